//! What changes from frame to frame: where each block is, seen from its place at rest, and how far faces have opened.
//!
//! A rigid block needs a shift and a turn, whatever number of corners it has; a block that changed its shape brings the
//! shift of each corner. Nothing is taken from columns here: what the corners did is what is shown.

use riprap_geom::Vec3;
use riprap_geom::{Mat3, Quat};
use riprap_record::Frame;
use serde_json::{Value, json};

use crate::parts::in_parts;
use crate::shape::{Shape, mean, single};
use crate::wire::Wire;

/// A block whose corners are farther from the rigid motion than this share of its size has changed its shape.
const RIGID: f64 = 2e-5;
/// Decades of opening below which faces are shut, and steps to a decade.
const SHUT_DECADE: f64 = -6.0;
const STEPS: f64 = 2.0;

/// The answer `frame`: the motion from `shape` to `frame`, whose shape it is.
pub fn wire(shape: &Shape, frame: &Frame) -> Vec<u8> {
    let now = in_parts(frame.points.len(), |range| {
        frame.points[range].iter().map(|p| Vec3::from(*p) - shape.origin).collect()
    });
    let blocks = shape.ids.len();
    let moves = in_parts(blocks, |range| range.map(|b| Move::of(shape, &now, b)).collect());
    let shifts: Vec<Vec3> = moves.iter().map(|m| m.shift).collect();
    let turns: Vec<Quat> = moves.iter().map(|m| m.turn).collect();
    let (mut bent, mut bent_shifts) = (Vec::new(), Vec::new());
    for (b, _) in moves.iter().enumerate().filter(|(_, m)| m.bent) {
        let (rest, here) = (&shape.points[shape.range(b)], &now[shape.range(b)]);
        bent.push(b as u32);
        bent_shifts.extend(rest.iter().zip(here).flat_map(|(r, h)| single(*h - *r)));
    }
    let info = |turn_scale: f64| -> Value {
        json!({
            "shape": shape.key, "time": frame.time, "step": frame.step, "phase": frame.phase,
            "turnScale": turn_scale, "shutDecade": SHUT_DECADE, "steps": STEPS,
        })
    };
    let out = Wire::default().u32("bent", &bent).f32("bentShifts", &bent_shifts);
    if shape.dimension == 2 {
        let shifts: Vec<f32> = shifts.iter().flat_map(|s| [s.x as f32, s.y as f32]).collect();
        let turns: Vec<f32> = turns.iter().map(|q| (2.0 * q.z.atan2(q.w)) as f32).collect();
        return out.f32("shifts", &shifts).f32("turns", &turns).finish(&info(1.0));
    }
    let shifts: Vec<f32> = shifts.iter().flat_map(|s| single(*s)).collect();
    let (scale, turns) = sixteen_bits(&turns);
    out.f32("shifts", &shifts)
        .i16("turns", &turns)
        .u8("gaps", &gaps(shape, &now))
        .finish(&info(scale))
}

/// What a block did.
struct Move {
    shift: Vec3,
    turn: Quat,
    /// It changed its shape.
    bent: bool,
}

impl Move {
    fn of(shape: &Shape, now: &[Vec3], b: usize) -> Self {
        let (rest, here) = (&shape.points[shape.range(b)], &now[shape.range(b)]);
        if rest == here {
            return Move { shift: Vec3::ZERO, turn: Quat::IDENTITY, bent: false };
        }
        let middle = mean(here);
        let turn = turn_of(rest, here);
        let far = farthest(rest, here, shape.middles[b], middle, turn);
        let bent = far.is_none_or(|far| far > RIGID) && middle.is_finite();
        Move { shift: middle - shape.middles[b], turn, bent }
    }
}

/// Vector parts of unit quaternions with a scalar part that is not negative, as shares of the largest component.
fn sixteen_bits(turns: &[Quat]) -> (f64, Vec<i16>) {
    let vectors: Vec<Vec3> =
        turns.iter().map(|q| if q.w < 0.0 { -q.xyz() } else { q.xyz() }).collect();
    let scale = vectors.iter().map(|v| v.abs().max_element()).fold(0.0, f64::max);
    let top = f64::from(i16::MAX);
    let share = |v: f64| {
        if scale > 0.0 { (v / scale * top).round() as i16 } else { 0 }
    };
    let numbers = vectors.iter().flat_map(|v| v.to_array().map(share)).collect();
    (scale, numbers)
}

