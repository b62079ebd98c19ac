//! The field table of the spatial engine: name, unit, meaning and getter of every number that frames,
//! histories, checks, `riprap fields` and the documentation can ask for.

use std::cell::Cell;

use riprap_geom::{Mat3, Vec3};

use crate::faces::region::holds;
use crate::field::{FieldError, FieldInfo, Part, Site, first, joined, pair, place};
use crate::laws::norm;
use crate::laws::tetrahedron::Gradient;
use crate::query::deformable::Motion;
pub use crate::query::view::View;
use crate::read::bolts;
use crate::read::cracks;
use crate::read::crater::UPLIFT;
use crate::read::heap;
use crate::read::removed;
use crate::setup::deform::BondFailure;
use crate::state::cavity::Cavity;
use crate::state::lineage::Origin;
use crate::state::patches::flag;
use crate::topology::cut::tip;
use crate::topology::fracture;

/// A getter: the view, the blocks (or the source) asked for, and room for up to three numbers.
type Getter = fn(&View<'_>, &[u32]) -> Vec3;

// A sum over nothing is -0.
const fn one(x: f64) -> Vec3 {
    Vec3::new(x + 0.0, 0.0, 0.0)
}

/// Blocks of a group (ascending) that are there, and those that its split blocks have become.
fn members(v: &View<'_>, of: &[u32]) -> std::vec::IntoIter<usize> {
    let world = v.world;
    let living: Vec<usize> = if of.iter().all(|&b| world.alive[b as usize]) {
        of.iter().map(|&b| b as usize).collect()
    } else {
        let belongs = |b: usize| {
            let mut ancestor = b as u32;
            while of.binary_search(&ancestor).is_err() {
                ancestor = world.lineage[ancestor as usize].parent;
                if ancestor == Origin::NONE {
                    return false;
                }
            }
            true
        };
        v.living().filter(|&b| belongs(b)).collect()
    };
    living.into_iter()
}

/// Mean over the living blocks of a group.
fn mean(v: &View<'_>, of: &[u32], get: impl Fn(usize) -> Vec3) -> Vec3 {
    let (mut sum, mut count) = (Vec3::ZERO, 0.0);
    for b in members(v, of) {
        sum += get(b);
        count += 1.0;
    }
    sum / f64::max(count, 1.0)
}

fn momentum(v: &View<'_>, b: usize) -> Vec3 {
    v.world.solid_of(b).mass * v.velocity(b)
}

/// Mean by volume over the living blocks of a group of components of their stress, Pa.
fn mean_stress(v: &View<'_>, of: &[u32], get: impl Fn(&Mat3) -> Vec3) -> Vec3 {
    let (mut sum, mut volume) = (Vec3::ZERO, 0.0);
    for b in members(v, of) {
        let own = v.world.solid_of(b).volume;
        sum += own * get(&v.stress(b));
        volume += own;
    }
    sum / f64::max(volume, f64::MIN_POSITIVE)
}

fn largest(blocks: impl Iterator<Item = usize>, get: impl Fn(usize) -> f64) -> Vec3 {
    one(blocks.map(get).fold(0.0, f64::max))
}

/// Horizontal way that this share of the blocks of a group has not exceeded, m; all of the way without gravity.
fn run_out(v: &View<'_>, of: &[u32], share: f64) -> f64 {
    let up = v.up();
    let way = |b: usize| {
        let moved = v.displacement(b);
        (moved - up.dot(moved) * up).length()
    };
    let mut ways: Vec<f64> = members(v, of).map(way).collect();
    ways.sort_by(f64::total_cmp);
    let last = (share * ways.len() as f64).ceil() as usize;
    ways.get(last.max(1) - 1).copied().unwrap_or(0.0)
}

/// Share of the living blocks of a group for which something holds.
fn share(v: &View<'_>, of: &[u32], holds: impl Fn(usize) -> bool) -> Vec3 {
    mean(v, of, |b| one(f64::from(u8::from(holds(b)))))
}

/// Living blocks that are not held or driven in all freedoms.
fn free<'a>(v: &'a View<'_>) -> impl Iterator<Item = usize> + 'a {
    v.living().filter(|&b| v.world.is_free(b))
}

/// A number of the cavity of a source; NaN if it has none.
fn of_cavity(v: &View<'_>, of: &[u32], get: impl Fn(&Cavity) -> f64) -> Vec3 {
    let source = first(of);
    let cavity = v.world.cavities.iter().find(|c| c.source as usize == source);
    one(cavity.map_or(f64::NAN, get))
}

/// Patches between two blocks with the sign that turns "on i" into "on the first".
fn between<'a>(v: &'a View<'_>, of: &[u32]) -> impl Iterator<Item = (usize, f64)> + 'a {
    let (a, b) = pair(of);
    v.world.patches.ends.iter().enumerate().filter_map(move |(p, e)| match *e {
        e if e == [a, b] => Some((p, 1.0)),
        e if e == [b, a] => Some((p, -1.0)),
        _ => None,
    })
}

/// Mean over the area of the points of patches, the springs of facets and the contact between two blocks of a function of their
/// tractions.
fn over_area(v: &View<'_>, of: &[u32], get: impl Fn(&[f64; 3]) -> f64) -> f64 {
    let (mut sum, mut area) = (0.0, 0.0);
    for (p, _) in between(v, of) {
        let part = 0.25 * v.patch_class(p).area;
        for traction in v.patch_tractions(p) {
            sum += part * get(&traction);
            area += part;
        }
    }
    let joined = joins(pair(of));
    if let Some((deform, work)) = v.deformables() {
        for facet in deform.facets.iter().filter(|f| joined(f.blocks)) {
            for p in facet.points() {
                let part = deform.points[p].area;
                let force = Vec3::from(work.slots[p]);
                sum += part * get(&facet.now.map(|e| e.dot(force) / part));
                area += part;
            }
        }
    }
    let (a, b) = pair(of);
    if let Some((contact, _)) = v.contact_between(a, b).filter(|(c, _)| c.area > 0.0) {
        let pressed = contact.force.dot(contact.normal);
        let along = (contact.force - pressed * contact.normal).length();
        sum += contact.area * get(&[-pressed / contact.area, along / contact.area, 0.0]);
        area += contact.area;
    }
    if area > 0.0 { sum / area } else { 0.0 }
}

/// Whether ends are these two blocks.
fn joins((a, b): (u32, u32)) -> impl Fn([u32; 2]) -> bool {
    move |ends| ends == [a, b] || ends == [b, a]
}

/// Share of the points of patches and the springs of facets between blocks that `chosen` takes that have failed, or that are open.
fn share_of_points(v: &View<'_>, group: u16, chosen: impl Fn([u32; 2]) -> bool) -> Vec3 {
    let (mut such, mut all) = (0.0, 0.0);
    let patches = &v.world.patches;
    for (ends, flags) in patches.ends.iter().zip(&patches.flags) {
        if chosen(*ends) {
            such += f64::from((flags & group).count_ones());
            all += 4.0;
        }
    }
    if let Some((deform, work)) = v.deformables() {
        for facet in deform.facets.iter().filter(|f| chosen(f.blocks)) {
            let is_such = |p: &usize| {
                let open = work.slots[*p] == [0.0; 3];
                deform.memory[*p].state.is_broken() && (group == flag::BROKEN || open)
            };
            such += facet.points().filter(is_such).count() as f64;
            all += f64::from(facet.count);
        }
    }
    one(if all > 0.0 { such / all } else { 0.0 })
}

/// Number of points of patches and springs of facets between blocks that `chosen` takes that have failed so far.
fn broken_points(v: &View<'_>, chosen: impl Fn([u32; 2]) -> bool) -> f64 {
    let patches = &v.world.patches;
    let such = patches.ends.iter().zip(&patches.flags);
    let such = such.filter(|(ends, _)| chosen(**ends));
    let mut count: u64 =
        such.map(|(_, flags)| u64::from((flags & flag::BROKEN).count_ones())).sum();
    if let Some((deform, _)) = v.deformables() {
        let facets = deform.facets.iter().filter(|f| chosen(f.blocks));
        count += facets.map(|f| deform.failed_points(f)).sum::<u64>();
    }
    (count + v.world.failed.count(chosen)) as f64
}

/// Whether a block is this one or has come of it by splits.
fn comes_of(v: &View<'_>, b: u32, ancestor: u32) -> bool {
    let mut at = b;
    while at != ancestor {
        match v.world.lineage.get(at as usize) {
            Some(origin) if origin.parent != Origin::NONE => at = origin.parent,
            _ => return false,
        }
    }
    true
}

/// Share of the points of all patches that slid in the last step.
fn sliding_share(v: &View<'_>) -> f64 {
    let flags = &v.world.patches.flags;
    let sliding = flags.iter().map(|f| (f & flag::SLIDING).count_ones());
    f64::from(sliding.sum::<u32>()) / (4 * flags.len()).max(1) as f64
}

/// Principal values of a symmetric matrix, largest first (analytic, for 3 x 3).
#[must_use]
pub fn principal(m: &Mat3) -> [f64; 3] {
    let mean = (m.x_axis.x + m.y_axis.y + m.z_axis.z) / 3.0;
    let off = m.y_axis.x * m.y_axis.x + m.z_axis.x * m.z_axis.x + m.z_axis.y * m.z_axis.y;
    let d = [m.x_axis.x - mean, m.y_axis.y - mean, m.z_axis.z - mean];
    let p = ((d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + 2.0 * off) / 6.0).sqrt();
    if p == 0.0 {
        return [mean; 3];
    }
    let scaled = (1.0 / p) * (*m - mean * Mat3::IDENTITY);
    let angle = libm::acos((0.5 * scaled.determinant()).clamp(-1.0, 1.0)) / 3.0;
    let third = 2.0 * std::f64::consts::PI / 3.0;
    let high = mean + 2.0 * p * libm::cos(angle);
    let low = mean + 2.0 * p * libm::cos(angle + third);
    [high, 3.0 * mean - high - low, low]
}

fn gradient(v: &View<'_>, of: &[u32]) -> Gradient {
    v.deformable(first(of)).map_or([[f64::NAN; 3]; 3], |deformable| deformable.gradient())
}

fn stress(v: &View<'_>, of: &[u32]) -> Mat3 {
    v.stress(first(of))
}

riprap_core::fields! {
    Getter;
    "block.position" "m" Block Vector3 false "Position of the centroid." |v, of| v.position(first(of)) + v.world.setup.origin;
    "block.displacement" "m" Block Vector3 false "Displacement of the centroid since the start or the last reset." |v, of| v.displacement(first(of));
    "block.rotation" "rad" Block Vector3 false "Rotation vector since the start or the last reset." |v, of| v.rotation(first(of));
    "block.velocity" "m/s" Block Vector3 false "Velocity of the centroid." |v, of| v.velocity(first(of));
    "block.speed" "m/s" Block Scalar false "Magnitude of the velocity." |v, of| one(v.velocity(first(of)).length());
    "block.peak_speed" "m/s" Block Scalar false "Peak particle velocity: largest speed of the centroid so far." |v, of| one(v.peak_speed(first(of)));
    "block.spin" "rad/s" Block Vector3 false "Angular velocity." |v, of| v.spin(first(of));
    "block.force" "N" Block Vector3 false "Sum of all forces on the block, damping and supports excluded." |v, of| v.net(first(of))[0];
    "block.moment" "N m" Block Vector3 false "Sum of all moments about the centroid." |v, of| v.net(first(of))[1];
    "block.kinetic" "J" Block Scalar false "Kinetic energy." |v, of| one(v.kinetic(first(of)));
    "block.volume" "m3" Block Scalar false "Volume." |v, of| one(v.world.solid_of(first(of)).volume);
    "block.mass" "kg" Block Scalar false "Mass." |v, of| one(v.world.solid_of(first(of)).mass);
    "block.momentum" "N s" Block Vector3 false "Momentum." |v, of| momentum(v, first(of));
    "block.water_force" "N" Block Vector3 false "Force of the standing water on all faces of the block." |v, of| v.water_force(first(of));
    "block.energy_head" "m" Block Scalar false "Height to which the energy of the block could lift its centroid: its height plus its kinetic energy over its weight." |v, of| one(v.energy_head(first(of)));
    "block.terrain_force" "N" Block Vector3 false "Force of all terrain on the block." |v, of| v.on_terrain(first(of)).0;
    "block.terrain_depth" "m" Block Scalar false "Penetration of the block into terrain; 0 without contact." |v, of| one(v.on_terrain(first(of)).1);
    "block.stress_normal" "Pa" Block Vector3 true "Average stress of the block, normal components xx, yy, zz as x, y, z; tension positive." |v, of| { let s = stress(v, of); Vec3::new(s.x_axis.x, s.y_axis.y, s.z_axis.z) };
    "block.stress_shear" "Pa" Block Vector3 true "Average stress of the block, shear components yz, zx, xy as x, y, z." |v, of| { let s = stress(v, of); Vec3::new(s.z_axis.y, s.x_axis.z, s.y_axis.x) };
    "block.sigma1_compressive" "Pa" Block Scalar true "Largest principal compression of the block's average stress." |v, of| one(-principal(&stress(v, of))[2]);
    "block.sigma3_compressive" "Pa" Block Scalar true "Smallest principal compression of the block's average stress (negative in tension)." |v, of| one(-principal(&stress(v, of))[0]);
    "block.pressure" "Pa" Block Scalar true "Mean compression of the block's average stress." |v, of| { let s = stress(v, of); one(-(s.x_axis.x + s.y_axis.y + s.z_axis.z) / 3.0) };
    "block.broken_share" "-" Block Scalar true "Share of the points of its patches and the springs of its facets that have failed. Patches released to contact are not included (`block.broken_points` counts them)." |v, of| { let b = first(of) as u32; share_of_points(v, flag::BROKEN, |ends| ends.contains(&b)) };
    "block.broken_points" "-" Block Scalar true "Number of points of its patches and springs of its facets, and of those of its parts, that have failed so far: it never decreases." |v, of| { let b = first(of) as u32; one(broken_points(v, |[i, j]| comes_of(v, i, b) || comes_of(v, j, b))) };
    "block.level" "-" Block Scalar false "Number of splits in the ancestry of the block." |v, of| one(f64::from(v.world.level(first(of))));
    "block.removed" "-" Block Scalar false "1 once the block has been removed or split." |v, of| one(f64::from(u8::from(!v.world.alive[first(of)])));
    "block.contact_force" "N" Block Vector3 true "Sum of the forces of contacts on the block, without dashpots." |v, of| v.contacts_of(first(of)).map(|(_, force)| force).sum();
    "block.contacts" "-" Block Scalar true "Number of contacts of the block that touch." |v, of| one(v.contacts_of(first(of)).count() as f64);
    "pair.force" "N" Pair Vector3 true "Sum of the forces of patches, bonds and the contact of the second block on the first, without dashpots." |v, of| { let (a, b) = pair(of); between(v, of).map(|(p, sign)| sign * v.patch_resultant(p).force).sum::<Vec3>() + v.facet_force((a, b)) + v.contact_between(a, b).map_or(Vec3::ZERO, |(_, force)| force) };
    "pair.overlap" "m" Pair Scalar true "Overlap of two blocks in their contact; 0 when apart or joined." |v, of| { let (a, b) = pair(of); one(v.contact_between(a, b).map_or(0.0, |(c, _)| c.depth)) };
    "pair.normal_force" "N" Pair Scalar true "Normal force of patches, facets and contacts between the two, without dashpots, compression positive (negative for a joint in tension)." |v, of| { let (a, b) = pair(of); one(v.borne(a, b).normal) };
    "pair.shear_force" "N" Pair Scalar true "Magnitude of the shear force of patches, facets and contacts between the two, without dashpots." |v, of| { let (a, b) = pair(of); one(v.borne(a, b).shear.length()) };
    "pair.shear_ratio" "-" Pair Scalar true "Ratio of this shear force to this normal force; 0 without normal force." |v, of| { let (a, b) = pair(of); one(v.borne(a, b).ratio()) };
    "pair.sliding" "-" Pair Scalar true "1 where the two are in compression and all of it slides: contacts, and failed points of patches and springs of facets that carry the full frictional resistance; otherwise 0." |v, of| { let (a, b) = pair(of); one(f64::from(u8::from(v.borne(a, b).slides()))) };
    "pair.pore_pressure" "Pa" Pair Scalar true "Largest pressure of the standing water at the centres of patches, facets and contacts between the two." |v, of| { let (a, b) = pair(of); one(v.pore_pressure_between(a, b)) };
    "pair.seepage_rate" "m3/s" Pair Scalar true "Largest flow rate through a joint between the two." |v, of| { let (a, b) = pair(of); one(v.world.seepage_between([a, b])) };
    "pair.displacement" "m" Pair Vector3 false "Displacement of the first block's centroid relative to the second's (or of two `pins`)." |v, of| { let (a, b) = pair(of); v.displacement(a as usize) - v.displacement(b as usize) };
    "pair.convergence" "m" Pair Scalar false "By how much the centroids of the two (or two `pins`) have come nearer to each other since the start or the last reset; negative when they have parted." |v, of| one(removed::convergence(v, pair(of)));
    "pair.velocity" "m/s" Pair Vector3 false "Velocity of the first block's centroid relative to the second's (or of two `pins`)." |v, of| { let (a, b) = pair(of); v.velocity(a as usize) - v.velocity(b as usize) };
    "pair.normal_stress" "Pa" Pair Scalar true "Mean normal stress of patches, facets and contacts between the two, tension positive." |v, of| one(over_area(v, of, |t| t[0]));
    "pair.shear_stress" "Pa" Pair Scalar true "Mean magnitude of the shear stress at the points of patches, at the springs of facets and of contacts between the two." |v, of| one(over_area(v, of, |t| norm(t[1], t[2])));
    "pair.broken" "-" Pair Scalar true "Share of the points of patches and the springs of facets between the two that have failed. Patches released to contact are not included (`pair.broken_points` counts them)." |v, of| share_of_points(v, flag::BROKEN, joins(pair(of)));
    "pair.broken_points" "-" Pair Scalar true "Number of points of patches and springs of facets between the two, and between their parts, that have failed so far: it never decreases, not even when a patch is released to contact or a block is removed." |v, of| one(broken_points(v, |[i, j]| { let (a, b) = pair(of); (comes_of(v, i, a) && comes_of(v, j, b)) || (comes_of(v, i, b) && comes_of(v, j, a)) }));
    "pair.patches" "-" Pair Scalar true "Number of patches between the two." |v, of| one(between(v, of).count() as f64);
    "group.water_force" "N" Group Vector3 false "Sum of the forces of the standing water on the group's blocks." |v, of| members(v, of).map(|b| v.water_force(b)).sum();
    "group.displacement" "m" Group Vector3 false "Mean displacement of the group's blocks." |v, of| mean(v, of, |b| v.displacement(b));
    "group.shift" "m" Group Vector3 false "Means of the magnitudes of x, y and z of the displacements of the group's blocks." |v, of| mean(v, of, |b| v.displacement(b).abs());
    "group.rotation" "rad" Group Vector3 false "Mean rotation vector of the group's blocks." |v, of| mean(v, of, |b| v.rotation(b));
    "group.velocity" "m/s" Group Vector3 false "Mean velocity of the group's blocks." |v, of| mean(v, of, |b| v.velocity(b));
    "group.kinetic" "J" Group Scalar false "Kinetic energy of the group's blocks." |v, of| one(members(v, of).map(|b| v.kinetic(b)).sum());
    "group.volume" "m3" Group Scalar false "Volume of the group's existing blocks." |v, of| one(members(v, of).map(|b| v.world.solid_of(b).volume).sum());
    "group.mass" "kg" Group Scalar false "Mass of the group's existing blocks." |v, of| one(members(v, of).map(|b| v.world.solid_of(b).mass).sum());
    "group.momentum" "N s" Group Vector3 false "Momentum of the group's existing blocks." |v, of| members(v, of).map(|b| momentum(v, b)).sum();
    "group.force" "N" Group Vector3 false "Sum of the net forces on the group's blocks." |v, of| members(v, of).map(|b| v.net(b)[0]).sum();
    "group.stress_normal" "Pa" Group Vector3 true "Mean over the volume of the group's blocks of their average stress, normal components xx, yy, zz as x, y, z; tension positive." |v, of| mean_stress(v, of, |s| Vec3::new(s.x_axis.x, s.y_axis.y, s.z_axis.z));
    "group.stress_shear" "Pa" Group Vector3 true "Mean over the volume of the group's blocks of their average stress, shear components yz, zx, xy as x, y, z." |v, of| mean_stress(v, of, |s| Vec3::new(s.z_axis.y, s.x_axis.z, s.y_axis.x));
    "group.fragments" "-" Group Scalar true "Number of fragments with a block of the group (see `model.fragments`)." |v, of| one(v.fragments().loose_with(members(v, of)).len() as f64);
    "group.largest_fragment" "m3" Group Scalar true "Volume of the largest fragment with a block of the group; 0 without fragments." |v, of| one(v.fragments().loose_with(members(v, of)).first().map_or(0.0, |f| f.size));
    "group.max_displacement" "m" Group Scalar false "Largest displacement in the group." |v, of| largest(members(v, of), |b| v.displacement(b).length());
    "group.max_rotation" "rad" Group Scalar false "Largest magnitude of rotation in the group." |v, of| largest(members(v, of), |b| v.rotation(b).length());
    "group.max_speed" "m/s" Group Scalar false "Largest speed in the group." |v, of| largest(members(v, of), |b| v.velocity(b).length());
    "group.peak_speed" "m/s" Group Scalar false "Largest peak particle velocity in the group." |v, of| largest(members(v, of), |b| v.peak_speed(b));
    "group.energy_head" "m" Group Scalar false "Largest height to which the energy of a block of the group would lift its centroid." |v, of| largest(members(v, of), |b| v.energy_head(b));
    "group.runout_50" "m" Group Scalar false "Run-out of the group: median of the horizontal travel of its blocks." |v, of| one(run_out(v, of, 0.5));
    "group.runout_90" "m" Group Scalar false "Run-out of the group: 90th percentile of the horizontal travel of its blocks." |v, of| one(run_out(v, of, 0.9));
    "group.repose_angle" "rad" Group Scalar true "Slope of the surface of a heap between 20 % and 80 % of its height, averaged over all directions about its axis: the angle of repose; for separate heaps the mass-weighted mean." |v, of| one(heap::repose_angle(v, members(v, of)));
    "group.swell" "-" Group Scalar true "Volume under the surface of the group seen from above, down to its lowest corner, over the volume of its blocks: the swell of a heap on level ground, hollows included." |v, of| one(heap::swell(v, members(v, of)));
    "group.left_terrain" "-" Group Scalar false "Number of the group's blocks that have left the terrain over its rim." |v, of| { let left = v.left_terrain(); one(members(v, of).filter(|b| left.contains(&(*b as u32))).count() as f64) };
    "group.rising_share" "-" Group Scalar false "Share of the group's blocks that move against gravity (up, without gravity)." |v, of| share(v, of, |b| v.velocity(b).dot(v.up()) > 0.0);
    "group.drawn_mass" "kg" Group Scalar false "Mass of the group's blocks that have been removed, by phases, by code or because they left the model." |v, of| one(removed::mass(v, of));
    "group.recovery" "-" Group Scalar false "Share of the group's mass that has been removed: of ore the recovery." |v, of| { let gone = removed::mass(v, of); one(removed::part(gone, gone + members(v, of).map(|b| v.world.solid_of(b).mass).sum::<f64>())) };
    "group.dilution" "-" Group Scalar false "Share of the group in the mass of all removed blocks: of waste the dilution; 0 while nothing is removed." |v, of| one(removed::part(removed::mass(v, of), removed::mass_of_all(v)));
    "group.blocks" "-" Group Scalar false "Number of the group's existing blocks." |v, of| one(members(v, of).count() as f64);
    "model.time" "s" Model Scalar false "Model time." |v, _| one(v.world.time);
    "model.steps" "-" Model Scalar false "Number of steps done." |v, _| one(v.world.step as f64);
    "model.time_step" "s" Model Scalar false "Size of the last time step." |v, _| one(v.world.last_dt);
    "model.kinetic" "J" Model Scalar true "Kinetic energy of all blocks." |v, _| one(v.living().map(|b| v.kinetic(b)).sum());
    "model.unbalanced" "-" Model Scalar true "Unbalanced-force ratio: sum of net forces on free blocks over the sum of the forces acting on them." |v, _| one(v.unbalanced());
    "model.blocks" "-" Model Scalar true "Number of existing blocks." |v, _| one(v.living().count() as f64);
    "model.patches" "-" Model Scalar false "Number of patches." |v, _| one(v.world.patches.len() as f64);
    "model.broken_share" "-" Model Scalar true "Share of the points of all patches and the springs of all facets that have failed. Patches released to contact are not included (`model.broken_points` counts them)." |v, _| share_of_points(v, flag::BROKEN, |_| true);
    "model.broken_points" "-" Model Scalar true "Number of points of patches and springs of facets that have failed so far: it never decreases, not even when a patch is released to contact or blocks are removed." |v, _| one(broken_points(v, |_| true));
    "model.open_share" "-" Model Scalar true "Share of the points of all patches and the springs of all facets that are open." |v, _| share_of_points(v, flag::OPEN, |_| true);
    "model.sliding_share" "-" Model Scalar true "Share of the points of all patches that slid in the last step." |v, _| one(sliding_share(v));
    "model.contacts" "-" Model Scalar false "Number of contacts that touch." |v, _| one(v.contacts().count() as f64);
    "model.candidates" "-" Model Scalar false "Number of near pairs of blocks that are monitored for contact." |v, _| one(v.world.near_pairs() as f64);
    "model.max_overlap" "m" Model Scalar false "Largest overlap of two blocks in contact." |v, _| one(v.contacts().map(|c| c.depth).fold(0.0, f64::max));
    "model.contact_sliding" "-" Model Scalar false "Share of the contacts that slide." |v, _| { let n = v.contacts().count(); one(v.contacts().filter(|c| c.sliding).count() as f64 / n.max(1) as f64) };
    "model.finite" "-" Model Scalar true "Number of blocks that use finite rotations." |v, _| one(v.living().filter(|&b| v.world.turned[b].is_some()).count() as f64);
    "model.mass" "kg" Model Scalar true "Mass of all blocks, without terrain." |v, _| one(v.living().filter(|&b| !v.world.is_terrain(b)).map(|b| v.world.solid_of(b).mass).sum());
    "model.volume" "m3" Model Scalar true "Volume of all blocks, without terrain." |v, _| one(v.living().filter(|&b| !v.world.is_terrain(b)).map(|b| v.world.solid_of(b).volume).sum());
    "model.max_displacement" "m" Model Scalar true "Largest displacement of a free block." |v, _| largest(free(v), |b| v.displacement(b).length());
    "model.max_rotation" "rad" Model Scalar true "Largest magnitude of rotation of a free block." |v, _| largest(free(v), |b| v.rotation(b).length());
    "model.max_speed" "m/s" Model Scalar true "Largest speed of a free block." |v, _| largest(free(v), |b| v.velocity(b).length());
    "model.max_closing" "-" Model Scalar true "Largest closing of a joint, a contact or a held face over the inscribed radius of the thinner block (in contacts of deformable blocks over the distance of the centre from the surface): how far blocks are pressed into each other. A run is stopped at 1." |v, _| one(v.worst_overlap().map_or(0.0, |(x, _, _)| x));
    "model.momentum" "N s" Model Vector3 true "Momentum of all blocks." |v, _| v.momentum();
    "model.angular_momentum" "N m s" Model Vector3 true "Angular momentum of all blocks about the local origin (blocks in joints with small kinematics at their reference positions)." |v, _| v.angular_momentum();
    "cavity.pressure" "Pa" Cavity Scalar false "Pressure in the cavity." |v, of| of_cavity(v, of, |c| c.pressure);
    "cavity.volume" "m3" Cavity Scalar false "Volume of the gas (of the cavity, for a pressure history)." |v, of| of_cavity(v, of, |c| c.volume);
    "cavity.expansion" "-" Cavity Scalar false "Volume of the gas over that of the charge, V/V0." |v, of| of_cavity(v, of, |c| c.volume / c.charge_volume());
    "cavity.volume_ratio" "-" Cavity Scalar false "Volume of the removed blocks over that of the charge, Vc/V0." |v, of| of_cavity(v, of, Cavity::volume_ratio);
    "cavity.gas_work" "J" Cavity Scalar false "Work done by the gas since ignition." |v, of| of_cavity(v, of, |c| c.work);
    "cavity.gas_mass" "kg" Cavity Scalar false "Mass of the gas in the cavity: less than that of the charge once it enters cracks (`venting.cracks`)." |v, of| of_cavity(v, of, |c| v.gas_mass(c));
    "cavity.stemming_way" "m" Cavity Scalar false "How far the gas has driven the stemming of its hole outwards (`gas_cavity.stemming`)." |v, of| of_cavity(v, of, |c| c.column.map_or(f64::NAN, |s| s.way));
    "cavity.stemming_speed" "m/s" Cavity Scalar false "Speed of the stemming; at the collar, once it is out." |v, of| of_cavity(v, of, |c| c.column.map_or(f64::NAN, |s| s.speed));
    "cavity.depth" "m" Cavity Scalar true "Depth of the charge below the free surface above it." |v, of| of_cavity(v, of, |c| v.profile(c).depth);
    "cavity.dome" "m" Cavity Scalar true "Mean uplift of the surface blocks nearest to the axis of the charge." |v, of| of_cavity(v, of, |c| v.profile(c).dome());
    "cavity.crater_radius" "m" Cavity Scalar true "Radius about the axis of the charge within which the free surface has risen by more than 0.02 of the depth of the charge (mean over rings)." |v, of| of_cavity(v, of, |c| { let p = v.profile(c); p.radius(UPLIFT * p.depth) });
    "cavity.crater_ratio" "-" Cavity Scalar true "The same radius over the depth of the charge (n of Boreskov's formula)." |v, of| of_cavity(v, of, |c| { let p = v.profile(c); p.radius(UPLIFT * p.depth) / p.depth });
    "cavity.attenuation" "-" Cavity Scalar true "Exponent n of the attenuation v = K/r^n of the peak speed between 2 and 16 radii of a ball as large as the cavity (least squares over means of shells)." |v, of| of_cavity(v, of, |c| v.attenuation(c));
    "cavity.roundness" "-" Cavity Scalar true "Radius along the axes over that along the diagonals of space of the contours of the peak speed around the source (blocks within 15 degrees, mean over contours); 1 is round." |v, of| of_cavity(v, of, |c| v.roundness(c));
    "cavity.attenuation_across" "-" Cavity Scalar true "Exponent n of the attenuation v = K/r^n of the peak speed across a charge, r from the axis of a line (beside its middle half), else from the centre, between 2 and 12 widths of the cavity." |v, of| of_cavity(v, of, |c| v.attenuation_across(c));
    "cavity.unevenness_3" "-" Cavity Scalar true "Largest departure, as a share of their mean, of the peak speeds in 26 directions round the charge (round the axis of a line) at 3 widths of the cavity; 0 is even." |v, of| of_cavity(v, of, |c| v.unevenness(c, 3.0));
    "cavity.unevenness_6" "-" Cavity Scalar true "The same at 6 widths." |v, of| of_cavity(v, of, |c| v.unevenness(c, 6.0));
    "cavity.unevenness_12" "-" Cavity Scalar true "The same at 12 widths." |v, of| of_cavity(v, of, |c| v.unevenness(c, 12.0));
    "block.node_displacement" "m" Block Vector3 false "Displacement, since the start, of the node of a deformable block that lay nearest to `at_point` (of a rigid block: of its centroid)." |v, of| v.at_node(of, Motion::Displacement);
    "block.node_velocity" "m/s" Block Vector3 false "Velocity of the node of a deformable block that lay nearest to `at_point` (of a rigid block: of its centroid)." |v, of| v.at_node(of, Motion::Velocity);
    "block.crack_distance" "m" Block Scalar true "Distance from `at_point` to the nearest broken facet, at the start; infinite if there is none." |_v, _of| one(f64::NAN);
    "block.crack_offset" "m" Block Vector3 true "Distance from `at_point` along x, y, z (or `along`) to the nearest broken facet on that line, at the start; negative against the axis, infinite if there is none." |_v, _of| Vec3::NAN;
    "block.strain_normal" "-" Block Vector3 true "Mean normal strains xx, yy, zz of a deformable block as x, y, z; extension positive." |v, of| { let h = gradient(v, of); Vec3::new(h[0][0], h[1][1], h[2][2]) };
    "block.strain_shear" "-" Block Vector3 true "Mean shear strains yz, zx, xy (half the angle) of a deformable block as x, y, z." |v, of| { let h = gradient(v, of); 0.5 * Vec3::new(h[1][2] + h[2][1], h[2][0] + h[0][2], h[0][1] + h[1][0]) };
    "block.sigma2_compressive" "Pa" Block Scalar true "Middle principal compression of the block's average stress." |v, of| one(-principal(&stress(v, of))[1]);
    "boundary.displacement" "m" Boundary Vector3 true "Mean displacement, by area, of the faces a condition acts on." |v, of| v.on_boundary(first(of)).0;
    "boundary.force" "N" Boundary Vector3 true "Force by which a condition acts on the nodes of deformable blocks: tractions and reactions." |v, of| v.on_boundary(first(of)).1;
    "boundary.work" "J" Boundary Scalar false "Work of a condition on its faces: of applied tractions and of the prescribed motion, less the energy absorbed by its dashpots." |v, of| one(v.world.work_of_boundary(first(of)));
    "support.force" "N" Support Vector3 false "Force of a support on the blocks or nodes that it holds or drives: its reaction, including the inertia of a driven motion, without damping." |v, of| v.on_support(first(of))[0];
    "support.moment" "N m" Support Vector3 false "Moment of this force about the centre of mass of its blocks, for a support of nodes about their centre." |v, of| v.on_support(first(of))[1];
    "support.work" "J" Support Scalar false "Work of a support on its blocks or nodes; fixed supports do none." |v, of| one(v.world.work(first(of)));
    "load.work" "J" Load Scalar false "Work of a load on its blocks." |v, of| one(v.world.work(first(of)));
    "bolt.axial_force" "N" Bolt Scalar false "Largest axial force in the bolts, tension positive." |v, of| one(bolts::largest(v, of, f64::NEG_INFINITY, bolts::force));
    "bolt.head_force" "N" Bolt Scalar false "Largest force of the plates on the bolts." |v, of| one(bolts::largest(v, of, f64::NEG_INFINITY, bolts::plate));
    "bolt.shear_force" "N" Bolt Scalar false "Largest shear force of the bolts across a joint." |v, of| one(bolts::largest(v, of, 0.0, bolts::shear));
    "bolt.slip" "m" Bolt Scalar false "Largest slip of the grout." |v, of| one(bolts::largest(v, of, 0.0, |_, b| b.chain.largest_slip()));
    "bolt.elongation" "m" Bolt Scalar false "Largest plastic elongation of a bar at one point." |v, of| one(bolts::largest(v, of, 0.0, |_, b| b.chain.largest_yield()));
    "bolt.utilisation" "-" Bolt Scalar false "Largest ratio of axial force to yield force; 0 for bars without yield." |v, of| one(bolts::largest(v, of, 0.0, |s, b| b.chain.utilisation(&s.design)));
    "bolt.broken" "-" Bolt Scalar false "Number of points at which bars have ruptured." |v, of| one(bolts::of(v, of).map(|b| f64::from(b.toll.breaks)).sum());
    "model.bolts" "-" Model Scalar false "Number of installed bolts." |v, _| one(v.world.bolts.len() as f64);
    "model.bolt_imbalance" "-" Model Scalar true "Largest unbalanced share of a bolt's force so far; 0 if every iteration converged." |v, _| one(v.world.bolts.iter().map(|b| b.toll.left).fold(0.0, f64::max));
    "model.strain_energy" "J" Model Scalar true "Elastic energy of deformable blocks." |v, _| one(v.strain_energy());
    "model.bond_energy" "J" Model Scalar true "Elastic energy of the bonds of deformable blocks." |v, _| one(v.bond_energy().iter().sum());
    "model.facets" "-" Model Scalar false "Number of facets: shared parts of faces along which a deformable block is joined." |v, _| one(v.deformables().map_or(0, |s| s.0.facets.len()) as f64);
    "model.springs" "-" Model Scalar false "Number of springs of these facets." |v, _| one(v.deformables().map_or(0, |s| s.0.points.len()) as f64);
    "model.broken_area" "m2" Model Scalar true "Area of broken bonds." |v, _| one(v.deformables().map_or(0.0, |s| s.0.broken_area.iter().sum()));
    "model.broken_tension" "m2" Model Scalar true "Area of bonds broken by tension." |v, _| one(v.deformables().map_or(0.0, |s| s.0.broken_area[0]));
    "model.broken_shear" "m2" Model Scalar true "Area of bonds broken by shear." |v, _| one(v.deformables().map_or(0.0, |s| s.0.broken_area[1]));
    "model.broken_facets" "-" Model Scalar true "Number of facets more than half of whose springs are broken." |v, _| one(v.deformables().map_or(0, |s| tip::broken(s.0).count()) as f64);
    "model.crack_fabric" "-" Model Vector3 true "Mean over the area of broken facets of the squared components of their normals: (0.75, 0.25, 0) for cracks at 30 degrees to y in the plane across z." |v, _| v.deformables().map_or(Vec3::NAN, |s| cracks::fabric(s.0));
    "model.crack_away" "m" Model Vector3 true "Mean over the area of broken facets of the distances of their centres from the planes x = 0, y = 0 and z = 0, as x, y, z." |v, _| v.deformables().map_or(Vec3::NAN, |s| cracks::away(s.0, v.world.setup.origin));
    "model.break_events" "-" Model Scalar true "Number of breaking events in static phases, each followed by a new equilibrium." |v, _| one(v.deformables().map_or(0, |s| s.0.breaks) as f64);
    "model.peak_share" "-" Model Scalar true "Largest 1/utilisation over the breaking events of static phases: the largest share of the load that the rock carried, if it is linear between events." |v, _| one(v.deformables().map_or(0.0, |s| s.0.peak_share));
    "model.cut_blocks" "-" Model Scalar true "Number of blocks that have been cut, including parts that were cut again." |v, _| one(v.deformables().map_or(0, |s| s.0.cut_blocks) as f64);
    "model.cut_unbalanced" "-" Model Scalar true "Largest ratio of net to external forces just after blocks were cut, before any motion." |v, _| one(v.deformables().map_or(0.0, |s| s.0.cut_unbalanced));
    "model.utilisation" "-" Model Scalar true "Largest ratio of traction to strength of an intact spring." |v, _| one(fracture::largest(v, BondFailure::Spring, |_| true));
    "model.facet_utilisation" "-" Model Scalar true "Largest ratio of traction to strength of an intact facet, from the average stress of its two blocks." |v, _| one(fracture::largest(v, BondFailure::BlockStress, |_| true));
    "pair.utilisation" "-" Pair Scalar true "Largest ratio of traction to strength of the intact springs between the two." |v, of| one(fracture::largest(v, BondFailure::Spring, joins(pair(of))));
    "pair.gas_pressure" "Pa" Pair Scalar false "Pressure of the gas in the crack between the two; 0 where none has entered." |v, of| { let (a, b) = pair(of); one(v.world.largest_in_cracks([a, b], |c, _| c.pressure)) };
    "pair.gas_aperture" "m" Pair Scalar false "Hydraulic aperture of the crack between the two that gas may enter; 0 where the joint has not failed." |v, of| { let (a, b) = pair(of); one(v.world.largest_in_cracks([a, b], |c, _| c.aperture)) };
    "pair.gas_mass" "kg" Pair Scalar false "Mass of the gas in the crack between the two." |v, of| { let (a, b) = pair(of); one(v.world.largest_in_cracks([a, b], |_, m| m)) };
    "pair.gas_speed" "m/s" Pair Scalar false "Largest speed of the gas at the rim of the crack between the two." |v, of| { let (a, b) = pair(of); one(v.world.largest_in_cracks([a, b], |c, _| c.speed)) };
    "model.gas_released" "kg" Model Scalar false "Mass of the charges that have gone off and whose gas may enter cracks." |v, _| one(v.gas_books().mass);
    "model.gas_in_cracks" "kg" Model Scalar false "Mass of the gas in cracks." |v, _| one(v.world.gas.as_ref().map_or(0.0, |g| g.in_cracks()));
    "model.gas_vented" "kg" Model Scalar false "Mass of the gas that has left through cracks into the air." |v, _| one(v.gas_books().vented);
    "model.gas_cracks" "-" Model Scalar false "Number of cracks that hold gas." |v, _| one(v.gas_cracks() as f64);
    "model.gas_reach" "m" Model Scalar false "Largest distance from the centre of a charge at which a crack holds gas above the pressure of the air." |v, _| one(v.gas_reach());
    "model.gas_energy" "J" Model Scalar false "Energy released by the charges whose gas may enter cracks." |v, _| one(v.gas_books().released);
    "model.gas_internal" "J" Model Scalar false "Energy left in this gas: its work in an expansion without end." |v, _| one(v.gas_internal());
    "model.gas_work" "J" Model Scalar false "Work of this gas on the rock, by the walls of cavities and by the sides of cracks." |v, _| one(v.gas_books().work);
    "model.gas_work_in_cracks" "J" Model Scalar false "The part of this work by the sides of cracks." |v, _| one(v.gas_books().in_cracks);
    "model.gas_friction" "J" Model Scalar false "Energy that this gas has lost by the friction of its flow and, of first order in the step, by the integration of the flow." |v, _| { let b = v.gas_books(); one(b.friction + b.numerical) };
    "model.gas_carried_off" "J" Model Scalar false "Energy that vented gas has taken along, and the work of the gas against the air." |v, _| { let b = v.gas_books(); one(b.carried + b.air) };
    "model.gas_residual" "-" Model Scalar false "Energy of the gas that these lines do not explain, over the energy released." |v, _| one(v.gas_residual());
    "model.seepage_inflow" "m3/s" Model Scalar true "Inflow of water through open faces." |v, _| one(v.world.seepage_inflow());
    "model.stable_step" "s" Model Scalar true "Stable time step of the present state without damping (safety 1)." |v, _| one(crate::stable::stable_step(v.world, v.scratch, 0.0).dt);
    "model.left_blocks" "-" Model Scalar false "Number of blocks that have left the model (`phases.*.leavers`)." |v, _| one(v.world.left.blocks as f64);
    "model.left_mass" "kg" Model Scalar false "Mass of the blocks that have left the model." |v, _| one(v.world.left.mass);
    "model.left_momentum" "N s" Model Vector3 false "Momentum that they took along." |v, _| Vec3::from(v.world.left.momentum);
    "model.fragments" "-" Model Scalar true "Number of fragments: blocks connected by intact patches or bonds. Blocks with all freedoms prescribed, and blocks joined to them, are not fragments." |v, _| one(v.fragments().loose().count() as f64);
    "model.largest_fragment" "m3" Model Scalar true "Volume of the largest fragment; 0 without fragments." |v, _| one(v.fragments().loose().next().map_or(0.0, |f| f.size));
    "energy.kinetic" "J" Energy Scalar true "Kinetic energy, time-centred." |v, _| one(v.balance().kinetic);
    "energy.gravity" "J" Energy Scalar true "Potential energy of gravity, relative to the start." |v, _| one(v.balance().gravity);
    "energy.contact_normal" "J" Energy Scalar true "Elastic energy of the normal springs of patches and of the pressure of contacts." |v, _| one(v.balance().contact_normal);
    "energy.contact_shear" "J" Energy Scalar true "Elastic energy of the shear springs of patches and of contacts." |v, _| one(v.balance().contact_shear);
    "energy.joints" "J" Energy Scalar true "Elastic energy of the springs behind boundary faces." |v, _| one(v.balance().bond);
    "energy.loads" "J" Energy Scalar true "Work of external loads and tractions." |v, _| one(v.world.works.loads);
    "energy.supports" "J" Energy Scalar true "Work of supports with prescribed motion." |v, _| one(v.world.works.supports);
    "energy.gas" "J" Energy Scalar true "Work of the gas of cavities and of other pressures in them." |v, _| one(v.world.works.gas);
    "energy.absorbed" "J" Energy Scalar true "Absorbed at viscous boundaries." |v, _| one(v.world.works.absorbed);
    "energy.friction" "J" Energy Scalar true "Dissipated by friction." |v, _| one(v.world.works.friction);
    "energy.damping" "J" Energy Scalar true "Dissipated by patch, mass and local damping." |v, _| one(v.world.works.damping);
    "energy.fracture" "J" Energy Scalar true "Released when points fail and open." |v, _| one(v.world.works.fracture);
    "energy.bolts" "J" Energy Scalar true "Elastic energy of bolts: bars, grout, plates and dowels." |v, _| one(v.world.bolt_energy());
    "energy.bolt_loss" "J" Energy Scalar true "Dissipated in bolts: yield of bars, slip of grout and dowels, rupture." |v, _| one(v.world.works.bolts);
    "energy.integrator" "J" Energy Scalar true "Taken by the integration itself in implicit phases." |v, _| one(v.world.works.integrator);
    "energy.left" "J" Energy Scalar true "Taken along by blocks that have left the model (`phases.*.leavers`)." |v, _| one(v.world.works.left);
    "energy.law_defect" "J" Energy Scalar true "Created (+) or lost (-) by contacts and joints in violation of their laws: by too long steps." |v, _| one(v.balance().works.law_defect);
    "energy.edit_defect" "J" Energy Scalar true "Added by edits: removed and split blocks, zeroed velocities, changed laws, joints released to contact." |v, _| one(v.world.works.edit_defect);
    "energy.step_change" "J" Energy Scalar true "Added by changes of the time step, including the first, and by jumps of forces: the difference between the kinetic energies at half steps and at whole steps." |v, _| one(v.world.works.step_change);
    "energy.residual" "J" Energy Scalar true "Energy that the ledger does not explain." |v, _| one(v.balance().residual());
    "energy.residual_relative" "-" Energy Scalar true "The residual relative to the largest energy exchanged." |v, _| one(v.balance().residual_relative());
}

/// A field with everything needed to read one number.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    index: usize,
    part: Part,
    of: Vec<u32>,
    groups: Vec<String>,
    at: Option<Vec3>,
    along: Option<Vec3>,
    /// Block that held the point at the last reading.
    held_by: Cell<u32>,
}

