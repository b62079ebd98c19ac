//! Runs that go where their laws mean nothing: they stop or warn, and right runs that look odd pass without a word.

use super::bench::{Bench, Said};

/// A scene in space of rock of 2600 kg/m³ with these keys of space, of the interface, and whatever else.
fn space(keys: &str, interface: &str, rest: &str) -> String {
    format!(
        "riprap = 1\ntitle = \"t\"\n[space.spatial]\ngravity = \"9.81 m/s2\"\n{keys}\n[materials.r]\ndensity = \"2600 kg/m3\"\nyoung = \"20 GPa\"\npoisson = 0.25\n\
         [interfaces.default]\n{interface}\n{rest}\n"
    )
}

/// A brick from a corner, m.
fn brick(name: &str, corner: [f64; 3], size: [f64; 3], more: &str) -> String {
    let list = |v: [f64; 3]| v.map(|x| format!("\"{x} m\"")).join(", ");
    format!(
        "[[blocks]]\nname = \"{name}\"\nmaterial = \"r\"\nbrick = {{ corner = [{}], size = [{}] }}\n{more}\n",
        list(corner),
        list(size)
    )
}

const FIXED: &str = "[[supports]]\non.block = \"floor\"\nfixed = {}\n";

fn run(scene: &str) -> (Bench, Said) {
    let bench = Bench::new();
    bench.file("a.toml", scene);
    let said = bench.run(&["run", "a.toml", "--out", "a.run", "-q", "-j1"]);
    (bench, said)
}

fn check(scene: &str) -> Said {
    let bench = Bench::new();
    bench.file("a.toml", scene);
    bench.run(&["check", "a.toml"])
}

/// A run that goes to its end without a word.
fn silent(scene: &str) {
    let (bench, said) = run(scene);
    let said = said.expect(0);
    assert_eq!(said.err, "", "{scene}");
    let manifest: serde_json::Value =
        serde_json::from_str(&bench.read("a.run/manifest.json")).unwrap();
    assert_eq!(manifest["warnings"], serde_json::json!([]), "{scene}");
}

/// Something thin of this shape between a fixed floor and a roof 5 m high.
fn between(stiffness: &str, [wide, thick]: [f64; 2], phase: &str) -> String {
    let thin = brick("thin", [-wide / 2.0, -wide / 2.0, 0.0], [wide, wide, thick], "");
    let floor = brick("floor", [-2.0, -2.0, -4.0], [4.0, 4.0, 4.0], "");
    let roof = brick("roof", [-2.0, -2.0, thick], [4.0, 4.0, 5.0], "");
    let interface = format!("friction_angle = \"30 deg\"\nnormal_stiffness = \"{stiffness}\"");
    space("", &interface, &format!("{floor}{thin}{roof}{FIXED}[[phases]]\nname = \"a\"\n{phase}\n"))
}

#[test]
fn what_is_thin_between_joints_is_not_swallowed_in_silence() {
    let slow = "until = { time = \"1 s\" }\ndamping.mass = \"5 1/s\"";
    for (stiffness, shape) in [
        ("1 GPa/m", [0.1, 0.1]),
        ("1 MPa/m", [4.0, 0.01]),
        ("100 MPa/m", [0.2, 0.05]),
        ("3 MPa/m", [4.0, 0.05]),
    ] {
        let (_, said) = run(&between(stiffness, shape, slow));
        let said = said.expect(1).warns(&["thin", "pass through", "beyond the inscribed radius"]);
        let reach = format!("({:.4e} m)", shape[0].min(shape[1]) / 2.0);
        assert!(said.err.contains(&reach), "{reach} {}", said.err);
    }
    // In between it is told, and what bears its load passes.
    let (_, said) = run(&between("100 MPa/m", [4.0, 0.006], slow));
    said.expect(0).warns(&["were pressed", "thin"]);
    silent(&between("10 GPa/m", [4.0, 0.01], slow));
    silent(&between(
        "10 GPa/m",
        [1.0, 0.1],
        "kind = \"static\"\nuntil = { unbalanced = 1e-4, steps = 20000 }",
    ));
}

