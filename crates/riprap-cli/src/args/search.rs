//! Arguments of searches: `riprap bisect` and `riprap safety`.

use std::path::PathBuf;

use clap::Args;

use super::{Errors, How, Scene};

/// Find the value of a key at which the scene starts to fail, or at which a result has a wanted value.
///
/// Runs the scene repeatedly, halving the interval each time: that of its [bisect] table, or with --vary the --range of any key, until a
/// result is as wanted. Results are the names of checks and histories, and `safety`, the factor of safety.
#[derive(Debug, Args)]
#[command(visible_alias = "find")]
#[command(after_help = "\
Examples:
  riprap bisect slope.toml
  riprap find slope.toml --vary bolts.0.pretension --range '0 kN..400 kN' --until 'safety = 1.3'
  riprap find slide.toml --vary materials.rock.density --range '2 t/m3..3 t/m3' --until 'slip = 5 cm'

Without --vary the scene says what to look for:
  [bisect]
  key = \"interfaces.default.friction_angle\"
  low = \"30 deg\"
  high = \"45 deg\"
  tolerance = \"0.1 deg\"
  fails_when = { field = \"model.max_displacement\", above = \"0.1 m\" }")]
pub struct Bisect {
    #[command(flatten)]
    pub scene: Scene,
    #[command(flatten)]
    pub how: How,
    /// Key whose value is searched for
    #[arg(long, value_name = "KEY", requires_all = ["range", "until"])]
    pub vary: Option<String>,
    /// Values of the key, at one of which the result is below, at the other above what is wanted
    #[arg(long, value_name = "A..B", allow_hyphen_values = true, requires = "vary")]
    pub range: Option<String>,
    /// The result and what it is to be
    #[arg(long, value_name = "RESULT=VALUE", requires = "vary", value_parser = riprap::run::study::find::Wanted::read)]
    pub until: Option<riprap::run::study::find::Wanted>,
    /// Width of the final range of the key, with its unit [default: a hundredth of the range]
    #[arg(long, value_name = "WIDTH", requires = "vary", allow_hyphen_values = true)]
    pub width: Option<String>,
    /// Print each run and the result as JSON lines
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub errors: Errors,
}

/// Find the factor of safety of a scene, or the limit value of one of its keys.
///
/// Strength reduction: cohesion, tension and tan(friction angle) of the interfaces are divided by a factor F, found by doubling
/// and bisection; the factor of safety is the largest F with which the model reaches equilibrium. The phases of the scene are run
/// first; each trial continues from the last stable state, as a static phase. With --quantity a key takes the place of F: a load, a
/// water level, an angle, a thickness; each trial then starts from the beginning. Writes a table of the trials and a run of the mechanism into a folder.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap safety slope.toml
  riprap safety slope.toml --interfaces plane --width 0.002
  riprap safety slope.toml --groups wedge
  riprap safety arch.toml --quantity blocks.arch.arch.thickness --range '1 m..1.15 m' --width '2 mm'

A trial is stable when the unbalanced-force ratio falls below --balance, failing when a block has moved more than --moved
and the kinetic energy keeps growing, and undecided otherwise; the answer is then a wider range.")]
pub struct Safety {
    #[command(flatten)]
    pub scene: Scene,
    #[command(flatten)]
    pub how: How,
    /// Width of the final range; of a quantity with its unit [default: 0.01; a hundredth of the range]
    #[arg(long, value_name = "F", allow_hyphen_values = true)]
    pub width: Option<String>,
    /// Interfaces whose strength is reduced, separated by commas [default: all]
    #[arg(long, value_name = "NAMES", value_delimiter = ',', conflicts_with = "quantity")]
    pub interfaces: Vec<String>,
    /// Materials: only strengths between a block of one of them and any other are reduced [default: all]
    #[arg(long, value_name = "NAMES", value_delimiter = ',', conflicts_with = "quantity")]
    pub materials: Vec<String>,
    /// Groups of blocks: only strengths between a block of one of them and any other are reduced [default: all]
    #[arg(long, value_name = "NAMES", value_delimiter = ',', conflicts_with = "quantity")]
    pub groups: Vec<String>,
    /// Search for the limit value of this key instead of the factor of safety
    #[arg(long, value_name = "KEY", requires = "range")]
    pub quantity: Option<String>,
    /// Values of the key that bracket the limit; either end may be the stable one
    #[arg(long, value_name = "A..B", allow_hyphen_values = true, requires = "quantity")]
    pub range: Option<String>,
    /// Displacement above which a trial may count as failing, with its unit [default: a thousandth of a block]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub moved: Option<String>,
    /// Unbalanced-force ratio below which a trial is stable
    #[arg(long, value_name = "RATIO", default_value_t = 1e-5, allow_negative_numbers = true)]
    pub balance: f64,
    /// Steps after which a trial counts as undecided
    #[arg(long, value_name = "N", default_value_t = 100_000, allow_negative_numbers = true)]
    pub steps: u64,
    /// Run the scene from its start with reduced strengths in every trial: slower, and with another stress path
    #[arg(long, conflicts_with = "quantity")]
    pub from_start: bool,
    /// How trials seek their equilibrium: by relaxation (explicit) or by Newton's method (implicit), or so where the model can take it (automatic)
    #[arg(long, value_name = "KIND", default_value = "automatic", value_parser = ["automatic", "explicit", "implicit"])]
    pub integration: String,
    /// Folder for the results [default: the scene's name with .safety, in the working folder]
    #[arg(short, long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Replace existing results
    #[arg(long)]
    pub force: bool,
    /// Print each trial and the answer as JSON lines
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub errors: Errors,
}
