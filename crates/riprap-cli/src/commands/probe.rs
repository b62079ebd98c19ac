//! `riprap probe-contact`.

use riprap::planar::classify::ContactType;
use riprap::run::probe::{self, Touch};
use riprap::scenario::units::{self, Dim};

use crate::args::ProbeContact;
use crate::diagnostics::Style;
use crate::failure::Failure;
use crate::numbers::si;
use crate::{scenes, screen};

pub fn run(args: &ProbeContact, style: Style) -> Result<(), Failure> {
    let prepared = scenes::prepare(&args.scene, style, args.json)?;
    let Some(setup) = prepared.model.setup.planar() else {
        return Err(Failure::Input("probe-contact needs [space.planar]".to_owned()));
    };
    if let Some(pair) = &args.pair {
        for name in pair {
            if !setup.blocks.iter().any(|block| block.name == *name) {
                return Err(Failure::Input(format!("unknown block {name:?}")));
            }
        }
    }
    let threshold = args.threshold.as_deref().map(length).transpose()?;
    let touches = probe::touches(setup, threshold).map_err(|e| Failure::Physics(e.to_string()))?;
    let wanted = |touch: &&Touch| match args.pair.as_deref() {
        // Nobody has to know which of the two the search found first.
        Some([a, b]) => {
            (touch.first == *a && touch.second == *b) || (touch.first == *b && touch.second == *a)
        }
        Some(_) | None => true,
    };
    let touches: Vec<&Touch> = touches.iter().filter(wanted).collect();
    if args.json {
        screen::line(&serde_json::to_string_pretty(&touches).unwrap_or_default());
        return Ok(());
    }
    if touches.is_empty() {
        screen::line("no blocks touch or are closer than the threshold");
        return Ok(());
    }
    screen::print(&screen::table(&HEADS, touches.iter().map(|touch| row(touch))));
    screen::line("forces act on the first block; moments are about each block's own centroid");
    Ok(())
}

const HEADS: [&str; 10] = [
    "first",
    "second",
    "overlap",
    "length",
    "centre [m]",
    "force x",
    "force y",
    "moment on first",
    "moment on second",
    "types",
];

/// What is shown of one contact.
fn row(t: &Touch) -> Vec<String> {
    let touching = t.overlap > 0.0 || t.length > 0.0;
    let depth = if touching { si(t.overlap, "m") } else { format!("none, gap {}", si(t.gap, "m")) };
    vec![
        t.first.clone(),
        t.second.clone(),
        depth,
        si(t.length, "m"),
        format!("({:.6}, {:.6})", t.centre[0], t.centre[1]),
        si(t.force[0], "N/m"),
        si(t.force[1], "N/m"),
        si(t.moment_first, "N"),
        si(t.moment_second, "N"),
        types(t),
    ]
}

/// The kinds of contact of one region, each once, in the order of the list.
fn types(touch: &Touch) -> String {
    let mut names: Vec<&str> = Vec::new();
    for found in &touch.types {
        let name = match found.kind {
            ContactType::ConvexConvex => "corner-corner",
            ContactType::ConcaveConvex => "notch-corner",
            ContactType::ConvexEdge => "corner-edge",
            ContactType::EdgeEdge => "edge-edge",
        };
        if !names.contains(&name) {
            names.push(name);
        }
    }
    if names.is_empty() { "-".to_owned() } else { names.join(",") }
}

fn length(text: &str) -> Result<f64, Failure> {
    match units::parse(text) {
        Ok((value, Dim::LENGTH)) if value > 0.0 && value.is_finite() => Ok(value),
        Ok(_) | Err(_) => Err(Failure::Input(format!(
            "{text:?} is not a valid length; write for example --threshold '1 mm'"
        ))),
    }
}
