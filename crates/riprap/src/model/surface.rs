//! Regions by a surface of a file: inside, above and below it.

use riprap_geom::Vec3;
use riprap_geom::height_field::HeightField;
use riprap_geom::surface::{Triangulated, is_above, is_inside};

use super::builder::Builder;
use super::drawn::Wanted;
use super::regions::Region;
use crate::numbers::counted;
use crate::scenario::foreign::dxf::{Drawing, parse_dxf};
use crate::scenario::foreign::obj::parse_obj;
use crate::scenario::foreign::stl::{parse_surface, surface};
use crate::scenario::language::{Group, SurfaceFile};
use crate::scenario::vectors::InSpace;
use crate::scenario::{Diagnostic, Name, Quantity};

/// Largest number of triangles of a surface.
const MOST: usize = 8_000_000;

/// Which side of a surface is meant.
#[derive(Clone, Copy, PartialEq)]
enum Side {
    Inside,
    Above,
    Below,
}

impl Side {
    /// Whether a height lies there, where a vertical line crosses the surface at these heights.
    fn holds(self, crossings: &[f64], height: f64) -> bool {
        match self {
            Side::Inside => is_inside(crossings, height),
            Side::Above => is_above(crossings, height) == Some(true),
            Side::Below => is_above(crossings, height) == Some(false),
        }
    }

    fn word(self) -> &'static str {
        match self {
            Side::Inside => "inside of the surface",
            Side::Above => "space above the surface",
            Side::Below => "space below the surface",
        }
    }
}

/// Heights at which vertical lines cross lines of the plane, m.
struct Lines(Vec<[Vec3; 2]>);

impl Lines {
    fn heights(&self, x: f64) -> Vec<f64> {
        // A corner belongs to the piece on its left only.
        let crossed = self.0.iter().filter(|[a, b]| (a.x > x) != (b.x > x));
        crossed.map(|[a, b]| a.y + (x - a.x) * (b.y - a.y) / (b.x - a.x)).collect()
    }

    fn middle(&self) -> Vec3 {
        let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let ends = self.0.iter().flatten();
        let (low, high) = ends.fold(start, |(low, high), p| (low.min(*p), high.max(*p)));
        0.5 * (low + high)
    }
}

