//! Masses and moments of inertia of their own, and moduli that nothing needs.

use super::*;
use riprap_geom::Mat3;

const BRICK: &str = r#"
[[blocks]]
name = "stone"
material = "rock"
brick = { size = ["1 m", "2 m", "3 m"], corner = ["1 m", "0 m", "0 m"] }
"#;

fn close(a: &Mat3, b: &Mat3, scale: f64) -> bool {
    let pairs = a.to_cols_array().into_iter().zip(b.to_cols_array());
    pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-12 * scale)
}

#[test]
fn a_mass_alone_scales_the_moments_of_the_shape() {
    let (setup, _) = solid(&format!("{BRICK}mass = \"1200 kg\""));
    let [body] = &setup.bodies[..] else {
        panic!("one body");
    };
    assert_eq!((body.block, body.mass), (0, 1200.0));
    let of_brick = Mat3::from_diagonal(100.0 * Vec3::new(13.0, 10.0, 5.0));
    assert!(close(&body.inertia, &of_brick, 1300.0), "{:?}", body.inertia);
}

#[test]
fn given_moments_turn_with_the_shape() {
    let inertia = r#"
inertia = ["30 kg m2", "40 kg m2", "50 kg m2", "0 kg m2", "0 kg m2", "5 kg m2"]
rotate = { quaternion = [1, 0, 0, 1] }
"#;
    let (setup, _) = solid(&format!("{BRICK}{inertia}"));
    // A quarter turn about z, by a quaternion of any length.
    let turned = Mat3::from_cols(
        Vec3::new(40.0, -5.0, 0.0),
        Vec3::new(-5.0, 30.0, 0.0),
        Vec3::new(0.0, 0.0, 50.0),
    );
    assert!(close(&setup.bodies[0].inertia, &turned, 50.0));
    assert_eq!(brick(&setup.blocks[0].shape).1, Vec3::new(1.0, 0.5, 1.5));
}

#[test]
fn no_body_has_such_moments() {
    for (keys, words) in [
        (
            r#"inertia = ["1 kg m2", "1 kg m2", "3 kg m2", "0 kg m2", "0 kg m2", "0 kg m2"]"#,
            "sum of the other two",
        ),
        (
            r#"inertia = ["1 kg m2", "1 kg m2", "1 kg m2", "0 kg m2", "0 kg m2", "2 kg m2"]"#,
            "principal values are -1 kg m2",
        ),
        (r#"mass = "0 kg""#, "greater than zero"),
        (r#"mass = "1 kg/m""#, "a mass"),
        ("mass = \"1 kg\"\nmechanics.deformable = {}", "deformable"),
        (
            "mass = \"1 kg\"\ncut.joint_sets = [{ dip = \"20 deg\", dip_direction = \"40 deg\", spacing = \"1 m\" }]",
            "cannot be used with `cut`",
        ),
        (
            "mass = \"1 kg\"\n[[refine]]\noctree = { around = { all = {} }, levels = 1 }",
            "has `refine`",
        ),
    ] {
        let told = refused(&format!("{BRICK}{keys}"));
        assert!(told.contains(words), "{words}: {told}");
    }
    // A thin plate is at the limit: its largest moment is the sum of the others.
    let plate = r#"inertia = ["1 kg m2", "2 kg m2", "3 kg m2", "0 kg m2", "0 kg m2", "0 kg m2"]"#;
    solid(&format!("{BRICK}{plate}"));
}

#[test]
fn quaternions_that_say_too_little_or_too_much() {
    for (rotate, words) in [
        ("rotate = { quaternion = [0, 0, 0, 0] }", "no length"),
        (
            r#"rotate = { quaternion = [1, 0, 0, 0], angle = "3 deg", axis = [0, 0, 1] }"#,
            "quaternion",
        ),
        ("rotate = { quaternion = [1, 0, 0, 0], axis = [0, 0, 1] }", "leave the others out"),
    ] {
        let told = refused(&format!("{BRICK}{rotate}"));
        assert!(told.contains(words), "{words}: {told}");
    }
}
