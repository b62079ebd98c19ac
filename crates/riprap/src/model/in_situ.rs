//! Stress at the start, in the plane and in space.

mod balance;
mod sides;

use super::builder::Builder;
use crate::laws::in_situ::InSitu;
use crate::scenario::language::{self, Compressive, GravityK0, TensionPositive};
use crate::scenario::quantity::{Length, Tensor};
use crate::scenario::read::{Given, Provenance};
use crate::scenario::vectors::InSpace;
use crate::scenario::{Diagnostic, Quantity, Span};
use riprap_geom::{Mat3, Vec3};

/// A place in the text that belongs to the stress.
fn place(said: &language::InSitu) -> Span {
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
        language::InSitu::TensionPositive(said) => said.stress.span.clone(),
    }
}

impl Builder<'_> {
    /// The stress at the start; blocks and materials must be known, in the plane interfaces too.
    pub(super) fn in_situ(&mut self) {
        let stress = match &self.parsed.scenario.in_situ {
            None => None,
            Some(language::InSitu::GravityK0(said)) => self.gravity_k0(said),
            Some(language::InSitu::Compressive(said)) => Some(self.compressive(said)),
            Some(language::InSitu::TensionPositive(said)) => Some(self.tension_positive(said)),
        };
        match self.space {
            InSpace::Planar => {
                self.setup.in_situ = stress;
                self.carriers();
                self.sides();
            }
            InSpace::Spatial => self.spatial.in_situ = stress,
        }
    }

    /// Axis of heights.
    fn up(&self) -> usize {
        match self.space {
            InSpace::Planar => 1,
            InSpace::Spatial => 2,
        }
    }

    /// Lowest and highest corner of the model, local, m; flat in the plane.
    pub(super) fn extent(&self) -> (Vec3, Vec3) {
        match self.space {
            InSpace::Planar => {
                let corners = self.setup.blocks.iter().flat_map(|b| &b.vertices);
                let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
                corners.fold(start, |(low, high), v| {
                    let v = Vec3::new(v.x, v.y, 0.0);
                    (low.min(v), high.max(v))
                })
            }
            InSpace::Spatial => self.model_bounds(),
        }
    }

    /// Gravity at the start, m/s².
    fn gravity_at_start(&self) -> Vec3 {
        match self.space {
            InSpace::Planar => Vec3::new(self.setup.gravity[0], self.setup.gravity[1], 0.0),
            InSpace::Spatial => self.spatial.gravity,
        }
    }

    /// Densities of the blocks, each once, kg/m³.
    fn densities(&self) -> Vec<f64> {
        let flat = self.setup.blocks.iter().map(|b| b.density);
        let solid = self.spatial.blocks.iter();
        let solid = solid.map(|b| self.spatial.materials[usize::from(b.material)].density);
        let mut all: Vec<f64> = flat.chain(solid).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    }

    /// Height at which stresses hold, local, m; by default the top of the model.
    fn surface(&mut self, form: &str, said: Option<&Quantity<Length>>) -> f64 {
        let (up, (_, top)) = (self.up(), self.extent());
        let origin = match self.space {
            InSpace::Planar => self.origin.y,
            InSpace::Spatial => self.spatial.origin.z,
        };
        let mut read = self.reading(format!("in_situ.{form}"), &());
        let (from, why) = (Provenance::Derived, "top of the model");
        let surface = read.or("surface", said, top[up] + origin, from, why);
        said.map_or(top[up], |_| surface - origin)
    }

    fn gravity_k0(&mut self, said: &GravityK0) -> Option<InSitu> {
        let (up, gravity) = (self.up(), self.gravity_at_start());
        if (0..3).any(|k| k != up && gravity[k] != 0.0) || gravity[up] > 0.0 {
            let error = Diagnostic::error("in_situ.gravity", "gravity does not point down");
            let axis = ["x", "y", "z"][up];
            let help =
                format!("gravity_k0 needs gravity along -{axis}; give the stress by `compressive`");
            self.found.push(error.at(said.k0.span.clone()).help(help));
            return None;
        }
        let density = match (&said.density, &self.densities()[..]) {
            (Some(density), _) => density.si(),
            (None, [only]) => *only,
            (None, _) => {
                let help = "specify the density for the stress: in_situ.gravity_k0.density = \"2400 kg/m3\"";
                let message = "the materials have different densities";
                self.error_at("in_situ.density", said.k0.span.clone(), message, help);
                return None;
            }
        };
        let datum = self.surface("gravity_k0", said.surface.as_ref());
        let mut read = self.reading("in_situ.gravity_k0", said);
        read.density_or(density, Provenance::Derived, "of the material");
        let vertical = density * gravity[up];
        let sideways = read.k0() * vertical;
        let mut gradient = [sideways, sideways, sideways, 0.0, 0.0, 0.0];
        gradient[up] = vertical;
        Some(InSitu { stress: [0.0; 6], gradient: self.flat(gradient), datum })
    }

    /// A stress without what lies out of the plane.
    fn flat(&self, stress: [f64; 6]) -> [f64; 6] {
        match self.space {
            InSpace::Planar => [stress[0], stress[1], 0.0, 0.0, 0.0, stress[5]],
            InSpace::Spatial => stress,
        }
    }

    fn compressive(&mut self, said: &Compressive) -> InSitu {
        let up = self.up();
        let mut read = self.reading("in_situ.compressive", said);
        let k0 = read.k0();
        let (vertical, below) = (read.vertical(), read.vertical_gradient());
        let axes = |x: f64, y: f64, vertical: f64| {
            let mut all = [x, y, 0.0, 0.0, 0.0, 0.0];
            all[up] = -vertical;
            all
        };
        let x = -said.x.si_or(k0 * vertical);
        let y = -said.y.si_or(k0 * vertical);
        let x_below = -said.x_gradient.si_or(k0 * below);
        let y_below = -said.y_gradient.si_or(k0 * below);
        let datum = self.surface("compressive", said.surface.as_ref());
        let angle = match (&said.azimuth, &said.angle) {
            // Clockwise from north to anticlockwise from east.
            (Some(azimuth), _) => Some(std::f64::consts::FRAC_PI_2 - azimuth.si()),
            (None, angle) => angle.as_ref().map(Quantity::si),
        };
        let turned = |stress| angle.map_or(stress, |angle| turned(stress, angle));
        InSitu {
            stress: turned(axes(x, y, vertical)),
            gradient: turned(axes(x_below, y_below, below)),
            datum,
        }
    }

    fn tension_positive(&mut self, said: &TensionPositive) -> InSitu {
        let gradient = said.gradient.as_ref();
        InSitu {
            stress: said.stress.symmetric(),
            gradient: gradient.map_or([0.0; 6], Tensor::symmetric),
            datum: self.surface("tension_positive", said.surface.as_ref()),
        }
    }
}

/// A stress with the axes x, y, z turned by an angle about z (rad, anticlockwise).
fn turned(stress: [f64; 6], angle: f64) -> [f64; 6] {
    let (s, c) = libm::sincos(angle);
    let turn = Mat3::from_cols(Vec3::new(c, s, 0.0), Vec3::new(-s, c, 0.0), Vec3::Z);
    let t =
        turn * Mat3::from_diagonal(Vec3::new(stress[0], stress[1], stress[2])) * turn.transpose();
    let [x, y, z] = [t.x_axis, t.y_axis, t.z_axis];
    [x.x, y.y, z.z, y.z, z.x, x.y]
}