impl Builder<'_> {
    /// The regions of a group by surfaces of files.
    pub(super) fn by_surface(&mut self, group: &Group) -> Vec<Region<'static>> {
        let said = [
            (&group.inside, Side::Inside),
            (&group.above, Side::Above),
            (&group.below, Side::Below),
        ];
        let said = said.into_iter().filter_map(|(said, side)| Some((said.as_ref()?, side)));
        let regions = said.filter_map(|(said, side)| match self.space {
            InSpace::Planar => self.beside_lines(said, side),
            InSpace::Spatial => self.beside_triangles(said, side),
        });
        regions.collect()
    }

    fn beside_lines(&mut self, said: &SurfaceFile, side: Side) -> Option<Region<'static>> {
        let file = said.dxf.as_ref()?;
        let wanted = Wanted {
            file,
            unit: said.unit.as_ref(),
            layers: said.layer.as_ref().map(std::slice::from_ref),
            sagitta: None,
        };
        let (own, drawing) = self.drawing(&wanted)?;
        let unit = said.unit.as_ref().map_or(own.value, Quantity::si);
        let lines = match side {
            Side::Inside => drawing.outlines().closed,
            Side::Above | Side::Below => drawing.lines,
        };
        if lines.is_empty() {
            let message = format!("`{file}` has no closed outline");
            let help = "close it in the drawing (closed flag, or coincident ends), or use `above` or `below`";
            self.error_at("group.surface", file, message, help);
            return None;
        }
        self.note_import(file, &format!("read {} as a surface", counted(lines.len(), "line")));
        let mut pieces = Vec::new();
        for line in &lines {
            let place = |[x, y]: &[f64; 2]| Vec3::from(self.local3([unit * x, unit * y, 0.0]));
            let points: Vec<Vec3> = line.points.iter().map(place).collect();
            pieces.extend(points.windows(2).map(|ends| [ends[0], ends[1]]));
            if line.closed {
                pieces.extend(points.last().zip(points.first()).map(|(a, b)| [*a, *b]));
            }
        }
        let lines = Lines(pieces);
        Some(Region {
            middle: lines.middle(),
            holds: Box::new(move |c| side.holds(&lines.heights(c.x), c.y)),
            word: side.word(),
            at: file.span.clone(),
        })
    }

    fn beside_triangles(&mut self, said: &SurfaceFile, side: Side) -> Option<Region<'static>> {
        let (file, of) = self.triangles(said)?;
        let count = of.triangles.len();
        if count > MOST {
            let message = format!("`{file}` has {count} triangles");
            let help = format!("at most {MOST} are allowed; use a coarser surface");
            self.error_at("group.surface", file, message, help);
            return None;
        }
        let Some(of) = Triangulated::new(of.points, of.triangles) else {
            let message = format!("`{file}` has no surface: all its triangles lie on one line");
            self.error_at("group.surface", file, message, "correct the file");
            return None;
        };
        if side == Side::Inside
            && let open = of.open_edges()
            && let Some(at) = open.first()
        {
            let [x, y, z] = self.everywhere(*at).to_array();
            let message = format!(
                "the surface of `{file}` is not closed: {} of its edges have triangles on one side only, one near ({x:.6}, {y:.6}, {z:.6}) m",
                open.len()
            );
            let help = "close it, or take the blocks `above` or `below` it";
            self.error_at("group.surface", file, message, help);
            return None;
        }
        Some(Region {
            middle: of.middle(),
            holds: Box::new(move |c| side.holds(&of.heights(c.x, c.y), c.z)),
            word: side.word(),
            at: file.span.clone(),
        })
    }

    /// The triangles of a file in local coordinates, m; `None` after an error.
    fn triangles<'s>(&mut self, said: &'s SurfaceFile) -> Option<(&'s Name, HeightField)> {
        let shift = Vec3::from(self.local3([0.0; 3]));
        let mut unit = said.unit.as_ref().map_or(1.0, Quantity::si);
        if said.asc.is_some() || said.csv.is_some() {
            return self.grid_surface([said.asc.as_ref(), said.csv.as_ref()], unit, shift);
        }
        let (file, (points, triangles, flat)) = if let Some(file) = &said.stl {
            (file, self.foreign_file(file, parse_surface, "save it as ASCII or binary STL")?)
        } else if let Some(file) = &said.obj {
            let help = "correct this line, or export the file again as OBJ";
            (file, self.foreign_file(file, |bytes| parse_obj(bytes)?.surface(), help)?)
        } else {
            let file = said.dxf.as_ref()?;
            let help = "save it as ASCII or binary DXF";
            let drawing = self.foreign_file(file, |bytes| parse_dxf(bytes, None), help)?;
            if said.unit.is_none() {
                unit = drawing.unit.unwrap_or(1.0);
            }
            let corners = self.drawn_faces(file, said.layer.as_ref(), &drawing)?;
            (file, surface(&corners))
        };
        let left =
            if flat > 0 { format!("; left out {flat} without an area") } else { String::new() };
        self.note_import(file, &format!("read {}{left}", counted(triangles.len(), "triangle")));
        let points = points.iter().map(|p| unit * Vec3::from_array(*p) + shift).collect();
        Some((file, HeightField { points, triangles }))
    }

    /// The triangles of the faces of a drawing on a layer, in its unit; `None` after an error.
    fn drawn_faces(
        &mut self,
        file: &Name,
        layer: Option<&Name>,
        drawing: &Drawing,
    ) -> Option<Vec<[Vec3; 3]>> {
        let of = |name: &str| layer.is_none_or(|layer| layer.as_str() == name);
        let taken = drawing.faces.iter().filter(|face| of(&face.layer));
        let corners = taken.flat_map(|face| {
            let [a, b, c, d] = face.corners.map(Vec3::from_array);
            let both = if c == d { 1 } else { 2 };
            [[a, b, c], [a, c, d]].into_iter().take(both)
        });
        let corners: Vec<[Vec3; 3]> = corners.collect();
        if corners.is_empty() {
            let place = layer.map(|layer| format!(" on layer `{layer}`")).unwrap_or_default();
            let message = format!("`{file}` has no faces in space (3DFACE){place}");
            let mut layers: Vec<&str> = drawing.faces.iter().map(|f| f.layer.as_str()).collect();
            layers.sort_unstable();
            layers.dedup();
            let help = match layers.is_empty() {
                true => "write its surface as 3DFACE, or save it as STL or OBJ".to_owned(),
                false => format!("layers with faces: `{}`", layers.join("`, `")),
            };
            let error = Diagnostic::error("group.surface", message).at(file.span.clone());
            self.found.push(error.help(help));
            return None;
        }
        Some(corners)
    }
}
