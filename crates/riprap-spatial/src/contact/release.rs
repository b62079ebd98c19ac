//! Patches that let go: found contact takes over what they carry.
//!
//! A patch knows two faces as they lay on each other when it was built. Once nothing holds its points together and it has slid,
//! turned or opened too far for that, it goes, and its pair becomes one that is searched for. What opens and closes in place
//! stays a patch, which is far cheaper. What hinges goes at once: the four points of a patch lie inside the face, and a block that rocks
//! about two of them has its hinge there instead of at its edge (a cube would topple at 30 deg). A patch of which some points still hold
//! is a hinge as long as its blocks stay nearly parallel; where they fold, the plane between them means nothing any more (at half a
//! turn it is not even defined), so its last points fail and it goes. So does what a law lets slide by more than the faces are wide
//! (`softening.slip` of a metre between bricks of half a metre): where the centre of one face has left the other, the points of the
//! patch carry a block that hangs in the air.
//!
//! Shear and torsion go on as springs of the found contact. What the patch carries across its plane and the pressure of found
//! contact are reconciled there ([`crate::kernel::offset`]). Differences in stored energy are booked with edits.

use crate::laws::face_joint::Traction;
use riprap_geom::Vec3;

use crate::contact::CHECK_INTERVAL;
use crate::contact::held::pair_of_patch;
use crate::faces::overlap::bare;
use crate::joint::patch;
use crate::joint::patch::Poses;
use crate::joint::reading::Reading;
use crate::kernel::offset::{Carried, Offset};
use crate::kernel::{Memory, PairKey};
use crate::laws::mohr_coulomb::Strength;
use crate::setup::Points;
use crate::state::face::Face;
use crate::state::found::{ContactPatch, FoundPair};
use crate::state::patches::flag;
use crate::state::scratch::Scratch;
use crate::state::world::World;

/// Slip over the smaller side of the patch.
const SLID: f64 = 0.05;
/// Opening of all points over the smaller side.
const OPEN: f64 = 0.01;
/// Way of a point of a patch that has slid or opened, over the smaller side: from here on the patch no longer holds its blocks in place
/// against others ([`super::held`]).
///
/// `Deviation:` of this program. What the edges of two such blocks sink into each other before they are looked at is at most this share of
/// the side; a smaller one would have every rim of a blasted lattice inspected that has shaken loose.
const DISPLACED: f64 = 1e-3;
/// Rotation of both blocks against each other, rad.
const TURNED: f64 = 0.02;
/// The same where some points are open and others are pressed, rad.
const HINGED: f64 = 2e-5;
/// Rotation at which the last points of a patch fail that has failed in part, rad.
///
/// `Deviation:` of this program; no source says when a strength at points ends by rotation. At 0.3 rad a patch 0.1 m wide has opened by
/// 30 mm at its far edge, far beyond what rock bears; what is left of its strength by then is an error of the points, not of the rock.
const FOLDED: f64 = 0.3;
/// Slip over the side of a patch along it at which its last points fail: the centre of one face has come to the edge of the other.
///
/// `Deviation:` of this program; softening laws are of joints that are long against their slip.
const TORN: f64 = 0.5;

/// Lets patches go that no longer describe where their blocks touch; every [`CHECK_INTERVAL`] steps.
pub(crate) fn release(world: &mut World, scratch: &mut Scratch) {
    // Implicit steps are as long as many explicit ones.
    let due = world.implicit.is_some() || world.step.is_multiple_of(CHECK_INTERVAL);
    let look = world.pending > 0.0 && due;
    if !world.setup.found_contacts || !look {
        return;
    }
    let (seen, known) = (&*world, &*scratch);
    // Each patch by itself: what fails here changes nothing of another.
    let change = |p: usize| {
        if is_folded(seen, p) || is_torn(seen, p) {
            Some((p, Change::Fails))
        } else if is_loose(seen, p) && is_past(seen, p) {
            Some((p, Change::Released))
        } else {
            is_displaced(seen, p).then_some((p, Change::Displaced))
        }
    };
    // Nearly always none does, and a step takes no memory then.
    let count = seen.patches.len();
    let first = known.exec.smallest(count, |mut chunk| {
        let first = chunk.find(|p| change(*p).is_some());
        first.map_or(f64::INFINITY, |p| p as f64)
    });
    if first.is_infinite() {
        return;
    }
    let chunks = known.exec.chunked(count, |chunk| chunk.filter_map(change).collect::<Vec<_>>());
    let mut pairs = Vec::new();
    for (p, change) in chunks.into_iter().flatten() {
        match change {
            Change::Displaced => {
                world.patches.flags[p] |= flag::DISPLACED;
                world.fresh = true;
                continue;
            }
            Change::Fails => fail(world, p),
            Change::Released => {}
        }
        pairs.push(pair_of_patch(world, p).0);
    }
    pairs.sort_unstable();
    pairs.dedup();
    if !pairs.is_empty() {
        release_pairs(world, scratch, &pairs);
    }
}

