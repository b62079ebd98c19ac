//! Block outlines coloured by a field, on equal axes, one frame or several.

use super::arrows;
use super::bolts;
use super::colour::{self, ColourMap};
use super::crosses;
use super::drawing::{BlockOptions, Chosen, Vectors};
use super::foot::{Foot, Piece};
use super::isolines;
use super::svg::{Anchor, Page, fitted, text_width};
use super::ticks::{Scale, label};
use super::{PlotError, digits};
use riprap_record::field::Part;
use riprap_record::frame::{Column, Frame};

const SIZE: f64 = 12.0;
const LEFT: f64 = 70.0;
const TOP: f64 = 44.0;
const BAR: f64 = 16.0;

/// What a picture is made of besides the frames.
pub(super) struct Words<'a> {
    /// Title, which may be shortened.
    pub(super) title: &'a str,
    /// Its end, which stays.
    pub(super) suffix: &'a str,
    /// When each frame is, in words.
    pub(super) moments: &'a [String],
    /// Names of the axes.
    pub(super) axes: [&'static str; 2],
    /// Names of the kinds that values count, where they are kinds and not amounts.
    pub(super) kinds: Option<&'a [String]>,
    /// Places of sources in the picture, m.
    pub(super) sources: Vec<[f64; 2]>,
}

/// What the colours cover: a range that was asked for, else that of the values or of their percentiles.
pub(super) fn colours(values: &[f64], options: BlockOptions) -> (ColourMap, Scale) {
    if let Some([low, high]) = options.range {
        let signed = low < 0.0 && high > 0.0;
        let map = if signed { ColourMap::BlueRed } else { ColourMap::Light };
        return (map, Scale { low, high, log: options.log });
    }
    match options.percentiles {
        Some(shares) => suited(&within(values, shares), options.log),
        None => suited(values, options.log),
    }
}

/// The finite values between two percentiles, both included; all of them where none lies between.
fn within(values: &[f64], shares: [f64; 2]) -> Vec<f64> {
    let mut sorted: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len().saturating_sub(1);
    let [from, to] = shares.map(|share| 0.01 * share * last as f64);
    let (from, to) = (from.floor() as usize, to.ceil() as usize);
    sorted.get(from..=to.min(last)).map_or_else(Vec::new, <[f64]>::to_vec)
}

/// Map and range that suit the values: signed ones symmetric about zero, amounts from zero if they come near it.
fn suited(values: &[f64], log: bool) -> (ColourMap, Scale) {
    if log {
        return (ColourMap::Light, Scale::log_covering(values.iter().copied()));
    }
    let s = Scale::exact(values.iter().copied());
    let all_zero = values.iter().all(|v| *v == 0.0 || v.is_nan());
    if all_zero {
        (ColourMap::Light, Scale { low: 0.0, high: 1.0, log: false })
    } else if s.low < 0.0 && s.high > 0.0 {
        let size = s.high.max(-s.low);
        (ColourMap::BlueRed, Scale { low: -size, high: size, log: false })
    } else if s.low > 0.0 && s.low < 0.3 * s.high {
        (ColourMap::Light, Scale { low: 0.0, ..s })
    } else if s.high < 0.0 && s.high > 0.3 * s.low {
        (ColourMap::Light, Scale { high: 0.0, ..s })
    } else {
        (ColourMap::Light, s)
    }
}

/// Model window common to all panels, and pixels per metre.
struct Window {
    low: [f64; 2],
    size: [f64; 2],
    zoom: f64,
}

