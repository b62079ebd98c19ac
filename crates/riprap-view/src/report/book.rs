//! Answers that the replay will ask for, as many as there is room for.

use base64::Engine as _;
use flate2::Compression;
use flate2::write::GzEncoder;
use riprap_record::frame::stress;
use serde_json::{Map, Value, json};
use std::io::Write as _;

use super::Limits;
use crate::answer::{FRAMES_AT_ONCE, Query, answer, summary};
use crate::run::{Problem, Run};

/// Fields of the replay, as far as the frames have them and there is room.
const FIELDS: [&str; 8] = [
    // What a page shows first.
    "material",
    "displacement",
    "velocity",
    "sigma1_compressive",
    "broken_share",
    "rotation",
    "peak_speed",
    "level",
];
/// Vectors of the replay, after the fields.
const ARROWS: [&str; 3] = ["displacement", "velocity", "force"];
/// Rows of histories kept for the replay.
const ROWS: usize = 2000;

/// What there may be of one run.
#[derive(Clone, Copy)]
struct Room<'a> {
    run: &'a Run,
    /// Numbers of the frames in the run.
    frames: &'a [usize],
    /// Of all answers together.
    bytes: usize,
}

/// Answers by their questions, packed.
#[derive(Default)]
pub(super) struct Book {
    /// gzip in base64, or `{"as": question}` where another answer is the same.
    pub(super) answers: Map<String, Value>,
    bytes: usize,
    /// What is missing.
    pub(super) notes: Vec<String>,
}

impl Book {
    fn put(&mut self, question: String, bytes: &[u8]) {
        let mut packer = GzEncoder::new(Vec::new(), Compression::default());
        // Writing into memory cannot fail.
        let _ = packer.write_all(bytes);
        let packed = packer.finish().unwrap_or_default();
        let text = base64::engine::general_purpose::STANDARD.encode(packed);
        self.bytes += text.len();
        self.answers.insert(question, Value::String(text));
    }

    /// Answers a question about frame `k` under the number that the frame has in the report.
    fn ask(
        &mut self,
        run: &Run,
        question: &str,
        name: Option<&str>,
        as_question: &str,
    ) -> Result<(), Problem> {
        let found = |key: &str| match (key, name) {
            ("name", Some(name)) => Some(name.to_owned()),
            (_, _) => None,
        };
        let answer = answer(run, question, &Query(&found))?;
        let question = match name {
            Some(name) => format!("{as_question}?name={name}"),
            None => as_question.to_owned(),
        };
        self.put(question, &answer.bytes);
        Ok(())
    }

    /// Fills it with as many frames as there is room for; how many.
    pub(super) fn fill(&mut self, run: &Run, limits: Limits) -> Result<usize, Problem> {
        let mut told = summary(run);
        let sound = self.motion(run, limits)?;
        self.same_shapes();
        let room = Room { run, frames: &sound, bytes: limits.bytes };
        let columns: Vec<(String, u64)> = told["fields"]
            .as_array()
            .into_iter()
            .flatten()
            .filter_map(|f| Some((f["name"].as_str()?.to_owned(), f["components"].as_u64()?)))
            .collect();
        let (main, rest): (Vec<_>, Vec<_>) =
            columns.iter().partition(|c| FIELDS.contains(&c.0.as_str()));
        let mut fields: Vec<&str> = Vec::new();
        for (name, _) in &main {
            // The first one is wanted whatever it takes.
            let room =
                Room { bytes: if fields.is_empty() { usize::MAX } else { room.bytes }, ..room };
            if self.field(&room, name)? {
                fields.push(name);
            }
        }
        let mut vectors: Vec<&str> = Vec::new();
        for (name, _) in columns.iter().filter(|c| ARROWS.contains(&c.0.as_str()) && c.1 > 1) {
            if self.add(&room, "vectors", Some(name)) {
                vectors.push(name);
            }
        }
        let contacts = self.add(&room, "contacts", None);
        // The page draws cracks by what contacts tell: without these it asks for none.
        let cracks = told["cracks"] == true && contacts && self.add(&room, "cracks", None);
        let bolts = told["bolts"] == true && self.add(&room, "bolts", None);
        let stress = self.add(&room, "stress", None);
        // What the crosses show says little component by component.
        let tensor = [stress::NORMAL, stress::SHEAR];
        for (name, _) in rest.iter().filter(|c| !tensor.contains(&c.0.as_str())) {
            if self.field(&room, name)? {
                fields.push(name);
            }
        }
        for name in ["histories", "energy"] {
            let bytes = thinned(run, name);
            self.put(format!("table/{name}"), &bytes);
        }
        // What a damaged file would have held is not drawn; the viewer tells of it.
        let conditions = run.conditions().ok().flatten();
        self.put("conditions".to_owned(), json!(conditions).to_string().as_bytes());
        let names = json!(run.names()).to_string();
        self.put("names".to_owned(), names.as_bytes());
        for key in ["times", "steps", "phases"] {
            told[key] = sound.iter().map(|k| told[key][*k].clone()).collect();
        }
        told["names"] = json!(fields);
        told["held"] = json!({ "vectors": vectors, "contacts": contacts, "stress": stress });
        told["cracks"] = json!(cracks);
        told["bolts"] = json!(bolts);
        told["live"] = json!(false);
        self.put("summary".to_owned(), told.to_string().as_bytes());
        Ok(sound.len())
    }

