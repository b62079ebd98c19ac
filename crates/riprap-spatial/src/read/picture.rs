//! Frames of a spatial model: solids at their present positions, patches as points.

use crate::setup::rotation::rotation;
use riprap_geom::{Mat3, Vec3};

use crate::frame::{BRICK, Column, Content, Frame, SEEPAGE_FLOW, Solids, stress};
use crate::laws::norm;
use crate::query::view::View;
use crate::read::fields::principal;
use crate::setup::{Shape, Solid};
use crate::state::deform::{Memory, State};
use crate::state::gas::Crack;
use crate::state::interface::Origin;
use crate::state::patches::flag;
use crate::state::world::World;

/// Patches beyond which a frame holds only those that have failed, opened or slid: a million blocks have
/// three million patches.
pub const MANY_PATCHES: usize = 200_000;

/// A number of a crack, with the mass in it, kg.
type OfCrack = fn(&Crack, f64) -> f64;

/// Names of the columns of blocks.
pub const FIELDS: [&str; 15] = [
    "block",
    "material",
    "level",
    "displacement",
    "rotation",
    "velocity",
    "peak_speed",
    "sigma1_compressive",
    "sigma3_compressive",
    "pressure",
    "broken_share",
    "surface",
    "held",
    stress::NORMAL,
    stress::SHEAR,
];

/// A picture of the living blocks and their patches, as far as they are wanted.
#[must_use]
pub fn frame(view: &View<'_>, phase: &str, content: &Content) -> Frame {
    let world = view.world;
    let living: Vec<usize> = view.living().collect();
    let mut frame = Frame {
        step: world.step,
        time: world.time,
        phase: phase.to_owned(),
        offsets: vec![0],
        ..Frame::default()
    };
    let mut solids = Solids { faces: vec![0], ends: vec![0], corners: Vec::new() };
    let corners = living.iter().map(|&b| match &world.setup.blocks[b].shape {
        Shape::Polyhedron(solid) => solid.vertices.len(),
        // Few are glued, and terrain is rare.
        Shape::Brick { .. } | Shape::Glued(_) | Shape::Terrain(_) => BRICK.len(),
    });
    frame.points.reserve(corners.sum());
    for &b in &living {
        put_block(view, b, &mut frame, &mut solids);
    }
    frame.solids = Some(solids);
    frame.block_columns = block_columns(view, &living);
    frame.block_columns.retain(|column| content.wants(&column.name));
    if content.contacts {
        put_interfaces(view, &mut frame);
    }
    frame.cracks = crate::read::cracks::surfaces(view);
    frame.bolts = crate::frame::bars::surfaces(&crate::read::bars::bars(view));
    frame
}

/// Patches, contacts and facets, with the water and the gas between their blocks.
fn put_interfaces(view: &View<'_>, frame: &mut Frame) {
    let world = view.world;
    put_patches(view, frame);
    put_contacts(view, frame);
    put_facets(view, frame);
    if world.water.is_some() {
        let rows = pairs_of(world, frame);
        let pressures = rows.iter().map(|(pair, at)| world.pressure_between(*pair, *at));
        let column = Column::scalar("pore_pressure", "Pa", pressures.collect());
        frame.contact_columns.push(column);
        if world.seepage.is_some() {
            let rates = rows.iter().map(|(pair, _)| world.seepage_between(*pair));
            let flows = rows.iter().map(|(pair, at)| world.seepage_flow(*pair, *at).to_array());
            let flows: Vec<[f64; 3]> = flows.collect();
            let rates = Column::scalar("seepage_rate", "m3/s", rates.collect());
            frame.contact_columns.push(rates);
            frame.contact_columns.push(Column::vector3(SEEPAGE_FLOW, "m2/s", flows));
        }
    }
    // From the first frame on, so that all have the same columns.
    if world.cavities.iter().any(|cavity| world.cracks_of(cavity).is_some()) {
        let rows = pairs_of(world, frame);
        let columns: [(&str, &str, OfCrack); 4] = [
            ("gas_pressure", "Pa", |crack, _| crack.pressure),
            ("gas_aperture", "m", |crack, _| crack.aperture),
            ("gas_mass", "kg", |_, mass| mass),
            ("gas_speed", "m/s", |crack, _| crack.speed),
        ];
        for (name, unit, get) in columns {
            let values = rows.iter().map(|(pair, _)| world.largest_in_cracks(*pair, get));
            frame.contact_columns.push(Column::scalar(name, unit, values.collect()));
        }
    }
}

