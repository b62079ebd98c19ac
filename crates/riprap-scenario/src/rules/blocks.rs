//! Rules of blocks and their shapes.

use std::f64::consts::FRAC_PI_2;

use super::Rules;
use crate::language::{
    Block, BoxRegion, Cut, Geometry, Grid, Group, MAX_BLOCKS, Polygon, Polyhedron, Rotate, span_of,
};
use crate::quantity::{Length, Span, Vector};
use crate::values::short;
use crate::vectors::InSpace;

impl Rules {
    pub(super) fn block(&mut self, block: &Block) {
        let span = &block.name.span;
        let of = format!("block `{}`", short(block.name.as_str()));
        self.name(&block.name, "a block");
        let given = block.geometries();
        let all: &[&str] = match self.space {
            InSpace::Planar => &[
                "polygon",
                "polygons",
                "rectangle",
                "regular",
                "wall",
                "arch",
                "cut",
                "voronoi",
                "pour",
            ],
            InSpace::Spatial => {
                &["brick", "grid", "polyhedron", "parts", "mesh", "pour", "terrain"]
            }
        };
        let flags: Vec<(&str, bool)> = all
            .iter()
            .map(|key| {
                let cut = *key == "cut" && block.cut.is_some();
                (*key, cut || given.iter().any(|(other, _)| other == key))
            })
            .collect();
        // A shape of the other space was refused already.
        if given.iter().all(|(key, _)| all.contains(key)) {
            self.one_of(span, &of, &flags);
        }
        if block.terrain.is_some() {
            let moves = [
                ("cut", block.cut.is_some()),
                ("copies", block.copies.is_some()),
                ("mechanics", block.mechanics.is_some()),
                ("rotate", block.rotate.is_some()),
                ("velocity", block.velocity.is_some()),
                ("spin", block.spin.is_some()),
                ("mass", block.mass.is_some()),
                ("inertia", block.inertia.is_some()),
            ];
            for (word, _) in moves.into_iter().filter(|(_, given)| *given) {
                let message = format!("{of} is terrain and has `{word}`");
                let help = "terrain is one fixed body: leave it out";
                self.error("key.forbidden", span, message, help);
            }
        }
        if block.parts.is_some() || block.mesh.as_ref().is_some_and(|m| m.glued == Some(true)) {
            let divides = [("cut", block.cut.is_some()), ("mechanics", block.mechanics.is_some())];
            for (word, _) in divides.into_iter().filter(|(_, given)| *given) {
                let message = format!("{of} is made of glued parts and has `{word}`");
                let help = "such a block is rigid and stays whole: leave it out";
                self.error("key.forbidden", span, message, help);
            }
        }
        self.given_mass(span, &of, block);
        if let Some(rotate) = &block.rotate {
            self.rotate(span, &format!("`rotate` of {of}"), rotate);
        }
        if let Some(cut) = &block.cut {
            self.cut(span, &of, cut);
            if block.copies.is_some() {
                let message = format!("{of}: what is cut cannot be copied");
                let help = "`copies` is for single shapes; write another [[blocks]] with `shift`";
                self.error("key.forbidden", span, message, help);
            }
        }
        for (key, geometry) in given {
            self.geometry(span, &of, geometry);
            if block.copies.is_some() && geometry.is_many() && block.cut.is_none() {
                let message = format!("{of}: `{key}` cannot be copied");
                let help = "`copies` is for single shapes; write another [[blocks]] with `shift`";
                self.error("key.forbidden", span, message, help);
            }
        }
    }

    /// Mass and moments of inertia are of one rigid body that stays whole.
    fn given_mass(&mut self, span: &Span, of: &str, block: &Block) {
        let given = [("mass", block.mass.is_some()), ("inertia", block.inertia.is_some())];
        let many = block.cut.is_some() || block.geometry().is_some_and(Geometry::is_many);
        for (word, _) in given.into_iter().filter(|(_, given)| *given) {
            if many {
                let message = format!("{of} makes several blocks and has `{word}`");
                let help = "it is that of one body: give the material its density, or write a [[blocks]] for each shape";
                self.error("key.forbidden", span, message, help);
            } else if block.mechanics.is_some() {
                let message = format!("{of} is deformable and has `{word}`");
                let help = "it is that of a rigid body: give the material its density";
                self.error("key.forbidden", span, message, help);
            }
        }
        let Some(inertia) = block.inertia.as_ref().filter(|i| i.is_single) else {
            return;
        };
        if self.values_sound && inertia.single().is_some_and(|i| i <= 0.0) {
            let message = format!("the moment of inertia of {of} is not greater than 0");
            let help = "of a homogeneous shape leave it out: it follows from the mass";
            self.error("value.range", &inertia.span, message, help);
        }
    }

