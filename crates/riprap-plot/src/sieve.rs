//! The fragment-size curve.

use super::chart::{self, Abscissa, Curve, Mark, Panel};
use super::run::Run;
use super::{PlotError, Target, column, digits, suffix, table_csv, write};
use crate::fits::{Passing, RosinRammler, Swebrec, rosin_rammler_fit, swebrec_fit};
use riprap_record::manifest::Manifest;
use riprap_record::names::Names;
use riprap_record::table::{Series, Table};
use riprap_record::write_whole;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

const PICTURE: &str = "fragment sizes";
/// Sieves that the fits look at, evenly spaced in the logarithm of the size.
const SIEVES: usize = 30;
/// Points of a drawn fit.
const POINTS: usize = 200;

/// Draws the fragment-size curve of `fragments.csv`, with x50 and x80 and fitted Rosin-Rammler and Swebrec curves.
///
/// The size of a fragment is the edge of the cube of its volume; in the plane the side of the square of its area. Fits
/// are by least squares of the share passing 30 sieves between the smallest and the largest fragment, evenly spaced in the logarithm; their
/// numbers are also in `NAME_fit.csv`. With fewer than four different sizes there are no fits.
///
/// What is held is no fragment, nor what is joined to it. Of some blocks of a run: the fragments that have one of these.
///
/// # Errors
/// A run without `fragments.csv`, a group that it does not have, a table without fragments, files that cannot be read or written.
pub fn fragments<'r, 't>(
    run: impl Into<Run<'r>>,
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    let Run { folder, of: group } = run.into();
    let manifest = Manifest::read(folder)?;
    let path = folder.join("fragments.csv");
    if !path.exists() {
        let reason = "the run has no fragments.csv: it has no joints, has not completed a phase, or was written by an earlier riprap"
            .to_owned();
        return Err(PlotError::Unsuitable { picture: PICTURE, reason });
    }
    let table = Table::read(&path)?;
    let flat = table.columns.iter().any(|c| c.name == "area_m2");
    let amounts = &table.column(if flat { "area_m2" } else { "volume_m3" })?.values;
    // Tables of earlier versions do not say what is held.
    let held = table.columns.iter().find(|c| c.name == "held");
    let wanted = group.map(|group| with_blocks_of(folder, group)).transpose()?;
    let counts = |k: usize| {
        held.is_none_or(|held| held.values[k] == 0.0)
            && wanted.as_ref().is_none_or(|w| w.contains(&(k as u32 + 1)))
    };
    let all = amounts.iter().enumerate();
    let amounts: Vec<f64> = all.filter(|(k, _)| counts(*k)).map(|(_, v)| *v).collect();
    let sizes = passing(&amounts, flat);
    if sizes.size.is_empty() {
        let of = group.map_or_else(String::new, |group| format!(" with a block of {group:?}"));
        let what = format!("{} lists no free fragments{of}", path.display());
        return Err(PlotError::NothingToDraw { what });
    }
    let count = amounts.iter().filter(|v| **v > 0.0).count();
    let of = group.map_or_else(String::new, |group| format!(" of {group}"));
    let title = suffix(&manifest, &format!("{count} fragments{of}"));
    curve((&manifest.title, &title), "fragment size", &sizes, out.into())
}

/// Sizes of blocks by volume (m3), in the plane by area (m2), and the share that is smaller: the edge of the cube of the same volume, the side
/// of the square of the same area.
#[must_use]
pub fn passing(amounts: &[f64], flat: bool) -> Passing {
    let edge = |v: f64| if flat { v.sqrt() } else { libm::cbrt(v) };
    Passing::of(amounts.iter().map(|v| (edge(*v), *v)))
}

/// Draws the curve of sizes of blocks as [`fragments`] does that of fragments. `head`: title and what stands below it.
///
/// # Errors
/// Files that cannot be written.
pub fn blocks<'t>(
    head: (&str, &str),
    sizes: &Passing,
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    if sizes.size.is_empty() {
        return Err(PlotError::NothingToDraw { what: "there is no block".to_owned() });
    }
    curve(head, "block size", sizes, out.into())
}

/// Rosin-Rammler and Swebrec, with four different sizes or more.
#[must_use]
pub fn fits(sizes: &Passing) -> Option<(RosinRammler, Swebrec)> {
    if sizes.size.len() < 4 {
        return None;
    }
    let sieves = sizes.sieves(SIEVES);
    let passing: Vec<f64> = sieves.iter().map(|x| sizes.at(*x)).collect();
    rosin_rammler_fit(&sieves, &passing).ok().zip(swebrec_fit(&sieves, &passing).ok())
}

/// Draws a curve of sizes and writes its numbers.
fn curve(
    head: (&str, &str),
    axis: &str,
    sizes: &Passing,
    out: Target<'_>,
) -> Result<Vec<PathBuf>, PlotError> {
    let fits = fits(sizes);
    let page = chart::draw(head, ("", ""), &[panel(axis, sizes, fits.as_ref())]);
    let at = |f: &dyn Fn(f64) -> f64| sizes.size.iter().map(|x| f(*x)).collect();
    let mut columns = vec![
        column("size", "m", sizes.size.clone()),
        column("passing", "-", sizes.passing.clone()),
    ];
    if let Some((rr, sw)) = &fits {
        columns.push(column("Rosin-Rammler", "-", at(&|x| rr.at(x))));
        columns.push(column("Swebrec", "-", at(&|x| sw.at(x))));
    }
    let mut files = write(&page, &table_csv(&columns.iter().collect::<Vec<_>>()), out.clone())?;
    let stem = out.path.file_stem().unwrap_or_default().to_string_lossy();
    let path = out.path.with_file_name(format!("{stem}_fit.csv"));
    let text = numbers(sizes, fits.as_ref());
    write_whole(&path, table_csv(&text.iter().collect::<Vec<_>>()).as_bytes())?;
    files.push(path);
    Ok(files)
}

