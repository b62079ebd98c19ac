//! Answers as a run folder of one picture, to be looked at.

use std::collections::BTreeMap;
use std::path::Path;

use super::{Answer, Block, Kind, RemovableError, as_begins};
use crate::record::folder::Existing;
use crate::record::frame::Column;
use crate::run::engine::View;
use crate::run::job::{Job, picture};
use crate::setup::Setup;

impl Kind {
    /// The type of Goodman & Shi as it stands in a picture; 0 of blocks that are not listed.
    fn in_picture(self) -> f64 {
        match self {
            Self::Key => 1.0,
            Self::Potential => 2.0,
            Self::Safe => 3.0,
            Self::Tapered => 4.0,
            Self::Inside | Self::Ground => 0.0,
        }
    }
}

impl Block {
    /// How it goes, as it stands in a picture.
    fn mode_in_picture(&self) -> f64 {
        match self.mode {
            _ if self.kind > Kind::Safe => 0.0,
            "held" => 1.0,
            "sliding" => 2.0,
            "wedge" => 3.0,
            _ => 4.0,
        }
    }
}

impl Answer {
    /// Writes the blocks as the phase of the answer begins into a run folder, coloured by what was found of them, for `riprap view`
    /// and ParaView. The job is the one that was asked about.
    ///
    /// # Errors
    /// A model in the plane, a job without that phase, a folder that `existing` does not allow, the disk.
    pub fn show(
        &self,
        mut job: Job,
        folder: &Path,
        existing: Existing,
    ) -> Result<(), RemovableError> {
        let Setup::Spatial(setup) = &mut job.setup else {
            return Err(RemovableError::Planar);
        };
        (job.plan, _) = as_begins(job.plan, Some(&self.phase), &mut setup.interfaces)?;
        Ok(picture(job, folder, existing, &|view| self.columns(view))?)
    }

    /// What is told of each living block, with its meaning.
    fn columns(&self, view: &View<'_>) -> Vec<(Column, &'static str)> {
        let View::Spatial(view) = view else { return Vec::new() };
        let by_name: BTreeMap<&str, &Block> =
            self.blocks.iter().map(|block| (block.name.as_str(), block)).collect();
        let blocks: Vec<Option<&Block>> =
            view.living().map(|b| by_name.get(view.name(b).as_str()).copied()).collect();
        let column = |name: &str, unit: &str, of: &dyn Fn(&Block) -> f64, other: f64| {
            let values = blocks.iter().map(|block| block.map_or(other, of));
            Column::scalar(name, unit, values.collect())
        };
        let factor = |block: &Block| match block.kind {
            Kind::Key | Kind::Potential if block.factor_of_safety.is_finite() => {
                block.factor_of_safety
            }
            _ => f64::NAN,
        };
        vec![
            (
                column("removable_type", "-", &|block| block.kind.in_picture(), 0.0),
                "Type of block theory: key block, held by strength, held by weight, tapered.",
            ),
            (
                column("removable_mode", "-", &Block::mode_in_picture, 0.0),
                "How a removable block goes: falls, slides on one plane or on two, stays.",
            ),
            (
                column("removable_factor", "-", &factor, f64::NAN),
                "Factor of safety of a removable block that its weight and the water drive.",
            ),
            (
                column("removable_support", "N", &|block| block.support_force, f64::NAN),
                "Force against the motion of a block that gives the wanted factor of safety.",
            ),
            (
                column("removable_round", "-", &|block| f64::from(block.round), f64::NAN),
                "Round in which a block was looked at last.",
            ),
        ]
    }
}
