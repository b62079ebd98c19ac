//! Stress at the start.

use crate::model::builder::Builder;
use crate::model::explain::{Provenance, with_unit};
use crate::scenario::language::{self, Compressive, GravityK0, TensionPositive};
use crate::scenario::quantity::{Kind, Length};
use crate::scenario::{Diagnostic, Quantity, Span};
use crate::spatial::setup::InSitu;

/// A place in the text that belongs to the stress.
pub(super) fn place(said: &language::InSitu) -> Span {
    match said {
        language::InSitu::GravityK0(said) => said.k0.span.clone(),
        language::InSitu::Compressive(said) => {
            let stresses = [&said.vertical, &said.x, &said.y].into_iter().flatten();
            let gradients = [&said.vertical_gradient, &said.x_gradient, &said.y_gradient];
            let mut spans = stresses
                .map(|q| q.span.clone())
                .chain(gradients.into_iter().flatten().map(|q| q.span.clone()));
            spans.next().unwrap_or(0..0)
        }
        language::InSitu::TensionPositive(said) => said.stress[0].span.clone(),
    }
}

impl Builder<'_> {
    pub(super) fn in_situ(&mut self) {
        self.spatial.in_situ = match &self.parsed.scenario.in_situ {
            None => None,
            Some(language::InSitu::GravityK0(said)) => self.gravity_k0(said),
            Some(language::InSitu::Compressive(said)) => Some(self.compressive(said)),
            Some(language::InSitu::TensionPositive(said)) => Some(self.tension_positive(said)),
        };
    }

    /// Height at which stresses hold, local z, m; by default the top of the model.
    fn surface(&mut self, form: &str, said: Option<&Quantity<Length>>) -> f64 {
        let key = format!("in_situ.{form}.surface");
        let (_, top) = self.model_bounds();
        let origin = self.spatial.origin.z;
        match said {
            Some(surface) => {
                let raw = surface.raw.to_string();
                self.explain(key, raw, Provenance::Given, "");
                surface.si() - origin
            }
            None => {
                let text = with_unit(top.z + origin, "m");
                self.explain(key, text, Provenance::Derived, "top of the model");
                top.z
            }
        }
    }

    fn gravity_k0(&mut self, said: &GravityK0) -> Option<InSitu> {
        let gravity = self.spatial.gravity;
        if gravity.x != 0.0 || gravity.y != 0.0 || gravity.z > 0.0 {
            let error = Diagnostic::error("in_situ.gravity", "gravity does not point down");
            let help = "gravity_k0 is for gravity along -z; give the stress by `compressive`";
            self.found.push(error.at(said.k0.span.clone()).help(help));
            return None;
        }
        let used: Vec<f64> = self
            .spatial
            .materials
            .iter()
            .enumerate()
            .filter(|(k, _)| {
                let mut blocks = self.spatial.blocks.iter();
                blocks.any(|block| usize::from(block.material) == *k)
            })
            .map(|(_, material)| material.density)
            .collect();
        let density = match (&said.density, &used[..]) {
            (Some(density), _) => {
                let raw = density.raw.to_string();
                self.explain("in_situ.gravity_k0.density", raw, Provenance::Given, "");
                density.si()
            }
            (None, [first, rest @ ..]) if rest.iter().all(|other| other == first) => {
                let text = with_unit(*first, "kg/m3");
                let why = "of the material";
                self.explain("in_situ.gravity_k0.density", text, Provenance::Derived, why);
                *first
            }
            (None, _) => {
                let error =
                    Diagnostic::error("in_situ.density", "the materials have different densities");
                let help = "say which the stress is for: in_situ.gravity_k0.density = \
                            \"2400 kg/m3\"";
                self.found.push(error.at(said.k0.span.clone()).help(help));
                return None;
            }
        };
        let datum = self.surface("gravity_k0", said.surface.as_ref());
        let k0 = said.k0.raw.to_string();
        self.explain("in_situ.gravity_k0.k0", k0, Provenance::Given, "");
        let vertical = density * gravity.z;
        let sideways = said.k0.si() * vertical;
        Some(InSitu {
            stress: [0.0; 6],
            gradient: [sideways, sideways, vertical, 0.0, 0.0, 0.0],
            datum,
        })
    }

    fn compressive(&mut self, said: &Compressive) -> InSitu {
        fn si<K: Kind>(q: Option<&Quantity<K>>) -> f64 {
            q.map_or(0.0, Quantity::si)
        }
        let k0 = si(said.k0.as_ref());
        let (vertical, below) = (
            si(said.vertical.as_ref()),
            si(said.vertical_gradient.as_ref()),
        );
        let value = |q: Option<f64>, other: f64| -(q.unwrap_or(k0 * other));
        let x = value(said.x.as_ref().map(Quantity::si), vertical);
        let y = value(said.y.as_ref().map(Quantity::si), vertical);
        let x_below = value(said.x_gradient.as_ref().map(Quantity::si), below);
        let y_below = value(said.y_gradient.as_ref().map(Quantity::si), below);
        let datum = self.surface("compressive", said.surface.as_ref());
        InSitu {
            stress: [x, y, -vertical, 0.0, 0.0, 0.0],
            gradient: [x_below, y_below, -below, 0.0, 0.0, 0.0],
            datum,
        }
    }

    fn tension_positive(&mut self, said: &TensionPositive) -> InSitu {
        let gradient = said.gradient.as_ref();
        InSitu {
            stress: said.stress.each_ref().map(Quantity::si),
            gradient: gradient.map_or([0.0; 6], |g| g.each_ref().map(Quantity::si)),
            datum: self.surface("tension_positive", said.surface.as_ref()),
        }
    }
}
