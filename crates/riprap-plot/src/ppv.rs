//! Peak particle velocity against scaled distance.

use super::chart::{self, Abscissa, Curve, Mark, Panel};
use super::drawing::{choose, short};
use super::load::Which;
use super::run::Run;
use super::section::need_space;
use super::{PlotError, Target, column, digits, solid, sources, table_csv, write};
use crate::fits::{PowerLaw, power_law};
use riprap_record::frame::Frame;
use riprap_record::manifest::{Manifest, Source};
use riprap_record::write_whole;
use std::path::PathBuf;

const PICTURE: &str = "peak particle velocity";
/// Velocities are drawn in mm/s, the unit of site laws and limits.
const MM: f64 = 1e3;

/// A block that is as fast now as ever, to this share, has its peak still to come.
const RISING: f64 = 0.98;

/// Roots of the mass that distances are divided by: cylindrical and spherical charges.
const ROOTS: [(f64, &str, &str); 2] =
    [(2.0, "square root", "m/kg^(1/2)"), (3.0, "cube root", "m/kg^(1/3)")];

/// One block that moved.
struct Sample {
    block: f64,
    distance: f64,
    mass: f64,
    /// mm/s.
    speed: f64,
}

/// Draws the peak particle velocities of the blocks of a frame against scaled distance, by square root and by cube root
/// of the mass of the nearest source, without blocks whose peak is still to come, with the site law `v = K SD^-n` and its upper 95 % line. With `surface` only
/// blocks with a free face looking up count.
///
/// Distances are those before anything moved. The fitted numbers are also in `NAME_fit.csv`.
///
/// # Errors
/// Runs in the plane, runs without sources that have a mass, frames without `peak_speed`, fewer than three blocks.
pub fn ppv<'r, 't>(
    run: impl Into<Run<'r>>,
    frame: Which,
    surface: bool,
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    let run = run.into();
    let manifest = Manifest::read(run.folder)?;
    let frame = run.frame(frame)?;
    need_space(&frame, PICTURE)?;
    let charges: Vec<&Source> =
        sources(&manifest, PICTURE)?.iter().filter(|s| s.mass.is_some_and(|m| m > 0.0)).collect();
    if charges.is_empty() {
        let reason = "scaled distance needs a source with a mass, and the run has none".to_owned();
        return Err(PlotError::Unsuitable { picture: PICTURE, reason });
    }
    let samples = samples(&frame, &charges, surface)?;
    let speed: Vec<f64> = samples.iter().map(|s| s.speed).collect();
    let what = if surface { "surface blocks" } else { "blocks" };
    let (mut panels, mut fits) = (Vec::new(), Vec::new());
    let mut columns = vec![
        column("block", "-", samples.iter().map(|s| s.block).collect()),
        column("distance", "m", samples.iter().map(|s| s.distance).collect()),
        column("mass", "kg", samples.iter().map(|s| s.mass).collect()),
        column(PICTURE, "mm/s", speed.clone()),
    ];
    for (root, name, unit) in ROOTS {
        let scaled: Vec<f64> =
            samples.iter().map(|s| s.distance / libm::pow(s.mass, 1.0 / root)).collect();
        let fit = power_law(&scaled, &speed).map_err(|reason| PlotError::Fit {
            what: format!("{PICTURE} of {} {what} that moved", samples.len()),
            reason,
        })?;
        panels.push(panel((name, unit), &scaled, &speed, &fit, what));
        let all = |f: &dyn Fn(f64) -> f64| scaled.iter().map(|x| f(*x)).collect();
        columns.push(column(&format!("{name} scaled distance"), unit, scaled.clone()));
        columns.push(column(&format!("{name} fit"), "mm/s", all(&|x| fit.at(x))));
        columns.push(column(&format!("{name} 95 %"), "mm/s", all(&|x| fit.upper(x))));
        fits.push((root, fit));
    }
    let suffix =
        run.suffix(&manifest, &format!("peak velocities up to t = {} s", short(frame.time)));
    let page = chart::draw((&manifest.title, &suffix), ("", ""), &panels);
    let columns: Vec<_> = columns.iter().collect();
    let out = out.into();
    let mut files = write(&page, &table_csv(&columns), out.clone())?;
    let stem = out.path.file_stem().unwrap_or_default().to_string_lossy();
    let path = out.path.with_file_name(format!("{stem}_fit.csv"));
    write_whole(&path, fit_csv(&fits).as_bytes())?;
    files.push(path);
    Ok(files)
}

