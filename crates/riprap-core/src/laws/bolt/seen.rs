//! What a chain shows: forces, slip, states of its bars.

use super::{Chain, Design};

/// State of a bar of a bolt.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BarState {
    /// Nothing has given way.
    Elastic,
    /// The bar has yielded.
    Yielded,
    /// The grout at one of its ends has slipped.
    Slipped,
    /// The bar has broken.
    Broken,
}

impl BarState {
    /// As a number in outputs.
    #[must_use]
    pub fn number(self) -> u8 {
        match self {
            Self::Elastic => 0,
            Self::Yielded => 1,
            Self::Slipped => 2,
            Self::Broken => 3,
        }
    }

    /// As a word in tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Elastic => "elastic",
            Self::Yielded => "yielded",
            Self::Slipped => "slipped",
            Self::Broken => "broken",
        }
    }
}

/// The largest of a number over bolts, at least `least`; not a number where there are none.
#[must_use]
pub fn largest(over: impl Iterator<Item = f64>, least: f64) -> f64 {
    let mut over = over.peekable();
    if over.peek().is_none() {
        return f64::NAN;
    }
    over.fold(least, f64::max)
}

impl Chain {
    /// Larger slip of the grout at the ends of bar `k`, m.
    #[must_use]
    pub fn slip_at(&self, k: usize) -> f64 {
        let grout = [k, k + 1].into_iter().filter(|n| !self.holds[*n].lifts);
        grout.map(|n| self.slip[n].abs()).fold(0.0, f64::max)
    }

    /// State of bar `k`.
    #[must_use]
    pub fn state(&self, k: usize) -> BarState {
        if self.bars[k].stiffness == 0.0 {
            BarState::Broken
        } else if self.plastic[k] != 0.0 {
            BarState::Yielded
        } else if self.slip_at(k) > 0.0 {
            BarState::Slipped
        } else {
            BarState::Elastic
        }
    }

    /// Largest axial force, N; minus infinity without a bar.
    #[must_use]
    pub fn largest_force(&self) -> f64 {
        self.force.iter().copied().fold(f64::NEG_INFINITY, f64::max)
    }

    /// Force of the plate, N; not a number without one.
    #[must_use]
    pub fn plate_force(&self, design: &Design) -> f64 {
        let has_one = self.holds.first().is_some_and(|hold| hold.lifts);
        if design.plate.is_some() && has_one { self.held(0) } else { f64::NAN }
    }

    /// Largest slip of the grout, m.
    #[must_use]
    pub fn largest_slip(&self) -> f64 {
        let nodes = self.holds.iter().zip(&self.slip);
        let grout = nodes.filter(|(hold, _)| !hold.lifts);
        grout.map(|(_, slip)| slip.abs()).fold(0.0, f64::max)
    }

    /// Largest plastic elongation of a bar, m.
    #[must_use]
    pub fn largest_yield(&self) -> f64 {
        self.plastic.iter().map(|p| p.abs()).fold(0.0, f64::max)
    }

    /// Largest axial force over that at which the bar yields.
    #[must_use]
    pub fn utilisation(&self, design: &Design) -> f64 {
        let shares = self.force.iter().map(|n| n.abs() / design.yields);
        shares.fold(0.0, f64::max)
    }
}
