//! One self-contained HTML file about a run: what was run, with what, how it ended, what it looks like.
//!
//! The replay in it is the page of the viewer itself, which finds its answers in the file instead of asking a server:
//! fewer frames and fields, gzip in base64. Everything else is plain HTML that prints.

use base64::Engine as _;
use flate2::Compression;
use flate2::write::GzEncoder;
use riprap::record::manifest::Manifest;
use riprap::record::names::Names;
use serde_json::{Map, Value, json};
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::PathBuf;

use crate::answer::{Query, answer, summary};
use crate::run::{Problem, Run};

const SCRIPT: &str = include_str!("../assets/app.js");
const STYLE: &str = include_str!("../assets/app.css");
const LAYOUT: &str = include_str!("report.css");

/// How large a report may become.
#[derive(Debug, Clone, Copy)]
pub struct Limits {
    /// Frames of the replay.
    pub frames: usize,
    /// Bytes of the replay in the file.
    pub bytes: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Limits {
            frames: 40,
            bytes: 24 << 20,
        }
    }
}

/// Fields of the replay, as far as the frames have them and there is room.
const FIELDS: [&str; 8] = [
    "displacement",
    "velocity",
    "sigma1_compressive",
    "broken_share",
    "rotation",
    "peak_speed",
    "level",
    "material",
];
/// Rows of histories kept for the replay.
const ROWS: usize = 2000;

/// The report as an HTML file, with the pictures in `plots` (SVG or PNG) in their order.
///
/// # Errors
/// A folder that is no run; damaged frames are left out of the replay and named.
pub fn report(run: &Run, plots: &[PathBuf], limits: Limits) -> Result<String, Problem> {
    let manifest = run.manifest()?;
    let mut out = String::new();
    let title = if manifest.title.is_empty() {
        "A run of riprap"
    } else {
        &manifest.title
    };
    let title = escape(title);
    let _ = write!(
        out,
        "<!doctype html>\n<html lang=\"en\" class=\"report\" data-theme=\"light\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
         <style>{STYLE}</style>\n<style>{LAYOUT}</style>\n</head>\n<body>\n<article>\n<h1>{title}</h1>\n"
    );
    facts(&mut out, &manifest);
    groups(&mut out, &run.names());
    for warning in &manifest.warnings {
        let _ = writeln!(out, "<p class=\"warning\">{}</p>", escape(warning));
    }
    checks(&mut out, run);
    replay(&mut out, run, limits);
    pictures(&mut out, plots);
    energy(&mut out, run);
    events(&mut out, run);
    scene(&mut out, run, &manifest);
    provenance(&mut out, &manifest);
    out.push_str("</article>\n<script type=\"module\">");
    // Nothing in the script may end it.
    out.push_str(&SCRIPT.replace("</script", "<\\/script"));
    out.push_str("</script>\n</body>\n</html>\n");
    Ok(out)
}

/// Text for HTML.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

fn table<'a>(out: &mut String, class: &str, rows: impl IntoIterator<Item = (&'a str, String)>) {
    let _ = writeln!(out, "<table class=\"{class}\">");
    for (name, value) in rows {
        if !value.is_empty() {
            let _ = writeln!(
                out,
                "<tr><th>{}</th><td>{}</td></tr>",
                escape(name),
                escape(&value)
            );
        }
    }
    out.push_str("</table>\n");
}

/// Groups of blocks, with what is in them.
fn groups(out: &mut String, names: &Names) {
    if names.groups.is_empty() {
        return;
    }
    out.push_str("<h2>Groups</h2>\n<table class=\"grid\"><tr><th>group</th><th>blocks</th><th>from</th><th>to</th></tr>\n");
    for group in &names.groups {
        let count: u64 = group
            .blocks
            .iter()
            .map(|[a, b]| 1 + u64::from(b.saturating_sub(*a)))
            .sum();
        let name = |number: Option<u32>| number.and_then(|n| names.block(n)).unwrap_or_default();
        let ends = [
            group.blocks.first().map(|b| b[0]),
            group.blocks.last().map(|b| b[1]),
        ];
        let _ = writeln!(
            out,
            "<tr><td>{}</td><td>{count}</td><td>{}</td><td>{}</td></tr>",
            escape(&group.name),
            escape(&name(ends[0])),
            escape(&name(ends[1]))
        );
    }
    out.push_str("</table>\n");
}

