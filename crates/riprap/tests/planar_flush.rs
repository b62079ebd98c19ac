//! Blocks whose sides lie on one line, in any orientation: round-off decides there which corner is inside.
//!
//! **Band of the source's law on a flat contact of length `L` and depth `d`.** Each of the two pressed faces
//! carries `pn` times the area under its potential. That is a triangle of height `d` if both its ends
//! are crossings (`pn L d / 2`) and at most a rectangle if both are inside corners (`pn L d`); at each end of the
//! contact the corner of one face only can be inside. So the sum is `1.5 pn L d` between bricks, and no less than
//! `1.0 pn L d` where round-off decides about corners of other shapes; the distance potential has `kn L d`.

use crate::common::{DISTANCE, Model, Random, SOURCE, general, law, moved, points, rectangle};
use riprap::Vec2;
use riprap::planar::setup::NormalLaw;

const KN: f64 = 1e10;

/// Upper and lower outline, both with the face y = 0, and where the contact begins and ends on it.
struct Case {
    name: &'static str,
    upper: Vec<Vec2>,
    lower: Vec<Vec2>,
    face: [f64; 2],
}

impl Case {
    fn length(&self) -> f64 {
        self.face[1] - self.face[0]
    }
}

/// Bricks of equal and unequal length, with none, one or both ends flush.
fn bricks() -> Vec<Case> {
    let lower = rectangle(0.0, -1.0, 1.0, 0.0);
    let case = |name, upper, face| Case { name, upper, lower: lower.clone(), face };
    vec![
        case("equal", rectangle(0.0, 0.0, 1.0, 1.0), [0.0, 1.0]),
        case("short in the middle", rectangle(0.25, 0.0, 0.75, 1.0), [0.25, 0.75]),
        case("short at the left end", rectangle(0.0, 0.0, 0.5, 1.0), [0.0, 0.5]),
        case("short at the right end", rectangle(0.5, 0.0, 1.0, 1.0), [0.5, 1.0]),
        case("staggered", rectangle(0.5, 0.0, 1.5, 1.0), [0.5, 1.0]),
        case(
            "concave on its own width",
            points(&[
                (0.0, 0.0),
                (1.0, 0.0),
                (1.0, 1.0),
                (0.7, 1.0),
                (0.7, 0.5),
                (0.3, 0.5),
                (0.3, 1.0),
                (0.0, 1.0),
            ]),
            [0.0, 1.0],
        ),
        Case {
            name: "slender",
            upper: rectangle(0.0, 0.0, 0.1, 3.0),
            lower: rectangle(0.0, -3.0, 0.1, 0.0),
            face: [0.0, 0.1],
        },
    ]
}

/// Corner on corner without sides on one line, and sides on one line that lean.
fn others() -> Vec<Case> {
    let hexagon = (0..6)
        .map(|k| {
            let angle = (f64::from(k) - 2.0) * std::f64::consts::FRAC_PI_3;
            Vec2::new(0.5 + libm::cos(angle), libm::sin(angle) + 0.75f64.sqrt())
        })
        .collect();
    vec![
        Case {
            name: "on a trapezium",
            upper: rectangle(0.0, 0.0, 1.0, 1.0),
            lower: points(&[(-0.5, -1.0), (1.5, -1.0), (1.0, 0.0), (0.0, 0.0)]),
            face: [0.0, 1.0],
        },
        Case {
            name: "hexagon",
            upper: hexagon,
            lower: rectangle(0.0, -1.0, 1.0, 0.0),
            face: [0.0, 1.0],
        },
        Case {
            name: "leaning",
            upper: points(&[(0.0, 0.0), (1.0, 0.0), (0.5, 1.0), (-0.5, 1.0)]),
            lower: points(&[(0.5, -1.0), (1.5, -1.0), (1.0, 0.0), (0.0, 0.0)]),
            face: [0.0, 1.0],
        },
    ]
}

/// Force on the upper block along and across the face, where it acts on the face (over its length, from
/// the middle), and the number of contacts.
struct Pressed {
    across: f64,
    along: f64,
    centre: f64,
    contacts: usize,
}

