//! Where the energy of a run went, from its ledger.

use std::path::Path;

use serde::Serialize;

use super::MuckpileError;
use crate::record::table::Table;

/// A part of the energy.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Part {
    /// What it is.
    pub name: &'static str,
    /// J.
    pub energy: f64,
    /// Over all that was put in.
    pub share: f64,
    /// What it depends on.
    pub depends_on: &'static str,
}

/// Where the energy came from and went, between the first and the last row of `energy.csv`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Partition {
    /// All that was put in, J.
    pub put_in: f64,
    /// What put it in.
    pub from: Vec<Part>,
    /// Where it went; together with what is not explained it is all that was put in.
    pub to: Vec<Part>,
}

/// A line of the table: name, columns of the ledger that it sums, what it depends on.
type Line = (&'static str, &'static [&'static str], &'static str);

const FROM: [Line; 2] = [
    ("work of the gas", &["gas"], "charge, coupling, equation of state, when and where gas vents"),
    ("loads and supports", &["loads", "supports"], "what the scene drives"),
];

const TO: [Line; 10] = [
    (
        "seismic, absorbed at boundaries",
        &["absorbed"],
        "viscous boundaries: without any, waves come back and go into other lines",
    ),
    (
        "fracture",
        &["fracture"],
        "strength and stiffness of joints, and how many there are: size of cells",
    ),
    ("friction", &["friction"], "friction angle, pressure on joints that have failed"),
    (
        "dashpots and damping",
        &["damping"],
        "damping_ratio, restitution, dashpots, damping of phases: often a choice and no measurement",
    ),
    ("bolts", &["bolts", "bolt_loss"], "bolts"),
    ("kinetic", &["kinetic"], "when the run ends; 0 at rest"),
    ("heave", &["gravity"], "weight that lies higher (+) or lower (-) than at the start"),
    (
        "strain",
        &["contact_normal", "contact_shear", "joints"],
        "stiffness of joints and contacts; stress of the start that was released counts as negative",
    ),
    ("left the model", &["left"], "bounds of `phases.*.leavers`"),
    (
        "not explained",
        &["integrator", "law_defect", "edit_defect", "step_change", "residual"],
        "time step; release of joints to contact",
    ),
];

/// Signs of columns that add to what is put in, where the table counts what went.
fn sign(column: &str) -> f64 {
    match column {
        "law_defect" | "edit_defect" | "step_change" | "residual" => -1.0,
        _ => 1.0,
    }
}

/// The partition of a run; `None` where it has no rows, or a ledger of an earlier version.
pub(super) fn partition(folder: &Path) -> Result<Option<Partition>, MuckpileError> {
    let path = folder.join("energy.csv");
    if !path.exists() {
        return Ok(None);
    }
    Ok(of_table(&Table::read(&path)?))
}

fn of_table(table: &Table) -> Option<Partition> {
    let change = |column: &&str| {
        // A ledger of an earlier version lacks some.
        let values = table.column(column).map_or(&[][..], |series| &series.values[..]);
        let (first, last) = (values.first().copied()?, values.last().copied()?);
        Some(sign(column) * (last - first))
    };
    table.column("kinetic").ok()?.values.first()?;
    let sum = |columns: &[&str]| columns.iter().filter_map(change).sum::<f64>();
    let put_in: f64 = FROM.iter().map(|(_, columns, _)| sum(columns)).sum();
    let parts = |lines: &[Line]| {
        let part = |(name, columns, depends_on): &Line| {
            let energy = sum(columns);
            let share = if put_in == 0.0 { 0.0 } else { energy / put_in };
            Part { name, energy, share, depends_on }
        };
        lines.iter().map(part).filter(|part| part.energy != 0.0).collect()
    };
    Some(Partition { put_in, from: parts(&FROM), to: parts(&TO) })
}
