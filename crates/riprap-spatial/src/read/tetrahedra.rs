//! Tetrahedra for ParaView, with stress and strain.

use riprap_geom::Vec3;

use crate::frame::{Column, Surfaces};
use crate::laws::tetrahedron::{Gradient, Strain, Symmetric, tensor};
use crate::query::view::View;
use crate::read::fields::principal;

/// Tetrahedra of all living deformable blocks at their present places; `None` if no block is deformable. Stress is tension
/// positive: `stress_normal` and `strain_normal` are xx, yy, zz, `stress_shear` and `strain_shear` yz, zx, xy;
/// `principal_stress` from the largest tension down.
#[must_use]
pub fn tetrahedra(view: &View<'_>) -> Option<Surfaces> {
    let (deform, work) = view.deformables()?;
    let mut out = Surfaces::default();
    let (mut blocks, mut normal, mut shear) = (Vec::new(), Vec::new(), Vec::new());
    let (mut stretch, mut slide, mut main) = (Vec::new(), Vec::new(), Vec::new());
    for body in deform.living() {
        let kind = work.class(body);
        let start = work.start_of(deform.slot[body.block as usize] as usize);
        let u = deform.displacement(body);
        let stresses = kind.groups.stresses(&kind.law, body.strain, start, u);
        for (tet, s) in stresses.iter().enumerate() {
            for node in kind.mesh.tets[tet] {
                let node = (body.first + node) as usize;
                let at =
                    deform.nodes.place[node] + Vec3::from_array(deform.nodes.displacement[node]);
                out.points.push((at + view.world.setup.origin).to_array());
            }
            out.ends.push(out.points.len() as u32);
            let e = strain(body.strain, &kind.groups.gradient(tet, u));
            let three = |s: &Symmetric, k: usize| [s[k], s[k + 1], s[k + 2]];
            blocks.push(f64::from(body.block));
            normal.push(three(s, 0));
            shear.push(three(s, 3));
            stretch.push(three(&e, 0));
            slide.push(three(&e, 3));
            main.push(principal(&tensor(*s)));
        }
    }
    out.columns = vec![
        Column::scalar("block", "-", blocks),
        Column::vector3("stress_normal", "Pa", normal),
        Column::vector3("stress_shear", "Pa", shear),
        Column::vector3("principal_stress", "Pa", main),
        Column::vector3("strain_normal", "-", stretch),
        Column::vector3("strain_shear", "-", slide),
    ];
    Some(out)
}

/// Strain of a displacement gradient, by the measure of the block.
pub(super) fn strain(measure: Strain, h: &Gradient) -> Symmetric {
    let one = |i: usize, j: usize| {
        let square: f64 = match measure {
            Strain::Small => 0.0,
            Strain::Large => (0..3).map(|k| h[k][i] * h[k][j]).sum(),
        };
        0.5 * (h[i][j] + h[j][i] + square)
    };
    [one(0, 0), one(1, 1), one(2, 2), one(1, 2), one(2, 0), one(0, 1)]
}