#[test]
fn a_bond_in_the_plane_has_a_guard_of_depth() {
    let scene = |stiffness: &str| {
        let block = |name: &str, low: f64, high: f64| {
            format!(
                "[[blocks]]\nname = \"{name}\"\nmaterial = \"r\"\nrectangle = {{ corner = [\"-2 m\", \"{low} m\"], size = [\"4 m\", \"{} m\"] }}\n",
                high - low
            )
        };
        format!(
            "riprap = 1\ntitle = \"t\"\n[space.planar]\ngravity = [\"0 m/s2\", \"-9.81 m/s2\"]\n[materials.r]\ndensity = \"2600 kg/m3\"\n\
             [interfaces.default]\nfriction_angle = \"30 deg\"\nnormal_stiffness = \"{stiffness}\"\nbond = {{ cohesion = \"10 MPa\", tension = \"10 MPa\" }}\n\
             {}{}{}{FIXED}[[phases]]\nname = \"a\"\nuntil = {{ time = \"1 s\" }}\ndamping.mass = \"5 1/s\"\n",
            block("floor", -4.0, 0.0),
            block("thin", 0.0, 0.02),
            block("roof", 0.02, 5.0)
        )
    };
    let (_, said) = run(&scene("3 MPa/m"));
    said.expect(1).warns(&["thin", "pass through"]);
    let (_, said) = run(&scene("10 GPa/m"));
    // Quiet runs repeat the warning of the scene, that the plate is a sliver, and nothing else.
    let said = said.expect(0);
    assert!(said.err.contains("geometry.sliver"), "{said:?}");
    assert_eq!(said.err.matches("warning").count(), 1, "{said:?}");
}

/// A column of deformable cubes on a held foot.
fn column(young: &str, strain: &str, phase: &str) -> String {
    let scene = space(
        "",
        "friction_angle = \"30 deg\"\nbrittle_bond = { thickness = \"10 mm\", elastic = true }",
        &format!(
            "[[blocks]]\nname = \"b\"\nmaterial = \"r\"\ngrid.box = {{ size = [\"1 m\", \"1 m\", \"3 m\"], cell = \"1 m\", corner = [\"0 m\", \"0 m\", \"0 m\"] }}\n\
             mechanics.deformable = {{ strain = \"{strain}\" }}\n[[boundaries]]\non.plane = \"z-min\"\nheld = {{}}\n[[phases]]\nname = \"a\"\n{phase}\n"
        ),
    );
    scene.replace("20 GPa", young)
}

#[test]
fn deformable_blocks_inside_out_stop_a_run_and_strain_beyond_the_law_is_told() {
    let statics = "kind = \"static\"\nuntil = { unbalanced = 1e-4 }";
    let (_, said) = run(&column("20 kPa", "small", statics));
    said.expect(1).warns(&["`b.", "is inverted", "times its initial volume", "young", " m: "]);
    let (_, said) = run(&column("300 kPa", "total_lagrangian", statics));
    said.expect(1).warns(&["`b.", "is inverted"]);
    // So soft that numbers end before a look finds it: named all the same.
    let (_, said) = run(&column("20 kPa", "total_lagrangian", statics));
    said.expect(1).warns(&["`b."]);
    let (_, said) = run(&column("300 kPa", "small", statics));
    said.expect(0).warns(&["was strained by", "%", "`young`", "at ("]);
    silent(&column("200 MPa", "small", statics));
    silent(&column("200 MPa", "total_lagrangian", statics));
}

/// Two joined cubes that turn as one by 1.5 rad, or by less in a shorter time.
fn turning(kinematics: &str, time: &str) -> String {
    let whirl = |v: f64| {
        format!(
            "spin = [\"0 rad/s\", \"0 rad/s\", \"5 rad/s\"]\nvelocity = [\"0 m/s\", \"{v} m/s\", \"0 m/s\"]"
        )
    };
    let a = brick("a", [-1.0, -0.5, 0.0], [1.0, 1.0, 1.0], &whirl(-2.5));
    let b = brick("b", [0.0, -0.5, 0.0], [1.0, 1.0, 1.0], &whirl(2.5));
    let keys = format!("kinematics = \"{kinematics}\"");
    let phase = format!("[[phases]]\nname = \"a\"\nuntil = {{ time = \"{time}\" }}\n");
    space(&keys, "elastic = true\ndamping_ratio = 0", &format!("{a}{b}{phase}"))
        .replace("9.81 m/s2", "0 m/s2")
}

#[test]
fn small_kinematics_of_blocks_that_turn_far_are_doubted() {
    let (bench, said) = run(&turning("small", "0.3 s"));
    said.expect(0).warns(&[
        "rotated by 1.5",
        "small-rotation kinematics",
        "kinematics = \"automatic\"",
    ]);
    assert!(bench.read("a.run/manifest.json").contains("rotated by 1.5"));
    let (_, said) = run(&turning("small", "0.03 s"));
    said.expect(0).warns(&["rotated by 0.15 rad"]);
    silent(&turning("small", "0.015 s"));
    silent(&turning("automatic", "0.3 s"));
    silent(&turning("finite", "0.3 s"));
}

