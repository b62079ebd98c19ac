//! What found contacts of deformable blocks will be like, told before they are there.

use riprap_geom::Vec3;

use super::between;
use super::search::shown;
use crate::contacts::{Meets, still};
use crate::found::cells::peak;
use crate::found::grid::Role;
use crate::read::view::View;

/// All deformable blocks that can come together with others; none where found contact is off. A block counts as deep as its centre lies
/// below its surface. How long steps may be is left open ([`Meets::step`] is infinite): their own waves are faster as a rule.
#[must_use]
pub fn outlook(view: &View<'_>) -> Vec<Meets> {
    let View { world, scratch } = view;
    let (Some(deform), Some(work)) = (world.deform.as_deref(), scratch.deform.as_deref()) else {
        return Vec::new();
    };
    let roles = &world.found.deformable.roles;
    // One block of each material and kind stands for all, as in `check`.
    let count = world.setup.materials.len();
    let mut partner = vec![[None; 2]; count];
    for b in (0..world.alive.len()).filter(|b| world.alive[*b]) {
        let material = usize::from(world.setup.blocks[b].material);
        partner[material][usize::from(world.deforms(b))].get_or_insert(b as u32);
    }
    let still = still(world);
    let seekers = (0..roles.len()).filter(|b| roles[*b] == Role::Seeker);
    let seekers = seekers.filter_map(|b| Some((b, deform.body(b)?)));
    seekers
        .filter_map(|(b, body)| {
            let solid = world.solid_of(b);
            let class = work.class(body);
            let depth = peak(&class.mesh);
            let own = usize::from(world.setup.blocks[b].material);
            let partners = partner.iter().enumerate().flat_map(|(material, of)| {
                let kinds = of.iter().enumerate();
                kinds.filter_map(move |(deforms, other)| Some((material, deforms, (*other)?)))
            });
            let laws = partners.filter_map(|(material, deforms, other)| {
                let rigid = [false, deforms == 0];
                let law = between(&world.setup, [b as u32, other], rigid, [depth; 2]).ok()?;
                let row = world.setup.pair_table[own * count + material];
                Some((row, law.normal_stiffness))
            });
            let (row, stiffness) = laws.min_by(|a, b| a.1.total_cmp(&b.1))?;
            let nodes = deform.nodes.velocity[body.nodes()].iter();
            let speeds = nodes.map(|v| (Vec3::from_array(*v) - still).length());
            let density = world.setup.materials[own].density;
            Some(Meets {
                block: b as u32,
                row,
                stiffness,
                inradius: depth,
                size: libm::cbrt(solid.mass / density),
                mass: solid.mass,
                face: shown(class).1,
                speed: speeds.fold(0.0, f64::max),
                step: f64::INFINITY,
            })
        })
        .collect()
}
