//! Cavities: charges and other pressures that push on the faces around removed blocks.
//!
//! The finest blocks that touch a charge are taken out when the model is built. Faces they shared with others are walls:
//! area A, normal n out of the block, arm r. Until the charge goes off a wall carries the in-situ traction that the charge
//! carried; from then on the pressure alone.
//!
//! Volume and force are conjugate: `V = V0 - f sum A n.(u + th x r)` and a force `-P f A n` at the centre of each wall,
//! so that the work on the blocks is `P dV`. Gas work is booked as the analytic integral of its adiabat; what the
//! leapfrog makes of it differs by its error, which shows in the residual. With small rotations normals keep the direction of the start; walls
//! of blocks with finite rotations turn with them (`walls::follow`). On deformable
//! blocks a wall is a set of nodes with their shares of the area (`walls`).
//!
//! Source: Tian & Li, eqs. (19)-(22) and assumption 1 (the charge turns to gas at once). Deviation: the coupling of
//! volume and faces, and the limit of the time step, are ours; the source gives none.

pub(crate) mod hole;
pub mod walls;

pub use crate::setup::error::{CavityError, ChargeError};
use riprap_geom::Vec3;
use riprap_geom::polyhedron::frame;

use crate::faces::overlap::Overlap;
use crate::faces::region::Extent;
use crate::laws::explosive::Adiabat;
use crate::push::gas;
use crate::setup::{CavityPressure, Coupling, Place, Region, Setup, Source, Venting};
pub use crate::state::cavity::{Burn, Cavity, Column, Gas, NodalWalls, TurnedWall, Wall};
use crate::state::lineage::Origin;
use crate::state::world::World;

/// Share of the period (over 2 pi) of the gas spring that a step may take: with 0.1 the energy budget closes to 0.1 % of
/// the gas work in the refined models of the tests and to 0.5 % in the unrefined one; the error is made in the first steps
/// of the expansion.
pub const GAS_STEP: f64 = 0.1;
/// A share of the last step by which an ignition may be early: times are sums of steps.
pub(crate) const EARLY: f64 = 1e-9;
/// Blocks are equally fine when their volumes differ by less than this share: cells that are fitted to one hole do so by a thousandth, and halving
/// the edges of a brick makes an eighth of it.
pub const EQUAL: f64 = 0.01;

impl Wall {
    /// The wall of an overlap whose block number `side` (0 or 1) stays.
    #[must_use]
    pub fn new(setup: &Setup, reference: &[Vec3], overlap: &Overlap, side: usize) -> Self {
        let [n, b, c] = overlap.frame;
        let block = overlap.blocks[side];
        let arm = overlap.arms[side];
        let outward = if side == 0 { n } else { -n };
        let (mut hold, mut hold_moment) = (Vec3::ZERO, Vec3::ZERO);
        if let Some(in_situ) = &setup.in_situ {
            // As in a patch: four points at the radii of gyration give the exact force
            // and moment of a traction that is linear over the face.
            for (s, t) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                let at = arm + s * overlap.gyration[0] * b + t * overlap.gyration[1] * c;
                let height = reference[block as usize].z + at.z;
                let force = 0.25 * overlap.area * (in_situ.at(height) * outward);
                hold += force;
                hold_moment += at.cross(force);
            }
        }
        Self {
            block,
            behind: overlap.blocks[1 - side],
            normal: outward,
            area: overlap.area,
            arm,
            hold,
            hold_moment,
            turned: None,
            after: 0.0,
        }
    }

    /// Finds when the detonation of its source reaches it; its centre at the start (m).
    pub(crate) fn wait_for(&mut self, source: &Source, centre: Vec3) {
        if let (Some(detonation), Place::Line { from, to }) =
            (source.hole.detonation, &source.place)
        {
            let along = *to - *from;
            let depth = ((centre - *from).dot(along) / along.length()).clamp(0.0, along.length());
            self.after = (depth - detonation.primer).abs() / detonation.velocity;
        }
    }

    /// Its unit outward normal and its area (m²) for the gas now.
    #[must_use]
    pub fn now(&self) -> (Vec3, f64) {
        match &self.turned {
            Some(turned) => (turned.normal, turned.area),
            None => (self.normal, self.area),
        }
    }
}