fn facts(out: &mut String, m: &Manifest) {
    let ended = serde_json::to_value(m.ended).unwrap_or_default();
    let ended = ended.as_str().unwrap_or_default();
    let mut how = ended.to_owned();
    if !m.message.is_empty() {
        let _ = write!(how, ": {}", m.message);
    }
    let case = [&m.variant, &m.case]
        .into_iter()
        .filter(|c| !c.is_empty() && *c != "default")
        .cloned()
        .collect::<Vec<_>>()
        .join(", ");
    let changed = m
        .overrides
        .iter()
        .map(|o| format!("{} = {}", o.key, o.value))
        .collect::<Vec<_>>()
        .join("; ");
    table(
        out,
        "facts",
        [
            ("ended", how),
            ("scene", m.scenario.clone()),
            ("case", case),
            ("changed", changed),
            ("model time", format!("{} s", short(m.time))),
            ("steps", m.steps.to_string()),
            ("last time step", format!("{} s", short(m.dt))),
            ("started", m.started.replace('T', " ").replace('Z', " UTC")),
            ("wall time", format!("{} s", short(m.wall_time))),
        ],
    );
    if !m.sources.is_empty() {
        out.push_str("<h2>Charges</h2>\n<table class=\"grid\"><tr><th>name</th><th>centre [m]</th><th>delay [s]</th><th>mass [kg]</th><th>cavity [m³]</th><th>depth [m]</th></tr>\n");
        for s in &m.sources {
            let centre = s.centre().map(short).join(", ");
            let maybe = |v: Option<f64>| v.map_or_else(String::new, short);
            let _ = writeln!(
                out,
                "<tr><td>{}</td><td>{centre}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
                escape(&s.name),
                short(s.delay),
                maybe(s.mass),
                short(s.cavity_volume),
                maybe(s.depth)
            );
        }
        out.push_str("</table>\n");
    }
}

/// A number with few digits.
fn short(v: f64) -> String {
    if v == 0.0 || (1e-3..1e5).contains(&v.abs()) {
        let text = format!("{v:.6}");
        let text = text.trim_end_matches('0').trim_end_matches('.');
        text.to_owned()
    } else {
        format!("{v:.4e}")
    }
}

fn text_of(value: &Value, key: &str) -> String {
    match &value[key] {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        Value::Number(n) => n.as_f64().map_or_else(|| n.to_string(), short),
        other => other.to_string(),
    }
}

fn checks(out: &mut String, run: &Run) {
    let lines = run.lines("checks.jsonl");
    if lines.is_empty() {
        return;
    }
    let count = |status: &str| lines.iter().filter(|l| l["status"] == status).count();
    let _ = writeln!(
        out,
        "<h2>Checks</h2>\n<p>{} passed, {} failed, {} skipped (known failures, shown with their reason).</p>",
        count("passed"),
        count("failed"),
        count("skipped")
    );
    out.push_str("<table class=\"grid\"><tr><th></th><th>check</th><th>measured</th><th>expected</th><th>tolerance</th></tr>\n");
    for line in &lines {
        let status = text_of(line, "status");
        let unit = text_of(line, "unit");
        let unit = if unit == "-" { "" } else { &unit };
        let note = text_of(line, "note");
        let note = if note.is_empty() {
            note
        } else {
            format!("<br><small>{}</small>", escape(&note))
        };
        let _ = writeln!(
            out,
            "<tr class=\"{0}\"><td>{0}</td><td>{1}{note}</td><td>{2} {3}</td><td>{4}</td><td>{5}</td></tr>",
            escape(&status),
            escape(&text_of(line, "check")),
            escape(&text_of(line, "measured")),
            escape(unit),
            escape(&text_of(line, "expected")),
            escape(&text_of(line, "tolerance")),
        );
    }
    out.push_str("</table>\n");
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
        "<h2>Replay</h2>\n<p class=\"screen\">{kept} frames. Drag to turn, wheel to come nearer, space to play, ? for the keys.</p>\n\
         <div id=\"app\" class=\"replay\"></div>"
    );
    for note in &book.notes {
        let _ = writeln!(out, "<p class=\"warning\">{}</p>", escape(note));
    }
    let answers = Value::Object(book.answers)
        .to_string()
        .replace('<', "\\u003c");
    let _ = writeln!(
        out,
        "<script type=\"application/json\" id=\"riprap-run\">{answers}</script>"
    );
}

