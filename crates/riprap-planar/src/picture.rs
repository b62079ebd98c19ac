//! Frames of a planar model: outlines at their present positions, found contacts and joints as points.

use riprap_geom::Vec2;

use super::bond::Bond;
use super::fields::unit_of_slice;
use super::view::View;
use super::world::Contact;
use crate::field::Site;
use crate::frame::{Column, Content, Frame, SEEPAGE_FLOW, stress};

/// Joints beyond which a frame holds only those of which a point has failed.
pub const MANY_JOINTS: usize = 200_000;

/// Names of the columns of blocks.
pub const FIELDS: [&str; 10] = [
    "block",
    "material",
    "displacement",
    "rotation",
    "velocity",
    "spin",
    "force",
    "held",
    stress::NORMAL,
    stress::SHEAR,
];

fn flat(v: Vec2) -> [f64; 3] {
    [v.x, v.y, 0.0]
}

/// A picture of the living blocks, their found contacts and the joints between them.
#[must_use]
pub fn frame(view: &View<'_>, phase: &str, content: &Content) -> Frame {
    let (world, scratch) = (view.world, view.scratch);
    let origin = Vec2::from(world.setup.origin);
    let mut frame = Frame {
        step: world.step,
        time: world.time,
        phase: phase.to_owned(),
        offsets: vec![0],
        ..Frame::default()
    };
    let living: Vec<usize> = view.living().collect();
    for &b in &living {
        let at = world.bodies[b].position + origin;
        frame
            .points
            .extend(scratch.turned[scratch.shapes.range(b)].iter().map(|t| flat(at + t.start)));
        frame.offsets.push(frame.points.len() as u32);
    }
    let scalar = |name: &str, unit: &str, get: &dyn Fn(usize) -> f64| {
        Column::scalar(name, unit, living.iter().map(|&b| get(b)).collect())
    };
    let vector = |name: &str, unit: &str, get: &dyn Fn(usize) -> Vec2| {
        let data: Vec<[f64; 2]> = living.iter().map(|&b| get(b).into()).collect();
        Column::vector(name, unit, data)
    };
    let (slice, unit) = forces(view);
    frame.block_columns = vec![
        scalar("block", "-", &|b| b as f64),
        scalar("material", "-", &|b| f64::from(world.setup.blocks[b].material)),
        vector("displacement", "m", &|b| view.displacement(b)),
        scalar("rotation", "rad", &|b| view.rotation(b)),
        vector("velocity", "m/s", &|b| view.velocity(b)),
        scalar("spin", "rad/s", &|b| view.spin(b)),
        vector("force", unit, &|b| slice * scratch.net[b].force),
        scalar("held", "-", &|b| f64::from(u8::from(world.motion[b].is_some()))),
    ];
    let stresses = view.stresses();
    let stresses: Vec<[f64; 3]> = living.iter().map(|&b| stresses[b]).collect();
    frame.block_columns.extend(stress::in_plane(&stresses));
    frame.block_columns.retain(|column| content.wants(&column.name));
    frame.bolts = crate::frame::bars::surfaces(&crate::bolts::read::bars(view));
    if !content.contacts {
        return frame;
    }
    let mut rows: Vec<Row> =
        view.contacts().map(|(i, j, contact)| found(view, [i, j], contact)).collect();
    rows.extend(joints(view));
    frame.contact_columns = contact_columns(&rows, slice, unit);
    frame.contact_columns.extend(water_columns(view, &rows));
    frame.contact_points = rows.iter().map(|r| flat(r.place + origin)).collect();
    frame
}

/// Pressure and flow of water between blocks, where there is any.
fn water_columns(view: &View<'_>, rows: &[Row]) -> Vec<Column> {
    let world = view.world;
    if world.water.is_none() {
        return Vec::new();
    }
    let between = |r: &Row| (r.blocks[0], r.blocks[1]);
    let pressures = rows.iter().map(|r| world.pressure_between(between(r), r.place));
    let mut out = vec![Column::scalar("pore_pressure", "Pa", pressures.collect())];
    if world.seepage.is_some() {
        let (slice, unit) = (world.setup.slice(), told(view, "m2/s"));
        let rates = rows.iter().map(|r| slice * world.seepage_between(between(r)));
        out.push(Column::scalar("seepage_rate", unit, rates.collect()));
        let flow = |r: &Row| slice * world.seepage_flow(between(r), r.place);
        let flows: Vec<[f64; 2]> = rows.iter().map(|r| flow(r).into()).collect();
        out.push(Column::vector(SEEPAGE_FLOW, unit, flows));
    }
    out
}

/// What forces per metre of thickness are multiplied by, and the unit they then have.
fn forces(view: &View<'_>) -> (f64, &'static str) {
    (view.world.setup.slice(), told(view, "N/m"))
}

/// The unit in which a quantity per metre of thickness is told.
fn told(view: &View<'_>, per_metre: &'static str) -> &'static str {
    let of_slice = || unit_of_slice(Site::Block, per_metre);
    let thickness = view.world.setup.thickness;
    thickness.and_then(|_| of_slice()).unwrap_or(per_metre)
}

