//! What of a model an implicit phase cannot take yet.

use crate::state::world::World;

/// Something that implicit phases do not take, and what to do instead.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Obstacle {
    /// What, with the name of one of its kind.
    pub what: String,
    /// The remedy besides an explicit phase.
    pub remedy: &'static str,
}

/// The first thing of a model that an implicit phase does not take.
#[must_use]
pub fn obstacle(world: &World) -> Option<Obstacle> {
    let found = |what: String, remedy: &'static str| Some(Obstacle { what, remedy });
    let living = || (0..world.alive.len()).filter(|b| world.alive[*b]);
    let first = |is: &dyn Fn(usize) -> bool| living().find(|b| is(*b)).map(|b| world.name(b));
    if let Some(name) = first(&|b| world.deforms(b)) {
        return found(format!("block `{name}` is deformable"), "make its set of blocks rigid");
    }
    if !world.setup.found_contacts {
        let what = "contact detection is switched off (`space.spatial.found_contacts`)";
        return found(what.to_owned(), "switch it on");
    }
    if let Some(row) = world.setup.interfaces.iter().find(|row| row.joint.stiffening > 0.0) {
        let what = format!("contacts of `interfaces.{}` stiffen (`stiffening_depth`)", row.name);
        return found(what, "leave out `stiffening_depth`");
    }
    if let Some(source) = world.setup.sources.first() {
        return found(format!("source `{}` pushes from a cavity", source.name), "remove it");
    }
    None
}