impl Window {
    fn around(frames: &[Frame], columns: usize, arrows: bool, given: Option<[f64; 4]>) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for p in
            frames.iter().flat_map(|f| &f.points).filter(|p| p[0].is_finite() && p[1].is_finite())
        {
            for k in 0..2 {
                low[k] = low[k].min(p[k]);
                high[k] = high[k].max(p[k]);
            }
        }
        if low[0] > high[0] {
            (low, high) = ([0.0; 2], [1.0; 2]);
        }
        if let Some([left, bottom, right, top]) = given {
            (low, high) = ([left, bottom], [right, top]);
        }
        let largest = (high[0] - low[0]).max(high[1] - low[1]).max(1e-9 * low[0].abs().max(1e-6));
        // Arrows of blocks at the rim reach beyond it.
        let margin = match (given, arrows) {
            (Some(_), _) => 0.0,
            (None, true) => 0.08 * largest,
            (None, false) => 0.03 * largest,
        };
        let size = [0, 1].map(|k| high[k] - low[k] + 2.0 * margin);
        let wide = if columns == 1 { 720.0 } else { 1100.0 / columns as f64 };
        let high_limit = if frames.len() == 1 { 560.0 } else { 420.0 };
        let zoom = (wide / size[0]).min(high_limit / size[1]);
        Window { low: [low[0] - margin, low[1] - margin], size, zoom }
    }

    fn pixel(&self, p: [f64; 2], corner: [f64; 2]) -> [f64; 2] {
        [
            corner[0] + (p[0] - self.low[0]) * self.zoom,
            corner[1] + (self.low[1] + self.size[1] - p[1]) * self.zoom,
        ]
    }
}

/// Panels side by side: wide scenes are stacked, tall ones stand beside each other.
fn columns_for(frames: &[Frame], given: Option<[f64; 4]>) -> usize {
    let one = Window::around(frames, 1, false, given);
    let aspect = one.size[0] / one.size[1];
    let columns =
        ((1.6 * frames.len() as f64 / aspect).sqrt().ceil() as usize).clamp(1, frames.len());
    frames.len().div_ceil(frames.len().div_ceil(columns))
}

/// Where the panels are on the page.
struct Panels {
    window: Window,
    columns: usize,
    /// Of one panel.
    size: [f64; 2],
    /// From one panel to the next.
    step: [f64; 2],
    /// Top of the first row.
    head: f64,
    /// Right edge of the last column.
    right: f64,
    /// From the top of the first row to the foot of the last.
    height: f64,
}

impl Panels {
    fn of(frames: &[Frame], options: BlockOptions) -> Self {
        let columns = columns_for(frames, options.window);
        let rows = frames.len().div_ceil(columns);
        let window = Window::around(frames, columns, options.vectors.is_some(), options.window);
        let size = window.size.map(|x| x * window.zoom);
        let step = [size[0] + LEFT + 10.0, size[1] + 72.0];
        let head = if frames.len() > 1 { TOP + 24.0 } else { TOP };
        let right = LEFT + step[0] * (columns - 1) as f64 + size[0];
        let height = step[1] * (rows - 1) as f64 + size[1];
        Self { window, columns, size, step, head, right, height }
    }
}