/// What becomes of a patch at a look.
#[derive(Clone, Copy)]
enum Change {
    /// It stays, and holds its blocks in place no longer.
    Displaced,
    Released,
    /// Its last points fail, and it is released.
    Fails,
}

/// Lets go all patches that nothing but pressure and friction holds, wherever their blocks are. Those with stress in place stay: a contact
/// knows none that its depth does not give.
pub(crate) fn release_loose(world: &mut World, scratch: &mut Scratch) {
    let stressed = |p: usize| world.patches.prestress.get(p).is_some_and(|t| *t != Vec3::ZERO);
    let loose = (0..world.patches.len()).filter(|p| is_loose(world, *p) && !stressed(*p));
    let mut pairs: Vec<PairKey> = loose.map(|p| pair_of_patch(world, p).0).collect();
    pairs.sort_unstable();
    pairs.dedup();
    if !pairs.is_empty() {
        release_pairs(world, scratch, &pairs);
    }
}

/// Gives what all patches of these pairs (sorted) carry to the found contacts of their blocks.
pub(super) fn release_pairs(world: &mut World, scratch: &mut Scratch, pairs: &[PairKey]) {
    let mut parted = vec![false; world.alive.len()];
    for b in pairs.iter().flat_map(|pair| &pair.ends) {
        parted[*b as usize] = true;
    }
    // Two convex blocks share one plane: all of its patches go at once.
    let goes = |p: &usize| {
        world.patches.ends[*p].iter().all(|b| parted[*b as usize])
            && pairs.binary_search(&pair_of_patch(world, *p).0).is_ok()
    };
    let gone: Vec<usize> = (0..world.patches.len()).filter(goes).collect();
    for &p in &gone {
        let failed = failed_points(world, p);
        world.failed.add(world.patches.ends[p], failed);
        hand_over(world, p);
        let faces = [0, 1].map(|side| Face { parted: true, ..bare(world, p, side) });
        world.faces.extend(faces);
    }
    world.faces.sort_by_key(|face| face.block);
    world.patches.drop_some(&gone);
    // The stable step can only grow: what was found for it stays, and so does the number of rebuilds.
    scratch.relay_patches(world);
    world.fresh = true;
}

/// Half the sides of a patch along b and c over the root of 3, m.
fn gyration(world: &World, p: usize) -> [f64; 2] {
    let class = &world.classes[world.patches.class[p] as usize];
    let joint = patch::joint(&world.setup.interfaces, class);
    let spread = match joint.points {
        Points::Gauss => 1.0,
        Points::Quarter => 0.75f64.sqrt(),
    };
    class.half_spacing.map(|half_spacing| half_spacing / spread)
}

/// Number of points of patch `p` that have failed once found contact takes it over: all of them where its law has a strength, which
/// ends then, also where a neighbour between the same blocks let it go.
fn failed_points(world: &World, p: usize) -> u64 {
    let (flags, class) = (world.patches.flags[p], world.patches.class[p]);
    let joint = patch::joint(&world.setup.interfaces, &world.classes[class as usize]);
    match &joint.strength {
        Some(strength) if strength.tension > 0.0 || strength.cohesion > 0.0 => 4,
        _ => u64::from((flags & flag::BROKEN).count_ones()),
    }
}

/// Whether nothing but pressure and friction holds a patch: all points have failed, or there is nothing that could.
pub(crate) fn is_loose(world: &World, p: usize) -> bool {
    let (flags, class) = (world.patches.flags[p], world.patches.class[p]);
    let joint = patch::joint(&world.setup.interfaces, &world.classes[class as usize]);
    let strengthless = |s: &Strength| s.tension <= 0.0 && s.cohesion <= 0.0;
    flags & flag::BROKEN == flag::BROKEN
        || (joint.is_plain() && joint.strength.as_ref().is_some_and(strengthless))
}