/// Blocks and place (local, m) of each interface and contact of a frame.
fn pairs_of(world: &World, frame: &Frame) -> Vec<([u32; 2], Vec3)> {
    let blocks = ["block_a", "block_b"].map(|name| {
        let column = frame.contact_columns.iter().find(|column| column.name == name);
        column.map_or(&[][..], |column| &column.data[..])
    });
    let rows = frame.contact_points.iter().enumerate().map(|(k, p)| {
        let pair = blocks.map(|list| list.get(k).map_or(0, |b| *b as u32));
        (pair, Vec3::from_array(*p) - world.setup.origin)
    });
    rows.collect()
}

/// Corners and faces of one block.
fn put_block(view: &View<'_>, b: usize, frame: &mut Frame, solids: &mut Solids) {
    let world = view.world;
    let place = view.position(b) + world.setup.origin;
    let attitude = match &world.turned[b] {
        Some(turned) => turned.attitude,
        None => rotation(world.bodies.rotation(b)),
    };
    let deformable = view.deformable(b);
    let node = |k: usize| {
        deformable.map(|deformable| {
            let at = deformable.place(deformable.body.first as usize + k);
            (at + world.setup.origin).to_array()
        })
    };
    match &world.setup.blocks[b].shape {
        Shape::Brick { half, .. } => {
            for corner in BRICK {
                // Nodes count x, y, z as bits.
                let bits = [0, 1, 2].map(|k: usize| usize::from(corner[k] > 0.0) << k);
                if let Some(point) = node(bits.iter().sum()) {
                    frame.points.push(point);
                    continue;
                }
                let arm = attitude * (*half * Vec3::from(corner));
                frame.points.push((place + arm).to_array());
            }
        }
        Shape::Polyhedron(solid) => {
            let centroid = world.reference[b];
            for (k, corner) in solid.vertices.iter().enumerate() {
                if let Some(point) = node(k) {
                    frame.points.push(point);
                    continue;
                }
                let arm = attitude * (*corner - centroid);
                frame.points.push((place + arm).to_array());
            }
            put_faces(solid, solids);
        }
        Shape::Glued(parts) => {
            let body = Solid::all(parts);
            let arms = body.vertices.iter();
            let arms = arms.map(|corner| attitude * (*corner - world.reference[b]));
            frame.points.extend(arms.map(|arm| (place + arm).to_array()));
            put_faces(&body, solids);
        }
        Shape::Terrain(surface) => {
            let body = surface.body();
            let moved = place - world.reference[b];
            let points = body.vertices.iter();
            frame.points.extend(points.map(|p| (moved + *p).to_array()));
            put_faces(&body, solids);
        }
    }
    solids.faces.push(solids.ends.len() as u32 - 1);
    frame.offsets.push(frame.points.len() as u32);
}

fn put_faces(solid: &Solid, solids: &mut Solids) {
    for face in &solid.faces {
        solids.corners.extend_from_slice(face);
        solids.ends.push(solids.corners.len() as u32);
    }
}

fn block_columns(view: &View<'_>, living: &[usize]) -> Vec<Column> {
    let world = view.world;
    let stresses: Vec<Mat3> = {
        let all = view.stresses();
        living.iter().map(|&b| all[b]).collect()
    };
    let surface = view.surface();
    let scalar = |name: &str, unit: &str, get: &(dyn Fn(usize) -> f64 + Sync)| {
        Column::scalar(name, unit, of_each(view, living, get))
    };
    let vector = |name: &str, unit: &str, get: &(dyn Fn(usize) -> Vec3 + Sync)| {
        Column::vector3(name, unit, of_each(view, living, |b| get(b).to_array()))
    };
    let ends: Vec<[f64; 3]> = stresses.iter().map(principal).collect();
    let broken = broken_shares(view);
    let mut columns = vec![
        scalar("block", "-", &|b| b as f64),
        scalar("material", "-", &|b| f64::from(world.setup.blocks[b].material)),
        scalar("level", "-", &|b| f64::from(world.level(b))),
        vector("displacement", "m", &|b| view.displacement(b)),
        vector("rotation", "rad", &|b| view.rotation(b)),
        vector("velocity", "m/s", &|b| view.velocity(b)),
        scalar("peak_speed", "m/s", &|b| view.peak_speed(b)),
        Column::scalar("sigma1_compressive", "Pa", ends.iter().map(|e| -e[2]).collect()),
        Column::scalar("sigma3_compressive", "Pa", ends.iter().map(|e| -e[0]).collect()),
        Column::scalar(
            "pressure",
            "Pa",
            ends.iter().map(|e| -(e[0] + e[1] + e[2]) / 3.0).collect(),
        ),
        scalar("broken_share", "-", &|b| broken[b]),
        scalar("surface", "-", &|b| f64::from(u8::from(surface[b]))),
        scalar("held", "-", &|b| f64::from(u8::from(world.motion[b].is_some()))),
    ];
    columns.extend(stress::in_space(&stresses));
    columns
}

