//! Computed values over a reference.

use super::chart::{self, Curve, Mark, Panel};
use super::{PlotError, Target, column, table_csv, write};
use riprap_record::table::Series;
use std::path::PathBuf;

/// A line for [`compare`].
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// Its name in the legend.
    pub name: String,
    /// Abscissae, ascending in a reference.
    pub x: Vec<f64>,
    /// Ordinates.
    pub y: Vec<f64>,
}

/// Words around a [`compare`] plot.
#[derive(Debug, Clone, PartialEq)]
pub struct Labels {
    /// Title.
    pub title: String,
    /// Name and unit of the abscissa.
    pub x: (String, String),
    /// Name and unit of the ordinate.
    pub y: (String, String),
}

/// Draws computed values (dots) over a reference (line), and their difference below.
///
/// The reference is interpolated linearly at the computed abscissae; outside its range there is no difference.
///
/// # Errors
/// Empty lines, files that cannot be written.
///
/// # Examples
///
/// ```
/// use riprap_plot::{Labels, Line, compare};
///
/// let line = |name: &str, x: &[f64], y: &[f64]| Line {
///     name: name.into(),
///     x: x.to_vec(),
///     y: y.to_vec(),
/// };
/// let labels = Labels {
///     title: "Fall of a stone".into(),
///     x: ("time".into(), "s".into()),
///     y: ("height".into(), "m".into()),
/// };
/// let out = tempfile::tempdir()?;
/// let written = compare(
///     &line("computed", &[0.0, 0.5, 1.0], &[10.0, 8.77, 5.1]),
///     &line("exact", &[0.0, 0.5, 1.0], &[10.0, 8.774, 5.095]),
///     &labels,
///     &out.path().join("fall.svg"),
/// )?;
/// // The figure and the numbers behind it.
/// assert_eq!(written.len(), 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn compare<'t>(
    computed: &Line,
    reference: &Line,
    labels: &Labels,
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    for line in [computed, reference] {
        if line.x.is_empty() || line.x.len() != line.y.len() {
            let what = format!(
                "`{}` has {} abscissae and {} values",
                line.name,
                line.x.len(),
                line.y.len()
            );
            return Err(PlotError::NothingToDraw { what });
        }
    }
    let at: Vec<f64> = computed.x.iter().map(|x| interpolated(reference, *x)).collect();
    let difference: Vec<f64> = computed.y.iter().zip(&at).map(|(a, b)| a - b).collect();
    let line =
        |l: &Line, mark| Curve { name: l.name.clone(), x: l.x.clone(), y: l.y.clone(), mark };
    let (name, unit) = labels.y.clone();
    let panels = [
        Panel {
            name,
            unit: unit.clone(),
            curves: vec![line(reference, Mark::Line), line(computed, Mark::Rings)],
            height: 320.0,
            ..Panel::default()
        },
        Panel {
            name: "difference".to_owned(),
            unit,
            curves: vec![Curve {
                x: computed.x.clone(),
                y: difference.clone(),
                ..Curve::default()
            }],
            height: 110.0,
            ..Panel::default()
        },
    ];
    let page = chart::draw((&labels.title, ""), (&labels.x.0, &labels.x.1), &panels);
    let columns = [
        column(&labels.x.0, &labels.x.1, computed.x.clone()),
        column(&computed.name, &labels.y.1, computed.y.clone()),
        column(&reference.name, &labels.y.1, at),
        column("difference", &labels.y.1, difference),
    ];
    let columns: Vec<&Series> = columns.iter().collect();
    write(&page, &table_csv(&columns), out)
}

fn interpolated(line: &Line, x: f64) -> f64 {
    let i = line.x.partition_point(|v| *v < x);
    // At a row of the reference itself: exact, and the first one has no row before it.
    if i < line.x.len() && line.x[i] == x {
        return line.y[i];
    }
    if i == 0 || i == line.x.len() {
        return f64::NAN;
    }
    let (x0, x1, y0, y1) = (line.x[i - 1], line.x[i], line.y[i - 1], line.y[i]);
    y0 + (y1 - y0) * (x - x0) / (x1 - x0)
}
