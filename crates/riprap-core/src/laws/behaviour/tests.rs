//! Closed forms, limit cases, symmetry, ledger.

use super::*;

const SPRINGS: Springs = [2e10, 1e10];

fn strength() -> Strength {
    Strength {
        cohesion: 1e6,
        tension: 0.3e6,
        friction: 0.6,
        residual_friction: 0.5,
        residual_cohesion: 0.1e6,
        ..Strength::default()
    }
}

fn softening() -> JointModel {
    JointModel {
        weakening: Weakening::Softening(Softening { slip: 1e-3, opening: 1e-4, curve: None }),
        closure: Closure::Linear,
    }
}

fn rough(peak_slip: Option<f64>) -> (Strength, JointModel) {
    let strength = Strength {
        residual_friction: libm::tan(28f64.to_radians()),
        friction: libm::tan(28f64.to_radians()),
        ..Strength::default()
    };
    let behaviour = JointModel {
        weakening: Weakening::BartonBandis(BartonBandis {
            jrc: 10.0,
            jcs: 100e6,
            peak_slip,
            share: 1.0,
        }),
        closure: Closure::Linear,
    };
    (strength, behaviour)
}

/// Shears a point and a face along `path` (n, b, c, m): tractions of both, losses and the balance of the point.
struct Sheared {
    point: Vec<Traction>,
    face: Vec<Traction>,
    loss: Loss,
    memory: Memory,
    /// Work less stored energy less losses over the work, of the point and of the face.
    residual: [f64; 2],
}

fn shear(law: &Law, path: &[[f64; 3]]) -> Sheared {
    let start = [0.0; 3];
    let (mut memory, mut four) = (Memory::default(), [Memory::default(); 4]);
    let mut out = Sheared {
        point: Vec::new(),
        face: Vec::new(),
        loss: Loss::default(),
        memory,
        residual: [0.0; 2],
    };
    let mut before = path[0];
    let (mut work, mut lost) = ([0.0; 2], [0.0; 2]);
    let mut old = [law.carried(&start, &before, &memory); 2];
    let first: f64 = law.energy(&start, &before, &memory).iter().sum();
    for at in path {
        let moved = [0, 1, 2].map(|k| at[k] - before[k]);
        let (t, loss) = law.point(&start, at, &moved, &mut memory);
        let (f, of_face) = law.face(&[start; 4], &[*at; 4], &[moved; 4], [0.25; 2], &mut four);
        for (k, now) in [t, f[0]].iter().enumerate() {
            work[k] += (0..3).map(|i| 0.5 * (old[k][i] + now[i]) * moved[i]).sum::<f64>();
        }
        out.loss.friction += loss.friction;
        out.loss.fracture += loss.fracture;
        lost[0] += loss.friction + loss.fracture;
        lost[1] += of_face.friction + of_face.fracture;
        out.point.push(t);
        out.face.push(f[0]);
        old = [t, f[0]];
        before = *at;
    }
    let held: f64 = law.energy(&start, &before, &memory).iter().sum();
    let face = law.energy_of_face(&[start; 4], &[before; 4], &four);
    let of_face: f64 = face.iter().flatten().map(|e| 0.25 * e).sum();
    let rest = [held, of_face].map(|held| held - first);
    out.residual = [0, 1].map(|k| (work[k] - rest[k] - lost[k]) / work[k].abs().max(lost[k]));
    out.memory = memory;
    out
}

/// A straight path in shear at one opening.
fn straight(opening: f64, end: f64) -> Vec<[f64; 3]> {
    (0..=20_000).map(|k| [opening, end * f64::from(k) / 20_000.0, 0.0]).collect()
}

