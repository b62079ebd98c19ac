//! Arguments of `riprap plot`.

use std::path::PathBuf;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use riprap::plot::{Normal, Projection, Vectors, Words};

/// Draw the results of a run.
///
/// Writes SVG pictures, and the numbers behind them as CSV, into the run folder.
#[derive(Debug, Args)]
#[command(after_help = "\
Pictures:
  histories          histories over time
  energy             the energy ledger over time
  blocks             blocks coloured by a field; of a run in space a section
  section            cut through a run in space
  line               a field along a line through the undeformed model, --from and --to
  ppv                peak particle velocity against scaled distance, with the site law
  crater             uplift of the surface around a charge, radius of the crater
  heave              surface profiles above a charge
  cavity             pressure and volume of cavities, with a fit of the pressure
  stereonet          poles of joints and cracks of a run in space, lower hemisphere
  rose               strikes of joints and cracks; in the plane the angles of their traces
  fragments          fragment size distribution, x50 and x80, with Rosin-Rammler and Swebrec fits
  spectrum HISTORY   amplitude spectrum of a history
  HISTORY ...        one history or several
                     over time, or over another one with --against

Examples:
  riprap plot hill.run                   everything
  riprap plot hill.run energy --png
  riprap plot hill.run slip -o slip.svg
  riprap plot core.run load --against shortening
  riprap plot hill.run crest toe --pdf --size '160 mm' --title 'Crest and toe'
  riprap plot hill.run blocks --percentiles 2 98
  riprap plot hill.run blocks --by velocity.x --range '-1 m/s' '1 m/s'
  riprap plot hill.run blocks --by velocity --time '0.5 s'
  riprap plot blast.run section --by displacement.z --vectors velocity
  riprap plot hill.run blocks --by sigma1_compressive --stress
  riprap plot hill.run blocks --by displacement --isolines 8
  riprap plot hill.run blocks --of 'rock and not (wall or crest)'
  riprap plot hill.run blocks --window '2 m' '0 m' '6 m' '3 m'
  riprap plot blast.run section --normal z --at '-0.5 m' --by peak_speed --log
  riprap plot blast.run section --time '5 ms' --time '20 ms' --exaggerate 20
  riprap plot tunnel.run line --by displacement.y --from '0 m, 3 m' --to '0 m, 12 m' --time '1 s' --time '2 s'
  riprap plot blast.run ppv --surface
  riprap plot blast.run crater --time '20 ms' --uplift '40 mm'
  riprap plot blast.run heave --time '5 ms' --time '10 ms' --time '20 ms'
  riprap plot blast.run cavity
  riprap plot beam.run stereonet --projection equal-angle
  riprap plot hill.run rose --png
  riprap plot beam.run fragments
  riprap plot blast.run fragments --of bench
  riprap plot blast.run spectrum house.velocity")]
