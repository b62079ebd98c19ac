//! What found contacts of a model will be like, told before they are there: who can be pressed in how far, and how long steps will be.

use riprap_core::laws::behaviour::{Closure, Weakening};
use riprap_core::laws::parameters::{Dashpots, Failure, JointLaw, Points};
use riprap_geom::Vec3;

use crate::contact::deformable::between;
use crate::contact::deformable::search::shown;
use crate::contact::limit::InverseInertia;
use crate::contact::limit::share_on_ground;
use crate::contact::{constants, joined, make_shapes, roles};
use crate::joint::patch;
use crate::kernel::{Role, limits};
use crate::laws::mohr_coulomb::Strength;
use crate::query::view::View;
use crate::state::contact_scratch::ContactScratch;
use crate::state::patches::flag;
use crate::state::world::World;

/// A block that can meet others, and the softest law under which it can.
#[derive(Clone, Debug, PartialEq)]
pub struct Meets {
    /// The block.
    pub block: u32,
    /// Row of the softest law in `Setup::interfaces`.
    pub row: u16,
    /// Its normal stiffness, Pa/m.
    pub stiffness: f64,
    /// How fast its pressures grow beyond the depth, `1/D²`, 1/m².
    pub growth: f64,
    /// Radius of the largest ball in the block, of a deformable one the distance of its centre from its surface, m.
    pub inradius: f64,
    /// Cube root of its volume, m.
    pub size: f64,
    /// Mass, kg.
    pub mass: f64,
    /// Largest face, m².
    pub face: f64,
    /// Speed of its fastest point at present against blocks that are held, or where none is against the centre of mass of all, m/s.
    pub speed: f64,
    /// Longest step once its largest face lies flat on something that cannot move, s; infinite where that is not known.
    pub step: f64,
}

impl Meets {
    /// Speed at which a corner goes in by the radius of the largest ball, where the run stops, m/s.
    #[must_use]
    pub fn stop_speed(&self) -> f64 {
        let gain = limits::corner_gain(self.inradius, self.growth);
        limits::corner_speed(self.mass, self.inradius, self.stiffness) * gain.sqrt()
    }

    /// How deep a corner goes in at the present speed over the radius of the largest ball.
    #[must_use]
    pub fn impact(&self) -> f64 {
        let under = |gain: f64| limits::corner_depth(self.mass, self.speed, gain * self.stiffness);
        // Each look at least halves what the depth is off by.
        let better = |depth: f64, _| under(limits::corner_gain(depth, self.growth));
        (0..40).fold(under(1.0), better) / self.inradius
    }

    /// How deep its own weight presses it in under gravity (m/s²), flat on its largest face and standing on a corner, over its size.
    #[must_use]
    pub fn pressed(&self, gravity: f64) -> [f64; 2] {
        let weight = self.mass * gravity;
        let flat = weight / (self.stiffness * self.face);
        [flat, limits::corner_under(weight, self.stiffness)].map(|depth| depth / self.size)
    }
}

/// All blocks that can come together with others, or with terrain, the rigid ones first; none where found contact is off.
#[must_use]
pub fn outlook(view: &View<'_>) -> Vec<Meets> {
    let mut blocks = rigid(view.world);
    blocks.extend(deformable(view));
    blocks
}