/// The upper block sunk by `depth`, turned by `tilt` about the place `pivot` of the face and moved by `slip` along
/// it; then both blocks turned by `angle`.
fn press(case: &Case, normal: NormalLaw, pose: [f64; 4], angle: f64) -> Pressed {
    let [depth, tilt, pivot, slip] = pose;
    let upper = moved(&case.upper, 0.0, Vec2::new(-pivot, 0.0));
    let upper = moved(&upper, tilt, Vec2::new(pivot + slip, -depth));
    let upper = moved(&upper, angle, Vec2::ZERO);
    let lower = moved(&case.lower, angle, Vec2::ZERO);
    // The road for any polygons for both laws.
    let model = Model::pair(&upper, &lower, general(law(normal, KN)));
    let wrench = model.wrench();
    let force = crate::common::turned(wrench.force, -angle);
    let middle = 0.5 * (case.face[0] + case.face[1]);
    let arm = model.world.bodies[0].position - crate::common::turned(Vec2::new(middle, 0.0), angle);
    Pressed {
        across: force.y,
        along: force.x,
        centre: (wrench.moment_i + arm.perp_dot(wrench.force)) / (force.y * case.length()),
        contacts: model.view().contacts().count(),
    }
}

/// What is wrong with a pair in a flat contact, if anything.
fn fault(case: &Case, normal: NormalLaw, depth: f64, angle: f64) -> Option<String> {
    let p = press(case, normal, [depth, 0.0, 0.0, 0.0], angle);
    let (l, d) = (case.length(), depth);
    if depth == 0.0 {
        // Corners of blocks of 3 m at most are placed within 1e-15 m.
        let off = p.across.abs().max(p.along.abs()) > KN * l * 5e-15;
        return off.then(|| format!("touches with {} N/m", p.across));
    }
    let ratio = p.across / (KN * l * d);
    // The distance potential lacks `d/2` of the length at each free or flush end.
    let ends = 1.5 * d / l;
    let (band, off_centre) = match normal {
        NormalLaw::DistancePotential => ([1.0, 1.0], 0.0),
        // One end on an own crossing, the other on none: (5/12 - 1/2) L at most.
        NormalLaw::PenetrationPotential => ([1.0, 1.5], 1.0 / 12.0),
    };
    // Round-off of the place over the depth.
    let noise = 4e-15 / d;
    let inside = ratio >= band[0] - ends - noise && ratio <= band[1] + ends + noise;
    let wrong = if !inside {
        format!("{ratio} kn L d")
    } else if p.centre.abs() > off_centre + ends + noise {
        format!("acts {} L off the middle", p.centre)
    } else if p.along.abs() > KN * (1.01 * d * d + l * 4e-15) {
        format!("{} N/m along the face", p.along)
    } else if p.contacts != 1 {
        format!("{} contacts", p.contacts)
    } else {
        return None;
    };
    Some(wrong)
}

#[test]
fn flat_contact_is_one_contact_with_the_force_of_its_law_in_any_orientation() {
    // The distance potential sees the regions alone: fewer orientations tell.
    for (normal, stride) in [(DISTANCE, 10), (SOURCE, 1)] {
        for case in bricks().iter().chain(&others()) {
            for depth in [0.0, 1e-8, 1e-6, 1e-3] {
                let faults: Vec<String> = (0..900)
                    .step_by(stride)
                    .filter_map(|k| {
                        let angle = (0.1 * f64::from(k)).to_radians();
                        fault(case, normal, depth, angle)
                            .map(|what| format!("{:.1} deg: {what}", 0.1 * f64::from(k)))
                    })
                    .collect();
                assert!(
                    faults.is_empty(),
                    "{} under {normal:?}, {} {depth} m deep, as {}",
                    faults.len(),
                    case.name,
                    faults[0]
                );
            }
        }
    }
}

/// A number of either sign, its magnitude spread evenly over 13 decades below `top`, or 0.
fn any_size(random: &mut Random, top: f64) -> f64 {
    let size = top * libm::pow(10.0, random.between(-13.0, 0.0));
    [0.0, size, -size][random.between(0.0, 3.0) as usize]
}

#[test]
fn nearly_flush_bricks_press_between_one_and_one_and_a_half_times_the_distance_law() {
    let mut random = Random(11);
    for case in bricks() {
        for depth in [1e-8, 1e-6, 1e-4] {
            for _ in 0..400 {
                // Up to a wedge that covers half of the face.
                let tilt = any_size(&mut random, 1.9 * depth / case.length());
                let slip = any_size(&mut random, 1e-3 * case.length());
                let pivot = [case.face[0], case.face[1]][random.between(0.0, 2.0) as usize];
                let angle = random.between(-3.1, 3.1);
                let pose = [depth, tilt, pivot, slip];
                let source = press(&case, SOURCE, pose, angle);
                let distance = press(&case, DISTANCE, pose, angle);
                let ratio = source.across / distance.across;
                let slack = 1e-2 + 4e-15 / depth;
                assert!(
                    ratio >= 1.0 - slack && ratio <= 1.5 + slack,
                    "{}: {ratio} at {pose:?}, {angle}",
                    case.name
                );
                assert_eq!(source.contacts, 1, "{} at {pose:?}, {angle}", case.name);
            }
        }
    }
}

