//! What of a model can meet in space, and what passes through: in words, for `check` and for the end of a run.

use serde::Serialize;

use super::engine::View;
use crate::plan::{Integration, Plan};
use crate::planar;
use crate::spatial;
use crate::spatial::limits;
use crate::spatial::read::outlook::{self, Meets};

/// Depth under a block's own weight, over its size, from which contacts are too soft for it.
const PRESSED: f64 = 0.01;
/// Depth of a corner at the speed of the start, over the radius of the largest ball, from which contacts are too soft for it: the run
/// stops there.
const IMPACT: f64 = 1.0;
/// Time that a pair of blocks that touch takes in a step on one thread, s: that of rubble of polyhedra of 13 faces.
const PAIR: f64 = 2.2e-6;
/// Touching pairs for each block of a heap.
const PAIRS: f64 = 2.5;

/// What `check` says of blocks that can meet in space.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Outlook {
    /// Blocks that can come together with others.
    pub blocks: usize,
    /// Those of them that are rigid.
    pub rigid: usize,
    /// Pairs of them near each other at the start.
    pub pairs: usize,
    /// Those that touch.
    pub touching: usize,
    /// Shortest step once rigid blocks touch, and the time that a step takes on one thread once all of them lie in a heap, s; none
    /// where all that can meet deform.
    pub steps: Option<[f64; 2]>,
    /// Least speed at which a corner is pressed in as far as the run allows, m/s, the height that it is reached from in a fall, m (none
    /// without gravity), and the block.
    pub stop_speed: (f64, Option<f64>, String),
    /// Largest depth under a block's own weight over its size: flat and on a corner.
    pub pressed: [f64; 2],
}

/// Where free blocks lose most of a tilting load to the softness of the joint on which they stand.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Toe {
    /// A block at the edge.
    pub block: String,
    /// Key of the stiffness of its joint.
    pub key: String,
    /// That stiffness, Pa/m.
    pub stiffness: f64,
    /// Share of the load with which these blocks would tilt about the edge of hard ground.
    pub share: f64,
}

/// What `check` says of blocks that can tilt.
pub(super) fn toe(view: &View<'_>, gravity: [f64; 3]) -> Option<Toe> {
    let of = view.spatial()?;
    let toe = of.softest_toe(gravity.into())?;
    let interface = &of.world.setup.interfaces[usize::from(toe.row)].name;
    Some(Toe {
        block: view.name(toe.block),
        key: format!("interfaces.{interface}.normal_stiffness"),
        stiffness: toe.stiffness,
        share: toe.share,
    })
}

/// That found contact is off, where there are blocks that no joint holds together.
pub(super) fn off(view: &View<'_>) -> Option<String> {
    let view = view.spatial()?;
    let meeting = spatial::meeting(view.world);
    let loose = meeting.seekers > 0 && view.living().nth(1).is_some();
    (loose && !meeting.on).then(|| {
        format!(
            "contact detection is switched off (`space.spatial.found_contacts`): {} blocks that are not, or no longer, joined to others pass through \
             them",
            meeting.seekers
        )
    })
}

/// That contact of deformable blocks does not act across the ends of a periodic model, where some can meet.
pub(super) fn across_ends(view: &View<'_>) -> Option<String> {
    let world = view.spatial()?.world;
    let loose = spatial::meeting(world);
    let periodic = world.setup.periodic.iter().any(Option::is_some);
    (loose.on && loose.deformable && periodic).then(|| {
        "contact of deformable blocks is not detected across the periodic boundaries: they pass through other blocks there; make the model longer \
         than their travel, or the blocks rigid"
            .to_owned()
    })
}

/// That nothing but dashpots of viscous faces carries the weight, in words.
pub(super) fn only_dashpots(view: &View<'_>) -> Option<String> {
    let of = view.spatial()?;
    let name = of.sinks_into()?;
    Some(format!(
        "only the dashpots of the viscous boundary `{name}` carry the weight: the model sinks without end; hold the base (`held`), or give \
         `[in_situ]`, the stress that viscous faces balance"
    ))
}

/// Bolts that tie nothing, in words.
pub(super) fn idle_bolts(view: &View<'_>) -> Vec<String> {
    let idle = view.idle_bolts();
    let Some((bolt, block)) = idle.first() else {
        return Vec::new();
    };
    let others = match idle.len() {
        1 => String::new(),
        n => format!(" (nor have {} others)", n - 1),
    };
    vec![format!(
        "bolt `{bolt}` has no effect{others}: it lies entirely in block `{block}`, which is rigid; let the bolt cross a joint, or make the block \
         deformable"
    )]
}

