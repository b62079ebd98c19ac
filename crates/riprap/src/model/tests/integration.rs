//! Implicit phases: what they take, what they refuse and with which words.

use super::*;
use crate::exec::Exec;
use crate::plan::{IMPLICIT_STEP, Integration, STATIC_STEP};
use crate::run::given_step;
use crate::run::simulation::Simulation;

const TWO: &str = r#"
riprap = 1
title = "t"
[space.spatial]
gravity = "9.81 m/s2"
[materials.rock]
density = "2500 kg/m3"
young = "20 GPa"
poisson = 0.25
[interfaces.default]
normal_stiffness = "1 GPa/m"
friction_angle = "30 deg"
[[blocks]]
name = "floor"
material = "rock"
brick = { size = ["4 m", "4 m", "1 m"], corner = ["-2 m", "-2 m", "-1 m"] }
[[blocks]]
name = "stone"
material = "rock"
brick = { size = ["1 m", "1 m", "1 m"], corner = ["-0.5 m", "-0.5 m", "0 m"] }
[[supports]]
on.block = "floor"
fixed = {}
[[phases]]
name = "rest"
until.time = "1 s"
integration = "implicit"
"#;

fn model(text: &str) -> Result<Model, String> {
    let parsed = parse(Source::new("t.toml", text)).map_err(|error| error.render())?;
    build(&parsed, "default", crate::run::engine::Kind::Spatial.fields())
        .map_err(|error| error.render())
}

/// What is said against a scene when it is checked, with its place.
fn refused(text: &str) -> String {
    let parsed = match parse(Source::new("t.toml", text)) {
        Ok(parsed) => parsed,
        Err(error) => return error.render(),
    };
    let model = match model(text) {
        Ok(model) => model,
        Err(error) => return error,
    };
    let simulation = Simulation::new(model.setup, model.plan, Exec::serial()).expect("built");
    given_step::check(&simulation).err().map_or(String::new(), |e| e.at(&parsed).render())
}

#[test]
fn dry_blocks_are_taken_with_steps_of_their_own() {
    assert_eq!(refused(TWO), "");
    let phase = &model(TWO).expect("good").plan.phases[0];
    assert_eq!(phase.integration, Integration::Implicit);
    assert_eq!(phase.time_step, TimeStep::Given { dt: IMPLICIT_STEP });
    // Longer than any explicit step of contacts.
    assert_eq!(refused(&format!("{TWO}time_step = \"5 ms\"\n")), "");
}

#[test]
fn what_implicit_phases_do_not_take_is_named_with_place_and_remedy() {
    let strong = "cohesion = \"1 MPa\"\ntension = \"1 MPa\"\nfriction_angle";
    let whole = TWO.replace("friction_angle", &format!("failure = \"face\"\n{strong}"));
    // Joints that fail point by point are taken.
    let dilates = format!("dilation_angle = \"5 deg\"\ndilation_end = \"5 mm\"\n{strong}");
    for law in [strong, &dilates] {
        assert_eq!(refused(&TWO.replace("friction_angle", law)), "");
    }
    // So are those that fail as one face.
    assert_eq!(refused(&whole), "");
    let parts = TWO.replace(
        "brick = { size = [\"1 m\", \"1 m\", \"1 m\"], corner = [\"-0.5 m\", \"-0.5 m\", \"0 m\"] }",
        "parts = [\n  { brick = { size = [\"1 m\", \"1 m\", \"1 m\"], corner = [\"-0.5 m\", \"-0.5 m\", \"0 m\"] } },\n  \
         { brick = { size = [\"1 m\", \"1 m\", \"0.5 m\"], corner = [\"0.5 m\", \"-0.5 m\", \"0 m\"] } },\n]",
    );
    // So are blocks of glued parts.
    assert_ne!(parts, TWO);
    assert_eq!(refused(&parts), "");
    let off = TWO.replace("[space.spatial]", "[space.spatial]\nfound_contacts = false");
    let viscous = format!(
        "{TWO}[[boundaries]]\nname = \"top\"\non = {{ block = \"stone\", side = \"z-max\" }}\nviscous = {{}}\n"
    );
    // Conditions on faces are taken, and what steps damp of a wave is told, but where nothing moves.
    assert_eq!(refused(&viscous), "");
    let told = |text: &str| {
        let warnings = model(text).expect("good").warnings;
        let waves = warnings.iter().filter(|w| w.code == "phase.waves");
        waves.map(|w| w.message.clone()).collect::<Vec<_>>()
    };
    let words = "phase `rest` is implicit, and boundary `top` is there for waves: steps of 1.0e-3 s halve a wave of 3.51e1 Hz in each period";
    let [said] = &told(&viscous)[..] else { panic!("one warning") };
    assert!(said.starts_with(words), "{said}");
    let held = viscous.replace("viscous = {}", "held = {}");
    let quiet = viscous.replace("until.time = \"1 s\"", "kind = \"static\"\nuntil.steps = 10");
    let explicit = viscous.replace("\"implicit\"", "\"explicit\"");
    for text in [TWO, &held, &quiet, &explicit] {
        assert!(told(text).is_empty());
    }
    let said = refused(&off);
    assert!(said.contains("contact detection is switched off"), "{said}");
    assert!(said.contains("phase `rest` is implicit") && said.contains("t.toml:"), "{said}");
    assert!(said.contains("or use `integration = \"explicit\"`"), "{said}");
    // Explicit phases take all of it.
    assert_eq!(refused(&off.replace("\"implicit\"", "\"explicit\"")), "");
}