/// The rigid ones.
fn rigid(world: &World) -> Vec<Meets> {
    let roles = roles(world);
    if !world.setup.found_contacts || world.found.roles.len() != roles.len() {
        return Vec::new();
    }
    let n = roles.len();
    let there = |b: &usize| world.alive[*b];
    // One block of each material stands for all: a law hangs on materials, and on the block itself.
    let mut partner: Vec<Option<u32>> = vec![None; world.setup.materials.len()];
    for b in (0..n).filter(there).filter(|b| !world.deforms(*b)) {
        let material = usize::from(world.setup.blocks[b].material);
        partner[material].get_or_insert(b as u32);
    }
    let mut desk = ContactScratch::default();
    make_shapes(world, &mut desk);
    let still = still(world);
    // What lies over terrain can meet it, joined to others or not.
    let over = |b: usize| world.has_terrain() && world.meets_terrain(b);
    let seekers = (0..n).filter(|b| roles[*b] == Role::Active || over(*b));
    let seekers = seekers.filter(|b| world.freedoms(*b)[0] != Vec3::ZERO);
    seekers
        .filter_map(|b| {
            let solid = world.solid_of(b);
            let shape = &desk.shapes[world.solid[b] as usize];
            let inradius = desk.inradius(world.solid[b]);
            let laws = partner.iter().flatten().map(|other| {
                let ends = [*other, b as u32];
                let materials = ends.map(|b| usize::from(world.setup.blocks[b as usize].material));
                let row = world.setup.row_of(materials);
                (row, constants::law(&world.setup, ends, [inradius; 2]))
            });
            let laws: Vec<_> = laws.collect();
            let softest =
                laws.iter().min_by(|a, b| a.1.normal_stiffness.total_cmp(&b.1.normal_stiffness))?;
            let face = shape.areas.iter().copied().fold(0.0, f64::max);
            let ease = InverseInertia::of(world, &desk.shapes, b).of_area(face);
            let steps = laws.iter().map(|(_, law)| {
                let stiffness = 2.0 * law.normal_stiffness.max(law.shear_stiffness);
                share_on_ground(law) * 2.0 / (stiffness * face * ease).sqrt()
            });
            let spin = world.bodies.spin(b).length() * solid.radius;
            let density =
                world.setup.materials[usize::from(world.setup.blocks[b].material)].density;
            Some(Meets {
                block: b as u32,
                row: softest.0,
                stiffness: softest.1.normal_stiffness,
                growth: softest.1.growth,
                inradius,
                size: libm::cbrt(solid.mass / density),
                mass: solid.mass,
                face,
                speed: (world.bodies.velocity(b) - still).length() + spin,
                step: steps.fold(f64::INFINITY, f64::min),
            })
        })
        .collect()
}

