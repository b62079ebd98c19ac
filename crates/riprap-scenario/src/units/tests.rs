//! Units as they are written, right and wrong.

use super::*;

#[test]
fn converts_a_table_of_values() {
    let table: &[(&str, f64, Dim)] = &[
        ("16 GPa", 16e9, Dim::PRESSURE),
        ("2400 kg/m3", 2400.0, Dim::DENSITY),
        ("2.4 g/cm3", 2400.0, Dim::DENSITY),
        ("2.4 t/m^3", 2400.0, Dim::DENSITY),
        ("2400 kg m-3", 2400.0, Dim::DENSITY),
        ("300 GPa/m", 300e9, Dim::STIFFNESS_PER_AREA),
        ("1 MPa/mm", 1e9, Dim::STIFFNESS_PER_AREA),
        ("26 kN/m3", 26e3, Dim::STIFFNESS_PER_AREA),
        ("9.81 m/s2", 9.81, Dim::ACCELERATION),
        ("9.81 m/s^2", 9.81, Dim::ACCELERATION),
        ("9.81 m/s²", 9.81, Dim::ACCELERATION),
        ("9.81 m s^-2", 9.81, Dim::ACCELERATION),
        ("-10 kN/m", -1e4, Dim::FORCE_PER_LENGTH),
        ("10 us", 1e-5, Dim::TIME),
        ("10 µs", 1e-5, Dim::TIME),
        ("10 μs", 1e-5, Dim::TIME),
        ("10us", 1e-5, Dim::TIME),
        ("2 min", 120.0, Dim::TIME),
        ("1 h", 3600.0, Dim::TIME),
        ("180 deg", std::f64::consts::PI, Dim::ANGLE),
        ("90°", std::f64::consts::FRAC_PI_2, Dim::ANGLE),
        ("200 gon", std::f64::consts::PI, Dim::ANGLE),
        ("5 mrad", 5e-3, Dim::ANGLE),
        ("60 rpm", TURN, Dim::SPIN),
        ("1 deg/s", DEG, Dim::SPIN),
        ("1 rad/s2", 1.0, Dim::SPIN_ACCELERATION),
        ("5 1/s", 5.0, Dim::RATE),
        ("5 /s", 5.0, Dim::RATE),
        ("5 s^-1", 5.0, Dim::RATE),
        ("2 kHz", 2e3, Dim::RATE),
        ("1e-5", 1e-5, Dim::NONE),
        ("5 %", 0.05, Dim::NONE),
        ("1 J/m", 1.0, Dim::FORCE),
        ("3 N", 3.0, Dim::FORCE),
        ("3 N m/m", 3.0, Dim::FORCE),
        ("3 N*m", 3.0, Dim::ENERGY),
        ("3 N·m", 3.0, Dim::ENERGY),
        ("1 kPa", 1e3, Dim::PRESSURE),
        ("1 bar", 1e5, Dim::PRESSURE),
        ("1 psi", 6_894.757_293_168_361, Dim::PRESSURE),
        ("1 N/mm2", 1e6, Dim::PRESSURE),
        ("1 mm", 1e-3, Dim::LENGTH),
        ("1 cm", 1e-2, Dim::LENGTH),
        ("1 ft", 0.3048, Dim::LENGTH),
        ("1e3 in", 25.4, Dim::LENGTH),
        ("1E3 m", 1e3, Dim::LENGTH),
        (".5 m", 0.5, Dim::LENGTH),
        ("5. m", 5.0, Dim::LENGTH),
        ("+5 m", 5.0, Dim::LENGTH),
        ("  5   m  ", 5.0, Dim::LENGTH),
        ("1 kg m/s", 1.0, Dim::MOMENTUM),
        ("1 kg*m/s", 1.0, Dim::MOMENTUM),
        ("3 kW", 3e3, Dim::POWER),
        ("1 m3", 1.0, Dim::VOLUME),
        ("1 l", 1e-3, Dim::VOLUME),
        ("2 cm2", 2e-4, Dim::AREA),
        ("1 MN/m2", 1e6, Dim::PRESSURE),
        ("1 kgf/cm2", 98_066.5, Dim::PRESSURE),
        ("0.5 m/s/s", 0.5, Dim::ACCELERATION),
        ("4180 kJ/kg", 4.18e6, Dim([0, 2, -2, 0])),
    ];
    for (text, value, dim) in table {
        let (got, got_dim) = parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
        assert_eq!(got_dim, *dim, "{text}");
        // One or two roundings of the factor.
        assert!((got - value).abs() <= 4.0 * f64::EPSILON * value.abs(), "{text}: {got}");
    }
}

