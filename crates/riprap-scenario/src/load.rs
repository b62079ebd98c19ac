//! From a file to a [`Parsed`] scenario, or to the reasons why not.

use std::io::Read;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use toml::Spanned;
use toml::de::DeTable;

use super::diagnostic::{Diagnostic, Diagnostics, Source};
use super::language::{Check, Scenario};
use super::overrides::apply_overrides;
use super::path::{plain, resolve};
use super::quantity::Span;
use super::replaced::fallen_away;
use super::units;
use super::{rules, validate};

/// Largest scenario file accepted, bytes. Generators and CSV files keep scenarios short.
pub(crate) const MAX_SIZE: u64 = 16 << 20;

/// Most brackets, commas, equals signs and line ends in a scenario: each costs the parser some
/// fifty bytes of memory.
pub(crate) const MAX_MARKS: usize = 6_000_000;

/// A scenario that follows the language: every quantity has its dimension and range, every name
/// stands for something. Geometry and physics are checked when the model is built.
#[derive(Debug, Clone)]
pub struct Parsed {
    /// What the user said.
    pub scenario: Scenario,
    /// The text it was read from, after overrides.
    pub source: Source,
    /// Folder from which relative paths in the scenario are seen.
    pub folder: PathBuf,
    /// Remarks that do not stop it.
    pub warnings: Vec<Diagnostic>,
    /// Whether blocks have moved since the start: bolts are then looked at when they are installed.
    pub has_moved: bool,
}

/// Reads a file, changes keys and parses the result.
///
/// # Errors
/// Everything that is wrong with it.
pub fn load(path: &Path, changes: &[(String, String)]) -> Result<Parsed, Diagnostics> {
    let mut parsed = parse_changed(&read(path)?, changes)?;
    parsed.folder = path.parent().map(Path::to_path_buf).unwrap_or_default();
    Ok(parsed)
}

/// Changes keys of a text and parses the result. What a changed table takes away is a warning.
///
/// # Errors
/// Everything that is wrong with it.
pub fn parse_changed(source: &Source, changes: &[(String, String)]) -> Result<Parsed, Diagnostics> {
    let changed = apply_overrides(source, changes)?;
    parse_with(changed, fallen_away(source, changes))
}

/// As [`parse`], with warnings that are known already; they stand beside errors too.
///
/// # Errors
/// Everything that is wrong with it.
pub fn parse_with(source: Source, known: Vec<Diagnostic>) -> Result<Parsed, Diagnostics> {
    match parse(source) {
        Ok(mut parsed) => {
            parsed.warnings.extend(known);
            Ok(parsed)
        }
        Err(mut errors) => {
            errors.list.extend(known);
            Err(errors)
        }
    }
}

/// Reads the text of a scenario file.
///
/// # Errors
/// No such file, a folder, too large, or not UTF-8 text.
pub(crate) fn read(path: &Path) -> Result<Source, Diagnostics> {
    let name = path.display().to_string();
    let fail =
        |diagnostic: Diagnostic| Diagnostics::new(Source::new(name.clone(), ""), vec![diagnostic]);
    let cannot = |error: &std::io::Error| {
        let diagnostic = Diagnostic::error("file.read", format!("cannot read the file: {error}"));
        fail(match error.kind() {
            std::io::ErrorKind::NotFound => {
                diagnostic.help("check the path; `riprap new NAME` writes a scenario to begin with")
            }
            _ => diagnostic,
        })
    };
    let meta = std::fs::metadata(path).map_err(|error| cannot(&error))?;
    if meta.is_dir() {
        let diagnostic = Diagnostic::error("file.folder", "this is a folder, not a scenario file");
        let help = match path.join("manifest.json").exists() {
            true => "it is the folder of a run: give its scene, a .toml file",
            false => "give the path of a .toml file",
        };
        return Err(fail(diagnostic.help(help)));
    }
    let too_large = || {
        fail(
            Diagnostic::error(
                "file.size",
                format!("the file is larger than {} MiB", MAX_SIZE >> 20),
            )
            .help("put long lists of points into CSV files, or let a generator make the blocks"),
        )
    };
    if meta.len() > MAX_SIZE {
        return Err(too_large());
    }
    // The length may be unknown (a pipe) or grow: never read more than allowed.
    let mut bytes = Vec::new();
    let file = std::fs::File::open(path).map_err(|error| cannot(&error))?;
    file.take(MAX_SIZE + 1).read_to_end(&mut bytes).map_err(|error| cannot(&error))?;
    if bytes.len() as u64 > MAX_SIZE {
        return Err(too_large());
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let line = error.as_bytes()[..at].iter().filter(|byte| **byte == b'\n').count() + 1;
        fail(
            Diagnostic::error(
                "file.text",
                format!("this is not a text file: byte {at} (line {line}) is not UTF-8"),
            )
            .help("a scenario is a TOML text saved as UTF-8"),
        )
    })?;
    Ok(Source::new(name, text))
}

