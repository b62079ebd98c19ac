use super::*;
use crate::dynamics::Formula;
use crate::plan::Gauge;

fn check(window: Window, expected: Expected) -> Check {
    Check {
        name: "c".to_owned(),
        gauge: Gauge { field: "block.displacement.x".to_owned(), of: vec![0], ..Gauge::default() },
        unit: "m".to_owned(),
        shown: None,
        window,
        expected,
        relative: None,
        absolute: Some(1e-9),
        known: None,
    }
}

/// Feeds x(t) = 10 t^2 at 0, 0.1, … 1.
fn fed(window: Window, expected: Expected) -> CheckResult {
    let mut watch = Watch::new(check(window, expected));
    for i in 0..=10 {
        let t = f64::from(i) * 0.1;
        if watch.wants(t) {
            watch.observe(t, 10.0 * t * t);
        }
    }
    watch.finish("s.toml", "", false)
}

fn over(reduce: Reduce) -> Window {
    Window::Over { from: 0.2, to: 0.8, reduce }
}

#[test]
fn moments_are_found_and_interpolated() {
    for (window, value) in [
        (Window::Start, 0.0),
        (Window::End, 10.0),
        (Window::At(0.5), 2.5),
        (Window::At(0.55), 0.5 * (2.5 + 3.6)),
        (over(Reduce::Max), 6.4),
        (over(Reduce::Min), 0.4),
        (over(Reduce::Range), 6.0),
        (over(Reduce::FirstAbove(3.0)), 0.6),
        (over(Reduce::FirstBelow(1.0)), 0.2),
        // Trapezoids on x^4: mean of 100 t^4 over 0.2 to 0.8, as summed.
        (over(Reduce::Rms), root_mean_square()),
        // Trapezoids on x^2: exact mean 2.8 plus h^2/12 (f'(b) - f'(a))/(b - a) = 1/60.
        (over(Reduce::Mean), 2.8 + 1.0 / 60.0),
        (over(Reduce::ShareAbove(3.0)), 0.3 / 0.6),
    ] {
        let result = fed(window, Expected::Value(value));
        assert_eq!(result.status, Status::Passed, "{window:?} {result:?}");
    }
}

/// Root of the mean of (10 t^2)^2 at 0.2, 0.3, ... 0.8 by trapezoids.
fn root_mean_square() -> f64 {
    let squares: Vec<f64> = (2..=8).map(|i| 0.01 * f64::from(i * i * i * i)).collect();
    let ends = 0.5 * (squares[0] + squares[6]);
    ((ends + squares[1..6].iter().sum::<f64>()) / 6.0).sqrt()
}

#[test]
fn words_are_in_the_unit_of_the_scene() {
    let words = |unit: &str, given: Option<(&str, f64)>, expected, relative, value| {
        let mut one = check(Window::End, expected);
        unit.clone_into(&mut one.unit);
        (one.absolute, one.relative) = (None, relative);
        one.shown = given.map(|(unit, one)| Shown { unit: unit.to_owned(), one });
        let mut watch = Watch::new(one);
        watch.observe(1.0, value);
        watch.finish("", "", false).words
    };
    let deg = std::f64::consts::PI / 180.0;
    let said = words("rad", Some(("deg", deg)), Expected::Value(2.0 * deg), Some(0.01), 2.01 * deg);
    assert_eq!(said, "2.01 deg, expected 2 deg (0.01 relative)");
    let said = words("rad", None, Expected::Value(2.0 * deg), Some(1e-6), 2.0 * deg);
    assert_eq!(said, "2 deg, expected 2 deg (1e-6 relative)");
    let said = words("Pa", None, Expected::Between(1.0e6, 2.5e6), None, 1.234_567e6);
    assert_eq!(said, "1.2346 MPa, expected 1 to 2.5 MPa");
    let band = Expected::Between(f64::NEG_INFINITY, 300.0);
    let said = words("N", Some(("kN", 1e3)), band, None, 250.0);
    assert_eq!(said, "0.25 kN, expected at most 0.3 kN");
}

#[test]
fn a_reading_that_never_came_fails_with_its_reason() {
    let result = fed(Window::At(2.0), Expected::Value(0.0));
    assert_eq!((result.status, result.measured), (Status::Failed, None));
    assert!(result.note.contains("ended at 1 s, before 2 s"), "{}", result.note);
    let result = fed(over(Reduce::FirstAbove(99.0)), Expected::Value(0.0));
    assert!(result.note.contains("never rose above 99"), "{}", result.note);
    let late = Window::Over { from: 3.0, to: 4.0, reduce: Reduce::Max };
    assert_eq!(fed(late, Expected::Value(0.0)).status, Status::Failed);
}