/// Blocks that each source removes, ascending.
///
/// # Errors
/// A source outside the model, two sources on one block.
pub fn charges(
    setup: &Setup,
    lineage: &[Origin],
    alive: &[bool],
) -> Result<Vec<Vec<u32>>, CavityError> {
    let mut taken: Vec<(u32, usize)> = Vec::new();
    let mut all = Vec::with_capacity(setup.sources.len());
    for (k, source) in setup.sources.iter().enumerate() {
        let blocks = match &source.place {
            Place::Point { centre } => finest(setup, alive, &Region::Point(*centre)),
            Place::Line { from, to } => finest(setup, alive, &Region::Line(*from, *to)),
            Place::Blocks { blocks } => {
                let living = blocks.iter().copied().filter(|b| alive[*b as usize]);
                living.collect()
            }
        };
        if blocks.is_empty() {
            let name = source.name.clone();
            return Err(CavityError::NoBlock { name });
        }
        for &b in &blocks {
            if let Some((_, other)) = taken.iter().find(|(block, _)| *block == b) {
                return Err(CavityError::Shared {
                    name: source.name.clone(),
                    other: setup.sources[*other].name.clone(),
                    block: crate::state::lineage::name(setup, lineage, b as usize),
                });
            }
        }
        taken.extend(blocks.iter().map(|&b| (b, k)));
        all.push(blocks);
    }
    Ok(all)
}

/// Living blocks that touch the region, only the smallest of them.
fn finest(setup: &Setup, alive: &[bool], region: &Region) -> Vec<u32> {
    let mut touching: Vec<(u32, f64)> = Vec::new();
    for (b, block) in setup.blocks.iter().enumerate() {
        if alive[b] {
            let extent = Extent::of(&block.shape);
            if extent.touches(region) && !block.shape.is_terrain() {
                touching.push((b as u32, extent.volume()));
            }
        }
    }
    let smallest = touching.iter().map(|t| t.1).fold(f64::INFINITY, f64::min);
    touching.iter().filter(|t| t.1 <= (1.0 + EQUAL) * smallest).map(|t| t.0).collect()
}

impl Cavity {
    /// The cavity of source number `source` after its blocks are gone.
    ///
    /// # Errors
    /// No walls, no free face above for venting by heave, constants that make no adiabat.
    pub fn new(
        world: &World,
        source: usize,
        blocks: Vec<u32>,
        mut walls: Vec<Wall>,
    ) -> Result<Self, CavityError> {
        let what = &world.setup.sources[source];
        let name = || what.name.clone();
        let nodal = NodalWalls::of(world, source as u16);
        if walls.is_empty() && nodal.area == 0.0 {
            return Err(CavityError::NoWall { name: name() });
        }
        // So that the walls of a block stand together, see `mobility`.
        walls.sort_by_key(|w| w.block);
        for wall in &mut walls {
            wall.wait_for(what, world.reference[wall.block as usize] + wall.arm);
        }
        let removed = blocks.iter().map(|&b| world.solid_of(b as usize).volume).sum();
        let (gas, venting) = match &what.push {
            CavityPressure::Pressure { .. } => (None, None),
            CavityPressure::Gas { explosive, mass, coupling, venting } => {
                let adiabat = explosive.adiabat(*mass).map_err(|reason| {
                    let name = name();
                    CavityError::Explosive { name, reason }
                })?;
                (Some(Gas::new(adiabat, removed, *coupling)), *venting)
            }
        };
        let mut cavity = Self {
            source: source as u16,
            blocks,
            removed,
            walls,
            ignited: None,
            venting: None,
            base: 0.0,
            volume: gas.map_or(removed, |g| g.start),
            pressure: 0.0,
            kept: 1.0,
            known: 0.0,
            work: 0.0,
            held: 0.0,
            above: Vec::new(),
            nodal,
            gas,
            burn: what.burn(),
            column: what.hole.stemming.map(|_| Column::default()),
        };
        if cavity.burn.is_some() {
            cavity.kept = 0.0;
        }
        if matches!(venting, Some(Venting::Heave { .. })) {
            cavity.above = cavity.surface(world);
            if cavity.above.is_empty() {
                return Err(CavityError::NoSurface { name: name() });
            }
        }
        Ok(cavity)
    }

