//! The field table of the planar engine: name, unit, meaning and getter of every number that frames,
//! histories, checks, `riprap fields` and the documentation can ask for.

use std::sync::LazyLock;

use riprap_geom::Vec2;

use super::bolts::read as bolts;
use super::bond::{Bond, shared_edges};
use super::heap;
use super::search::is_fixed;
use super::view::View;
use crate::field::{FieldError, FieldInfo, Part, Site, first, joined, pair, place};
use crate::frame::stress::Principal;

/// A getter: the view, the blocks asked for, and room for one or two numbers.
type Getter = fn(&View<'_>, &[u32]) -> [f64; 2];

// A sum over nothing is -0.
const fn one(x: f64) -> [f64; 2] {
    [x + 0.0, 0.0]
}

/// Mean over blocks of a vector.
fn mean(of: &[u32], get: impl Fn(usize) -> Vec2) -> [f64; 2] {
    let sum: Vec2 = of.iter().map(|&b| get(b as usize)).sum();
    (sum / of.len().max(1) as f64).into()
}

/// Largest value over blocks.
fn largest(blocks: impl Iterator<Item = usize>, get: impl Fn(usize) -> f64) -> [f64; 2] {
    one(blocks.map(get).fold(0.0, f64::max))
}

/// What joints and contacts between two blocks carry together, dashpots included.
#[derive(Default)]
struct Borne {
    /// Normal force, compression positive, N/m.
    normal: f64,
    /// Shear force on the first block along the normal turned by +90 deg, the normal pointing into the block with the lower number, N/m.
    shear: f64,
    /// Whether there is something that presses, and all of it slides.
    slides: bool,
    /// Length of the contacts, m.
    length: f64,
    /// Largest depth of the contacts, m.
    depth: f64,
    /// Number of contacts.
    contacts: f64,
}

/// Adds up what lies between a pair.
fn borne(v: &View<'_>, of: &[u32]) -> Borne {
    let (a, b) = pair(of);
    let (mut out, mut pressing, mut sliding) = (Borne::default(), 0, 0);
    // Lists have the lower number first.
    let sign = if a < b { 1.0 } else { -1.0 };
    let mut add = |out: &mut Borne, normal: f64, shear: f64, slides: bool| {
        out.normal += normal;
        out.shear += sign * shear;
        pressing += 1;
        sliding += usize::from(slides);
    };
    for (i, j, c) in v.contacts() {
        if (i, j) == (a, b) || (i, j) == (b, a) {
            let n = c.normal.force.normalize_or_zero();
            let force = c.normal.force + c.handed.force + c.damping.force;
            let shear = c.tangential.force.dot(n.perp());
            add(&mut out, force.dot(n), shear, c.slipping);
            out.length += c.length;
            out.depth = out.depth.max(c.depth);
            out.contacts += 1.0;
        }
    }
    let bonds = v.world.bonds.iter().filter(|k| k.active);
    for bond in bonds.filter(|k| (k.i, k.j) == (a.min(b), a.max(b))) {
        let n = -bond.normal_now(&v.world.bodies);
        let force = bond.stress.force + bond.damping.force;
        let law = v.world.setup.interfaces[bond.row as usize].bond;
        match law.and_then(|law| bond.slides(&law)) {
            Some(slides) => add(&mut out, force.dot(n), force.dot(n.perp()), slides),
            // Open at all points: what is left is the pull of its dashpots.
            None => {
                out.normal += force.dot(n);
                out.shear += sign * force.dot(n.perp());
            }
        }
    }
    out.slides = pressing > 0 && sliding == pressing;
    out
}

/// Largest value over the joint points of a pair; 0 without joints.
fn joint(v: &View<'_>, of: &[u32], get: impl Fn(&super::bond::BondPoint) -> f64) -> f64 {
    let (a, b) = pair(of);
    let key = (a.min(b), a.max(b));
    let points = v.world.bonds.iter().filter(|k| (k.i, k.j) == key).flat_map(|k| &k.points);
    points.map(get).reduce(f64::max).unwrap_or(0.0)
}

/// The numbers of a pair, the lower one first.
fn key(of: &[u32]) -> [u32; 2] {
    let (a, b) = pair(of);
    [a.min(b), a.max(b)]
}

/// Number of failed joint points between blocks that `chosen` takes, those of blocks that were removed included.
fn broken_points(v: &View<'_>, chosen: impl Fn([u32; 2]) -> bool) -> f64 {
    let bonds = v.world.bonds.iter().filter(|k| chosen([k.i, k.j]));
    let there: u64 = bonds.map(Bond::failed_points).sum();
    (there + v.world.failed.count(&chosen)) as f64
}

/// Share of the joint points of a pair that have failed; 0 without joints.
fn broken_share(v: &View<'_>, of: &[u32]) -> f64 {
    let key = key(of);
    let bonds = v.world.bonds.iter().filter(|k| [k.i, k.j] == key);
    let (failed, all) =
        bonds.fold((0, 0), |(failed, all), k| (failed + k.failed_points(), all + k.points.len()));
    if all > 0 { failed as f64 / all as f64 } else { 0.0 }
}

/// Largest pressure of the water between two blocks.
fn pore_pressure(v: &View<'_>, of: &[u32]) -> f64 {
    let (a, b) = pair(of);
    let key = (a.min(b), a.max(b));
    let found = v.contacts().filter(|(i, j, _)| (*i, *j) == key);
    let found = found.map(|(i, _, c)| v.world.bodies[i as usize].position + c.centre);
    let bonds = v.world.bonds.iter().filter(|k| (k.i, k.j) == key);
    let points = bonds.flat_map(|k| k.points.iter().map(|p| v.world.on_body(k.i, p.on_i)));
    let pressures = found
        .chain(points)
        .chain(between_fixed(v, key))
        .map(|at| v.world.pressure_between(key, at));
    pressures.fold(0.0, f64::max)
}

/// Centres of the edges that two fixed blocks share (local, m): nothing acts between them that could say where they meet.
fn between_fixed(v: &View<'_>, key: (u32, u32)) -> Vec<Vec2> {
    let (world, blocks) = (v.world, [key.0, key.1].map(|b| b as usize));
    let fixed = |b: usize| world.alive[b] && is_fixed(world.motion[b].as_deref());
    if !blocks.into_iter().all(fixed) {
        return Vec::new();
    }
    let shared = shared_edges(&v.scratch.shapes, blocks);
    let centroid = v.scratch.shapes.centroid[blocks[0]];
    let centres = (shared.iter()).map(|edge| world.on_body(key.0, edge.middle() - centroid));
    centres.collect()
}

/// Living blocks without prescribed motion.
fn free<'a>(v: &'a View<'_>) -> impl Iterator<Item = usize> + 'a {
    v.living().filter(|&b| v.world.motion[b].is_none())
}

/// Blocks of a group that have not been removed.
fn there<'a>(v: &'a View<'_>, of: &'a [u32]) -> impl Iterator<Item = usize> + 'a {
    of.iter().map(|&b| b as usize).filter(|&b| v.world.alive[b])
}

