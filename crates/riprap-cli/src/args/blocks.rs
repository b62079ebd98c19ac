//! Verbs that look at the blocks of a scene without a step.

use std::path::PathBuf;

use clap::Args;

use super::Scene;

/// List the removable blocks of a scene in space, by block theory: mode, factor of safety, support.
///
/// A block is removable if some direction leads it away from all its neighbours (Goodman & Shi 1985). Its weight and the pressure of the water
/// make it fall, slide on one plane or on two, or hold it in place. The factor of safety is the strength of the planes it slides on, divided by the
/// driving force along them. Key blocks are those with a factor below 1. The blocks are examined as the last phase begins, with its excavations
/// made and its water table in place; nothing is run.
#[derive(Debug, Args)]
#[command(visible_alias = "key-blocks")]
#[command(after_help = "\
Examples:
  riprap removable wedge.toml
  riprap removable tunnel.toml --factor 1.5 --rounds 10 --out blocks.csv
  riprap removable wedge.toml --picture wedge.blocks && riprap view wedge.blocks
  riprap removable wedge.toml --set 'interfaces.default.friction_angle=30 deg' --json

Types of Goodman & Shi: I key block; II held by the strength of its joints; III held by its weight; IV tapered, not removable.
The support force acts against the motion, the support pressure on the free faces by which the block goes out.")]
pub struct Removable {
    #[command(flatten)]
    pub scene: Scene,
    /// Factor of safety that support is to give, and below which blocks are taken out between rounds
    #[arg(long, value_name = "F", default_value_t = 1.0, allow_negative_numbers = true, value_parser = super::plot::factor)]
    pub factor: f64,
    /// Rounds: after each the blocks below the factor are taken out, and those that they have held are examined
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..), allow_negative_numbers = true)]
    pub rounds: u32,
    /// Phase at whose beginning [default: the last]
    #[arg(long, value_name = "NAME")]
    pub phase: Option<String>,
    /// List tapered blocks too
    #[arg(long)]
    pub all: bool,
    /// Write the blocks, tapered ones too, to this file as CSV
    #[arg(short, long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Write a picture of the blocks, coloured by type, motion and factor of safety, into this run folder: for `riprap view`
    #[arg(long, value_name = "RUN")]
    pub picture: Option<PathBuf>,
    /// Write into a folder of --picture that exists
    #[arg(long, requires = "picture")]
    pub force: bool,
    /// Print as JSON
    #[arg(long)]
    pub json: bool,
}

/// Show the sizes of the blocks of a scene before it runs: curve, x50, x80, fit.
///
/// The size of a block is the edge of the cube of its volume, in the plane the side of the square of its area. Terrain has none. Blocks that are split
/// before the first step count as what they are split into.
#[derive(Debug, Args)]
#[command(visible_alias = "block-sizes")]
#[command(after_help = "\
Examples:
  riprap sizes slope.toml
  riprap sizes slope.toml --of 'rock and not wall' --out sizes.svg
  riprap sizes slope.toml --json")]
pub struct Sizes {
    #[command(flatten)]
    pub scene: Scene,
    /// Only the blocks of this group, block or condition
    #[arg(long, value_name = "GROUP")]
    pub of: Option<String>,
    /// Draw the curve into this file (SVG, PDF or PNG by its name); the numbers go beside it as CSV
    #[arg(short, long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Print as JSON
    #[arg(long)]
    pub json: bool,
}

/// Show the contact forces of a scene at its start, without any step.
///
/// One row per contact: overlap, length, centre, force on the first block, moments about each block's
/// own centroid, and the contact types of the source law. Blocks closer than the threshold that do not
/// touch follow with their gap.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap probe-contact two.toml
  riprap probe-contact two.toml --pair left right --json")]
pub struct ProbeContact {
    #[command(flatten)]
    pub scene: Scene,
    /// Distance below which blocks are listed and features count as touching in the source's contact
    /// types, for example '1 mm' [default: a thousandth of the smaller block]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub threshold: Option<String>,
    /// Only this pair of blocks, by name
    #[arg(long, num_args = 2, value_names = ["A", "B"])]
    pub pair: Option<Vec<String>>,
    /// Print as JSON
    #[arg(long)]
    pub json: bool,
}
