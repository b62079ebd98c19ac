//! One self-contained HTML file about a run: what was run, with what, how it ended, what it looks like.
//!
//! The replay in it is the page of the viewer itself, which finds its answers in the file instead of asking a server:
//! fewer frames and fields, gzip in base64. Everything else is plain HTML that prints.

use serde_json::Value;
use std::fmt::Write as _;
use std::path::PathBuf;

use crate::run::{Problem, Run};

mod book;
mod html;
mod sections;
mod words;

use book::Book;
use html::escape;
use sections::{checks, energy, events, facts, groups, pictures, provenance, scene, trust, works};

const SCRIPT: &str = include_str!("../assets/app.js");
const STYLE: &str = include_str!("../assets/app.css");
const LAYOUT: &str = include_str!("report.css");

/// File name, without its ending, of the picture of a model in the plane before it moved.
pub const SETUP: &str = "setup";
/// The same of a view of a model in space.
pub const SETUP_VIEW: &str = "setup_view";
/// The same of a section of a model in space.
pub const SETUP_SECTION: &str = "setup_section";

/// How large a report may become.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// Frames of the replay.
    pub frames: usize,
    /// Bytes of the replay in the file.
    pub bytes: usize,
}

/// Who made the run, and for what: before what the scene says.
#[derive(Debug, Clone, Default)]
pub struct Signature {
    /// Who is to be asked; empty takes `author` of the scene.
    pub author: String,
    /// What the run belongs to; empty takes `project` of the scene.
    pub project: String,
}

impl Signature {
    /// What is not given as the scene says it.
    fn or_of(&self, scene: &toml::Table) -> Self {
        let or = |given: &str, key: &str| {
            let said = || scene.get(key).and_then(toml::Value::as_str);
            match given {
                "" => said().unwrap_or_default().to_owned(),
                given => given.to_owned(),
            }
        };
        Self { author: or(&self.author, "author"), project: or(&self.project, "project") }
    }
}

impl Default for Limits {
    fn default() -> Self {
        Limits { frames: 40, bytes: 24 << 20 }
    }
}

/// The report as an HTML file, with the pictures in `plots` (SVG or PNG) in their order; those of the set-up come first, under a
/// head of their own, a view before a section.
///
/// # Errors
/// A folder that is no run; damaged frames are left out of the replay and named.
pub fn report(
    run: &Run,
    plots: &[PathBuf],
    signature: &Signature,
    limits: Limits,
) -> Result<String, Problem> {
    let manifest = run.manifest()?;
    let mut out = String::new();
    let title = if manifest.title.is_empty() { "A run of riprap" } else { &manifest.title };
    let title = escape(title);
    let _ = write!(
        out,
        "<!doctype html>\n<html lang=\"en\" class=\"report\" data-theme=\"light\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
         <style>{STYLE}</style>\n<style>{LAYOUT}</style>\n</head>\n<body>\n<article>\n<h1>{title}</h1>\n"
    );
    let scene_table = words::scene(run);
    facts(&mut out, &manifest, &signature.or_of(&scene_table));
    let of_setup = |path: &&PathBuf| {
        path.file_stem().is_some_and(|s| [SETUP, SETUP_VIEW, SETUP_SECTION].iter().any(|n| s == *n))
    };
    let (mut setup, plots): (Vec<_>, Vec<_>) = plots.iter().partition(of_setup);
    setup.sort_by_key(|path| path.file_stem().is_some_and(|s| s == SETUP_SECTION));
    pictures(&mut out, "Set-up", &setup);
    words::materials(&mut out, &scene_table);
    groups(&mut out, &run.names());
    words::phases(&mut out, &scene_table);
    for warning in &manifest.warnings {
        let _ = writeln!(out, "<p class=\"warning\">{}</p>", escape(warning));
    }
    checks(&mut out, run);
    trust(&mut out, run);
    replay(&mut out, run, limits);
    pictures(&mut out, "Plots", &plots);
    energy(&mut out, run);
    works(&mut out, &manifest);
    events(&mut out, run);
    scene(&mut out, run, &manifest);
    provenance(&mut out, &manifest);
    out.push_str("</article>\n<script type=\"module\">");
    // Nothing in the script may end it.
    out.push_str(&SCRIPT.replace("</script", "<\\/script"));
    out.push_str("</script>\n</body>\n</html>\n");
    Ok(out)
}

/// The viewer with the answers that it will ask for.
fn replay(out: &mut String, run: &Run, limits: Limits) {
    let mut book = Book::default();
    let kept = match book.fill(run, limits) {
        Ok(kept) => kept,
        Err(problem) => {
            let _ = writeln!(
                out,
                "<h2>Replay</h2>\n<p class=\"warning\">{} {}</p>",
                escape(&problem.what),
                escape(&problem.hint)
            );
            return;
        }
    };
    let _ = writeln!(
        out,
        "<h2>Replay</h2>\n<p class=\"screen\">{kept} frame{}. Drag to rotate, scroll to zoom, space to play, ? for all keys.</p>\n<div id=\"app\" \
         class=\"replay\"></div>",
        if kept == 1 { "" } else { "s" }
    );
    for note in &book.notes {
        let _ = writeln!(out, "<p class=\"warning\">{}</p>", escape(note));
    }
    // No name in an answer may end the script that holds it.
    let answers = Value::Object(book.answers).to_string().replace('<', "\\u003c");
    let _ = writeln!(out, "<script type=\"application/json\" id=\"riprap-run\">{answers}</script>");
}