/// What a user must know of blocks that do not act on each other, or act otherwise than one would think.
pub(super) fn words(view: &View<'_>) -> Vec<String> {
    let mut found: Vec<String> = off(view).into_iter().collect();
    let of = match view {
        View::Planar(of) => return unbonded(of.world),
        View::Spatial(of) => of,
    };
    let world = of.world;
    for (name, keys) in outlook::unjoined(world) {
        let verb = if keys.len() == 1 { "has" } else { "have" };
        found.push(format!(
            "{} of {name} {verb} no effect: no joint of the model has this interface, and new contacts do not read these keys",
            keys.iter().map(|key| format!("`{key}`")).collect::<Vec<_>>().join(", ")
        ));
    }
    let meeting = spatial::meeting(world);
    if !meeting.on {
        return found;
    }
    found.extend(across_ends(view));
    if meeting.seekers > 0 && !meeting.sticking.is_empty() {
        found.push(format!(
            "blocks in contact under {} never slide: an elastic interface has no friction law; give its `friction_angle`",
            meeting.sticking.join(", ")
        ));
    }
    let glued = world.setup.blocks.iter().any(|b| b.shape.is_glued());
    if !meeting.unread.is_empty() && !glued {
        found.push(format!(
            "cohesion and tension of {} have no effect: no joint of the model uses this interface, and new contacts use `residual_cohesion`",
            meeting.unread.join(", ")
        ));
    }
    let blocks = outlook::outlook(of);
    found.extend(soft(&view_name(view), world, &blocks));
    found
}

/// Phases with a damping of joints in a model in space that has none, in words. Models of deformable blocks alone are reported where they
/// are made.
pub(super) fn undamped(view: &View<'_>, plan: &Plan) -> Option<String> {
    let world = view.spatial()?.world;
    let rigid =
        (0..world.alive.len()).any(|b| world.alive[b] && world.is_free(b) && !world.deforms(b));
    let joints = !world.patches.class.is_empty() || !world.setup.refinements.is_empty();
    // Of implicit phases the model has said it.
    let mut explicit = plan.phases.iter().filter(|p| p.integration != Integration::Implicit);
    let phase = explicit.find(|p| p.damping.stiffness > 0.0)?;
    (rigid && !joints).then(|| {
        format!(
            "`damping.stiffness` of phase `{}` has no effect: it acts in joints, and the model has none; contacts use the `damping_ratio` or \
             `restitution` of their interface",
            phase.name
        )
    })
}

/// Interfaces in the plane whose `bond` joins no blocks, in words. Joints are made at the start alone.
fn unbonded(world: &planar::world::World) -> Vec<String> {
    let rows = world.setup.interfaces.iter().enumerate();
    let unused = rows.filter(|(row, interface)| {
        let mut bonds = world.bonds.iter();
        interface.bond.is_some() && bonds.all(|bond| usize::from(bond.row) != *row)
    });
    let said = unused.map(|(_, interface)| {
        format!(
            "`bond` of interfaces.{} has no effect: no two blocks of its materials share an edge at the start",
            interface.name
        )
    });
    said.collect()
}

/// Names of blocks.
fn view_name<'a>(view: &'a View<'_>) -> impl Fn(u32) -> String + 'a {
    |b| view.name(b)
}

/// Blocks that contacts are too soft for, each reason once.
fn soft(
    name: &impl Fn(u32) -> String,
    world: &crate::spatial::world::World,
    blocks: &[Meets],
) -> Vec<String> {
    let mut found = Vec::new();
    let gravity = world.gravity.length();
    let key = |block: &Meets| {
        let row = &world.setup.interfaces[usize::from(block.row)];
        let of = &row.name;
        match &row.bond {
            Some(_) if world.deforms(block.block as usize) => {
                format!("interfaces.{of}.brittle_bond.normal_stiffness")
            }
            _ => format!("interfaces.{of}.normal_stiffness"),
        }
    };
    let most = |get: &dyn Fn(&Meets) -> f64| {
        let worst = blocks.iter().max_by(|a, b| get(a).total_cmp(&get(b)));
        worst.map(|block| (block, get(block)))
    };
    if let Some((block, share)) = most(&|b| b.pressed(gravity)[0]).filter(|(_, s)| *s > PRESSED) {
        let wanted = block.stiffness * share / PRESSED;
        found.push(format!(
            "block `{}` penetrates by {:.1} % of its size under its own weight, lying flat: `{}` = {:.1e} Pa/m is too soft; {wanted:.1e} Pa/m keeps \
             the overlap below {:.0} %",
            name(block.block),
            100.0 * share,
            key(block),
            block.stiffness,
            100.0 * PRESSED,
        ));
    }
    if let Some((block, share)) = most(&Meets::impact).filter(|(_, s)| *s > IMPACT) {
        let wanted = limits::least_stiffness(block.mass, block.speed, block.size);
        found.push(format!(
            "block `{}` starts at {:.3} m/s: if it hit with a corner, that would penetrate by {share:.2} of the inscribed radius, and the run would stop; `{}` \
             = {wanted:.1e} Pa/m keeps the penetration below a twentieth of its size",
            name(block.block),
            block.speed,
            key(block),
        ));
    }
    found
}

