//! Criteria against envelopes searched plane by plane, and what is wrong with the printed equations.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use super::super::tetrahedron::tensor;
use super::*;

/// Table 1 of the paper.
/// Angle of friction, rad.
const ANGLE: f64 = std::f64::consts::FRAC_PI_6;
const ROCK: Rock = Rock { tension: 5e6, cohesion: 8e6, friction: 0.577_350_269_189_625_8 };

/// Normal and shear stress on the plane at the angle psi to s1.
fn on_plane(s1: f64, s3: f64, psi: f64) -> (f64, f64) {
    let (r, s) = (0.5 * (s1 - s3), 0.5 * (s1 + s3));
    (s - r * (2.0 * psi).cos(), r * (2.0 * psi).sin())
}

/// Angle in 0 to pi/2 at which `f(sigma, tau)` is largest.
fn worst(s1: f64, s3: f64, f: impl Fn(f64, f64) -> f64) -> (f64, f64) {
    let n = 100_000;
    (0..=n)
        .map(|k| {
            let psi = FRAC_PI_2 * f64::from(k) / f64::from(n);
            let (sigma, tau) = on_plane(s1, s3, psi);
            (psi, f(sigma, tau))
        })
        .fold((0.0, f64::NEG_INFINITY), |a, b| if b.1 > a.1 { b } else { a })
}

fn plain(s1: f64, s2: f64, s3: f64) -> Principal {
    Principal { values: [s1, s2, s3], axes: [Vec3::Y, Vec3::Z, Vec3::X] }
}

#[test]
fn rock_without_tensile_strength_is_cut_in_shear() {
    let rock = Rock { tension: 0.0, ..ROCK };
    let margins = |tension| Margins { tension, shear: 0.0 };
    let assess =
        |margin, s1, s3| assess(&rock, Criterion::Larger, &margins(margin), &plain(s1, s3, s3));
    for margin in [0.0, 1e6] {
        // Pressed all round, far beyond Mohr-Coulomb's limit.
        let shear = assess(margin, 100e6, 2e6);
        assert!(shear.cut() && shear.mode == FractureMode::Shear, "{shear:?}");
        // Within it, nothing is cut.
        let none = assess(margin, 10e6, 2e6);
        assert!(!none.cut() && none.utilisation < 1.0, "{none:?}");
        // Pulled, it is.
        let tension = assess(margin, 1e6, -0.1e6);
        assert!(tension.cut() && tension.mode == FractureMode::Tension);
    }
}

#[test]
fn griffith_is_continuous_and_the_printed_form_is_not() {
    let st = ROCK.tension;
    // At s1 = -3 s3 both branches ask for s3 = -st.
    let (s1, s3) = (3.0 * st, -st);
    assert!((griffith(s1, s3) / st - 1.0).abs() < 1e-12);
    assert!((griffith(s1 * (1.0 + 1e-12), s3) / st - 1.0).abs() < 1e-11);
    let printed = |s1: f64, s3: f64| (s1 + 3.0 * s3).powi(2) / (8.0 * (s1 + s3));
    assert!(
        printed(s1, s3).abs() < 1e-6 * st,
        "no failure at a stress that fails in the other branch"
    );
    // Without lateral stress both have s1 = 8 st: this check does not see the slip of the pen.
    assert!((griffith(8.0 * st, 0.0) / st - 1.0).abs() < 1e-15);
    assert!((printed(8.0 * st, 0.0) / st - 1.0).abs() < 1e-15);
    // Griffith's envelope tau² = 4 st (sigma + st) is touched exactly, at the corrected angle.
    for s3 in [-0.9 * st, -0.3 * st, 0.0, 2.0 * st, 10.0 * st] {
        // (s1 - s3)² = 8 st (s1 + s3).
        let s1 = s3 + 4.0 * st + (16.0 * st * st + 16.0 * st * s3).sqrt();
        assert!((griffith(s1, s3) / st - 1.0).abs() < 1e-12);
        let (psi, most) = worst(s1, s3, |sigma, tau| tau * tau - 4.0 * st * (sigma + st));
        assert!(most.abs() < 1e-6 * st * st, "{most}");
        let angle = plane_angle(&ROCK, FractureMode::Griffith, &plain(s1, 0.5 * (s1 + s3), s3));
        assert!((angle - psi).abs() < 1e-3, "{angle} {psi}");
        // Printed (14) with s1 - s2 depends on the stress that lies in the plane.
        let wrong = 0.5 * ((s1 - 0.5 * (s1 + s3)) / (2.0 * (s1 + s3))).acos();
        assert!((wrong - psi).abs() > 0.02, "{wrong} {psi}");
    }
    let uniaxial = plane_angle(&ROCK, FractureMode::Griffith, &plain(8.0 * st, 0.0, 0.0));
    assert!((uniaxial.to_degrees() - 30.0).abs() < 1e-12);
    assert!(plane_angle(&ROCK, FractureMode::Griffith, &plain(3.0 * st, 0.0, -st)).abs() < 1e-7);
    assert_eq!(plane_angle(&ROCK, FractureMode::Griffith, &plain(st, 0.0, -st)), 0.0);
}

