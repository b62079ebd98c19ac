//! Cracks and the lines along which they meet: built from the joints of living blocks, and handed on when blocks are divided or taken out.

use riprap_geom::Vec3;

use crate::flow::{End, Fluid, Network, Port};
use crate::push::seepage::network::{Mesh, middle};
use crate::state::cavity::Cavity;
use crate::state::gas::{Crack, CrackGas, GasBooks};
use crate::state::lineage::Origin;
use crate::state::world::World;

/// A place belongs to a free face within its plane when it is not farther from its centre than this, in half its sides if it is a rectangle.
const BESIDE: f64 = 2.0;
/// Radius of gyration of a rectangle over half its side.
const GYRATION: f64 = 0.577_350_269_189_625_8;

/// The network of the living blocks with the gas in it; that of before where no block has come or gone.
pub(super) fn current(world: &mut World) -> Option<Box<CrackGas>> {
    let blocks = [world.alive.len(), world.alive.iter().filter(|a| **a).count()];
    let known = world.gas.take();
    match known {
        Some(gas) if gas.blocks == blocks => Some(gas),
        known => {
            let mut new = build(world, blocks)?;
            if let Some(old) = known {
                hand_on(world, &old, &mut new);
            }
            Some(Box::new(new))
        }
    }
}

/// The network of the living blocks, without gas.
fn build(world: &World, blocks: [usize; 2]) -> Option<CrackGas> {
    let leaves = |c: &Cavity| world.cracks_of(c).copied();
    let numbers = (0..).zip(&world.cavities);
    let cavities: Vec<u32> = numbers.filter(|(_, c)| leaves(c).is_some()).map(|(k, _)| k).collect();
    let first = &world.cavities[*cavities.first()? as usize];
    let rules = leaves(first)?;
    let fluid = Fluid { adiabat: first.gas?.adiabat, mass: world.charge_mass(first)? };
    let mesh = Mesh::of(world, &[]);
    let mut cracks = Vec::with_capacity(mesh.joints.len());
    let mut ports: Vec<Vec<Port>> = Vec::new();
    ports.resize_with(mesh.lines.around().count(), Vec::new);
    for (cell, (part, rim)) in (0..).zip(&mesh.joints) {
        let (centre, normal, area) = middle(&part.outline);
        for (node, [from, to]) in rim.nodes.iter().zip(&rim.ends) {
            let length = from.distance(*to);
            let along = (*to - *from) / length;
            let way = centre - *from;
            let path = (way - way.dot(along) * along).length();
            ports[*node as usize].push(Port { cell, length, path });
        }
        cracks.push(Crack::new(part.blocks, &part.outline, (centre, normal, area)));
    }
    let cells = (cracks.len() + cavities.len()) as u32;
    let mut network = Network { cells, first: vec![0], ..Network::default() };
    let size = 10.0 * mesh.lines.size();
    for (ports, (ends, around)) in ports.into_iter().zip(mesh.lines.around()) {
        if ports.is_empty() {
            continue;
        }
        network.ports.extend(ports);
        network.first.push(network.ports.len() as u32);
        let at_wall = |k: &u32| {
            let removed = &world.cavities[*k as usize].blocks;
            around.iter().any(|b| removed.contains(b))
        };
        let place = 0.5 * (ends[0] + ends[1]);
        network.ends.push(match cavities.iter().position(at_wall) {
            Some(k) => End::Cell((cracks.len() + k) as u32),
            None if is_free(world, place, around, size) => End::Air,
            None => End::Inside,
        });
    }
    let masses = vec![0.0; cells as usize];
    let books = GasBooks::default();
    Some(CrackGas {
        fluid,
        rules,
        fluxes: vec![0.0; network.ports.len()],
        network,
        cracks,
        cavities,
        masses,
        failed: [0; 2],
        every: 1,
        passed: 0,
        waits: 0.0,
        limit: 0.0,
        blocks,
        books,
        stuck: None,
    })
}

