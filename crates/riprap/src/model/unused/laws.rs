//! Numbers of laws that nothing of the model reads.

use crate::model::builder::Builder;
use crate::scenario::quantity::Span;

impl Builder<'_> {
    /// Warns of `dashpots` of joints in space in which no dashpot acts.
    pub(super) fn unused_dashpots(&mut self) {
        let phases = &self.plan.phases;
        let stiffness = phases.iter().any(|phase| phase.damping.stiffness > 0.0);
        let damped = |row: usize| {
            let of_row = |(k, _): &&(u16, _)| usize::from(*k) == row;
            let mut later = phases.iter().flat_map(|p| p.joints.iter().filter(of_row));
            self.spatial.interfaces[row].joint.damping > 0.0
                || later.any(|(_, law)| law.damping > 0.0)
        };
        let rows = self.parsed.scenario.interfaces.iter().enumerate();
        // Of an elastic one the rules of the language have said it.
        let rows = rows.filter(|(_, (_, said))| said.dashpots.is_some() && !said.elastic);
        let implicit = self.is_wholly_implicit();
        let idle = rows.filter(|(row, _)| implicit || !stiffness && !damped(*row));
        let idle: Vec<(String, Span)> =
            idle.map(|(_, (name, _))| (format!("interfaces.{name}"), name.span.clone())).collect();
        let help = match implicit {
            true => "joints have no dashpots in implicit phases",
            false => {
                "its joints have no dashpots: its `damping_ratio` is 0, and no phase has `damping.stiffness`"
            }
        };
        for (of, span) in idle {
            self.no_effect(&of, &[("dashpots", true)], &span, help);
        }
    }

    /// Warns of `young` and `poisson` in the plane, which nothing but a contact stiffness that is not given is estimated from.
    pub(super) fn unused_moduli(&mut self) {
        let scenario = &self.parsed.scenario;
        // A variant may be in space, or have another interface that leaves its stiffness to the material, or be so itself.
        let varies = |key: &str| {
            let whole = key.split('.').count() <= 2;
            key.starts_with("space") || (key.starts_with("interfaces") && whole)
        };
        let mut keys = scenario.variants.iter().flat_map(|(_, keys)| keys.names());
        if self.variant != "default" || keys.any(varies) {
            return;
        }
        let n = self.setup.materials.len();
        let rows: Vec<bool> =
            scenario.interfaces.iter().map(|(_, said)| said.normal_stiffness.is_none()).collect();
        let reads = |material: usize| {
            let mut rows_of =
                (0..n).map(|other| usize::from(self.setup.pair_table[material * n + other]));
            rows_of.any(|row| rows.get(row).is_none_or(|reads| *reads))
        };
        let asked = |material: &str, key: &str| {
            let path = format!("materials.{material}.{key}");
            let mut names = scenario.checks.iter().flat_map(|check| check.names.iter());
            names.any(|(_, value)| value.raw.to_string() == path)
        };
        let mut idle = Vec::new();
        for (number, (name, said)) in scenario.materials.iter().enumerate() {
            let given = [
                ("young", said.young.as_ref().map(|q| q.span.clone())),
                ("poisson", said.poisson.as_ref().map(|q| q.span.clone())),
            ];
            let given: Vec<_> = given
                .into_iter()
                .filter_map(|(key, span)| Some((key, span?)))
                .filter(|(key, _)| !asked(name.as_str(), key))
                .collect();
            if !reads(number) && !given.is_empty() {
                idle.push((format!("materials.{name}"), given));
            }
        }
        for (of, given) in idle {
            let keys: Vec<_> = given.iter().map(|(key, _)| (*key, true)).collect();
            let help = "blocks in the plane are rigid, and their interfaces give `normal_stiffness`; these keys are read only to estimate it";
            self.no_effect(&of, &keys, &given[0].1, help);
        }
    }
}
