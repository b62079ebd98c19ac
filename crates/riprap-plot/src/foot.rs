//! Lines below a picture, broken where they would leave it.

use super::svg::{Anchor, Page, fitted, text_width};

/// Size of the letters, and from line to line.
const SIZE: f64 = 11.0;
const STEP: f64 = 15.0;
/// Side of a square of colour, and from its left edge to its text.
const CHIP: f64 = 9.0;
const BESIDE: f64 = 13.0;
/// Between two pieces of a paragraph.
const GAP: f64 = 10.0;

/// Text with a square of colour before it, where it has one.
pub(super) struct Piece {
    pub(super) colour: Option<&'static str>,
    pub(super) text: String,
}

impl Piece {
    pub(super) fn plain(text: impl Into<String>) -> Self {
        Self { colour: None, text: text.into() }
    }
}

/// A stretch of text on one line.
struct Run {
    x: f64,
    line: usize,
    colour: Option<&'static str>,
    text: String,
}

/// Paragraphs as they are laid out.
pub(super) struct Foot {
    runs: Vec<Run>,
    lines: usize,
}

impl Foot {
    /// Lays paragraphs out in a width.
    pub(super) fn of(paragraphs: &[Vec<Piece>], room: f64) -> Self {
        let mut foot = Self { runs: Vec::new(), lines: 0 };
        for paragraph in paragraphs.iter().filter(|pieces| !pieces.is_empty()) {
            let mut x = 0.0;
            foot.lines += 1;
            for piece in paragraph {
                x = foot.put(piece, x, room) + GAP;
            }
        }
        foot
    }

    /// Lays a piece out from `x` on the last line; where it ends.
    fn put(&mut self, piece: &Piece, x: f64, room: f64) -> f64 {
        let mut begin = x;
        let mut end = x;
        let mut open = false;
        for word in piece.text.split(' ') {
            let chip = if open || piece.colour.is_none() { 0.0 } else { BESIDE };
            let space = if open { text_width(" ", SIZE) } else { 0.0 };
            let long = text_width(word, SIZE);
            if end > 0.0 && end + space + chip + long > room {
                self.lines += 1;
                (begin, end) = (0.0, 0.0);
            }
            let line = self.lines - 1;
            let goes_on = open && end > 0.0;
            match self.runs.last_mut().filter(|_| goes_on) {
                Some(run) => {
                    run.text.push(' ');
                    run.text.push_str(word);
                    end = begin + text_width(&run.text, SIZE);
                }
                None => {
                    let colour = piece.colour.filter(|_| !open);
                    begin += chip;
                    let text = fitted(word, SIZE, room - begin);
                    end = begin + text_width(&text, SIZE);
                    self.runs.push(Run { x: begin, line, colour, text });
                }
            }
            open = true;
        }
        end
    }

    pub(super) fn height(&self) -> f64 {
        STEP * self.lines as f64
    }

    /// Draws the lines; `at`: the base of the first.
    pub(super) fn draw(&self, page: &mut Page, [x, y]: [f64; 2]) {
        for run in &self.runs {
            let base = y + STEP * run.line as f64;
            if let Some(colour) = run.colour {
                let style = format!("fill=\"{colour}\"");
                page.rect(x + run.x - BESIDE, base - CHIP + 0.5, CHIP, CHIP, &style);
            }
            page.text([x + run.x, base], SIZE, Anchor::Start, &run.text);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_break_between_words_and_stay_inside() {
        let text = "contact forces: tubes as thick and dark as they are, up to 4.00 kN";
        let chips = ["sliding 12", "broken and open 3", "open 4"];
        let chips = chips.map(|text| Piece { colour: Some("#f0a020"), text: text.to_owned() });
        let paragraphs = [vec![Piece::plain(text)], chips.into_iter().collect()];
        for room in [60.0, 130.0, 196.0, 1000.0] {
            let foot = Foot::of(&paragraphs, room);
            for run in &foot.runs {
                let end = run.x + text_width(&run.text, SIZE);
                assert!(end <= room, "{}: {end} > {room}", run.text);
            }
            let words: Vec<&str> = foot.runs.iter().map(|run| run.text.as_str()).collect();
            let all = format!("{text} sliding 12 broken and open 3 open 4");
            assert_eq!(words.join(" "), all, "{room}");
            assert_eq!(foot.runs.iter().filter(|run| run.colour.is_some()).count(), 3);
        }
        assert_eq!(Foot::of(&paragraphs, 1000.0).lines, 2);
        assert!(Foot::of(&paragraphs, 196.0).lines > 3);
        // A word that is longer than the room is cut.
        let foot = Foot::of(&[vec![Piece::plain("Donaudampfschifffahrt")]], 60.0);
        assert!(foot.runs[0].text.ends_with('\u{2026}'));
    }
}
