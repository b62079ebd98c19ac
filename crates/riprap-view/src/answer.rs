//! The questions a page asks of a run, by their paths. The server and the report give the same answers.
//!
//! | path | answer |
//! |---|---|
//! | `summary` | JSON: manifest, times of the frames, fields; or the problem with the folder |
//! | `frame/K` | motion of the blocks of frame K ([`crate::motion`]); names the key of its shape |
//! | `shape/K` | the blocks of frame K at rest ([`crate::shape`]) |
//! | `field/K?name=` | one number per block |
//! | `vectors/K?name=` | one vector per block |
//! | `contacts/K` | places, states, areas and forces of contacts ([`crate::contacts`]) |
//! | `cracks/K` | outlines of the broken parts of deformable blocks |
//! | `bolts/K` | bars of bolts with their axial forces |
//! | `stress/K` | principal stresses of the blocks ([`crate::crosses`]) |
//! | `conditions` | JSON: boundaries, loads, supports, water tables, laws of interfaces ([`riprap_record::conditions`]); null in runs of earlier versions |
//! | `names` | JSON: names of blocks and groups ([`riprap_record::names`]) |
//! | `block/K/ID` | JSON: all numbers of one block |
//! | `history/ID?name=&from=&count=` | JSON: a field of one block over frames |
//! | `range?name=&from=&count=` | JSON: smallest and largest value over frames, and those of most blocks |
//! | `table/histories`, `table/energy` | columns of the CSV files |
//! | `events`, `checks` | JSON: lines of those files |
//! | `file/NAME` | a file of the run folder as it is |

use riprap_record::Column;
use riprap_record::table::Table;
use serde_json::{Value, json};

use crate::run::{Problem, Run};
use crate::wire::Wire;
use crate::{contacts, crosses, motion};

/// Frames read for one question at most; a page asks again for more.
pub(crate) const FRAMES_AT_ONCE: usize = 64;

/// Kind and bytes of an answer.
#[derive(Debug)]
pub struct Answer {
    /// Media type.
    pub kind: &'static str,
    /// The bytes.
    pub bytes: Vec<u8>,
}

/// What stands behind the question mark.
pub struct Query<'a>(pub &'a dyn Fn(&str) -> Option<String>);

impl Query<'_> {
    fn text(&self, key: &str) -> Result<String, Problem> {
        (self.0)(key).ok_or_else(|| unknown(&format!("?{key}= is missing")))
    }

    fn number(&self, key: &str, default: usize) -> usize {
        (self.0)(key).and_then(|v| v.parse().ok()).unwrap_or(default)
    }
}

/// Answers a question about a run.
///
/// # Errors
/// Questions that are not in the table, and whatever is wrong with the run.
pub fn answer(run: &Run, path: &str, query: &Query<'_>) -> Result<Answer, Problem> {
    let words: Vec<&str> = path.split('/').collect();
    let count = |word: &str| {
        word.parse::<usize>()
            .map_err(|_| unknown(&format!("{word:?} is not a number of a frame or block")))
    };
    match words[..] {
        ["summary"] => Ok(json_answer(&summary(run))),
        ["frame", k] => {
            let (shape, frame) = run.placed(count(k)?)?;
            Ok(binary(motion::wire(&shape, &frame)))
        }
        ["shape", k] => Ok(binary(run.placed(count(k)?)?.0.wire())),
        ["field", k] => field(run, count(k)?, &query.text("name")?),
        ["vectors", k] => vectors(run, count(k)?, &query.text("name")?),
        ["contacts", k] => Ok(binary(contacts::wire(&run.contacts(count(k)?)?))),
        ["cracks", k] => Ok(binary(contacts::cracks(run, count(k)?)?)),
        ["bolts", k] => Ok(binary(contacts::bolts(run, count(k)?)?)),
        ["stress", k] => Ok(binary(crosses::wire(run, count(k)?)?)),
        ["conditions"] => Ok(json_answer(&json!(run.conditions()?))),
        ["names"] => Ok(json_answer(&json!(run.names()))),
        ["block", k, id] => block(run, count(k)?, count(id)?),
        ["history", id] => history(run, count(id)?, query),
        ["range"] => range(run, query),
        ["table", name @ ("histories" | "energy")] => table(run, name),
        ["events"] => Ok(json_answer(&run.lines("events.jsonl").into())),
        ["checks"] => Ok(json_answer(&run.lines("checks.jsonl").into())),
        ["file", ref name @ ..] => file(run, &name.join("/")),
        _ => Err(unknown(&format!("unknown request {path:?}"))),
    }
}