/// Whether a loose patch has slid, turned or opened too far.
fn is_past(world: &World, p: usize) -> bool {
    let list = &world.patches;
    let class = &world.classes[list.class[p] as usize];
    let poses = Poses { bodies: &world.bodies, turned: &world.turned };
    let points = poses.points(class, list.ends[p], list.flags[p] & flag::FINITE != 0);
    let [b, c] = sides(world, p);
    let side = b.min(c);
    let normal_offset = list.normal_offset.get(p).copied().unwrap_or_default();
    if (points.at.iter().zip(normal_offset))
        .all(|(at, normal_offset)| at[0] - normal_offset > OPEN * side)
    {
        return true;
    }
    let slip = mean_slip(&points);
    if slip[0] * slip[0] + slip[1] * slip[1] > (SLID * side) * (SLID * side) {
        return true;
    }
    let turned = turned(&poses, list.ends[p]);
    turned > TURNED || (turned > HINGED && hinges(world, p))
}

/// Whether a point of a patch that slides, opens or has failed has gone so far that the patch holds its blocks in place no longer; once.
fn is_displaced(world: &World, p: usize) -> bool {
    let (list, flags) = (&world.patches, world.patches.flags[p]);
    let gives = flags & (flag::BROKEN | flag::OPEN | flag::SLIDING) != 0;
    if !gives || flags & flag::DISPLACED != 0 {
        return false;
    }
    let class = &world.classes[list.class[p] as usize];
    let poses = Poses { bodies: &world.bodies, turned: &world.turned };
    let points = poses.points(class, list.ends[p], flags & flag::FINITE != 0);
    let normal_offset = list.normal_offset.get(p).copied().unwrap_or_default();
    let [b, c] = sides(world, p);
    let way = DISPLACED * b.min(c);
    points.at.iter().zip(normal_offset).any(|(at, normal_offset)| {
        at[0] - normal_offset > way || at[1] * at[1] + at[2] * at[2] > way * way
    })
}

/// Sides of a patch along b and c, m.
fn sides(world: &World, p: usize) -> [f64; 2] {
    gyration(world, p).map(|radius| 2.0 * 3.0f64.sqrt() * radius)
}

/// Mean slip of the points of a patch along b and c, m.
fn mean_slip(points: &patch::Points) -> [f64; 2] {
    [1, 2].map(|k| 0.25 * points.at.iter().map(|at| at[k]).sum::<f64>())
}

/// Whether a patch that has not failed has slid so far that its faces hardly meet; only laws that change with slip let it.
fn is_torn(world: &World, p: usize) -> bool {
    let list = &world.patches;
    let class = &world.classes[list.class[p] as usize];
    let joint = patch::joint(&world.setup.interfaces, class);
    if joint.is_plain() || joint.strength.is_none() || list.flags[p] & flag::BROKEN == flag::BROKEN
    {
        return false;
    }
    let poses = Poses { bodies: &world.bodies, turned: &world.turned };
    let points = poses.points(class, list.ends[p], list.flags[p] & flag::FINITE != 0);
    let slip = mean_slip(&points);
    let sides = sides(world, p);
    (0..2).any(|k| slip[k].abs() > TORN * sides[k])
}

/// Rotation of two blocks against each other, rad: exact where it is small, 0.3 rad less at half a turn.
fn turned(poses: &Poses, ends: [u32; 2]) -> f64 {
    let [i, j] = ends.map(|b| poses.attitude(b as usize));
    // Quaternions of attitudes an angle a apart differ by 2 sin(a/4).
    let apart = (i - j).length_squared().min((i + j).length_squared());
    2.0 * apart.sqrt()
}

/// Whether a patch of which some points have failed and others hold has folded.
fn is_folded(world: &World, p: usize) -> bool {
    let broken = world.patches.flags[p] & flag::BROKEN;
    let poses = Poses { bodies: &world.bodies, turned: &world.turned };
    broken != 0 && broken != flag::BROKEN && turned(&poses, world.patches.ends[p]) > FOLDED
}

/// Tractions of patch `p` on block i at its points.
fn tractions(world: &World, p: usize) -> [Traction; 4] {
    let patch = Reading { world, p };
    patch.tractions(&patch.points())
}

