//! `cargo run --profile ci -p riprap-fuzz -- [--target NAME] [--tries N] [--seed K] [--last FILE] [FILE ...]`: fuzzing on a stable toolchain.
//!
//! `--last` writes each input to a file before it is tried, so that one that ends the process is there afterwards (half a gigabyte of memory is all that the process gets).
//! With files, tries these. Otherwise tries N damaged inputs (a million) of each target, or of one, and prints a table. Exit code 1 if anything failed.

use std::process::ExitCode;
use std::time::Instant;

use riprap_fuzz::{Outcome, TARGETS, Target, attempt, bound_memory, campaign_after, seeds, target};

struct Asked {
    targets: Vec<&'static Target>,
    tries: Option<u64>,
    seed: u64,
    last: Option<String>,
    files: Vec<String>,
}

fn asked() -> Result<Asked, String> {
    let mut asked = Asked {
        targets: TARGETS.iter().collect(),
        tries: None,
        seed: 1,
        last: None,
        files: Vec::new(),
    };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        let mut value = || words.next().ok_or(format!("{word} wants a value"));
        let number = |text: String| text.parse().map_err(|_| format!("{text} is no whole number"));
        match word.as_str() {
            "--target" => {
                let name = value()?;
                let known: Vec<&str> = TARGETS.iter().map(|t| t.name).collect();
                let found = target(&name)
                    .ok_or(format!("no target is called {name}; there are {}", known.join(", ")))?;
                asked.targets = vec![found];
            }
            "--tries" => asked.tries = Some(number(value()?)?),
            "--last" => asked.last = Some(value()?),
            "--seed" => asked.seed = number(value()?)?,
            _ => asked.files.push(word),
        }
    }
    if !asked.files.is_empty() && asked.targets.len() > 1 {
        return Err("--target says which target the files are for".to_owned());
    }
    Ok(asked)
}

fn main() -> ExitCode {
    let asked = match asked() {
        Ok(asked) => asked,
        Err(why) => {
            eprintln!("{why}");
            return ExitCode::from(2);
        }
    };
    if let Err(why) = bound_memory() {
        eprintln!("{why}");
        return ExitCode::FAILURE;
    }
    let mut sound = true;
    if asked.files.is_empty() {
        println!("| target | tries | taken | failures | s |\n|---|---|---|---|---|");
        for target in &asked.targets {
            sound &= try_target(target, &asked);
        }
    } else {
        for file in &asked.files {
            sound &= try_file(asked.targets[0], file);
        }
    }
    ExitCode::from(u8::from(!sound))
}

fn try_target(target: &Target, asked: &Asked) -> bool {
    let seeds = match seeds(target) {
        Ok(seeds) => seeds,
        Err(error) => {
            eprintln!("corpus/{}: {error}", target.name);
            return false;
        }
    };
    let begin = Instant::now();
    let mut unwritten = None;
    let tally =
        campaign_after(target, &seeds, asked.seed, asked.tries.unwrap_or(1_000_000), |input| {
            if let Some(last) = &asked.last {
                unwritten = std::fs::write(last, input).err();
            }
        });
    if let Some(error) = unwritten {
        eprintln!("--last: {error}");
    }
    println!(
        "| {} | {} | {} | {} | {:.0} |",
        target.name,
        tally.tries,
        tally.taken,
        tally.failures.len(),
        begin.elapsed().as_secs_f64()
    );
    for (place, why) in &tally.failures {
        eprintln!("{}: {why}", place.display());
    }
    tally.failures.is_empty()
}

fn try_file(target: &Target, file: &str) -> bool {
    match std::fs::read(file) {
        Ok(bytes) => {
            let outcome = attempt(target, &bytes);
            println!("{file}: {outcome:?}");
            !matches!(outcome, Outcome::Failed(_))
        }
        Err(error) => {
            eprintln!("{file}: {error}");
            false
        }
    }
}