fn unknown(what: &str) -> Problem {
    Problem::missing(what, "Reload the page.")
}

fn json_answer(value: &Value) -> Answer {
    Answer { kind: "application/json", bytes: value.to_string().into_bytes() }
}

fn binary(bytes: Vec<u8>) -> Answer {
    Answer { kind: "application/octet-stream", bytes }
}

/// What there is to see, or why there is nothing.
pub fn summary(run: &Run) -> Value {
    let name = run
        .path()
        .canonicalize()
        .ok()
        .and_then(|p| Some(p.file_name()?.to_string_lossy().into_owned()))
        .unwrap_or_else(|| run.path().display().to_string());
    let told = |problem: &Problem| json!({ "name": name, "problem": problem });
    let manifest = match run.manifest() {
        Ok(manifest) => manifest,
        Err(problem) => return told(&problem),
    };
    let frames = match run.moments() {
        Ok(frames) => frames,
        Err(problem) => return told(&problem),
    };
    let (mut fields, mut note) = (Value::Array(Vec::new()), None);
    // The newest frame that can be read tells the fields; damaged ones tell what is wrong when they are looked at.
    for k in (0..frames.len().min(3)).chain(frames.len().checked_sub(1)) {
        match run.columns(k, &|_| true) {
            Ok(columns) => {
                fields = columns.iter().map(described).collect();
                note = None;
                break;
            }
            Err(problem) => note = Some(problem),
        }
    }
    let live = run.live(&manifest);
    let tables = ["histories", "energy"].map(|t| run.inside(&format!("{t}.csv")).is_ok());
    json!({
        "name": name,
        "manifest": manifest,
        "live": live,
        "died": manifest.ended == riprap_record::Ended::Running && !live,
        "times": frames.iter().map(|f| f.time).collect::<Vec<_>>(),
        "steps": frames.iter().map(|f| f.step).collect::<Vec<_>>(),
        "phases": frames.iter().map(|f| f.phase.as_str()).collect::<Vec<_>>(),
        "fields": fields,
        "note": note,
        "tables": tables,
        "cracks": run.inside("cracks.pvd").is_ok(),
        "bolts": run.inside("bolts.pvd").is_ok(),
        "views": run.inside("views.json").is_ok(),
    })
}

pub(crate) fn described(column: &Column) -> Value {
    json!({ "name": column.name, "unit": column.unit, "components": column.components })
}

/// Smallest and largest finite value.
pub(crate) fn extremes(values: &[f64]) -> Option<[f64; 2]> {
    let finite = values.iter().copied().filter(|v| v.is_finite());
    finite.fold(None, |range, v| match range {
        None => Some([v, v]),
        Some([low, high]) => Some([low.min(v), high.max(v)]),
    })
}

/// Share of the blocks at either end whose values the colours of most leave out.
const STRAY: f64 = 0.01;

/// The values between which all but the share [`STRAY`] at either end lie; those of few blocks are all of them.
pub(crate) fn most(values: &[f64]) -> Option<[f64; 2]> {
    let mut finite: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    finite.sort_by(f64::total_cmp);
    let left_out = (STRAY * finite.len() as f64).floor() as usize;
    Some([*finite.get(left_out)?, *finite.get(finite.len().checked_sub(1 + left_out)?)?])
}

fn field(run: &Run, k: usize, name: &str) -> Result<Answer, Problem> {
    let numbers = run.field(k, name)?;
    let values: Vec<f32> = numbers.values.iter().map(|v| *v as f32).collect();
    let info = json!({
        "unit": numbers.unit, "range": extremes(&numbers.values), "most": most(&numbers.values),
    });
    Ok(binary(Wire::default().f32("values", &values).finish(&info)))
}

pub(crate) fn flat3(column: &Column) -> Vec<f32> {
    column
        .data
        .chunks(column.components.max(1))
        .flat_map(|v| [0, 1, 2].map(|i| v.get(i).map_or(0.0, |x| *x as f32)))
        .collect()
}

fn vectors(run: &Run, k: usize, name: &str) -> Result<Answer, Problem> {
    let column = run.vectors(k, name)?;
    let longest = extremes(&column.numbers(riprap_record::Part::Magnitude));
    let info = json!({ "unit": column.unit, "longest": longest.map(|r| r[1]) });
    Ok(binary(Wire::default().f32("values", &flat3(&column)).finish(&info)))
}

