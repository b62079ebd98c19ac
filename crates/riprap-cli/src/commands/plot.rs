//! `riprap plot`.

use std::path::{Path, PathBuf};

use clap::Parser;
use riprap::plot::{
    self, Along, BlockOptions, CraterOptions, Fault, Look, Normal, PlotError, Projection, Target,
    Which,
};
use riprap::scenario::units::{self, Dim};

use super::run_folder;
use crate::args::{Cli, Plot, Verb};
use crate::diagnostics;
use crate::failure::Failure;
use crate::screen;

/// Pictures of blasts that are part of everything, as far as the run has what they need.
const OF_BLASTS: [&str; 4] = ["ppv", "crater", "heave", "cavity"];
/// Pictures of numbers that are not histories, and of blocks.
const OF_BLOCKS: [&str; 5] = ["energy", "blocks", "section", "line", "spectrum"];
/// Pictures of any run that are part of everything where they show something.
const OF_ANY: [&str; 3] = ["stereonet", "rose", "fragments"];

/// Pictures whose blocks have the colours of a field.
const FLAT: &[&str] = &["blocks", "section"];

/// Pictures of blocks, of which some can be chosen.
const OF_SOME: [&str; 9] =
    ["blocks", "section", "line", "ppv", "crater", "heave", "stereonet", "rose", "fragments"];

/// All pictures but those of histories.
const PICTURES: [&[&str]; 3] = [&OF_BLOCKS, &OF_BLASTS, &OF_ANY];

pub fn run(args: &Plot) -> Result<(), Failure> {
    for path in draw(args)? {
        screen::line(&path.display().to_string());
    }
    Ok(())
}

/// Draws what `riprap plot FOLDER` draws; the files written.
pub fn all(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let words = [
        "riprap".as_ref(),
        "plot".as_ref(),
        // The name of a folder may begin with a dash.
        "--".as_ref(),
        folder.as_os_str(),
    ];
    match Cli::try_parse_from(words).map(|cli| cli.verb) {
        Ok(Verb::Plot(args)) => draw(&args),
        Ok(_) | Err(_) => Err(Failure::Input(format!("{} cannot be plotted", folder.display()))),
    }
}

fn draw(args: &Plot) -> Result<Vec<PathBuf>, Failure> {
    let folder = &args.run;
    run_folder(folder, "plot")?;
    // No folder is left in what turns out to be no run.
    if args.output.is_none() && folder.join("manifest.json").exists() {
        let plots = folder.join("plots");
        std::fs::create_dir_all(&plots)
            .map_err(|e| Failure::Output(format!("could not create {}: {e}", plots.display())))?;
    }
    let asked = Asked::read(args)?;
    let mut others = PICTURES.iter().copied().flatten();
    let what = others.find(|name| args.what.as_deref() == Some(**name));
    if let (Some(_), Some(what)) = (&args.against, what) {
        return Err(Failure::Input(format!(
            "--against applies to histories, and `{what}` shows none; write riprap plot RUN HISTORY --against OTHER"
        )));
    }
    if let Some(what) =
        args.what.as_deref().filter(|what| args.of.is_some() && !OF_SOME.contains(what))
    {
        return Err(Failure::Input(format!(
            "--of chooses blocks, and `{what}` is of the whole run; pictures of some blocks: {}",
            OF_SOME.join(", ")
        )));
    }
    for option in unsuited(args) {
        let what = args.what.as_deref().unwrap_or("these pictures");
        diagnostics::print_line("note", &format!("--{option} has no effect on `{what}`"));
    }
    Ok(match (args.what.as_deref(), &args.more[..]) {
        (Some("spectrum"), [history]) => {
            let out = asked.out(&format!("spectrum_{}", file_name(history)));
            plot::spectrum(folder, history, asked.target(&out))?
        }
        (Some("spectrum"), _) => {
            let text = "spectrum needs the name of one history: riprap plot RUN spectrum HISTORY";
            return Err(Failure::Input(text.to_owned()));
        }
        (Some(what), [history, ..]) if PICTURES.iter().any(|names| names.contains(&what)) => {
            let other = match what {
                "blocks" | "section" | "line" => format!("name the field by --by {history}"),
                _ => "only spectrum and histories do".to_owned(),
            };
            return Err(Failure::Input(format!(
                "`{what}` takes no second name, but `{history}` was given; {other}"
            )));
        }
        (Some("histories"), [_, ..]) => asked.histories(&args.more)?,
        (Some(what), []) => asked.picture(what)?,
        (Some(what), more) => {
            let all: Vec<String> = std::iter::once(what.to_owned()).chain(more.to_vec()).collect();
            asked.histories(&all)?
        }
        (None, _) => everything(folder, &asked)?,
    })
}

