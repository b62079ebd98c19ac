//! Nodes that are held or driven.

use riprap_geom::{Mat3, Vec3};
use serde::{Deserialize, Serialize};

use crate::dynamics::TimeFunction;

/// Directions whose cosine differs from 1 by less than this are the same.
const SAME: f64 = 1e-9;

/// A node whose motion is prescribed in some directions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Hold {
    /// The node.
    pub node: u32,
    /// Takes the free part of a vector: `1 - sum e e^T`.
    pub free: Mat3,
    /// What is prescribed; at most three, independent.
    along: Vec<Along>,
}

/// Prescribed velocity along a unit direction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Along {
    direction: Vec3,
    /// m/s; `None` is held.
    velocity: Option<TimeFunction>,
    /// Account of the condition that prescribes it, if any.
    account: Option<u16>,
    /// The direction less its parts along the earlier bases, normalised.
    basis: Vec3,
}

impl Hold {
    /// A node that is still free.
    #[must_use]
    pub fn new(node: u32) -> Self {
        Self { node, free: Mat3::IDENTITY, along: Vec::new() }
    }

    /// Prescribes the velocity along a unit direction for the condition on an account; an earlier one along the same line is
    /// replaced, one that follows from earlier ones changes nothing.
    pub fn add(&mut self, direction: Vec3, velocity: Option<TimeFunction>, account: Option<u16>) {
        let same = |a: &&mut Along| a.direction.dot(direction).abs() > 1.0 - SAME;
        if let Some(same) = self.along.iter_mut().find(same) {
            if same.direction.dot(direction) < 0.0 {
                same.basis = -same.basis;
            }
            same.direction = direction;
            same.velocity = velocity;
            same.account = account;
            return;
        }
        let mut rest = direction;
        for a in &self.along {
            rest -= a.basis.dot(rest) * a.basis;
        }
        if rest.length() < SAME {
            return;
        }
        let basis = rest.normalize();
        self.free -= Mat3::from_cols(basis.x * basis, basis.y * basis, basis.z * basis);
        self.along.push(Along { direction, velocity, account, basis });
    }

    /// Whether nothing is prescribed.
    #[must_use]
    pub fn is_free(&self) -> bool {
        self.along.is_empty()
    }

    /// Velocities that are prescribed as functions of time and place, each with the account of its condition.
    pub fn prescribed(&self) -> impl Iterator<Item = (&TimeFunction, Option<u16>)> {
        let along = self.along.iter();
        along.filter_map(|a| Some((a.velocity.as_ref()?, a.account)))
    }

    /// Whether it drives the node on any account: what holds still does no work.
    #[must_use]
    pub fn drives(&self) -> bool {
        let still = |f: &TimeFunction| matches!(f, TimeFunction::Constant(0.0));
        let drives = |a: &Along| a.velocity.as_ref().is_some_and(|f| !still(f));
        self.along.iter().any(|a| drives(a) && a.account.is_some())
    }

    /// Parts of what holds the node, a vector along the prescribed directions, with the accounts of their conditions: each
    /// along its direction; what is left goes to the first.
    pub fn parts(&self, vector: Vec3) -> impl Iterator<Item = (Option<u16>, Vec3)> {
        let mut rest = vector;
        let mut parts = [Vec3::ZERO; 3];
        // Bases of later directions are across the earlier ones.
        for (part, a) in parts.iter_mut().zip(&self.along).rev() {
            *part = rest.dot(a.basis) / a.direction.dot(a.basis) * a.direction;
            rest -= *part;
        }
        parts[0] += rest;
        (self.along.iter().map(|a| a.account)).zip(parts)
    }

    /// Prescribed velocity at time `t` of the node that was at `place` (m, global) at the start, m/s: the shortest with the
    /// prescribed parts.
    #[must_use]
    pub fn velocity(&self, t: f64, place: Vec3) -> Vec3 {
        let mut v = Vec3::ZERO;
        for a in &self.along {
            let wanted = a.velocity.as_ref().map_or(0.0, |f| f.at_place(t, place.to_array()));
            v += (wanted - a.direction.dot(v)) / a.direction.dot(a.basis) * a.basis;
        }
        v
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_directions_go_together() {
        let two = || Some(TimeFunction::Constant(2.0));
        let mut hold = Hold::new(3);
        hold.add(Vec3::X, None, None);
        hold.add(Vec3::new(0.6, 0.8, 0.0), two(), None);
        let v = hold.free * Vec3::new(1.0, 2.0, 3.0);
        assert!((v - Vec3::new(0.0, 0.0, 3.0)).length() < 1e-15);
        let now = |hold: &Hold| hold.velocity(0.0, Vec3::ZERO);
        let v = now(&hold);
        assert!(v.x.abs() < 1e-15 && (Vec3::new(0.6, 0.8, 0.0).dot(v) - 2.0).abs() < 1e-15);
        // Follows from the two.
        hold.add(Vec3::Y, None, None);
        assert_eq!(now(&hold), v);
        hold.add(-Vec3::X, two(), None);
        assert!((now(&hold).x + 2.0).abs() < 1e-15);
        hold.add(-Vec3::Z, two(), None);
        assert!((now(&hold).z + 2.0).abs() < 1e-15);
        assert!((hold.free * Vec3::ONE).length() < 1e-15 && !hold.is_free());
    }
    #[test]
    fn each_direction_has_its_own_part() {
        let mut hold = Hold::new(3);
        hold.add(Vec3::X, None, Some(4));
        let tilted = Vec3::new(0.6, 0.8, 0.0);
        hold.add(tilted, Some(TimeFunction::Constant(1.0)), Some(7));
        assert!(hold.drives());
        let parts: Vec<_> = hold.parts(Vec3::new(5.0, 4.0, 0.0)).collect();
        assert_eq!((parts[0].0, parts[1].0), (Some(4), Some(7)));
        assert!((parts[0].1 - 2.0 * Vec3::X).length() < 1e-14, "{parts:?}");
        assert!((parts[1].1 - 5.0 * tilted).length() < 1e-14, "{parts:?}");
    }
}
