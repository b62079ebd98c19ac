//! The rim of a surface: one outline, no holes; and the wall that goes down from it.

use std::collections::BTreeMap;

use super::{HeightField, HeightFieldError, middle};
use crate::{Vec2, Vec3};

/// Run of the wall along the ground over a typical edge of the surface.
const RUN: f64 = 1e-3;
/// The wall leans outward at a sharp corner of the rim by no more than this many runs.
const MITRE: f64 = 4.0;

/// The surface with a wall all round that goes down from its rim, by its extent below its lowest point: as steep as numbers allow. The
/// first triangles and corners are those of the surface; a part of the wall that would be folded is left out.
///
/// The height is continuous over the wall: what comes to the rim from outside meets a side.
pub(super) fn walled(surface: &HeightField) -> HeightField {
    let mut walled = surface.clone();
    let Ok(ring) = ring(surface) else {
        return walled;
    };
    let (low, high) = surface.bounds();
    let extent = (high - low).truncate();
    let foot = low.z - extent.length();
    let run = RUN * (extent.x * extent.y / surface.triangles.len() as f64).sqrt();
    let count = ring.len();
    let first = walled.points.len() as u32;
    let outward = |from: u32, to: u32| {
        let way = (surface.points[to as usize] - surface.points[from as usize]).truncate();
        // The surface lies to the left.
        Vec2::new(way.y, -way.x).normalize_or_zero()
    };
    for k in 0..count {
        let [before, here, after] = [k + count - 1, k, k + 1].map(|k| ring[k % count]);
        let [a, b] = [outward(before, here), outward(here, after)];
        let sum = a + b;
        // The wall keeps its run along both edges.
        let lean = sum / (0.5 * sum.length_squared()).max(2.0 / (MITRE * MITRE));
        let at = surface.points[here as usize];
        let out = at.truncate() + run * lean;
        walled.points.push(Vec3::new(out.x, out.y, foot));
    }
    for k in 0..count as u32 {
        let next = (k + 1) % count as u32;
        let [a, b] = [k, next].map(|k| ring[k as usize]);
        let [c, d] = [first + next, first + k];
        for triangle in [[a, d, b], [b, d, c]] {
            let [p, q, r] = triangle.map(|k| walled.points[k as usize]);
            if super::cross(p, q, r) > 0.0 {
                walled.triangles.push(triangle);
            }
        }
    }
    walled
}

/// The corners of the rim, anticlockwise. Its loops must be one anticlockwise one.
///
/// At a corner that the rim passes twice, the next edge is the one that bounds the same outside: the first one anticlockwise from
/// where the rim came.
pub(super) fn ring(surface: &HeightField) -> Result<Vec<u32>, HeightFieldError> {
    let mut leaving: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    let rim = surface.rim();
    for &(from, to) in &rim {
        leaving.entry(from).or_default().push(to);
    }
    let at = |k: u32| surface.points[k as usize];
    let mut outer: Vec<(Vec<Vec3>, Vec<u32>)> = Vec::new();
    for start in rim {
        let Some(first) = take(&mut leaving, start.0, |to| *to == start.1) else {
            continue;
        };
        let mut ring = vec![at(start.0)];
        let mut corners = vec![start.0];
        let (mut from, mut here) = (start.0, first);
        while here != start.0 {
            ring.push(at(here));
            corners.push(here);
            let back = at(from) - at(here);
            let Some(list) = leaving.get(&here) else {
                break;
            };
            let turn = |to: u32| {
                let out = at(to) - at(here);
                let angle =
                    libm::atan2(back.x * out.y - back.y * out.x, back.x * out.x + back.y * out.y);
                // Back along the edge that was come by is the last choice, a full turn, not the first.
                if angle > 0.0 { angle } else { angle + std::f64::consts::TAU }
            };
            let Some(&next) = list.iter().min_by(|a, b| turn(**a).total_cmp(&turn(**b))) else {
                break;
            };
            take(&mut leaving, here, |to| *to == next);
            (from, here) = (here, next);
        }
        // The outline runs anticlockwise, the rim of a hole clockwise.
        if area(&ring) <= 0.0 {
            let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
            let (low, high) = ring.iter().fold(start, |(low, high), p| (low.min(*p), high.max(*p)));
            return Err(HeightFieldError::Hole {
                at: middle(&ring),
                width: (high - low).truncate().max_element(),
            });
        }
        outer.push((ring, corners));
    }
    if outer.len() > 1 {
        let smallest = outer.iter().min_by(|a, b| area(&a.0).total_cmp(&area(&b.0)));
        return Err(HeightFieldError::Parts {
            parts: outer.len(),
            at: smallest.map_or([0.0; 2], |(ring, _)| middle(&ring[..1])),
        });
    }
    Ok(outer.pop().map_or_else(Vec::new, |(_, corners)| corners))
}

/// Takes out one of the edges that leave a corner.
fn take(
    leaving: &mut BTreeMap<u32, Vec<u32>>,
    from: u32,
    wanted: impl Fn(&u32) -> bool,
) -> Option<u32> {
    let list = leaving.get_mut(&from)?;
    let place = list.iter().position(wanted)?;
    Some(list.remove(place))
}

fn area(ring: &[Vec3]) -> f64 {
    let next = ring.iter().cycle().skip(1);
    ring.iter()
        .zip(next)
        .map(|(a, b)| {
            // From a corner of it: far from the origin the products would lose their digits.
            0.5 * ((a.x - ring[0].x) * (b.y - ring[0].y) - (b.x - ring[0].x) * (a.y - ring[0].y))
        })
        .sum()
}
