//! `manifest.json`: what was run, with what, and how it ended.

use super::disk::{OutputError, write_whole};
use super::field::FieldInfo;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

/// Version of the run folder; see `docs/src/run-folder.md` for what raises it.
pub const FORMAT_VERSION: u32 = 1;
/// Marks a manifest as ours.
pub const FORMAT: &str = "riprap-run";

/// How a run ended.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Ended {
    /// It has not ended, or the process died without a word.
    #[default]
    Running,
    /// All phases reached their ends.
    Finished,
    /// A stop criterion of the user ended it early.
    Stopped,
    /// Ctrl-C or a signal; the last checkpoint can be resumed.
    Interrupted,
    /// The physics stopped it (values that are not finite, divergence).
    Unstable,
}

/// Time spent in one stage of the step.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StageTime {
    /// Stage, for example `contact::forces`.
    pub name: String,
    /// Wall time in s.
    pub seconds: f64,
    /// The part of it in which several threads had work, s; the rest is serial.
    #[serde(default)]
    pub pooled: f64,
    /// How often it ran.
    pub calls: u64,
}

/// One key changed on the way from the file to the run.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Override {
    /// Dotted key.
    pub key: String,
    /// Its value as text.
    pub value: String,
}

/// A file that the scene reads.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct InputFile {
    /// Its name as the scene gives it.
    pub name: String,
    /// blake3 of its bytes, hexadecimal.
    pub blake3: String,
}

impl InputFile {
    /// The file as it is now; `None` where it can not be read. `folder` is where the scene lies.
    #[must_use]
    pub fn read(folder: &Path, name: &str) -> Option<Self> {
        let bytes = crate::read_plain(&folder.join(name)).ok()?;
        Some(Self { name: name.to_owned(), blake3: blake3::hash(&bytes).to_hex().to_string() })
    }
}

/// The machine.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Machine {
    /// Operating system.
    pub os: String,
    /// Processor architecture.
    pub arch: String,
    /// Processor name, empty if the system does not tell.
    pub cpu: String,
    /// Logical processors.
    pub cores: usize,
}

impl Machine {
    /// The machine this runs on.
    pub fn this() -> Self {
        // Linux only; elsewhere the name stays empty, which is allowed.
        let cpu = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let cpu = cpu.lines().find_map(|l| l.strip_prefix("model name")).unwrap_or("");
        Machine {
            os: std::env::consts::OS.to_owned(),
            arch: std::env::consts::ARCH.to_owned(),
            cpu: cpu.trim_start_matches([' ', '\t', ':']).trim().to_owned(),
            cores: std::thread::available_parallelism().map_or(0, std::num::NonZero::get),
        }
    }
}

/// A field as the manifest lists it: name, unit and meaning of what stands in frames and histories.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct FieldNote {
    /// Name.
    pub name: String,
    /// Unit, `-` for none.
    pub unit: String,
    /// One sentence.
    pub meaning: String,
}

impl From<&FieldInfo> for FieldNote {
    fn from(f: &FieldInfo) -> Self {
        FieldNote {
            name: f.name.to_owned(),
            unit: f.unit.to_owned(),
            meaning: f.meaning.to_owned(),
        }
    }
}

/// What a boundary, support or load has done.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Work {
    /// `boundary`, `support` or `load`.
    pub of: String,
    /// Its name in the scene, or what stands for one.
    pub name: String,
    /// Its work since the start in `unit`.
    pub work: f64,
    /// J; J/m for a model in the plane without thickness.
    pub unit: String,
}

/// A charge, or another cavity that pushes on the rock around it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Source {
    /// Name in the scene.
    pub name: String,
    /// Where it lies: a key `centre` or `line`.
    #[serde(flatten)]
    pub place: Place,
    /// Time at which it goes off in s.
    #[serde(default)]
    pub delay: f64,
    /// Mass of the explosive in kg; `None` if what pushes is no explosive.
    #[serde(default)]
    pub mass: Option<f64>,
    /// Volume of the explosive before it goes off in m³; `None` as for the mass.
    #[serde(default)]
    pub charge_volume: Option<f64>,
    /// Volume of the blocks that were taken out for it in m³.
    #[serde(default)]
    pub cavity_volume: f64,
    /// Depth of its centre below the free surface over it in m (the line of least resistance of a buried charge);
    /// `None` where there is rock up to the boundary of the model.
    #[serde(default)]
    pub depth: Option<f64>,
}