/// Draws the frames with one colour bar for all.
pub(super) fn draw(
    words: &Words,
    frames: &[Frame],
    fields: &[Chosen],
    options: BlockOptions,
) -> Result<Page, PlotError> {
    let Some(first) = fields.first() else {
        return Err(PlotError::NothingToDraw { what: "no frames were selected".to_owned() });
    };
    refuse(words, frames, options)?;
    let all: Vec<f64> = fields.iter().flat_map(|f| f.values.iter().copied()).collect();
    let (map, scale) = colours(&all, options);
    let Panels { window, columns, size: [w, h], step, head, right, height } =
        Panels::of(frames, options);
    let bar_height = height.max(140.0);
    let mut note = notes(frames, options);
    if let (None, Some(beyond)) = (words.kinds, beyond(&all, &scale, options)) {
        let joint = if note.is_empty() { "" } else { "; " };
        note = format!("{note}{joint}{beyond}");
    }
    let wide = (right + 110.0).max(360.0);
    let paragraph = if note.is_empty() { Vec::new() } else { vec![Piece::plain(note)] };
    let foot = Foot::of(&[paragraph], wide - LEFT - 10.0);
    let below = (foot.height() - 5.0).max(0.0);
    let mut page = Page::new(wide, head + bar_height + 58.0 + below);
    page.title([LEFT, 26.0], 10.0, words.title, words.suffix);
    let most = Most {
        bolts: bolts::most(frames),
        arrow: arrows::longest(frames, options.vectors),
        cross: crosses::longest(frames),
    };
    for (i, (frame, field)) in frames.iter().zip(fields).enumerate() {
        let corner = [LEFT + step[0] * (i % columns) as f64, head + step[1] * (i / columns) as f64];
        if frames.len() > 1 {
            let text = fitted(words.moments.get(i).map_or("", |text| text), SIZE, w + 20.0);
            page.text([corner[0] + w / 2.0, corner[1] - 8.0], SIZE, Anchor::Middle, &text);
        }
        axes(&mut page, &window, corner, words.axes);
        page.begin_clip(&format!("frame{i}"), corner[0], corner[1], w, h);
        let paint = |v: f64| match words.kinds {
            Some(_) => colour::material(v).to_owned(),
            None => map.at(scale.share(v)),
        };
        outlines(&mut page, frame, field, &paint, &window, corner);
        if options.isolines > 0 {
            let pixel = |p| window.pixel(p, corner);
            let lines = (&scale, options.isolines);
            isolines::draw(&mut page, frame, &field.values, lines, &pixel);
        }
        marks(&mut page, frame, options, &most, &window, corner);
        for place in &words.sources {
            star(&mut page, window.pixel(*place, corner));
        }
        page.end_clip();
        page.rect(corner[0], corner[1], w, h, "fill=\"none\" stroke=\"#1a1a1a\"");
    }
    foot.draw(&mut page, [LEFT, head + bar_height + 58.0]);
    let at = [right + 18.0, head];
    match words.kinds {
        Some(names) => chips(&mut page, names, &all, at),
        None => bar(&mut page, (map, &scale), first, at, bar_height),
    }
    Ok(page)
}

/// Largest values of all frames, which the sizes of marks are relative to.
struct Most {
    bolts: f64,
    arrow: f64,
    cross: f64,
}

/// Cracks, bolts, forces, arrows and crosses over the blocks, as chosen.
fn marks(
    page: &mut Page,
    frame: &Frame,
    options: BlockOptions,
    most: &Most,
    window: &Window,
    corner: [f64; 2],
) {
    let pixel = |p| window.pixel(p, corner);
    let size = window.size.map(|x| x * window.zoom);
    if options.cracks {
        cracks(page, frame, window, corner);
    }
    bolts::draw(page, frame, most.bolts, &pixel);
    if options.contacts {
        contacts(page, frame, window, corner);
    }
    if let Some(vectors) = options.vectors {
        arrows::draw(page, frame, vectors, most.arrow, &pixel, size);
    }
    if options.stress {
        crosses::draw(page, frame, most.cross, &pixel, size);
    }
}

/// Refuses marks that these frames, or this field, do not have.
fn refuse(words: &Words, frames: &[Frame], options: BlockOptions) -> Result<(), PlotError> {
    let flows = options.vectors == Some(Vectors::Flow);
    if flows && !frames.iter().any(|f| arrows::column(f, Vectors::Flow).is_some()) {
        let what =
            "these frames have no seepage through joints; give `water.*.seepage` in the scene";
        return Err(PlotError::NothingToDraw { what: what.to_owned() });
    }
    if options.isolines > 0 && words.kinds.is_some() {
        let reason = "materials are categories, not quantities; choose another field or leave the isolines out";
        return Err(PlotError::Unsuitable { picture: "isolines", reason: reason.to_owned() });
    }
    Ok(())
}

