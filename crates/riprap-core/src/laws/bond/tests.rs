//! Bonds: strength, slider, softening energies, energy ledger.

use super::*;

/// Table 1 of the paper.
const STRENGTH: Strength = Strength {
    tension: 5e6,
    cohesion: 8e6,
    friction: 0.577_350_269_189_625_8,
    residual_friction: 0.577_350_269_189_625_8,
    residual_cohesion: 0.0,
    dilation: 0.0,
    dilation_end: 0.0,
};
const K: Springs = [1e14, 4e13];
const NONE: Traction = [0.0; 3];

/// A broken point with this coefficient of friction.
fn rubbing(friction: f64) -> Strength {
    Strength { residual_friction: friction, ..STRENGTH }
}

#[test]
fn residual_cohesion_holds_only_what_is_pressed() {
    let strength = Strength { residual_cohesion: 1e6, ..rubbing(0.5) };
    // 2 MPa of pressure, and far more shear than can be borne.
    let (t, state) = contact(K, &strength, &NONE, &[-2e6 / K[0], 1.0, 0.0], &State::default());
    assert!((t[1] - 2e6).abs() < 1e-3, "{t:?}");
    assert!((state.slip[0] - (1.0 - 2e6 / K[1])).abs() < 1e-12);
    let (t, _) = contact(K, &strength, &NONE, &[1e-9, 1.0, 0.0], &State::default());
    assert_eq!(t, NONE);
}

fn law(softening: Softening) -> Cohesive {
    Cohesive { strength: STRENGTH, energy: [20.0, 80.0], softening, curve: None }
}

/// All curves by name, and one by points.
fn curves() -> Vec<(Softening, Option<Curve>)> {
    let points = [[0.0, 1.0], [0.1, 0.4], [0.4, 0.4], [0.9, 0.05], [2.0, 0.0]];
    let named = [
        Softening::Linear,
        Softening::Munjiza,
        Softening::Petersson,
        Softening::Hordijk,
        Softening::Exponential,
    ];
    let named = named.map(|softening| (softening, None));
    let own = (Softening::Linear, Some(Curve::new(&points).unwrap()));
    named.into_iter().chain([own]).collect()
}

#[test]
fn tension_lowers_the_shear_strength() {
    // Printed (11), |F_s| > |F_n| tan(phi) + c A, would let this point hold.
    let t: Traction = [4e6, 8.5e6, 0.0];
    let printed = t[0].abs() * STRENGTH.friction + STRENGTH.cohesion;
    assert!(t[1] < printed);
    assert_eq!(STRENGTH.failure(&t), Some(FailureMode::Shear));
    assert_eq!(STRENGTH.failure(&[5.1e6, 0.0, 0.0]), Some(FailureMode::Tension));
    assert_eq!(STRENGTH.failure(&[-4e6, 0.0, 10.3e6]), None);
    assert_eq!(STRENGTH.failure(&[-4e6, 0.0, 10.4e6]), Some(FailureMode::Shear));
    assert!((STRENGTH.apex() - 13.86e6).abs() < 0.01e6);
    let nothing = Strength { tension: 0.0, cohesion: 0.0, ..STRENGTH };
    assert_eq!(nothing.utilisation(&NONE).0, 0.0);
    assert!(nothing.failure(&[1.0, 0.0, 0.0]).is_some());
}

/// A traction at u times its limit has the utilisation u, in tension, in shear and in compression.
#[test]
fn utilisation_scales_with_the_traction() {
    for t in [[1e6, 2e6, 0.0], [0.2e6, 3e6, 1e6], [-2e6, 3e6, 2e6], [40e6, 1e6, 0.0]] {
        let (used, mode) = STRENGTH.utilisation(&t);
        assert!(used.is_finite() && used > 0.0, "{t:?}");
        let at = |factor: f64| t.map(|x: f64| factor / used * x);
        assert_eq!(STRENGTH.failure(&at(1.0 - 1e-12)), None);
        assert_eq!(STRENGTH.failure(&at(1.0 + 1e-12)), Some(mode));
    }
}