/// What `check` says of blocks that can meet; `None` where none can.
pub(super) fn outlook(view: &View<'_>) -> Option<Outlook> {
    let of = view.spatial()?;
    let blocks = outlook::outlook(&of);
    let least =
        |get: &dyn Fn(&Meets) -> f64| blocks.iter().min_by(|a, b| get(a).total_cmp(&get(b)));
    let stop = least(&Meets::stop_speed)?;
    let speed = stop.stop_speed();
    let gravity = of.world.gravity.length();
    let most = |k: usize| blocks.iter().map(|b| b.pressed(gravity)[k]).fold(0.0, f64::max);
    let rigid = blocks.iter().filter(|b| b.step.is_finite()).count();
    let (pairs, deformable) = (&of.world.found.pairs, &of.world.found.deformable.pairs);
    // Terrain is in reach of all blocks.
    let searched = pairs.iter().filter(|pair| !of.world.is_terrain(pair.ends[0] as usize));
    let touching = searched.filter(|pair| pair.depth > 0.0).count()
        + deformable.iter().filter(|pair| pair.depth > 0.0).count();
    Some(Outlook {
        blocks: blocks.len(),
        rigid,
        pairs: of.world.near_pairs() + deformable.len(),
        touching,
        steps: least(&|b| b.step)
            .filter(|_| rigid > 0)
            .map(|block| [block.step, PAIRS * PAIR * rigid as f64]),
        stop_speed: (
            speed,
            (gravity > 0.0).then(|| speed * speed / (2.0 * gravity)),
            view.name(stop.block),
        ),
        pressed: [most(0), most(1)],
    })
}

#[cfg(test)]
mod tests {
    use crate::exec::Exec;
    use crate::run::forecast::{Forecast, forecast};
    use crate::run::job::Job;
    use crate::run::scene::Scene;
    use crate::run::simulation::Simulation;
    use crate::scenario::Source;

    fn cube_over_floor(stiffness: &str, speed: &str) -> Forecast {
        above_floor(&format!("normal_stiffness = \"{stiffness}\"\n"), "3 m", speed)
    }

    /// A cube at a height over a floor, with these keys of their interface.
    fn above_floor(interface: &str, height: &str, speed: &str) -> Forecast {
        above_floor_in(interface, height, speed, "")
    }

    /// The same with keys of the phase.
    fn above_floor_in(interface: &str, height: &str, speed: &str, phase: &str) -> Forecast {
        let until = format!("until.time = \"1 s\"\n{phase}");
        let job = falling(interface, height, speed, &until);
        forecast(&job.setup, &job.plan).unwrap()
    }

    fn falling(interface: &str, height: &str, speed: &str, phase: &str) -> Job {
        let text = format!(
            "riprap = 1\ntitle = \"t\"\n[space.spatial]\nfound_contacts = true\ngravity = \"10 m/s2\"\n\
             [materials.rock]\ndensity = \"2500 kg/m3\"\nyoung = \"20 GPa\"\npoisson = 0.25\n\
             [interfaces.default]\n{interface}friction_angle = \"30 deg\"\ndamping_ratio = 0\n\
             [[blocks]]\nname = \"floor\"\nmaterial = \"rock\"\nbrick = {{ size = [\"6 m\", \"6 m\", \"2 m\"], corner = [\"0 m\", \"0 m\", \"-2 m\"] }}\n\
             [[blocks]]\nname = \"cube\"\nmaterial = \"rock\"\nbrick = {{ size = [\"1 m\", \"1 m\", \"1 m\"], corner = [\"2 m\", \"2 m\", \"{height}\"] }}\n\
             velocity = [\"0 m/s\", \"0 m/s\", \"{speed}\"]\n\
             [[supports]]\non.block = \"floor\"\nfixed = {{}}\n[[phases]]\nname = \"fall\"\n{phase}"
        );
        job(text)
    }

    fn job(text: String) -> Job {
        let scene = Scene::parse(Source::new("t.toml", text), ".".into(), &[]).unwrap();
        scene.prepare(&scene.plain()).unwrap().job()
    }

