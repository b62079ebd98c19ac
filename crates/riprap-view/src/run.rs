//! One run folder, opened for looking: frames by their place in the list of frames, read when asked for.
//!
//! Only the public readers of `riprap_record` touch the files, and only names that they make themselves or that
//! lie inside the folder. A run that goes on while it is looked at is read again each time.

use riprap_geom::Vec3;
use riprap_record::conditions::{self, Conditions};
use riprap_record::folder::{
    block_file, bolt_file, contact_file, crack_file, in_use, tetrahedron_file,
};
use riprap_record::names::Names;
use riprap_record::table::Table;
use riprap_record::vtu::{self, Moment, PvdEntry, Wanted};
use riprap_record::{Column, Ended, Frame, Manifest, Part};
use std::collections::{BTreeMap, BTreeSet};
use std::io::{BufRead as _, BufReader, Read as _};
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::SystemTime;

pub use crate::problem::Problem;
use crate::shape::{self, Shape};

/// Shapes kept in memory; runs that split blocks have many.
const SHAPES: usize = 3;
/// Lines of a file of JSON that are handed out.
const LINES: usize = 20_000;
/// Longer lines are none of ours.
const LONGEST_LINE: u64 = 1 << 20;
/// Files larger than this are not handed out.
const LARGEST_FILE: u64 = 256 << 20;

/// A run folder.
#[derive(Debug)]
pub struct Run {
    path: PathBuf,
    memory: Mutex<Memory>,
    /// Held while a shape is made.
    making: Mutex<()>,
}

#[derive(Debug, Default)]
struct Memory {
    /// Middle of the first frame: positions are sent relative to it.
    origin: Option<Vec3>,
    /// Newest last.
    shapes: Vec<Arc<Shape>>,
    /// The list of frames, with when it was written and its length.
    list: Option<(SystemTime, u64, Arc<Vec<PvdEntry>>)>,
    /// When the frames are, by their files: asked for again and again while a run goes on.
    moments: BTreeMap<String, Moment>,
}