impl Reading {
    /// Finds `name` in the table. With a point `at` (m, local) a block field is read at the block that holds it.
    ///
    /// # Errors
    /// Unknown names and parts of scalars.
    pub fn new(
        name: &str,
        of: &[u32],
        at: Option<Vec3>,
        along: Option<Vec3>,
    ) -> Result<Self, FieldError> {
        let (index, part) = place(INFOS, name)?;
        let (of, groups) = (of.to_vec(), Vec::new());
        Ok(Self { index, part, of, groups, at, along, held_by: Cell::new(0) })
    }

    /// The same with blocks that join groups of these names while the model runs.
    #[must_use]
    pub fn with_groups(self, groups: &[String]) -> Self {
        Self { groups: groups.to_vec(), ..self }
    }

    /// Table entry.
    #[must_use]
    pub fn info(&self) -> &'static FieldInfo {
        &INFOS[self.index]
    }

    /// Whether reading it costs as much as a step.
    #[must_use]
    pub fn costly(&self) -> bool {
        READERS[self.index].costly
    }

    /// The number; a vector without part or direction gives its magnitude. NaN where the block is gone or
    /// no block holds the point.
    #[must_use]
    pub fn value(&self, view: &View<'_>) -> f64 {
        let get = READERS[self.index].get;
        if self.info().name == "block.crack_distance" {
            return self.at.map_or(f64::NAN, |at| cracks::distance(view, at));
        }
        if self.info().name == "block.crack_offset" {
            let axis = match self.part {
                Part::Whole | Part::Magnitude => self.along,
                part => Vec3::AXES.into_iter().find(|e| part.of(&e.to_array()) == Some(1.0)),
            };
            let both = self.at.zip(axis);
            return both.map_or(f64::NAN, |(at, axis)| cracks::offset(view, at, axis));
        }
        let found;
        let of: &[u32] = match (self.at, self.info().site) {
            (Some(point), _) => match self.holder(view, point) {
                Some(block) => {
                    found = [block, view.spot(block, point)];
                    &found
                }
                None => return f64::NAN,
            },
            (None, Site::Block) if self.info().name.starts_with("block.node_") => return f64::NAN,
            (None, Site::Block | Site::Pair) if self.gone(view) => return f64::NAN,
            (None, _) => &self.of,
        };
        let groups = view.world.setup.groups.iter();
        let groups = groups.filter(|group| self.groups.contains(&group.name));
        let of = joined(of, groups.map(|group| &group.blocks[..]));
        let values = get(view, &of).to_array();
        let along = self.along.map(|along| along.to_array());
        self.part.read(self.info().shape, values, along)
    }

    /// Whether a block asked for is no longer there (`block.removed` can still be read).
    fn gone(&self, view: &View<'_>) -> bool {
        self.info().name != "block.removed"
            && self.of.iter().any(|&b| !view.world.alive[b as usize])
    }

    fn holder(&self, view: &View<'_>, point: Vec3) -> Option<u32> {
        let last = self.held_by.get();
        let there =
            |b: usize| view.world.alive[b] && holds(&view.world.setup.blocks[b].shape, point);
        if (last as usize) < view.world.alive.len() && there(last as usize) {
            return Some(last);
        }
        let block = (0..view.world.alive.len()).find(|&b| there(b))? as u32;
        self.held_by.set(block);
        Some(block)
    }
}