/// Answers by their questions, packed.
#[derive(Default)]
struct Book {
    answers: Map<String, Value>,
    bytes: usize,
    notes: Vec<String>,
}

impl Book {
    fn put(&mut self, question: String, bytes: &[u8]) {
        let mut packer = GzEncoder::new(Vec::new(), Compression::default());
        // Writing into memory cannot fail.
        let _ = packer.write_all(bytes);
        let packed = packer.finish().unwrap_or_default();
        let text = base64::engine::general_purpose::STANDARD.encode(packed);
        self.bytes += text.len();
        self.answers.insert(question, Value::String(text));
    }

    /// Answers a question about frame `k` under the number that the frame has in the report.
    fn ask(
        &mut self,
        run: &Run,
        question: &str,
        name: Option<&str>,
        as_question: &str,
    ) -> Result<(), Problem> {
        let found = |key: &str| match (key, name) {
            ("name", Some(name)) => Some(name.to_owned()),
            (_, _) => None,
        };
        let answer = answer(run, question, &Query(&found))?;
        let question = match name {
            Some(name) => format!("{as_question}?name={name}"),
            None => as_question.to_owned(),
        };
        self.put(question, &answer.bytes);
        Ok(())
    }

    /// Fills it with as many frames as there is room for; how many.
    fn fill(&mut self, run: &Run, limits: Limits) -> Result<usize, Problem> {
        let times = run.frames()?;
        let mut told = summary(run);
        let names: Vec<String> = told["fields"]
            .as_array()
            .into_iter()
            .flatten()
            .filter_map(|f| f["name"].as_str().map(str::to_owned))
            .filter(|n| FIELDS.contains(&n.as_str()))
            .collect();
        let mut chosen = spread(times.len(), limits.frames);
        let mut sound = Vec::new();
        // Too large with all frames: half of them, and so on. The motion comes first, fields as there is room.
        loop {
            *self = Book::default();
            sound.clear();
            for &k in &chosen {
                let n = sound.len();
                let done = self
                    .ask(run, &format!("frame/{k}"), None, &format!("frame/{n}"))
                    .and_then(|()| {
                        self.ask(run, &format!("shape/{k}"), None, &format!("shape/{n}"))
                    });
                match done {
                    Ok(()) => sound.push(k),
                    Err(problem) => self
                        .notes
                        .push(format!("frame {} is left out: {problem}", k + 1)),
                }
                if self.bytes > limits.bytes {
                    break;
                }
            }
            if self.bytes <= limits.bytes || chosen.len() < 2 {
                break;
            }
            chosen = spread(times.len(), chosen.len() / 2);
        }
        if sound.is_empty() {
            return Err(Problem::missing(
                "There is no frame that could be shown.",
                "Ask for frames in the scene: [[outputs]] frames = { every = ... }",
            ));
        }
        self.same_shapes();
        let mut offered = Vec::new();
        for name in names {
            let before = self.answers.clone();
            let bytes = self.bytes;
            for (n, k) in sound.iter().enumerate() {
                // A field that one frame lacks is missing there.
                let _ = self.ask(
                    run,
                    &format!("field/{k}"),
                    Some(&name),
                    &format!("field/{n}"),
                );
            }
            if self.bytes > limits.bytes && !offered.is_empty() {
                self.answers = before;
                self.bytes = bytes;
                break;
            }
            let whole = |key: &str| (key == "name").then(|| name.clone());
            let range = answer(run, "range", &Query(&whole))?;
            self.put(format!("range?name={name}"), &range.bytes);
            offered.push(name);
        }
        for name in ["histories", "energy"] {
            let bytes = thinned(run, name);
            self.put(format!("table/{name}"), &bytes);
        }
        told["times"] = sound.iter().map(|k| json!(times[*k].time)).collect();
        told["names"] = json!(offered);
        told["held"] = json!(true);
        told["live"] = json!(false);
        self.put("summary".to_owned(), told.to_string().as_bytes());
        Ok(sound.len())
    }

