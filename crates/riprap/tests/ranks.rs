//! Several ranks leave the folder of one, byte for byte: scenes of every engine.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use riprap::record::folder::Existing;
use riprap::record::manifest::Manifest;
use riprap::run::drive::{Control, Ending, Look};
use riprap::run::job::{Job, resume_ranks, run, run_ranks};
use riprap::run::scene::Scene;

/// A scene of the library, or of a file with an absolute path, made small by changes of its keys.
fn job(scene: &str, changes: &[(&str, &str)]) -> Job {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes")).join(scene);
    let own = |(key, value): &(&str, &str)| ((*key).to_owned(), (*value).to_owned());
    let changes: Vec<(String, String)> = changes.iter().map(own).collect();
    let scene = Scene::load(&path, &changes).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    scene.prepare(&scene.plain()).unwrap_or_else(|e| panic!("{}: {e}", path.display())).job()
}

/// All files of a run but for its manifest, which holds wall times.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut left = vec![folder.to_owned()];
    while let Some(at) = left.pop() {
        for entry in std::fs::read_dir(at).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                left.push(path);
            } else if path.file_name().is_some_and(|name| name != "manifest.json") {
                let name = path.strip_prefix(folder).unwrap().to_owned();
                found.insert(name, std::fs::read(path).unwrap());
            }
        }
    }
    found
}

fn go(_: &mut Look<'_>) -> Control {
    Control::Continue
}

/// Compares runs with these numbers of ranks with one without any.
fn same_for_any_ranks(scene: &str, changes: &[(&str, &str)], ranks: &[usize]) {
    let dir = tempfile::tempdir().unwrap();
    let one = dir.path().join("one.run");
    let alone = run(job(scene, changes), &one, Existing::Refuse, 1, &mut go).unwrap();
    assert!(alone.manifest.steps > 5, "{scene}: {} steps", alone.manifest.steps);
    let expected = files(&one);
    assert!(expected.len() > 8, "{scene}: {:?}", expected.keys());
    for &size in ranks {
        let folder = dir.path().join(format!("{size}.run"));
        let job = job(scene, changes);
        let done = run_ranks(job, &folder, Existing::Refuse, [size, 1], &mut go).unwrap();
        assert_eq!(done.ending, alone.ending, "{scene} on {size}");
        assert_eq!(done.manifest.state_hash, alone.manifest.state_hash, "{scene} on {size}");
        let found = files(&folder);
        let names = |all: &BTreeMap<PathBuf, Vec<u8>>| all.keys().cloned().collect::<Vec<_>>();
        assert_eq!(names(&found), names(&expected), "{scene} on {size}");
        for (name, bytes) in &expected {
            assert!(found[name] == *bytes, "{scene} on {size}: {} differs", name.display());
        }
    }
}

const BLAST: &str = "bench/blast_throw.toml";
/// 726 bricks, of which a charge tears some off.
const SMALL_BLAST: [(&str, &str); 5] = [
    ("blocks.rock.grid.box.size", "[\"11 m\", \"11 m\", \"6 m\"]"),
    ("blocks.rock.grid.box.corner", "[\"-5.5 m\", \"-5.5 m\", \"-6 m\"]"),
    ("sources.charge.gas_cavity.mass", "\"600 kg\""),
    ("phases.0.until.time", "\"4 ms\""),
    ("phases.1.until.steps", "5"),
];

/// Joints that fail, gas, found contact, blocks that turn, supports.
#[test]
fn a_blast_has_the_bits_of_one_rank() {
    same_for_any_ranks(BLAST, &SMALL_BLAST, &[1, 2, 3, 5, 8]);
}

/// Stones that come to lie on each other.
#[test]
fn rubble_has_the_bits_of_one_rank() {
    let changes = [
        ("blocks.rubble.pour.count", "80"),
        ("phases.0.until.time", "\"450 ms\""),
        ("phases.1.until.steps", "5"),
    ];
    same_for_any_ranks("bench/rubble.toml", &changes, &[2, 3, 8]);
}

