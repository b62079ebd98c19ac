//! `riprap sweep` and `riprap monte-carlo`: all cases of a scene, at once or in parts.

use std::path::{Path, PathBuf};

use riprap::plot::{self, PlotError, Sampled, Tornado};
use riprap::record::folder::Existing;
use riprap::run::scene::Scene;
use riprap::run::study::Executor;
use riprap::run::study::monte_carlo::{self, Failure as Failures, Outcome, SUMMARY, Summary};
use riprap::run::study::sweep::{self, Part, Row};
use riprap::scenario::Case;

use crate::args::Cases;
use crate::commands::run::target;
use crate::commands::trials::make_folder;
use crate::commands::{default_folder, threads};
use crate::diagnostics::print_line;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::numbers::grouped;
use crate::{scenes, screen};

/// `riprap sweep`.
pub fn sweep(args: &Cases) -> Result<(), Failure> {
    let (mut scene, case) = scenes::chosen(&args.scene)?;
    if args.scene.change.case.is_some() {
        scene.cases = vec![case];
    }
    // A slip in the last case is reported now, not when all others have been run. A part leaves those of others to them.
    let here = Scene { cases: of_part(args, &scene.cases), ..scene.clone() };
    sweep::check_all(&here)?;
    let done = run(args, &here, "sweep")?;
    report(args, &scene, &done, || {})
}

/// `riprap monte-carlo`.
pub fn monte_carlo(args: &Cases) -> Result<(), Failure> {
    let (scene, case) = scenes::chosen(&args.scene)?;
    let scene = monte_carlo::sampled(&scene, &case)?;
    let here = Scene { cases: of_part(args, &scene.cases), ..scene.clone() };
    let done = run(args, &here, "monte-carlo")?;
    if args.part.is_some() || done.stopped {
        return report(args, &scene, &done, || {});
    }
    let summary = Summary::of(&scene, &done.rows);
    summary.write(&done.folder).map_err(|wrong| Failure::Output(wrong.to_string()))?;
    let pictures = pictures(&scene, &done, &summary)?;
    report(args, &scene, &done, || {
        screen::print(&words(&summary));
        for path in std::iter::once(&done.folder.join(SUMMARY)).chain(&pictures) {
            screen::line(&path.display().to_string());
        }
    })
}

/// Histograms of the results, and what they depend on; none where no sample has finished.
fn pictures(scene: &Scene, done: &Done, summary: &Summary) -> Result<Vec<PathBuf>, Failure> {
    let last = |row: &Row, name: &str| row.last.iter().find(|(of, _)| of == name).map(|of| of.1);
    let sampled: Vec<Sampled> = summary
        .results
        .iter()
        .map(|of| Sampled {
            name: of.spread.name.clone(),
            unit: String::new(),
            values: done.rows.iter().filter_map(|row| last(row, &of.spread.name)).collect(),
        })
        .collect();
    let causes = summary.variables.iter().map(|of| of.name.clone());
    let tornados: Vec<Tornado> = summary
        .results
        .iter()
        .map(|of| Tornado {
            name: of.spread.name.clone(),
            mean: of.spread.mean,
            swings: causes.clone().zip(of.swing.iter().copied()).collect(),
        })
        .collect();
    let title = &scene.parsed.scenario.title;
    let drawn = [
        plot::histograms(title, &sampled, &done.folder.join("histograms.svg")),
        plot::tornado(title, &tornados, &done.folder.join("tornado.svg")),
    ];
    let mut files = Vec::new();
    for picture in drawn {
        match picture {
            Ok(made) => files.extend(made.into_iter().filter(|path| is_picture(path))),
            Err(PlotError::NothingToDraw { .. }) => {}
            Err(wrong) => return Err(Failure::Output(wrong.to_string())),
        }
    }
    Ok(files)
}

fn is_picture(path: &Path) -> bool {
    path.extension().is_some_and(|end| end == "svg")
}

/// The cases that are run here.
fn of_part(args: &Cases, cases: &[Case]) -> Vec<Case> {
    args.part.map_or_else(|| cases.to_vec(), |part| part.of(cases))
}

