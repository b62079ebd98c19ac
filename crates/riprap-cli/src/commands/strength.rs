//! `riprap strength`: modulus and strength of laboratory tests.

use riprap::run::strength::{Rules, Test, strength};
use riprap::scenario::units::{self, Dim};

use crate::args::Strength;
use crate::commands::answer as say;
use crate::commands::plot::quantity;
use crate::failure::Failure;

/// `riprap strength`.
pub fn run(args: &Strength) -> Result<(), Failure> {
    let answer = strength(&args.runs, &rules(args)?).map_err(|e| Failure::Input(e.to_string()))?;
    let json = args.json.then(|| serde_json::json!(answer));
    let csv = || answer.table().map_err(|e| e.to_string());
    say(json, args.out.as_deref(), csv, || answer.words())
}

fn rules(args: &Strength) -> Result<Rules, Failure> {
    let test = match (&args.disk, args.shear) {
        (Some(text), _) => disk(text)?,
        (None, true) => Test::Shear,
        (None, false) => Test::Axial,
    };
    let area = args.area.as_deref().map(area).transpose()?;
    if args.load.is_some() && area.is_none() && args.disk.is_none() {
        return Err(Failure::Input(
            "a load is no stress: add --area '20 cm2', of a disk --disk '54 mm,27 mm', or name a stress with --stress".to_owned(),
        ));
    }
    let length = args.length.as_deref();
    let (low, high) = args.between.split_once("..").unwrap_or((&args.between, ""));
    let share = |text: &str| {
        text.trim().parse::<f64>().map_err(|_| {
            Failure::Input(format!(
                "{:?} is no range; write for example --between 0.2..0.5",
                args.between
            ))
        })
    };
    Ok(Rules {
        test,
        load: args.stress.clone().or_else(|| args.load.clone()).unwrap_or_default(),
        area,
        strain: args.strain.clone().or_else(|| args.shortening.clone()),
        length: length
            .map(|text| quantity(text, Dim::LENGTH, "length", "--length '10 cm'"))
            .transpose()?,
        confining: args.confining.clone(),
        between: [share(low)?, share(high)?],
    })
}

/// An area, in the plane per thickness a length.
fn area(text: &str) -> Result<f64, Failure> {
    match units::parse(text) {
        Ok((value, Dim::AREA | Dim::LENGTH)) => Ok(value),
        Ok(_) | Err(_) => Err(Failure::Input(format!(
            "{text:?} is not a valid area; write for example --area '20 cm2', in the plane --area '5 cm'"
        ))),
    }
}

/// Diameter and thickness of a disk.
fn disk(text: &str) -> Result<Test, Failure> {
    let length = |text: &str| quantity(text.trim(), Dim::LENGTH, "length", "--disk '54 mm,27 mm'");
    let (diameter, thickness) = match text.split_once(',') {
        Some((diameter, thickness)) => (diameter, Some(length(thickness)?)),
        None => (text, None),
    };
    Ok(Test::Disk { diameter: length(diameter)?, thickness })
}
