//! Arguments of `riprap shot`.

use std::path::PathBuf;

use clap::Args;
use riprap::plot::Normal;

use super::plot::{factor, word};

/// Draw the blocks of a run in space as they stand, without a browser.
///
/// Writes PNG pictures in parallel projection, with title and legend: blocks coloured by a field, cut open where wanted. Several frames
/// are numbered pictures with one window and one range of colours, as a film needs them.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap shot wedge.run                               writes wedge.run/plots/shot.png
  riprap shot wedge.run --view 180 0 --by block       from the south
  riprap shot wedge.run --view 225 90                 from above, the south-west at the foot of the picture
  riprap shot blast.run --cut y --at '0 m' --by peak_speed --log
  riprap shot wedge.run --all --size 1280 720 -o film/wedge.png
                                                      film/wedge_0001.png, film/wedge_0002.png, ...")]
pub struct Shot {
    /// Run folder
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
    /// File to write [default: plots/shot.png in the run folder]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Field that colours the blocks; `block` and `material` are kinds
    #[arg(long, alias = "field", value_name = "FIELD", default_value = "displacement")]
    pub by: String,
    /// Where the eye stands: degrees clockwise from north (y), and above the horizon
    #[arg(long, num_args = 2, value_names = ["AZIMUTH", "ELEVATION"], default_values_t = [215.0, 28.0], allow_hyphen_values = true)]
    pub view: Vec<f64>,
    /// Width and height of the blocks' part of the picture, pixels
    #[arg(long, num_args = 2, value_names = ["WIDTH", "HEIGHT"], default_values_t = [1000, 700], allow_negative_numbers = true)]
    pub size: Vec<u32>,
    /// Time of the frame to draw; repeatable [default: the last]
    #[arg(long, value_name = "TIME", allow_hyphen_values = true, conflicts_with = "all")]
    pub time: Vec<String>,
    /// All frames
    #[arg(long)]
    pub all: bool,
    /// Normal of a plane; the side nearer to the eye is cut away
    #[arg(long, value_parser = word::<Normal>(), value_name = "AXIS", requires = "at")]
    pub cut: Option<Normal>,
    /// Where the plane lies along its normal
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true, requires = "cut")]
    pub at: Option<String>,
    /// Values of the first and the last colour, with units or in SI
    #[arg(long, num_args = 2, value_names = ["LOW", "HIGH"], allow_hyphen_values = true)]
    pub range: Option<Vec<String>>,
    /// Percentiles of the values at which the colours begin and end
    #[arg(long, num_args = 2, value_names = ["LOW", "HIGH"], allow_negative_numbers = true, conflicts_with = "range")]
    pub percentiles: Option<Vec<f64>>,
    /// Logarithmic colour scale
    #[arg(long)]
    pub log: bool,
    /// Factor that exaggerates displacements
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true, value_parser = factor)]
    pub exaggerate: Option<f64>,
}
