//! Embeds the scenes of `scenes/planar`, `scenes/spatial` and `scenes/spatial/long` as the templates of `riprap new`: whoever adds a
//! scene there adds a template. Names are those of the files, so no name may stand in both folders. Tells the binary from
//! which commit and for which target it is built.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

fn main() {
    let manifest = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    println!("cargo::rerun-if-changed=build.rs");
    let out = PathBuf::from(std::env::var_os("OUT_DIR").unwrap_or_default());
    let table = index(&manifest.join("../.."));
    if let Err(error) = std::fs::write(out.join("index.rs"), table) {
        println!("cargo::error=could not write the index of pages and scenes: {error}");
    }
    let commit = commit(&manifest.join("../../.git")).unwrap_or_else(|| "unknown".to_owned());
    println!("cargo::rustc-env=RIPRAP_COMMIT={commit}");
    let target = std::env::var("TARGET").unwrap_or_default();
    println!("cargo::rustc-env=RIPRAP_TARGET={target}");
    let scenes = manifest.join("../../scenes");
    if let Err(error) = std::fs::write(out.join("shipped.rs"), shipped(&scenes)) {
        println!("cargo::error=could not write the scenes: {error}");
    }
    let mut table = String::from("pub const TEMPLATES: &[Template] = &[\n");
    for (folder, space) in [("planar", "plane"), ("spatial", "space"), ("spatial/long", "space")] {
        let scenes = manifest.join("../../scenes").join(folder);
        // A folder that is not there (a packaged crate) adds nothing.
        println!("cargo::rerun-if-changed={}", scenes.display());
        add_templates(&scenes, space, &mut table);
    }
    table.push_str("];\n");
    if let Err(error) = std::fs::write(out.join("templates.rs"), table) {
        println!("cargo::error=could not write the templates: {error}");
    }
}

/// All files of scenes, by their paths.
fn shipped(scenes: &Path) -> String {
    let mut files = Vec::new();
    for ending in
        ["toml", "csv", "asc", "stl", "obj", "msh", "tess", "dat", "fab", "dxf", "AT2", "at2"]
    {
        files_under(scenes, ending, &mut files);
    }
    files.sort();
    let mut table = String::from(
        "/// Path under `scenes/` and contents.\npub const SHIPPED: &[(&str, &[u8])] = &[\n",
    );
    for path in files {
        let Ok(short) = path.strip_prefix(scenes) else { continue };
        let short = short.to_string_lossy().replace('\\', "/");
        let _ = writeln!(table, "({short:?}, include_bytes!({path:?})),");
    }
    table.push_str("];\n");
    table
}

/// Which words stand how often on which page and in which scene, for `riprap explain WORD`.
fn index(root: &Path) -> String {
    // Pages written from the program: their words are searched where they come from. The front page has a line of every
    // other page.
    const ELSEWHERE: [&str; 7] = [
        "index.md",
        "SUMMARY.md",
        "cli.md",
        "fields.md",
        "python-reference.md",
        "scenario-reference.md",
        "verification.md",
    ];
    let mut table = String::new();
    for (name, folder, ending) in [("PAGES", "docs/src", "md"), ("SCENES", "scenes", "toml")] {
        let _ = writeln!(table, "const {name}: &[Text] = &[");
        println!("cargo::rerun-if-changed={}", root.join(folder).display());
        let mut files = Vec::new();
        files_under(&root.join(folder), ending, &mut files);
        files.sort();
        for path in files {
            let file = path.file_name().unwrap_or_default().to_string_lossy();
            if ELSEWHERE.contains(&&*file) {
                continue;
            }
            let Ok(text) = std::fs::read_to_string(&path) else {
                continue;
            };
            let heading = text.lines().find_map(|line| line.strip_prefix("# "));
            let about = if ending == "md" { heading.map(str::to_owned) } else { title(&text) };
            let (Some(about), Ok(short)) = (about, path.strip_prefix(root)) else {
                continue;
            };
            let shown = short.to_string_lossy().replace('\\', "/");
            let _ = writeln!(
                table,
                "Text {{ path: {shown:?}, about: {about:?}, words: {:?} }},",
                counted(&text)
            );
        }
        table.push_str("];\n");
    }
    table
}

/// Words of four letters and more, each with how often it occurs: `angle 3 block 12`.
fn counted(text: &str) -> String {
    let mut words = std::collections::BTreeMap::new();
    for word in text.split(|c: char| !c.is_alphabetic()) {
        if word.chars().count() > 3 {
            *words.entry(word.to_lowercase()).or_insert(0_u32) += 1;
        }
    }
    let each: Vec<String> = words.iter().map(|(word, n)| format!("{word} {n}")).collect();
    each.join(" ")
}