/// Lets the points of patch `p` fail that still hold; what their springs give up is fracture.
fn fail(world: &mut World, p: usize) {
    let stored = |world: &World| Reading { world, p }.energy().iter().sum::<f64>();
    let before = stored(world);
    let tractions = tractions(world, p);
    let flags = &mut world.patches.flags[p];
    *flags |= flag::BROKEN;
    for (q, traction) in tractions.iter().enumerate() {
        if traction[0] > 0.0 {
            *flags |= flag::of(flag::OPEN, q);
        }
    }
    world.works.dissipate(0.0, before - stored(world));
}

/// Whether some points of a patch are open while others are pressed.
fn hinges(world: &World, p: usize) -> bool {
    let tractions = tractions(world, p);
    let pressed = tractions.iter().filter(|traction| traction[0] < 0.0);
    (1..tractions.len()).contains(&pressed.count())
}

/// Gives what patch `p` carries to the found contact of its blocks.
fn hand_over(world: &mut World, p: usize) {
    let patch = Reading { world, p };
    let points = patch.points();
    let mut tractions = patch.tractions(&points);
    let [normal_energy, _] = patch.energy();
    let [normal, b, c] = points.frame;
    let class = *patch.class();
    let share = 0.25 * class.area;
    let (mut shear, mut torsion, mut shear_energy) = (Vec3::ZERO, 0.0, 0.0);
    let (mut pressed, mut rocking) = (0.0, Vec3::ZERO);
    let joint = patch::joint(&world.setup.interfaces, &class);
    for (q, traction) in tractions.iter_mut().enumerate() {
        if let Some(strength) = &joint.strength {
            // The blocks have moved since the points last slid: what is beyond their strength slides now.
            let limit = strength.residual(traction[0].min(0.0));
            let size = (traction[1] * traction[1] + traction[2] * traction[2]).sqrt();
            if size > limit {
                traction[1] *= limit / size;
                traction[2] *= limit / size;
            }
        }
        let squared = traction[1] * traction[1] + traction[2] * traction[2];
        shear_energy += share * squared / (2.0 * class.stiffness[1]);
        let at = patch::place(&class, q);
        let [y, z] = [class.frame[1].dot(at), class.frame[2].dot(at)];
        shear += share * (traction[1] * b + traction[2] * c);
        torsion += share * (y * traction[2] - z * traction[1]);
        pressed -= share * traction[0];
        rocking += share * traction[0] * (y * b + z * c).cross(normal);
    }
    let radii = gyration(world, p);
    let (key, turned) = pair_of_patch(world, p);
    let ends = world.patches.ends[p].map(|b| b as usize);
    let poses = Poses { bodies: &world.bodies, turned: &world.turned };
    let arms = [0, 1].map(|k| poses.attitude(ends[k]) * class.arms[k]);
    let from = |k: usize| {
        let position = world.reference[ends[k]] + world.bodies.displacement(ends[k]);
        // Seen as the pair has it: its second block by the image that lies on the first.
        key.place(k ^ usize::from(turned), position, &world.setup.periodic) + arms[k]
    };
    let centre = 0.5 * (from(0) + from(1));
    // Tractions are those on i; the found contact counts what acts on the second block, and its normal points there.
    let sign: f64 = if turned { -1.0 } else { 1.0 };
    let pairs = &mut world.found.pairs;
    let at = pairs.partition_point(|pair| pair.key() < key);
    if pairs.get(at).is_none_or(|pair| pair.key() != key) {
        pairs.insert(at, FoundPair::new(key));
    }
    let pair = &mut pairs[at];
    pair.seated = true;
    // The first patch of a pair says about which point all of them are added.
    let first = pair.offset.as_ref().and_then(|offset| offset.joint);
    let about = first.map_or(centre, |carried| carried.at);
    let (shear, arm) = (-sign * shear, centre - about);
    let load = sign * pressed * normal;
    let carried = first.unwrap_or_default();
    pair.offset = Some(Box::new(Offset::new(Carried {
        normal: carried.normal + pressed,
        rocking: carried.rocking - sign * rocking + arm.cross(load),
        at: about,
        energy: carried.energy + normal_energy,
    })));
    if pair.patches.is_empty() {
        pair.push(ContactPatch::default());
    }
    let patch = &mut pair.patches[0];
    let memory = Memory {
        shear: patch.memory.shear + shear,
        torsion: patch.memory.torsion - torsion + sign * arm.cross(shear).dot(normal),
        normal: sign * normal,
        area: patch.memory.area + class.area,
        polar: patch.memory.polar + class.area * (radii[0] * radii[0] + radii[1] * radii[1]),
        sliding: true,
        arms: if turned { [arms[1], arms[0]] } else { arms },
    };
    let stored = memory.stored(class.stiffness[1]);
    let change = stored - patch.stored;
    (patch.memory, patch.stored) = (memory, stored);
    world.works.edit_defect += change - shear_energy;
}

