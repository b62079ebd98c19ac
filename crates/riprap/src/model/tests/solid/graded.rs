//! Random cells graded towards charges, and the warning of charges in bricks.

use super::*;
use crate::exec::Exec;
use crate::run::simulation::Simulation;

fn graded(keys: &str) -> String {
    format!(
        r#"
[[blocks]]
name = "rock"
material = "rock"
grid.cells = {{ size = ["4 m", "4 m", "4 m"], graded = {{ {keys} }}, relax = 3 }}
"#
    )
}

const KEYS: &str = r#"at = "charge", to = "1 m", over = "2 m""#;

/// What building a scene is refused with.
fn refused(middle: &str) -> String {
    match try_solid(&format!("{SPACE}{middle}{TAIL}")) {
        Ok(_) => panic!("it was built"),
        Err(error) => error.to_string(),
    }
}

fn codes(model: &Model) -> Vec<&'static str> {
    model.warnings.iter().map(|warning| warning.code).collect()
}

/// One cell in place of the charge, with its volume; cells about as wide as it round it; no warning.
#[test]
fn charges_have_room_in_graded_cells() {
    let (setup, model) = solid(&format!("{}{CHARGE}", graded(KEYS)));
    let charge = &model.summary.charges[0];
    assert_eq!(charge.blocks, 1);
    assert!((charge.ratio.unwrap() - 1.0).abs() < 1e-9, "{charge:?}");
    assert!(!codes(&model).contains(&"source.lattice"), "{:?}", model.warnings);
    let count = setup.blocks.len();
    assert!((100..150).contains(&count), "{count}");
    assert!(model.summary.fitted[0].contains(&format!("{count} graded cells")));
    let from = model.explained.iter().find(|e| e.key.ends_with("graded.from")).unwrap();
    // (6 x 0.016 m3/pi)^(1/3).
    assert!(from.value.starts_with("0.3126"), "{from:?}");
    // Shifted and turned, the room stays where the charge is.
    let turned = graded(KEYS)
        + "shift = [\"1 m\", \"0 m\", \"0 m\"]\nrotate = { axis = [0, 0, 1], angle = \"20 deg\" }\n";
    let (_, model) = solid(&format!("{turned}{CHARGE}"));
    assert!((model.summary.charges[0].ratio.unwrap() - 1.0).abs() < 1e-9);
    // A hole: one column of cells.
    let hole = CHARGE.replace(
        "centre = [\"2 m\", \"2 m\", \"2 m\"]",
        "line = { from = [\"2 m\", \"2 m\", \"3 m\"], to = [\"2.2 m\", \"2 m\", \"1 m\"] }",
    );
    let (_, model) = solid(&format!("{}{hole}", graded(KEYS)));
    let charge = &model.summary.charges[0];
    assert_eq!(charge.blocks, 20);
    assert!((charge.ratio.unwrap() - 1.0).abs() < 1e-9, "{charge:?}");
    assert!(!codes(&model).contains(&"source.lattice"), "{:?}", model.warnings);
}

/// Joint sets cut graded cells: a bench has both.
#[test]
fn joint_sets_cut_graded_cells() {
    let cut = "cut.joint_sets = [{ dip = \"0 deg\", dip_direction = \"0 deg\", origin = [\"0 m\", \"0 m\", \"0.9 m\"], spacing = \"3 m\" }]\n";
    let (plain, _) = solid(&format!("{}{CHARGE}", graded(KEYS)));
    let (setup, model) = solid(&format!("{}{cut}{CHARGE}", graded(KEYS)));
    assert!(setup.blocks.len() > plain.blocks.len() + 10);
    assert!((model.summary.charges[0].ratio.unwrap() - 1.0).abs() < 1e-9);
}

