//! Keys that have no effect in the scene at hand: each is a warning, at its place.
//!
//! What the text alone shows is in the rules of the language; here is what depends on which blocks deform and on how
//! phases are calculated. The table of who reads what:
//!
//! | keys | read by |
//! |---|---|
//! | `interfaces.*` besides `between`, `brittle_bond` | joints and found contacts of rigid blocks |
//! | `interfaces.*.brittle_bond` | bonds with a deformable block; its strengths also joints of rigid ones |
//! | `phases.*.damping.stiffness`, `rotation` | joints of rigid blocks, rigid blocks |
//! | `phases.*.damping.mass`, `local` | rigid blocks; nodes in dynamic phases |
//! | `phases.*.damping`, `interfaces.*.damping_ratio` | of implicit phases `mass` and `rotation` of dynamic ones (`implicit`) |
//! | `phases.*` `breaking`, `strain`, `cut` | deformable blocks |
//! | `phases.*` `load_steps`, `iterations`, `relaxation` | static phases in which all free blocks deform |
//! | `interfaces.*.dashpots` | joints in space with a `damping_ratio` or a phase with `damping.stiffness` (`laws`) |
//! | `materials.*` `young`, `poisson` | in the plane interfaces without `normal_stiffness` (`laws`) |
//! | `blocks.*` `velocity`, `spin` | freedoms that no support prescribes (`start`) |

mod implicit;
mod laws;
mod start;

use crate::model::builder::Builder;
use crate::plan::PhaseKind;
use crate::scenario::language::{Fixed, Interface, Output, Phase, Target};
use crate::scenario::vectors::InSpace;
use crate::scenario::{Name, Span, no_effect, target_span};