#[cfg(test)]
mod tests {
    use riprap_geom::Vec3;

    use super::release_pairs;
    use crate::contact::tests::{Run, above_floor, brick};
    use crate::dynamics::TimeFunction;
    use crate::exec::Exec;
    use crate::kernel::PairKey;
    use crate::kernel::offset::{Carried, Offset};
    use crate::setup::{Load, LoadKind};
    use crate::state::patches::flag;
    use crate::state::scratch::Scratch;
    use crate::topology::split;

    /// A brick of half a metre on the floor, whose edge is at x = 4 m, joined to it without strength.
    fn joined(x: f64, velocity: Vec3, friction: f64) -> Run {
        let mut block = brick([x, -0.25, 0.0], [0.5; 3]);
        block.velocity = velocity;
        let run = Run::new(above_floor(vec![block], friction, 0.1), 1, 1e-4);
        assert_eq!(run.world.patches.len(), 1);
        run
    }

    #[test]
    fn a_brick_that_slides_off_the_edge_falls() {
        let mut run = joined(2.5, Vec3::new(3.0, 0.0, 0.0), 0.0);
        run.until(0.2);
        assert!(run.world.patches.is_empty());
        // Still on the floor, and carried by it.
        let place = run.place(1);
        assert!((place.z - 0.25).abs() < 1e-3 && (place.x - 3.35).abs() < 1e-3, "{place}");
        let weight = 2500.0 * 0.125 * 9.81;
        let carried = run.world.found.pairs[0].force().z;
        assert!((carried / weight - 1.0).abs() < 0.02, "{carried}");
        run.until(0.9);
        assert!(run.place(1).z < -0.5, "{}", run.place(1));
        let balance = run.view().balance();
        assert!(balance.residual_relative().abs() < 1e-3, "{balance:?}");
    }

    /// A brick whose joint to the floor holds at two of four points turns about them by a quarter turn and more.
    #[test]
    fn a_joint_that_has_partly_failed_lets_go_when_it_folds() {
        let mut block = brick([2.0, -0.25, 0.0], [0.5; 3]);
        let rate = 4.0;
        block.spin = Vec3::new(0.0, rate, 0.0);
        let hinge = Vec3::new(2.25 + 0.25 / 3.0f64.sqrt(), 0.0, 0.0);
        block.velocity = block.spin.cross(Vec3::new(2.25, 0.0, 0.25) - hinge);
        let mut setup = above_floor(vec![block], 0.5, 0.1);
        setup.gravity = Vec3::ZERO;
        let strength = setup.interfaces[0].joint.strength.as_mut().unwrap();
        (strength.cohesion, strength.tension) = (1e9, 1e9);
        let mut run = Run::new(setup, 1, 2e-5);
        let class = run.world.classes[run.world.patches.class[0] as usize];
        for q in 0..4 {
            if crate::joint::patch::place(&class, q).dot(Vec3::X) < 0.0 {
                run.world.patches.flags[0] |= flag::of(flag::BROKEN, q) | flag::of(flag::OPEN, q);
            }
        }
        run.until(0.3 / rate - 0.01);
        assert_eq!(run.world.patches.len(), 1);
        run.until(0.3 / rate + 0.01);
        assert!(run.world.patches.is_empty());
        let works = run.world.works;
        let energy = run.view().balance().kinetic;
        assert!(works.fracture > 0.0, "{works:?}");
        run.until(3.0 / rate);
        let balance = run.view().balance();
        assert!(balance.residual_relative().abs() < 1e-3, "{balance:?}");
        // Nothing but a blow on the floor takes from it what the hinge left.
        assert!(balance.kinetic <= 1.001 * energy, "{balance:?} {energy}");
    }

    #[test]
    fn friction_goes_on_when_the_joint_gives_way() {
        let mut run = joined(-2.0, Vec3::new(1.5, 0.0, 0.0), 0.5);
        run.until(0.5);
        assert!(run.world.patches.is_empty());
        let way = run.place(1).x + 1.75;
        let wanted = 1.5 * 1.5 / (2.0 * 0.5 * 9.81);
        assert!((way / wanted - 1.0).abs() < 0.02, "{way} {wanted}");
        assert!((run.place(1).z - 0.25).abs() < 1e-4);
        let balance = run.view().balance();
        assert!(balance.residual_relative().abs() < 1e-2, "{balance:?}");
    }