/// Bricks with whole joints, of which ranks need to know only what lies at the cut, until joints fail and bricks fly off.
const TORN: &str = r#"
riprap = 1
title = "Bricks that stand, and are torn off"
[space.spatial]
gravity = "9.81 m/s2"
[materials.rock]
density = "2500 kg/m3"
young = "1 GPa"
poisson = 0.25
[interfaces.default]
cohesion = "300 kPa"
tension = "150 kPa"
friction_angle = "30 deg"
damping_ratio = 0.05
[[blocks]]
name = "rock"
material = "rock"
grid.box = { size = ["8 m", "8 m", "6 m"], cell = "1 m" }
[[boundaries]]
on.plane = "z-min"
held = {}
[[phases]]
name = "stand"
until.steps = 400
[[phases]]
name = "tear"
gravity = ["20 m/s2", "0 m/s2", "30 m/s2"]
until.steps = 300
[[outputs]]
history = { name = "top", field = "block.displacement.z", of = "rock.384", every = "5 ms" }
[[checks]]
name = "the top has moved"
field = "block.displacement.magnitude"
of = "rock.384"
at = "30 ms"
value = "1 mm"
absolute = "1 mm"
"#;

#[test]
fn steps_that_nobody_reads_have_the_bits_of_one_rank() {
    let dir = tempfile::tempdir().unwrap();
    let scene = dir.path().join("torn.toml");
    std::fs::write(&scene, TORN).unwrap();
    let scene = scene.to_str().unwrap();
    same_for_any_ranks(scene, &[], &[2, 3, 5, 8]);
    // Standing, hardly more travels than the cut: 8 by 8 joints, and what 64 blocks and their joints do.
    let stand = [
        ("phases.1.until.steps", "1"),
        ("phases.0.until.steps", "2000"),
        ("blocks.rock.grid.box.size", "[\"8 m\", \"8 m\", \"24 m\"]"),
    ];
    let sent = |changes: &[(&str, &str)]| {
        let (job, folder) = (job(scene, changes), dir.path().join("sent.run"));
        let done = run_ranks(job, &folder, Existing::Force, [2, 1], &mut go).unwrap();
        let sent = done.sent.unwrap();
        sent.traffic.bytes as f64 / sent.steps as f64
    };
    let quiet = sent(&stand);
    let read = sent(&[&stand[..], &[("outputs.0.history.every", "\"0.4 ms\"")]].concat());
    // 39 of 109 kB on a quiet machine; looks by the clock add little.
    assert!(quiet < 0.5 * read, "{quiet} of {read} bytes a step");
}

/// What several scenes of bricks begin with.
const BRICKS: &str = r#"
riprap = 1
title = "Bricks"
[space.spatial]
gravity = "9.81 m/s2"
[materials.rock]
density = "2500 kg/m3"
young = "1 GPa"
poisson = 0.25
[[boundaries]]
on.plane = "z-min"
held = {}
"#;

/// Compares runs of bricks with this end of their scene.
fn same_bricks(scene: &str, ranks: &[usize]) {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("bricks.toml");
    std::fs::write(&file, format!("{BRICKS}{scene}")).unwrap();
    same_for_any_ranks(file.to_str().unwrap(), &[], ranks);
}

/// The last state of a phase that waits for rest is read, at whatever step it ends: here at none that is looked at in any case.
#[test]
fn a_phase_that_ends_at_rest_is_read_at_its_end() {
    let scene = r#"
[interfaces.default]
cohesion = "300 kPa"
tension = "150 kPa"
friction_angle = "30 deg"
damping_ratio = 0.2
[[blocks]]
name = "rock"
material = "rock"
grid.box = { size = ["4 m", "4 m", "24 m"], cell = "1 m" }
[[phases]]
name = "stand"
until.steps = 33
[[phases]]
name = "rest"
until.rest = { share = 0.9, speed = "10 m/s", hold = "20 ms" }
damping.local = 0.3
[[outputs]]
history = { name = "far", field = "block.displacement.z", of = "rock.384", every = "500 ms" }
[[outputs]]
history = { name = "moving", field = "model.kinetic", every = "500 ms" }
"#;
    same_bricks(scene, &[2, 3]);
}