#[test]
fn springs_of_thin_layers_add() {
    let k = springs(40e9, 16e9, 3e-4);
    assert!((k[0] * 3e-4 - 40e9).abs() < 1.0 && (k[1] * 3e-4 - 16e9).abs() < 1.0);
    assert_eq!(in_series(2.0, [f64::INFINITY; 2]), 2.0);
    assert!((in_series(2.0, [2.0, f64::INFINITY]) - 1.0).abs() < 1e-15);
}

#[test]
fn a_broken_point_slides_at_the_limit_and_sticks_on_reversal() {
    // Compressed to 10 MPa, sheared beyond the peak of 13.77 MPa.
    let at = |s: f64| [-1e-7, s, 0.0];
    let (t, state) = brittle(K, &STRENGTH, &NONE, &at(3.4e-7), &State::default());
    assert_eq!(state, State::default());
    assert!((t[1] - 13.6e6).abs() < 1.0);
    let (t, state) = brittle(K, &STRENGTH, &NONE, &at(3.5e-7), &state);
    let limit = 10e6 * STRENGTH.friction;
    assert_eq!(state.damage, 1.0);
    assert!((t[0] + 10e6).abs() < 1e-3 && (t[1] - limit).abs() < 1e-3);
    let (t, after) = brittle(K, &STRENGTH, &NONE, &at(3.4e-7), &state);
    assert_eq!(after, state);
    assert!((t[1] - (limit - 0.4e6)).abs() < 1.0);
    // Below the limit at breakage: the shear traction goes on unchanged.
    let low = contact(K, &rubbing(0.577), &NONE, &[-1e-7, 1e-7, 0.0], &State::default());
    assert!((low.0[1] - 4e6).abs() < 1e-3);
    // Open: nothing; closing again: no shear from the time it was open.
    let (t, open) = brittle(K, &STRENGTH, &NONE, &[1e-6, 5e-6, 1e-6], &state);
    assert_eq!((t, open.slip), (NONE, [5e-6, 1e-6]));
    let (t, _) = brittle(K, &STRENGTH, &NONE, &[-1e-8, 5e-6, 1e-6], &open);
    assert!((t[0] + 1e6).abs() < 1e-3 && t[1] == 0.0);
}

#[test]
fn a_start_traction_is_a_shifted_origin() {
    let start = [-2e6, 1e6, -3e6];
    let shift = [-2e6 / K[0], 1e6 / K[1], -3e6 / K[1]];
    let mut a = State::default();
    let mut b = State::default();
    for k in 0..40 {
        let s = 2e-8 * f64::from(k);
        let at = [-0.2 * s, s, 0.3 * s];
        let moved = [at[0] + shift[0], at[1] + shift[1], at[2] + shift[2]];
        let (t, next) = brittle(K, &STRENGTH, &start, &at, &a);
        let (u, other) = brittle(K, &STRENGTH, &NONE, &moved, &b);
        for k in 0..3 {
            assert!((t[k] - u[k]).abs() < 1.0, "{t:?} {u:?}");
        }
        (a, b) = (next, other);
    }
    assert_eq!(a.damage, 1.0);
}

/// Work of a cohesive point along a path, J/m².
fn work(k: Springs, law: &Cohesive, path: impl Iterator<Item = [f64; 3]>) -> (f64, State) {
    let (mut at, mut t, mut state, mut sum) = ([0.0; 3], NONE, State::default(), 0.0);
    for next in path {
        let (u, new) = cohesive(k, law, &NONE, &next, &state);
        sum += (0..3).map(|k| 0.5 * (t[k] + u[k]) * (next[k] - at[k])).sum::<f64>();
        (at, t, state) = (next, u, new);
    }
    (sum, state)
}

/// There, half way back, and to the end: in steps fine enough for the trapezoidal rule.
fn reload(end: f64) -> impl Iterator<Item = f64> {
    let n = 200_000;
    let up = move |k: i32| end * f64::from(k) / f64::from(n);
    let back = (0..n / 4).map(move |k| up(n / 3 - k));
    (0..n / 3).map(up).chain(back).chain((0..=n).map(up))
}

