//! Classes of patches: geometry and stiffness that many patches share.

use std::collections::BTreeMap;

use riprap_geom::Vec3;

use crate::faces::overlap::Overlap;
use crate::setup::error::BuildError;
use crate::setup::{Setup, Stiffness, StiffnessRule};
use crate::state::patches::PatchClass;
use crate::state::world::World;

/// Lengths are rounded to this share of the shortest half edge, so that equal patches are equal bits.
const ROUNDING: f64 = 1.0 / (1u64 << 34) as f64;

/// Finds the class of a patch among those there are, or adds it.
pub struct ClassTable {
    quantum: f64,
    known: BTreeMap<[i64; 23], u32>,
}

impl ClassTable {
    /// A table for the classes of `world`; `finest` is the shortest half edge, m.
    #[must_use]
    pub fn new(world: &World, finest: f64) -> Self {
        let mut table = Self {
            // A power of two leaves dyadic lengths as they are.
            quantum: libm::exp2(libm::log2(finest).floor()) * ROUNDING,
            known: BTreeMap::new(),
        };
        for (k, class) in world.classes.iter().enumerate() {
            let (arms, laws) = (&class.arms, (class.materials, class.row));
            let key = table.key(&class.frame, arms, class.area, class.half_spacing, laws);
            table.known.insert(key, k as u32);
        }
        table
    }

    fn round(&self, length: f64) -> f64 {
        (length / self.quantum).round() * self.quantum
    }

    fn key(
        &self,
        frame: &[Vec3; 3],
        arms: &[Vec3; 2],
        area: f64,
        half_spacing: [f64; 2],
        (materials, row): ([u16; 2], u16),
    ) -> [i64; 23] {
        let mut key = [0; 23];
        let lengths = arms.iter().flat_map(Vec3::to_array).chain(half_spacing);
        let units = frame.iter().flat_map(Vec3::to_array);
        let numbers = lengths
            .map(|x| (x / self.quantum).round())
            .chain(units.map(|x| (x / ROUNDING).round()))
            .chain([(area / (self.quantum * half_spacing[0].max(half_spacing[1]))).round()]);
        for (slot, number) in key.iter_mut().zip(numbers) {
            *slot = number as i64;
        }
        key[20] = i64::from(materials[0]);
        key[21] = i64::from(materials[1]);
        key[22] = i64::from(row);
        key
    }

    /// Index of the class of a patch.
    ///
    /// # Errors
    /// A stiffness without modulus.
    pub fn class_of(&mut self, world: &mut World, overlap: &Overlap) -> Result<u32, BuildError> {
        let setup = &world.setup;
        let materials = overlap.blocks.map(|b| setup.blocks[b as usize].material as usize);
        let centre = world.reference[overlap.blocks[0] as usize] + overlap.arms[0];
        let row = setup.row_at(materials, centre, overlap.frame[0]);
        let joint = &setup.interfaces[row as usize].joint;
        let arms = overlap.arms.map(|a| a.to_array().map(|x| self.round(x)).into());
        // Four equal points at this distance have the exact second moments of the part.
        let spread = joint.points.spread();
        let half_spacing = overlap.gyration.map(|g| spread * g);
        let pair = materials.map(|m| m as u16);
        let key = self.key(&overlap.frame, &arms, overlap.area, half_spacing, (pair, row));
        if let Some(&class) = self.known.get(&key) {
            return Ok(class);
        }
        let n = overlap.frame[0];
        let depths = [arms[0].dot(n), -arms[1].dot(n)];
        let (stiffness, travel) = stiffness(setup, row, materials, depths)?;
        let slope = setup.in_situ.map_or([[0.0; 3]; 2], |in_situ| {
            let upward = in_situ.upward() * n;
            [overlap.frame[1], overlap.frame[2]].map(|along: Vec3| {
                let traction = upward * along.z / (spread * spread);
                overlap.frame.map(|e| traction.dot(e))
            })
        });
        world.classes.push(PatchClass {
            frame: overlap.frame,
            area: overlap.area,
            half_spacing,
            arms,
            stiffness,
            beta: joint.damping * travel,
            materials: pair,
            row,
            axis: overlap.axis,
            distance: depths[0] + depths[1],
            slope,
        });
        let class = world.classes.len() as u32 - 1;
        self.known.insert(key, class);
        Ok(class)
    }
}

/// Normal and shear stiffness (Pa/m) of a patch between materials, with the depths (m) of the blocks
/// behind it, and the time a P wave takes from centroid to centroid, s.
///
/// Half-block compliances in series: `1/Kn = h1/M1 + h2/M2`, `1/Ks = h1/2G1 + h2/2G2`; for equal
/// materials `Kn = M/d`, `Ks = 2G/d`, which give the right wave speeds along the axes of a lattice
/// whose blocks turn.
pub(crate) fn stiffness(
    setup: &Setup,
    row: u16,
    materials: [usize; 2],
    depths: [f64; 2],
) -> Result<([f64; 2], f64), BuildError> {
    let sides = [0, 1].map(|k| (&setup.materials[materials[k]], depths[k]));
    let series = |modulus: &dyn Fn(usize) -> Option<f64>| -> Result<f64, BuildError> {
        let mut compliance = 0.0;
        for (k, (material, depth)) in sides.iter().enumerate() {
            let modulus = modulus(k).ok_or_else(|| BuildError::NoModulus {
                material: material.name.clone(),
                need: "the stiffness of its joints",
            })?;
            compliance += depth / modulus;
        }
        Ok(1.0 / compliance)
    };
    let shear = |k: usize| sides[k].0.shear_modulus().map(|g| 2.0 * g);
    let stiffness = match setup.interfaces[row as usize].joint.stiffness {
        Stiffness::Given { normal, shear } => [normal, shear],
        Stiffness::Rule(StiffnessRule::Material) => {
            [series(&|k| sides[k].0.constrained_modulus())?, series(&shear)?]
        }
        Stiffness::Rule(StiffnessRule::Uniaxial) => {
            [series(&|k| sides[k].0.young)?, series(&shear)?]
        }
    };
    let closure = &setup.interfaces[row as usize].joint.behaviour.closure;
    let stiffness = [stiffness[0] * closure.stiffest(), stiffness[1]];
    let mut travel = 0.0;
    for (material, depth) in sides {
        let distance: f64 = depths.iter().sum();
        let modulus = material.constrained_modulus().unwrap_or(stiffness[0] * distance);
        travel += depth * (material.density / modulus).sqrt();
    }
    Ok((stiffness, travel))
}
