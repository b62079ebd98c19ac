//! What either engine is built from.

use serde::{Deserialize, Serialize};

use crate::planar::setup as planar;
use crate::spatial::setup as spatial;

/// What an engine is built from. The example program `wall_by_hand` fills one in without a scene file.
///
/// # Examples
///
/// ```
/// use std::path::Path;
///
/// use riprap::run::scene::Scene;
///
/// let path = Path::new("scenes/verify/planar/rest.toml");
/// # let path = &Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
/// let scene = Scene::load(path, &[])?;
/// let setup = scene.prepare(&scene.plain())?.job().setup;
/// let names = setup.planar().map(|setup| setup.blocks.iter().map(|block| block.name.as_str()));
/// assert!(names.is_some_and(|mut names| names.any(|name| name == "block")));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Setup {
    /// Polygons in the plane.
    Planar(Box<planar::Setup>),
    /// Blocks in space.
    Spatial(Box<spatial::Setup>),
}

impl From<planar::Setup> for Setup {
    fn from(setup: planar::Setup) -> Self {
        Self::Planar(Box::new(setup))
    }
}

impl From<spatial::Setup> for Setup {
    fn from(setup: spatial::Setup) -> Self {
        Self::Spatial(Box::new(setup))
    }
}

impl Setup {
    /// The planar setup, for what only that engine has.
    #[must_use]
    pub fn planar(&self) -> Option<&planar::Setup> {
        match self {
            Self::Planar(setup) => Some(setup),
            Self::Spatial(_) => None,
        }
    }
}