/// What the colours leave out, where they do not cover all values.
fn beyond(values: &[f64], scale: &Scale, options: BlockOptions) -> Option<String> {
    options.range.map(|_| ()).or(options.percentiles.map(|_| ()))?;
    let outside = values.iter().filter(|v| **v < scale.low || **v > scale.high).count();
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let words = || {
        let [low, high] = [low, high].map(|v| digits(v, 3));
        format!("{outside} values beyond the colours: {low} to {high}")
    };
    (outside > 0).then(words)
}

/// What stands below the picture.
fn notes(frames: &[Frame], options: BlockOptions) -> String {
    let mut out: Vec<String> = bolts::note(frames).into_iter().collect();
    if options.contacts {
        out.push(contact_note(frames));
    }
    if let Some(vectors) = options.vectors {
        let longest = arrows::longest(frames, Some(vectors));
        let mut columns = frames.iter().filter_map(|f| arrows::column(f, vectors));
        let (name, unit) = (vectors.column(), columns.next().map_or("", |c| &c.unit));
        let also = match arrows::beyond(frames, vectors, longest) {
            0 => String::new(),
            more => format!(" or more ({more})"),
        };
        out.push(format!("longest arrow: {name} {} {unit}{also}", digits(longest, 3)));
    }
    if options.stress {
        out.push(crosses::note(frames));
    }
    if options.cracks {
        let count: usize = frames.iter().map(|f| traces(f).len()).sum();
        out.push(format!("red: {count} broken faces in the cut"));
    }
    out.join("; ")
}

/// Where a charge lies.
fn star(page: &mut Page, [x, y]: [f64; 2]) {
    for (colour, width) in [("#ffffff", 4.0), ("#d00060", 1.8)] {
        let style =
            format!("stroke=\"{colour}\" stroke-width=\"{width}\" stroke-linecap=\"round\"");
        for [dx, dy] in [[6.0, 0.0], [0.0, 6.0], [4.2, 4.2], [4.2, -4.2]] {
            page.line([x - dx, y - dy], [x + dx, y + dy], &style);
        }
    }
}

fn axes(page: &mut Page, window: &Window, corner: [f64; 2], names: [&str; 2]) {
    let (w, h) = (window.size[0] * window.zoom, window.size[1] * window.zoom);
    let scale =
        |k: usize| Scale { low: window.low[k], high: window.low[k] + window.size[k], log: false };
    let (sx, sy) = (scale(0), scale(1));
    // As many labels as fit: their width depends on their number of digits.
    let widest = sx.ticks(6).iter().map(|t| text_width(&t.1, SIZE)).fold(20.0, f64::max);
    let bottom = corner[1] + h;
    for (v, text) in sx.ticks(((w / (1.8 * widest)) as usize).clamp(1, 9)) {
        let x = window.pixel([v, 0.0], corner)[0];
        page.line([x, bottom], [x, bottom + 4.0], "stroke=\"#1a1a1a\"");
        page.text([x, bottom + 18.0], SIZE, Anchor::Middle, &text);
    }
    for (v, text) in sy.ticks(((h / 34.0) as usize).clamp(1, 9)) {
        let y = window.pixel([0.0, v], corner)[1];
        page.line([corner[0] - 4.0, y], [corner[0], y], "stroke=\"#1a1a1a\"");
        page.text([corner[0] - 7.0, y + 4.2], SIZE, Anchor::End, &text);
    }
    let at = [corner[0] + w / 2.0, bottom + 36.0];
    page.text(at, SIZE, Anchor::Middle, &label(names[0], "m", &sx));
    page.upright([corner[0] - 52.0, corner[1] + h / 2.0], SIZE, &label(names[1], "m", &sy));
}

