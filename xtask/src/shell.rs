//! Running commands: their output is shown as it comes and, where they count, counted.

use std::cell::{Cell, RefCell};
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Command, Stdio};

/// How many checks passed, failed and were skipped.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    pub passed: u64,
    pub failed: u64,
    pub skipped: u64,
}

impl Counts {
    pub fn add(&mut self, other: Counts) {
        self.passed += other.passed;
        self.failed += other.failed;
        self.skipped += other.skipped;
    }
}

/// What a command left behind.
pub struct Finished {
    pub success: bool,
    pub counts: Counts,
}

thread_local! {
    /// Step whose commands this thread runs.
    static SPEAKER: Cell<&'static str> = const { Cell::new("") };
    /// What the commands of this thread said of failures.
    static FAILURES: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

/// Lines kept of the failures of a step.
const KEPT: usize = 40;

/// Takes what the commands of this thread said of failures: a log is cut at its beginning, so that the summary repeats them.
pub fn failures() -> Vec<String> {
    FAILURES.take()
}

/// Whether `line` names a failed check: of cargo (`test a::b ... FAILED`), of pytest and of `riprap verify`
/// (`FAILED …`), of the browser's tally (`failed: …`).
fn names_failure(line: &str) -> bool {
    let line = line.trim();
    ["FAILED ", "failed: "].iter().any(|word| line.starts_with(word))
        || (line.starts_with("test ") && line.ends_with("FAILED"))
}

/// Whether `line`, which is not of a test, names an error of rustc, clippy or rustdoc.
fn names_error(line: &str) -> bool {
    ["error: ", "error["].iter().any(|word| line.starts_with(word))
}

/// Copies what a command says of errors to ours, whole lines at a time, and returns the lines that name a failure, each with the
/// place that rustc writes below it.
fn copy_errors(stream: impl Read, mark: &str) -> Vec<String> {
    let mut kept: Vec<String> = Vec::new();
    let mut named = false;
    for line in BufReader::new(stream).split(b'\n') {
        let Ok(line) = line else { break };
        let _ = std::io::stderr().write_all(&[mark.as_bytes(), &line, b"\n"].concat());
        let line = String::from_utf8_lossy(&line);
        let place = line.trim().strip_prefix("--> ");
        if let (true, Some(place), Some(last)) = (named, place, kept.last_mut()) {
            last.push_str(" at ");
            last.push_str(place);
        }
        named = names_error(&line) || names_failure(&line);
        if named && kept.len() < KEPT {
            kept.push(line.trim().to_owned());
        }
    }
    kept
}

/// Keeps a line that names a failed check.
fn keep_failure(line: &str) {
    if names_failure(line) {
        FAILURES.with_borrow_mut(|kept| {
            if kept.len() < KEPT {
                kept.push(line.trim().to_owned());
            }
        });
    }
}

/// Runs `f` with the output of its commands marked by `name`: steps run side by side.
pub fn speaking_as<R>(name: &'static str, f: impl FnOnce() -> R) -> R {
    let before = SPEAKER.replace(name);
    let result = f();
    SPEAKER.set(before);
    result
}

/// The mark of this thread's lines.
fn mark() -> String {
    match SPEAKER.get() {
        "" => String::new(),
        name => format!("{name:<9}| "),
    }
}

/// Takes `name VALUE` out of `words`.
pub fn option<'a>(words: &mut Vec<&'a str>, name: &str) -> Result<Option<&'a str>, String> {
    let Some(at) = words.iter().position(|word| *word == name) else {
        return Ok(None);
    };
    let value = *words.get(at + 1).ok_or_else(|| format!("{name} needs a value"))?;
    words.drain(at..at + 2);
    Ok(Some(value))
}

/// The same for a number.
pub fn number(words: &mut Vec<&str>, name: &str) -> Result<Option<f64>, String> {
    let value = option(words, name)?;
    value.map(|v| v.parse().map_err(|_| format!("{name} needs a number, not {v}"))).transpose()
}

/// The cargo that started this program.
pub fn cargo() -> String {
    std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned())
}