#[test]
fn mohr_coulomb_is_the_worst_plane_and_the_printed_angle_is_not() {
    let tan = ROCK.friction;
    let f = mohr_coulomb(&ROCK, 30e6, 0.0);
    assert!((f - 0.6603e6).abs() < 50.0, "{f}");
    for (s1, s3) in [(30e6, 0.0), (50e6, 7e6), (10e6, -3e6)] {
        let (psi, most) = worst(s1, s3, |sigma, tau| tau - sigma * tan - ROCK.cohesion);
        assert!((most - mohr_coulomb(&ROCK, s1, s3)).abs() < 1.0);
        let angle = plane_angle(&ROCK, FractureMode::Shear, &plain(s1, s3, s3));
        assert!((angle - psi).abs() < 1e-4);
        assert!((angle.to_degrees() - 30.0).abs() < 1e-9);
        // Printed (16), pi/2 +- phi/2: the plane hardly slides.
        for printed in [FRAC_PI_2 + 0.5 * ANGLE, FRAC_PI_2 - 0.5 * ANGLE] {
            let (sigma, tau) = on_plane(s1, s3, printed);
            let there = tau.abs() - sigma * tan - ROCK.cohesion;
            assert!(there < most - 0.4 * (s1 - s3), "{there} {most}");
        }
        // pi/4 + phi/2 is the angle to s3.
        assert!((FRAC_PI_4 + 0.5 * ANGLE + angle - FRAC_PI_2).abs() < 1e-15);
    }
}

/// Printed (11), `|F_s| > |F_n| tan(phi) + c A`: tension would make shear strength.
#[test]
fn printed_11_lets_tension_hold() {
    let sigma: f64 = 4e6;
    let tan = ROCK.friction;
    let (printed, correct) = (sigma * tan + ROCK.cohesion, ROCK.cohesion - sigma * tan);
    assert!(printed > ROCK.cohesion && correct < ROCK.cohesion);
    let strength = super::super::bond::Strength {
        tension: ROCK.tension,
        cohesion: ROCK.cohesion,
        friction: tan,
        residual_friction: tan,
        ..Default::default()
    };
    let used = strength.utilisation(&[sigma, correct, 0.0]).0;
    assert!((used - 1.0).abs() < 1e-12);
}

#[test]
fn criteria_and_margins() {
    let none = Margins::default();
    let verdict = |criterion, margins: &Margins, s1: f64, s3: f64| {
        assess(&ROCK, criterion, margins, &plain(s1, s3, s3))
    };
    // Pure tension.
    for criterion in [Criterion::Source, Criterion::Griffith, Criterion::Larger] {
        let v = verdict(criterion, &none, 0.0, -5.1e6);
        assert!(v.cut() && v.mode == FractureMode::Tension && v.utilisation > 1.0);
        assert!(!verdict(criterion, &none, 0.0, -4.9e6).cut());
        let early = Margins { tension: 0.2e6, shear: 0.0 };
        assert!(verdict(criterion, &early, 0.0, -4.9e6).cut());
    }
    // Compression: 30 MPa is over Mohr-Coulomb's 27.71 and below Griffith's 40.
    assert_eq!(verdict(Criterion::Source, &none, 30e6, 0.0).mode, FractureMode::Shear);
    assert!(verdict(Criterion::Source, &none, 30e6, 0.0).cut());
    assert!(verdict(Criterion::Source, &none, 27.72e6, 0.0).cut());
    assert!(!verdict(Criterion::Source, &none, 27.70e6, 0.0).cut());
    let early = Margins { tension: 0.0, shear: 2e6 };
    assert!(verdict(Criterion::Source, &early, 21e6, 0.0).cut());
    assert!(!verdict(Criterion::Griffith, &none, 39e6, 0.0).cut());
    let v = verdict(Criterion::Griffith, &none, 41e6, 0.0);
    assert!(v.cut() && v.mode == FractureMode::Griffith);
    assert_eq!(verdict(Criterion::MohrCoulomb, &none, 0.0, -9e6).mode, FractureMode::Shear);
    // The gap of (17): s3 below -st with s1 + 3 s3 > 0.
    let weak = Rock { tension: 1e6, ..ROCK };
    let p = plain(5e6, 0.0, -1.2e6);
    assert!(!assess(&weak, Criterion::Source, &none, &p).cut());
    assert!(assess(&weak, Criterion::Larger, &none, &p).cut());
    // A margin above all strength cuts everything.
    let all = Margins { tension: 6e6, shear: 9e6 };
    let v = assess(&ROCK, Criterion::Larger, &all, &plain(0.0, 0.0, 0.0));
    assert!(v.cut() && v.utilisation == f64::INFINITY);
}

