//! Answers as tables, words and files.

use std::path::Path;

use super::{Answer, Passage, Ranks, Rock};
use crate::record::{OutputError, write_whole};

/// The rocks, in the folder of the answer.
const ROCKS: &str = "rocks.csv";
/// The lines.
const LINES: &str = "lines.csv";
/// The passages.
const PASSAGES: &str = "passages.csv";
/// Share of the rocks that go at least so far.
const REACH: &str = "reach.csv";
/// All numbers.
const SUMMARY: &str = "runout.json";

type Written = Result<Vec<u8>, csv::Error>;

/// Rows under heads.
fn table(heads: &[&str], rows: impl Iterator<Item = Vec<String>>) -> Written {
    let mut out = csv::Writer::from_writer(Vec::new());
    out.write_record(heads)?;
    for row in rows {
        out.write_record(row)?;
    }
    out.into_inner().map_err(|error| error.into_error().into())
}

fn maybe(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

fn ranks(of: Option<Ranks>) -> [String; 3] {
    [of.map(|r| r.half), of.map(|r| r.most), of.map(|r| r.largest)].map(maybe)
}

impl Rock {
    fn row(&self) -> Vec<String> {
        let mut row = vec![self.run.clone(), self.name.clone(), maybe(self.mass)];
        row.extend(self.start.iter().chain(&self.end).map(f64::to_string));
        row.extend(
            [self.runout, self.drop, self.travel_angle, self.max_speed].map(|v| v.to_string()),
        );
        row.extend([maybe(self.max_height), maybe(self.max_energy), self.end_speed.to_string()]);
        row
    }
}

impl Passage {
    fn row(&self) -> Vec<String> {
        let mut row = vec![self.line.clone(), self.run.clone(), self.rock.clone()];
        row.push(self.time.to_string());
        row.extend(self.at.map(|v| v.to_string()));
        row.extend([maybe(self.height), self.speed.to_string(), maybe(self.energy)]);
        row
    }
}

impl Answer {
    /// The rocks as CSV, SI.
    ///
    /// # Errors
    /// Never in practice: it is written to memory.
    pub fn rocks_table(&self) -> Written {
        let heads = [
            "run",
            "rock",
            "mass_kg",
            "start_x_m",
            "start_y_m",
            "start_z_m",
            "end_x_m",
            "end_y_m",
            "end_z_m",
            "runout_m",
            "drop_m",
            "travel_angle_deg",
            "max_speed_m_s",
            "max_height_m",
            "max_energy_J",
            "end_speed_m_s",
        ];
        table(&heads, self.rocks.iter().map(Rock::row))
    }

    /// The first passages as CSV, SI.
    ///
    /// # Errors
    /// Never in practice: it is written to memory.
    pub fn passages_table(&self) -> Written {
        let heads = [
            "line",
            "run",
            "rock",
            "time_s",
            "x_m",
            "y_m",
            "z_m",
            "height_m",
            "speed_m_s",
            "energy_J",
        ];
        table(&heads, self.passages.iter().map(Passage::row))
    }

    /// The lines as CSV, SI.
    ///
    /// # Errors
    /// Never in practice: it is written to memory.
    pub fn lines_table(&self) -> Written {
        let heads = [
            "line",
            "rocks",
            "passed",
            "share",
            "share_low",
            "share_high",
            "height_50_m",
            "height_90_m",
            "height_max_m",
            "speed_50_m_s",
            "speed_90_m_s",
            "speed_max_m_s",
            "energy_50_J",
            "energy_90_J",
            "energy_max_J",
        ];
        let rows = self.lines.iter().map(|line| {
            let mut row = vec![line.line.clone(), line.rocks.to_string(), line.passed.to_string()];
            row.extend([line.share, line.interval[0], line.interval[1]].map(|v| v.to_string()));
            row.extend([line.height, line.speed, line.energy].map(ranks).into_iter().flatten());
            row
        });
        table(&heads, rows)
    }

    /// Run-outs with the share of the rocks that go at least so far, as CSV.
    ///
    /// # Errors
    /// Never in practice: it is written to memory.
    pub fn reach_table(&self) -> Written {
        let mut ways: Vec<f64> = self.rocks.iter().map(|rock| rock.runout).collect();
        ways.sort_by(f64::total_cmp);
        let count = ways.len();
        let rows = ways
            .iter()
            .enumerate()
            .map(|(k, way)| vec![way.to_string(), ((count - k) as f64 / count as f64).to_string()]);
        table(&["runout_m", "share"], rows)
    }

    /// Writes all tables into a folder.
    ///
    /// # Errors
    /// The disk.
    pub fn write(&self, folder: &Path) -> Result<(), OutputError> {
        let tables = [
            (ROCKS, self.rocks_table()),
            (REACH, self.reach_table()),
            (LINES, self.lines_table()),
            (PASSAGES, self.passages_table()),
        ];
        for (name, table) in tables {
            let about_lines = name == LINES || name == PASSAGES;
            if about_lines && self.lines.is_empty() {
                continue;
            }
            let path = folder.join(name);
            let text = table.map_err(|e| OutputError { path: path.clone(), source: e.into() })?;
            write_whole(&path, &text)?;
        }
        let text = serde_json::to_string_pretty(self).unwrap_or_default();
        write_whole(&folder.join(SUMMARY), text.as_bytes())
    }

    /// The rock with the largest of something.
    fn most(&self, get: impl Fn(&Rock) -> Option<f64>) -> Option<(f64, &str)> {
        let all = self.rocks.iter().filter_map(|rock| Some((get(rock)?, rock.name.as_str())));
        all.max_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// What a reader asks first, a line each.
    #[must_use]
    pub fn words(&self) -> String {
        let s = |n: usize| if n == 1 { "" } else { "s" };
        let (rocks, runs) = (self.rocks.len(), self.runs);
        let mut text = format!(
            "{rocks} rock{} of {runs} run{}\nrun-out: median {:.3} m, 90th percentile {:.3} m, maximum {:.3} m; smallest travel angle {:.1} deg",
            s(rocks),
            s(runs),
            self.runout.half,
            self.runout.most,
            self.runout.largest,
            self.least_angle,
        );
        if let Some((speed, rock)) = self.most(|rock| Some(rock.max_speed)) {
            text.push_str(&format!("\nfastest: {speed:.3} m/s ({rock})"));
        }
        if let Some((height, rock)) = self.most(|rock| rock.max_height) {
            text.push_str(&format!("; highest above the ground: {height:.3} m ({rock})"));
        }
        for line in &self.lines {
            let [low, high] = line.interval.map(|share| 100.0 * share);
            text.push_str(&format!(
                "\n{}: {} of {} rocks pass, {:.1} % ({low:.1} .. {high:.1} %)",
                line.line,
                line.passed,
                line.rocks,
                100.0 * line.share,
            ));
            let parts = [
                ("height", line.height, 1.0, "m"),
                ("speed", line.speed, 1.0, "m/s"),
                ("energy", line.energy, 1e-3, self.energy_unit()),
            ];
            for (what, of, scale, unit) in parts {
                if let Some(Ranks { half, most, largest }) = of {
                    text.push_str(&format!(
                        "; {what} median {:.3}, 90th percentile {:.3}, maximum {:.3} {unit}",
                        scale * half,
                        scale * most,
                        scale * largest,
                    ));
                }
            }
        }
        if self.moving > 0 {
            text.push_str(&format!(
                "\nstill moving at the end: {}; their run-out is not final",
                self.moving
            ));
        }
        text
    }

    fn energy_unit(&self) -> &'static str {
        if self.planar { "kJ/m" } else { "kJ" }
    }
}
