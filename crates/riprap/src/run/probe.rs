//! Contact forces of a model at its start, without a step.

use std::collections::BTreeSet;

use serde::Serialize;

use crate::Vec2;
use crate::dynamics::damping::Damping;
use crate::exec::Exec;
use crate::geom::pairs::touching_boxes;
use crate::geom::polygon::Aabb;
use crate::planar::classify::{Classified, classify};
use crate::planar::setup::Setup;
use crate::planar::step::{self, NonFinite};
use crate::planar::view::View;
use crate::planar::world::{World, Wrench};

/// One contact region, or two blocks that are near each other. Forces are per metre of thickness and act on the first block.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Touch {
    /// First block.
    pub first: String,
    /// Second block.
    pub second: String,
    /// Largest depth of a boundary point, m; 0 between blocks that do not touch.
    pub overlap: f64,
    /// Shortest distance between blocks that do not touch, m; 0 between those that do.
    pub gap: f64,
    /// Length of the contact, m.
    pub length: f64,
    /// Centre of pressure, of a gap the middle of it, global, m.
    pub centre: [f64; 2],
    /// Whole force on the first block, N/m.
    pub force: [f64; 2],
    /// Size of the normal part, N/m.
    pub normal_force: f64,
    /// Size of the rest (friction and damping), N/m.
    pub other_force: f64,
    /// Moment on the first block about its centroid, N.
    pub moment_first: f64,
    /// Moment on the second block about its centroid, N.
    pub moment_second: f64,
    /// The source's contact types of the pair's features closer than twice the threshold.
    pub types: Vec<Classified>,
}

/// Classification threshold d0 over the smaller radius of a pair, unless one is given.
pub const THRESHOLD: f64 = 1e-3;

/// All touching contacts in a fixed order, then all pairs of blocks that do not touch and are nearer than `threshold`, the
/// source's d0 (m), by default [`THRESHOLD`] of the smaller block. Joints built with the model carry no force at the
/// start and are not listed.
///
/// # Errors
/// A block with forces that are not finite.
/// # Examples
///
/// ```
/// use riprap::run::probe::touches;
/// use riprap::run::scene::Scene;
/// use riprap::scenario::Source;
///
/// // A stone on a slope of 30 degrees, friction angle 40 degrees.
/// # let text = r#"
/// # riprap = 1
/// # title = "a stone on a slope"
/// # [space.planar]
/// # gravity = ["0 m/s2", "-9.81 m/s2"]
/// # tilt = "30 deg"
/// # [materials.rock]
/// # density = "2500 kg/m3"
/// # [interfaces.default]
/// # normal_stiffness = "1 GPa/m"
/// # friction_angle = "40 deg"
/// # [[blocks]]
/// # name = "slope"
/// # material = "rock"
/// # rectangle = { size = ["20 m", "1 m"], corner = ["-10 m", "-1 m"] }
/// # [[blocks]]
/// # name = "stone"
/// # material = "rock"
/// # rectangle = { size = ["2 m", "1 m"], corner = ["0 m", "0 m"] }
/// # [[supports]]
/// # on = { block = "slope" }
/// # fixed = {}
/// # [[phases]]
/// # name = "settle"
/// # kind = "static"
/// # until = { unbalanced = 1e-6, steps = 50000 }
/// # [[checks]]
/// # name = "the stone stays"
/// # field = "block.speed"
/// # of = "stone"
/// # at = "end"
/// # between = ["0 m/s", "1 mm/s"]
/// # "#;
/// let scene = Scene::parse(Source::new("slope.toml", text), ".".into(), &[])?;
/// let job = scene.prepare(&scene.plain())?.job();
/// // Side on side, not yet pressed: nothing touches with an overlap.
/// let touches = touches(job.setup.planar().unwrap(), None)?;
/// assert!(touches.iter().all(|touch| touch.overlap < 1e-9));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn touches(setup: &Setup, threshold: Option<f64>) -> Result<Vec<Touch>, NonFinite> {
    let (mut world, mut scratch) = World::new(setup.clone(), Exec::serial());
    // The forces do not depend on the step; a small one keeps the unused velocity changes finite.
    step::evaluate(&mut world, &mut scratch, &Damping::default(), 1e-9)?;
    let probe = Probe { view: View { world: &world, scratch: &scratch }, threshold };
    let mut touches: Vec<Touch> = Vec::new();
    let mut joined: BTreeSet<[u32; 2]> = BTreeSet::new();
    for (i, j, contact) in probe.view.contacts() {
        joined.insert([i, j]);
        let other = contact.tangential.plus(&contact.damping);
        let all: Wrench = contact.normal.plus(&other);
        touches.push(Touch {
            overlap: contact.depth,
            length: contact.length,
            force: all.force.into(),
            normal_force: contact.normal.force.length(),
            other_force: other.force.length(),
            moment_first: all.moment_i,
            moment_second: all.moment_j,
            ..probe.untouched([i, j], world.bodies[i as usize].position + contact.centre)
        });
    }
    joined.extend(world.bonds.iter().map(|bond| [bond.i, bond.j]));
    touches.extend(probe.near(&joined));
    Ok(touches)
}

