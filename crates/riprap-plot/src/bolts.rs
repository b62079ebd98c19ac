//! Bolts on pictures of blocks: bars as lines coloured by axial force.

use super::svg::Page;
use riprap_record::frame::Frame;

/// Colours without force, in full tension, in full compression: those of the viewer.
const COLOURS: [[f64; 3]; 3] = [[244.0, 240.0, 234.0], [208.0, 28.0, 28.0], [29.0, 95.0, 208.0]];

/// Axial forces of the bars of a frame, N, tension positive.
pub(super) fn forces(frame: &Frame) -> &[f64] {
    let columns = frame.bolts.as_ref().map_or(&[][..], |b| &b.columns);
    let force = columns.iter().find(|c| c.name == "axial_force");
    force.map_or(&[], |c| &c.data)
}

/// Largest size of an axial force in any of the frames, N.
pub(super) fn most(frames: &[Frame]) -> f64 {
    let all = frames.iter().flat_map(forces);
    all.map(|f| f.abs()).fold(0.0, f64::max)
}

/// What the lines are, in words; `None` without bolts.
pub(super) fn note(frames: &[Frame]) -> Option<String> {
    let any = frames.iter().any(|f| !forces(f).is_empty());
    any.then(|| {
        let most = 1e-3 * most(frames);
        format!(
            "bolts (in sections as seen along the normal): red in tension, blue in compression, up to {} kN",
            super::digits(most, 3)
        )
    })
}

/// Draws the bars with a dark rim, white without force, full colour at the force `most` (N).
pub(super) fn draw(
    page: &mut Page,
    frame: &Frame,
    most: f64,
    pixel: &dyn Fn([f64; 2]) -> [f64; 2],
) {
    let Some(bolts) = &frame.bolts else { return };
    let lines: Vec<[[f64; 2]; 2]> = bolts
        .points
        .chunks_exact(2)
        .map(|ends| [ends[0], ends[1]].map(|p| pixel([p[0], p[1]])))
        .collect();
    for [a, b] in &lines {
        page.line(*a, *b, "stroke=\"#1a1a1a\" stroke-width=\"4.2\" stroke-linecap=\"round\"");
    }
    for ([a, b], force) in lines.iter().zip(forces(frame)) {
        let share = if most > 0.0 { force / most } else { 0.0 };
        let style =
            format!("stroke=\"{}\" stroke-width=\"2.6\" stroke-linecap=\"round\"", colour(share));
        page.line(*a, *b, &style);
    }
}

/// Colour of a share of the largest force, -1 to 1.
pub(super) fn colour(share: f64) -> String {
    let end = COLOURS[if share < 0.0 { 2 } else { 1 }];
    let size = share.abs().min(1.0);
    let mix = |k: usize| (COLOURS[0][k] + size * (end[k] - COLOURS[0][k])).round() as u8;
    format!("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use riprap_record::frame::{Column, Surfaces};

    #[test]
    fn tension_is_red_compression_blue_and_nothing_white() {
        assert_eq!(colour(0.0), "#f4f0ea");
        assert_eq!([colour(1.0), colour(-1.0)], ["#d01c1c", "#1d5fd0"]);
    }

    #[test]
    fn bars_are_drawn_with_their_largest_force_in_words() {
        let frame = Frame {
            bolts: Some(Surfaces {
                ends: vec![2, 4],
                points: vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]],
                columns: vec![Column::scalar("axial_force", "N", vec![-5e3, 25e3])],
            }),
            ..Frame::default()
        };
        let frames = [frame, Frame::default()];
        assert_eq!(most(&frames), 25e3);
        assert!(note(&frames).unwrap().contains("25"));
        assert_eq!(note(&frames[1..]), None);
        let mut page = Page::new(100.0, 100.0);
        draw(&mut page, &frames[0], most(&frames), &|p| p);
        let svg = page.svg(&crate::Look::default());
        assert!(svg.matches("<line").count() >= 4 && svg.contains("#d01c1c"));
    }
}
