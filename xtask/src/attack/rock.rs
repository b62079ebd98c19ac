//! Attacks on what a run says of its own physics: jointed rock at random, thin blocks under joints, folded deformable blocks, forces that change
//! from one phase to the next.

use super::{Field, Found};
use riprap_fuzz::damage::Chance;

/// Steps of each of the two phases of a model of jointed rock, and of the short form.
const STEPS: [usize; 2] = [200, 40];
/// Miss of a fall from which on a change of forces is followed wrongly, m.
const MISSED: f64 = 1e-3;

/// Rock cut at random by joint sets, disks or into cells, that settles and is excavated, slowly or at once.
pub fn jointed(field: &Field<'_>, chance: &mut Chance) -> Result<Found, String> {
    let mut found = Found::default();
    let steps = STEPS[usize::from(field.few())];
    for number in 0..(field.tries / 3).max(4) {
        found.tries += 1;
        let scene = rock(field, chance, number, steps)?;
        let how = field.ran(&scene)?;
        match how.code {
            Some(0) => {}
            // A joint that leaves slivers, or a disk that cuts nothing.
            Some(2) => found.refused += 1,
            _ => {
                let name = format!("rock_{number}");
                field.keep(&name);
                let said = how.said.lines().rev().find(|l| l.starts_with("error"));
                let why = said.unwrap_or("").chars().take(300).collect::<String>();
                found.failures.push(format!("{name}: {:?}: {why}", how.code));
            }
        }
    }
    Ok(found)
}

/// A number from 0 to 1.
fn share(chance: &mut Chance) -> f64 {
    chance.below(10_000) as f64 / 1e4
}

/// Two to four joint sets with this spacing, m.
fn joint_sets(chance: &mut Chance, spacing: f64) -> Vec<String> {
    let sets = (0..2 + chance.below(3)).map(|_| {
        let any = 90.0 * share(chance);
        let dip = *chance.of(&[0.0, 5.0, 30.0, 45.0, 60.0, 80.0, 85.0, 90.0, any]);
        let any = 360.0 * share(chance);
        let direction = *chance.of(&[0.0, 70.0, 90.0, 160.0, 180.0, any]);
        let scatter = *chance.of(&[0.0, 0.2]) * spacing;
        format!(
            "{{ dip = \"{dip} deg\", dip_direction = \"{direction} deg\", spacing = \"{spacing} m\", spacing_scatter = \"{scatter} m\" }}"
        )
    });
    sets.collect()
}

/// A table of joints that are disks, in a cube of this length, m.
fn disks(chance: &mut Chance, length: f64) -> String {
    let mut rows = "x_m,y_m,z_m,dip_deg,dip_direction_deg,radius_m\n".to_owned();
    for _ in 0..*chance.of(&[6, 12, 20]) {
        let [x, y, z, dip, direction, radius] = [0; 6].map(|_| share(chance));
        rows += &format!(
            "{},{},{},{},{},{}\n",
            length * x,
            length * y,
            length * z,
            90.0 * dip,
            360.0 * direction,
            length * (0.2 + 0.5 * radius)
        );
    }
    rows
}

/// One model of jointed rock.
fn rock(
    field: &Field<'_>,
    chance: &mut Chance,
    number: usize,
    steps: usize,
) -> Result<String, String> {
    let length = *chance.of(&[4.0, 6.0, 8.0]);
    let spacing = length / *chance.of(&[3.0, 4.0, 5.0]);
    let mut shape = String::new();
    let mut cell = None;
    match number % 4 {
        0 | 1 => {
            shape = format!(
                "cut = {{ seed = {number}, smallest_edge = \"{} m\", joint_sets = [{}] }}\n",
                0.03 * length,
                joint_sets(chance, spacing).join(", ")
            );
        }
        2 => {
            field.write("disks.csv", disks(chance, length))?;
            shape = format!(
                "cut = {{ joints.csv = \"disks.csv\", smallest_edge = \"{} m\" }}\n",
                0.02 * length
            );
        }
        _ => cell = Some(number),
    }
    let block = |name: &str, from: f64, wide: f64| {
        let head = format!("[[blocks]]\nname = \"{name}\"\nmaterial = \"rock\"\n");
        let place = format!(
            "size = [\"{wide} m\", \"{length} m\", \"{length} m\"], corner = [\"{from} m\", \"0 m\", \"0 m\"]"
        );
        match cell {
            Some(seed) => format!(
                "{head}grid.cells = {{ {place}, cell = \"{spacing} m\", seed = {seed}, smallest_edge = \"{} m\" }}\n",
                0.05 * spacing
            ),
            None => format!("{head}brick = {{ {place} }}\n{shape}"),
        }
    };
    let kind = |chance: &mut Chance, share: usize| {
        if chance.below(10) < share { "kind = \"static\"\n" } else { "" }
    };
    let room = chance.below(2) == 0;
    let (first, second) = (kind(chance, 6), kind(chance, 3));
    Ok(format!(
        "riprap = 1\ntitle = \"jointed rock\"\n[space.spatial]\ngravity = \"9.81 m/s2\"\nkinematics = \"{}\"\n[materials.rock]\ndensity = \"2700 kg/m3\"\n\
         young = \"30 GPa\"\npoisson = 0.25\n[interfaces.default]\nfriction_angle = \"{} deg\"\nnormal_stiffness = \"{}\"\n{}{}\
         [[boundaries]]\non.plane = \"z-min\"\nheld = {{}}\n[[phases]]\nname = \"settle\"\n{first}until = {{ steps = {steps} }}\n\
         [[phases]]\nname = \"next\"\n{second}{}until = {{ steps = {steps} }}\n",
        chance.of(&["automatic", "automatic", "finite"]),
        chance.of(&[0, 10, 30, 45]),
        chance.of(&["50 MPa/m", "100 MPa/m", "1 GPa/m", "10 GPa/m"]),
        block("ore", 0.0, length),
        if room { block("room", length, 0.5 * length) } else { String::new() },
        if room { "remove = [\"room\"]\n" } else { "" },
    ))
}

