//! Random cells that grow with the distance from charges.
//!
//! The room of a charge is made with the cells, so that its volume is right whatever the other cells are. Places of charges are in the
//! coordinates of the scene: they are brought to where the table's cells stand before these are shifted and turned.

use riprap_geom::Vec3;
use riprap_geom::polyhedron::{Charge, Finest, Grading, graded_cells};

use super::global;
use super::pattern::span_of_pattern;
use super::shapes::{MOST_CELLS, box_of, whole};
use super::turn::Turn;
use crate::model::builder::Builder;
use crate::numbers::counted;
use crate::scenario::language::{
    Around, Block, CouplingWord, Explosive, GasCavity, Geometry, Graded, Grid, GridCells, Place,
    Source,
};
use crate::scenario::quantity::Span;
use crate::scenario::read::{Provenance, with_unit};
use crate::scenario::vectors::unit;
use crate::scenario::words::WordOr;
use crate::scenario::{Name, Quantity};
use crate::spatial::setup::Shape;

/// Cells at a charge are from this share of its diameter ...
const FINEST: f64 = 0.5;
/// ... to this many times it wide: its walls are one ring of cells.
const COARSEST: f64 = 2.0;
/// An end of a charge may lie on a side of the cells to this share of their size.
const ON_SIDE: f64 = 1e-9;

/// The graded cells of a table.
fn graded_of(block: &Block) -> Option<&Graded> {
    let Some(Geometry::Grid(Grid::Cells(cells))) = block.geometry() else { return None };
    cells.graded.as_ref()
}

/// Whether the cells of a table are finest at a source.
pub(super) fn is_graded_at(block: &Block, source: &Name) -> bool {
    graded_of(block).is_some_and(|graded| match &graded.at {
        None => true,
        Some(Around::Source(name)) => name == source,
        Some(Around::Point(_) | Around::Place(..)) => false,
    })
}

/// Where cells are finest, in the coordinates of the scene, and what is charged there.
#[derive(Default)]
struct Places {
    finest: Vec<Finest>,
    charges: Vec<(String, Span, Charge)>,
}