#[test]
fn cohesion_and_friction_go_linearly_to_their_residuals() {
    let (strength, behaviour) = (strength(), softening());
    let law = Law::new(Some(&strength), &behaviour, SPRINGS);
    let sheared = shear(&law, &straight(-5e-5, 2e-3));
    let (s, tau) = (1e6, |t: &Traction| t[1]);
    let (peak, residual) = (1e6 + 0.6 * s, 0.1e6 + 0.5 * s);
    let most = sheared.point.iter().map(tau).fold(0.0, f64::max);
    assert!((most / peak - 1.0).abs() < 1e-4, "{most}");
    // Half of the way down: slip 0.5 mm, and the shear spring on top.
    let middle = 0.5 * (peak + residual);
    let k = ((0.5e-3 + middle / 1e10) / 2e-3 * 20_000.0).round() as usize;
    assert!((sheared.point[k][1] / middle - 1.0).abs() < 1e-4);
    assert!((sheared.point[20_000][1] / residual - 1.0).abs() < 1e-9);
    assert!(sheared.memory.broken);
    // Work of separation: the area under the curve above the residual strength.
    let work = 0.5 * (peak - residual) * 1e-3;
    assert!((sheared.loss.fracture / work - 1.0).abs() < 1e-6);
    assert!(sheared.residual[0].abs() < 1e-9, "{:?}", sheared.residual);
    assert!(sheared.residual[1].abs() < 1e-9, "{:?}", sheared.residual);
    for (t, f) in sheared.point.iter().zip(&sheared.face) {
        assert!((t[1] - f[1]).abs() < 1e-6 * peak);
    }
}

/// Along a curve by points: what is left of the strength at a slip and at an opening, and the work of separation under it.
#[test]
fn joints_soften_along_a_curve() {
    let curve = Curve::new(&[[0.0, 1.0], [0.2, 0.3], [0.6, 0.25], [1.0, 0.0]]).unwrap();
    let behaviour = JointModel {
        weakening: Weakening::Softening(Softening {
            slip: 1e-3,
            opening: 1e-4,
            curve: Some(curve),
        }),
        closure: Closure::Linear,
    };
    let strength = strength();
    let law = Law::new(Some(&strength), &behaviour, SPRINGS);
    let sheared = shear(&law, &straight(-5e-5, 2e-3));
    let (peak, residual) = (1e6 + 0.6 * 1e6, 0.1e6 + 0.5 * 1e6);
    for slip in [0.05e-3, 0.2e-3, 0.5e-3, 0.9e-3] {
        let wanted = residual + curve.at(slip / 1e-3) * (peak - residual);
        let k = ((slip + wanted / 1e10) / 2e-3 * 20_000.0).round() as usize;
        let ratio = sheared.point[k][1] / wanted;
        assert!((ratio - 1.0).abs() < 2e-3, "{slip} {ratio}");
    }
    assert!(sheared.memory.broken);
    let open: Vec<[f64; 3]> =
        (0..=20_000).map(|k| [1.3e-4 * f64::from(k) / 20_000.0, 0.0, 0.0]).collect();
    let drawn = shear(&law, &open);
    for parted in [0.1e-4, 0.4e-4, 0.8e-4] {
        let wanted = 0.3e6 * curve.at(parted / 1e-4);
        let k = ((parted + wanted / SPRINGS[0]) / 1.3e-4 * 20_000.0).round() as usize;
        let ratio = drawn.point[k][0] / wanted;
        assert!((ratio - 1.0).abs() < 2e-3, "{parted} {ratio}");
    }
    let work =
        0.3e6 * (0.5 * 0.3e6 / SPRINGS[0] + curve.area() * 1e-4) - 0.3e6 * 0.5 * 0.3e6 / SPRINGS[0];
    let lost = drawn.loss.fracture;
    assert!((lost / work - 1.0).abs() < 2e-3, "{lost} {work}");
    assert!(drawn.memory.open && drawn.memory.broken);
}

#[test]
fn tension_softens_and_a_crack_that_closes_is_closed() {
    let (strength, behaviour) = (strength(), softening());
    let law = Law::new(Some(&strength), &behaviour, SPRINGS);
    let open: Vec<[f64; 3]> =
        (0..=20_000).map(|k| [1.3e-4 * f64::from(k) / 20_000.0, 0.0, 0.0]).collect();
    let sheared = shear(&law, &open);
    let most = sheared.point.iter().map(|t| t[0]).fold(0.0, f64::max);
    assert!((most / 0.3e6 - 1.0).abs() < 1e-3, "{most}");
    assert!(sheared.memory.open && sheared.memory.broken);
    // Elastic and softening part of the curve: t w/2 each, and all of it is lost.
    let work = 0.5 * 0.3e6 * 1e-4;
    assert!((sheared.loss.fracture / work - 1.0).abs() < 1e-4, "{}", sheared.loss.fracture);
    // Half open, back and forth: through the origin, without loss, and into compression with the full stiffness.
    let half = (0..=1000).map(|k| [6e-8 * f64::from(k), 0.0, 0.0]);
    let back = (0..=2000).map(|k| [6e-5 - 6e-8 * f64::from(k), 0.0, 0.0]);
    let path: Vec<[f64; 3]> = half.chain(back).collect();
    let sheared = shear(&law, &path);
    let t = &sheared.point;
    assert!((t[1000][0] / (0.3e6 * (1.0 - 0.45e-4 / 0.85e-4)) - 1.0).abs() < 1.0);
    assert!((t[1501][0] / t[1000][0] - 0.5).abs() < 1e-9);
    assert!(t[2001][0].abs() < 1e-3 && (t[3001][0] / (-6e-5 * 2e10) - 1.0).abs() < 1e-12);
    assert!(sheared.residual.iter().all(|r| r.abs() < 1e-9), "{:?}", sheared.residual);
}