    /// A slab of a metre on a joint that is softer (0.4) than found contact and carries its weight; the joint lets go and the slab is
    /// pushed with 0.7 of its weight, where friction holds 0.5. Without what is kept of the joint's load it would jump up by 1.5
    /// weights. Expected: `1/2 0.2 g t²`.
    #[test]
    fn the_load_of_a_joint_goes_on_when_it_lets_go() {
        let g = 10.0;
        let mut setup = above_floor(vec![brick([-0.5, -0.5, 0.0], [1.0, 1.0, 0.1])], 0.5, 0.2);
        setup.gravity = Vec3::new(0.7 * g, 0.0, -g);
        let mut run = Run::new(setup, 1, 2e-5);
        for class in &mut run.world.classes {
            class.stiffness = class.stiffness.map(|k| 0.4 * k);
        }
        run.scratch = Scratch::new(&mut run.world, Exec::serial());
        let weight = 250.0 * g;
        run.world.bodies.displacement[2][1] = -weight / 0.4e9;
        // Its shear is at the limit: it slides from the first instant.
        let start = 0.5 * weight / (0.4 * 5e8);
        run.world.bodies.displacement[0][1] = start;
        run.world.patches.flags[0] |= flag::BROKEN;
        run.evaluate();
        run.world.start_energy = Some(run.view().balance().total());
        release_pairs(&mut run.world, &mut run.scratch, &[PairKey::plain([0, 1])]);
        run.world.pending = 0.0;
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        for step in 1..=300 {
            run.until(1e-3 * f64::from(step));
            let normal = run.world.found.pairs[0].force().z / weight;
            (least, most) = (least.min(normal), most.max(normal));
        }
        assert!(least > 0.99 && most < 1.01, "{least} {most}");
        let way = run.place(1).x - start;
        assert!((way - 0.09).abs() < 1e-4, "{way}");
        assert!(run.world.found.pairs[0].offset.is_some());
        let balance = run.view().balance();
        assert!(balance.residual_relative().abs() < 1e-6, "{balance:?}");
        // What the hand-over has made: nothing across the joint, and along it springs of the law's stiffness hold the same force.
        let shear = 0.5 * weight;
        let wanted = 0.5 * shear * shear * (1.0 / 0.5e9 - 1.0 / (0.4 * 0.5e9));
        let made = balance.works.edit_defect;
        assert!((made / wanted - 1.0).abs() < 0.02, "{made} {wanted}");
    }

    #[test]
    fn nothing_is_left_of_a_joint_that_has_opened() {
        let mut run = joined(2.0, Vec3::new(0.5, 0.0, 4.0), 0.5);
        run.until(0.3);
        assert!(run.world.patches.is_empty());
        let place = run.place(1);
        let height = 0.25 + 4.0 * 0.3 - 0.5 * 9.81 * 0.09;
        assert!((place.z - height).abs() < 1e-2 && (place.x - 2.4).abs() < 5e-3, "{place}");
        // And it comes down on the floor again.
        run.until(2.0);
        let height = run.place(1).z;
        assert!(height > 0.249 && height < 0.4, "{height}");
    }

    #[test]
    fn the_layout_after_a_joint_has_gone_is_that_of_a_restart() {
        // Bricks side by side in a lattice on the floor, each pushed off in its own way.
        let start = || {
            let mut blocks = Vec::new();
            for k in 0..12 {
                let [x, y] = [f64::from(k % 4), f64::from(k / 4)];
                let mut block = brick([0.5 * x - 1.0, 0.5 * y - 1.0, 0.0], [0.5; 3]);
                block.velocity =
                    Vec3::new(0.9 * (x - 1.4), 0.7 * (y - 0.9), 0.1 * f64::from(k % 3));
                blocks.push(block);
            }
            let mut setup = above_floor(blocks, 0.3, 0.1);
            setup.loads.push(Load {
                blocks: vec![3, 5],
                kind: LoadKind::Point { force: Vec3::new(0.0, 0.0, -500.0), at: None },
                account: None,
                time: TimeFunction::Constant(1.0),
            });
            Run::new(setup, 1, 1e-4)
        };
        let (mut usual, mut laid) = (start(), start());
        let before = usual.world.patches.len();
        let mut some_are_left = false;
        for k in 1..=12 {
            usual.until(0.005 * f64::from(k));
            laid.until_laid_out_each_step(0.005 * f64::from(k));
            assert_eq!(usual.world.hash(), laid.world.hash(), "{k}");
            let tiles = format!("{:?}", usual.scratch.tiles);
            let anew = Scratch::new(&mut usual.world.clone(), Exec::serial());
            assert_eq!(tiles, format!("{:?}", anew.tiles), "{k}");
            some_are_left |= (1..before).contains(&usual.world.patches.len());
        }
        assert!(some_are_left, "{before}");
    }

