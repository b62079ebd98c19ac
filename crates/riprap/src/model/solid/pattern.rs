//! Blast patterns: many holes from a CSV file.

use riprap_geom::Vec3;

use crate::model::builder::Builder;
use crate::scenario::Diagnostic;
use crate::scenario::csv_columns::csv_quantities;
use crate::scenario::language::Pattern;
use crate::scenario::units::Dim;

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
}

/// Columns that every pattern has.
const NEEDED: [(&str, Dim); 7] = [
    ("collar_x", Dim::LENGTH),
    ("collar_y", Dim::LENGTH),
    ("collar_z", Dim::LENGTH),
    ("toe_x", Dim::LENGTH),
    ("toe_y", Dim::LENGTH),
    ("toe_z", Dim::LENGTH),
    ("delay", Dim::TIME),
];
/// Columns that it may have; one of the first two.
const OPTIONAL: [(&str, Dim); 3] = [
    ("charge", Dim::MASS),
    ("diameter", Dim::LENGTH),
    ("stemming", Dim::LENGTH),
];

impl Builder<'_> {
    /// The holes of a pattern; `None` after an error. `density` of the explosive, kg/m³, makes a mass
    /// of a diameter.
    pub(super) fn holes(&mut self, pattern: &Pattern, density: f64) -> Option<Vec<Hole>> {
        let path = self.parsed.folder.join(pattern.csv.as_str());
        let columns = match csv_quantities(&path, &NEEDED, &OPTIONAL) {
            Ok(columns) => columns,
            Err(error) => {
                let mut found = Diagnostic::error("file.csv", error.message);
                found.help = error.help;
                self.found.push(found.at(pattern.csv.span.clone()));
                return None;
            }
        };
        let [
            Some(cx),
            Some(cy),
            Some(cz),
            Some(tx),
            Some(ty),
            Some(tz),
            Some(delay),
            charge,
            diameter,
            stemming,
        ] = &columns[..]
        else {
            return None; // the reader answers for all needed columns
        };
        if charge.is_some() == diameter.is_some() {
            let message = format!(
                "`{}` needs one of the columns charge_kg and diameter_mm",
                pattern.csv
            );
            let help = "the mass of each charge follows from one of them";
            self.error_at("file.csv", &pattern.csv, message, help);
            return None;
        }
        let mut holes = Vec::new();
        for k in 0..delay.len() {
            let (collar, toe) = (
                Vec3::new(cx[k], cy[k], cz[k]),
                Vec3::new(tx[k], ty[k], tz[k]),
            );
            let length = collar.distance(toe);
            let stemmed = stemming.as_ref().map_or(0.0, |s| s[k]);
            let charged = length - stemmed;
            let mass = match (charge, diameter) {
                (Some(mass), _) => mass[k],
                (None, Some(d)) => 0.25 * std::f64::consts::PI * d[k] * d[k] * charged * density,
                (None, None) => 0.0,
            };
            if !(stemmed >= 0.0 && charged > 0.0 && mass > 0.0 && delay[k] >= 0.0) {
                let message = format!(
                    "`{}`, hole {}: {length} m long, {stemmed} m stemming, {mass} kg, {} s delay",
                    pattern.csv,
                    k + 1,
                    delay[k]
                );
                let help = "a hole needs a length above its stemming, a charge, and no negative \
                            delay";
                self.error_at("file.csv", &pattern.csv, message, help);
                return None;
            }
            holes.push(Hole {
                from: toe + (collar - toe) * (charged / length),
                to: toe,
                mass,
                delay: delay[k],
            });
        }
        Some(holes)
    }
}