/// A column of rigid blocks on a base, under its weight.
fn on_base(base: &str, rest: &str) -> String {
    let interface = "friction_angle = \"35 deg\"";
    space(
        "",
        interface,
        &format!(
            "[[blocks]]\nname = \"rock\"\nmaterial = \"r\"\ngrid.box = {{ cell = \"1 m\", size = [\"2 m\", \"2 m\", \"4 m\"] }}\n\
             [[boundaries]]\nname = \"base\"\non.plane = \"z-min\"\n{base}\n{rest}\n"
        ),
    )
}

#[test]
fn weight_on_dashpots_is_told_and_is_no_rest() {
    let dynamic = "[[phases]]\nname = \"p\"\nuntil = { time = \"0.1 s\" }";
    let statics =
        "[[phases]]\nname = \"p\"\nkind = \"static\"\nuntil = { unbalanced = 1e-4, steps = 20000 }";
    let viscous = "viscous = {}";
    check(&on_base(viscous, dynamic)).expect(0).warns(&["dashpots", "`base`", "sinks", "in_situ"]);
    let (_, said) = run(&on_base(viscous, dynamic));
    said.expect(0).warns(&["dashpots", "`base`", "sinks"]);
    let (_, said) = run(&on_base(viscous, statics));
    let said = said.expect(0).warns(&["`base`", "sinks", "ended before the model was at rest"]);
    assert!(!said.err.contains("are balanced"), "{}", said.err);
    // Rollers on the sides bear no weight.
    let side = "[[boundaries]]\nname = \"side\"\non.plane = \"x-min\"\nroller = {}\n";
    let with_side = format!("{side}{dynamic}");
    check(&on_base(viscous, &with_side)).expect(0).warns(&["dashpots", "`base`"]);
    // A held base, a base that takes up the stress at the start, and one side that bears the weight.
    silent(&on_base("held = {}", statics));
    let stress = "[in_situ.gravity_k0]\nk0 = 0.5\n";
    for (base, rest) in [
        (viscous, format!("{side}{statics}").replace("roller = {}", "held = {}")),
        (viscous, format!("{stress}{statics}")),
    ] {
        let told = check(&on_base(base, &rest)).expect(0);
        assert!(!told.err.contains("dashpots") && !told.out.contains("dashpots"), "{told:?}");
    }
}

/// A block that hangs on a bolt from a fixed one.
fn hanging(bolt: &str, phase: &str) -> String {
    let floor = brick("floor", [-1.0, -1.0, 1.0], [2.0, 2.0, 2.0], "");
    let b = brick("b", [-1.0, -1.0, 0.0], [2.0, 2.0, 1.0], "");
    let interface = "friction_angle = \"30 deg\"\nnormal_stiffness = \"1 GPa/m\"";
    space(
        "",
        interface,
        &format!(
            "{floor}{b}{FIXED}[[bolts]]\nname = \"k\"\n{bolt}\n[[phases]]\nname = \"a\"\n{phase}\n"
        ),
    )
}

