//! What a blast does to the free surface: crater and heave.

use super::chart::{self, Abscissa, Curve, Mark, Panel};
use super::drawing::{Normal, choose, short};
use super::load::Which;
use super::load::listed;
use super::run::Run;
use super::section::need_space;
use super::{PlotError, Target, column, digits, solid, source, table_csv, write};
use riprap_geom::Vec3;
use riprap_record::frame::Frame;
use riprap_record::manifest::{Manifest, Source};
use riprap_record::table::Series;
use std::path::PathBuf;

const CRATER: &str = "the crater";
const HEAVE: &str = "the heave";
/// Uplift that bounds a crater, as a share of the depth of the charge, if the user gives none.
const THRESHOLD: f64 = 0.02;
/// Profiles of the heave if the user names no times.
const PROFILES: usize = 6;

/// How the crater is read.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct CraterOptions<'a> {
    /// Uplift that bounds it, m; `None` is 0.02 times the depth of the charge.
    pub uplift: Option<f64>,
    /// Name of the source; `None` is the first.
    pub source: Option<&'a str>,
}

/// A block with a free face looking up, above the charge.
struct Top {
    /// Centre before it moved, m.
    place: Vec3,
    /// Upward displacement, m.
    uplift: f64,
    /// Widths along x and y, m.
    width: [f64; 2],
}

/// Blocks of the free surface. The floor of the cavity has a free face looking up too, but lies below the charge.
fn tops(frame: &Frame, source: &Source, picture: &'static str) -> Result<Vec<Top>, PlotError> {
    need_space(frame, picture)?;
    let surface = choose(frame, "surface")?.values;
    let uplift = choose(frame, "displacement.z")?.values;
    let depth = source.centre()[2];
    let mut out = Vec::new();
    for (i, body) in solid::bodies(frame).iter().enumerate() {
        let place = body.start();
        if surface[i] < 0.5 || place.z <= depth {
            continue;
        }
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for p in frame.outline(i) {
            let p = body.unmoved(Vec3::from(*p));
            (low, high) = (low.min(p), high.max(p));
        }
        let width = high - low;
        out.push(Top { place, uplift: uplift[i], width: [width.x, width.y] });
    }
    if out.is_empty() {
        let what = format!("no block above the source `{}` has `surface` = 1", source.name);
        return Err(PlotError::NothingToDraw { what });
    }
    Ok(out)
}

/// Mean uplift in one ring about the source.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Ring {
    /// Mean distance of its blocks, m.
    radius: f64,
    /// Mean uplift, m.
    uplift: f64,
    count: usize,
}

/// Rings of a width, of samples (distance, uplift); rings without blocks are left out. The same reading as the
/// field `cavity.crater_radius` of a running model.
fn rings(samples: &[[f64; 2]], width: f64) -> Vec<Ring> {
    let mut sorted = samples.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let number = |r: f64| (r / width + 1e-9).floor();
    sorted
        .chunk_by(|a, b| number(a[0]) == number(b[0]))
        .map(|ring| {
            let mean = |k: usize| ring.iter().map(|s| s[k]).sum::<f64>() / ring.len() as f64;
            Ring { radius: mean(0), uplift: mean(1), count: ring.len() }
        })
        .collect()
}

/// Where, going outwards, the ring means first fall below the threshold, between rings linearly.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Edge {
    /// The innermost ring is below it already.
    None,
    /// Radius, m.
    At(f64),
    /// All rings are above it; the radius of the last one, m.
    Beyond(f64),
}

fn edge(rings: &[Ring], threshold: f64) -> Edge {
    let Some(outside) = rings.iter().position(|r| r.uplift < threshold) else {
        return rings.last().map_or(Edge::None, |r| Edge::Beyond(r.radius));
    };
    let Some(inside) = outside.checked_sub(1) else {
        return Edge::None;
    };
    let (inner, outer) = (rings[inside], rings[outside]);
    let share = (inner.uplift - threshold) / (inner.uplift - outer.uplift);
    Edge::At(inner.radius + share * (outer.radius - inner.radius))
}

