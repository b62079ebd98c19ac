//! Times the steps of one scene and prints CSV: `bench_scene SCENE.toml CASE [THREADS]...`.
//!
//! `cargo xtask bench` runs it for every scene and size under `scenes/bench`. The scene is loaded as
//! `riprap run` loads it and its loop is the one of a run. All phases but the last only prepare; the steps
//! that are timed belong to the last one, begin at the same state for every number of threads and
//! end at the same state hash. Times are medians over repeats with the smallest and largest beside.
//!
//! Contacts are pairs of blocks that touch, in space those found anew; patches stand beside them. Memory is what is
//! allocated beyond the setup (shapes and names): in space a block takes what is allocated with found contacts
//! switched off, and a candidate its share of what it takes more with them, less the shapes of the blocks and their turned normals.

use std::path::Path;
use std::time::Instant;

use riprap::exec::Exec;
use riprap::record::manifest::Machine;
use riprap::run::engine::View;
use riprap::run::job::Job;
use riprap::run::scene::Scene;
use riprap::run::simulation::{Simulation, Snapshot, Stage};
use riprap::setup::Setup;
use riprap::spatial::Shape;
use riprap_testkit::Counting;

const REPEATS: usize = 5;
/// Block-steps per repeat: long enough to time, short enough to wait for.
const WORK: usize = 500_000;
/// Fewest steps per repeat.
const FEWEST: usize = 5;

/// Reads a case of a scene.
fn load(path: &Path, case: &str) -> Result<Job, String> {
    let scene = Scene::load(path, &[]).map_err(|wrong| wrong.render())?;
    let found =
        scene.case(case).ok_or_else(|| format!("{} has no case {case:?}", path.display()))?;
    Ok(scene.prepare(&found).map_err(|wrong| wrong.render())?.job())
}

#[global_allocator]
static ALLOCATOR: Counting = Counting::new();

/// What is counted in a state.
struct Counts {
    blocks: usize,
    contacts: usize,
    /// Pairs that are watched, in space.
    candidates: usize,
    /// Memory of the shapes of blocks that can meet, bytes.
    shapes: usize,
    patches: usize,
}

impl Counts {
    fn of(simulation: &Simulation) -> Self {
        let view = simulation.view();
        let blocks = view.blocks().max(1);
        match view {
            View::Planar(view) => Counts {
                blocks,
                contacts: view.contacts().count(),
                candidates: 0,
                shapes: 0,
                patches: 0,
            },
            View::Spatial(view) => Counts {
                blocks,
                contacts: view.contacts().count(),
                candidates: view.world.found.pairs.len(),
                shapes: {
                    let desk = &view.scratch.desk;
                    let shapes = desk.shapes.iter().map(Shape::bytes);
                    shapes.sum::<usize>() + size_of_val(desk.normals.as_slice())
                },
                patches: view.world.patches.len(),
            },
        }
    }
}

/// Memory that a scene takes beyond its setup, bytes.
struct Memory {
    per_block: f64,
    per_candidate: f64,
}

/// A pool of so many threads.
fn with(threads: usize) -> Result<Exec, String> {
    Exec::new(threads).map_err(|error| error.to_string())
}

