//! Runs that are not to be believed: they stop, and say why.

use super::bench::{Bench, FALL, Said};

const CORNER: &str =
    include_str!("../../../../scenes/verify/spatial-contact/b3_corner_impact.toml");

const CROOKED: &str = include_str!("../../../../scenes/verify/spatial-deformable/crooked_cut.toml");

const REST: &str = include_str!("../../../../scenes/verify/planar/rest.toml");

const BUILT_IN: &str =
    include_str!("../../../../scenes/verify/spatial-contact/overlapping_start.toml");

/// Runs a changed scene of a falling block into `a.run`.
fn run(changes: &[(&str, &str)]) -> (Bench, Said) {
    let bench = Bench::new();
    let mut scene = FALL.to_owned();
    for (old, new) in changes {
        assert!(scene.contains(old), "{old}");
        scene = scene.replace(old, new);
    }
    bench.file("a.toml", scene);
    let said = bench.run(&["run", "a.toml", "--out", "a.run", "-q"]);
    (bench, said)
}

#[test]
fn a_formula_that_is_no_number_is_named_with_its_line() {
    let motion = "motion = { velocity = { x = { formula = \"0.1*log(0.15 - t)\" } } }";
    let (bench, said) = run(&[("fixed = {}", motion)]);
    let said = said.expect(1);
    let said = said.warns(&["`floor`", "velocity along x", "0.1*log(0.15 - t)", "line "]);
    assert!(!said.err.contains("time step"), "{}", said.err);
    // The free fall was over before that, but the run is not what it should have been.
    let checks = bench.read("a.run/checks.jsonl");
    assert!(checks.contains("failed") && !checks.contains("passed"), "{checks}");
    assert!(checks.contains("before its end"), "{checks}");
}

/// A bar in space on whose left face something acts, and what is on it.
fn bar(condition: &str, block: &str) -> String {
    let joints = if block.is_empty() {
        "elastic = true"
    } else {
        "brittle_bond = { thickness = \"1 mm\", elastic = true }"
    };
    format!(
        "riprap = 1\ntitle = \"a bar\"\n[space.spatial]\ngravity = \"0 m/s2\"\n\
         [materials.rock]\ndensity = \"2700 kg/m3\"\nyoung = \"50 GPa\"\npoisson = 0.2\n\
         [interfaces.default]\n{joints}\n\
         [[blocks]]\nname = \"bar\"\nmaterial = \"rock\"\ngrid.box = {{ size = [\"4 m\", \"1 m\", \"1 m\"], cell = \"1 m\" }}\n{block}\n\
         {condition}\n\
         [[boundaries]]\nname = \"hold\"\non.plane = \"x-max\"\nheld = {{}}\n\
         [[phases]]\nname = \"run\"\nuntil = {{ time = \"4 ms\" }}\n"
    )
}

/// The run said that loads had been looked at and were numbers, and that the step alone was not to blame.
#[test]
fn a_formula_of_a_boundary_that_is_no_number_is_named_with_its_condition() {
    let bench = Bench::new();
    let left = "[[boundaries]]\nname = \"push\"\non.plane = \"x-min\"\n";
    let moved = "moved.velocity.x = { formula = \"y*sqrt(0.002-t)\" }";
    let soft = "mechanics.deformable = {}";
    let cases = [
        (
            format!("{left}pressure = {{ value = \"1 MPa\", time = {{ formula = \"sqrt(0.002-t)\" }} }}"),
            "",
            ["boundary `push`", "pressure.time", "`sqrt(0.002-t)`"],
        ),
        (
            format!("{left}traction = {{ value = [\"1 MPa\", \"0 Pa\", \"0 Pa\"], time = {{ formula = \"sqrt(0.002-t)\" }} }}"),
            "",
            ["boundary `push`", "traction.time", "`sqrt(0.002-t)`"],
        ),
        (
            format!("{left}{moved}"),
            "",
            ["boundary `push`", "velocity along x", "`y*sqrt(0.002-t)`"],
        ),
        (
            format!("{left}{moved}"),
            soft,
            ["boundary `push`", "velocity of nodes", "`y*sqrt(0.002-t)`"],
        ),
        (
            "[[supports]]\nname = \"grip\"\non.nodes = { min = [\"0 m\", \"0 m\", \"0 m\"], max = [\"0 m\", \"1 m\", \"1 m\"] }\n\
             motion.velocity.x = { formula = \"y*sqrt(0.002-t)\" }"
                .to_owned(),
            soft,
            ["support `grip`", "velocity of nodes", "`y*sqrt(0.002-t)`"],
        ),
    ];
    for (k, (condition, block, words)) in cases.into_iter().enumerate() {
        bench.file("a.toml", bar(&condition, block));
        let out = format!("{k}.run");
        let said = bench.run(&["run", "a.toml", "--out", &out, "-q"]).expect(1);
        let said = said.warns(&words).warns(&["not finite at this time", "line "]);
        assert!(!said.err.contains("have finite values"), "{}", said.err);
        assert!(!said.err.contains("time step"), "{}", said.err);
    }
}

