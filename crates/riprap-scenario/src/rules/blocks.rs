//! Rules of blocks and their shapes.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{Rules, above};
use crate::diagnostic::short;
use crate::language::{
    Around, BenchesProfile, Block, BoxRegion, Cut, Dome, Excavation, Geometry, Graded, Grid, Group,
    MAX_BLOCKS, Place, Polygon, Polyhedron, Rotate, span_of,
};
use crate::quantity::{Length, Quantity, Span, Vector};
use crate::vectors::InSpace;

impl Rules {
    pub(super) fn block(&mut self, block: &Block) {
        let span = &block.name.span;
        let of = format!("block `{}`", short(block.name.as_str()));
        self.name(&block.name, "a block");
        if let Some(inertia) = block.inertia.as_ref().filter(|i| i.is_single)
            && self.values_sound
            && inertia.single().is_some_and(|i| i <= 0.0)
        {
            let message = format!("the moment of inertia of {of} is not greater than 0");
            let help = "leave it out for a homogeneous shape: it follows from the mass";
            self.error("value.range", &inertia.span, message, help);
        }
        if let Some(rotate) = &block.rotate {
            self.rotate(&format!("`rotate` of {of}"), rotate);
        }
        if let Some(cut) = &block.cut {
            self.cut(span, &of, cut);
        }
        for (_, geometry) in block.geometries() {
            self.geometry(span, &of, geometry);
        }
    }

    /// Axis and quaternion must have a direction.
    fn rotate(&mut self, of: &str, rotate: &Rotate) {
        if let Some(axis) = &rotate.axis {
            self.normal(axis);
        }
        let Some(quaternion) = &rotate.quaternion else {
            return;
        };
        if self.values_sound && quaternion.iter().all(|part| part.si() == 0.0) {
            let message = format!("the quaternion of {of} has no length");
            let help = "write [w, x, y, z]; [1, 0, 0, 0] turns nothing";
            self.error("value.range", &quaternion[0].span, message, help);
        }
    }

    pub(super) fn geometry(&mut self, span: &Span, of: &str, geometry: Geometry<'_>) {
        match geometry {
            Geometry::Polygon(Polygon::Points(points)) => self.corners(span, of, points.len()),
            Geometry::Polygon(Polygon::Csv(_)) => {}
            // The schema has their ranges, and the attributes of keys which go together.
            Geometry::Brick(_)
            | Geometry::Grid(Grid::Box(_))
            | Geometry::Mesh(_)
            | Geometry::Terrain(_)
            | Geometry::Masonry(_)
            | Geometry::Vault(_)
            | Geometry::Polygons(_)
            | Geometry::Rectangle(_)
            | Geometry::Regular(_) => {}
            Geometry::Grid(Grid::Cells(cells)) => {
                let [x, y, _] = &cells.size;
                if cells.sides.is_some() && self.values_sound && x.si() != y.si() {
                    let message =
                        format!("the cells of {of} have `sides` and a box that is not square");
                    let help = "give `size` equal lengths along x and y";
                    self.error("value.order", &y.span, message, help);
                }
                if let Some(graded) = &cells.graded {
                    self.graded(graded);
                }
            }
            Geometry::Dome(dome) => self.dome(dome),
            Geometry::Polyhedron(shape) => self.polyhedron(span, of, shape),
            Geometry::Parts(parts) => {
                for (number, part) in (1..).zip(parts) {
                    let of = format!("part {number} of {of}");
                    if let Some(shape) = &part.polyhedron {
                        self.polyhedron(span, &of, shape);
                    }
                }
            }
            Geometry::Wall(wall) => {
                let (rows, columns) = (u64::from(wall.courses), u64::from(wall.per_course));
                self.count(span, of, "courses x per_course", rows * columns, 0, MAX_BLOCKS);
            }
            Geometry::Arch(arch) => {
                if self.values_sound && arch.thickness.si() >= 2.0 * arch.radius.si() {
                    let message = format!("the arch of {of} is thicker than its diameter");
                    let help = "thickness must be less than twice the radius of the centre line";
                    self.error("value.order", &arch.thickness.span, message, help);
                }
            }
            // With the other keys of the block, as in space it is no shape.
            Geometry::Cut(_) => {}
            Geometry::Voronoi(voronoi) => {
                self.corners(span, of, voronoi.region.len());
            }
            Geometry::Pour(pour) => {
                let [low, high] = pour.vertices_or_default();
                self.count(span, of, "vertices", u64::from(low), 3, 100);
                self.count(span, of, "vertices", u64::from(high), u64::from(low), 100);
                self.in_order(&pour.size[0], &pour.size[1], true, "`size` is [smallest, largest]");
                let [lowest, highest] = &pour.region;
                for (low, high) in lowest.items.iter().zip(&highest.items) {
                    let help = "`region` is [lowest corner, highest corner]";
                    self.in_order(low, high, false, help);
                }
            }
        }
    }

