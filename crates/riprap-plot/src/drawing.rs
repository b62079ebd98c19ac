//! What pictures of blocks are asked for, and what all of them read of a frame.

use riprap_keys::Words;

use super::PlotError;
use riprap_record::field::{FieldError, Part, nearest};
use riprap_record::frame::{Frame, SEEPAGE_FLOW};

/// Direction that a cut is normal to.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Words)]
pub enum Normal {
    /// y to the right, z up.
    X,
    /// x to the right, z up.
    #[default]
    Y,
    /// x to the right, y up: a plan.
    Z,
}

impl Normal {
    pub(super) fn index(self) -> usize {
        match self {
            Normal::X => 0,
            Normal::Y => 1,
            Normal::Z => 2,
        }
    }

    /// The axes of the picture.
    pub(super) fn across(self) -> [usize; 2] {
        match self {
            Normal::X => [1, 2],
            Normal::Y => [0, 2],
            Normal::Z => [0, 1],
        }
    }

    pub(super) fn axes(self) -> [&'static str; 2] {
        self.across().map(|k| ["x", "y", "z"][k])
    }
}

/// What arrows show.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Words)]
pub enum Vectors {
    /// Way since the start.
    Displacement,
    /// As it is now.
    Velocity,
    /// Water that seeps through joints, at their middles.
    Flow,
}

impl Vectors {
    /// Column of the frame.
    pub(super) fn column(self) -> &'static str {
        match self {
            Vectors::Displacement => "displacement",
            Vectors::Velocity => "velocity",
            Vectors::Flow => SEEPAGE_FLOW,
        }
    }
}

/// How blocks are drawn, and what besides them.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct BlockOptions {
    /// Contact points, and contact forces if the frame has a vector column with `force` in its name. In the plane only.
    pub contacts: bool,
    /// Colours over powers of ten.
    pub log: bool,
    /// Values of the first and the last colour, in the unit of the field; `None` covers all values.
    pub range: Option<[f64; 2]>,
    /// Shares of the values, 0 to 100, at which the colours begin and end: `[2, 98]` leaves out what single blocks have.
    pub percentiles: Option<[f64; 2]>,
    /// Arrows on the blocks.
    pub vectors: Option<Vectors>,
    /// What is shown: left, bottom, right and top in the axes of the picture, m; `None` is all of the model.
    pub window: Option<[f64; 4]>,
    /// In space: marks of the faces that have broken where the cut meets them.
    pub cracks: bool,
    /// Principal stresses as crosses, in space those in the plane of the cut.
    pub stress: bool,
    /// About so many lines of equal value over the blocks, at round values; 0 is none.
    pub isolines: usize,
    /// Factor on displacements and rotations; `None` is 1: blocks where they are.
    pub exaggeration: Option<f64>,
    /// In space: direction that the cut is normal to.
    pub normal: Normal,
    /// In space: where the cut lies along its normal, m; `None` is the first source, or the middle of the model.
    pub at: Option<f64>,
}

/// More lines of equal value than this hide what they are drawn over.
const MOST_ISOLINES: usize = 50;

impl BlockOptions {
    /// Refuses what no picture can be drawn by.
    pub(super) fn checked(&self) -> Result<(), PlotError> {
        let wrong = |option, given, wanted| Err(PlotError::Option { option, given, wanted });
        if let Some(window @ [left, bottom, right, top]) = self.window {
            let finite = window.iter().all(|v| v.is_finite());
            if !finite || left >= right || bottom >= top {
                let given = window.map(short).join(", ");
                return wrong(
                    "window",
                    given,
                    "give left, bottom, right and top: left less than right, bottom less than top",
                );
            }
        }
        if let Some(range @ [low, high]) = self.range {
            let given = || range.map(short).join(" to ");
            if !low.is_finite() || !high.is_finite() || low >= high {
                return wrong("range", given(), "give the lowest value and a higher one");
            }
            if self.log && low <= 0.0 {
                return wrong("range", given(), "a logarithmic scale begins above 0");
            }
            if self.percentiles.is_some() {
                return wrong("range", given(), "give either a range or percentiles");
            }
        }
        if let Some(shares @ [low, high]) = self.percentiles
            && !(0.0 <= low && low < high && high <= 100.0)
        {
            let given = shares.map(short).join(" to ");
            return wrong("percentiles", given, "give two shares from 0 to 100, for example 2 98");
        }
        match self.exaggeration {
            Some(factor) if !factor.is_finite() || factor <= 0.0 => {
                return wrong(
                    "exaggerate",
                    short(factor),
                    "give a positive factor, for example 20",
                );
            }
            Some(_) | None => {}
        }
        match self.at {
            Some(at) if !at.is_finite() => {
                return wrong("at", short(at), "give a position along the normal in m");
            }
            Some(_) | None => {}
        }
        if self.isolines > MOST_ISOLINES {
            let given = self.isolines.to_string();
            return wrong("isolines", given, "give a number up to 50");
        }
        Ok(())
    }
}