/// They were taken, and the run ended with a kinetic energy that is not finite, or in a panic.
#[test]
fn numbers_beyond_all_sense_are_refused_by_their_key() {
    let still = "velocity = [\"0 m/s\", \"0 m/s\"]";
    let dashpot = "time_step = \"10 us\"\ndamping = { stiffness = \"1e300 s\" }";
    let cases = [
        (still, format!("{still}\nspin = \"1e10 rad/s\""), "`spin` is out of range"),
        ("time_step = \"10 us\"", dashpot.to_owned(), "`stiffness` is out of range"),
        ("2000 kg/m3", "1e300 kg/m3".to_owned(), "`density` is out of range"),
        ("2000 kg/m3", "1e-200 kg/m3".to_owned(), "`density` is out of range"),
    ];
    for (old, new, words) in cases {
        let said = run(&[(old, &new)]).1.expect(2);
        said.warns(&[words, "in SI units"]);
    }
    // What is left gets an answer.
    for (old, new) in [
        ("2000 kg/m3", "1e30 kg/m3".to_owned()),
        ("2000 kg/m3", "1e-30 kg/m3".to_owned()),
        ("time_step = \"10 us\"", dashpot.replace("300", "30")),
    ] {
        let said = run(&[(old, &new), ("\"0.2 m\"]", "\"0 m\"]")]).1;
        assert!(matches!(said.code, Some(0..=1)), "{new}: {said:?}");
        assert!(!said.err.contains("kinetic energy is not finite"), "{new}: {}", said.err);
    }
}

#[test]
fn a_step_far_above_the_stable_one_stops_the_run_and_is_named() {
    let long = ("time_step = \"10 us\"", "time_step = \"20 ms\"\nmax_residual = 0.1");
    let touching = ("\"0.2 m\"]", "\"0 m\"]");
    let end = ("time = \"0.2 s\"", "time = \"2 s\"");
    let (bench, said) = run(&[long, touching, end]);
    said.expect(1).warns(&["times the stable step"]);
    assert!(bench.read("a.run/manifest.json").contains("\"ended\": \"unstable\""));
}

/// They were those of the last row of `energy.csv`: of the start, at which nothing had moved.
#[test]
fn the_energies_of_a_run_that_is_stopped_are_those_of_its_last_state() {
    let bench = Bench::new();
    let fast = FALL
        .replace("velocity = [\"0 m/s\", \"0 m/s\"]", "velocity = [\"0 m/s\", \"-30 m/s\"]")
        .replace("100 MPa/m", "1 MPa/m");
    bench.file("a.toml", fast);
    let said = bench.run(&["run", "a.toml"]).expect(1);
    let line = said.out.lines().find(|line| line.starts_with("energy"));
    let line = line.unwrap_or_else(|| panic!("{}", said.out));
    assert!(line.starts_with("energy at t = ") && line.contains("contact normal"), "{line}");
    let table = bench.read("a.run/energy.csv");
    assert!(!line.contains("t = 0 s"), "{line}\n{table}");
}

