//! Runs a target over its corpus and over damaged copies of it.

use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use std::{fs, io};

use crate::damage::{self, Chance};
use crate::{Target, corpus};

/// A try that takes longer is a failure: what is large must be refused, or cost no more than it says.
const LIMIT: Duration = Duration::from_secs(20);
/// Address space of the process, bytes: what takes more ends it. Models that need as much are refused by name.
const MEMORY: u64 = 1 << 29;
/// Largest input, bytes.
const LARGEST: usize = 1 << 16;

/// What became of one input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It was taken.
    Taken,
    /// It was refused with an error.
    Refused,
    /// A panic, with its message, or too long a time.
    Failed(String),
}

/// The files that damage starts from.
#[derive(Clone, Debug, Default)]
pub struct Seeds {
    /// Paths and bytes, by name.
    pub files: Vec<(PathBuf, Vec<u8>)>,
}

/// What a campaign has found.
#[derive(Clone, Debug, Default)]
pub struct Tally {
    /// Files of the corpus that were taken as they are.
    pub sound: u64,
    /// Damaged inputs tried.
    pub tries: u64,
    /// Those that were taken.
    pub taken: u64,
    /// What failed: where it lies, and why.
    pub failures: Vec<(PathBuf, String)>,
}

/// Bounds the memory of this process, so that what takes it without bound ends it and not the machine.
///
/// # Errors
/// The system does not do it.
pub fn bound_memory() -> Result<(), String> {
    use nix::sys::resource::{Resource, setrlimit};
    setrlimit(Resource::RLIMIT_AS, MEMORY, MEMORY).map_err(|e| format!("no bound on memory: {e}"))
}

/// The corpus of a target.
///
/// # Errors
/// A folder cannot be read.
pub fn seeds(target: &Target) -> io::Result<Seeds> {
    let read = |path: PathBuf| fs::read(&path).map(|bytes| (path, bytes));
    let paths = corpus::all(target.name)?.into_iter();
    let mut files = paths.map(read).collect::<io::Result<Vec<_>>>()?;
    let made = (target.made)().into_iter().enumerate();
    files.extend(made.map(|(k, bytes)| (format!("made {k}").into(), bytes)));
    Ok(Seeds { files })
}

/// Tries one input. The message of a panic is caught, not printed.
#[must_use]
pub fn attempt(target: &Target, input: &[u8]) -> Outcome {
    // One at a time: the hook belongs to the process.
    static HOOK: Mutex<()> = Mutex::new(());
    let _alone = HOOK.lock();
    let said = Arc::new(Mutex::new(String::new()));
    let heard = Arc::clone(&said);
    let before = take_hook();
    set_hook(Box::new(move |panic| {
        let message = panic.payload_as_str().unwrap_or("a panic without words");
        if let Ok(mut said) = heard.lock() {
            message.clone_into(&mut said);
        }
    }));
    let begin = Instant::now();
    let done = catch_unwind(AssertUnwindSafe(|| (target.run)(input)));
    set_hook(before);
    let message = said.lock().map(|said| said.clone()).unwrap_or_default();
    match done {
        Ok(_) if begin.elapsed() > LIMIT => {
            Outcome::Failed(format!("it took {:.0} s", begin.elapsed().as_secs_f64()))
        }
        Ok(true) => Outcome::Taken,
        Ok(false) => Outcome::Refused,
        Err(_) => Outcome::Failed(message),
    }
}

/// Tries the corpus as it is, then damaged copies of it, and what was taken of these again; the same tries for the same seed. What fails
/// is kept in `target/fuzz/failures/TARGET`. Each input is written to the file `last` before it is tried: one that ends the process is
/// there afterwards.
#[must_use]
pub fn campaign(
    target: &Target,
    seeds: &Seeds,
    seed: u64,
    tries: u64,
    last: Option<&Path>,
) -> Tally {
    let before = |input: &[u8]| {
        if let Some(error) = last.and_then(|last| fs::write(last, input).err()) {
            eprintln!("the last input cannot be written: {error}");
        }
    };
    let mut chance = Chance::new(seed);
    let mut pool: Vec<Vec<u8>> = seeds.files.iter().map(|(_, bytes)| bytes.clone()).collect();
    let own = pool.len();
    let mut tally = Tally::default();
    // What was once a fault, and what reached code that others do not.
    for (place, input) in &seeds.files {
        before(input);
        match attempt(target, input) {
            Outcome::Taken => tally.sound += 1,
            Outcome::Refused => {}
            Outcome::Failed(why) => tally.failures.push((place.clone(), why)),
        }
    }
    for _ in 0..tries {
        let input = damaged(target, &pool, &mut chance);
        tally.tries += 1;
        before(&input);
        match attempt(target, &input) {
            Outcome::Refused => {}
            Outcome::Taken if target.sealed && !pool.contains(&input) => {
                let place = keep(target, tally.failures.len(), &input);
                tally.failures.push((place, "a damaged one was taken".to_owned()));
            }
            Outcome::Taken => {
                tally.taken += 1;
                // Damage upon damage goes where one change does not; the pool stays small and its beginning the corpus.
                if pool.len() < own + 64 {
                    pool.push(input);
                } else {
                    let at = own + chance.below(64);
                    pool[at] = input;
                }
            }
            Outcome::Failed(why) => {
                let place = keep(target, tally.failures.len(), &input);
                tally.failures.push((place, why));
                if tally.failures.len() >= 20 {
                    break;
                }
            }
        }
    }
    tally
}

fn damaged(target: &Target, pool: &[Vec<u8>], chance: &mut Chance) -> Vec<u8> {
    let Some(original) = pool.get(chance.below(pool.len())) else {
        return Vec::new();
    };
    let mut input = altered(target, original, chance);
    input.truncate(LARGEST);
    input
}

/// A damaged copy of an input of this target.
#[must_use]
pub fn altered(target: &Target, original: &[u8], chance: &mut Chance) -> Vec<u8> {
    match std::str::from_utf8(original) {
        // Most changes of a text are refused at once; a number goes far.
        Ok(text) if target.text && chance.below(2) == 0 => {
            damage::number(text, 0, chance).into_bytes()
        }
        Ok(text) if target.text || chance.below(3) > 0 => damage::text(text, chance),
        Ok(_) | Err(_) => damage::bytes(original, chance),
    }
}

/// Writes an input that failed; where it lies, or would.
fn keep(target: &Target, number: usize, input: &[u8]) -> PathBuf {
    let root = corpus::folder().join("../..");
    let folder = root.join("target/fuzz/failures").join(target.name);
    let place = folder.join(format!("failure-{number}"));
    if let Err(error) = fs::create_dir_all(&folder).and_then(|()| fs::write(&place, input)) {
        eprintln!("{} cannot be written: {error}", place.display());
    }
    place
}