#[test]
fn rough_joints_have_the_numbers_of_the_closed_form() {
    let (strength, behaviour) = rough(None);
    let Weakening::BartonBandis(law) = behaviour.weakening else { unreachable!() };
    let phi = strength.residual_friction;
    for (s, tau, dilation) in
        [(0.2e6, 0.285520e6, 13.4949f64), (1e6, 1.110613e6, 10.0), (5e6, 4.348012e6, 6.5051)]
    {
        assert!((law.strength(phi, s, 0.0) / tau - 1.0).abs() < 3e-6);
        let angle = libm::atan(law.dilation(phi, s, 0.0)).to_degrees();
        assert!((angle - dilation).abs() < 1e-4, "{angle}");
    }
    // Above JCS friction alone, near nothing at most 70 degrees.
    assert!((law.strength(phi, 2e8, 0.0) / (2e8 * phi) - 1.0).abs() < 1e-12);
    let steep = law.strength(phi, 1.0, 0.0);
    assert!((steep / libm::tan(70f64.to_radians()) - 1.0).abs() < 1e-12);
    let [jrc, jcs] = scaled(10.0, 100e6, 1.0);
    assert!((jrc - 6.30957).abs() < 1e-5 && (jcs - 50.1187e6).abs() < 50.0);
    assert!((slip_at_peak(jrc, 1.0) - 3.67308e-3).abs() < 1e-8);
    let [stiffness, most] = closure_of(10.0, 100e6, 100e6).unwrap();
    assert!((stiffness - 20.35e9).abs() < 1.0 && (most - 0.136871e-3).abs() < 1e-9);
    assert!(closure_of(0.0, 100e6, 100e6).is_none());
    let mobilised = BartonBandis { peak_slip: Some(1e-3), ..law };
    assert!(mobilised.strength(phi, 1e6, 0.0).abs() < 1e-6);
    let at = |x: f64| mobilised.strength(phi, 1e6, x * 1e-3);
    assert!((at(0.3) / (1e6 * phi) - 1.0).abs() < 1e-12);
    assert!((at(1.0) / 1.110613e6 - 1.0).abs() < 3e-6);
    assert!((at(10.0) / (1e6 * libm::tan(38f64.to_radians())) - 1.0).abs() < 1e-12);
    assert!((at(500.0) / (1e6 * phi) - 1.0).abs() < 1e-12);
}

#[test]
fn a_rough_joint_follows_its_curve_and_dilates() {
    let (strength, behaviour) = rough(Some(1e-3));
    let law = Law::new(Some(&strength), &behaviour, SPRINGS);
    let sheared = shear(&law, &straight(-1e-3, 4e-3));
    let Weakening::BartonBandis(b) = behaviour.weakening else { unreachable!() };
    let path = sheared.memory.accumulated_slip;
    let t = sheared.point[20_000];
    let expected = b.strength(strength.residual_friction, -t[0], path);
    assert!((t[1] / expected - 1.0).abs() < 1e-9);
    // Dilation presses it together: 20 MPa at the start, more in the end.
    assert!(sheared.memory.dilated > 1e-4 && t[0] < -20e6 - 1e-4 * SPRINGS[0]);
    assert!(sheared.residual.iter().all(|r| r.abs() < 1e-6), "{:?}", sheared.residual);
    assert!(sheared.loss.fracture == 0.0 && sheared.loss.friction > 0.0);
    let last = (sheared.point[20_000], sheared.face[20_000]);
    assert!((last.0[1] / last.1[1] - 1.0).abs() < 1e-9);
}

