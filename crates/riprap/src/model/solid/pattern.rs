//! Blast patterns, many holes from a CSV file or in rows, and holes with decks.

use riprap_geom::Vec3;

use super::global;
use crate::model::builder::Builder;
use crate::scenario::csv_columns::Column;
use crate::scenario::language::{Deck, Pattern, PatternGrid, Segment, span_of};
use crate::scenario::read::with_unit;
use crate::scenario::units::Dim;
use crate::scenario::{Name, Span};

/// A deck may end beyond the toe by this share of the hole: round-off.
const ON_TOE: f64 = 1e-9;

/// The charged part of a hole, in the coordinates of the file.
pub(super) struct Hole {
    /// End towards the collar, m.
    pub(super) from: Vec3,
    /// Toe, m.
    pub(super) to: Vec3,
    /// Mass of explosive, kg.
    pub(super) mass: f64,
    /// Time of detonation, s.
    pub(super) delay: f64,
    /// Length of the hole above it without explosive, m.
    pub(super) stemmed: f64,
}

/// Columns of a pattern; one of the mass and the diameter of each charge is there.
const COLUMNS: [Column; 10] = [
    Column::needed(&["collar_x", "collar_easting", "collar_east"], Dim::LENGTH, "m"),
    Column::needed(&["collar_y", "collar_northing", "collar_north"], Dim::LENGTH, "m"),
    Column::needed(&["collar_z", "collar_elevation", "collar_rl"], Dim::LENGTH, "m"),
    Column::needed(&["toe_x", "toe_easting", "toe_east"], Dim::LENGTH, "m"),
    Column::needed(&["toe_y", "toe_northing", "toe_north"], Dim::LENGTH, "m"),
    Column::needed(&["toe_z", "toe_elevation", "toe_rl"], Dim::LENGTH, "m"),
    Column::needed(&["delay", "delay_time", "time"], Dim::TIME, "ms").with_unit(),
    Column::optional(&["charge", "charge_mass", "mass"], Dim::MASS, "kg").with_unit(),
    Column::optional(&["diameter", "hole_diameter"], Dim::LENGTH, "mm").with_unit(),
    Column::optional(&["stemming", "stemming_length"], Dim::LENGTH, "m"),
];

/// Where a scene gives a pattern.
pub(super) fn span_of_pattern(pattern: &Pattern) -> Span {
    let csv = pattern.csv.as_ref().map(|csv| csv.span.clone());
    let grid = pattern.grid.as_ref().map(|grid| span_of(&grid.collar));
    csv.or(grid).unwrap_or_default()
}