/// A model whose forces are found.
struct Probe<'a> {
    view: View<'a>,
    /// The source's d0 where one is given, m.
    threshold: Option<f64>,
}

impl Probe<'_> {
    /// The threshold d0 of a pair, m.
    fn d0(&self, [i, j]: [u32; 2]) -> f64 {
        let radius = &self.view.scratch.shapes.radius;
        let smaller = radius[i as usize].min(radius[j as usize]);
        self.threshold.unwrap_or(THRESHOLD * smaller)
    }

    /// A pair without forces, about a local place.
    fn untouched(&self, [i, j]: [u32; 2], centre: Vec2) -> Touch {
        let View { world, scratch } = self.view;
        let name = |block: u32| world.setup.blocks[block as usize].name.clone();
        let outline = |block: u32| &scratch.turned[scratch.shapes.range(block as usize)];
        let apart = world.bodies[i as usize].position - world.bodies[j as usize].position;
        Touch {
            first: name(i),
            second: name(j),
            overlap: 0.0,
            gap: 0.0,
            length: 0.0,
            centre: (Vec2::from(world.setup.origin) + centre).into(),
            force: [0.0; 2],
            normal_force: 0.0,
            other_force: 0.0,
            moment_first: 0.0,
            moment_second: 0.0,
            types: classify(outline(i), outline(j), apart, self.d0([i, j])),
        }
    }

    /// Pairs that do not touch and are nearer than their threshold, without those that are `joined`.
    fn near(&self, joined: &BTreeSet<[u32; 2]>) -> Vec<Touch> {
        let View { world, scratch } = self.view;
        let outline = |b: usize| -> Vec<Vec2> {
            let edges = scratch.turned[scratch.shapes.range(b)].iter();
            edges.map(|edge| world.bodies[b].position + edge.start).collect()
        };
        let outlines: Vec<Vec<Vec2>> = (0..world.setup.blocks.len()).map(outline).collect();
        let boxed = |(corners, radius): (&Vec<Vec2>, &f64)| {
            let mut bounds = Aabb::of(corners);
            // Half of it on either side: together no less than the threshold of the smaller block.
            let reach = Vec2::splat(0.5 * self.threshold.unwrap_or(THRESHOLD * radius));
            (bounds.min, bounds.max) = (bounds.min - reach, bounds.max + reach);
            bounds
        };
        let boxes: Vec<Aabb> = outlines.iter().zip(&scratch.shapes.radius).map(boxed).collect();
        let pairs = touching_boxes(&boxes, usize::MAX).unwrap_or_default().into_iter();
        let near = |(i, j): (u32, u32)| {
            let (gap, middle) = gap(&outlines[i as usize], &outlines[j as usize]);
            let shown = gap < self.d0([i, j]) && !joined.contains(&[i, j]);
            shown.then(|| Touch { gap, ..self.untouched([i, j], middle) })
        };
        pairs.filter_map(near).collect()
    }
}