/// A key, and whether it was given.
type Given = (&'static str, bool);

impl Builder<'_> {
    /// Warns of keys without effect; the setup is complete.
    pub(super) fn unused(&mut self) {
        self.unused_at_start();
        match self.space {
            InSpace::Planar => self.unused_moduli(),
            InSpace::Spatial => {
                self.unused_dashpots();
                self.unused_in_implicit_phases();
                self.waves_in_implicit_phases();
            }
        }
        let scenario = &self.parsed.scenario;
        for (number, said) in scenario.phases.iter().enumerate() {
            if number > 0
                && said.gravity.is_none()
                && let Some(ramp) = &said.gravity_ramp
            {
                let of = format!("phase `{}`", said.name);
                let help = "gravity does not change in this phase; give `gravity`";
                self.no_effect(&of, &[("gravity_ramp", true)], &ramp.span, help);
            }
        }
    }

    /// The same in space.
    pub(super) fn unused_in_space(&mut self) {
        let scenario = &self.parsed.scenario;
        let deforms = self.deforming_blocks();
        let any = deforms.contains(&true);
        for (number, said) in scenario.phases.iter().enumerate() {
            self.unused_of_phase(number, said, any);
        }
        self.unused_of_interfaces(&deforms);
        for output in &scenario.outputs {
            if let Output::Frames(pictures) = output
                && pictures.tetrahedra
                && !any
            {
                let keys = [("tetrahedra", true)];
                let help = "no block is deformable, so there are no tetrahedra";
                self.no_effect("frames", &keys, &pictures.every.span, help);
            }
        }
        if let Some(notch) = scenario.notches.first().filter(|_| !any) {
            let help = "no block is deformable, so there are no bonds for a notch to break";
            self.no_effect("the scene", &[("notches", true)], &notch.region.min.span, help);
        }
        for support in &scenario.supports {
            let Some(Fixed { rotation, rotation_x, rotation_y, rotation_z, .. }) = &support.fixed
            else {
                continue;
            };
            if matches!(support.on, Target::Nodes(_)) {
                let keys = [
                    ("rotation", rotation.is_some()),
                    ("rotation_x", rotation_x.is_some()),
                    ("rotation_y", rotation_y.is_some()),
                    ("rotation_z", rotation_z.is_some()),
                ];
                let span = target_span(&support.on);
                self.no_effect("`fixed` of nodes", &keys, &span, "nodes have no rotation");
            }
        }
    }

    /// Warns if there are any of the keys.
    fn no_effect(&mut self, of: &str, keys: &[Given], span: &Span, help: &str) {
        let given: Vec<&str> = keys.iter().filter(|(_, g)| *g).map(|(k, _)| *k).collect();
        if given.is_empty() {
            return;
        }
        self.found.push(no_effect(of, &given, span.clone(), help));
    }

    /// Which blocks deform.
    pub(super) fn deforming_blocks(&self) -> Vec<bool> {
        let mut deforms = vec![false; self.spatial.blocks.len()];
        for set in &self.spatial.deform.sets {
            for &block in &set.blocks {
                deforms[block as usize] = true;
            }
        }
        deforms
    }

    fn unused_of_phase(&mut self, number: usize, said: &Phase, any: bool) {
        let (of, span) = (format!("phase `{}`", said.name), &said.name.span);
        let of_nodes = [
            ("breaking", said.breaking.is_some()),
            ("strain", said.strain.is_some()),
            ("cut", said.cut.is_some()),
        ];
        let of_relaxing = [
            ("load_steps", said.load_steps.is_some()),
            ("iterations", said.iterations.is_some()),
            ("relaxation", said.relaxation.is_some()),
        ];
        let damping = said.damping.clone().unwrap_or_default();
        let plan = self.plan.phases.get(number);
        let relaxes = plan.is_some_and(|p| p.deform.is_some_and(|d| d.relax.is_some()));
        let settles = plan.is_some_and(|p| p.kind == PhaseKind::Static);
        if !any {
            let help = "these keys apply to deformable blocks, and there are none";
            self.no_effect(&of, &of_nodes, span, help);
            // For dynamic phases the rules of the language have said it.
            let first = if settles { 0 } else { 2 };
            self.no_effect(&of, &of_relaxing[first..], span, help);
            return;
        }
        if !relaxes {
            let (first, help) = if settles {
                let help = "these keys apply to phases in which all free blocks are deformable; free rigid blocks relax by time steps";
                (0, help)
            } else {
                (2, "it applies to kind = \"static\"")
            };
            self.no_effect(&of, &of_relaxing[first..], span, help);
        }
        let of = format!("`damping` of {of}");
        if relaxes {
            let keys = [
                ("mass", damping.mass.is_some()),
                ("rotation", damping.rotation.is_some()),
                ("stiffness", damping.stiffness.is_some()),
                ("local", damping.local.is_some()),
            ];
            let help = "deformable blocks relax with their own damping; see `relaxation`";
            self.no_effect(&of, &keys, span, help);
        } else if self.all_free_deform(said) {
            let keys = [
                ("rotation", damping.rotation.is_some()),
                ("stiffness", damping.stiffness.is_some()),
            ];
            let help = "bonds and nodes of deformable blocks have no such damping; use `mass`";
            self.no_effect(&of, &keys, span, help);
        }
    }

    /// Rows of the table that no pair of rigid blocks uses, or no pair with a deformable one.
    fn unused_of_interfaces(&mut self, deforms: &[bool]) {
        let n = self.spatial.materials.len();
        let mut deformable = vec![false; n];
        // How many rigid blocks there are, and whether any of them can be moved: two that are held mean nothing to each other.
        let mut rigid = vec![(0, false); n];
        let released: Vec<u32> =
            (self.plan.phases.iter()).flat_map(|phase| phase.release.iter().copied()).collect();
        let driven = self.wholly_driven(&released);
        for ((block, deforms), driven) in self.spatial.blocks.iter().zip(deforms).zip(driven) {
            let material = usize::from(block.material);
            if *deforms {
                deformable[material] = true;
            } else {
                let (count, any_free) = &mut rigid[material];
                *count += 1;
                *any_free |= !driven;
            }
        }
        let of_two_rigid = |a: usize, b: usize| {
            let (first, second) = (rigid[a], rigid[b]);
            let enough = if a == b { first.0 > 1 } else { first.0 > 0 && second.0 > 0 };
            enough && (first.1 || second.1)
        };
        let rows = self.parsed.scenario.interfaces.iter().enumerate();
        for (row, (name, said)) in rows {
            let pairs = (0..n * n).filter(|&k| usize::from(self.spatial.pair_table[k]) == row);
            let pairs = pairs.map(|k| (k / n, k % n));
            let of_rigid = pairs.clone().any(|(a, b)| of_two_rigid(a, b));
            let of_bonds =
                pairs.clone().any(|(a, b)| deformable[a] && (deformable[b] || rigid[b].0 > 0));
            let of = format!("interfaces.{name}");
            if of_bonds {
                self.refuse_behaviour(&of, said);
                if !of_rigid {
                    self.unused_without_joints(&of, name, said);
                }
            }
            if !self.spatial.found_contacts {
                self.unused_without_contacts(&of, name, said);
            }
            if let Some(bond) = said.brittle_bond.as_ref().filter(|_| of_rigid && !of_bonds) {
                let help = "this interface has only joints of rigid blocks, which read from `brittle_bond` only the strengths that the interface \
                            does not give";
                let of = format!("{of}.brittle_bond");
                let span = bond.thickness.as_ref().map_or(&name.span, |thickness| &thickness.span);
                self.no_effect(&of, &bond.read_by("bonds"), span, help);
            }
        }
    }

    /// Keys of joints where an interface has bonds alone.
    fn unused_without_joints(&mut self, of: &str, name: &Name, said: &Interface) {
        // Found contacts of deformable blocks read the dashpots of joints; the rest too where there is no bond.
        let found = self.spatial.found_contacts;
        if found && said.brittle_bond.is_none() {
            return;
        }
        let slides = found && said.brittle_bond.as_ref().is_some_and(|bond| bond.elastic);
        let unread = |keys: Vec<Given>| -> Vec<Given> {
            let unread = |given: &Given| match given.0 {
                "damping_ratio" => !found,
                // What is elastic slides once it meets anew.
                "friction_angle" | "friction_coefficient" => !slides,
                _ => true,
            };
            keys.into_iter().filter(unread).collect()
        };
        let help = "this interface joins no two rigid blocks of which one is free; `brittle_bond` describes the bonds of deformable blocks \
                    and their new contacts";
        self.no_effect(of, &unread(said.read_by("joints")), &name.span, help);
        for phase in &self.parsed.scenario.phases {
            if let Some(change) = phase.interfaces.get(name.as_str()) {
                let of = format!("phases.{}.{of}", phase.name);
                self.no_effect(&of, &unread(change.read_by("joints")), &phase.name.span, help);
            }
        }
    }

    /// Keys of contacts where none are detected.
    fn unused_without_contacts(&mut self, of: &str, name: &Name, said: &Interface) {
        let help = "it applies to contacts: set space.spatial.found_contacts = true";
        if let Some(wanted) = &said.restitution {
            self.no_effect(of, &[("restitution", true)], &wanted.span, help);
        }
        if let Some(depth) = &said.stiffening_depth {
            self.no_effect(of, &[("stiffening_depth", true)], &depth.span, help);
        }
        // A joint that is elastic does not slide; a contact under its law does.
        let given = [
            ("friction_angle", said.elastic && said.friction_angle.is_some()),
            ("friction_coefficient", said.elastic && said.friction_coefficient.is_some()),
        ];
        self.no_effect(of, &given, &name.span, help);
        for phase in &self.parsed.scenario.phases {
            let change = phase.interfaces.get(name.as_str());
            if let Some(wanted) = change.and_then(|change| change.restitution.as_ref()) {
                let of = format!("phases.{}.{of}", phase.name);
                self.no_effect(&of, &[("restitution", true)], &wanted.span, help);
            }
        }
    }
}