/// Options that were given and that the picture does not read. Values that are the default ones may not have been given.
fn unsuited(args: &Plot) -> Vec<&'static str> {
    let given: [(&str, bool, &[&str]); 18] = [
        (
            "time",
            !args.time.is_empty(),
            &["blocks", "section", "line", "ppv", "crater", "heave", "stereonet", "rose"],
        ),
        ("by", args.by != "displacement", &["blocks", "section", "line"]),
        ("log", args.log, FLAT),
        ("range", args.range.is_some(), FLAT),
        ("percentiles", args.percentiles.is_some(), FLAT),
        ("vectors", args.vectors.is_some(), FLAT),
        ("stress", args.stress, FLAT),
        ("isolines", args.isolines.is_some(), FLAT),
        ("cracks", args.cracks, FLAT),
        ("window", args.window.is_some(), FLAT),
        ("exaggerate", args.exaggerate.is_some(), FLAT),
        ("normal", args.normal != Normal::Y, &["blocks", "section", "heave"]),
        ("at", args.at.is_some(), FLAT),
        ("from", args.from.is_some(), &["line"]),
        ("projection", args.projection != Projection::EqualArea, &["stereonet"]),
        ("surface", args.surface, &["ppv"]),
        ("uplift", args.uplift.is_some(), &["crater"]),
        ("source", args.source.is_some(), &["crater", "heave"]),
    ];
    let reads = |pictures: &[&str]| match args.what.as_deref() {
        Some(what) => pictures.contains(&what),
        // All but lines and spectra are among all pictures.
        None => pictures != ["line"],
    };
    let unread = given.into_iter().filter(|(_, given, pictures)| *given && !reads(pictures));
    let mut unread: Vec<&str> = unread.map(|(option, _, _)| option).collect();
    // Of a file the extension says what it is.
    let is = |wanted: &str, flag: bool| match args.output.as_ref().and_then(|out| out.extension()) {
        Some(ending) => ending.eq_ignore_ascii_case(wanted),
        None => flag || args.output.is_some(),
    };
    if args.dpi.is_some() && !is("png", args.png) {
        unread.push("dpi");
    }
    if args.font.is_some() && !is("svg", !args.png && !args.pdf) {
        unread.push("font");
    }
    unread
}

/// Values of the field `by` of a run, with a unit of its kind or in SI.
pub(super) fn range(
    given: Option<&[String]>,
    run: &Path,
    frame: Which,
    by: &str,
) -> Result<Option<[f64; 2]>, Failure> {
    let Some([low, high]) = given else { return Ok(None) };
    let unit = plot::unit_of(run, frame, by)?;
    let value = |text: &String| {
        units::value_in(text, &unit).ok_or_else(|| {
            let of = if unit == "-" { "has no unit".to_owned() } else { format!("is in {unit}") };
            Failure::Input(format!("--range: {text:?} is no value of `{by}`, which {of}"))
        })
    };
    Ok(Some([value(low)?, value(high)?]))
}

/// All pictures that suit the run.
fn everything(folder: &Path, asked: &Asked) -> Result<Vec<PathBuf>, Failure> {
    let some = asked.args.of.is_some();
    let mut all = if some { Vec::new() } else { asked.picture("energy")? };
    all.extend(asked.picture("blocks")?);
    if !some && folder.join("histories.csv").exists() {
        all.extend(asked.picture("histories")?);
    }
    let blast = riprap::record::Manifest::read(folder).is_ok_and(|m| !m.sources.is_empty());
    let of_blasts = OF_BLASTS.into_iter().filter(|what| blast && (!some || OF_SOME.contains(what)));
    for what in of_blasts.chain(OF_ANY) {
        match asked.drawn(what) {
            Ok(files) => all.extend(files),
            Err(PlotError::Unsuitable { .. } | PlotError::NothingToDraw { .. })
                // What a run has nothing of, as a run in the plane of poles, is no news.
                if OF_ANY.contains(&what) => {}
            // Nobody asked for this one by name.
            Err(
                error @ (PlotError::Unsuitable { .. }
                | PlotError::NothingToDraw { .. }
                | PlotError::Field(_)
                | PlotError::Table(_)
                | PlotError::Fit { .. }),
            ) => diagnostics::print_line("note", &format!("no picture of {what}: {error}")),
            Err(error) => return Err(error.into()),
        }
    }
    Ok(all)
}

/// Left, bottom, right and top of a picture, m.
fn window(given: Option<&[String]>) -> Result<Option<[f64; 4]>, Failure> {
    let Some(texts) = given else { return Ok(None) };
    let mut ends = [0.0; 4];
    for (end, text) in ends.iter_mut().zip(texts) {
        *end = quantity(text, Dim::LENGTH, "window", "--window '0 m' '0 m' '5 m' '3 m'")?;
    }
    if ends[0] < ends[2] && ends[1] < ends[3] {
        return Ok(Some(ends));
    }
    Err(Failure::Input(
        "--window takes left, bottom, right and top: left must be less than right, and bottom less than top".to_owned(),
    ))
}