    fn told(text: String) -> Forecast {
        let job = job(text);
        forecast(&job.setup, &job.plan).unwrap()
    }

    #[test]
    fn what_will_meet_is_told_before_it_does() {
        let told = cube_over_floor("100 MPa/m", "-1 m/s");
        let found = told.found.unwrap();
        assert_eq!((found.blocks, found.touching), (1, 0));
        // The energy of a corner, (3 - sqrt 3)/8 kn d^4, at the radius of the largest ball.
        let stop = 0.25 * (2.0 * (3.0 - 3f64.sqrt()) / 8.0 * 1e8 / 2500.0).sqrt();
        assert!((found.stop_speed.0 - stop).abs() < 1e-9 * stop);
        assert_eq!(found.stop_speed.2, "cube");
        let height = stop * stop / 20.0;
        assert!((found.stop_speed.1.unwrap() - height).abs() < 1e-9 * height);
        let corner = (25_000.0 / ((3.0 - 3f64.sqrt()) / 2.0 * 1e8)).cbrt();
        assert!((found.pressed[0] - 2.5e-4).abs() < 1e-15);
        assert!((found.pressed[1] - corner).abs() < 1e-12);
        assert_eq!(told.warnings, Vec::<String>::new());
    }

    #[test]
    fn a_short_run_is_tried_to_its_end_and_a_long_one_told_as_a_range() {
        // It falls 3 m and rebounds: blocks that are apart have no stable step, those of the contact are many.
        let job =
            falling("normal_stiffness = \"100 MPa/m\"\n", "3 m", "-1 m/s", "until.time = \"1 s\"");
        let told = forecast(&job.setup, &job.plan).unwrap();
        let mut run = Simulation::new(job.setup, job.plan, Exec::serial()).unwrap();
        run.run().unwrap();
        assert!(told.tried_to_end);
        assert!(run.steps() > 100, "{}", run.steps());
        assert_eq!(told.steps, Some(run.steps()));
        // A hundred steps and more, whatever shortens them.
        let soft = "normal_stiffness = \"10 MPa/m\"\n";
        let job = falling(soft, "0.1 m", "0 m/s", "until.time = \"1000 h\"");
        let told = forecast(&job.setup, &job.plan).unwrap();
        assert!(!told.tried_to_end);
        assert!(told.least_steps.unwrap() >= 100, "{:?}", told.least_steps);
        assert!(told.steps.unwrap() > 1_000_000, "{:?}", told.steps);
    }

    /// A block of 0.5 m x 0.5 m x 2 m, in one piece and in four: with their sum W = 12.25 kN, 13 % of the load at 1 GPa/m and 1.3 % at 1000,
    /// as in `soft_toe.toml`.
    #[test]
    fn the_softness_of_a_toe_is_told() {
        let told = |stiffness: &str, height: f64, count: u32, lift: &str| {
            told(format!(
                "riprap = 1\ntitle = \"t\"\n[space.spatial]\ngravity = \"9.8 m/s2\"\n\
                 [materials.rock]\ndensity = \"2500 kg/m3\"\nyoung = \"20 GPa\"\npoisson = 0.2\n\
                 [interfaces.default]\nnormal_stiffness = \"{stiffness}\"\nfriction_angle = \"45 deg\"\n\
                 [[blocks]]\nname = \"floor\"\nmaterial = \"rock\"\nbrick = {{ size = [\"6 m\", \"4 m\", \"1 m\"], corner = [\"-3 m\", \"-2 m\", \"-1 m\"] }}\n\
                 [[blocks]]\nname = \"stone\"\nmaterial = \"rock\"\nbrick = {{ size = [\"0.5 m\", \"0.5 m\", \"{height} m\"], corner = [\"-0.25 m\", \"-0.25 m\", \"{lift}\"] }}\n\
                 copies = {{ count = {count}, step = [\"0 m\", \"0 m\", \"{height} m\"] }}\n\
                 [[supports]]\non.block = \"floor\"\nfixed = {{}}\n[[phases]]\nname = \"stand\"\nuntil.steps = 2\n"
            ))
            .toe
        };
        let exact = |stiffness: f64| 12.0 * (12_250.0 / (18.0 * stiffness * 0.5)).cbrt();
        for (stiffness, of, count) in
            [("1 GPa/m", 1e9, 1), ("1000 GPa/m", 1e12, 1), ("1 GPa/m", 1e9, 4)]
        {
            let toe = told(stiffness, 2.0 / f64::from(count), count, "0 m").expect("it stands");
            assert!((toe.share / exact(of) - 1.0).abs() < 1e-9, "{toe:?}");
            assert_eq!(toe.key, "interfaces.default.normal_stiffness");
            assert!(toe.block.starts_with("stone"), "{toe:?}");
        }
        // What does not stand yet has no toe.
        assert_eq!(told("1 GPa/m", 2.0, 1, "0.1 m"), None);
    }

