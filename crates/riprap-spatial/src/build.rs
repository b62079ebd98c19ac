//! From plain data to a world: mass properties, patches between blocks, free faces.

pub(crate) mod layout;

pub use crate::joint::classes::ClassTable;
pub use crate::setup::error::BuildError;

use crate::faces::overlap::GAP;
use crate::state::lineage::name;
use std::collections::BTreeMap;

use riprap_geom::polyhedron::Polyhedron;
use riprap_geom::{Mat3, Vec3};

use crate::accounts::Account;
use crate::contact;
use crate::deform;
use crate::exec::Exec;
use crate::faces::overlap;
use crate::faces::overlap::Overlap;
use crate::faces::region::Bounds;
use crate::failed::FailedPoints;
use crate::ledger::{Left, Works};
use crate::push::boundary;
use crate::push::charge;
use crate::setup::{GivenBody, Motion, Setup, Shape, Solid};
use crate::state::bodies::{Bodies, SolidClass};
use crate::state::cavity::{Cavity, Wall};
use crate::state::face::Face;
use crate::state::found::FoundContacts;
use crate::state::interface::Origin;
use crate::state::lineage;
use crate::state::patches::Patches;
use crate::state::scratch::Scratch;
use crate::state::world::World;
use crate::topology::refine;

impl World {
    /// A world at rest at time zero, with patches and boundaries built; the scratch data come with it.
    ///
    /// # Errors
    /// A block without volume, a stiffness without modulus, a boundary without faces, a source without blocks.
    pub fn new(setup: Setup, exec: Exec) -> Result<(Self, Scratch), BuildError> {
        let mut setup = setup;
        contact::glued::check(&setup, |b| name(&setup, &[], b))?;
        let lineage = refine::before_run(&mut setup)?;
        let n = setup.blocks.len();
        let mut alive = vec![true; n];
        for origin in lineage.iter().filter(|o| o.parent != lineage::Origin::NONE) {
            alive[origin.parent as usize] = false;
        }
        let mut world = Self {
            gravity: setup.gravity,
            water: None,
            seepage: None,
            gas: None,
            time: 0.0,
            step: 0,
            last_dt: 0.0,
            pending: 0.0,
            fresh: true,
            bodies: Bodies::at_rest(n),
            reference: Vec::with_capacity(n),
            datum: Vec::new(),
            node_datum: Vec::new(),
            solid: Vec::with_capacity(n),
            solids: Vec::new(),
            turned: vec![None; n],
            alive,
            lineage,
            motion: vec![None; n],
            peak_speed_squared: vec![0.0; n],
            patches: Patches::default(),
            classes: Vec::new(),
            faces: Vec::new(),
            overruled: Vec::new(),
            cavities: Vec::new(),
            bolts: Vec::new(),
            deform: None,
            found: FoundContacts::default(),
            implicit: None,
            failed: FailedPoints::default(),
            last_check_step: 0,
            events: Vec::new(),
            works: Works::default(),
            left: Left::default(),
            accounts: vec![Account::default(); setup.accounts.len()],
            start_energy: None,
            setup,
        };
        world.find_solids()?;
        world.deform = deform::build::bodies(&world)?.map(Box::new);
        for (b, block) in world.setup.blocks.iter().enumerate() {
            world.bodies.set_velocity(b, block.velocity, block.spin);
        }
        for support in &world.setup.supports {
            for &b in &support.blocks {
                world.motion[b as usize] = Some(Box::new(support.motion.clone()));
            }
        }
        world.hold_terrain();
        if world.setup.found_contacts && (0..n).any(|b| world.is_terrain(b)) {
            world.found.left_terrain = vec![false; n];
        }
        world.hold_driven();
        let charges = charge::charges(&world.setup, &world.lineage, &world.alive)?;
        world.build_patches(&charges)?;
        contact::check(&world)?;
        crate::contact::deformable::check(&world)?;
        let scratch = Scratch::new(&mut world, exec);
        Ok((world, scratch))
    }

    /// Name of a block, as `rock`, `rock.17` or `rock.17/3`.
    #[must_use]
    pub fn name(&self, b: usize) -> String {
        name(&self.setup, &self.lineage, b)
    }

