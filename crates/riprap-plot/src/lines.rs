//! Histories and energies over time, histories over each other.

use super::chart::{self, Curve, Panel};
use super::{PlotError, Target, table_csv, write};
use riprap_record::manifest::Manifest;
use riprap_record::table::{Series, Table};
use std::path::{Path, PathBuf};

/// Draws columns of `histories.csv` over time, or over the column `against` (load against displacement, convergence
/// against the way of a face), those of one unit in one panel. No names: all columns.
///
/// Ratios that fall over decades (a column named `...unbalanced...`, no value negative) get a logarithmic axis.
///
/// # Errors
/// Unknown columns (with the nearest name), files that cannot be read or written.
pub fn histories<'t>(
    folder: &Path,
    columns: &[String],
    against: Option<&str>,
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    let manifest = Manifest::read(folder)?;
    let table = Table::read(&folder.join("histories.csv"))?;
    let (along, axis) = match against {
        Some(name) => {
            let series = table.column(name)?;
            (series, (series.name.replace('_', " "), &*series.unit))
        }
        None => abscissa(&table).map(|(series, (name, unit))| (series, (name.to_owned(), unit)))?,
    };
    let chosen: Vec<&Series> = if columns.is_empty() {
        table
            .columns
            .iter()
            .filter(|c| !["step", "time"].contains(&c.name.as_str()))
            .filter(|c| c.name != along.name)
            .collect()
    } else {
        columns.iter().map(|c| table.column(c)).collect::<Result<_, _>>()?
    };
    need_rows(&table, &chosen)?;
    let mut panels: Vec<Panel> = Vec::new();
    for series in &chosen {
        let log = series.name.contains("unbalanced")
            && series.values.iter().any(|v| *v > 0.0)
            && series.values.iter().all(|v| *v >= 0.0 || v.is_nan());
        let curve = curve(series, &along.values);
        match panels.iter_mut().find(|p| p.unit == series.unit && p.log == log) {
            Some(panel) => panel.curves.push(curve),
            None => panels.push(Panel {
                name: series.name.clone(),
                unit: series.unit.clone(),
                curves: vec![curve],
                log,
                ..Panel::default()
            }),
        }
    }
    let height = if panels.len() == 1 { 360.0 } else { 200.0 };
    for panel in &mut panels {
        panel.height = height;
        if panel.curves.len() > 1 {
            panel.name = quantity(&panel.curves, &panel.unit);
        }
    }
    let page = chart::draw((&manifest.title, ""), (&axis.0, axis.1), &panels);
    let mut columns = vec![along];
    columns.extend(chosen);
    write(&page, &table_csv(&columns), out)
}

/// Draws the terms of `energy.csv` over time, the residual in a panel of its own.
///
/// # Errors
/// Files that cannot be read or written.
pub fn energy<'t>(folder: &Path, out: impl Into<Target<'t>>) -> Result<Vec<PathBuf>, PlotError> {
    let manifest = Manifest::read(folder)?;
    let table = Table::read(&folder.join("energy.csv"))?;
    let (time, axis) = abscissa(&table)?;
    let terms: Vec<&Series> = table
        .columns
        .iter()
        .filter(|c| !["step", "time"].contains(&c.name.as_str()) && !c.name.contains("residual"))
        .collect();
    need_rows(&table, &terms)?;
    // Terms that are nil throughout only fill the legend; the numbers still have them.
    let alive = |s: &&&Series| s.values.iter().any(|v| *v != 0.0);
    let mut curves: Vec<Curve> =
        terms.iter().filter(alive).map(|s| curve(s, &time.values)).collect();
    // Axes need a curve, where all terms are nil too.
    if curves.is_empty() {
        curves = terms.iter().take(1).map(|s| curve(s, &time.values)).collect();
    }
    let unit = terms[0].unit.clone();
    let mut panels =
        vec![Panel { name: "energy".to_owned(), unit, curves, height: 320.0, ..Panel::default() }];
    let mut columns = vec![time];
    columns.extend(&terms);
    for series in table.columns.iter().filter(|c| c.name.contains("residual")) {
        panels.push(Panel {
            name: series.name.replace('_', " "),
            unit: series.unit.clone(),
            curves: vec![curve(series, &time.values)],
            height: 110.0,
            ..Panel::default()
        });
        columns.push(series);
    }
    let page = chart::draw((&manifest.title, ""), axis, &panels);
    write(&page, &table_csv(&columns), out)
}

/// Time; where it stands still because all phases are static, the step. With name and unit of the axis.
fn abscissa(table: &Table) -> Result<(&Series, (&'static str, &'static str)), PlotError> {
    let time = table.column("time")?;
    let still = time.values.len() > 1 && time.values.iter().all(|t| *t == time.values[0]);
    Ok(match table.column("step") {
        Ok(step) if still => (step, ("step", "-")),
        Ok(_) | Err(_) => (time, ("time", "s")),
    })
}

pub(super) fn curve(series: &Series, time: &[f64]) -> Curve {
    Curve {
        name: series.name.replace('_', " "),
        x: time.to_vec(),
        y: series.values.clone(),
        ..Curve::default()
    }
}

/// The name of a panel of several curves: what their names share at the end, else what has that unit.
fn quantity(curves: &[Curve], unit: &str) -> String {
    let tail = |c: &Curve| c.name.rsplit('.').next().unwrap_or_default().to_owned();
    let first = curves.first().map(tail).unwrap_or_default();
    if curves.iter().all(|c| tail(c) == first) {
        return first;
    }
    let of_unit = match unit {
        "m" => "length",
        "m2" => "area",
        "m3" => "volume",
        "rad" => "angle",
        "m/s" => "velocity",
        "rad/s" => "spin",
        "m/s2" => "acceleration",
        "N" | "N/m" => "force",
        "N m" | "N m/m" => "moment",
        "Pa" => "stress",
        "J" | "J/m" => "energy",
        "kg" | "kg/m" => "mass",
        "s" => "duration",
        "m3/s" | "m2/s" => "flow",
        _ => "value",
    };
    of_unit.to_owned()
}

pub(super) fn need_rows(table: &Table, chosen: &[&Series]) -> Result<(), PlotError> {
    let what = if chosen.is_empty() {
        "columns besides step and time"
    } else if chosen[0].values.is_empty() {
        "complete rows"
    } else {
        return Ok(());
    };
    let what = format!("{} has no {what}", table.path.display());
    Err(PlotError::NothingToDraw { what })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_of_one_panel_have_one_name() {
        let named = |names: &[&str], unit: &str| {
            let curve = |name: &&str| Curve { name: (*name).to_owned(), ..Curve::default() };
            quantity(&names.iter().map(curve).collect::<Vec<_>>(), unit)
        };
        assert_eq!(named(&["crest.velocity", "toe.velocity"], "m/s"), "velocity");
        assert_eq!(named(&["crest", "toe"], "m"), "length");
        assert_eq!(named(&["crest", "toe"], "furlong"), "value");
    }
}