#[test]
fn never_writes_no_frame() {
    let (bench, said) = run(&[("every = \"50 ms\"", "every = \"never\"")]);
    said.expect(0);
    let frames = bench.path("a.run/frames").read_dir().unwrap();
    assert_eq!(frames.count(), 0);
    assert!(!bench.read("a.run/run.pvd").contains("DataSet"));
}

#[test]
fn the_end_of_a_phase_says_why() {
    let (bench, said) = run(&[("time = \"0.2 s\"", "time = \"1 s\", steps = 30")]);
    // The check is read later than that.
    said.expect(1);
    let events = bench.read("a.run/events.jsonl");
    assert!(events.contains("\"reason\":\"steps\""), "{events}");
}

#[test]
fn the_step_is_blamed_only_where_half_of_it_was_tried() {
    // A step far above the stable one: with half the stable one the stone lands.
    let long = ("time_step = \"10 us\"", "time_step = \"20 ms\"");
    let touching = ("\"0.2 m\"]", "\"0 m\"]");
    let end = ("time = \"0.2 s\"", "time = \"2 s\"");
    let said = run(&[long, touching, end]).1.expect(1);
    said.warns(&["with half the stable step", "the step is too long"]);
    // A contact too soft for the stone: no step helps.
    let soft = ("100 MPa/m", "1 MPa/m");
    let fast = ("velocity = [\"0 m/s\", \"0 m/s\"]", "velocity = [\"0 m/s\", \"-30 m/s\"]");
    let auto = ("time_step = \"10 us\"", "");
    let said = run(&[soft, fast, auto, touching]).1.expect(1);
    let said = said.warns(&["with half the step stopped as well", "not the cause"]);
    assert!(!said.err.contains("step is too long"), "{}", said.err);
}

/// A corner that meets a floor: nothing but the contact itself bounds the step.
#[test]
fn a_smaller_safety_shortens_the_steps_of_found_contacts() {
    let bench = Bench::new();
    bench.file("a.toml", CORNER);
    let steps = |safety: &str| {
        let set = format!("phases.impact.safety={safety}");
        let args = ["run", "a.toml", "--out", "a.run", "-q", "--force", "--set", &set];
        bench.run(&args).expect(0);
        let manifest: serde_json::Value =
            serde_json::from_str(&bench.read("a.run/manifest.json")).unwrap();
        manifest["steps"].as_f64().unwrap()
    };
    // The flight before and after the impact does not change.
    let ratio = steps("0.05") / steps("0.5");
    assert!((3.0..10.0).contains(&ratio), "{ratio}");
}

#[test]
fn no_block_passes_through_a_floor_in_silence() {
    for stiffness in ["1 MPa/m", "10 MPa/m", "100 MPa/m", "1 GPa/m", "10 GPa/m"] {
        for speed in [1.0, 3.0, 10.0, 30.0, 100.0, 300.0] {
            let soft = ("100 MPa/m", stiffness);
            let fast = format!("velocity = [\"0 m/s\", \"-{speed} m/s\"]");
            let check = "at = \"0.1 s\"\nformula = \"-0.5*10*t^2\"\nrelative = 1e-6\n";
            let above = "at = \"end\"\nbetween = [\"-0.5 m\", \"1000 m\"]\n";
            let (_, said) = run(&[
                soft,
                ("velocity = [\"0 m/s\", \"0 m/s\"]", &fast),
                ("time_step = \"10 us\"", ""),
                ("\"0.2 m\"]", "\"0 m\"]"),
                (check, above),
            ]);
            match said.code {
                Some(0) => {}
                Some(1) => assert!(said.err.contains("pass through"), "{said:?}"),
                _ => panic!("{stiffness}, {speed} m/s: {said:?}"),
            }
        }
    }
}

