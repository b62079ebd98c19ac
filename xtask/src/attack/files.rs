//! Attacks on what the program reads.

use std::path::{Path, PathBuf};
use std::time::Duration;

use super::process::Ended;
use super::{Field, Found, read_text, write};
use crate::{cut, source_tree};
use riprap_fuzz::damage::{self, Chance};

/// Largest scene of the corpus, bytes, and how many there are.
const SMALL: u64 = 4000;
const SCENES: usize = 50;
/// A scene of the corpus is checked in this time.
const QUICK: Duration = Duration::from_millis(400);

const HEAD: &str = "riprap = 1\ntitle = \"t\"\n[materials.rock]\ndensity = \"2500 kg/m3\"\nyoung = \"20 GPa\"\npoisson = 0.25\n[interfaces.default]\n\
    normal_stiffness = \"1 GPa/m\"\nfriction_angle = \"30 deg\"\n[[phases]]\nname = \"fall\"\nuntil = { time = \"1 s\" }\n[[blocks]]\nname = \"a\"\nmaterial = \"rock\"\n";
const PLANE: &str = "[space.planar]\ngravity = [\"0 m/s2\", \"-9.81 m/s2\"]\n";
const SPACE: &str = "[space.spatial]\nfound_contacts = true\ngravity = \"9.81 m/s2\"\n";
const BALL: &str = "[[blocks]]\nname = \"ball\"\nmaterial = \"rock\"\nbrick = { size = [\"1 m\", \"1 m\", \"1 m\"], centre = [\"5 m\", \"3 m\", \"9 m\"] }\n";
const GRID: &str = "ncols 5\nnrows 4\nxllcorner -1\nyllcorner -1\ncellsize 2\nNODATA_value -9\n0 1 2 3 4\n0 1 2 3 4\n0 1 2 3 4\n0 1 2 3 4\n";

impl Field<'_> {
    /// Counts a try, and keeps the input if it failed.
    fn note(
        &self,
        found: &mut Found,
        ended: &Ended,
        input: (&str, &[u8]),
        more: Option<String>,
    ) -> Result<(), String> {
        found.tries += 1;
        found.slow += usize::from(ended.slow);
        found.refused += usize::from(matches!(ended.code, Some(1..=3)));
        if let Some(why) = ended.wrong().or(more) {
            let kept = format!("failed_{}_{}", found.failures.len() + 1, input.0);
            self.write(&kept, input.1)?;
            found.failures.push(format!("{}: {why}", self.folder.join(kept).display()));
        }
        Ok(())
    }

    /// Scenes that are small and quickly checked, with their texts.
    fn corpus(&self, chance: &mut Chance) -> Result<Vec<String>, String> {
        let mut all: Vec<PathBuf> = source_tree::files(&self.root.join("scenes"), &["toml"])
            .into_iter()
            .filter(|path| !path.iter().any(|part| part == "long" || part == "mid"))
            .filter(|path| path.metadata().is_ok_and(|m| m.len() < SMALL))
            .collect();
        let wanted = SCENES.min(self.tries.div_ceil(3));
        let mut corpus = Vec::new();
        while corpus.len() < wanted && !all.is_empty() {
            let path = all.remove(chance.below(all.len()));
            let text = read_text(&path)?;
            // Beside the copy there are no data.
            if !text.starts_with("riprap") || text.contains("data/") {
                continue;
            }
            self.write("t.toml", &text)?;
            let ended = self.program.run_within(&self.folder, &["check", "t.toml"], QUICK)?;
            if ended.code == Some(0) {
                corpus.push(text);
            }
        }
        if corpus.is_empty() {
            return Err("no scene of the repository can be checked".to_owned());
        }
        Ok(corpus)
    }
}

fn read(path: &Path) -> Result<Vec<u8>, String> {
    std::fs::read(path).map_err(|e| format!("{}: {e}", path.display()))
}