impl Builder<'_> {
    /// The holes of a pattern; `None` after an error. `density` of the explosive, kg/m³, makes a mass
    /// of a diameter.
    pub(super) fn holes(
        &mut self,
        name: &Name,
        pattern: &Pattern,
        density: f64,
    ) -> Option<Vec<Hole>> {
        match (&pattern.csv, &pattern.grid) {
            (Some(csv), _) => self.holes_of_file(csv, density),
            (None, Some(grid)) => self.holes_in_rows(name, grid, density),
            (None, None) => None,
        }
    }

    /// Equal holes, row by row; `None` after an error.
    fn holes_in_rows(
        &mut self,
        name: &Name,
        said: &PatternGrid,
        density: f64,
    ) -> Option<Vec<Hole>> {
        let mut read = self.reading(format!("sources.{name}.gas_cavity.pattern.grid"), said);
        let (rows, inclination, stemmed) = (read.rows(), read.inclination(), read.stemming());
        let (per_hole, per_row) = (read.delay_holes(), read.delay_rows());
        let along = said.along.as_ref().map_or(Vec3::X, |along| Vec3::from(along.xyz()));
        let flat = Vec3::new(along.x, along.y, 0.0).try_normalize();
        let Some(along) = flat.filter(|_| along.z == 0.0) else {
            let at = said.along.as_ref().map_or(name.span.clone(), |along| along.span.clone());
            let help = "give a level direction, for example along = [1, 0, 0]";
            self.error_at("source.pattern", at, "the rows of the pattern are not level", help);
            return None;
        };
        let (length, back) = (said.length.si(), Vec3::Z.cross(along));
        let charged = length - stemmed;
        if charged <= 0.0 || inclination.abs() >= std::f64::consts::FRAC_PI_2 {
            let (at, message) = if charged <= 0.0 {
                let [stemmed, length] = [stemmed, length].map(|x| with_unit(x, "m"));
                let at = said.stemming.as_ref().map_or(&said.length.span, |of| &of.span);
                let why =
                    format!("a stemming of {stemmed} leaves no room for a charge in {length}");
                (at, why)
            } else {
                let at = said.inclination.as_ref().map_or(&said.length.span, |of| &of.span);
                (at, "the holes do not go down".to_owned())
            };
            let help = "give holes longer than their stemming, inclined by less than 90 deg";
            self.error_at("source.pattern", at.clone(), message, help);
            return None;
        }
        let down = -libm::sin(inclination) * back - libm::cos(inclination) * Vec3::Z;
        let mass = match (&said.charge, &said.diameter) {
            (Some(charge), _) => charge.si(),
            (None, Some(d)) => 0.25 * std::f64::consts::PI * d.si() * d.si() * charged * density,
            (None, None) => return None,
        };
        let mut holes = Vec::new();
        for row in 0..rows {
            let shift = if said.staggered && row % 2 == 1 { 0.5 } else { 0.0 };
            for hole in 0..said.holes {
                let collar = global(&said.collar)
                    + (hole as f64 + shift) * said.spacing.si() * along
                    + row as f64 * said.burden.si() * back;
                holes.push(Hole {
                    from: collar + stemmed * down,
                    to: collar + length * down,
                    mass,
                    delay: hole as f64 * per_hole + row as f64 * per_row,
                    stemmed,
                });
            }
        }
        Some(holes)
    }

    fn holes_of_file(&mut self, csv: &Name, density: f64) -> Option<Vec<Hole>> {
        let table = self.table(csv, &COLUMNS)?;
        let [cx, cy, cz, tx, ty, tz, delay] = std::array::from_fn(|k| table.values(k));
        let [charge, diameter, stemming] = [7, 8, 9].map(|k| {
            let found = table.columns[k].as_ref();
            found.map(|found| &found.values)
        });
        if charge.is_some() == diameter.is_some() {
            let message = format!("`{csv}` needs a column charge_kg or diameter_mm");
            let help = "the mass of each charge is derived from one of them";
            self.error_at("file.csv", csv, message, help);
            return None;
        }
        let mut holes = Vec::new();
        for k in 0..delay.len() {
            let (collar, toe) = (Vec3::new(cx[k], cy[k], cz[k]), Vec3::new(tx[k], ty[k], tz[k]));
            let length = collar.distance(toe);
            let stemmed = stemming.as_ref().map_or(0.0, |s| s[k]);
            let charged = length - stemmed;
            let mass = match (charge, diameter) {
                (Some(mass), _) => mass[k],
                (None, Some(d)) => 0.25 * std::f64::consts::PI * d[k] * d[k] * charged * density,
                (None, None) => 0.0,
            };
            let wrong = if stemmed < 0.0 {
                Some(format!("its stemming is {}", with_unit(stemmed, "m")))
            } else if charged <= 0.0 {
                let [stemmed, length] = [stemmed, length].map(|x| with_unit(x, "m"));
                Some(format!("its stemming, {stemmed}, leaves no room for a charge in {length}"))
            } else if let Some(d) = diameter.map(|d| d[k]).filter(|d| *d <= 0.0) {
                Some(format!("its diameter is {}", with_unit(d, "m")))
            } else if mass <= 0.0 {
                Some(format!("its charge is {}", with_unit(mass, "kg")))
            } else if delay[k] < 0.0 {
                Some(format!("its delay is {}", with_unit(delay[k], "s")))
            } else {
                None
            };
            if let Some(wrong) = wrong {
                let (file, line) = (csv, table.lines[k]);
                let message = format!("`{file}`, line {line}: hole {}: {wrong}", k + 1);
                let help = "a hole must be longer than its stemming, and needs a charge and a delay of 0 s or more";
                self.error_at("file.csv", file, message, help);
                return None;
            }
            holes.push(Hole {
                from: toe + (collar - toe) * (charged / length),
                to: toe,
                mass,
                delay: delay[k],
                stemmed,
            });
        }
        Some(holes)
    }

    /// The charges of a hole with decks, in the coordinates of the scene; `None` after an error.
    pub(super) fn decks(
        &mut self,
        name: &Name,
        line: &Segment,
        decks: &[Deck],
    ) -> Option<Vec<Hole>> {
        let (collar, toe) = (global(&line.from), global(&line.to));
        let length = collar.distance(toe);
        let mut holes: Vec<Hole> = Vec::with_capacity(decks.len());
        let mut above = 0.0;
        for (number, deck) in (1..).zip(decks) {
            let [from, to] = [deck.from.si(), deck.to.si()];
            let path = format!("sources.{name}.gas_cavity.decks.{number}");
            let delay = self.reading(path, deck).delay();
            let wrong = if to > length * (1.0 + ON_TOE) {
                Some((&deck.to, format!("the hole is {} long", with_unit(length, "m"))))
            } else if from >= to {
                Some((&deck.to, format!("it begins at {}", with_unit(from, "m"))))
            } else if from < above {
                let message = format!("the deck above it ends at {}", with_unit(above, "m"));
                return self.wrong_deck(name, number, &deck.from.span, &message);
            } else {
                None
            };
            if let Some((end, why)) = wrong {
                let message = format!("it ends at {}, but {why}", with_unit(to, "m"));
                return self.wrong_deck(name, number, &end.span, &message);
            }
            let at = |depth: f64| collar + (toe - collar) * (depth / length).min(1.0);
            let (mass, stemmed) = (deck.mass.si(), from - above);
            holes.push(Hole { from: at(from), to: at(to), mass, delay, stemmed });
            above = to;
        }
        if holes.is_empty() {
            let message = format!("`{name}` has no deck");
            let help = "give each charge of the hole: decks = [{ from = \"2 m\", to = \"5 m\", mass = \"20 kg\" }]";
            self.error_at("source.decks", name, message, help);
            return None;
        }
        Some(holes)
    }

    fn wrong_deck<T>(&mut self, name: &Name, number: u32, span: &Span, why: &str) -> Option<T> {
        let message = format!("deck {number} of `{name}`: {why}");
        let help = "give decks from the collar on, with `from` and `to` as distances from it along the hole, none over another";
        self.error_at("source.decks", span.clone(), message, help);
        None
    }
}
