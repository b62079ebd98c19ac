//! Line charts: panels one above the other, over a common abscissa or each over its own.

use super::colour::LINES;
use super::svg::{Anchor, Page, fitted, text_width};
use super::ticks::{Scale, label};
use std::collections::BTreeSet;

/// How the samples of a curve are drawn.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Mark {
    /// Joined.
    #[default]
    Line,
    /// Joined by a broken line.
    Dashed,
    /// As rings, not more than 60.
    Rings,
    /// As faint dots, any number of them.
    Cloud,
}

/// One curve of a panel.
#[derive(Debug, Clone, Default)]
pub(super) struct Curve {
    pub(super) name: String,
    pub(super) x: Vec<f64>,
    /// Not-a-number means no value here; the line goes on to the next one.
    pub(super) y: Vec<f64>,
    pub(super) mark: Mark,
}

/// What runs along x.
#[derive(Debug, Clone, Default)]
pub(super) struct Abscissa {
    pub(super) name: String,
    pub(super) unit: String,
    pub(super) log: bool,
}

/// One pair of axes.
#[derive(Debug, Clone, Default)]
pub(super) struct Panel {
    /// Ordinate: what and in which unit.
    pub(super) name: String,
    pub(super) unit: String,
    pub(super) curves: Vec<Curve>,
    pub(super) log: bool,
    pub(super) height: f64,
    /// An abscissa of its own; `None` shares that of the page.
    pub(super) x: Option<Abscissa>,
    /// Lines of text below the legend.
    pub(super) notes: Vec<String>,
    /// Ordinates that are in the picture besides those of the curves.
    pub(super) room: Vec<f64>,
}

impl Panel {
    fn has_legend(&self) -> bool {
        self.curves.len() > 1 || !self.notes.is_empty()
    }
}

const WIDTH: f64 = 640.0;
const SIZE: f64 = 12.0;
const TOP: f64 = 44.0;
const GAP: f64 = 26.0;
/// Room for the numbers and the name of an abscissa.
const FOOT: f64 = 32.0;
const LEFT: f64 = 84.0;
/// Height of a line of the legend.
const ROW: f64 = 17.0;
/// More points than this are thinned to the extremes of each half pixel.
const MANY: usize = 4000;

/// Draws the panels; `title` has a second part that stays when the first is too long, `x` is the name and unit of the
/// common abscissa.
pub(super) fn draw((title, suffix): (&str, &str), x: (&str, &str), panels: &[Panel]) -> Page {
    let legend = panels
        .iter()
        .filter(|p| p.has_legend())
        .flat_map(|p| {
            let curves = p.curves.iter().map(|c| text_width(&c.name, SIZE) + 44.0);
            curves.chain(p.notes.iter().map(|n| text_width(n, SIZE) + 30.0))
        })
        .fold(24.0, f64::max);
    let feet = panels.iter().rev().skip(1).filter(|p| p.x.is_some());
    let height =
        TOP + panels.iter().map(|p| p.height + GAP).sum::<f64>() + FOOT * (1 + feet.count()) as f64;
    let mut page = Page::new(LEFT + WIDTH + legend, height);
    page.title([LEFT, 26.0], 10.0, title, suffix);
    let common = Abscissa { name: x.0.to_owned(), unit: x.1.to_owned(), log: false };
    let xs = |p: &Panel| -> Vec<f64> { p.curves.iter().flat_map(|c| c.x.clone()).collect() };
    let shared: Vec<f64> = panels.iter().filter(|p| p.x.is_none()).flat_map(xs).collect();
    let shared = Scale::exact(shared);
    let mut top = TOP;
    for (i, panel) in panels.iter().enumerate() {
        let last = i + 1 == panels.len();
        let (x, scale) = match &panel.x {
            Some(own) if own.log => (Some(own), Scale::log_covering(xs(panel))),
            Some(own) => (Some(own), Scale::exact(xs(panel))),
            None => (last.then_some(&common), shared),
        };
        one_panel(&mut page, panel, &scale, top, i, x);
        top += panel.height + GAP + if panel.x.is_some() { FOOT } else { 0.0 };
    }
    page
}

fn one_panel(
    page: &mut Page,
    panel: &Panel,
    sx: &Scale,
    top: f64,
    index: usize,
    x: Option<&Abscissa>,
) {
    let values = panel.curves.iter().flat_map(|c| &c.y).chain(&panel.room).copied();
    let sy = match (panel.log, sx.log) {
        (true, true) => Scale::log_covering(values),
        (true, false) => Scale::decades(values),
        (false, _) => Scale::covering(values),
    };
    let (h, bottom) = (panel.height, top + panel.height);
    let px = |v: f64| LEFT + WIDTH * sx.share(v);
    let py = |v: f64| bottom - h * sy.share(v);
    for v in sx.fine() {
        page.line([px(v), top], [px(v), bottom], "stroke=\"#f2f2f2\"");
    }
    for v in sy.fine() {
        page.line([LEFT, py(v)], [LEFT + WIDTH, py(v)], "stroke=\"#f2f2f2\"");
    }
    for (v, text) in sy.ticks((h / 36.0) as usize) {
        page.line([LEFT, py(v)], [LEFT + WIDTH, py(v)], "stroke=\"#e3e3e3\"");
        page.text([LEFT - 7.0, py(v) + 4.2], SIZE, Anchor::End, &text);
    }
    if sy.low < 0.0 && sy.high > 0.0 {
        page.line([LEFT, py(0.0)], [LEFT + WIDTH, py(0.0)], "stroke=\"#9a9a9a\"");
    }
    for (v, text) in sx.ticks(8) {
        page.line([px(v), top], [px(v), bottom], "stroke=\"#e3e3e3\"");
        if x.is_some() {
            page.text([px(v), bottom + 17.0], SIZE, Anchor::Middle, &text);
        }
    }
    page.begin_clip(&format!("panel{index}"), LEFT, top, WIDTH, h);
    for (i, curve) in panel.curves.iter().enumerate() {
        let points: Vec<[f64; 2]> = curve
            .x
            .iter()
            .zip(&curve.y)
            .filter(|(a, b)| a.is_finite() && b.is_finite())
            .filter(|(a, b)| !(sx.log && **a <= 0.0 || sy.log && sx.log && **b <= 0.0))
            .map(|(a, b)| [px(*a), py(*b)])
            .collect();
        samples(page, curve.mark, i, points);
    }
    page.end_clip();
    page.rect(LEFT, top, WIDTH, h, "fill=\"none\" stroke=\"#1a1a1a\"");
    let text = fitted(&label(&panel.name, &panel.unit, &sy), SIZE, h + GAP);
    page.upright([20.0, top + h / 2.0], SIZE, &text);
    if let Some(x) = x {
        let at = [LEFT + WIDTH / 2.0, bottom + 38.0];
        page.text(at, SIZE, Anchor::Middle, &label(&x.name, &x.unit, sx));
    }
    if panel.has_legend() {
        legend(page, panel, top);
    }
}

