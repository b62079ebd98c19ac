//! `riprap check`: what a scene holds and what a run of it will take.

use riprap::exec::Exec;
use riprap::model::{Charge, Setup, Summary};
use riprap::run::cpu::Work;
use riprap::run::engine::Engine;
use riprap::run::forecast::{Forecast, ForecastError, forecast};
use riprap::run::meeting::Outlook;
use riprap::spatial::Part;
use serde_json::json;

use crate::args::Check;
use crate::diagnostics::{Style, print_line};
use crate::failure::Failure;
use crate::numbers::{coordinate, counted, duration, grouped, ratio, si};
use crate::{scenes, screen};

/// Fewer blocks than these have no distribution of sizes, nor have those whose sizes differ by less than this factor.
const FEW: usize = 10;
const ALIKE: f64 = 1.01;
/// CPU time before the first step that is worth a word, s.
const NOTICED: f64 = 1.0;
/// Share of a tilting load below which the softness of a toe is not reported.
const SLIGHT_TOE: f64 = 1e-3;

pub fn run(args: &Check, style: Style) -> Result<(), Failure> {
    let work = Work::begin();
    let prepared = scenes::prepare(&args.scene, style, false)?;
    let laid_out = work.done().as_secs_f64();
    let (model, summary) = (&prepared.model, &prepared.model.summary);
    let expected = forecast(&model.setup, &model.plan).map_err(|e| match e {
        ForecastError::Build(e) => Failure::Input(e.to_string()),
        ForecastError::Step(e) => Failure::step(&e, &prepared.parsed),
        // Nothing was run: a scene that cannot begin is bad input.
        ForecastError::Physics(e) => Failure::Input(e.to_string()),
    })?;
    if args.json {
        let mut warnings: Vec<_> = model
            .warnings
            .iter()
            .map(|w| json!({ "code": w.code, "message": w.message, "help": w.help }))
            .collect();
        warnings.extend(
            expected
                .warnings
                .iter()
                .map(|message| json!({ "code": "run.doubt", "message": message, "help": null })),
        );
        let all = json!({
            "scene": args.scene.file.display().to_string(),
            "title": prepared.parsed.scenario.title,
            "input_hash": prepared.manifest.input_hash,
            "model": summary, "expected": expected, "warnings": warnings,
        });
        screen::line(&serde_json::to_string_pretty(&all).unwrap_or_default());
        return Ok(());
    }
    let title = &prepared.parsed.scenario.title;
    screen::line(&format!("{}: {title}", args.scene.file.display()));
    screen::print(&match &summary.solid_bounds {
        None => model_text(summary),
        Some(bounds) => solid_text(summary, bounds, &model.setup, &expected),
    });
    screen::print(&imports_text(summary));
    let memory = grouped((1e-6 * expected.memory).ceil() as u64);
    screen::line(&format!("  memory     about {memory} MB"));
    if expected.frame > LARGE_FRAME {
        let size = si(expected.frame as f64, "B");
        screen::line(&format!(
            "  frames     {size} each before compression (`outputs.*.frames.fields`, `contacts` choose)"
        ));
    }
    screen::print(&expected_text(&expected, laid_out + expected.build_time));
    if let Some(ranks) = args.ranks {
        screen::print(&ranks_text(&model.setup, ranks as usize, expected.memory)?);
    }
    for doubt in &expected.warnings {
        print_line("warning", doubt);
    }
    let checks = model.checks.len();
    screen::line(&format!(
        "  checks     {checks}\nno errors, {}",
        counted(model.warnings.len() + expected.warnings.len(), "warning")
    ));
    Ok(())
}

/// Bytes from which the size of a frame is worth a line.
const LARGE_FRAME: usize = 10_000_000;

