//! What the user typed, and nothing else: one struct a verb, with the help texts.
//!
//! Doc comments here are the `--help` texts. They are read aloud before they are committed.

mod blocks;
mod muckpile;
mod plot;
mod runout;
mod search;
mod shell;
mod shot;
mod strength;
mod view;

pub use blocks::{ProbeContact, Removable, Sizes};
pub use muckpile::Muckpile;
pub use plot::Plot;
pub use runout::Runout;
pub use search::{Bisect, Safety};
pub use shell::{Completions, Man};
pub use shot::{ContactPoints, Shot, TrailColour};
pub use strength::Strength;
pub use view::{Paraview, Report, View};

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};

/// Version, commit and target of this program. Changes that are not committed do not show.
pub const VERSION: &str = concat!(
    env!("CARGO_PKG_VERSION"),
    " (commit ",
    env!("RIPRAP_COMMIT"),
    ", ",
    env!("RIPRAP_TARGET"),
    ")"
);

const FIRST_STEPS: &str = "\
First steps:
  riprap new hill --template slope       write a scene to start from
  riprap check hill.toml                 check it without running it
  riprap run hill.toml                   run it; results go to hill.run/
  riprap view hill.run                   watch it in the browser
  riprap plot hill.run                   draw what happened

Exit codes:
  0  done
  1  the physics stopped the run, or a check failed
  2  bad input
  3  could not write the results
  130  stopped by Ctrl-C, with a checkpoint";

/// Discrete-element simulation of blocky rock.
///
/// A scene is a TOML file: blocks, interfaces, loads and what to record. Every
/// quantity has its unit, and a scene can check its own results.
#[derive(Debug, Parser)]
#[command(name = "riprap", version = VERSION, after_help = FIRST_STEPS, arg_required_else_help = true)]
#[command(disable_help_subcommand = true, max_term_width = 100)]
pub struct Cli {
    /// Colours in messages and progress lines
    #[arg(long, global = true, value_enum, default_value_t = ColorChoice::Auto, value_name = "WHEN")]
    pub color: ColorChoice,
    #[command(subcommand)]
    pub verb: Verb,
}

/// When to colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ColorChoice {
    /// On a terminal, unless NO_COLOR is set
    Auto,
    Always,
    Never,
}

/// The verbs.
#[derive(Debug, Subcommand)]
pub enum Verb {
    New(New),
    Check(Check),
    Run(Run),
    Resume(Resume),
    Sweep(Sweep),
    MonteCarlo(MonteCarlo),
    Bisect(Bisect),
    Safety(Safety),
    Trust(Trust),
    Removable(Removable),
    Sizes(Sizes),
    Runout(Runout),
    Muckpile(Muckpile),
    Strength(Strength),
    Compare(Compare),
    ProbeContact(ProbeContact),
    Verify(Verify),
    Plot(Plot),
    Shot(Shot),
    View(View),
    Report(Report),
    Paraview(Paraview),
    Fields(Fields),
    Explain(Explain),
    Schema(Schema),
    Hash(Hash),
    Doctor(Doctor),
    SelfTest(SelfTest),
    Completions(Completions),
    Man(Man),
}

/// A scene file, and what is changed in it before it is read.
#[derive(Debug, Args)]
pub struct Scene {
    /// Scene to read (TOML)
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    #[command(flatten)]
    pub change: Change,
}

/// What is changed in a scene before it is read.
#[derive(Clone, Debug, Default, Args)]
pub struct Change {
    /// Set a key of the scene; repeatable. Quantities need their units
    ///
    /// Keys are paths with dots; entries of lists are given by number or name.
    /// Examples:
    ///   --set 'interfaces.default.friction_angle=20 deg'
    ///   --set blocks.slope.shift.0='1 m'
    #[arg(long = "set", value_name = "KEY=VALUE", verbatim_doc_comment, value_parser = key_value)]
    pub set: Vec<(String, String)>,
    /// Select one case of the scene: a variant, or values of its sweep; an unknown name lists them
    #[arg(long, value_name = "NAME")]
    pub case: Option<String>,
}

/// What `riprap new NAME` writes.
pub const DEFAULT_TEMPLATE: &str = "slide";

/// Write a scene to start from.
///
/// The templates are complete scenes of the library, ready to run.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap new --list
  riprap new hill --template slope       writes hill.toml")]
