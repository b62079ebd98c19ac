//! Materials, interfaces and phases of the scene in words.

use std::fmt::Write as _;

use toml::{Table, Value};

use super::html::{escape, superscript};
use crate::run::Run;

/// Keys that have a name of their own.
const NAMES: [(&str, &str); 5] = [
    ("young", "Young's modulus"),
    ("poisson", "Poisson's ratio"),
    ("p_wave_speed", "speed of P-waves"),
    ("s_wave_speed", "speed of S-waves"),
    ("bond", "joint"),
];

/// The scene as it was run; empty where it cannot be read: the run may be of a later version, or cut off.
pub(super) fn scene(run: &Run) -> Table {
    let bytes = run.file("scenario.resolved.toml").unwrap_or_default();
    toml::from_str(&String::from_utf8_lossy(&bytes)).unwrap_or_default()
}

/// The tables of materials and interfaces of a scene.
pub(super) fn materials(out: &mut String, scene: &Table) {
    let tables = [("Materials", "material", "materials"), ("Interfaces", "between", "interfaces")];
    for (title, head, key) in tables {
        let Some(Value::Table(all)) =
            scene.get(key).filter(|t| t.as_table().is_some_and(|t| !t.is_empty()))
        else {
            continue;
        };
        let _ = writeln!(
            out,
            "<h2>{title}</h2>\n<table class=\"grid\"><tr><th>{head}</th><th>properties</th></tr>"
        );
        for (name, value) in all {
            let who = match key {
                "interfaces" => between(name, value),
                _ => name.clone(),
            };
            let _ = writeln!(
                out,
                "<tr><td>{}</td><td>{}</td></tr>",
                escape(&who),
                escape(&properties(value))
            );
        }
        out.push_str("</table>\n");
    }
}

/// Keys of a phase that say how it is calculated and when it ends; what is left is what it changes.
const CALCULATION: [&str; 9] = [
    "name",
    "kind",
    "until",
    "damping",
    "time_step",
    "integration",
    "load_steps",
    "iterations",
    "relaxation",
];

/// The phases, with what each changes when it begins.
pub(super) fn phases(out: &mut String, scene: &Table) {
    let all = scene.get("phases").and_then(Value::as_array);
    let all: Vec<&Table> = all.into_iter().flatten().filter_map(Value::as_table).collect();
    if all.is_empty() {
        return;
    }
    let bolts = scene.get("bolts").and_then(Value::as_array);
    let bolts: Vec<&Table> = bolts.into_iter().flatten().filter_map(Value::as_table).collect();
    out.push_str("<h2>Phases</h2>\n<table class=\"grid\"><tr><th>phase</th><th>kind</th><th>changes at its start</th><th>until</th></tr>\n");
    for (number, phase) in all.iter().enumerate() {
        let said = |key: &str| phase.get(key).map(properties).unwrap_or_default();
        let name = said("name");
        let others = phase.iter().filter(|(key, _)| !CALCULATION.contains(&key.as_str()));
        let mut changes: Vec<String> = others.map(|(key, value)| change(key, value)).collect();
        let here = |bolt: &&&Table| match bolt.get("phase") {
            Some(phase) => text(phase) == name,
            None => number == 0,
        };
        let installed = bolts.iter().filter(here).filter_map(|bolt| bolt.get("name"));
        changes.extend(installed.map(|bolt| format!("bolts {} installed", text(bolt))));
        let _ = writeln!(
            out,
            "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            escape(&name),
            escape(&said("kind")),
            escape(&changes.join("; ")),
            escape(&said("until"))
        );
    }
    out.push_str("</table>\n");
}

/// One change of a phase: `remove heading`, `interfaces default (friction angle 27 deg)`.
fn change(key: &str, value: &Value) -> String {
    let words = match value {
        Value::Boolean(true) => return spoken(key),
        Value::Table(_) => properties(value),
        other => text(other),
    };
    format!("{} {words}", spoken(key))
}

/// Which materials an interface lies between.
fn between(name: &str, value: &Value) -> String {
    let pair = value.get("between").and_then(Value::as_array);
    let names: Vec<&str> = pair.into_iter().flatten().filter_map(Value::as_str).collect();
    match names[..] {
        [a, b] => format!("{a} and {b} ({name})"),
        _ if name == "default" => "all other pairs".to_owned(),
        _ => name.to_owned(),
    }
}

/// `density 2600 kg/m³, Young's modulus 20 GPa`; tables within in parentheses; keys in the order of the alphabet.
fn properties(value: &Value) -> String {
    let Value::Table(table) = value else {
        return text(value);
    };
    let named = table.iter().filter(|(key, _)| *key != "between");
    let words = named.map(|(key, value)| match value {
        Value::Table(_) => format!("{} ({})", spoken(key), properties(value)),
        Value::Boolean(true) => spoken(key),
        Value::Boolean(false) => format!("no {}", spoken(key)),
        _ => format!("{} {}", spoken(key), text(value)),
    });
    words.collect::<Vec<_>>().join(", ")
}

fn spoken(key: &str) -> String {
    let known = NAMES.iter().find(|(k, _)| *k == key);
    known.map_or_else(|| key.replace('_', " "), |(_, name)| (*name).to_owned())
}

fn text(value: &Value) -> String {
    match value {
        Value::String(text) => superscript(text),
        Value::Array(all) => all.iter().map(text).collect::<Vec<_>>().join(", "),
        Value::Table(_) => properties(value),
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_become_words() {
        let table: Table = toml::from_str(
            "between = [\"rock\", \"steel\"]\nfriction_angle = \"30 deg\"\n\
             [bond]\ntension = \"1 MPa\"\nelastic = true\n[softening]\nslip = 0.5\nbrittle = false\n",
        )
        .unwrap();
        let value = Value::Table(table);
        assert_eq!(between("smooth", &value), "rock and steel (smooth)");
        assert_eq!(
            properties(&value),
            "joint (elastic, tension 1 MPa), friction angle 30 deg, softening (no brittle, slip 0.5)"
                .to_owned()
        );
        let scene: Table = toml::from_str(
            "[[phases]]\nname = \"settle\"\nkind = \"static\"\nuntil = { unbalanced = 1e-5 }\n\
             [[phases]]\nname = \"dig\"\nremove = [\"a\", \"b\"]\ninterfaces.default.friction_angle = \"27 deg\"\n\
             [[bolts]]\nname = \"roof\"\nphase = \"dig\"\n",
        )
        .unwrap();
        let mut out = String::new();
        phases(&mut out, &scene);
        for part in [
            "<td>settle</td><td>static</td><td></td><td>unbalanced 0.00001</td>",
            "interfaces default (friction angle 27 deg); remove a, b; bolts roof installed</td>",
        ] {
            assert!(out.contains(part), "{part}: {out}");
        }
        assert_eq!(between("default", &Value::Integer(1)), "all other pairs");
        assert_eq!(text(&Value::String("2600 kg/m3".to_owned())), "2600 kg/m³");
        assert_eq!(spoken("young"), "Young's modulus");
    }
}