    /// Cells grow from the finest ones, by less than their own size from one to the next.
    fn graded(&mut self, graded: &Graded) {
        if let Some(at) = &graded.at {
            self.around(at);
            if let Around::Place(place, span) = at
                && matches!(&**place, Place::All(_))
            {
                let message = "cells cannot be graded towards everything".to_owned();
                let help = "give cells of one size with `cell`, or `at` a place that ends";
                self.error("value.place", span, message, help);
            }
        }
        let Some(from) = &graded.from else { return };
        self.in_order(
            from,
            &graded.to,
            true,
            "cells are finest, `from`, at the place, and grow to `to`",
        );
        let growth = graded.to.si() - from.si();
        if self.values_sound && growth > graded.over.si() {
            let message = format!(
                "cells would grow by {:.3} of the way: more than their own size from one to the next",
                growth / graded.over.si()
            );
            let help = format!(
                "give `over` at least {} m; four times that makes even cells",
                short(&format!("{growth}"))
            );
            self.error("value.order", &graded.over.span, message, &help);
        }
    }

    fn polyhedron(&mut self, span: &Span, of: &str, shape: &Polyhedron) {
        let count = shape.vertices.as_ref().map_or(4, Vec::len);
        if count < 4 {
            let message = format!("the polyhedron of {of} has {count} corners");
            let help = "a polyhedron has at least four corners";
            self.error("polyhedron.corners", span, message, help);
        }
        let (Some(faces), Some(_)) = (&shape.faces, &shape.vertices) else { return };
        for (number, face) in faces.iter().enumerate() {
            if face.len() < 3 {
                let message = format!("face {number} of {of} has {} corners", face.len());
                let help = "a face has at least three corners";
                self.error("polyhedron.face", span, message, help);
            }
            if let Some(corner) = face.iter().find(|corner| **corner as usize >= count) {
                let message = format!("face {number} of {of} names corner {corner}");
                let help = format!("corners are counted from 0 to {}", count - 1);
                self.error("polyhedron.face", span, message, &help);
            }
        }
    }

    /// A box whose corners must be in order.
    pub(super) fn region(&mut self, region: &BoxRegion) {
        self.corners_of_box(&region.min, &region.max);
    }

    pub(super) fn corners_of_box(&mut self, min: &Vector<Length>, max: &Vector<Length>) {
        for (low, high) in min.items.iter().zip(&max.items) {
            self.in_order(low, high, true, "`box` is { min = [lowest], max = [highest] }");
        }
    }

    pub(super) fn group(&mut self, group: &Group) {
        if let Some(region) = &group.region {
            self.region(region);
        }
        if let Some(prism) = &group.prism
            && let Some(first) = prism.points.first()
        {
            self.corners(&first[0].span, "`prism`", prism.points.len());
        }
        if let Some(said) = &group.excavation {
            self.excavation(said);
        }
        if let Some(size) = &group.size
            && let (Some(low), Some(high)) = (&size.above, &size.below)
        {
            self.in_order(low, high, false, "`size` is { above = smallest, below = largest }");
        }
        if let Some(half) = &group.half_space
            && self.values_sound
            && half.normal.xyz().iter().all(|x| *x == 0.0)
        {
            let message = "the normal of the half-space has no length".to_owned();
            self.error(
                "group.normal",
                &half.normal.span,
                message,
                "write for example normal = [0, 0, 1]",
            );
        }
    }

    fn dome(&mut self, said: &Dome) {
        if !self.values_sound {
            return;
        }
        if !above(2.0 * said.radius.si(), said.thickness.si()) {
            let message = "the dome is as thick as the sphere is wide".to_owned();
            let help = "give a thickness of less than twice the radius";
            self.error("value.order", &said.thickness.span, message, help);
        }
        let half = said.half_angle.si();
        if above(half, PI - 1e-6) {
            let message = "a dome does not go round to the lowest point of its sphere".to_owned();
            let help = "give a `half_angle` of less than 180 deg; 90 deg is a half sphere";
            self.error("value.order", &said.half_angle.span, message, help);
        }
        if let Some(oculus) = &said.oculus
            && !above(half, oculus.si())
        {
            let message = "the oculus reaches to the springing".to_owned();
            let help = "give it an angle of less than `half_angle`";
            self.error("value.order", &oculus.span, message, help);
        }
    }