/// Something of each of the blocks, found by all threads.
fn of_each<T: Send + Clone>(
    view: &View<'_>,
    blocks: &[usize],
    get: impl Fn(usize) -> T + Sync,
) -> Vec<T> {
    let chunks = view
        .scratch
        .exec
        .chunked(blocks.len(), |chunk| blocks[chunk].iter().map(|&b| get(b)).collect::<Vec<_>>());
    chunks.concat()
}

/// Share of the failed points among the points of each block's patches.
fn broken_shares(view: &View<'_>) -> Vec<f64> {
    let list = &view.world.patches;
    let mut sums = vec![[0.0_f64; 2]; view.world.alive.len()];
    for (ends, flags) in list.ends.iter().zip(&list.flags) {
        let broken = f64::from((flags & flag::BROKEN).count_ones());
        for b in ends {
            sums[*b as usize][0] += broken;
            sums[*b as usize][1] += 4.0;
        }
    }
    for facet in view.deformables().iter().flat_map(|(deform, _)| &deform.facets) {
        let broken = view.broken_points(facet);
        for b in facet.blocks {
            sums[b as usize][0] += f64::from(broken);
            sums[b as usize][1] += f64::from(facet.count);
        }
    }
    sums.iter().map(|[n, all]| n / all.max(1.0)).collect()
}

/// Facets of deformable blocks, in the columns of patches.
fn put_facets(view: &View<'_>, frame: &mut Frame) {
    let Some((deform, work)) = view.deformables() else {
        return;
    };
    let many = deform.facets.len() > MANY_PATCHES;
    for facet in &deform.facets {
        let broken = view.broken_points(facet);
        let whole = |m: &Memory| !m.state.is_broken() && m.law.damage == 0.0;
        if many && deform.memory[facet.points()].iter().all(whole) {
            continue;
        }
        let place = view.facet_place(facet) + view.world.setup.origin;
        frame.contact_points.push(place.to_array());
        let of = |is: &dyn Fn(&Memory) -> bool| {
            let points = facet.points().filter(|p| is(&deform.memory[*p]));
            points.map(|p| (deform.points[p].area, Vec3::from(work.slots[p]))).collect::<Vec<_>>()
        };
        let area = |points: &[(f64, Vec3)]| points.iter().map(|p| p.0).sum::<f64>();
        let force: Vec3 = of(&|_| true).iter().map(|p| p.1).sum();
        let [n, b, c] = facet.frame.map(|e| e.dot(force) / facet.area);
        let lost = of(&|m| m.state.is_broken());
        let (failed, open) = (area(&lost), lost.iter().filter(|p| p.1 == Vec3::ZERO));
        let sheared = area(&of(&|m| m.state == State::Sheared));
        let mode = match broken {
            0 => 0.0,
            _ if sheared > failed - sheared => 2.0,
            _ => 1.0,
        };
        let softening = of(&|m| !m.state.is_broken() && m.law.damage > 0.0);
        let numbers = [
            f64::from(facet.blocks[0]),
            f64::from(facet.blocks[1]),
            force.x,
            force.y,
            force.z,
            n,
            norm(b, c),
            facet.area,
            f64::from(broken),
            open.count() as f64,
            0.0,
            facet.frame[0].x,
            facet.frame[0].y,
            facet.frame[0].z,
            failed,
            mode,
            softening.len() as f64,
            area(&softening),
            f64::from(facet.origin.code()),
        ];
        put_row(frame, numbers);
    }
}

