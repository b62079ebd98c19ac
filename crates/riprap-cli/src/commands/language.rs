//! `riprap explain`, `riprap schema`, `riprap fields` and `riprap hash`.

use std::path::Path;

use riprap::model::Provenance;
use riprap::record::Manifest;
use riprap::record::Shape;
use riprap::run::engine::Kind;
use riprap::scenario;

use crate::args::{Explain, Fields, Hash, Schema};
use crate::diagnostics::Style;
use crate::failure::Failure;
use crate::{concepts, scenes, screen};

/// `riprap schema`.
pub fn schema(args: &Schema) -> Result<(), Failure> {
    let text = if args.markdown { scenario::markdown() } else { scenario::schema_text() };
    screen::line(text.trim_end());
    Ok(())
}

/// `riprap explain`.
pub fn explain(args: &Explain, style: Style) -> Result<(), Failure> {
    let what = args.what.join(" ");
    let path = Path::new(&what);
    // A key never looks like this; a file that does not exist deserves a message about files.
    let names_a_file = path.exists() || what.contains('/') || what.ends_with(".toml");
    if !names_a_file {
        let text = match scenario::explain_key(&what) {
            // A word that is a key too is looked up everywhere.
            Ok(text) if !what.contains('.') => match concepts::find(&what) {
                Some(found) => format!("{}\n\n{found}", text.trim_end()),
                None => text,
            },
            Ok(text) => text,
            // A path with dots was meant as a field or a key, and its slip is reported.
            Err(why) if what.contains('.') => {
                concepts::field(what.trim()).ok_or(Failure::Input(why))?
            }
            Err(why) => concepts::find(&what).ok_or_else(|| {
                Failure::Input(format!(
                    "{why}; no command, key, field, page or scene contains this word"
                ))
            })?,
        };
        screen::line(text.trim_end());
        return Ok(());
    }
    let prepared = scenes::prepare_file(path, &args.change, style, false)?;
    let explained = &prepared.model.explained;
    let rows = explained.iter().map(|one| {
        let from = match one.from {
            Provenance::Given => "given",
            Provenance::Default => "default",
            Provenance::Derived => "derived",
        };
        [one.key.clone(), one.value.clone(), from.to_owned(), one.why.clone()]
    });
    let rows: Vec<[String; 4]> = rows.collect();
    let width = |i: usize| rows.iter().map(|row| row[i].chars().count()).max().unwrap_or(0).min(60);
    let (keys, values) = (width(0), width(1));
    for [key, value, from, why] in &rows {
        let line = format!("{key:<keys$}  {value:<values$}  {from:<8} {why}");
        screen::line(line.trim_end());
    }
    Ok(())
}

/// `riprap fields`: those of both engines.
pub fn fields(args: &Fields) -> Result<(), Failure> {
    let tables = [("planar", Kind::Planar), ("spatial", Kind::Spatial)];
    if args.json {
        let all: serde_json::Map<String, serde_json::Value> = tables
            .iter()
            .map(|(word, kind)| ((*word).to_owned(), serde_json::json!(kind.fields())))
            .collect();
        screen::line(&serde_json::to_string_pretty(&all).unwrap_or_default());
        return Ok(());
    }
    for (word, kind) in tables {
        let fields = kind.fields();
        let width = fields.iter().map(|f| f.name.len()).max().unwrap_or(0);
        screen::line(&format!("[space.{word}]"));
        for field in fields {
            let shape = match field.shape {
                Shape::Scalar => "",
                Shape::Vector => " (vector: .x, .y, .magnitude)",
                Shape::Vector3 => " (vector: .x, .y, .z, .magnitude)",
            };
            screen::line(&format!(
                "{:<width$}  {:<6} {}{shape}",
                field.name, field.unit, field.meaning
            ));
        }
    }
    Ok(())
}

/// `riprap hash`.
pub fn hash(args: &Hash, style: Style) -> Result<(), Failure> {
    if !args.what.is_dir() {
        let prepared = scenes::prepare_file(&args.what, &args.change, style, true)?;
        screen::line(&prepared.manifest.input_hash);
        return Ok(());
    }
    let manifest = Manifest::read(&args.what).map_err(|e| Failure::Input(e.to_string()))?;
    if manifest.state_hash.is_empty() {
        let shown = args.what.display();
        return Err(Failure::Input(format!(
            "{shown} has no final state yet; continue with: riprap resume {shown}"
        )));
    }
    screen::line(&manifest.state_hash);
    Ok(())
}