/// Draws the uplift of the free surface in one frame against the horizontal distance from a source: every surface
/// block, the mean in rings as wide as the narrowest block, the threshold. The crater's radius is where, going outwards,
/// the ring means first fall below the threshold.
///
/// # Errors
/// Runs in the plane, without sources, without surface blocks; no threshold and no depth to take it from.
pub fn crater<'r, 't>(
    run: impl Into<Run<'r>>,
    frame: Which,
    options: CraterOptions,
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    if let Some(uplift) = options.uplift.filter(|u| !u.is_finite() || *u <= 0.0) {
        return Err(PlotError::Option {
            option: "uplift",
            given: format!("{} m", short(uplift)),
            wanted: "give a value above zero, for example 40 mm",
        });
    }
    let run = run.into();
    let manifest = Manifest::read(run.folder)?;
    let frame = run.frame(frame)?;
    need_space(&frame, CRATER)?;
    let source = source(&manifest, options.source, CRATER)?;
    let Some(threshold) = options.uplift.or(source.depth.map(|d| THRESHOLD * d)) else {
        let reason = format!(
            "source `{}` has no depth from which to derive the threshold; give the uplift at the crater rim",
            source.name
        );
        return Err(PlotError::Unsuitable { picture: CRATER, reason });
    };
    let tops = tops(&frame, source, CRATER)?;
    let [x, y, _] = source.centre();
    let samples: Vec<[f64; 2]> =
        tops.iter().map(|t| [libm::hypot(t.place.x - x, t.place.y - y), t.uplift]).collect();
    let width = tops.iter().flat_map(|t| t.width).fold(f64::INFINITY, f64::min);
    let rings = rings(&samples, width);
    let edge = edge(&rings, threshold);
    let title =
        run.suffix(&manifest, &format!("t = {} s: {}", short(frame.time), said(edge, source)));
    let panel = crater_panel(&samples, &rings, threshold, (edge, width));
    let page = chart::draw((&manifest.title, &title), ("", ""), &[panel]);
    let all = |f: &dyn Fn(&Ring) -> f64| rings.iter().map(f).collect();
    let columns = [
        column("distance", "m", samples.iter().map(|s| s[0]).collect()),
        column("uplift", "m", samples.iter().map(|s| s[1]).collect()),
        column("ring distance", "m", all(&|r| r.radius)),
        column("ring mean uplift", "m", all(&|r| r.uplift)),
        column("ring blocks", "-", all(&|r| r.count as f64)),
        column("threshold", "m", vec![threshold]),
        column(
            "crater radius",
            "m",
            vec![match edge {
                Edge::At(r) => r,
                Edge::None => 0.0,
                Edge::Beyond(_) => f64::INFINITY,
            }],
        ),
        column("charge depth", "m", vec![source.depth.unwrap_or(f64::NAN)]),
    ];
    write(&page, &table_csv(&columns.iter().collect::<Vec<_>>()), out)
}

/// The crater in words: radius, depth of the charge, their ratio.
fn said(edge: Edge, source: &Source) -> String {
    let depth = source.depth;
    let ratio = |sign: &str, r: f64| {
        let mut text = format!("r {sign} {} m", digits(r, 3));
        if let Some(w) = depth.filter(|w| *w > 0.0) {
            text += &format!(", W = {} m, r/W {sign} {}", digits(w, 3), digits(r / w, 3));
        }
        text
    };
    match edge {
        Edge::None => "no crater".to_owned(),
        Edge::At(r) => ratio("=", r),
        Edge::Beyond(r) => ratio(">", r),
    }
}

fn crater_panel(
    samples: &[[f64; 2]],
    rings: &[Ring],
    threshold: f64,
    (edge, width): (Edge, f64),
) -> Panel {
    let far = samples.iter().map(|s| s[0]).fold(0.0, f64::max);
    let top = samples.iter().map(|s| s[1]).fold(0.0, f64::max);
    let mut curves = vec![
        Curve {
            name: "surface blocks".to_owned(),
            x: samples.iter().map(|s| s[0]).collect(),
            y: samples.iter().map(|s| s[1]).collect(),
            mark: Mark::Cloud,
        },
        Curve {
            name: "mean in rings".to_owned(),
            x: rings.iter().map(|r| r.radius).collect(),
            y: rings.iter().map(|r| r.uplift).collect(),
            mark: Mark::Line,
        },
        Curve {
            name: "threshold".to_owned(),
            x: vec![0.0, far],
            y: vec![threshold; 2],
            mark: Mark::Dashed,
        },
    ];
    if let Edge::At(r) = edge {
        curves.push(Curve {
            name: "crater radius".to_owned(),
            x: vec![r, r],
            y: vec![0.0, top],
            mark: Mark::Dashed,
        });
    }
    Panel {
        name: "uplift".to_owned(),
        unit: "m".to_owned(),
        curves,
        height: 340.0,
        x: Some(Abscissa {
            name: "horizontal distance from the source".to_owned(),
            unit: "m".to_owned(),
            log: false,
        }),
        notes: vec![
            format!("threshold {} m", short(threshold)),
            format!("rings {} m wide", short(width)),
        ],
        // Where nothing rises to it, the threshold is not on the frame.
        room: vec![1.1 * threshold],
        ..Panel::default()
    }
}

