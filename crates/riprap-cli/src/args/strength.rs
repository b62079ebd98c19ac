//! Arguments of `riprap strength`.

use std::path::PathBuf;

use clap::Args;
use riprap::run::strength::Confining;

/// Modulus, strength, cohesion and friction from the histories of laboratory tests.
///
/// Reads runs of compression tests, disks or shear tests, one, several, or all in a folder of `riprap sweep`. Each gives its peak, the strain there, the
/// modulus and the residual stress; tests with two and more confining (in shear: normal) stresses give cohesion and friction angle of the line
/// of Mohr and Coulomb, with their standard errors. The sign of a history does not matter.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap strength ucs.run --load load --area '20 cm2' --shortening platen --length '10 cm'
  riprap strength triaxial.sweep --stress axial --strain strain --confining side
  riprap strength a.run b.run --stress axial --confining '5 MPa'
  riprap strength disk.run --load load --disk '54 mm,27 mm'
  riprap strength shear.sweep --shear --stress tau --confining sigma")]
pub struct Strength {
    /// Run folders, or folders that hold some
    #[arg(value_name = "RUN", required = true)]
    pub runs: Vec<PathBuf>,
    /// History of the stress
    #[arg(long, value_name = "HISTORY", conflicts_with_all = ["load", "area", "disk"], required_unless_present = "load")]
    pub stress: Option<String>,
    /// History of the load; needs --area or --disk
    #[arg(long, value_name = "HISTORY")]
    pub load: Option<String>,
    /// Area that the load acts on; in the plane a length
    #[arg(
        long,
        value_name = "AREA",
        conflicts_with = "disk",
        requires = "load",
        allow_hyphen_values = true
    )]
    pub area: Option<String>,
    /// Brazilian test: diameter of the disk and, in space, its thickness
    #[arg(long, value_name = "D[,T]", requires = "load", conflicts_with_all = ["shear", "confining"], allow_hyphen_values = true)]
    pub disk: Option<String>,
    /// History of the strain, for the modulus
    #[arg(long, value_name = "HISTORY", conflicts_with = "shortening")]
    pub strain: Option<String>,
    /// History of the shortening, for the modulus; needs --length
    #[arg(long, value_name = "HISTORY", requires = "length")]
    pub shortening: Option<String>,
    /// Length that the shortening is divided by
    #[arg(long, value_name = "LENGTH", requires = "shortening", allow_hyphen_values = true)]
    pub length: Option<String>,
    /// Confining stress, in shear the normal stress: a history, or a value with its unit
    #[arg(long, value_name = "HISTORY|STRESS", value_parser = |text: &str| Ok::<_, String>(Confining::read(text)), allow_hyphen_values = true)]
    pub confining: Option<Confining>,
    /// The tests shear a joint
    #[arg(long)]
    pub shear: bool,
    /// Shares of the peak between which the modulus is measured
    #[arg(long, value_name = "A..B", default_value = "0.2..0.5", allow_hyphen_values = true)]
    pub between: String,
    /// Write the tests to this file as CSV
    #[arg(short, long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Print as JSON
    #[arg(long)]
    pub json: bool,
}
