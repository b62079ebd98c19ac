//! Ready-made blocks: rectangle, regular polygon, wall, arch. All outlines anticlockwise.

use crate::error::demand;
use crate::{GeomError, Vec2, tol};

/// Rectangle with its lower left corner at `corner`.
pub fn rectangle(corner: Vec2, size: Vec2) -> Vec<Vec2> {
    let far = corner + size;
    vec![corner, Vec2::new(far.x, corner.y), far, Vec2::new(corner.x, far.y)]
}

/// Regular polygon on a circle, standing on an edge; the right end of that edge comes first.
pub fn regular(sides: usize, radius: f64, centre: Vec2) -> Vec<Vec2> {
    // From straight down, so that the two ends of the lowest edge mirror each other.
    let angle = |k: usize| std::f64::consts::PI * (2.0 * k as f64 + 1.0) / sides as f64;
    let corner = |a: f64| Vec2::new(libm::sin(a), -libm::cos(a));
    (0..sides).map(|k| centre + radius * corner(angle(k))).collect()
}

/// Unit vector at an angle anticlockwise from +x, the same bits on every machine.
pub fn unit(angle: f64) -> Vec2 {
    Vec2::new(libm::cos(angle), libm::sin(angle))
}

/// A wall of equal rectangles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wall {
    /// Lower left corner, m.
    pub corner: Vec2,
    /// Width and height of a block, m.
    pub block: Vec2,
    /// Number of courses.
    pub courses: usize,
    /// Whole blocks in the first course.
    pub per_course: usize,
    /// Whether every second course is shifted by half a block: a running bond. Else all vertical joints stand above each other.
    pub running: bool,
    /// Running bond: even courses (second, fourth, ...) end in half blocks, so that the ends of the
    /// wall are straight; else they stick out by half a block to the right.
    pub half_blocks: bool,
}

/// Blocks of a wall, course by course from below, from left to right. Neighbours share coordinates
/// bit for bit.
pub fn wall(wall: &Wall) -> Result<Vec<Vec<Vec2>>, GeomError> {
    demand("the width of a wall block", wall.block.x, wall.block.x > 0.0, "above 0")?;
    demand("the height of a wall block", wall.block.y, wall.block.y > 0.0, "above 0")?;
    demand("the wall's corner", wall.corner.x + wall.corner.y, true, "finite")?;
    capped("blocks", wall.courses as f64 * (wall.per_course as f64 + 1.0))?;
    demand("the number of courses", wall.courses as f64, wall.courses > 0, "at least 1")?;
    demand("blocks per course", wall.per_course as f64, wall.per_course > 0, "at least 1")?;
    // Every coordinate is a whole number of half blocks from the corner.
    let x = |halves: usize| wall.corner.x + halves as f64 * (0.5 * wall.block.x);
    let y = |course: usize| wall.corner.y + course as f64 * wall.block.y;
    let mut blocks = Vec::new();
    for course in 0..wall.courses {
        let (low, high) = (y(course), y(course + 1));
        let mut brick = |from: usize, to: usize| {
            blocks.push(vec![
                Vec2::new(x(from), low),
                Vec2::new(x(to), low),
                Vec2::new(x(to), high),
                Vec2::new(x(from), high),
            ]);
        };
        let end = 2 * wall.per_course;
        let shifted = wall.running && course % 2 == 1;
        if !shifted {
            (0..wall.per_course).for_each(|k| brick(2 * k, 2 * k + 2));
        } else if wall.half_blocks {
            brick(0, 1);
            (1..wall.per_course).for_each(|k| brick(2 * k - 1, 2 * k + 1));
            brick(end - 1, end);
        } else {
            (0..wall.per_course).for_each(|k| brick(2 * k + 1, 2 * k + 3));
        }
    }
    Ok(blocks)
}

/// A circular arch with radial joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arch {
    /// Centre of the circle, m.
    pub centre: Vec2,
    /// Radius of the centre line, m.
    pub radius: f64,
    /// Thickness across the arch, m.
    pub thickness: f64,
    /// Half of the opening angle, rad: pi/2 for a half circle; the crown is above the centre.
    pub half_angle: f64,
    /// Number of voussoirs.
    pub voussoirs: usize,
}

