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
    // In a step that ranks do by themselves nothing changes here ([`super::quiet`]).
    if scratch.apart().is_some() {
        return;
    }
    let (seen, known) = (&*world, &*scratch);
    // Each patch by itself: what fails here changes nothing of another.
    let change = |p: usize| change_of(seen, p).map(|change| (p, change));
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
pub(super) enum Change {
    /// It stays, and holds its blocks in place no longer.
    Displaced,
    Released,
    /// Its last points fail, and it is released.
    Fails,
}

/// Lets go all patches that are `loose`, wherever their blocks are. Those with stress in place stay: a contact
/// knows none that its depth does not give. Those between two blocks that nothing moves stay as well: they cover faces ([`super::covered`]).
pub(crate) fn release_loose(
    world: &mut World,
    scratch: &mut Scratch,
    loose: impl Fn(&World, usize) -> bool,
) {
    let stressed = |p: usize| world.patches.prestress.get(p).is_some_and(|t| *t != Vec3::ZERO);
    let moves = |p: usize| world.patches.ends[p].iter().any(|b| world.is_free(*b as usize));
    let all = 0..world.patches.len();
    let loose = all.filter(|p| loose(world, *p) && !stressed(*p) && moves(*p));
    let mut pairs: Vec<PairKey> = loose.map(|p| pair_of_patch(world, p).0).collect();
    pairs.sort_unstable();
    pairs.dedup();
    if !pairs.is_empty() {
        release_pairs(world, scratch, &pairs);
    }
}

/// What becomes of a patch.
pub(super) fn change_of(world: &World, p: usize) -> Option<Change> {
    if is_folded(world, p) || is_torn(world, p) {
        Some(Change::Fails)
    } else if is_loose(world, p) && is_past(world, p) {
        Some(Change::Released)
    } else {
        is_displaced(world, p).then_some(Change::Displaced)
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
    world.patches.flags[p] & flag::BROKEN == flag::BROKEN || is_dry(world, p)
}

/// Whether there is nothing of a patch that could fail.
pub(crate) fn is_dry(world: &World, p: usize) -> bool {
    let class = &world.classes[world.patches.class[p] as usize];
    let joint = patch::joint(&world.setup.interfaces, class);
    let strengthless = |s: &Strength| s.tension <= 0.0 && s.cohesion <= 0.0;
    joint.is_plain() && joint.strength.as_ref().is_some_and(strengthless)
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
mod tests;
