//! Keys without effect are reported, conditions without effect refused.

use super::*;
use crate::run::simulation::Simulation;

const HEAD: &str = r#"
riprap = 1
title = "test"
space.spatial.gravity = "10 m/s2"
[materials.rock]
density = "2000 kg/m3"
young = "18 GPa"
poisson = 0.25
[interfaces.default.brittle_bond]
thickness = "1 mm"
elastic = true
[[blocks]]
name = "rock"
material = "rock"
grid.box = { size = ["2 m", "1 m", "1 m"], cell = "1 m" }
"#;

const DEFORMABLE: &str = "mechanics.deformable = {}\n";

/// The warnings of keys without effect.
fn unused(text: &str) -> Vec<String> {
    let parsed = parse(Source::new("t.toml", text)).unwrap_or_else(|error| panic!("{error}"));
    let model = build(&parsed, "default", INFOS).unwrap_or_else(|error| panic!("{error}"));
    let unused = model.warnings.iter().filter(|w| w.code == "key.unused");
    unused.map(|w| w.message.clone()).collect()
}

fn phase(keys: &str) -> String {
    format!("[[phases]]\nname = \"p\"\nuntil.time = \"1 ms\"\n{keys}\n")
}

/// In the plane and in space.
#[test]
fn a_second_support_of_a_block_is_told() {
    let solid = format!("{HEAD}{}", phase(""));
    let plane = r#"
riprap = 1
title = "test"
space.planar.gravity = ["0 m/s2", "-10 m/s2"]
materials.rock.density = "2000 kg/m3"
interfaces.default = { normal_stiffness = "1 GPa/m", friction_angle = "30 deg" }
[[blocks]]
name = "rock"
material = "rock"
rectangle = { size = ["2 m", "1 m"], corner = ["0 m", "0 m"] }
[[phases]]
name = "p"
until.time = "1 ms"
"#;
    let support =
        |fixed: &str| format!("[[supports]]\non.block = \"rock\"\nfixed = {{ {fixed} }}\n");
    for scene in [solid.as_str(), plane] {
        let told = |supports: &[&str]| {
            let all: String = supports.iter().map(|fixed| support(fixed)).collect();
            let parsed = parse(Source::new("t.toml", format!("{scene}{all}")))
                .unwrap_or_else(|error| panic!("{error}"));
            let model = build(&parsed, "default", &[]).unwrap_or_else(|error| panic!("{error}"));
            let codes = model.warnings.iter().map(|w| w.code);
            codes.filter(|code| *code == "supports.twice").count()
        };
        assert_eq!(told(&["y = false"]), 0);
        assert_eq!(told(&["y = false", "x = false"]), 1);
    }
}

#[test]
fn what_deformable_blocks_read_is_quiet() {
    let scene =
        format!("{HEAD}{DEFORMABLE}{}", phase("damping.mass = \"1 1/s\"\nbreaking = false"));
    assert_eq!(unused(&scene), Vec::<String>::new());
}

#[test]
fn keys_of_joints_beside_bonds_alone() {
    let head = HEAD.replace(
        "[interfaces.default.brittle_bond]",
        "[interfaces.default]\nnormal_stiffness = \"1 GPa/m\"\ndamping_ratio = 0.2\n[interfaces.default.brittle_bond]",
    );
    let scene = format!("{head}{DEFORMABLE}{}", phase(""));
    assert_eq!(unused(&scene), ["`normal_stiffness` in interfaces.default has no effect"]);
    let off = scene.replace(
        "space.spatial.gravity",
        "space.spatial.found_contacts = false\nspace.spatial.gravity",
    );
    assert_eq!(
        unused(&off),
        ["`normal_stiffness`, `damping_ratio` in interfaces.default have no effect"]
    );
    // A rigid block beside them brings no joint of rigid blocks; two do.
    let rigid = |count: u32| {
        format!(
            "[[blocks]]\nname = \"other\"\nmaterial = \"rock\"\nbrick = {{ size = [\"1 m\", \"1 m\", \"1 m\"], \
             corner = [\"2 m\", \"0 m\", \"0 m\"] }}\ncopies = {{ count = {count}, step = [\"1 m\", \"0 m\", \"0 m\"] }}\n"
        )
    };
    let friction = head.replace("damping_ratio", "friction_angle = \"30 deg\"\ndamping_ratio");
    let scene = format!("{friction}{DEFORMABLE}{}{}", rigid(2), phase(""));
    assert_eq!(unused(&scene), Vec::<String>::new());
}