    /// Reference centroids and mass properties of all blocks.
    fn find_solids(&mut self) -> Result<(), BuildError> {
        let mut known: BTreeMap<[u64; 4], u32> = BTreeMap::new();
        for b in 0..self.setup.blocks.len() {
            let block = &self.setup.blocks[b];
            let density = self.setup.materials[block.material as usize].density;
            let (centre, class) = solid(&block.shape, density).map_err(|reason| {
                let block = self.name(b);
                BuildError::Shape { block, reason }
            })?;
            self.reference.push(centre);
            let given = self.setup.bodies.iter().find(|g| g.block as usize == b);
            let class = given.map_or(class, |given| own_body(class, given));
            let key = block.shape.key(density.to_bits()).filter(|_| given.is_none());
            let index = key.and_then(|k| known.get(&k).copied());
            let index = index.unwrap_or_else(|| {
                self.solids.push(class);
                let index = self.solids.len() as u32 - 1;
                if let Some(key) = key {
                    known.insert(key, index);
                }
                index
            });
            self.solid.push(index);
        }
        Ok(())
    }

    /// Terrain stays where it is, whatever supports say.
    pub(super) fn hold_terrain(&mut self) {
        for b in 0..self.setup.blocks.len() {
            if self.is_terrain(b) {
                self.motion[b] =
                    Some(Box::new(Motion::Fixed { translation: [true; 3], rotation: [true; 3] }));
            }
        }
    }

    /// Shortest half edge of a living block, m.
    #[must_use]
    pub fn finest(&self) -> f64 {
        let living = (0..self.alive.len()).filter(|b| self.alive[*b] && !self.is_terrain(*b));
        living.map(|b| self.solid_of(b).half.min_element()).fold(f64::INFINITY, f64::min)
    }

    /// Builds patches, free faces and walls of cavities of all living blocks, without history; the blocks of
    /// `charges` (one list per source) go.
    fn build_patches(&mut self, charges: &[Vec<u32>]) -> Result<(), BuildError> {
        let finest = self.finest();
        let tolerance = GAP * finest;
        let living = (0..self.alive.len()).filter(|b| self.alive[*b] && !self.is_terrain(*b));
        let living: Vec<u32> = living.map(|b| b as u32).collect();
        // With the blocks of charges: what they share with others becomes the walls of cavities.
        let (overlaps, faces) = overlap::touching(self, &living, tolerance);
        let mut owner: BTreeMap<u32, usize> = BTreeMap::new();
        for (k, blocks) in charges.iter().enumerate() {
            for &b in blocks {
                owner.insert(b, k);
                self.alive[b as usize] = false;
                if let Some(deform) = self.deform.as_deref_mut() {
                    deform.retire(b);
                }
            }
        }
        let mut walls: Vec<Vec<Wall>> = vec![Vec::new(); charges.len()];
        let mut deformable = Vec::new();
        let mut table = ClassTable::new(self, finest);
        let mut joined = Vec::new();
        for overlap in overlaps {
            let deforms = overlap.blocks.iter().any(|&b| self.deforms(b as usize));
            match overlap.blocks.map(|b| owner.get(&b)) {
                [None, None] if deforms => joined.push(overlap),
                [None, None] => self.add_patch(&mut table, &overlap)?,
                [Some(_), Some(_)] => {}
                [Some(&k), None] | [None, Some(&k)] => {
                    let side = usize::from(owner.contains_key(&overlap.blocks[0]));
                    if self.deforms(overlap.blocks[side] as usize) {
                        deformable.push(deform::build::NodalWall {
                            source: k as u16,
                            block: overlap.blocks[side],
                            normal: if side == 0 { overlap.frame[0] } else { -overlap.frame[0] },
                            arm: overlap.arms[side],
                        });
                    } else {
                        walls[k].push(Wall::new(&self.setup, &self.reference, &overlap, side));
                    }
                }
            }
        }
        self.patches.sort(&self.classes);
        let living = |f: &Face| self.alive[f.block as usize];
        self.faces = faces.into_iter().filter(living).collect();
        self.faces.shrink_to_fit();
        self.faces.sort_by_key(|f| f.block);
        boundary::assign(self, tolerance)?;
        let faces = std::mem::take(&mut self.faces);
        self.faces = deform::build::finish(self, &joined, faces, &deformable)?;
        for (source, (blocks, walls)) in charges.iter().zip(walls).enumerate() {
            let cavity = Cavity::new(self, source, blocks.clone(), walls)?;
            self.cavities.push(cavity);
        }
        Ok(())
    }