/// Axes given by the first corner, the one farthest from it and the one farthest from the line through both.
fn axes(points: &[Vec3], [a, b, c]: [usize; 3]) -> Option<Mat3> {
    let e = (points[b] - points[a]).try_normalize()?;
    let way = points[c] - points[a];
    let f = (way - e * e.dot(way)).try_normalize()?;
    Some(Mat3::from_cols(e, f, e.cross(f)))
}

fn turn_of(rest: &[Vec3], here: &[Vec3]) -> Quat {
    let Some((first, others)) = rest.split_first() else {
        return Quat::IDENTITY;
    };
    let farthest = |size: &dyn Fn(Vec3) -> f64| {
        let sizes = others.iter().map(|p| size(*p - *first)).enumerate();
        sizes.max_by(|x, y| x.1.total_cmp(&y.1)).map_or(0, |x| x.0 + 1)
    };
    let b = farthest(&|v| v.length_squared());
    let along = rest[b] - *first;
    let c = farthest(&|v| along.cross(v).length_squared());
    match (axes(rest, [0, b, c]), axes(here, [0, b, c])) {
        (Some(from), Some(to)) => {
            let q = Quat::from_mat3(&(to * from.transpose())).normalize();
            if q.is_finite() { q } else { Quat::IDENTITY }
        }
        (_, _) => Quat::IDENTITY,
    }
}

/// Largest distance of a corner from the rigid motion, as a share of the block's size. `None` where it is no number.
fn farthest(rest: &[Vec3], here: &[Vec3], middle: Vec3, moved: Vec3, turn: Quat) -> Option<f64> {
    let turn = Mat3::from_quat(turn);
    let (mut far, mut size) = (0.0_f64, 0.0_f64);
    for (r, h) in rest.iter().zip(here) {
        let arm = *r - middle;
        far = far.max((turn * arm - (*h - moved)).length_squared());
        size = size.max(arm.length_squared());
    }
    let share = (far / size).sqrt();
    share.is_finite().then_some(share)
}

