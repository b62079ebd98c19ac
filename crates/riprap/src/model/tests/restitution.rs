//! Restitution as an input of found contacts, in the plane and in space.

use super::*;
use crate::laws::damping::ratio_of;

const SPACE: &str = "riprap = 1\ntitle = \"t\"\n[space.spatial]\nfound_contacts = true\ngravity = \"9.81 m/s2\"\n\
    [materials.rock]\ndensity = \"2500 kg/m3\"\nyoung = \"20 GPa\"\npoisson = 0.25\n";
const PLANE: &str = "riprap = 1\ntitle = \"t\"\n[space.planar]\ngravity = [\"0 m/s2\", \"-9.81 m/s2\"]\n\
    [materials.rock]\ndensity = \"2500 kg/m3\"\n";
const LAW: &str =
    "[interfaces.default]\nnormal_stiffness = \"1 GPa/m\"\nfriction_angle = \"30 deg\"\n";
const BRICK: &str = "[[blocks]]\nname = \"a\"\nmaterial = \"rock\"\nbrick = { size = [\"1 m\", \"1 m\", \"1 m\"], corner = [\"0 m\", \"0 m\", \"0 m\"] }\n\
    [[phases]]\nname = \"fall\"\nuntil.time = \"1 s\"\n";
const SQUARE: &str = "[[blocks]]\nname = \"a\"\nmaterial = \"rock\"\nrectangle = { size = [\"1 m\", \"1 m\"], corner = [\"0 m\", \"0 m\"] }\n\
    [[phases]]\nname = \"fall\"\nuntil.time = \"1 s\"\n";

fn built(text: &str) -> Result<Model, String> {
    let kind = if text.contains("[space.planar]") {
        crate::run::engine::Kind::Planar
    } else {
        crate::run::engine::Kind::Spatial
    };
    let parsed = parse(Source::new("t.toml", text)).map_err(|error| error.render())?;
    build(&parsed, "default", kind.fields()).map_err(|error| error.render())
}

/// Dashpots of joints and of found contacts.
fn damping(text: &str) -> [f64; 2] {
    match built(text).unwrap_or_else(|error| panic!("{error}")).setup {
        Setup::Planar(setup) => [0.0, setup.interfaces[0].contact.damping_ratio],
        Setup::Spatial(setup) => {
            let joint = setup.interfaces[0].joint;
            [joint.damping, joint.contact_damping]
        }
    }
}

#[test]
fn it_sets_the_dashpots_of_found_contacts_alone() {
    let wanted = format!("{LAW}restitution = 0.3\n");
    let ratio = ratio_of(0.3);
    assert!((ratio - 0.497_239).abs() < 1e-6);
    assert_eq!(damping(&format!("{SPACE}{wanted}{BRICK}")), [0.1, ratio]);
    assert_eq!(damping(&format!("{PLANE}{wanted}{SQUARE}")), [0.0, ratio]);
    // Without it one ratio holds for both.
    let given = format!("{LAW}damping_ratio = 0.2\n");
    assert_eq!(damping(&format!("{SPACE}{given}{BRICK}")), [0.2, 0.2]);
    // Without either, joints and free blocks have each their own; in the plane there is one.
    assert_eq!(damping(&format!("{SPACE}{LAW}{BRICK}")), [0.1, ratio_of(0.2)]);
    assert_eq!(damping(&format!("{PLANE}{LAW}{SQUARE}")), [0.0, 0.2]);
    let elastic = format!("{LAW}restitution = 1\n");
    assert_eq!(damping(&format!("{SPACE}{elastic}{BRICK}")), [0.1, 0.0]);
}

/// What a flat impact leaves is said of every interface, given or not, and of none where blocks do not meet.
#[test]
fn what_an_impact_leaves_is_said() {
    let says = |text: &str| {
        let model = built(text).unwrap_or_else(|error| panic!("{error}"));
        let of = |e: &&Explained| e.key == "interfaces.default.damping_ratio";
        model.explained.iter().find(of).unwrap().why.clone()
    };
    let leaves = |share: &str| {
        format!(
            "a face-to-face impact of free blocks rebounds with {share} of their relative \
                 speed (`restitution`)"
        )
    };
    for (keys, share) in
        [("", "0.20"), ("damping_ratio = 0.2\n", "0.57"), ("restitution = 0.9\n", "0.90")]
    {
        assert_eq!(says(&format!("{SPACE}{LAW}{keys}{BRICK}")), leaves(share));
    }
    let apart = SPACE.replace("found_contacts = true", "found_contacts = false");
    assert_eq!(says(&format!("{apart}{LAW}{BRICK}")), "");
}

#[test]
fn two_ways_to_say_it_and_impossible_values_are_refused() {
    for (head, blocks) in [(SPACE, BRICK), (PLANE, SQUARE)] {
        let both = format!("{head}{LAW}restitution = 0.3\ndamping_ratio = 0.2\n{blocks}");
        let error = built(&both).unwrap_err();
        assert!(error.contains("interfaces.default has `damping_ratio`, `restitution`"), "{error}");
        let later = "interfaces.default = { damping_ratio = 0.1, restitution = 0.5 }\n";
        let error = built(&format!("{head}{LAW}{blocks}{later}")).unwrap_err();
        let says = "phases.fall.interfaces.default has `damping_ratio`, `restitution`";
        assert!(error.contains(says), "{error}");
        for value in ["0", "1.2", "-0.5"] {
            let error = built(&format!("{head}{LAW}restitution = {value}\n{blocks}")).unwrap_err();
            assert!(error.contains("at least 0.01 and at most 1"), "{error}");
        }
    }
}

#[test]
fn phases_change_it() {
    let later = "interfaces.default.restitution = 0.5\n";
    let model = built(&format!("{SPACE}{LAW}damping_ratio = 0.2\n{BRICK}{later}")).unwrap();
    let (_, law) = model.plan.phases[0].joints[0];
    assert_eq!((law.damping, law.contact_damping), (0.2, ratio_of(0.5)));
    let model = built(&format!("{PLANE}{LAW}restitution = 0.9\n{SQUARE}{later}")).unwrap();
    assert_eq!(model.plan.phases[0].contacts[0].1.damping_ratio, ratio_of(0.5));
}

#[test]
fn without_found_contacts_it_has_no_effect() {
    let space = SPACE.replace("found_contacts = true", "found_contacts = false");
    let model = built(&format!("{space}{LAW}restitution = 0.5\n{BRICK}")).unwrap();
    let said = model.warnings.iter().map(|w| w.message.as_str());
    let said: Vec<&str> = said.filter(|m| m.contains("restitution")).collect();
    assert_eq!(said, ["`restitution` in interfaces.default has no effect"]);
}