/// Whether a place lies on a face without condition of one of the blocks `around`.
fn is_free(world: &World, place: Vec3, around: &[u32], size: f64) -> bool {
    around.iter().any(|&b| {
        let first = world.faces.partition_point(|f| f.block < b);
        let own = world.faces[first..].iter().take_while(|f| f.block == b);
        let at = place - world.reference[b as usize];
        own.filter(|f| f.boundary.is_none() && !f.parted).any(|face| {
            let [n, s, t] = face.frame;
            let off = at - face.arm;
            let within =
                |along: Vec3, reach: f64| off.dot(along).abs() <= BESIDE * reach / GYRATION + size;
            off.dot(n).abs() <= size
                && within(s, face.half_spacing[0])
                && within(t, face.half_spacing[1])
        })
    })
}

impl Crack {
    fn new(blocks: [u32; 2], outline: &[Vec3], (centre, normal, area): (Vec3, Vec3, f64)) -> Self {
        Self {
            blocks,
            outline: outline.to_vec(),
            centre,
            normal,
            area,
            open: false,
            gone: false,
            jump: Vec3::ZERO,
            moved: Vec3::ZERO,
            volume: 0.0,
            aperture: 0.0,
            pressure: 0.0,
            known: [0.0; 3],
            push: Vec3::ZERO,
            speed: 0.0,
        }
    }
}

impl World {
    /// Mass of the charge of a cavity, kg.
    pub(crate) fn charge_mass(&self, cavity: &Cavity) -> Option<f64> {
        match &self.setup.sources[cavity.source as usize].push {
            crate::setup::CavityPressure::Gas { mass, .. } => Some(*mass),
            crate::setup::CavityPressure::Pressure { .. } => None,
        }
    }
}

/// Hands the gas on from the network before blocks were divided or taken out: a crack shares it among its parts by area. What has lost its crack has left,
/// and the flow begins anew from rest.
fn hand_on(world: &World, old: &CrackGas, new: &mut CrackGas) {
    new.books = old.books;
    new.stuck = old.stuck;
    new.waits = old.waits;
    let cavities = new.cracks.len();
    for (k, number) in old.cavities.iter().enumerate() {
        if let Some(cell) = new.cell_of_cavity(*number as usize) {
            new.masses[cell] = old.masses[old.cracks.len() + k];
        }
    }
    let ancestor = |mut b: u32| {
        while b as usize >= old.blocks[0] {
            let parent = world.lineage[b as usize].parent;
            if parent == Origin::NONE {
                break;
            }
            b = parent;
        }
        b
    };
    // The crack that each new one was a part of.
    let mut of: Vec<Option<usize>> = Vec::with_capacity(cavities);
    let mut areas = vec![0.0; old.cracks.len()];
    for crack in &new.cracks {
        let [i, j] = crack.blocks.map(ancestor);
        let key = [i.min(j), i.max(j)];
        let first = old.cracks.partition_point(|c| c.blocks < key);
        let same = old.cracks[first..].iter().take_while(|c| c.blocks == key);
        let apart = |c: &Crack| c.centre.distance(crack.centre);
        let nearest = (first..).zip(same).min_by(|a, b| apart(a.1).total_cmp(&apart(b.1)));
        let found = nearest.map(|(k, _)| k).filter(|_| i != j);
        if let Some(k) = found {
            areas[k] += crack.area;
        }
        of.push(found);
    }
    let freedoms = world.all_freedoms();
    for (cell, k) in of.into_iter().enumerate() {
        let Some(k) = k else { continue };
        let (from, crack) = (&old.cracks[k], &mut new.cracks[cell]);
        let share = crack.area / areas[k];
        new.masses[cell] = share * old.masses[k];
        crack.open = from.open;
        crack.gone = from.gone;
        crack.volume = share * from.volume;
        crack.aperture = from.aperture;
        crack.pressure = from.pressure;
        crack.speed = from.speed;
        // It moves from where its own middle is.
        crack.jump = super::place(world, &freedoms, crack).0;
        let sign = crack.normal.dot(from.normal).signum();
        crack.push = sign * crack.area / from.area * from.push;
    }
    for (k, mass) in old.masses[..old.cracks.len()].iter().enumerate() {
        if areas[k] == 0.0 && *mass > 0.0 {
            new.books.vented += mass;
            new.books.carried += mass * old.fluid.energy(mass / old.cracks[k].volume);
        }
    }
}
