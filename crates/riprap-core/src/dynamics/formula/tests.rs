use super::*;

fn value(text: &str, x: f64) -> f64 {
    Formula::new(text, &["x", "e"]).unwrap_or_else(|e| panic!("{text}: {e}")).value(&[("x", x)])
}

#[test]
fn evaluates_the_sliding_distance() {
    let formula =
        Formula::new("0.5*g*(sin(35*deg)-cos(35*deg)*tan(phi))*t^2", &["g", "phi", "t"]).unwrap();
    let phi = 15.0_f64.to_radians();
    let d = formula.value(&[("g", 10.0), ("phi", phi), ("t", 1.5)]);
    assert!((d - 3.983_460).abs() < 1e-6, "{d}");
}

#[test]
fn numbers_may_have_exponents() {
    for (text, value) in [
        ("4e-3", 0.004),
        ("2*1.5E2+1", 301.0),
        ("x1e*2", 10.0),
        ("1e300*1e-300", 1.0),
        (".5 + 1.", 1.5),
    ] {
        let formula = Formula::new(text, &["x1e"]).unwrap();
        assert!((formula.value(&[("x1e", 5.0)]) - value).abs() < 1e-12, "{text}");
    }
}

/// Runs with a check against a formula of other names than `t` could not be resumed.
#[test]
fn a_formula_is_read_back_with_all_its_names() {
    let formula = Formula::new("g*t^2/2 + sin(a*deg)", &["t", "g", "a"]).unwrap();
    let bytes = postcard::to_stdvec(&formula).unwrap();
    let again: Formula = postcard::from_bytes(&bytes).unwrap();
    let values = [("t", 2.0), ("g", 10.0), ("a", 30.0)];
    assert_eq!(again.value(&values), formula.value(&values));
    assert!((again.value(&values) - 20.5).abs() < 1e-12);
    assert!(postcard::from_bytes::<Formula>(&[3, b'2', b'*', b'(']).is_err());
}

#[test]
fn functions_are_those_of_libm() {
    for (text, expected) in [
        ("sin(x)", libm::sin(0.37)),
        ("log(x)", libm::log(0.37)),
        ("2*x^1.5", 2.0 * libm::pow(0.37, 1.5)),
        ("atan2(x, 2)", libm::atan2(0.37, 2.0)),
    ] {
        assert_eq!(value(text, 0.37).to_bits(), expected.to_bits(), "{text}");
    }
}

/// The order that earlier versions had: results keep their bits.
#[test]
fn quotients_and_differences_bind_tighter() {
    let (a, b, c) = (0.1, 0.7, 0.3);
    let formula = |text: &str| {
        let formula = Formula::new(text, &["a", "b", "c"]).unwrap();
        formula.value(&[("a", a), ("b", b), ("c", c)]).to_bits()
    };
    assert_eq!(formula("a*b/c"), (a * (b / c)).to_bits());
    assert_eq!(formula("a/b*c"), (a / b * c).to_bits());
    assert_eq!(formula("a+b-c"), (a + (b - c)).to_bits());
    assert_eq!(formula("a-b+c-a"), ((a - b) + (c - a)).to_bits());
    assert_eq!(formula("a-b-c"), (a - b - c).to_bits());
    assert_eq!(formula("a/b/c"), (a / b / c).to_bits());
    assert_eq!(formula("-a*b+c"), (-a * b + c).to_bits());
}

/// `exp(-t^2)` was exp(t²).
#[test]
fn a_sign_binds_looser_than_a_power() {
    assert_eq!(value("-x^2", 3.0), -9.0);
    assert_eq!(value("2*-x^2", 3.0), -18.0);
    assert_eq!(value("(-x)^2", 3.0), 9.0);
    assert_eq!(value("2^-1", 0.0), 0.5);
    assert_eq!(value("2^3^2", 0.0), 512.0);
    assert_eq!(value("+x--x", 3.0), 6.0);
}

