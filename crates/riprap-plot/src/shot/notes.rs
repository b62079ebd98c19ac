//! Texts at places of the model, as they were written in the viewer.

use resvg::tiny_skia::Pixmap;
use riprap_geom::{Quat, Vec3};
use riprap_record::frame::Frame;

use super::super::svg::{Anchor, Page, fitted, text_width};
use super::super::{Look, PlotError};
use super::camera::{Camera, Window};
use super::drawing::unit;
use super::wanted::{FINE, Note, Shot, TITLE, failed};

/// Size of the letters; where a text begins, from its place; and the height of its box, pixels.
const SIZE: f64 = 12.0;
const AWAY: [f64; 2] = [14.0, -18.0];
const HIGH: f64 = 18.0;
/// A box keeps so far from the edge of the picture, pixels.
const EDGE: f64 = 2.0;

/// Where a note is in a frame, m; `None`: its block is not there.
fn place(note: &Note, frame: &Frame, shot: &Shot) -> Option<Vec3> {
    let at = Vec3::from(note.at);
    let Some(block) = note.block else { return Some(at) };
    let i = match frame.column("block") {
        Some(numbers) => numbers.data.iter().position(|n| *n == f64::from(block))?,
        None => Some(block as usize).filter(|i| *i < frame.blocks())?,
    };
    let vector = |name: &str| {
        let column = frame.column(name).filter(|c| c.components == 3)?;
        column.data.get(3 * i..3 * i + 3).map(|v| Vec3::new(v[0], v[1], v[2]))
    };
    let (shift, turn) = (vector("displacement")?, vector("rotation").unwrap_or(Vec3::ZERO));
    let body = super::super::solid::bodies(frame).swap_remove(i);
    // Where its centroid was at rest.
    let centre = body.now - shift;
    let factor = shot.options.exaggeration.unwrap_or(1.0);
    let arm = at - centre;
    Some(at + factor * (shift + Quat::from_scaled_axis(turn) * arm - arm))
}

/// Writes the notes of a shot over a picture of a frame.
pub(super) fn write(
    map: &mut Pixmap,
    frame: &Frame,
    shot: &Shot,
    (camera, window): (&Camera, &Window),
) -> Result<(), PlotError> {
    let plane = shot.cut.map(unit);
    let mut page = Page::new(f64::from(map.width()), f64::from(map.height()));
    let mut boxes = Vec::new();
    for note in &shot.notes {
        let Some(place) = place(note, frame, shot) else { continue };
        if plane.is_some_and(|(normal, at)| normal.dot(place) > at) {
            continue;
        }
        let Some((seen, _)) = camera.polygon(&[place], &|_| -1.0).pop() else { continue };
        let at = window.at(seen);
        let [x, y] = [at.x / FINE as f64, at.y / FINE as f64 + TITLE];
        let inside = x >= 0.0 && x < f64::from(shot.size[0]) && y >= TITLE;
        if !inside || y >= TITLE + f64::from(shot.size[1]) {
            continue;
        }
        let most = f64::from(map.width()) - 2.0 * EDGE;
        let text = fitted(&note.text, SIZE, most - 8.0);
        let long = text_width(&text, SIZE) + 8.0;
        // Boxes stay in the picture.
        let tx = (x + AWAY[0]).min(EDGE + most - long + 4.0).max(EDGE + 4.0);
        let ty = (y + AWAY[1]).max(0.5 * HIGH + EDGE);
        page.line([x, y], [tx, ty], "stroke=\"#1a1a1a\" stroke-width=\"1\"");
        page.circle([x, y], 2.5, "");
        let [left, top] = [tx - 4.0, ty - 0.5 * HIGH];
        let style = "fill=\"#ffffff\" stroke=\"#1a1a1a\" stroke-width=\"1\"";
        page.rect(left, top, long, HIGH, style);
        page.text([tx, ty + 0.36 * SIZE], SIZE, Anchor::Start, &text);
        boxes.push([left - 0.5, top - 0.5, left + long + 0.5, top + HIGH + 0.5]);
    }
    if boxes.is_empty() {
        return Ok(());
    }
    let look = Look { dpi: Some(96.0), ..Look::default() };
    let over = Pixmap::decode_png(&page.png(&look)?).map_err(failed)?;
    let wide = map.width() as usize;
    for (k, (old, new)) in map.pixels_mut().iter_mut().zip(over.pixels()).enumerate() {
        let (x, y) = ((k % wide) as f64 + 0.5, (k / wide) as f64 + 0.5);
        // The box hides what is below it; lines are darker than all else.
        let hides = boxes.iter().any(|[l, t, r, b]| x > *l && x < *r && y > *t && y < *b);
        if hides || new.green() < old.green() {
            *old = *new;
        }
    }
    Ok(())
}
