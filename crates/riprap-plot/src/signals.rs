//! Pressures of cavities with their fit, spectra of histories.

use super::chart::{self, Abscissa, Curve, Mark, Panel};
use super::lines::{curve, need_rows};
use super::{PlotError, Target, column, digits, suffix, table_csv, write};
use crate::fits::{self, Spectrum, TwoExponential};
use riprap_record::manifest::Manifest;
use riprap_record::table::{Series, Table};
use std::path::{Path, PathBuf};

const CAVITY: &str = "the cavities";
/// Pressure counts from this share of its maximum.
const ONSET: f64 = 0.01;
/// Amplitudes below this share of the largest are not drawn.
const FAINTEST: f64 = 1e-4;

/// Draws the histories whose names end in `.pressure`, `.volume`, `.expansion` and `.volume_ratio`, each kind in one panel, the
/// pressures with the fit `p0 (exp(-a t) - exp(-b t)) + plateau` from their onset on; where the rise is over at the first sample, t
/// counts from up to a step before it, which stands beside the picture.
///
/// A pressure that cannot be fitted (constant, too few rows) is drawn without a fit, and the reason stands beside it.
///
/// # Errors
/// A run without such histories, files that cannot be read or written.
pub fn cavity<'t>(folder: &Path, out: impl Into<Target<'t>>) -> Result<Vec<PathBuf>, PlotError> {
    let manifest = Manifest::read(folder)?;
    let table = Table::read(&folder.join("histories.csv"))?;
    let time = table.column("time")?;
    let mut panels = Vec::new();
    let mut columns = vec![time.clone()];
    for (ending, name) in [
        (".pressure", "pressure"),
        (".volume", "volume"),
        (".expansion", "expansion V/V\u{2080}"),
        (".volume_ratio", "volume ratio"),
    ] {
        let found: Vec<&Series> =
            table.columns.iter().filter(|c| c.name.ends_with(ending)).collect();
        let Some(first) = found.first() else {
            continue;
        };
        need_rows(&table, &found)?;
        let mut panel = Panel {
            name: name.to_owned(),
            unit: first.unit.clone(),
            height: 150.0,
            ..Panel::default()
        };
        for series in &found {
            panel.curves.push(curve(series, &time.values));
            columns.push((*series).clone());
            if ending == ".pressure" {
                columns.extend(fitted(&mut panel, series, &time.values));
            }
        }
        panels.push(panel);
    }
    if panels.is_empty() {
        let reason = "no history of the run ends in .pressure, .volume, .expansion or .volume_ratio; add some to the scene: [[histories]]".to_owned();
        return Err(PlotError::Unsuitable { picture: CAVITY, reason });
    }
    let page = chart::draw((&manifest.title, ""), ("time", "s"), &panels);
    write(&page, &table_csv(&columns.iter().collect::<Vec<_>>()), out)
}

/// Adds the fit of a pressure to its panel; returns it as columns: the curve, then its numbers.
fn fitted(panel: &mut Panel, series: &Series, time: &[f64]) -> Vec<Series> {
    let bare = series.name.trim_end_matches(".pressure");
    let (t, p) = from_onset(time, &series.values);
    let fit = match fits::two_exponential(t, p) {
        Ok(fit) => fit,
        Err(reason) => {
            panel.notes.push(format!("{bare}: no fit, {reason}"));
            return Vec::new();
        }
    };
    let y: Vec<f64> =
        time.iter().map(|t| if *t < fit.start { f64::NAN } else { fit.at(*t) }).collect();
    panel.curves.push(Curve {
        name: format!("{bare}: fit"),
        x: time.to_vec(),
        y: y.clone(),
        mark: Mark::Dashed,
    });
    panel.notes.extend(words(bare, &fit, &series.unit));
    panel.height = panel.height.max(17.0 * (panel.curves.len() + panel.notes.len() + 1) as f64);
    let one = |name: &str, unit: &str, v: f64| column(&format!("{bare} {name}"), unit, vec![v]);
    vec![
        column(&format!("{bare} fit"), &series.unit, y),
        one("p0", &series.unit, fit.p0),
        one("a", "1/s", fit.a),
        one("b", "1/s", fit.b),
        one("plateau", &series.unit, fit.plateau),
        one("R2", "-", fit.r2),
    ]
}