/// Mass of those of some blocks that have been removed, kg/m.
fn removed_mass(v: &View<'_>, of: impl Iterator<Item = usize>) -> f64 {
    of.filter(|&b| !v.world.alive[b]).map(|b| v.scratch.shapes.mass[b]).sum()
}

/// Mass of the blocks of a group that have been removed, kg/m.
fn drawn(v: &View<'_>, of: &[u32]) -> f64 {
    removed_mass(v, of.iter().map(|&b| b as usize))
}

/// A share of nothing is zero.
fn part(of: f64, all: f64) -> f64 {
    if all > 0.0 { of / all } else { 0.0 }
}

/// By how much the centroids of two blocks have come nearer to each other, m.
fn convergence(v: &View<'_>, of: &[u32]) -> f64 {
    let (a, b) = pair(of);
    let [a, b] = [a, b].map(|b| b as usize);
    let now = v.world.bodies[a].position - v.world.bodies[b].position;
    let before = now - (v.displacement(a) - v.displacement(b));
    before.length() - now.length()
}

fn area(v: &View<'_>, b: usize) -> f64 {
    v.scratch.shapes.mass[b] / v.world.setup.blocks[b].density
}

fn principal(v: &View<'_>, of: &[u32]) -> Principal {
    let [xx, yy, xy] = v.stress(first(of));
    Principal::in_plane(xx, yy, xy)
}

