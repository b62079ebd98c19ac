//! Scenes of the library that `riprap new` writes, embedded in the binary by `build.rs`.

/// A scene to start from.
pub struct Template {
    /// What the user calls it.
    pub name: &'static str,
    /// `plane` or `space`.
    pub space: &'static str,
    /// Number of its blocks.
    pub blocks: &'static str,
    /// Processor time of a run, with its unit.
    pub time: &'static str,
    /// What happens in it, in one line.
    pub about: &'static str,
    /// The scene.
    pub text: &'static str,
    /// Files the scene reads: name and contents.
    pub files: &'static [(&'static str, &'static str)],
}

include!(concat!(env!("OUT_DIR"), "/templates.rs"));

// Every file under `scenes/`, by its path from there: `SHIPPED`.
include!(concat!(env!("OUT_DIR"), "/shipped.rs"));

/// The template called `name`.
pub fn find(name: &str) -> Option<&'static Template> {
    TEMPLATES.iter().find(|t| t.name == name)
}