/// A block that falls on terrain, and a deformable one that falls on a floor: each looked at only now and then, they could lie deep in
/// it between two looks.
#[test]
fn no_block_sinks_into_the_ground_in_silence() {
    let bench = Bench::new();
    bench.file("ground.csv", "x_m,y_m,z_m\n-4,-4,0\n4,-4,0\n-4,4,0\n4,4,0\n");
    let head = "riprap = 1\ntitle = \"a fall\"\nspace.spatial.gravity = \"9.81 m/s2\"\n\
        [materials.rock]\ndensity = \"2500 kg/m3\"\nyoung = \"20 GPa\"\npoisson = 0.25\n";
    let block = "[[blocks]]\nname = \"a\"\nmaterial = \"rock\"\nvelocity = [\"0 m/s\", \"0 m/s\", \"-20 m/s\"]\n\
        brick = { size = [\"0.5 m\", \"0.5 m\", \"0.5 m\"], corner = [\"-0.2 m\", \"-0.2 m\", \"0.1 m\"] }\n";
    let phase = "[[phases]]\nname = \"fall\"\nuntil.time = \"0.05 s\"\nmax_residual = 1.0\n\
        [[outputs]]\nhistory = { name = \"d\", field = \"model.max_closing\", every = \"1 steps\" }\n";
    let (mut fine, mut warned, mut stopped) = (0, 0, 0);
    for stiffness in ["3 MPa/m", "10 MPa/m", "30 MPa/m", "100 MPa/m", "1 GPa/m"] {
        let law = "damping_ratio = 0\nfriction_angle = \"30 deg\"";
        let terrain = format!(
            "{head}[interfaces.default]\n{law}\nnormal_stiffness = \"{stiffness}\"\n\
             [[blocks]]\nname = \"ground\"\nmaterial = \"rock\"\nterrain.csv = \"ground.csv\"\n{block}{phase}"
        );
        let floor = format!(
            "{head}[interfaces.default]\n{law}\nnormal_stiffness = \"{stiffness}\"\n\
             [[blocks]]\nname = \"ground\"\nmaterial = \"rock\"\n\
             brick = {{ size = [\"8 m\", \"8 m\", \"1 m\"], corner = [\"-4 m\", \"-4 m\", \"-1 m\"] }}\n\
             {block}mechanics.deformable = {{ strain = \"total_lagrangian\" }}\n\
             [[supports]]\non.block = \"ground\"\nfixed = {{}}\n{phase}"
        );
        for scene in [terrain, floor] {
            bench.file("a.toml", scene);
            let said = bench.run(&["run", "a.toml", "--out", "a.run", "-q", "--force"]);
            let depth = bench.read("a.run/histories.csv");
            let values = depth.lines().skip(1).filter_map(|line| {
                let value = line.rsplit(',').next()?;
                value.parse::<f64>().ok()
            });
            let deepest = values.fold(0.0, f64::max);
            match said.code {
                Some(0) if deepest > 0.4 => {
                    assert!(said.err.contains("were pressed"), "{deepest} {said:?}");
                    warned += 1;
                }
                Some(0) => fine += 1,
                Some(1) => {
                    assert!(said.err.contains("pass through"), "{said:?}");
                    stopped += 1;
                }
                _ => panic!("{stiffness}: {said:?}"),
            }
        }
    }
    assert!(fine > 1 && warned > 1 && stopped > 1, "{fine} {warned} {stopped}");
}

