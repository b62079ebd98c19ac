//! Interfaces: defaults, changes by phases, strengths divided by a factor.

use super::*;

#[test]
fn interfaces_between_materials_and_their_changes() {
    let middle = format!(
        r#"
[interfaces.shoe]
between = ["steel", "rock"]
law = "penetration_potential"
normal_stiffness = "3 GPa/m"
friction_coefficient = 0.1
friction_law = "clipped"
clip_speed = "1 mm/s"
[interfaces.shoe.bond]
tension = "1 MPa"
cohesion = "2 MPa"
[materials.steel]
density = "7800 kg/m3"
young = "200 GPa"
poisson = 0.3
{CUBE}
[[blocks]]
name = "shoe"
material = "steel"
rectangle = {{ size = ["1 m", "1 m"], corner = ["3 m", "0 m"] }}
[[phases]]
name = "slip"
until = {{ steps = 10 }}
[phases.interfaces.shoe]
friction_coefficient = 0.05
[[phases]]
name = "slip more"
until = {{ steps = 10 }}
[phases.interfaces.shoe]
cohesion = "1 kPa"
"#
    );
    let model = good(&middle);
    assert_eq!(model.setup.planar().unwrap().materials, ["rock", "steel"]);
    assert_eq!(model.setup.planar().unwrap().pair_table, [0, 1, 1, 0]);
    let shoe = &model.setup.planar().unwrap().interfaces[1];
    assert_eq!((shoe.contact.friction, shoe.contact.shear_stiffness), (0.1, 1.5e9));
    let bond = shoe.bond.unwrap();
    assert_eq!((bond.normal_stiffness, bond.strength.friction, bond.points), (3e9, 0.1, 2));
    let [(row, law)] = model.plan.phases[1].contacts[..] else { panic!() };
    // Changes add up over the phases.
    assert_eq!((row, law.friction, law.cohesion), (1, 0.05, 1000.0));
    assert_eq!(model.summary.duration, None);
}

#[test]
fn default_stiffness_needs_elastic_constants() {
    let text = text(&format!("{CUBE}{FLOOR}")).replace("young = \"10 GPa\"\npoisson = 0.25\n", "");
    let parsed = parse(Source::new("t", text));
    let error = match parsed {
        Ok(parsed) => build(&parsed, "default", INFOS).unwrap_err(),
        Err(error) => error,
    };
    assert!(error.render().contains("normal_stiffness"), "{error}");
}

#[test]
fn strengths_are_divided_by_the_factor() {
    let scene = format!(
        "{CUBE}{FLOOR}\n[[phases]]\nname = \"weak\"\nuntil = {{ time = \"1 s\" }}\n\
         [phases.interfaces.default]\nfriction_coefficient = 0.3\ncohesion = \"3 kPa\"\n"
    );
    let plain = good(&scene).setup.planar().unwrap().interfaces[0].contact.friction;
    let source = text(&scene).replacen("title", "strength_factor = 1.5\ntitle", 1);
    let model = build(&parse(Source::new("t.toml", source)).unwrap(), "default", INFOS).unwrap();
    let law = &model.setup.planar().unwrap().interfaces[0].contact;
    assert!((law.friction - plain / 1.5).abs() < 1e-15);
    let weak = model.plan.phases.iter().find(|p| p.name == "weak").unwrap();
    let (_, later) = &weak.contacts[0];
    assert!((later.friction - 0.2).abs() < 1e-15 && (later.cohesion - 2000.0).abs() < 1e-9);
}
