//! Convex solids divided by joints: planes, disks, convex polygons, and sets of parallel planes.
//!
//! A plane cuts every solid that it meets; one that is not persistent cuts each of them with a chance, so that it ends at the joints before it. A disk or a polygon cuts the solids whose section with its plane it touches, and
//! those all through, so that every part stays convex: the usual convention of block-cutting codes.

use super::{Polyhedron, Sliced, slice};
use crate::error::demand;
use crate::random::Chance;
use crate::tol::{MAX_BLOCKS, SNAP};
use crate::{GeomError, Vec3};

/// Most planes of one set.
pub const MAX_SET: usize = 10_000;

/// Largest distance of a corner of a polygon from its plane, over the size of the polygon: what lists with rounded numbers need.
const FLAT: f64 = 1e-3;

/// A joint.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// Unit normal.
    pub normal: Vec3,
    /// A point of it; the centre of a disk, m.
    pub at: Vec3,
    /// How far it goes.
    pub extent: Extent,
}

/// How far a joint goes in its plane.
#[derive(Clone, Debug, PartialEq)]
pub enum Extent {
    /// Without end.
    Whole,
    /// Without end, but each solid that it meets is cut with this chance only.
    Partly(f64),
    /// A disk about its point, with its radius, m.
    Disk(f64),
    /// A convex polygon, its corners anticlockwise about the normal, m.
    Polygon(Vec<Vec3>),
}

impl Joint {
    /// A joint that is a convex polygon; corners in their order either way round.
    ///
    /// # Errors
    /// What is wrong with the polygon, in words.
    pub fn polygon(corners: &[Vec3]) -> Result<Self, &'static str> {
        let count = corners.len();
        if count < 3 {
            return Err("has fewer than three corners");
        }
        if corners.iter().any(|c| !c.is_finite() || c.abs().max_element() > 1e150) {
            return Err("has a non-finite corner");
        }
        let at = corners.iter().sum::<Vec3>() / count as f64;
        let arm = |k: usize| corners[k % count] - at;
        let doubled: Vec3 = (0..count).map(|k| arm(k).cross(arm(k + 1))).sum();
        let size = (0..count).map(|k| arm(k).length()).fold(0.0, f64::max);
        if doubled.length() <= SNAP * size * size {
            return Err("has no area");
        }
        let normal = doubled.normalize();
        if (0..count).any(|k| normal.dot(arm(k)).abs() > FLAT * size) {
            return Err("is not flat");
        }
        let turns = |k: usize| (arm(k + 1) - arm(k)).cross(arm(k + 2) - arm(k + 1));
        if (0..count).any(|k| turns(k).dot(normal) < -FLAT * FLAT * size * size) {
            return Err("is not convex");
        }
        let flat = |k: usize| at + arm(k) - normal.dot(arm(k)) * normal;
        Ok(Self { normal, at, extent: Extent::Polygon((0..count).map(flat).collect()) })
    }
}

/// A set of parallel planes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneSet {
    /// Unit normal.
    pub normal: Vec3,
    /// A point of one plane, m.
    pub at: Vec3,
    /// Distance between neighbours, m.
    pub spacing: f64,
    /// Standard deviation of that distance, m. The place of each plane is scattered by this over sqrt 2, and by no more
    /// than 0.45 spacings, so planes keep their order.
    pub spacing_scatter: f64,
    /// Standard deviation of the turns of a normal about two axes across it, rad; at most 3 of them.
    pub angle_scatter: f64,
    /// Chance with which a joint cuts a solid that it meets, above 0 and at most 1.
    pub persistence: f64,
}

/// What joints have made of solids.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Divided {
    /// The parts.
    pub solids: Vec<Polyhedron>,
    /// Number of the solid that each part comes from.
    pub parents: Vec<u32>,
    /// Cuts that were not made, because a part would have been too thin.
    pub spared: usize,
    /// Area of all cuts that were made, m².
    pub area: f64,
    /// The part of it that lies within the disks and polygons of joints that have an end, or on joints without one, m².
    pub within: f64,
}

