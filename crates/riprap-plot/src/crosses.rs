//! Principal stresses of blocks as crosses.

use super::digits;
use super::drawing::middle;
use super::svg::Page;
use riprap_record::frame::stress::{self, Principal};
use riprap_record::frame::{Frame, usual};
use std::collections::BTreeSet;

/// Colours of tension and compression: those of bolts, and of the viewer.
const PULLED: &str = "#d01c1c";
const PRESSED: &str = "#1d5fd0";
/// The longest arm, from end to end, as a share of the mean distance of the blocks.
const SPACING: f64 = 0.85;
/// It is not shorter than so many pixels; of blocks whose middles lie in one cell of this size the first has a cross.
const CELL: f64 = 14.0;
/// Shorter arms are not drawn, pixels.
const SHORTEST: f64 = 1.0;

/// Largest size of a principal stress in the plane of the picture of each block, Pa.
fn sizes(frames: &[Frame]) -> Vec<f64> {
    let all = frames.iter().filter_map(|f| stress::principal(&f.block_columns));
    let size = |p: Principal| p.values[0].abs().max(p.values[1].abs());
    all.flatten().map(size).filter(|v| v.is_finite()).collect()
}

/// The stress whose arm is the longest, Pa: what most blocks of all frames do not exceed.
pub(super) fn longest(frames: &[Frame]) -> f64 {
    usual(&sizes(frames))
}

/// What the crosses are, in words.
pub(super) fn note(frames: &[Frame]) -> String {
    let longest = longest(frames);
    let beyond = sizes(frames).iter().filter(|v| **v > 1.001 * longest).count();
    let also = match beyond {
        0 => String::new(),
        _ => format!(" or more ({beyond})"),
    };
    format!(
        "principal stresses in the plane, blue compression, red tension, longest {} MPa{also}",
        digits(1e-6 * longest, 3)
    )
}

/// Draws crosses at the middles of the blocks; the stress `longest` (Pa) has the same length everywhere, and larger ones have it too.
pub(super) fn draw(
    page: &mut Page,
    frame: &Frame,
    longest: f64,
    pixel: &dyn Fn([f64; 2]) -> [f64; 2],
    size: [f64; 2],
) {
    let Some(all) = stress::principal(&frame.block_columns).filter(|_| longest > 0.0) else {
        return;
    };
    let spacing = (size[0] * size[1] / frame.blocks().max(1) as f64).sqrt();
    let half = 0.5 * (SPACING * spacing).clamp(CELL, 80.0);
    let numbers = frame.column("block").map_or(&[][..], |c| &c.data);
    let mut taken = BTreeSet::new();
    for (i, stress) in all.iter().enumerate() {
        // Parts of one block have one stress.
        let same = i > 0 && numbers.get(i).is_some_and(|n| *n == numbers[i - 1]);
        let at = pixel(middle(frame.outline(i)));
        let cell = at.map(|v| (v / CELL).floor() as i64);
        if same || !at.iter().all(|v| v.is_finite()) || !taken.insert(cell) {
            continue;
        }
        cross(page, at, stress, half / longest, half);
    }
}

/// One cross; the larger arm lies above.
fn cross(page: &mut Page, [x, y]: [f64; 2], stress: &Principal, scale: f64, half: f64) {
    let mut arms = [0, 1].map(|k| (stress.values[k], stress.axes[k]));
    arms.sort_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
    // Both rims first, so that neither covers an arm.
    for (rim, width) in [(true, 3.0), (false, 1.5)] {
        for (value, axis) in arms {
            let reach = (scale * value.abs()).min(half);
            if !reach.is_finite() || 2.0 * reach < SHORTEST {
                continue;
            }
            let (dx, dy) = (reach * axis.x, -reach * axis.y);
            let colour = match (rim, value > 0.0) {
                (true, _) => "#ffffff",
                (false, true) => PULLED,
                (false, false) => PRESSED,
            };
            let style = format!("stroke=\"{colour}\" stroke-width=\"{width}\"");
            page.line([x - dx, y - dy], [x + dx, y + dy], &style);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Unit squares in a row under the stresses xx, yy, xy.
    fn row(stresses: &[[f64; 3]]) -> Frame {
        let mut frame = Frame { offsets: vec![0], ..Frame::default() };
        for i in 0..stresses.len() {
            let x = i as f64;
            let corners = [[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
            frame.points.extend(corners.map(|[x, y]| [x, y, 0.0]));
            frame.offsets.push(frame.points.len() as u32);
        }
        frame.block_columns = stress::in_plane(stresses).to_vec();
        frame
    }

    fn drawn(frame: &Frame) -> String {
        let mut page = Page::new(400.0, 100.0);
        let longest = longest(std::slice::from_ref(frame));
        let pixel = |p: [f64; 2]| [100.0 * p[0], 100.0 * (1.0 - p[1])];
        draw(&mut page, frame, longest, &pixel, [400.0, 100.0]);
        page.svg(&crate::Look::default())
    }

    #[test]
    fn compression_upright_is_an_upright_blue_line_of_full_length() {
        let svg = drawn(&row(&[[0.0, -2e6, 0.0]]));
        assert_eq!(svg.matches(PRESSED).count(), 1, "{svg}");
        assert!(!svg.contains(PULLED));
        let line = svg.lines().find(|l| l.contains(PRESSED)).unwrap();
        // From end to end 80 pixels, through the middle of the block.
        let on = |name: &str, v: &str| line.contains(&format!("{name}=\"{v}\""));
        assert!(on("x1", "50.00") && on("x2", "50.00"), "{line}");
        assert!(on("y1", "90.00") && on("y2", "10.00"), "{line}");
    }

    #[test]
    fn one_crushed_block_of_many_does_not_shorten_the_others() {
        let mut stresses = vec![[0.0, -1e6, 0.0]; 199];
        stresses.push([0.0, -1e12, 0.0]);
        let frame = row(&stresses);
        assert_eq!(longest(std::slice::from_ref(&frame)), 1e6);
        let note = note(std::slice::from_ref(&frame));
        assert!(note.contains("longest 1.00 MPa or more (1)"), "{note}");
    }

    #[test]
    fn frames_of_earlier_versions_have_no_crosses() {
        let mut frame = row(&[[0.0, -2e6, 0.0]]);
        frame.block_columns.clear();
        assert!(!drawn(&frame).contains(PRESSED));
    }
}
