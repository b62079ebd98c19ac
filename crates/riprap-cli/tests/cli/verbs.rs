//! The other verbs, and input that is wrong.

use super::bench::{Bench, FALL};

#[test]
fn check_tells_what_to_expect() {
    let bench = Bench::with_scene();
    bench.run(&["check", "fall.toml"]).expect(0).says(&[
        "a block falls",
        "2 (1 held)",
        "stable",
        "20 000 steps",
        "no errors",
    ]);
    let said = bench.run(&["check", "fall.toml", "--json"]).expect(0);
    let value: serde_json::Value = serde_json::from_str(&said.out).expect("JSON");
    assert_eq!(value["model"]["blocks"], 2);
    assert!(value["expected"]["stable_time_step"].as_f64().is_some_and(|dt| dt > 1e-5));
    assert_eq!(value["expected"]["steps"], 20_000);
}

#[test]
fn set_changes_a_key_and_wrong_keys_are_explained() {
    let bench = Bench::with_scene();
    bench
        .run(&["check", "fall.toml", "--set", "phases.fall.until.time=0.1 s"])
        .expect(0)
        .says(&["10 000 steps"]);
    bench
        .run(&["check", "fall.toml", "--set", "phases.fall.utnil.time=0.1 s"])
        .expect(2)
        .warns(&["until"]);
    bench
        .run(&["check", "fall.toml", "--set", "materials.rock.density=30 deg"])
        .expect(2)
        .warns(&["density", "kg/m3"]);
}

#[test]
fn wrong_scenes_point_at_the_place() {
    let bench = Bench::new();
    for (name, text, parts) in [
        ("unit", FALL.replace("2000 kg/m3", "20 kN/m3"), ["unit.toml:9:11", "unit weight"]),
        ("key", FALL.replace("density", "densty"), ["key.toml:9:1", "did you mean `density`"]),
        ("syntax", FALL.replace("riprap = 1", "riprap = = 1"), ["syntax.toml:2", "TOML"]),
        ("empty", String::new(), ["empty.toml", "missing"]),
    ] {
        let file = format!("{name}.toml");
        bench.file(&file, text);
        for verb in [
            "check",
            "run",
            "verify",
            "sweep",
            "bisect",
            "safety",
            "removable",
            "compare",
            "probe-contact",
            "hash",
        ] {
            let said = bench.run(&[verb, &file]);
            if verb == "verify" {
                // In a line of its own, so that others are still run.
                said.expect(2).says(&parts);
            } else {
                said.expect(2).warns(&parts);
            }
        }
    }
    for verb in [
        "check",
        "run",
        "sweep",
        "bisect",
        "safety",
        "removable",
        "compare",
        "probe-contact",
        "explain",
        "hash",
    ] {
        bench.run(&[verb, "missing.toml"]).expect(2).warns(&["missing.toml"]);
    }
    bench.file("noise.toml", [0u8, 159, 146, 150, 255, 7, 27, 91]);
    let said = bench.run(&["run", "noise.toml"]).expect(2);
    assert!(!said.err.contains('\u{1b}'), "{:?}", said.err);
}

#[test]
fn results_of_runs_are_named() {
    let bench = Bench::with_scene();
    bench.run(&["run", "fall.toml"]).expect(0);
    bench.run(&["runout", "fall.run", "--line", "wall=1 m"]).expect(0).says(&[
        "1 rock of 1 run",
        "wall: 0 of 1 rocks pass, 0.0 %",
        "fall.runout",
    ]);
    bench.run(&["runout", "fall.run", "--line", "wall=1 s"]).expect(2).warns(&["is not a line"]);
    bench.run(&["runout", "fall.toml"]).expect(2).warns(&["holds no run"]);
    // What it finds in stresses the page of laboratory tests shows.
    let told = bench.run(&["strength", "fall.run", "--stress", "height"]).expect(2);
    told.warns(&["`height` is in m, but a stress is in Pa"]);
    bench.run(&["strength", "fall.run", "--load", "height"]).expect(2).warns(&["--area"]);
    bench.run(&["strength", "fall.run", "--stress", "hight"]).expect(2).warns(&["hight"]);
    bench.run(&["removable", "fall.toml"]).expect(2).warns(&["[space.spatial]"]);
}

