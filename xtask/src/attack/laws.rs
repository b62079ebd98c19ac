//! Every scene in the plane under both normal laws.

use std::path::{Path, PathBuf};
use std::time::Duration;

use super::process::Ended;
use super::{Field, Found, LONG, read_text};
use crate::{cut, source_tree};
use riprap_fuzz::damage::Chance;

/// A scene that takes longer under both laws is begun again in its short form.
const WHOLE: Duration = Duration::from_secs(30);
/// Steps of each phase of the short form; the next where nothing has met by then.
const STEPS: [usize; 3] = [3000, 30_000, 300_000];
/// The same in the short form of CI, where no scene is run whole.
const FEW: usize = 100;

/// Scenes in the plane, with or without checks.
fn scenes(root: &Path) -> Result<Vec<(PathBuf, String)>, String> {
    let mut found = Vec::new();
    for path in source_tree::files(&root.join("scenes"), &["toml"]) {
        let text = read_text(&path)?;
        if text.lines().any(|l| l.starts_with("[space.planar")) {
            found.push((path, text));
        }
    }
    Ok(found)
}

/// Whether its folder says that a whole run of a scene takes minutes.
fn takes_long(scene: &Path) -> bool {
    scene.iter().any(|part| part == "long" || part == "bench")
}

/// `riprap compare` on each.
pub fn two(field: &Field<'_>, _: &mut Chance) -> Result<Found, String> {
    let few = field.few();
    let mut found = Found::default();
    for (path, text) in scenes(field.root)? {
        found.tries += 1;
        let name = source_tree::shown(field.root, &path);
        let file = path.to_string_lossy();
        let compare = |steps: Option<usize>, limit| {
            let mut words = vec!["compare", &file, "--out", "a.compare", "--force", "--quiet"];
            let changes = steps.map_or_else(Vec::new, |steps| cut::words(&text, steps));
            words.extend(changes.iter().map(String::as_str));
            field.program.run_within(&field.folder, &words, limit)
        };
        let whole = if few || takes_long(&path) { None } else { Some(compare(None, WHOLE)?) };
        found.slow += usize::from(whole.as_ref().is_some_and(|ended| ended.slow));
        let wrong = match whole {
            Some(whole) if !whole.slow => failed(&whole),
            Some(_) | None if few => failed(&compare(Some(FEW), LONG)?),
            Some(_) | None => {
                short(|steps| compare(Some(steps), LONG), &field.folder.join("a.compare"))?
            }
        };
        let wrong = wrong.map(|why| format!("{name}: {why}"));
        found.failures.extend(wrong);
    }
    Ok(found)
}

/// What is wrong with the way a comparison ended.
fn failed(ended: &Ended) -> Option<String> {
    let said = ended.said.lines().last().unwrap_or("");
    (ended.code != Some(0)).then(|| format!("exit {:?}: {said}", ended.code))
}

/// The short form, as long as it must be for something to have met; what is wrong with it.
fn short(
    compare: impl Fn(usize) -> Result<Ended, String>,
    results: &Path,
) -> Result<Option<String>, String> {
    for steps in STEPS {
        if let Some(why) = failed(&compare(steps)?) {
            return Ok(Some(format!("phases of {steps} steps: {why}")));
        }
        if pressed(results)? {
            return Ok(None);
        }
    }
    Ok(Some("nothing has met".to_owned()))
}

/// Whether contacts or joints of both runs of a comparison have stored energy.
fn pressed(folder: &Path) -> Result<bool, String> {
    let one = |law: std::io::Result<std::fs::DirEntry>| -> Result<Option<bool>, String> {
        let path = law.map_err(|e| e.to_string())?.path().join("energy.csv");
        if !path.exists() {
            return Ok(None);
        }
        let wrong = |e: csv::Error| format!("{}: {e}", path.display());
        let mut table = csv::Reader::from_path(&path).map_err(wrong)?;
        let heads = table.headers().map_err(wrong)?.clone();
        let stored = |head: &str| head.starts_with("contact_normal") || head.starts_with("joints");
        let mut any = false;
        for row in table.records() {
            let row = row.map_err(wrong)?;
            let mut cells = heads.iter().zip(row.iter()).filter(|(head, _)| stored(head));
            any |= cells.any(|(_, cell)| cell.parse::<f64>().is_ok_and(|energy| energy > 0.0));
        }
        Ok(Some(any))
    };
    let laws = std::fs::read_dir(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let laws: Vec<bool> = laws.map(one).filter_map(Result::transpose).collect::<Result<_, _>>()?;
    Ok(laws.len() == 2 && laws.iter().all(|any| *any))
}