fn outlines(
    page: &mut Page,
    frame: &Frame,
    field: &Chosen,
    paint: &dyn Fn(f64) -> String,
    window: &Window,
    corner: [f64; 2],
) {
    let stroke = if frame.blocks() > 400 { 0.35 } else { 0.8 };
    let numbers = frame.column("block").map_or(&[][..], |c| &c.data);
    let same = |i: usize| i > 0 && numbers.get(i).is_some_and(|n| *n == numbers[i - 1]);
    let mut from = 0;
    while from < field.values.len() {
        // A cut block may be in several parts, and have holes.
        let to = (from + 1..field.values.len()).find(|&i| !same(i));
        let to = to.unwrap_or(field.values.len());
        let line = |i: usize| -> Vec<[f64; 2]> {
            let points = frame.outline(i).iter();
            points.map(|p| window.pixel([p[0], p[1]], corner)).collect()
        };
        let lines: Vec<Vec<[f64; 2]>> = (from..to).map(line).collect();
        if lines.iter().flatten().flatten().all(|v| v.is_finite()) {
            let colour = paint(field.values[from]);
            // Black edges are lost on dark blocks.
            let edge = if colour::is_dark(&colour) { "#c9d3e3" } else { "#1a1a1a" };
            let style = format!(
                "fill=\"{colour}\" stroke=\"{edge}\" stroke-width=\"{stroke}\" stroke-linejoin=\"round\""
            );
            page.rings(&lines, &style);
        }
        from = to;
    }
}

/// Faces that have broken, where the cut meets them: the columns `trace` of the frame are their ends.
fn cracks(page: &mut Page, frame: &Frame, window: &Window, corner: [f64; 2]) {
    for [a, b] in traces(frame) {
        let (a, b) = (window.pixel(a, corner), window.pixel(b, corner));
        if a.iter().chain(&b).all(|v| v.is_finite()) {
            page.line(a, b, "stroke=\"#ffffff\" stroke-width=\"3.4\" stroke-linecap=\"round\" stroke-opacity=\"0.8\"");
            page.line(a, b, "stroke=\"#d62728\" stroke-width=\"1.8\" stroke-linecap=\"round\"");
        }
    }
}

/// Ends of the traces of broken faces, m, in the axes of the picture.
fn traces(frame: &Frame) -> Vec<[[f64; 2]; 2]> {
    let lines = frame.cracks.as_ref().map_or(&[][..], |c| &c.points);
    let ends = lines.chunks_exact(2);
    ends.map(|e| [[e[0][0], e[0][1]], [e[1][0], e[1][1]]]).collect()
}

fn force_column(frame: &Frame) -> Option<&Column> {
    frame.contact_columns.iter().find(|c| c.components == 2 && c.name.contains("force"))
}

fn largest_force(frame: &Frame) -> f64 {
    force_column(frame).map_or(0.0, |c| {
        c.numbers(Part::Magnitude).into_iter().filter(|v| v.is_finite()).fold(0.0, f64::max)
    })
}

fn contact_note(frames: &[Frame]) -> String {
    let count = frames.last().map_or(0, |f| f.contact_points.len());
    match frames.iter().map(largest_force).fold(0.0, f64::max) {
        0.0 => format!("{count} contacts"),
        f => {
            let unit = frames.iter().find_map(force_column).map_or("", |c| &c.unit);
            format!("{count} contacts, longest force line {f:.2e} {unit}")
        }
    }
}

/// Dots, and a line along each force, the longest a tenth of the picture or less where contacts are dense.
fn contacts(page: &mut Page, frame: &Frame, window: &Window, corner: [f64; 2]) {
    let largest = largest_force(frame);
    let count = frame.contact_points.len().max(1) as f64;
    let spacing = (window.size[0] * window.size[1] / count).sqrt();
    let reach = (0.025 * (window.size[0] + window.size[1])).min(0.7 * spacing) * window.zoom;
    let thick = (0.12 * spacing * window.zoom).clamp(0.6, 1.6);
    let line = format!("stroke=\"#d00060\" stroke-width=\"{thick:.2}\" stroke-linecap=\"round\"");
    let force = force_column(frame).filter(|_| largest > 0.0);
    for (i, p) in frame.contact_points.iter().enumerate() {
        let [x, y] = window.pixel([p[0], p[1]], corner);
        if let Some(column) = force {
            let (fx, fy) =
                (column.data[2 * i] / largest * reach, column.data[2 * i + 1] / largest * reach);
            page.line([x - fx, y + fy], [x + fx, y - fy], &line);
        }
        page.circle(
            [x, y],
            1.1 * thick,
            "fill=\"#d00060\" stroke=\"#ffffff\" stroke-width=\"0.5\"",
        );
    }
}

