//! Velocities and spins at the start that are lost before the first step.

use crate::dynamics::kick::Target;
use crate::model::builder::Builder;
use crate::scenario::quantity::{Axial, Vector};
use crate::scenario::vectors::InSpace;

impl Builder<'_> {
    /// Warns of `velocity` and `spin` of blocks whose motion is prescribed, and of all where the first phase stops every block.
    pub(super) fn unused_at_start(&mut self) {
        let scenario = &self.parsed.scenario;
        for block in &scenario.blocks {
            let (velocity, spin) = match self.space {
                InSpace::Planar => {
                    let [x, y] = block.velocity.as_ref().map_or([0.0; 2], Vector::xy);
                    let about = block.spin.as_ref().and_then(Axial::single);
                    ([x, y, 0.0], [0.0, 0.0, about.unwrap_or(0.0)])
                }
                InSpace::Spatial => (
                    block.velocity.as_ref().map_or([0.0; 3], Vector::xyz),
                    block.spin.as_ref().map_or([0.0; 3], Axial::xyz),
                ),
            };
            let lost = self.lost(block.name.as_str(), [velocity, spin]);
            let spans =
                [block.velocity.as_ref().map(|v| &v.span), block.spin.as_ref().map(|s| &s.span)];
            for ((key, why), span) in ["velocity", "spin"].into_iter().zip(lost).zip(spans) {
                if let (Some(why), Some(span)) = (why, span) {
                    let of = format!("block `{}`", block.name);
                    self.no_effect(&of, &[(key, true)], span, &why);
                }
            }
        }
    }

    /// Why the velocity and the spin at the start of all blocks of a table are lost, at least along one axis.
    fn lost(&self, table: &str, start: [[f64; 3]; 2]) -> [Option<String>; 2] {
        let given = start.map(|v| v.iter().any(|v| v.abs() > 0.0));
        if given == [false; 2] {
            return [None, None];
        }
        let Some((_, blocks)) = self.directory.tables().find(|(name, _)| *name == table) else {
            return [None, None];
        };
        if let Some(first) = self.plan.phases.first().filter(|p| p.zero_velocities) {
            let why = format!("phase `{}` begins with `reset` of all velocities", first.name);
            return given.map(|given| given.then(|| why.clone()));
        }
        // An axis counts that every block of the table loses: of a grid a part may be held.
        let mut kept = [[false; 3]; 2];
        for block in blocks {
            let now = self.after_supports(block, start);
            for (kept, (now, start)) in kept.iter_mut().zip(now.iter().zip(&start)) {
                for k in 0..3 {
                    kept[k] |= now[k].to_bits() == start[k].to_bits() || start[k] == 0.0;
                }
            }
        }
        std::array::from_fn(|which| {
            let axes = ["x", "y", "z"].into_iter().zip(kept[which]);
            let axes: Vec<&str> = axes.filter(|(_, kept)| !kept).map(|(axis, _)| axis).collect();
            let axes = match (self.space, which) {
                (InSpace::Planar, 1) => String::new(),
                (_, 0) => format!(" along {}", axes.join(", ")),
                _ => format!(" about {}", axes.join(", ")),
            };
            let any = kept[which].contains(&false);
            any.then(|| format!("a support prescribes the motion{axes} from the start; remove this value, or the support"))
        })
    }

    /// Velocity and spin of a block once what holds and drives it has had its say.
    fn after_supports(&self, block: u32, start: [[f64; 3]; 2]) -> [[f64; 3]; 2] {
        let all = |targets: [[Target<'_>; 3]; 2]| -> [[f64; 3]; 2] {
            std::array::from_fn(|of| std::array::from_fn(|k| targets[of][k].at(0.0, start[of][k])))
        };
        let fixed = (self.plan.phases.first()).is_some_and(|p| p.fix.binary_search(&block).is_ok());
        let terrain =
            (self.spatial.blocks.get(block as usize)).is_some_and(|b| b.shape.is_terrain());
        if fixed || terrain {
            return [[0.0; 3]; 2];
        }
        let holds = |blocks: &[u32]| blocks.binary_search(&block).is_ok();
        match self.space {
            InSpace::Planar => {
                // The last support of a block is its only one.
                let last = self.setup.supports.iter().rfind(|s| holds(&s.blocks));
                let motion = last.map(|s| s.motion.targets());
                motion.map_or(start, |[x, y, spin]| {
                    let free = || Target::Free;
                    all([[x, y, free()], [free(), free(), spin]])
                })
            }
            InSpace::Spatial => {
                let last = self.spatial.supports.iter().rfind(|s| holds(&s.blocks));
                last.map_or(start, |s| all(s.motion.targets()))
            }
        }
    }
}