/// The samples from the last quiet one before the pressure comes.
fn from_onset<'a>(time: &'a [f64], p: &'a [f64]) -> (&'a [f64], &'a [f64]) {
    let top = p.iter().filter(|v| v.is_finite()).fold(0.0, |m: f64, v| m.max(v.abs()));
    let first = p.iter().position(|v| v.abs() > ONSET * top).unwrap_or(0);
    let start = first.saturating_sub(1);
    (&time[start..], &p[start..])
}

fn words(name: &str, fit: &TwoExponential, unit: &str) -> Vec<String> {
    let rate = |v: f64, sign: &str, limit: bool| {
        let sign = if limit { sign } else { "=" };
        format!("{sign} {} 1/s", digits(v, 3))
    };
    vec![
        format!("{name}: p\u{2080}(exp(\u{2212}at) \u{2212} exp(\u{2212}bt)) + plateau"),
        format!("p\u{2080} = {} {unit}", digits(fit.p0, 3)),
        format!("a {}", rate(fit.a, "\u{2264}", fit.decay_unresolved)),
        format!("b {}", rate(fit.b, "\u{2265}", fit.rise_unresolved)),
        format!("plateau = {} {unit}", digits(fit.plateau, 3)),
        // A pressure that is there with its first sample has risen before it.
        format!("t from {} s on", digits(fit.start, 3)),
        format!("R² = {:.3}", fit.r2),
    ]
}

/// Draws a history and its amplitude spectrum with the dominant frequency.
///
/// # Errors
/// Unknown histories (with the nearest name), too few samples.
pub fn spectrum<'t>(
    folder: &Path,
    history: &str,
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    let manifest = Manifest::read(folder)?;
    let table = Table::read(&folder.join("histories.csv"))?;
    let time = table.column("time")?;
    let series = table.column(history)?;
    let s = fits::amplitude_spectrum(&time.values, &series.values).map_err(|reason| {
        PlotError::Fit { what: format!("a spectrum of `{}`", series.name), reason }
    })?;
    let unit = match series.unit.as_str() {
        "-" | "" => "1/Hz".to_owned(),
        u => format!("({u})/Hz"),
    };
    let own = |name: &str, unit: &str, log| {
        Some(Abscissa { name: name.to_owned(), unit: unit.to_owned(), log })
    };
    let panels = [
        Panel {
            name: series.name.replace('_', " "),
            unit: series.unit.clone(),
            curves: vec![curve(series, &time.values)],
            height: 180.0,
            x: own("time", "s", false),
            ..Panel::default()
        },
        Panel {
            name: "amplitude".to_owned(),
            unit: unit.clone(),
            curves: spectrum_curves(&s),
            log: true,
            height: 280.0,
            x: own("frequency", "Hz", true),
            notes: vec![
                format!("dominant {} Hz", digits(s.dominant, 3)),
                format!("resolution {} Hz", digits(s.resolution, 2)),
            ],
            ..Panel::default()
        },
    ];
    let title = suffix(&manifest, &format!("spectrum of {}", series.name));
    let page = chart::draw((&manifest.title, &title), ("", ""), &panels);
    let columns = [
        column("frequency", "Hz", s.frequency),
        column("amplitude", &unit, s.amplitude),
        column("dominant frequency", "Hz", vec![s.dominant]),
        column("resolution", "Hz", vec![s.resolution]),
        column("even time step", "s", vec![s.step]),
    ];
    write(&page, &table_csv(&columns.iter().collect::<Vec<_>>()), out)
}

/// The spectrum from one period in the record to where nothing is left, and a line at its peak.
fn spectrum_curves(s: &Spectrum) -> Vec<Curve> {
    // The place of one period is off by a rounding.
    let first = s.frequency.partition_point(|f| *f < 0.999 * s.resolution);
    let largest = s.amplitude[first..].iter().copied().fold(0.0, f64::max);
    let least = FAINTEST * largest;
    let last = s.amplitude.iter().rposition(|a| *a >= least).unwrap_or(0);
    let end = (last + 2).min(s.amplitude.len());
    vec![
        Curve {
            name: "amplitude".to_owned(),
            x: s.frequency[first..end].to_vec(),
            y: s.amplitude[first..end].iter().map(|a| a.max(least)).collect(),
            mark: Mark::Line,
        },
        Curve {
            name: "dominant frequency".to_owned(),
            x: vec![s.dominant; 2],
            y: vec![least, largest],
            mark: Mark::Dashed,
        },
    ]
}