    /// A shape that several frames share is kept once: the page asks for the shape of the first of them.
    fn same_shapes(&mut self) {
        let mut seen: Vec<Value> = Vec::new();
        let shapes: Vec<String> = self
            .answers
            .keys()
            .filter(|k| k.starts_with("shape/"))
            .cloned()
            .collect();
        let mut shapes = shapes;
        shapes.sort_by_key(|s| s[6..].parse::<usize>().unwrap_or(0));
        for question in shapes {
            let text = self.answers[&question].clone();
            if let Some(first) = seen.iter().find(|s| s["text"] == text) {
                self.bytes -= text.as_str().map_or(0, str::len);
                self.answers
                    .insert(question, json!({ "as": first["question"] }));
            } else {
                seen.push(json!({ "question": question, "text": text }));
            }
        }
    }
}

/// At most `count` of `0..all`, evenly, the first and the last among them.
fn spread(all: usize, count: usize) -> Vec<usize> {
    let count = count.max(2);
    if all <= count {
        return (0..all).collect();
    }
    (0..count).map(|i| i * (all - 1) / (count - 1)).collect()
}

/// A table with at most [`ROWS`] rows.
fn thinned(run: &Run, name: &str) -> Vec<u8> {
    let table = run.table(&format!("{name}.csv")).ok().flatten();
    let columns = table.map_or_else(Vec::new, |t| t.columns);
    let rows = columns.iter().map(|c| c.values.len()).min().unwrap_or(0);
    let kept = spread(rows, ROWS);
    let mut wire = crate::wire::Wire::default();
    for (i, column) in columns.iter().enumerate() {
        let values: Vec<f64> = kept.iter().map(|r| column.values[*r]).collect();
        wire = wire.f64(&i.to_string(), &values);
    }
    let heads: Vec<Value> = columns
        .iter()
        .map(|c| json!({ "name": c.name, "unit": c.unit }))
        .collect();
    wire.finish(&json!({ "columns": heads, "cut": false }))
}

fn pictures(out: &mut String, plots: &[PathBuf]) {
    let mut headed = false;
    for path in plots {
        let kind = match path.extension().and_then(|e| e.to_str()) {
            Some("svg") => "image/svg+xml",
            Some("png") => "image/png",
            Some(_) | None => continue,
        };
        let Ok(bytes) = std::fs::read(path) else {
            continue;
        };
        if !headed {
            out.push_str("<h2>Plots</h2>\n");
            headed = true;
        }
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let _ = writeln!(
            out,
            "<figure><img alt=\"{0}\" src=\"data:{kind};base64,{1}\"><figcaption>{0}</figcaption></figure>",
            escape(&name),
            base64::engine::general_purpose::STANDARD.encode(bytes)
        );
    }
}

