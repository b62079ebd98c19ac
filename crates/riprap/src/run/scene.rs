//! A scene file as something to run: its cases, each with its job.

use std::path::{Path, PathBuf};

use crate::exec::Exec;
use crate::model::{self, Model};
use crate::plan::Check;
use crate::record::manifest::{InputFile, Override};
use crate::record::{FieldInfo, Manifest};
use crate::run::engine::{BuildError, Kind};
use crate::run::given_step::{self, RefusedStep};
use crate::run::job::Job;
use crate::run::simulation::{RunError, Simulation};
use crate::scenario::foreign::dfnworks::companions;
use crate::scenario::language::Space;
use crate::scenario::{self, Case, Diagnostic, Diagnostics, Parsed, Source};
use crate::setup::Setup;

/// A scene as the user wants it run.
#[derive(Clone, Debug)]
pub struct Scene {
    /// File.
    pub path: PathBuf,
    /// The scene with the user's changes.
    pub parsed: Parsed,
    /// Its cases: variants and combinations of swept values.
    pub cases: Vec<Case>,
    /// The user's changes.
    pub changes: Vec<(String, String)>,
    /// What a study asks of every case beside the checks of its own.
    pub asks: Option<Check>,
}

/// One case, ready to run.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// The text the model was built from: the file's own when nothing is changed.
    pub parsed: Parsed,
    /// The text of the case alone, runnable as it stands.
    pub resolved: String,
    /// The model.
    pub model: Model,
    /// The manifest as far as it is known before the run.
    pub manifest: Manifest,
}

impl Scene {
    /// Reads a scene and lists its cases.
    ///
    /// # Errors
    /// Everything that is wrong with the text.
    pub fn load(path: &Path, changes: &[(String, String)]) -> Result<Self, Diagnostics> {
        let parsed = scenario::load(path, changes)?;
        let cases = scenario::cases(&parsed.source, &parsed.scenario)?;
        Ok(Self { path: path.to_owned(), parsed, cases, changes: changes.to_vec(), asks: None })
    }

    /// As [`Scene::load`] for a text; relative paths in it are seen from `folder`.
    ///
    /// # Errors
    /// Everything that is wrong with the text.
    pub fn parse(
        source: Source,
        folder: PathBuf,
        changes: &[(String, String)],
    ) -> Result<Self, Diagnostics> {
        let path = PathBuf::from(&source.name);
        let mut parsed = scenario::parse_changed(&source, changes)?;
        parsed.folder = folder;
        let cases = scenario::cases(&parsed.source, &parsed.scenario)?;
        Ok(Self { path, parsed, cases, changes: changes.to_vec(), asks: None })
    }

    /// The scene as it stands: the variant `default`, with nothing swept.
    #[must_use]
    pub fn plain(&self) -> Case {
        let variant = "default";
        let changes = self.parsed.scenario.variants.get(variant).map_or_else(Vec::new, |table| {
            table.iter().map(|(key, value)| (key.text.clone(), value.to_string())).collect()
        });
        Case { name: variant.to_owned(), variant: variant.to_owned(), changes, trial: Vec::new() }
    }

    /// The case of that name; the plain one is called `default`.
    #[must_use]
    pub fn case(&self, name: &str) -> Option<Case> {
        let found = self.cases.iter().find(|case| case.name == name).cloned();
        found.or_else(|| (name == "default").then(|| self.plain()))
    }

