//! A page as PDF 1.4: the outlines of its picture, texts included, on one sheet. By hand: a page of filled and stroked paths needs
//! a hundred lines, and a crate for any SVG would bring images, fonts and their compression.

use std::fmt::Write as _;

use resvg::tiny_skia::{Path, PathSegment, Point, Transform};
use resvg::usvg::{self, Group, Node, Paint};

/// The sheet of a picture, `wide` points (1/72 inch) wide.
pub(super) fn pdf(tree: &usvg::Tree, wide: f32, title: &str) -> Vec<u8> {
    let size = tree.size();
    let zoom = wide / size.width();
    let high = zoom * size.height();
    let mut sheet = Sheet { content: String::new(), states: Vec::new() };
    // y runs up in a PDF.
    sheet.say(format_args!("{zoom:.6} 0 0 {:.6} 0 {high:.3} cm", -zoom));
    sheet.group(tree.root());
    let states: String =
        (0..).zip(&sheet.states).fold(String::new(), |mut all, (k, [fill, line])| {
            let _ = write!(all, "/G{k} << /ca {fill:.3} /CA {line:.3} >> ");
            all
        });
    // Any text: UTF-16 in hexadecimal digits.
    let title: String = title.encode_utf16().fold("FEFF".to_owned(), |mut all, unit| {
        let _ = write!(all, "{unit:04X}");
        all
    });
    let content = sheet.content;
    let objects = [
        "<< /Type /Catalog /Pages 2 0 R >>".to_owned(),
        "<< /Type /Pages /Kids [3 0 R] /Count 1 >>".to_owned(),
        format!(
            "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {wide:.3} {high:.3}] /Contents 4 0 R /Resources << /ExtGState << {states}>> >> >>"
        ),
        format!("<< /Length {} >>\nstream\n{content}\nendstream", content.len()),
        format!("<< /Title <{title}> /Producer (riprap) >>"),
    ];
    let mut file = "%PDF-1.4\n".to_owned();
    let mut places = Vec::new();
    for (number, object) in (1..).zip(&objects) {
        places.push(file.len());
        let _ = write!(file, "{number} 0 obj\n{object}\nendobj\n");
    }
    let table = file.len();
    let _ = write!(file, "xref\n0 {}\n0000000000 65535 f \n", objects.len() + 1);
    for place in places {
        let _ = writeln!(file, "{place:010} 00000 n ");
    }
    let _ = write!(
        file,
        "trailer\n<< /Size {} /Root 1 0 R /Info 5 0 R >>\nstartxref\n{table}\n%%EOF\n",
        objects.len() + 1
    );
    file.into_bytes()
}

struct Sheet {
    content: String,
    /// Opacities of areas and lines.
    states: Vec<[f32; 2]>,
}

impl Sheet {
    fn say(&mut self, line: std::fmt::Arguments<'_>) {
        let _ = writeln!(self.content, "{line}");
    }

    fn group(&mut self, group: &Group) {
        self.say(format_args!("q"));
        if let Some(clip) = group.clip_path() {
            for node in clip.root().children() {
                if let Node::Path(path) = node {
                    self.outline(path.data(), path.abs_transform());
                }
            }
            self.say(format_args!("W n"));
        }
        for node in group.children() {
            match node {
                Node::Group(group) => self.group(group),
                Node::Path(path) => self.path(path),
                // Pages have none: texts are outlines.
                Node::Image(_) | Node::Text(_) => {}
            }
        }
        self.say(format_args!("Q"));
    }

    fn path(&mut self, path: &usvg::Path) {
        if let Some(fill) = path.fill() {
            self.opacity(fill.opacity().get(), 1.0);
            self.colour(fill.paint(), "rg");
            self.outline(path.data(), path.abs_transform());
            match fill.rule() {
                usvg::FillRule::NonZero => self.say(format_args!("f")),
                usvg::FillRule::EvenOdd => self.say(format_args!("f*")),
            }
        }
        let Some(line) = path.stroke() else { return };
        self.opacity(1.0, line.opacity().get());
        self.colour(line.paint(), "RG");
        let cap = match line.linecap() {
            usvg::LineCap::Butt => 0,
            usvg::LineCap::Round => 1,
            usvg::LineCap::Square => 2,
        };
        let join = match line.linejoin() {
            usvg::LineJoin::Miter | usvg::LineJoin::MiterClip => 0,
            usvg::LineJoin::Round => 1,
            usvg::LineJoin::Bevel => 2,
        };
        let dash = line.dasharray().unwrap_or_default().iter();
        let dash: Vec<String> = dash.map(|length| format!("{length:.3}")).collect();
        self.say(format_args!(
            "{:.3} w {cap} J {join} j [{}] 0 d",
            line.width().get(),
            dash.join(" ")
        ));
        self.outline(path.data(), path.abs_transform());
        self.say(format_args!("S"));
    }

    fn colour(&mut self, paint: &Paint, operator: &str) {
        // Pages have plain colours only.
        let Paint::Color(colour) = paint else { return };
        let [r, g, b] = [colour.red, colour.green, colour.blue].map(|part| f32::from(part) / 255.0);
        self.say(format_args!("{r:.3} {g:.3} {b:.3} {operator}"));
    }

    fn opacity(&mut self, fill: f32, line: f32) {
        let wanted = [fill, line];
        let known = self.states.iter().position(|state| *state == wanted);
        let number = known.unwrap_or_else(|| {
            self.states.push(wanted);
            self.states.len() - 1
        });
        self.say(format_args!("/G{number} gs"));
    }

    fn outline(&mut self, path: &Path, transform: Transform) {
        let place = |mut point: Point| {
            transform.map_point(&mut point);
            point
        };
        let mut last = Point::zero();
        for segment in path.segments() {
            match segment {
                PathSegment::MoveTo(p) => {
                    last = place(p);
                    self.say(format_args!("{:.3} {:.3} m", last.x, last.y));
                }
                PathSegment::LineTo(p) => {
                    last = place(p);
                    self.say(format_args!("{:.3} {:.3} l", last.x, last.y));
                }
                PathSegment::QuadTo(a, p) => {
                    // The cubic curve that is the same.
                    let (a, end) = (place(a), place(p));
                    let near = |end: Point| {
                        [end.x + 2.0 * (a.x - end.x) / 3.0, end.y + 2.0 * (a.y - end.y) / 3.0]
                    };
                    self.curve(near(last), near(end), [end.x, end.y]);
                    last = end;
                }
                PathSegment::CubicTo(a, b, p) => {
                    let [a, b, end] = [a, b, p].map(place);
                    self.curve([a.x, a.y], [b.x, b.y], [end.x, end.y]);
                    last = end;
                }
                PathSegment::Close => self.say(format_args!("h")),
            }
        }
    }

    fn curve(&mut self, a: [f32; 2], b: [f32; 2], end: [f32; 2]) {
        let [[ax, ay], [bx, by], [x, y]] = [a, b, end];
        self.say(format_args!("{ax:.3} {ay:.3} {bx:.3} {by:.3} {x:.3} {y:.3} c"));
    }
}