fn momentum(v: &View<'_>, b: usize) -> Vec2 {
    v.scratch.shapes.mass[b] * v.velocity(b)
}

fn blocks(v: &View<'_>, of: &[u32]) -> f64 {
    v.contacts().filter(|(i, j, _)| of.contains(i) || of.contains(j)).count() as f64
}

/// Unit of a quantity of a slice of given thickness, from that for each metre of thickness; `None` for what is no such quantity.
#[must_use]
pub fn unit_of_slice(site: Site, unit: &str) -> Option<&'static str> {
    let units = [
        ("N/m", "N"),
        ("N", "N m"),
        ("J/m", "J"),
        ("kg/m", "kg"),
        ("N s/m", "N s"),
        ("N s", "N m s"),
        ("m2/s", "m3/s"),
    ];
    // Numbers of bolts are those of one bolt.
    let found = units.iter().find(|(per_metre, _)| *per_metre == unit);
    found.filter(|_| site != Site::Bolt).map(|(_, of_slice)| *of_slice)
}

/// [`INFOS`] of a model whose thickness is given.
pub static INFOS_OF_SLICE: LazyLock<Vec<FieldInfo>> = LazyLock::new(|| {
    let of_slice =
        |f: &FieldInfo| FieldInfo { unit: unit_of_slice(f.site, f.unit).unwrap_or(f.unit), ..*f };
    INFOS.iter().map(of_slice).collect()
});