/// How so many ranks would share the model out; `memory` of each of them, bytes.
fn ranks_text(setup: &Setup, ranks: usize, memory: f64) -> Result<String, Failure> {
    let each = format!("each holds the whole model, about {}", si(memory, "B"));
    let engine = Engine::new(setup.clone(), Exec::serial());
    let engine = engine.map_err(|e| Failure::Input(e.to_string()))?;
    let Some(parts) = engine.parts(ranks) else {
        return Ok(format!(
            "  ranks      {ranks}; {each}; models in the plane are not shared out: every rank computes all of it\n"
        ));
    };
    let mut text = format!("  ranks      {ranks}; {each}\n");
    let line = |part: &Part| {
        format!(
            "{}, {} ({} at the cut); sends {} and {} a step",
            counted(part.blocks, "block"),
            counted(part.patches, "joint"),
            grouped(part.cut as u64),
            counted(part.messages, "message"),
            si(part.bytes as f64, "B")
        )
    };
    // Ranks in a row that are alike share a line.
    for alike in parts.iter().zip(0..).collect::<Vec<_>>().chunk_by(|(a, _), (b, _)| a == b) {
        let (part, first) = alike[0];
        let numbers = match alike.len() {
            1 => format!("rank {first}"),
            n => format!("ranks {first} to {}", first + n - 1),
        };
        text.push_str(&format!("             {numbers}: {}\n", line(part)));
    }
    if parts.iter().any(|part| part.blocks == 0) {
        text.push_str("             the model has fewer groups of 64 blocks than there are ranks: some have none\n");
    }
    Ok(text)
}

/// What was read of the files that the scene names, a line each.
pub(super) fn imports_text(s: &Summary) -> String {
    let lines = s.imports.iter();
    lines.map(|words| format!("  file       {words}\n")).collect()
}

fn model_text(s: &Summary) -> String {
    let mut text = format!(
        "  blocks     {} ({} held), {} corners, sizes {} / {} / {} (smallest, median, largest)\n  region     {}; mass {}\n  shortest   edge {} on \
         block {}\n  near       {} at the start (overlapping bounding boxes)",
        grouped(s.blocks as u64),
        grouped(s.supported as u64),
        grouped(s.vertices as u64),
        si(s.size[0], "m"),
        si(s.size[1], "m"),
        si(s.size[2], "m"),
        region(&["x", "y"], &s.bounds),
        mass(s.mass, "/m"),
        si(s.shortest_edge.0, "m"),
        s.shortest_edge.1,
        counted(s.near_pairs, "pair"),
    );
    if let Some((depth, [a, b])) = &s.deepest_overlap {
        text.push_str(&format!(", deepest overlap {} between {a} and {b}", si(*depth, "m")));
    }
    text.push('\n');
    text.push_str(&passing_text(s));
    if !s.slivers.is_empty() {
        text.push_str(&format!("  slivers    {} (see the warnings)\n", s.slivers.len()));
    }
    text
}

/// The distribution of sizes, where there is one.
fn passing_text(s: &Summary) -> String {
    let [smallest, _, largest] = s.size;
    if s.blocks < FEW || largest < ALIKE * smallest {
        return String::new();
    }
    let [fifth, half, most] = s.passing.map(|size| si(size, "m"));
    format!(
        "  passing    20 % of the rock in blocks up to {fifth}, 50 % up to {half}, 80 % up to {most}\n"
    )
}

/// From where to where a model reaches along each axis.
fn region<const N: usize>(axes: &[&str; N], [low, high]: &[[f64; N]; 2]) -> String {
    let sides = low.iter().zip(high).map(|(low, high)| high - low);
    let size = sides.fold(0.0, f64::max);
    let along = |k: usize| {
        let [from, to] = [low[k], high[k]].map(|x| coordinate(x, size));
        format!("{} {from} to {to} m", axes[k])
    };
    let all: Vec<String> = (0..N).map(along).collect();
    all.join(", ")
}

