//! Rules of `[space.spatial]`, boundaries and in-situ stress.

use riprap_core::laws::parameters::Kinematics;

use super::Rules;
use crate::diagnostic::{Diagnostic, list};
use crate::language::{Boundary, InSitu, Scenario, Side, Space};
use crate::quantity::{Plain, Quantity, Span};
use crate::time_function::OF_PLACE_AND_TIME;
use crate::vectors::unit;
use crate::words::WordOr;

impl Rules {
    pub(super) fn ground(&mut self, scenario: &Scenario) {
        if let Space::Spatial(space) = &scenario.space
            && let (Some(Kinematics::Small | Kinematics::Finite), Some(bound)) =
                (space.kinematics, &space.rotation_bound)
        {
            self.found.push(
                Diagnostic::warning("key.unused", "`rotation_bound` has no effect")
                    .at(bound.span.clone())
                    .help("it belongs to kinematics = \"automatic\""),
            );
        }
        let planar = matches!(scenario.space, Space::Planar(_));
        for boundary in &scenario.boundaries {
            if planar {
                self.flat_boundary(boundary);
            }
            self.boundary(boundary, scenario.in_situ.is_some());
        }
        if let Some(InSitu::Compressive(stress)) = &scenario.in_situ {
            let none = stress.vertical.is_none()
                && stress.vertical_gradient.is_none()
                && stress.x.is_none()
                && stress.x_gradient.is_none()
                && stress.y.is_none()
                && stress.y_gradient.is_none();
            if none {
                let span = stress.k0.as_ref().map_or(0..0, |k0| k0.span.clone());
                let message = "in_situ.compressive gives no stress".to_owned();
                let help = "write for example vertical = \"2 MPa\"; or use \
                            gravity_k0 = { k0 = 0.333 } for the weight of the rock";
                self.error("key.one_of", &span, message, help);
            }
        }
    }

    /// In the plane a boundary is a side of the model on which the stress of the rock outside acts.
    fn flat_boundary(&mut self, boundary: &Boundary) {
        let sides = [Side::XMin, Side::XMax, Side::YMin, Side::YMax];
        let side = match &boundary.on.plane {
            Some(WordOr::Word(word, _)) => sides.contains(word),
            Some(WordOr::Table(..)) | None => false,
        };
        if !side {
            let message = "in the plane `on` of a boundary is a side of the model".to_owned();
            let help = "write on.plane = \"x-min\", \"x-max\", \"y-min\" or \"y-max\"";
            self.error("key.forbidden", &boundary_span(boundary), message, help);
        }
    }

    fn boundary(&mut self, boundary: &Boundary, in_situ: bool) {
        let on = &boundary.on;
        let span = boundary_span(boundary);
        self.one_of(
            &span,
            "`on` of a boundary",
            &[
                ("plane", on.plane.is_some()),
                ("block", on.block.is_some()),
                ("blocks", on.blocks.is_some()),
                ("group", on.group.is_some()),
                ("box", on.region.is_some()),
                ("surface", on.surface.is_some()),
            ],
        );
        let flat = on.plane.is_some() || on.surface.is_some();
        if let Some(side) = on.side.as_ref().filter(|_| flat) {
            let message = "these faces have normals already, `side` has no place".to_owned();
            let help = "`side` goes with block, blocks, group and box";
            self.error("key.forbidden", &side.1, message, help);
        }
        if let Some(WordOr::Table(plane, _)) = &on.plane {
            self.normal(&plane.normal);
        }
        if let Some(region) = &on.region {
            self.region(region);
        }
        let kinds = [
            ("held", boundary.held.is_some()),
            ("roller", boundary.roller.is_some()),
            ("moved", boundary.moved.is_some()),
            ("viscous", boundary.viscous.is_some()),
            ("pressure", boundary.pressure.is_some()),
            ("traction", boundary.traction.is_some()),
        ];
        let given: Vec<&str> =
            kinds.iter().filter(|(_, there)| *there).map(|(key, _)| *key).collect();
        if given.len() > 1 {
            let message = format!("a boundary has {}: only one is possible", list(&given));
            let help = "keep one and remove the others";
            self.error("key.one_of", &span, message, help);
        } else if given.is_empty() && boundary.in_situ != Some(true) {
            let all = kinds.map(|(key, _)| key);
            let message = format!("a boundary needs one of {}", list(&all));
            let help = "write for example held = {}; or in_situ = true for the stress alone";
            self.error("key.one_of", &span, message, help);
        }
        if boundary.in_situ == Some(true) && !in_situ {
            let message = "`in_situ` of a boundary without [in_situ]".to_owned();
            let help = "say which stress there is: for example \
                        in_situ.gravity_k0 = { k0 = 0.333 }";
            self.error("key.missing", &span, message, help);
        }
        self.boundary_functions(boundary, &span);
    }

    fn boundary_functions(&mut self, boundary: &Boundary, span: &Span) {
        if let Some(moved) = &boundary.moved {
            let velocity = &moved.velocity;
            if self.turns(span, "faces", velocity) {
                // Reported.
            } else if !self.components(span, velocity, &OF_PLACE_AND_TIME) {
                let message = "a motion needs at least one of `x`, `y`, `z`".to_owned();
                let help = "write for example x = { constant = \"0.1 m/s\" }";
                self.error("key.one_of", span, message, help);
            }
        }
        if let Some(pressure) = &boundary.pressure {
            self.time_function(span, pressure.time.as_ref());
        }
        if let Some(traction) = &boundary.traction {
            self.time_function(span, traction.time.as_ref());
        }
    }

    /// A normal must have a direction.
    pub(super) fn normal(&mut self, normal: &[Quantity<Plain>; 3]) {
        if self.values_sound && unit(normal).is_none() {
            let span = normal[0].span.start..normal[2].span.end;
            let message = "this vector has no direction".to_owned();
            let help = "at least one component is not zero, for example [0, 0, 1]";
            self.error("value.direction", &span, message, help);
        }
    }
}

/// The place of a boundary.
pub(crate) fn boundary_span(boundary: &Boundary) -> Span {
    let on = &boundary.on;
    let name = boundary.name.as_ref().or(on.block.as_ref());
    let name = name
        .or(on.group.as_ref())
        .or(on.surface.as_ref())
        .or_else(|| on.blocks.as_ref().and_then(|names| names.first()));
    let plane = on.plane.as_ref().map(|plane| plane.span().clone());
    let region = on.region.as_ref().map(|region| region.min.span.clone());
    name.map(|name| name.span.clone())
        .or(plane)
        .or(region)
        .or_else(|| on.side.as_ref().map(|side| side.1.clone()))
        .unwrap_or(0..0)
}