#[test]
fn colours_only_where_they_are_wanted() {
    let bench = Bench::new();
    bench.file("a.toml", "riprap = 1\n");
    let said = bench.run(&["check", "a.toml", "--color", "always"]).expect(2);
    assert!(said.err.contains('\u{1b}'));
    let said = bench.run(&["check", "a.toml"]).expect(2);
    assert!(!said.err.contains('\u{1b}'));
}

#[test]
fn verify_closes_with_its_counts() {
    let bench = Bench::with_scene();
    bench.file("notes.toml", "not = \"a scene\"\n");
    let known = FALL
        .replace("-0.5*10*t^2", "-0.5*9*t^2")
        .replace("relative = 1e-6", "relative = 1e-6\nknown = \"the moon is near\"");
    bench.file("known.toml", known);
    bench.run(&["verify", "."]).expect(0).says(&[
        "passed",
        "skipped",
        "the moon is near",
        "1 passed, 0 failed, 1 skipped",
    ]);
    bench.run(&["verify", ".", "--strict"]).expect(1).says(&["1 passed, 1 failed, 0 skipped"]);
    let said = bench.run(&["verify", "fall.toml", "--json"]).expect(0);
    let value: serde_json::Value = serde_json::from_str(said.out.trim()).expect("one JSON line");
    assert_eq!((&value["check"], &value["status"]), (&"free fall".into(), &"passed".into()));
    std::fs::create_dir(bench.path("none")).unwrap();
    bench.run(&["verify", "none"]).expect(2);
    let heavy = ["--set", "space.planar.gravity=['0 m/s2', '-11 m/s2']"];
    bench.run(&[&["verify", "fall.toml"], &heavy[..]].concat()).expect(1);
    bench.run(&["verify", "fall.toml", "--set", "materials.rock.density=3 t/m3"]).expect(0);
    bench.run(&["verify", "fall.toml", "--set", "materials.rock.densty=3 t/m3"]).expect(2);
    // Bad input is none of the checks: the others are run, and one that fails goes before it.
    bench.run(&["verify", "nowhere.toml"]).expect(2).warns(&["nowhere.toml does not exist"]);
    bench.run(&["verify", "fal.toml"]).expect(2).warns(&["did you mean fall.toml?"]);
    bench.file("cut.toml", FALL.replace("density", "densty"));
    bench
        .run(&["verify", "cut.toml", "fall.toml"])
        .expect(2)
        .says(&["the scene can be read", "1 passed, 1 failed, 0 skipped"])
        .warns(&["no check failed, but not all scenes can be read"]);
    bench.run(&["verify", "cut.toml", "known.toml", "--strict"]).expect(1);
    // A scene that cannot begin is bad input too, of `run` the end of the run.
    bench.file(
        "held.toml",
        FALL.replace("on = { block = \"floor\" }", "on = { blocks = [\"floor\", \"stone\"] }")
            .replace(
                "until = { time = \"0.2 s\" }\ntime_step = \"10 us\"",
                "until = { steps = 1 }",
            ),
    );
    bench
        .run(&["check", "held.toml"])
        .expect(2)
        .warns(&["(t = 0.000000e0 s): no two blocks interact"]);
    bench.run(&["run", "held.toml", "-q"]).expect(1);
}

#[test]
fn a_sweep_writes_one_table() {
    let bench = Bench::new();
    let sweep = "[sweep]\n\"blocks.stone.velocity\" = [[\"0 m/s\", \"0 m/s\"], [\"1 m/s\", \"0 m/s\"]]\n\n[bisect]";
    bench.file("two.toml", FALL.replace("[bisect]", sweep));
    bench.run(&["sweep", "two.toml"]).expect(0).says(&["2/2", "checks: 2 passed", "two.sweep"]);
    let table = bench.read("two.sweep/sweep.csv");
    assert_eq!(table.lines().count(), 3, "{table}");
    assert!(table.lines().next().is_some_and(|head| head.contains("height [m]")), "{table}");
    // The same again is kept; another input is not mixed into it.
    bench.run(&["sweep", "two.toml", "--out", "two.sweep"]).expect(0).says(&[
        "2/2",
        "steps, kept",
        "checks: 2 passed",
    ]);
    assert_eq!(bench.read("two.sweep/sweep.csv"), table);
    let other =
        ["sweep", "two.toml", "--out", "two.sweep", "--set", "phases.fall.until.time=0.1 s"];
    bench.run(&other).expect(2).warns(&["contains a run of another input", "--force"]);
    assert_eq!(bench.read("two.sweep/sweep.csv"), table);
    bench.run(&["run", "two.toml", "--case", "nonsense"]).expect(2).warns(&["valid cases:"]);
}

