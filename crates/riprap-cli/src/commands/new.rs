//! `riprap new`: writes a template where the user wants it.

use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use riprap::record::field::nearest;

use crate::args::{DEFAULT_TEMPLATE, New};
use crate::diagnostics;
use crate::failure::Failure;
use crate::screen;
use crate::templates::{self, TEMPLATES};

pub fn run(args: &New) -> Result<(), Failure> {
    if args.list {
        for template in TEMPLATES {
            screen::line(&format!(
                "{:<16} {}  {:>6} blocks  {:>6}  {}",
                template.name, template.space, template.blocks, template.time, template.about
            ));
        }
        return Ok(());
    }
    let template = templates::find(&args.template).ok_or_else(|| {
        let names: Vec<&str> = TEMPLATES.iter().map(|t| t.name).collect();
        let known = match nearest(&args.template, names.iter().copied()) {
            Some(near) => format!("did you mean {near}? `riprap new --list` shows all"),
            None => format!("valid templates: {}", names.join(", ")),
        };
        Failure::Input(format!("unknown template {:?}; {known}", args.template))
    })?;
    let name = args.name.as_deref().unwrap_or(template.name);
    let path = scene_path(name)?;
    let folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
    write(&path, template.text, args.force)?;
    for (file, text) in template.files {
        let target = folder.join(file);
        if let Some(parent) = target.parent() {
            std::fs::create_dir_all(parent).map_err(|error| {
                Failure::Output(format!("could not create {}: {error}", parent.display()))
            })?;
        }
        write(&target, text, args.force)?;
    }
    let by_default = template.name == DEFAULT_TEMPLATE && name != template.name;
    if by_default && templates::find(name).is_some() {
        diagnostics::print_line(
            "note",
            &format!(
                "this is the template `{0}`; the one called `{name}` is `riprap new {name} --template {name} --force`",
                template.name
            ),
        );
    }
    let shown = path.display();
    let run = crate::commands::default_folder(&path, "run");
    screen::line(&format!(
        "wrote {shown}: {}\n\nnext:\n  riprap check {shown}\n  riprap run {shown}\n  riprap plot {}",
        template.about,
        run.display()
    ));
    Ok(())
}

/// `hill` and `hill.toml` both mean `hill.toml`.
fn scene_path(name: &str) -> Result<PathBuf, Failure> {
    let path = PathBuf::from(name);
    let Some(stem) = path.file_name() else {
        return Err(Failure::Input(format!("{name:?} is not a file name")));
    };
    let mut file = stem.to_os_string();
    if path.extension().is_none_or(|e| e != "toml") {
        file.push(".toml");
    }
    Ok(path.with_file_name(file))
}

fn write(path: &Path, text: &str, force: bool) -> Result<(), Failure> {
    let mut options = OpenOptions::new();
    options.write(true).create(true).truncate(true);
    if !force {
        // Refused by the system itself: what came to be there since is safe too.
        options.create_new(true);
    }
    options.open(path).and_then(|mut file| file.write_all(text.as_bytes())).map_err(|error| {
        let shown = path.display();
        if error.kind() == ErrorKind::AlreadyExists {
            Failure::Input(format!("{shown} already exists; --force replaces it"))
        } else {
            Failure::Output(format!("could not write {shown}: {error}"))
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ending_is_added_once() {
        for (name, path) in
            [("hill", "hill.toml"), ("hill.toml", "hill.toml"), ("a/hill.v2", "a/hill.v2.toml")]
        {
            assert_eq!(scene_path(name).unwrap(), Path::new(path));
        }
        assert!(scene_path("..").is_err());
        assert!(scene_path("").is_err());
    }
}
