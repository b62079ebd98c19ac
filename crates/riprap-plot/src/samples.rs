//! Pictures of many samples: histograms, and a tornado of what a result depends on.

use super::chart::{self, Abscissa, Curve, Panel};
use super::svg::{Anchor, Page, fitted};
use super::ticks::{Scale, label};
use super::{PlotError, Target, column, table_csv, write};
use std::path::PathBuf;

/// Values of one number in all samples.
#[derive(Clone, Debug)]
pub struct Sampled {
    /// What it is.
    pub name: String,
    /// Its unit; empty for plain numbers.
    pub unit: String,
    /// Its values, those that are no numbers left out.
    pub values: Vec<f64>,
}

/// Draws a histogram of each number, one below the other.
///
/// # Errors
/// No values; files that cannot be written.
pub fn histograms<'t>(
    title: &str,
    numbers: &[Sampled],
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    let counted: Vec<(&Sampled, Bins)> =
        numbers.iter().filter_map(|of| Some((of, Bins::of(&of.values)?))).collect();
    if counted.is_empty() {
        return Err(PlotError::NothingToDraw { what: "no sample has a value".to_owned() });
    }
    let panels: Vec<Panel> = counted
        .iter()
        .map(|(of, bins)| Panel {
            name: "samples".to_owned(),
            curves: vec![bins.outline()],
            height: 130.0,
            x: Some(Abscissa { name: of.name.clone(), unit: of.unit.clone(), log: false }),
            room: vec![0.0],
            ..Panel::default()
        })
        .collect();
    let columns: Vec<_> = counted
        .iter()
        .flat_map(|(of, bins)| {
            let middles = (0..bins.counts.len()).map(|k| bins.low + (k as f64 + 0.5) * bins.width);
            [
                column(&of.name, &of.unit, middles.collect()),
                column("samples", "-", bins.counts.iter().map(|n| *n as f64).collect()),
            ]
        })
        .collect();
    let page = chart::draw((title, ""), ("", ""), &panels);
    write(&page, &table_csv(&columns.iter().collect::<Vec<_>>()), out)
}

/// Counts in intervals of one width.
struct Bins {
    low: f64,
    width: f64,
    counts: Vec<usize>,
}

impl Bins {
    fn of(values: &[f64]) -> Option<Self> {
        let low = values.iter().copied().reduce(f64::min)?;
        let high = values.iter().copied().reduce(f64::max)?;
        let count = (values.len() as f64).sqrt().ceil().clamp(5.0, 40.0);
        let width = if high > low { (high - low) / count } else { low.abs().max(1.0) * 1e-3 };
        let mut counts = vec![0; count as usize];
        for value in values {
            let at = ((value - low) / width) as usize;
            counts[at.min(count as usize - 1)] += 1;
        }
        Some(Bins { low, width, counts })
    }

    fn outline(&self) -> Curve {
        let (mut x, mut y) = (vec![self.low], vec![0.0]);
        for (k, count) in self.counts.iter().enumerate() {
            let [left, right] = [k, k + 1].map(|k| self.low + k as f64 * self.width);
            x.extend([left, right]);
            y.extend([*count as f64; 2]);
        }
        x.push(self.low + self.counts.len() as f64 * self.width);
        y.push(0.0);
        Curve { x, y, ..Curve::default() }
    }
}

/// A result with what it depends on.
#[derive(Clone, Debug)]
pub struct Tornado {
    /// The result.
    pub name: String,
    /// Its mean over all samples.
    pub mean: f64,
    /// Each cause with the mean of the result in the samples with its lowest and with its highest values.
    pub swings: Vec<(String, [f64; 2])>,
}

/// Causes of a result, the one with the longest bar first.
type Bars<'a> = Vec<&'a (String, [f64; 2])>;

/// Bars of one result at most.
const BARS: usize = 12;
const LEFT: f64 = 260.0;
const WIDTH: f64 = 460.0;
const BAR: f64 = 22.0;
const SIZE: f64 = 12.0;
/// Colours of both ends of a bar.
const LOWEST: &str = "#0072b2";
const HIGHEST: &str = "#e69f00";
/// Room above the bars of a result and for its axis.
const FRAME: f64 = 76.0;

/// Draws a tornado of each result: the longest bar is the cause on which it depends most.
///
/// # Errors
/// No results; files that cannot be written.
pub fn tornado<'t>(
    title: &str,
    results: &[Tornado],
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    let legend = "mean of the samples with the lowest fifth (blue) and the highest fifth (orange) of each value";
    tornado_with(title, legend, results, out)
}