impl Builder<'_> {
    /// Bonds of deformable blocks neither dilate nor know the laws of joints that change with slip and closure.
    fn refuse_behaviour(&mut self, of: &str, said: &Interface) {
        let dilates = said.dilation_angle.as_ref().filter(|a| a.si() > 0.0);
        let keys = [
            ("dilation_angle", dilates.map(|a| &a.span)),
            ("softening", said.softening.as_ref().map(|s| &s.slip.span)),
            ("barton_bandis", said.barton_bandis.as_ref().map(|b| &b.jrc.span)),
            ("closure", said.closure.as_ref().map(|c| &c.limit.span)),
        ];
        for (key, span) in keys {
            let Some(span) = span else { continue };
            let message = format!("`{key}` in {of} applies to joints between rigid blocks only");
            let help = "a deformable block uses this interface; give its material a separate interface, or let the bonds soften \
                        (`brittle_bond.cohesive`)";
            self.error_at("mechanics.deformable", span.clone(), message, help);
        }
        if let Some(depth) = &said.stiffening_depth {
            let message =
                format!("`stiffening_depth` in {of} applies to contacts between rigid blocks only");
            let help =
                "a deformable block uses this interface; give its material a separate interface";
            self.error_at("mechanics.deformable", depth.span.clone(), message, help);
        }
    }
}