pub struct New {
    /// Name of the new scene; `.toml` is added
    #[arg(value_name = "NAME", required_unless_present = "list")]
    pub name: Option<String>,
    /// Template to start from; see --list
    #[arg(short, long, value_name = "TEMPLATE", default_value = DEFAULT_TEMPLATE)]
    pub template: String,
    /// List the templates
    #[arg(short, long)]
    pub list: bool,
    /// Replace an existing file
    #[arg(long)]
    pub force: bool,
}

/// Check a scene without running it.
///
/// Checks syntax, units, names and geometry, and reports what to expect: blocks, contacts,
/// slivers, overlaps, the stable time step and the block that governs it, steps and time of the run.
/// Exits with code 2 when the scene cannot run.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap check hill.toml
  riprap check hill.toml --set 'phases.0.time_step=1 ms'
  riprap check hill.toml --json | jq .stable_time_step")]
pub struct Check {
    #[command(flatten)]
    pub scene: Scene,
    /// Print the findings as JSON
    #[arg(long)]
    pub json: bool,
    /// Report how N ranks would share the model out, and what they would send each other
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000), allow_negative_numbers = true)]
    pub ranks: Option<u32>,
}

/// Run a scene.
///
/// Results go to a run folder: histories and energies as CSV, frames for ParaView, checkpoints,
/// and a manifest that records how it ended. Ctrl-C stops at the next step and writes a checkpoint;
/// Ctrl-C again quits at once.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap run hill.toml
  riprap run hill.toml --out try1 --threads 2
  riprap run hill.toml --set 'interfaces.default.friction_angle=20 deg' --out phi20")]
pub struct Run {
    #[command(flatten)]
    pub scene: Scene,
    #[command(flatten)]
    pub how: How,
    #[command(flatten)]
    pub ranks: Ranks,
    /// Folder for the results [default: the scene's name with .run, in the working folder]
    #[arg(short, long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Replace existing results
    #[arg(long)]
    pub force: bool,
    #[command(flatten)]
    pub errors: Errors,
}

/// The error of what a command finds.
#[derive(Debug, Args)]
pub struct Errors {
    /// Then give each result its error, by runs with one thing changed at a time in so much wall time (see `riprap trust`)
    #[arg(long, value_name = "TIME", num_args = 0..=1, require_equals = true, default_missing_value = "10min", allow_hyphen_values = true)]
    pub trust: Option<String>,
    /// Causes to leave out with --trust, separated by commas
    #[arg(long, value_name = "CAUSES", requires = "trust", value_delimiter = ',', value_parser = riprap::run::study::trust::Cause::read)]
    pub without: Vec<riprap::run::study::trust::Cause>,
}

/// How to compute; never what.
#[derive(Debug, Args)]
pub struct How {
    /// Threads; the results are bitwise identical for any number [default: all cores]
    #[arg(short = 'j', long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..), allow_negative_numbers = true)]
    pub threads: Option<u16>,
    /// No progress output, only warnings and errors
    #[arg(short, long)]
    pub quiet: bool,
}

/// Ranks that compute one run together.
#[derive(Debug, Args)]
pub struct Ranks {
    /// Compute as N ranks, threads of this process: the results are bitwise identical for any number. To try out how a
    /// model is shared out; on one machine --threads is faster
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024), allow_negative_numbers = true)]
    pub ranks: Option<u16>,
}

/// Resume a stopped run.
///
/// Continues from the last valid checkpoint in the run folder. The result is bitwise identical
/// to that of an uninterrupted run. A run that has already ended is not changed.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  riprap resume hill.run")]
pub struct Resume {
    /// Run folder
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
    #[command(flatten)]
    pub how: How,
    #[command(flatten)]
    pub ranks: Ranks,
}

/// Run a scene over the values of its [sweep].
///
/// Each combination has its own subfolder; `sweep.csv` has one row per combination.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap sweep slide.toml --out friction
  riprap sweep slide.toml --part 3/20    one job of an array; then --merge

The scene says what to vary:
  [sweep]
  \"interfaces.default.friction_angle\" = [\"0 deg\", \"15 deg\", \"30 deg\"]")]
pub struct Sweep {
    #[command(flatten)]
    pub cases: Cases,
}

/// Run random samples of a scene: probability of failure, influences.
///
/// Each sample has its own subfolder; `sweep.csv` has one row per sample, `monte_carlo.json` the numbers of all.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap monte-carlo wedge.toml
  riprap monte-carlo wedge.toml --part 3/20    one job of an array; then --merge