#[test]
fn senseless_gradings_are_refused() {
    let with = |keys: &str| refused(&format!("{}{CHARGE}", graded(keys)));
    for (keys, told) in [
        (r#"from = "1 m", to = "1 m", over = "2 m""#, "they cannot be its walls"),
        (r#"from = "1 m", to = "1 m", over = "2 m""#, "makes about"),
        (r#"from = "2 cm", to = "1 m", over = "2 m""#, "they cannot be its walls"),
        (r#"to = "1 m", over = "5 cm""#, "more than their own size"),
        (r#"from = "0.3 m", to = "1 m", over = "5 cm""#, "more than their own size"),
        (r#"from = "0.3 m", to = "0.1 m", over = "2 m""#, "is larger than"),
        (
            r#"at = { all = {} }, from = "0.3 m", to = "1 m", over = "2 m""#,
            "graded towards everything",
        ),
        (r#"at = "hole", to = "1 m", over = "2 m""#, "hole"),
    ] {
        let error = with(keys);
        assert!(error.contains(told), "{keys}: {error}");
    }
    let many =
        refused(&graded(r#"at = ["1 m", "1 m", "1 m"], from = "1 mm", to = "2 mm", over = "2 m""#));
    assert!(many.contains("more than 1 million"), "{many}");
    let none = refused(&graded(r#"from = "0.3 m", to = "1 m", over = "2 m""#));
    assert!(none.contains("no source has a place"), "{none}");
    let no_size = refused(&graded(r#"at = ["1 m", "1 m", "1 m"], to = "1 m", over = "2 m""#));
    assert!(no_size.contains("the finest cells of `rock` is not given"), "{no_size}");
    let out = CHARGE.replace(
        "centre = [\"2 m\", \"2 m\", \"2 m\"]",
        "line = { from = [\"2 m\", \"2 m\", \"5 m\"], to = [\"2 m\", \"2 m\", \"1 m\"] }",
    );
    let crosses = refused(&format!("{}{out}", graded(KEYS)));
    assert!(crosses.contains("crosses a side of the cells"), "{crosses}");
    let both = graded(KEYS).replace("relax", "cell = \"1 m\", relax");
    assert!(refused(&format!("{both}{CHARGE}")).contains("graded"));
}

/// A charge in bricks is warned of where their joints can fail, and only there.
#[test]
fn lattices_that_fail_are_warned_of() {
    let coupled = format!("{CHARGE}coupling = {{ scaled = 0.667 }}\n");
    let refine = "[[refine]]\noctree = { around = \"charge\", levels = 2 }\n";
    let (_, model) = solid(&format!("{GRID}{coupled}{refine}"));
    assert!(codes(&model).contains(&"source.lattice"), "{:?}", model.warnings);
    let scene = format!("{SPACE}{GRID}{coupled}{refine}{TAIL}");
    let elastic = scene.replace("friction_angle = \"45 deg\"", "elastic = true");
    assert_ne!(scene, elastic);
    let model = try_solid(&elastic).unwrap_or_else(|error| panic!("{error}"));
    assert!(!codes(&model).contains(&"source.lattice"), "{:?}", model.warnings);
}

/// The same cells and the same motion, whatever the threads, and after a restart.
#[test]
fn graded_cells_do_not_depend_on_threads() {
    let scene = format!("{SPACE}{}{CHARGE}{TAIL}", graded(KEYS));
    let state = |threads: usize, stop: bool| {
        let model = try_solid(&scene).unwrap_or_else(|error| panic!("{error}"));
        let exec = Exec::new(threads).unwrap();
        let mut run = Simulation::new(model.setup, model.plan, exec).unwrap();
        // A snapshot is exact between a step and the forces of the next.
        for _ in 0..20 {
            run.prepare().unwrap();
            run.step();
        }
        if stop {
            let bytes = postcard::to_allocvec(&run.snapshot()).unwrap();
            let exec = Exec::new(threads).unwrap();
            run = Simulation::resume(postcard::from_bytes(&bytes).unwrap(), exec);
        }
        run.advance(20).unwrap();
        postcard::to_allocvec(&run.snapshot()).unwrap()
    };
    let one = state(1, false);
    for threads in [2, 3, 7] {
        assert!(state(threads, false) == one, "{threads} threads");
    }
    assert!(state(2, true) == one, "after a restart");
}