#[test]
fn work_to_full_separation_is_the_fracture_energy() {
    for thickness in [3e-3, 3e-4, 3e-5] {
        let k = springs(40e9, 16e9, thickness);
        for (softening, curve) in curves() {
            let law = Cohesive {
                strength: Strength { tension: 2e6, cohesion: 10e6, ..STRENGTH },
                energy: [50.0, 200.0],
                softening,
                curve,
            };
            for (mode, direction) in [[1.0, 0.0, 0.0], [0.0, 0.6, -0.8]].iter().enumerate() {
                let path = reload(2e-4).map(|s| direction.map(|d| s * d));
                let (sum, state) = work(k, &law, path);
                assert_eq!(state.damage, 1.0);
                let ratio = sum / law.energy[mode];
                assert!((ratio - 1.0).abs() < 1e-3, "{thickness} {softening:?}: {ratio}");
            }
        }
    }
}

#[test]
fn mixed_modes_share_the_energy() {
    for (softening, curve) in curves() {
        let law = Cohesive { curve, ..law(softening) };
        for angle in [0.2_f64, 0.7, 1.2] {
            let (mut at, mut t, mut state) = ([0.0; 3], NONE, State::default());
            let mut taken = [0.0; 2];
            for k in 1..=100_000 {
                let s = 1e-4 * f64::from(k) / 1e5;
                let next = [s * angle.cos(), s * angle.sin(), 0.0];
                let (u, new) = cohesive(K, &law, &NONE, &next, &state);
                for (k, sum) in taken.iter_mut().enumerate() {
                    *sum += 0.5 * (t[k] + u[k]) * (next[k] - at[k]);
                }
                (at, t, state) = (next, u, new);
            }
            assert_eq!(state.damage, 1.0);
            let sum = taken[0] / law.energy[0] + taken[1] / law.energy[1];
            assert!((sum - 1.0).abs() < 1e-3, "{angle}: {sum}");
        }
    }
}

#[test]
fn friction_comes_on_top_and_what_is_left_is_a_contact() {
    let law = law(Softening::Linear);
    let pressure = 4e6;
    let (mut at, mut t) = ([-pressure / K[0], 0.0, 0.0], [-pressure, 0.0, 0.0]);
    let (mut state, mut sum, mut peak) = (State::default(), 0.0, 0.0_f64);
    for k in 1..=400_000 {
        let next = [at[0], 4e-5 * f64::from(k) / 4e5, 0.0];
        let (u, new) = cohesive(K, &law, &NONE, &next, &state);
        sum += 0.5 * (t[1] + u[1]) * (next[1] - at[1]);
        peak = peak.max(u[1]);
        (at, t, state) = (next, u, new);
    }
    let rub = pressure * STRENGTH.friction;
    assert!((peak / (8e6 + rub) - 1.0).abs() < 1e-3);
    assert_eq!(state.damage, 1.0);
    let bond = sum - rub * state.slip[0] - 0.5 * rub * rub / K[1];
    assert!((bond / 80.0 - 1.0).abs() < 1e-3, "{}", bond / 80.0);
    // From here on it is the contact law.
    for next in [[at[0], 3.9e-5, 1e-6], [1e-7, 0.0, 0.0], [-1e-8, 1e-8, 2e-6]] {
        let (u, new) = cohesive(K, &law, &NONE, &next, &state);
        let (v, other) = contact(K, &law.strength, &NONE, &next, &state);
        assert_eq!((u, new), (v, other));
        state = new;
    }
}

/// On random paths nothing is gained: the loss of every fine step is at least round-off.
#[test]
fn energy_is_only_lost() {
    let mut seed = 9_u64;
    let mut noise = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    for (softening, curve) in curves() {
        let law = Cohesive { curve, ..law(softening) };
        let start = [-1e6, 2e6, 0.0];
        for _ in 0..20 {
            let mut at = [0.0; 3];
            let (mut t, mut state) = cohesive(K, &law, &start, &at, &State::default());
            let mut total = 0.0;
            for _ in 0..40 {
                let target = [4e-6 * noise(), 4e-6 * noise(), 4e-6 * noise()];
                let from = at;
                for k in 1..=500 {
                    let s = f64::from(k) / 500.0;
                    let next = [0, 1, 2].map(|i| from[i] + s * (target[i] - from[i]));
                    let (u, new) = cohesive(K, &law, &start, &next, &state);
                    assert!(new.damage >= state.damage);
                    let lost = loss(K, &start, (&at, &t, &state), (&next, &u, &new));
                    assert!(lost > -0.02, "{lost}");
                    total += lost;
                    (at, t, state) = (next, u, new);
                }
            }
            assert!(total > 0.0);
        }
    }
}