/// Upward unit normal of a plane by its dip (below the horizontal) and dip direction (clockwise from y), rad.
#[must_use]
pub fn normal_of_dip(dip: f64, direction: f64) -> Vec3 {
    let (sin, cos) = (libm::sin(dip), libm::cos(dip));
    Vec3::new(sin * libm::sin(direction), sin * libm::cos(direction), cos)
}

/// The planes of each set that meet the box from `min` to `max` (m), along its normal.
///
/// # Errors
/// Numbers out of range, more than [`MAX_SET`] planes in a set.
pub fn planes(
    sets: &[PlaneSet],
    min: Vec3,
    max: Vec3,
    seed: u64,
) -> Result<Vec<Vec<Joint>>, GeomError> {
    let mut chance = Chance::new(seed);
    let mut all = Vec::with_capacity(sets.len());
    for set in sets {
        let mut joints = Vec::new();
        let spacing = set.spacing;
        demand("the spacing of a joint set", spacing, spacing > 0.0, "above 0")?;
        let far = set.at.abs().max_element();
        demand("the origin of a joint set", far, far < 1e150, "finite")?;
        let share = set.persistence;
        demand(
            "the persistence of a joint set",
            share,
            share > 0.0 && share <= 1.0,
            "above 0 and at most 1",
        )?;
        let (centre, half) = (0.5 * (min + max), 0.5 * (max - min));
        let reach = set.normal.abs().dot(half)
            // Turns end at three deviations.
            + libm::tan(3.0 * set.angle_scatter.min(0.3)) * half.length();
        let middle = (centre - set.at).dot(set.normal);
        // One plane more on either side, since scatter may bring it in.
        let first = ((middle - reach) / spacing).floor() - 1.0;
        let last = ((middle + reach) / spacing).ceil() + 1.0;
        let count = last - first + 1.0;
        if count.is_nan() || count > MAX_SET as f64 {
            return Err(GeomError::TooMany { what: "planes of a joint set", count, cap: MAX_SET });
        }
        let [_, b, c] = super::frame(set.normal);
        for k in 0..count as usize {
            // A spacing has the scatter of both its planes.
            let jitter = set.spacing_scatter * std::f64::consts::FRAC_1_SQRT_2 * chance.normal();
            let limit = 0.45 * spacing;
            let height = (first + k as f64) * spacing + jitter.clamp(-limit, limit);
            let mut turn = || set.angle_scatter * chance.normal().clamp(-3.0, 3.0);
            let turned = set.normal + libm::tan(turn()) * b + libm::tan(turn()) * c;
            joints.push(Joint {
                normal: turned.normalize(),
                // Beside the middle of the model: about a far point of the set a turn would move the plane away.
                at: centre + (height - middle) * set.normal,
                extent: match share < 1.0 {
                    true => Extent::Partly(share),
                    false => Extent::Whole,
                },
            });
        }
        all.push(joints);
    }
    Ok(all)
}

/// Cuts solids by joints, one joint after the other. A cut that would leave a part thinner than `thinnest` (m) across the
/// joint is not made. `seed` draws which solids joints that are not persistent cut.
///
/// # Errors
/// A joint without direction or place; more than `tol::MAX_BLOCKS` parts.
pub fn divide(
    solids: Vec<Polyhedron>,
    joints: &[Joint],
    thinnest: f64,
    seed: u64,
) -> Result<Divided, GeomError> {
    let mut chance = Chance::new(seed);
    for joint in joints {
        let far = joint.at.abs().max_element();
        demand("the position of a joint", far, far < 1e150, "finite")?;
        let length = joint.normal.length();
        demand("the normal of a joint", length, (length - 1.0).abs() < 1e-9, "a non-zero vector")?;
    }
    let mut boxes: Vec<(Vec3, Vec3)> = solids.iter().map(centre_and_half).collect();
    let mut divided = Divided {
        parents: (0..solids.len() as u32).collect(),
        solids,
        spared: 0,
        area: 0.0,
        within: 0.0,
    };
    for joint in joints {
        let offset = joint.normal.dot(joint.at);
        let across = joint.normal.abs();
        // The halves above a joint are beyond the end of this range: it does not meet them again.
        for k in 0..divided.solids.len() {
            let (centre, half) = boxes[k];
            if (joint.normal.dot(centre) - offset).abs() > across.dot(half) {
                continue;
            }
            match halves(&divided.solids[k], joint, offset, thinnest) {
                Halves::Beside => {}
                Halves::Thin => divided.spared += 1,
                Halves::Cut { .. } if ends(joint, &mut chance) => {}
                Halves::Cut { below, above, area, within } => {
                    divided.area += area;
                    divided.within += within;
                    if divided.solids.len() >= MAX_BLOCKS {
                        return Err(GeomError::TooMany {
                            what: "blocks",
                            count: (MAX_BLOCKS + 1) as f64,
                            cap: MAX_BLOCKS,
                        });
                    }
                    boxes[k] = centre_and_half(&below);
                    boxes.push(centre_and_half(&above));
                    divided.parents.push(divided.parents[k]);
                    divided.solids[k] = below;
                    divided.solids.push(above);
                }
            }
        }
    }
    Ok(divided)
}

