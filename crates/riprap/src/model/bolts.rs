//! Bolts: patterns, files, and whether they are in rock. In the plane z is 0, and a metre of thickness has its share of a bolt.

use std::f64::consts::PI;

use riprap_core::numbers::counted;
use riprap_geom::{Vec2, Vec3};

use crate::laws::bolt::Design;
use crate::laws::bolt::place::{self, Misplaced};
use crate::model::builder::Builder;
use crate::model::memory;
use crate::scenario::csv_columns::Column;
use crate::scenario::language::{self, Dowel, Plate};
use crate::scenario::read::{Provenance, with_unit};
use crate::scenario::units::Dim;
use crate::scenario::vectors::InSpace;
use crate::scenario::{Diagnostic, Name, Quantity, Span};
use crate::{planar, spatial};

/// Most bolts of one table.
const MOST: usize = 100_000;

/// Most pieces of one bolt, and of all bolts of a table: a cable of a kilometre in pieces of a centimetre.
const MOST_PIECES: [f64; 2] = [1e5, 1e8];

/// Columns of a file of bolts; in the plane without the third of each end.
const COLUMNS: [Column; 6] = [
    Column::needed(&["head_x", "head_easting", "collar_x"], Dim::LENGTH, "m"),
    Column::needed(&["head_y", "head_northing", "collar_y"], Dim::LENGTH, "m"),
    Column::needed(&["head_z", "head_elevation", "collar_z"], Dim::LENGTH, "m"),
    Column::needed(&["toe_x", "toe_easting"], Dim::LENGTH, "m"),
    Column::needed(&["toe_y", "toe_northing"], Dim::LENGTH, "m"),
    Column::needed(&["toe_z", "toe_elevation"], Dim::LENGTH, "m"),
];

/// A bolt with the place in the text that says where it is.
struct Line {
    head: Vec3,
    toe: Vec3,
    span: Span,
}

