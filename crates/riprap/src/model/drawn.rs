//! Outlines and traces from drawings and tessellations in the plane.

use std::collections::{BTreeMap, BTreeSet};

use riprap_geom::Vec2;
use riprap_geom::polygon::{self, Collinear};

use super::builder::Builder;
use super::generated::{Drawn, Generated};
use crate::numbers::counted;
use crate::scenario::csv_columns::Column;
use crate::scenario::diagnostic::suggest;
use crate::scenario::foreign::dxf::{Drawing, Outlines, Why, parse_dxf};
use crate::scenario::foreign::tess::{Cells, parse_tess};
use crate::scenario::foreign::{self, Place};
use crate::scenario::language::{Block, Cut, DrawnProfile, Geometry, Polygons, Traces};
use crate::scenario::quantity::PositiveLength;
use crate::scenario::read::{Provenance, with_unit};
use crate::scenario::units::Dim;
use crate::scenario::{Diagnostic, Name, Quantity};

/// Columns of the ends of traces.
const ENDS: [Column; 4] = [
    Column::needed(&["x1", "x_1", "x_start", "start_x", "from_x"], Dim::LENGTH, "m"),
    Column::needed(&["y1", "y_1", "y_start", "start_y", "from_y"], Dim::LENGTH, "m"),
    Column::needed(&["x2", "x_2", "x_end", "end_x", "to_x"], Dim::LENGTH, "m"),
    Column::needed(&["y2", "y_2", "y_end", "end_y", "to_y"], Dim::LENGTH, "m"),
];

/// What is asked of a drawing.
pub(super) struct Wanted<'a> {
    pub(super) file: &'a Name,
    pub(super) unit: Option<&'a Quantity<PositiveLength>>,
    pub(super) layers: Option<&'a [Name]>,
    pub(super) sagitta: Option<&'a Quantity<PositiveLength>>,
}