/// Whether a joint that is not persistent ends at a solid, drawn anew for each.
fn ends(joint: &Joint, chance: &mut Chance) -> bool {
    matches!(joint.extent, Extent::Partly(share) if chance.unit() >= share)
}

fn centre_and_half(solid: &Polyhedron) -> (Vec3, Vec3) {
    let (min, max) = solid.bounds();
    (0.5 * (min + max), 0.5 * (max - min))
}

enum Halves {
    /// The joint does not meet the solid.
    Beside,
    /// It would cut off too little.
    Thin,
    /// Parts below and above it, area of the cut and of what of it the joint covers, m².
    Cut { below: Polyhedron, above: Polyhedron, area: f64, within: f64 },
}

fn halves(solid: &Polyhedron, joint: &Joint, offset: f64, thinnest: f64) -> Halves {
    let heights = || solid.vertices.iter().map(|v| joint.normal.dot(*v) - offset);
    let below = heights().fold(0.0, |most: f64, h| most.max(-h));
    let above = heights().fold(0.0, f64::max);
    if below.min(above) <= SNAP * solid.size() {
        return Halves::Beside;
    }
    let parts = (slice(solid, joint.normal, offset), slice(solid, -joint.normal, -offset));
    let (Sliced::Part(low), Sliced::Part(high)) = parts else {
        return Halves::Thin;
    };
    // The face of the cut is the last one.
    let section = low.outline(low.faces.len() - 1);
    let area = area(&section, joint);
    let within = match &joint.extent {
        Extent::Whole | Extent::Partly(_) => Some(area),
        Extent::Disk(radius) => {
            (distance(&section, joint) <= *radius).then(|| covered(&section, joint, *radius))
        }
        Extent::Polygon(corners) => {
            Some(shared(&section, corners, joint)).filter(|shared| *shared > SNAP * area)
        }
    };
    let Some(within) = within else {
        return Halves::Beside;
    };
    if below.min(above) < thinnest {
        return Halves::Thin;
    }
    Halves::Cut { below: low, above: high, area, within }
}

/// Area that two convex polygons in the plane of a joint have in common, both anticlockwise about its normal, m².
fn shared(section: &[Vec3], corners: &[Vec3], joint: &Joint) -> f64 {
    let mut left = section.to_vec();
    let mut next = Vec::with_capacity(section.len() + corners.len());
    for (k, &from) in corners.iter().enumerate() {
        let edge = corners[(k + 1) % corners.len()] - from;
        let inside = |p: Vec3| edge.cross(p - from).dot(joint.normal);
        next.clear();
        for (k, &a) in left.iter().enumerate() {
            let b = left[(k + 1) % left.len()];
            let (ha, hb) = (inside(a), inside(b));
            if ha >= 0.0 {
                next.push(a);
            }
            if (ha >= 0.0) != (hb >= 0.0) {
                next.push(a + ha / (ha - hb) * (b - a));
            }
        }
        std::mem::swap(&mut left, &mut next);
    }
    area(&left, joint)
}

/// Area of a polygon in the plane of a joint that runs anticlockwise about its normal, m².
fn area(section: &[Vec3], joint: &Joint) -> f64 {
    let next = section.iter().cycle().skip(1);
    let cross = section.iter().zip(next).map(|(a, b)| (*a - joint.at).cross(*b - joint.at));
    0.5 * cross.sum::<Vec3>().dot(joint.normal)
}

