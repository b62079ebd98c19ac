//! Arguments of `riprap muckpile`.

use std::path::PathBuf;

use clap::Args;

/// Results of a blast: muckpile and swell, throw and flyrock, fragments, back-break, crater, gas, energy.
///
/// Reads first and last frame, fragments, events and energies of a run in space. A block counts as thrown if it lies farther from its place than half its size; all
/// others are the ground below the pile. Fragments are measured by their smallest edge, beside the curve of Kuz-Ram if a rock factor is
/// given. The parts of the energy are listed with what they depend on. End the run at rest (`until = { rest = {} }`). Writes tables and pictures of the
/// profile and of the energy into a folder.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap muckpile shot.run
  riprap muckpile shot.run --rock-factor 7 --uniformity 1.3
  riprap muckpile shot.run --of 'burden and not toe'
  riprap muckpile shot.run --along 1,0 --moved '0.5 m' --json")]
pub struct Muckpile {
    /// Run folder
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
    /// Way from which on a block counts as thrown [default: half the edge of the cube of its volume]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub moved: Option<String>,
    /// Only blocks of this group, block or condition make the pile; all others are ground
    #[arg(long, value_name = "GROUP")]
    pub of: Option<String>,
    /// Direction of the throw in the plan [default: the mean one]
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    pub along: Option<String>,
    /// Cell of the grid over the plan [default: a quarter of the edge of the cube of the mean thrown block]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub cell: Option<String>,
    /// Rock factor A of Kuz-Ram, 0.8 to 22
    #[arg(long, value_name = "A", allow_negative_numbers = true)]
    pub rock_factor: Option<f64>,
    /// Explosive over the rock that it breaks, for Kuz-Ram [default: all charges over all thrown rock]
    #[arg(long, value_name = "DENSITY", requires = "rock_factor", allow_hyphen_values = true)]
    pub powder_factor: Option<String>,
    /// Charge of a hole, for Kuz-Ram [default: the mean one]
    #[arg(long, value_name = "MASS", requires = "rock_factor", allow_hyphen_values = true)]
    pub charge: Option<String>,
    /// Strength by weight relative to ANFO, %, for Kuz-Ram
    #[arg(long, value_name = "S", default_value_t = 100.0, allow_negative_numbers = true)]
    pub strength: f64,
    /// Uniformity n, for x80 of Kuz-Ram
    #[arg(long, value_name = "N", requires = "rock_factor", allow_negative_numbers = true)]
    pub uniformity: Option<f64>,
    /// Folder for the results [default: the name of the run with .muckpile, in the working folder]
    #[arg(short, long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Replace existing results
    #[arg(long)]
    pub force: bool,
    /// Print as JSON
    #[arg(long)]
    pub json: bool,
}