/// Softening joints wear in tension without a bit that says so, in steps that are read.
#[test]
fn worn_joints_have_the_bits_of_one_rank() {
    let scene = r#"
[interfaces.default]
cohesion = "30 kPa"
tension = "20 kPa"
friction_angle = "30 deg"
residual_cohesion = "10 kPa"
residual_friction_angle = "25 deg"
damping_ratio = 0.05
softening = { slip = "20 mm", opening = "20 mm" }
[[blocks]]
name = "rock"
material = "rock"
grid.box = { size = ["4 m", "4 m", "12 m"], cell = "1 m" }
[[phases]]
name = "stand"
until.steps = 150
[[phases]]
name = "tear"
gravity = ["0 m/s2", "0 m/s2", "0.5 m/s2"]
until.steps = 80
[[phases]]
name = "back"
gravity = ["0 m/s2", "0 m/s2", "-9.81 m/s2"]
until.steps = 33
[[outputs]]
history = { name = "top", field = "block.displacement.z", of = "rock.100", every = "0.001 ms" }
"#;
    same_bricks(scene, &[2, 3]);
}

/// They slip and stick again between two states that are read.
#[test]
fn joints_that_slip_unread_have_the_bits_of_one_rank() {
    let scene = r#"
[interfaces.default]
cohesion = "1 kPa"
tension = "1 kPa"
friction_angle = "30 deg"
residual_cohesion = "0 kPa"
residual_friction_angle = "25 deg"
damping_ratio = 0.1
softening = { slip = "20 mm", opening = "20 mm" }
[[blocks]]
name = "rock"
material = "rock"
grid.box = { size = ["8 m", "8 m", "4 m"], cell = ["8 m", "8 m", "0.02 m"] }
[[phases]]
name = "stand"
until.unbalanced = 1e-3
kind = "static"
[[phases]]
name = "tear"
gravity = ["6.8 m/s2", "0 m/s2", "-9.81 m/s2"]
until.steps = 400
damping.local = 0.5
[[phases]]
name = "back"
gravity = ["0 m/s2", "0 m/s2", "-9.81 m/s2"]
until.steps = 433
damping.local = 0.5
[[outputs]]
history = { name = "top", field = "block.displacement.x", of = "rock.100", every = "500 ms" }
"#;
    same_bricks(scene, &[2, 3]);
}

/// A joint fails, all are told of it as a row is written, and the next look at joints falls into a step that nobody reads.
#[test]
fn joints_that_failed_before_a_row_are_seen_at_the_next_look() {
    let scene = r#"
[interfaces.default]
cohesion = "60 kPa"
tension = "20 kPa"
friction_angle = "30 deg"
damping_ratio = 0.05
[[blocks]]
name = "rock"
material = "rock"
grid.box = { size = ["4 m", "4 m", "12 m"], cell = "1 m" }
[[phases]]
name = "stand"
until.steps = 3
[[phases]]
name = "tear"
gravity = ["2 m/s2", "0 m/s2", "-9.81 m/s2"]
until.steps = 142
[[outputs]]
history = { name = "top", field = "block.displacement.z", of = "rock.100", every = "58.0 ms" }
[[outputs]]
history = { name = "broken", field = "model.broken_points", every = "58.0 ms" }
"#;
    same_bricks(scene, &[2, 3]);
}

/// A look that measures in every step, a run that is stopped in the middle of steps that nobody reads, and goes on.
#[test]
fn looks_at_steps_that_nobody_reads_see_what_one_rank_sees() {
    let dir = tempfile::tempdir().unwrap();
    let scene = dir.path().join("torn.toml");
    std::fs::write(&scene, TORN).unwrap();
    let scene = scene.to_str().unwrap();
    let [one, many] = ["one.run", "many.run"].map(|name| dir.path().join(name));
    let alone = run(job(scene, &[]), &one, Existing::Refuse, 1, &mut go).unwrap();
    let mut stop = |look: &mut Look<'_>| Control::stop_if(look.progress.step > 20);
    let part = run_ranks(job(scene, &[]), &many, Existing::Refuse, [3, 1], &mut stop).unwrap();
    assert_eq!(part.ending, Ending::Stopped);
    let mut seen = 0.0;
    let mut measure = |look: &mut Look<'_>| {
        seen = look.measured().kinetic;
        Control::Continue
    };
    let done = resume_ranks(&many, [2, 1], &mut measure).unwrap();
    assert_eq!(done.manifest.state_hash, alone.manifest.state_hash);
    assert!(seen > 0.0);
}