/// Opening of each pair of twin faces against the typical block size, four bits each, low ones first: 0 is shut
/// (below `10^SHUT_DECADE`), each further number is `1 / STEPS` of a decade.
fn gaps(shape: &Shape, now: &[Vec3]) -> Vec<u8> {
    let pairs = shape.twin_ends.len() - 1;
    let shut = (shape.size * 10_f64.powf(SHUT_DECADE)).powi(2);
    let code = |k: usize| -> u8 {
        let range = shape.twin_ends[k] as usize..shape.twin_ends[k + 1] as usize;
        let gap2 = shape.twin_corners[range]
            .iter()
            .map(|[a, b]| now[*a as usize].distance_squared(now[*b as usize]))
            .fold(0.0, f64::max);
        if gap2 < shut {
            0
        } else {
            // Saturates; what is no number is shut.
            (1.0 + 0.5 * STEPS * (gap2 / shut).log10()).min(15.0) as u8
        }
    };
    in_parts(pairs.div_ceil(2), |range| {
        let both = |i: usize| {
            let high = if 2 * i + 1 < pairs { code(2 * i + 1) << 4 } else { 0 };
            code(2 * i) | high
        };
        range.map(both).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use riprap_record::frame::{BRICK, Column, Solids};

    /// Two bricks side by side; the second has moved by `shift`, turned by `turn` and been stretched.
    fn bricks(shift: Vec3, turn: Vec3, stretch: f64) -> Frame {
        let mut points = Vec::new();
        points.extend(BRICK.map(|c| (Vec3::from(c) * 0.5).to_array()));
        let q = Quat::from_scaled_axis(turn);
        let centre = Vec3::new(1.0, 0.0, 0.0);
        points.extend(BRICK.map(|c| {
            let mut arm = Vec3::from(c) * 0.5;
            arm.z *= stretch;
            (centre + shift + q * arm).to_array()
        }));
        Frame {
            offsets: vec![0, 8, 16],
            points,
            solids: Some(Solids { faces: vec![0, 0, 0], ends: vec![0], corners: vec![] }),
            block_columns: vec![
                Column::scalar("block", "-", vec![3.0, 5.0]),
                Column::vector3("displacement", "m", [[0.0; 3], shift.to_array()]),
                Column::vector3("rotation", "rad", [[0.0; 3], turn.to_array()]),
            ],
            ..Frame::default()
        }
    }

    fn array(bytes: &[u8], name: &str) -> Vec<u8> {
        let length = u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]) as usize;
        let head: Value = serde_json::from_slice(&bytes[4..4 + length]).unwrap();
        let list = head["arrays"].as_array().unwrap();
        let entry = list.iter().find(|a| a["name"] == name).unwrap();
        let size = match entry["type"].as_str().unwrap() {
            "u8" => 1,
            "i16" => 2,
            _ => 4,
        };
        let at = (4 + length).next_multiple_of(8) + entry["at"].as_u64().unwrap() as usize;
        bytes[at..at + size * entry["length"].as_u64().unwrap() as usize].to_vec()
    }

    fn singles(bytes: &[u8]) -> Vec<f32> {
        bytes.as_chunks::<4>().0.iter().map(|b| f32::from_le_bytes(*b)).collect()
    }

    #[test]
    fn the_shape_at_rest_does_not_depend_on_the_frame() {
        let rest = Shape::of(&bricks(Vec3::ZERO, Vec3::ZERO, 1.0), Vec3::ZERO);
        let moved = Shape::of(
            &bricks(Vec3::new(0.3, -0.2, 5.0), Vec3::new(0.1, 2.0, 0.3), 1.0),
            Vec3::ZERO,
        );
        assert_eq!(rest.key, moved.key);
        assert_eq!(rest.twin_ends, [0, 4]);
        for (a, b) in rest.points.iter().zip(&moved.points) {
            assert!((*a - *b).length() < 1e-12);
        }
    }

    #[test]
    fn rigid_motion_is_a_shift_and_a_turn() {
        let shape = Shape::of(&bricks(Vec3::ZERO, Vec3::ZERO, 1.0), Vec3::ZERO);
        let (shift, turn) = (Vec3::new(0.5, 0.0, -2.0), Vec3::new(0.2, -0.4, 0.1));
        let bytes = wire(&shape, &bricks(shift, turn, 1.0));
        assert!(array(&bytes, "bent").is_empty());
        let got = singles(&array(&bytes, "shifts"));
        assert!((f64::from(got[5]) + 2.0).abs() < 1e-6 && got[0] == 0.0);
        let turns = array(&bytes, "turns");
        let last = i16::from_le_bytes([turns[8], turns[9]]);
        // The largest component, that about y of the second block, uses the whole range.
        assert_eq!(last, -i16::MAX);
        assert_eq!(array(&bytes, "gaps"), [13]);
    }

    #[test]
    fn a_stretched_block_brings_its_corners_and_tiny_gaps_are_told() {
        let shape = Shape::of(&bricks(Vec3::ZERO, Vec3::ZERO, 1.0), Vec3::ZERO);
        let bytes = wire(&shape, &bricks(Vec3::new(1e-4, 0.0, 0.0), Vec3::ZERO, 1.01));
        assert_eq!(array(&bytes, "bent"), [1, 0, 0, 0]);
        assert_eq!(singles(&array(&bytes, "bentShifts")).len(), 24);
        let still = wire(&shape, &bricks(Vec3::new(1.5e-4, 0.0, 0.0), Vec3::ZERO, 1.0));
        assert_eq!(array(&still, "gaps"), [5]);
        let shut = wire(&shape, &bricks(Vec3::ZERO, Vec3::ZERO, 1.0));
        assert_eq!(array(&shut, "gaps"), [0]);
    }

    #[test]
    fn what_is_no_number_is_let_through() {
        let mut frame = bricks(Vec3::ZERO, Vec3::ZERO, 1.0);
        frame.points[9] = [f64::NAN; 3];
        let shape = Shape::of(&frame, Vec3::ZERO);
        wire(&shape, &frame);
        shape.wire();
        let none = Frame::default();
        wire(&Shape::of(&none, Vec3::ZERO), &none);
    }
}
