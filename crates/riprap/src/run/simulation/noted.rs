//! What a run goes through that its laws do not mean: found at the looks of the guard, noted where it was largest, reported at the end.

use super::cursor::{Noticed, Turned};
use super::{RunError, Simulation, cause};
use crate::plan::PhaseKind;
use crate::run::engine::{Drawn, View};
use crate::spatial::read::beyond::Strained;

/// Rotation from which on small kinematics is wrong by what is worth a word, rad: points move along the tangent of their circle and come to lie
/// `sqrt(1 + angle²)` times as far from the axis, half a per cent here.
const TURNED: f64 = 0.1;
/// Share of its length that a bolt may be drawn out by: more than any bar of steel bears (0.05 to 0.2 at rupture).
const DRAWN: f64 = 0.3;

/// Notes the larger one.
fn keep(noted: &mut Option<Noticed>, size: f64, words: impl FnOnce() -> String) {
    if size > noted.as_ref().map_or(0.0, |n| n.size) {
        let words = words();
        *noted = Some(Noticed { size, words });
    }
}

impl Simulation {
    /// Looks at what costs little.
    pub(super) fn note_motion(&mut self) {
        let (step, time) = (self.steps(), self.time());
        if let View::Spatial(v) = self.view()
            && v.world.deform.is_none()
        {
            self.note_turn();
        }
        let view = self.view();
        let drawn = view.most_drawn().filter(|d| d.by > DRAWN * d.length && d.force > 0.0);
        let drawn = drawn.filter(|d| !d.breaks);
        let noted = &mut self.cursor.noted;
        if let Some(found) = drawn {
            keep(&mut noted.drawn, found.by / found.length, || drawn_words(&found, step, time));
        }
    }

    /// Notes the block that has turned farthest for its kinematics.
    fn note_turn(&mut self) {
        let (step, time) = (self.steps(), self.time());
        let view = self.view();
        let Some((block, angle)) = view.spatial().and_then(|v| v.turned_most()) else {
            return;
        };
        let before = self.cursor.noted.turned.as_ref().map_or(TURNED, |t| t.angle);
        if angle > before {
            let block = view.name(block);
            self.cursor.noted.turned = Some(Turned { block, angle, step, time });
        }
    }

    /// Looks at what costs as much as some steps: strains and turns of deformable blocks. On the way to an equilibrium they mean nothing.
    ///
    /// # Errors
    /// A tetrahedron is inside out.
    pub(super) fn look_at_strain(&mut self, over: bool) -> Result<(), RunError> {
        let moves = self.view().spatial().is_some_and(|v| v.world.deform.is_some());
        if !moves || self.relaxes() && !over && !self.settled() {
            return Ok(());
        }
        self.note_turn();
        let (step, time) = (self.steps(), self.time());
        let view = self.view();
        let Some([smallest, most]) = view.spatial().and_then(|v| v.most_strained()) else {
            return Ok(());
        };
        if let Some(error) = self.inside_out(&smallest) {
            return Err(error);
        }
        let (size, block) = (most.beyond(), view.name(most.block));
        if size > 1.0 {
            keep(&mut self.cursor.noted.strained, size, || {
                strained_words(&most, &block, step, time)
            });
        }
        Ok(())
    }

    /// The error for a tetrahedron, the one that has least of its volume left, if it is inside out.
    fn inside_out(&self, smallest: &Strained) -> Option<RunError> {
        (smallest.volume <= 0.0).then(|| RunError::InsideOut {
            block: self.view().name(smallest.block),
            at: smallest.at.to_array(),
            volume: smallest.volume,
            ruled_out: cause::of_step(self),
            step: self.steps(),
            time: self.time(),
        })
    }

    /// The same where forces on a block are no numbers: one that is inside out may be why.
    pub(super) fn turned_inside_out(&self, block: u32) -> Option<RunError> {
        let view = self.view();
        let of = view.spatial().filter(|v| v.world.deforms(block as usize))?;
        let [smallest, _] = of.most_strained()?;
        self.inside_out(&smallest)
    }

    /// What dashpots of viscous faces carry over all forces in a static phase, and the condition whose faces carry most.
    pub(super) fn sinking(&self) -> Option<(f64, String)> {
        let quiet = self.phase().is_some_and(|p| p.kind == PhaseKind::Static);
        if !quiet || self.relaxes() {
            return None;
        }
        let view = self.view();
        let of = view.spatial()?;
        let (share, boundary) = of.sinking()?;
        let name = of.world.setup.boundaries[usize::from(boundary)].name.clone();
        Some((share, name))
    }

    /// What was noted, in words.
    pub(super) fn noted_words(&self) -> Vec<String> {
        let noted = &self.cursor.noted;
        let turned = noted.turned.as_ref().map(|t| {
            format!(
                "block `{}` rotated by {:.2} rad (step {}, t = {:.4e} s) under small-rotation kinematics, which moves its points along tangents: \
                 they lie {:.1} % too far from the axis, and rigid rotation strains or tears the model; use `space.spatial.kinematics = \
                 \"automatic\"` (for deformable blocks `strain = \"total_lagrangian\"`)",
                t.block,
                t.angle,
                t.step,
                t.time,
                100.0 * ((1.0 + t.angle * t.angle).sqrt() - 1.0),
            )
        });
        let others = [&noted.strained, &noted.drawn];
        let others = others.into_iter().flatten().map(|n| n.words.clone());
        turned.into_iter().chain(others).collect()
    }
}

fn drawn_words(drawn: &Drawn, step: u64, time: f64) -> String {
    format!(
        "bolt `{}` is {:.3e} m longer than when it was installed, {:.0} % of its length, and still carries {:.1e} N (step {step}, t = {time:.4e} s), \
         more than any bar can; give `steel.rupture`, the plastic elongation at rupture, or `grout.strength`, the pull-out strength",
        drawn.name,
        drawn.by,
        100.0 * drawn.by / drawn.length,
        drawn.force,
    )
}

fn strained_words(of: &Strained, block: &str, step: u64, time: f64) -> String {
    use crate::laws::tetrahedron::Strain;
    let [x, y, z] = of.at.to_array();
    let place =
        format!("block `{block}` at ({x:.3}, {y:.3}, {z:.3}) m (step {step}, t = {time:.4e} s)");
    match of.measure {
        Strain::Small => format!(
            "{place} was strained by {:.0} %, but its law is for small strain and wrong by about as much; check `young` and its unit, or use `strain \
             = \"total_lagrangian\"`",
            100.0 * of.strain
        ),
        Strain::Large => format!(
            "{place} was shortened by {:.0} % along one direction, where its law softens (from 42 % on it carries no more load); check `young` and \
             its unit, and the load",
            100.0 * of.shortening
        ),
    }
}
