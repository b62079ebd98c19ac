//! Answers as a table and in words.

use super::{Answer, Fitted, Test, Tested};

impl Fitted {
    /// `12.3 +- 0.4`, scaled.
    fn text(self, scale: f64) -> String {
        let value = scale * self.value;
        match self.error {
            // Two digits of the error, whatever its size.
            Some(error) => format!("{value:.4} +- {:.1e}", scale * error),
            None => format!("{value:.4}"),
        }
    }
}

impl Tested {
    fn row(&self) -> Vec<String> {
        let maybe = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
        vec![
            self.run.clone(),
            self.peak.to_string(),
            maybe(self.strain_at_peak),
            maybe(self.modulus),
            maybe(self.fit),
            self.residual.to_string(),
            maybe(self.confining),
            if self.at_end { "yes" } else { "no" }.to_owned(),
        ]
    }

    fn words(&self, test: Test) -> String {
        let what = match test {
            Test::Axial if self.confining.is_none_or(|s| s == 0.0) => "uniaxial strength",
            Test::Axial => "triaxial strength",
            Test::Disk { .. } => "Brazilian tensile strength",
            Test::Shear => "shear strength",
        };
        let mut text = format!("{}: {what} {:.4} MPa", self.run, 1e-6 * self.peak);
        if let Some(strain) = self.strain_at_peak {
            text.push_str(&format!(" at {strain:.4e}"));
        }
        if let Some(confining) = self.confining {
            let of = if test == Test::Shear { "normal" } else { "confining" };
            text.push_str(&format!(", {of} stress {:.4} MPa", 1e-6 * confining));
        }
        if let (Some(modulus), Some(fit)) = (self.modulus, self.fit) {
            text.push_str(&format!(", modulus {:.4} GPa (r2 {fit:.4})", 1e-9 * modulus));
        }
        if self.at_end {
            text.push_str("; still rising at the end: load it further for its strength");
        } else {
            text.push_str(&format!(", residual {:.4} MPa", 1e-6 * self.residual));
        }
        text
    }
}

impl Answer {
    /// The tests as CSV, SI.
    ///
    /// # Errors
    /// Never in practice: it is written to memory.
    pub fn table(&self) -> Result<Vec<u8>, csv::Error> {
        let mut out = csv::Writer::from_writer(Vec::new());
        out.write_record([
            "run",
            "peak_Pa",
            "strain_at_peak",
            "modulus_Pa",
            "r2",
            "residual_Pa",
            "confining_Pa",
            "at_end",
        ])?;
        for test in &self.tests {
            out.write_record(test.row())?;
        }
        out.into_inner().map_err(|error| error.into_error().into())
    }

    /// A line a test, then cohesion and friction.
    #[must_use]
    pub fn words(&self) -> String {
        let mut lines: Vec<String> = self.tests.iter().map(|test| test.words(self.test)).collect();
        if let Some(envelope) = &self.envelope {
            let mut line = format!(
                "cohesion {} MPa, friction angle {} deg",
                envelope.cohesion.text(1e-6),
                envelope.friction.text(1.0)
            );
            if self.test == Test::Axial {
                line.push_str(&format!(
                    ", uniaxial strength {} MPa",
                    envelope.unconfined.text(1e-6)
                ));
            }
            lines.push(line);
        }
        lines.join("\n")
    }
}