#[test]
fn damping_that_deformable_blocks_do_not_have() {
    let scene = format!(
        "{HEAD}{DEFORMABLE}{}",
        phase("damping = { mass = \"1 1/s\", stiffness = \"1 ms\" }")
    );
    assert_eq!(unused(&scene), ["`stiffness` in `damping` of phase `p` has no effect"]);
    let settle = "kind = \"static\"\ndamping = { local = 0.5 }";
    let scene = format!("{HEAD}{DEFORMABLE}{}", phase(settle));
    assert_eq!(unused(&scene), ["`local` in `damping` of phase `p` has no effect"]);
}

/// A rigid block that can move keeps a static phase in true time: one that is held in part, or that a phase lets go.
#[test]
fn a_rigid_block_that_can_move_relaxes_in_true_time() {
    let platen = "[[blocks]]\nname = \"platen\"\nmaterial = \"rock\"\nbrick = { size = [\"2 m\", \"1 m\", \"1 m\"], corner = [\"0 m\", \"0 m\", \"1 m\"] }\n";
    let relaxes = |fixed: &str, keys: &str| -> Vec<bool> {
        let support = format!("[[supports]]\non.block = \"platen\"\nfixed = {{ {fixed} }}\n");
        let phases = phase("kind = \"static\"") + &phase(keys).replace("\"p\"", "\"q\"");
        let text = format!("{HEAD}{DEFORMABLE}{platen}{support}{phases}");
        let parsed = parse(Source::new("t.toml", text)).unwrap_or_else(|error| panic!("{error}"));
        let model = build(&parsed, "default", INFOS).unwrap_or_else(|error| panic!("{error}"));
        let phases = model.plan.phases.iter();
        let deform = phases.map(|phase| phase.deform.as_ref().expect("blocks deform"));
        deform.map(|deform| deform.relax.is_some()).collect()
    };
    assert_eq!(relaxes("", "kind = \"static\""), [true, true]);
    assert_eq!(relaxes("z = false", "kind = \"static\""), [false, false]);
    let released = "kind = \"static\"\nrelease = [\"platen\"]";
    assert_eq!(relaxes("", released), [true, false]);
}

#[test]
fn keys_of_deformable_blocks_without_any() {
    let friction = HEAD.replace(
        "[interfaces.default.brittle_bond]",
        "[interfaces.default]\nfriction_angle = \"30 deg\"\n[interfaces.default.brittle_bond]",
    );
    let keys = "breaking = false\ncut = {}\nrelaxation = {}";
    assert_eq!(
        unused(&format!("{friction}{}", phase(keys))),
        [
            "`thickness` in interfaces.default.brittle_bond has no effect",
            "`breaking`, `cut` in phase `p` have no effect",
            "`relaxation` in phase `p` has no effect",
        ]
    );
}