fn block(run: &Run, k: usize, id: usize) -> Result<Answer, Problem> {
    let columns = run.columns(k, &|_| true)?;
    let ids = columns.iter().find(|c| c.name == "block");
    let at = match ids {
        Some(column) => column.data.iter().position(|v| *v == id as f64),
        None => Some(id).filter(|i| columns.first().is_some_and(|c| *i < c.len())),
    };
    let at = at.ok_or_else(|| {
        Problem::missing(
            format!("there is no block {id} in frame {k}"),
            "It was split, cut or removed.",
        )
    })?;
    let rows: Vec<Value> = columns
        .iter()
        .map(|c| {
            let n = c.components.max(1);
            let values: Vec<Value> =
                c.data[at * n..(at + 1) * n].iter().map(|v| number(*v)).collect();
            json!({ "name": c.name, "unit": c.unit, "values": values })
        })
        .collect();
    let names = run.names();
    let number = u32::try_from(id).unwrap_or(u32::MAX);
    Ok(json_answer(&json!({
        "block": id, "name": names.block(number).unwrap_or_default(), "groups": names.groups_of(number),
        "frame": k, "columns": rows,
    })))
}

/// A number as JSON; what is not finite as text.
fn number(v: f64) -> Value {
    serde_json::Number::from_f64(v).map_or_else(|| Value::String(v.to_string()), Value::Number)
}

/// The frames that a question is about.
fn span(run: &Run, query: &Query<'_>) -> Result<(std::ops::Range<usize>, Vec<f64>), Problem> {
    let times: Vec<f64> = run.frames()?.iter().map(|f| f.time).collect();
    let from = query.number("from", 0).min(times.len());
    let count = query.number("count", FRAMES_AT_ONCE).min(FRAMES_AT_ONCE);
    Ok((from..(from + count).min(times.len()), times))
}

fn history(run: &Run, id: usize, query: &Query<'_>) -> Result<Answer, Problem> {
    let name = query.text("name")?;
    let (frames, times) = span(run, query)?;
    let (mut at, mut values, mut unit) = (Vec::new(), Vec::new(), String::new());
    for k in frames {
        // A damaged frame, or one without the block, is a gap.
        let numbers = run.field(k, &name).ok();
        let value = numbers.as_ref().and_then(|n| {
            unit.clone_from(&n.unit);
            let i = n.ids.iter().position(|b| *b as usize == id)?;
            n.values.get(i).copied()
        });
        at.push(times[k]);
        values.push(value.map_or(Value::Null, number));
    }
    Ok(json_answer(&json!({ "unit": unit, "times": at, "values": values })))
}

fn range(run: &Run, query: &Query<'_>) -> Result<Answer, Problem> {
    let name = query.text("name")?;
    let (frames, _) = span(run, query)?;
    let (mut all, mut some) = (Vec::new(), Vec::new());
    for k in frames {
        if let Ok(numbers) = run.field(k, &name) {
            all.extend(extremes(&numbers.values).into_iter().flatten());
            some.extend(most(&numbers.values).into_iter().flatten());
        }
    }
    Ok(json_answer(&json!({ "range": extremes(&all), "most": extremes(&some) })))
}

fn table(run: &Run, name: &str) -> Result<Answer, Problem> {
    let table = run.table(&format!("{name}.csv"))?.unwrap_or(Table {
        path: run.path().to_owned(),
        columns: Vec::new(),
        cut: false,
    });
    // A row that is being written can leave columns of unequal length.
    let rows = table.columns.iter().map(|c| c.values.len()).min().unwrap_or(0);
    let mut out = Wire::default();
    for (i, column) in table.columns.iter().enumerate() {
        out = out.f64(&i.to_string(), &column.values[..rows]);
    }
    let heads: Vec<Value> =
        table.columns.iter().map(|c| json!({ "name": c.name, "unit": c.unit })).collect();
    Ok(binary(out.finish(&json!({ "columns": heads, "cut": table.cut }))))
}

fn file(run: &Run, name: &str) -> Result<Answer, Problem> {
    let bytes = run.file(name)?;
    // Nothing of a run folder is ever shown as a page.
    let kind = match name.rsplit('.').next() {
        Some("png") => "image/png",
        Some("json" | "jsonl" | "csv" | "toml" | "txt") => "text/plain; charset=utf-8",
        Some(_) | None => "application/octet-stream",
    };
    Ok(Answer { kind, bytes })
}