/// Area of the part of such a polygon that lies in a disk about the centre of the joint, m²: for each edge the triangle with the
/// centre, or a sector where the edge runs outside of the circle.
fn covered(section: &[Vec3], joint: &Joint, radius: f64) -> f64 {
    let square = radius * radius;
    let cross = |a: Vec3, b: Vec3| a.cross(b).dot(joint.normal);
    let sector = |a: Vec3, b: Vec3| 0.5 * square * libm::atan2(cross(a, b), a.dot(b));
    let mut sum = 0.0;
    for (k, &from) in section.iter().enumerate() {
        let a = from - joint.at;
        let b = section[(k + 1) % section.len()] - joint.at;
        let way = b - a;
        // Shares of the edge at which it enters and leaves the circle: |a + t way| = radius.
        let (half, length) = (-a.dot(way) / way.length_squared(), way.length_squared());
        let root = half * half - (a.length_squared() - square) / length;
        let [enter, leave] = match root > 0.0 {
            true => [half - root.sqrt(), half + root.sqrt()].map(|t| t.clamp(0.0, 1.0)),
            false => [0.0, 0.0],
        };
        let [p, q] = [enter, leave].map(|t| a + t * way);
        sum += sector(a, p) + 0.5 * cross(p, q) + sector(q, b);
    }
    sum
}