/// What has been run.
struct Done {
    folder: PathBuf,
    rows: Vec<Row>,
    /// The table, where one was made.
    table: Option<String>,
    stopped: bool,
}

/// Runs the cases of `scene`, or collects what parts have run.
fn run(args: &Cases, scene: &Scene, kind: &str) -> Result<Done, Failure> {
    let shared = args.part.is_some() || args.merge;
    let (folder, existing) = match &args.out {
        // All parts write into one folder, which they must find without each other.
        None if shared => (default_folder(&args.scene.file, kind), existing(args)),
        out => target(out.as_deref(), &args.scene.file, kind, args.force),
    };
    let write = |rows: &[Row], earlier: Option<&str>| {
        sweep::write_table(rows, earlier, &folder)
            .map_err(|wrong| Failure::Output(wrong.to_string()))
    };
    if args.merge {
        if !folder.is_dir() {
            return Err(Failure::Input(format!(
                "{} does not exist; name the folder of the parts with --out",
                folder.display()
            )));
        }
        let rows = sweep::merged(scene, &folder)?;
        let table = Some(write(&rows, None)?);
        return Ok(Done { folder, rows, table, stopped: false });
    }
    let earlier = sweep::earlier(&folder, existing);
    // Also where it was killed before it could write its table.
    let begun = |case: &Case| folder.join(&case.name).join("manifest.json").is_file();
    let again = existing == Existing::Refuse && scene.cases.iter().any(begun);
    if earlier.is_none() && !again {
        prepare_folder(&folder, existing, args.part)?;
    }
    if existing == Existing::Refuse
        && let Some(other) = sweep::other_run(scene, &folder)?
    {
        return Err(Failure::Input(format!(
            "{} contains a run of another input or program; choose another folder, or replace it with --force",
            other.display()
        )));
    }
    let interrupt = Interrupt::listen()?;
    let (count, mut rows) = (scene.cases.len(), Vec::new());
    let executor = Executor { threads: threads(&args.how), stop: &|| interrupt.asked() };
    sweep::sweep(scene, &folder, existing, &executor, |row: Row| {
        if !args.how.quiet {
            let (n, case, steps) = (rows.len() + 1, &row.case, grouped(row.steps));
            let kept = if row.kept { ", kept" } else { "" };
            screen::line(&format!("{n}/{count}  {case}: {}, {steps} steps{kept}", row.ended));
        }
        rows.push(row);
    });
    let table = match args.part {
        None => Some(write(&rows, earlier.as_deref())?),
        Some(_) => None,
    };
    Ok(Done { folder, rows, table, stopped: interrupt.asked() })
}

fn existing(args: &Cases) -> Existing {
    if args.force { Existing::Force } else { Existing::Refuse }
}

/// Makes the folder. Parts share it: another one may have made it, and have runs in it.
fn prepare_folder(folder: &Path, existing: Existing, part: Option<Part>) -> Result<(), Failure> {
    match part {
        None => make_folder(folder, existing),
        Some(_) => std::fs::create_dir_all(folder)
            .map_err(|e| Failure::Output(format!("could not create {}: {e}", folder.display()))),
    }
}

