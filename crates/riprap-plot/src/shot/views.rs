//! Views that were saved in the viewer, by name: `views.json`.

use std::path::Path;

use serde_json::Value;

use super::super::PlotError;
use super::super::frames::unit_of;
use super::super::load::Which;
use super::kinds::Kinds;
use super::wanted::{CHANGED, Cut, Eye, Note, Shot, Trails};

/// What somebody asks for of a picture; the rest is that of a saved view or of a new shot.
#[derive(Clone, Copy, Debug, Default)]
pub struct Asked<'a> {
    /// Name of a saved view.
    pub saved: Option<&'a str>,
    /// File of saved views, by default `views.json` of the run folder.
    pub views: Option<&'a Path>,
    /// Field that colours the blocks.
    pub field: Option<&'a str>,
    /// Where the eye stands, without a saved view: clockwise from north (y), and above the horizon, deg.
    pub view: Option<[f64; 2]>,
    /// Angle of view, without a saved view, deg.
    pub perspective: Option<f64>,
}

/// Field of a picture for which nobody chose one.
const MATERIAL: &str = "material";
/// Field of a picture of removable blocks, which is looked at for them.
const REMOVABLE: &str = "removable_type";

impl Shot {
    /// The shot that is asked for of a run whose first frame to be drawn is `first`. A saved range of colours goes with its field.
    ///
    /// # Errors
    /// As [`Shot::saved`].
    pub fn asked(folder: &Path, first: Which, asked: &Asked<'_>) -> Result<Self, PlotError> {
        let mut shot = match asked.saved {
            Some(name) => Self::saved(folder, asked.views, name)?,
            None => Self::default(),
        };
        if let Eye::From { direction, angle } = &mut shot.eye {
            *direction = asked.view.unwrap_or(*direction);
            *angle = asked.perspective;
        }
        match asked.field {
            Some(field) if field != shot.field => {
                field.clone_into(&mut shot.field);
                shot.options.range = None;
            }
            None if asked.saved.is_none() && unit_of(folder, first, REMOVABLE).is_ok() => {
                REMOVABLE.clone_into(&mut shot.field);
            }
            // What the model is made of is seen first; a run of earlier versions does not tell.
            None if asked.saved.is_none() && unit_of(folder, first, MATERIAL).is_ok() => {
                MATERIAL.clone_into(&mut shot.field);
            }
            Some(_) | None => {}
        }
        Ok(shot)
    }

    /// A view as the viewer saved it, from `views`, by default `views.json` of the run folder: eye, field, range of the colours, cut,
    /// exaggeration and bolts. Size and percentiles are those of a new shot.
    ///
    /// # Errors
    /// No such file, one of another form, no view of that name, one of a model in the plane.
    pub fn saved(folder: &Path, views: Option<&Path>, name: &str) -> Result<Self, PlotError> {
        let path = views.map_or_else(|| folder.join("views.json"), Path::to_path_buf);
        let wrong = |reason: String| PlotError::View { path: path.clone(), reason };
        let text = std::fs::read_to_string(&path).map_err(|error| {
            let how = "save views in `riprap view` and write views.json into the run folder";
            wrong(format!("{error}; {how}, or name another file"))
        })?;
        let file: Value = serde_json::from_str(&text).map_err(|error| wrong(error.to_string()))?;
        let all = file["views"].as_array().ok_or_else(|| wrong("it has no list `views`".into()))?;
        let Some(view) = all.iter().find(|view| view["name"] == name) else {
            let known: Vec<&str> = all.iter().filter_map(|view| view["name"].as_str()).collect();
            let known = known.join(", ");
            return Err(wrong(format!("no view is named `{name}`; valid names: {known}")));
        };
        let mut shot = shot(view).map_err(|reason| wrong(format!("view `{name}`: {reason}")))?;
        shot.notes = notes(&file["notes"]).map_err(wrong)?;
        Ok(shot)
    }
}

/// The texts at places of the model that a file of views has.
fn notes(list: &Value) -> Result<Vec<Note>, String> {
    let one = |(i, note): (usize, &Value)| {
        let wrong =
            || format!("note {}: it needs a `text` and a place `at` of three numbers", i + 1);
        let at = triple(&note["at"]).ok_or_else(wrong)?;
        let text = note["text"].as_str().ok_or_else(wrong)?.to_owned();
        let block = note["block"].as_u64().and_then(|block| u32::try_from(block).ok());
        Ok(Note { text, at, block })
    };
    list.as_array().into_iter().flatten().enumerate().map(one).collect()
}

fn triple(of: &Value) -> Option<[f64; 3]> {
    let parts: Vec<f64> = of.as_array()?.iter().filter_map(Value::as_f64).collect();
    parts.try_into().ok()
}

fn shot(view: &Value) -> Result<Shot, String> {
    let needed = |key: &str| triple(&view[key]).ok_or(format!("`{key}` must be three numbers"));
    let angle = match &view["angle"] {
        Value::Null if view.get("angle").is_some() => {
            return Err("it is of a model in the plane; use `riprap plot RUN blocks`".to_owned());
        }
        given => given.as_f64().unwrap_or(32.0),
    };
    let new = Shot::default();
    let mut options = new.options;
    let field = view["field"].as_str().filter(|field| !field.is_empty());
    let field = field.map_or(new.field, str::to_owned);
    options.log = view["log"].as_bool().unwrap_or(false);
    let ends = view["range"].as_array().map(|ends| ends.iter().filter_map(Value::as_f64));
    options.range = match ends.map(Iterator::collect::<Vec<_>>).as_deref() {
        Some([low, high]) if Kinds::of(&field, &[]).is_none() => Some([*low, *high]),
        Some(_) | None => None,
    };
    options.exaggeration = view["exaggeration"].as_f64().filter(|factor| *factor != 1.0);
    let cut = match &view["cut"] {
        Value::Null => None,
        cut => Some(Cut {
            normal: triple(&cut["normal"]).ok_or("`cut.normal` must be three numbers")?,
            at: cut["at"].as_f64().ok_or("`cut.at` must be a number")?,
        }),
    };
    let up = triple(&view["up"]).unwrap_or([0.0, 0.0, 1.0]);
    let eye = Eye::At { place: needed("eye")?, target: needed("target")?, up, angle };
    let bolts = view["bolts"].as_bool().unwrap_or(true);
    let chosen = &view["settings"];
    let shadows = chosen["shadows"].as_bool().unwrap_or(true);
    let chains = chosen["chains"].as_bool().unwrap_or(false);
    let contacts = chosen["contacts"].as_bool().unwrap_or(false).then(|| states(&chosen["states"]));
    let by_block = chosen["trailColour"] == "block";
    let picked = view["picked"].as_u64().and_then(|block| u32::try_from(block).ok());
    let trails = match chosen["trails"].as_str() {
        Some("moving") => Some(Trails { by_block, only: None }),
        Some("picked") => picked.map(|block| Trails { by_block, only: Some(block) }),
        Some(_) | None => None,
    };
    let vectors = ["displacement", "velocity", "force"];
    let vectors = chosen["vectors"].as_str().filter(|name| vectors.contains(name));
    let vectors = vectors.map(str::to_owned);
    Ok(Shot { field, eye, cut, bolts, options, shadows, chains, contacts, trails, vectors, ..new })
}

/// The states of contacts that a view shows.
fn states(list: &Value) -> [bool; CHANGED.len()] {
    let one = |(k, usual): (usize, bool)| list[k].as_bool().unwrap_or(usual);
    let mut all = CHANGED.into_iter().enumerate().map(one);
    std::array::from_fn(|_| all.next().unwrap_or(false))
}