    #[test]
    fn contacts_that_are_too_soft_are_told_with_their_key() {
        let soft = cube_over_floor("1 MPa/m", "-0.1 m/s").warnings.join("\n");
        assert!(soft.contains("`cube` penetrates by 2.5 % of its size"), "{soft}");
        assert!(soft.contains("`interfaces.default.normal_stiffness`"), "{soft}");
        assert!(!soft.contains("starts at"), "{soft}");
        let fast = cube_over_floor("100 MPa/m", "-40 m/s").warnings.join("\n");
        assert!(fast.contains("`cube` starts at 40.000 m/s"), "{fast}");
        assert!(fast.contains("and the run would stop"), "{fast}");
        assert!(!fast.contains("own weight"), "{fast}");
    }

    #[test]
    fn cohesion_that_neither_a_joint_nor_a_contact_has_is_told() {
        let wanted = "cohesion and tension of interfaces.default have no effect";
        let tells = |height: &str, strength: &str| {
            let rest = format!("normal_stiffness = \"10 GPa/m\"\n{strength}");
            let told = above_floor(&rest, height, "0 m/s").warnings;
            told.iter().any(|s| s.starts_with(wanted))
        };
        assert!(tells("1 mm", "cohesion = \"1 kPa\"\n"));
        assert!(!tells("1 mm", ""));
        assert!(!tells("1 mm", "cohesion = \"1 kPa\"\nresidual_cohesion = \"1 kPa\"\n"));
        // A joint has it.
        assert!(!tells("0 m", "cohesion = \"1 kPa\"\n"));
    }

    #[test]
    fn what_joints_alone_read_is_told_where_there_are_none() {
        let wanted = "`failure`, `dashpots` of interfaces.default have no effect: no joint";
        let tells = |height: &str, keys: &str| {
            let told =
                above_floor(&format!("normal_stiffness = \"10 GPa/m\"\n{keys}"), height, "0 m/s")
                    .warnings;
            told.iter().any(|s| s.starts_with(wanted))
        };
        let keys = "failure = \"face\"\ndashpots = \"closed\"\n";
        assert!(tells("1 mm", keys));
        assert!(!tells("1 mm", "failure = \"point\"\n"));
        assert!(!tells("0 m", keys));
    }

    #[test]
    fn damping_of_joints_is_told_where_there_are_none() {
        let tells = |height: &str, phase: &str| {
            let told = above_floor_in("normal_stiffness = \"10 GPa/m\"\n", height, "0 m/s", phase)
                .warnings;
            told.iter().any(|s| s.starts_with("`damping.stiffness` of phase `fall` has no effect"))
        };
        let damped = "damping.stiffness = \"1 us\"\n";
        assert!(tells("1 mm", damped));
        assert!(!tells("1 mm", ""));
        assert!(!tells("0 m", damped));
    }

    #[test]
    fn a_bond_in_the_plane_that_joins_nothing_is_told() {
        let tells = |height: &str| {
            let text = format!(
                "riprap = 1\ntitle = \"t\"\nspace.planar.gravity = [\"0 m/s2\", \"-10 m/s2\"]\nmaterials.rock.density = \"2500 kg/m3\"\n\
                 [interfaces.default]\nnormal_stiffness = \"1 GPa/m\"\nfriction_angle = \"30 deg\"\nbond = {{ tension = \"1 MPa\", cohesion = \"1 MPa\" }}\n\
                 [[blocks]]\nname = \"floor\"\nmaterial = \"rock\"\nrectangle = {{ size = [\"6 m\", \"2 m\"], corner = [\"0 m\", \"-2 m\"] }}\n\
                 [[blocks]]\nname = \"cube\"\nmaterial = \"rock\"\nrectangle = {{ size = [\"1 m\", \"1 m\"], corner = [\"2 m\", \"{height}\"] }}\n\
                 [[supports]]\non.block = \"floor\"\nfixed = {{}}\n[[phases]]\nname = \"fall\"\nuntil.time = \"1 s\"\n"
            );
            let told = told(text).warnings;
            told.iter().any(|s| s.starts_with("`bond` of interfaces.default has no effect"))
        };
        assert!(tells("0.2 m"));
        assert!(!tells("0 m"));
    }
}
