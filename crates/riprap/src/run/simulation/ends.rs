//! What a run says of its phases when they are over, and of itself at its end.

use super::spent::{SLID, middle_size};
use super::{PhaseEnd, Simulation, Spent, Thrown, Unconverged};
use crate::ledger::{Balance, Unexplained};
use crate::plan::PhaseKind;
use crate::run::engine::{Movement, View};
use crate::run::{meeting, overruled, rough};

/// Share of the largest energy exchanged from which on what edits have added is reported.
const MADE: f64 = 0.05;

/// Share of the force up to which a bolt has yielded below which it bears clearly less.
const BORNE: f64 = 0.99;

/// Share of implicit steps with unsettled friction above which it is reported.
const UNSETTLED: f64 = 0.01;

/// Share of what a joint conducts that its shape leaves out above which it is reported.
const OBTUSE: f64 = 0.05;

impl Simulation {
    /// Whether the present phase, which is over, ends without equilibrium; noted once.
    pub fn note_unconverged(&mut self) -> Option<Unconverged> {
        let phase = self.phase()?;
        let rules = phase.deform?.relax?;
        let now = self.engine.relaxing()?;
        let over = !now.converged && now.iterations >= rules.iterations;
        let note = Unconverged {
            phase: phase.name.clone(),
            iterations: now.iterations,
            ratio: now.ratio,
            wanted: rules.tolerance,
        };
        over.then(|| {
            self.cursor.unconverged.push(note.clone());
            note
        })
    }

    /// Notes how the present phase, which is over, has ended.
    pub fn note_end(&mut self) -> Option<PhaseEnd> {
        let phase = self.phase()?;
        let (name, kind, wanted) = (phase.name.clone(), phase.kind, phase.until.unbalanced);
        let quiet = kind == PhaseKind::Static;
        let view = self.view();
        // Speeds of a relaxing phase are those of fictitious masses.
        let judged = quiet && !self.relaxes();
        let worst = quiet.then(|| view.least_balanced()).flatten();
        let ways = |elapsed: f64| {
            let ways = view.movements().into_iter();
            let ways = ways.map(|m| (m.block, m.speed * elapsed / m.size));
            ways.max_by(|a, b| a.1.total_cmp(&b.1))
        };
        let moving = judged.then(|| ways(self.elapsed())).flatten();
        let moving = moving.map(|(block, way)| (view.name(block), way));
        let thrown = quiet.then(|| Thrown::of(&view)).flatten();
        let end = PhaseEnd {
            phase: name,
            quiet,
            reason: self.reason?,
            unbalanced: view.unbalanced(),
            wanted,
            worst,
            moving,
            thrown,
            sinking: self.sinking(),
            rubbed: self.rubbed(),
        };
        self.cursor.ends.push(end.clone());
        let swung =
            if judged && !self.engine.is_implicit() { self.swung_bolt(&end.phase) } else { None };
        self.cursor.chosen.extend(swung);
        Some(end)
    }

    /// That a bolt has yielded by more than what it bears at rest asks for, in words: relaxation swings beyond its equilibrium.
    fn swung_bolt(&self, phase: &str) -> Option<String> {
        let (name, [force, borne]) = self.view().relieved_bolt()?;
        (force < BORNE * borne).then(|| {
            format!(
                "bolt `{name}` has yielded up to {borne:.4e} N and bears {force:.4e} N at the end of the static phase `{phase}`: where relaxation has \
                 swung beyond its equilibrium the bolt is too long; compare with `integration = \"implicit\"`, or let the weight come slowly \
                 (`gravity_ramp`)"
            )
        })
    }

    /// Share that friction has taken of what drives an implicit static phase, if it may have locked in forces.
    fn rubbed(&self) -> Option<f64> {
        let settles = self.phase().is_some_and(|phase| self.settles(phase));
        let spent =
            settles.then(|| Spent::of(&self.view().balance().works).since(self.cursor.spent))?;
        let movements = self.view().movements();
        let far = SLID * middle_size(&movements);
        let square = |m: &Movement| m.shift.iter().map(|x| x * x).sum::<f64>();
        let slid = movements.iter().any(|m| square(m) > far * far);
        (slid && spent.strays()).then(|| spent.rubbed())
    }