fn samples(page: &mut Page, mark: Mark, i: usize, points: Vec<[f64; 2]>) {
    match mark {
        Mark::Rings => {
            let every = points.len().div_ceil(60).max(1);
            for p in points.iter().step_by(every) {
                page.circle(*p, 3.0, &ring_style(i));
            }
        }
        Mark::Cloud => {
            // Dots that would hide each other are drawn once.
            let mut taken = BTreeSet::new();
            for p in points {
                if taken.insert(p.map(|v| (v / 1.5) as i64)) {
                    page.circle(p, 1.8, &cloud_style(i));
                }
            }
        }
        Mark::Line | Mark::Dashed if points.len() == 1 => {
            let colour = LINES[i % LINES.len()];
            page.circle(points[0], 2.5, &format!("fill=\"{colour}\""));
        }
        Mark::Line | Mark::Dashed => page.polyline(&thinned(points), &line_style(i, mark)),
    }
}

fn ring_style(i: usize) -> String {
    let colour = LINES[i % LINES.len()];
    format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.4\"")
}

fn cloud_style(i: usize) -> String {
    format!("fill=\"{}\" fill-opacity=\"0.2\"", LINES[i % LINES.len()])
}

fn line_style(i: usize, mark: Mark) -> String {
    let dash = ["", " stroke-dasharray=\"7 3\"", " stroke-dasharray=\"2 3\""];
    let dash = if mark == Mark::Dashed {
        " stroke-dasharray=\"6 4\""
    } else {
        dash[i / LINES.len() % dash.len()]
    };
    format!(
        "fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" stroke-linejoin=\"round\"{dash}",
        LINES[i % LINES.len()],
    )
}

fn legend(page: &mut Page, panel: &Panel, top: f64) {
    let left = LEFT + WIDTH + 10.0;
    let room = ((panel.height / ROW) as usize).saturating_sub(panel.notes.len()).max(1);
    let shown = if panel.curves.len() > room { room - 1 } else { panel.curves.len() };
    for (i, curve) in panel.curves.iter().take(shown).enumerate() {
        let y = top + 10.0 + ROW * i as f64;
        match curve.mark {
            Mark::Rings => page.circle([left + 9.0, y], 3.0, &ring_style(i)),
            Mark::Cloud => page.circle([left + 9.0, y], 2.5, &cloud_style(i)),
            Mark::Line | Mark::Dashed => {
                page.line([left, y], [left + 18.0, y], &line_style(i, curve.mark));
            }
        }
        page.text([left + 24.0, y + 4.2], SIZE, Anchor::Start, &curve.name);
    }
    let mut below = shown;
    if shown < panel.curves.len() {
        let text = format!("and {} more", panel.curves.len() - shown);
        let y = top + 14.0 + ROW * shown as f64;
        page.text([left + 24.0, y], SIZE, Anchor::Start, &text);
        below += 1;
    }
    for (i, note) in panel.notes.iter().enumerate() {
        let y = top + 22.0 + ROW * (below + i) as f64;
        page.text([left, y], SIZE, Anchor::Start, note);
    }
}

/// Many points along growing x: first, lowest, highest and last of each half pixel look the same as all of them.
fn thinned(points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    if points.len() <= MANY || !points.is_sorted_by(|a, b| a[0] <= b[0]) {
        return points;
    }
    let mut out = Vec::new();
    for column in points.chunk_by(|a, b| (a[0] * 2.0).floor() == (b[0] * 2.0).floor()) {
        let last = column.len() - 1;
        let by_y = |a: &usize, b: &usize| column[*a][1].total_cmp(&column[*b][1]);
        let mut keep = vec![0, last];
        keep.extend((0..=last).min_by(by_y));
        keep.extend((0..=last).max_by(by_y));
        keep.sort_unstable();
        keep.dedup();
        out.extend(keep.into_iter().map(|i| column[i]));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_ends_and_peaks() {
        let n = 100_000;
        let mut points: Vec<[f64; 2]> = (0..n).map(|i| [f64::from(i) / 200.0, 0.0]).collect();
        points[77_777][1] = 9.0;
        let thin = thinned(points.clone());
        assert!(thin.len() < 3000, "{}", thin.len());
        assert_eq!((thin[0], thin[thin.len() - 1]), (points[0], points[n as usize - 1]));
        assert!(thin.contains(&points[77_777]));
    }
}
