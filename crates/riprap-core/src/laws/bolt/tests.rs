use super::*;

/// The bar of the numbers: E 200 GPa, d 25 mm, grout 1 GN/m2, 2 m.
const AXIAL: f64 = 200e9 * std::f64::consts::PI * 0.025 * 0.025 / 4.0;
const GROUT: f64 = 1e9;
const LENGTH: f64 = 2.0;
const STRENGTH: f64 = 200e3;

fn bar(length: f64) -> Bar {
    Bar { stiffness: AXIAL / length, yields: f64::INFINITY, hardening: 0.0, breaks: f64::INFINITY }
}

/// A chain whose first node is the head, moved by the first entry of what is apart, and that is grouted from there on. The head is held
/// by half a piece of grout, as nodes at an end are.
fn pulled(pieces: usize, strength: f64) -> Chain {
    let l = LENGTH / pieces as f64;
    let mut holds = vec![Hold::grout(1e9 * AXIAL, f64::INFINITY)];
    let mut bars = vec![bar(0.5 * l)];
    for k in 0..pieces {
        holds.push(Hold::grout(GROUT * l, strength * l));
        if k > 0 {
            bars.push(bar(l));
        }
    }
    Chain::new(holds, bars)
}

fn pull(chain: &mut Chain, work: &mut Factors, u: f64) -> (f64, Losses) {
    let mut apart = vec![0.0; chain.bars.len()];
    apart[0] = u;
    let losses = chain.solve(&apart, work);
    (chain.force[0], losses)
}

#[test]
fn an_elastic_bolt_is_as_stiff_as_its_closed_form() {
    let exact = pull_out_stiffness(GROUT, AXIAL, LENGTH);
    assert!((exact / 313.3267e6 - 1.0).abs() < 1e-6, "{exact}");
    let mut errors = Vec::new();
    for pieces in [20, 40, 80] {
        let mut chain = pulled(pieces, f64::INFINITY);
        let mut work = chain.factors();
        let (force, _) = pull(&mut chain, &mut work, 1e-4);
        errors.push(force / 1e-4 / exact - 1.0);
        // Force along the bolt, in the middle of a bar.
        let lambda = (GROUT / AXIAL).sqrt();
        let l = LENGTH / pieces as f64;
        for (x, share) in [(0.5, 0.202739), (1.0, 0.041039), (1.5, 0.007992)] {
            let k = (x / l).round() as usize;
            let n = chain.force[k] / force;
            let closed = libm::sinh(lambda * (LENGTH - x)) / libm::sinh(lambda * LENGTH);
            assert!((closed - share).abs() < 1e-6);
            assert!((n / share - 1.0).abs() < 0.5 * l, "{pieces} {x} {n}");
        }
    }
    // Second order, 1 % at 5 cm.
    assert!(errors[1].abs() < 0.01, "{errors:?}");
    assert!((errors[0] / errors[1] - 4.0).abs() < 0.2, "{errors:?}");
    assert!((errors[1] / errors[2] - 4.0).abs() < 0.2, "{errors:?}");
}

#[test]
fn slipping_grout_follows_the_closed_form_in_one_jump_and_unloads_by_masing() {
    let loads = [
        (0.5, 162.6570e3, 0.773757e-3),
        (1.0, 262.4543e3, 1.854746e-3),
        (1.5, 357.7169e3, 3.373681e-3),
    ];
    for (slipping, force, motion) in loads {
        let (f, u) = pull_out_load(GROUT, AXIAL, STRENGTH, LENGTH, slipping);
        assert!((f / force - 1.0).abs() < 1e-6 && (u / motion - 1.0).abs() < 1e-6);
        let mut chain = pulled(40, STRENGTH);
        let mut work = chain.factors();
        let (found, losses) = pull(&mut chain, &mut work, motion);
        assert!((found / force - 1.0).abs() < 1e-3, "{found} {force}");
        assert_eq!(losses.left, 0.0);
    }
    let mut chain = pulled(40, STRENGTH);
    let mut work = chain.factors();
    pull(&mut chain, &mut work, 1.854746e-3);
    let unloaded = [(0.4e-3, 137.1236e3), (0.8e-3, 45.3757e3), (1.2e-3, -17.7915e3)];
    for (back, force) in unloaded {
        let (found, _) = pull(&mut chain, &mut work, 1.854746e-3 - back);
        assert!((found - force).abs() < 1.5e-3 * 262e3, "{found} {force}");
    }
    // All of the grout, at last.
    let (found, losses) = pull(&mut chain, &mut work, 0.05);
    assert!((found / 400e3 - 1.0).abs() < 1e-9, "{found}");
    assert_eq!(losses.left, 0.0);
}