#[test]
fn what_is_not_a_number_never_agrees() {
    for window in [Window::End, over(Reduce::Max), over(Reduce::Min), over(Reduce::Mean)] {
        let mut watch = Watch::new(check(window, Expected::Between(-1e300, 1e300)));
        for (t, v) in [(0.2, 0.0), (0.3, f64::NAN), (0.4, 1.0), (0.8, f64::NAN)] {
            watch.observe(t, v);
        }
        assert_eq!(watch.finish("", "", false).status, Status::Failed, "{window:?}");
    }
}

#[test]
fn what_is_infinite_agrees_with_nothing_but_an_open_bound() {
    let result = |expected: Expected, relative, value: f64| {
        let mut one = check(Window::End, expected);
        (one.relative, one.absolute) = (relative, Some(1.0));
        let mut watch = Watch::new(one);
        watch.observe(0.5, value);
        watch.finish("", "", false)
    };
    let formula = |text: &str| Expected::Formula {
        formula: Formula::new(text, &["t"]).unwrap(),
        names: Vec::new(),
    };
    // The share of an infinite value was infinite too, and every difference within it.
    let said = result(formula("exp(1000)"), Some(1e-6), 2.0);
    assert_eq!(said.status, Status::Failed, "{said:?}");
    assert!(said.note.contains("`exp(1000)` gives inf at t = 0.5 s"), "{}", said.note);
    let said = result(formula("sqrt(t - 1)"), Some(1e-6), 2.0);
    assert!(said.note.contains("gives NaN"), "{}", said.note);
    let said = result(Expected::Value(1.0), Some(1e-6), f64::INFINITY);
    assert_eq!(said.status, Status::Failed, "{said:?}");
    assert!(said.note.contains("the result is not finite"), "{}", said.note);
    let open = Expected::Between(1.0, f64::INFINITY);
    let said = result(open.clone(), None, f64::INFINITY);
    assert_eq!((said.status, &said.note[..]), (Status::Passed, ""));
    let said = result(open, None, f64::NAN);
    assert_eq!(said.status, Status::Failed, "{said:?}");
    assert!(said.note.contains("NaN"), "{}", said.note);
}

#[test]
fn tables_formulas_and_bands() {
    let formula = Formula::new("0.5*g*t^2", &["t", "g"]).unwrap();
    let names = vec![("g".to_owned(), 20.0)];
    let expected = Expected::Formula { formula, names };
    assert_eq!(fed(Window::At(0.5), expected).status, Status::Passed);
    let table = Expected::Table { t: vec![0.0, 1.0], v: vec![0.0, 5.0] };
    assert_eq!(fed(Window::At(0.5), table).status, Status::Passed);
    assert_eq!(fed(Window::End, Expected::Between(9.0, 11.0)).status, Status::Passed);
    assert_eq!(fed(Window::End, Expected::Between(9.0, 9.5)).status, Status::Failed);
    assert!(interpolate(&[], &[], 1.0).is_nan());
    assert_eq!(interpolate(&[0.0, 1.0], &[2.0, 3.0], 9.0), 3.0);
    assert_eq!(interpolate(&[0.0, 1.0], &[2.0, 3.0], -9.0), 2.0);
}

#[test]
fn a_verdict_says_how_often_a_costly_field_was_read() {
    let words = |next| {
        let mut watch = Watch::new(check(over(Reduce::Max), Expected::Value(1.0)));
        watch.observe(0.5, 1.0);
        watch.next = next;
        watch.finish("", "", false).words
    };
    assert!(words(0.5 + 2e-3).ends_with("; read every 2 ms"), "{}", words(0.502));
    assert!(!words(0.5).contains("read every"), "{}", words(0.5));
}

#[test]
fn relative_or_absolute_is_enough() {
    let mut one = check(Window::End, Expected::Value(9.95));
    one.absolute = None;
    one.relative = Some(0.01);
    let mut watch = Watch::new(one.clone());
    watch.observe(1.0, 10.0);
    assert_eq!(watch.finish("", "", false).status, Status::Passed);
    one.relative = Some(0.001);
    one.absolute = Some(0.1);
    let mut watch = Watch::new(one);
    watch.observe(1.0, 10.0);
    assert_eq!(watch.finish("", "", false).status, Status::Passed);
}

#[test]
fn known_failures_are_skipped_and_unexpected_passes_fail() {
    let result = |expected: f64, strict| {
        let mut one = check(Window::End, Expected::Value(expected));
        one.known = Some("no reason at all".to_owned());
        let mut watch = Watch::new(one);
        watch.observe(1.0, 10.0);
        watch.finish("", "", strict)
    };
    assert_eq!(result(9.0, false).status, Status::Skipped);
    assert_eq!(result(9.0, true).status, Status::Failed);
    let surprise = result(10.0, false);
    assert_eq!(surprise.status, Status::Failed);
    assert!(surprise.note.contains("marked as a known failure"), "{}", surprise.note);
}
