//! `riprap sizes`: sizes of the blocks of a scene.

use riprap::exec::Exec;
use riprap::numbers::counted;
use riprap::plot;
use riprap::run::engine::Engine;
use riprap::run::sizes::{Sizes as Found, sizes};

use crate::args::Sizes;
use crate::diagnostics::Style;
use crate::failure::Failure;
use crate::numbers::si;
use crate::{scenes, screen};

/// `riprap sizes`.
pub fn run(args: &Sizes, style: Style) -> Result<(), Failure> {
    let prepared = scenes::prepare(&args.scene, style, args.json)?;
    let title = prepared.parsed.scenario.title.clone();
    let engine = Engine::new(prepared.job().setup, Exec::serial());
    let engine = engine.map_err(|wrong| Failure::Input(wrong.to_string()))?;
    let found = sizes(&engine.view(), args.of.as_deref()).map_err(Failure::Input)?;
    let mut files = Vec::new();
    if let Some(file) = &args.out {
        let of = args.of.as_ref().map_or(String::new(), |of| format!(" of {of}"));
        let below = format!(", {}{of} at the start", found.head());
        files = plot::block_sizes((&title, &below), &found.curve, file.as_path())?;
    }
    if args.json {
        screen::line(&serde_json::json!(found).to_string());
        return Ok(());
    }
    screen::line(&words(&found));
    for file in files {
        screen::line(&file.display().to_string());
    }
    Ok(())
}

fn words(found: &Found) -> String {
    let row = |name: &str, size: f64| format!("  {name:<10} {}", si(size, "m"));
    let mut lines = vec![
        found.head(),
        row("smallest", found.smallest),
        row("x20", found.x20),
        row("x50", found.x50),
        row("x80", found.x80),
        row("largest", found.largest),
    ];
    if found.held > 0 {
        lines.push(format!("  {} left out: they are held", counted(found.held, "block")));
    }
    if let Some(n) = found.n {
        lines.push(format!("  n          {n:.3} (Rosin-Rammler)"));
    }
    lines.join("\n")
}