    /// Two bricks on each other on the floor, the joints between them gone.
    fn parted() -> Run {
        let blocks = vec![brick([0.0, 0.0, 0.0], [0.5; 3]), brick([0.0, 0.0, 0.5], [0.5; 3])];
        let mut run = Run::new(above_floor(blocks, 0.5, 0.1), 1, 1e-4);
        assert_eq!(run.world.patches.len(), 2);
        run.evaluate();
        run.world.start_energy = Some(run.view().balance().total());
        release_pairs(&mut run.world, &mut run.scratch, &[PairKey::plain([1, 2])]);
        run.evaluate();
        run
    }

    #[test]
    fn faces_in_joints_that_have_given_way_are_no_surface() {
        let run = parted();
        assert_eq!(run.view().surface(), [true, false, true]);
    }

    #[test]
    fn blocks_whose_joint_has_given_way_can_be_split() {
        let mut run = parted();
        split(&mut run.world, &mut run.scratch, &[1, 2], run.dt).unwrap();
        // Twelve joints inside each, four to the floor, none between the two.
        assert_eq!(run.world.patches.len(), 2 * 12 + 4);
        let surface = run.view().surface();
        assert_eq!(surface.iter().filter(|s| **s).count(), 5, "{surface:?}");
        // The parts of the upper one lie on those of the lower one.
        run.until(0.2);
        for b in 3..19 {
            let sunk = run.view().displacement(b).z;
            assert!(sunk.abs() < 1e-4, "{b}: {sunk}");
        }
        let residual = run.view().balance().residual_relative();
        assert!(residual.abs() < 1e-2, "{residual}");
    }

    /// What blocks hide of their pressure, their parts hide too: nothing is thrown up when blocks that lie deep in each other are split.
    #[test]
    fn parts_of_blocks_hide_what_these_did() {
        let mut run = parted();
        let depth = 0.02;
        for b in [1, 2] {
            run.world.bodies.displacement[2][b] = -depth * (b as f64 - 1.0);
        }
        for pair in &mut run.world.found.pairs {
            pair.offset = Some(Box::new(Offset::new(Carried::default())));
        }
        run.evaluate();
        let hidden = run.world.found.pairs[0].offset.as_ref().unwrap().hidden;
        let whole = 0.5 * 1e9 * 0.25 * depth * depth;
        assert!((hidden / whole - 1.0).abs() < 0.2, "{hidden} {whole}");
        run.world.start_energy = Some(run.view().balance().total());
        split(&mut run.world, &mut run.scratch, &[1, 2], run.dt).unwrap();
        run.until(0.1);
        let hiding = run.world.found.pairs.iter().filter(|p| p.offset.is_some());
        assert!(hiding.count() >= 4);
        let balance = run.view().balance();
        // Falling onto each other by their weight is all that moves them.
        assert!(balance.kinetic < 1e-3 * whole, "{balance:?} {whole}");
        assert!(balance.works.edit_defect.abs() < 0.1 * whole, "{balance:?} {whole}");
    }

    #[test]
    fn what_opens_and_closes_in_place_stays_a_joint() {
        let mut run = joined(2.0, Vec3::new(0.0, 0.0, 0.02), 0.5);
        run.until(0.3);
        assert_eq!(run.world.patches.len(), 1);
        assert!(run.world.found.pairs.is_empty() || run.world.found.pairs[0].depth == 0.0);
    }

    #[test]
    fn what_rocks_gives_way_at_once_and_comes_to_rest() {
        let mut run = joined(2.0, Vec3::new(0.02, 0.0, 0.02), 0.5);
        run.until(0.3);
        assert!(run.world.patches.is_empty());
        let height = run.place(1).z;
        assert!((height - 0.25).abs() < 1e-4, "{height}");
    }
}