/// Numbers of the fragments that have a block of a group, a block of this name or of this condition, or what such a block was split into.
fn with_blocks_of(folder: &Path, group: &str) -> Result<BTreeSet<u32>, PlotError> {
    let names = Names::read(folder)?;
    let path = folder.join("fragment_blocks.csv");
    if !path.exists() {
        let reason =
            "the run has no fragment_blocks.csv; it was written by an earlier riprap".to_owned();
        return Err(PlotError::Unsuitable { picture: PICTURE, reason });
    }
    let chosen = names.chosen(group).map_err(|what| PlotError::NothingToDraw { what })?;
    let table = Table::read(&path)?;
    let (blocks, fragments) = (table.column("block")?, table.column("fragment")?);
    let all = blocks.values.iter().zip(&fragments.values);
    let of_group = all.filter(|(b, _)| chosen.has(**b as u32));
    Ok(of_group.map(|(_, fragment)| *fragment as u32).collect())
}

/// One row: sizes as counted, and the fits where there are any.
fn numbers(sizes: &Passing, fits: Option<&(RosinRammler, Swebrec)>) -> Vec<Series> {
    let one = |name: &str, unit: &str, v: f64| column(name, unit, vec![v]);
    let mut out = vec![
        one("x20", "m", sizes.quantile(0.2)),
        one("x50", "m", sizes.quantile(0.5)),
        one("x80", "m", sizes.quantile(0.8)),
        one("largest", "m", sizes.size.last().copied().unwrap_or(f64::NAN)),
    ];
    if let Some((rr, sw)) = fits {
        out.extend([
            one("Rosin-Rammler x50", "m", rr.x50),
            one("Rosin-Rammler x80", "m", rr.size(0.8)),
            one("Rosin-Rammler n", "-", rr.n),
            one("Rosin-Rammler R2", "-", rr.r2),
            one("Swebrec x50", "m", sw.x50),
            one("Swebrec x80", "m", sw.size(0.8)),
            one("Swebrec xmax", "m", sw.xmax),
            one("Swebrec b", "-", sw.b),
            one("Swebrec R2", "-", sw.r2),
        ]);
    }
    out
}

fn panel(axis: &str, sizes: &Passing, fits: Option<&(RosinRammler, Swebrec)>) -> Panel {
    let percent = |p: &f64| 100.0 * p;
    // From size to size as [`Passing::quantile`] goes: x50 and x80 lie on the curve. The smallest pass all at once.
    let (mut x, mut y) = (vec![sizes.size[0]], vec![0.0]);
    x.extend(&sizes.size);
    y.extend(sizes.passing.iter().map(percent));
    let mut curves = vec![Curve { name: "volume passing".to_owned(), x, y, mark: Mark::Line }];
    let (x50, x80) = (sizes.quantile(0.5), sizes.quantile(0.8));
    let mut notes =
        vec![format!("x50 = {} m", digits(x50, 3)), format!("x80 = {} m", digits(x80, 3))];
    let fine = sizes.sieves(POINTS);
    if let Some((rr, sw)) = fits {
        let line = |name: &str, mark, f: &dyn Fn(f64) -> f64| Curve {
            name: name.to_owned(),
            x: fine.clone(),
            y: fine.iter().map(|x| percent(&f(*x))).collect(),
            mark,
        };
        curves.push(line("Rosin-Rammler", Mark::Line, &|x| rr.at(x)));
        curves.push(line("Swebrec", Mark::Line, &|x| sw.at(x)));
        notes.extend([
            String::new(),
            "Rosin-Rammler:".to_owned(),
            format!("x50 = {} m, n = {}", digits(rr.x50, 3), digits(rr.n, 3)),
            format!("R\u{b2} = {:.3}", rr.r2),
            String::new(),
            "Swebrec:".to_owned(),
            format!("x50 = {} m, b = {}", digits(sw.x50, 3), digits(sw.b, 3)),
            format!("xmax = {} m", digits(sw.xmax, 3)),
            format!("R\u{b2} = {:.3}", sw.r2),
        ]);
    } else {
        notes.push("too few sizes for a fit".to_owned());
    }
    let low = sizes.size.first().copied().unwrap_or(f64::NAN);
    for (name, share, size) in [("x50", 50.0, x50), ("x80", 80.0, x80)] {
        curves.push(Curve {
            name: name.to_owned(),
            x: vec![low, size, size],
            y: vec![share, share, 0.0],
            mark: Mark::Dashed,
        });
    }
    Panel {
        name: "volume passing".to_owned(),
        unit: "%".to_owned(),
        curves,
        height: 380.0,
        x: Some(Abscissa { name: axis.to_owned(), unit: "m".to_owned(), log: true }),
        notes,
        ..Panel::default()
    }
}