impl Builder<'_> {
    /// The cells of a table; `None` after an error.
    pub(super) fn graded(
        &mut self,
        block: &Block,
        said: &GridCells,
        graded: &Graded,
        shift: Vec3,
    ) -> Option<Vec<Shape>> {
        let mut places = self.finest_places(graded)?;
        self.bring_home(block, said, shift, &mut places);
        let charges = self.charges_within(block, said, &places)?;
        let grading = self.grading(block, graded, places.finest, &charges)?;
        let (min, max) = box_of(said);
        self.fits_charges(&grading, graded, &charges, (min, max))?;
        let count = grading.count(min, max, MOST_CELLS);
        if !self.few_enough(block, graded, &grading, count, (min, max)) {
            return None;
        }
        let mut read = self.reading(format!("blocks.{}.grid.cells", block.name), said);
        let (seed, relax, smallest) = (read.seed(), read.relax(), read.smallest_edge());
        let rooms: Vec<Charge> = charges.iter().map(|(_, _, charge)| *charge).collect();
        let made = whole(said).and_then(|whole| {
            graded_cells(&whole, &grading, &rooms, seed, relax as usize, smallest)
        });
        let shapes = self.made_cells(block, made, shift)?;
        self.summary.fitted.push(format!(
            "{}: {} graded cells, from {} to {} over {}{}",
            block.name,
            shapes.len(),
            with_unit(grading.from, "m"),
            with_unit(grading.to, "m"),
            with_unit(grading.over, "m"),
            match rooms.len() {
                0 => String::new(),
                n => format!(", room for {}", counted(n, "charge")),
            },
        ));
        Some(shapes)
    }

    /// Where the cells of a table are finest; `None` after an error.
    fn finest_places(&mut self, graded: &Graded) -> Option<Places> {
        let mut places = Places::default();
        let line = |line: &crate::scenario::language::Segment| {
            Finest::Segment(global(&line.from), global(&line.to))
        };
        let only = match &graded.at {
            None => None,
            Some(Around::Source(name)) => Some(name),
            Some(Around::Point(point)) => {
                let at = Vec3::from(point.xyz());
                places.finest.push(Finest::Segment(at, at));
                return Some(places);
            }
            Some(Around::Place(place, _)) => {
                places.finest.push(match &**place {
                    Place::Line(of) => line(of),
                    Place::Plane(plane) => {
                        Finest::Plane(global(&plane.at), Vec3::from(unit(&plane.normal)?))
                    }
                    Place::Ball(ball) => Finest::Ball(global(&ball.centre), ball.radius.si()),
                    Place::Box(region) => {
                        Finest::Box(region.min.xyz().into(), region.max.xyz().into())
                    }
                    Place::All(_) => return None, // reported by the rules of the language
                });
                return Some(places);
            }
        };
        let scenario = &self.parsed.scenario;
        for (name, source) in scenario.sources.iter().filter(|(n, _)| only.is_none_or(|o| o == *n))
        {
            match source {
                Source::GasCavity(gas) => self.room_of(name, gas, &mut places)?,
                Source::PressureCavity(cavity) => match (&cavity.centre, &cavity.line) {
                    (Some(centre), _) => {
                        places.finest.push(Finest::Segment(global(centre), global(centre)));
                    }
                    (None, Some(of)) => places.finest.push(line(of)),
                    (None, None) => {}
                },
            }
        }
        if places.finest.is_empty() {
            let message = "no source has a place at which the cells could be finest";
            let help = "give `at` a point or a place, or a source `centre`, `line` or `pattern`";
            let span = graded.at.as_ref().map_or(&graded.to.span, Around::span);
            self.error_at("geometry.graded", span.clone(), message, help);
            return None;
        }
        Some(places)
    }

    /// The place of a charge, and the room that it needs.
    fn room_of(&mut self, name: &Name, gas: &GasCavity, places: &mut Places) -> Option<()> {
        // What is missing is reported by the rules of the language, or with the source.
        let density = self.explosive(gas).and_then(Explosive::charge_density);
        let decoupled = matches!(&gas.coupling, Some(WordOr::Word(CouplingWord::Decoupled, _)));
        let mut enter = |name: String, span: Span, from: Vec3, to: Vec3, mass: Option<f64>| {
            places.finest.push(Finest::Segment(from, to));
            // A decoupled charge is smaller than its hole: how much is not known.
            if let (Some(mass), Some(density), false) = (mass, density, decoupled) {
                places.charges.push((name, span, Charge { from, to, volume: mass / density }));
            }
        };
        let mass = gas.mass.as_ref().map(Quantity::si);
        let name_of = name.text.clone();
        match (&gas.centre, &gas.line, &gas.pattern) {
            (Some(centre), ..) => {
                let at = global(centre);
                enter(name_of, crate::scenario::language::span_of(centre), at, at, mass);
            }
            (None, Some(line), _) if gas.decks.is_some() => {
                let span = crate::scenario::language::span_of(&line.from);
                let decks = self.decks(name, line, gas.decks.as_deref()?)?;
                for (number, hole) in (1..).zip(decks) {
                    let (span, mass) = (span.clone(), Some(hole.mass));
                    enter(format!("{name_of}.{number}"), span, hole.from, hole.to, mass);
                }
            }
            (None, Some(line), _) => {
                let span = crate::scenario::language::span_of(&line.from);
                enter(name_of, span, global(&line.from), global(&line.to), mass);
            }
            (None, None, Some(pattern)) => {
                let holes = self.holes(name, pattern, density?)?;
                for (number, hole) in (1..).zip(holes) {
                    let span = span_of_pattern(pattern);
                    enter(format!("{name_of}.{number}"), span, hole.from, hole.to, Some(hole.mass));
                }
            }
            (None, None, None) => {}
        }
        Some(())
    }

    /// Brings places of the scene to where the cells of a table stand before they are shifted and turned.
    fn bring_home(&self, block: &Block, said: &GridCells, shift: Vec3, places: &mut Places) {
        let (min, max) = box_of(said);
        let turn = block.rotate.as_ref().map(|rotate| {
            let about = rotate.about.as_ref().map(|at| Vec3::from(at.xyz()));
            Turn::new(rotate, about.unwrap_or(0.5 * (min + max)) + shift)
        });
        let home = |at: Vec3| {
            let local = at - self.spatial.origin;
            turn.map_or(local, |turn| turn.back(local)) - shift
        };
        for finest in &mut places.finest {
            *finest = match *finest {
                Finest::Segment(from, to) => Finest::Segment(home(from), home(to)),
                Finest::Plane(at, normal) => {
                    let at_home = home(at);
                    Finest::Plane(at_home, (home(at + normal) - at_home).normalize())
                }
                Finest::Ball(centre, radius) => Finest::Ball(home(centre), radius),
                // Of a turned table the box about its corners.
                Finest::Box(min, max) => {
                    let corners = (0..8).map(|k| {
                        home(Vec3::from_array(
                            [0, 1, 2].map(|a| if k >> a & 1 == 0 { min[a] } else { max[a] }),
                        ))
                    });
                    let start = (Vec3::INFINITY, Vec3::NEG_INFINITY);
                    let (low, high) = corners.fold(start, |(l, h), c| (l.min(c), h.max(c)));
                    Finest::Box(low, high)
                }
            };
        }
        for (_, _, charge) in &mut places.charges {
            (charge.from, charge.to) = (home(charge.from), home(charge.to));
        }
    }

    /// The charges that lie in the box of a table; `None` if one lies partly in it.
    fn charges_within(
        &mut self,
        block: &Block,
        said: &GridCells,
        places: &Places,
    ) -> Option<Vec<(String, Span, Charge)>> {
        let (min, max) = box_of(said);
        let slack = ON_SIDE * (max - min).max_element();
        let inside = |at: Vec3| at.cmpge(min - slack).all() && at.cmple(max + slack).all();
        let mut within = Vec::new();
        for (name, span, charge) in &places.charges {
            // One in other rock makes these cells fine, and has its room there.
            let middle = 0.5 * (charge.from + charge.to);
            let ends = [charge.from, charge.to].map(inside);
            if ends == [true, true] {
                within.push((name.clone(), span.clone(), *charge));
            } else if ends != [false, false] || inside(middle) {
                let message = format!("`{name}` crosses a side of the cells of `{}`", block.name);
                let help = "end the charge inside the cells, or make them larger; a charge has its room in one table";
                self.error_at("geometry.graded", span.clone(), message, help);
                return None;
            }
        }
        Some(within)
    }

    /// Sizes of cells; `None` after an error.
    fn grading(
        &mut self,
        block: &Block,
        graded: &Graded,
        at: Vec<Finest>,
        charges: &[(String, Span, Charge)],
    ) -> Option<Grading> {
        let thinnest = charges.iter().map(|(_, _, charge)| charge.width()).min_by(f64::total_cmp);
        let (to, over) = (graded.to.si(), graded.over.si());
        let from = match (&graded.from, thinnest) {
            (Some(from), _) => from.si(),
            (None, Some(width)) => {
                let key = format!("blocks.{}.grid.cells.graded.from", block.name);
                let why = "diameter of the thinnest charge";
                self.explain(key, with_unit(width, "m"), Provenance::Derived, why);
                width.min(to)
            }
            (None, None) => {
                let message =
                    format!("the size of the finest cells of `{}` is not given", block.name);
                let help = "write for example from = \"5 cm\"; only at charges it follows from their diameter";
                self.error_at("geometry.graded", graded.to.span.clone(), message, help);
                return None;
            }
        };
        if to - from > over {
            let message = format!(
                "the cells of `{}` would grow from {} by more than their own size from one to the next",
                block.name,
                with_unit(from, "m")
            );
            let help = format!("give `over` at least {}", with_unit(to - from, "m"));
            self.error_at("geometry.graded", graded.over.span.clone(), message, &help);
            return None;
        }
        Some(Grading { from, to, over, at })
    }

    /// Whether the finest cells can be the walls of all charges.
    fn fits_charges(
        &mut self,
        grading: &Grading,
        graded: &Graded,
        charges: &[(String, Span, Charge)],
        (min, max): (Vec3, Vec3),
    ) -> Option<()> {
        let span = graded.from.as_ref().map_or(&graded.to.span, |from| &from.span);
        for (name, _, charge) in charges {
            let width = charge.width();
            let ratio = grading.from / width;
            if (FINEST..=COARSEST).contains(&ratio) {
                continue;
            }
            let cells = |from: f64| {
                let count = Grading { from, ..grading.clone() }.count(min, max, MOST_CELLS);
                if count > MOST_CELLS {
                    "more than a million".to_owned()
                } else {
                    format!("about {count:.0}")
                }
            };
            let message = format!(
                "`{name}` is {} wide, and the finest cells are {}: they cannot be its walls",
                with_unit(width, "m"),
                with_unit(grading.from, "m"),
            );
            let help = format!(
                "cells at a charge are from half to twice as wide as it: from = \"{:.3e} m\" makes {} cells in place of {}",
                width,
                cells(width),
                cells(grading.from),
            );
            self.error_at("geometry.graded", span.clone(), message, &help);
            return None;
        }
        Some(())
    }

    /// Whether there are not too many cells; the error says what would make fewer.
    fn few_enough(
        &mut self,
        block: &Block,
        graded: &Graded,
        grading: &Grading,
        count: f64,
        (min, max): (Vec3, Vec3),
    ) -> bool {
        let key = format!("blocks.{}.grid.cells.count", block.name);
        let why = "volume over the cubes of the sizes of cells";
        self.explain(key, format!("about {count:.0}"), Provenance::Derived, why);
        if count <= MOST_CELLS {
            return self.has_memory(block, count, &graded.to.span);
        }
        let coarser = Grading { to: 2.0 * grading.to, ..grading.clone() };
        let many = coarser.count(min, max, MOST_CELLS);
        let instead = match many <= MOST_CELLS {
            true => format!("twice as large a `to` makes about {many:.0}"),
            false => {
                "twice as large a `to` is not enough: a shorter `over` and a smaller box make fewer"
                    .to_owned()
            }
        };
        let message = format!(
            "`{}` would have more than 1 million cells, from {} to {}",
            block.name,
            with_unit(grading.from, "m"),
            with_unit(grading.to, "m"),
        );
        self.error_at("geometry.count", graded.to.span.clone(), message, &instead);
        false
    }
}