/// A thin layer or a small prop between large blocks: joined or apart, in space and in the plane.
pub fn thin(field: &Field<'_>, _: &mut Chance) -> Result<Found, String> {
    let mut found = Found::default();
    let stiffnesses = ["1 MPa/m", "10 MPa/m", "100 MPa/m", "1 GPa/m", "100 GPa/m"];
    for (k, stiffness) in stiffnesses.iter().enumerate() {
        for (l, thickness) in [0.01, 0.1, 0.3].into_iter().enumerate() {
            for (m, gap) in [0.0, 0.001].into_iter().enumerate() {
                for plane in [false, true] {
                    if field.few() && (k + l + m) % 5 != 0 {
                        continue;
                    }
                    found.tries += 1;
                    let how = field.ran(&layer(plane, stiffness, thickness, gap))?;
                    found.refused += usize::from(how.code == Some(1));
                    let name = format!("plane {plane}, {stiffness}, {thickness} m, gap {gap} m");
                    let sunk = match how.code {
                        Some(0) => -field.last()?,
                        Some(1) if !how.slow => continue,
                        _ => f64::INFINITY,
                    };
                    if sunk > thickness + 2.0 * gap {
                        field.keep(&format!("thin_{k}{l}{m}{plane}"));
                        found.failures.push(format!("{name}: {:?}, sunk {sunk} m", how.code));
                    }
                }
            }
        }
    }
    Ok(found)
}

/// A roof on a layer on a floor.
fn layer(plane: bool, stiffness: &str, thickness: f64, gap: f64) -> String {
    let above = thickness + gap;
    let head = format!(
        "riprap = 1\ntitle = \"thin\"\n[materials.r]\ndensity = \"2600 kg/m3\"\nyoung = \"20 GPa\"\npoisson = 0.25\n[interfaces.default]\n\
         friction_angle = \"30 deg\"\nnormal_stiffness = \"{stiffness}\"\n{}\
         [[supports]]\non.block = \"floor\"\nfixed = {{}}\n[[phases]]\nname = \"a\"\nuntil = {{ time = \"1.5 s\" }}\ndamping.mass = \"5 1/s\"\n",
        if plane && gap == 0.0 {
            "bond = { cohesion = \"10 MPa\", tension = \"10 MPa\" }\n"
        } else {
            ""
        }
    );
    let block = |name: &str, low: f64, high: f64, half: f64| {
        let shape = if plane {
            format!(
                "rectangle = {{ corner = [\"{} m\", \"{low} m\"], size = [\"{} m\", \"{} m\"] }}",
                -half,
                2.0 * half,
                high - low
            )
        } else {
            format!(
                "brick = {{ corner = [\"{} m\", \"{} m\", \"{low} m\"], size = [\"{} m\", \"{} m\", \"{} m\"] }}",
                -half,
                -half,
                2.0 * half,
                2.0 * half,
                high - low
            )
        };
        format!("[[blocks]]\nname = \"{name}\"\nmaterial = \"r\"\n{shape}\n")
    };
    let (space, along) = if plane {
        ("[space.planar]\ngravity = [\"0 m/s2\", \"-9.81 m/s2\"]\n", "y")
    } else {
        ("[space.spatial]\ngravity = \"9.81 m/s2\"\n", "z")
    };
    format!(
        "{head}{space}{}{}{}[[outputs]]\nhistory = {{ name = \"roof\", field = \"block.displacement.{along}\", of = \"roof\", every = \"10 ms\" }}\n",
        block("floor", -4.0, 0.0, 4.0),
        block("layer", 0.0, thickness, if thickness > 0.2 { 0.15 } else { 4.0 }),
        block("roof", above, above + 8.0, 4.0),
    )
}