#[test]
fn compare_runs_both_laws() {
    let bench = Bench::with_scene();
    bench.run(&["compare", "fall.toml", "-q"]).expect(0).says(&[
        "distance_potential",
        "penetration_potential",
        "height",
        "largest displacement",
    ]);
    assert!(bench.path("fall.compare/penetration_potential/manifest.json").exists());
}

#[test]
fn probe_contact_shows_touching_pairs() {
    let bench = Bench::new();
    bench.file("touch.toml", FALL.replace("\"0.2 m\"]", "\"-0.0001 m\"]"));
    let said = bench.run(&["probe-contact", "touch.toml", "--json"]);
    if said.code == Some(0) {
        let value: serde_json::Value = serde_json::from_str(&said.out).expect("JSON");
        assert_eq!((&value[0]["first"], &value[0]["second"]), (&"floor".into(), &"stone".into()));
        bench.run(&["probe-contact", "touch.toml"]).expect(0).says(&["floor", "stone", "overlap"]);
        bench.run(&["probe-contact", "touch.toml", "--pair", "floor", "x"]).expect(2);
    } else {
        said.expect(2).warns(&["overlap"]);
    }
    bench.file("apart.toml", FALL);
    bench.run(&["probe-contact", "apart.toml"]).expect(0).says(&["no blocks touch"]);
    bench.run(&["probe-contact", "apart.toml", "--threshold", "0.3 m"]).expect(0).says(&[
        "floor",
        "stone",
        "gap 200 mm",
    ]);
}

#[test]
fn a_report_is_one_file() {
    let bench = Bench::with_scene();
    bench.run(&["run", "fall.toml", "-q"]).expect(0);
    bench
        .run(&["report", "fall.run", "--author", "A. Stone", "--project", "Pit <3>"])
        .expect(0)
        .says(&["fall.html", "MB"]);
    let page = bench.read("fall.html");
    // The model as it was before it moved.
    let setup = bench.read("fall.run/plots/setup.svg");
    assert!(setup.contains(">rock<") && setup.contains("t = 0 s"), "{setup}");
    for part in [
        "<th>author</th><td>A. Stone</td>",
        "<th>project</th><td>Pit &lt;3&gt;</td>",
        "<h2>Set-up</h2>",
        "<h2>Materials</h2>",
        "<td>rock</td><td>density ",
        "kg/m³",
        "<td>all other pairs</td><td>",
        "a block falls",
        "free fall",
        "id=\"riprap-run\"",
        "Energy ledger",
        "data:image/svg+xml;base64,",
        "input hash",
    ] {
        assert!(page.contains(part), "{part}");
    }
    // Energies have four digits.
    let ledger = page.split("Energy ledger</h2>").nth(1).unwrap();
    let ledger = ledger.split("</table>").next().unwrap();
    let digits = |cell: &str| cell.chars().filter(char::is_ascii_digit).count();
    let cells =
        ledger.split("<td>").filter(|c| c.starts_with(|x: char| x == '-' || x.is_ascii_digit()));
    assert!(cells.clone().count() > 4 && cells.clone().all(|c| digits(c) < 9), "{ledger}");
    // Of the script only the two ends of its element.
    assert_eq!(page.matches("</script").count(), 2);
    bench
        .run(&["report", "nothing.run"])
        .expect(2)
        .warns(&["nothing.run does not exist", "needs a run folder, written by `riprap run`"]);
    bench
        .run(&["report", "fall.run", "-o", "no/such/folder.html"])
        .expect(3)
        .warns(&["could not write"]);
}