    fn excavation(&mut self, said: &Excavation) {
        let place = |point: &[Quantity<Length>; 3]| point.each_ref().map(Quantity::si);
        if self.values_sound && place(&said.from) == place(&said.to) {
            let message = "the line of the excavation has no length".to_owned();
            self.error("value.order", &span_of(&said.to), message, "give two points");
        }
        if let Some(points) = &said.polygon {
            let span = points.first().map_or_else(|| span_of(&said.from), |p| p[0].span.clone());
            self.corners(&span, "the excavation", points.len());
        }
        if let Some(shape) = &said.horseshoe
            && self.values_sound
            && above(0.5 * shape.width.si(), shape.height.si())
        {
            let message = "a horseshoe is at least half as high as wide".to_owned();
            let help = "its roof is half a circle: give a larger `height`, or a `polygon`";
            self.error("value.order", &shape.height.span, message, help);
        }
        if let Some(shape) = &said.benches
            && self.values_sound
            && !(f64::EPSILON..=FRAC_PI_2).contains(&shape.face_angle.si())
        {
            let message = format!("a face cannot rise by \"{}\"", shape.face_angle.raw);
            let help = "the angle of a face is above 0 deg and at most 90 deg (upright)";
            self.error("value.range", &shape.face_angle.span, message, help);
        }
        if let Some(shape) = &said.benches
            && self.values_sound
        {
            let [from, to] = [place(&said.from), place(&said.to)];
            let square: f64 = from.iter().zip(&to).map(|(a, b)| (b - a) * (b - a)).sum();
            self.ramps(shape, square.sqrt());
        }
    }

    /// Ramps down benches along a line of a length, m.
    fn ramps(&mut self, said: &BenchesProfile, length: f64) {
        for ramp in &said.ramps {
            let bench = ramp.bench_or_default();
            let (place, room) = match bench {
                1 => ("floor", &said.floor),
                _ => ("berm", &said.berm),
            };
            let most = room.si();
            let end =
                ramp.start.as_ref().map_or(0.0, Quantity::si) + said.height.si() / ramp.grade.si();
            if bench > said.count {
                let message = format!("there is no bench {bench} for a ramp");
                let help = format!("`count` is {}: give `bench` at most that", said.count);
                self.error("value.range", &ramp.width.span, message, &help);
            } else if above(ramp.width.si(), most) {
                let message = format!("the ramp is wider than the {place} it stands on");
                let help = format!("give a width of at most {}, or a wider `{place}`", room.raw);
                self.error("value.order", &ramp.width.span, message, &help);
            } else if above(end, length) {
                let message = format!("the ramp ends {end:.6} m along a line of {length:.6} m");
                let help = "give a steeper `grade`, an earlier `start` or a longer line";
                self.error("value.order", &ramp.grade.span, message, help);
            }
        }
    }

    pub(super) fn corners(&mut self, span: &Span, of: &str, count: usize) {
        if count < 3 {
            let message = format!("the polygon of {of} has {count} corners");
            self.error("polygon.corners", span, message, "a polygon has at least three corners");
        }
    }

    fn cut(&mut self, span: &Span, of: &str, cut: &Cut) {
        if let (InSpace::Planar, Some(region)) = (self.space, &cut.region) {
            self.corners(span, of, region.len());
        }
        for set in &cut.joint_sets {
            if self.space == InSpace::Spatial
                && self.values_sound
                // In the plane the angle alone says also to which side a joint falls.
                && !(0.0..=FRAC_PI_2).contains(&set.dip.si())
            {
                let message = format!("the dip of a plane cannot be \"{}\"", set.dip.raw);
                let help = "a dip is from 0 deg (flat) to 90 deg (vertical); a plane that dips to the other side has the \
                            opposite `dip_direction`";
                self.error("value.range", &set.dip.span, message, help);
            }
            let partial = set.persistence.as_ref().filter(|share| share.si() < 1.0);
            if let (Some(share), None, InSpace::Planar) = (partial, &set.trace_length, self.space) {
                let message =
                    "a joint set with persistence below 1 needs `trace_length`".to_owned();
                let help = "write for example trace_length = \"5 m\"";
                self.error("key.missing", &share.span, message, help);
            }
        }
    }
}
