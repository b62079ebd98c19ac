//! Rough joints pressed beyond the strength of their walls, in words.

use super::engine::View;
use crate::laws::behaviour::{JointModel, Weakening};

/// Compressive strength of the walls (Pa), if the joint is rough.
fn walls(behaviour: &JointModel) -> Option<f64> {
    match &behaviour.weakening {
        Weakening::BartonBandis(rough) => Some(rough.jcs),
        Weakening::Brittle | Weakening::Softening(_) => None,
    }
}

/// That the normal stress on rough joints is above JCS now: roughness adds nothing there.
pub(super) fn crushed(view: &View<'_>) -> Option<String> {
    let (mut above, mut all) = (0_usize, 0_usize);
    let mut count = |jcs: f64, sigma: f64| {
        all += 1;
        above += usize::from(-sigma > jcs);
    };
    if let Some(view) = view.planar() {
        let interfaces = &view.world.setup.interfaces;
        for bond in view.world.bonds.iter().filter(|b| b.active) {
            let law = interfaces[bond.row as usize].bond.as_ref();
            let Some(jcs) = law.and_then(|law| walls(&law.behaviour)) else {
                continue;
            };
            bond.points.iter().for_each(|p| count(jcs, p.sigma));
        }
    }
    if let Some(view) = view.spatial() {
        let interfaces = &view.world.setup.interfaces;
        if interfaces.iter().any(|i| walls(&i.joint.behaviour).is_some()) {
            for p in 0..view.world.patches.len() {
                let row = usize::from(view.patch_class(p).row);
                let Some(jcs) = walls(&interfaces[row].joint.behaviour) else {
                    continue;
                };
                let tractions = view.patch_tractions(p);
                tractions.iter().for_each(|t| count(jcs, t[0]));
            }
        }
    }
    (above > 0).then(|| {
        format!(
            "the normal stress exceeds JCS at {above} of {all} points of rough joints, outside the range of the law; roughness adds no strength there"
        )
    })
}
