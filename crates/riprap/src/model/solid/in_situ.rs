//! Stress at the start.

use crate::model::builder::Builder;
use crate::scenario::language::{self, Compressive, GravityK0, TensionPositive};
use crate::scenario::quantity::Length;
use crate::scenario::read::{Given, Provenance};
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
        let (_, top) = self.model_bounds();
        let origin = self.spatial.origin.z;
        let mut read = self.reading(format!("in_situ.{form}"), &());
        let (from, why) = (Provenance::Derived, "top of the model");
        let surface = read.or("surface", said, top.z + origin, from, why);
        said.map_or(top.z, |_| surface - origin)
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
            (Some(density), _) => density.si(),
            (None, [first, rest @ ..]) if rest.iter().all(|other| other == first) => *first,
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
        let mut read = self.reading("in_situ.gravity_k0", said);
        read.density_or(density, Provenance::Derived, "of the material");
        let vertical = density * gravity.z;
        let sideways = read.k0() * vertical;
        Some(InSitu {
            stress: [0.0; 6],
            gradient: [sideways, sideways, vertical, 0.0, 0.0, 0.0],
            datum,
        })
    }

    fn compressive(&mut self, said: &Compressive) -> InSitu {
        let mut read = self.reading("in_situ.compressive", said);
        let k0 = read.k0();
        let (vertical, below) = (read.vertical(), read.vertical_gradient());
        let x = -said.x.si_or(k0 * vertical);
        let y = -said.y.si_or(k0 * vertical);
        let x_below = -said.x_gradient.si_or(k0 * below);
        let y_below = -said.y_gradient.si_or(k0 * below);
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
