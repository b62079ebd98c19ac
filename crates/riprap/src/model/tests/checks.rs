//! Outputs, checks and bisections.

use super::*;

#[test]
fn outputs_and_checks_are_resolved() {
    let model = good(&format!(
        r#"{CUBE}{FLOOR}
[[outputs]]
history = {{ name = "slip", field = "block.displacement", of = "cube", along = "-35 deg", every = "1 ms" }}
[[outputs]]
history = {{ name = "v", field = "block.velocity", of = "cube", every = "10 steps" }}
[[outputs]]
frames = {{ every = "1 phase" }}
[[checks]]
name = "formula"
field = "block.displacement.y"
of = "cube"
at = "0.5 s"
formula = "0.5*g*tan(phi)*t^2"
let = {{ phi = "interfaces.default.friction_angle", g = 9.81 }}
relative = 1e-3
absolute = "1 mm"
[[checks]]
name = "force"
field = "pair.force"
of = ["cube", "floor"]
along = "90 deg"
reduce = "first_above"
threshold = "1 kN/m"
between = ["0 s", "1 ms"]
[[checks]]
name = "elsewhere"
field = "model.kinetic"
value = "0 J/m"
absolute = "1 J/m"
only = ["deformable"]
[variants.deformable]
"interfaces.default.friction_angle" = "5 deg"
"#
    ));
    let names: Vec<&str> = model.plan.histories.iter().map(|h| h.name.as_str()).collect();
    assert_eq!(names, ["slip", "v.x", "v.y"]);
    assert_eq!(model.plan.histories[2].gauge.field, "block.velocity.y");
    assert_eq!(model.plan.frames, Some(Every::Phase));
    let [formula, force] = &model.checks[..] else { panic!("{:?}", model.checks) };
    assert_eq!((formula.window, formula.absolute), (Window::At(0.5), Some(1e-3)));
    let Expected::Formula { formula, names } = &formula.expected else { panic!() };
    let mut values: Vec<(&str, f64)> = names.iter().map(|(n, v)| (n.as_str(), *v)).collect();
    values.push(("t", 2.0));
    assert!((formula.value(&values) - 2.0 * 9.81).abs() < 1e-12);
    assert_eq!((force.unit.as_str(), &force.gauge.of[..]), ("N/m", &[0, 1][..]));
    assert!(matches!(force.expected, Expected::Between(_, high) if (high - 1e-3).abs() < 1e-18));
}

#[test]
fn what_checks_ask_for_must_exist() {
    let check = |rest: &str| {
        bad(&format!("{CUBE}{FLOOR}\n[[checks]]\nname = \"c\"\nrelative = 0.1\n{rest}\n"))
    };
    let has = |text: String, parts: &[&str]| {
        for part in parts {
            assert!(text.contains(part), "no {part:?} in\n{text}");
        }
    };
    has(
        check("field = \"block.displacment.x\"\nof = \"cube\"\nvalue = \"1 m\""),
        &["there is no field `block.displacment.x`", "`block.displacement`"],
    );
    has(
        check("field = \"block.displacement\"\nof = \"cube\"\nvalue = \"1 m\""),
        &["is a vector", "block.displacement.x"],
    );
    has(
        check("field = \"block.displacement.x\"\nof = \"cube\"\nvalue = \"1 s\""),
        &["is a time", "the field is in m"],
    );
    has(check("field = \"block.rotation\"\nof = \"cube\"\nvalue = 0.1"), &["unit", "rad"]);
    has(check("field = \"block.rotation\"\nvalue = \"1 deg\""), &["needs one block"]);
    has(check("field = \"model.kinetic\"\nof = \"cube\"\nvalue = \"1 J/m\""), &["whole model"]);
    has(
        check("field = \"pair.force.x\"\nof = [\"cube\", \"cube\"]\nvalue = \"1 N/m\""),
        &["the same block"],
    );
    has(
        check("field = \"model.kinetic\"\nat = \"5 s\"\nvalue = \"1 J/m\""),
        &["reads at 5 s", "last phase (1 s)"],
    );
    has(
        check("field = \"model.kinetic\"\nvalue = \"1 J/m\"\nexact = true\nknown = \"x\""),
        &["known"],
    );
}

#[test]
fn bisections_are_in_si() {
    let model = good(&format!(
        r#"{CUBE}{FLOOR}
[bisect]
key = "interfaces.default.friction_angle"
low = "30 deg"
high = "45 deg"
tolerance = "0.1 deg"
fails_when = {{ field = "model.max_displacement", above = "0.1 m" }}
"#
    ));
    let bisect = model.bisect.unwrap();
    assert_eq!(bisect.unit, "rad");
    assert!((bisect.low - 30f64.to_radians()).abs() < 1e-15);
    assert!(
        matches!(bisect.holds.expected, Expected::Between(low, 0.1) if low == f64::NEG_INFINITY)
    );
}

#[test]
fn the_limit_of_a_bisection_can_be_checked() {
    let model = good(&format!(
        r#"{CUBE}{FLOOR}
[bisect]
key = "interfaces.default.friction_angle"
low = "30 deg"
high = "45 deg"
tolerance = "0.1 deg"
fails_when = {{ field = "model.max_displacement", above = "0.1 m" }}
[[checks]]
name = "limit"
field = "bisect.limit"
value = "35 deg"
absolute = "0.2 deg"
"#
    ));
    assert!(model.checks.is_empty());
    let check = &model.bisect.unwrap().checks[0];
    assert_eq!((check.gauge.field.as_str(), check.unit.as_str()), (super::LIMIT, "rad"));
    assert!(matches!(check.expected, Expected::Value(x) if (x - 35f64.to_radians()).abs() < 1e-15));
    let text = bad(&format!(
        "{CUBE}[[checks]]\nname = \"limit\"\nfield = \"bisect.limit\"\nvalue = 1.0\nrelative = 0.1\n"
    ));
    assert!(text.contains("the scene has no [bisect]"), "{text}");
}