pub struct Plot {
    /// Run folder
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
    /// Picture (listed below), or the name of one history [default: all that apply to the run]
    #[arg(value_name = "WHAT")]
    pub what: Option<String>,
    /// Further histories to draw, or the one whose spectrum is drawn
    #[arg(value_name = "HISTORY")]
    pub more: Vec<String>,
    /// History on the x axis instead of time: load over displacement, convergence over the advance of a face
    #[arg(long, value_name = "HISTORY", requires = "what")]
    pub against: Option<String>,
    /// File to write; its extension selects the format
    #[arg(short, long, value_name = "FILE", requires = "what")]
    pub output: Option<PathBuf>,
    /// Write PNG instead of SVG
    #[arg(long)]
    pub png: bool,
    /// Write PDF instead of SVG
    #[arg(long, conflicts_with = "png")]
    pub pdf: bool,
    /// Title in place of that of the scene
    #[arg(long, value_name = "TEXT")]
    pub title: Option<String>,
    /// Width on paper
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub size: Option<String>,
    /// Pixels of PNG per inch [default: 192]
    #[arg(long, value_name = "DPI", value_parser = factor, allow_negative_numbers = true)]
    pub dpi: Option<f64>,
    /// Font family of SVG; PNG and PDF have outlines of DejaVu Sans
    #[arg(long, value_name = "FAMILY")]
    pub font: Option<String>,
    /// Values of the first and the last colour, with units or in SI
    #[arg(long, num_args = 2, value_names = ["LOW", "HIGH"], allow_hyphen_values = true)]
    pub range: Option<Vec<String>>,
    /// Percentiles of the values at which the colours begin and end
    #[arg(long, num_args = 2, value_names = ["LOW", "HIGH"], conflicts_with = "range", allow_negative_numbers = true)]
    pub percentiles: Option<Vec<f64>>,
    /// Field that colours the blocks
    #[arg(long, alias = "field", value_name = "FIELD", default_value = "displacement")]
    pub by: String,
    /// Time of the frame to draw; repeatable for blocks, sections, lines and heave [default: the last]
    #[arg(long, value_name = "TIME", allow_hyphen_values = true)]
    pub time: Vec<String>,
    /// Logarithmic colour scale
    #[arg(long)]
    pub log: bool,
    /// Arrows for blocks, or for the flow through joints
    #[arg(long, value_parser = word::<Vectors>(), value_name = "VECTOR")]
    pub vectors: Option<Vectors>,
    /// Principal stresses of the blocks as crosses
    #[arg(long)]
    pub stress: bool,
    /// Approximate number of labelled isolines over the blocks
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u8).range(1..=50), allow_negative_numbers = true)]
    pub isolines: Option<u8>,
    /// Broken faces, on sections
    #[arg(long)]
    pub cracks: bool,
    /// Extent of the picture: left, bottom, right, top
    #[arg(long, num_args = 4, value_names = ["LEFT", "BOTTOM", "RIGHT", "TOP"], allow_hyphen_values = true)]
    pub window: Option<Vec<String>>,
    /// Factor that exaggerates displacements
    #[arg(long, value_name = "FACTOR", value_parser = factor, allow_negative_numbers = true)]
    pub exaggerate: Option<f64>,
    /// Normal of a section; heave profiles run along the other horizontal axis
    #[arg(long, value_parser = word::<Normal>(), value_name = "AXIS", default_value = "y")]
    pub normal: Normal,
    /// Position of the section along its normal [default: through the first source, or the middle]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub at: Option<String>,
    /// Start of a line: x, y and in space z, separated by commas
    #[arg(long, value_name = "PLACE", allow_hyphen_values = true, requires = "to")]
    pub from: Option<String>,
    /// End of the line
    #[arg(long, value_name = "PLACE", allow_hyphen_values = true, requires = "from")]
    pub to: Option<String>,
    /// Projection of the stereonet
    #[arg(long, value_parser = word::<Projection>(), value_name = "PROJECTION", default_value = "equal-area")]
    pub projection: Projection,
    /// Peak velocities only of blocks with a free face upwards
    #[arg(long)]
    pub surface: bool,
    /// Uplift that defines the crater rim [default: 0.02 of the depth of the charge]
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub uplift: Option<String>,
    /// Only blocks of this group, block or condition, and what lies between them; fragments that contain one
    #[arg(long, value_name = "GROUP")]
    pub of: Option<String>,
    /// Charge for crater and heave [default: the first]
    #[arg(long, value_name = "NAME")]
    pub source: Option<String>,
}

/// Reads a choice, with hyphens as words of a command have them.
pub(super) fn word<T: Words + Send + Sync>() -> impl TypedValueParser<Value = T> {
    let words = T::WORDS
        .iter()
        .map(|(word, meaning)| PossibleValue::new(word.replace('_', "-")).help(*meaning));
    PossibleValuesParser::new(words)
        .try_map(|word| T::named(&word.replace('-', "_")).ok_or("this is not a valid choice"))
}

/// Reads a positive number.
pub(super) fn factor(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(v) if v.is_finite() && v > 0.0 => Ok(v),
        Ok(_) | Err(_) => Err("write a positive number, for example 20".to_owned()),
    }
}