impl Run {
    /// A folder, sound or not: what is wrong with it is reported when it is asked for something.
    pub fn new(path: &Path) -> Self {
        Run { path: path.to_owned(), memory: Mutex::default(), making: Mutex::default() }
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Its manifest.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn manifest(&self) -> Result<Manifest, Problem> {
        use riprap_record::manifest::ManifestError;
        Manifest::read(&self.path).map_err(|error| {
            let hint = match &error {
                ManifestError::Read { .. } => self.where_runs_are(),
                ManifestError::Foreign { .. } => {
                    "Its manifest.json was changed or truncated. Copy the run folder again, or run the scene again.".to_owned()
                }
                ManifestError::Newer { .. } => {
                    "Use the riprap that wrote it, or a newer one.".to_owned()
                }
            };
            Problem::broken(error.to_string(), hint)
        })
    }

    /// What to name instead of a folder that is no run: runs inside it, as sweeps and comparisons leave them.
    fn where_runs_are(&self) -> String {
        let mut inside: Vec<String> = std::fs::read_dir(&self.path)
            .into_iter()
            .flatten()
            .flatten()
            .take(1000)
            .filter(|entry| entry.path().join("manifest.json").is_file())
            .map(|entry| self.path.join(entry.file_name()).display().to_string())
            .collect();
        inside.sort();
        match &inside[..] {
            [] => "A run folder is written by `riprap run`, for example hill.run, and contains a manifest.json. Name that folder: riprap view \
                   hill.run".to_owned(),
            [one] => format!("It contains a run: riprap view {one}"),
            [one, two, ..] => format!(
                "It contains {} runs. Name one or two of them: riprap view {one} {two}",
                inside.len()
            ),
        }
    }

    /// Names of its blocks and groups; none if the file is missing or damaged, since numbers do as well.
    pub fn names(&self) -> Names {
        Names::read(&self.path).unwrap_or_default()
    }

    /// Times of the frames there are.
    ///
    /// # Errors
    /// A list that is missing or damaged.
    pub fn frames(&self) -> Result<Arc<Vec<PvdEntry>>, Problem> {
        let path = self.path.join("run.pvd");
        let Ok(state) = path.metadata() else {
            return Ok(Arc::default());
        };
        // Read once as long as it stays the same: every question about a frame looks into it.
        let state = state.modified().ok().map(|at| (at, state.len()));
        if let (Some((at, length, list)), Some(now)) = (&self.memory().list, state)
            && (*at, *length) == now
        {
            return Ok(Arc::clone(list));
        }
        let read = vtu::read_pvd(&path).map_err(|error| {
            Problem::broken(
                error.to_string(),
                "The list of frames is damaged. Copy the run folder again, or run the scene again.",
            )
        })?;
        let list = Arc::new(read);
        self.memory().list = state.map(|(at, length)| (at, length, Arc::clone(&list)));
        Ok(list)
    }

    /// When the frames are, as many as there are in [`Run::frames`]. One that cannot be read has the time of the list, step 0 and
    /// no phase.
    ///
    /// # Errors
    /// As [`Run::frames`].
    pub fn moments(&self) -> Result<Vec<Moment>, Problem> {
        let frames = self.frames()?;
        // One look at the folder: a list may name far more frames than there are, and to look for each takes minutes.
        let there: BTreeSet<String> = std::fs::read_dir(self.path.join("frames"))
            .into_iter()
            .flatten()
            .flatten()
            .map(|entry| format!("frames/{}", entry.file_name().to_string_lossy()))
            .collect();
        let mut memory = self.memory();
        let all = frames.iter().map(|entry| {
            if let Some(known) = memory.moments.get(&entry.file) {
                // Another run may have taken the folder.
                if known.time == entry.time {
                    return known.clone();
                }
            }
            let file = there.contains(&entry.file).then(|| self.inside(&entry.file));
            let read = file.and_then(Result::ok).and_then(|f| vtu::read_moment(&f).ok());
            let moment = Moment { time: entry.time, ..read.unwrap_or_default() };
            memory.moments.insert(entry.file.clone(), moment.clone());
            moment
        });
        Ok(all.collect())
    }

    /// Whether a process is still writing into it. A manifest that says so with nobody there means that it died.
    pub fn live(&self, manifest: &Manifest) -> bool {
        manifest.ended == Ended::Running && in_use(&self.path) != Some(false)
    }

    /// Files of blocks and contacts of frame `k`, counted from 0.
    fn files(&self, k: usize) -> Result<[PathBuf; 2], Problem> {
        Ok(self.numbered(k)?.1)
    }

    /// The number of frame `k` and its files.
    fn numbered(&self, k: usize) -> Result<(u32, [PathBuf; 2]), Problem> {
        let frames = self.frames()?;
        let entry = frames.get(k).ok_or_else(|| {
            Problem::missing(
                format!("there is no frame {k}: the run has {}", frames.len()),
                "Frames are numbered from 0.",
            )
        })?;
        // Names are made here and only compared: a list that points elsewhere is not followed.
        let number = entry
            .file
            .strip_prefix("frames/frame_")
            .and_then(|n| n.strip_suffix(".vtu"))
            .and_then(|n| n.parse().ok())
            .filter(|n| block_file(*n) == entry.file);
        let Some(number) = number else {
            return Err(Problem::broken(
                format!("run.pvd names {:?}, which is not a frame of this run", entry.file),
                "The list of frames was changed. Copy the run folder again, or run the scene again.",
            ));
        };
        let files = [self.inside(&block_file(number))?, self.inside(&contact_file(number))?];
        Ok((number, files))
    }

    /// A file of the folder by its relative name. What leads out of the folder, by `..` or by a link, is refused.
    ///
    /// # Errors
    /// Names that lead outside, files that are not there.
    pub fn inside(&self, name: &str) -> Result<PathBuf, Problem> {
        let refused = || {
            Problem::missing(
                format!("{name:?} is not inside the run folder"),
                "Only files in the run folder are shown.",
            )
        };
        let plain = Path::new(name).components().all(|c| matches!(c, Component::Normal(_)));
        if !plain {
            return Err(refused());
        }
        let absent = |_| {
            Problem::missing(
                format!("{} does not exist", self.path.join(name).display()),
                "The file is missing. Copy the complete run folder again.",
            )
        };
        let root = self.path.canonicalize().map_err(absent)?;
        let file = root.join(name).canonicalize().map_err(absent)?;
        if file.starts_with(&root) { Ok(file) } else { Err(refused()) }
    }

    /// Bytes of a file of the folder.
    ///
    /// # Errors
    /// As [`Run::inside`], and files that are too large.
    pub fn file(&self, name: &str) -> Result<Vec<u8>, Problem> {
        let path = self.inside(name)?;
        let unreadable = |e: std::io::Error| {
            Problem::broken(
                format!("could not read {}: {e}", path.display()),
                "Check that it is a file that you are allowed to read.",
            )
        };
        let length = path.metadata().map_err(unreadable)?.len();
        if length > LARGEST_FILE {
            return Err(Problem::broken(
                format!("{} is too large for the page", path.display()),
                "Open it with another program.",
            ));
        }
        riprap_record::read_plain(&path).map_err(unreadable)
    }

    /// A file of JSON, if it is there and whole.
    #[must_use]
    pub fn json(&self, name: &str) -> Option<serde_json::Value> {
        serde_json::from_slice(&self.file(name).ok()?).ok()
    }

    /// Corners of frame `k` and the columns that tell its blocks apart, with the shape of its blocks.
    ///
    /// # Errors
    /// Frames that are not there or damaged.
    pub fn placed(&self, k: usize) -> Result<(Arc<Shape>, Frame), Problem> {
        let [file, _] = self.files(k)?;
        let known = |name: &str| ["block", "displacement", "rotation"].contains(&name);
        let wanted = Wanted { geometry: true, column: &known };
        let frame = vtu::read_blocks(&file, wanted)?;
        let key = shape::key(&frame);
        if let Some(shape) = self.remembered(&key) {
            return Ok((shape, frame));
        }
        // Who asks for it meanwhile waits: a large one takes a second on all cores.
        let _alone = self.making.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(shape) = self.remembered(&key) {
            return Ok((shape, frame));
        }
        let origin = self.origin(k, &frame)?;
        let shape = Arc::new(Shape::of(&frame, origin));
        let mut memory = self.memory();
        if memory.shapes.len() == SHAPES {
            memory.shapes.remove(0);
        }
        memory.shapes.push(Arc::clone(&shape));
        Ok((shape, frame))
    }

    /// Makes the shape of the last frame, with which the page begins; what is wrong with it is said to the page.
    pub(crate) fn prepare(&self) {
        if let Some(last) = self.moments().ok().and_then(|moments| moments.len().checked_sub(1)) {
            let _ = self.placed(last);
        }
    }

    fn memory(&self) -> std::sync::MutexGuard<'_, Memory> {
        // What is kept here is only a copy of what can be read again.
        self.memory.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn remembered(&self, key: &str) -> Option<Arc<Shape>> {
        let mut memory = self.memory();
        let at = memory.shapes.iter().position(|s| s.key == key)?;
        let shape = memory.shapes.remove(at);
        memory.shapes.push(Arc::clone(&shape));
        Some(shape)
    }

    /// Middle of the first frame that can be read: the same for all answers.
    fn origin(&self, k: usize, frame: &Frame) -> Result<Vec3, Problem> {
        if let Some(origin) = self.memory().origin {
            return Ok(origin);
        }
        let first = if k == 0 {
            None
        } else {
            let [file, _] = self.files(0)?;
            let bare = Wanted { geometry: true, column: &|_| false };
            vtu::read_blocks(&file, bare).ok()
        };
        let points: Vec<Vec3> =
            first.as_ref().unwrap_or(frame).points.iter().map(|p| Vec3::from(*p)).collect();
        let (low, high) = shape::bounds(&points);
        Ok(*self.memory().origin.insert(0.5 * (low + high)))
    }

    /// Columns of the blocks of frame `k`: the chosen ones, in the order of the file.
    ///
    /// # Errors
    /// As [`Run::placed`].
    pub fn columns(&self, k: usize, chosen: &dyn Fn(&str) -> bool) -> Result<Vec<Column>, Problem> {
        let [file, _] = self.files(k)?;
        let wanted = Wanted { geometry: false, column: chosen };
        Ok(vtu::read_some(&file, wanted)?.cell_columns)
    }

    /// Numbers of one field of the blocks of frame `k`: `displacement.x`, `velocity` (its length), `rotation`.
    /// With `block`, the numbers of the blocks.
    ///
    /// # Errors
    /// As [`Run::placed`]; a field that the frame does not have.
    pub fn field(&self, k: usize, name: &str) -> Result<Numbers, Problem> {
        let (stem, part) = Part::split(name);
        let columns = self.columns(k, &|n| n == stem || n == "block")?;
        let column = columns.iter().find(|c| c.name == stem).ok_or_else(|| {
            Problem::missing(format!("frame {k} has no field {stem:?}"), "Choose another field.")
        })?;
        let ids = columns.iter().find(|c| c.name == "block");
        Ok(Numbers {
            unit: column.unit.clone(),
            values: column.numbers(part),
            ids: ids.map_or_else(
                || (0..column.len() as u32).collect(),
                |c| c.data.iter().map(|v| *v as u32).collect(),
            ),
        })
    }

    /// A column of vectors.
    ///
    /// # Errors
    /// As [`Run::field`].
    pub fn vectors(&self, k: usize, name: &str) -> Result<Column, Problem> {
        let columns = self.columns(k, &|n| n == name)?;
        let column = columns.into_iter().find(|c| c.components > 1);
        column.ok_or_else(|| {
            Problem::missing(format!("frame {k} has no vectors {name:?}"), "Choose another field.")
        })
    }

    /// What holds, moves and loads the model; `None` in runs of earlier versions.
    ///
    /// # Errors
    /// A damaged file.
    pub fn conditions(&self) -> Result<Option<Conditions>, Problem> {
        conditions::read(&self.path).map_err(|error| {
            Problem::broken(error.to_string(), "Copy the run folder again, or run the scene again.")
        })
    }

    /// Contacts of frame `k`: places less the origin, and columns; numbers of its blocks.
    ///
    /// # Errors
    /// As [`Run::placed`].
    pub fn contacts(&self, k: usize) -> Result<Touches, Problem> {
        let [blocks, file] = self.files(k)?;
        let contacts = vtu::read(&file)?;
        Ok(Touches {
            points: self.less_origin(k, &contacts.points)?,
            columns: contacts.point_columns,
            ids: numbers_of(&blocks)?,
        })
    }

    /// Cracks of frame `k`: outlines of the broken parts of deformable blocks.
    ///
    /// # Errors
    /// As [`Run::placed`]; a run without deformable blocks has none.
    pub fn cracks(&self, k: usize) -> Result<Cracks, Problem> {
        let (number, [blocks, _]) = self.numbered(k)?;
        let cracks = vtu::read(&self.inside(&crack_file(number))?)?;
        Ok(Cracks {
            points: self.less_origin(k, &cracks.points)?,
            ends: cracks.offsets,
            columns: cracks.cell_columns,
            ids: numbers_of(&blocks)?,
        })
    }

    /// Bars of bolts of frame `k`, two points each; none before the first bolt is put in.
    ///
    /// # Errors
    /// As [`Run::placed`]; a run without bolts.
    pub fn bolts(&self, k: usize) -> Result<Cracks, Problem> {
        let (number, [blocks, _]) = self.numbered(k)?;
        let bolts = match self.inside(&bolt_file(number)) {
            Ok(file) => vtu::read(&file)?,
            Err(_) if self.inside("bolts.pvd").is_ok() => vtu::Vtu::default(),
            Err(problem) => return Err(problem),
        };
        Ok(Cracks {
            points: self.less_origin(k, &bolts.points)?,
            ends: bolts.offsets,
            columns: bolts.cell_columns,
            ids: numbers_of(&blocks)?,
        })
    }

    /// Tetrahedra of deformable blocks of frame `k`, four corners each; `None` where the scene did not ask for them.
    ///
    /// # Errors
    /// As [`Run::placed`].
    pub fn tetrahedra(&self, k: usize) -> Result<Option<Cracks>, Problem> {
        let (number, [blocks, _]) = self.numbered(k)?;
        let Ok(file) = self.inside(&tetrahedron_file(number)) else {
            return Ok(None);
        };
        let read = vtu::read(&file)?;
        Ok(Some(Cracks {
            points: self.less_origin(k, &read.points)?,
            ends: read.offsets,
            columns: read.cell_columns,
            ids: numbers_of(&blocks)?,
        }))
    }

    fn less_origin(&self, k: usize, points: &[[f64; 3]]) -> Result<Vec<Vec3>, Problem> {
        let origin = self.memory().origin;
        let origin = match origin {
            Some(origin) => origin,
            None => self.placed(k)?.0.origin,
        };
        Ok(points.iter().map(|p| Vec3::from(*p) - origin).collect())
    }

    /// `histories.csv` or `energy.csv`; `None` if the run has none.
    ///
    /// # Errors
    /// A damaged file.
    pub fn table(&self, name: &str) -> Result<Option<Table>, Problem> {
        let Ok(path) = self.inside(name) else {
            return Ok(None);
        };
        Table::read(&path).map(Some).map_err(|error| {
            Problem::broken(
                error.to_string(),
                "Repair the file with a text editor, or copy the run folder again.",
            )
        })
    }

    /// Complete lines of an append-only file of JSON, the first ones; lines that are no JSON are left out.
    pub fn lines(&self, name: &str) -> Vec<serde_json::Value> {
        let mut lines = Vec::new();
        // What could be read until something went wrong is shown.
        let _ = self.each_line(name, &mut |line| {
            lines.push(line);
            lines.len() < LINES
        });
        lines
    }

    /// Hands on all complete lines of an append-only file of JSON, however long it is, until told to stop by `false`; lines that are no JSON
    /// are left out. A file that is not there has none.
    ///
    /// # Errors
    /// A file that cannot be read to its end.
    pub fn each_line(
        &self,
        name: &str,
        more: &mut dyn FnMut(serde_json::Value) -> bool,
    ) -> Result<(), Problem> {
        let Ok(path) = self.inside(name) else {
            return Ok(());
        };
        let unreadable = |e: std::io::Error| {
            Problem::broken(
                format!("could not read {} to its end: {e}", path.display()),
                "Check that it is a file that you are allowed to read.",
            )
        };
        let file = riprap_record::open_plain(&path).map_err(unreadable)?;
        let mut file = BufReader::new(file);
        let (mut line, mut skipping) = (Vec::new(), false);
        loop {
            line.clear();
            let mut part = file.by_ref().take(LONGEST_LINE);
            let read = part.read_until(b'\n', &mut line).map_err(unreadable)?;
            if read == 0 {
                return Ok(());
            }
            let ends = line.last() == Some(&b'\n');
            // A line that does not end is being written, or is no line of ours.
            if ends
                && !skipping
                && let Ok(value) = serde_json::from_slice(&line)
                && !more(value)
            {
                return Ok(());
            }
            skipping = !ends;
        }
    }
}

/// Contacts of a frame.
#[derive(Debug)]
pub struct Touches {
    /// Places less the origin, m.
    pub points: Vec<Vec3>,
    /// Numbers on contacts.
    pub columns: Vec<Column>,
    /// Shape `[blocks]`: numbers of the blocks of the frame.
    pub ids: Vec<u32>,
}

/// Cracks of a frame, bars of its bolts, or its tetrahedra.
#[derive(Debug)]
pub struct Cracks {
    /// Corners less the origin, m.
    pub points: Vec<Vec3>,
    /// Shape `[cracks]`: end of the corners of each.
    pub ends: Vec<u32>,
    /// Numbers on cracks.
    pub columns: Vec<Column>,
    /// Shape `[blocks]`: numbers of the blocks of the frame.
    pub ids: Vec<u32>,
}

/// Numbers of the blocks of a frame.
fn numbers_of(blocks: &Path) -> Result<Vec<u32>, Problem> {
    let only = Wanted { geometry: false, column: &|n| n == "block" };
    let columns = vtu::read_some(blocks, only)?.cell_columns;
    let ids = columns.first();
    Ok(ids.map_or_else(Vec::new, |c| c.data.iter().map(|v| *v as u32).collect()))
}

/// One number per block.
#[derive(Debug)]
pub struct Numbers {
    /// Unit, `-` for none.
    pub unit: String,
    /// Shape `[blocks]`.
    pub values: Vec<f64>,
    /// Shape `[blocks]`: numbers of the blocks.
    pub ids: Vec<u32>,
}