    /// Appends a patch; `Patches::sort` puts it in its place later.
    ///
    /// # Errors
    /// A stiffness without modulus.
    pub fn add_patch(
        &mut self,
        table: &mut ClassTable,
        overlap: &Overlap,
    ) -> Result<(), BuildError> {
        let class = table.class_of(self, overlap)?;
        let k = &self.classes[class as usize];
        if let Some(in_situ) = &self.setup.in_situ {
            let centre = self.reference[overlap.blocks[0] as usize] + k.arms[0];
            let stress = in_situ.at(centre.z);
            self.patches.prestress.push(stress * k.frame[0]);
        }
        let joint = &self.setup.interfaces[k.row as usize].joint;
        let remembers = !joint.behaviour.is_plain();
        let strength = joint.strength;
        self.patches.ends.push(overlap.blocks);
        self.patches.class.push(class);
        self.patches.flags.push(0);
        if !self.patches.origin.is_empty() {
            self.patches.origin.push(Origin::Built);
        }
        // Such lists are there for all patches or for none.
        if strength.is_some() || !self.patches.slip.is_empty() {
            self.patches.need_slip();
        }
        if !self.patches.normal_offset.is_empty() {
            self.patches.need_normal_offset();
        }
        if remembers || !self.patches.wear.is_empty() {
            self.patches.need_wear();
        }
        Ok(())
    }
}

/// A class with the mass and the inertia that are given.
fn own_body(class: SolidClass, given: &GivenBody) -> SolidClass {
    let [x, y, z] = given.inertia.to_cols_array_2d();
    SolidClass {
        mass: given.mass,
        inertia: given.inertia,
        inverse: given.inertia.inverse(),
        diagonal: [x[1], x[2], y[0], y[2], z[0], z[1]] == [0.0; 6],
        ..class
    }
}

/// Centroid and mass properties of a shape.
fn solid(shape: &Shape, density: f64) -> Result<(Vec3, SolidClass), String> {
    match shape {
        Shape::Brick { centre, half } => {
            if !(half.min_element() > 0.0 && half.is_finite() && centre.is_finite()) {
                return Err(format!("the half lengths of its edges are {half} m"));
            }
            let volume = 8.0 * half.x * half.y * half.z;
            let mass = density * volume;
            let square = *half * *half;
            let inertia = mass / 3.0
                * Vec3::new(square.y + square.z, square.z + square.x, square.x + square.y);
            let class = SolidClass {
                mass,
                volume,
                inertia: Mat3::from_diagonal(inertia),
                inverse: Mat3::from_diagonal(inertia.recip()),
                half: *half,
                radius: half.length(),
                diagonal: true,
            };
            Ok((*centre, class))
        }
        Shape::Polyhedron(solid) => {
            let body = solid.polyhedron();
            body.validate().map_err(|e| e.to_string())?;
            Ok(SolidClass::bounded_by(&body, density, None))
        }
        // Integrals over glued faces cancel.
        Shape::Glued(parts) => {
            for part in parts {
                part.polyhedron().validate().map_err(|e| e.to_string())?;
            }
            Ok(SolidClass::bounded_by(&Solid::all(parts).polyhedron(), density, None))
        }
        Shape::Terrain(surface) => {
            let bounds = Bounds::of(shape);
            let body = surface.body();
            let body = Polyhedron { vertices: body.vertices, faces: body.faces };
            let volume = body.moments().volume;
            // Nothing moves it; mass and inertia are there to be finite.
            let mass = density * volume;
            let inertia = mass * bounds.half.length_squared();
            let class = SolidClass {
                mass,
                volume,
                inertia: Mat3::from_diagonal(Vec3::splat(inertia)),
                inverse: Mat3::from_diagonal(Vec3::splat(1.0 / inertia)),
                half: bounds.half,
                radius: bounds.half.length(),
                diagonal: true,
            };
            Ok((bounds.centre, class))
        }
    }
}
