//! A page of SVG, and its picture as PNG or PDF.
//!
//! Written by hand: outlines of blocks need filled polygons on equal axes with a colour bar, which the plotting
//! crates looked at (kuva 0.6, plotters 0.3) do not draw, and once axes are there a line chart is a page more. One hand gives
//! all plots one look, and bytes that change only when we change them.

use std::fmt::Write as _;

use resvg::{tiny_skia, usvg};

use super::lettering::Lettering;
use super::pdf::pdf;
use super::{Look, PlotError};

/// Pixels of an SVG in an inch.
const PIXELS: f64 = 96.0;
/// Length of an inch, m.
const INCH: f64 = 0.0254;

/// Advance widths of DejaVu Sans, characters 32 to 126, in thousandths of the size.
#[rustfmt::skip]
const WIDTHS: [u16; 95] = [
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361, 318, 337, 636, 636, 636, 636, 636, 636,
    636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632, 575, 775, 752, 295, 295, 656,
    557, 863, 748, 787, 603, 787, 695, 635, 611, 732, 684, 989, 685, 611, 685, 390, 337, 390, 838, 500, 500, 613,
    635, 550, 635, 615, 352, 635, 634, 278, 278, 579, 278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818,
    592, 592, 525, 636, 337, 636, 838,
];

/// Width of a text in units of the page.
pub(super) fn text_width(text: &str, size: f64) -> f64 {
    let sum: u32 = text
        .chars()
        .map(|c| match c {
            ' '..='~' => u32::from(WIDTHS[c as usize - 32]),
            '\u{b2}' | '\u{b3}' | '\u{b9}' | '\u{2070}'..='\u{209c}' => 401,
            _ => 700,
        })
        .sum();
    f64::from(sum) * size / 1000.0
}

/// Cuts a text so that it fits, with an ellipsis.
pub(super) fn fitted(text: &str, size: f64, width: f64) -> String {
    if text_width(text, size) <= width {
        return text.to_owned();
    }
    let mut out: String = text.to_owned();
    while !out.is_empty() && text_width(&out, size) + size > width {
        out.pop();
    }
    out.push('\u{2026}');
    out
}

/// Which point of a text is anchored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

impl Anchor {
    /// Share of its width by which a text begins before its point.
    pub(super) fn share(self) -> f64 {
        match self {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5,
            Anchor::End => 1.0,
        }
    }
}

/// A page; y runs down.
#[derive(Debug)]
pub(super) struct Page {
    pub(super) width: f64,
    pub(super) height: f64,
    /// Texts, each with the markup before it.
    lines: Vec<(String, Text)>,
    /// Markup after the last text.
    tail: String,
    /// Which of the texts is the title, with the room for it.
    titled: Option<(usize, f64)>,
}

/// A line of text: an SVG has it as text, a picture as outlines.
#[derive(Debug, Clone)]
struct Text {
    at: [f64; 2],
    /// Whether it reads upwards.
    upright: bool,
    size: f64,
    anchor: Anchor,
    text: String,
}

impl Text {
    fn markup(&self) -> String {
        let [x, y] = self.at;
        let anchor = match self.anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let place = if self.upright {
            format!("transform=\"translate({x:.2},{y:.2}) rotate(-90)\"")
        } else {
            format!("x=\"{x:.2}\" y=\"{y:.2}\"")
        };
        format!(
            "<text {place} font-size=\"{}\" text-anchor=\"{anchor}\">{}</text>\n",
            self.size,
            riprap_record::vtu::escape(&self.text)
        )
    }

    fn outlines(&self, lettering: &Lettering) -> String {
        let [x, y] = self.at;
        let path = lettering.outlines([0.0; 2], self.size, self.anchor, &self.text);
        let turn = if self.upright { " rotate(-90)" } else { "" };
        format!("<path transform=\"translate({x:.2},{y:.2}){turn}\" d=\"{path}\"/>\n")
    }
}

/// Writing into a `String` cannot fail, so the result is dropped in this one place.
macro_rules! put {
    ($page:expr, $($arg:tt)*) => { let _ = writeln!($page.tail, $($arg)*); };
}

impl Page {
    pub(super) fn new(width: f64, height: f64) -> Self {
        Page { width, height, lines: Vec::new(), tail: String::new(), titled: None }
    }

    pub(super) fn rect(&mut self, x: f64, y: f64, w: f64, h: f64, style: &str) {
        put!(self, "<rect x=\"{x:.2}\" y=\"{y:.2}\" width=\"{w:.2}\" height=\"{h:.2}\" {style}/>");
    }

    pub(super) fn line(&mut self, a: [f64; 2], b: [f64; 2], style: &str) {
        put!(
            self,
            "<line x1=\"{:.2}\" y1=\"{:.2}\" x2=\"{:.2}\" y2=\"{:.2}\" {style}/>",
            a[0],
            a[1],
            b[0],
            b[1]
        );
    }