    /// What should be known of the run besides its results, in words: conditions that have lost faces to others, what cannot meet, phases that did not come to rest, an energy
    /// residual that is not small, given time steps that were made shorter, blocks pressed deep into each other, bolts whose forces did not come into
    /// equilibrium, rough joints pressed beyond the strength of their walls.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        let cursor = &self.cursor;
        let unconverged = cursor.unconverged.iter().map(ToString::to_string);
        let ends = (cursor.ends.iter())
            .flat_map(|end| end.warning().into_iter().chain(end.thrown()).chain(end.locked_in()));
        let residual = Unexplained::ALL.into_iter().zip(&cursor.unexplained);
        let residual = residual.filter(|(what, largest)| largest.share.abs() > self.noted(*what));
        let residual = residual.map(|(what, largest)| largest.told(what));
        let deepest = cursor.deepest.as_ref().map(ToString::to_string);
        let others = residual.chain(deepest);
        let given = overruled::words(&self.view()).into_iter();
        let given = given.chain(meeting::only_dashpots(&self.view()));
        let across = meeting::across_ends(&self.view());
        let off = given.chain(meeting::off(&self.view())).chain(across);
        let all = off.chain(unconverged).chain(ends).chain(others);
        let supports = self
            .left_terrain()
            .into_iter()
            .chain(self.unbalanced_bolt())
            .chain(self.obtuse_joint())
            .chain(self.made_by_edits())
            .chain(self.left_whole())
            .chain(self.shorter())
            .chain(cursor.chosen.iter().cloned())
            .chain(self.open_surfaces())
            .chain(self.unsettled_friction())
            .chain(self.by_levels())
            .chain(rough::crushed(&self.view()));
        let noted = self.noted_words().into_iter();
        let noted = noted.chain(meeting::idle_bolts(&self.view())).chain(self.missed_targets());
        all.chain(supports).chain(noted).collect()
    }

    /// Contacts in space of whose surface a part may be missing, in words.
    fn open_surfaces(&self) -> Option<String> {
        let view = self.view();
        open_surfaces(view.spatial()?.world.found.unlabelled)
    }

    /// Implicit steps whose limits of friction did not come to rest, if there are more than a few, in words.
    fn unsettled_friction(&self) -> Option<String> {
        let [unsettled, all] = self.view().spatial()?.world.found.unsettled;
        (unsettled as f64 > UNSETTLED * all as f64).then(|| {
            format!(
                "in {unsettled} of {all} implicit steps the pressure that limits friction still changed by more than 2 % in the last of four solutions: \
                 forces of blocks that slide or wedge may depend on the time step; repeat the run with half the step and compare"
            )
        })
    }

    /// What steps by level have spared, in words.
    fn by_levels(&self) -> Option<String> {
        let levels = self.view().spatial()?.world.found.levels.as_ref()?;
        let share = 100.0 * levels.evaluated as f64 / levels.touching.max(1) as f64;
        Some(format!(
            "steps by level: contacts were evaluated {share:.0} % as often as at one level"
        ))
    }

    /// Energy that edits of a model in space have added, if it is not small, in words.
    fn made_by_edits(&self) -> Option<String> {
        match self.view() {
            View::Spatial(_) => made_by_edits(&self.view().balance()),
            View::Planar(_) => None,
        }
    }

    /// Deformable blocks that should be cut and cannot, in words.
    fn left_whole(&self) -> Option<String> {
        let left = crate::spatial::topology::cut::crooked(&self.view().spatial()?);
        (left > 0).then(|| {
            format!(
                "{left} blocks meet the cutting criterion but stay whole: an earlier cut left their faces non-planar, and cutting them would change \
                 the mass; a smaller `snap` leaves fewer such blocks"
            )
        })
    }

    /// The joint in space that water seeps through least exactly, in words.
    fn obtuse_joint(&self) -> Option<String> {
        let View::Spatial(v) = self.view() else {
            return None;
        };
        let (lost, blocks) = v.world.seepage.as_ref()?.lost;
        let [a, b] = blocks.map(|b| self.view().name(b));
        (lost > OBTUSE).then(|| {
            format!(
                "the joint between `{a}` and `{b}` is so obtuse that {:.0} % of the conductance between the segments of its rim would be negative; \
                 this part is left out, and seepage through the joint is wrong by about as much",
                100.0 * lost
            )
        })
    }

    /// The bolt whose equilibrium was missed by most, in words.
    fn unbalanced_bolt(&self) -> Option<String> {
        let view = self.view();
        let (name, left) = view.unbalanced_bolt()?;
        Some(format!(
            "the forces along bolt `{name}` did not reach equilibrium in some step: {left:.1e} of its largest force remained unbalanced; a smaller \
             `safety` moves the rock less per step"
        ))
    }

    /// Blocks that have gone over the rim of the terrain, in words.
    fn left_terrain(&self) -> Option<String> {
        let view = self.view();
        let left = view.spatial()?.left_terrain();
        let first = *left.first()?;
        let name = view.name(first);
        Some(match left.len() {
            1 => format!("block `{name}` has left the terrain over its rim and falls without end"),
            n => format!(
                "{n} blocks have left the terrain over its rim and fall without end; the first by number is `{name}`"
            ),
        })
    }
}

/// Edges of contacts that no plane has made, in words.
fn open_surfaces(edges: u64) -> Option<String> {
    (edges > 0).then(|| {
        format!(
            "{edges} edges of contact polygons belong to no face of either block: part of a contact surface may be missing and its force too small. \
             This is a fault in riprap, not in the scene; please report it"
        )
    })
}

/// Energy that edits have added, if it is not small, in words.
fn made_by_edits(balance: &Balance) -> Option<String> {
    let (made, scale) = (balance.works.edit_defect, balance.scale());
    (made > MADE * scale).then(|| {
        format!(
            "edits of the model have added {made:.3e} J, {:.0} % of the largest energy exchanged (`energy.edit_defect`), by joints released to \
             contact, splits, cuts or changes of laws; this energy drives the later motion",
            100.0 * made / scale
        )
    })
}

#[cfg(test)]
mod tests {
    use super::{Balance, made_by_edits, open_surfaces};

    #[test]
    fn energy_that_edits_have_added_is_told_when_it_is_not_small() {
        let mut balance = Balance { kinetic: 4e6, start: 1e6, ..Balance::default() };
        // Nothing moved is no reason, nor is what edits have taken.
        assert_eq!(made_by_edits(&Balance::default()), None);
        for quiet in [0.0, -3e6, 1.9e5] {
            balance.works.edit_defect = quiet;
            assert_eq!(made_by_edits(&balance), None, "{quiet}");
        }
        balance.works.edit_defect = 3e5;
        let said = made_by_edits(&balance).expect("a warning");
        assert!(said.contains("3.000e5 J, 8 % of"), "{said}");
    }

    #[test]
    fn contacts_with_an_edge_that_no_face_has_made_are_told() {
        assert_eq!(open_surfaces(0), None);
        let said = open_surfaces(2).expect("a warning");
        assert!(said.starts_with("2 edges of contact polygons"), "{said}");
    }
}
