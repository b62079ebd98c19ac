//! `riprap run` and `riprap resume`.

use std::path::{Path, PathBuf};

use riprap::model::Setup;
use riprap::record::folder::{Existing, in_use};
use riprap::record::manifest::{Manifest, Work};
use riprap::record::table::Table;
use riprap::record::{RunFolder, checkpoint};
use riprap::run::drive::{Control, Ending, Look};
use riprap::run::job::{Outcome, Sent};
use riprap::run::simulation::PhaseEnd;
use riprap::run::study::Executor;
use riprap::run::study::trust::Question;

use crate::args::{Resume, Run};
use crate::commands::check::imports_text;
use crate::commands::ranks::Crew;
use crate::commands::trust::{self, Told};
use crate::commands::{check_lines, default_folder, run_folder, threads};
use crate::diagnostics::{Style, print_line};
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::numbers::{counted, duration, grouped, ratio, si};
use crate::progress::Display;
use crate::{scenes, screen};

/// `riprap run`.
pub fn run(args: &Run, style: Style) -> Result<(), Failure> {
    let crew = Crew::of("run", &args.ranks, &args.how)?;
    let quiet = args.how.quiet || !crew.speaks();
    let errors = crew.end(trust::asked(&args.errors))?;
    if errors.is_some() && !crew.is_alone() {
        let text =
            "--trust makes many runs side by side on the threads of one process; leave --ranks out";
        return crew.end(Err(Failure::Input(text.to_owned())));
    }
    let (of, case) = crew.end(scenes::chosen(&args.scene))?;
    let change = &args.scene.change;
    let prepared = crew.end(scenes::prepare_case(&of, &case, change, style, quiet))?;
    if errors.is_some() {
        // Before a run that may take hours.
        crew.end(
            riprap::run::study::trust::has_results(&of, prepared.clone()).map_err(Failure::from),
        )?;
    }
    let (folder, existing) = target(args.out.as_deref(), &args.scene.file, "run", args.force);
    let summary = &prepared.model.summary;
    let near = match &prepared.model.setup {
        Setup::Planar(_) => format!(", {}", counted(summary.near_pairs, "near pair")),
        Setup::Spatial(_) => String::new(),
    };
    let head = format!(
        "riprap {}  {}: {}{near}, results in {}\n{}",
        env!("CARGO_PKG_VERSION"),
        prepared.parsed.scenario.title,
        counted(summary.blocks, "block"),
        folder.display(),
        imports_text(summary)
    );
    let head = head.trim_end().to_owned();
    let scene = prepared.parsed.clone();
    let job = prepared.job();
    let begun = folder.clone();
    let early = move || stopped_early(&begun);
    let show = crew.speaks().then_some(args.how.quiet);
    let (interrupt, ended) = with_display(show, &head, &folder, early, |look| {
        let done = crew.run(job, &folder, existing, look);
        crew.end(done.map_err(|error| Failure::of_job(error, &scene)))
    })?;
    // Checks that fail have errors too.
    let came = matches!(ended, Ok(()) | Err(Failure::Checks));
    if let (Some(errors), Some(interrupt), true) = (errors, interrupt, came) {
        let executor = Executor { threads: threads(&args.how), stop: &|| interrupt.asked() };
        let told = Told { quiet: args.how.quiet, json: false };
        trust::errors((&of, &case), Question::Results, &errors, &executor, (Some(&folder), told))?;
    }
    ended
}

/// What a run that is stopped before its first look leaves in `folder`, if it has come so far as to begin there.
fn stopped_early(folder: &Path) -> String {
    let shown = folder.display();
    let saved = || checkpoint::all(folder).is_ok_and(|all| !all.is_empty());
    match in_use(folder) {
        Some(true) if saved() => {
            format!("stopped before the first step; continue with: riprap resume {shown}")
        }
        Some(true) => format!(
            "stopped before the first step: nothing was computed, and {shown} can be reused"
        ),
        Some(false) | None => "stopped before the first step: nothing was computed".to_owned(),
    }
}