#[test]
fn what_is_put_in_is_stored_or_lost() {
    let mut chain = pulled(40, STRENGTH);
    chain.bars.iter_mut().for_each(|b| b.yields = 250e3);
    let mut work = chain.factors();
    let (mut put, mut lost, mut last) = (0.0, 0.0, 0.0);
    let steps = 400;
    for k in 1..=steps {
        // There and back again.
        let u = 3e-3 * (std::f64::consts::PI * f64::from(k) / f64::from(steps)).sin();
        let before = 3e-3 * (std::f64::consts::PI * f64::from(k - 1) / f64::from(steps)).sin();
        let (force, losses) = pull(&mut chain, &mut work, u);
        put += 0.5 * (force + last) * (u - before);
        lost += losses.all();
        last = force;
        assert_eq!(losses.left, 0.0);
    }
    let residual = put - lost - chain.stored();
    assert!(residual.abs() < 1e-3 * lost, "{residual} {lost}");
    assert!(lost > 100.0);
}

/// Two blocks with 2 m of bolt on each side: the joint between them opens.
fn crossing(piece: f64) -> (Chain, usize) {
    let n = (LENGTH / piece).round() as usize;
    let holds = vec![Hold::grout(GROUT * piece, STRENGTH * piece); 2 * n];
    (Chain::new(holds, vec![bar(piece); 2 * n - 1]), n - 1)
}

#[test]
fn a_joint_opens_against_a_bolt_as_the_closed_form_says() {
    let exact = 156.6634e6;
    for (piece, error) in [(0.1, -1.25e-2), (0.05, -3.17e-3), (0.025, -7.9e-4)] {
        let (mut chain, joint) = crossing(piece);
        let mut work = chain.factors();
        let mut apart = vec![0.0; chain.bars.len()];
        apart[joint] = 1e-5;
        chain.solve(&apart, &mut work);
        let stiffness = chain.force[joint] / 1e-5;
        assert!(
            (stiffness / exact - 1.0 - error).abs() < 0.02 * error.abs(),
            "{piece} {stiffness}"
        );
        // The elastic forces are those of the equilibrium.
        let mut forces = vec![0.0; chain.bars.len()];
        work.elastic_forces(&chain, &apart, &mut forces);
        for (a, b) in forces.iter().zip(&chain.force) {
            assert!((a - b).abs() < 1e-9 * chain.force[joint]);
        }
    }
}

#[test]
fn a_bar_breaks_at_its_elongation_and_what_it_held_is_booked() {
    let (mut chain, joint) = crossing(0.05);
    for bar in &mut chain.bars {
        bar.yields = 250e3;
        bar.breaks = 5e-3;
    }
    let mut work = chain.factors();
    let mut apart = vec![0.0; chain.bars.len()];
    let (mut put, mut lost, mut last) = (0.0, Losses::default(), 0.0);
    let steps = 2000;
    let mut broken_at = None;
    for k in 1..=steps {
        apart[joint] = 10e-3 * f64::from(k) / f64::from(steps);
        let losses = chain.solve(&apart, &mut work);
        // The bar yields at its limit until it breaks.
        let force = if losses.breaks > 0 {
            broken_at = Some(apart[joint]);
            last
        } else {
            chain.force[joint]
        };
        put += 0.5 * (force + last) * 10e-3 / f64::from(steps);
        last = chain.force[joint];
        assert_eq!(losses.left, 0.0);
        lost.add(&losses);
    }
    assert_eq!(lost.breaks, 1);
    assert!(broken_at.is_some_and(|u| (8e-3..9e-3).contains(&u)), "{broken_at:?}");
    assert_eq!(chain.force[joint], 0.0);
    // Slipped grout keeps part of the bar stretched.
    assert!(chain.stored() > 10.0 && lost.ruptured > 100.0);
    let residual = put - lost.all() - chain.stored();
    assert!(residual.abs() < 2e-3 * put, "{residual} {put}");
}

/// When the node between them goes, two bars at 0.6 of their rupture are none at 1.2, and a place that was compressed saves no other one.
#[test]
fn a_joined_bar_breaks_when_what_is_left_of_its_worst_part_is_used_up() {
    let rigid = || Hold::grout(1e9 * AXIAL, f64::INFINITY);
    let half = Bar { yields: 250e3, breaks: 5e-3, ..bar(0.5) };
    for plastic in [[3e-3, 3e-3], [3e-3, -3e-3], [0.0, 3e-3]] {
        let mut chain = Chain::new(vec![rigid(), rigid(), rigid()], vec![half; 2]);
        chain.plastic = plastic.to_vec();
        chain.yielded = plastic.map(f64::abs).to_vec();
        let mut chain = chain.keep(&[true, false, true]).chain;
        let mut work = chain.factors();
        // Plastic elongation begins beyond this one.
        let start = plastic[0] + plastic[1] + 250e3 / chain.bars[0].stiffness;
        for (more, breaks) in [(-1e-3, 0), (1.99e-3, 0), (2.01e-3, 1)] {
            let losses = chain.solve(&[start + more], &mut work);
            assert_eq!(losses.breaks, breaks, "{plastic:?} {more}");
        }
    }
    // Bars that are not joined keep their own to the bit.
    let mut chain = Chain::new(vec![rigid(), rigid(), rigid()], vec![half; 2]);
    chain.plastic = vec![1e-3 / 3.0; 2];
    let kept = chain.keep(&[true, true, false]).chain;
    assert_eq!(kept.bars, [half]);
}