#[test]
fn folders_and_scenes_are_viewed() {
    let bench = Bench::with_scene();
    bench.file("notes.txt", "no scene");
    bench
        .run(&["view", "notes.txt", "--no-open"])
        .expect(2)
        .warns(&["neither a run folder nor a scene"]);
    bench.file("wrong.toml", FALL.replace("density", "densty"));
    bench.run(&["view", "wrong.toml", "--no-open"]).expect(2).warns(&["did you mean `density`"]);
    bench
        .run(&["view", "fall.toml", "fall.run", "--no-open"])
        .expect(2)
        .warns(&["a scene can only be viewed alone"]);
    bench.run(&["view", "nothing.run", "--no-open"]).expect(2).warns(&["does not exist"]);
}

#[test]
fn plots_are_drawn() {
    let bench = Bench::with_scene();
    bench.run(&["run", "fall.toml", "-q"]).expect(0);
    bench.run(&["plot", "fall.run"]).expect(0).says(&["energy.svg", "histories.svg", "blocks"]);
    let drawn = bench.read("fall.run/plots/energy.svg");
    assert!(drawn.starts_with("<?xml") || drawn.starts_with("<svg"), "{}", &drawn[..40]);
    bench.run(&["plot", "fall.run", "height", "-o", "h.png"]).expect(0);
    let png = std::fs::read(bench.path("h.png")).expect("the picture");
    assert_eq!(&png[..4], b"\x89PNG");
    bench.run(&["plot", "fall.run", "hieght"]).expect(2).warns(&["did you mean `height`"]);
    bench.run(&["plot", "fall.run", "blocks", "--time", "soon"]).expect(2);
    bench.run(&["plot", "nowhere"]).expect(2);
    for (words, said) in [
        ("", "the run is in the plane"),
        ("-o a.svg", "a.svg is no PNG"),
        ("--cut y", "--at"),
        ("--fps 5", "ends in .apng"),
        ("--perspective=0", "1 to 150 degrees"),
        ("--trails=colour", "[possible values: speed, block]"),
        ("--contacts=open", "[possible values: changed, all]"),
        ("--saved south", "views.json"),
    ] {
        let words: Vec<&str> =
            ["shot", "fall.run"].into_iter().chain(words.split_whitespace()).collect();
        bench.run(&words).expect(2).warns(&[said]);
    }
    let strip = ["--time", "0 s", "--time", "0.2 s", "--vectors", "velocity"];
    let words = [&["plot", "fall.run", "blocks", "--exaggerate", "2"], &strip[..]].concat();
    bench.run(&words).expect(0);
    let drawn = bench.read("fall.run/plots/blocks_displacement.svg");
    assert!(drawn.contains("displacements × 2") && drawn.contains("longest arrow"));
    for (words, said) in [
        (&["section"][..], "in the plane"),
        (&["ppv"], "in the plane"),
        (&["crater"], "in the plane"),
        (&["heave"], "no sources"),
        (&["cavity"], ".pressure"),
        (&["spectrum"], "the name of one history"),
        (&["spectrum", "hieght"], "did you mean `height`"),
        (&["energy", "height"], "only spectrum and histories do"),
        (&["section", "--at", "3 s"], "is not a valid length"),
        (&["crater", "--uplift", "high"], "is not a valid length"),
        (&["ppv", "--time", "0 s", "--time", "1 s"], "one frame"),
        (&["blocks", "--exaggerate", "0"], "positive"),
        (
            &["blocks", "--range", "0 MPa", "1 mm"],
            "\"0 MPa\" is no value of `displacement`, which is in m",
        ),
        (
            &["blocks", "--by", "velocity", "--range", "-1 m/s", "1 kg"],
            "`velocity`, which is in m/s",
        ),
        (&["blocks", "--by", "material", "--range", "0", "1 m"], "`material`, which has no unit"),
        (&["--range", "0 s", "1 s"], "\"0 s\" is no value of `displacement`, which is in m"),
    ] {
        let words = [&["plot", "fall.run"], words].concat();
        bench.run(&words).expect(2).warns(&[said]);
    }
    let colours = |by, low, high| {
        let words = ["plot", "fall.run", "blocks", "--by", by, "--range", low, high];
        bench.run(&words).expect(0);
        bench.read(&format!("fall.run/plots/blocks_{by}.svg"))
    };
    assert_eq!(
        colours("velocity", "-1 cm/s", "2 km/h"),
        colours("velocity", "-0.01", "0.5555555555555556")
    );
    colours("material", "0", "1");
    // A line in the plane takes two coordinates, no more.
    let line = |from, to| ["plot", "fall.run", "line", "--from", from, "--to", to];
    bench.run(&line("0.5 m, -9 m", "0.5 m, 9 m")).expect(0);
    bench
        .run(&line("0.5 m, -9 m, 0 m", "0.5 m, 9 m"))
        .expect(2)
        .warns(&["in the plane, where a point has x and y; (0.5, -9, 0) m has 3 coordinates"]);
    bench.run(&["plot", "fall.run", "spectrum", "height"]).expect(0).says(&["spectrum_height.svg"]);
}

