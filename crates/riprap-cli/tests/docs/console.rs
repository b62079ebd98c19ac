//! Commands shown in pages work and print what the pages show.
//!
//! In a page, a block marked `toml` whose first line is `# NAME.toml` is a file. A block marked
//! `console` holds commands (lines that begin with `$ `), each followed by what it prints: a line
//! `...` skips lines, `...` within a line skips text, numbers may differ by 5 %. What a command prints may
//! come from either stream; lines that the page does not show must be skipped by `...`. A block `console,long` takes minutes: only ignored
//! tests run it, after all that stands before it (`cargo xtask pages`).

use std::path::Path;
use std::process::Command;

use tempfile::TempDir;

use super::{pages, read, writing};

/// Numbers of a shown line may differ by this share: a page need not follow the last digit.
const NEAR: f64 = 0.05;

/// What a page asks for, in its order.
enum Item {
    /// A file with its text.
    File(String, String),
    /// A command with the lines it is said to print.
    Command(String, Vec<String>),
}

/// `long`: with the blocks that take minutes.
fn items(page: &str, long: bool) -> Vec<Item> {
    let mut items = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        let Some(language) = line.strip_prefix("```") else {
            continue;
        };
        let body: Vec<&str> = lines.by_ref().take_while(|l| *l != "```").collect();
        match language {
            "toml" => {
                let name = body.first().and_then(|l| l.strip_prefix("# "));
                if let Some(name) = name.filter(|n| n.ends_with(".toml") && !n.contains(' ')) {
                    items.push(Item::File(name.to_owned(), body.join("\n") + "\n"));
                }
            }
            "console,long" if !long => {}
            "console" | "console,long" => {
                for line in body {
                    if let Some(command) = line.strip_prefix("$ ") {
                        items.push(Item::Command(command.to_owned(), Vec::new()));
                    } else if let Some(Item::Command(_, shown)) = items.last_mut() {
                        shown.push(line.to_owned());
                    }
                }
            }
            _ => {}
        }
    }
    items
}

/// Whether two words are the same, numbers nearly.
fn same_word(shown: &str, printed: &str) -> bool {
    let number = |w: &str| w.trim_end_matches([',', ')', ';', ':']).parse::<f64>().ok();
    match (number(shown), number(printed)) {
        (Some(a), Some(b)) => (a - b).abs() <= NEAR * a.abs().max(b.abs()),
        _ => shown == printed,
    }
}

fn same_words(shown: &[&str], printed: &[&str]) -> bool {
    shown.len() == printed.len() && shown.iter().zip(printed).all(|(a, b)| same_word(a, b))
}

/// Whether a printed line is what the page shows; `...` stands for any words.
fn same_line(shown: &str, printed: &str) -> bool {
    let words: Vec<&str> = printed.split_whitespace().collect();
    let parts: Vec<Vec<&str>> =
        shown.split("...").map(|part| part.split_whitespace().collect()).collect();
    let [first, middle @ .., last] = &parts[..] else {
        return same_words(&parts[0], &words);
    };
    if words.len() < first.len() + last.len() || !same_words(first, &words[..first.len()]) {
        return false;
    }
    let (mut at, end) = (first.len(), words.len() - last.len());
    for part in middle {
        let found = (at..=end.saturating_sub(part.len()))
            .find(|&k| k + part.len() <= end && same_words(part, &words[k..k + part.len()]));
        match found {
            Some(k) => at = k + part.len(),
            None => return false,
        }
    }
    same_words(last, &words[end..])
}

/// The first shown line that was not printed, if any. Lines must come in order; lines between them
/// may be skipped only where the page says `...`, except that progress may come at any time.
fn missing<'a>(shown: &'a [String], printed: &[String]) -> Option<&'a str> {
    let mut rest = printed;
    let mut may_skip = false;
    for line in shown {
        if line.trim() == "..." {
            may_skip = true;
            continue;
        }
        let found = rest.iter().position(|p| same_line(line, p));
        match found {
            Some(k) if may_skip || k == 0 || line.contains("...") => rest = &rest[k + 1..],
            _ => return Some(line),
        }
        may_skip = line.contains("...");
    }
    None
}

/// Runs a page's commands in an empty folder, which is returned.
fn run_page(name: &str) -> TempDir {
    run_items(name, false)
}