/// `riprap resume`.
pub fn resume(args: &Resume) -> Result<(), Failure> {
    let crew = Crew::of("resume", &args.ranks, &args.how)?;
    run_folder(&args.run, "resume")?;
    let head = format!("riprap {}  resuming {}", env!("CARGO_PKG_VERSION"), args.run.display());
    let early = || "stopped before any step: the run can still be resumed".to_owned();
    let show = crew.speaks().then_some(args.how.quiet);
    with_display(show, &head, &args.run, early, |look| {
        crew.end(crew.resume(&args.run, look).map_err(Failure::from))
    })?
    .1
}

/// Where results go, and what may be replaced there. Without `--out` a name that is not taken.
pub fn target(out: Option<&Path>, scene: &Path, kind: &str, force: bool) -> (PathBuf, Existing) {
    let existing = if force { Existing::Force } else { Existing::Refuse };
    let folder = match out {
        Some(out) => out.to_owned(),
        None if force => default_folder(scene, kind),
        None => RunFolder::free_name(&default_folder(scene, kind)),
    };
    (folder, existing)
}

/// Runs `work` with progress and Ctrl-C, and reports how it ended; `early` is said where it is stopped before its first look. `show`: whether
/// quietly; `None` for a rank that says nothing and leaves it to another one when to stop. Gives who asks to stop, and how it ended.
fn with_display(
    show: Option<bool>,
    head: &str,
    folder: &Path,
    early: impl Fn() -> String + Send + 'static,
    work: impl FnOnce(&mut dyn FnMut(&mut Look<'_>) -> Control) -> Result<Outcome, Failure>,
) -> Result<(Option<Interrupt>, Result<(), Failure>), Failure> {
    let Some(quiet) = show else {
        Interrupt::leave_to_another()?;
        return work(&mut |_| Control::Continue).map(|_| (None, Ok(())));
    };
    // Until the first step is done nothing is lost: building a large model takes longer than anybody waits after Ctrl-C.
    let interrupt = Interrupt::listen_from_begin(early)?;
    let mut display = Display::new(quiet);
    display.say(head);
    let outcome = work(&mut |look| {
        interrupt.begin();
        display.show(look);
        Control::stop_if(interrupt.asked())
    });
    display.close();
    Ok((Some(interrupt), finish(&outcome?, folder, quiet)))
}

/// Says how a run ended, where its results are and what to do next.
fn finish(outcome: &Outcome, folder: &Path, quiet: bool) -> Result<(), Failure> {
    let (manifest, shown) = (&outcome.manifest, folder.display());
    if !quiet {
        let (verb, to) = match outcome.ending {
            Ending::Finished => ("done:", "to"),
            Ending::Stopped => ("stopped after", "at"),
            Ending::Unstable(_) => ("aborted after", "at"),
        };
        screen::line(&format!(
            "{verb} {} steps {to} t = {} in {}",
            grouped(manifest.steps),
            si(manifest.time, "s"),
            duration(manifest.wall_time)
        ));
        screen::print(&ledger(outcome, folder));
        screen::print(&works(manifest));
        screen::print(&traffic(outcome));
        for end in outcome.ends.iter().filter(|end| end.quiet) {
            print_line("note", &phase_end(end));
        }
    }
    // Whoever asks for quiet wants warnings all the same.
    for note in &outcome.warnings {
        print_line("warning", note);
    }
    let tally = check_lines(&outcome.checks, quiet);
    match &outcome.ending {
        Ending::Finished => {}
        Ending::Stopped => {
            return Err(Failure::Interrupted(format!(
                "a checkpoint is in {shown}; continue with: riprap resume {shown}"
            )));
        }
        Ending::Unstable(why) => {
            let place = why
                .formula()
                .and_then(|text| line_of(folder, text))
                .map_or(String::new(), |line| {
                    format!("\n  line {line} of scenario.resolved.toml in the run folder")
                });
            return Err(Failure::Physics(format!(
                "{why}{place}\n  results up to this point: {shown}"
            )));
        }
    }
    if !quiet {
        screen::print(&format!(
            "\nresults in {shown}; next:\n  riprap view {shown}\n  riprap plot {shown}\n  riprap plot {shown} blocks --by velocity --png\n  \
             paraview {shown}/run.pvd\n"
        ));
    }
    if tally.failed > 0 { Err(Failure::Checks) } else { Ok(()) }
}

/// Line of the resolved scene that holds a formula.
fn line_of(folder: &Path, formula: &str) -> Option<usize> {
    let scene = riprap::record::read_plain_text(&folder.join("scenario.resolved.toml")).ok()?;
    let at = scene.lines().position(|line| line.contains(formula))?;
    Some(at + 1)
}

/// Why a static phase has ended.
fn phase_end(end: &PhaseEnd) -> String {
    let asked = end.wanted.map_or(String::new(), |wanted| format!(", limit {}", ratio(wanted)));
    format!(
        "phase {:?} ended: {} (unbalanced {}{asked})",
        end.phase,
        end.words(),
        ratio(end.unbalanced)
    )
}

/// What boundaries, supports and loads have done, a line each, where it was more than one.
fn works(manifest: &Manifest) -> String {
    let some: Vec<&Work> = manifest.works.iter().filter(|w| w.work != 0.0).collect();
    let line = |w: &&Work| format!("work of {} {}: {}\n", w.of, w.name, si(w.work, &w.unit));
    match some.len() {
        0 | 1 => String::new(),
        _ => some.iter().map(line).collect(),
    }
}

/// What the ranks have sent each other.
fn traffic(outcome: &Outcome) -> String {
    let Some(Sent { traffic: sent, steps, wall_time: wall }) = outcome.sent else {
        return String::new();
    };
    let steps = steps.max(1);
    let waited = if wall > 0.0 { 100.0 * sent.waiting.as_secs_f64() / wall } else { 0.0 };
    format!(
        "ranks: {}; rank 0 sent {} messages and {} a step and waited {} % of the time\n",
        sent.ranks,
        ratio(sent.messages as f64 / steps as f64),
        si(sent.bytes as f64 / steps as f64, "B"),
        ratio(waited)
    )
}

/// A term of the ledger below this share of the largest that any of them has been is round-off.
const ROUND_OFF: f64 = 1e-13;

/// The energies at the end, one line, with the residual; what is round-off of the largest that has moved is left out. Of a run that
/// has not come to its end with the time that they are of.
fn ledger(outcome: &Outcome, folder: &Path) -> String {
    let Ok(table) = Table::read(&folder.join("energy.csv")) else {
        return String::new();
    };
    let columns = || (table.columns.iter()).filter(|c| c.name != "step" && c.name != "time");
    let last = |name: &str| {
        let column = table.columns.iter().find(|c| c.name == name);
        column.and_then(|c| c.values.last().copied())
    };
    let (time, terms): (Option<f64>, Vec<(&str, &str, f64)>) = match &outcome.energies {
        Some(now) => {
            let terms = now.terms.iter().map(|(name, v)| (*name, now.unit, *v));
            (Some(now.time), terms.collect())
        }
        None => {
            let terms =
                columns().filter_map(|c| Some((&c.name[..], &c.unit[..], *c.values.last()?)));
            (last("time"), terms.collect())
        }
    };
    let written = columns().flat_map(|c| c.values.iter().copied());
    let all = written.chain(terms.iter().map(|(_, _, value)| *value));
    let round_off = ROUND_OFF * all.fold(0.0_f64, |most, value| most.max(value.abs()));
    let terms: Vec<String> = terms
        .into_iter()
        .map(|(name, unit, v)| (name, unit, if v.abs() > round_off { v } else { 0.0 }))
        .filter(|(name, _, value)| *value != 0.0 || *name == "residual")
        .map(|(name, unit, value)| format!("{} {}", name.replace('_', " "), si(value, unit)))
        .collect();
    let at = match (&outcome.ending, time) {
        (Ending::Stopped | Ending::Unstable(_), Some(time)) => format!(" at t = {}", si(time, "s")),
        (Ending::Finished, _) | (_, None) => String::new(),
    };
    format!("energy{at}: {}\n", terms.join(", "))
}