/// Names of kinds beside their colours, those that occur.
fn chips(page: &mut Page, names: &[String], values: &[f64], at: [f64; 2]) {
    let there = |k: usize| values.contains(&(k as f64));
    let shown = names.iter().enumerate().filter(|(k, _)| there(*k));
    let shown: Vec<(&str, &str)> =
        shown.map(|(k, name)| (colour::material(k as f64), name.as_str())).collect();
    chips_of(page, &shown, at);
}

/// Names beside their colours, one below the other.
pub(super) fn chips_of(page: &mut Page, kinds: &[(&str, &str)], [x, y]: [f64; 2]) {
    for (row, (colour, name)) in kinds.iter().enumerate() {
        let top = y + 22.0 * row as f64;
        let style = format!("fill=\"{colour}\" stroke=\"#1a1a1a\"");
        page.rect(x, top, 14.0, 14.0, &style);
        let room = page.width - x - 22.0;
        page.text([x + 20.0, top + 11.5], SIZE, Anchor::Start, &fitted(name, SIZE, room));
    }
}

pub(super) fn bar(
    page: &mut Page,
    (map, scale): (ColourMap, &Scale),
    field: &Chosen,
    at: [f64; 2],
    height: f64,
) {
    let parts = 64;
    let part = height / f64::from(parts);
    for i in 0..parts {
        let colour = map.at((f64::from(i) + 0.5) / f64::from(parts));
        let y = at[1] + height - f64::from(i + 1) * part;
        // A little taller than its share, or seams show.
        page.rect(
            at[0],
            y,
            BAR,
            part + if i > 0 { 0.6 } else { 0.0 },
            &format!("fill=\"{colour}\""),
        );
    }
    page.rect(at[0], at[1], BAR, height, "fill=\"none\" stroke=\"#1a1a1a\"");
    let mut widest = 0.0f64;
    for (v, text) in scale.ticks(((height / 34.0) as usize).clamp(4, 8)) {
        widest = widest.max(text_width(&text, SIZE));
        let y = at[1] + height * (1.0 - scale.share(v));
        page.line([at[0] + BAR, y], [at[0] + BAR + 4.0, y], "stroke=\"#1a1a1a\"");
        page.text([at[0] + BAR + 7.0, y + 4.2], SIZE, Anchor::Start, &text);
    }
    let middle = at[1] + height / 2.0;
    let room = 2.0 * middle.min(page.height - middle) - 10.0;
    let text = fitted(&label(&field.name, &field.unit, scale), SIZE, room);
    page.upright([at[0] + BAR + widest + 28.0, at[1] + height / 2.0], SIZE, &text);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_cover_what_was_asked_for() {
        let values: Vec<f64> = (0..=100).map(f64::from).chain([1e6, f64::NAN]).collect();
        let with = |range, percentiles| {
            let options = BlockOptions { range, percentiles, ..BlockOptions::default() };
            let (map, scale) = colours(&values, options);
            (map, [scale.low, scale.high], beyond(&values, &scale, options))
        };
        let (map, ends, note) = with(None, None);
        assert!(map == ColourMap::Light && ends == [0.0, 1e6] && note.is_none());
        let (_, ends, note) = with(None, Some([2.0, 98.0]));
        assert_eq!(ends, [0.0, 99.0]);
        assert_eq!(note.unwrap(), "2 values beyond the colours: 0 to 1.00e6");
        let (map, ends, _) = with(Some([-5.0, 20.0]), None);
        assert!(map == ColourMap::BlueRed && ends == [-5.0, 20.0]);
    }
}