#[test]
fn bolts_that_bear_what_no_bar_bears_tie_nothing_or_have_too_many_pieces_are_told() {
    let ends = "head = [\"0 m\", \"0 m\", \"0 m\"]\ntoe = [\"0 m\", \"0 m\", \"2 m\"]\ngrout = { stiffness = \"1 GN/m2\" }\nplate = {}\n";
    let weak = format!("{ends}steel = {{ diameter = \"25 mm\", yield_force = \"1 kN\" }}");
    let (_, said) = run(&hanging(&weak, "until = { time = \"2 s\" }"));
    said.expect(0).warns(&["bolt `k`", "longer than when it was installed", "rupture"]);
    // It breaks by itself, bears the weight, or has not been drawn far.
    let breaks = weak.replace("\"1 kN\"", "\"1 kN\", rupture = \"10 cm\"");
    let (_, said) = run(&hanging(&breaks, "until = { time = \"2 s\" }"));
    assert!(!said.expect(0).err.contains("longer than"), "a bar that breaks");
    let strong = weak.replace("1 kN", "300 kN");
    silent(&hanging(&strong, "until = { time = \"0.2 s\" }"));
    silent(&hanging(&weak, "until = { time = \"0.2 s\" }"));
    // All of it in one block, here and from a later phase on.
    let inside = "head = [\"0 m\", \"0 m\", \"1.2 m\"]\ntoe = [\"0 m\", \"0 m\", \"1.8 m\"]\ngrout = { stiffness = \"1 GN/m2\" }\nsteel = { diameter = \"25 mm\" }";
    let phase = "until = { time = \"0.1 s\" }";
    for phases in [phase.to_owned(), format!("{phase}\n[[phases]]\nname = \"b\"\n{phase}")] {
        let inside = match phases.contains("\"b\"") {
            true => format!("{inside}\nphase = \"b\""),
            false => inside.to_owned(),
        };
        let scene = hanging(&inside, &phases);
        check(&scene).expect(0).warns(&["bolt `k` has no effect", "`floor`"]);
        let (_, said) = run(&scene);
        said.expect(0).warns(&["bolt `k` has no effect"]);
    }
    for piece in ["10 nm", "1 um"] {
        let scene = hanging(&format!("{strong}\npiece = \"{piece}\""), phase);
        check(&scene).expect(2).warns(&["bolt.pieces", "pieces", "piece ="]);
    }
    check(&hanging(&format!("{strong}\npiece = \"1 mm\""), phase)).expect(0);
    let long = hanging(&format!("{strong}\npiece = \"1 km\""), phase);
    check(&long).expect(2).warns(&["bolt.length", "the length of the pieces", "1 km"]);
    let grouted = |length: &str| {
        hanging(&strong.replace("GN/m2\"", &format!("GN/m2\", length = \"{length}\"")), phase)
    };
    check(&grouted("50 m")).expect(2).warns(&["bolt.length", "the grouted length", "50 m"]);
    check(&grouted("0.3 m")).expect(0);
}

#[test]
fn contact_across_the_ends_of_a_periodic_model_is_told_where_it_is_missing() {
    let velocity = "velocity = [\"-5 m/s\", \"0 m/s\", \"0 m/s\"]";
    let scene = |deformable: &str| {
        let q = brick("q", [3.0, 0.0, 0.0], [1.0, 1.0, 1.0], deformable);
        let b = brick("b", [1.0, 0.0, 0.0], [1.0, 1.0, 1.0], velocity);
        space(
            "periodic = [\"4 m\", \"none\", \"none\"]",
            "friction_angle = \"30 deg\"\nnormal_stiffness = \"1 GPa/m\"\ndamping_ratio = 0",
            &format!(
                "{q}{b}[[phases]]\nname = \"a\"\nuntil = {{ time = \"0.3 s\" }}\ntime_step = \"0.1 ms\"\n\
                 [[checks]]\nname = \"struck\"\nfield = \"block.velocity.x\"\nof = \"q\"\nvalue = \"-5 m/s\"\nabsolute = \"0.01 m/s\"\n"
            ),
        )
        .replace("9.81 m/s2", "0 m/s2")
    };
    // Rigid blocks meet there.
    silent(&scene(""));
    let warning = ["contact of deformable blocks", "across the periodic boundaries"];
    let soft = "mechanics.deformable = { strain = \"total_lagrangian\" }\n";
    check(&scene(soft)).expect(0).warns(&warning);
}

#[test]
fn splitting_everywhere_is_refused_at_its_key_before_it_fills_the_memory() {
    let scene = |around: &str, levels: u8| {
        let b = brick("b", [0.0; 3], [1.0; 3], "");
        space(
            "",
            "friction_angle = \"30 deg\"\nnormal_stiffness = \"100 MPa/m\"",
            &format!(
                "{b}[[refine]]\noctree = {{ around{around}, levels = {levels} }}\n[[phases]]\nname = \"a\"\nuntil = {{ time = \"0.01 s\" }}\n"
            ),
        )
    };
    check(&scene(".all = {}", 12)).expect(2).warns(&["refine.many", "6.9e10 blocks", "levels"]);
    let box_ = ".box = { min = [\"0 m\", \"0 m\", \"0 m\"], max = [\"1 m\", \"1 m\", \"1 m\"] }";
    check(&scene(box_, 12)).expect(2).warns(&["refine.many", "more than"]);
    check(&scene(".all = {}", 3)).expect(0);
    check(&scene(".ball = { centre = [\"0 m\", \"0 m\", \"0 m\"], radius = \"1 mm\" }", 12))
        .expect(0);
}