/// Where a source lies, global axes, before anything moves.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Place {
    /// Concentrated: its centre in m.
    Centre([f64; 3]),
    /// Elongated: its ends in m.
    Line([[f64; 3]; 2]),
}

impl Source {
    /// Its centre in m; of a line the middle.
    pub fn centre(&self) -> [f64; 3] {
        match self.place {
            Place::Centre(c) => c,
            Place::Line([a, b]) => [0, 1, 2].map(|k| 0.5 * (a[k] + b[k])),
        }
    }

    /// Distance in m from the centre, or from the nearest point of the line.
    pub fn distance(&self, p: [f64; 3]) -> f64 {
        let minus = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|k| a[k] - b[k]);
        let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let (from, along) = match self.place {
            Place::Centre(c) => (c, [0.0; 3]),
            Place::Line([a, b]) => (a, minus(b, a)),
        };
        let (way, length2) = (minus(p, from), dot(along, along));
        let share = if length2 > 0.0 { (dot(way, along) / length2).clamp(0.0, 1.0) } else { 0.0 };
        let rest = [0, 1, 2].map(|k| way[k] - share * along[k]);
        dot(rest, rest).sqrt()
    }
}

/// Where the gas of charges is that may enter cracks, and its energy.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Gas {
    /// Mass of the charges that have gone off, kg.
    pub mass: f64,
    /// The part of it in cracks, kg.
    pub in_cracks: f64,
    /// The part of it that has left into the air, kg.
    pub vented: f64,
    /// Energy released, J.
    pub released: f64,
    /// Energy that the gas still has, J.
    pub internal: f64,
    /// Work on the rock, J.
    pub work: f64,
    /// The part of it by the sides of cracks, J.
    pub work_in_cracks: f64,
    /// Lost by friction of the flow and by its integration, J.
    pub friction: f64,
    /// Taken along by vented gas, given to the air and to stemming, J.
    pub carried_off: f64,
}

/// Contents of `manifest.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Manifest {
    /// Always [`FORMAT`].
    pub format: String,
    /// Version of the run folder.
    pub format_version: u32,
    /// Version of riprap that wrote it.
    pub riprap: String,
    /// Title of the scene.
    pub title: String,
    /// Scene file as given.
    pub scenario: String,
    /// blake3 of the resolved scene and all files it reads, hexadecimal.
    pub input_hash: String,
    /// Files that the scene reads.
    pub files: Vec<InputFile>,
    /// Named variant of the scene.
    pub variant: String,
    /// Sweep case, for example `friction_angle=5 deg`; empty outside a sweep.
    pub case: String,
    /// Keys changed by variant, case and command line, in the order of application.
    pub overrides: Vec<Override>,
    /// Threads used.
    pub threads: usize,
    /// The machine.
    pub machine: Machine,
    /// Start, UTC, RFC 3339.
    pub started: String,
    /// Wall time in s.
    pub wall_time: f64,
    /// The part of it, since the run was begun or resumed, in which several threads had work, s.
    #[serde(default)]
    pub pooled_time: f64,
    /// Last time step in s.
    pub dt: f64,
    /// Steps done.
    pub steps: u64,
    /// Model time in s.
    pub time: f64,
    /// blake3 of the final state, hexadecimal: equal hashes mean bitwise equal states.
    pub state_hash: String,
    /// How it ended.
    pub ended: Ended,
    /// One sentence more on how it ended.
    pub message: String,
    /// Warnings worth reading.
    pub warnings: Vec<String>,
    /// Time per stage of the step, in the order of the step.
    pub profile: Vec<StageTime>,
    /// Fields in frames and histories.
    pub fields: Vec<FieldNote>,
    /// Charges and other cavities of a run in space, in the order of the scene.
    pub sources: Vec<Source>,
    /// Work of boundaries, supports and loads since the start.
    pub works: Vec<Work>,
    /// The gas that may enter cracks; `None` where there is none.
    pub gas: Option<Gas>,
    /// Acceleration of gravity, m/s²: a picture stands on its feet by it. Zero in folders of earlier versions.
    pub gravity: [f64; 3],
    /// Names of the materials, in the order of the numbers that frames carry.
    pub materials: Vec<String>,
    /// Whether this is a model before it is run (`riprap view SCENE`), and no run.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub preview: bool,
}

