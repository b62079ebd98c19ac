//! The parts of the report that print: facts, checks, plots, energy, events, scene, versions.

use base64::Engine as _;
use riprap_record::manifest::Manifest;
use riprap_record::names::Names;
use std::fmt::Write as _;
use std::path::PathBuf;

use super::Signature;
use super::html::{escape, rounded, short, superscript, table, text_of};
use crate::run::Run;

/// Groups of blocks, with what is in them.
pub(super) fn groups(out: &mut String, names: &Names) {
    if names.groups.is_empty() {
        return;
    }
    out.push_str("<h2>Groups</h2>\n<table class=\"grid\"><tr><th>group</th><th>blocks</th><th>from</th><th>to</th></tr>\n");
    for group in &names.groups {
        let count: u64 = group
            .blocks
            .iter()
            // A damaged file may have the ends the other way round.
            .map(|[a, b]| 1 + u64::from(b.saturating_sub(*a)))
            .sum();
        let name = |number: Option<u32>| number.and_then(|n| names.block(n)).unwrap_or_default();
        let ends = [group.blocks.first().map(|b| b[0]), group.blocks.last().map(|b| b[1])];
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

pub(super) fn facts(out: &mut String, m: &Manifest, signature: &Signature) {
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
            ("project", signature.project.clone()),
            ("author", signature.author.clone()),
            ("ended", how),
            ("scene", m.scenario.clone()),
            ("case", case),
            ("changed", changed),
            ("model time", format!("{} s", short(m.time))),
            ("steps", m.steps.to_string()),
            ("last time step", format!("{} s", rounded(m.dt, m.dt))),
            ("started", m.started.replace('T', " ").replace('Z', " UTC")),
            ("wall time", format!("{} s", rounded(m.wall_time, m.wall_time))),
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

pub(super) fn checks(out: &mut String, run: &Run) {
    let lines = run.lines("checks.jsonl");
    if lines.is_empty() {
        return;
    }
    let count =
        |status: &str, words: &str| match lines.iter().filter(|l| l["status"] == status).count() {
            0 => None,
            count => Some(format!("{count} {words}")),
        };
    let counts = [
        count("passed", "passed"),
        count("failed", "failed"),
        count("skipped", "skipped (known failures, shown with their reason)"),
    ];
    let counts: Vec<String> = counts.into_iter().flatten().collect();
    let _ = writeln!(out, "<h2>Checks</h2>\n<p>{}.</p>", counts.join(", "));
    out.push_str(
        "<table class=\"grid\"><tr><th></th><th>check</th><th>measured, expected</th></tr>\n",
    );
    for line in &lines {
        let status = text_of(line, "status");
        let note = text_of(line, "note");
        let note =
            if note.is_empty() { note } else { format!("<br><small>{}</small>", escape(&note)) };
        let _ = writeln!(
            out,
            "<tr class=\"{0}\"><td>{0}</td><td>{1}{note}</td><td>{2}</td></tr>",
            escape(&status),
            escape(&text_of(line, "check")),
            escape(&superscript(&text_of(line, "words"))),
        );
    }
    out.push_str("</table>\n");
}

/// The results with their errors, where the run was asked for them.
pub(super) fn trust(out: &mut String, run: &Run) {
    let Some(answer) = run.json("trust.json") else {
        return;
    };
    let results = answer["results"].as_array().map_or(&[][..], Vec::as_slice);
    out.push_str(
        "<h2>Errors of the results</h2>\n<p>Each with what the causes add to its error, found by runs with one thing changed at a time.</p>\n\
         <table class=\"grid\"><tr><th>result</th><th>value</th><th>causes</th></tr>\n",
    );
    for result in results {
        let advice = match text_of(result, "advice") {
            advice if advice.is_empty() => advice,
            advice => format!("<br><small>{}</small>", escape(&advice)),
        };
        let _ = writeln!(
            out,
            "<tr><td>{}{advice}</td><td>{}</td><td>{}</td></tr>",
            escape(&text_of(result, "name")),
            escape(&text_of(result, "shown").replace("+-", "\u{b1}")),
            escape(&text_of(result, "shares")),
        );
    }
    out.push_str("</table>\n");
    for left in answer["left_out"].as_array().into_iter().flatten() {
        let text = |k: usize| left[k].as_str().unwrap_or_default();
        let _ = writeln!(
            out,
            "<p><small>not varied: {} ({})</small></p>",
            escape(text(0)),
            escape(text(1))
        );
    }
}

/// What a picture shows, by the name of its file.
fn caption(stem: &str) -> String {
    let known = match stem {
        "setup" => "The model before the first step, coloured by material",
        "setup_view" => {
            "The model before the first step, coloured by material; seen from the south-west"
        }
        "setup_section" => "A section through it, coloured by material",
        "energy" => "Energies over time",
        "histories" => "Histories of the scene",
        "stereonet" => "Poles of joints and cracks",
        "rose" => "Directions of joints and cracks",
        "fragments" => "Sizes of the fragments",
        "ppv" => "Peak particle velocity against scaled distance, with the site law",
        "crater" => "Uplift of the surface around the charge, and the radius of the crater",
        "heave" => "Profiles of the surface above the charge",
        "cavity" => "Pressure and volume of the cavities",
        "trust" => "Results with their errors",
        "section" => "A section through the blocks",
        other => {
            return match other.split_once('_') {
                Some(("blocks", field)) => format!("The blocks, coloured by {}", words(field)),
                Some(("section", field)) => format!("A section, coloured by {}", words(field)),
                Some(("spectrum", of)) => format!("Amplitude spectrum of {}", words(of)),
                Some(_) | None => capital(&words(other)),
            };
        }
    };
    known.to_owned()
}

fn words(name: &str) -> String {
    name.replace('_', " ")
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |c| c.to_uppercase().chain(letters).collect())
}

pub(super) fn pictures(out: &mut String, head: &str, plots: &[&PathBuf]) {
    let mut headed = false;
    for path in plots {
        let kind = match path.extension().and_then(|e| e.to_str()) {
            Some("svg") => "image/svg+xml",
            Some("png") => "image/png",
            Some(_) | None => continue,
        };
        let Ok(bytes) = riprap_record::read_plain(path) else {
            continue;
        };
        if !headed {
            let _ = writeln!(out, "<h2>{head}</h2>");
            headed = true;
        }
        let name = caption(&path.file_stem().unwrap_or_default().to_string_lossy());
        let _ = writeln!(
            out,
            "<figure><img alt=\"{0}\" src=\"data:{kind};base64,{1}\"><figcaption>{0}</figcaption></figure>",
            escape(&name),
            base64::engine::general_purpose::STANDARD.encode(bytes)
        );
    }
}

pub(super) fn energy(out: &mut String, run: &Run) {
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
    // Rows of what the run does not have hide the others.
    let (terms, nil): (Vec<_>, Vec<_>) =
        terms.into_iter().partition(|(c, ..)| c.values.iter().any(|v| *v != 0.0));
    out.push_str("<h2>Energy ledger</h2>\n<table class=\"grid\"><tr><th>term</th><th>at the start</th><th>at the end</th><th>unit</th></tr>\n");
    let largest = terms.iter().flat_map(|(_, a, b)| [a.abs(), b.abs()]);
    let largest = largest.filter(|v| v.is_finite()).fold(0.0, f64::max);
    for (column, first, last) in terms {
        // A ratio, as the residual over the largest energy, is none of the energies.
        let whole = if column.unit == "-" { 0.0 } else { largest };
        let _ = writeln!(
            out,
            "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            escape(&column.name),
            rounded(first, whole),
            rounded(last, whole),
            escape(&column.unit)
        );
    }
    out.push_str("</table>\n<p><small>The residual is zero except for the errors of time integration and rounding.");
    if !nil.is_empty() {
        let names: Vec<String> = nil.iter().map(|(c, ..)| escape(&c.name)).collect();
        let _ = write!(out, " Zero throughout: {}.", names.join(", "));
    }
    out.push_str("</small></p>\n");
}

/// Work of boundaries, supports and loads.
pub(super) fn works(out: &mut String, m: &Manifest) {
    let some: Vec<_> = m.works.iter().filter(|w| w.work != 0.0).collect();
    if some.is_empty() {
        return;
    }
    out.push_str("<h2>Work of boundaries, supports and loads</h2>\n<table class=\"grid\"><tr><th></th><th>name</th><th>work</th><th>unit</th></tr>\n");
    for w in some {
        let _ = writeln!(
            out,
            "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            escape(&w.of),
            escape(&w.name),
            short(w.work),
            escape(&w.unit)
        );
    }
    out.push_str("</table>\n");
}

pub(super) fn events(out: &mut String, run: &Run) {
    let mut counts: std::collections::BTreeMap<String, (usize, f64, f64)> = Default::default();
    let read = run.each_line("events.jsonl", &mut |line| {
        let time = line["time"].as_f64().unwrap_or(f64::NAN);
        let entry = counts.entry(text_of(&line, "event")).or_insert((0, time, time));
        entry.0 += 1;
        entry.2 = time;
        true
    });
    if counts.is_empty() && read.is_ok() {
        return;
    }
    out.push_str("<h2>Events</h2>\n<table class=\"grid\"><tr><th>event</th><th>count</th><th>first [s]</th><th>last [s]</th></tr>\n");
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
    if let Err(problem) = read {
        let _ = writeln!(
            out,
            "<p class=\"warning\">There may be more: {} {}</p>",
            escape(&problem.what),
            escape(&problem.hint)
        );
    }
}

pub(super) fn scene(out: &mut String, run: &Run, manifest: &Manifest) {
    let bytes = run.file("scenario.resolved.toml").unwrap_or_default();
    if bytes.is_empty() {
        return;
    }
    let _ = writeln!(
        out,
        "<h2>The scene as run</h2>\n<p>{} with all changes; it can be run unchanged.</p>\n<pre>{}</pre>",
        escape(&manifest.scenario),
        escape(&String::from_utf8_lossy(&bytes))
    );
}

pub(super) fn provenance(out: &mut String, m: &Manifest) {
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
        out.push_str("<table class=\"grid\"><tr><th>stage of the step</th><th>time [s]</th><th>share</th><th>on one thread</th></tr>\n");
        for stage in m.profile.iter().filter(|s| s.seconds > 0.0) {
            let _ = writeln!(
                out,
                "<tr><td>{}</td><td>{:.3}</td><td>{:.1} %</td><td>{:.1} %</td></tr>",
                escape(&stage.name),
                stage.seconds,
                100.0 * stage.seconds / all,
                100.0 * (1.0 - stage.pooled / stage.seconds)
            );
        }
        out.push_str("</table>\n");
    }
    out.push_str("<p><small>Equal input hashes mean the same scene and files; equal state hashes mean the same final state, bit for bit, on any number of threads.</small></p>\n");
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture;
    use std::io::Write as _;

    #[test]
    fn captions_are_words() {
        for (stem, words) in [
            ("setup", "The model before the first step, coloured by material"),
            ("blocks_displacement", "The blocks, coloured by displacement"),
            ("section_peak_speed", "A section, coloured by peak speed"),
            ("spectrum_house.velocity", "Amplitude spectrum of house.velocity"),
            ("my_own_picture", "My own picture"),
        ] {
            assert_eq!(caption(stem), words);
        }
    }

    #[test]
    fn events_are_counted_over_the_whole_file() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("long.run");
        fixture::write_run(&path, 1);
        let file = std::fs::File::create(path.join("events.jsonl")).unwrap();
        let mut file = std::io::BufWriter::new(file);
        for k in 0..30_000 {
            writeln!(file, "{{\"event\":\"contact_broken\",\"time\":{k}}}").unwrap();
            if k == 10 {
                // No line of ours, whole and longer than any.
                writeln!(file, "nonsense").unwrap();
                writeln!(file, "{}", "[".repeat(3 << 20)).unwrap();
            }
        }
        // Being written.
        write!(file, "{{\"event\":\"contact_broken\",\"time\":1e9}}").unwrap();
        drop(file);
        let (run, mut out) = (Run::new(&path), String::new());
        events(&mut out, &run);
        assert!(
            out.contains("<td>contact broken</td><td>30000</td><td>0</td><td>29999</td>"),
            "{out}"
        );
        assert_eq!(run.lines("events.jsonl").len(), 20_000);
        std::fs::remove_file(path.join("events.jsonl")).unwrap();
        let mut none = String::new();
        events(&mut none, &run);
        assert!(none.is_empty());
        // What cannot be read is reported.
        std::fs::create_dir(path.join("events.jsonl")).unwrap();
        events(&mut none, &run);
        assert!(none.contains("not a regular file"), "{none}");
    }
}