#[test]
fn the_slider_loses_what_it_rubs() {
    let mut state = contact(K, &rubbing(0.5), &NONE, &[-1e-7, 1e-7, 0.0], &State::default()).1;
    let (mut at, mut t) = ([-1e-7, 1e-7, 0.0], [-1e7, 4e6, 0.0]);
    let mut total = 0.0;
    for k in 1..=1000 {
        let next = [-1e-7, 1e-7 + 1e-9 * f64::from(k), 0.0];
        let (u, new) = contact(K, &rubbing(0.5), &NONE, &next, &state);
        total += loss(K, &NONE, (&at, &t, &state), (&next, &u, &new));
        (at, t, state) = (next, u, new);
    }
    // It slides from 1.25e-7 m on, at 5 MPa.
    assert!((total / (5e6 * (1.1e-6 - 1.25e-7)) - 1.0).abs() < 1e-9, "{total}");
}

/// A point that is pulled apart follows its curve: traction over strength at the opening past the peak.
#[test]
fn a_pulled_point_is_on_its_curve() {
    let strength = Strength { tension: 2e6, ..STRENGTH };
    let (rise, energy) = (2e6 / K[0], 50.0);
    for (softening, curve) in curves() {
        let law = Cohesive { strength, energy: [energy, 200.0], softening, curve };
        assert!((law.share(0.0) - 1.0).abs() < 1e-15 && law.share(1.0).abs() < 1e-15);
        let steps = 100_000_u32;
        let x = |k: u32| f64::from(k) / f64::from(steps);
        let sum: f64 = (0..steps).map(|k| law.share(0.5 * (x(k) + x(k + 1)))).sum();
        assert!((sum / f64::from(steps) - law.share_area()).abs() < 2e-7);
        assert!((0..steps).all(|k| law.share(x(k)) >= law.share(x(k + 1))));
        let length = (energy / 2e6 - 0.5 * rise) / law.share_area();
        for part in [0.01, 0.05, 0.2, 0.4, 0.7, 0.95] {
            let at = [rise + part * length, 0.0, 0.0];
            let (t, _) = cohesive(K, &law, &NONE, &at, &State::default());
            let wanted = 2e6 * law.share(part);
            assert!((t[0] - wanted).abs() < 1e-3, "{softening:?} {part}: {t:?} {wanted}");
        }
    }
}

#[test]
fn curves_have_the_numbers_of_their_sources() {
    let of = |softening| law(softening);
    // Petersson: kink at 0.8 G/f, end at 3.6 G/f; Hordijk: end at 5.136 G/f; exponential: tangent meets nothing at G/f.
    assert!((1.0 / of(Softening::Petersson).share_area() - 3.6).abs() < 1e-12);
    assert!((of(Softening::Petersson).share(0.8 / 3.6) - 1.0 / 3.0).abs() < 1e-12);
    assert!((1.0 / of(Softening::Hordijk).share_area() - 5.136).abs() < 1e-3);
    let exponential = of(Softening::Exponential);
    let slope = (1.0 - exponential.share(1e-6)) / 1e-6 * exponential.share_area();
    assert!((slope - 1.0).abs() < 0.01, "{slope}");
}

#[test]
fn points_that_are_no_curve_are_refused() {
    let new = |points: &[[f64; 2]]| Curve::new(points).unwrap_err();
    assert_eq!(new(&[[0.0, 1.0]]), CurveError::Count { count: 1 });
    assert_eq!(new(&[[0.0, 0.9], [1.0, 0.0]]), CurveError::Start);
    assert_eq!(new(&[[0.0, 1.0], [1.0, 0.1]]), CurveError::End);
    let order = new(&[[0.0, 1.0], [0.5, 0.3], [0.5, 0.0]]);
    assert_eq!(order, CurveError::Order { point: 3 });
    let rise = new(&[[0.0, 1.0], [0.5, 0.3], [0.6, 0.4], [1.0, 0.0]]);
    assert_eq!(rise, CurveError::Rise { point: 3 });
    assert_eq!(new(&[[0.0, 1.0], [f64::NAN, 0.0]]), CurveError::Order { point: 2 });
}