#[test]
fn a_stretched_bolt_carries_its_force_exactly_and_its_plate_lifts() {
    // 5 m free, then 2 m of grout.
    let piece = 0.05;
    let mut holds = vec![Hold::plate(1e3 * AXIAL / 5.0, f64::INFINITY)];
    holds.extend(vec![Hold::grout(GROUT * piece, STRENGTH * piece); 40]);
    let mut bars = vec![bar(5.0 + 0.5 * piece)];
    bars.extend(vec![bar(piece); 39]);
    let mut chain = Chain::new(holds, bars);
    let mut work = chain.factors();
    chain.stretch(150e3, &mut work);
    assert!((chain.force[0] / 150e3 - 1.0).abs() < 1e-9, "{}", chain.force[0]);
    let still = vec![0.0; chain.bars.len()];
    chain.solve(&still, &mut work);
    assert!((chain.force[0] / 150e3 - 1.0).abs() < 1e-9, "{}", chain.force[0]);
    assert!((chain.held(0) / 150e3 - 1.0).abs() < 1e-9);
    // Evaluated again, it stays where it is.
    let before = chain.clone();
    chain.solve(&still, &mut work);
    assert_eq!(chain.slip, before.slip);
    // The rock under the plate gives way: the plate lifts and comes back as it was.
    let mut closer = still.clone();
    closer[0] = -0.02;
    chain.solve(&closer, &mut work);
    assert!(chain.force[0].abs() < 1e-6 && chain.held(0) == 0.0);
    chain.solve(&still, &mut work);
    assert!(chain.force[0] > 100e3);
}

#[test]
fn a_dowel_holds_up_to_its_limit_in_any_direction() {
    let (force, slip) = dowel(1e8, 1e5, [6e-4, 0.0], [0.0; 2]);
    assert!((force[0] / 6e4 - 1.0).abs() < 1e-12 && force[1] == 0.0);
    assert_eq!(slip, [0.0; 2]);
    let (force, slip) = dowel(1e8, 1e5, [3e-3, 4e-3], [0.0; 2]);
    assert!((force[0] / 6e4 - 1.0).abs() < 1e-12 && (force[1] / 8e4 - 1.0).abs() < 1e-12);
    assert!((slip[0] / (3e-3 - 6e-4) - 1.0).abs() < 1e-12);
    // Parting along the bolt is none of its business, and with its bar it loses what it holds.
    let held = Sheared { slip: [0.0; 2], force: [6e4, 0.0] };
    let (now, lost) = held.after([1e8, 1e5], false, [0.0, 1.0], [3e-3, 7.0]);
    assert!((now.force[0] / 1e5 - 1.0).abs() < 1e-12 && now.force[1] == 0.0);
    assert!((lost / (1e5 * 2e-3) - 1.0).abs() < 1e-12);
    let (now, lost) = held.after([1e8, 1e5], true, [0.0, 1.0], [6e-4, 0.0]);
    assert!(now.force == [0.0; 2] && (lost / 18.0 - 1.0).abs() < 1e-12);
    assert!((dowel_limit(0.025, 500e6, 50e6) / 66.21e3 - 1.0).abs() < 1e-3);
    let k = dowel_stiffness(20e9, 200e9, 0.025, 0.040);
    assert!((5e7..5e8).contains(&k), "{k}");
}

#[test]
fn a_chord_tells_how_much_longer_it_is_where_its_lengths_no_longer_do() {
    let (now, longer) = chord(3.0, 1e-17, |a: f64, b: f64| a * b);
    assert_eq!(now, 3.0);
    assert!((longer / 1e-17 - 1.0).abs() < 1e-15);
}

#[test]
fn dowels_store_with_the_chain_and_no_bolt_has_no_largest_number() {
    let squares = [4.0, 8.0];
    let stored = |dowel| Chain::default().stored_with(dowel, squares.into_iter());
    assert_eq!(stored(Some([2.0, 9.0])), 3.0);
    assert_eq!(stored(None), 0.0);
    assert!(largest(std::iter::empty(), 0.0).is_nan());
    assert_eq!(largest([-2.0, -1.0].into_iter(), f64::NEG_INFINITY), -1.0);
    assert_eq!(largest([-2.0, -1.0].into_iter(), 0.0), 0.0);
}