/// Distance of the centre of a disk from a convex polygon in its plane that runs anticlockwise about its normal, m.
fn distance(section: &[Vec3], joint: &Joint) -> f64 {
    let mut least = f64::INFINITY;
    let mut inside = true;
    for (k, &a) in section.iter().enumerate() {
        let edge = section[(k + 1) % section.len()] - a;
        let arm = joint.at - a;
        inside &= edge.cross(arm).dot(joint.normal) >= 0.0;
        let share = (arm.dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
        least = least.min((arm - share * edge).length());
    }
    if inside { 0.0 } else { least }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CUBE: (Vec3, Vec3) = (Vec3::ZERO, Vec3::ONE);

    fn cube() -> Vec<Polyhedron> {
        vec![Polyhedron::brick(Vec3::splat(0.5), Vec3::splat(0.5))]
    }

    fn set(dip: f64, direction: f64, spacing: f64) -> PlaneSet {
        PlaneSet {
            normal: normal_of_dip(dip.to_radians(), direction.to_radians()),
            at: Vec3::splat(0.05),
            spacing,
            spacing_scatter: 0.0,
            angle_scatter: 0.0,
            persistence: 1.0,
        }
    }

    fn volume(divided: &Divided) -> f64 {
        divided.solids.iter().map(|s| s.moments().volume).sum()
    }

    #[test]
    fn a_plane_that_dips_east_has_a_normal_that_leans_east() {
        let n = normal_of_dip(30_f64.to_radians(), 90_f64.to_radians());
        assert!((n - Vec3::new(0.5, 0.0, 0.75_f64.sqrt())).length() < 1e-15);
        assert!(normal_of_dip(std::f64::consts::FRAC_PI_2, 0.0).y > 0.999);
    }

    #[test]
    fn three_sets_across_fill_the_cube() {
        let sets = [set(0.0, 0.0, 0.25), set(90.0, 0.0, 0.25), set(90.0, 90.0, 0.25)];
        let joints = planes(&sets, CUBE.0, CUBE.1, 1).unwrap().concat();
        let divided = divide(cube(), &joints, 0.0, 0).unwrap();
        // Planes at 0.05, 0.3, 0.55, 0.8 along each axis.
        assert_eq!((divided.solids.len(), divided.spared), (125, 0));
        assert!((volume(&divided) - 1.0).abs() < 1e-12);
        assert!(divided.parents.iter().all(|p| *p == 0));
        // Parts of 0.05 across are not cut off.
        let thick = divide(cube(), &joints, 0.1, 0).unwrap();
        assert_eq!(thick.solids.len(), 64);
        assert!((volume(&thick) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn oblique_sets_fill_it_too_and_scatter_is_the_same_for_a_seed() {
        let mut sets = [set(35.0, 110.0, 0.2), set(70.0, 220.0, 0.3), set(80.0, 330.0, 0.25)];
        for set in &mut sets {
            (set.spacing_scatter, set.angle_scatter) = (0.05, 0.1);
        }
        let made = |seed| {
            let joints = planes(&sets, CUBE.0, CUBE.1, seed).unwrap().concat();
            divide(cube(), &joints, 0.0, 0).unwrap()
        };
        let (one, again, other) = (made(1), made(1), made(2));
        assert!(one == again && one != other);
        assert!(one.solids.len() > 50, "{}", one.solids.len());
        assert!((volume(&one) - 1.0).abs() < 1e-9, "{}", volume(&one));
        for solid in &one.solids {
            solid.validate().unwrap();
        }
    }

    #[test]
    fn a_disk_cuts_what_it_touches() {
        let plane =
            |z: f64| Joint { normal: Vec3::Z, at: Vec3::new(0.2, 0.5, z), extent: Extent::Whole };
        let across = Joint { normal: Vec3::X, at: Vec3::new(0.5, 0.5, 0.5), extent: Extent::Whole };
        let disk = |radius: f64| Joint { extent: Extent::Disk(radius), ..plane(0.5) };
        let count = |joints: &[Joint]| divide(cube(), joints, 0.0, 0).unwrap().solids.len();
        assert_eq!(count(&[across.clone(), plane(0.5)]), 4);
        assert_eq!(count(&[across.clone(), disk(0.29)]), 3);
        assert_eq!(count(&[across, disk(0.31)]), 4);
        // Its centre outside of the cube.
        let beside = |radius: f64| Joint { at: Vec3::new(-0.2, 0.5, 0.5), ..disk(radius) };
        assert_eq!(count(&[beside(0.19)]), 1);
        assert_eq!(count(&[beside(0.21)]), 2);
        // Faces of the cube are no cuts.
        assert_eq!(count(&[plane(0.0), plane(1.0), plane(-3.0)]), 1);
    }

    #[test]
    fn the_area_of_cuts_is_told_with_what_disks_cover_of_it() {
        let disk = |x: f64, radius: f64| Joint {
            normal: Vec3::Z,
            at: Vec3::new(x, 0.5, 0.5),
            extent: Extent::Disk(radius),
        };
        let areas = |joint: Joint| {
            let divided = divide(cube(), &[joint], 0.0, 0).unwrap();
            [divided.area, divided.within]
        };
        let circle = |radius: f64| std::f64::consts::PI * radius * radius;
        // Inside of the section, half of it, a corner more than the whole section, and a segment of 0.3 from the centre.
        let segment = 0.16 * (0.75_f64.acos()) - 0.3 * 0.07_f64.sqrt();
        for (joint, within) in [
            (disk(0.5, 0.3), circle(0.3)),
            (disk(0.0, 0.3), 0.5 * circle(0.3)),
            (disk(0.5, 2.0), 1.0),
            (disk(0.7, 0.4), circle(0.4) - segment),
            (disk(-0.3, 0.4), segment),
        ] {
            let [area, found] = areas(joint);
            assert!((area - 1.0).abs() < 1e-14, "{area}");
            assert!((found - within).abs() < 1e-13, "{found} {within}");
        }
    }

    /// A rectangle of 2a by 2b about a point, turned about x by `angle`, its corners either way round.
    fn rectangle(at: Vec3, half: [f64; 2], angle: f64, turn: bool) -> Vec<Vec3> {
        let (along, across) = (Vec3::X, Vec3::new(0.0, angle.cos(), angle.sin()));
        let signs = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let corner = |(a, b): (f64, f64)| at + a * half[0] * along + b * half[1] * across;
        let mut corners: Vec<Vec3> = signs.map(corner).to_vec();
        if turn {
            corners.reverse();
        }
        corners
    }

    #[test]
    fn a_polygon_cuts_what_it_covers_and_tells_its_area() {
        let middle = Vec3::splat(0.5);
        for turn in [false, true] {
            for (at, half, cut, within) in [
                (middle, [0.2, 0.3], true, 0.24),
                (middle, [2.0, 3.0], true, 1.0),
                (Vec3::new(0.1, 0.5, 0.5), [0.2, 0.25], true, 0.15),
                (Vec3::new(-0.2, 0.5, 0.5), [0.19, 0.25], false, 0.0),
                (Vec3::new(0.5, 0.5, 1.5), [0.2, 0.3], false, 0.0),
            ] {
                let joint = Joint::polygon(&rectangle(at, half, 0.0, turn)).unwrap();
                let divided = divide(cube(), &[joint], 0.0, 0).unwrap();
                assert_eq!(divided.solids.len(), if cut { 2 } else { 1 });
                assert!((divided.within - within).abs() < 1e-14, "{}", divided.within);
                let all = if cut { 1.0 } else { 0.0 };
                assert!((divided.area - all).abs() < 1e-14);
            }
        }
        // Across at 30 degrees to the horizontal: the section is longer by 1/cos.
        let joint = Joint::polygon(&rectangle(middle, [0.1, 0.2], 30_f64.to_radians(), false));
        let divided = divide(cube(), &[joint.unwrap()], 0.0, 0).unwrap();
        assert!((divided.area - 1.0 / 0.75_f64.sqrt()).abs() < 1e-14);
        assert!((divided.within - 0.08).abs() < 1e-14, "{}", divided.within);
    }

    #[test]
    fn what_is_wrong_with_a_polygon_is_told() {
        let mut corners = rectangle(Vec3::ZERO, [1.0, 1.0], 0.3, false);
        assert_eq!(Joint::polygon(&corners[..2]), Err("has fewer than three corners"));
        let bent = corners[0] + 0.2 * Vec3::Z;
        let straight = std::mem::replace(&mut corners[0], bent);
        assert_eq!(Joint::polygon(&corners), Err("is not flat"));
        corners[0] = straight;
        corners.insert(1, 0.1 * Vec3::X);
        assert_eq!(Joint::polygon(&corners), Err("is not convex"));
        let line = [Vec3::ZERO, Vec3::X, 2.0 * Vec3::X];
        assert_eq!(Joint::polygon(&line), Err("has no area"));
    }

    #[test]
    fn joints_of_half_persistence_have_half_the_area() {
        let mut sets = [set(0.0, 0.0, 0.05), set(90.0, 0.0, 0.05), set(90.0, 90.0, 0.05)];
        let area = |sets: &[PlaneSet], seed| {
            let joints = planes(sets, CUBE.0, CUBE.1, 1).unwrap().concat();
            let divided = divide(cube(), &joints, 0.0, seed).unwrap();
            assert!((volume(&divided) - 1.0).abs() < 1e-11);
            (divided.area, divided.solids.len())
        };
        // 19 planes of 1 m2 each way.
        let (whole, blocks) = area(&sets, 3);
        assert!((whole - 57.0).abs() < 1e-9 && blocks == 8000, "{whole} {blocks}");
        sets[2].persistence = 0.5;
        let (half, fewer) = area(&sets, 3);
        // 400 columns of 0.0025 m2 with 19 places each, cut at half of them: 9.5 m2, give or take 0.11.
        assert!((half - 47.5).abs() < 0.5 && fewer < blocks, "{half} {fewer}");
        assert_eq!(area(&sets, 3), (half, fewer));
        assert_ne!(area(&sets, 4), (half, fewer));
        // Of the first set a joint meets one solid: it cuts all of it, or nothing.
        sets[0].persistence = 0.5;
        sets[2].persistence = 1.0;
        let (layers, _) = area(&sets, 3);
        assert!((layers - layers.round()).abs() < 1e-9 && layers < 57.0, "{layers}");
        sets[0].persistence = 0.0;
        assert!(planes(&sets, CUBE.0, CUBE.1, 1).is_err());
    }

    #[test]
    fn too_many_planes_are_refused() {
        let fine = set(10.0, 0.0, 1e-5);
        let error = planes(&[fine], CUBE.0, CUBE.1, 1).unwrap_err();
        assert!(error.to_string().contains("planes of a joint set"), "{error}");
        let thin = [set(0.0, 0.0, 1e-3), set(90.0, 0.0, 1e-3)];
        let joints = planes(&thin, CUBE.0, CUBE.1, 1).unwrap().concat();
        assert!(divide(cube(), &joints[..300], 0.0, 0).is_ok());
    }
}
