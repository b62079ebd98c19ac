//! Rules of `[space.spatial]`, boundaries and in-situ stress.

use super::Rules;
use crate::language::{Boundary, Scenario, Side, Space};
use crate::quantity::{Plain, Quantity, Span};
use crate::vectors::unit;
use crate::words::WordOr;

impl Rules {
    pub(super) fn ground(&mut self, scenario: &Scenario) {
        let planar = matches!(scenario.space, Space::Planar(_));
        for boundary in &scenario.boundaries {
            if planar {
                self.flat_boundary(boundary);
            }
            self.boundary(boundary, scenario.in_situ.is_some());
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
        if let Some(WordOr::Table(plane, _)) = &on.plane {
            self.normal(&plane.normal);
        }
        if let Some(region) = &on.region {
            self.region(region);
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
            self.points_move(span, "faces", &moved.velocity);
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
