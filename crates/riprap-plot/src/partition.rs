//! Where the energy of a run came from and went, as bars with their shares.

use super::svg::{Anchor, Page, fitted};
use super::ticks::Scale;
use super::{PlotError, Target, digits, write};
use riprap_record::field::number;
use std::fmt::Write as _;
use std::path::PathBuf;

/// A part of an energy that is drawn by [`partition`].
#[derive(Clone, Debug, PartialEq)]
pub struct Share {
    /// What it is.
    pub name: String,
    /// Whether it was put in; else it is where what was put in went.
    pub source: bool,
    /// J, or J/m in the plane.
    pub energy: f64,
    /// Over all that was put in.
    pub share: f64,
    /// What it depends on.
    pub depends_on: String,
}

const LEFT: f64 = 250.0;
const WIDTH: f64 = 520.0;
/// Room for the numbers beside the bars.
const NUMBERS: f64 = 160.0;
/// A bar and the line of text under it.
const ROW: f64 = 40.0;
const TOP: f64 = 58.0;
/// Room for the axis.
const FOOT: f64 = 48.0;
/// Between what was put in and where it went.
const GAP: f64 = 14.0;
const SIZE: f64 = 12.0;
const SMALL: f64 = 10.0;
/// Share that is told as nothing, %.
const NOTHING: f64 = 0.001;
/// Colours of what was put in, of where it went, and of what is negative: taken out of the model's own store.
const SOURCE: &str = "#e69f00";
const SINK: &str = "#0072b2";
const NEGATIVE: &str = "#cc79a7";

/// Draws what was put in and where it went: a bar each, with its share, its energy and what it depends on.
///
/// A negative bar is energy that the model had at the start and has given: weight that lies lower, stress that was released.
///
/// # Errors
/// No parts; files that cannot be written.
pub fn partition<'t>(
    title: &str,
    parts: &[Share],
    out: impl Into<Target<'t>>,
) -> Result<Vec<PathBuf>, PlotError> {
    let finite = |part: &&Share| part.share.is_finite() && part.energy.is_finite();
    let (from, to): (Vec<&Share>, Vec<&Share>) =
        parts.iter().filter(finite).partition(|part| part.source);
    if from.is_empty() && to.is_empty() {
        return Err(PlotError::NothingToDraw { what: "no energy was put in".to_owned() });
    }
    let rows = (from.len() + to.len()) as f64;
    let bottom = TOP + ROW * rows + GAP;
    let mut page = Page::new(LEFT + WIDTH + NUMBERS, bottom + FOOT);
    page.title([20.0, 26.0], 10.0, title, "");
    let scale = Scale::covering(parts.iter().map(|part| 100.0 * part.share).chain([0.0, 100.0]));
    let px = |v: f64| LEFT + WIDTH * scale.share(v);
    for (v, text) in scale.ticks(6) {
        page.line([px(v), TOP], [px(v), bottom], "stroke=\"#e3e3e3\"");
        page.text([px(v), bottom + 17.0], SIZE, Anchor::Middle, &text);
    }
    let mut y = TOP;
    for part in &from {
        bar(&mut page, part, &px, y);
        y += ROW;
    }
    y += GAP;
    page.line([20.0, y - GAP / 2.0], [LEFT + WIDTH, y - GAP / 2.0], "stroke=\"#9a9a9a\"");
    for part in &to {
        bar(&mut page, part, &px, y);
        y += ROW;
    }
    page.line([px(0.0), TOP], [px(0.0), bottom], "stroke=\"#1a1a1a\"");
    page.rect(LEFT, TOP, WIDTH, bottom - TOP, "fill=\"none\" stroke=\"#1a1a1a\"");
    let words = "share of the energy that was put in (above the line), %";
    page.text([LEFT + WIDTH / 2.0, bottom + 38.0], SIZE, Anchor::Middle, words);
    write(&page, &table(&from, &to), out)
}

/// One part, its row beginning at `y`.
fn bar(page: &mut Page, part: &Share, px: &impl Fn(f64) -> f64, y: f64) {
    let share = 100.0 * part.share;
    let [low, high] = [px(share.min(0.0)), px(share.max(0.0))];
    let colour = match (part.source, share < 0.0) {
        (true, _) => SOURCE,
        (false, false) => SINK,
        (false, true) => NEGATIVE,
    };
    page.rect(low, y + 5.0, high - low, 16.0, &format!("fill=\"{colour}\""));
    let name = fitted(&part.name, SIZE, LEFT - 34.0);
    page.text([LEFT - 10.0, y + 17.0], SIZE, Anchor::End, &name);
    let mega = if share.abs() < NOTHING { "0".to_owned() } else { digits(1e-6 * part.energy, 3) };
    let percent = if share.abs() < 0.05 { 0.0 } else { share };
    let percent = format!("{percent:.1}").replacen('-', "\u{2212}", 1);
    let numbers = format!("{percent} %, {mega} MJ");
    page.text([LEFT + WIDTH + 10.0, y + 17.0], SIZE, Anchor::Start, &numbers);
    let note = fitted(&part.depends_on, SMALL, WIDTH - 16.0);
    page.text([LEFT + 8.0, y + 33.0], SMALL, Anchor::Start, &note);
}

/// The numbers behind the picture.
fn table(from: &[&Share], to: &[&Share]) -> String {
    let mut text = "\"way\",\"part\",\"energy [J]\",\"share\"\n".to_owned();
    for (way, part) in from.iter().map(|part| ("from", part)).chain(to.iter().map(|p| ("to", p))) {
        let name = part.name.replace('"', "\"\"");
        let [energy, share] = [part.energy, part.share].map(number);
        // Writing into a `String` cannot fail.
        let _ = writeln!(text, "{way},\"{name}\",{energy},{share}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn part(name: &str, source: bool, share: f64) -> Share {
        let depends_on = "a choice".to_owned();
        Share { name: name.to_owned(), source, energy: 2e6 * share, share, depends_on }
    }

    #[test]
    fn bars_are_as_long_as_their_shares_and_negative_ones_go_left() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("parts.svg");
        let parts =
            [part("gas", true, 1.0), part("friction", false, 0.75), part("heave", false, -0.25)];
        let written = partition("a bench", &parts, &out).unwrap();
        assert_eq!(written.len(), 2);
        let drawn = std::fs::read_to_string(&out).unwrap();
        let bar = |colour: &str| {
            let line = drawn.lines().find(|l| l.starts_with("<rect") && l.contains(colour));
            let number = |key: &str| {
                let text = line.unwrap().split(key).nth(1).unwrap();
                text.split('"').next().unwrap().parse::<f64>().unwrap()
            };
            [number(" x=\""), number(" width=\"")]
        };
        let [gas, friction, heave] = [SOURCE, SINK, NEGATIVE].map(bar);
        assert!((friction[1] / gas[1] - 0.75).abs() < 1e-3, "{friction:?} {gas:?}");
        assert!((heave[1] / gas[1] - 0.25).abs() < 1e-3, "{heave:?} {gas:?}");
        assert!((heave[0] + heave[1] - gas[0]).abs() < 0.02, "{heave:?} {gas:?}");
        let table = std::fs::read_to_string(folder.path().join("parts_data.csv")).unwrap();
        assert_eq!(table.lines().nth(3), Some("to,\"heave\",-500000,-0.25"), "{table}");
        assert!(partition("a bench", &[], &out).is_err());
        assert!(partition("a bench", &[part("gas", true, f64::NAN)], &out).is_err());
    }
}
