//! Fields asked for by the names of blocks.

use thiserror::Error;

use super::engine::View;
use crate::plan::Gauge;
use crate::record::field::{self, FieldError, FieldInfo, Site};

/// Why a field cannot be read.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum AskError {
    /// No such field.
    #[error(transparent)]
    Field(#[from] FieldError),
    /// Of every contact.
    #[error("{field} has one value per contact; read it from the contacts of a frame")]
    Contact {
        /// The field.
        field: &'static str,
    },
    /// Too many or too few names.
    #[error("{field} applies to {of_what}, but `of` has {given} names")]
    Count {
        /// The field.
        field: &'static str,
        /// What it is of.
        of_what: &'static str,
        /// Number of names.
        given: usize,
    },
    /// Nothing has that name.
    #[error(
        "there is no {name:?} in the model{}",
        near.as_ref().map_or(String::new(), |n| format!("; did you mean {n:?}?"))
    )]
    Unknown {
        /// The name.
        name: String,
        /// The nearest there is.
        near: Option<String>,
    },
}

/// What reads `field` (with its component, `block.velocity.x`) of the blocks, the groups or the source with the names `of`.
///
/// # Errors
/// Unknown fields and names, a wrong number of names, fields of single contacts.
pub fn gauge<S: AsRef<str>>(view: &View<'_>, field: &str, of: &[S]) -> Result<Gauge, AskError> {
    let (info, _) = field::find(view.kind().fields(), field)?;
    let (of, groups) = match info.site {
        Site::Group if !of.is_empty() => members(view, of)?,
        _ => (subjects(view, info, of)?, Vec::new()),
    };
    Ok(Gauge { field: field.to_owned(), of, groups, ..Gauge::default() })
}

/// Blocks of the blocks and groups of these names, ascending, and which of the names are groups.
fn members<S: AsRef<str>>(view: &View<'_>, of: &[S]) -> Result<(Vec<u32>, Vec<String>), AskError> {
    let (groups, mut blocks, mut found) = (view.groups(), Vec::new(), Vec::new());
    let names: Vec<String> = (0..view.all_blocks() as u32).map(|b| view.name(b)).collect();
    for name in of.iter().map(AsRef::as_ref) {
        if let Some(b) = names.iter().position(|known| known == name) {
            blocks.push(b as u32);
        } else if let Some((_, all)) = groups.iter().find(|(known, _)| *known == name) {
            blocks.extend_from_slice(all);
            found.push(name.to_owned());
        } else {
            let known = names.iter().map(String::as_str).chain(groups.iter().map(|g| g.0));
            let near = field::nearest(name, known).map(str::to_owned);
            return Err(AskError::Unknown { name: name.to_owned(), near });
        }
    }
    blocks.sort_unstable();
    blocks.dedup();
    Ok((blocks, found))
}

/// Numbers of the blocks or of the source that a field is read of.
fn subjects<S: AsRef<str>>(
    view: &View<'_>,
    info: &FieldInfo,
    of: &[S],
) -> Result<Vec<u32>, AskError> {
    let (field, given) = (info.name, of.len());
    let (count, of_what) = match info.site {
        Site::Block => (Some(1), "one block"),
        Site::Pair => (Some(2), "two blocks"),
        Site::Group => (None, "blocks"),
        Site::Cavity => (Some(1), "one source"),
        Site::Model | Site::Energy => (Some(0), "the whole model"),
        Site::Bolt => (None, "bolts"),
        Site::Boundary => (Some(1), "one boundary"),
        Site::Support => (Some(1), "one support"),
        Site::Load => (Some(1), "one load"),
        Site::Contact => return Err(AskError::Contact { field }),
    };
    if count.is_some_and(|n| n != given) || (count.is_none() && given == 0) {
        return Err(AskError::Count { field, of_what, given });
    }
    let known: Vec<(u32, String)> = match info.site {
        Site::Cavity => (0..).zip(view.sources().into_iter().map(|s| s.name)).collect(),
        Site::Bolt => (0..).zip(view.bolts()).collect(),
        Site::Block | Site::Pair | Site::Group => {
            (0..view.all_blocks() as u32).map(|b| (b, view.name(b))).collect()
        }
        Site::Boundary | Site::Support | Site::Load => (0..)
            .zip(view.accounts())
            .filter(|(_, c)| c.holder.word() == info.site.word())
            .map(|(account, c)| (c.holder.number(account), c.name.clone()))
            .collect(),
        Site::Model | Site::Energy | Site::Contact => Vec::new(),
    };
    of.iter()
        .map(|name| {
            let name = name.as_ref();
            let place = known.iter().find(|(_, k)| k == name);
            place.map(|(k, _)| *k).ok_or_else(|| AskError::Unknown {
                name: name.to_owned(),
                near: field::nearest(name, known.iter().map(|(_, k)| k.as_str()))
                    .map(str::to_owned),
            })
        })
        .collect()
}