/// Half of the scenes have one number replaced, but that of the version of the language, which is the first: most other damage is refused
/// at once. What is taken is run for three steps.
pub fn scenes(field: &Field<'_>, chance: &mut Chance) -> Result<Found, String> {
    let corpus = field.corpus(chance)?;
    let mut found = Found::default();
    for _ in 0..field.tries {
        let original: &String = chance.of(&corpus);
        let input = match chance.below(2) {
            0 => damage::number(original, 1, chance).into_bytes(),
            _ => damage::text(original, chance),
        };
        field.write("t.toml", &input)?;
        let mut ended = field.program.run(&field.folder, &["check", "t.toml"])?;
        let mut wrong = None;
        if ended.code == Some(0) {
            (ended, wrong) = first_steps(field, &String::from_utf8_lossy(&input))?;
        }
        field.note(&mut found, &ended, ("t.toml", &input), wrong)?;
    }
    Ok(found)
}

/// Runs the scene `t.toml`, which has this text, for three steps of each phase; how that ended, and what is wrong with its energies.
fn first_steps(field: &Field<'_>, text: &str) -> Result<(Ended, Option<String>), String> {
    let mut words = vec!["run", "t.toml", "--out", "a.run", "--force", "--quiet"];
    // Of three steps no check can be said.
    words.extend(["--threads", "1", "--set", "checks=[]"]);
    let changes = cut::words(text, 3);
    words.extend(changes.iter().map(String::as_str));
    let ended = field.program.run(&field.folder, &words)?;
    let energies = std::fs::read_to_string(field.folder.join("a.run/energy.csv"));
    let wrong = ended.code == Some(0)
        && energies.is_ok_and(|text| {
            let last = text.lines().skip(1).last().unwrap_or("").to_owned();
            last.split(',').any(|cell| cell.parse::<f64>().is_ok_and(|x| !x.is_finite()))
        });
    Ok((ended, wrong.then(|| "exit 0 with energies that are not numbers".to_owned())))
}