impl Default for Manifest {
    fn default() -> Self {
        Manifest {
            format: FORMAT.to_owned(),
            format_version: FORMAT_VERSION,
            riprap: env!("CARGO_PKG_VERSION").to_owned(),
            title: String::new(),
            scenario: String::new(),
            input_hash: String::new(),
            files: Vec::new(),
            variant: String::new(),
            case: String::new(),
            overrides: Vec::new(),
            threads: 0,
            machine: Machine::default(),
            started: String::new(),
            wall_time: 0.0,
            pooled_time: 0.0,
            dt: 0.0,
            steps: 0,
            time: 0.0,
            state_hash: String::new(),
            ended: Ended::Running,
            message: String::new(),
            warnings: Vec::new(),
            profile: Vec::new(),
            fields: Vec::new(),
            sources: Vec::new(),
            works: Vec::new(),
            gas: None,
            gravity: [0.0; 3],
            materials: Vec::new(),
            preview: false,
        }
    }
}

/// Why a manifest cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum ManifestError {
    /// Not there or not readable.
    #[error("could not read {}: {source}; is this a run folder?", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// Not a manifest of ours.
    #[error("{} is not a riprap manifest: {reason}", path.display())]
    Foreign {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// Written by a later riprap.
    #[error(
        "{} has run-folder format {found}, this riprap reads up to {FORMAT_VERSION}; use a newer riprap",
        path.display()
    )]
    Newer {
        /// The file.
        path: PathBuf,
        /// Its format version.
        found: u32,
    },
}

impl Manifest {
    /// Reads `manifest.json` of a run folder.
    ///
    /// # Errors
    /// Missing, foreign or newer manifests.
    pub fn read(folder: &Path) -> Result<Self, ManifestError> {
        let path = folder.join("manifest.json");
        let text = crate::read_plain_text(&path)
            .map_err(|source| ManifestError::Read { path: path.clone(), source })?;
        let foreign = |reason: String| ManifestError::Foreign { path: path.clone(), reason };
        // Only the two marks first: a newer manifest may have another shape.
        let value: serde_json::Value =
            serde_json::from_str(&text).map_err(|e| foreign(e.to_string()))?;
        if value["format"] != FORMAT {
            return Err(foreign(format!("`format` is not \"{FORMAT}\"")));
        }
        let found = value["format_version"].as_u64().unwrap_or(0);
        if found > u64::from(FORMAT_VERSION) {
            let found = u32::try_from(found).unwrap_or(u32::MAX);
            return Err(ManifestError::Newer { path: path.clone(), found });
        }
        serde_json::from_value(value).map_err(|e| foreign(e.to_string()))
    }

    /// Writes `manifest.json`; the old one stays until the new one is complete.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn write(&self, folder: &Path) -> Result<(), OutputError> {
        let path = folder.join("manifest.json");
        let mut text = serde_json::to_string_pretty(self)
            .map_err(|e| OutputError { path: path.clone(), source: e.into() })?;
        text.push('\n');
        write_whole(&path, text.as_bytes())
    }
}