/// Prints what has been run, `summary` between table and checks, and says how it ended.
fn report(args: &Cases, scene: &Scene, done: &Done, summary: impl Fn()) -> Result<(), Failure> {
    let (asks, rows) = (scene.asks.as_ref(), &done.rows);
    let (tally, path) = (sweep::tally(rows, asks), done.folder.join(sweep::TABLE));
    if let (false, Some(table)) = (args.how.quiet, &done.table) {
        // Hundreds of rows help nobody on a screen.
        if asks.is_none() && scene.parsed.scenario.distributions.is_empty() {
            screen::line(&format!("\n{}", table.trim_end()));
        }
        summary();
        screen::line(&format!("{}\nchecks: {tally}", path.display()));
    }
    if let (false, Some(part)) = (args.how.quiet, args.part) {
        let (count, Part { number, of }) = (rows.len(), part);
        screen::line(&format!(
            "part {number} of {of}: {count} of {} cases in {}; --merge makes the table of all parts",
            scene.cases.len(),
            done.folder.display()
        ));
    }
    if let Some(row) = rows.iter().find(|row| !row.warnings.is_empty()) {
        let (count, all) = (rows.iter().filter(|row| !row.warnings.is_empty()).count(), rows.len());
        let (case, first) = (&row.case, &row.warnings[0]);
        print_line(
            "warning",
            &format!("{count} of {all} cases ran with warnings; {case}: {first}"),
        );
    }
    if let Some(row) = rows.iter().find(|row| row.unwritten) {
        return Err(Failure::Output(row.ended.clone()));
    }
    if done.stopped {
        return Err(Failure::Interrupted(format!(
            "completed cases are in {}",
            done.folder.display()
        )));
    }
    if let Some(row) = rows.iter().find(|row| !row.finished) {
        let missing = rows.iter().filter(|row| !row.finished).count();
        let more = if missing > 1 { format!(" (and {} more)", missing - 1) } else { String::new() };
        return Err(Failure::Physics(format!("case {}: {}{more}", row.case, row.ended)));
    }
    if tally.failed > 0 { Err(Failure::Checks) } else { Ok(()) }
}

/// The numbers of a Monte Carlo study, for reading.
fn words(summary: &Summary) -> String {
    let mut text = String::from("\n");
    let (all, finished) = (summary.samples, summary.finished);
    match &summary.failure {
        Some(Failures { failed, probability, interval: [low, high], .. }) => {
            let [p, low, high] = [*probability, *low, *high].map(percent);
            text.push_str(&format!(
                "{failed} of {finished} samples fail: probability of failure {p} (95 %: {low} to {high})\n"
            ));
        }
        None => text.push_str(&format!("{finished} samples\n")),
    }
    if finished < all {
        text.push_str(&format!(
            "{} of {all} samples did not finish and are not counted\n",
            all - finished
        ));
    }
    let failure = summary.failure.as_ref();
    let influence = |k: usize| match failure.map(|of| of.influence[k]) {
        Some(Some(of)) => format!("{of:+.2}"),
        Some(None) | None => "-".to_owned(),
    };
    let spread = |of: &monte_carlo::Spread| {
        let name = match &of.unit[..] {
            "" => of.name.clone(),
            unit => format!("{} [{unit}]", of.name),
        };
        let [low, middle, high] = of.quantiles;
        let numbers =
            [of.mean, of.deviation, low, middle, high].map(|value| format!("{value:.4e}"));
        std::iter::once(name).chain(numbers).collect::<Vec<String>>()
    };
    let heads = ["", "mean", "deviation", "5 %", "50 %", "95 %"];
    let rows = summary.variables.iter().enumerate().map(|(k, of)| {
        let mut row = spread(of);
        row.push(influence(k));
        row
    });
    let with_failure = [&heads[..], &["correlation with failure"]].concat();
    text.push_str(&screen::table(&with_failure, rows));
    if !summary.results.is_empty() {
        text.push('\n');
        let strongest = |of: &Outcome| {
            let known = of.influence.iter().enumerate().filter_map(|(k, r)| Some((k, (*r)?)));
            let largest = known.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
            largest.map_or("-".to_owned(), |(k, r)| {
                let key = &summary.variables[k].name;
                format!("{} ({r:+.2})", key.rsplit('.').next().unwrap_or(key))
            })
        };
        let rows = summary.results.iter().map(|of| {
            let mut row = spread(&of.spread);
            row.push(strongest(of));
            row
        });
        let with_cause = [&heads[..], &["depends most on"]].concat();
        text.push_str(&screen::table(&with_cause, rows));
    }
    text.push('\n');
    text
}

/// `7.4 %`.
fn percent(share: f64) -> String {
    let digits = if share > 0.0995 { 1 } else { 2 };
    format!("{:.digits$} %", 100.0 * share)
}