The scene says what is random and what fails:
  [distributions]
  \"interfaces.default.friction_angle\" = { normal = { mean = \"35 deg\", deviation = \"2 deg\" } }
  [monte_carlo]
  samples = 500
  fails_when = { field = \"model.max_displacement\", above = \"0.1 m\" }")]
pub struct MonteCarlo {
    #[command(flatten)]
    pub cases: Cases,
}

/// Many cases of a scene.
#[derive(Debug, Args)]
pub struct Cases {
    #[command(flatten)]
    pub scene: Scene,
    #[command(flatten)]
    pub how: How,
    /// Folder for the results [default: the scene's name with .sweep or .monte-carlo, in the working folder]
    #[arg(short, long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Replace existing results
    #[arg(long)]
    pub force: bool,
    /// Run only this part of the cases (`3/20`: the third of 20), for arrays of jobs that share the folder
    #[arg(long, value_name = "K/N", value_parser = riprap::run::study::sweep::Part::read)]
    pub part: Option<riprap::run::study::sweep::Part>,
    /// Run nothing: make the table of what all parts have run
    #[arg(long, conflicts_with_all = ["part", "force"])]
    pub merge: bool,
}

/// Estimate the error of each named result of a scene, and the share of each cause.
///
/// Results are the checks of the scene and the last values of its histories. The scene is run as it stands, then with one thing changed at a
/// time: time step, limit of equilibrium, stiffness of contacts, damping, size of generated cells, seed. Where an order is seen in the
/// time step or the size, the value is extrapolated; chaotic results are given as distributions. The output says which key to change
/// to halve the error. Tables of results and runs and a picture go into a folder.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap trust slope.toml
  riprap trust slope.toml --budget 30min --without stiffness,damping

Leave out what is not in doubt, for example a stiffness or a damping that was measured. Causes: step, equilibrium, stiffness, damping, size, seed.")]
pub struct Trust {
    #[command(flatten)]
    pub scene: Scene,
    #[command(flatten)]
    pub how: How,
    /// Wall time for all runs: what is forecast to take longer is left out, and reported
    #[arg(long, value_name = "TIME", default_value = "10min", allow_hyphen_values = true)]
    pub budget: String,
    /// Causes to leave out, separated by commas
    #[arg(long, value_name = "CAUSES", value_delimiter = ',', value_parser = riprap::run::study::trust::Cause::read)]
    pub without: Vec<riprap::run::study::trust::Cause>,
    /// Folder for the results [default: the scene's name with .trust, in the working folder]
    #[arg(short, long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Replace existing results
    #[arg(long)]
    pub force: bool,
    /// Print each run and the answer as JSON lines
    #[arg(long)]
    pub json: bool,
}

/// Run a scene with both normal laws and show the difference.
///
/// Two independent contact laws on one model are a cross-check: where they agree, the law does not
/// matter; where they differ, examine the contact.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  riprap compare topple.toml")]
pub struct Compare {
    #[command(flatten)]
    pub scene: Scene,
    #[command(flatten)]
    pub how: How,
    /// Folder for the results [default: the scene's name with .compare, in the working folder]
    #[arg(short, long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Replace existing results
    #[arg(long)]
    pub force: bool,
}

/// Run scenes and evaluate their checks.
///
/// Prints one line per check and a summary `N passed, N failed, N skipped`. Skipped are checks
/// that the scene marks as known failures: they are run and shown with their reason. Exits with
/// code 1 when a check failed, 2 when a scene cannot be read or none has checks.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap verify scenes/verify/planar
  riprap verify slide.toml --strict")]
pub struct Verify {
    /// Scenes, or folders with scenes
    #[arg(value_name = "PATH", required_unless_present = "shipped")]
    pub paths: Vec<PathBuf>,
    /// Scenes that are in the program: the name of a file or folder under scenes/, or all; repeatable
    #[arg(long, value_name = "NAME")]
    pub shipped: Vec<String>,
    /// Set a key of each scene, as for `riprap run`; repeatable
    #[arg(long, value_name = "KEY=VALUE", value_parser = key_value)]
    pub set: Vec<(String, String)>,
    /// Count known failures as failed
    #[arg(long)]
    pub strict: bool,
    /// Scenes to run in parallel [default: all cores]
    #[arg(short, long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..), allow_negative_numbers = true)]
    pub jobs: Option<u16>,
    /// Print one JSON object per check
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub errors: Errors,
}

/// List the fields available in histories, checks and frames.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  riprap fields | grep energy")]
pub struct Fields {
    /// Print as JSON
    #[arg(long)]
    pub json: bool,
}

