use std::path::{Path, PathBuf};

use super::{Answer, Pattern, Rules, muckpile};
use crate::record::folder::Existing;
use crate::run::drive::Control;
use crate::run::job;
use crate::run::scene::Scene;
use crate::scenario::Source;

/// Without gravity two held cubes of 1 m with their upper faces at z = 0, a gap of 1.2 m between them, and a held one of 10 m beside them;
/// a free cube of 1 m with a corner and a velocity, and one of 0.5 m that goes 2 m over the gap at z = 0.05 m.
fn thrown(corner: [f64; 3], velocity: [f64; 3]) -> String {
    let three = |v: [f64; 3], unit: &str| {
        format!("[\"{} {unit}\", \"{} {unit}\", \"{} {unit}\"]", v[0], v[1], v[2])
    };
    let cube = |name: &str, size: f64, corner: [f64; 3], more: &str| {
        format!(
            "[[blocks]]\nname = \"{name}\"\nmaterial = \"rock\"\n{more}\nbrick = {{ size = {}, corner = {} }}\n",
            three([size; 3], "m"),
            three(corner, "m"),
        )
    };
    let free = |v: [f64; 3]| format!("velocity = {}", three(v, "m/s"));
    let held = "groups = [\"held\"]";
    format!(
        "riprap = 1\ntitle = \"thrown\"\n[space.spatial]\ngravity = \"0 m/s2\"\n[materials.rock]\ndensity = \"2000 kg/m3\"\n\
        [interfaces.default]\nnormal_stiffness = \"1 GPa/m\"\nfriction_angle = \"30 deg\"\n\
        {}{}{}{}{}[[supports]]\non.group = \"held\"\nfixed = {{}}\n\
        [[phases]]\nname = \"fly\"\nuntil = {{ time = \"1 s\" }}\ntime_step = \"1 ms\"\n\
        [[outputs]]\nframes = {{ every = \"0.5 s\" }}\n",
        cube("west", 1.0, [-1.1, 0.0, -1.0], held),
        cube("east", 1.0, [1.1, 0.0, -1.0], held),
        cube("large", 1.0, corner, &free(velocity)),
        cube("small", 0.5, [-1.0, 0.25, 0.05], &free([2.0, 0.0, 0.0])),
        cube("ground", 10.0, [2.2, -4.5, -10.0], held),
    )
}

/// The large cube flies out of the gap, 20 m up and 1 m away.
fn out_of_the_gap() -> String {
    thrown([0.0, 0.0, -1.0], [1.0, 0.0, 20.0])
}

fn ran(text: &str, folder: &Path) {
    let scene = Scene::parse(Source::new("scene", text), PathBuf::from("."), &[]).unwrap();
    let job = scene.prepare(&scene.plain()).unwrap().job();
    job::run(job, folder, Existing::Refuse, 1, &mut |_| Control::Continue).unwrap();
}

fn near(value: f64, expected: f64) {
    assert!((value - expected).abs() <= 1e-6 * expected.abs().max(1.0), "{value}, not {expected}");
}

fn asked(text: &str, rules: &Rules) -> Answer {
    let dir = tempfile::tempdir().unwrap();
    let folder = dir.path().join("thrown.run");
    ran(text, &folder);
    muckpile(&folder, rules).unwrap()
}