/// Runs `command` in `root`; shows its output; adds up the test counts it prints.
pub fn run(root: &Path, command: &mut Command) -> Result<Finished, String> {
    let mark = mark();
    println!("{mark}$ {}", spoken(command));
    let name = command.get_program().to_string_lossy().into_owned();
    let mut child = command
        .current_dir(root)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|e| format!("{name} could not be started: {e}"))?;
    let errors = child.stderr.take().map(|stream| {
        let mark = mark.clone();
        std::thread::spawn(move || copy_errors(stream, &mark))
    });
    let mut counts = Counts::default();
    if let Some(stdout) = child.stdout.take() {
        let mut out = std::io::stdout();
        for line in BufReader::new(stdout).split(b'\n') {
            let line = line.map_err(|e| format!("reading from {name}: {e}"))?;
            // A reader that has gone away (`| head`) must not stop the checks.
            let whole = [mark.as_bytes(), &line, b"\n"].concat();
            let _ = out.write_all(&whole);
            let line = String::from_utf8_lossy(&line);
            keep_failure(&line);
            if let Some(found) = read_counts(&line) {
                counts.add(found);
            }
        }
    }
    if let Some(lines) = errors {
        let lines = lines.join().map_err(|_| format!("reading the errors of {name} failed"))?;
        FAILURES.with_borrow_mut(|kept| {
            let room = KEPT.saturating_sub(kept.len());
            kept.extend(lines.into_iter().take(room));
        });
    }
    let status = child.wait().map_err(|e| format!("waiting for {name}: {e}"))?;
    Ok(Finished { success: status.success(), counts })
}

/// The command as a person would type it.
fn spoken(command: &Command) -> String {
    let program = Path::new(command.get_program());
    let mut words = vec![program.file_name().unwrap_or_default().to_string_lossy().into_owned()];
    words.extend(command.get_args().map(|a| a.to_string_lossy().into_owned()));
    if words.len() > 14 {
        let hidden = words.len() - 12;
        words.truncate(12);
        words.push(format!("… and {hidden} more"));
    }
    words.join(" ")
}

/// Reads `test result: ok. 12 passed; 0 failed; 1 ignored; …` or `12 passed, 0 failed, 1 skipped`.
fn read_counts(line: &str) -> Option<Counts> {
    let line = line.trim();
    if !line.starts_with("test result:") && !line.starts_with(|c: char| c.is_ascii_digit()) {
        return None;
    }
    let number = |word: &str| -> Option<u64> {
        let before = line.find(word).map(|at| line[..at].trim_end())?;
        let digits = before.rsplit(|c: char| !c.is_ascii_digit()).next()?;
        digits.parse().ok()
    };
    Some(Counts {
        passed: number(" passed")?,
        failed: number(" failed")?,
        skipped: number(" ignored").or_else(|| number(" skipped"))?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_are_taken_out_of_the_words() {
        let mut words = vec!["a", "--tries", "7", "b"];
        assert_eq!(number(&mut words, "--tries"), Ok(Some(7.0)));
        assert_eq!(words, ["a", "b"]);
        assert_eq!(option(&mut words, "--binary"), Ok(None));
        assert!(number(&mut vec!["--tries"], "--tries").is_err());
        assert!(number(&mut vec!["--tries", "x"], "--tries").is_err());
    }

    #[test]
    fn lines_that_name_a_failed_check_are_kept_once() {
        let named = [
            "test a::b ... FAILED",
            "FAILED tests/test_x.py::test_y - assert 1 == 2",
            "failed: a test › of the page",
        ];
        for line in named.iter().chain(&[
            "test a::c ... ok",
            "test result: FAILED. 1 passed; 1 failed",
            "what failed lies in x",
        ]) {
            keep_failure(line);
        }
        assert_eq!(failures(), named);
        assert!(failures().is_empty());
    }

    #[test]
    fn errors_of_the_compiler_are_kept_with_their_place() {
        let said = "warning: unused\n  --> src/a.rs:1:1\nerror: unresolved link to `A`\n  --> src/b.rs:12:14\n   |\nerror: could not document `b`\n";
        assert_eq!(
            copy_errors(said.as_bytes(), ""),
            ["error: unresolved link to `A` at src/b.rs:12:14", "error: could not document `b`"]
        );
    }

    #[test]
    fn counts_are_read_from_cargo_and_from_riprap() {
        let cargo = "test result: ok. 12 passed; 0 failed; 1 ignored; 0 measured; 3 filtered out";
        assert_eq!(read_counts(cargo), Some(Counts { passed: 12, failed: 0, skipped: 1 }));
        let riprap = "7 passed, 2 failed, 0 skipped";
        assert_eq!(read_counts(riprap), Some(Counts { passed: 7, failed: 2, skipped: 0 }));
        assert_eq!(read_counts("test a::b ... ok"), None);
        assert_eq!(read_counts("3 warnings"), None);
    }
}
