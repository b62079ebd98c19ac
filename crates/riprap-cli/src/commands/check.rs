//! `riprap check`: what a scene holds and what a run of it will take.

use riprap::model::Summary;
use riprap::run::forecast::{Forecast, ForecastError, forecast};
use serde_json::json;

use crate::args::Check;
use crate::diagnostics::Style;
use crate::failure::Failure;
use crate::numbers::{duration, grouped, ratio, si};
use crate::{scenes, screen};

pub fn run(args: &Check, style: Style) -> Result<(), Failure> {
    let prepared = scenes::prepare(&args.scene, style, false)?;
    let (model, summary) = (&prepared.model, &prepared.model.summary);
    let expected = forecast(&model.setup, &model.plan).map_err(|e| match e {
        ForecastError::Build(e) => Failure::Input(e.to_string()),
        ForecastError::Physics(e) => Failure::Physics(e.to_string()),
    })?;
    if args.json {
        let warnings: Vec<_> = model
            .warnings
            .iter()
            .map(|w| json!({ "code": w.code, "message": w.message, "help": w.help }))
            .collect();
        let all = json!({
            "scene": args.scene.file.display().to_string(),
            "title": prepared.parsed.scenario.title,
            "input_hash": prepared.manifest.input_hash,
            "model": summary, "expected": expected, "warnings": warnings,
        });
        screen::line(&serde_json::to_string_pretty(&all).unwrap_or_default());
        return Ok(());
    }
    let title = &prepared.parsed.scenario.title;
    screen::line(&format!("{}: {title}", args.scene.file.display()));
    screen::print(&model_text(summary));
    screen::print(&expected_text(&expected));
    let checks = model.checks.len();
    screen::line(&format!(
        "  checks     {checks}\nno errors, {} warnings",
        model.warnings.len()
    ));
    Ok(())
}

fn model_text(s: &Summary) -> String {
    let [low, high] = s.bounds;
    let mut text = format!(
        "  blocks     {} ({} held), {} corners, sizes {} / {} / {} (smallest, median, largest)\n  \
         region     x {} to {} m, y {} to {} m; mass {}\n  \
         shortest   edge {} on block {}\n  near       {} pairs at the start (boxes that meet)",
        grouped(s.blocks as u64),
        grouped(s.supported as u64),
        grouped(s.vertices as u64),
        si(s.size[0], "m"),
        si(s.size[1], "m"),
        si(s.size[2], "m"),
        low[0],
        high[0],
        low[1],
        high[1],
        mass(s.mass),
        si(s.shortest_edge.0, "m"),
        s.shortest_edge.1,
        grouped(s.near_pairs as u64),
    );
    if let Some((depth, [a, b])) = &s.deepest_overlap {
        text.push_str(&format!(
            ", deepest overlap {} between {a} and {b}",
            si(*depth, "m")
        ));
    }
    text.push('\n');
    if !s.slivers.is_empty() {
        text.push_str(&format!(
            "  slivers    {} (see the warnings)\n",
            s.slivers.len()
        ));
    }
    text
}

fn mass(kilograms: f64) -> String {
    if kilograms >= 1000.0 {
        format!("{} t/m", ratio(kilograms / 1000.0))
    } else {
        format!("{} kg/m", ratio(kilograms))
    }
}

fn expected_text(f: &Forecast) -> String {
    let mut text = format!("  time step  {}", si(f.time_step, "s"));
    if let (Some(stable), Some(share)) = (f.stable_time_step, f.share_of_stable) {
        text.push_str(&format!(
            " = {} % of the stable {}",
            ratio(100.0 * share),
            si(stable, "s")
        ));
    }
    if let Some(block) = &f.governing_block {
        text.push_str(&format!(", set by block {block}"));
    }
    text.push('\n');
    if let Some((block, speed)) = &f.fastest {
        let guard = if f.guard_shortens {
            "; so fast that the first steps are shortened against tunnelling"
        } else {
            ""
        };
        text.push_str(&format!(
            "  fastest    {} (block {block}){guard}\n",
            si(*speed, "m/s")
        ));
    }
    let steps = f.steps.map_or("as many steps as it takes".to_owned(), |n| {
        format!("{} steps", grouped(n))
    });
    let time = f
        .wall_time
        .map_or(String::new(), |s| format!(", about {}", duration(s)));
    text.push_str(&format!(
        "  expected   {steps}{time} at {} steps/s on one thread\n",
        grouped(f.steps_per_second as u64)
    ));
    text
}
