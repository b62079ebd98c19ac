//! Cutting a convex solid by a plane.
//!
//! Vertices near the plane are taken to lie on it, so that cuts through vertices, edges and faces leave no slivers.
//! Which faces remain follows from these signs alone; the new face closes the edges that are left open. Both
//! sides of a cut get the same new vertices, bit for bit.

use std::collections::BTreeMap;

use super::hull::compact;
use super::{Polyhedron, SolidError, ZERO_VOLUME, edges_of};
use crate::Vec3;
use crate::tol::SNAP;

/// What a half space leaves of a solid.
#[derive(Clone, Debug, PartialEq)]
pub enum Sliced {
    /// All of it.
    Whole,
    /// Nothing (at most a face, an edge or a corner in the plane).
    Nothing,
    /// A part; its last face lies in the plane.
    Part(Polyhedron),
}

/// The part of a convex solid where `normal . x <= offset` (unit normal; m).
#[must_use]
pub fn slice(solid: &Polyhedron, normal: Vec3, offset: f64) -> Sliced {
    let tolerance = SNAP * solid.size();
    let heights: Vec<f64> = solid
        .vertices
        .iter()
        .map(|v| {
            let height = normal.dot(*v) - offset;
            if height.abs() <= tolerance { 0.0 } else { height }
        })
        .collect();
    if heights.iter().all(|h| *h <= 0.0) {
        return Sliced::Whole;
    }
    if heights.iter().all(|h| *h >= 0.0) {
        return Sliced::Nothing;
    }
    let mut vertices = solid.vertices.clone();
    let mut crossings: BTreeMap<(u32, u32), u32> = BTreeMap::new();
    let mut crossing = |from: u32, to: u32| {
        // Both faces of an edge ask, from either end, and must find the same bits.
        let (a, b) = (from.min(to), from.max(to));
        *crossings.entry((a, b)).or_insert_with(|| {
            let (p, q) = (solid.vertices[a as usize], solid.vertices[b as usize]);
            let (s, t) = (heights[a as usize], heights[b as usize]);
            vertices.push(p + (s / (s - t)) * (q - p));
            vertices.len() as u32 - 1
        })
    };
    let mut faces: Vec<Vec<u32>> = Vec::new();
    for corners in &solid.faces {
        let height = |v: u32| heights[v as usize];
        // A face that lies in the plane goes too: the new face stands for it.
        if corners.iter().all(|&v| height(v) >= 0.0) {
            continue;
        }
        let mut kept = Vec::with_capacity(corners.len() + 1);
        for (from, to) in edges_of(corners) {
            if height(from) <= 0.0 {
                kept.push(from);
            }
            if height(from) * height(to) < 0.0 {
                kept.push(crossing(from, to));
            }
        }
        faces.push(kept);
    }
    match cap(&faces) {
        Some(face) => {
            faces.push(face);
            let part = compact(&vertices, faces);
            let size = solid.size();
            if part.moments().volume < ZERO_VOLUME * (size * size * size) {
                return Sliced::Nothing;
            }
            Sliced::Part(part)
        }
        // The open edges make no ring: what is left is thinner than the tolerance.
        None => Sliced::Nothing,
    }
}

/// The face that closes the open edges of a surface, if they make one ring.
fn cap(faces: &[Vec<u32>]) -> Option<Vec<u32>> {
    let mut edges: BTreeMap<(u32, u32), ()> = BTreeMap::new();
    for face in faces {
        edges.extend(edges_of(face).map(|edge| (edge, ())));
    }
    let mut next: BTreeMap<u32, u32> = BTreeMap::new();
    for &(from, to) in edges.keys() {
        if !edges.contains_key(&(to, from)) && next.insert(to, from).is_some() {
            return None;
        }
    }
    let (&start, _) = next.iter().next()?;
    let mut ring = vec![start];
    let mut at = *next.get(&start)?;
    while at != start {
        if ring.len() > next.len() {
            return None;
        }
        ring.push(at);
        at = *next.get(&at)?;
    }
    (ring.len() == next.len() && ring.len() >= 3).then_some(ring)
}

/// The solid that all half spaces `normal . x <= offset` (normal of any length) have in common; `reach` (m) bounds how
/// far it may extend from the origin.
///
/// # Errors
/// Nothing in common, or something that reaches farther than `reach`.
pub fn from_half_spaces(planes: &[(Vec3, f64)], reach: f64) -> Result<Polyhedron, SolidError> {
    // Farther than is allowed, so that what has no bounds is found out.
    let far = 2.0 * reach;
    let mut solid = Polyhedron::brick(Vec3::ZERO, Vec3::splat(far));
    for (plane, &(normal, offset)) in planes.iter().enumerate() {
        let length = normal.length();
        match slice(&solid, normal / length, offset / length) {
            Sliced::Whole => {}
            Sliced::Nothing => return Err(SolidError::Nothing { plane }),
            Sliced::Part(part) => solid = part,
        }
    }
    let limit = solid.vertices.iter().map(|v| v.abs().max_element());
    if limit.fold(0.0, f64::max) > reach {
        return Err(SolidError::Unbounded { reach });
    }
    Ok(solid)
}
