//! Arguments of `riprap runout`.

use std::path::PathBuf;

use clap::Args;
use riprap::run::runout::Line;

/// Run-out of rocks: where each ends, how high and how fast it goes, how many pass a line.
///
/// Reads the frames of runs: one, several, or all in a folder of `riprap sweep` or `riprap monte-carlo`, whose rocks then count together. Gives the
/// distribution of run-out and angle of travel; for each line the probability of being reached with its 95 % interval, and height above the ground,
/// speed and energy at it. Between two frames rocks go along the parabola of free flight; impacts between them are not seen, so
/// record frames every 0.1 s or so. Writes tables and histograms into a folder.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap runout fall.run
  riprap runout fall.run --of rocks --line 'ditch=55 m'
  riprap runout fall.run --line 'fence=40 m,-10 m..45 m,10 m' --line 'road=60 m'
  riprap runout fall.monte-carlo --line 'road=60 m' --json")]
pub struct Runout {
    /// Run folders, or folders that hold some
    #[arg(value_name = "RUN", required = true)]
    pub runs: Vec<PathBuf>,
    /// Only the rocks of this group, or of this condition, for example 'rocks and not cliff' [default: all free blocks]
    #[arg(long, value_name = "GROUP")]
    pub of: Option<String>,
    /// Line that rocks may pass, with a name: at an x, or between two points of the plan; repeatable
    #[arg(long, value_name = "NAME=X|NAME=X,Y..X,Y", allow_hyphen_values = true, value_parser = Line::read)]
    pub line: Vec<Line>,
    /// Folder for the results [default: the name of the first folder with .runout, in the working folder]
    #[arg(short, long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Replace existing results
    #[arg(long)]
    pub force: bool,
    /// Print as JSON
    #[arg(long)]
    pub json: bool,
}