/// A deformable block meets a rigid floor by what `brittle_bond` says: what the interface itself says of stiffness and strength is for
/// two rigid blocks of which one is free.
#[test]
fn keys_of_joints_beside_bonds_need_two_rigid_blocks() {
    let given = HEAD.replace(
        "[interfaces.default.brittle_bond]",
        "[interfaces.default]\nnormal_stiffness = \"1 GPa/m\"\ncohesion = \"1 MPa\"\nresidual_cohesion = \"1 MPa\"\nrestitution = 0.5\n\
         [interfaces.default.brittle_bond]",
    );
    let floor = |name: &str| {
        format!(
            "[[blocks]]\nname = \"{name}\"\nmaterial = \"rock\"\n\
             brick = {{ size = [\"9 m\", \"9 m\", \"1 m\"], corner = [\"0 m\", \"0 m\", \"-2 m\"] }}\n"
        )
    };
    let held = |fixed: &str| format!("[[supports]]\non.block = \"floor\"\nfixed = {{ {fixed} }}\n");
    let scene = |floor: &str, held: &str, change: &str| {
        format!("{given}{DEFORMABLE}{floor}{held}{}", phase(change))
    };
    let told = [
        "`normal_stiffness`, `cohesion`, `residual_cohesion` in interfaces.default have no effect",
        "`cohesion` in phases.p.interfaces.default has no effect",
    ];
    let change = "interfaces.default.cohesion = \"1 kPa\"";
    let alone = scene(&floor("floor"), &held(""), change);
    let of_interfaces = |scene: &str| -> Vec<String> {
        let all = unused(scene).into_iter();
        all.filter(|m| m.contains("interfaces.default")).collect()
    };
    assert_eq!(of_interfaces(&alone), told);
    // A block that is released later can be pushed by others, and so can one that is held in part.
    let two = format!("{}{}", floor("floor"), floor("other").replace("-2 m", "-5 m"));
    let all = format!("{}{}", held(""), held("").replace("\"floor\"", "\"other\""));
    assert_eq!(of_interfaces(&scene(&two, &all, change)), told);
    let released = format!("release = [\"other\"]\n{change}");
    assert_eq!(of_interfaces(&scene(&two, &all, &released)), [""; 0]);
    let in_part = scene(&two, &held("x = false"), change);
    assert_eq!(of_interfaces(&in_part), [""; 0]);
}

#[test]
fn gravity_that_does_not_change_has_no_ramp() {
    let later = phase("gravity_ramp = \"1 ms\"").replace("\"p\"", "\"later\"");
    let scene = format!("{HEAD}{DEFORMABLE}{}{later}", phase("gravity_ramp = \"1 ms\""));
    assert_eq!(unused(&scene), ["`gravity_ramp` in phase `later` has no effect"]);
}

/// The first of two conditions on one face was dropped without a word.
#[test]
fn a_boundary_whose_faces_all_have_a_later_one_is_refused() {
    let side = |name: &str, what: &str| {
        format!("[[boundaries]]\nname = \"{name}\"\non.plane = \"x-min\"\n{what}\n")
    };
    let (absorb, push) =
        (side("absorb", "viscous = {}"), side("push", "pressure.value = \"1 MPa\""));
    let head = HEAD.replace("gravity = \"10 m/s2\"", "gravity = \"0 m/s2\"");
    for kind in ["", DEFORMABLE] {
        let friction = head.replace(
            "[interfaces.default.brittle_bond]",
            "[interfaces.default]\nfriction_angle = \"30 deg\"\n[interfaces.default.brittle_bond]",
        );
        let scene = format!("{friction}{kind}{absorb}{push}{}", phase(""));
        let Err(error) = Simulation::from_toml(&scene) else {
            panic!("accepted");
        };
        let text = error.to_string();
        assert!(text.contains("`absorb` has no effect") && text.contains("`push`"), "{text}");
        // A part of the faces may have another one.
        let part =
            absorb.replace("on.plane = \"x-min\"", "on = { block = \"rock\", side = \"x-min\" }");
        let whole = push.replace("on.plane = \"x-min\"", "on = { group = \"rock\" }");
        assert!(
            Simulation::from_toml(&format!("{friction}{kind}{whole}{part}{}", phase(""))).is_ok()
        );
    }
}