/// One line of the contacts of a frame.
#[derive(Default)]
struct Row {
    /// m, without the origin.
    place: Vec2,
    blocks: [u32; 2],
    /// On the first block, N/m.
    force: Vec2,
    /// Unit normal from the first block to the second; zero of a contact that does not press.
    out: Vec2,
    /// Compression positive, N/m.
    normal: f64,
    shear: f64,
    length: f64,
    overlap: f64,
    slipping: bool,
    /// Of joints: number of points, failed ones, the length these stand for (m), their mean opening and sliding (m).
    points: f64,
    broken: f64,
    broken_length: f64,
    opening: f64,
    slip: f64,
}

fn found(view: &View<'_>, blocks: [u32; 2], c: &Contact) -> Row {
    let normal = c.normal.force.normalize_or_zero();
    Row {
        place: view.world.bodies[blocks[0] as usize].position + c.centre,
        blocks,
        force: c.normal.force + c.damping.force + c.tangential.force,
        // What presses pushes the first block back.
        out: -normal,
        normal: (c.normal.force + c.damping.force).dot(normal),
        shear: c.tangential.force.dot(normal.perp()),
        length: c.length,
        overlap: c.depth,
        slipping: c.slipping,
        ..Row::default()
    }
}

/// A contact or a joint of the present instant.
#[derive(Clone, Copy, Debug)]
pub struct Met {
    /// The blocks.
    pub blocks: [u32; 2],
    /// Whether it is a joint of the start.
    pub joint: bool,
    /// Place, m, without the origin.
    pub place: Vec2,
    /// Unit normal from the first to the second; zero of a contact that does not press.
    pub normal: Vec2,
    /// Length, m.
    pub length: f64,
    /// On the first block, N/m.
    pub force: Vec2,
}

impl View<'_> {
    /// Found contacts that touch, then joints that act between living blocks.
    #[must_use]
    pub fn met(&self) -> Vec<Met> {
        let one = |row: Row, joint: bool| Met {
            blocks: row.blocks,
            joint,
            place: row.place,
            normal: row.out,
            length: row.length,
            force: row.force,
        };
        let alive = |b: u32| self.world.alive[b as usize];
        let found = self.contacts().map(|(i, j, c)| one(found(self, [i, j], c), false));
        let acting = self.world.bonds.iter().filter(|b| b.active && alive(b.i) && alive(b.j));
        found.chain(acting.map(|bond| one(joint(self, bond), true))).collect()
    }
}

/// Joints between living blocks; those that have handed over to found contact bear nothing but keep their marks.
fn joints(view: &View<'_>) -> Vec<Row> {
    let world = view.world;
    let many = world.bonds.len() > MANY_JOINTS;
    let mut living = vec![false; world.bodies.len()];
    for b in view.living() {
        living[b] = true;
    }
    let between = |b: &&Bond| {
        let whole = b.points.iter().all(|p| !p.failed);
        living[b.i as usize] && living[b.j as usize] && !(many && whole)
    };
    world.bonds.iter().filter(between).map(|b| joint(view, b)).collect()
}

fn joint(view: &View<'_>, bond: &Bond) -> Row {
    let count = bond.points.len().max(1) as f64;
    let arm = bond.points.iter().map(|p| p.on_i).sum::<Vec2>() / count;
    let (mut broken, mut length, mut opening, mut slip) = (0.0, 0.0, 0.0, 0.0);
    for p in bond.points.iter().filter(|p| p.failed) {
        broken += 1.0;
        length += p.weight;
        opening += p.weight * p.opening;
        slip += p.weight * p.slip;
    }
    let mean = |sum: f64| if length > 0.0 { sum / length } else { 0.0 };
    let bears = if bond.active { 1.0 } else { 0.0 };
    Row {
        place: view.world.on_body(bond.i, arm),
        blocks: [bond.i, bond.j],
        force: bond.stress.force + bond.damping.force,
        out: view.world.bodies[bond.i as usize].turned(bond.normal),
        normal: bears * bond.compression(),
        shear: bears * bond.shear(),
        length: bond.length,
        points: bond.points.len() as f64,
        broken,
        broken_length: length,
        opening: mean(opening),
        slip: mean(slip),
        ..Row::default()
    }
}

/// `slice` and `unit` as of [`forces`].
fn contact_columns(rows: &[Row], slice: f64, unit: &str) -> Vec<Column> {
    let column = |name: &str, unit: &str, get: &dyn Fn(&Row) -> f64| {
        Column::scalar(name, unit, rows.iter().map(get).collect())
    };
    let forces: Vec<[f64; 2]> = rows.iter().map(|r| (slice * r.force).into()).collect();
    let normals: Vec<[f64; 2]> = rows.iter().map(|r| r.out.into()).collect();
    vec![
        column("block_a", "-", &|r| f64::from(r.blocks[0])),
        column("block_b", "-", &|r| f64::from(r.blocks[1])),
        Column::vector("force_on_a", unit, forces),
        column("normal_force", unit, &|r| slice * r.normal),
        column("shear_force", unit, &|r| slice * r.shear),
        column("length", "m", &|r| r.length),
        column("overlap", "m", &|r| r.overlap),
        column("slipping", "-", &|r| f64::from(u8::from(r.slipping))),
        column("joint_points", "-", &|r| r.points),
        column("broken_points", "-", &|r| r.broken),
        column("broken_length", "m", &|r| r.broken_length),
        column("opening", "m", &|r| r.opening),
        column("slip", "m", &|r| r.slip),
        Column::vector("normal", "-", normals),
    ]
}
