//! Criteria of splitting during a run, one number per block.

use riprap_geom::polyhedron::principal;

use crate::query::view::View;
use crate::setup::Criterion;
use crate::state::patches::flag;

/// Value of the criterion for each block: Pa, 1/s or a share; 0 for dead blocks.
pub(super) fn of(view: &View, criterion: Criterion) -> Vec<f64> {
    let world = view.world;
    let mut values = vec![0.0_f64; world.alive.len()];
    match criterion {
        Criterion::Stress => {
            for (b, stress) in view.stresses().iter().enumerate() {
                if world.alive[b] {
                    values[b] = principal(stress).0.abs().max_element();
                }
            }
        }
        Criterion::StrainRate => {
            for p in 0..world.patches.len() {
                let class = view.patch_class(p);
                let fastest = view
                    .patch_points(p)
                    .velocity
                    .iter()
                    .map(|r| r.iter().map(|v| v * v).sum::<f64>().sqrt())
                    .fold(0.0, f64::max);
                for b in world.patches.ends[p] {
                    let value = &mut values[b as usize];
                    *value = value.max(fastest / class.distance);
                }
            }
        }
        Criterion::Broken => {
            let mut points = vec![0u32; world.alive.len()];
            for (ends, flags) in world.patches.ends.iter().zip(&world.patches.flags) {
                for b in ends {
                    values[*b as usize] += f64::from((flags & flag::BROKEN).count_ones());
                    points[*b as usize] += 4;
                }
            }
            for (value, points) in values.iter_mut().zip(points) {
                if points > 0 {
                    *value /= f64::from(points);
                }
            }
        }
    }
    values
}