/// Parses a text.
///
/// # Errors
/// Everything that is wrong with it: syntax, keys, types, units, ranges and references.
/// # Examples
///
/// A key with a slip of the pen: the answer says where, and what may have been meant.
///
/// ```
/// use riprap_scenario::{Source, parse};
///
/// let text = "riprap = 1\ntitle = \"x\"\n[space.planar]\n[materials.rock]\ndensty = \"2500 kg/m3\"\n";
/// let wrong = parse(Source::new("scene.toml", text)).unwrap_err().to_string();
/// assert!(wrong.contains("scene.toml:5") && wrong.contains("density"), "{wrong}");
/// ```
pub fn parse(mut source: Source) -> Result<Parsed, Diagnostics> {
    if source.text.starts_with('\u{feff}') {
        source.text.drain(..'\u{feff}'.len_utf8());
    }
    let text = source.text.as_str();
    let fail = |list| Err(Diagnostics::new(source.clone(), list));
    let marks = text.bytes().filter(|byte| b"[]{},=.\n".contains(byte)).count();
    if marks > MAX_MARKS {
        let diagnostic = Diagnostic::error("file.size", "the scenario has too many values")
            .help("put long lists of points into CSV files, or let a generator make the blocks");
        return fail(vec![diagnostic]);
    }
    if let Some(at) = text.find('\0') {
        let diagnostic = Diagnostic::error("file.text", "this is not a text: it has a zero byte")
            .at(at..at + 1)
            .help("a scenario is a TOML text saved as UTF-8");
        return fail(vec![diagnostic]);
    }
    let root = match DeTable::parse(text) {
        Ok(root) => root,
        Err(error) => return fail(vec![syntax_error(text, error.message(), error.span())]),
    };
    let [mut list, by_rules] = validate::validate(&root);
    match deserialize(&root) {
        Ok(scenario) => {
            list.extend(rules::check(&scenario, root.get_ref(), list.is_empty()));
            list.extend(by_rules);
            let diagnostics = Diagnostics::new(source.clone(), list);
            if diagnostics.errors() > 0 {
                return Err(diagnostics);
            }
            Ok(Parsed {
                scenario,
                source,
                folder: PathBuf::new(),
                warnings: diagnostics.list,
                has_moved: false,
            })
        }
        Err(error) => {
            // The validation should have found it; if not, the parser's own words must do.
            if list.is_empty() {
                let mut diagnostic = Diagnostic::error("toml.value", error.message());
                diagnostic.span = error.span();
                list.push(diagnostic);
            }
            fail(list)
        }
    }
}

fn deserialize(root: &Spanned<DeTable<'_>>) -> Result<Scenario, toml::de::Error> {
    Scenario::deserialize(toml::Deserializer::from(root.clone()))
}