/// Voussoirs from the right springing to the left one, each with four straight sides; neighbours
/// share their two vertices bit for bit.
pub fn arch(arch: &Arch) -> Result<Vec<Vec<Vec2>>, GeomError> {
    let Arch { centre, radius, thickness, half_angle, voussoirs } = *arch;
    demand("the radius of the arch", radius, radius > 0.0, "above 0")?;
    demand(
        "the thickness of the arch",
        thickness,
        thickness > 0.0 && thickness < 2.0 * radius,
        "above 0 and below twice the radius",
    )?;
    demand(
        "the half angle of the arch",
        half_angle,
        half_angle > 0.0 && half_angle < std::f64::consts::PI,
        "above 0 and below 180 deg (pi)",
    )?;
    demand("the arch's centre", centre.x + centre.y, true, "finite")?;
    demand("the number of voussoirs", voussoirs as f64, voussoirs > 0, "at least 1")?;
    let step = 2.0 * half_angle / voussoirs as f64;
    demand("the angle of one voussoir", step, step < std::f64::consts::PI, "below 180 deg (pi)")?;
    capped("voussoirs", voussoirs as f64)?;
    // Measured from the crown, so that the two halves mirror each other to the bit.
    let ray = |k: usize| {
        let from_crown = half_angle * (voussoirs as f64 - 2.0 * k as f64) / voussoirs as f64;
        Vec2::new(libm::sin(from_crown), libm::cos(from_crown))
    };
    let (inner, outer) = (radius - 0.5 * thickness, radius + 0.5 * thickness);
    let joints: Vec<[Vec2; 2]> =
        (0..=voussoirs).map(|k| [centre + inner * ray(k), centre + outer * ray(k)]).collect();
    Ok(joints.windows(2).map(|j| vec![j[0][0], j[0][1], j[1][1], j[1][0]]).collect())
}

/// `Ok` if `count` blocks are allowed.
pub(crate) fn capped(what: &'static str, count: f64) -> Result<(), GeomError> {
    if count <= tol::MAX_BLOCKS as f64 {
        Ok(())
    } else {
        Err(GeomError::TooMany { what, count, cap: tol::MAX_BLOCKS })
    }
}

/// A U for tests, 5 m wide and 4 m high, its arms 1 m thick: the simplest outline that a line leaves in
/// two parts.
#[cfg(test)]
pub(crate) fn letter_u() -> Vec<Vec2> {
    [(0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (4.0, 4.0), (4.0, 1.0), (1.0, 1.0), (1.0, 4.0), (0.0, 4.0)]
        .map(Vec2::from)
        .to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::polygon::{signed_area, validate};

    #[test]
    fn walls_have_the_blocks_they_should() {
        let plain = Wall {
            corner: Vec2::new(1.0, 2.0),
            block: Vec2::new(0.4, 0.2),
            courses: 5,
            per_course: 3,
            running: false,
            half_blocks: false,
        };
        assert_eq!(wall(&plain).unwrap().len(), 15);
        let ragged = Wall { running: true, ..plain };
        assert_eq!(wall(&ragged).unwrap().len(), 15);
        let straight = wall(&Wall { half_blocks: true, ..ragged }).unwrap();
        assert_eq!(straight.len(), 3 * 3 + 2 * 4);
        let area: f64 = straight.iter().map(|b| signed_area(b)).sum();
        assert!((area - 1.2).abs() < 1e-12);
        // The top of a block below and the bottom of the one above have the same y bits.
        assert_eq!(straight[0][2].y.to_bits(), straight[3][0].y.to_bits());
        let silly = Wall { courses: usize::MAX, per_course: usize::MAX, ..plain };
        assert!(matches!(wall(&silly), Err(GeomError::TooMany { .. })));
        assert!(wall(&Wall { block: Vec2::new(f64::NAN, 1.0), ..plain }).is_err());
    }

    #[test]
    fn regular_polygons_stand_on_an_edge() {
        for sides in 3..12 {
            let shape = regular(sides, 2.0, Vec2::new(0.0, 1.0));
            let lowest = shape.iter().map(|v| v.y).fold(f64::INFINITY, f64::min);
            let standing = shape.iter().filter(|v| v.y - lowest < 1e-12).count();
            assert!(standing == 2 && signed_area(&shape) > 0.0, "{sides}");
        }
    }

    #[test]
    fn voussoirs_share_vertices_and_mirror() {
        let shape = Arch {
            centre: Vec2::ZERO,
            radius: 10.0,
            thickness: 1.07,
            half_angle: std::f64::consts::FRAC_PI_2,
            voussoirs: 15,
        };
        let blocks = arch(&shape).unwrap();
        assert_eq!(blocks.len(), 15);
        for pair in blocks.windows(2) {
            assert_eq!((pair[0][3], pair[0][2]), (pair[1][0], pair[1][1]));
        }
        for (left, right) in blocks.iter().rev().zip(&blocks) {
            assert!(validate(right).is_ok() && signed_area(right) > 0.0);
            assert_eq!(left[3], Vec2::new(-right[0].x, right[0].y));
        }
        assert!(arch(&Arch { voussoirs: 0, ..shape }).is_err());
        assert!(arch(&Arch { thickness: 30.0, ..shape }).is_err());
        assert!(arch(&Arch { voussoirs: usize::MAX, ..shape }).is_err());
    }
}
