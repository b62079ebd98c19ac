//! Line charts: panels one above the other over a common abscissa.

use super::colour::LINES;
use super::svg::{Anchor, Page, fitted, text_width};
use super::ticks::{Scale, label};

/// One line of a panel.
#[derive(Debug, Clone)]
pub(super) struct Curve {
    pub(super) name: String,
    pub(super) x: Vec<f64>,
    /// Not-a-number means no value here; the line goes on to the next one.
    pub(super) y: Vec<f64>,
    /// Drawn as dots instead of a line.
    pub(super) dots: bool,
}

/// One pair of axes.
#[derive(Debug, Clone)]
pub(super) struct Panel {
    /// Ordinate: what and in which unit.
    pub(super) name: String,
    pub(super) unit: String,
    pub(super) curves: Vec<Curve>,
    pub(super) log: bool,
    pub(super) height: f64,
}

const WIDTH: f64 = 640.0;
const SIZE: f64 = 12.0;
const TOP: f64 = 44.0;
const GAP: f64 = 26.0;
const LEFT: f64 = 84.0;
/// More points than this are thinned to the extremes of each half pixel.
const MANY: usize = 4000;

/// Draws the panels; `x` is the name and unit of the abscissa.
pub(super) fn draw(title: &str, x: (&str, &str), panels: &[Panel]) -> Page {
    let legend = panels
        .iter()
        .filter(|p| p.curves.len() > 1)
        .flat_map(|p| &p.curves)
        .map(|c| text_width(&c.name, SIZE) + 44.0)
        .fold(24.0, f64::max);
    let height = TOP + panels.iter().map(|p| p.height + GAP).sum::<f64>() + 32.0;
    let mut page = Page::new(LEFT + WIDTH + legend, height);
    let width = page.width;
    page.text(
        [LEFT, 26.0],
        15.0,
        Anchor::Start,
        &fitted(title, 15.0, width - LEFT - 10.0),
    );
    let xs = panels
        .iter()
        .flat_map(|p| &p.curves)
        .flat_map(|c| &c.x)
        .copied();
    let sx = Scale {
        log: false,
        ..Scale::exact(xs)
    };
    let mut top = TOP;
    for (i, panel) in panels.iter().enumerate() {
        let last = i + 1 == panels.len();
        one_panel(&mut page, panel, &sx, top, i, last.then_some(x));
        top += panel.height + GAP;
    }
    page
}

fn one_panel(
    page: &mut Page,
    panel: &Panel,
    sx: &Scale,
    top: f64,
    index: usize,
    x: Option<(&str, &str)>,
) {
    let values = panel.curves.iter().flat_map(|c| &c.y).copied();
    let sy = if panel.log {
        Scale::decades(values)
    } else {
        Scale::covering(values)
    };
    let (h, bottom) = (panel.height, top + panel.height);
    let px = |v: f64| LEFT + WIDTH * sx.share(v);
    let py = |v: f64| bottom - h * sy.share(v);
    for (v, text) in sy.ticks((h / 36.0) as usize) {
        page.line([LEFT, py(v)], [LEFT + WIDTH, py(v)], "stroke=\"#e3e3e3\"");
        page.text([LEFT - 7.0, py(v) + 4.2], SIZE, Anchor::End, &text);
    }
    if sy.low < 0.0 && sy.high > 0.0 {
        page.line(
            [LEFT, py(0.0)],
            [LEFT + WIDTH, py(0.0)],
            "stroke=\"#9a9a9a\"",
        );
    }
    for (v, text) in sx.ticks(8) {
        page.line([px(v), top], [px(v), bottom], "stroke=\"#e3e3e3\"");
        if x.is_some() {
            page.text([px(v), bottom + 17.0], SIZE, Anchor::Middle, &text);
        }
    }
    page.begin_clip(&format!("panel{index}"), LEFT, top, WIDTH, h);
    for (i, curve) in panel.curves.iter().enumerate() {
        let colour = LINES[i % LINES.len()];
        let points: Vec<[f64; 2]> = curve
            .x
            .iter()
            .zip(&curve.y)
            .filter(|(a, b)| a.is_finite() && b.is_finite())
            .map(|(a, b)| [px(*a), py(*b)])
            .collect();
        if curve.dots {
            let every = points.len().div_ceil(60).max(1);
            for p in points.iter().step_by(every) {
                page.circle(
                    *p,
                    3.0,
                    &format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.4\""),
                );
            }
        } else if points.len() == 1 {
            page.circle(points[0], 2.5, &format!("fill=\"{colour}\""));
        } else {
            page.polyline(&thinned(points), &line_style(i));
        }
    }
    page.end_clip();
    page.rect(LEFT, top, WIDTH, h, "fill=\"none\" stroke=\"#1a1a1a\"");
    let text = fitted(&label(&panel.name, &panel.unit, &sy), SIZE, h + GAP);
    page.upright([20.0, top + h / 2.0], SIZE, &text);
    if let Some((name, unit)) = x {
        let text = label(name, unit, sx);
        page.text(
            [LEFT + WIDTH / 2.0, bottom + 38.0],
            SIZE,
            Anchor::Middle,
            &text,
        );
    }
    if panel.curves.len() > 1 {
        legend(page, panel, top);
    }
}

fn line_style(i: usize) -> String {
    let dash = ["", " stroke-dasharray=\"7 3\"", " stroke-dasharray=\"2 3\""];
    format!(
        "fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\" stroke-linejoin=\"round\"{}",
        LINES[i % LINES.len()],
        dash[i / LINES.len() % dash.len()]
    )
}

fn legend(page: &mut Page, panel: &Panel, top: f64) {
    let left = LEFT + WIDTH + 10.0;
    let room = ((panel.height / 17.0) as usize).max(1);
    let shown = if panel.curves.len() > room {
        room - 1
    } else {
        panel.curves.len()
    };
    for (i, curve) in panel.curves.iter().take(shown).enumerate() {
        let y = top + 10.0 + 17.0 * i as f64;
        if curve.dots {
            let style = format!(
                "fill=\"none\" stroke=\"{}\" stroke-width=\"1.4\"",
                LINES[i % LINES.len()]
            );
            page.circle([left + 9.0, y], 3.0, &style);
        } else {
            page.line([left, y], [left + 18.0, y], &line_style(i));
        }
        page.text([left + 24.0, y + 4.2], SIZE, Anchor::Start, &curve.name);
    }
    if shown < panel.curves.len() {
        let text = format!("and {} more", panel.curves.len() - shown);
        page.text(
            [left + 24.0, top + 14.0 + 17.0 * shown as f64],
            SIZE,
            Anchor::Start,
            &text,
        );
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
        assert_eq!(
            (thin[0], thin[thin.len() - 1]),
            (points[0], points[n as usize - 1])
        );
        assert!(thin.contains(&points[77_777]));
    }
}