/// A line, m.
fn line(args: &Plot) -> Result<Option<Along>, Failure> {
    let (Some(from), Some(to)) = (&args.from, &args.to) else {
        return Ok(None);
    };
    let place = |text: &str| {
        let parts: Vec<&str> = text.split(',').map(str::trim).collect();
        if !(2..=3).contains(&parts.len()) {
            return Err(Failure::Input(format!(
                "{text:?} is not a point; write x, y and in space z: --from '0 m, 3 m'"
            )));
        }
        let length = |part| quantity(part, Dim::LENGTH, "length", "--from '0 m, 3 m'");
        parts.into_iter().map(length).collect()
    };
    Ok(Some(Along { from: place(from)?, to: place(to)? }))
}

/// The arguments, read.
struct Asked<'a> {
    args: &'a Plot,
    look: Look,
    frames: Vec<Which>,
    options: BlockOptions,
    uplift: Option<f64>,
    line: Option<Along>,
}

impl<'a> Asked<'a> {
    fn read(args: &'a Plot) -> Result<Self, Failure> {
        let frames: Vec<Which> = args
            .time
            .iter()
            .map(|t| Ok(Which::Time(quantity(t, Dim::TIME, "time", "--time '0.5 s'")?)))
            .collect::<Result<_, Failure>>()?;
        let length = |text: &Option<String>, example| match text {
            Some(text) => quantity(text, Dim::LENGTH, "length", example).map(Some),
            None => Ok(None),
        };
        let width = length(&args.size, "--size '160 mm'")?;
        if width.is_some_and(|width| !(0.001..=100.0).contains(&width)) {
            return Err(Failure::Input(
                "--size is the width on paper, from 1 mm to 100 m; write for example --size '160 mm'"
                    .to_owned(),
            ));
        }
        let (title, font) = (args.title.clone(), args.font.clone());
        let look = Look { title, width, dpi: args.dpi, font };
        let options = BlockOptions {
            contacts: false,
            log: args.log,
            // Other pictures do not read it, which has its own note.
            range: match args.what.as_deref().is_none_or(|what| FLAT.contains(&what)) {
                true => {
                    let frame = frames.first().copied().unwrap_or(Which::Last);
                    range(args.range.as_deref(), &args.run, frame, &args.by)?
                }
                false => None,
            },
            percentiles: match args.percentiles.as_deref() {
                Some([low, high]) => Some([*low, *high]),
                Some(_) | None => None,
            },
            vectors: args.vectors,
            stress: args.stress,
            cracks: args.cracks,
            isolines: args.isolines.map_or(0, usize::from),
            window: window(args.window.as_deref())?,
            exaggeration: args.exaggerate,
            normal: args.normal,
            at: length(&args.at, "--at '2 m'")?,
        };
        Ok(Asked {
            args,
            look,
            frames,
            options,
            uplift: length(&args.uplift, "--uplift '40 mm'")?,
            line: line(args)?,
        })
    }

    fn out(&self, name: &str) -> PathBuf {
        let ending = match (self.args.png, self.args.pdf) {
            (true, _) => "png",
            (_, true) => "pdf",
            _ => "svg",
        };
        let plots = self.args.run.join("plots");
        let of =
            self.args.of.as_deref().map_or_else(String::new, |of| format!("_{}", file_name(of)));
        self.args.output.clone().unwrap_or_else(|| plots.join(format!("{name}{of}.{ending}")))
    }

