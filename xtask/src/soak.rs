//! `cargo xtask soak`: a run that never ends beside a viewer that follows it, for an hour: what they take of memory and descriptors, and how fast the run goes.
//!
//! The scene is `scenes/bench/soak.toml`. Every ten seconds both processes are looked at through `/proc`, and the page asks the viewer what a browser would
//! ask. Speed is in steps for each second of processor time, so that other work on the machine does not enter. Written: `docs/src/soak.csv` and a page with
//! pictures, `docs/src/soak.md`.

use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

use crate::verify;

const SCENE: &str = "scenes/bench/soak.toml";
const PAGE: &str = "docs/src/soak.md";
const TABLE: &str = "docs/src/soak.csv";
/// Between two looks.
const LOOK: Duration = Duration::from_secs(10);
/// Looks that the speed is a mean over.
const OVER: usize = 12;
/// What the viewer may take at most in answering one question.
const PATIENCE: Duration = Duration::from_secs(20);
/// Growth of memory over the last quarter, as a share, from which on it is a failure.
const GROWTH: f64 = 0.05;

/// One look at both.
#[derive(Clone, Copy, Debug)]
struct Look {
    seconds: f64,
    /// Resident memory of run and viewer, MB.
    memory: [f64; 2],
    /// Open descriptors of both.
    descriptors: [usize; 2],
    /// Steps of the run for each second of processor time, over the last [`OVER`] looks: tables are written in batches.
    speed: f64,
}