/// A syntax error in friendly words.
pub(super) fn syntax_error(text: &str, message: &str, span: Option<Span>) -> Diagnostic {
    let span = span.unwrap_or(0..0);
    if message.contains("recurs") {
        return Diagnostic::error("toml.depth", "brackets are nested too deeply")
            .at(span)
            .help("no part of a scenario needs more than a few levels");
    }
    if let Some(rest) = message.strip_prefix("duplicate key") {
        let _ = rest;
        return Diagnostic::error("toml.duplicate", "this key or table stands twice")
            .at(span)
            .help("keep one; repeated tables are written with double brackets, [[blocks]]");
    }
    // Control characters, or no equals sign at all: another kind of file, whose first error would mean nothing.
    let odd = text.chars().take(2000).filter(|c| c.is_control() && !"\t\r\n".contains(*c)).count();
    if odd > 0 || !text.contains('=') && !text.trim().is_empty() {
        return Diagnostic::error("toml.syntax", format!("this is not a TOML text: {message}"))
            .at(span)
            .help("a scenario is a TOML text; `riprap new NAME` writes one to begin with");
    }
    let place = text.get(span.start..).unwrap_or_default();
    let line = place.lines().next().unwrap_or_default();
    let before = text.get(..span.start).unwrap_or_default();
    if line.trim().is_empty() && before.trim_end_matches([' ', '\t']).ends_with('=') {
        return Diagnostic::error("toml.syntax", "there is no value after the equals sign")
            .at(span)
            .help("write key = value, for example density = \"2600 kg/m3\"");
    }
    let help = if line.contains('“') || line.contains('”') {
        "use straight quotes: \""
    } else if message.contains("string") || message.contains("quote") {
        "put texts and values with units in quotes, for example density = \"2600 kg/m3\""
    } else {
        "write key = value, one on a line; values with units stand in quotes"
    };
    Diagnostic::error("toml.syntax", format!("this is not TOML: {message}")).at(span).help(help)
}

impl Parsed {
    /// SI value of a key in the text, such as `interfaces.default.friction_angle`.
    ///
    /// # Errors
    /// The key is not there or is no number.
    pub fn key_si(&self, key: &str) -> Result<f64, String> {
        let root = DeTable::parse(&self.source.text).map_err(|error| error.message().to_owned())?;
        key_si(root.get_ref(), key)
    }

    /// Whether a check is meant for this text: every key of its `when` has one of the values.
    /// (`only` is about the variant, see [`super::Case`].)
    pub fn check_applies(&self, check: &Check) -> bool {
        if check.when.is_empty() {
            return true;
        }
        let Ok(root) = DeTable::parse(&self.source.text) else {
            return false;
        };
        check.when.iter().all(|(key, values)| {
            resolve(root.get_ref(), key.as_str())
                .ok()
                .and_then(|place| plain(place.value?.get_ref()))
                .is_some_and(|actual| values.iter().any(|value| same(value, &actual)))
        })
    }
}

/// SI value of a key.
pub(super) fn key_si(root: &DeTable<'_>, key: &str) -> Result<f64, String> {
    let place = resolve(root, key).map_err(|error| match error.help {
        Some(help) => format!("{}; {help}", error.message),
        None => error.message,
    })?;
    let value = place
        .value
        .and_then(|value| plain(value.get_ref()))
        .ok_or_else(|| format!("the file gives no `{key}`"))?;
    number(&value).ok_or_else(|| format!("`{key}` is not a number"))
}

fn number(value: &toml::Value) -> Option<f64> {
    match value {
        toml::Value::Integer(number) => Some(*number as f64),
        toml::Value::Float(number) => Some(*number),
        toml::Value::String(text) => units::parse(text).ok().map(|(value, _)| value),
        toml::Value::Boolean(_)
        | toml::Value::Datetime(_)
        | toml::Value::Array(_)
        | toml::Value::Table(_) => None,
    }
}

/// Equal as values: "5 deg" and "5.0 deg" are the same.
fn same(a: &toml::Value, b: &toml::Value) -> bool {
    a == b || number(a).zip(number(b)).is_some_and(|(a, b)| a == b)
}
