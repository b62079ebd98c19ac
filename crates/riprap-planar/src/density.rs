//! The density of a material that changes in the midst of a run: weight and inertia follow, velocities stay.
//!
//! Momentum and kinetic energy change with the mass: that is the work of who changes the material, an edit.

use super::world::World;

/// Gives the living blocks of a material another density (kg/m3); those whose mass the scene gives keep it. Evaluate anew afterwards with scratch data that are
/// laid out anew.
pub fn change(world: &mut World, row: u16, density: f64) {
    let Some(of_row) = world.setup.densities.get_mut(usize::from(row)) else { return };
    let before = std::mem::replace(of_row, density);
    let blocks = world.setup.blocks.iter_mut().zip(&world.alive);
    for (block, _) in blocks.filter(|(block, alive)| **alive && block.material == row) {
        if block.density.to_bits() == before.to_bits() {
            block.density = density;
        }
    }
}
