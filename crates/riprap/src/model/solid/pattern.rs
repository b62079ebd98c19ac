//! Blast patterns: many holes from a CSV file.

use riprap_geom::Vec3;

use crate::model::builder::Builder;
use crate::scenario::csv_columns::Column;
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

impl Builder<'_> {
    /// The holes of a pattern; `None` after an error. `density` of the explosive, kg/m³, makes a mass
    /// of a diameter.
    pub(super) fn holes(&mut self, pattern: &Pattern, density: f64) -> Option<Vec<Hole>> {
        let table = self.table(&pattern.csv, &COLUMNS)?;
        let [cx, cy, cz, tx, ty, tz, delay] = std::array::from_fn(|k| table.values(k));
        let [charge, diameter, stemming] = [7, 8, 9].map(|k| {
            let found = table.columns[k].as_ref();
            found.map(|found| &found.values)
        });
        if charge.is_some() == diameter.is_some() {
            let message = format!("`{}` needs a column charge_kg or diameter_mm", pattern.csv);
            let help = "the mass of each charge is derived from one of them";
            self.error_at("file.csv", &pattern.csv, message, help);
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
            if !(stemmed >= 0.0 && charged > 0.0 && mass > 0.0 && delay[k] >= 0.0) {
                let message = format!(
                    "`{}`, line {}: hole {}: {length} m long, {stemmed} m stemming, {mass} kg, {} s delay",
                    pattern.csv,
                    table.lines[k],
                    k + 1,
                    delay[k]
                );
                let help = "a hole must be longer than its stemming, and needs a charge and a delay of 0 s or more";
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
