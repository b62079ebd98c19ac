use std::path::{Path, PathBuf};

use super::{Answer, Line, Rules, RunoutError, runout, wilson};
use crate::record::folder::Existing;
use crate::run::drive::Control;
use crate::run::job;
use crate::run::scene::Scene;
use crate::scenario::Source;

/// Two bodies thrown over level ground, in the plane or in space: one of 1 m at 10 m/s from 20 m, one at 4 m/s.
fn thrown(planar: bool, frames: &str) -> String {
    let v = |x: &str, up: &str| match planar {
        true => format!("[\"{x}\", \"{up}\"]"),
        false => format!("[\"{x}\", \"0 m/s\", \"{up}\"]"),
    };
    let body = |name: &str, at: f64, size: f64, material: &str| match planar {
        true => format!(
            "[[blocks]]\nname = \"{name}\"\nmaterial = \"{material}\"\nrectangle = {{ size = [\"{size} m\", \"1 m\"], corner = [\"{} m\", \"{at} m\"] }}\n",
            -0.5 * size
        ),
        false => format!(
            "[[blocks]]\nname = \"{name}\"\nmaterial = \"{material}\"\nbrick = {{ size = [\"{size} m\", \"{size} m\", \"1 m\"], corner = [\"{0} m\", \"{0} m\", \"{at} m\"] }}\n",
            -0.5 * size
        ),
    };
    let (space, gravity) = match planar {
        true => ("planar", "[\"0 m/s2\", \"-10 m/s2\"]"),
        false => ("spatial", "\"10 m/s2\""),
    };
    let found = if planar { "" } else { "found_contacts = true\n" };
    format!(
        "riprap = 1\ntitle = \"thrown\"\n[space.{space}]\ngravity = {gravity}\n{found}\
        [materials.rock]\ndensity = \"2000 kg/m3\"\n[materials.ground]\ndensity = \"1000 kg/m3\"\n\
        [interfaces.default]\nnormal_stiffness = \"100 MPa/m\"\nfriction_angle = \"30 deg\"\n{}{}groups = [\"rocks\"]\nvelocity = {}\n{}\
        groups = [\"rocks\", \"high\"]\nvelocity = {}\n[[supports]]\non = {{ block = \"floor\" }}\nfixed = {{}}\n\
        [[phases]]\nname = \"fly\"\nuntil = {{ time = \"1.5 s\" }}\ntime_step = \"1 ms\"\n{frames}",
        body("floor", -1.0, 100.0, "ground"),
        body("low", 19.5, 1.0, "rock"),
        v("10 m/s", "0 m/s"),
        body("high", 39.5, 1.0, "rock"),
        v("4 m/s", "2 m/s"),
    )
}

const FRAMES: &str = "[[outputs]]\nframes = { every = \"0.5 s\" }\n";

fn ran(text: &str, folder: &Path) {
    let scene = Scene::parse(Source::new("scene", text), PathBuf::from("."), &[]).unwrap();
    let job = scene.prepare(&scene.plain()).unwrap().job();
    job::run(job, folder, Existing::Refuse, 1, &mut |_| Control::Continue).unwrap();
}

fn near(value: f64, expected: f64) {
    assert!((value - expected).abs() <= 2e-9 * expected.abs().max(1.0), "{value}, not {expected}");
}

fn asked(folder: &Path, of: Option<&str>, lines: &[&str]) -> Result<Answer, RunoutError> {
    let lines = lines.iter().map(|line| Line::read(line).unwrap()).collect();
    runout(&[folder.to_owned()], &Rules { of: of.map(str::to_owned), lines })
}