/// A model in space.
fn solid_text(s: &Summary, bounds: &[[f64; 3]; 2], setup: &Setup, f: &Forecast) -> String {
    let mut text = format!(
        "  blocks     {} as given ({} held), {} at the start, sizes {} / {} / {} (smallest, median, \
         largest, as given)\n  patches    {}\n  region     {}; \
         mass {}\n",
        grouped(s.blocks as u64),
        grouped(s.supported as u64),
        grouped(f.blocks as u64),
        si(s.size[0], "m"),
        si(s.size[1], "m"),
        si(s.size[2], "m"),
        grouped(f.contacts as u64),
        region(&["x", "y", "z"], bounds),
        mass(s.mass, ""),
    );
    if let Setup::Spatial(setup) = setup {
        let before = |levels: u8, during: bool| match (levels, during) {
            (1, false) => "1 level".to_owned(),
            (1, true) => "1 level during the run".to_owned(),
            (n, false) => format!("{n} levels"),
            (n, true) => format!("{n} levels during the run"),
        };
        let all: Vec<String> =
            setup.refinements.iter().map(|r| before(r.levels, r.during.is_some())).collect();
        if !all.is_empty() {
            text.push_str(&format!("  splitting  {}\n", all.join(", ")));
        }
    }
    text.push_str(&passing_text(s));
    for joints in &s.joints {
        text.push_str(&format!("  joints     {joints}\n"));
    }
    for terrain in &s.terrain {
        text.push_str(&format!("  terrain    {terrain}\n"));
    }
    for fitted in &s.fitted {
        text.push_str(&format!("  fitted     {fitted}\n"));
    }
    for charge in &s.charges {
        text.push_str(&format!("  source     {}\n", charge_text(charge)));
    }
    text
}

/// A charge and the blocks that it replaces.
fn charge_text(charge: &Charge) -> String {
    let name = &charge.name;
    let removed = format!("{} of {}", counted(charge.blocks, "block"), cubic(charge.cavity));
    match (charge.mass, charge.volume, charge.ratio) {
        (Some(mass), Some(volume), Some(times)) => format!(
            "{name}: {} kg of {} in place of {removed} (Vc/V0 = {})",
            ratio(mass),
            cubic(volume),
            ratio(times)
        ),
        (_, _, _) => format!("{name}: a pressure in place of {removed}"),
    }
}

/// A volume in m3, a small one in litres.
fn cubic(volume: f64) -> String {
    if volume < 0.01 {
        format!("{} l", ratio(1e3 * volume))
    } else {
        format!("{} m3", ratio(volume))
    }
}

fn mass(kilograms: f64, per: &str) -> String {
    if kilograms >= 1000.0 {
        format!("{} t{per}", ratio(kilograms / 1000.0))
    } else {
        format!("{} kg{per}", ratio(kilograms))
    }
}

/// What a run will take; `before` is the CPU time until its first step, s.
fn expected_text(f: &Forecast, before: f64) -> String {
    let mut text = match (f.stable_time_step, f.share_of_stable) {
        (Some(stable), Some(share)) => format!(
            "  time step  {} = {} % of the stable {}",
            si(f.time_step, "s"),
            ratio(100.0 * share),
            si(stable, "s")
        ),
        (Some(stable), None) => format!(
            "  time step  none in the first, static phase; {} is stable in a dynamic phase",
            si(stable, "s")
        ),
        (None, _) => match f.longest_step {
            Some(longest) => format!(
                "  time step  {} at first, then longer towards equilibrium, at most {}",
                si(f.time_step, "s"),
                si(longest, "s")
            ),
            None => format!("  time step  {}", si(f.time_step, "s")),
        },
    };
    if let Some(block) = &f.governing_block {
        text.push_str(&format!(", governed by block {block}"));
    }
    text.push('\n');
    if let Some((block, speed)) = &f.fastest {
        let guard = if f.guard_shortens {
            "; the first steps are shortened to prevent tunnelling"
        } else {
            ""
        };
        text.push_str(&format!("  fastest    {} (block {block}){guard}\n", si(*speed, "m/s")));
    }
    text.extend(f.found.as_ref().map(found_text));
    if let Some(toe) = f.toe.as_ref().filter(|toe| toe.share > SLIGHT_TOE) {
        text.push_str(&format!(
            "  tilting    contact softness reduces by {} % the load that tilts block {} and the blocks that stand with it; a thousand times `{}` \
             reduces this to a tenth, without shorter steps in phases with `integration = \"implicit\"`\n",
            ratio(100.0 * toe.share),
            toe.block,
            toe.key
        ));
    }
    if let Some(of) = &f.reckoned {
        text.push_str(&format!(
            "  expected   {} {} steps, {} of CPU time (one thread, no records){}\n             from a trial of {} that reached {} of phase `{}`\n",
            if of.at_most { "at most" } else { "about" },
            grouped(rounded(of.steps)),
            about(of.cpu_time),
            before_text(before),
            duration(of.tried),
            si(of.reached, "s"),
            of.phase
        ));
        if let Some(rest) = of.rest {
            text.push_str(&format!(
                "             if the model rests {} after its phase began, as benches did: six times a fall from its height\n",
                si(rest, "s")
            ));
        }
        return text;
    }
    text.push_str(&format!(
        "  expected   {} at {} steps/s of CPU time (one thread, no records){}\n",
        steps_text(f),
        if f.steps_per_second < 10.0 {
            ratio(f.steps_per_second)
        } else {
            grouped(f.steps_per_second as u64)
        },
        before_text(before)
    ));
    if f.apart {
        text.push_str("             while the blocks are apart; several times longer once they rest on each other\n");
    } else if f.gives_way {
        text.push_str(
            "             while the joints are intact; loose blocks need shorter steps and more time per step\n",
        );
    }
    text
}