    pub(super) fn circle(&mut self, c: [f64; 2], r: f64, style: &str) {
        put!(self, "<circle cx=\"{:.2}\" cy=\"{:.2}\" r=\"{r:.2}\" {style}/>", c[0], c[1]);
    }

    pub(super) fn polyline(&mut self, points: &[[f64; 2]], style: &str) {
        self.points("polyline", points, style);
    }

    pub(super) fn polygon(&mut self, points: &[[f64; 2]], style: &str) {
        self.points("polygon", points, style);
    }

    /// Closed lines filled together: what lies inside two of them is a hole.
    pub(super) fn rings(&mut self, rings: &[Vec<[f64; 2]>], style: &str) {
        if let [one] = rings {
            return self.polygon(one, style);
        }
        let mut path = String::new();
        for ring in rings {
            for (k, p) in ring.iter().enumerate() {
                let _ = write!(path, "{}{:.2},{:.2} ", if k == 0 { "M" } else { "L" }, p[0], p[1]);
            }
            path.push_str("Z ");
        }
        put!(self, "<path d=\"{}\" fill-rule=\"evenodd\" {style}/>", path.trim_end());
    }

    fn points(&mut self, tag: &str, points: &[[f64; 2]], style: &str) {
        let mut list = String::new();
        for p in points {
            let _ = write!(list, "{:.2},{:.2} ", p[0], p[1]);
        }
        put!(self, "<{tag} points=\"{}\" {style}/>", list.trim_end());
    }

    /// Straight pieces of lines as one path.
    pub(super) fn pieces(&mut self, pieces: &[[[f64; 2]; 2]], style: &str) {
        if pieces.is_empty() {
            return;
        }
        let mut path = String::new();
        for [a, b] in pieces {
            let _ = write!(path, "M{:.2} {:.2}L{:.2} {:.2}", a[0], a[1], b[0], b[1]);
        }
        put!(self, "<path d=\"{path}\" {style}/>");
    }

    pub(super) fn text(&mut self, at: [f64; 2], size: f64, anchor: Anchor, text: &str) {
        self.write(at, false, size, anchor, text);
    }

    /// A title with a suffix; a long one loses its end, never the suffix, so that `margin` remains on the right.
    pub(super) fn title(&mut self, at: [f64; 2], margin: f64, title: &str, suffix: &str) {
        let room = self.width - at[0] - margin - text_width(suffix, 15.0);
        let title = format!("{}{suffix}", fitted(title, 15.0, room));
        self.titled = Some((self.lines.len(), self.width - at[0] - margin));
        self.text(at, 15.0, Anchor::Start, &title);
    }

    /// Text that reads upwards, centred on its point.
    pub(super) fn upright(&mut self, at: [f64; 2], size: f64, text: &str) {
        self.write(at, true, size, Anchor::Middle, text);
    }

    fn write(&mut self, at: [f64; 2], upright: bool, size: f64, anchor: Anchor, text: &str) {
        let before = std::mem::take(&mut self.tail);
        let text = Text { at, upright, size, anchor, text: text.to_owned() };
        self.lines.push((before, text));
    }

    /// Everything until [`Page::end_clip`] is cut at this rectangle.
    pub(super) fn begin_clip(&mut self, id: &str, x: f64, y: f64, w: f64, h: f64) {
        put!(
            self,
            "<clipPath id=\"{id}\"><rect x=\"{x:.2}\" y=\"{y:.2}\" width=\"{w:.2}\" height=\"{h:.2}\"/></clipPath>\n\
             <g clip-path=\"url(#{id})\">"
        );
    }

    pub(super) fn end_clip(&mut self) {
        put!(self, "</g>");
    }

    /// The file.
    pub(super) fn svg(&self, look: &Look) -> String {
        self.written(look, Text::markup)
    }

