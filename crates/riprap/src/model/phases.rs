//! Phases and outputs.

use super::builder::Builder;
use super::fields::Said as Place;
use super::interfaces::change_contact;
use super::solid::change_joint;
use crate::laws::fracture::Margins;
use crate::plan::{
    Cutting, Damping, Deforming, Every, Gauge, History, Phase, PhaseKind, Relaxation, Relaxing,
    TimeStep, Until,
};
use crate::plan::{IMPLICIT_STEP, Integration, Rest, STATIC_STEP};
use crate::planar::setup::ContactLaw;
use crate::record::frame::Content;
use crate::scenario::language::{self, CutAxis, Output, Pictures, Reset};
use crate::scenario::read::{Given, Provenance, with_unit};
use crate::scenario::vectors::InSpace;
use crate::scenario::{Diagnostic, Name, Quantity, Span};
use crate::spatial::setup::JointLaw;
use riprap_geom::Vec3;

/// Ratio of net to external forces at which a relaxing phase without `until.unbalanced` is converged.
const RELAXED: f64 = 1e-6;

/// Laws by their rows of the table.
type Rows<T> = Vec<(u16, T)>;

impl Builder<'_> {
    pub(super) fn phases(&mut self) {
        // Changes stay until a later phase makes others.
        let mut laws = Laws {
            contacts: self.setup.interfaces.iter().map(|i| i.contact).collect(),
            joints: self.spatial.interfaces.iter().map(|i| i.joint).collect(),
        };
        for (number, said) in self.parsed.scenario.phases.iter().enumerate() {
            let mut phase = self.phase(said, &mut laws);
            phase.install = self.installs(&said.name, number == 0);
            self.plan.phases.push(phase);
        }
        let total: Option<f64> = self.plan.phases.iter().map(|p| p.until.time).sum();
        self.summary.duration = total;
    }

    fn phase(&mut self, said: &language::Phase, laws: &mut Laws) -> Phase {
        let mut read = self.reading(format!("phases.{}", said.name), said);
        let kind = read.kind();
        let integration = read.integration();
        let time_step = match read.time_step() {
            Some(dt) => TimeStep::Given { dt },
            None if integration == Integration::Implicit => {
                let dt = if kind == PhaseKind::Static { STATIC_STEP } else { IMPLICIT_STEP };
                let text = format!("{} or less", with_unit(dt, "s"));
                read.note("time_step", text, Provenance::Default, "");
                TimeStep::Given { dt }
            }
            None => {
                let safety = read.safety();
                let text = format!("{} of the stable step", with_unit(safety, ""));
                read.note("time_step", text, Provenance::Default, "");
                TimeStep::Auto { safety }
            }
        };
        let max_residual = read.max_residual();
        let stepped = integration == Integration::Explicit && kind != PhaseKind::Static;
        // Elsewhere the key is reported as without effect.
        let levels = if stepped { read.levels() } else { 0 };
        if integration == Integration::Implicit {
            self.refuse_implicit(said);
        }
        if levels > 0 {
            self.refuse_levels(said);
        }
        let mut read = self.reading(format!("phases.{}", said.name), said);
        let none = language::Damping::default();
        let mut read = read.within("damping", said.damping.as_ref().unwrap_or(&none));
        let damping = Damping {
            mass: read.mass(),
            rotation: read.rotation(),
            stiffness: read.stiffness(),
            local: read.local(),
        };
        let (contacts, joints) = self.changed_laws(said, laws);
        let [remove, fix, release] = [&said.remove, &said.fix, &said.release].map(|names| {
            let blocks = self.directory.all(names);
            self.take(blocks).unwrap_or_default()
        });
        self.refuse_released_terrain(&said.release);
        Phase {
            name: said.name.text.clone(),
            kind,
            until: Until {
                time: said.until.time.as_ref().map(Quantity::si),
                unbalanced: said.until.unbalanced.as_ref().map(Quantity::si),
                kinetic: said.until.kinetic.as_ref().map(Quantity::si),
                rest: said.until.rest.as_ref().map(|rest| {
                    let mut read = self.reading(format!("phases.{}.until.rest", said.name), rest);
                    Rest { share: read.share(), speed: read.speed(), hold: read.hold() }
                }),
                steps: said.until.steps,
            },
            integration,
            time_step,
            step_error: said.step_error.as_ref().map(Quantity::si),
            levels: levels as u8,
            damping,
            remove,
            removal_ramp: self.removal_ramp(said),
            leavers: self.leavers(said),
            fix,
            release,
            install: Vec::new(),
            gravity: said.gravity.as_ref().map(|g| self.gravity(g)),
            gravity_ramp: said.gravity_ramp.as_ref().map(Quantity::si).filter(|&t| t > 0.0),
            water: self.table_of(said),
            contacts,
            joints,
            reduction: None,
            zero_velocities: said.reset.contains(&Reset::Velocities),
            zero_displacements: said.reset.contains(&Reset::Displacements),
            deform: self.deforming(said),
            max_residual,
        }
    }

    /// The laws that a phase changes, with their rows of the table.
    fn changed_laws(
        &mut self,
        said: &language::Phase,
        laws: &mut Laws,
    ) -> (Rows<ContactLaw>, Rows<JointLaw>) {
        let (mut contacts, mut joints) = (Vec::new(), Vec::new());
        for (name, change) in said.interfaces.iter() {
            let mut names = self.parsed.scenario.interfaces.names();
            // Unknown interfaces are reported by the rules of the language.
            let Some(row) = names.position(|one| one == name.as_str()) else {
                continue;
            };
            if let Some(law) = laws.contacts.get_mut(row) {
                change_contact(law, change);
                contacts.push((row as u16, *law));
            }
            let Some(law) = laws.joints.get_mut(row) else {
                continue;
            };
            change_joint(law, change);
            joints.push((row as u16, *law));
            if let Some(strength) = law.strength.filter(|s| s.dilation > s.dilating()) {
                let least = libm::atan(strength.dilating()).to_degrees();
                let message = format!(
                    "phase `{}` lowers the friction of interfaces.{name} below its dilation angle: its dilation angle is limited to {least:.4} \
                     deg from then on",
                    said.name
                );
                let help = "sliding with more dilation than friction would create energy";
                self.warn_at("phase.dilation", name.span.clone(), message, help);
            }
        }
        (contacts, joints)
    }

    fn refuse_released_terrain(&mut self, release: &[Name]) {
        for name in release {
            let blocks = self.directory.all(std::slice::from_ref(name));
            let terrain = |b: &u32| {
                let block = self.spatial.blocks.get(*b as usize);
                block.is_some_and(|block| block.shape.is_terrain())
            };
            if blocks.is_ok_and(|blocks| blocks.iter().any(terrain)) {
                let message = format!("`{name}` is terrain, which cannot move");
                self.error_at("terrain.release", name, message, "leave it out");
            }
        }
    }

    /// Reports what an implicit phase does not take of its own keys.
    fn refuse_implicit(&mut self, said: &language::Phase) {
        let name = &said.name;
        let mut refuse = |message: String, help: &str| {
            let error = Diagnostic::error("phase.integration", message).at(name.span.clone());
            self.found.push(error.help(help));
        };
        let local = said.damping.as_ref().and_then(|damping| damping.local.as_ref());
        if local.is_some_and(|local| local.si() > 0.0) {
            let message = format!(
                "phase `{name}` is implicit and has local damping, which needs explicit steps"
            );
            refuse(message, "leave out `damping.local`; `damping.mass` works in both");
        }
    }

    /// Reports what steps by level do not go with.
    fn refuse_levels(&mut self, said: &language::Phase) {
        let at = said.name.span.clone();
        let local = said.damping.as_ref().and_then(|damping| damping.local.as_ref());
        let reasons = [
            (
                !self.spatial.deform.sets.is_empty(),
                "deformable blocks, whose nodes move at each step",
                "leave out `levels`; it is for rigid blocks",
            ),
            (
                !self.parsed.scenario.bolts.is_empty(),
                "bolts, whose stiffness no level knows",
                "leave out `levels`",
            ),
            (
                !self.parsed.scenario.water.is_empty(),
                "water, whose stiffness no level knows",
                "leave out `levels`",
            ),
            (
                self.spatial.interfaces.iter().any(|row| row.joint.stiffening > 0.0),
                "contacts that stiffen (`stiffening_depth`), whose stiffness changes between their looks",
                "leave out `levels`",
            ),
            (
                local.is_some_and(|local| local.si() > 0.0),
                "local damping, a share of the force at each step: contacts of higher levels act once in several steps",
                "use `damping.mass`, or leave out `levels`",
            ),
        ];
        for (_, what, help) in reasons.into_iter().filter(|(there, ..)| *there) {
            let message = format!("phase `{}` steps by levels and has {what}", said.name);
            self.error_at("phase.levels", at.clone(), message, help);
        }
        if !self.spatial.found_contacts {
            let message = format!(
                "`levels` of phase `{}` has no effect: blocks of this model are not watched for contact, and joints are found at each step",
                said.name
            );
            self.error_at("phase.levels", at, message, "leave it out");
        }
    }

    /// Time over which the forces of removed blocks fade, s. It must pass: where blocks relax, it does in load steps.
    fn removal_ramp(&mut self, said: &language::Phase) -> Option<f64> {
        let ramp = said.removal_ramp.as_ref().filter(|ramp| ramp.si() > 0.0)?;
        let deforms = !self.spatial.deform.sets.is_empty() && self.all_free_deform(said);
        let relaxes = deforms && said.kind == Some(PhaseKind::Static);
        if relaxes && said.until.time.is_none() {
            let message = format!(
                "phase `{}` has no duration; the removed blocks cannot fade out",
                said.name
            );
            let help = "give `until.time`, as long as `removal_ramp`, and `load_steps`";
            self.error_at("key.missing", ramp.span.clone(), message, help);
        }
        Some(ramp.si())
    }

    /// Rules for deformable blocks. A static phase relaxes them with fictitious masses if no rigid block is free.
    fn deforming(&mut self, said: &language::Phase) -> Option<Deforming> {
        if self.spatial.deform.sets.is_empty() {
            return None;
        }
        let all_deform = self.all_free_deform(said);
        let mut read = self.reading(format!("phases.{}", said.name), said);
        let breaking = read.breaking();
        let relaxes = said.kind == Some(PhaseKind::Static) && all_deform;
        let relax = relaxes.then(|| Relaxing {
            tolerance: said.until.unbalanced.si_or(RELAXED),
            load_steps: read.load_steps(),
            iterations: read.iterations(),
            relaxation: said.relaxation.as_ref().map_or(Relaxation::default(), way),
        });
        let cut = said.cut.as_ref().map(|cut| self.cutting(&said.name.text, cut));
        Some(Deforming { breaking, strain: said.strain, relax, cut })
    }

    /// Rules of cutting with their defaults.
    fn cutting(&mut self, phase: &str, said: &language::Cutting) -> Cutting {
        let mut read = self.reading(format!("phases.{phase}.cut"), said);
        Cutting {
            planes: read.planes() as u32,
            generations: read.generations() as u8,
            margins: Margins { tension: read.margin_tension(), shear: read.margin_shear() },
            criterion: read.criterion(),
            smallest: read.smallest().unwrap_or(0.0),
            anchor: read.anchor(),
            only_cut: said.only_cut,
            along: said.along.map(|axis| match axis {
                CutAxis::X => Vec3::X,
                CutAxis::Y => Vec3::Y,
                CutAxis::Z => Vec3::Z,
            }),
            snap: read.snap(),
            stages: said.stages.unwrap_or(u64::MAX),
            step_floor: read.step_floor(),
        }
    }

    /// Whether every block that can move in phase `said` is deformable.
    pub(super) fn all_free_deform(&self, said: &language::Phase) -> bool {
        let mut released = Vec::new();
        for phase in &self.parsed.scenario.phases {
            // What cannot be found has been reported.
            released.extend(self.directory.all(&phase.release).unwrap_or_default());
            if std::ptr::eq(phase, said) {
                break;
            }
        }
        let mut bound = self.wholly_driven(&released);
        for &b in self.spatial.deform.sets.iter().flat_map(|s| &s.blocks) {
            bound[b as usize] = true;
        }
        bound.into_iter().all(|b| b)
    }

    /// Whether each block in space is terrain, or has all its freedoms prescribed by one support and is not among the `released`.
    pub(super) fn wholly_driven(&self, released: &[u32]) -> Vec<bool> {
        let blocks = self.spatial.blocks.iter();
        let mut driven: Vec<bool> = blocks.map(|block| block.shape.is_terrain()).collect();
        for support in &self.spatial.supports {
            if support.motion.prescribes() == [[true; 3]; 2] {
                for &b in &support.blocks {
                    driven[b as usize] = true;
                }
            }
        }
        for &b in released {
            driven[b as usize] = false;
        }
        driven
    }

    pub(super) fn outputs(&mut self) {
        for output in &self.parsed.scenario.outputs {
            match output {
                Output::History(history) => self.history(history),
                Output::Frames(pictures) => {
                    let every = pictures.every.read();
                    self.plan.frames = Some(every);
                    let ends = "are written only at the start and at the end of each phase";
                    self.too_rare(format!("frames {ends}"), every, &pictures.every.span);
                    self.pictures(pictures);
                }
                Output::Checkpoints(schedule) => {
                    let every = schedule.every.read();
                    self.plan.checkpoints = Some(every).filter(|every| *every != Every::Never);
                    let ends = "are written at the end of each phase and at automatic intervals";
                    self.too_rare(format!("checkpoints {ends}"), every, &schedule.every.span);
                }
            }
        }
    }

    /// What frames hold.
    fn pictures(&mut self, said: &Pictures) {
        let known: &[&str] = match self.space {
            InSpace::Planar => &crate::planar::picture::FIELDS,
            InSpace::Spatial => &crate::spatial::read::picture::FIELDS,
        };
        let names: Vec<_> = said.fields.iter().flat_map(|names| &names.0).collect();
        for name in names.iter().filter(|name| !known.contains(&name.as_str())) {
            let message = format!("frames have no field `{}`", name.as_str());
            let help = format!("valid fields: {}", known.join(", "));
            self.error_at("name.unknown", name.span.clone(), message, help);
        }
        let fields = said.fields.is_some();
        let fields = fields.then(|| names.iter().map(|name| name.as_str().to_owned()).collect());
        let (contacts, tetrahedra) = (said.contacts.unwrap_or(true), said.tetrahedra);
        self.plan.pictures = Content { fields, contacts, tetrahedra };
    }

    /// Warns of a rhythm that is longer than the run, which is no longer than the times, or the steps, of its phases.
    fn too_rare(&mut self, what: String, every: Every, span: &Span) {
        let phases = self.plan.phases.iter();
        let (rhythm, run) = match every {
            Every::Time(rhythm) => {
                let run = phases.map(|p| p.until.time).sum::<Option<f64>>();
                // A rhythm as long as the run writes at its end, and the sum of the phases is rounded.
                let longer = run.filter(|run| rhythm > *run * (1.0 + 1e-9));
                (with_unit(rhythm, "s"), longer.map(|run| with_unit(run, "s")))
            }
            Every::Steps(rhythm) => {
                let run = phases.map(|p| p.until.steps).sum::<Option<u64>>();
                let longer = run.filter(|run| rhythm > *run);
                (format!("{rhythm} steps"), longer.map(|run| format!("{run} steps")))
            }
            Every::Phase | Every::Never => return,
        };
        if let Some(run) = run {
            let message = format!("{what}: `every` ({rhythm}) is longer than the run ({run})");
            let help = "write every = \"phase\" if this is intended";
            self.warn_at("output.rare", span.clone(), message, help);
        }
    }

    fn history(&mut self, said: &language::History) {
        let place = Place {
            of: said.of.as_ref(),
            point: said.at_point.as_ref(),
            pins: said.pins.as_ref(),
            along: said.along.as_ref(),
            relative_to: said.relative_to.as_ref(),
        };
        let Some(used) = self.field(&said.field, place) else {
            return;
        };
        let every = said.every.read();
        if every == Every::Never {
            let message = format!("history `{}` is never written", said.name);
            let note = Diagnostic::warning("output.never", message);
            self.found.push(note.at(said.every.span.clone()));
            return;
        }
        let ends = "is written only at the start and at the end of each phase";
        let what = format!("history `{}` {ends}", said.name);
        self.too_rare(what, every, &said.every.span);
        let suffixes = used.suffixes;
        let gauge = used.gauge();
        for part in suffixes {
            self.plan.histories.push(History {
                name: format!("{}{part}", said.name),
                gauge: Gauge { field: format!("{}{part}", gauge.field), ..gauge.clone() },
                every,
            });
        }
    }
}

/// The laws of all interfaces as they are after the phases so far; one list is empty.
struct Laws {
    contacts: Vec<ContactLaw>,
    joints: Vec<JointLaw>,
}

/// How a phase relaxes.
fn way(said: &language::Relaxation) -> Relaxation {
    Relaxation {
        damping: said.damping.as_ref().map(Quantity::si),
        energy: said.energy.as_ref().map(Quantity::si),
        breaks: said.breaks.unwrap_or_default(),
    }
}