#[test]
fn refuses_what_is_no_quantity() {
    let table = [
        ("", "does not begin with a number"),
        ("m", "does not begin with a number"),
        ("--5 m", "does not begin with a number"),
        ("nan m", "not a finite number"),
        ("-inf", "not a finite number"),
        ("1e999 m", "not a finite number"),
        ("1e308 GPa", "not a finite number"),
        ("1,5 m", "a comma in a number"),
        ("1.5.3 m", "is not a unit"),
        ("5 (m/s)", "is not a unit"),
        ("5 m/", "is not a unit"),
        ("5 m//s", "is not a unit"),
        ("5 *m", "is not a unit"),
        ("5 m^", "is not a unit"),
        ("5 m99", "is not a unit"),
        ("5 m^9 m^9 m^9 m^9 m^9 m^9 m^9 m^9 m^9 m^9 m^9 m^9 m^9 m^9 m^9", "is not a unit"),
        ("5 furlong", "unknown unit `furlong`"),
        ("5 Mpa", "unknown unit `Mpa`"),
        ("5 6 m", "is not a unit"),
        ("5 m\0", "is not a unit"),
    ];
    for (text, message) in table {
        let error = parse(text).expect_err(text);
        assert!(error.message.contains(message), "{text}: {error}");
    }
    assert!(parse(&"9".repeat(1000)).is_err());
}

#[test]
fn suggests_units() {
    let help = |text| parse(text).expect_err("unknown").help.unwrap_or_default();
    assert_eq!(help("5 Mpa"), "did you mean `MPa`?");
    assert_eq!(help("5 seconds"), "did you mean `s`?");
    assert_eq!(help("5 degs"), "did you mean `deg`?");
    assert_eq!(help("5 Gpa/m"), "did you mean `GPa`?");
    assert_eq!(help("5 msec"), "did you mean `ms`?");
    assert!(help("5 furlong").starts_with("known units"));
}

#[test]
fn tells_thousands_from_a_decimal_comma() {
    let help = |text| parse(text).expect_err("comma").help.unwrap_or_default();
    assert_eq!(
        help("2,600 kg/m3"),
        "write 2600, without a comma; or 2.600 if the comma is a decimal one"
    );
    assert_eq!(help("-1,250,000 Pa"), "write -1250000, without a comma");
    for decimal in ["1,5 m", "0,250 m", "1,2500 m", "1.5,000 m", "1234,567 m"] {
        assert_eq!(help(decimal), "write a decimal point: 1.5, not 1,5");
    }
}

#[test]
fn a_value_in_a_unit_has_its_dimension() {
    assert_eq!(value_in("36 km/h", "m/s"), Some(10.0));
    assert_eq!(value_in(" -2.5 ", "m/s"), Some(-2.5));
    assert_eq!(value_in("3", "-"), Some(3.0));
    assert_eq!(value_in("200 mm", "cm").map(|v| (v * 1e6).round()), Some(2e7));
    for (text, unit) in
        [("0 kg", "m/s"), ("1 Pa", "-"), ("1 s", "m"), ("inf", "m"), ("NaN", "m"), ("much", "m")]
    {
        assert_eq!(value_in(text, unit), None, "{text} {unit}");
    }
}

#[test]
fn describes_dimensions() {
    assert_eq!(dimension("N/m").unwrap().describe(), "a force per length");
    assert_eq!(dimension("-").unwrap(), Dim::NONE);
    assert_eq!(dimension("kg m").unwrap().describe(), "a quantity in kg m");
    assert_eq!(dimension("m-4").unwrap().to_string(), "m^-4");
    assert!(all_names().len() >= 60, "{}", all_names().len());
}