#[test]
fn dilation_ends_and_goes_back() {
    let strength =
        Strength { dilation: 0.2, dilation_end: 1e-3, cohesion: 0.0, tension: 0.0, ..strength() };
    let behaviour = JointModel::default();
    let law = Law::new(Some(&strength), &behaviour, SPRINGS);
    let there = (0..=3000).map(|k| [-1e-5, 1e-6 * f64::from(k), 0.0]);
    let back = (0..=3000).map(|k| [-1e-5, 3e-3 - 1e-6 * f64::from(k), 0.0]);
    let path: Vec<[f64; 3]> = there.chain(back).collect();
    let sheared = shear(&law, &path);
    let t = &sheared.point;
    assert!((t[3000][0] + 2e10 * (1e-5 + 0.2e-3)).abs() < 1.0);
    assert!((t[3000][1] / strength.residual(t[3000][0]) - 1.0).abs() < 1e-12);
    // Back where it began, but for what the shear spring holds.
    let slip = norm(sheared.memory.slip[0], 0.0);
    let expected = -2e10 * (1e-5 + 0.2 * slip);
    assert!(slip < 0.1e-3 && (t[6001][0] / expected - 1.0).abs() < 1e-9);
    assert!(sheared.residual.iter().all(|r| r.abs() < 1e-6), "{:?}", sheared.residual);
    for (t, f) in t.iter().zip(&sheared.face) {
        assert!((t[0] - f[0]).abs() < 1e-6 * 4e6 && (t[1] - f[1]).abs() < 1e-6 * 4e6);
    }
}

/// Each law under reduction: the tractions of the reduced strength, no energy from sliding, and the balance of the whole law.
#[test]
fn reduced_laws_slide_at_their_reduced_strength_and_make_no_energy() {
    let steep = Strength { dilation: 0.45, dilation_end: 1.0, ..strength() };
    let closes = JointModel {
        closure: Closure::Hyperbolic { limit: 1e-3, stiffest: 25.0 },
        ..JointModel::default()
    };
    let laws = [
        (strength(), softening()),
        (steep, softening()),
        (steep, JointModel::default()),
        (steep, closes),
        rough(None),
        rough(Some(1e-3)),
    ];
    for (case, (strength, behaviour)) in laws.into_iter().enumerate() {
        for factor in [1.0, 1.25, 4.0] {
            let (strength, behaviour) = (strength.reduced(factor), behaviour.reduced(factor));
            let law = Law::new(Some(&strength), &behaviour, SPRINGS);
            let sheared = shear(&law, &straight(-1e-4, 4e-3));
            assert!(
                sheared.residual.iter().all(|r| r.abs() < 1e-6),
                "{case} {factor} {:?}",
                sheared.residual
            );
            assert!(sheared.loss.friction >= 0.0, "{case} {factor}");
            let t = sheared.point[20_000];
            let path = sheared.memory.accumulated_slip;
            let bears = law.limit(t[0], law.damage(&sheared.memory, path), path);
            assert!((t[1] / bears - 1.0).abs() < 1e-9, "{case} {factor}");
            // Step by step: what friction takes is at least what dilation lifts against the pressure.
            for pair in sheared.point.windows(2) {
                assert!(pair[1][1] >= 0.0 && pair[1][0] <= pair[0][0] + 1e-6, "{case} {factor}");
            }
            let half = (strength.reduced(2.0), behaviour.reduced(2.0));
            let half = Law::new(Some(&half.0), &half.1, SPRINGS);
            let [one, other] = [law, half].map(|law| law.limit(-5e6, 1.0, 2e-3));
            assert!((one / other - 2.0).abs() < 1e-12, "{case} {factor}");
        }
    }
    // At the dilation angle nothing is lost in sliding, and nothing made.
    let smooth = Strength {
        cohesion: 0.0,
        tension: 0.0,
        friction: 0.1,
        residual_friction: 0.1,
        residual_cohesion: 0.0,
        ..steep
    };
    let plain = JointModel::default();
    let sheared = shear(&Law::new(Some(&smooth), &plain, SPRINGS), &straight(-1e-4, 4e-3));
    let Loss { friction, fracture } = sheared.loss;
    assert!(friction.abs() + fracture.abs() < 1e-6 * 1e4, "{friction} {fracture}");
}