#[test]
fn compares_and_chooses() {
    for (text, expected) in [
        ("x < 2", 1.0),
        ("x<=1", 1.0),
        ("x > 1", 0.0),
        ("x >= 1", 1.0),
        ("x == 1", 1.0),
        ("x != 1", 0.0),
        ("x + 1 < 3*x", 1.0),
        ("(0 < x)*(x < 0.5)", 0.0),
        ("if(x < 2, 10, 20)", 10.0),
        ("if(x > 2, 10, 20)", 20.0),
        ("if(x > 2, 10, x > 0, 20)", f64::NAN),
        ("if(x > 2, 10, if(x > 0.5, 20, 30)) + 1", 21.0),
        ("2*if(x, x + 1, 0) - 1", 3.0),
        ("min(x, 3)*2", 2.0),
        ("min(3, x, 2)", 1.0),
        ("max(1, min(2, 5, 4), 0)^2 - 1", 3.0),
        ("min(min(7, 4), max(2, 3))", 3.0),
        ("sign(-x) + sign(0)", -1.0),
    ] {
        match Formula::new(text, &["x"]) {
            Ok(formula) => assert_eq!(formula.value(&[("x", 1.0)]), expected, "{text}"),
            Err(_) => assert!(expected.is_nan(), "{text}"),
        }
    }
}

/// Only the value that is taken is found; one that does not exist is not hidden.
#[test]
fn what_does_not_exist_shows() {
    assert_eq!(value("if(x > 0, sqrt(x), 0)", -1.0), 0.0);
    for text in [
        "min(sqrt(x), 1)",
        "max(1, sqrt(x))",
        "sqrt(x) < 1",
        "if(sqrt(x) < 1, 2, 3)",
        "1 + if(sqrt(x), 2, 3)",
        "sign(sqrt(x))",
    ] {
        assert!(value(text, -1.0).is_nan(), "{text}");
    }
}

#[test]
fn names_win_over_constants() {
    assert_eq!(value("e", 0.0), std::f64::consts::E);
    let formula = Formula::new("2*e", &["e"]).unwrap();
    assert_eq!(formula.value(&[("e", 0.5)]), 1.0);
}

#[test]
fn says_what_is_wrong_and_where() {
    for (text, at, part) in [
        ("", 0, "unexpected end"),
        ("2*(", 3, "unexpected end"),
        ("2*(x", 4, "not closed"),
        ("2*x)", 3, "has no opening one"),
        ("2 x", 2, "operator is missing"),
        ("sin(2 x)", 6, "operator or a closing"),
        ("2 + * x", 4, "is missing here"),
        ("2*q", 2, "unknown name `q`"),
        ("x + foo(x)", 4, "`foo` is not a function"),
        ("sin x", 0, "write sin(...)"),
        ("1 + if(x < 1, 2)", 4, "`if` takes three"),
        ("1 + if(x < 1, 2, 3, 4)", 4, "`if` takes three"),
        ("min(x)", 0, "two or more"),
        ("sin(x, 2)", 0, "one argument"),
        ("atan2(x)", 0, "two arguments"),
        ("x = 2", 2, "write =="),
        ("if(x = 2, 1, 0)", 0, "`if` takes three"),
        ("0 < x < 2", 6, "two values at a time"),
        ("1.2.3", 0, "`1.2.3` is not a number"),
        ("1e999", 0, "too large"),
        ("x, 2", 1, "comma"),
        ("x # 2", 2, "unexpected `#`"),
    ] {
        let error = Formula::new(text, &["x"]).unwrap_err();
        assert!(error.to_string().contains(part), "{text}: {error}");
        assert_eq!(error.at(), Some(at), "{text}: {error}");
    }
    for text in ["(".repeat(5000), "-".repeat(1000) + "1", "2^".repeat(900)] {
        assert_eq!(Formula::new(&text, &[]), Err(FormulaError::TooLarge));
    }
}

#[test]
fn long_formulas_need_no_deep_stack() {
    let text = "1".to_owned() + &"+1".repeat(999);
    assert_eq!(value(&text, 0.0), 1000.0);
}