/// Forces at the left and right end of a face of 1 m that together are the pressure of equal bricks, over `KN` and a depth of 1 um;
/// the upper one is `left` and `right` deep at its ends (um) and slipped.
fn at_ends(left: f64, right: f64, slip: f64, angle: f64) -> [f64; 2] {
    let [depth, tilt] = [0.5e-6 * (left + right), 1e-6 * (left - right)];
    let p = press(&bricks()[0], SOURCE, [depth, tilt, 0.5, slip], angle);
    let force = p.across / (KN * 1e-6);
    [force * (0.5 - p.centre), force * (0.5 + p.centre)]
}

#[test]
fn faces_have_one_symmetric_stiffness_whichever_ends_have_passed() {
    // A trapezium on one face, the depth of its middle as a triangle on the other. Depths at the ends at which the
    // forces there are linear in them: 11/24 of the own one, 7/24 of the other.
    for slip in [-1e-3, -1e-6, -1e-9, 0.0, 1e-9, 1e-6, 1e-3] {
        for (left, right) in [(1.0, 1.0), (1.0, 0.5), (0.5, 1.0), (1.0, 0.01), (0.01, 1.0)] {
            for angle in [0.0, -0.7, 2.0] {
                let own = at_ends(left, right, slip, angle);
                let due = [11.0 * left + 7.0 * right, 7.0 * left + 11.0 * right].map(|f| f / 24.0);
                for (f, due) in own.into_iter().zip(due) {
                    let what =
                        format!("{left} and {right} um, slip {slip} m, {angle}: {f} for {due}");
                    assert!((f - due).abs() < 5e-3, "{what}");
                }
            }
        }
    }
}

#[test]
fn an_end_that_lifts_off_changes_no_force_at_once() {
    for slip in [-1e-3, -1e-6, 0.0, 1e-6, 1e-3] {
        for lifted in [[false, true], [true, false]] {
            let pose = |away: f64| {
                let [left, right] = lifted.map(|up| if up { -away } else { 1.0 });
                at_ends(left, right, slip, 0.3)
            };
            let (before, after) = (pose(-1e-3), pose(1e-3));
            for (b, a) in before.into_iter().zip(after) {
                assert!((b - a).abs() < 5e-3, "slip {slip}, {lifted:?}: {b} then {a}");
            }
        }
    }
}

#[test]
fn the_order_of_flush_blocks_does_not_matter() {
    for case in bricks().iter().chain(&others()) {
        for depth in [1e-6, 1e-3] {
            let upper = moved(&case.upper, 0.3, Vec2::new(0.0, -depth));
            let lower = moved(&case.lower, 0.3, Vec2::ZERO);
            let (a, b) = (
                Model::pair(&upper, &lower, law(SOURCE, KN)).wrench(),
                Model::pair(&lower, &upper, law(SOURCE, KN)).wrench(),
            );
            let off = (a.force + b.force).length();
            assert!(off <= 1e-9 * a.force.length(), "{}: {a:?} {b:?}", case.name);
            assert!(
                (a.moment_i - b.moment_j).abs() <= 1e-9 * a.force.length(),
                "{}: {a:?} {b:?}",
                case.name
            );
        }
    }
}

#[test]
fn an_overlap_at_the_start_gives_back_what_it_is_said_to_hold() {
    // Most of a brick, 1 mm deep: `1.5 kn L d` on either boundary together, `0.75 kn L d²` in all.
    let (l, d) = (0.9, 1e-3);
    let upper = rectangle(0.1, -d, 1.1, 1.0);
    let lower = rectangle(0.0, -1.0, 1.0, 0.0);
    let mut model = Model::pair(&upper, &lower, law(SOURCE, KN));
    let start = model.balance().total();
    assert!((start / (0.75 * KN * l * d * d) - 1.0).abs() < 2e-3, "{start}");
    model.run(1e-6, 3000);
    let balance = model.balance();
    assert_eq!(model.view().contacts().count(), 0);
    assert!((balance.kinetic / start - 1.0).abs() < 1e-2, "{} of {start}", balance.kinetic);
    // The half kick at the start, `m dv²/2` of it, is not booked here.
    let residual = balance.residual_relative();
    assert!(residual.abs() < 1e-5, "{residual}");
}
