//! A work folder and the command in it.

use std::io::Read;
use std::path::PathBuf;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// A block that falls onto a fixed one and bounces: 20 000 steps, a fraction of a second.
pub const FALL: &str = r#"
riprap = 1
title = "a block falls"

[space.planar]
gravity = ["0 m/s2", "-10 m/s2"]

[materials.rock]
density = "2000 kg/m3"

[interfaces.default]
normal_stiffness = "100 MPa/m"
friction_angle = "30 deg"

[[blocks]]
name = "floor"
material = "rock"
rectangle = { size = ["4 m", "1 m"], corner = ["-2 m", "-1 m"] }

[[blocks]]
name = "stone"
material = "rock"
rectangle = { size = ["1 m", "1 m"], corner = ["-0.5 m", "0.2 m"] }
velocity = ["0 m/s", "0 m/s"]

[[supports]]
on = { block = "floor" }
fixed = {}

[[phases]]
name = "fall"
until = { time = "0.2 s" }
time_step = "10 us"

[[outputs]]
history = { name = "height", field = "block.displacement.y", of = "stone", every = "1 ms" }
[[outputs]]
frames = { every = "50 ms" }
[[outputs]]
checkpoints = { every = "20 ms" }

[bisect]
key = "blocks.stone.velocity.1"
low = "-10 m/s"
high = "0 m/s"
tolerance = "1 m/s"
fails_when = { field = "model.max_speed", reduce = "max", above = "6 m/s" }

[[checks]]
name = "free fall"
field = "block.displacement.y"
of = "stone"
at = "0.1 s"
formula = "-0.5*10*t^2"
relative = 1e-6
"#;

/// A temporary folder in which commands run; gone when dropped.
pub struct Bench {
    folder: tempfile::TempDir,
}

/// What a command said and how it ended.
#[derive(Debug)]
pub struct Said {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

impl Bench {
    pub fn new() -> Self {
        Bench { folder: tempfile::tempdir().expect("a temporary folder") }
    }

    /// In memory where the machine has such a folder: runs with a checkpoint every few steps otherwise wait for the disk.
    pub fn in_memory() -> Self {
        tempfile::tempdir_in("/dev/shm").map_or_else(|_| Bench::new(), |folder| Bench { folder })
    }

    /// With `fall.toml` in it.
    pub fn with_scene() -> Self {
        let bench = Bench::new();
        bench.file("fall.toml", FALL);
        bench
    }

    /// With a scene that takes far longer than any test waits.
    pub fn with_long_scene() -> Self {
        let bench = Bench::new();
        bench.file("long.toml", FALL.replace("time = \"0.2 s\"", "time = \"2000 s\""));
        bench
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Writes a file into the folder.
    pub fn file(&self, name: &str, text: impl AsRef<[u8]>) -> PathBuf {
        let path = self.path(name);
        std::fs::write(&path, text).expect("write a test file");
        path
    }

    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    /// The whole checkpoints of a run, the newest last.
    pub fn checkpoints(&self, run: &str) -> Vec<PathBuf> {
        let Ok(files) = self.path(run).join("checkpoints").read_dir() else {
            return Vec::new();
        };
        let mut files: Vec<_> = files
            .map(|file| file.expect("an entry").path())
            .filter(|file| file.extension().is_some_and(|e| e == "rck"))
            .collect();
        files.sort();
        files
    }

    /// The command, not yet started.
    pub fn command(&self, words: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_riprap"));
        command.args(words).current_dir(self.folder.path()).env_remove("NO_COLOR");
        command
    }

    /// Runs the command to its end.
    pub fn run(&self, words: &[&str]) -> Said {
        Said::from(self.command(words).output().expect("start riprap"))
    }

    /// Starts the command and leaves it running.
    pub fn start(&self, words: &[&str]) -> Running {
        let mut command = self.command(words);
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        Running { child: command.spawn().expect("start riprap") }
    }

    /// Waits until `there` holds.
    #[track_caller]
    pub fn wait_for(&self, what: &str, there: impl Fn() -> bool) {
        let begun = Instant::now();
        while !there() {
            assert!(begun.elapsed() < Duration::from_secs(60), "waited in vain for {what}");
            std::thread::sleep(Duration::from_millis(20));
        }
    }
}

/// A command that runs; killed when dropped.
pub struct Running {
    child: Child,
}

impl Running {
    /// Sends a signal by its name, as `kill` does.
    pub fn signal(&self, name: &str) {
        // The shell's own `kill`: small systems have no other.
        let line = format!("kill -{name} {}", self.child.id());
        let done = Command::new("sh").args(["-c", &line]).status();
        assert!(done.is_ok_and(|s| s.success()), "{line}");
    }

    /// Waits for the end.
    pub fn end(mut self) -> Said {
        let (mut out, mut err) = (String::new(), String::new());
        if let Some(mut pipe) = self.child.stdout.take() {
            pipe.read_to_string(&mut out).expect("read stdout");
        }
        if let Some(mut pipe) = self.child.stderr.take() {
            pipe.read_to_string(&mut err).expect("read stderr");
        }
        let code = self.child.wait().expect("wait for riprap").code();
        Said { code, out, err }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // It may have ended already.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl From<Output> for Said {
    fn from(output: Output) -> Self {
        Said {
            code: output.status.code(),
            out: String::from_utf8_lossy(&output.stdout).into_owned(),
            err: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }
}

impl Said {
    /// Panics with everything that was said unless the exit code is `code`.
    #[track_caller]
    pub fn expect(self, code: i32) -> Self {
        assert_eq!(
            self.code,
            Some(code),
            "\n-- stdout --\n{}\n-- stderr --\n{}",
            self.out,
            self.err
        );
        self
    }

    /// Panics unless stdout holds all `parts`.
    #[track_caller]
    pub fn says(self, parts: &[&str]) -> Self {
        for part in parts {
            assert!(self.out.contains(part), "no {part:?} in\n{}", self.out);
        }
        self
    }

    /// Panics unless stderr holds all `parts`.
    #[track_caller]
    pub fn warns(self, parts: &[&str]) -> Self {
        for part in parts {
            assert!(self.err.contains(part), "no {part:?} in\n{}", self.err);
        }
        self
    }
}