    /// What the walls carry now: block, present arm (m), force (N).
    pub fn forces<'a>(
        &'a self,
        world: &'a World,
    ) -> impl Iterator<Item = (usize, Vec3, Vec3)> + 'a {
        let factor = self.gas.map_or(1.0, |g| g.factor);
        let freedoms = world.all_freedoms();
        self.walls.iter().map(move |wall| {
            let force = if self.holds(wall) {
                wall.hold
            } else {
                let (normal, area) = wall.now();
                -self.pressure * factor * area * normal
            };
            (wall.block as usize, freedoms.arm(wall.block, wall.arm), force)
        })
    }

    /// Whether the detonation has been at a wall; at all of them where the charge turns to gas at once.
    pub(crate) fn reached(&self, wall: &Wall) -> bool {
        self.burn.is_none_or(|burn| wall.after <= burn.reached)
    }

    /// Whether a wall still carries what the charge carried.
    pub(crate) fn holds(&self, wall: &Wall) -> bool {
        self.ignited.is_none() || !self.reached(wall)
    }

    /// Volume of the charge V0, m³; that of the removed blocks for a pressure history.
    #[must_use]
    pub fn charge_volume(&self) -> f64 {
        self.gas.map_or(self.removed, |g| g.adiabat.v0())
    }

    /// Volume of the removed blocks over that of the charge, Vc/V0.
    #[must_use]
    pub fn volume_ratio(&self) -> f64 {
        self.removed / self.charge_volume()
    }

    /// Living blocks with a free face over the removed blocks, ascending: seen along gravity, they overlap.
    fn surface(&self, world: &World) -> Vec<u32> {
        let [up, b, c] = frame(upward(world.gravity));
        let extent = |b: u32| Extent::of(&world.setup.blocks[b as usize].shape);
        let charge: Vec<Extent> = self.blocks.iter().map(|&b| extent(b)).collect();
        let mut found: Vec<u32> = Vec::new();
        for face in &world.faces {
            let block = face.block as usize;
            if !world.alive[block] || face.parted || face.frame[0].dot(up) < 0.9 {
                continue;
            }
            let centre = world.reference[block];
            let block = extent(face.block);
            let over = charge.iter().any(|part| {
                let above = (centre - part.bounds().centre).dot(up) > 0.0;
                above && block.overlaps_along(part, [up, b, c])
            });
            if over {
                found.push(face.block);
            }
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// Share of the gas pressure that is left at `time` (s).
    pub(crate) fn sealed(&self, venting: Option<Venting>, time: f64) -> f64 {
        match (venting, self.ignited) {
            (Some(Venting::Time { start, span }), Some(ignited)) => {
                let gone = time - ignited - start;
                if gone <= 0.0 {
                    1.0
                } else if gone >= span {
                    0.0
                } else {
                    1.0 - gone / span
                }
            }
            (Some(Venting::Heave { .. }), _) if self.venting.is_some() => 0.0,
            (Some(Venting::Heave { .. } | Venting::Time { .. } | Venting::Cracks(_)) | None, _) => {
                1.0
            }
        }
    }

    /// Sum over the blocks at the walls of `|a|²/m + m.I⁻¹ m`, with a the sum of `A n` and m that of `r x A n`: how
    /// much faster the volume grows for each unit of pressure and time, m⁴/kg.
    fn mobility(&self, world: &World) -> f64 {
        let mut sum = 0.0;
        let reached =
            |wall: &&Wall| self.ignited.is_none() || self.kept == 0.0 || self.reached(wall);
        for walls in self.walls.chunk_by(|a, b| a.block == b.block) {
            let b = walls[0].block as usize;
            // Who is held or driven in all freedoms does not give way to the gas; one that is so in some counts as free, which is safe.
            let motion = world.motion[b].as_deref();
            if motion.is_some_and(|motion| motion.prescribes() == [[true; 3]; 2]) {
                continue;
            }
            let (mut area, mut moment) = (Vec3::ZERO, Vec3::ZERO);
            for wall in walls.iter().filter(reached) {
                area += wall.area * wall.normal;
                moment += wall.arm.cross(wall.area * wall.normal);
            }
            let solid = world.solid_of(b);
            sum += area.length_squared() / solid.mass + moment.dot(solid.inverse * moment);
        }
        sum + self.nodal.mobility
    }

    /// Largest step that resolves the gas spring, `0.1/w` with `w² = g P f² mobility / V`, s.
    fn gas_limit(&self, world: &World) -> f64 {
        let Some(gas) = &self.gas else {
            return f64::INFINITY;
        };
        let (volume, pressure, kept) = match self.ignited {
            Some(_) if self.kept > 0.0 => (self.volume, self.pressure, self.kept),
            // The first step of the gas begins at its full pressure: it has
            // to be resolved before it is known what it does.
            Some(_) | None => (gas.start, gas.adiabat.pressure(gas.start), 1.0),
        };
        // As much as all of the gas would have at this density.
        let whole = volume / kept;
        let source = &world.setup.sources[self.source as usize];
        let mobility = match (self.column, source.hole.stemming) {
            (Some(Column { out: None, .. }), Some(stemming)) => {
                let area = stemming.section() / gas.factor;
                self.mobility(world) + area * area / stemming.mass()
            }
            (Some(_) | None, _) => self.mobility(world),
        };
        let squared =
            gas.adiabat.exponent(whole) * pressure * gas.factor * gas.factor * mobility / volume;
        if squared > 0.0 { GAS_STEP / squared.sqrt() } else { f64::INFINITY }
    }
}

/// Charges the hole of cavity `k` with another mass (kg), to go off at `time` (s): the explosive, the place and the stemming are those of
/// its source. Before it goes off a charge does no work, so nothing is booked.
///
/// # Errors
/// A charge that has gone off, a pressure history, a mass of which there is no adiabat; nothing has changed then.
pub fn charge(world: &mut World, k: usize, mass: f64, time: f64) -> Result<(), ChargeError> {
    let cavity = &mut world.cavities[k];
    let source = &mut world.setup.sources[usize::from(cavity.source)];
    if cavity.ignited.is_some() {
        return Err(ChargeError::Gone);
    }
    let CavityPressure::Gas { explosive, mass: before, coupling, .. } = &mut source.push else {
        return Err(ChargeError::Pressure);
    };
    let adiabat = explosive.adiabat(mass).map_err(ChargeError::Explosive)?;
    *before = mass;
    source.delay = time;
    let gas = Gas::new(adiabat, cavity.removed, *coupling);
    cavity.volume = gas.start;
    cavity.gas = Some(gas);
    Ok(())
}

/// Largest step that cavities allow at the present state, s; the run loop takes the smallest of all limits, every step.
///
/// A charge that has not gone off yet is met on time, but for the length of a step that the gas allows; its first step is already limited.
#[must_use]
pub fn step_limit(world: &World) -> f64 {
    let mut limit = gas::step_limit(world);
    for cavity in &world.cavities {
        let remaining = match cavity.ignited {
            Some(_) => 0.0,
            None => world.setup.sources[cavity.source as usize].delay - world.time,
        };
        let gas = cavity.gas_limit(world);
        let own = if remaining <= EARLY * world.last_dt {
            gas
        } else if gas.is_finite() {
            // No step is made shorter than the gas itself asks for, only to meet the ignition.
            remaining.max(gas)
        } else {
            remaining
        };
        limit = limit.min(own);
    }
    limit
}

impl Gas {
    fn new(adiabat: Adiabat, removed: f64, coupling: Coupling) -> Self {
        let (start, factor) = match coupling {
            Coupling::Scaled { exponent } => {
                (adiabat.v0(), libm::pow(adiabat.v0() / removed, exponent))
            }
            Coupling::Coupled => (adiabat.v0(), 1.0),
            Coupling::Decoupled => (removed, 1.0),
        };
        Self { adiabat, start, factor }
    }
}

/// Direction against gravity; z without gravity.
pub(crate) fn upward(gravity: Vec3) -> Vec3 {
    (-gravity).normalize_or(Vec3::Z)
}

/// Forgets walls of dead blocks in all cavities; their volumes stay what they are.
pub(crate) fn drop_walls(world: &mut World) {
    for k in 0..world.cavities.len() {
        // While they are still among the walls.
        let lost = walls::lost(world, &world.cavities[k]);
        let World { cavities, alive, .. } = world;
        let cavity = &mut cavities[k];
        cavity.walls.retain(|w| alive[w.block as usize]);
        // V = start + f (swept - base): what the dead have swept leaves both, and V stays what it is.
        if cavity.ignited.is_some() {
            cavity.base -= lost;
        }
        if cavity.ignited.is_none() || cavity.burn.is_some() {
            // Only its changes are booked as work, and that of walls that are gone was done.
            world.cavities[k].held = walls::held(world, &world.cavities[k]);
        }
    }
}

/// Finds the surface above the cavities whose gas vents by heave anew.
pub(crate) fn renew_surfaces(world: &mut World) {
    for k in 0..world.cavities.len() {
        if !world.cavities[k].above.is_empty() {
            world.cavities[k].above = world.cavities[k].surface(world);
        }
    }
}