/// CPU time until the first step where it is worth a word.
fn before_text(before: f64) -> String {
    if before < NOTICED {
        return String::new();
    }
    format!(", {} before the first step", duration(before))
}

/// To two digits: what is reckoned has no more.
fn rounded(steps: u64) -> u64 {
    let unit = 10u64.pow(steps.max(1).ilog10().saturating_sub(1));
    steps.saturating_add(unit / 2) / unit * unit
}

/// `about 2 min 30 s`, `under 0.1 s`.
fn about(seconds: f64) -> String {
    match duration(seconds) {
        short if short.starts_with("under") => short,
        long => format!("about {long}"),
    }
}

/// Steps and time of a run.
fn steps_text(f: &Forecast) -> String {
    let time = |steps: u64| about(steps as f64 / f.steps_per_second);
    match (f.steps, f.iterations) {
        (Some(n), _) if f.tried_to_end => {
            format!("{} steps (a trial run finished), {}", grouped(n), time(n))
        }
        (Some(n), _) => match f.least_steps {
            _ if f.at_most => format!("at most {} steps of this length, {}", grouped(n), time(n)),
            Some(least) if least < n => format!(
                "at least {} steps, at most {} with permanent contact, {} to {}",
                grouped(least),
                grouped(n),
                time(least),
                duration(n as f64 / f.steps_per_second)
            ),
            // Contacts that are not there yet are not in the stable step.
            _ if f.apart || f.gives_way => {
                format!("at least {} steps, {} or more", grouped(n), time(n))
            }
            Some(_) | None => format!("{} steps, {}", grouped(n), time(n)),
        },
        (None, Some(n)) => format!(
            "an unknown number of steps, at most {} per load step of a static phase,",
            grouped(n)
        ),
        (None, None) => "an unknown number of steps".to_owned(),
    }
}

/// What blocks that can meet in space will be like.
fn found_text(found: &Outlook) -> String {
    let [flat, corner] = found.pressed.map(|share| ratio(100.0 * share));
    let (speed, height, block) = &found.stop_speed;
    let steps = found.steps.map_or(String::new(), |[step, time]| {
        format!(
            "; steps of {} or more in contact, {} per step in a heap",
            si(step, "s"),
            si(time, "s")
        )
    });
    let blocks = counted(found.blocks, "block");
    let fall = height.map_or(String::new(), |height| format!(", a fall of {}", si(height, "m")));
    format!(
        "  contact    {blocks} can come into contact; near at the start: {}, touching: {}{steps}\n             overlap under own weight \
         {flat} % of the size lying flat, {corner} % on a corner; without dashpots a cube's corner penetrates too far at {}{fall} (block {block})\n",
        counted(found.pairs, "pair"),
        grouped(found.touching as u64),
        si(*speed, "m/s"),
    )
}