    /// Motion and shapes of as many frames as there is room for; their numbers in the run.
    fn motion(&mut self, run: &Run, limits: Limits) -> Result<Vec<usize>, Problem> {
        let count = run.frames()?.len();
        let mut chosen = spread(count, limits.frames);
        let mut sound;
        // Too large with all frames: half of them, and so on.
        loop {
            sound = self.moved(run, &chosen, limits);
            if self.bytes <= limits.bytes || chosen.len() <= 2 {
                break;
            }
            chosen = spread(count, chosen.len() / 2);
        }
        if self.bytes > limits.bytes && chosen.len() == 2 {
            // One is wanted whatever it takes: the last, or the first where the last is damaged.
            let [first, last] = [chosen[0], chosen[1]];
            sound = self.moved(run, &[last], limits);
            if sound.is_empty() {
                let damaged = std::mem::take(&mut self.notes);
                sound = self.moved(run, &[first], limits);
                self.notes.extend(damaged);
            }
            self.notes.push(format!(
                "The replay has only one of {count} frames and shows no motion: two frames would exceed {} MiB. View the motion with `riprap view`.",
                limits.bytes >> 20
            ));
        }
        if sound.is_empty() {
            return Err(Problem::missing(
                "The run has no frames to show.",
                "Request frames in the scene: [[outputs]] frames = { every = ... }",
            ));
        }
        Ok(sound)
    }

    /// Restarts with motion and shapes of the chosen frames, until they are too large; the sound ones among them.
    fn moved(&mut self, run: &Run, chosen: &[usize], limits: Limits) -> Vec<usize> {
        *self = Book::default();
        let mut sound = Vec::new();
        for &k in chosen {
            let n = sound.len();
            let done = self
                .ask(run, &format!("frame/{k}"), None, &format!("frame/{n}"))
                .and_then(|()| self.ask(run, &format!("shape/{k}"), None, &format!("shape/{n}")));
            match done {
                Ok(()) => sound.push(k),
                Err(problem) => self.notes.push(format!("frame {} was left out: {problem}", k + 1)),
            }
            if self.bytes > limits.bytes {
                break;
            }
        }
        sound
    }

    /// Adds an answer of all frames if there is room for it; whether there was. What one frame lacks is missing there.
    fn add(&mut self, room: &Room<'_>, what: &str, name: Option<&str>) -> bool {
        let mut part = Book::default();
        for (n, k) in room.frames.iter().enumerate() {
            let _ = part.ask(room.run, &format!("{what}/{k}"), name, &format!("{what}/{n}"));
            if self.bytes.saturating_add(part.bytes) > room.bytes {
                return false;
            }
        }
        self.bytes += part.bytes;
        let any = !part.answers.is_empty();
        self.answers.extend(part.answers);
        any
    }