/// Shortest distance between two outlines that do not cross, m, and the middle of it.
fn gap(one: &[Vec2], other: &[Vec2]) -> (f64, Vec2) {
    let mut least = (f64::INFINITY, Vec2::ZERO);
    // Outlines that are apart are nearest at a corner of one of them.
    for (corners, edges) in [(one, other), (other, one)] {
        for &x in corners {
            for (k, &p) in edges.iter().enumerate() {
                let along = edges[(k + 1) % edges.len()] - p;
                let t = ((x - p).dot(along) / along.length_squared()).clamp(0.0, 1.0);
                let nearest = p + t * along;
                let distance = (x - nearest).length();
                if distance < least.0 {
                    least = (distance, 0.5 * (x + nearest));
                }
            }
        }
    }
    least
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::laws::parameters::{ContactLaw, FrictionLaw, NormalLaw, Reflex};
    use crate::planar::setup::{BlockSpec, Interface};

    fn square(name: &str, y: f64) -> BlockSpec {
        let corner = |dx: f64, dy: f64| Vec2::new(dx, y + dy);
        BlockSpec {
            name: name.to_owned(),
            vertices: vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)],
            material: 0,
            density: 1000.0,
            velocity: Vec2::ZERO,
            spin: 0.0,
        }
    }

    #[test]
    fn a_block_pressed_into_another_is_pushed_out() {
        let contact = ContactLaw {
            normal: NormalLaw::DistancePotential,
            reflex: Reflex::Min,
            normal_stiffness: 1e9,
            shear_stiffness: 5e8,
            friction: 0.5,
            cohesion: 0.0,
            friction_law: FrictionLaw::ShearSpring,
            clip_speed: 0.0,
            damping_ratio: 0.2,
        };
        let setup = Setup {
            origin: [100.0, 0.0],
            materials: vec!["rock".to_owned()],
            blocks: vec![square("low", 0.0), square("high", 0.999), square("far", 5.0)],
            interfaces: vec![Interface { name: "default".to_owned(), contact, bond: None }],
            pair_table: vec![0],
            ..Setup::default()
        };
        let found = touches(&setup, None).unwrap();
        assert_eq!(found.len(), 1);
        let one = &found[0];
        assert_eq!((one.first.as_str(), one.second.as_str()), ("low", "high"));
        assert!((one.overlap - 1e-3).abs() < 1e-12 && (one.length - 1.0).abs() < 1e-3, "{one:?}");
        assert!(one.force[1] < 0.0 && one.force[0].abs() < 1e-9 * one.force[1].abs(), "{one:?}");
        assert!((one.normal_force + one.force[1]).abs() < 1e-9 * one.normal_force);
        assert!((one.centre[0] - 100.5).abs() < 1e-6 && (one.centre[1] - 1.0).abs() < 1e-3);
        assert_eq!((one.other_force, one.gap), (0.0, 0.0));
        // Blocks that are apart show from a threshold on that is wider than their gap, with nothing between them.
        let mut apart = setup.clone();
        apart.blocks[1] = square("high", 1.0003);
        assert_eq!(touches(&apart, Some(2e-4)).unwrap(), []);
        let found = touches(&apart, Some(1e-3)).unwrap();
        let [one] = &found[..] else {
            panic!("{found:?}");
        };
        assert_eq!((one.first.as_str(), one.second.as_str()), ("low", "high"));
        assert!((one.gap - 3e-4).abs() < 1e-12, "{one:?}");
        assert_eq!((one.overlap, one.force), (0.0, [0.0; 2]));
        assert!((one.centre[1] - 1.00015).abs() < 1e-12, "{one:?}");
        assert!(!one.types.is_empty(), "{one:?}");
        // Blocks that stand flush have a gap of nothing.
        apart.blocks[1] = square("high", 1.0);
        assert_eq!(touches(&apart, None).unwrap()[0].gap, 0.0);
    }
}