/// In the plane and in space.
#[test]
fn a_motion_at_the_start_that_a_support_prescribes_is_told() {
    let plane = |support: &str, reset: &str| {
        format!(
            r#"
riprap = 1
title = "test"
space.planar.gravity = ["0 m/s2", "-10 m/s2"]
materials.rock.density = "2000 kg/m3"
interfaces.default = {{ normal_stiffness = "1 GPa/m", friction_angle = "30 deg" }}
[[blocks]]
name = "rock"
material = "rock"
rectangle = {{ size = ["2 m", "1 m"], corner = ["0 m", "0 m"] }}
velocity = ["1 m/s", "0 m/s"]
spin = "1 rad/s"
{support}
{}"#,
            phase(reset)
        )
    };
    let told = |support: &str| unused(&plane(support, ""));
    let both = ["`velocity` in block `rock` has no effect", "`spin` in block `rock` has no effect"];
    let on = |what: &str| format!("[[supports]]\non.block = \"rock\"\n{what}\n");
    assert_eq!(told(&on("fixed = {}")), both);
    assert_eq!(told(&on("fixed = { rotation = false }")), both[..1]);
    // What is not held keeps its motion, a zero is none, and a motion that goes on with it is no contradiction.
    let quiet = [
        "fixed = { x = false, rotation = false }",
        "motion.velocity.x.constant = \"1 m/s\"",
        "motion.acceleration.x.constant = \"1 m/s2\"",
    ];
    for support in quiet {
        assert_eq!(told(&on(support)), Vec::<String>::new(), "{support}");
    }
    assert_eq!(told(&on("motion.velocity.x.constant = \"2 m/s\"")), both[..1]);
    assert_eq!(unused(&plane("", "reset = [\"velocities\"]")), both);
    assert_eq!(unused(&plane("", "")), Vec::<String>::new());

    let space = |support: &str| {
        let start = "velocity = [\"1 m/s\", \"0 m/s\", \"0 m/s\"]\n";
        let head = HEAD.replace(
            "[interfaces.default.brittle_bond]\nthickness = \"1 mm\"\nelastic = true",
            "[interfaces.default]\nfriction_angle = \"30 deg\"",
        );
        unused(&format!("{head}{start}{support}{}", phase("")))
    };
    assert_eq!(space(&on("fixed = {}")), both[..1]);
    assert_eq!(space(&on("fixed = { x = false }")), Vec::<String>::new());
    // Of a grid a part may be held.
    let part = "[[supports]]\non.block = \"rock.1\"\nfixed = {}\n";
    assert_eq!(space(part), Vec::<String>::new());
}

#[test]
fn dashpots_that_do_not_act_are_told() {
    let scene = |interface: &str, keys: &str| {
        let head = HEAD.replace(
            "[interfaces.default.brittle_bond]\nthickness = \"1 mm\"\nelastic = true",
            &format!("[interfaces.default]\nfriction_angle = \"30 deg\"\ndashpots = \"closed\"\n{interface}"),
        );
        unused(&format!("{head}{}", phase(keys)))
    };
    let told = ["`dashpots` in interfaces.default has no effect"];
    assert_eq!(scene("damping_ratio = 0", ""), told);
    let quiet = [
        ("", ""),
        ("damping_ratio = 0", "damping.stiffness = \"1 us\""),
        ("damping_ratio = 0", "interfaces.default.damping_ratio = 0.1"),
    ];
    for (interface, keys) in quiet {
        assert_eq!(scene(interface, keys), Vec::<String>::new(), "{interface} {keys}");
    }
}

#[test]
fn moduli_in_the_plane_that_nothing_reads_are_told() {
    let scene = |interfaces: &str, rest: &str| {
        unused(&format!(
            r#"
riprap = 1
title = "test"
space.planar.gravity = ["0 m/s2", "-10 m/s2"]
[materials.rock]
density = "2000 kg/m3"
young = "18 GPa"
poisson = 0.25
[materials.steel]
density = "7800 kg/m3"
[interfaces.default]
friction_angle = "30 deg"
{interfaces}
[[blocks]]
name = "rock"
material = "rock"
rectangle = {{ size = ["2 m", "1 m"], corner = ["0 m", "0 m"] }}
{}{rest}"#,
            phase("")
        ))
    };
    let given = "normal_stiffness = \"1 GPa/m\"";
    let told = ["`young`, `poisson` in materials.rock have no effect"];
    assert_eq!(scene(given, ""), told);
    // The stiffness of one of its interfaces is estimated from them.
    let steel = "[interfaces.steel]\nfriction_angle = \"20 deg\"\nbetween = [\"steel\", \"steel\"]\nnormal_stiffness = \"1 GPa/m\"";
    let rock =
        steel.replace("\"steel\", \"steel\"", "\"rock\", \"rock\"").replace(".steel", ".rock");
    assert_eq!(scene(&format!("{given}\n{steel}"), ""), told);
    let rock = rock.replace("normal_stiffness = \"1 GPa/m\"", "");
    assert_eq!(scene(&format!("{given}\n{rock}"), ""), Vec::<String>::new());
    // A variant leaves it to them, or a check calculates with one of them.
    let variant = "[variants.soft]\n\"interfaces.default\" = { friction_angle = \"30 deg\" }\n";
    assert_eq!(scene(given, variant), Vec::<String>::new());
    let check = "[[checks]]\nname = \"c\"\nfield = \"block.speed\"\nof = \"rock\"\nlet = { modulus = \"materials.rock.young\" }\nformula = \"0*modulus\"\nabsolute = \"1 m/s\"\n";
    assert_eq!(scene(given, check), ["`poisson` in materials.rock has no effect"]);
}