#[test]
fn principal_stresses_are_sorted_and_plane() {
    // Tension positive: 3 along x, -10 along y, -4 along z, turned about z by 20 degrees.
    let (s, c) = 20f64.to_radians().sin_cos();
    let (xx, yy) = (3.0 * c * c - 10.0 * s * s, 3.0 * s * s - 10.0 * c * c);
    let xy = 13.0 * s * c;
    let stress = tensor([xx, yy, -4.0, 0.0, 0.0, xy]);
    for out in [None, Some(Vec3::Z)] {
        let p = principal(&stress, out);
        for (value, expected) in p.values.iter().zip([10.0, 4.0, -3.0]) {
            assert!((value - expected).abs() < 1e-12, "{p:?}");
        }
        assert!(p.axes[0].distance(Vec3::new(-s, c, 0.0)) < 1e-12, "{p:?}");
        assert!(p.axes[2].distance(Vec3::new(c, s, 0.0)) < 1e-12);
        // Tension: the crack lies across s3.
        let n = cut_normal(&ROCK, FractureMode::Tension, &p, &[[0.0; 3]; 3], None);
        assert!(n.distance(Vec3::new(c, s, 0.0)) < 1e-12);
    }
    // Out-of-plane stress is not looked at.
    let p = principal(&tensor([1.0, -1.0, 50.0, 0.0, 0.0, 0.0]), Some(Vec3::Z));
    assert_eq!(p.values, [1.0, -50.0, -1.0]);
}

#[test]
fn rotation_chooses_the_conjugate() {
    // Compressed along y; stress and strain are the same for both mirror images, the rotation is not.
    let p = plain(30e6, 5e6, 0.0);
    let turned = |w: f64| [[1e-4, -w, 0.0], [w, -7e-4, 0.0], [0.0, 0.0, 0.0]];
    let n = cut_normal(&ROCK, FractureMode::Shear, &p, &turned(1e-4), None);
    let m = cut_normal(&ROCK, FractureMode::Shear, &p, &turned(-1e-4), None);
    for v in [n, m] {
        // The normal makes 60 degrees with s1 (y).
        assert!((v.y.abs() - 0.5).abs() < 1e-12 && v.z.abs() < 1e-12);
        assert!((v.length() - 1.0).abs() < 1e-12);
    }
    assert!((n.x * n.y + m.x * m.y).abs() < 1e-12 && n.x * n.y != 0.0, "{n} {m}");
    // Without rotation: always the same.
    let tie = cut_normal(&ROCK, FractureMode::Shear, &p, &turned(0.0), None);
    assert_eq!(tie, cut_normal(&ROCK, FractureMode::Shear, &p, &turned(1e-16), None));
    // The chosen plane slides more: its normal and that mirrored.
    let slide = |n: Vec3, w: f64| {
        let s = Vec3::new(n.y, -n.x, 0.0);
        let h = turned(w).map(Vec3::from_array);
        s.dot(Vec3::new(h[0].dot(n), h[1].dot(n), h[2].dot(n))).abs()
    };
    assert!(slide(n, 1e-4) > slide(m, 1e-4));
}

#[test]
fn equal_stresses_follow_the_hint() {
    let p = Principal { values: [30e6, 4.1e6, 4e6], axes: [Vec3::Y, Vec3::X, Vec3::Z] };
    let hint = Vec3::new(0.3, 0.2, 1.0);
    let s = settle(&p, hint);
    let across = Vec3::new(0.3, 0.0, 1.0).normalize();
    assert!(s.axes[1].distance(across) < 1e-12 && s.axes[0] == Vec3::Y);
    assert!(s.axes[2].dot(across).abs() < 1e-12 && s.axes[2].y.abs() < 1e-12);
    let apart = Principal { values: [30e6, 15e6, 4e6], ..p };
    assert_eq!(settle(&apart, hint), apart);
    assert_eq!(settle(&p, Vec3::Y), p);
    let upper = Principal { values: [30e6, 29.9e6, -4e6], ..p };
    assert_eq!(settle(&upper, hint).axes[2], Vec3::Z);
    let n = cut_normal(&ROCK, FractureMode::Shear, &p, &[[0.0; 3]; 3], Some(hint));
    assert!(n.dot(across).abs() < 1e-12);
}
