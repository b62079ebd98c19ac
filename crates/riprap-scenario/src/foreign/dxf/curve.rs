//! Arcs, circles and ellipses as straight pieces.

use std::f64::consts::TAU;

use super::{Entity, Kind, SAGITTA};

/// Most pieces of one arc.
const MOST_PIECES: f64 = 1000.0;

/// A circle, an ellipse or a part of one: centre + cos(s) a + sin(s) b for s from `from` over `turn`.
pub(super) struct Curve {
    centre: [f64; 2],
    a: [f64; 2],
    b: [f64; 2],
    from: f64,
    turn: f64,
    /// Whether it is closed.
    pub(super) whole: bool,
}

impl Curve {
    /// Of an entity; none without a size.
    pub(super) fn of(entity: &Entity) -> Option<Self> {
        let [x, y, ..] = *entity.points.first()?;
        let (a, b, from, to) = if entity.kind == Kind::Ellipse {
            let [ax, ay, ..] = *entity.points.get(1)?;
            let ratio = entity.number(40, 1.0);
            // Against an upside-down normal it runs the other way.
            let ratio = if entity.normal.z < 0.0 { -ratio } else { ratio };
            let (from, to) = (entity.number(41, 0.0), entity.number(42, TAU));
            ([ax, ay], [-ratio * ay, ratio * ax], from, to)
        } else {
            let radius = entity.number(40, 0.0);
            let [from, to] = if entity.kind == Kind::Arc {
                [50, 51].map(|code| entity.number(code, 0.0).to_radians())
            } else {
                [0.0, TAU]
            };
            ([radius, 0.0], [0.0, radius], from, to)
        };
        let sized = |v: [f64; 2]| libm::hypot(v[0], v[1]) > 0.0;
        if !(sized(a) && sized(b) && (to - from).is_finite()) {
            return None;
        }
        // Arcs run anticlockwise, over the angle 0 where they end before it.
        let turn = (to - from).rem_euclid(TAU);
        let whole = !(1e-9..=TAU - 1e-9).contains(&turn);
        Some(Curve { centre: [x, y], a, b, from, turn: if whole { TAU } else { turn }, whole })
    }
}

/// Points of a curve; of a closed one without the first again.
pub(super) fn pieces(curve: &Curve, sagitta: Option<f64>) -> Vec<[f64; 2]> {
    let size = |v: [f64; 2]| libm::hypot(v[0], v[1]);
    let radius = size(curve.a).max(size(curve.b));
    let share = sagitta.map_or(SAGITTA, |s| s / radius);
    let piece = 2.0 * libm::acos(1.0 - share.clamp(0.0, 1.0));
    let mut count = (curve.turn / piece).ceil().clamp(1.0, MOST_PIECES) as u32;
    if curve.whole {
        // As wide as high, and at least a square.
        count = count.max(4).next_multiple_of(4);
    }
    let ends = u32::from(!curve.whole);
    (0..count + ends)
        .map(|k| {
            let s = curve.from + curve.turn * f64::from(k) / f64::from(count);
            let (sin, cos) = (libm::sin(s), libm::cos(s));
            [0, 1].map(|axis| curve.centre[axis] + cos * curve.a[axis] + sin * curve.b[axis])
        })
        .collect()
}

/// Points of an arc between its ends. The bulge is the tangent of a quarter of its angle, positive anticlockwise.
pub(super) fn arc(
    from: [f64; 2],
    to: [f64; 2],
    bulge: f64,
    sagitta: Option<f64>,
    out: &mut Vec<[f64; 2]>,
) {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    // With t = tan(angle/4): sin(angle/2) = 2 t/(1 + t^2), cos(angle/2) = (1 - t^2)/(1 + t^2).
    let radius = libm::hypot(dx, dy) * (1.0 + bulge * bulge) / (4.0 * bulge.abs());
    let angle = 4.0 * libm::atan(bulge);
    let share = sagitta.map_or(SAGITTA, |s| s / radius);
    // At most half a circle: a sagitta above the radius would have no angle.
    let piece = 2.0 * libm::acos(1.0 - share.clamp(0.0, 1.0));
    let pieces = (angle.abs() / piece).ceil();
    let to_centre = (1.0 - bulge * bulge) / (4.0 * bulge);
    let centre =
        [0.5 * (from[0] + to[0]) - to_centre * dy, 0.5 * (from[1] + to[1]) + to_centre * dx];
    // A bulge of next to nothing has its centre at infinity: the arc is the straight piece.
    if !(radius.is_finite() && centre.iter().all(|x| x.is_finite())) {
        return;
    }
    let pieces = pieces.clamp(1.0, MOST_PIECES) as u32;
    let arm = [from[0] - centre[0], from[1] - centre[1]];
    for k in 1..pieces {
        let turn = angle * f64::from(k) / f64::from(pieces);
        let (sin, cos) = (libm::sin(turn), libm::cos(turn));
        out.push([
            centre[0] + cos * arm[0] - sin * arm[1],
            centre[1] + sin * arm[0] + cos * arm[1],
        ]);
    }
}