/// Columns of deformable blocks that are too soft for their weight.
pub fn folded(field: &Field<'_>, _: &mut Chance) -> Result<Found, String> {
    let mut found = Found::default();
    for (k, young) in ["2 kPa", "20 kPa", "100 kPa", "1 MPa", "100 MPa"].iter().enumerate() {
        for strain in ["small", "total_lagrangian"] {
            for kind in ["kind = \"static\"\n", ""] {
                if field.few() && (k != 1 || kind.is_empty()) {
                    continue;
                }
                found.tries += 1;
                let until = if kind.is_empty() { "time = \"1 s\"" } else { "unbalanced = 1e-4" };
                let scene = format!(
                    "riprap = 1\ntitle = \"folded\"\n[space.spatial]\ngravity = \"9.81 m/s2\"\n[materials.r]\ndensity = \"2600 kg/m3\"\nyoung = \"{young}\"\n\
                     poisson = 0.25\n[interfaces.default]\nfriction_angle = \"30 deg\"\nbrittle_bond = {{ thickness = \"10 mm\", elastic = true }}\n\
                     [[blocks]]\nname = \"b\"\nmaterial = \"r\"\n\
                     grid.box = {{ size = [\"1 m\", \"1 m\", \"3 m\"], cell = \"1 m\", corner = [\"0 m\", \"0 m\", \"0 m\"] }}\n\
                     mechanics.deformable = {{ strain = \"{strain}\" }}\n[[boundaries]]\non.plane = \"z-min\"\nheld = {{}}\n\
                     [[phases]]\nname = \"a\"\n{kind}until = {{ {until} }}\n\
                     [[outputs]]\nhistory = {{ name = \"top\", field = \"block.displacement.z\", at_point = [\"0.5 m\", \"0.5 m\", \"2.5 m\"], every = \"phase\" }}\n"
                );
                let how = field.ran(&scene)?;
                found.refused += usize::from(how.code == Some(1));
                let name = format!("{young}, {strain} strain, {kind}");
                match how.code {
                    // The centre of the uppermost block begins at 2.5 m above its foot.
                    Some(0) if field.last()? > -2.5 => {}
                    Some(1) if !how.slow => {}
                    code => {
                        field.keep(&format!("folded_{k}{strain}"));
                        found.failures.push(format!("{name}: {code:?}: below its foot"));
                    }
                }
            }
        }
    }
    Ok(found)
}

/// Blocks that fall freely in a second phase: by gravity that is new, or since nothing holds them any more.
pub fn forces(field: &Field<'_>, _: &mut Chance) -> Result<Found, String> {
    let mut found = Found::default();
    for plane in [false, true] {
        for release in [false, true] {
            for step in ["auto", "10 ms", "1 ms"] {
                if field.few() && step != "10 ms" {
                    continue;
                }
                found.tries += 1;
                let how = field.ran(&falling(plane, release, step))?;
                let name = format!("plane {plane}, released {release}, steps {step}");
                let fallen = if how.code == Some(0) { -field.last()? } else { f64::NAN };
                let fell = (fallen - 5.0).abs() < MISSED;
                if !fell {
                    field.keep(&format!("forces_{plane}{release}"));
                    found.failures.push(format!("{name}: {:?}, fallen {fallen} m of 5", how.code));
                }
            }
        }
    }
    Ok(found)
}

/// A block that falls for a second from the start of the second phase on.
fn falling(plane: bool, release: bool, step: &str) -> String {
    let vector = |down: &str| {
        if plane { format!("[\"0 m/s2\", \"-{down} m/s2\"]") } else { format!("\"{down} m/s2\"") }
    };
    let step = match step {
        "auto" => String::new(),
        given => format!("time_step = \"{given}\"\n"),
    };
    let (space, shape) = if plane {
        ("planar", "rectangle = { corner = [\"0 m\", \"0 m\"], size = [\"1 m\", \"1 m\"] }")
    } else {
        (
            "spatial",
            "brick = { corner = [\"0 m\", \"0 m\", \"0 m\"], size = [\"1 m\", \"1 m\", \"1 m\"] }",
        )
    };
    let (start, change, hold) = if release {
        ("10", "release = [\"b\"]\n".to_owned(), "[[supports]]\non.block = \"b\"\nfixed = {}\n")
    } else {
        ("0", format!("gravity = {}\n", vector("10")), "")
    };
    format!(
        "riprap = 1\ntitle = \"forces\"\n[space.{space}]\ngravity = {}\n[materials.r]\ndensity = \"2000 kg/m3\"\nyoung = \"20 GPa\"\npoisson = 0.25\n\
         [interfaces.default]\nfriction_angle = \"30 deg\"\nnormal_stiffness = \"100 MPa/m\"\n[[blocks]]\nname = \"b\"\nmaterial = \"r\"\n{shape}\n{hold}\
         [[phases]]\nname = \"before\"\nuntil = {{ time = \"0.5 s\" }}\n{step}[[phases]]\nname = \"fall\"\n{change}until = {{ time = \"1 s\" }}\n{step}\
         [[outputs]]\nhistory = {{ name = \"fall\", field = \"block.displacement.{}\", of = \"b\", every = \"phase\" }}\n",
        vector(start),
        if plane { "y" } else { "z" },
    )
}