/// Explain a scene, a key of the scenario language or a concept.
///
/// For a file: the resolved scene with all defaults, and the origin of each value.
/// For a key: its meaning, unit, default and range. For a field: its meaning and unit. For any other word:
/// the commands, keys, fields, pages and scenes that mention it.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap explain hill.toml
  riprap explain interfaces.default.friction_angle
  riprap explain pore pressure")]
pub struct Explain {
    /// A scene file, a key, or words
    #[arg(value_name = "FILE|KEY|WORDS", required = true)]
    pub what: Vec<String>,
    #[command(flatten)]
    pub change: Change,
}

/// Print the JSON schema of the scenario language, for editors.
///
/// With `#:schema ./riprap.schema.json` at the top of a scene, an editor with TOML support
/// completes and explains keys.
#[derive(Debug, Args)]
#[command(after_help = "\
Example:
  riprap schema > riprap.schema.json")]
pub struct Schema {
    /// Print the reference page of all keys instead
    #[arg(long)]
    pub markdown: bool,
}

/// Print the hash of a scene, or of the final state of a run.
///
/// Equal hashes of two runs mean bitwise identical final states.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap hash hill.toml
  riprap hash hill.run")]
pub struct Hash {
    /// A scene file or a run folder
    #[arg(value_name = "FILE|RUN")]
    pub what: PathBuf,
    #[command(flatten)]
    pub change: Change,
}

/// Check that this program computes as it should.
///
/// Runs ten scenes that are in the program, of each kind of block and law, and checks their results against closed forms. It takes
/// seconds, needs no other file, and exits with 1 if a check fails.
#[derive(Debug, Args)]
pub struct SelfTest {}

/// Show what riprap detects on this machine.
#[derive(Debug, Args)]
pub struct Doctor {}

/// Reads `key=value`; the value may contain `=`.
fn key_value(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((key, value)) if !key.trim().is_empty() => {
            Ok((key.trim().to_owned(), value.trim().to_owned()))
        }
        _ => Err("write KEY=VALUE, for example interfaces.default.cohesion='1 kPa'".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_definition_is_consistent() {
        Cli::command().debug_assert();
    }

    #[test]
    fn set_is_split_at_the_first_equals_sign() {
        let cli = Cli::try_parse_from(["riprap", "run", "a.toml", "--set", "a.b=\"x=1\""]).unwrap();
        let Verb::Run(run) = cli.verb else { panic!("not run") };
        assert_eq!(run.scene.change.set, [("a.b".to_owned(), "\"x=1\"".to_owned())]);
        assert!(Cli::try_parse_from(["riprap", "run", "a.toml", "--set", "a.b"]).is_err());
        assert!(Cli::try_parse_from(["riprap", "run", "a.toml", "--threads", "0"]).is_err());
    }

    /// Values that are words or files; all others may be negative, and are then answered by what reads them.
    const WORDS: [&str; 24] = [
        "WHEN",
        "KEY=VALUE",
        "NAME",
        "NAMES",
        "TEMPLATE",
        "DIR",
        "FOLDER",
        "RUN",
        "FILE",
        "K/N",
        "KEY",
        "RESULT=VALUE",
        "KIND",
        "CAUSES",
        "GROUP",
        "HISTORY",
        "TEXT",
        "FAMILY",
        "FIELD",
        "VECTOR",
        "AXIS",
        "PROJECTION",
        "WHICH",
        "BY",
    ];

    #[test]
    fn options_that_take_numbers_take_negative_ones() {
        for verb in Cli::command().get_subcommands() {
            for option in verb.get_arguments().filter(|a| !a.is_positional()) {
                let names: Vec<&str> = option
                    .get_value_names()
                    .unwrap_or_default()
                    .iter()
                    .map(clap::builder::Str::as_str)
                    .collect();
                let word = names.first().is_none_or(|name| WORDS.contains(name) || *name == "A");
                let open =
                    option.is_allow_hyphen_values_set() || option.is_allow_negative_numbers_set();
                let takes = option.get_action().takes_values();
                assert!(!takes || word || open, "{} --{}", verb.get_name(), option.get_id());
            }
        }
    }

    #[test]
    fn every_verb_has_an_about_and_every_argument_a_help() {
        for verb in Cli::command().get_subcommands() {
            assert!(verb.get_about().is_some(), "{}", verb.get_name());
            for argument in verb.get_arguments() {
                assert!(argument.get_help().is_some(), "{} {}", verb.get_name(), argument.get_id());
            }
        }
    }
}