/// `cargo xtask soak [--minutes N] [--binary FILE]`, or `--table`: runs nothing, draws the table that is there.
pub fn run(root: &Path, words: &[&str]) -> ExitCode {
    match soak(root, words) {
        Ok(failures) if failures.is_empty() => ExitCode::SUCCESS,
        Ok(failures) => {
            failures.iter().for_each(|f| eprintln!("{f}"));
            ExitCode::FAILURE
        }
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

/// Two processes that end with this.
struct Both {
    run: Child,
    view: Child,
}

impl Drop for Both {
    fn drop(&mut self) {
        for child in [&mut self.run, &mut self.view] {
            // One that has ended already cannot be killed; nothing else can go wrong here that anybody could cure.
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

fn soak(root: &Path, words: &[&str]) -> Result<Vec<String>, String> {
    if words == ["--table"] {
        let looks = read(root)?;
        let failures = grown(&looks);
        write(root, &looks, &failures)?;
        return Ok(failures);
    }
    let (mut minutes, mut binary) = (60.0, None);
    let mut words = words.iter();
    while let Some(word) = words.next() {
        let value = words.next().ok_or_else(|| format!("{word} needs a value"))?;
        match *word {
            "--minutes" => {
                minutes = value.parse().map_err(|_| "--minutes needs a number".to_owned())?;
            }
            "--binary" => binary = Some(root.join(value)),
            other => return Err(format!("there is no option {other}")),
        }
    }
    let binary = match binary {
        Some(binary) => binary,
        None => root.join(verify::ci_binary(root)?),
    };
    let folder = root.join("target/soak");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let results = folder.join("soak.run");
    let (mut both, address) = start(root, &binary, &folder, &results)?;
    let begun = Instant::now();
    let mut looks: Vec<Look> = Vec::new();
    let mut marks = vec![(0.0, 0.0)];
    let mut failures = Vec::new();
    while begun.elapsed().as_secs_f64() < 60.0 * minutes {
        std::thread::sleep(LOOK);
        if let Some(code) = both.run.try_wait().map_err(|e| e.to_string())? {
            failures.push(format!("the run ended by itself: {code}"));
            break;
        }
        for question in
            ["summary", "frame/0", "field/0?name=velocity", "table/histories", "table/energy"]
        {
            if let Err(why) = ask(&address, question) {
                failures.push(format!("the viewer did not answer {question}: {why}"));
            }
        }
        let now = (processor(both.run.id())?, steps(&results));
        let before = marks[marks.len().saturating_sub(OVER)];
        looks.push(Look {
            seconds: begun.elapsed().as_secs_f64(),
            memory: [memory(both.run.id())?, memory(both.view.id())?],
            descriptors: [descriptors(both.run.id())?, descriptors(both.view.id())?],
            speed: (now.1 - before.1) / (now.0 - before.0),
        });
        marks.push(now);
        if failures.len() > 3 {
            break;
        }
    }
    drop(both);
    failures.extend(grown(&looks));
    write(root, &looks, &failures)?;
    Ok(failures)
}

/// Starts the run and, once it has frames, the viewer; its address.
fn start(
    root: &Path,
    binary: &Path,
    folder: &Path,
    results: &Path,
) -> Result<(Both, String), String> {
    let command = || {
        let mut command = Command::new(binary);
        command.stdin(Stdio::null()).stderr(Stdio::null());
        command
    };
    let run = command()
        .args(["run", "-q", "-j", "1", "-o"])
        .args([results, &root.join(SCENE)])
        .current_dir(folder)
        .stdout(Stdio::null())
        .spawn();
    let mut run = run.map_err(|e| format!("{}: {e}", binary.display()))?;
    let begun = Instant::now();
    while !results.join("run.pvd").exists() {
        if begun.elapsed() > PATIENCE || run.try_wait().is_ok_and(|ended| ended.is_some()) {
            let _ = run.kill();
            return Err(format!("the run has no frames after {PATIENCE:?}"));
        }
        std::thread::sleep(Duration::from_millis(100));
    }
    let view = command().args(["view", "--no-open"]).arg(results).stdout(Stdio::piped()).spawn();
    let mut view = view.map_err(|e| format!("{}: {e}", binary.display()))?;
    let said = view.stdout.take().ok_or("the viewer says nothing")?;
    let mut address = None;
    for line in BufReader::new(said).lines().map_while(Result::ok).take(20) {
        if let Some(at) = line.find("http://") {
            address = line[at..].split_whitespace().next().map(str::to_owned);
            break;
        }
    }
    let both = Both { run, view };
    let address = address.ok_or("the viewer did not say where it is")?;
    Ok((both, address))
}

/// Asks the viewer one question and reads the answer to its end.
fn ask(address: &str, question: &str) -> Result<usize, String> {
    let rest = address.strip_prefix("http://").unwrap_or(address);
    let (host, path) = rest.split_once('/').unwrap_or((rest, ""));
    let mut stream = TcpStream::connect(host).map_err(|e| e.to_string())?;
    stream.set_read_timeout(Some(PATIENCE)).map_err(|e| e.to_string())?;
    let path = path.trim_end_matches('/');
    write!(
        stream,
        "GET /{path}/api/0/{question} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n"
    )
    .map_err(|e| e.to_string())?;
    let mut answer = Vec::new();
    stream.read_to_end(&mut answer).map_err(|e| e.to_string())?;
    let head = String::from_utf8_lossy(&answer[..answer.len().min(64)]).into_owned();
    match head.starts_with("HTTP/1.1 200") {
        true => Ok(answer.len()),
        false => Err(head.lines().next().unwrap_or("nothing").to_owned()),
    }
}

/// Resident memory of a process, MB.
fn memory(id: u32) -> Result<f64, String> {
    let text = std::fs::read_to_string(format!("/proc/{id}/status")).map_err(|e| e.to_string())?;
    let line = text.lines().find_map(|l| l.strip_prefix("VmRSS:"));
    let kilobytes = line.and_then(|l| l.split_whitespace().next()?.parse::<f64>().ok());
    kilobytes.map(|k| k / 1000.0).ok_or_else(|| "no VmRSS".to_owned())
}

fn descriptors(id: u32) -> Result<usize, String> {
    let list = std::fs::read_dir(format!("/proc/{id}/fd")).map_err(|e| e.to_string())?;
    Ok(list.count())
}

/// Processor time of a process, s: user and system, in hundredths as Linux counts them.
fn processor(id: u32) -> Result<f64, String> {
    let text = std::fs::read_to_string(format!("/proc/{id}/stat")).map_err(|e| e.to_string())?;
    let (_, rest) = text.rsplit_once(')').ok_or("no stat")?;
    let fields: Vec<f64> =
        rest.split_whitespace().skip(11).take(2).filter_map(|f| f.parse().ok()).collect();
    Ok(fields.iter().sum::<f64>() / 100.0)
}

/// Steps of the run so far, as its table of histories says.
fn steps(results: &Path) -> f64 {
    let text = std::fs::read_to_string(results.join("histories.csv")).unwrap_or_default();
    let last = text.lines().rev().find(|l| !l.is_empty());
    last.and_then(|l| l.split(',').next()?.parse().ok()).unwrap_or(0.0)
}

/// The looks of the table that is there.
fn read(root: &Path) -> Result<Vec<Look>, String> {
    let path = root.join(TABLE);
    let text = std::fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))?;
    let look = |line: &str| {
        let cells: Vec<f64> =
            line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect();
        match cells[..] {
            [seconds, m, n, d, e, speed] => {
                Ok(Look { seconds, memory: [m, n], descriptors: [d as usize, e as usize], speed })
            }
            _ => Err(format!("{}: {line:?} is no look", path.display())),
        }
    };
    text.lines().skip(1).map(look).collect()
}

/// What has grown over the last quarter.
fn grown(looks: &[Look]) -> Vec<String> {
    let mut out = Vec::new();
    let (third, last) = (looks.len() / 2, 3 * looks.len() / 4);
    if last == third {
        return vec!["it was looked at too seldom".to_owned()];
    }
    let most = |part: &[Look], get: &dyn Fn(&Look) -> f64| part.iter().map(get).fold(0.0, f64::max);
    let both = |get: &dyn Fn(&Look) -> f64| {
        let parts = [&looks[third..last], &looks[last..]];
        parts.map(|part| most(part, get))
    };
    for (k, who) in ["the run", "the viewer"].into_iter().enumerate() {
        let [before, after] = both(&|l| l.memory[k]);
        if after > (1.0 + GROWTH) * before {
            out.push(format!(
                "memory of {who} grew from {before:.1} to {after:.1} MB in the last quarter"
            ));
        }
        // Files are opened for a moment: what leaks stays open, and raises the fewest.
        let fewest = |part: &[Look]| part.iter().map(|l| l.descriptors[k]).min().unwrap_or(0);
        let (before, after) = (fewest(&looks[third..last]), fewest(&looks[last..]));
        if after > before {
            out.push(format!("descriptors of {who} grew from {before} to {after}"));
        }
    }
    out
}

fn write(root: &Path, looks: &[Look], failures: &[String]) -> Result<(), String> {
    let mut table = String::from(
        "time [s],memory of the run [MB],memory of the viewer [MB],descriptors of the run,descriptors of the viewer,steps for a second of processor time\n",
    );
    for l in looks {
        let ([m, n], [d, e]) = (l.memory, l.descriptors);
        // Writing to a string cannot fail.
        let _ = writeln!(
            table,
            "{:.0},{m:.2},{n:.2},{d},{e},{}",
            l.seconds,
            if l.speed > 0.0 { format!("{:.0}", l.speed) } else { String::new() }
        );
    }
    put(&root.join(TABLE), &table)?;
    let of = |get: &dyn Fn(&Look) -> f64| -> Vec<[f64; 2]> {
        looks.iter().map(|l| [l.seconds, get(l)]).collect()
    };
    let pictures = [
        ("memory", "memory, MB", vec![of(&|l| l.memory[0]), of(&|l| l.memory[1])]),
        (
            "descriptors",
            "open descriptors",
            vec![of(&|l| l.descriptors[0] as f64), of(&|l| l.descriptors[1] as f64)],
        ),
        ("speed", "steps for a second of processor time", vec![of(&|l| l.speed)]),
    ];
    for (name, label, curves) in &pictures {
        put(&picture(root, name), &drawn(label, curves))?;
    }
    let hours = looks.last().map_or(0.0, |l| l.seconds / 3600.0);
    let range = |get: &dyn Fn(&Look) -> f64| {
        let late = looks.iter().skip(looks.len() / 10).map(get);
        let (low, high) = late.fold((f64::INFINITY, 0.0_f64), |(l, h), v| (l.min(v), h.max(v)));
        format!("{low:.1} to {high:.1}")
    };
    let found = match failures {
        [] => "nothing grew, nothing ended, every question was answered".to_owned(),
        some => some.join("; "),
    };
    let page = format!(
        "# An hour of running\n\nWritten by `cargo xtask soak`: `{SCENE}`, a tray of stones that is shaken for ever, with frames, histories and checkpoints, run on one thread beside `riprap view` on its results, \
         which is asked every ten seconds what a browser asks. Blue is the run, red the viewer. Steps are counted in a table that is written in batches, so that speed scatters where other work crowds the run. The numbers are in [soak.csv](soak.csv).\n\n\
         | | run | viewer |\n|---|---|---|\n| time | {hours:.2} h | the same |\n| memory after the first tenth, MB | {} | {} |\n| descriptors | {} | {} |\n\n\
         Found: {found}.\n\n![Memory](img/soak-memory.svg)\n\n![Descriptors](img/soak-descriptors.svg)\n\n![Speed](img/soak-speed.svg)\n",
        range(&|l| l.memory[0]),
        range(&|l| l.memory[1]),
        range(&|l| l.descriptors[0] as f64),
        range(&|l| l.descriptors[1] as f64),
    );
    put(&root.join(PAGE), &page)
}

fn put(path: &Path, text: &str) -> Result<(), String> {
    std::fs::write(path, text).map_err(|e| format!("{}: {e}", path.display()))
}

fn picture(root: &Path, name: &str) -> PathBuf {
    root.join(format!("docs/src/img/soak-{name}.svg"))
}

/// Curves over time, from zero.
fn drawn(label: &str, curves: &[Vec<[f64; 2]>]) -> String {
    let (width, height, left, foot) = (640.0, 200.0, 70.0, 40.0);
    let points = || curves.iter().flatten().filter(|p| p[1] > 0.0);
    let [end, top] = [0, 1].map(|k| points().map(|p| p[k]).fold(1e-9, f64::max));
    let place = |p: &[f64; 2]| {
        format!(
            "{:.1},{:.1}",
            left + width * p[0] / end,
            10.0 + height * (1.0 - p[1] / (1.1 * top))
        )
    };
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" font-family=\"Verdana, Arial, sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n\
         <rect x=\"{left}\" y=\"10\" width=\"{width}\" height=\"{height}\" fill=\"none\" stroke=\"#1a1a1a\"/>\n",
        left + width + 20.0,
        10.0 + height + foot
    );
    for (curve, colour) in curves.iter().zip(["#1f5fbf", "#c0392b"]) {
        let way: Vec<String> = curve.iter().filter(|p| p[1] > 0.0).map(place).collect();
        let _ = writeln!(
            out,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\"/>",
            way.join(" ")
        );
    }
    let bottom = 10.0 + height;
    let _ = writeln!(
        out,
        "<text x=\"{left}\" y=\"{}\">0</text><text x=\"{}\" y=\"{}\" text-anchor=\"end\">{:.0} min</text>\n\
         <text x=\"{}\" y=\"24\" text-anchor=\"end\">{:.4}</text><text x=\"{}\" y=\"{bottom}\" text-anchor=\"end\">0</text>\n\
         <text transform=\"translate(16 {}) rotate(-90)\" text-anchor=\"middle\">{label}</text>\n</svg>",
        bottom + 18.0,
        left + width,
        bottom + 18.0,
        end / 60.0,
        left - 6.0,
        1.1 * top,
        left - 6.0,
        10.0 + 0.5 * height,
    );
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn look(seconds: f64, memory: f64, descriptors: usize) -> Look {
        Look { seconds, memory: [memory, 10.0], descriptors: [descriptors, 8], speed: 100.0 }
    }

    #[test]
    fn growth_of_the_last_quarter_is_told() {
        let steady: Vec<Look> =
            (0..40).map(|k| look(f64::from(k), 20.0 - 5.0 / f64::from(k + 1), 9)).collect();
        assert!(grown(&steady).is_empty(), "{:?}", grown(&steady));
        let leak: Vec<Look> = (0..40).map(|k| look(f64::from(k), 20.0 + f64::from(k), 9)).collect();
        assert!(grown(&leak)[0].contains("memory of the run grew from 49.0 to 59.0"));
        let open: Vec<Look> = (0..40).map(|k| look(f64::from(k), 20.0, k as usize)).collect();
        assert_eq!(grown(&open), ["descriptors of the run grew from 20 to 30"]);
        assert_eq!(grown(&[]), ["it was looked at too seldom"]);
    }
}