    /// Adds a field with its range.
    fn field(&mut self, room: &Room<'_>, name: &str) -> Result<bool, Problem> {
        if !self.add(room, "field", Some(name)) {
            return Ok(false);
        }
        let (mut range, mut most, mut from) = (Value::Null, Value::Null, 0);
        while from < room.run.frames()?.len() {
            let part = |key: &str| match key {
                "name" => Some(name.to_owned()),
                "from" => Some(from.to_string()),
                _ => None,
            };
            let found = answer(room.run, "range", &Query(&part))?;
            let found: Value = serde_json::from_slice(&found.bytes).unwrap_or_default();
            range = wider(&range, &found["range"]);
            most = wider(&most, &found["most"]);
            from += FRAMES_AT_ONCE;
        }
        let range = json!({ "range": range, "most": most }).to_string();
        self.put(format!("range?name={name}"), range.as_bytes());
        Ok(true)
    }

    /// A shape that several frames share is kept once: the page asks for the shape of the first of them.
    fn same_shapes(&mut self) {
        let mut seen: Vec<Value> = Vec::new();
        let shapes: Vec<String> =
            self.answers.keys().filter(|k| k.starts_with("shape/")).cloned().collect();
        let mut shapes = shapes;
        shapes.sort_by_key(|s| s[6..].parse::<usize>().unwrap_or(0));
        for question in shapes {
            let text = self.answers[&question].clone();
            if let Some(first) = seen.iter().find(|s| s["text"] == text) {
                self.bytes -= text.as_str().map_or(0, str::len);
                self.answers.insert(question, json!({ "as": first["question"] }));
            } else {
                seen.push(json!({ "question": question, "text": text }));
            }
        }
    }
}

/// The range over two ranges, either of which may be null.
fn wider(a: &Value, b: &Value) -> Value {
    let ends = |r: &Value| Some([r[0].as_f64()?, r[1].as_f64()?]);
    match (ends(a), ends(b)) {
        (Some(a), Some(b)) => json!([a[0].min(b[0]), a[1].max(b[1])]),
        (Some(_), None) => a.clone(),
        (None, _) => b.clone(),
    }
}

/// At most `count` of `0..all`, evenly, the first and the last among them.
fn spread(all: usize, count: usize) -> Vec<usize> {
    let count = count.max(2);
    if all <= count {
        return (0..all).collect();
    }
    (0..count).map(|i| i * (all - 1) / (count - 1)).collect()
}

/// A table with at most [`ROWS`] rows.
fn thinned(run: &Run, name: &str) -> Vec<u8> {
    let table = run.table(&format!("{name}.csv")).ok().flatten();
    let columns = table.map_or_else(Vec::new, |t| t.columns);
    let rows = columns.iter().map(|c| c.values.len()).min().unwrap_or(0);
    let kept = spread(rows, ROWS);
    let mut wire = crate::wire::Wire::default();
    for (i, column) in columns.iter().enumerate() {
        let values: Vec<f64> = kept.iter().map(|r| column.values[*r]).collect();
        wire = wire.f64(&i.to_string(), &values);
    }
    let heads: Vec<Value> =
        columns.iter().map(|c| json!({ "name": c.name, "unit": c.unit })).collect();
    wire.finish(&json!({ "columns": heads, "cut": false }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture;

    #[test]
    fn frames_that_are_too_large_together_leave_one_with_a_note() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("large.run");
        for (frames, damaged) in [(1, None), (2, None), (5, None), (5, Some(5))] {
            let _ = std::fs::remove_dir_all(&path);
            fixture::write_run(&path, frames);
            if let Some(k) = damaged {
                std::fs::write(path.join(riprap_record::folder::block_file(k)), "no").unwrap();
            }
            let limits = Limits { frames: 2, bytes: 1 };
            let mut book = Book::default();
            assert_eq!(book.fill(&Run::new(&path), limits).unwrap(), 1);
            let told = book.notes.iter().any(|n| n.contains("shows no motion"));
            assert_eq!(told, frames > 1, "{:?}", book.notes);
            let left_out = book.notes.iter().any(|n| n.contains("frame 5 was left out"));
            assert_eq!(left_out, damaged.is_some(), "{:?}", book.notes);
        }
    }

    #[test]
    fn frames_are_spread_evenly() {
        assert_eq!(spread(3, 40), [0, 1, 2]);
        assert_eq!(spread(100, 4), [0, 33, 66, 99]);
        assert!(spread(0, 4).is_empty());
    }
}