    fn target<'p>(&self, path: &'p Path) -> Target<'p> {
        Target { path, look: self.look.clone() }
    }

    /// Several histories in one picture.
    fn histories(&self, names: &[String]) -> Result<Vec<PathBuf>, Failure> {
        let file: Vec<String> = names.iter().map(|name| file_name(name)).collect();
        let out = self.over(&file.join("_"));
        let against = self.args.against.as_deref();
        Ok(plot::histories(&self.args.run, names, against, self.target(&out))?)
    }

    /// The file of histories, which may be drawn over another one.
    fn over(&self, name: &str) -> PathBuf {
        match &self.args.against {
            Some(other) => self.out(&format!("{name}_against_{}", file_name(other))),
            None => self.out(name),
        }
    }

    /// The one frame of pictures that show one.
    fn frame(&self, what: &str) -> Result<Which, Failure> {
        match self.frames[..] {
            [] => Ok(Which::Last),
            [one] => Ok(one),
            [..] => Err(Failure::Input(format!(
                "{what} shows one frame, but --time was given {} times",
                self.frames.len()
            ))),
        }
    }

    fn picture(&self, what: &str) -> Result<Vec<PathBuf>, Failure> {
        if ["ppv", "crater", "stereonet", "rose"].contains(&what) {
            self.frame(what)?;
        }
        if what == "line" && self.line.is_none() {
            let text = "a line needs two ends, for example riprap plot RUN line --from '0 m, 3 m' --to '0 m, 12 m'";
            return Err(Failure::Input(text.to_owned()));
        }
        Ok(self.drawn(what)?)
    }

    fn drawn(&self, what: &str) -> Result<Vec<PathBuf>, PlotError> {
        let (folder, by) = (&self.args.run, &self.args.by);
        let run = plot::Run { folder, of: self.args.of.as_deref() };
        let last = [Which::Last];
        let frames = if self.frames.is_empty() { &last } else { &self.frames[..] };
        let source = self.args.source.as_deref();
        let against = self.args.against.as_deref();
        match what {
            "histories" => plot::histories(folder, &[], against, self.target(&self.over(what))),
            "energy" => plot::energy(folder, self.target(&self.out(what))),
            "blocks" => {
                let out = self.out(&format!("blocks_{by}"));
                plot::strip(run, frames, by, self.options, self.target(&out))
            }
            "section" => {
                let out = self.out(&format!("section_{by}"));
                plot::section(run, frames, by, self.options, self.target(&out))
            }
            "line" => match &self.line {
                Some(line) => {
                    let out = self.out(&format!("line_{by}"));
                    plot::along(run, frames, by, line, self.target(&out))
                }
                None => Ok(Vec::new()),
            },
            "ppv" => plot::ppv(run, frames[0], self.args.surface, self.target(&self.out(what))),
            "crater" => {
                let options = CraterOptions { uplift: self.uplift, source };
                plot::crater(run, frames[0], options, self.target(&self.out(what)))
            }
            "heave" => {
                let normal = self.options.normal;
                plot::heave(run, &self.frames, source, normal, self.target(&self.out(what)))
            }
            "cavity" => plot::cavity(folder, self.target(&self.out(what))),
            "stereonet" => {
                let projection = self.args.projection;
                plot::stereonet(run, frames[0], projection, self.target(&self.out(what)))
            }
            "fragments" => plot::fragments(run, self.target(&self.out(what))),
            "rose" => plot::rose(run, frames[0], self.target(&self.out(what))),
            name => {
                let out = self.over(&file_name(name));
                plot::histories(folder, &[name.to_owned()], against, self.target(&out))
            }
        }
    }
}

/// A quantity with its unit.
pub fn quantity(text: &str, wanted: Dim, what: &str, example: &str) -> Result<f64, Failure> {
    match units::parse(text) {
        Ok((value, dim)) if dim == wanted => Ok(value),
        Ok(_) | Err(_) => Err(Failure::Input(format!(
            "{text:?} is not a valid {what}; write for example {example}"
        ))),
    }
}

/// A history's name without what a file name cannot hold.
fn file_name(history: &str) -> String {
    let safe = |c: char| {
        if c.is_alphanumeric() || "-_.".contains(c) { c } else { '_' }
    };
    history.chars().map(safe).collect()
}

impl From<PlotError> for Failure {
    fn from(error: PlotError) -> Self {
        match error.fault() {
            Fault::Output => Failure::Output(error.to_string()),
            Fault::Folder | Fault::Request => Failure::Input(error.to_string()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_that_do_not_suit_a_picture_are_told() {
        let told = |words: &str| {
            let words = ["riprap", "plot", "a.run"].into_iter().chain(words.split(' '));
            let Verb::Plot(args) = Cli::try_parse_from(words).unwrap().verb else {
                panic!("no plot");
            };
            unsuited(&args)
        };
        assert_eq!(told("energy --time 1s --log"), ["time", "log"]);
        assert_eq!(told("slip --by velocity"), ["by"]);
        assert_eq!(told("rose --projection equal-angle --time 1s"), ["projection"]);
        assert_eq!(told("ppv --surface --uplift 1mm"), ["uplift"]);
        assert_eq!(told("line --from 0m,0m --to 1m,0m --isolines 4"), ["isolines"]);
        assert!(told("blocks --time 1s --by velocity --log --stress --cracks").is_empty());
        assert!(told("heave --normal x --source a --time 1s").is_empty());
        assert!(told("--time 1s --log --surface --png").is_empty());
        assert_eq!(told("--from 0m,0m --to 1m,0m"), ["from"]);
        assert_eq!(told("energy --range 0 1 --dpi 300 --font Arial"), ["range", "dpi"]);
        assert_eq!(told("blocks --percentiles 2 98 --png --dpi 300 --font Arial"), ["font"]);
        assert_eq!(told("blocks -o a.pdf --size 16cm --title b --dpi 300"), ["dpi"]);
    }
}
