//! What can be asked of an engine whose forces are evaluated.

use super::{Kind, Who, notes};
use crate::accounts::{Account, Condition};
use crate::exec::Exec;
use crate::ledger::Balance;
use crate::plan::{Every, Plan};
use crate::record::conditions::Conditions;
use crate::record::field::Site;
use crate::record::frame::bars;
use crate::record::frame::fragments::Fragments;
use crate::record::frame::states;
use crate::record::frame::{Content, Frame, Surfaces};
use crate::record::manifest::{Gas, Source, Work};
use crate::record::names::Names;
use crate::spatial::Deepest;
use crate::{planar, spatial};

/// A bolt that has been drawn out.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// Its name.
    pub name: String,
    /// How much farther its points in the rock lie apart along it than when it was installed, m.
    pub by: f64,
    /// Its length, m.
    pub length: f64,
    /// Largest force that it pulls with, N; in the plane per metre.
    pub force: f64,
    /// Whether its bar breaks by itself once it is drawn out far enough.
    pub breaks: bool,
}

/// How far a block has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Movement {
    /// The block.
    pub block: u32,
    /// Displacement, m; in the plane the third component is 0.
    pub shift: [f64; 3],
    /// Rotation about x, y, z, rad; in the plane about z alone.
    pub turn: [f64; 3],
    /// Edge of a square or cube of the same area or volume, m.
    pub size: f64,
    /// Speed of the centroid, and what rotation adds to it at half the size, m/s.
    pub speed: f64,
}