fn run_items(name: &str, long: bool) -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let programs = Path::new(env!("CARGO_BIN_EXE_riprap")).parent().expect("a folder");
    let path = std::env::var("PATH").unwrap_or_default();
    let mut code = 0;
    for item in items(&read(&pages().join(name)), long) {
        let (command, shown) = match item {
            Item::File(name, text) => {
                std::fs::write(folder.path().join(name), text).expect("write a file");
                continue;
            }
            Item::Command(command, shown) => (command, shown),
        };
        if command == "echo $?" {
            assert_eq!(shown, [code.to_string()], "{name}: exit code");
            continue;
        }
        let output = Command::new("sh")
            .args(["-c", &command])
            .current_dir(folder.path())
            .env("PATH", format!("{}:{path}", programs.display()))
            .env_remove("NO_COLOR")
            .output()
            .expect("start sh");
        code = output.status.code().unwrap_or(-1);
        // Progress, warnings and notes go to stderr, results to stdout.
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        let said = text(&output.stderr) + &text(&output.stdout);
        let printed: Vec<String> =
            said.lines().filter(|line| !line.trim().is_empty()).map(str::to_owned).collect();
        let bad = |line: &String| line.starts_with("error") || line.starts_with("FAILED");
        let wants_error = shown.iter().any(bad);
        assert_eq!(code == 0, !wants_error, "{name}: `{command}` ended with {code}\n{said}");
        if let Some(line) = missing(&shown, &printed) {
            panic!("{name}: `{command}` did not print\n  {line}\nbut\n{said}");
        }
    }
    folder
}

#[test]
fn the_first_hour_works() {
    let folder = run_page("first-hour.md");
    keep(&folder, &["topple.svg", "tilt.svg", "hill.svg"]);
}

#[test]
fn the_first_blast_works() {
    let folder = run_page("first-blast.md");
    let bench = ["shot-section", "shot.muckpile/profile", "shot.muckpile/energy_partition"];
    let house = ["house-section", "house-cavity", "house-ppv", "house-spectrum", "bricks-ppv"];
    let pictures = [&bench[..], &house].concat().into_iter().map(|name| format!("{name}.svg"));
    keep(&folder, &pictures.collect::<Vec<_>>());
}

#[test]
fn the_first_crack_works() {
    let folder = run_page("first-crack.md");
    keep(&folder, &["notch-section.svg", "notch-net.svg"]);
}

#[test]
fn the_first_rockfall_works() {
    let folder = run_page("first-rockfall.md");
    keep(&folder, &["fall-section.svg", "fall-runout.svg"]);
}

#[test]
fn the_first_support_works() {
    run_page("first-support.md");
}

#[test]
fn the_page_on_removable_blocks_works() {
    run_page("how-to/removable-blocks.md");
}

#[test]
fn the_page_of_ten_problems_works() {
    run_page("how-to/ten-problems.md");
}

#[test]
#[ignore = "minutes: a rockfall, a bench, a search, the error of a calibration"]
fn ten_problems_long() {
    run_items("how-to/ten-problems.md", true);
}

#[test]
fn the_page_on_laboratory_tests_works() {
    run_page("how-to/laboratory-tests.md");
}

#[test]
fn the_first_water_works() {
    run_page("first-water.md");
}

#[test]
fn the_page_on_many_machines_works() {
    run_page("scale.md");
}

/// Pictures that a page's commands made are those that it shows.
fn keep(folder: &TempDir, pictures: &[impl AsRef<Path>]) {
    for picture in pictures.iter().map(AsRef::as_ref) {
        let made = read(&folder.path().join(picture));
        let kept = pages().join("img").join(picture.file_name().unwrap_or_default());
        if writing() {
            std::fs::write(&kept, made).expect("write a picture");
        } else {
            // Not byte by byte: a picture need not follow the last digit.
            assert!(kept.exists() && made.starts_with("<svg"), "{}", picture.display());
        }
    }
}

#[test]
fn lines_are_compared_as_said() {
    assert!(same_line("done: ... in ...", "done: 14 650 steps in 1.9 s"));
    assert!(same_line("limit 29.4 deg", "limit   29.3750 deg"));
    assert!(!same_line("limit 29.4 deg", "limit 32 deg"));
    assert!(!same_line("a ... c", "a b d"));
    let printed = ["one".to_owned(), "two".to_owned(), "three".to_owned()];
    let shown = |lines: &[&str]| lines.iter().map(|l| (*l).to_owned()).collect::<Vec<_>>();
    assert_eq!(missing(&shown(&["one", "three"]), &printed), Some("three"));
    assert_eq!(missing(&shown(&["one", "...", "three"]), &printed), None);
    assert_eq!(missing(&shown(&["one"]), &printed), None);
}