/// The length of the unit of a drawing, m, where the scene does not give it.
pub(super) struct OwnUnit {
    pub(super) value: f64,
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
            let unit = self.reading(key, said).unit_or(1.0, Provenance::Default, "");
            let Cells::Plane(cells) = cells else {
                let message = format!("`{file}` is a three-dimensional tessellation");
                let help =
                    "generate it with `neper -T -dim 2`, or use `mesh.tess` in [space.spatial]";
                self.error_at("file.tess", file, message, help);
                return None;
            };
            self.note_import(file, &format!("read {0} of {0} cells", cells.len()));
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
        let unit = self.reading(key, said).unit_or(own.value, own.from, own.why);
        let outlines = drawing.outlines();
        self.note_import(file, &outlines_text(&drawing, &outlines, unit));
        let mut drawn = Drawn::default();
        for line in outlines.closed {
            let number = drawn.outlines.len() as u32;
            let points = line.points.iter().map(|p| unit * Vec2::from(*p));
            drawn.outlines.push(points.collect());
            drawn.places.push(line.place);
            drawn.groups.entry(line.layer).or_default().push(number);
        }
        if drawn.outlines.is_empty() {
            let message = format!("`{file}` has no closed polylines on the layers read");
            let open = outlines.left_out.iter().chain(&drawing.left_out);
            let open = left_out_text(open);
            let help = format!(
                "close them in the drawing (closed flag, or coincident ends); left out {open}"
            );
            self.error_at("file.dxf", file, message, &help);
            return None;
        }
        Some(drawn)
    }

    /// The one closed outline of a drawing, corners [u, v] of a profile, m; `None` after an error.
    pub(super) fn drawn_profile(&mut self, said: &DrawnProfile) -> Option<Vec<Vec2>> {
        // Several keys ask for the same profile, which is read and complained about once.
        let key = format!("{said:?}");
        if let Some(known) = self.profiles.get(&key) {
            return known.clone();
        }
        let read = self.read_profile(said);
        self.profiles.insert(key, read.clone());
        read
    }

    fn read_profile(&mut self, said: &DrawnProfile) -> Option<Vec<Vec2>> {
        let file = &said.dxf;
        let wanted = Wanted {
            file,
            unit: said.unit.as_ref(),
            layers: said.layer.as_ref().map(std::slice::from_ref),
            sagitta: said.sagitta.as_ref(),
        };
        let (own, drawing) = self.drawing(&wanted)?;
        let unit = said.unit.as_ref().map_or(own.value, Quantity::si);
        let outlines = drawing.outlines();
        self.note_import(file, &outlines_text(&drawing, &outlines, unit));
        let [line] = &outlines.closed[..] else {
            let message = format!("`{file}` has {} closed outlines", outlines.closed.len());
            let layers = drawing.layers().join("`, `");
            let help = match outlines.closed.len() {
                0 => format!(
                    "close it in the drawing (closed flag, or coincident ends); left out {}",
                    left_out_text(outlines.left_out.iter().chain(&drawing.left_out))
                ),
                _ => format!("a profile is one: give its `layer`, of `{layers}`"),
            };
            self.error_at("file.dxf", file, message, &help);
            return None;
        };
        let origin = said.origin.as_ref().map_or(Vec2::ZERO, |[x, y]| Vec2::new(x.si(), y.si()));
        let corners: Vec<Vec2> =
            line.points.iter().map(|p| unit * Vec2::from(*p) - origin).collect();
        let (clean, _) = polygon::normalise(&corners, Collinear::Drop);
        if let Err(error) = polygon::validate(&clean) {
            let message = format!("`{file}`, {}: the outline is no profile: {error}", line.place);
            let help = "correct it in the drawing; a profile is simple and encloses an area";
            self.error_at("file.shape", file, message, help);
            return None;
        }
        Some(clean)
    }

    /// The lines of a drawing on the layers that are wanted, and the length of its unit.
    pub(super) fn drawing(&mut self, wanted: &Wanted) -> Option<(OwnUnit, Drawing)> {
        let file = wanted.file;
        // Arcs become pieces in the unit of the drawing, which may stand in the file only.
        let help = "save it as ASCII or binary DXF";
        let given = wanted.unit.map(Quantity::si);
        let sagitta = wanted.sagitta.map(Quantity::si);
        let first = self.foreign_file(file, |bytes| parse_dxf(bytes, None), help)?;
        let own = match first.unit {
            Some(value) => {
                OwnUnit { value, from: Provenance::Derived, why: "$INSUNITS of the drawing" }
            }
            None => OwnUnit {
                value: 1.0,
                from: Provenance::Default,
                why: "the drawing specifies no unit",
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
                let message = format!("`{file}` has no lines on layer `{layer}`");
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
        let read = foreign::read(&self.parsed.folder.join(file.as_str()), parse);
        self.as_read(file, read, help)
    }

    /// What was read for a file of another tool; `None` after an error.
    pub(super) fn as_read<T>(
        &mut self,
        file: &Name,
        read: Result<T, foreign::Refused>,
        help: &str,
    ) -> Option<T> {
        match read {
            Ok(read) => Some(read),
            Err(refused) => {
                let help = refused.help.unwrap_or_else(|| help.to_owned());
                self.error_at("file.shape", file, refused.message, &help);
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
                let help = "correct it in the drawing; outlines must be simple and enclose an area";
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
        let message =
            format!("group `{group}` of `{file}` has the same name as a [[blocks]] table");
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
        let Traces { unit, layers, sagitta, .. } = mapped;
        let wanted = Wanted {
            file,
            unit: unit.as_ref(),
            layers: layers.as_deref(),
            sagitta: sagitta.as_ref(),
        };
        let (own, drawing) = self.drawing(&wanted)?;
        let key = format!("blocks.{}.cut.traces", block.name);
        let unit = self.reading(key, mapped).unit_or(own.value, own.from, own.why);
        let open: Vec<_> = drawing.lines.iter().filter(|line| !line.closed).collect();
        let closed = drawing.lines.len() - open.len();
        self.note_import(file, &traces_text(&drawing, open.len(), closed));
        let pieces = open.iter().flat_map(|line| line.points.windows(2));
        let place = |p: [f64; 2]| unit * Vec2::from(p) - self.origin;
        let traces: Vec<[Vec2; 2]> =
            pieces.map(|pair| [place(pair[0]), place(pair[1])]).filter(|[a, b]| a != b).collect();
        if traces.is_empty() {
            let message = format!("`{file}` has no lines or open polylines on the layers read");
            let help = "closed polylines are outlines; read them with `polygons.dxf`";
            self.error_at("file.dxf", file, message, help);
            return None;
        }
        Some(traces)
    }

    fn traces_of_csv(&mut self, csv: &Name) -> Option<Vec<[Vec2; 2]>> {
        let table = self.table(csv, &ENDS)?;
        let [x1, y1, x2, y2] = std::array::from_fn(|k| table.values(k));
        let mut traces = Vec::with_capacity(x1.len());
        for (k, line) in table.lines.iter().enumerate() {
            let ends = [Vec2::new(x1[k], y1[k]), Vec2::new(x2[k], y2[k])];
            if ends[0] == ends[1] {
                let message = format!("`{csv}`, line {line}: trace {} has zero length", k + 1);
                let found = Diagnostic::error("geometry.joints", message);
                let help = "give the trace two different ends, or remove it";
                self.found.push(found.at(csv.span.clone()).help(help));
                return None;
            }
            traces.push(ends.map(|p| p - self.origin));
        }
        Some(traces)
    }
}

/// What is left out of a drawing, by kind and reason.
fn left_out_text<'a>(all: impl Iterator<Item = (&'a (String, Why), &'a usize)>) -> String {
    let mut reasons: BTreeMap<Why, Vec<String>> = BTreeMap::new();
    for ((kind, why), count) in all {
        reasons.entry(why).or_default().push(format!("{count} {kind}"));
    }
    let reasons = reasons.into_iter();
    let reasons: Vec<String> =
        reasons.map(|(why, kinds)| format!("{} ({why})", kinds.join(", "))).collect();
    match reasons.is_empty() {
        true => "nothing".to_owned(),
        false => reasons.join("; "),
    }
}

/// What became of the entities of a drawing; `unit` is the length of its unit, m.
fn outlines_text(drawing: &Drawing, outlines: &Outlines, unit: f64) -> String {
    let left = || outlines.left_out.iter().chain(&drawing.left_out);
    let all = outlines.used + left().map(|(_, count)| count).sum::<usize>();
    let mut words = format!(
        "read {} of {all} entities as {}",
        outlines.used,
        counted(outlines.closed.len(), "outline")
    );
    let [chains, lines] = outlines.joined;
    if chains > 0 {
        words.push_str(&format!(
            "; {} assembled from {}",
            counted(chains, "outline"),
            counted(lines, "line")
        ));
    }
    if outlines.over_gaps > 0 {
        words.push_str(&format!("; closed {}", counted(outlines.over_gaps, "open polyline")));
    }
    if outlines.largest_gap > 0.0 {
        let gap = with_unit(unit * outlines.largest_gap, "m");
        words.push_str(&format!("; ends up to {gap} apart were joined"));
    }
    if drawing.inserted > 0 {
        words.push_str(&format!("; expanded {}", counted(drawing.inserted, "block reference")));
    }
    let round = outlines.closed.iter().filter(|line| line.kind == "CIRCLE");
    let corners: BTreeSet<usize> = round.clone().map(|line| line.points.len()).collect();
    if let (Some(least), Some(most)) = (corners.first(), corners.last()) {
        let many = match least == most {
            true => least.to_string(),
            false => format!("{least} to {most}"),
        };
        words.push_str(&format!(
            "; {} as polygons with {many} corners",
            counted(round.count(), "circle")
        ));
    }
    if outlines.healed > 0 {
        let healed = outlines.healed;
        words.push_str(&format!("; {healed} edges of round-off length were collapsed"));
    }
    if left().next().is_some() {
        words.push_str(&format!("; left out {}", left_out_text(left())));
    }
    if let Some(gap) = outlines.smallest_open {
        let gap = with_unit(unit * gap, "m");
        words.push_str(&format!("; the smallest gap of an open polyline is {gap}"));
    }
    words
}

/// What became of the entities of a drawing with traces.
fn traces_text(drawing: &Drawing, open: usize, closed: usize) -> String {
    let mut left = drawing.left_out.clone();
    if closed > 0 {
        left.insert(("closed lines".to_owned(), "outlines, not traces"), closed);
    }
    let all = open + left.values().sum::<usize>();
    let mut words = format!("read {open} of {all} entities as traces");
    if !left.is_empty() {
        words.push_str(&format!("; left out {}", left_out_text(left.iter())));
    }
    words
}