#[test]
fn the_language_explains_itself() {
    let bench = Bench::with_scene();
    bench.run(&["explain", "friction_angle"]).expect(0).says(&["interfaces.*.friction_angle"]);
    bench.run(&["explain", "frition_angle"]).expect(2).warns(&["did you mean"]);
    bench.run(&["explain", "fall.toml"]).expect(0).says(&[
        "interfaces.default.shear_stiffness",
        "default",
        "given",
    ]);
    let said = bench.run(&["schema"]).expect(0);
    let schema: serde_json::Value = serde_json::from_str(&said.out).expect("JSON");
    assert!(schema["properties"]["blocks"].is_object());
    bench.run(&["schema", "--markdown"]).expect(0).says(&["# Scenario reference"]);
    bench.run(&["fields"]).expect(0).says(&["block.displacement", "energy.residual"]);
    bench.run(&["doctor"]).expect(0).says(&["riprap", "cores"]);
}

#[test]
fn hashes_tell_scenes_apart() {
    let bench = Bench::with_scene();
    let hash = |extra: &[&str]| {
        let words: Vec<&str> = ["hash", "fall.toml"].iter().chain(extra).copied().collect();
        bench.run(&words).expect(0).out
    };
    assert_eq!(hash(&[]), hash(&[]));
    assert_ne!(hash(&[]), hash(&["--set", "materials.rock.density=2001 kg/m3"]));
    assert_eq!(hash(&[]).trim().len(), 64);
}

#[test]
fn a_closed_pipe_is_no_error() {
    let bench = Bench::new();
    let mut command = bench.command(&["schema"]);
    command.stdout(std::process::Stdio::piped()).stderr(std::process::Stdio::piped());
    let mut child = command.spawn().expect("start riprap");
    drop(child.stdout.take());
    let ended = child.wait_with_output().expect("wait");
    assert_eq!(ended.status.code(), Some(0), "{}", String::from_utf8_lossy(&ended.stderr));
}

#[test]
fn every_template_is_written_and_can_be_used() {
    let bench = Bench::new();
    let list = bench.run(&["new", "--list"]).expect(0).out;
    // Of both spaces, rigid, deformable and hybrid.
    for name in ["slide", "slope", "bricks", "blast", "beam", "hybrid"] {
        assert!(list.lines().any(|l| l.starts_with(name)), "{name}");
    }
    for line in list.lines() {
        let name = line.split_whitespace().next().expect("a name");
        let file = format!("{name}.toml");
        bench
            .run(&["new", name, "--template", name])
            .expect(0)
            .says(&[&format!("wrote {file}"), &format!("riprap run {file}")]);
        bench.run(&["explain", &file]).expect(0);
        bench.run(&["new", name, "--template", name]).expect(2).warns(&["--force"]);
        bench.run(&["new", &file, "--template", name, "--force"]).expect(0);
    }
    bench.run(&["new", "x", "--template", "nonsense"]).expect(2).warns(&["unknown template"]);
}