#[test]
fn free_flight_is_exact_between_frames() {
    for planar in [true, false] {
        let dir = tempfile::tempdir().unwrap();
        let folder = dir.path().join("thrown.run");
        ran(&thrown(planar, FRAMES), &folder);
        let answer = asked(&folder, Some("rocks"), &["road=7 m", "far=13 m"]).unwrap();
        let [low, high] = &answer.rocks[..] else { panic!("{answer:?}") };
        assert_eq!((low.name.as_str(), high.name.as_str()), ("low", "high"));
        near(low.runout, 15.0);
        near(low.drop, 0.5 * 10.0 * 1.5 * 1.5);
        near(low.travel_angle, (low.drop / 15.0_f64).atan().to_degrees());
        // The highest point lies between two frames: 40 m + 0.2 m, as far as eight looks in each see it.
        assert!((high.max_height.unwrap() - 40.2).abs() < 0.01, "{high:?}");
        near(high.runout, 6.0);
        near(low.mass.unwrap(), 2000.0);
        let [passes, far] = &answer.passages[..] else { panic!("{:?}", answer.passages) };
        // x = 7 m after 0.7 s, x = 13 m after 1.3 s: 20 m less g t^2/2, with sqrt(100 + (g t)^2).
        for (passage, t) in [(passes, 0.7_f64), (far, 1.3)] {
            assert_eq!(passage.rock, "low");
            near(passage.time, t);
            near(passage.height.unwrap(), 20.0 - 5.0 * t * t);
            near(passage.speed, (100.0 + 100.0 * t * t).sqrt());
            near(passage.energy.unwrap(), 1000.0 * (100.0 + 100.0 * t * t));
        }
        assert_eq!((answer.lines[0].passed, answer.lines[0].rocks), (1, 2));
        assert_eq!((answer.moving, answer.runs, answer.planar), (2, 1, planar));
        near(answer.runout.half, 6.0);
        near(answer.runout.most, 15.0);
        let one = asked(&folder, Some("high"), &[]).unwrap();
        assert_eq!(one.rocks.len(), 1);
        one.write(dir.path()).unwrap();
        assert!(dir.path().join("rocks.csv").exists() && !dir.path().join("lines.csv").exists());
        // A folder of runs counts all of them; across one another lines have ends.
        ran(&thrown(planar, FRAMES), &dir.path().join("again.run"));
        assert_eq!(asked(dir.path(), None, &[]).unwrap().rocks.len(), 4);
        let wall = asked(&folder, None, &["fence=7 m,-1 m..7 m,1 m", "beside=7 m,1 m..7 m,9 m"]);
        match (planar, wall) {
            (true, wall) => assert!(matches!(wall, Err(RunoutError::Mixed(_)))),
            (false, wall) => {
                let passed: Vec<usize> = wall.unwrap().lines.iter().map(|l| l.passed).collect();
                assert_eq!(passed, [1, 0]);
            }
        }
        let both = [folder.clone(), dir.path().to_owned()];
        let twice = runout(&both, &Rules { of: None, lines: Vec::new() }).unwrap_err();
        assert!(twice.to_string().contains("thrown.run is given twice"), "{twice}");
        let told = asked(&folder, Some("rock"), &[]).unwrap_err().to_string();
        assert!(
            told.contains("unknown block or group \"rock\"; valid groups: high, rocks"),
            "{told}"
        );
    }
}

#[test]
fn what_cannot_be_read_is_told() {
    let dir = tempfile::tempdir().unwrap();
    assert!(matches!(asked(dir.path(), None, &[]), Err(RunoutError::NoRun(_))));
    assert!(matches!(asked(&dir.path().join("no"), None, &[]), Err(RunoutError::NoRun(_))));
    for wrong in ["7 m", "=7 m", "road=7", "road=7 s", "road=7 m..8 m", "road=1 m,2 m..1 m,2 m"] {
        assert!(Line::read(wrong).is_err(), "{wrong}");
    }
    let twice = asked(dir.path(), None, &["road=7 m", "road=8 m"]).unwrap_err();
    assert!(twice.to_string().contains("two lines are called `road`"), "{twice}");
    let road = Line::read("road=1 m,2 m..1.5 km,-2 m").unwrap();
    assert_eq!((road.from, road.to), ([1.0, 2.0], Some([1500.0, -2.0])));
}

#[test]
fn the_interval_of_a_share() {
    // Wilson's interval of 3 in 10, and of none in 40.
    let [low, high] = wilson(3, 10);
    assert!((low - 0.107_789).abs() < 1e-5 && (high - 0.603_222).abs() < 1e-5, "{low} {high}");
    let [low, high] = wilson(0, 40);
    assert!(low < 1e-12 && (high - 0.087_622).abs() < 1e-5, "{low} {high}");
}
