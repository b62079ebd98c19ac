//! Principal stresses as crosses: of blocks, and of the tetrahedra of deformable blocks where the run has written these.

use riprap_geom::Vec3;
use riprap_record::frame::stress::{self, Principal};
use riprap_record::frame::usual;
use serde_json::json;

use crate::answer::extremes;
use crate::contacts::Places;
use crate::run::{Cracks, Problem, Run};
use crate::shape;
use crate::wire::Wire;

/// The answer `stress`: of each block three arms along the principal axes, as long as the values are large (Pa; in the
/// plane the third is nothing), and for each whether it is in tension (1). The same of each tetrahedron (`tetArms`, `tetTension`), with
/// the place of its block (`tetBlock`) and its corners (`tetCorners`): these stand for their blocks, whose averages then count for nothing.
///
/// # Errors
/// As [`Run::columns`] and [`Run::tetrahedra`]; runs of earlier versions, whose frames have no stress.
pub fn wire(run: &Run, k: usize) -> Result<Vec<u8>, Problem> {
    let columns = run.columns(k, &|n| [stress::NORMAL, stress::SHEAR].contains(&n))?;
    let blocks = stress::principal(&columns).ok_or_else(|| {
        Problem::missing(
            format!("frame {k} has no block stresses"),
            "Run the scene again; frames of earlier versions have none.",
        )
    })?;
    let fine = match run.tetrahedra(k)? {
        Some(read) => Fine::of(&read, k)?,
        None => Fine::default(),
    };
    let mut divided = vec![false; blocks.len()];
    for block in &fine.block {
        if let Some(one) = divided.get_mut(*block as usize) {
            *one = true;
        }
    }
    // Range and length are those of what is drawn.
    let whole = blocks.iter().zip(&divided).filter(|(_, d)| !**d);
    let drawn: Vec<&Principal> = whole.map(|(b, _)| b).chain(&fine.stress).collect();
    let sizes: Vec<f64> = drawn.iter().map(|p| largest(&p.values)).collect();
    let values: Vec<f64> = drawn.iter().flat_map(|p| p.values).collect();
    let (arms, tension) = crosses(&blocks);
    let (fine_arms, fine_tension) = crosses(&fine.stress);
    Ok(Wire::default()
        .f32("arms", &arms)
        .u8("tension", &tension)
        .f32("tetArms", &fine_arms)
        .u8("tetTension", &fine_tension)
        .f32("tetCorners", &fine.corners)
        .u32("tetBlock", &fine.block)
        .finish(&json!({
            "unit": "Pa",
            "range": extremes(&values),
            "longest": Some(usual(&sizes)).filter(|v| *v > 0.0),
            "tetSize": fine.size,
        })))
}

/// Arms with nine numbers each, and whether they are in tension.
fn crosses(all: &[Principal]) -> (Vec<f32>, Vec<u8>) {
    let (mut arms, mut tension) = (Vec::with_capacity(9 * all.len()), Vec::new());
    for one in all {
        for (value, axis) in one.values.iter().zip(one.axes) {
            arms.extend((value.abs() * axis).to_array().map(|v| v as f32));
            tension.push(u8::from(*value > 0.0));
        }
    }
    (arms, tension)
}

/// Tetrahedra of a frame.
#[derive(Default)]
struct Fine {
    stress: Vec<Principal>,
    /// Shape `[tetrahedra]`: place of the block of each in the frame.
    block: Vec<u32>,
    /// Shape `[tetrahedra, 4, 3]`: corners less the origin, m.
    corners: Vec<f32>,
    /// Median edge of the regular tetrahedra of their volumes, m; `None` where there are none.
    size: Option<f64>,
}

impl Fine {
    fn of(read: &Cracks, k: usize) -> Result<Self, Problem> {
        let damaged = || {
            Problem::broken(
                format!("frame {k} has inconsistent tetrahedra"),
                "Run the scene again, or copy the run folder again.",
            )
        };
        let stress = stress::principal(&read.columns).ok_or_else(damaged)?;
        let blocks = read.columns.iter().find(|c| c.name == "block");
        let blocks = blocks.ok_or_else(damaged)?;
        let (corners, rest) = read.points.as_chunks::<4>();
        let fit = [stress.len(), blocks.data.len(), read.ends.len()] == [corners.len(); 3];
        if !fit || !rest.is_empty() {
            return Err(damaged());
        }
        let places = Places::of(&read.ids);
        let mut sizes: Vec<f64> = corners.iter().map(edge).collect();
        sizes.sort_by(f64::total_cmp);
        Ok(Fine {
            stress,
            block: blocks.data.iter().map(|id| places.find(*id)).collect(),
            corners: read.points.iter().flat_map(|p| shape::single(*p)).collect(),
            size: sizes.get(sizes.len() / 2).copied(),
        })
    }
}

/// Edge of the regular tetrahedron of the same volume, m: `V = a^3 / (6 sqrt 2)`.
fn edge([a, b, c, d]: &[Vec3; 4]) -> f64 {
    let volume = (*b - *a).dot((*c - *a).cross(*d - *a)).abs() / 6.0;
    (6.0 * std::f64::consts::SQRT_2 * volume).cbrt()
}

fn largest(values: &[f64; 3]) -> f64 {
    values.iter().fold(0.0, |m, v| m.max(v.abs()))
}
