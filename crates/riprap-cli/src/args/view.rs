//! `riprap view`, `riprap report` and `riprap paraview`.

use std::path::PathBuf;

use clap::Args;

use super::Change;

/// View a run in the browser, or a scene before it is run.
///
/// Serves a page to this machine only, without network access, and opens it: blocks in motion, coloured by any
/// field, contacts, vectors, clipping, histories, pictures and films. A run in progress is
/// followed. Two runs are shown side by side. A scene is shown as its model before the first step, with the
/// warnings of `riprap check`, and reloaded whenever the file is saved. Ctrl-C stops the server; the run folder is not
/// modified.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap view hill.run
  riprap view hill.toml                  the model before it is run
  riprap view dry.run wet.run            two runs side by side
  riprap view hill.run --no-open         only print the address
  riprap view hill.run --port 9000")]
pub struct View {
    /// Run folder, or a scene
    #[arg(value_name = "RUN|SCENE")]
    pub run: PathBuf,
    #[command(flatten)]
    pub change: Change,
    /// Another run folder, shown beside it
    #[arg(value_name = "RUN2")]
    pub other: Option<PathBuf>,
    /// Do not open a browser
    #[arg(long)]
    pub no_open: bool,
    /// Port to listen on; if it is in use the next free one is taken [default: 8470]
    #[arg(short, long, value_name = "PORT", value_parser = clap::value_parser!(u16).range(1..), allow_negative_numbers = true)]
    pub port: Option<u16>,
}

/// Write a run as one self-contained HTML file.
///
/// It holds the outcome of the run, its checks, an interactive replay, all plots, the energy ledger, the scene as
/// run, versions and hashes, needs no other file and prints well. Plots are first redrawn into
/// the run folder, as by `riprap plot RUN`.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap report hill.run                 writes hill.html
  riprap report hill.run -o letter.html --frames 20")]
pub struct Report {
    /// Run folder
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
    /// File to write [default: the run folder's name with .html, in the working folder]
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Maximum number of frames in the replay
    #[arg(long, value_name = "N", default_value_t = 40, value_parser = clap::value_parser!(u16).range(2..=1000), allow_negative_numbers = true)]
    pub frames: u16,
    /// Author, shown at the top
    #[arg(long, value_name = "NAME", default_value = "", hide_default_value = true)]
    pub author: String,
    /// Project, shown at the top
    #[arg(long, value_name = "NAME", default_value = "", hide_default_value = true)]
    pub project: String,
}

/// Write a script that opens a run in ParaView.
///
/// The script is written to the run folder as paraview_state.py. It loads blocks, cracks and contacts, colours them with the
/// ranges of the last frame, sets time and camera, and prepares arrows of the contact forces and a cut through the middle,
/// both hidden at first.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  riprap paraview hill.run                               writes hill.run/paraview_state.py
  paraview --script=hill.run/paraview_state.py           opens it
  pvpython hill.run/paraview_state.py last.png           draws one picture, without a window
  riprap paraview blast.run --by velocity --exaggerate 20")]
pub struct Paraview {
    /// Run folder
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
    /// Field of the frames that colours the blocks
    #[arg(long, value_name = "FIELD", default_value = "displacement")]
    pub by: String,
    /// Factor that exaggerates displacements, 1 or more
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, value_parser = exaggeration, allow_negative_numbers = true)]
    pub exaggerate: f64,
}

/// Reads a number of at least 1.
fn exaggeration(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(v) if v.is_finite() && v >= 1.0 => Ok(v),
        Ok(_) | Err(_) => Err("write a number of 1 or more, for example 20".to_owned()),
    }
}
