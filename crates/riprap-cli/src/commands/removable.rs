//! `riprap removable`: removable blocks and key blocks.

use riprap::exec::Exec;
use riprap::record::folder::Existing;
use riprap::run::removable::{Answer, Block, Kind, RemovableError, Rules, removable};

use crate::args::Removable;
use crate::commands::answer as say;
use crate::diagnostics::Style;
use crate::failure::Failure;
use crate::numbers::{ratio, si};
use crate::{scenes, screen};

/// `riprap removable`.
pub fn run(args: &Removable, style: Style) -> Result<(), Failure> {
    let prepared = scenes::prepare(&args.scene, style, args.json)?;
    let scene = prepared.parsed.clone();
    let job = prepared.job();
    let failure = |error| match error {
        RemovableError::Planar | RemovableError::Phase { .. } | RemovableError::Factor => {
            Failure::Input(error.to_string())
        }
        RemovableError::Build(_) | RemovableError::Run(_) => Failure::Physics(error.to_string()),
        RemovableError::Picture(error) => Failure::of_job(*error, &scene),
    };
    let rules = Rules { factor: args.factor, rounds: args.rounds, phase: args.phase.clone() };
    let (setup, plan) = (job.setup.clone(), job.plan.clone());
    let answer = removable(setup, plan, &rules, Exec::serial()).map_err(failure)?;
    if let Some(folder) = &args.picture {
        let existing = if args.force { Existing::Force } else { Existing::Refuse };
        answer.show(job, folder, existing).map_err(failure)?;
    }
    let json = args.json.then(|| serde_json::json!(answer));
    let csv = || answer.table().map_err(|e| e.to_string());
    say(json, args.out.as_deref(), csv, || {
        let listed: Vec<&Block> =
            answer.blocks.iter().filter(|block| args.all || block.kind != Kind::Tapered).collect();
        let rows = if listed.is_empty() {
            String::new()
        } else {
            table(&answer, &listed, args.rounds > 1)
        };
        rows + &answer.words()
    })
}

/// A row a block.
fn table(answer: &Answer, listed: &[&Block], rounds: bool) -> String {
    let force = format!("force for F = {}", answer.factor);
    let mut heads = vec!["block", "type", "", "volume", "F", &force, "pressure", "motion"];
    if rounds {
        heads.insert(1, "round");
    }
    let rows = listed.iter().map(|block| {
        let supported = block.support_force > 0.0;
        let pressure = block.support_pressure.filter(|_| supported);
        let mut row = vec![
            block.name.clone(),
            block.kind.number().to_owned(),
            block.kind.word().to_owned(),
            format!("{} m3", ratio(block.volume)),
            if block.factor_of_safety.is_finite() {
                ratio(block.factor_of_safety)
            } else {
                "-".to_owned()
            },
            if supported { si(block.support_force, "N") } else { "-".to_owned() },
            pressure.map_or_else(|| "-".to_owned(), |p| si(p, "Pa")),
            block.way(),
        ];
        if rounds {
            row.insert(1, block.round.to_string());
        }
        row
    });
    screen::table(&heads, rows)
}
