//! Outlines and traces from drawings and tessellations in the plane.

use riprap_geom::Vec2;
use riprap_geom::polygon::{self, Collinear};

use super::builder::Builder;
use super::generated::{Drawn, Generated};
use crate::scenario::diagnostic::suggest;
use crate::scenario::foreign::dxf::{Drawing, parse_dxf};
use crate::scenario::foreign::tess::{Cells, parse_tess};
use crate::scenario::foreign::{self, Place};
use crate::scenario::language::{Block, Cut, Geometry, Polygons, Traces};
use crate::scenario::quantity::PositiveLength;
use crate::scenario::read::Provenance;
use crate::scenario::{Diagnostic, Name, Quantity};

/// What is asked of a drawing.
struct Wanted<'a> {
    file: &'a Name,
    unit: Option<&'a Quantity<PositiveLength>>,
    layers: Option<&'a [Name]>,
    sagitta: Option<&'a Quantity<PositiveLength>>,
}

/// The length of the unit of a drawing, m, where the scene does not give it.
struct OwnUnit {
    value: f64,
    from: Provenance,
    why: &'static str,
}

impl Builder<'_> {
    /// Reads the polygons of all files: where they are decides about the origin.
    pub(super) fn draw(&mut self) {
        for block in &self.parsed.scenario.blocks {
            if let Some(Geometry::Polygons(said)) = block.geometry()
                && let Some(drawn) = self.read_polygons(block, said)
            {
                self.drawn.insert(block.name.text.clone(), drawn);
            }
        }
    }

    fn read_polygons(&mut self, block: &Block, said: &Polygons) -> Option<Drawn> {
        let key = format!("blocks.{}.polygons", block.name);
        if let Some(file) = &said.tess {
            let cells =
                self.foreign_file(file, parse_tess, "use `mesh.tess` in [space.spatial]")?;
            let unit = self
                .reading(key, said)
                .unit_or(1.0, Provenance::Default, "");
            let Cells::Plane(cells) = cells else {
                let message = format!("`{file}` has cells in three dimensions");
                let help =
                    "make them with `neper -T -dim 2`, or use `mesh.tess` in [space.spatial]";
                self.error_at("file.tess", file, message, help);
                return None;
            };
            let mut drawn = Drawn::default();
            for cell in cells {
                let points = cell.points.iter().map(|p| unit * Vec2::from(*p));
                drawn.outlines.push(points.collect());
                drawn.places.push(Place::Line(cell.line));
            }
            return Some(drawn);
        }
        let file = said.dxf.as_ref()?;
        let wanted = Wanted {
            file,
            unit: said.unit.as_ref(),
            layers: said.layers.as_deref(),
            sagitta: said.sagitta.as_ref(),
        };
        let (own, drawing) = self.drawing(&wanted)?;
        let unit = self
            .reading(key, said)
            .unit_or(own.value, own.from, own.why);
        let mut drawn = Drawn::default();
        for line in drawing.lines.into_iter().filter(|line| line.closed) {
            let number = drawn.outlines.len() as u32;
            let points = line.points.iter().map(|p| unit * Vec2::from(*p));
            drawn.outlines.push(points.collect());
            drawn.places.push(line.place);
            drawn.groups.entry(line.layer).or_default().push(number);
        }
        if drawn.outlines.is_empty() {
            let message = format!("`{file}` has no closed polylines there");
            let help = "close them in the drawing (flag or equal ends); blocks of the drawing (INSERT) are not read: explode them";
            self.error_at("file.dxf", file, message, help);
            return None;
        }
        Some(drawn)
    }

    /// The lines of a drawing on the layers that are wanted, and the length of its unit.
    fn drawing(&mut self, wanted: &Wanted) -> Option<(OwnUnit, Drawing)> {
        let file = wanted.file;
        // Arcs become pieces in the unit of the drawing, which may stand in the file only.
        let help = "save it as DXF, text or binary";
        let given = wanted.unit.map(Quantity::si);
        let sagitta = wanted.sagitta.map(Quantity::si);
        let first = self.foreign_file(file, |bytes| parse_dxf(bytes, None), help)?;
        let own = match first.unit {
            Some(value) => OwnUnit {
                value,
                from: Provenance::Derived,
                why: "$INSUNITS of the drawing",
            },
            None => OwnUnit {
                value: 1.0,
                from: Provenance::Default,
                why: "the drawing names no unit",
            },
        };
        let unit = given.unwrap_or(own.value);
        let mut drawing = match sagitta {
            Some(sagitta) => {
                self.foreign_file(file, |bytes| parse_dxf(bytes, Some(sagitta / unit)), help)?
            }
            None => first,
        };
        if let Some(layers) = wanted.layers {
            let known = drawing.layers();
            let unknown = layers.iter().find(|l| !known.contains(&l.as_str()));
            if let Some(layer) = unknown {
                let message = format!("`{file}` has no lines on a layer `{layer}`");
                let mut error = Diagnostic::error("file.dxf", message).at(layer.span.clone());
                error.help = suggest(layer.as_str(), known);
                self.found.push(error);
                return None;
            }
            let taken = |layer: &str| layers.iter().any(|l| l.as_str() == layer);
            drawing.lines.retain(|line| taken(&line.layer));
        }
        Some((own, drawing))
    }

    /// What a file of another tool holds; `None` after an error.
    pub(super) fn foreign_file<T>(
        &mut self,
        file: &Name,
        parse: impl FnOnce(&[u8]) -> Result<T, foreign::FileError>,
        help: &str,
    ) -> Option<T> {
        match foreign::read(&self.parsed.folder.join(file.as_str()), parse) {
            Ok(read) => Some(read),
            Err(message) => {
                let help = format!("{help}; paths are seen from the folder of the scenario file");
                self.error_at("file.shape", file, message, &help);
                None
            }
        }
    }

    /// The blocks of a file that was read before.
    pub(super) fn polygons(&mut self, block: &Block, said: &Polygons) -> Option<Generated> {
        let drawn = self.drawn.remove(block.name.as_str())?;
        let file = said.dxf.as_ref().or(said.tess.as_ref())?;
        let mut outlines = Vec::with_capacity(drawn.outlines.len());
        for (outline, place) in drawn.outlines.into_iter().zip(drawn.places) {
            let outline: Vec<Vec2> = outline.iter().map(|p| *p - self.origin).collect();
            let (clean, _) = polygon::normalise(&outline, Collinear::Keep);
            if let Err(error) = polygon::validate(&clean) {
                let number = outlines.len() + 1;
                let message =
                    format!("`{file}`, {place}: polygon {number} cannot be a block: {error}");
                let help = "correct it in the drawing; outlines are simple and have an area";
                self.error_at("file.shape", file, message, help);
                return None;
            }
            outlines.push(clean);
        }
        for group in drawn.groups.keys() {
            self.group_of_file(block, file, group)?;
        }
        let mut made = Generated::several(outlines);
        made.groups = drawn.groups.into_iter().collect();
        Some(made)
    }

    /// Whether a group of a file has a name that is free; `None` after an error.
    pub(super) fn group_of_file(&mut self, block: &Block, file: &Name, group: &str) -> Option<()> {
        let mut blocks = self.parsed.scenario.blocks.iter();
        if group == block.name.as_str() || !blocks.any(|b| b.name.as_str() == group) {
            return Some(());
        }
        let message = format!("the group `{group}` of `{file}` has the name of a [[blocks]] table");
        self.error_at("file.group", file, message, "rename one of them");
        None
    }

    /// Mapped traces in local coordinates, m; `None` after an error.
    pub(super) fn traces(&mut self, block: &Block, cut: &Cut) -> Option<Vec<[Vec2; 2]>> {
        let Some(mapped) = &cut.traces else {
            return Some(Vec::new());
        };
        if let Some(csv) = &mapped.csv {
            return self.traces_of_csv(csv);
        }
        let file = mapped.dxf.as_ref()?;
        let Traces {
            unit,
            layers,
            sagitta,
            ..
        } = mapped;
        let wanted = Wanted {
            file,
            unit: unit.as_ref(),
            layers: layers.as_deref(),
            sagitta: sagitta.as_ref(),
        };
        let (own, drawing) = self.drawing(&wanted)?;
        let key = format!("blocks.{}.cut.traces", block.name);
        let unit = self
            .reading(key, mapped)
            .unit_or(own.value, own.from, own.why);
        let open = drawing.lines.iter().filter(|line| !line.closed);
        let pieces = open.flat_map(|line| line.points.windows(2));
        let place = |p: [f64; 2]| unit * Vec2::from(p) - self.origin;
        let traces: Vec<[Vec2; 2]> = pieces
            .map(|pair| [place(pair[0]), place(pair[1])])
            .filter(|[a, b]| a != b)
            .collect();
        if traces.is_empty() {
            let message = format!("`{file}` has no lines or open polylines there");
            let help = "closed polylines are outlines: use `polygons.dxf` for them";
            self.error_at("file.dxf", file, message, help);
            return None;
        }
        Some(traces)
    }

    fn traces_of_csv(&mut self, csv: &Name) -> Option<Vec<[Vec2; 2]>> {
        let [x1, y1, x2, y2] = self.columns(csv, ["x1_m", "y1_m", "x2_m", "y2_m"])?;
        let mut traces = Vec::with_capacity(x1.len());
        for k in 0..x1.len() {
            let ends = [Vec2::new(x1[k], y1[k]), Vec2::new(x2[k], y2[k])];
            if ends[0] == ends[1] {
                let message = format!("trace {} has no length", k + 1);
                let found = Diagnostic::error("geometry.joints", message);
                let help = "give each trace two different ends, or leave it out";
                self.found.push(found.at(csv.span.clone()).help(help));
                return None;
            }
            traces.push(ends.map(|p| p - self.origin));
        }
        Some(traces)
    }
}
