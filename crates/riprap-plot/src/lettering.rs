//! Text as outlines, for pictures.
//!
//! One font and single lines of text need no shaping: glyphs one after the other by their advance widths. The renderer is built without
//! its own text stack, which took a tenth of a cold build of the whole program.

use std::fmt::Write as _;

use ttf_parser::{Face, GlyphId, OutlineBuilder};

use super::svg::Anchor;

/// The one font of PNG files, so that they look the same on a machine without fonts. Licence beside it.
const FONT: &[u8] = include_bytes!("../assets/DejaVuSans-subset.ttf");

/// The font that comes with riprap.
pub(super) struct Lettering {
    face: Face<'static>,
}

impl Lettering {
    /// Reads the font.
    ///
    /// # Errors
    /// A font that cannot be read: our fault, reported as text.
    pub(super) fn new() -> Result<Self, String> {
        let face = Face::parse(FONT, 0).map_err(|e| format!("the font: {e}"))?;
        Ok(Self { face })
    }

    /// Path data of a line of text whose base line begins, has its middle or ends at `at` (units of the page, y runs down).
    pub(super) fn outlines(&self, at: [f64; 2], size: f64, anchor: Anchor, text: &str) -> String {
        let scale = size / f64::from(self.face.units_per_em());
        // What the font lacks is its glyph 0, an empty box.
        let glyphs: Vec<GlyphId> =
            (text.chars()).map(|c| self.face.glyph_index(c).unwrap_or_default()).collect();
        let advance =
            |glyph: GlyphId| scale * f64::from(self.face.glyph_hor_advance(glyph).unwrap_or(0));
        let width: f64 = glyphs.iter().map(|&glyph| advance(glyph)).sum();
        let mut pen =
            Pen { at: [at[0] - anchor.share() * width, at[1]], scale, path: String::new() };
        for glyph in glyphs {
            // `None` for what has no outline: a space.
            let _ = self.face.outline_glyph(glyph, &mut pen);
            pen.at[0] += advance(glyph);
        }
        pen.path
    }
}

/// Writes outlines of glyphs (units of the font, y runs up) as path data (units of the page).
struct Pen {
    at: [f64; 2],
    scale: f64,
    path: String,
}

impl Pen {
    /// Writing into a `String` cannot fail, so the result is dropped in this one place.
    fn put(&mut self, letter: char, points: &[[f32; 2]]) {
        self.path.push(letter);
        for (k, [x, y]) in points.iter().enumerate() {
            let x = self.at[0] + self.scale * f64::from(*x);
            let y = self.at[1] - self.scale * f64::from(*y);
            let space = if k == 0 { "" } else { " " };
            let _ = write!(self.path, "{space}{x:.3} {y:.3}");
        }
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.put('M', &[[x, y]]);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.put('L', &[[x, y]]);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.put('Q', &[[x1, y1], [x, y]]);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.put('C', &[[x1, y1], [x2, y2], [x, y]]);
    }

    fn close(&mut self) {
        self.path.push('Z');
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::svg::text_width;

    #[test]
    fn widths_are_those_that_pages_are_laid_out_with() {
        let lettering = Lettering::new().unwrap();
        for text in ["0123456789", "shear displacement [mm]", "(a) E = 50 GPa"] {
            let width: f64 = text
                .chars()
                .map(|c| {
                    let glyph = lettering.face.glyph_index(c).expect("a letter of the font");
                    f64::from(lettering.face.glyph_hor_advance(glyph).unwrap())
                        / f64::from(lettering.face.units_per_em())
                })
                .sum();
            assert!((width - text_width(text, 1.0)).abs() < 1e-3 * width, "{text}");
        }
    }

    #[test]
    fn a_text_hangs_on_its_anchor() {
        let lettering = Lettering::new().unwrap();
        let first = |anchor| {
            let path = lettering.outlines([100.0, 10.0], 10.0, anchor, "HH");
            let x = path[1..].split(' ').next().unwrap();
            x.parse::<f64>().unwrap()
        };
        let (start, middle, end) =
            (first(Anchor::Start), first(Anchor::Middle), first(Anchor::End));
        let width = text_width("HH", 10.0);
        assert!((start - middle - 0.5 * width).abs() < 0.01, "{start} {middle}");
        assert!((start - end - width).abs() < 0.01, "{start} {end}");
    }
}