fn samples(frame: &Frame, charges: &[&Source], surface: bool) -> Result<Vec<Sample>, PlotError> {
    let speed = choose(frame, "peak_speed")?.values;
    let up = if surface { Some(choose(frame, "surface")?.values) } else { None };
    let ids = frame.column("block").filter(|c| c.components == 1);
    let now = frame.column("velocity").filter(|c| c.components == 3);
    let rising = |i: usize| {
        let v = now.map_or([0.0; 3], |c| [0, 1, 2].map(|k| c.data[3 * i + k]));
        v[0].hypot(v[1]).hypot(v[2]) > RISING * speed[i]
    };
    let mut out = Vec::new();
    for (i, body) in solid::bodies(frame).iter().enumerate() {
        let place = body.start().to_array();
        let nearest = charges
            .iter()
            .map(|s| (s.distance(place), s.mass.unwrap_or(f64::NAN)))
            .min_by(|a, b| a.0.total_cmp(&b.0));
        let counts = speed[i] > 0.0 && !rising(i) && up.as_ref().is_none_or(|u| u[i] > 0.5);
        // No distance has no logarithm.
        if let Some((distance, mass)) = nearest.filter(|n| counts && n.0 > 0.0) {
            out.push(Sample {
                block: ids.map_or(i as f64, |c| c.data[i]),
                distance,
                mass,
                speed: MM * speed[i],
            });
        }
    }
    Ok(out)
}

fn panel(
    (name, unit): (&str, &str),
    scaled: &[f64],
    speed: &[f64],
    fit: &PowerLaw,
    what: &str,
) -> Panel {
    let ends = scaled.iter().fold([f64::INFINITY, 0.0f64], |e, x| [e[0].min(*x), e[1].max(*x)]);
    let line = |name: &str, mark, at: &dyn Fn(f64) -> f64| Curve {
        name: name.to_owned(),
        x: ends.to_vec(),
        y: ends.iter().map(|x| at(*x)).collect(),
        mark,
    };
    let cloud = Curve {
        name: format!("{} {what}", scaled.len()),
        x: scaled.to_vec(),
        y: speed.to_vec(),
        mark: Mark::Cloud,
    };
    Panel {
        name: PICTURE.to_owned(),
        unit: "mm/s".to_owned(),
        curves: vec![
            cloud,
            line("fit", Mark::Line, &|x| fit.at(x)),
            line("95 % line", Mark::Dashed, &|x| fit.upper(x)),
        ],
        log: true,
        height: 300.0,
        x: Some(Abscissa {
            name: format!("{name} scaled distance"),
            unit: unit.to_owned(),
            log: true,
        }),
        notes: vec![
            "v = K SD\u{207b}\u{207f}".to_owned(),
            format!("K = {} mm/s", digits(fit.factor, 4)),
            format!("n = {:.3} ± {}", fit.exponent, digits(fit.exponent_error, 2)),
            format!("R² = {:.3}", fit.r2),
            format!("scatter: factor {:.2}", libm::exp(fit.deviation)),
            format!("K 95 % = {} mm/s", digits(fit.upper_factor, 4)),
        ],
        ..Panel::default()
    }
}

fn fit_csv(fits: &[(f64, PowerLaw)]) -> String {
    let all = |f: &dyn Fn(&(f64, PowerLaw)) -> f64| fits.iter().map(f).collect();
    let columns = [
        column("root", "-", all(&|f| f.0)),
        column("K", "mm/s", all(&|f| f.1.factor)),
        column("n", "-", all(&|f| f.1.exponent)),
        column("standard error of n", "-", all(&|f| f.1.exponent_error)),
        column("R2", "-", all(&|f| f.1.r2)),
        column("deviation of ln v", "-", all(&|f| f.1.deviation)),
        column("K 95 %", "mm/s", all(&|f| f.1.upper_factor)),
        column("samples", "-", all(&|f| f.1.count as f64)),
    ];
    table_csv(&columns.iter().collect::<Vec<_>>())
}