/// Brings a scene to the first step of its last phase, and looks at its memory on the way.
fn prepared(job: Job, threads: usize) -> Result<(Simulation, Memory), String> {
    let grown = |since: f64| ALLOCATOR.live() as f64 - since;
    let mut without = None;
    if let Setup::Spatial(setup) = &job.setup
        && setup.found_contacts
    {
        let mut setup = setup.clone();
        setup.found_contacts = false;
        let setup = Setup::Spatial(setup);
        let before = ALLOCATOR.live() as f64;
        let mut blind = Simulation::new(setup, job.plan.clone(), with(threads)?)
            .map_err(|error| error.to_string())?;
        blind.prepare().map_err(|error| error.to_string())?;
        // Kept to the end, so that its memory is not taken a second time.
        without = Some((grown(before), blind));
    }
    let before = ALLOCATOR.live() as f64;
    let mut simulation =
        Simulation::new(job.setup, job.plan, with(threads)?).map_err(|error| error.to_string())?;
    up_to_last_phase(&mut simulation)?;
    simulation.prepare().map_err(|error| error.to_string())?;
    let (all, counts) = (grown(before), Counts::of(&simulation));
    let alone = without.as_ref().map_or(all, |(bytes, _)| *bytes);
    let memory = Memory {
        per_block: alone / counts.blocks as f64,
        per_candidate: (all - alone - counts.shapes as f64) / counts.candidates as f64,
    };
    Ok((simulation, memory))
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

/// One row: the last phase from `start` on `threads` threads.
fn measure(
    label: &str,
    start: Snapshot,
    threads: usize,
    memory: &Memory,
) -> Result<String, String> {
    let exec = with(threads)?;
    let mut simulation = Simulation::resume(start, exec);
    simulation.prepare().map_err(|e| e.to_string())?;
    // One step untimed: memory is claimed and every stage has its row.
    advance(&mut simulation, 1)?;
    let steps = (WORK / Counts::of(&simulation).blocks).max(FEWEST);
    let before = simulation.engine().profile().seconds();
    let mut times = Vec::new();
    for _ in 0..REPEATS {
        let begun = Instant::now();
        advance(&mut simulation, steps)?;
        times.push(begun.elapsed().as_secs_f64() / steps as f64);
    }
    times.sort_by(f64::total_cmp);
    let median = times[REPEATS / 2];
    let Counts { blocks, contacts, candidates, patches, .. } = Counts::of(&simulation);
    let after = simulation.engine().profile().seconds();
    let spent = after.iter().zip(&before).map(|((_, a), (_, b))| a - b);
    let all: f64 = spent.clone().sum();
    let split: Vec<String> = after
        .iter()
        .zip(spent)
        .map(|((name, _), s)| format!("{name} {:.0} %", 100.0 * s / all))
        .collect();
    Ok(format!(
        "{label},{blocks},{contacts},{candidates},{patches},{threads},{steps},{:.4},{:.4},{:.4},{:.3},{:.1},{:.0},{:.0},{},{}",
        1e3 * median,
        1e3 * times[0],
        1e3 * times[REPEATS - 1],
        1e-6 * contacts as f64 / median,
        1e9 * median / blocks as f64,
        memory.per_block,
        memory.per_candidate,
        split.join(" | "),
        &simulation.engine().hash()[..16],
    ))
}

fn main() -> Result<(), String> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [path, case, threads @ ..] = arguments.as_slice() else {
        return Err("usage: bench_scene SCENE.toml CASE [THREADS]...".to_owned());
    };
    let threads: Vec<usize> = threads
        .iter()
        .map(|text| text.parse().map_err(|_| format!("{text:?} is no number")))
        .collect::<Result<_, _>>()?;
    let threads = if threads.is_empty() { vec![1, 2] } else { threads };
    let path = Path::new(path);
    let job = load(path, case)?;
    let most = threads.iter().copied().max().unwrap_or(1);
    let (simulation, memory) = prepared(job, most)?;
    let start = simulation.snapshot();
    drop(simulation);
    let machine = Machine::this();
    println!("# {} ({} cores), {} {}", machine.cpu, machine.cores, machine.os, machine.arch);
    println!(
        "scene,size,blocks,contacts,candidates,patches,threads,steps,median_ms_per_step,min_ms,max_ms,\
         million_contacts_per_s,ns_per_block_step,bytes_per_block,bytes_per_candidate,stages,state_hash"
    );
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let label = format!("{name},{case}");
    for &count in &threads {
        println!("{}", measure(&label, start.clone(), count, &memory)?);
    }
    Ok(())
}