/// Appends a row to the columns of patches.
fn put_row(frame: &mut Frame, numbers: impl IntoIterator<Item = f64>) {
    let mut numbers = numbers.into_iter();
    for column in &mut frame.contact_columns {
        column.data.extend(numbers.by_ref().take(column.components));
    }
}

/// Found contacts, in the columns of patches; nothing of them can fail.
fn put_contacts(view: &View<'_>, frame: &mut Frame) {
    for contact in view.contacts() {
        let place = view.contact_place(&contact) + view.world.setup.origin;
        frame.contact_points.push(place.to_array());
        let (force, normal) = (-contact.force, contact.normal);
        // Force on the first block: compression is against the normal, which points to the second.
        let across = force.dot(normal);
        let along = (force - across * normal).length();
        let over_area = |f: f64| {
            if contact.area > 0.0 { f / contact.area } else { 0.0 }
        };
        let [a, b] = contact.ends.map(f64::from);
        let sliding = if contact.sliding { 4.0 } else { 0.0 };
        let mut numbers = vec![a, b, force.x, force.y, force.z];
        numbers.extend([over_area(across), over_area(along), contact.area]);
        numbers.extend([0.0, 0.0, sliding, normal.x, normal.y, normal.z]);
        numbers.extend([0.0; 4]);
        numbers.push(f64::from(Origin::Found.code()));
        put_row(frame, numbers);
    }
}

fn put_patches(view: &View<'_>, frame: &mut Frame) {
    let list = &view.world.patches;
    let active = flag::BROKEN | flag::OPEN | flag::SLIDING;
    let many = list.len() > MANY_PATCHES;
    let chosen: Vec<usize> =
        (0..list.len()).filter(|&p| !many || list.flags[p] & active != 0).collect();
    let mut forces = Vec::with_capacity(chosen.len());
    let mut means = Vec::with_capacity(chosen.len());
    let mut normals = Vec::with_capacity(chosen.len());
    for &p in &chosen {
        let class = view.patch_class(p);
        let i = list.ends[p][0] as usize;
        let normal = match &view.world.turned[i] {
            Some(turned) => turned.attitude * class.frame[0],
            None => class.frame[0],
        };
        normals.push(normal.to_array());
        let place = view.patch_place(p) + view.world.setup.origin;
        frame.contact_points.push(place.to_array());
        forces.push(view.patch_resultant(p).force.to_array());
        let t = view.patch_tractions(p);
        let mean = |k: usize| 0.25 * t.iter().map(|t| t[k]).sum::<f64>();
        means.push([mean(0), norm(mean(1), mean(2))]);
    }
    let column = |name: &str, unit: &str, get: &dyn Fn(usize) -> f64| {
        Column::scalar(name, unit, (0..chosen.len()).map(get).collect())
    };
    let bits = |k: usize, group: u16| f64::from((list.flags[chosen[k]] & group).count_ones());
    frame.contact_columns = vec![
        column("block_a", "-", &|k| f64::from(list.ends[chosen[k]][0])),
        column("block_b", "-", &|k| f64::from(list.ends[chosen[k]][1])),
        Column::vector3("force_on_a", "N", forces),
        column("normal_stress", "Pa", &|k| means[k][0]),
        column("shear_stress", "Pa", &|k| means[k][1]),
        column("area", "m2", &|k| view.patch_class(chosen[k]).area),
        column("broken_points", "-", &|k| bits(k, flag::BROKEN)),
        column("open_points", "-", &|k| bits(k, flag::OPEN)),
        column("sliding_points", "-", &|k| bits(k, flag::SLIDING)),
        Column::vector3("normal", "-", normals),
        column("failed_area", "m2", &|k| {
            0.25 * bits(k, flag::BROKEN) * view.patch_class(chosen[k]).area
        }),
        // Of facets only.
        column("failure_mode", "-", &|_| 0.0),
        column("softened_points", "-", &|_| 0.0),
        column("softened_area", "m2", &|_| 0.0),
        column("origin", "-", &|k| f64::from(list.origin_of(chosen[k]).code())),
    ];
}