/// The deformable ones. A block counts as deep as its centre lies
/// below its surface. How long steps may be is left open ([`Meets::step`] is infinite): their own waves are faster as a rule.
fn deformable(view: &View<'_>) -> Vec<Meets> {
    let View { world, scratch } = view;
    let (Some(deform), Some(work)) = (world.deform.as_deref(), scratch.deform.as_deref()) else {
        return Vec::new();
    };
    let roles = &world.found.deformable.roles;
    // One block of each material and kind stands for all, as in `check`.
    let mut partner = vec![[None; 2]; world.setup.materials.len()];
    for b in (0..world.alive.len()).filter(|b| world.alive[*b]) {
        let material = usize::from(world.setup.blocks[b].material);
        partner[material][usize::from(world.deforms(b))].get_or_insert(b as u32);
    }
    let still = still(world);
    let seekers = (0..roles.len()).filter(|b| roles[*b] == Role::Active);
    let seekers = seekers.filter_map(|b| Some((b, deform.body(b)?)));
    seekers
        .filter_map(|(b, body)| {
            let solid = world.solid_of(b);
            let class = work.class(body);
            let depth = class.mesh.height();
            let own = usize::from(world.setup.blocks[b].material);
            let partners = partner.iter().enumerate().flat_map(|(material, of)| {
                let kinds = of.iter().enumerate();
                kinds.filter_map(move |(deforms, other)| Some((material, deforms, (*other)?)))
            });
            let laws = partners.filter_map(|(material, deforms, other)| {
                let rigid = [false, deforms == 0];
                let law = between(&world.setup, [b as u32, other], rigid, [depth; 2]).ok()?;
                Some((world.setup.row_of([own, material]), law.normal_stiffness))
            });
            let (row, stiffness) = laws.min_by(|a, b| a.1.total_cmp(&b.1))?;
            let nodes = deform.nodes.velocity[body.nodes()].iter();
            let speeds = nodes.map(|v| (Vec3::from_array(*v) - still).length());
            let density = world.setup.materials[own].density;
            Some(Meets {
                block: b as u32,
                row,
                stiffness,
                growth: 0.0,
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

/// Whether joints or bonds of the model can give way to contacts that are found anew, which take shorter steps, and more time each.
#[must_use]
pub fn can_give_way(world: &World) -> bool {
    let setup = &world.setup;
    let mut joints = setup.interfaces.iter().zip(joined(world));
    let mut bonds = (world.deform.iter())
        .flat_map(|deform| &deform.facets)
        .filter_map(|facet| setup.interfaces[usize::from(facet.row)].bond.as_ref());
    setup.found_contacts
        && (joints.any(|(row, joined)| joined && row.joint.strength.is_some())
            || bonds.any(|bond| bond.strength.is_some()))
}

/// Points of joints that have failed so far and had a strength that failing takes away: cohesion, tension, friction above the residual one.
#[must_use]
pub fn lost_points(world: &World) -> u64 {
    let setup = &world.setup;
    let loses = |s: &Option<Strength>| {
        let more = |s: &Strength| {
            s.tension > 0.0 || s.cohesion > s.residual_cohesion || s.friction > s.residual_friction
        };
        s.as_ref().is_some_and(more)
    };
    let patches = world.patches.flags.iter().zip(&world.patches.class);
    let patches = patches.filter(|(_, class)| {
        loses(&patch::joint(&setup.interfaces, &world.classes[**class as usize]).strength)
    });
    let there: u64 = patches.map(|(flags, _)| u64::from((flags & flag::BROKEN).count_ones())).sum();
    let facets = world.deform.iter().flat_map(|deform| {
        let bond = |row: u16| setup.interfaces[usize::from(row)].bond.as_ref();
        let breaks =
            deform.facets.iter().filter(move |f| bond(f.row).is_some_and(|b| loses(&b.strength)));
        breaks.map(|f| deform.failed_points(f))
    });
    let released = world.failed.count(|ends| {
        let of = ends.map(|b| usize::from(setup.blocks[b as usize].material));
        loses(&setup.interfaces[usize::from(setup.row_of(of))].joint.strength)
    });
    there + facets.sum::<u64>() + released
}

/// Interfaces that no joint of the model has, with what they say that joints alone read: `interfaces.NAME` and keys. None where
/// splitting may yet make joints.
#[must_use]
pub fn unjoined(world: &World) -> Vec<(String, Vec<&'static str>)> {
    let setup = &world.setup;
    if !setup.refinements.is_empty() {
        return Vec::new();
    }
    let rows = setup.interfaces.iter().zip(joined(world));
    // Bonds of deformable blocks are not among the patches, and are told of where the model is made.
    let rows = rows.filter(|(row, joined)| !joined && row.bond.is_none());
    let rows = rows.map(|(row, _)| (format!("interfaces.{}", row.name), of_joints(&row.joint)));
    rows.filter(|(_, keys)| !keys.is_empty()).collect()
}

/// What a law says that joints alone read, but for cohesion and tension; that an elastic one has a strength has been told.
fn of_joints(law: &JointLaw) -> Vec<&'static str> {
    let breaks = law.strength.is_some();
    let (softens, rough) = match law.behaviour.weakening {
        Weakening::Brittle => (false, false),
        Weakening::Softening(_) => (true, false),
        Weakening::BartonBandis(_) => (false, true),
    };
    let keys = [
        ("dilation_angle", law.strength.is_some_and(|s| s.dilation > 0.0)),
        ("softening", breaks && softens),
        ("barton_bandis", breaks && rough),
        ("closure", law.behaviour.closure != Closure::default()),
        ("failure", breaks && law.failure != Failure::default()),
        ("points", law.points != Points::default()),
        ("dashpots", breaks && law.dashpots != Dashpots::default()),
    ];
    let said = keys.into_iter().filter(|(_, said)| *said);
    said.map(|(key, _)| key).collect()
}

/// Velocity that nobody is hit with: none where something is held, else that of the centre of mass, m/s.
fn still(world: &World) -> Vec3 {
    let (mut mass, mut momentum) = (0.0, Vec3::ZERO);
    for b in (0..world.alive.len()).filter(|b| world.alive[*b]) {
        if world.is_terrain(b) || world.motion[b].is_some() {
            return Vec3::ZERO;
        }
        let of = world.solid_of(b).mass;
        mass += of;
        momentum += of * world.bodies.velocity(b);
    }
    if mass > 0.0 { momentum / mass } else { Vec3::ZERO }
}