    /// An angle, in space about one axis, or a quaternion.
    fn rotate(&mut self, span: &Span, of: &str, rotate: &Rotate) {
        let forms =
            [("angle", rotate.angle.is_some()), ("quaternion", rotate.quaternion.is_some())];
        let forms = match self.space {
            InSpace::Planar => &forms[..1],
            InSpace::Spatial => &forms[..],
        };
        self.one_of(span, of, forms);
        if let (Some(angle), InSpace::Spatial) = (&rotate.angle, self.space) {
            let about = [
                ("axis", rotate.axis.is_some()),
                ("dip_direction", rotate.dip_direction.is_some()),
            ];
            self.one_of(&angle.span, of, &about);
        }
        if let Some(axis) = &rotate.axis {
            self.normal(axis);
        }
        let Some(quaternion) = &rotate.quaternion else {
            return;
        };
        if rotate.axis.is_some() || rotate.dip_direction.is_some() {
            let message = format!("{of} has `quaternion`, and `axis` or `dip_direction`");
            let help = "a quaternion has its axis in it: leave the others out";
            self.error("key.one_of", span, message, help);
        }
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
            Geometry::Brick(brick) => self.one_of(
                span,
                &format!("the brick of {of}"),
                &[("corner", brick.corner.is_some()), ("centre", brick.centre.is_some())],
            ),
            Geometry::Grid(Grid::Box(grid)) => {
                if let (Some(_), Some(centre)) = (&grid.corner, &grid.centre) {
                    let message = format!("the grid of {of} has `corner` and `centre`");
                    self.error("key.one_of", &span_of(centre), message, "keep one of them");
                }
            }
            Geometry::Grid(Grid::Cells(cells)) => {
                let random = [
                    ("seed", cells.seed.is_some()),
                    ("relax", cells.relax.is_some()),
                    ("smallest_edge", cells.smallest_edge.is_some()),
                ];
                let lattice = cells.turned.is_some() || cells.site.is_some();
                for (word, _) in random.into_iter().filter(|(_, given)| lattice && *given) {
                    let message =
                        format!("the cells of {of} have `turned` or `site`, and `{word}`");
                    let help = "`turned` and `site` make a lattice; the others are of random cells";
                    self.error("key.one_of", span, message, help);
                }
                if cells.sides.is_some() {
                    let [x, y, _] = &cells.size;
                    if self.values_sound && x.si() != y.si() {
                        let message =
                            format!("the cells of {of} have `sides` and a box that is not square");
                        let help = "give `size` equal lengths along x and y";
                        self.error("value.order", &y.span, message, help);
                    }
                }
            }
            Geometry::Polyhedron(shape) => self.polyhedron(span, of, shape),
            Geometry::Parts(parts) => {
                for (number, part) in (1..).zip(parts) {
                    let of = format!("part {number} of {of}");
                    let given = [
                        ("brick", part.brick.is_some()),
                        ("polyhedron", part.polyhedron.is_some()),
                    ];
                    self.one_of(span, &of, &given);
                    if let Some(brick) = &part.brick {
                        self.geometry(span, &of, Geometry::Brick(brick));
                    }
                    if let Some(shape) = &part.polyhedron {
                        self.polyhedron(span, &of, shape);
                    }
                }
            }
            Geometry::Mesh(mesh) => {
                let of = format!("the mesh of {of}");
                let given = [
                    ("msh", mesh.msh.is_some()),
                    ("tess", mesh.tess.is_some()),
                    ("stl", mesh.stl.is_some()),
                    ("obj", mesh.obj.is_some()),
                ];
                self.one_of(span, &of, &given);
                if let (Some(volume), None) = (&mesh.volume, &mesh.msh) {
                    let message = format!("{of} has `volume` without `msh`");
                    self.error("key.forbidden", &volume.span, message, "leave it out");
                }
            }
            Geometry::Terrain(terrain) => {
                let of = format!("the terrain of {of}");
                let given = [
                    ("asc", terrain.asc.is_some()),
                    ("csv", terrain.csv.is_some()),
                    ("stl", terrain.stl.is_some()),
                ];
                self.one_of(span, &of, &given);
                if let (Some(unit), Some(_)) = (&terrain.unit, &terrain.csv) {
                    let message = format!("{of} has `unit` and `csv`");
                    let help = "the columns of a CSV file have their units in their names";
                    self.error("key.forbidden", &unit.span, message, help);
                }
            }
            Geometry::Polygons(polygons) => {
                let of = format!("the polygons of {of}");
                let given = [("dxf", polygons.dxf.is_some()), ("tess", polygons.tess.is_some())];
                self.one_of(span, &of, &given);
                let layers = polygons.layers.as_ref().and_then(|layers| layers.first());
                let sagitta = polygons.sagitta.as_ref().map(|sagitta| &sagitta.span);
                if polygons.dxf.is_none() {
                    self.of_drawing(&of, layers.map(|l| &l.span), sagitta);
                }
            }
            Geometry::Rectangle(shape) => self.one_of(
                span,
                &format!("the rectangle of {of}"),
                &[("corner", shape.corner.is_some()), ("centre", shape.centre.is_some())],
            ),
            // The schema has their ranges.
            Geometry::Regular(_) => {}
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

    fn polyhedron(&mut self, span: &Span, of: &str, shape: &Polyhedron) {
        self.one_of(
            span,
            &format!("the polyhedron of {of}"),
            &[("vertices", shape.vertices.is_some()), ("obj", shape.obj.is_some())],
        );
        let count = shape.vertices.as_ref().map_or(4, Vec::len);
        if count < 4 {
            let message = format!("the polyhedron of {of} has {count} corners");
            let help = "a polyhedron has at least four corners";
            self.error("polyhedron.corners", span, message, help);
        }
        let Some(faces) = &shape.faces else { return };
        if shape.vertices.is_none() {
            let message = format!("the polyhedron of {of} has `faces` without `vertices`");
            self.error("key.missing", span, message, "give the corners too");
            return;
        }
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
    }

    pub(super) fn corners(&mut self, span: &Span, of: &str, count: usize) {
        if count < 3 {
            let message = format!("the polygon of {of} has {count} corners");
            self.error("polygon.corners", span, message, "a polygon has at least three corners");
        }
    }

    /// Keys that only a drawing has.
    fn of_drawing(&mut self, of: &str, layers: Option<&Span>, sagitta: Option<&Span>) {
        for (key, span) in [("layers", layers), ("sagitta", sagitta)] {
            if let Some(span) = span {
                let message = format!("{of}: `{key}` belongs to `dxf`");
                self.error("key.forbidden", span, message, "leave it out");
            }
        }
    }

    fn cut(&mut self, span: &Span, of: &str, cut: &Cut) {
        match (self.space, &cut.region) {
            (InSpace::Planar, Some(region)) => self.corners(span, of, region.len()),
            (InSpace::Planar, None) => {
                let message = format!("the cut of {of} has no `region`");
                let help = "give the corners of what is cut: region = [[\"0 m\", \"0 m\"], ...]";
                self.error("key.missing", span, message, help);
            }
            // Refused already where there is one.
            (InSpace::Spatial, _) => {}
        }
        if cut.joint_sets.is_empty() && cut.traces.is_none() && cut.joints.is_none() {
            let message = format!("{of} is cut by no joints");
            let help = match self.space {
                InSpace::Planar => "add joint_sets = [{ dip = \"60 deg\", spacing = \"1 m\" }]",
                InSpace::Spatial => {
                    "add joint_sets = [{ dip = \"60 deg\", dip_direction = \"90 deg\", spacing = \"1 m\" }]"
                }
            };
            self.error("key.missing", span, message, help);
        }
        if let Some(joints) = &cut.joints {
            let given = [
                ("csv", joints.csv.is_some()),
                ("fab", joints.fab.is_some()),
                ("dfnworks", joints.dfnworks.is_some()),
                ("itasca", joints.itasca.is_some()),
            ];
            self.one_of(span, &format!("the joints of {of}"), &given);
            if let (Some(unit), Some(_)) = (&joints.unit, &joints.csv) {
                let message = format!("the joints of {of} have `unit` and `csv`");
                let help = "the columns of a CSV file have their units in their names";
                self.error("key.forbidden", &unit.span, message, help);
            }
        }
        if let Some(traces) = &cut.traces {
            let of = format!("the traces of {of}");
            let given = [("csv", traces.csv.is_some()), ("dxf", traces.dxf.is_some())];
            self.one_of(span, &of, &given);
            if traces.dxf.is_none() {
                let layers = traces.layers.as_ref().and_then(|layers| layers.first());
                let sagitta = traces.sagitta.as_ref().map(|sagitta| &sagitta.span);
                self.of_drawing(&of, layers.map(|l| &l.span), sagitta);
            }
        }
        for set in &cut.joint_sets {
            if self.space == InSpace::Spatial && set.dip_direction.is_none() {
                let message = "a joint set in space needs `dip_direction`".to_owned();
                let help = "write for example dip_direction = \"90 deg\": dipping to the east (x)";
                self.error("key.missing", &set.dip.span, message, help);
            }
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