    fn written(&self, look: &Look, text: impl Fn(&Text) -> String) -> String {
        let mut body = String::new();
        for (k, (before, line)) in self.lines.iter().enumerate() {
            body.push_str(before);
            match (&look.title, self.titled) {
                (Some(title), Some((place, room))) if place == k => {
                    let title = fitted(title, line.size, room);
                    body.push_str(&text(&Text { text: title, ..line.clone() }));
                }
                _ => body.push_str(&text(line)),
            }
        }
        body.push_str(&self.tail);
        let (w, h) = (self.width.round(), self.height.round());
        let [wide, high] = match look.width {
            Some(width) => [width, width * h / w].map(|length| format!("{:.3}mm", 1e3 * length)),
            None => [w, h].map(|length| length.to_string()),
        };
        let own =
            look.font.as_ref().map(|font| format!("'{}', ", riprap_record::vtu::escape(font)));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{wide}\" height=\"{high}\" viewBox=\"0 0 {w} {h}\" \
             font-family=\"{}'DejaVu Sans', Verdana, Arial, sans-serif\" fill=\"#1a1a1a\">\n\
             <rect width=\"{w}\" height=\"{h}\" fill=\"#ffffff\"/>\n{body}</svg>\n",
            own.unwrap_or_default(),
        )
    }

    /// The page with texts as outlines of the font that comes with riprap, in pixels of the SVG.
    fn tree(&self, look: &Look) -> Result<usvg::Tree, PlotError> {
        let failed = |reason: String| PlotError::Render { reason };
        let lettering = Lettering::new().map_err(failed)?;
        // Sizes on paper are for the renderer, not for the picture.
        let plain = Look { width: None, ..look.clone() };
        let svg = self.written(&plain, |text| text.outlines(&lettering));
        usvg::Tree::from_str(&svg, &usvg::Options::default()).map_err(|e| failed(e.to_string()))
    }

    /// Width on paper, inches.
    fn inches(&self, look: &Look) -> f64 {
        look.width.map_or(self.width.round() / PIXELS, |width| width / INCH)
    }

    /// The page as PNG.
    ///
    /// # Errors
    /// A page that resvg refuses, or one too large for memory.
    pub(super) fn png(&self, look: &Look) -> Result<Vec<u8>, PlotError> {
        let failed = |reason: String| PlotError::Render { reason };
        let tree = self.tree(look)?;
        let size = tree.size();
        let wanted = self.inches(look) * look.dpi.unwrap_or(2.0 * PIXELS);
        let zoom = wanted as f32 / size.width();
        let (w, h) = (size.width() * zoom, size.height() * zoom);
        let mut pixels = tiny_skia::Pixmap::new(w.ceil() as u32, h.ceil() as u32)
            .ok_or_else(|| failed(format!("a picture of {w} x {h} pixels is too large")))?;
        let scaled = tiny_skia::Transform::from_scale(zoom, zoom);
        resvg::render(&tree, scaled, &mut pixels.as_mut());
        pixels.encode_png().map_err(|e| failed(e.to_string()))
    }

    /// The page as PDF.
    ///
    /// # Errors
    /// A page that resvg refuses: our fault, reported as text.
    pub(super) fn pdf(&self, look: &Look) -> Result<Vec<u8>, PlotError> {
        let own = self.titled.and_then(|(place, _)| self.lines.get(place)).map(|(_, t)| &t.text);
        let title = look.title.as_ref().or(own).map_or("", String::as_str);
        Ok(pdf(&self.tree(look)?, (72.0 * self.inches(look)) as f32, title))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_is_drawn_without_system_fonts() {
        let dark = |text: &str| {
            let mut page = Page::new(200.0, 40.0);
            page.text([10.0, 25.0], 14.0, Anchor::Start, text);
            let bytes = page.png(&Look::default()).unwrap();
            let map = resvg::tiny_skia::Pixmap::decode_png(&bytes).unwrap();
            map.pixels().iter().filter(|p| p.red() < 128).count()
        };
        assert_eq!(dark(""), 0);
        assert!(dark("slip [m] <&> 10⁻³ φ °") > 300);
    }

    #[test]
    fn a_look_changes_title_and_size_alone() {
        let mut page = Page::new(192.0, 96.0);
        page.title([10.0, 26.0], 10.0, "own", "");
        page.rect(10.0, 40.0, 50.0, 20.0, "fill=\"#ff0000\" fill-opacity=\"0.5\"");
        let look = Look {
            title: Some("other".to_owned()),
            width: Some(0.0508),
            dpi: Some(300.0),
            font: Some("Arial".to_owned()),
        };
        let svg = page.svg(&look);
        assert!(svg.contains(">other<") && !svg.contains(">own<"), "{svg}");
        assert!(
            svg.contains("width=\"50.800mm\"") && svg.contains("'Arial', 'DejaVu Sans'"),
            "{svg}"
        );
        let sizes = [look.clone(), Look::default()].map(|look| {
            let map = tiny_skia::Pixmap::decode_png(&page.png(&look).unwrap()).unwrap();
            [map.width(), map.height()]
        });
        assert_eq!(sizes, [[600, 300], [384, 192]]);
        let sheet = String::from_utf8(page.pdf(&look).unwrap()).unwrap();
        assert!(sheet.starts_with("%PDF-1.4") && sheet.ends_with("%%EOF\n"));
        // Two inches, a red area of which half shows, letters as curves.
        for part in ["/MediaBox [0 0 144.000 72.000]", "1.000 0.000 0.000 rg", "/ca 0.500", " c\n"]
        {
            assert!(sheet.contains(part), "{part}: {sheet}");
        }
        let table: usize =
            sheet.rsplit("startxref\n").next().unwrap().lines().next().unwrap().parse().unwrap();
        assert!(sheet[table..].starts_with("xref\n0 6\n"));
    }

    #[test]
    fn widths() {
        assert!((text_width("0123456789", 10.0) - 63.6).abs() < 0.1);
        let cut = fitted("a very long title that does not fit at all", 12.0, 100.0);
        assert!(cut.ends_with('\u{2026}') && text_width(&cut, 12.0) <= 105.0);
        assert_eq!(fitted("short", 12.0, 100.0), "short");
    }
}