/// Dashpots and stress at the start behind faces.
#[test]
fn viscous_faces_have_the_bits_of_one_rank() {
    same_for_any_ranks("verify/spatial-rigid/viscous_in_situ.toml", &[], &[2, 3, 5, 8]);
}

#[test]
fn blocks_that_split_have_the_bits_of_one_rank() {
    same_for_any_ranks("verify/spatial-rigid/split_during_run.toml", &[], &[3, 8]);
}

#[test]
fn seepage_has_the_bits_of_one_rank() {
    same_for_any_ranks("verify/engineering/seepage_dam_space.toml", &[], &[2, 5]);
}

#[test]
fn glued_stones_on_terrain_have_the_bits_of_one_rank() {
    let changes = [("phases.0.until.time", "\"50 ms\"")];
    same_for_any_ranks("verify/spatial-contact/glued_terrain.toml", &changes, &[3, 8]);
}

#[test]
fn bolts_have_the_bits_of_one_rank() {
    let changes = [("phases.0.until.time", "\"20 ms\"")];
    same_for_any_ranks("spatial/bolted_wedge.toml", &changes, &[2, 3]);
}

#[test]
fn rigid_and_deformable_blocks_have_the_bits_of_one_rank() {
    let changes = [("phases.0.until.time", "\"10 us\"")];
    same_for_any_ranks("fracture/hybrid_blast.toml", &changes, &[2, 3]);
}

#[test]
fn implicit_steps_have_the_bits_of_one_rank() {
    let changes = [("phases.1.until.time", "\"20 ms\"")];
    same_for_any_ranks("verify/implicit/column.toml", &changes, &[2, 3]);
}

#[test]
fn steps_by_level_have_the_bits_of_one_rank() {
    let changes = [("phases.0.until.time", "\"0.2 ms\""), ("phases.0.levels", "3")];
    same_for_any_ranks("spatial/blast.toml", &changes, &[2, 3]);
}

#[test]
fn the_plane_has_the_bits_of_one_rank() {
    same_for_any_ranks("verify/engineering/bolt_plane_anchor.toml", &[], &[2, 3]);
}

#[test]
fn a_run_of_ranks_goes_on_with_any_other_number() {
    let (scene, changes) = (BLAST, SMALL_BLAST);
    let dir = tempfile::tempdir().unwrap();
    let [one, many] = ["one.run", "many.run"].map(|name| dir.path().join(name));
    let alone = run(job(scene, &changes), &one, Existing::Refuse, 1, &mut go).unwrap();
    let mut stop = |_: &mut Look<'_>| Control::Stop;
    let part = run_ranks(job(scene, &changes), &many, Existing::Refuse, [3, 1], &mut stop).unwrap();
    assert_eq!(part.ending, Ending::Stopped);
    assert!(part.manifest.steps < alone.manifest.steps);
    let mut looks = 0;
    let mut later = |_: &mut Look<'_>| {
        looks += 1;
        Control::stop_if(looks > 1)
    };
    let part = resume_ranks(&many, [2, 1], &mut later).unwrap();
    assert_eq!(part.ending, Ending::Stopped);
    let done = resume_ranks(&many, [5, 1], &mut go).unwrap();
    assert_eq!(done.ending, Ending::Finished);
    assert_eq!(done.manifest.state_hash, alone.manifest.state_hash);
    assert_eq!(Manifest::read(&many).unwrap().state_hash, alone.manifest.state_hash);
    let without = |mut all: BTreeMap<PathBuf, Vec<u8>>| {
        // Which steps have checkpoints depends on when the run was stopped.
        all.retain(|name, _| !name.starts_with("checkpoints"));
        all
    };
    assert!(without(files(&one)) == without(files(&many)));
}
