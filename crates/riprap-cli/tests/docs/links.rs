//! Links and file names in pages lead somewhere.

use std::path::{Path, PathBuf};

use super::{pages, read, repository};

/// Written by `cargo xtask verify-all`, which takes minutes.
const WRITTEN_LATER: [&str; 1] = ["verification.md"];

/// All Markdown pages of the book and of the repository's root.
fn all_pages() -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![pages()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("list a folder") {
            let path = entry.expect("list a folder").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "md") {
                found.push(path);
            }
        }
    }
    for name in ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"] {
        found.push(repository().join(name));
    }
    found.sort();
    found
}

/// Targets of `[text](target)` outside of code.
fn targets(page: &str) -> Vec<String> {
    let mut code = false;
    let mut found = Vec::new();
    for line in page.lines() {
        if line.trim_start().starts_with("```") {
            code = !code;
        }
        if code {
            continue;
        }
        for part in line.split("](").skip(1) {
            if let Some(end) = part.find(')') {
                found.push(part[..end].to_owned());
            }
        }
    }
    found
}

#[test]
fn links_lead_to_files() {
    let mut broken = Vec::new();
    for page in all_pages() {
        for target in targets(&read(&page)) {
            let path = target.split('#').next().unwrap_or_default();
            let outside = target.contains("://") || target.starts_with("mailto:");
            if outside || path.is_empty() || WRITTEN_LATER.iter().any(|w| path.ends_with(w)) {
                continue;
            }
            if !page.parent().expect("a folder").join(path).exists() {
                broken.push(format!("{}: {target}", page.display()));
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

/// The anchors that mdBook makes of the headings of a page.
fn anchors(page: &str) -> Vec<String> {
    let mut code = false;
    let mut found: Vec<String> = Vec::new();
    for line in page.lines() {
        if line.trim_start().starts_with("```") {
            code = !code;
        }
        let heading = line.trim_start_matches('#');
        if code || heading == line || !heading.starts_with(' ') {
            continue;
        }
        let kept = heading.trim().chars().filter_map(|c| match c {
            ' ' => Some('-'),
            '-' | '_' => Some(c),
            _ => c.is_alphanumeric().then(|| c.to_ascii_lowercase()),
        });
        let anchor: String = kept.collect();
        let same = found.iter().filter(|a| **a == anchor).count();
        if same > 0 {
            found.push(format!("{anchor}-{same}"));
        }
        found.push(anchor);
    }
    found
}

#[test]
fn links_lead_to_headings() {
    let mut broken = Vec::new();
    for page in all_pages() {
        for target in targets(&read(&page)) {
            let Some((path, anchor)) = target.split_once('#') else {
                continue;
            };
            if target.contains("://") || WRITTEN_LATER.iter().any(|w| path.ends_with(w)) {
                continue;
            }
            let other = match path {
                "" => page.clone(),
                path => page.parent().expect("a folder").join(path),
            };
            // A file that is not there is found above.
            let known = other.exists() && other.extension().is_some_and(|e| e == "md");
            if known && !anchors(&read(&other)).iter().any(|a| a == anchor) {
                broken.push(format!("{}: {target}", page.display()));
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

/// Whether a word in backquotes is meant as a file of the repository.
fn is_repository_path(word: &str) -> bool {
    let rooted = ["crates/", "scenes/", "docs/", "xtask/", "tests/"];
    rooted.iter().any(|root| word.starts_with(root))
        && word.chars().all(|c| c.is_ascii_alphanumeric() || "/._-".contains(c))
}

#[test]
fn named_files_exist() {
    let mut missing = Vec::new();
    for page in all_pages() {
        let text = read(&page);
        for (k, word) in text.split('`').enumerate() {
            let is_code = k % 2 == 1;
            let later = WRITTEN_LATER.iter().any(|w| word.ends_with(w));
            if is_code && is_repository_path(word) && !later && !repository().join(word).exists() {
                missing.push(format!("{}: {word}", page.display()));
            }
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

#[test]
fn every_page_is_in_the_summary() {
    let summary = read(&pages().join("SUMMARY.md"));
    let listed = targets(&summary);
    for page in all_pages() {
        let Ok(inside) = page.strip_prefix(pages()) else {
            continue;
        };
        let name = inside.to_string_lossy().replace('\\', "/");
        assert!(
            name == "SUMMARY.md" || listed.contains(&name),
            "{name} is not in docs/src/SUMMARY.md"
        );
    }
    for target in listed {
        let later = WRITTEN_LATER.contains(&target.as_str());
        assert!(later || Path::new(&pages()).join(&target).exists(), "{target}");
    }
}

/// Source files with the path of their module: the crate with and without `riprap_`, then the folders.
fn modules() -> Vec<(Vec<String>, String)> {
    let mut found = Vec::new();
    let crates = std::fs::read_dir(repository().join("crates")).expect("list the crates");
    for entry in crates {
        let root = entry.expect("list the crates").path();
        let name = root.file_name().expect("a name").to_string_lossy();
        let short = name.trim_start_matches("riprap-").to_owned();
        let mut folders = vec![(root.join("src"), vec![short])];
        while let Some((folder, path)) = folders.pop() {
            let Ok(list) = std::fs::read_dir(&folder) else {
                continue;
            };
            for entry in list {
                let file = entry.expect("list a folder").path();
                let stem = file.file_stem().expect("a name").to_string_lossy();
                let mut own = path.clone();
                if !["lib", "mod"].contains(&stem.as_ref()) {
                    own.push(stem.into_owned());
                }
                if file.is_dir() {
                    folders.push((file, own));
                } else if file.extension().is_some_and(|e| e == "rs") {
                    found.push((own, read(&file)));
                }
            }
        }
    }
    found
}

/// Whether a source says that it has an item of this name.
fn defines(text: &str, item: &str) -> bool {
    let kinds = ["fn", "struct", "enum", "trait", "type", "const", "static", "mod"];
    text.match_indices(item).any(|(at, _)| {
        let before = text[..at].trim_end();
        let after = text[at + item.len()..].chars().next();
        let whole = after.is_none_or(|c| !c.is_alphanumeric() && c != '_');
        whole && kinds.iter().any(|kind| before.ends_with(kind))
    })
}

/// Whether `module::item`, `module::Type::function` or a module of this name is there.
fn exists(modules: &[(Vec<String>, String)], name: &str) -> bool {
    let parts: Vec<&str> = name.trim_start_matches("riprap_").split("::").collect();
    let ends = |path: &[String], with: &[&str]| {
        path.len() >= with.len() && path[path.len() - with.len()..] == *with
    };
    modules.iter().any(|(path, text)| {
        let items = |count: usize| {
            let (module, items) = parts.split_at(parts.len() - count);
            ends(path, module) && items.iter().all(|item| defines(text, item))
        };
        (0..parts.len().min(3)).any(items)
    })
}

#[test]
fn code_that_pages_name_is_there() {
    let modules = modules();
    let mut missing = Vec::new();
    for page in all_pages() {
        for name in read(&page).split('`').skip(1).step_by(2) {
            let word = |part: &str| {
                let mut letters = part.chars();
                letters.next().is_some_and(|c| c.is_ascii_lowercase())
                    && letters.all(|c| c.is_ascii_alphanumeric() || c == '_')
            };
            let code = name.contains("::") && name.split("::").next().is_some_and(word);
            if code && !name.contains(' ') && !exists(&modules, name) {
                missing.push(format!("{}: {name}", page.display()));
            }
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
    assert!(!exists(&modules, "limits::stable_step"));
    assert!(exists(&modules, "limits::judge"));
}