/// A field of a frame as numbers on blocks.
pub(super) struct Chosen {
    pub(super) name: String,
    pub(super) unit: String,
    pub(super) values: Vec<f64>,
}

/// Finds `displacement`, `block.displacement`, `block.velocity.x`... A vector without a part is its magnitude.
pub(super) fn choose(frame: &Frame, field: &str) -> Result<Chosen, FieldError> {
    let bare = |s: &str| s.strip_prefix("block.").unwrap_or(s).to_owned();
    let find = |name: &str| frame.block_columns.iter().find(|c| bare(&c.name) == bare(name));
    let (stem, part) = Part::split(field);
    let (column, part) = match (find(field), find(stem)) {
        (Some(c), _) => (c, Part::Whole),
        (None, Some(c)) if c.components > 1 => (c, part),
        (None, Some(_)) => {
            return Err(FieldError::NoComponents {
                name: field.to_owned(),
                field: stem.to_owned(),
            });
        }
        (None, None) => {
            let known: Vec<String> = frame.block_columns.iter().map(|c| c.name.clone()).collect();
            let suggestion =
                nearest(&bare(stem), known.iter().map(String::as_str)).map(str::to_owned);
            return Err(FieldError::Unknown { name: field.to_owned(), suggestion, known });
        }
    };
    let part = if column.components > 1 && part == Part::Whole { Part::Magnitude } else { part };
    let suffix = match part {
        Part::Whole => "",
        Part::X => ", x",
        Part::Y => ", y",
        Part::Z => ", z",
        Part::Magnitude => " magnitude",
    };
    Ok(Chosen {
        name: format!("{}{suffix}", bare(&column.name).replace('_', " ")),
        unit: column.unit.clone(),
        values: column.numbers(part),
    })
}

/// Centroid of an outline in the plane.
pub(super) fn middle(outline: &[[f64; 3]]) -> [f64; 2] {
    // Centroid by triangles from the first vertex, which keeps its digits far from the origin.
    let [ox, oy, _] = outline.first().copied().unwrap_or_default();
    let (mut area, mut x, mut y) = (0.0, 0.0, 0.0);
    for pair in outline.windows(2) {
        let (ax, ay, bx, by) = (pair[0][0] - ox, pair[0][1] - oy, pair[1][0] - ox, pair[1][1] - oy);
        let cross = ax * by - bx * ay;
        area += cross;
        x += cross * (ax + bx) / 3.0;
        y += cross * (ay + by) / 3.0;
    }
    if area == 0.0 { [ox, oy] } else { [ox + x / area, oy + y / area] }
}

/// A number for people: at most 6 digits.
pub(super) fn short(v: f64) -> String {
    if v != 0.0 && !(1e-4..1e6).contains(&v.abs()) {
        let text = format!("{v:.3e}");
        let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
        return format!("{}e{power}", digits.trim_end_matches('0').trim_end_matches('.'));
    }
    let text = format!("{v:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_that_no_picture_can_be_drawn_by_are_refused() {
        let told = |options: BlockOptions| options.checked().map_err(|e| e.to_string());
        let sound = BlockOptions {
            window: Some([-1.0, 0.0, 5.0, 3.0]),
            exaggeration: Some(20.0),
            isolines: 50,
            at: Some(-2.0),
            ..BlockOptions::default()
        };
        assert_eq!(told(sound), Ok(()));
        let coloured = |range, percentiles, log| {
            told(BlockOptions { range, percentiles, log, ..sound }).unwrap_err()
        };
        for (text, words) in [
            (coloured(Some([1.0, 0.0]), None, false), "range cannot be 1 to 0"),
            (coloured(Some([0.0, f64::INFINITY]), None, false), "range"),
            (coloured(Some([0.0, 1.0]), None, true), "begins above 0"),
            (coloured(Some([0.0, 1.0]), Some([2.0, 98.0]), false), "either"),
            (coloured(None, Some([98.0, 2.0]), false), "percentiles cannot be 98 to 2"),
            (coloured(None, Some([f64::NAN, 2.0]), false), "percentiles"),
        ] {
            assert!(text.contains(words), "{text}");
        }
        for (window, exaggeration, isolines, at, option) in [
            (Some([5.0, 0.0, 0.0, 3.0]), None, 0, None, "window"),
            (Some([0.0, 3.0, 5.0, 3.0]), None, 0, None, "window"),
            (Some([0.0, 0.0, f64::NAN, 3.0]), None, 0, None, "window"),
            (None, Some(0.0), 0, None, "exaggerate"),
            (None, Some(f64::INFINITY), 0, None, "exaggerate"),
            (None, None, 51, None, "isolines"),
            (None, None, 0, Some(f64::NAN), "at"),
        ] {
            let options =
                BlockOptions { window, exaggeration, isolines, at, ..BlockOptions::default() };
            let text = told(options).unwrap_err();
            assert!(text.starts_with(option) && text.contains("give "), "{text}");
        }
    }
}
