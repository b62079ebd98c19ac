//! Principal stresses of the blocks as crosses.

use riprap_record::frame::{stress, usual};
use serde_json::json;

use crate::answer::extremes;
use crate::run::{Problem, Run};
use crate::wire::Wire;

/// The answer `stress`: of each block three arms along the principal axes, as long as the values are large (Pa; in the
/// plane the third is nothing), and for each whether it is in tension (1).
///
/// # Errors
/// As [`Run::columns`]; runs of earlier versions, whose frames have no stress.
pub fn wire(run: &Run, k: usize) -> Result<Vec<u8>, Problem> {
    let columns = run.columns(k, &|n| [stress::NORMAL, stress::SHEAR].contains(&n))?;
    let all = stress::principal(&columns).ok_or_else(|| {
        Problem::missing(
            format!("frame {k} has no stress of blocks"),
            "Run the scene again: frames of earlier versions have none.",
        )
    })?;
    let (mut arms, mut tension) = (Vec::with_capacity(9 * all.len()), Vec::new());
    for block in &all {
        for (value, axis) in block.values.iter().zip(block.axes) {
            arms.extend((value.abs() * axis).to_array().map(|v| v as f32));
            tension.push(u8::from(*value > 0.0));
        }
    }
    let sizes: Vec<f64> = all.iter().map(|p| largest(&p.values)).collect();
    let values: Vec<f64> = all.iter().flat_map(|p| p.values).collect();
    Ok(Wire::default()
        .f32("arms", &arms)
        .u8("tension", &tension)
        .finish(&json!({
            "unit": "Pa",
            "range": extremes(&values),
            "longest": Some(usual(&sizes)).filter(|v| *v > 0.0),
        })))
}

fn largest(values: &[f64; 3]) -> f64 {
    values.iter().fold(0.0, |m, v| m.max(v.abs()))
}