/// A file, its bytes, and the scene that reads it.
type Reader = (&'static str, Vec<u8>, String);

fn readers(root: &Path) -> Result<Vec<Reader>, String> {
    let folder = root.join("crates/riprap-scenario/tests/data");
    let scene = |space: &str, block: &str, more: &str| {
        let (head, rest) = HEAD.split_once("[materials").unwrap_or((HEAD, ""));
        format!("{head}{space}[materials{rest}{block}\n{more}")
    };
    let mut all = Vec::new();
    for (file, space, block, more) in [
        ("msh/bricks_22_ascii.msh", SPACE, "mesh.msh = \"FILE\"", ""),
        ("msh/bricks_22_binary.msh", SPACE, "mesh.msh = \"FILE\"", ""),
        ("msh/bricks_41_ascii.msh", SPACE, "mesh.msh = \"FILE\"", ""),
        ("msh/cylinder_41_binary.msh", SPACE, "mesh.msh = \"FILE\"", ""),
        ("shapes/grains3d.tess", SPACE, "mesh.tess = \"FILE\"", ""),
        ("shapes/grains2d.tess", PLANE, "polygons = { tess = \"FILE\" }", ""),
        ("shapes/two_ascii.stl", SPACE, "mesh.stl = \"FILE\"", ""),
        ("shapes/two_binary.stl", SPACE, "mesh.stl = \"FILE\"", ""),
        ("shapes/two_ascii.stl", SPACE, "terrain.stl = \"FILE\"", BALL),
        ("shapes/section_R12.dxf", PLANE, "polygons = { dxf = \"FILE\", layers = [\"rock\"] }", ""),
        (
            "shapes/section_R2010_binary.dxf",
            PLANE,
            "polygons = { dxf = \"FILE\", layers = [\"rock\"] }",
            "",
        ),
    ] {
        all.push((file, read(&folder.join(file))?, scene(space, block, more)));
    }
    let places = (0..20).map(|k| (2 * (k % 5), 2 * (k / 5)));
    let heights: String = places.map(|(x, y)| format!("{x},{y},0.5\n")).collect();
    let heights = format!("x_m,y_m,z_m\n{heights}");
    for (file, text, block) in [
        ("g.asc", GRID, "terrain.asc = \"FILE\""),
        ("g.csv", heights.as_str(), "terrain.csv = \"FILE\""),
    ] {
        all.push((file, text.as_bytes().to_vec(), scene(SPACE, block, BALL)));
    }
    let square = "rectangle = { size = [\"1 m\", \"1 m\"], corner = [\"0 m\", \"0 m\"] }";
    let shaken = "[[supports]]\non = { block = \"a\" }\nmotion.acceleration = { x = { csv = { file = \"FILE\", time = \"t\", column = \"a\" } } }\n";
    let table = b"t,a\n0,0\n0.5,1\n1,0\n2,3e-3\n".to_vec();
    all.push(("s.csv", table, scene(PLANE, square, shaken)));
    Ok(all)
}

pub fn inputs(field: &Field<'_>, chance: &mut Chance) -> Result<Found, String> {
    let readers = readers(field.root)?;
    let mut found = Found::default();
    for (file, bytes, scene) in &readers {
        let name = file.rsplit('/').next().unwrap_or(file);
        field.write(name, bytes)?;
        field.write("t.toml", scene.replace("FILE", name))?;
        let ended = field.program.run(&field.folder, &["check", "t.toml"])?;
        // Only who reads a sound file is worth a damaged one; the surface of solids is no terrain.
        if ended.code != Some(0) && !scene.contains("terrain.stl") {
            return Err(format!("{file} is not read undamaged: {}", ended.said));
        }
    }
    for k in 0..field.tries {
        let (file, bytes, scene) = &readers[k % readers.len()];
        let name = file.rsplit('/').next().unwrap_or(file);
        let input = match std::str::from_utf8(bytes) {
            Ok(text) if chance.below(3) > 0 => damage::text(text, chance),
            Ok(_) | Err(_) => damage::bytes(bytes, chance),
        };
        field.write(name, &input)?;
        field.write("t.toml", scene.replace("FILE", name))?;
        let ended = field.program.run(&field.folder, &["check", "t.toml"])?;
        field.note(&mut found, &ended, (name, &input), None)?;
    }
    Ok(found)
}

/// Runs a quick scene of each engine; the folders of the runs.
fn sound_runs(field: &Field<'_>) -> Result<Vec<PathBuf>, String> {
    let mut runs = Vec::new();
    for (name, scene) in super::faults::engines(field.root)? {
        let file = format!("{name}.toml");
        field.write(&file, &scene)?;
        let out = format!("{name}.run");
        let mut words = vec!["run", &file, "--out", &out, "--threads", "1", "--quiet"];
        let changes = cut::words(&scene, 100);
        words.extend(changes.iter().map(String::as_str));
        let ended = field.program.run(&field.folder, &words)?;
        if ended.code != Some(0) {
            return Err(format!("{name}: {ended:?}"));
        }
        runs.push(field.folder.join(out));
    }
    Ok(runs)
}

/// All files of a folder with their bytes.
fn contents(folder: &Path) -> Result<Vec<(PathBuf, Vec<u8>)>, String> {
    let files = source_tree::files(folder, &[]).into_iter();
    files.map(|path| Ok((path.clone(), read(&path)?))).collect()
}

pub fn run_folders(field: &Field<'_>, chance: &mut Chance) -> Result<Found, String> {
    let runs = sound_runs(field)?;
    let mut kept = Vec::new();
    for run in &runs {
        let mut files = contents(run)?;
        files.retain(|(path, _)| !path.iter().any(|part| part == "checkpoints"));
        kept.push(files);
    }
    let mut found = Found::default();
    // Drawing takes longer than checking.
    for k in 0..field.tries.div_ceil(2) {
        let (run, files) = (&runs[k % runs.len()], &kept[k % runs.len()]);
        let (path, bytes) = chance.of(files);
        let input = damage::bytes(bytes, chance);
        write(path, &input)?;
        let name = run.file_name().unwrap_or_default().to_string_lossy();
        let words: &[&str] = if chance.below(2) == 0 {
            &["plot", &name, "blocks", "--output", "picture.svg"]
        } else {
            &["plot", &name]
        };
        let ended = field.program.run(&field.folder, words)?;
        write(path, bytes)?;
        let file = path.file_name().unwrap_or_default().to_string_lossy();
        field.note(&mut found, &ended, (&file, &input), None)?;
    }
    Ok(found)
}