#[test]
fn what_is_thrown_is_measured_exactly() {
    let answer = asked(&out_of_the_gap(), &Rules::default());
    let throw = answer.throw.as_ref().unwrap();
    assert_eq!((throw.blocks, throw.moving, throw.left), (2, 2, (0, 0.0)));
    near(throw.volume, 1.125);
    near(throw.mass.unwrap(), 2250.0);
    // 1 m of 1 m3 and 2 m of 0.125 m3: nine tenths are more than the first.
    near(throw.shift[0], (1.0 + 0.25) / 1.125);
    near(throw.half, 1.0);
    near(throw.most, 2.0);
    assert_eq!((throw.farthest.block.as_str(), throw.along), ("small", [1.0, 0.0]));
    near(throw.farthest.size, 0.5);
    assert_eq!((throw.farthest.from_charge, answer.behind), (None, None));
    // The surface was at 0 where the large cube was; now the model is open there to its bottom.
    near(answer.crater.unwrap().depth, 10.0);
    let fragments = answer.fragments.unwrap();
    assert_eq!((fragments.count, fragments.n), (2, None));
    near(fragments.curve[0][0], 0.5);
    near(fragments.curve[0][1], 0.125 / 1.125);
    near(fragments.curve[1][0], 1.0);
    assert_eq!(answer.energy.unwrap().put_in, 0.0);
    // A way that none has gone.
    let rules = Rules { moved: Some(30.0), ..Rules::default() };
    assert_eq!(asked(&out_of_the_gap(), &rules).throw, None);
}

#[test]
fn a_pile_is_measured_over_its_ground() {
    // The large cube ends 5 cm over the ground; the small one over the gap (a fifth of it) and over the east cube.
    let rules = Rules { cell: Some(0.05), ..Rules::default() };
    let pile = asked(&thrown([0.0, 0.0, 0.05], [4.0, 0.0, 0.0]), &rules).pile.unwrap();
    near(pile.area, 1.25);
    near(pile.height, 1.05);
    let volume = 1.05 + 0.5 * (0.4 * 0.55 + 0.1 * 0.5);
    near(pile.volume, volume);
    near(pile.swell, volume / 1.125);
    near(pile.profile.iter().map(|s| s.highest).fold(0.0, f64::max), 1.05);
}

#[test]
fn a_pile_of_a_group_lies_on_all_others() {
    // Of two that have flown only the small one counts; the large one, though free, is ground.
    let rules = Rules { of: Some("small and not held".to_owned()), ..Rules::default() };
    let answer = asked(&out_of_the_gap(), &rules);
    let throw = answer.throw.as_ref().unwrap();
    assert_eq!((throw.blocks, answer.fragments.unwrap().count), (1, 1));
    near(throw.volume, 0.125);
    near(throw.half, 2.0);
}

#[test]
fn kuz_ram_is_that_of_cunningham() {
    let pattern = Pattern {
        rock_factor: 7.0,
        powder_factor: Some(0.5),
        charge: Some(64.0),
        strength: 115.0,
        uniformity: Some(1.0),
    };
    let rules = Rules { kuz_ram: Some(pattern), ..Rules::default() };
    let found = asked(&out_of_the_gap(), &rules).kuz_ram.unwrap();
    // 7 x 0.5^-0.8 x 64^(1/6) = 7 x 1.741101 x 2 cm.
    near(found.x50, 0.01 * 7.0 * 2.0_f64.powf(0.8) * 2.0);
    near(found.x80.unwrap(), found.x50 * 5.0_f64.log2());
}

#[test]
fn what_cannot_be_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let folder = dir.path().join("thrown.run");
    ran(&out_of_the_gap(), &folder);
    let said = |rules: &Rules| muckpile(&folder, rules).unwrap_err().to_string();
    assert!(said(&Rules { cell: Some(0.0), ..Rules::default() }).contains("cell of the grid"));
    let none = Pattern {
        rock_factor: 7.0,
        powder_factor: None,
        charge: None,
        strength: 100.0,
        uniformity: None,
    };
    let rules = Rules { kuz_ram: Some(none), ..Rules::default() };
    assert!(said(&rules).contains("the run has no charges; give it"));
    let rules = Rules { of: Some("smal".to_owned()), ..Rules::default() };
    assert!(said(&rules).contains("unknown block or group \"smal\""), "{}", said(&rules));
    let nowhere = muckpile(&dir.path().join("nothing"), &Rules::default());
    assert!(nowhere.unwrap_err().to_string().contains("holds no run"));
}
