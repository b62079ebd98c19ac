//! Adding a block to a model that is running.

use super::Engine;
use crate::record::field::nearest;
use crate::{Vec2, Vec3};
use crate::{planar, spatial};

/// A rigid block that code adds, in the coordinates of the scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NewBlock {
    /// A name that no block and no group has.
    pub name: String,
    /// Name of a material.
    pub material: String,
    /// Names of groups that it joins. Their fields and what code does with their names have it from then on; supports, loads and phases of the scene keep the
    /// blocks that they had.
    pub groups: Vec<String>,
    /// Corners, m: in space of a convex solid, in the plane, with z = 0, of a polygon.
    pub vertices: Vec<[f64; 3]>,
    /// Corners of each face, in space alone; the convex hull of the corners without any.
    pub faces: Vec<Vec<u32>>,
    /// Of the centroid, m/s; in the plane with z = 0.
    pub velocity: [f64; 3],
    /// rad/s; in the plane about z alone.
    pub spin: [f64; 3],
}

/// A block that has been looked at and can be added.
#[derive(Clone, Debug)]
pub(in crate::run) enum Addition {
    /// In the plane.
    Planar(planar::addition::Addition),
    /// In space.
    Spatial(Box<spatial::topology::add::Addition>),
}

impl Addition {
    /// kg; in the plane kg/m.
    pub(in crate::run) fn mass(&self) -> f64 {
        either!(self, addition => addition.mass())
    }
}

/// A bolt that code installs, in local coordinates.
#[derive(Clone, Debug)]
pub(in crate::run) enum NewBolt {
    /// In the plane.
    Planar(planar::setup::Bolt),
    /// In space.
    Spatial(spatial::setup::Bolt),
}

/// Number of a name among others.
fn number<'a>(
    what: &str,
    name: &str,
    known: impl Iterator<Item = &'a str> + Clone,
) -> Result<u16, String> {
    let at = known.clone().position(|one| one == name);
    at.map(|k| k as u16).ok_or_else(|| {
        let near = nearest(name, known).map_or(String::new(), |n| format!("; did you mean {n:?}?"));
        format!("there is no {what} {name:?}{near}")
    })
}

/// The two components in the plane.
fn flat(what: &str, [x, y, z]: [f64; 3]) -> Result<Vec2, String> {
    match z == 0.0 {
        true => Ok(Vec2::new(x, y)),
        false => Err(format!("{what} has a third component of {z}, but the model is in the plane")),
    }
}

impl Engine {
    /// Looks at a block that is to be added in the present state.
    ///
    /// # Errors
    /// What is wrong with it, in words.
    pub(in crate::run) fn plan_block(&self, new: &NewBlock) -> Result<Addition, String> {
        let numbers = [("velocity", &new.velocity), ("spin", &new.spin)];
        if let Some((what, _)) = numbers.iter().find(|(_, v)| v.iter().any(|x| !x.is_finite())) {
            return Err(format!("its {what} is not finite"));
        }
        let groups = self.groups();
        let names = groups.iter().map(|(name, _)| *name);
        let found = new.groups.iter().map(|group| number("group", group, names.clone()));
        let mut joined = found.collect::<Result<Vec<u16>, String>>()?;
        joined.sort_unstable();
        joined.dedup();
        if self.exec().peers().is_some() {
            return Err("the model is shared out among ranks; run it on one".to_owned());
        }
        match self {
            Self::Planar(e) => {
                let materials = e.world.setup.materials.iter().map(String::as_str);
                let material = number("material", &new.material, materials)?;
                if !new.faces.is_empty() {
                    return Err(
                        "a polygon has no `faces`, and the model is in the plane".to_owned()
                    );
                }
                let origin = Vec2::from(e.world.setup.origin);
                let corners = new.vertices.iter().enumerate();
                let local = corners.map(|(k, v)| Ok(flat(&format!("vertex {k}"), *v)? - origin));
                let [x, y, turning] = new.spin;
                if [x, y] != [0.0; 2] {
                    return Err("its spin is not about z, but the model is in the plane".to_owned());
                }
                let block = planar::addition::NewBlock {
                    name: new.name.clone(),
                    vertices: local.collect::<Result<_, String>>()?,
                    material,
                    velocity: flat("its velocity", new.velocity)?,
                    spin: turning,
                    groups: joined,
                };
                let planned = planar::addition::Addition::plan(&e.view(), block);
                planned.map(Addition::Planar).map_err(|wrong| wrong.to_string())
            }
            Self::Spatial(e) => {
                let setup = &e.world.setup;
                let materials = setup.materials.iter().map(|m| m.name.as_str());
                let local = new.vertices.iter().map(|v| Vec3::from(*v) - setup.origin);
                let block = spatial::topology::add::NewBlock {
                    name: new.name.clone(),
                    solid: spatial::setup::Solid {
                        vertices: local.collect(),
                        faces: new.faces.clone(),
                    },
                    material: number("material", &new.material, materials)?,
                    velocity: new.velocity.into(),
                    spin: new.spin.into(),
                    groups: joined,
                };
                let planned = spatial::topology::add::Addition::plan(&e.view(), block);
                planned
                    .map(|one| Addition::Spatial(Box::new(one)))
                    .map_err(|wrong| wrong.to_string())
            }
        }
    }

    /// Adds a block that was looked at in this state; forces must be re-evaluated afterwards.
    pub(in crate::run) fn add_block(&mut self, addition: Addition) {
        match (self, addition) {
            (Self::Planar(e), Addition::Planar(block)) => {
                block.apply(&mut e.world, &mut e.scratch);
                e.world.last_dt = 0.0;
            }
            (Self::Spatial(e), Addition::Spatial(block)) => {
                block.apply(&mut e.world);
                e.world.last_dt = 0.0;
                e.scratch.invalidate(&mut e.world);
            }
            (Self::Planar(_), Addition::Spatial(_)) | (Self::Spatial(_), Addition::Planar(_)) => {
                unreachable!("a block is added to the engine that has looked at it")
            }
        }
    }

    /// Enters a bolt, which is installed later; the next number is its own.
    pub(in crate::run) fn add_bolt(&mut self, bolt: NewBolt) {
        match (self, bolt) {
            (Self::Planar(e), NewBolt::Planar(bolt)) => e.world.setup.bolts.push(bolt),
            (Self::Spatial(e), NewBolt::Spatial(bolt)) => e.world.setup.bolts.push(bolt),
            (Self::Planar(_), NewBolt::Spatial(_)) | (Self::Spatial(_), NewBolt::Planar(_)) => {
                unreachable!("a bolt is read for the engine that takes it")
            }
        }
    }

    /// Blocks of a material.
    pub(in crate::run) fn of_material(&self, name: &str) -> Option<Vec<u32>> {
        let (materials, of): (Vec<&str>, Vec<u16>) = match self {
            Self::Planar(e) => {
                let setup = &e.world.setup;
                let names = setup.materials.iter().map(String::as_str).collect();
                (names, setup.blocks.iter().map(|b| b.material).collect())
            }
            Self::Spatial(e) => {
                let setup = &e.world.setup;
                let names = setup.materials.iter().map(|m| m.name.as_str()).collect();
                (names, setup.blocks.iter().map(|b| b.material).collect())
            }
        };
        let at = materials.iter().position(|one| *one == name)? as u16;
        Some((0..).zip(of).filter(|(_, m)| *m == at).map(|(b, _)| b).collect())
    }
}