riprap_core::fields! {
    Getter;
    "block.position" "m" Block Vector false "Position of the centroid." |v, of| (v.world.bodies[first(of)].position + Vec2::from(v.world.setup.origin)).into();
    "block.displacement" "m" Block Vector false "Displacement of the centroid since the start or the last reset." |v, of| v.displacement(first(of)).into();
    "block.rotation" "rad" Block Scalar false "Rotation since the start or the last reset, anticlockwise." |v, of| one(v.rotation(first(of)));
    "block.velocity" "m/s" Block Vector false "Velocity of the centroid." |v, of| v.velocity(first(of)).into();
    "block.speed" "m/s" Block Scalar false "Magnitude of the velocity." |v, of| one(v.velocity(first(of)).length());
    "block.spin" "rad/s" Block Scalar false "Angular velocity, anticlockwise." |v, of| one(v.spin(first(of)));
    "block.acceleration" "m/s2" Block Vector false "Acceleration of the centroid." |v, of| v.acceleration(first(of)).0.into();
    "block.angular_acceleration" "rad/s2" Block Scalar false "Angular acceleration, anticlockwise." |v, of| one(v.acceleration(first(of)).1);
    "block.force" "N/m" Block Vector false "Sum of all forces on the block, weight included, supports and damping excluded." |v, of| v.scratch.net[first(of)].force.into();
    "block.moment" "N" Block Scalar false "Sum of all moments about the centroid (N m per m)." |v, of| one(v.scratch.net[first(of)].moment);
    "block.water_force" "N/m" Block Vector false "Force of the water on all faces of the block." |v, of| v.water_force(first(of)).into();
    "block.kinetic" "J/m" Block Scalar false "Kinetic energy." |v, of| one(v.kinetic(first(of)));
    "block.area" "m2" Block Scalar false "Area: volume per metre of thickness." |v, of| one(area(v, first(of)));
    "block.mass" "kg/m" Block Scalar false "Mass." |v, of| one(v.scratch.shapes.mass[first(of)]);
    "block.momentum" "N s/m" Block Vector false "Momentum." |v, of| momentum(v, first(of)).into();
    "block.stress_normal" "Pa" Block Vector true "Average stress of the block from the forces on its outline, normal components xx, yy as x, y; tension positive; in water the effective stress." |v, of| { let [xx, yy, _] = v.stress(first(of)); [xx, yy] };
    "block.stress_shear" "Pa" Block Scalar true "Average stress of the block, shear component xy." |v, of| one(v.stress(first(of))[2]);
    "block.sigma1_compressive" "Pa" Block Scalar true "Largest principal compression in the plane of the block's average stress." |v, of| one(-principal(v, of).values[1]);
    "block.sigma3_compressive" "Pa" Block Scalar true "Smallest principal compression in the plane of the block's average stress (negative in tension)." |v, of| one(-principal(v, of).values[0]);
    "block.contacts" "-" Block Scalar true "Number of contacts of the block." |v, of| one(blocks(v, &of[..of.len().min(1)]));
    "block.removed" "-" Block Scalar false "1 once the block has been removed." |v, of| one(f64::from(u8::from(!v.world.alive[first(of)])));
    "pair.force" "N/m" Pair Vector true "Sum of all contact and joint forces of the second block on the first." |v, of| { let (a, b) = pair(of); v.pair_wrench(a, b).force.into() };
    "pair.displacement" "m" Pair Vector false "Displacement of the first block's centroid relative to the second's (or of two `pins`)." |v, of| { let (a, b) = pair(of); (v.displacement(a as usize) - v.displacement(b as usize)).into() };
    "pair.convergence" "m" Pair Scalar false "By how much the centroids of the two (or two `pins`) have come nearer to each other since the start or the last reset; negative when they have parted." |v, of| one(convergence(v, of));
    "pair.velocity" "m/s" Pair Vector false "Velocity of the first block's centroid relative to the second's (or of two `pins`)." |v, of| { let (a, b) = pair(of); (v.velocity(a as usize) - v.velocity(b as usize)).into() };
    "pair.moment" "N" Pair Scalar true "Moment of this force about the first block's centroid." |v, of| { let (a, b) = pair(of); one(v.pair_wrench(a, b).moment_i) };
    "pair.normal_force" "N/m" Pair Scalar true "Normal force of joints and contacts between the two, dashpots included, compression positive (negative for a joint in tension)." |v, of| one(borne(v, of).normal);
    "pair.shear_force" "N/m" Pair Scalar true "Shear force of joints and contacts between the two on the first block, dashpots included." |v, of| one(borne(v, of).shear);
    "pair.shear_ratio" "-" Pair Scalar true "Ratio of this shear force to this normal force; 0 without normal force." |v, of| { let k = borne(v, of); one(if k.normal > 0.0 { k.shear.abs() / k.normal } else { 0.0 }) };
    "pair.sliding" "-" Pair Scalar true "1 where the two are in compression and all of it slides: contacts, and joints whose failed points carry the full frictional resistance; otherwise 0." |v, of| one(f64::from(u8::from(borne(v, of).slides)));
    "pair.length" "m" Pair Scalar true "Length of the contacts." |v, of| one(borne(v, of).length);
    "pair.overlap" "m" Pair Scalar true "Largest depth of a boundary point inside the other block." |v, of| one(borne(v, of).depth);
    "pair.contacts" "-" Pair Scalar true "Number of contacts between the two." |v, of| one(borne(v, of).contacts);
    "pair.broken" "-" Pair Scalar true "Share of the points of the joints between the two that have failed, including those released to contact; 0 without joints." |v, of| one(broken_share(v, of));
    "pair.broken_points" "-" Pair Scalar true "Number of joint points between the two that have failed so far: it never decreases, not even when a joint is released to contact or a block is removed." |v, of| { let key = key(of); one(broken_points(v, |ends| ends == key)) };
    "pair.opening" "m" Pair Scalar true "Largest opening of the joints between the two (negative in compression)." |v, of| one(joint(v, of, |p| p.opening));
    "pair.joint_normal_stress" "Pa" Pair Scalar true "Largest normal stress of the joints between the two, tension positive." |v, of| one(joint(v, of, |p| p.sigma));
    "pair.joint_shear_stress" "Pa" Pair Scalar true "Largest magnitude of the joints' shear stress." |v, of| one(joint(v, of, |p| p.tau.abs()));
    "pair.seepage_rate" "m2/s" Pair Scalar true "Largest flow rate in the joints between the two, per metre of thickness." |v, of| one(v.world.seepage_between(pair(of)));
    "pair.pore_pressure" "Pa" Pair Scalar true "Largest pressure of the water at the centres of contacts and at the joint points between the two; of two fixed blocks at the middles of the edges that they share." |v, of| one(pore_pressure(v, of));
    "group.displacement" "m" Group Vector false "Mean displacement of the group's blocks." |v, of| mean(of, |b| v.displacement(b));
    "group.velocity" "m/s" Group Vector false "Mean velocity of the group's blocks." |v, of| mean(of, |b| v.velocity(b));
    "group.kinetic" "J/m" Group Scalar false "Kinetic energy of the group's blocks." |v, of| one(of.iter().map(|&b| v.kinetic(b as usize)).sum());
    "group.area" "m2" Group Scalar false "Area of the group's existing blocks: volume per metre of thickness." |v, of| one(there(v, of).map(|b| area(v, b)).sum());
    "group.mass" "kg/m" Group Scalar false "Mass of the group's existing blocks." |v, of| one(there(v, of).map(|b| v.scratch.shapes.mass[b]).sum());
    "group.drawn_mass" "kg/m" Group Scalar false "Mass of the group's blocks that have been removed, by phases, by code or because they left the model." |v, of| one(drawn(v, of));
    "group.recovery" "-" Group Scalar false "Share of the group's mass that has been removed: of ore the recovery." |v, of| one(part(drawn(v, of), of.iter().map(|&b| v.scratch.shapes.mass[b as usize]).sum()));
    "group.dilution" "-" Group Scalar false "Share of the group in the mass of all removed blocks: of waste the dilution; 0 while nothing is removed." |v, of| one(part(drawn(v, of), removed_mass(v, 0..v.world.alive.len())));
    "group.blocks" "-" Group Scalar false "Number of the group's existing blocks." |v, of| one(there(v, of).count() as f64);
    "group.momentum" "N s/m" Group Vector false "Momentum of the group's existing blocks." |v, of| there(v, of).map(|b| momentum(v, b)).sum::<Vec2>().into();
    "group.repose_angle" "rad" Group Scalar true "Mean slope of both flanks of the group's outline between 20 % and 80 % of its height: the angle of repose of a heap; for separate heaps the mass-weighted mean." |v, of| one(heap::repose_angle(v, of));
    "group.force" "N/m" Group Vector false "Sum of the net forces on the group's blocks." |v, of| of.iter().map(|&b| v.scratch.net[b as usize].force).sum::<Vec2>().into();
    "group.water_force" "N/m" Group Vector false "Sum of the forces of the standing water on the group's blocks." |v, of| of.iter().map(|&b| v.water_force(b as usize)).sum::<Vec2>().into();
    "group.fragments" "-" Group Scalar true "Number of fragments with a block of the group (see `model.fragments`)." |v, of| one(v.fragments().loose_with(there(v, of)).len() as f64);
    "group.largest_fragment" "m2" Group Scalar true "Area of the largest fragment with a block of the group; 0 without fragments." |v, of| one(v.fragments().loose_with(there(v, of)).first().map_or(0.0, |f| f.size));
    "group.max_displacement" "m" Group Scalar false "Largest displacement in the group." |v, of| largest(of.iter().map(|&b| b as usize), |b| v.displacement(b).length());
    "group.max_rotation" "rad" Group Scalar false "Largest magnitude of rotation in the group." |v, of| largest(of.iter().map(|&b| b as usize), |b| v.rotation(b).abs());
    "group.max_speed" "m/s" Group Scalar false "Largest speed in the group." |v, of| largest(of.iter().map(|&b| b as usize), |b| v.velocity(b).length());
    "model.time" "s" Model Scalar false "Model time." |v, _| one(v.world.time);
    "model.steps" "-" Model Scalar false "Number of steps done." |v, _| one(v.world.step as f64);
    "model.time_step" "s" Model Scalar false "Size of the last time step." |v, _| one(v.world.last_dt);
    "model.kinetic" "J/m" Model Scalar true "Kinetic energy of all blocks." |v, _| one(v.living().map(|b| v.kinetic(b)).sum());
    "model.seepage_inflow" "m2/s" Model Scalar true "Inflow of water through open faces, per metre of thickness." |v, _| one(v.world.seepage_inflow());
    "model.unbalanced" "-" Model Scalar true "Unbalanced-force ratio: sum of net forces on free blocks over the sum of the forces acting on them." |v, _| one(v.unbalanced());
    "model.contacts" "-" Model Scalar true "Number of contacts." |v, _| one(v.contacts().count() as f64);
    "model.slipping" "-" Model Scalar true "Number of contacts that slid in the last step." |v, _| one(v.contacts().filter(|(_, _, c)| c.slipping).count() as f64);
    "model.max_overlap" "m" Model Scalar true "Largest depth of a boundary point inside another block." |v, _| one(v.contacts().map(|(_, _, c)| c.depth).fold(0.0, f64::max));
    "model.max_overlap_ratio" "-" Model Scalar true "Largest overlap of a contact, or closing of a joint, over the smaller inscribed radius of the pair." |v, _| one(v.worst_overlap().map_or(0.0, |(x, _, _)| x));
    "model.max_displacement" "m" Model Scalar true "Largest displacement of a free block." |v, _| largest(free(v), |b| v.displacement(b).length());
    "model.max_rotation" "rad" Model Scalar true "Largest magnitude of rotation of a free block." |v, _| largest(free(v), |b| v.rotation(b).abs());
    "model.max_speed" "m/s" Model Scalar true "Largest speed of a free block." |v, _| largest(free(v), |b| v.velocity(b).length());
    "model.momentum" "N s/m" Model Vector true "Momentum of all blocks." |v, _| v.living().map(|b| v.scratch.shapes.mass[b] * v.velocity(b)).sum::<Vec2>().into();
    "model.angular_momentum" "N s" Model Scalar true "Angular momentum of all blocks about the origin (N m s per m)." |v, _| one(v.angular_momentum());
    "model.blocks" "-" Model Scalar true "Number of existing blocks." |v, _| one(v.living().count() as f64);
    "model.broken" "-" Model Scalar true "Number of joints whose points have all failed." |v, _| one(v.world.bonds.iter().filter(|b| b.broken()).count() as f64);
    "model.broken_points" "-" Model Scalar true "Number of joint points that have failed so far: it never decreases, not even when blocks are removed." |v, _| one(broken_points(v, |_| true));
    "model.joints" "-" Model Scalar true "Number of joints built." |v, _| one(v.world.bonds.len() as f64);
    "model.left_blocks" "-" Model Scalar false "Number of blocks that have left the model (`phases.*.leavers`)." |v, _| one(v.world.left.blocks as f64);
    "model.left_mass" "kg/m" Model Scalar false "Mass of the blocks that have left the model." |v, _| one(v.world.left.mass);
    "model.left_momentum" "N s/m" Model Vector false "Momentum that they took along." |v, _| { let [x, y, _] = v.world.left.momentum; [x, y] };
    "model.fragments" "-" Model Scalar true "Number of fragments: blocks connected by intact joints. Blocks with all freedoms prescribed, and blocks joined to them, are not fragments." |v, _| one(v.fragments().loose().count() as f64);
    "model.largest_fragment" "m2" Model Scalar true "Area of the largest fragment; 0 without fragments." |v, _| one(v.fragments().loose().next().map_or(0.0, |f| f.size));
    "bolt.axial_force" "N" Bolt Scalar false "Largest axial force in the bolts, tension positive." |v, of| one(bolts::largest(v, of, f64::NEG_INFINITY, bolts::force));
    "bolt.head_force" "N" Bolt Scalar false "Largest force of the plates on the bolts." |v, of| one(bolts::largest(v, of, f64::NEG_INFINITY, bolts::plate));
    "bolt.shear_force" "N" Bolt Scalar false "Largest shear force of the bolts across a joint." |v, of| one(bolts::largest(v, of, 0.0, bolts::shear));
    "bolt.slip" "m" Bolt Scalar false "Largest slip of the grout." |v, of| one(bolts::largest(v, of, 0.0, |_, b| b.chain.largest_slip()));
    "bolt.elongation" "m" Bolt Scalar false "Largest plastic elongation of a bar at one point." |v, of| one(bolts::largest(v, of, 0.0, |_, b| b.chain.largest_yield()));
    "bolt.utilisation" "-" Bolt Scalar false "Largest ratio of axial force to yield force; 0 for bars without yield." |v, of| one(bolts::largest(v, of, 0.0, |s, b| b.chain.utilisation(&s.design)));
    "bolt.broken" "-" Bolt Scalar false "Number of points at which bars have ruptured." |v, of| one(bolts::of(v, of).map(|b| f64::from(b.toll.breaks)).sum());
    "model.bolts" "-" Model Scalar false "Number of installed bolts." |v, _| one(v.world.bolts.len() as f64);
    "model.bolt_imbalance" "-" Model Scalar true "Largest unbalanced share of a bolt's force so far; 0 if every iteration converged." |v, _| one(v.world.bolts.iter().map(|b| b.toll.left).fold(0.0, f64::max));
    "boundary.work" "J/m" Boundary Scalar false "Work of the stress of the surrounding rock on a side of the model." |v, of| one(v.world.work_of_boundary(first(of)));
    "support.force" "N/m" Support Vector false "Force of a support on the blocks that it holds or drives: its reaction, including the inertia of a driven motion, without damping." |v, of| v.on_support(first(of)).0.into();
    "support.moment" "N" Support Scalar false "Moment of this force about the centre of mass of its blocks (N m per m)." |v, of| one(v.on_support(first(of)).1);
    "support.work" "J/m" Support Scalar false "Work of a support on its blocks; fixed supports do none." |v, of| one(v.world.work(first(of)));
    "load.work" "J/m" Load Scalar false "Work of a load on its blocks." |v, of| one(v.world.work(first(of)));
    "energy.kinetic" "J/m" Energy Scalar true "Kinetic energy, time-centred." |v, _| one(v.balance().kinetic);
    "energy.gravity" "J/m" Energy Scalar true "Potential energy of gravity, relative to the start." |v, _| one(v.balance().gravity);
    "energy.contact_normal" "J/m" Energy Scalar true "Elastic energy in the normal direction of contacts (exact for the distance potential, otherwise integrated along the path)." |v, _| one(v.balance().contact_normal);
    "energy.contact_shear" "J/m" Energy Scalar true "Elastic energy of the shear springs of contacts." |v, _| one(v.balance().contact_shear);
    "energy.joints" "J/m" Energy Scalar true "Elastic energy of joints." |v, _| one(v.balance().bond);
    "energy.bolts" "J/m" Energy Scalar true "Elastic energy of bolts: bars, grout, plates and dowels." |v, _| one(v.world.bolt_energy());
    "energy.loads" "J/m" Energy Scalar true "Work of external loads." |v, _| one(v.world.works.loads);
    "energy.supports" "J/m" Energy Scalar true "Work of supports with prescribed motion." |v, _| one(v.world.works.supports);
    "energy.friction" "J/m" Energy Scalar true "Dissipated by friction." |v, _| one(v.world.works.friction);
    "energy.damping" "J/m" Energy Scalar true "Dissipated by contact, joint, mass and local damping." |v, _| one(v.world.works.damping);
    "energy.fracture" "J/m" Energy Scalar true "Released by the failure of joints." |v, _| one(v.world.works.fracture);
    "energy.bolt_loss" "J/m" Energy Scalar true "Dissipated in bolts: yield of bars, slip of grout and dowels, rupture." |v, _| one(v.world.works.bolts);
    "energy.integrator" "J/m" Energy Scalar true "Taken by the integration itself in implicit phases." |v, _| one(v.world.works.integrator);
    "energy.left" "J/m" Energy Scalar true "Taken along by blocks that have left the model (`phases.*.leavers`)." |v, _| one(v.world.works.left);
    "energy.law_defect" "J/m" Energy Scalar true "Created (+) or lost (-) by a contact law without potential, or by too long steps." |v, _| one(v.world.works.law_defect);
    "energy.edit_defect" "J/m" Energy Scalar true "Added by edits: removed blocks, zeroed velocities, changed laws, joints released to contact." |v, _| one(v.world.works.edit_defect);
    "energy.step_change" "J/m" Energy Scalar true "Added by changes of the time step, including the first, and by jumps of forces: the difference between the kinetic energies at half steps and at whole steps." |v, _| one(v.world.works.step_change);
    "energy.residual" "J/m" Energy Scalar true "Energy that the ledger does not explain." |v, _| one(v.balance().residual());
    "energy.residual_relative" "-" Energy Scalar true "The residual relative to the largest energy exchanged." |v, _| one(v.balance().residual_relative());
}

