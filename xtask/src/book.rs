//! The book in `target/book`: whole in itself, so that it can be copied to any server.
//!
//! Pages link scenes of the repository, for those who read them there; the built book brings these scenes along.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::shell;
use crate::source_tree::{files, shown};

/// Builds the book where mdBook is installed, and looks whether its links lead somewhere.
pub fn build(root: &Path) -> Result<(), String> {
    let mdbook = Command::new("mdbook").arg("--version").output();
    if !mdbook.is_ok_and(|o| o.status.success()) {
        return Ok(());
    }
    let book = root.join("target/book");
    let mut command = Command::new("mdbook");
    command.args(["build", "docs", "--dest-dir"]).arg(&book);
    if !shell::run(root, &mut command)?.success {
        return Err("mdbook build docs failed".to_owned());
    }
    let scenes = root.join("scenes");
    for scene in files(&scenes, &[]) {
        let inside = scene.strip_prefix(&scenes).unwrap_or(&scene);
        copy(&scene, &book.join("scenes").join(inside))?;
    }
    let mut broken = Vec::new();
    let pages = files(&book, &["html"]);
    if pages.is_empty() {
        return Err(format!("mdbook wrote no pages to {}", book.display()));
    }
    for page in pages {
        let text = fs::read_to_string(&page).map_err(|e| format!("{}: {e}", page.display()))?;
        let depth = page.strip_prefix(&book).map_or(0, |p| p.components().count() - 1);
        let text = brought_along(&text, depth);
        fs::write(&page, &text).map_err(|e| format!("{}: {e}", page.display()))?;
        let folder = page.parent().unwrap_or(&book);
        let lost = links(&text).filter(|link| !leads(&book, folder, link));
        broken.extend(lost.map(|link| format!("{}: {link}", shown(root, &page))));
    }
    if broken.is_empty() {
        return Ok(());
    }
    Err(format!("links of the book lead nowhere:\n{}", broken.join("\n")))
}

fn copy(from: &Path, to: &Path) -> Result<(), String> {
    let said = |e: std::io::Error| format!("{}: {e}", to.display());
    fs::create_dir_all(to.parent().unwrap_or(to)).map_err(said)?;
    fs::copy(from, to).map(|_| ()).map_err(said)
}

/// Leads links to scenes of the repository, two folders above the book, into the book. `depth`: folders of the page within it.
fn brought_along(text: &str, depth: usize) -> String {
    let up = "../".repeat(depth);
    text.replace(&format!("href=\"{up}../../scenes/"), &format!("href=\"{up}scenes/"))
}

/// Links and pictures of a page that are relative, without their heads.
fn links(text: &str) -> impl Iterator<Item = &str> {
    let found = ["href=\"", "src=\""]
        .into_iter()
        .flat_map(|key| text.split(key).skip(1))
        .filter_map(|rest| rest.split(['"', '#', '?']).next());
    found.filter(|link| !link.is_empty() && !link.contains(':') && !link.starts_with('/'))
}

/// Whether a link leads to a file of the book.
fn leads(book: &Path, folder: &Path, link: &str) -> bool {
    let target: PathBuf = folder.join(link);
    target.canonicalize().is_ok_and(|t| book.canonicalize().is_ok_and(|b| t.starts_with(b)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_are_linked_inside_the_book() {
        let page = "<a href=\"../../../scenes/a.toml\">a</a> <a href=\"../x.html#y\">b</a> <a href=\"https://c.d\">c</a>";
        let inside = brought_along(page, 1);
        assert_eq!(links(&inside).collect::<Vec<_>>(), ["../scenes/a.toml", "../x.html"]);
        assert_eq!(brought_along(page, 0), page);
    }

    #[test]
    fn what_is_not_there_or_outside_is_told() {
        let book = Path::new(env!("CARGO_MANIFEST_DIR"));
        assert!(leads(book, &book.join("src"), "../Cargo.toml"));
        assert!(!leads(book, &book.join("src"), "../nothing.html"));
        assert!(!leads(book, &book.join("src"), "../../Cargo.toml"));
    }
}