/// A heavy block at rest, a light one that nothing holds, and a phase that ends when forces are balanced.
fn pile(gravity: &str, velocity: &str, until: &str) -> (Bench, Said) {
    let heavy = "\n[materials.lead]\ndensity = \"2e7 kg/m3\"\n\n[[blocks]]\nname = \"pile\"\nmaterial = \"lead\"\n\
        rectangle = { size = [\"1 m\", \"1 m\"], corner = [\"-1.9 m\", \"0 m\"] }\n\n[[supports]]";
    run(&[
        ("[[supports]]", heavy),
        ("100 MPa/m", "1e13 Pa/m"),
        ("gravity = [\"0 m/s2\", \"-10 m/s2\"]", gravity),
        ("velocity = [\"0 m/s\", \"0 m/s\"]", velocity),
        ("0.2 m\"]", "5 m\"]"),
        ("name = \"fall\"", "name = \"fall\"\nkind = \"static\""),
        ("until = { time = \"0.2 s\" }", until),
        ("time_step = \"10 us\"", ""),
    ])
}

#[test]
fn a_falling_block_does_not_hide_behind_the_balance_of_others() {
    let own = "gravity = [\"0 m/s2\", \"-10 m/s2\"]";
    let until = "until = { unbalanced = 1e-2, time = \"0.2 s\" }";
    let (bench, said) = pile(own, "velocity = [\"0 m/s\", \"0 m/s\"]", until);
    let said = said.warns(&["not every block is", "`stone`", "falls or slides"]);
    let events = bench.read("a.run/events.jsonl");
    assert!(events.contains("but not on every block"), "{events} {said:?}");
    assert!(events.contains("\"least_balanced\":{\"block\":\"stone\""), "{events}");
    // Nothing pushes the stone, but it goes.
    let none = "gravity = [\"0 m/s2\", \"0 m/s2\"]";
    let until = "until = { time = \"0.1 s\" }";
    let (_, said) = pile(none, "velocity = [\"0 m/s\", \"30 m/s\"]", until);
    said.warns(&["reached its limit of time", "`stone` moves", "times its own size"]);
}

/// A slice has residuals that are its thickness times larger, and round-off too.
#[test]
fn round_off_of_a_thick_slice_stops_no_run() {
    let bench = Bench::new();
    bench.file("rest.toml", REST);
    let thick = "space.planar.thickness=1000 km";
    bench.run(&["run", "rest.toml", "-q", "--set", thick]).expect(0);
}

/// The phase can end in balance, with the block somewhere else.
#[test]
fn a_block_that_was_thrown_out_of_another_is_named() {
    let bench = Bench::new();
    let told = |stiffness: &str| {
        // With the default rebound, dashpots keep it where it is.
        let law = format!("\"{stiffness}\"\ndamping_ratio = 0.1");
        let scene = BUILT_IN.replace("\"200 MPa/m\"", &law);
        bench.file("a.toml", scene);
        let said = bench.run(&["run", "a.toml", "--out", "a.run", "-q", "--force"]);
        said.err.contains("`pyramid` had travelled") && said.err.contains("initial overlaps")
    };
    assert!(told("100 GPa/m"));
    assert!(!told("200 MPa/m"));
}

/// A fast block makes the guard against tunnelling shorten what the scene gives.
#[test]
fn a_given_time_step_that_is_made_shorter_is_told_once_with_both_numbers() {
    let fast = ("velocity = [\"0 m/s\", \"0 m/s\"]", "velocity = [\"0 m/s\", \"300 m/s\"]");
    let long = ("time_step = \"10 us\"", "time_step = \"2 ms\"");
    let (bench, said) = run(&[fast, long]);
    let wanted = "the `time_step` of phase `fall`, 2.000e-3 s, was reduced to as little as ";
    assert_eq!(said.err.matches(wanted).count(), 1, "{said:?}");
    assert!(
        said.err.contains("s because of a block that moves fast for its size (step "),
        "{said:?}"
    );
    assert!(bench.read("a.run/manifest.json").contains("was reduced to as little as"));
    let said = bench.run(&["check", "a.toml"]);
    assert_eq!(said.err.matches(wanted).count(), 1, "{said:?}");
    assert!(!run(&[]).1.err.contains("was reduced"));
}