/// Draws profiles of the free surface through a source: uplift along x (or along y with [`Normal::X`]) in several
/// frames. No frames: six, spread over the run.
///
/// # Errors
/// Runs in the plane, without sources, without surface blocks; a horizontal section.
pub fn heave<'r, 't>(
    run: impl Into<Run<'r>>,
    frames: &[Which],
    source_name: Option<&str>,
    normal: Normal,
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    let run = run.into();
    let manifest = Manifest::read(run.folder)?;
    let source = source(&manifest, source_name, HEAVE)?;
    let [along, _] = normal.across();
    if normal == Normal::Z {
        let reason = "a profile runs along x or y; use the normal y or x".to_owned();
        return Err(PlotError::Unsuitable { picture: HEAVE, reason });
    }
    let spread: Vec<Which>;
    let frames = if frames.is_empty() {
        spread = spread_over(listed(run.folder)?.len());
        &spread
    } else {
        frames
    };
    let (mut curves, mut columns): (Vec<Curve>, Vec<Series>) = (Vec::new(), Vec::new());
    for which in frames {
        let frame = run.frame(*which)?;
        let (x, y) = profile(&tops(&frame, source, HEAVE)?, source.centre(), along);
        let name = format!("t = {} s", short(frame.time));
        let axis = normal.axes()[0];
        columns.push(column(&format!("{axis}, {name}"), "m", x.clone()));
        columns.push(column(&format!("uplift, {name}"), "m", y.clone()));
        curves.push(Curve { name, x, y, mark: Mark::Line });
    }
    let [axis, _] = normal.axes();
    let across = 1 - along;
    let panel = Panel {
        name: "uplift of the surface".to_owned(),
        unit: "m".to_owned(),
        curves,
        height: 340.0,
        notes: vec![format!("{} = {} m", ["x", "y"][across], digits(source.centre()[across], 4))],
        ..Panel::default()
    };
    let title = run.suffix(&manifest, &format!("heave over `{}`", source.name));
    let page = chart::draw((&manifest.title, &title), (axis, "m"), &[panel]);
    write(&page, &table_csv(&columns.iter().collect::<Vec<_>>()), out)
}

/// Frames evenly spread over the run, the last one among them; the first shows nothing yet.
fn spread_over(count: usize) -> Vec<Which> {
    let mut all: Vec<usize> = (1..=PROFILES)
        .map(|k| (1.0 + (count - 1) as f64 * k as f64 / PROFILES as f64).round() as usize)
        .collect();
    all.dedup();
    all.into_iter().map(Which::Index).collect()
}

/// Uplift along a line through the source: blocks under the line, those on both sides of it averaged.
fn profile(tops: &[Top], centre: [f64; 3], along: usize) -> (Vec<f64>, Vec<f64>) {
    let across = 1 - along;
    let mut on: Vec<&Top> = tops
        .iter()
        .filter(|t| {
            (t.place[across] - centre[across]).abs() <= 0.5 * t.width[across] * (1.0 + 1e-6)
        })
        .collect();
    on.sort_by(|a, b| a.place[along].total_cmp(&b.place[along]));
    on.chunk_by(|a, b| b.place[along] - a.place[along] < 1e-3 * a.width[along])
        .map(|same| {
            let n = same.len() as f64;
            (
                same.iter().map(|t| t.place[along]).sum::<f64>() / n,
                same.iter().map(|t| t.uplift).sum::<f64>() / n,
            )
        })
        .unzip()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_edge_of_a_cone_is_where_it_crosses() {
        // Uplift 0.1 m - 0.02 r: 0.04 m at r = 3 m.
        let samples: Vec<[f64; 2]> =
            (0..100).map(|i| 0.1 * f64::from(i)).map(|r| [r, 0.1 - 0.02 * r]).collect();
        let all = rings(&samples, 0.5);
        assert_eq!(all.len(), 20);
        let Edge::At(r) = edge(&all, 0.04) else { panic!("no edge") };
        assert!((r - 3.0).abs() < 1e-9, "{r}");
        assert_eq!(edge(&all, 0.2), Edge::None);
        assert!(matches!(edge(&all, -9.0), Edge::Beyond(_)));
    }

    #[test]
    fn frames_are_spread_to_the_last() {
        let index = |n| -> Vec<usize> {
            spread_over(n)
                .iter()
                .map(|w| match w {
                    Which::Index(i) => *i,
                    Which::Last | Which::Time(_) => 0,
                })
                .collect()
        };
        assert_eq!(index(13), [3, 5, 7, 9, 11, 13]);
        assert_eq!(index(3), [1, 2, 3]);
        assert_eq!(index(1), [1]);
    }
}
