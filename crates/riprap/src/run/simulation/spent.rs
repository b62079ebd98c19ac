//! What forces have done in a phase: whether long steps may have driven blocks into each other.

use serde::{Deserialize, Serialize};

use crate::ledger::Works;
use crate::run::engine::Movement;

/// Share of the work of weight, loads and supports that friction has taken beyond which Newton's method may have driven a wedge: blocks have slid in its long steps,
/// and friction then locks in more than the weight asks for.
const RUBBED: f64 = 0.02;

/// Way of a block over the size of the middle one beyond which blocks have slid by more than their springs give.
pub(crate) const SLID: f64 = 5e-5;

/// Size of the middle one of the blocks, m.
#[must_use]
pub(crate) fn middle_size(movements: &[Movement]) -> f64 {
    let mut sizes: Vec<f64> = movements.iter().map(|m| m.size).collect();
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied().unwrap_or(0.0)
}

/// What forces have done, J.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Spent {
    friction: f64,
    gravity: f64,
    loads: f64,
    supports: f64,
}

impl Spent {
    /// Of all works so far.
    #[must_use]
    pub fn of(works: &Works) -> Self {
        Self {
            friction: works.friction,
            gravity: works.gravity,
            loads: works.loads,
            supports: works.supports,
        }
    }

    /// After an earlier state.
    #[must_use]
    pub fn since(self, from: Self) -> Self {
        Self {
            friction: self.friction - from.friction,
            gravity: self.gravity - from.gravity,
            loads: self.loads - from.loads,
            supports: self.supports - from.supports,
        }
    }

    /// Friction over the work of what drives the model by itself.
    #[must_use]
    pub fn rubbed(self) -> f64 {
        let driven = self.gravity.abs() + self.loads.abs() + self.supports.abs();
        if driven > 0.0 { self.friction / driven } else { 0.0 }
    }

    /// Whether blocks have slid by what weight and loads have done. What supports drive slides as it is told.
    #[must_use]
    pub fn strays(self) -> bool {
        self.rubbed() > RUBBED && self.supports.abs() < 0.5 * self.friction
    }
}

#[cfg(all(test, feature = "scenario"))]
mod tests {
    use super::*;
    use crate::run::simulation::Simulation;

    /// A key between two blocks on a floor, which it drives apart below 17.09 deg: `tan(20 deg + phi)` is the thrust of its flanks, and half its weight and theirs on the
    /// floor holds them.
    fn key(angle: &str, phase: &str) -> Vec<String> {
        let side = |name: &str, sign: f64| {
            let corner =
                |x: f64, y: f64, z: f64| format!("[\"{} m\", \"{y} m\", \"{z} m\"]", sign * x);
            let ends = [-0.5, 0.5].map(|y| {
                [(0.227205953147, 0.0), (2.0, 0.0), (2.0, 1.0), (0.591176187413, 1.0)]
                    .map(|(x, z)| corner(x, y, z))
                    .join(", ")
            });
            format!(
                "[[blocks]]\nname = \"{name}\"\nmaterial = \"rock\"\npolyhedron.vertices = [{}]\n",
                ends.join(", ")
            )
        };
        let (left, right) = (side("left", -1.0), side("right", 1.0));
        let scene = format!(
            r#"
            riprap = 1
            title = "a key drives two blocks apart"
            [space.spatial]
            gravity = "9.81 m/s2"
            [materials.rock]
            density = "2600 kg/m3"
            young = "30 GPa"
            poisson = 0.25
            [interfaces.default]
            normal_stiffness = "100 GPa/m"
            shear_stiffness = "100 GPa/m"
            friction_angle = "{angle}"
            [[blocks]]
            name = "floor"
            material = "rock"
            brick = {{ size = ["8 m", "2 m", "0.5 m"], corner = ["-4 m", "-1 m", "-0.5 m"] }}
            [[blocks]]
            name = "key"
            material = "rock"
            polyhedron.vertices = [
                ["-0.3 m", "-0.5 m", "0.2 m"], ["0.3 m", "-0.5 m", "0.2 m"],
                ["0.663970234266 m", "-0.5 m", "1.2 m"], ["-0.663970234266 m", "-0.5 m", "1.2 m"],
                ["-0.3 m", "0.5 m", "0.2 m"], ["0.3 m", "0.5 m", "0.2 m"],
                ["0.663970234266 m", "0.5 m", "1.2 m"], ["-0.663970234266 m", "0.5 m", "1.2 m"],
            ]
            {left}
            {right}
            [[supports]]
            on.block = "floor"
            fixed = {{}}
            [[phases]]
            name = "load"
            {phase}
            "#
        );
        let mut run = Simulation::from_toml(&scene).unwrap();
        run.run().unwrap();
        run.warnings()
    }

    #[test]
    fn a_key_that_long_steps_wedge_is_reported() {
        let implicit = "kind = \"static\"\nintegration = \"implicit\"\nuntil = { unbalanced = 1e-6, steps = 300 }";
        let locked = |warnings: &[String]| warnings.iter().any(|w| w.contains("friction took"));
        assert!(locked(&key("15 deg", implicit)));
        // It stands, with slips of the springs.
        for angle in ["20 deg", "30 deg", "45 deg"] {
            assert!(!locked(&key(angle, implicit)), "{angle}");
        }
        // A dynamic phase says what it is.
        let moves = "integration = \"implicit\"\nuntil.time = \"0.1 s\"";
        assert!(!locked(&key("15 deg", moves)));
    }

    #[test]
    fn what_supports_drive_slides_as_it_is_told() {
        let driven = Spent { friction: 9.0, supports: 10.0, ..Spent::default() };
        assert!(driven.rubbed() > 0.5 && !driven.strays());
        let pulled = Spent { friction: 9.0, loads: 10.0, ..Spent::default() };
        assert!(pulled.strays() && !Spent::default().strays());
    }
}