/// Contacts that stiffen: what knows the law, and what refuses it by name.
#[test]
fn contacts_that_stiffen_are_those_of_rigid_blocks_in_explicit_steps() {
    let explicit = TWO.replace("\"implicit\"", "\"explicit\"");
    let with = |text: &str, depth: &str| {
        text.replace("friction_angle", &format!("stiffening_depth = {depth}\nfriction_angle"))
    };
    let good = with(&explicit, "0.2");
    assert_eq!(refused(&good), "");
    let Setup::Spatial(setup) = model(&good).expect("good").setup else { panic!("in space") };
    assert_eq!(setup.interfaces[0].joint.stiffening, 0.2);
    let said = refused(&with(TWO, "0.2"));
    assert!(said.contains("contacts of `interfaces.default` stiffen"), "{said}");
    for depth in ["0", "1.5", "\"5 cm\""] {
        let said = refused(&with(&explicit, depth));
        assert!(said.contains("stiffening_depth") && said.contains("t.toml:"), "{depth}: {said}");
    }
    let levels = good.replace("\"explicit\"", "\"explicit\"\nlevels = 3");
    let said = refused(&levels);
    assert!(said.contains("contacts that stiffen (`stiffening_depth`)"), "{said}");
    let soft = good.replace("name = \"stone\"", "name = \"stone\"\nmechanics.deformable = {}");
    let said = refused(&soft);
    assert!(said.contains("applies to contacts between rigid blocks only"), "{said}");
    let off = good.replace("[space.spatial]", "[space.spatial]\nfound_contacts = false");
    let warnings = model(&off).expect("good").warnings;
    assert!(warnings.iter().any(|w| w.message.contains("stiffening_depth")));
}

/// What bounds explicit steps of joints is nothing to implicit ones, and no cause for a warning.
#[test]
fn a_stable_step_is_named_for_explicit_phases_alone() {
    let strong = "cohesion = \"1 MPa\"\ntension = \"1 MPa\"\nfriction_angle";
    let joined = TWO.replace("friction_angle", strong);
    let of = |text: &str| {
        let model = model(text).expect("good");
        let forecast = crate::run::forecast::forecast(&model.setup, &model.plan).expect("built");
        let named = forecast.warnings.iter().any(|w| w.contains("stable step"));
        (forecast.stable_time_step.is_some(), named)
    };
    assert_eq!(of(&joined), (false, false));
    let explicit = joined.replace("\"implicit\"", "\"explicit\"\ntime_step = \"1 ms\"");
    assert!(of(&explicit).0);
}

#[test]
fn keys_that_have_no_meaning_in_an_implicit_phase_are_refused() {
    let said = refused(&format!("{TWO}damping.local = 0.5\n"));
    let words = "phase `rest` is implicit and has local damping";
    assert!(said.contains(words) && said.contains("t.toml:"), "{said}");
    let plane = format!(
        "{HEAD}[[blocks]]\nname = \"a\"\nmaterial = \"rock\"\nrectangle = {{ size = [\"1 m\", \"1 m\"], corner = [\"0 m\", \"0 m\"] }}\n\
         [[phases]]\nname = \"rest\"\nuntil.time = \"1 s\"\nintegration = \"implicit\"\n"
    );
    let said = refused(&plane);
    assert!(said.contains("integration") && said.contains("space"), "{said}");
}

#[test]
fn a_share_of_the_stable_step_has_no_effect_in_an_implicit_phase() {
    let said = |text: &str| {
        let warnings = model(text).expect("good").warnings;
        warnings.iter().any(|w| w.message == "`safety` in phases.rest has no effect")
    };
    let share = format!("{TWO}safety = 0.3\n");
    assert!(said(&share));
    for other in ["explicit", "automatic"] {
        assert!(!said(&share.replace("\"implicit\"", &format!("\"{other}\""))), "{other}");
    }
}