/// A field with everything needed to read one number.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    index: usize,
    part: Part,
    of: Vec<u32>,
    groups: Vec<String>,
    along: Option<[f64; 2]>,
    /// Whether the thickness of the model is given.
    slice: bool,
}

impl Reading {
    /// Finds `name` in the table; vectors need a part or a direction `along`.
    ///
    /// # Errors
    /// Unknown names and parts of scalars.
    pub fn new(name: &str, of: &[u32], along: Option<[f64; 2]>) -> Result<Self, FieldError> {
        let (index, part) = place(INFOS, name)?;
        Ok(Self { index, part, of: of.to_vec(), groups: Vec::new(), along, slice: false })
    }

    /// The same with blocks that join groups of these names while the model runs.
    #[must_use]
    pub fn with_groups(self, groups: &[String]) -> Self {
        Self { groups: groups.to_vec(), ..self }
    }

    /// The same of a model whose thickness is given.
    #[must_use]
    pub fn of_slice(self) -> Self {
        Self { slice: true, ..self }
    }

    /// Table entry.
    #[must_use]
    pub fn info(&self) -> &'static FieldInfo {
        match self.slice {
            true => &INFOS_OF_SLICE[self.index],
            false => &INFOS[self.index],
        }
    }

    /// Whether reading it costs as much as a step.
    #[must_use]
    pub fn costly(&self) -> bool {
        READERS[self.index].costly
    }

    /// The number; a vector without part or direction gives its magnitude.
    #[must_use]
    pub fn value(&self, view: &View<'_>) -> f64 {
        let groups = view.world.setup.groups.iter();
        let groups = groups.filter(|group| self.groups.contains(&group.name));
        let of = joined(&self.of, groups.map(|group| &group.blocks[..]));
        let per_metre = (READERS[self.index].get)(view, &of);
        let info = &INFOS[self.index];
        let values = match unit_of_slice(info.site, info.unit) {
            Some(_) => per_metre.map(|value| value * view.world.setup.slice()),
            None => per_metre,
        };
        self.part.read(info.shape, values, self.along)
    }
}