#[test]
fn rhythms_longer_than_the_run_are_told() {
    let rare = |outputs: &str, until: &str| {
        let text = format!("{HEAD}{DEFORMABLE}{}{outputs}", phase(""))
            .replace("until.time = \"1 ms\"", until);
        let parsed = parse(Source::new("t.toml", text)).unwrap_or_else(|error| panic!("{error}"));
        let model = build(&parsed, "default", crate::spatial::fields::INFOS)
            .unwrap_or_else(|error| panic!("{error}"));
        let told = model.warnings.iter().filter(|w| w.code == "output.rare");
        told.map(|w| w.message.clone()).collect::<Vec<_>>()
    };
    let history = |every: &str| {
        format!(
            "[[outputs]]\nhistory = {{ name = \"v\", field = \"model.max_speed\", every = \"{every}\" }}\n"
        )
    };
    let frames = |every: &str| format!("[[outputs]]\nframes = {{ every = \"{every}\" }}\n");
    let time = "until.time = \"1 ms\"";
    assert_eq!(
        rare(&history("2 ms"), time),
        [
            "history `v` is written only at the start and at the end of each phase: `every` (0.002 s) is longer than the run (0.001 s)"
        ]
    );
    assert_eq!(rare(&frames("2 ms"), time).len(), 1);
    assert_eq!(rare(&frames("200 steps"), "until.steps = 100").len(), 1);
    let quiet = [
        (history("1 ms"), time),
        (history("phase"), time),
        (frames("200 steps"), time),
        (frames("2 ms"), "until.steps = 100"),
    ];
    for (outputs, until) in quiet {
        assert_eq!(rare(&outputs, until), Vec::<String>::new(), "{outputs} {until}");
    }
}

/// A contact under the law of an elastic joint slides by its friction; without contacts nothing does.
#[test]
fn friction_beside_an_elastic_joint_is_that_of_contacts() {
    let text = |space: &str, strength: &str| {
        format!(
            "riprap = 1\ntitle = \"t\"\nspace.spatial.gravity = \"10 m/s2\"\n{space}\nmaterials.rock.density = \"2000 kg/m3\"\n\
             interfaces.default = {{ normal_stiffness = \"1 GPa/m\", elastic = true, {strength} }}\n\
             [[blocks]]\nname = \"rock\"\nmaterial = \"rock\"\ngrid.box = {{ size = [\"2 m\", \"1 m\", \"1 m\"], cell = \"1 m\" }}\n{}",
            phase("")
        )
    };
    for friction in ["friction_angle = \"30 deg\"", "friction_coefficient = 0.5"] {
        assert_eq!(unused(&text("", friction)), [""; 0]);
        let told = unused(&text("space.spatial.found_contacts = false", friction));
        assert!(told.iter().any(|t| t.contains("friction") && t.contains("no effect")), "{told:?}");
    }
    let told = unused(&text("", "friction_angle = \"30 deg\", cohesion = \"1 MPa\""));
    assert!(told.iter().any(|t| t.starts_with("`cohesion` in")), "{told:?}");
}
