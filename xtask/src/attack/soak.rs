//! A run that never ends beside a viewer that follows it: what both take of memory and descriptors.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use super::{Field, Found};
use riprap_fuzz::damage::Chance;

const SCENE: &str = "scenes/bench/soak.toml";
/// Between two looks at both.
const LOOK: Duration = Duration::from_secs(10);
/// What the viewer may take at most to answer one question.
const PATIENCE: Duration = Duration::from_secs(20);
/// What the page of the viewer asks.
const QUESTIONS: [&str; 5] =
    ["summary", "frame/0", "field/0?name=velocity", "table/histories", "table/energy"];
/// Growth of memory over the last quarter, as a share, from which on it is a failure.
const GROWTH: f64 = 0.05;

/// A process that ends with this.
struct Ends(Child);

impl Drop for Ends {
    fn drop(&mut self) {
        // One that has ended already cannot be killed; nothing else can go wrong here that anybody could cure.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// Resident memory, MB, and open descriptors of a process.
type Taken = (f64, usize);

/// A look every ten seconds, `--tries 9000` for an hour. Skipped, with a line, where there is no `/proc`.
pub fn soak(field: &Field<'_>, _: &mut Chance) -> Result<Found, String> {
    let mut found = Found::default();
    if !cfg!(target_os = "linux") {
        println!("long run skipped: this system has no /proc");
        return Ok(found);
    }
    let scene = field.root.join(SCENE).to_string_lossy().into_owned();
    let words = ["run", &scene, "--quiet", "--threads", "1", "--out", "soak.run"];
    let mut run = Ends(field.program.start(&field.folder, &words)?);
    std::thread::sleep(LOOK);
    let mut view = Command::new(field.program.path());
    view.args(["view", "--no-open", "soak.run"]).current_dir(&field.folder);
    let view = view.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null()).spawn();
    let mut view = Ends(view.map_err(|e| format!("riprap view: {e}"))?);
    let address = address(&mut view.0)?;
    let mut looks: [Vec<Taken>; 2] = Default::default();
    for _ in 0..field.tries.div_ceil(25) {
        found.tries += 1;
        std::thread::sleep(LOOK);
        if let Some(code) = run.0.try_wait().map_err(|e| e.to_string())? {
            found.failures.push(format!("the run ended by itself: {code}"));
            return Ok(found);
        }
        let asked = QUESTIONS.map(|q| ask(&address, q).map_err(|why| format!("{q}: {why}")));
        found.failures.extend(asked.into_iter().filter_map(Result::err));
        for (looks, process) in looks.iter_mut().zip([&run, &view]) {
            looks.push(taken(process.0.id())?);
        }
    }
    for (who, looks) in ["the run", "the viewer"].into_iter().zip(&looks) {
        let (memory, descriptors) = looks.last().copied().unwrap_or_default();
        println!("{who}: {memory:.1} MB and {descriptors} descriptors at the end");
        found.failures.extend(grown(who, looks));
    }
    Ok(found)
}

/// What the viewer says of where it is.
fn address(view: &mut Child) -> Result<String, String> {
    let said = view.stdout.take().ok_or("the viewer has no output")?;
    let lines = BufReader::new(said).lines().map_while(Result::ok).take(20);
    let found = lines.filter_map(|line| line.split("http://").nth(1).map(str::to_owned)).next();
    let found = found.ok_or("the viewer did not say where it is")?;
    Ok(found.split_whitespace().next().unwrap_or_default().trim_end_matches('/').to_owned())
}

/// Asks the viewer one question and reads the answer to its end.
fn ask(address: &str, question: &str) -> Result<(), String> {
    let (host, path) = address.split_once('/').unwrap_or((address, ""));
    let failed = |e: std::io::Error| e.to_string();
    let mut stream = TcpStream::connect(host).map_err(failed)?;
    stream.set_read_timeout(Some(PATIENCE)).map_err(failed)?;
    let head = format!("GET /{path}/api/0/{question} HTTP/1.1\r\nHost: {host}\r\n");
    stream.write_all(format!("{head}Connection: close\r\n\r\n").as_bytes()).map_err(failed)?;
    let mut answer = Vec::new();
    stream.read_to_end(&mut answer).map_err(failed)?;
    match answer.starts_with(b"HTTP/1.1 200") {
        true => Ok(()),
        false => Err(String::from_utf8_lossy(&answer).lines().next().unwrap_or("").to_owned()),
    }
}

fn taken(id: u32) -> Result<Taken, String> {
    let text = super::read_text(format!("/proc/{id}/status").as_ref())?;
    let line = text.lines().find_map(|l| l.strip_prefix("VmRSS:"));
    let kilobytes = line.and_then(|l| l.split_whitespace().next()?.parse::<f64>().ok());
    let open = std::fs::read_dir(format!("/proc/{id}/fd")).map_err(|e| e.to_string())?;
    Ok((kilobytes.ok_or("no VmRSS")? / 1000.0, open.count()))
}

/// What has grown from the third quarter to the last.
fn grown(who: &str, looks: &[Taken]) -> Vec<String> {
    let (third, last) = looks.split_at(3 * looks.len() / 4);
    let third = &third[third.len().min(looks.len() / 2)..];
    if third.is_empty() || last.is_empty() {
        return vec![format!("{who} was looked at too seldom")];
    }
    let memory = |part: &[Taken]| part.iter().map(|t| t.0).fold(0.0, f64::max);
    // Files are opened for a moment: what leaks stays open, and raises the fewest.
    let open = |part: &[Taken]| part.iter().map(|t| t.1).min().unwrap_or(0);
    let mut grown = Vec::new();
    if memory(last) > (1.0 + GROWTH) * memory(third) {
        grown.push(format!("memory of {who}: from {:.1} to {:.1} MB", memory(third), memory(last)));
    }
    if open(last) > open(third) {
        grown.push(format!("descriptors of {who}: from {} to {}", open(third), open(last)));
    }
    grown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_of_memory_and_descriptors_is_reported() {
        let looks = |end: Taken| [&[(10.0, 9); 12][..], &[end; 4]].concat();
        assert!(grown("x", &looks((10.4, 9))).is_empty());
        assert_eq!(grown("x", &looks((10.6, 9))), ["memory of x: from 10.0 to 10.6 MB"]);
        assert_eq!(grown("x", &looks((10.0, 10))), ["descriptors of x: from 9 to 10"]);
        assert_eq!(grown("x", &[]).len(), 1);
    }
}
