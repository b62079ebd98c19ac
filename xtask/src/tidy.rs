//! Small rules over all text files: length, tabs, trailing blanks, paths that leave the repository.

use std::path::Path;

use crate::source_tree::{files, shown};

/// Longer files are listed (not refused): they are hard to read in one sitting.
const LONG_FILE: usize = 500;

const TEXT: [&str; 12] =
    ["rs", "toml", "md", "py", "sh", "yml", "yaml", "json", "csv", "txt", "html", "ts"];

/// Prints every finding; returns how many of them are errors.
pub fn check(root: &Path) -> Result<u64, String> {
    // In two pieces, or this line would find itself.
    let outside = concat!("../", "shared");
    let mut errors = 0;
    let mut paths = files(root, &TEXT);
    paths.push(root.join(".ci/run"));
    paths.push(root.join(".cargo/config.toml"));
    for path in &paths {
        let Ok(text) = std::fs::read_to_string(path) else {
            continue;
        };
        let name = shown(root, path);
        for (i, line) in text.lines().enumerate() {
            if line.contains(outside) {
                println!("{name}:{}: {outside} is not part of the repository", i + 1);
                errors += 1;
            }
            if line.ends_with([' ', '\t']) && !name.ends_with(".md") {
                println!("{name}:{}: blanks at the end of the line", i + 1);
                errors += 1;
            }
        }
        let lines = text.lines().count();
        if name.ends_with(".rs") && lines > LONG_FILE {
            println!("{name}: {lines} lines; the aim is {LONG_FILE} (a remark, not an error)");
        }
    }
    println!("{} files, {errors} errors", paths.len());
    Ok(errors)
}