/// As [`tornado`], with words of its own on what the two ends of a bar are.
///
/// # Errors
/// No results; files that cannot be written.
pub fn tornado_with<'t>(
    title: &str,
    legend: &str,
    results: &[Tornado],
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    let finite = |[low, high]: &[f64; 2]| low.is_finite() && high.is_finite();
    let results: Vec<(&Tornado, Bars<'_>)> = results
        .iter()
        .filter(|of| of.swings.iter().any(|(_, swing)| finite(swing) && swing[0] != swing[1]))
        .map(|of| {
            let mut bars: Bars<'_> = of.swings.iter().filter(|(_, swing)| finite(swing)).collect();
            let length = |swing: &[f64; 2]| (swing[1] - swing[0]).abs();
            bars.sort_by(|a, b| length(&b.1).total_cmp(&length(&a.1)));
            bars.truncate(BARS);
            (of, bars)
        })
        .collect();
    if results.is_empty() {
        let what = "no result depends on the random values".to_owned();
        return Err(PlotError::NothingToDraw { what });
    }
    let height = results.iter().map(|(_, bars)| FRAME + BAR * bars.len() as f64).sum::<f64>();
    let mut page = Page::new(LEFT + WIDTH + 30.0, 64.0 + height);
    page.title([20.0, 26.0], 10.0, title, "");
    page.text([20.0, 46.0], 11.0, Anchor::Start, legend);
    let mut top = 64.0;
    for (of, bars) in &results {
        one_result(&mut page, of, bars, top);
        top += FRAME + BAR * bars.len() as f64;
    }
    let columns: Vec<_> = results
        .iter()
        .flat_map(|(of, bars)| {
            [0, 1].map(|end| {
                let name = format!("{} {}", of.name, ["at lowest", "at highest"][end]);
                column(&name, "", bars.iter().map(|(_, swing)| swing[end]).collect())
            })
        })
        .collect();
    write(&page, &table_csv(&columns.iter().collect::<Vec<_>>()), out)
}

fn one_result(page: &mut Page, of: &Tornado, bars: &[&(String, [f64; 2])], top: f64) {
    let ends = bars.iter().flat_map(|(_, swing)| *swing).chain([of.mean]);
    let scale = Scale::covering(ends);
    let px = |v: f64| LEFT + WIDTH * scale.share(v);
    let (top, bottom) = (top + 16.0, top + 16.0 + BAR * bars.len() as f64);
    for (v, text) in scale.ticks(6) {
        page.line([px(v), top], [px(v), bottom], "stroke=\"#e3e3e3\"");
        page.text([px(v), bottom + 17.0], SIZE, Anchor::Middle, &text);
    }
    for (k, (name, swing)) in bars.iter().enumerate() {
        let y = top + BAR * k as f64;
        page.text([LEFT - 10.0, y + 15.0], SIZE, Anchor::End, &fitted(name, SIZE, LEFT - 24.0));
        for (end, colour) in swing.iter().zip([LOWEST, HIGHEST]) {
            let [from, to] = [px(of.mean).min(px(*end)), px(of.mean).max(px(*end))];
            page.rect(from, y + 4.0, to - from, BAR - 8.0, &format!("fill=\"{colour}\""));
        }
    }
    page.line([px(of.mean), top], [px(of.mean), bottom], "stroke=\"#1a1a1a\"");
    page.rect(LEFT, top, WIDTH, bottom - top, "fill=\"none\" stroke=\"#1a1a1a\"");
    let at = [LEFT + WIDTH / 2.0, bottom + 38.0];
    page.text(at, SIZE, Anchor::Middle, &label(&of.name, "", &scale));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sample_is_counted_once() {
        let values: Vec<f64> = (0..100).map(|k| f64::from(k) * 0.01).collect();
        let bins = Bins::of(&values).unwrap();
        assert_eq!(bins.counts, [10; 10]);
        assert_eq!(Bins::of(&[3.0, 3.0]).unwrap().counts.iter().sum::<usize>(), 2);
        assert!(Bins::of(&[]).is_none());
    }

    #[test]
    fn the_cause_with_the_largest_swing_comes_first() {
        let folder = tempfile::tempdir().unwrap();
        let result = |swings: Vec<(String, [f64; 2])>| {
            [Tornado { name: "run-out [m]".to_owned(), mean: 2.0, swings }]
        };
        let causes = vec![("cohesion".to_owned(), [1.9, 2.1]), ("friction".to_owned(), [4.0, 1.0])];
        let out = folder.path().join("tornado.svg");
        tornado("a wedge", &result(causes), &out).unwrap();
        let drawn = std::fs::read_to_string(&out).unwrap();
        assert!(drawn.find(">friction<").unwrap() < drawn.find(">cohesion<").unwrap());
        let flat = result(vec![("cohesion".to_owned(), [2.0, 2.0])]);
        assert!(tornado("a wedge", &flat, &out).is_err());
    }
}