/// Back at the height that it fell from, a block has next to nothing of what gravity put in: its own motion was called energy from nowhere.
#[test]
fn a_block_that_bounces_without_loss_is_not_stopped_at_its_highest_point() {
    for height in ["0.3 m", "1.3 m", "1.7 m"] {
        let bench = Bench::new();
        bench.file(
            "a.toml",
            format!(
                "riprap = 1\ntitle = \"a block bounces\"\nspace.planar.gravity = [\"0 m/s2\", \"-10 m/s2\"]\n\
                 materials.rock.density = \"2500 kg/m3\"\n\
                 [interfaces.default]\nnormal_stiffness = \"1 GPa/m\"\nshear_stiffness = \"1 GPa/m\"\nfriction_angle = \"30 deg\"\ndamping_ratio = 0\n\
                 [[blocks]]\nname = \"floor\"\nmaterial = \"rock\"\nrectangle = {{ size = [\"10 m\", \"1 m\"], corner = [\"-5 m\", \"-1 m\"] }}\n\
                 [[blocks]]\nname = \"stone\"\nmaterial = \"rock\"\nrectangle = {{ size = [\"1 m\", \"1 m\"], corner = [\"0 m\", \"{height}\"] }}\n\
                 [[supports]]\non.block = \"floor\"\nfixed = {{}}\n\
                 [[phases]]\nname = \"bounce\"\nuntil.time = \"2.1 s\"\n"
            ),
        );
        bench.run(&["run", "a.toml", "-q"]).expect(0);
    }
}

/// The forces of a relaxing phase were balanced as a whole: a block that hangs in the air weighs nothing beside the pressure on the other one.
#[test]
fn a_deformable_block_that_falls_is_told_beside_one_under_pressure() {
    let bench = Bench::new();
    let scene = "riprap = 1\ntitle = \"one is pressed, one falls\"\nspace.spatial.gravity = \"9.81 m/s2\"\n\
         [materials.rock]\ndensity = \"2700 kg/m3\"\nyoung = \"50 GPa\"\npoisson = 0.2\n\
         [interfaces.default]\nbrittle_bond = { thickness = \"1 mm\", elastic = true }\n\
         [[blocks]]\nname = \"base\"\nmaterial = \"rock\"\nbrick = { size = [\"4 m\", \"4 m\", \"1 m\"], corner = [\"-2 m\", \"-2 m\", \"-1 m\"] }\n\
         mechanics.deformable = {}\n\
         [[blocks]]\nname = \"roof\"\nmaterial = \"rock\"\nbrick = { size = [\"0.2 m\", \"0.2 m\", \"0.2 m\"], corner = [\"0 m\", \"0 m\", \"3 m\"] }\n\
         mechanics.deformable = {}\n\
         [[boundaries]]\nname = \"bottom\"\non.plane = \"z-min\"\nheld = {}\n\
         [[boundaries]]\nname = \"side\"\non.plane = \"x-min\"\npressure.value = \"100 MPa\"\n\
         [[phases]]\nname = \"press\"\nkind = \"static\"\nuntil = { unbalanced = 1e-4 }\n";
    bench.file("a.toml", scene);
    let said = bench.run(&["run", "a.toml", "-q"]).expect(0);
    let said = said.warns(&["not every block is", "`roof` is 100 %"]);
    assert!(!said.err.contains("`base`"), "{}", said.err);
    // Without balance nothing is said of one.
    bench.file("b.toml", format!("{scene}iterations = 10\n"));
    let said = bench.run(&["run", "b.toml", "-q"]).expect(0);
    let said = said.warns(&[
        "without equilibrium",
        "reached its limit of iterations before every block",
        "`roof` is 100 %",
    ]);
    assert!(!said.err.contains("in overall equilibrium"), "{}", said.err);
}

#[test]
fn parts_that_are_too_crooked_to_be_cut_again_are_told() {
    let bench = Bench::new();
    bench.file("a.toml", CROOKED);
    let said = bench.run(&["run", "a.toml", "--out", "a.run", "-q"]);
    let said = said.expect(0);
    said.warns(&["10 blocks meet the cutting criterion but stay whole", "`snap`"]);
}