#[test]
fn munjizas_curve_has_the_known_area() {
    let n = 100_000;
    let f = |k: i32| munjiza(f64::from(k) / f64::from(n));
    let sum: f64 = (0..n).step_by(2).map(|k| f(k) + 4.0 * f(k + 1) + f(k + 2)).sum();
    let area = sum / (3.0 * f64::from(n));
    assert!((area - cohesive::MUNJIZA_AREA).abs() < 1e-7, "{area:.9}");
    assert!((area - 0.38631).abs() < 1e-5);
    assert!((munjiza(0.0) - 1.0).abs() < 1e-15 && munjiza(1.0) == 0.0);
    assert!((0..n).all(|k| f(k) > f(k + 1)));
}

#[test]
fn eight_points_are_eight_single_ones() {
    let mut seed = 5_u64;
    let mut noise = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let mut lanes =
        || std::array::from_fn::<Lanes, 3, _>(|_| Lanes(std::array::from_fn(|_| noise())));
    let (mut n, mut at) = (lanes(), lanes());
    for k in 0..LANES {
        let size = (n[0].0[k].powi(2) + n[1].0[k].powi(2) + n[2].0[k].powi(2)).sqrt();
        for i in 0..3 {
            n[i].0[k] /= size;
            at[i].0[k] *= 3e-7;
        }
    }
    let t = connect_eight([Lanes::all(K[0]), Lanes::all(K[1])], &n, &at);
    let mut failed = 0;
    for k in 0..LANES {
        let one = |v: &Vectors| crate::Vec3::new(v[0].0[k], v[1].0[k], v[2].0[k]);
        let axes = crate::geom::polyhedron::frame(one(&n));
        let local = |v: &Vectors| axes.map(|a| a.dot(one(v)));
        let single = connect(K, &[0.0; 3], &local(&at));
        for (i, x) in local(&t).iter().enumerate() {
            assert!((x - single[i]).abs() < 1e-6, "{x} {}", single[i]);
        }
        // The others have no traction.
        let alone = |v: &Vectors| {
            let mut lone = Vectors::default();
            for i in 0..3 {
                lone[i].0[k] = v[i].0[k];
            }
            lone
        };
        let fails = STRENGTH.failure(&single).is_some();
        assert_eq!(fails, near_eight(&STRENGTH, &alone(&n), &alone(&t)));
        failed += usize::from(fails);
    }
    assert!(failed > 0 && failed < LANES, "{failed}");
    assert!(near_eight(&STRENGTH, &n, &t));
}

#[test]
fn a_point_at_its_strength_is_never_passed_over() {
    let n = [Lanes::all(0.6), Lanes::all(0.0), Lanes::all(0.8)];
    let strength =
        Strength { tension: 5e6, cohesion: 8e6, friction: 0.5, residual_friction: 0.5, ..STRENGTH };
    for (sigma, tau) in [(5e6, 0.0), (-1e9, 5.08e8), (0.0, 8e6), (4e6, 6e6)] {
        for share in [1.0 - 1e-12, 1.0, 1.0 + 1e-12] {
            let t = [
                Lanes::all(share * (0.6 * sigma - 0.8 * tau)),
                Lanes::all(0.0),
                Lanes::all(share * (0.8 * sigma + 0.6 * tau)),
            ];
            assert!(near_eight(&strength, &n, &t), "{sigma} {tau} {share}");
        }
        let less = |x: f64| Lanes::all(0.999 * x);
        let t = [less(0.6 * sigma - 0.8 * tau), Lanes::all(0.0), less(0.8 * sigma + 0.6 * tau)];
        assert!(!near_eight(&strength, &n, &t), "{sigma} {tau}");
    }
}
