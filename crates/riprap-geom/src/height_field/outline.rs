//! The rim of a surface: one outline, no holes.

use std::collections::BTreeMap;

use super::{HeightField, HeightFieldError, middle};
use crate::Vec3;

/// Loops of the rim must be one anticlockwise one.
///
/// At a corner that the rim passes twice, the next edge is the one that bounds the same outside: the first one anticlockwise from
/// where the rim came.
pub(super) fn check(surface: &HeightField) -> Result<(), HeightFieldError> {
    let mut leaving: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    let rim = surface.rim();
    for &(from, to) in &rim {
        leaving.entry(from).or_default().push(to);
    }
    let at = |k: u32| surface.points[k as usize];
    let mut outer: Vec<Vec<Vec3>> = Vec::new();
    for start in rim {
        let Some(first) = take(&mut leaving, start.0, |to| *to == start.1) else {
            continue;
        };
        let mut ring = vec![at(start.0)];
        let (mut from, mut here) = (start.0, first);
        while here != start.0 {
            ring.push(at(here));
            let back = at(from) - at(here);
            let Some(list) = leaving.get(&here) else {
                break;
            };
            let turn = |to: u32| {
                let out = at(to) - at(here);
                let angle = libm::atan2(
                    back.x * out.y - back.y * out.x,
                    back.x * out.x + back.y * out.y,
                );
                // Back along the edge that was come by is the last choice, a full turn, not the first.
                if angle > 0.0 {
                    angle
                } else {
                    angle + std::f64::consts::TAU
                }
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
            let (low, high) = ring
                .iter()
                .fold(start, |(low, high), p| (low.min(*p), high.max(*p)));
            return Err(HeightFieldError::Hole {
                at: middle(&ring),
                width: (high - low).truncate().max_element(),
            });
        }
        outer.push(ring);
    }
    if outer.len() > 1 {
        let smallest = outer.iter().min_by(|a, b| area(a).total_cmp(&area(b)));
        return Err(HeightFieldError::Parts {
            parts: outer.len(),
            at: smallest.map_or([0.0; 2], |ring| middle(&ring[..1])),
        });
    }
    Ok(())
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