    /// Builds the model of one case.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn prepare(&self, case: &Case) -> Result<Prepared, Diagnostics> {
        let mut source = case.source(&self.parsed.source, &self.changes)?;
        let resolved = source.text.clone();
        let parsed = if case.is_plain() {
            // Places in messages are then those of the file.
            self.parsed.clone()
        } else {
            source.name = format!("{} (case {})", source.name, case.name);
            let changes = [&case.changes[..], &self.changes, &case.trial].concat();
            let mut lost = self.parsed.warnings.clone();
            lost.retain(|warning| warning.code == scenario::TABLE_REPLACED);
            lost.extend(scenario::fallen_away(&self.parsed.source, &changes));
            let mut parsed = scenario::parse_with(source, lost)?;
            parsed.folder.clone_from(&self.parsed.folder);
            parsed
        };
        let mut model = build(&parsed, &case.variant)?;
        model.checks.extend(self.asks.clone());
        let changed = case.changes.iter().chain(&self.changes).chain(&case.trial);
        let manifest = Manifest {
            title: parsed.scenario.title.clone(),
            scenario: self.path.display().to_string(),
            input_hash: input_hash(&resolved, &parsed.folder),
            files: named_files(&resolved, &parsed.folder)
                .iter()
                .filter_map(|name| InputFile::read(&parsed.folder, name))
                .collect(),
            variant: case.variant.clone(),
            case: if self.cases.len() > 1 { case.name.clone() } else { String::new() },
            overrides: changed
                .map(|(key, value)| Override { key: key.clone(), value: value.clone() })
                .collect(),
            warnings: model.warnings.iter().map(|warning| warning.message.clone()).collect(),
            gravity: match &model.setup {
                Setup::Planar(setup) => [setup.gravity[0], setup.gravity[1], 0.0],
                Setup::Spatial(setup) => setup.gravity.to_array(),
            },
            materials: parsed.scenario.materials.names().map(str::to_owned).collect(),
            ..Manifest::default()
        };
        Ok(Prepared { parsed, resolved, model, manifest })
    }
}

impl Prepared {
    /// The model as a simulation that records nothing, with its forces found.
    ///
    /// # Errors
    /// As [`Simulation::from_toml`].
    pub fn simulation(self, exec: Exec) -> Result<Simulation, SceneError> {
        let mut simulation = Simulation::new(self.model.setup, self.model.plan, exec)?;
        given_step::check(&simulation)?;
        simulation.advance(0)?;
        Ok(simulation)
    }

    /// What is run.
    #[must_use]
    pub fn job(self) -> Job {
        Job {
            setup: self.model.setup,
            plan: self.model.plan,
            checks: self.model.checks,
            resolved: self.resolved,
            manifest: self.manifest,
            folder: self.parsed.folder,
        }
    }
}

impl RefusedStep {
    /// The same at its place in the scene.
    #[must_use]
    pub fn at(&self, scene: &Parsed) -> Diagnostics {
        let (code, phase) = match self {
            Self::TooLong { phase, .. } => ("phase.time_step", *phase),
            Self::Implicit { phase, .. } => ("phase.integration", *phase),
        };
        let mut found = Diagnostic::error(code, self.to_string());
        if let Some(phase) = scene.scenario.phases.get(phase) {
            let given = match self {
                Self::TooLong { .. } => phase.time_step.as_ref().map(|given| &given.span),
                Self::Implicit { .. } => Some(&phase.name.span),
            };
            found = given.map_or(found.clone(), |span| found.at(span.clone()));
        }
        Diagnostics::new(scene.source.clone(), vec![found])
    }
}