#[test]
fn damping_that_implicit_phases_do_not_read_is_told() {
    let told = |text: &str| {
        let warnings = model(text).expect("good").warnings;
        let unused = warnings.iter().filter(|w| w.code == "key.unused");
        unused.map(|w| w.message.clone()).collect::<Vec<_>>()
    };
    let damped = |keys: &str, kind: &str| format!("{TWO}{kind}damping = {{ {keys} }}\n");
    let all = "mass = \"1 1/s\", rotation = \"1 1/s\", stiffness = \"1 us\"";
    assert_eq!(told(&damped(all, "")), ["`stiffness` in `damping` of phase `rest` has no effect"]);
    assert_eq!(
        told(&damped(all, "kind = \"static\"\n")),
        ["`mass`, `rotation`, `stiffness` in `damping` of phase `rest` have no effect"]
    );
    assert!(told(&damped("mass = \"1 1/s\"", "")).is_empty());
    let explicit = |text: &str| text.replace("\"implicit\"", "\"explicit\"");
    assert!(told(&explicit(&damped(all, ""))).is_empty());

    let ratio = TWO.replace("friction_angle", "damping_ratio = 0.5\nfriction_angle");
    assert_eq!(told(&ratio), ["`damping_ratio` in interfaces.default has no effect"]);
    assert!(told(&explicit(&ratio)).is_empty());
    let automatic = ratio.replace("\"implicit\"", "\"automatic\"");
    assert!(told(&automatic).is_empty());
    // A variant, or another phase, reads it.
    let varied = format!("{ratio}[variants.waves]\n\"phases.rest.integration\" = \"explicit\"\n");
    assert!(told(&varied).is_empty());
    let next = "[[phases]]\nname = \"shake\"\nuntil.time = \"1 s\"\n";
    assert!(told(&format!("{ratio}{next}")).is_empty());
    let later = format!("{TWO}interfaces.default.damping_ratio = 0.1\n");
    let of_phase = ["`damping_ratio` in phases.rest.interfaces.default has no effect"];
    assert_eq!(told(&later), of_phase);
    assert!(told(&format!("{later}{next}")).is_empty());
}

/// Friction of a driven wedge has no rest; a block that lies and slides does.
#[test]
fn friction_that_does_not_settle_is_reported() {
    let run = |text: &str| {
        let model = model(text).expect("good");
        let mut simulation =
            Simulation::new(model.setup, model.plan, Exec::serial()).expect("built");
        simulation.run().expect("goes on");
        simulation.warnings().iter().any(|w| w.contains("the pressure that limits friction"))
    };
    let wedge = include_str!("../../../../../scenes/verify/implicit/wedge.toml");
    assert!(run(wedge));
    let slides = TWO.replace("corner = [\"-0.5 m\", \"-0.5 m\", \"0 m\"] }", "corner = [\"-0.5 m\", \"-0.5 m\", \"0 m\"] }\nvelocity = [\"2 m/s\", \"0 m/s\", \"0 m/s\"]");
    assert_ne!(slides, TWO);
    assert!(!run(&slides));
}

/// A static implicit phase comes to rest within few steps, with a ledger that closes; motion goes on from rest.
#[test]
fn a_static_phase_settles_in_few_steps() {
    let quiet = TWO.replace(
        "until.time = \"1 s\"",
        "kind = \"static\"\nuntil = { unbalanced = 1e-6, steps = 100 }",
    );
    assert_ne!(quiet, TWO);
    let run = |text: &str| {
        let model = model(text).expect("good");
        let mut simulation =
            Simulation::new(model.setup, model.plan, Exec::serial()).expect("built");
        simulation.run().expect("rests");
        simulation
    };
    let still = run(&quiet);
    assert_eq!(still.plan().phases[0].time_step, TimeStep::Given { dt: STATIC_STEP });
    assert!(still.steps() < 30, "{}", still.steps());
    let balance = still.view().balance();
    assert!(balance.residual_relative().abs() < 1e-6, "{:e}", balance.residual_relative());
    let moves = format!(
        "{quiet}[[phases]]\nname = \"go\"\nuntil.time = \"10 ms\"\nintegration = \"implicit\"\n"
    );
    let gone = run(&moves);
    assert_eq!(gone.steps(), still.steps() + 10);
    assert!(gone.view().kinetic() < 1e-12, "{:e}", gone.view().kinetic());
}

/// Steps by level, and with what they do not go.
#[test]
fn levels_are_refused_where_they_do_not_work() {
    let levels = TWO.replace("integration = \"implicit\"", "levels = 3");
    assert_eq!(refused(&levels), "");
    let local = levels.replace("levels = 3", "levels = 3\ndamping.local = 0.5");
    assert!(refused(&local).contains("local damping"), "{}", refused(&local));
    let blind = levels.replace("gravity =", "found_contacts = false\ngravity =");
    assert!(refused(&blind).contains("has no effect"), "{}", refused(&blind));
}