/// An engine with its forces evaluated, ready to be read.
#[derive(Clone, Copy)]
pub enum View<'a> {
    /// Of the planar engine.
    Planar(planar::view::View<'a>),
    /// Of the spatial engine.
    Spatial(spatial::view::View<'a>),
}

impl<'a> View<'a> {
    /// The planar view, for what only that engine has.
    #[must_use]
    pub fn planar(self) -> Option<planar::view::View<'a>> {
        match self {
            Self::Planar(view) => Some(view),
            Self::Spatial(_) => None,
        }
    }

    /// The spatial view, for what only that engine has.
    #[must_use]
    pub fn spatial(self) -> Option<spatial::view::View<'a>> {
        match self {
            Self::Planar(_) => None,
            Self::Spatial(view) => Some(view),
        }
    }

    /// Which engine it is of.
    #[must_use]
    pub fn kind(&self) -> Kind {
        match self {
            Self::Planar(v) => Kind::in_plane(&v.world.setup),
            Self::Spatial(_) => Kind::Spatial,
        }
    }

    /// Model time, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        either!(self, v => v.world.time)
    }

    /// Steps done.
    #[must_use]
    pub fn step(&self) -> u64 {
        either!(self, v => v.world.step)
    }

    /// Length of the last step, s; 0 before the first.
    #[must_use]
    pub fn last_dt(&self) -> f64 {
        either!(self, v => v.world.last_dt)
    }

    /// Name of a block.
    #[must_use]
    pub fn name(&self, block: u32) -> String {
        match self {
            Self::Planar(v) => v.world.setup.blocks[block as usize].name.clone(),
            Self::Spatial(v) => v.name(block as usize),
        }
    }

    /// The gas of charges that may enter cracks; `None` without such gas.
    #[must_use]
    pub fn gas(&self) -> Option<Gas> {
        let v = self.spatial()?;
        let gas = v.world.gas.as_ref()?;
        let books = v.gas_books();
        Some(Gas {
            mass: books.mass,
            in_cracks: gas.in_cracks(),
            vented: books.vented,
            released: books.released,
            internal: v.gas_internal(),
            work: books.work,
            work_in_cracks: books.in_cracks,
            friction: books.friction + books.numerical,
            carried_off: books.carried + books.air + books.stemming,
        })
    }

    /// Boundaries, supports and loads with the work that they have done since the start.
    #[must_use]
    pub fn works(&self) -> Vec<Work> {
        let accounts = either!(self, v => &v.world.accounts);
        let energy = self.kind().fields().iter().find(|f| f.site == Site::Energy);
        let unit = energy.map_or("J", |f| f.unit);
        let work = |(condition, account): (&Condition, &Account)| Work {
            of: condition.holder.word().to_owned(),
            name: condition.name.clone(),
            work: self.slice() * account.work(),
            unit: unit.to_owned(),
        };
        self.accounts().iter().zip(accounts).map(work).collect()
    }

    /// Boundaries, supports and loads that have accounts.
    #[must_use]
    pub fn accounts(&self) -> &'a [Condition] {
        either!(self, v => &v.world.setup.accounts)
    }

    /// Kinetic energy, J or J/m.
    #[must_use]
    pub fn kinetic(&self) -> f64 {
        either!(self, v => v.kinetic_energy())
    }

    /// Sum over the blocks of `m dv² + I dw²` of the coming half kick: what the ledger needs at the start.
    #[must_use]
    pub fn half_kick(&self) -> f64 {
        either!(self, v => v.half_kick())
    }

    /// Energy that has been put in so far, J or J/m: the scale of a blow-up.
    #[must_use]
    pub fn put_in(&self) -> f64 {
        either!(self, v => v.world.works.put_in(v.world.start_energy.unwrap_or_default()))
    }

    /// Largest work of any kind so far, J or J/m.
    #[must_use]
    pub fn largest_work(&self) -> f64 {
        either!(self, v => v.world.works.peak)
    }

    /// What blocks in space that were built into each other have given back by found contact, J: a search for equilibrium presses them
    /// apart. Their energy counts from nil at the start, so less than nothing is left of it.
    #[must_use]
    pub fn released_by_overlaps(&self) -> f64 {
        match self {
            Self::Planar(_) => 0.0,
            Self::Spatial(v) => (-v.world.works.contact_path).max(0.0),
        }
    }

    /// Points of joints that have failed so far and lost strength by it.
    #[must_use]
    pub fn lost_points(&self) -> u64 {
        match self {
            Self::Planar(v) => {
                let loses = |bond: &&planar::world::Bond| {
                    let law = &v.world.setup.interfaces[usize::from(bond.row)].bond;
                    law.as_ref().is_some_and(|law| {
                        let s = &law.strength;
                        s.tension > 0.0
                            || s.cohesion > s.residual_cohesion
                            || s.friction > s.residual_friction
                    })
                };
                v.world.bonds.iter().filter(loses).map(planar::world::Bond::failed_points).sum()
            }
            Self::Spatial(v) => spatial::read::outlook::lost_points(v.world),
        }
    }

    /// Unbalanced-force ratio.
    #[must_use]
    pub fn unbalanced(&self) -> f64 {
        either!(self, v => v.unbalanced())
    }

    /// Whether a block is held, driven or leans on a boundary, so that the model does not fall as a whole.
    #[must_use]
    pub fn holds_something(&self) -> bool {
        match self {
            Self::Planar(v) => v.world.motion.iter().any(Option::is_some),
            Self::Spatial(v) => {
                v.world.motion.iter().any(Option::is_some)
                    || !v.world.setup.boundaries.is_empty()
                    || v.world.deform.as_ref().is_some_and(|d| !d.holds.is_empty())
            }
        }
    }

    /// The first block whose motion is prescribed and not rest.
    #[must_use]
    pub fn driven(&self) -> Option<u32> {
        use planar::setup::Motion as Flat;
        use spatial::setup::Motion as Solid;
        let found = match self {
            Self::Planar(v) => v.world.motion.iter().position(|m| {
                matches!(m.as_deref(), Some(Flat::Velocity { .. } | Flat::Acceleration { .. }))
            }),
            Self::Spatial(v) => v.world.motion.iter().position(|m| {
                matches!(m.as_deref(), Some(Solid::Velocity { .. } | Solid::Acceleration { .. }))
            }),
        };
        found.and_then(|b| u32::try_from(b).ok())
    }

    /// Mass of all blocks, kg or kg/m.
    #[must_use]
    pub fn mass(&self) -> f64 {
        match self {
            Self::Planar(v) => v.living().map(|b| v.scratch.shapes.mass[b]).sum(),
            Self::Spatial(v) => v.living().map(|b| v.world.solid_of(b).mass).sum(),
        }
    }

    /// Largest coordinate of a centroid, in magnitude, m.
    #[must_use]
    pub fn reach(&self) -> f64 {
        let most = |far: f64, at: f64| far.max(at.abs());
        match self {
            Self::Planar(v) => (v.living().map(|b| v.world.bodies[b].position))
                .fold(0.0, |far, p| most(most(far, p.x), p.y)),
            Self::Spatial(v) => (v.living().map(|b| v.position(b)))
                .fold(0.0, |far, p| p.to_array().into_iter().fold(far, most)),
        }
    }

    /// How high the free blocks reach above the lowest of them, along a direction of length 1, m.
    pub fn free_height(&self, up: [f64; 3]) -> f64 {
        let place = |b: usize| match self {
            Self::Planar(v) => {
                let at = v.world.bodies[b].position;
                [at.x, at.y, 0.0]
            }
            Self::Spatial(v) => v.position(b).to_array(),
        };
        let [low, high] =
            self.movements().iter().fold([f64::INFINITY, f64::NEG_INFINITY], |ends, block| {
                let at = place(block.block as usize);
                let level = (0..3).map(|k| at[k] * up[k]).sum::<f64>();
                [ends[0].min(level - 0.5 * block.size), ends[1].max(level + 0.5 * block.size)]
            });
        high - low
    }

    /// Free blocks that are there, with displacement (m) and rotation (rad, about the axes) since displacements were last set
    /// to zero, and size, m: the edge of a square or cube of the same area or volume.
    pub fn movements(&self) -> Vec<Movement> {
        match self {
            Self::Planar(v) => {
                let free = v.living().filter(|b| v.world.motion[*b].is_none());
                free.map(|b| {
                    let shift = v.displacement(b);
                    let area = v.scratch.shapes.mass[b] / v.world.setup.blocks[b].density;
                    let size = area.sqrt();
                    Movement {
                        block: b as u32,
                        shift: [shift.x, shift.y, 0.0],
                        turn: [0.0, 0.0, v.rotation(b)],
                        size,
                        speed: v.velocity(b).length() + 0.5 * size * v.spin(b).abs(),
                    }
                })
                .collect()
            }
            Self::Spatial(v) => {
                let free = v.living().filter(|b| v.world.motion[*b].is_none());
                free.map(|b| {
                    let size = libm::cbrt(v.world.solid_of(b).volume);
                    Movement {
                        block: b as u32,
                        shift: v.displacement(b).to_array(),
                        turn: v.rotation(b).to_array(),
                        size,
                        speed: v.velocity(b).length() + 0.5 * size * v.spin(b).length(),
                    }
                })
                .collect()
            }
        }
    }

    /// The free block whose net force is the largest share of the forces that act on it, with that share.
    #[must_use]
    pub fn least_balanced(&self) -> Option<Who> {
        let (ratio, b) = either!(self, v => v.least_balanced()?);
        Some((self.name(b), ratio))
    }

    /// What energies are multiplied by when they are reported: the thickness of a slice in m, else 1.
    #[must_use]
    pub fn slice(&self) -> f64 {
        match self {
            Self::Planar(v) => v.world.setup.slice(),
            Self::Spatial(_) => 1.0,
        }
    }

    /// The energy ledger, in the plane for each metre of thickness.
    #[must_use]
    pub fn balance(&self) -> Balance {
        either!(self, v => v.balance())
    }

    /// Number of blocks that are there, after splitting and removal.
    #[must_use]
    pub fn blocks(&self) -> usize {
        either!(self, v => v.living().count())
    }

    /// Number of contacts that touch; in space of patches too.
    #[must_use]
    pub fn contacts(&self) -> usize {
        match self {
            Self::Planar(v) => v.contacts().count(),
            Self::Spatial(v) => v.world.patches.len() + v.contacts().count(),
        }
    }

    /// Deepest overlap over the smaller inscribed radius of its pair, with the pair.
    #[must_use]
    pub fn worst_overlap(&self) -> Option<(f64, u32, u32)> {
        either!(self, v => v.worst_overlap())
    }

    /// The bolt that has been drawn out by most of its length.
    #[must_use]
    pub fn most_drawn(&self) -> Option<Drawn> {
        let (bolt, [by, length, force]) = match self {
            Self::Planar(v) => v.most_drawn()?,
            Self::Spatial(v) => v.most_drawn().map(|d| (d.bolt, [d.by, d.length, d.force]))?,
        };
        let breaks =
            either!(self, v => v.world.setup.bolts[bolt as usize].design.breaks.is_finite());
        Some(Drawn { name: self.bolt(bolt).to_owned(), by, length, force, breaks })
    }

    /// Names of bolts that tie nothing to anything, with that of the block that all of each lies in.
    #[must_use]
    pub fn idle_bolts(&self) -> Vec<(String, String)> {
        let idle = either!(self, v => v.idle_bolts()).into_iter();
        idle.map(|(bolt, block)| (self.bolt(bolt).to_owned(), self.name(block))).collect()
    }

    /// Name of a bolt.
    fn bolt(&self, bolt: u32) -> &'a str {
        either!(self, v => v.world.setup.bolts[bolt as usize].name.as_str())
    }

    /// The found contact in space that is deepest for its blocks, rigid, on terrain or deformable.
    #[must_use]
    pub fn deepest_contact(&self) -> Option<Deepest> {
        match self {
            Self::Planar(_) => None,
            Self::Spatial(v) => v.deepest_contact(),
        }
    }

    /// Fastest block and its speed, m/s.
    #[must_use]
    pub fn fastest(&self) -> Option<Who> {
        let (speed, b) = either!(self, v => v.fastest())?;
        Some((self.name(u32::try_from(b).ok()?), speed))
    }

    /// Charges and other cavities, for the manifest.
    #[must_use]
    pub fn sources(&self) -> Vec<Source> {
        match self {
            Self::Planar(_) => Vec::new(),
            Self::Spatial(v) => v.world.cavities.iter().map(|c| notes::source(v, c)).collect(),
        }
    }

    /// Names of the bolts of the model, installed or not.
    #[must_use]
    pub fn bolts(&self) -> Vec<String> {
        either!(self, v => v.world.setup.bolts.iter().map(|bolt| bolt.name.clone()).collect())
    }

    /// The table of the bars of all bolts; `None` where none is in the rock.
    #[must_use]
    pub fn bolt_table(&self) -> Option<String> {
        let bars = match self {
            Self::Planar(v) => planar::bolts::read::bars(v),
            Self::Spatial(v) => spatial::read::bars::bars(v),
        };
        bars::csv(&bars, |bolt| self.bolt(bolt))
    }

    /// The bolt whose equilibrium was missed by most so far: its name, and the force that was left over its largest one.
    #[must_use]
    pub fn unbalanced_bolt(&self) -> Option<(String, f64)> {
        let found = either!(self, v => v.unbalanced_bolt());
        found.map(|(name, left)| (name.to_owned(), left))
    }

    /// The bolt that bears least of the force up to which it has yielded: its name, its force and that one, N.
    #[must_use]
    pub fn relieved_bolt(&self) -> Option<(String, [f64; 2])> {
        either!(self, v => {
            let forces = v.world.bolts.iter().filter_map(|b| Some((b.number, b.chain.hardened()?)));
            let least = forces.min_by(|(_, a), (_, b)| (a[0] / a[1]).total_cmp(&(b[0] / b[1])));
            least.map(|(k, forces)| (v.world.setup.bolts[k as usize].name.clone(), forces))
        })
    }

    /// Fragments now; `None` where no joints hold blocks together.
    #[must_use]
    pub fn fragments(&self) -> Option<Fragments> {
        match self {
            Self::Planar(v) => (!v.world.bonds.is_empty()).then(|| v.fragments()),
            Self::Spatial(v) => Some(v.fragments()),
        }
    }

    /// The table of the states of the blocks, as `start.csv` of a scene reads it.
    #[must_use]
    pub fn states(&self) -> String {
        match self {
            Self::Planar(v) => states::csv(states::PLANAR, &v.states()),
            Self::Spatial(v) => states::csv(states::SPATIAL, &v.states()),
        }
    }

    /// The tetrahedra of deformable blocks; `None` where there are none.
    #[must_use]
    pub fn tetrahedra(&self) -> Option<Surfaces> {
        match self {
            Self::Planar(_) => None,
            Self::Spatial(v) => spatial::read::tetrahedra::tetrahedra(v),
        }
    }

    /// Whether a block is there.
    #[must_use]
    pub(in crate::run) fn is_alive(&self, block: u32) -> bool {
        either!(self, v => v.world.alive.get(block as usize).copied().unwrap_or(false))
    }

    /// Number of blocks there are and have been.
    #[must_use]
    pub fn all_blocks(&self) -> usize {
        either!(self, v => v.world.setup.blocks.len())
    }

    /// Names of groups with their blocks.
    #[must_use]
    pub fn groups(&self) -> Vec<(&'a str, &'a [u32])> {
        either!(self, v => {
            v.world.setup.groups.iter().map(|g| (g.name.as_str(), &g.blocks[..])).collect()
        })
    }

    /// Names of blocks and groups.
    #[must_use]
    pub fn names(&self) -> Names {
        let blocks = (0..self.all_blocks() as u32).map(|b| self.name(b));
        either!(self, v => {
            let groups = v.world.setup.groups.iter();
            Names::pack(blocks, groups.map(|g| (g.name.as_str(), &g.blocks[..])))
        })
    }

    /// What holds, moves and loads blocks with numbers from `first` on.
    #[must_use]
    pub fn conditions(&self, first: usize) -> Conditions {
        match self {
            Self::Planar(v) => planar::conditions::conditions(v, first),
            Self::Spatial(v) => spatial::read::conditions::conditions(v, first),
        }
    }

    /// The threads of the engine.
    pub(crate) fn exec(&self) -> &'a Exec {
        either!(self, v => &v.scratch.exec)
    }

    /// Bytes of a frame of the present before it is compressed; 0 where the plan writes none.
    #[must_use]
    pub fn frame_bytes(&self, plan: &Plan) -> usize {
        if plan.frames == Some(Every::Never) { 0 } else { self.picture("", &plan.pictures).bytes() }
    }

    /// A picture with everything but tetrahedra.
    #[must_use]
    pub fn frame(&self, phase: &str) -> Frame {
        self.picture(phase, &Content::default())
    }

    /// A picture with what is wanted.
    #[must_use]
    pub fn picture(&self, phase: &str, content: &Content) -> Frame {
        let mut frame = match self {
            Self::Planar(v) => planar::picture::frame(v, phase, content),
            Self::Spatial(v) => spatial::read::picture::frame(v, phase, content),
        };
        if content.tetrahedra {
            frame.tetrahedra = self.tetrahedra();
        }
        frame
    }
}