/// Why a scene cannot be begun.
#[derive(Debug, thiserror::Error)]
pub enum SceneError {
    /// The text is wrong, or the model it describes.
    #[error(transparent)]
    Scene(#[from] Diagnostics),
    /// The engine cannot build the model.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// A step that the scene asks for cannot be made.
    #[error(transparent)]
    Step(#[from] RefusedStep),
    /// The physics stops it at once.
    #[error(transparent)]
    Physics(#[from] RunError),
}

impl Simulation {
    /// A scene given as text, as it stands (no variant, nothing swept), on one thread, with its forces found: fields can be
    /// read at once. Nothing is written. Relative paths in the text are seen from the present folder.
    ///
    /// # Errors
    /// A wrong text, a model that cannot be built, a time step that is too long, physics that stops it at once.
    ///
    /// # Examples
    ///
    /// ```
    /// use riprap::run::simulation::Simulation;
    ///
    /// let mut simulation = Simulation::from_toml(
    ///     r#"
    ///     riprap = 1
    ///     title = "a stone falls"
    ///     [space.planar]
    ///     gravity = ["0 m/s2", "-10 m/s2"]
    ///     [materials.rock]
    ///     density = "2500 kg/m3"
    ///     [interfaces.default]
    ///     normal_stiffness = "1 GPa/m"
    ///     friction_angle = "30 deg"
    ///     [[blocks]]
    ///     name = "stone"
    ///     material = "rock"
    ///     rectangle = { size = ["1 m", "1 m"], corner = ["0 m", "5 m"] }
    ///     [[phases]]
    ///     name = "fall"
    ///     until = { time = "1 s" }
    ///     time_step = "1 ms"
    ///     "#,
    /// )?;
    /// simulation.run_for(0.5)?;
    /// let speed = simulation.field("block.speed", &["stone"])?;
    /// assert!((speed - 5.0).abs() < 0.01, "{speed}");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_toml(text: &str) -> Result<Self, SceneError> {
        let scene = Scene::parse(Source::new("scene", text), PathBuf::from("."), &[])?;
        scene.prepare(&scene.plain())?.simulation(Exec::serial())
    }
}

/// The model of a scene without variants.
pub(super) fn build(parsed: &Parsed, variant: &str) -> Result<Model, Diagnostics> {
    model::build(parsed, variant, fields(parsed))
}

/// Field table of the engine that the scene needs.
fn fields(parsed: &Parsed) -> &'static [FieldInfo] {
    match parsed.scenario.space {
        Space::Planar(ref plane) if plane.thickness.is_some() => Kind::Slice.fields(),
        Space::Planar(_) => Kind::Planar.fields(),
        Space::Spatial(_) => Kind::Spatial.fields(),
    }
}

/// blake3 of the scene's text and of every file it names, hexadecimal.
#[must_use]
pub fn input_hash(text: &str, folder: &Path) -> String {
    let mut hasher = blake3::Hasher::new();
    let mut add = |bytes: &[u8]| {
        hasher.update(&(bytes.len() as u64).to_le_bytes());
        hasher.update(bytes);
    };
    add(text.as_bytes());
    for name in &named_files(text, folder) {
        add(name.as_bytes());
        // A file that cannot be read stops the model before this.
        add(&crate::record::read_plain(&folder.join(name)).unwrap_or_default());
    }
    hasher.finalize().to_hex().to_string()
}

/// How the names of the files end that scenes read.
const ENDS: [&str; 14] = [
    ".csv", ".txt", ".dat", ".obj", ".msh", ".tess", ".stl", ".dxf", ".asc", ".at2", ".vt2",
    ".dt2", ".fab", ".dfn",
];

/// Texts of a scene that end as the files do which scenes read, and files that are read with those.
fn named_files(text: &str, folder: &Path) -> Vec<String> {
    let root: toml::Value = toml::from_str(text).unwrap_or(toml::Value::Boolean(false));
    let mut texts = Vec::new();
    strings(&root, &mut texts);
    let mut names: Vec<String> = Vec::new();
    for name in texts.into_iter().filter(|name| !name.is_empty()) {
        let beside = companions(&folder.join(&name));
        let beside: Vec<String> = beside
            .iter()
            .map(|file| file.strip_prefix(folder).unwrap_or(file))
            .map(|file| file.to_string_lossy().into_owned())
            .collect();
        let lower = name.to_lowercase();
        if ENDS.iter().any(|end| lower.ends_with(end)) {
            names.push(name);
        }
        for file in beside {
            if !names.contains(&file) {
                names.push(file);
            }
        }
    }
    names
}

/// All texts of a document, tables in the order of their keys.
fn strings(value: &toml::Value, found: &mut Vec<String>) {
    match value {
        toml::Value::String(text) => found.push(text.clone()),
        toml::Value::Array(items) => items.iter().for_each(|item| strings(item, found)),
        toml::Value::Table(table) => table.iter().for_each(|(_, item)| strings(item, found)),
        toml::Value::Integer(_)
        | toml::Value::Float(_)
        | toml::Value::Boolean(_)
        | toml::Value::Datetime(_) => {}
    }
}
