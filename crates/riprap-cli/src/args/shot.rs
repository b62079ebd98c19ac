//! Arguments of `riprap shot`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use riprap::plot::Normal;

use super::plot::{factor, word};

/// Which contacts are drawn.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum ContactPoints {
    /// All but those that only touch
    Changed,
    /// All
    All,
}

/// What colours trails.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub enum TrailColour {
    /// Mean speed between two frames
    Speed,
    /// A colour for each block
    Block,
}

/// Draw the blocks of a run in space as they stand, without a browser.
///
/// Writes PNG pictures with title and legend: blocks coloured by a field, cut open where wanted, bolts as rods. Several frames are numbered
/// pictures with one window and one range of colours, or one animated PNG.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap shot wedge.run                               writes wedge.run/plots/shot.png
  riprap shot wedge.run --view 180 0 --by block       from the south
  riprap shot wedge.run --view 225 90                 from above, the south-west at the foot of the picture
  riprap shot wedge.run --of 'rock and not wedge'      only these blocks
  riprap shot blast.run --cut y --at '0 m' --by peak_speed --log
  riprap shot wall.run --chains --vectors velocity    contact forces as tubes, velocities as arrows
  riprap shot rockfall.run --trails                   the ways of what moved, by speed
  riprap shot wall.run --contacts                     contacts that slide, have broken or are open
  riprap shot wedge.run --perspective=50              things farther away are smaller
  riprap shot wedge.run --saved south                 a view saved in riprap view, from wedge.run/views.json
  riprap shot wedge.run -o wedge.apng --fps 20        a film of all frames that browsers and slides play
  riprap shot wedge.run --all --size 1280 720 -o film/wedge.png
                                                      film/wedge_0001.png, film/wedge_0002.png, ...
  ffmpeg -framerate 20 -i film/wedge_%04d.png -pix_fmt yuv420p -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' wedge.mp4
                                                      these as MP4")]
pub struct Shot {
    /// Run folder
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
    /// File to write, .png or .apng (a film) [default: plots/shot.png in the run folder]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Field that colours the blocks; `block`, `material` and `removable_type` are kinds [default: material, of removable blocks
    /// their type, of a saved view its field]
    #[arg(long, alias = "field", value_name = "FIELD")]
    pub by: Option<String>,
    /// Where the eye stands: degrees clockwise from north (y), and above the horizon [default: 215 28]
    #[arg(long, num_args = 2, value_names = ["AZIMUTH", "ELEVATION"], allow_hyphen_values = true)]
    pub view: Option<Vec<f64>>,
    /// Angle of view from the lower to the upper edge, degrees; without: a parallel projection
    #[arg(long, value_name = "ANGLE", num_args = 0..=1, require_equals = true, default_missing_value = "32", allow_negative_numbers = true)]
    pub perspective: Option<f64>,
    /// Name of a view that was saved in `riprap view`
    #[arg(long, value_name = "NAME", conflicts_with_all = ["view", "perspective"])]
    pub saved: Option<String>,
    /// File of saved views [default: views.json in the run folder]
    #[arg(long, value_name = "FILE", requires = "saved")]
    pub views: Option<PathBuf>,
    /// Width and height of the blocks' part of the picture, pixels [default: 1000 700]
    #[arg(long, num_args = 2, value_names = ["WIDTH", "HEIGHT"], allow_negative_numbers = true)]
    pub size: Option<Vec<u32>>,
    /// Time of the frame to draw; repeatable [default: the last]
    #[arg(long, value_name = "TIME", allow_hyphen_values = true, conflicts_with = "all")]
    pub time: Vec<String>,
    /// All frames; a film has all where no time is given
    #[arg(long)]
    pub all: bool,
    /// Pictures of a film in a second [default: 10]
    #[arg(long, value_name = "NUMBER", allow_negative_numbers = true)]
    pub fps: Option<f64>,
    /// Only blocks of this group, block or condition, and the bolts and contacts between them
    #[arg(long, value_name = "GROUP")]
    pub of: Option<String>,
    /// Leave out bolts
    #[arg(long)]
    pub no_bolts: bool,
    /// Leave out the shadows of the sun and the dark of hollows
    #[arg(long)]
    pub no_shadows: bool,
    /// Contact forces as tubes from block to block
    #[arg(long)]
    pub chains: bool,
    /// Contacts as points coloured by state: those that slide, have broken or are open, or `all`
    #[arg(long, value_name = "WHICH", num_args = 0..=1, require_equals = true, default_missing_value = "changed")]
    pub contacts: Option<ContactPoints>,
    /// The ways of all blocks that moved by a quarter of a block, up to the frame, by mean `speed` or by `block`
    #[arg(long, value_name = "BY", num_args = 0..=1, require_equals = true, default_missing_value = "speed")]
    pub trails: Option<TrailColour>,
    /// Field of vectors, drawn as arrows: displacement, velocity or force
    #[arg(long, value_name = "FIELD")]
    pub vectors: Option<String>,
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