#[test]
fn closure_follows_the_hyperbola_and_stores_its_integral() {
    let closure = Closure::Hyperbolic { limit: 0.136871e-3, stiffest: 25.0 };
    let k = 20.35e9;
    for (v, s) in [(0.05e-3, 1.603139e6), (0.1e-3, 7.554254e6)] {
        assert!((closure.pressure(k, v) / s - 1.0).abs() < 1e-5);
    }
    let mut sum = 0.0;
    let mut before = 0.0;
    for n in 1..=40_000 {
        let v = 0.16e-3 * f64::from(n) / 40_000.0;
        let s = closure.pressure(k, v);
        assert!((closure.closed(k, s) / v - 1.0).abs() < 1e-12);
        assert!(s - before <= 25.0 * k * 0.16e-3 / 40_000.0 * (1.0 + 1e-6));
        sum += 0.5 * (s + before) * 0.16e-3 / 40_000.0;
        before = s;
    }
    assert!((closure.energy(k, 0.16e-3) / sum - 1.0).abs() < 1e-7);
    assert_eq!(Closure::Linear.pressure(k, 1e-3), k * 1e-3);
}

#[test]
fn a_law_without_anything_of_this_is_the_plain_one() {
    use super::super::face_joint;
    let (strength, behaviour) = (strength(), JointModel::default());
    assert!(behaviour.is_plain() && !softening().is_plain());
    let law = Law::new(Some(&strength), &behaviour, SPRINGS);
    let wave = |k: usize, f: f64, a: f64| a * libm::sin(f * k as f64);
    let (mut one, mut other, mut before) = (Memory::default(), Memory::default(), [0.0; 3]);
    let start = [-1e5, 2e4, -3e4];
    for k in 0..4000 {
        let n = if k < 30 { 2e-6 * k as f64 } else { wave(k, 0.013, 4e-5) - 1.2e-5 };
        let at = [n, wave(k, 0.0171, 2.5e-4), wave(k, 0.0093, 1.5e-4)];
        let moved = [0, 1, 2].map(|i| at[i] - before[i]);
        let (t, a) = law.point(&start, &at, &moved, &mut one);
        let (u, b) = face_joint::point(&strength, SPRINGS, &start, &at, &moved, &mut other);
        for i in 0..3 {
            assert!((t[i] - u[i]).abs() < 1e-2, "{k} {t:?} {u:?}");
        }
        assert_eq!((one.broken, one.open, one.sliding), (other.broken, other.open, other.sliding));
        let (a, b) = (a.friction + a.fracture, b.friction + b.fracture);
        // What the rule of the trapezium makes of the step in which it opens is booked here.
        assert!((a - b).abs() < 1e-3 * (1.0 + b.abs()), "{k} {a} {b}");
        before = at;
    }
}

#[test]
fn applied_twice_nothing_changes() {
    for (strength, behaviour) in [(strength(), softening()), rough(Some(1e-3))] {
        let law = Law::new(Some(&strength), &behaviour, SPRINGS);
        let (mut memory, mut before) = (Memory::default(), [-1e-4, 0.0, 0.0]);
        for at in straight(-1e-4, 3e-3).into_iter().step_by(100) {
            let moved = [0, 1, 2].map(|k| at[k] - before[k]);
            let (t, _) = law.point(&[0.0; 3], &at, &moved, &mut memory);
            let mut again = memory;
            let (u, loss) = law.point(&[0.0; 3], &at, &[0.0; 3], &mut again);
            memory.sliding = again.sliding;
            assert_eq!(memory, again);
            for k in 0..3 {
                assert!((t[k] - u[k]).abs() <= 1e-9 * t[0].abs());
            }
            assert!(loss.friction.abs() + loss.fracture.abs() < 1e-9);
            before = at;
        }
    }
}

#[test]
fn turning_the_frame_turns_the_answer() {
    let (strength, behaviour) = rough(Some(1e-3));
    let law = Law::new(Some(&strength), &behaviour, SPRINGS);
    let (mut one, mut turned, mut before) = (Memory::default(), Memory::default(), [0.0; 3]);
    for at in straight(-1e-4, 3e-3) {
        let moved = [0, 1, 2].map(|k| at[k] - before[k]);
        let turn = |v: [f64; 3]| [v[0], 0.6 * v[1], 0.8 * v[1]];
        let (t, _) = law.point(&[0.0; 3], &at, &moved, &mut one);
        let (u, _) = law.point(&[0.0; 3], &turn(at), &turn(moved), &mut turned);
        assert!((t[1] - (0.6 * u[1] + 0.8 * u[2])).abs() < 1e-6 * (1.0 + t[1].abs()));
        before = at;
    }
}
