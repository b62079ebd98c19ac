//! `cargo xtask bench gas`: what gas in cracks costs of a step, beside the same blast with sealed gas.

use std::fmt::Write;
use std::path::Path;

use serde_json::Value;

use super::threads::stages_of;
use super::{SIZES, keep, manifest_of, release};

const SCENE: &str = "scenes/bench/blast_gas.toml";
/// What lets gas into cracks.
const CRACKS: &str = "sources.hole.gas_cavity.venting.cracks={}";
/// The stage in which charges and their gas are computed.
const STAGE: &str = "cavities";
/// Share of the step of the model without gas that the network may cost, %.
const ASKED: f64 = 25.0;

/// One run: steps, times of a step and of the charges in it, ms.
struct Timed {
    steps: f64,
    step: f64,
    charges: f64,
}

impl Timed {
    fn of(manifest: &Value) -> Self {
        let steps = manifest["steps"].as_f64().unwrap_or(f64::NAN);
        let per = |name: Option<&str>| {
            let stages = stages_of(manifest).filter(|stage| name.is_none_or(|n| n == stage.name));
            1e3 * stages.map(|stage| stage.wall).sum::<f64>() / steps
        };
        Self { steps, step: per(None), charges: per(Some(STAGE)) }
    }
}

/// Runs the blast in three sizes, with gas in cracks and without, and prints the table. Times are means over the steps of the blast.
pub fn gas(root: &Path) -> Result<bool, String> {
    release(root)?;
    let mut table = String::from(
        "case,joints,wetted,steps_with,steps_without,step_with_ms,step_without_ms,network_ms,network_percent_of_step_without,asked_percent\n",
    );
    for case in SIZES {
        let scene = root.join(SCENE);
        let (sealed, _) = manifest_of(root, &scene, &["--case", case])?;
        let without = Timed::of(&sealed);
        let (vented, _) = manifest_of(root, &scene, &["--case", case, "--set", CRACKS])?;
        let with = Timed::of(&vented);
        let network = with.charges - without.charges;
        let [joints, wetted] = ["joints", "cracks"].map(|name| most(root, name));
        let _ = writeln!(
            table,
            "{case},{},{},{},{},{:.3},{:.3},{network:.3},{:.1},{ASKED}",
            joints?,
            wetted?,
            with.steps,
            without.steps,
            with.step,
            without.step,
            100.0 * network / without.step
        );
    }
    print!("{table}");
    keep(root, "bench-gas.csv", &table)?;
    Ok(true)
}

/// Largest value of a history of the run done last.
fn most(root: &Path, name: &str) -> Result<f64, String> {
    let path = root.join("target").join("bench.run").join("histories.csv");
    let text = std::fs::read_to_string(&path)
        .map_err(|error| format!("{} could not be read: {error}", path.display()))?;
    let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let head = lines.next().unwrap_or_default();
    let of = |title: &&str| title.split(' ').next() == Some(name);
    let column = head.iter().position(of);
    let column = column.ok_or_else(|| format!("{} has no `{name}`", path.display()))?;
    let values = lines.filter_map(|line| line.get(column)?.trim().parse().ok());
    Ok(values.fold(0.0, f64::max))
}