/// A moment in UTC as RFC 3339, whole seconds: `2026-11-21T09:28:42Z`.
pub fn utc(moment: SystemTime) -> String {
    let seconds = moment.duration_since(UNIX_EPOCH).map_or(0, |d| d.as_secs());
    let (days, rest) = (seconds / 86_400, seconds % 86_400);
    // Days to civil date: Howard Hinnant, "chrono-compatible low-level date algorithms", for days >= 0.
    let z = days + 719_468;
    let (era, doe) = (z / 146_097, z % 146_097);
    let yoe = (doe - doe / 1460 + doe / 36_524 - doe / 146_096) / 365;
    let doy = doe - (365 * yoe + yoe / 4 - yoe / 100);
    let mp = (5 * doy + 2) / 153;
    let day = doy - (153 * mp + 2) / 5 + 1;
    let month = if mp < 10 { mp + 3 } else { mp - 9 };
    let year = yoe + era * 400 + u64::from(month <= 2);
    let (h, m, s) = (rest / 3600, rest / 60 % 60, rest % 60);
    format!("{year:04}-{month:02}-{day:02}T{h:02}:{m:02}:{s:02}Z")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn round_trip_and_refusals() {
        let dir = tempfile::tempdir().unwrap();
        assert!(matches!(Manifest::read(dir.path()), Err(ManifestError::Read { .. })));
        let m = Manifest {
            title: "sliding block".to_owned(),
            ended: Ended::Interrupted,
            overrides: vec![Override { key: "a.b".to_owned(), value: "5 deg".to_owned() }],
            profile: vec![StageTime {
                name: "gather".to_owned(),
                seconds: 0.25,
                pooled: 0.125,
                calls: 7,
            }],
            machine: Machine::this(),
            ..Manifest::default()
        };
        m.write(dir.path()).unwrap();
        assert_eq!(Manifest::read(dir.path()).unwrap(), m);
        let path = dir.path().join("manifest.json");
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(text.contains("\"ended\": \"interrupted\""), "{text}");
        std::fs::write(&path, text.replace("\"format_version\": 1", "\"format_version\": 7"))
            .unwrap();
        assert!(matches!(Manifest::read(dir.path()), Err(ManifestError::Newer { found: 7, .. })));
        std::fs::write(&path, "{\"name\": \"npm\"}").unwrap();
        assert!(matches!(Manifest::read(dir.path()), Err(ManifestError::Foreign { .. })));
        std::fs::write(&path, &text[..40]).unwrap();
        assert!(matches!(Manifest::read(dir.path()), Err(ManifestError::Foreign { .. })));
    }

    #[test]
    fn sources_have_a_centre_or_a_line() {
        let text = r#"[{"name": "a", "centre": [0, 0, -2], "mass": 8.0, "depth": 2.0},
            {"name": "b", "line": [[0, 0, 0], [0, 0, -4]], "cavity_volume": 0.5}]"#;
        let sources: Vec<Source> = serde_json::from_str(text).unwrap();
        let m = Manifest { sources: sources.clone(), ..Manifest::default() };
        let again = serde_json::to_string(&m).unwrap();
        assert_eq!(serde_json::from_str::<Manifest>(&again).unwrap(), m);
        assert_eq!(sources[0].distance([3.0, 0.0, 2.0]), 5.0);
        assert_eq!(sources[1].centre(), [0.0, 0.0, -2.0]);
        assert_eq!(sources[1].distance([1.0, 0.0, -3.0]), 1.0);
        assert_eq!(sources[1].distance([0.0, 0.0, -6.0]), 2.0);
        assert_eq!((sources[1].mass, sources[1].depth), (None, None));
        // A folder of an earlier riprap has no sources.
        assert!(serde_json::from_str::<Manifest>("{}").unwrap().sources.is_empty());
    }

    #[test]
    fn dates() {
        let at = |s| utc(UNIX_EPOCH + Duration::from_secs(s));
        assert_eq!(at(0), "1970-01-01T00:00:00Z");
        assert_eq!(at(951_827_696), "2000-02-29T12:34:56Z");
        assert_eq!(at(1_795_253_322), "2026-11-21T09:28:42Z");
    }
}
