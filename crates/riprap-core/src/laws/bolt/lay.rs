//! From what a bolt is made of, and where it passes through rock, to its chain.

use serde::{Deserialize, Serialize};

use super::{Bar, Chain, Hold, Toll};

/// Stiffness of a plate over that of the bar behind it, which then is 0.1 % softer than behind a rigid one. Deviation: the tie of a
/// rigid plate is a stiff spring, so that the plate can lift and give way.
const RIGID: f64 = 1e3;
/// A piece of grout below this share of the length of the pieces is none.
const SLIVER: f64 = 0.01;

/// What a bolt is made of. In the plane forces are per metre of thickness: those of one bolt over the spacing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Design {
    /// Axial stiffness EA, N.
    pub axial: f64,
    /// Force at which the bar yields, N; infinite for a bar that does not.
    pub yields: f64,
    /// Growth of that force with the plastic strain, N.
    pub hardening: f64,
    /// Plastic elongation at which the bar breaks, m; infinite for one that does not.
    pub breaks: f64,
    /// Stiffness of the grout, N/m for each metre of bolt.
    pub grout: f64,
    /// Largest force of the grout, N for each metre of bolt; infinite where it does not slip.
    pub bond: f64,
    /// Length from the toe that is grouted, m; infinite for all of it.
    pub grouted: f64,
    /// Largest force of the plate at the head, N; `None` without a plate.
    pub plate: Option<f64>,
    /// Force to which the bar is stretched when it is installed, N.
    pub pretension: f64,
    /// Shear stiffness (N/m) and largest shear force (N) where the bolt crosses a joint.
    pub dowel: Option<[f64; 2]>,
    /// Length of the pieces that get a node each, m.
    pub piece: f64,
}

impl Design {
    /// What a metre of thickness has of bolts at a spacing (m) out of the plane.
    #[must_use]
    pub fn per_spacing(self, spacing: f64) -> Self {
        Self {
            axial: self.axial / spacing,
            yields: self.yields / spacing,
            hardening: self.hardening / spacing,
            grout: self.grout / spacing,
            bond: self.bond / spacing,
            plate: self.plate.map(|capacity| capacity / spacing),
            pretension: self.pretension / spacing,
            dowel: self.dowel.map(|d| d.map(|x| x / spacing)),
            ..self
        }
    }
}

/// A bolt in the rock.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Laid {
    /// The chain.
    pub chain: Chain,
    /// Distance of each node from the head, m.
    pub along: Vec<f64>,
    /// The span that each node lies in.
    pub span: Vec<usize>,
    /// Joints that a dowel crosses: the bar across, and the distance from the head, m.
    pub joints: Vec<(usize, f64)>,
}

impl Laid {
    /// Stretches the bar to the pretension of its design, if it has one; gives what that has cost.
    #[must_use]
    pub fn tighten(&mut self, design: &Design) -> Toll {
        let mut toll = Toll::default();
        if design.pretension > 0.0 {
            let mut factors = self.chain.factors();
            toll.lost = self.chain.stretch(design.pretension, &mut factors).all();
        }
        toll
    }
}

/// Lays a bolt of a `length` (m) through spans of rock: from where to where each block holds it (m from the head), in order.
///
/// Nodes stand in the middle of equal pieces of grout, so that they lie on both sides of a joint and one bar crosses it; the plate is a node at the
/// head.
#[must_use]
pub fn lay(design: &Design, length: f64, spans: &[[f64; 2]]) -> Laid {
    let mut laid = Laid::default();
    let mut holds = Vec::new();
    if let (Some(capacity), Some(first)) = (design.plate, spans.first()) {
        // Its stiffness follows from the bar behind it, which is laid below.
        holds.push(Hold::plate(0.0, capacity));
        laid.along.push(first[0]);
        laid.span.push(0);
    }
    let collar = (length - design.grouted).max(0.0);
    for (span, &[from, to]) in spans.iter().enumerate() {
        let from = from.max(collar);
        if to - from < SLIVER * design.piece {
            continue;
        }
        let count = libm::round((to - from) / design.piece).max(1.0);
        let piece = (to - from) / count;
        for k in 0..count as usize {
            holds.push(Hold::grout(design.grout * piece, design.bond * piece));
            laid.along.push(from + (k as f64 + 0.5) * piece);
            laid.span.push(span);
        }
    }
    let bars: Vec<Bar> = laid.along.windows(2).map(|w| bar(design, w[1] - w[0])).collect();
    if let (Some(_), Some(first)) = (design.plate, bars.first()) {
        holds[0].stiffness = RIGID * first.stiffness;
    }
    if design.dowel.is_some() {
        for k in 0..bars.len() {
            let [a, b] = [laid.span[k], laid.span[k + 1]];
            // The bar behind a plate may run free of grout: nothing holds it across there.
            let held = k > 0 || design.plate.is_none();
            // A wider gap between blocks is a void, no joint.
            if b == a + 1 && held && spans[b][0] - spans[a][1] <= design.piece {
                laid.joints.push((k, 0.5 * (spans[a][1] + spans[b][0])));
            }
        }
    }
    laid.chain = Chain::new(holds, bars);
    laid
}

/// A piece of the bar of a length (m).
#[must_use]
pub fn bar(design: &Design, length: f64) -> Bar {
    Bar {
        stiffness: design.axial / length,
        yields: design.yields,
        hardening: design.hardening / length,
        breaks: design.breaks,
    }
}