impl Builder<'_> {
    /// Reads all bolts; phases install them.
    pub(in crate::model) fn bolts(&mut self) {
        for (k, said) in self.parsed.scenario.bolts.iter().enumerate() {
            let Some(lines) = self.bolt_lines(said).and_then(|all| self.with_collars(said, all))
            else {
                // What names them is no second error.
                self.directory.bolts.push(said.name.text.clone());
                continue;
            };
            let (design, spacing) = self.design(k, said);
            let many = lines.len() > 1 || said.csv.is_some() || said.pattern.is_some();
            let name = |number: usize| match many {
                true => format!("{}.{number}", said.name),
                false => said.name.text.clone(),
            };
            // Also of those that are refused, so that what names them is no second error.
            self.directory.bolts.extend((1..=lines.len()).map(name));
            if !self.has_room_for_pieces(said, &lines, design.piece)
                || !self.lengths_fit(said, &lines, design.piece)
            {
                continue;
            }
            for (number, line) in (1..).zip(lines) {
                let name = name(number);
                if !self.parsed.has_moved {
                    self.bolt_in_rock(said, &name, &line, &design);
                }
                let [head, toe] = [line.head, line.toe].map(|end| self.near(end));
                match self.space {
                    InSpace::Planar => self.setup.bolts.push(planar::setup::Bolt {
                        name,
                        head: flat(head),
                        toe: flat(toe),
                        design,
                        spacing,
                    }),
                    InSpace::Spatial => {
                        self.spatial.bolts.push(spatial::setup::Bolt { name, head, toe, design });
                    }
                }
            }
        }
    }

    /// Whether there is room for the pieces of the bolts of a table, before any is made.
    fn has_room_for_pieces(&mut self, said: &language::Bolt, lines: &[Line], piece: f64) -> bool {
        let pieces = |line: &Line| (line.head.distance(line.toe) / piece).ceil();
        let longest = lines.iter().map(pieces).fold(0.0, f64::max);
        let all: f64 = lines.iter().map(pieces).sum();
        if longest <= MOST_PIECES[0] && all <= MOST_PIECES[1] && memory::holds_pieces(all) {
            return true;
        }
        let message = if longest > MOST_PIECES[0] {
            format!(
                "bolt `{}` would have {longest:.1e} pieces; at most {:.0e} are allowed for one bolt",
                said.name, MOST_PIECES[0]
            )
        } else {
            format!("bolts `{}` would have {all:.1e} pieces in total", said.name)
        };
        let at = said.piece.as_ref().map_or(&said.name.span, |piece| &piece.span);
        let help = "give a longer `piece`: a tenth of the load transfer length of the grout (`sqrt(E A / k)`) is fine enough";
        self.error_at("bolt.pieces", at.clone(), message, help);
        false
    }

    /// Whether pieces and grouted length are no longer than the bolts: a slip of the pen in a unit would leave a bar without grout.
    fn lengths_fit(&mut self, said: &language::Bolt, lines: &[Line], piece: f64) -> bool {
        let length = |line: &Line| line.head.distance(line.toe);
        let shortest = lines.iter().map(length).fold(f64::INFINITY, f64::min);
        let longest = lines.iter().map(length).fold(0.0, f64::max);
        let mut fits = true;
        let mut wrong = |at: &Span, what: &str, given: f64, bolt: f64, help: &str| {
            let message = format!(
                "{what} of bolt `{}` is {}, the bolt {}",
                said.name,
                with_unit(given, "m"),
                with_unit(bolt, "m")
            );
            self.error_at("bolt.length", at.clone(), message, help);
            fits = false;
        };
        if let Some(said) = said.piece.as_ref().filter(|_| piece > shortest) {
            let help =
                "a tenth of the load transfer length of the grout (`sqrt(E A / k)`) is fine enough";
            wrong(&said.span, "the length of the pieces", piece, shortest, help);
        }
        // What a table of other lengths calls all of it, to the last digit.
        let all = |grouted: f64| grouted <= longest * (1.0 + 1e-9);
        if let Some(said) = said.grout.length.as_ref().filter(|said| !all(said.si())) {
            let help = "leave it out: a bolt is grouted along all of its length by default";
            wrong(&said.span, "the grouted length", said.si(), longest, help);
        }
        fits
    }

    /// Numbers of the bolts that a phase installs.
    pub(in crate::model) fn installs(&self, phase: &Name, first: bool) -> Vec<u32> {
        let mut all = Vec::new();
        for said in &self.parsed.scenario.bolts {
            let here = match &said.phase {
                Some(name) => name.as_str() == phase.as_str(),
                None => first,
            };
            if here {
                all.extend(self.directory.bolts_of(said.name.as_str()));
            }
        }
        all.sort_unstable();
        all
    }

    /// A place of the file in local coordinates.
    fn near(&self, place: Vec3) -> Vec3 {
        match self.space {
            InSpace::Planar => place - Vec3::new(self.origin.x, self.origin.y, 0.0),
            InSpace::Spatial => place - self.spatial.origin,
        }
    }

    /// What a bolt is made of, in the plane per metre of thickness, and the spacing there, m.
    fn design(&mut self, k: usize, said: &language::Bolt) -> (Design, f64) {
        let steel = &said.steel;
        let flat = self.space == InSpace::Planar;
        let mut read = self.reading(format!("bolts.{k}"), said);
        let piece = read.piece();
        let pretension = read.pretension().unwrap_or(0.0);
        let spacing = if flat { read.spacing() } else { 1.0 };
        let mut read = read.within("steel", steel);
        let (young, share) = (read.young(), read.hardening());
        let area = match (&steel.diameter, &steel.area) {
            (Some(d), _) => 0.25 * PI * d.si() * d.si(),
            (None, area) => area.as_ref().map_or(0.0, Quantity::si),
        };
        let axial = young * area;
        let or_none = |limit: Option<f64>| limit.unwrap_or(f64::INFINITY);
        self.explain(
            format!("bolts.{k}.steel.axial_stiffness"),
            with_unit(axial, "N"),
            Provenance::Derived,
            "Young's modulus times area",
        );
        let si = |limit: &Option<Quantity<_>>| or_none(limit.as_ref().map(Quantity::si));
        let capacity = |plate: &Plate| si(&plate.capacity);
        let dowel = |dowel: &Dowel| [dowel.stiffness.si(), si(&dowel.strength)];
        let one = Design {
            axial,
            yields: si(&steel.yield_force),
            hardening: share * axial,
            breaks: or_none(steel.rupture.as_ref().map(Quantity::si)),
            grout: said.grout.stiffness.si(),
            bond: or_none(said.grout.strength.as_ref().map(Quantity::si)),
            grouted: or_none(said.grout.length.as_ref().map(Quantity::si)),
            plate: said.plate.as_ref().map(capacity),
            pretension,
            dowel: said.dowel.as_ref().map(dowel),
            piece,
        };
        (one.per_spacing(spacing), spacing)
    }

    /// Ends of all bolts of a table, in the coordinates of the file; `None` after an error.
    fn bolt_lines(&mut self, said: &language::Bolt) -> Option<Vec<Line>> {
        if let Some(csv) = &said.csv {
            return self.bolts_of_file(csv);
        }
        if let Some(pattern) = &said.pattern {
            return self.bolts_on_walls(said, pattern);
        }
        let (head, toe) = (said.head.as_ref()?, said.toe.as_ref()?);
        let count = said.repeat.iter().map(|row| row.count as usize);
        // Before any is made: a slip of the pen in a count must not fill the memory.
        if count.fold(1, usize::saturating_mul) > MOST {
            let message = format!("table `{}` would make more than {MOST} bolts", said.name);
            self.error_at("bolt.many", &said.name, message, "use fewer bolts");
            return None;
        }
        for row in said.repeat.iter().filter(|row| row.count > 1) {
            if Vec3::from(row.step.xyz()) == Vec3::ZERO {
                let message = format!("the copies of bolt `{}` lie in one place", said.name);
                let help = "give `step` a length, or take `repeat` away";
                self.error_at("bolt.many", row.step.span.clone(), message, help);
                return None;
            }
        }
        let mut lines = vec![Line {
            head: Vec3::from(head.xyz()),
            toe: Vec3::from(toe.xyz()),
            span: head.span.clone(),
        }];
        for row in &said.repeat {
            let step = Vec3::from(row.step.xyz());
            // Each row repeats all that is there so far: two of them make a pattern.
            let copies = (0..row.count).flat_map(|k| {
                let shift = k as f64 * step;
                lines.iter().map(move |line| Line {
                    head: line.head + shift,
                    toe: line.toe + shift,
                    span: line.span.clone(),
                })
            });
            lines = copies.collect();
        }
        Some(lines)
    }

    /// Bolts across the walls of an excavation, in the coordinates of the file.
    fn bolts_on_walls(
        &mut self,
        said: &language::Bolt,
        pattern: &language::BoltPattern,
    ) -> Option<Vec<Line>> {
        let groups = &self.parsed.scenario.groups;
        let name = &pattern.group;
        let Some(excavation) = groups.get(name.as_str()).and_then(|of| of.excavation.as_ref())
        else {
            let known = groups.iter().filter(|(_, of)| of.excavation.is_some());
            let known: Vec<&str> = known.map(|(name, _)| name.as_str()).collect();
            self.found.push(Diagnostic::unknown("group with an `excavation`", name, known));
            return None;
        };
        let opening = self.opening(excavation, Vec3::ZERO)?;
        let half_angle = self.reading(format!("bolts.{}.pattern", said.name), pattern).half_angle();
        let [length, spacing, rows] =
            [&pattern.length, &pattern.spacing, &pattern.rows].map(Quantity::si);
        if opening.bolts_about(spacing, rows) > MOST as f64 {
            let message = format!("table `{}` would make more than {MOST} bolts", said.name);
            self.error_at("bolt.many", pattern.spacing.span.clone(), message, "use fewer bolts");
            return None;
        }
        let all = opening.bolts([spacing, rows, length], half_angle);
        if all.is_empty() {
            let message = format!("no wall of `{name}` faces up by `half_angle`");
            let at = pattern.half_angle.as_ref().map_or(&name.span, |angle| &angle.span);
            let help = "give a larger `half_angle`: of bolts with the upward direction";
            self.error_at("bolt.place", at.clone(), message, help);
            return None;
        }
        let span = &name.span;
        Some(all.into_iter().map(|(head, toe)| Line { head, toe, span: span.clone() }).collect())
    }

    fn bolts_of_file(&mut self, csv: &Name) -> Option<Vec<Line>> {
        let mut columns = COLUMNS;
        for k in [2, 5] {
            columns[k].needed = self.space == InSpace::Spatial;
        }
        let table = self.table(csv, &columns)?;
        let mut lines = Vec::new();
        for (k, line) in table.lines.iter().enumerate() {
            let end = |first: usize| {
                let place = [0, 1, 2].map(|axis| match self.space {
                    // Depths of a file in space are no part of the plane.
                    InSpace::Planar if axis == 2 => 0.0,
                    InSpace::Planar | InSpace::Spatial => table.values(first + axis)[k],
                });
                Vec3::from(place)
            };
            let (head, toe) = (end(0), end(3));
            if head == toe {
                let message = format!("`{csv}`, line {line}: bolt {} has no length", k + 1);
                self.error_at("file.csv", csv, message, "head and toe must be different points");
                return None;
            }
            lines.push(Line { head, toe, span: csv.span.clone() });
        }
        Some(lines)
    }

    /// Whether a bolt is in the rock of the blocks as they are given, without those that are removed by then.
    fn bolt_in_rock(&mut self, said: &language::Bolt, name: &str, line: &Line, design: &Design) {
        let length = line.head.distance(line.toe);
        let spans = self.spans(line, &self.gone_before(said));
        let plate = design.plate.is_some();
        let Err(reason) = place::order(spans, length, design.grouted, plate) else {
            return;
        };
        let help = match reason {
            Misplaced::Outside => "check its ends and their units",
            Misplaced::Head { .. } => "place the head on the rock face",
            Misplaced::Buried => "place the head on the rock face, or leave out `plate`",
            Misplaced::Toe { .. } => "place the toe inside the rock",
            Misplaced::NoGrout => "use a longer grouted length, or a longer bolt",
        };
        let message = format!("bolt `{name}`: {reason}");
        self.error_at("bolt.place", line.span.clone(), message, help);
    }

    /// The bolts whose collar lies in a block of the condition of their table; `None` after an error.
    fn with_collars(&mut self, said: &language::Bolt, lines: Vec<Line>) -> Option<Vec<Line>> {
        let Some(condition) = &said.condition else { return Some(lines) };
        let chosen = match self.directory.blocks(condition) {
            Ok(chosen) => chosen,
            Err(wrong) => {
                self.found.push(*wrong);
                return None;
            }
        };
        let gone = self.gone_before(said);
        let collar =
            |line: &Line| place::collar(&self.spans(line, &gone), line.head.distance(line.toe));
        let all = lines.len();
        let holds = |line: &Line| collar(line).is_some_and(|b| chosen.binary_search(&b).is_ok());
        let kept: Vec<Line> = lines.into_iter().filter(holds).collect();
        if kept.is_empty() {
            let message = format!("no bolt of `{}` has its collar in `{condition}`", said.name);
            let help = format!(
                "it has {}; none of the {all} bolts begins there",
                counted(chosen.len(), "block")
            );
            self.error_at("bolt.place", condition, message, &help);
            return None;
        }
        Some(kept)
    }

    /// Blocks that are removed before a bolt is installed, or with it.
    fn gone_before(&self, said: &language::Bolt) -> Vec<bool> {
        let mut gone = vec![false; self.spatial.blocks.len().max(self.setup.blocks.len())];
        for (k, phase) in self.parsed.scenario.phases.iter().enumerate() {
            let names = self.directory.all(&phase.remove);
            for b in names.unwrap_or_default() {
                gone[b as usize] = true;
            }
            let here = said.phase.as_ref().map_or(k == 0, |p| p.as_str() == phase.name.as_str());
            // After the blocks of this phase: it takes them out before it installs.
            if here {
                break;
            }
        }
        gone
    }

    /// Where a bolt is in blocks that are there: from and to along it, m.
    fn spans(&self, line: &Line, gone: &[bool]) -> Vec<([f64; 2], u32)> {
        let [head, toe] = [line.head, line.toe].map(|end| self.near(end));
        let length = head.distance(toe);
        let axis = (toe - head) / length;
        let range = place::range(length);
        let solids = (0u32..).zip(&self.spatial.blocks).filter_map(|(b, block)| {
            let span = spatial::bolts::place::span(&block.shape, head, axis, range)?;
            Some((span, b))
        });
        let polygons = (0u32..).zip(&self.setup.blocks).flat_map(|(b, block)| {
            let (from, along) = (flat(head), flat(axis));
            let spans = planar::bolts::place::spans(&block.vertices, from, along, range);
            spans.into_iter().map(move |span| (span, b))
        });
        let here = |(_, b): &([f64; 2], u32)| !gone[*b as usize];
        solids.chain(polygons).filter(here).collect()
    }
}

/// A place or direction in the plane.
fn flat(v: Vec3) -> Vec2 {
    Vec2::new(v.x, v.y)
}
