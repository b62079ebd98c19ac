//! The program under attack.

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// A try that takes longer is stopped.
pub const LIMIT: Duration = Duration::from_secs(20);
/// Address space of a try, kB: the program must refuse what does not fit, not take it.
const MEMORY: &str = "4000000";

/// The program.
pub struct Program {
    binary: PathBuf,
}

/// How a try ended.
#[derive(Debug)]
pub struct Ended {
    /// Exit code; `None` after a signal or when it was stopped.
    pub code: Option<i32>,
    pub slow: bool,
    /// The last of what it said on standard error.
    pub said: String,
    /// What it printed.
    pub printed: String,
}

impl Ended {
    /// What is wrong with the way it ended.
    pub fn wrong(&self) -> Option<String> {
        match self.code {
            _ if self.slow => None,
            Some(0..=3) if !self.said.contains("panicked") => None,
            code => {
                let said = self.said.lines().find(|l| l.contains("panicked"));
                Some(format!("exit {code:?}: {}", said.or(self.said.lines().last()).unwrap_or("")))
            }
        }
    }
}

impl Program {
    pub fn new(binary: &Path) -> Self {
        Self { binary: binary.to_owned() }
    }

    /// Its file.
    pub fn path(&self) -> &Path {
        &self.binary
    }

    /// A command in `folder`, with little memory; what it says goes into a file.
    fn command(&self, folder: &Path, words: &[&str]) -> Result<Command, String> {
        let file = |name| std::fs::File::create(folder.join(name)).map_err(|e| e.to_string());
        let (printed, said) = (file("printed.txt")?, file("said.txt")?);
        let mut command = Command::new("sh");
        command
            .args(["-c", &format!("ulimit -v {MEMORY}; exec \"$@\""), "sh"])
            .arg(&self.binary)
            .args(words)
            .current_dir(folder)
            .env("RUST_BACKTRACE", "0")
            .stdin(Stdio::null())
            .stdout(printed)
            .stderr(said);
        Ok(command)
    }

    /// Starts it.
    ///
    /// # Errors
    /// What the system says.
    pub fn start(&self, folder: &Path, words: &[&str]) -> Result<Child, String> {
        let child = self.command(folder, words)?.spawn();
        child.map_err(|e| format!("{}: {e}", self.binary.display()))
    }

    /// Runs it to its end, at most for the limit.
    ///
    /// # Errors
    /// What the system says.
    pub fn run(&self, folder: &Path, words: &[&str]) -> Result<Ended, String> {
        self.run_within(folder, words, LIMIT)
    }

    /// Runs it to its end, at most for `limit`.
    ///
    /// # Errors
    /// What the system says.
    pub fn run_within(
        &self,
        folder: &Path,
        words: &[&str],
        limit: Duration,
    ) -> Result<Ended, String> {
        self.run_with(folder, words, limit, &[])
    }

    /// The same with these variables in its environment.
    ///
    /// # Errors
    /// What the system says.
    pub fn run_with(
        &self,
        folder: &Path,
        words: &[&str],
        limit: Duration,
        variables: &[(&str, &Path)],
    ) -> Result<Ended, String> {
        let mut command = self.command(folder, words)?;
        let child = command.envs(variables.iter().copied()).spawn();
        let mut child = child.map_err(|e| format!("{}: {e}", self.binary.display()))?;
        let begun = Instant::now();
        let (code, slow) = loop {
            if let Some(status) = child.try_wait().map_err(|e| e.to_string())? {
                break (status.code(), false);
            }
            if begun.elapsed() > limit {
                child.kill().map_err(|e| e.to_string())?;
                child.wait().map_err(|e| e.to_string())?;
                break (None, true);
            }
            std::thread::sleep(Duration::from_millis(1));
        };
        let read = |name| std::fs::read(folder.join(name)).unwrap_or_default();
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        let said = read("said.txt");
        let said = text(&said[said.len().saturating_sub(4000)..]);
        Ok(Ended { code, slow, said, printed: text(&read("printed.txt")) })
    }

    /// What it prints.
    ///
    /// # Errors
    /// It does not end with success.
    pub fn answer(&self, folder: &Path, words: &[&str]) -> Result<String, String> {
        let output = Command::new(&self.binary)
            .args(words)
            .current_dir(folder)
            .stdin(Stdio::null())
            .output()
            .map_err(|e| e.to_string())?;
        if !output.status.success() {
            return Err(format!(
                "riprap {}: {}",
                words.join(" "),
                String::from_utf8_lossy(&output.stderr)
            ));
        }
        Ok(String::from_utf8_lossy(&output.stdout).trim().to_owned())
    }
}
