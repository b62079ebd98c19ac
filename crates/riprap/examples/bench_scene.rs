//! Times the steps of one scene and prints CSV: `bench_planar SCENE.toml CASE [THREADS]...`.
//!
//! `cargo xtask bench` runs it for every scene and size under `scenes/bench`. The scene is loaded as
//! `riprap run` loads it and its loop is the one of a run. All phases but the last only prepare; the steps
//! that are timed belong to the last one, begin at the same state for every number of threads and
//! end at the same state hash. Times are medians over repeats with the smallest and largest beside.

use std::path::Path;
use std::time::Instant;

use riprap::exec::Exec;
use riprap::record::manifest::Machine;
use riprap::run::job::Job;
use riprap::run::scene::Scene;
use riprap::run::simulation::{Simulation, Snapshot, Stage};

const REPEATS: usize = 5;
/// Block-steps per repeat: long enough to time, short enough to wait for.
const WORK: usize = 500_000;
/// Fewest steps per repeat.
const FEWEST: usize = 5;

/// Reads a case of a scene.
fn load(path: &Path, case: &str) -> Result<Job, String> {
    let scene = Scene::load(path, &[]).map_err(|wrong| wrong.render())?;
    let found = scene
        .case(case)
        .ok_or_else(|| format!("{} has no case {case:?}", path.display()))?;
    Ok(scene.prepare(&found).map_err(|wrong| wrong.render())?.job())
}

/// Number of living blocks.
fn blocks(simulation: &Simulation) -> usize {
    let view = simulation.view().planar();
    view.map_or(0, |view| view.living().count()).max(1)
}

/// Runs up to the first step of the last phase.
fn up_to_last_phase(simulation: &mut Simulation) -> Result<(), String> {
    let last = simulation.plan().phases.len().saturating_sub(1);
    while simulation.cursor().phase < last {
        match simulation.prepare().map_err(|e| e.to_string())? {
            Stage::Within => simulation.step(),
            Stage::PhaseEnd => simulation.next_phase(),
            Stage::Done => return Err("the scene has no phases".to_owned()),
        }
    }
    Ok(())
}

/// Makes `steps` steps; the forces of the state behind them are known.
fn advance(simulation: &mut Simulation, steps: usize) -> Result<(), String> {
    for _ in 0..steps {
        simulation.step();
        if simulation.prepare().map_err(|e| e.to_string())? != Stage::Within {
            return Err("the last phase ends too soon to be timed".to_owned());
        }
    }
    Ok(())
}

/// Memory in use by this process, kB; `None` where the system does not tell.
fn resident_kb() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find(|l| l.starts_with("VmRSS:"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

/// One row: the last phase from `start` on `threads` threads.
fn measure(
    label: &str,
    start: Snapshot,
    threads: usize,
    kb_per_block: f64,
) -> Result<String, String> {
    let exec = Exec::new(threads).map_err(|e| e.to_string())?;
    let mut simulation = Simulation::resume(start, exec);
    simulation.prepare().map_err(|e| e.to_string())?;
    // One step untimed: memory is claimed and every stage has its row.
    advance(&mut simulation, 1)?;
    let blocks = blocks(&simulation);
    let steps = (WORK / blocks).max(FEWEST);
    let before = simulation.engine().profile().seconds();
    let mut times = Vec::new();
    for _ in 0..REPEATS {
        let begun = Instant::now();
        advance(&mut simulation, steps)?;
        times.push(begun.elapsed().as_secs_f64() / steps as f64);
    }
    times.sort_by(f64::total_cmp);
    let median = times[REPEATS / 2];
    let contacts = simulation.view().contacts();
    let after = simulation.engine().profile().seconds();
    let spent = after.iter().zip(&before).map(|((_, a), (_, b))| a - b);
    let all: f64 = spent.clone().sum();
    let split: Vec<String> = after
        .iter()
        .zip(spent)
        .map(|((name, _), s)| format!("{name} {:.0} %", 100.0 * s / all))
        .collect();
    Ok(format!(
        "{label},{blocks},{contacts},{threads},{steps},{:.4},{:.4},{:.4},{:.3},{:.1},{kb_per_block:.2},{},{}",
        1e3 * median,
        1e3 * times[0],
        1e3 * times[REPEATS - 1],
        1e-6 * contacts as f64 / median,
        1e9 * median / blocks as f64,
        split.join(" | "),
        &simulation.engine().hash()[..16],
    ))
}

fn main() -> Result<(), String> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [path, case, threads @ ..] = arguments.as_slice() else {
        return Err("usage: bench_planar SCENE.toml CASE [THREADS]...".to_owned());
    };
    let threads: Vec<usize> = threads
        .iter()
        .map(|text| text.parse().map_err(|_| format!("{text:?} is no number")))
        .collect::<Result<_, _>>()?;
    let threads = if threads.is_empty() {
        vec![1, 2]
    } else {
        threads
    };
    let path = Path::new(path);
    let job = load(path, case)?;
    let before = resident_kb();
    let most = threads.iter().copied().max().unwrap_or(1);
    let exec = Exec::new(most).map_err(|e| e.to_string())?;
    let mut simulation = Simulation::new(job.setup, job.plan, exec).map_err(|e| e.to_string())?;
    up_to_last_phase(&mut simulation)?;
    let blocks = blocks(&simulation);
    let kb_per_block = resident_kb()
        .zip(before)
        .map_or(f64::NAN, |(now, before)| (now - before) / blocks as f64);
    let start = simulation.snapshot();
    drop(simulation);
    let machine = Machine::this();
    println!(
        "# {} ({} cores), {} {}",
        machine.cpu, machine.cores, machine.os, machine.arch
    );
    println!(
        "scene,size,blocks,contacts,threads,steps,median_ms_per_step,min_ms,max_ms,\
         million_contacts_per_s,ns_per_block_step,kb_per_block,stages,state_hash"
    );
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let label = format!("{name},{case}");
    for &count in &threads {
        println!("{}", measure(&label, start.clone(), count, kb_per_block)?);
    }
    Ok(())
}