fn files_under(folder: &Path, ending: &str, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            files_under(&path, ending, found);
        } else if path.extension().is_some_and(|e| e == ending) {
            found.push(path);
        }
    }
}

/// The commit that is checked out, twelve digits: of the variable `RIPRAP_COMMIT` (for who builds from a packed tree),
/// else read from the files of git, so that git need not be there. `None` where neither says.
fn commit(git: &Path) -> Option<String> {
    println!("cargo::rerun-if-env-changed=RIPRAP_COMMIT");
    let given = std::env::var("RIPRAP_COMMIT").ok();
    let whole = given.or_else(|| checked_out(git))?;
    let digits = whole.trim();
    let hex = digits.len() >= 7 && digits.chars().all(|c| c.is_ascii_hexdigit());
    hex.then(|| digits[..digits.len().min(12)].to_owned())
}

/// What `HEAD` points at.
fn checked_out(git: &Path) -> Option<String> {
    // In a work tree `.git` is a file that names the folder.
    let folder = match std::fs::read_to_string(git) {
        Ok(text) => git.parent()?.join(text.trim().strip_prefix("gitdir:")?.trim()),
        Err(_) => git.to_owned(),
    };
    let head = std::fs::read_to_string(folder.join("HEAD")).ok()?;
    for file in ["HEAD", "logs/HEAD"] {
        let path = folder.join(file);
        // A file that is not there would make every build run this again.
        if path.exists() {
            println!("cargo::rerun-if-changed={}", path.display());
        }
    }
    let Some(name) = head.trim().strip_prefix("ref:") else {
        return Some(head);
    };
    let name = name.trim();
    let shared = match std::fs::read_to_string(folder.join("commondir")) {
        Ok(text) => folder.join(text.trim()),
        Err(_) => folder,
    };
    std::fs::read_to_string(shared.join(name)).ok().or_else(|| {
        let packed = std::fs::read_to_string(shared.join("packed-refs")).ok()?;
        let line = packed.lines().find(|line| line.ends_with(name))?;
        line.split_once(' ').filter(|(_, of)| *of == name).map(|(hash, _)| hash.to_owned())
    })
}

/// One entry for each scene of a folder.
fn add_templates(scenes: &Path, space: &str, table: &mut String) {
    for path in toml_files(scenes) {
        let Ok(text) = std::fs::read_to_string(&path) else {
            continue;
        };
        let (Some(name), Some(about)) = (path.file_stem(), title(&text)) else {
            continue;
        };
        // A comment of the scene: its blocks, and the processor time of one run, measured.
        let size = text.lines().find_map(|line| line.strip_prefix("# Size: "));
        let Some((blocks, time)) =
            size.and_then(|s| s.trim_end_matches('.').split_once(" blocks, "))
        else {
            println!("cargo::error={} has no line `# Size: N blocks, T s.`", path.display());
            continue;
        };
        // Writing to a String cannot fail.
        let _ = writeln!(
            table,
            "Template {{ name: {:?}, space: {space:?}, blocks: {blocks:?}, time: {time:?}, about: {about:?}, text: include_str!({path:?}), files: &[",
            name.to_string_lossy()
        );
        for file in files_read(&text) {
            let full = scenes.join(&file);
            if full.exists() {
                let _ = writeln!(table, "({file:?}, include_str!({full:?})),");
            }
        }
        table.push_str("] },\n");
    }
}

fn toml_files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut paths: Vec<PathBuf> =
        entries.map(|e| e.path()).filter(|p| p.extension().is_some_and(|e| e == "toml")).collect();
    paths.sort();
    paths
}

/// The value of the first `title = "…"`.
fn title(text: &str) -> Option<String> {
    let line = text.lines().find(|line| line.starts_with("title"))?;
    line.split('"').nth(1).map(str::to_owned)
}

/// Every quoted name that ends in `.csv` or `.asc`, once.
fn files_read(text: &str) -> Vec<String> {
    let mut names: Vec<String> = text
        .lines()
        .filter(|line| !line.trim_start().starts_with('#'))
        .flat_map(|line| line.split('"').skip(1).step_by(2))
        .filter(|word| word.ends_with(".csv") || word.ends_with(".asc"))
        .map(str::to_owned)
        .collect();
    names.sort();
    names.dedup();
    names
}