fn energy(out: &mut String, run: &Run) {
    let Ok(Some(table)) = run.table("energy.csv") else {
        return;
    };
    let terms: Vec<_> = table
        .columns
        .iter()
        .filter(|c| c.name != "step" && c.name != "time")
        .filter_map(|c| Some((c, *c.values.first()?, *c.values.last()?)))
        .collect();
    if terms.is_empty() {
        return;
    }
    out.push_str("<h2>Energy ledger</h2>\n<table class=\"grid\"><tr><th>term</th><th>at the start</th><th>at the end</th><th>unit</th></tr>\n");
    for (column, first, last) in terms {
        let _ = writeln!(
            out,
            "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            escape(&column.name),
            short(first),
            short(last),
            escape(&column.unit)
        );
    }
    out.push_str("</table>\n<p><small>The residual is zero but for the error of time integration and rounding.</small></p>\n");
}

fn events(out: &mut String, run: &Run) {
    let lines = run.lines("events.jsonl");
    if lines.is_empty() {
        return;
    }
    let mut counts: std::collections::BTreeMap<String, (usize, f64, f64)> = Default::default();
    for line in &lines {
        let time = line["time"].as_f64().unwrap_or(f64::NAN);
        let entry = counts
            .entry(text_of(line, "event"))
            .or_insert((0, time, time));
        entry.0 += 1;
        entry.2 = time;
    }
    out.push_str("<h2>Events</h2>\n<table class=\"grid\"><tr><th>event</th><th>how often</th><th>first [s]</th><th>last [s]</th></tr>\n");
    for (event, (count, first, last)) in counts {
        let _ = writeln!(
            out,
            "<tr><td>{}</td><td>{count}</td><td>{}</td><td>{}</td></tr>",
            escape(&event.replace('_', " ")),
            short(first),
            short(last)
        );
    }
    out.push_str("</table>\n");
}

fn scene(out: &mut String, run: &Run, manifest: &Manifest) {
    let bytes = run.file("scenario.resolved.toml").unwrap_or_default();
    if bytes.is_empty() {
        return;
    }
    let _ = writeln!(
        out,
        "<h2>The scene as run</h2>\n<p>{} with all changes; it runs as it stands.</p>\n<pre>{}</pre>",
        escape(&manifest.scenario),
        escape(&String::from_utf8_lossy(&bytes))
    );
}

fn provenance(out: &mut String, m: &Manifest) {
    out.push_str("<h2>Versions and hashes</h2>\n");
    let machine = [
        m.machine.cpu.clone(),
        m.machine.arch.clone(),
        m.machine.os.clone(),
        format!("{} cores", m.machine.cores),
    ];
    let machine: Vec<String> = machine.into_iter().filter(|t| !t.is_empty()).collect();
    table(
        out,
        "facts",
        [
            ("riprap", m.riprap.clone()),
            ("report written by", env!("CARGO_PKG_VERSION").to_owned()),
            ("input hash", m.input_hash.clone()),
            ("state hash", m.state_hash.clone()),
            ("machine", machine.join(", ")),
            ("threads", m.threads.to_string()),
        ],
    );
    if !m.profile.is_empty() {
        let all: f64 = m.profile.iter().map(|s| s.seconds).sum();
        out.push_str("<table class=\"grid\"><tr><th>stage of the step</th><th>time [s]</th><th>share</th></tr>\n");
        for stage in m.profile.iter().filter(|s| s.seconds > 0.0) {
            let _ = writeln!(
                out,
                "<tr><td>{}</td><td>{:.3}</td><td>{:.1} %</td></tr>",
                escape(&stage.name),
                stage.seconds,
                100.0 * stage.seconds / all
            );
        }
        out.push_str("</table>\n");
    }
    out.push_str("<p><small>Equal input hashes mean the same scene and files; equal state hashes mean the same final state, bit for bit, on any number of threads.</small></p>\n");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_spread_evenly() {
        assert_eq!(spread(3, 40), [0, 1, 2]);
        assert_eq!(spread(100, 4), [0, 33, 66, 99]);
        assert!(spread(0, 4).is_empty());
    }

    #[test]
    fn text_of_a_run_cannot_become_html() {
        assert_eq!(
            escape("<b>\"&\"</b>"),
            "&lt;b&gt;&quot;&amp;&quot;&lt;/b&gt;"
        );
    }
}
