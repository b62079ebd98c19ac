//! Numbers of a .msh file one after the other, as text or in binary, with the place of what is wrong.

/// Where something is wrong in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Line of a text file, counted from 1.
    Line(usize),
    /// Byte of a binary file, counted from 0.
    Byte(usize),
}

impl std::fmt::Display for Place {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Line(line) => write!(out, "line {line}"),
            Self::Byte(byte) => write!(out, "byte {byte}"),
        }
    }
}

/// What is wrong with a file, and where.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{place}: {text}")]
pub struct FileError {
    /// Where.
    pub place: Place,
    /// What is wrong and what to do about it.
    pub text: String,
}

/// How numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Coding {
    Text,
    /// Whether the bytes of a number are turned round.
    Binary {
        swapped: bool,
    },
}

/// A place in a file.
pub(super) struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Start of what was read last.
    start: usize,
    pub(super) coding: Coding,
}

impl<'a> Reader<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0, start: 0, coding: Coding::Text }
    }

    /// An error at what was read last.
    pub(super) fn wrong(&self, text: impl Into<String>) -> FileError {
        let start = self.start.min(self.bytes.len());
        let place = match self.coding {
            Coding::Text => {
                // Counted only when there is something to say, not at each word.
                let lines = self.bytes[..start].iter().filter(|b| **b == b'\n').count();
                Place::Line(lines + 1)
            }
            Coding::Binary { .. } => Place::Byte(start),
        };
        FileError { place, text: text.into() }
    }

    /// The next word of text, or nothing at the end of the file.
    pub(super) fn word(&mut self) -> Option<&'a str> {
        while self.bytes.get(self.at).is_some_and(u8::is_ascii_whitespace) {
            self.at += 1;
        }
        self.start = self.at;
        while self.bytes.get(self.at).is_some_and(|b| !b.is_ascii_whitespace()) {
            self.at += 1;
        }
        let word = &self.bytes[self.start..self.at];
        // What is not text is no number and no name either.
        (!word.is_empty()).then(|| std::str::from_utf8(word).unwrap_or("\u{fffd}"))
    }

    fn text<T: std::str::FromStr>(&mut self, what: &str, kind: &str) -> Result<T, FileError> {
        let Some(word) = self.word() else {
            return Err(self.wrong(format!("the file ends where {what} should be")));
        };
        word.parse().map_err(|_| {
            let shown: String = word.chars().take(40).collect();
            self.wrong(format!("{what} is {shown:?}; it must be {kind}"))
        })
    }

    fn binary<const N: usize>(&mut self, what: &str, swapped: bool) -> Result<[u8; N], FileError> {
        self.start = self.at;
        let Some(part) = self.bytes.get(self.at..self.at + N) else {
            return Err(self.wrong(format!("the file ends where {what} should be")));
        };
        self.at += N;
        let mut bytes = [0; N];
        bytes.copy_from_slice(part);
        if swapped {
            bytes.reverse();
        }
        Ok(bytes)
    }

    /// A whole number of 4 bytes.
    pub(super) fn int(&mut self, what: &str) -> Result<i32, FileError> {
        match self.coding {
            Coding::Text => self.text(what, "an integer"),
            Coding::Binary { swapped } => Ok(i32::from_le_bytes(self.binary(what, swapped)?)),
        }
    }

    /// A count or tag of 8 bytes.
    pub(super) fn size(&mut self, what: &str) -> Result<u64, FileError> {
        match self.coding {
            Coding::Text => self.text(what, "an integer, 0 or above"),
            Coding::Binary { swapped } => Ok(u64::from_le_bytes(self.binary(what, swapped)?)),
        }
    }

    /// A number, which is finite.
    pub(super) fn number(&mut self, what: &str) -> Result<f64, FileError> {
        let x = match self.coding {
            Coding::Text => self.text(what, "a number")?,
            Coding::Binary { swapped } => f64::from_le_bytes(self.binary(what, swapped)?),
        };
        if !f64::is_finite(x) {
            return Err(self.wrong(format!("{what} is {x}, which is not finite")));
        }
        Ok(x)
    }

    /// Checks that `count` things of at least `bytes` bytes each can still come: a count is never trusted with memory.
    pub(super) fn room(&self, count: u64, bytes: u64, what: &str) -> Result<usize, FileError> {
        let left = (self.bytes.len() - self.at) as u64;
        if count > left / bytes {
            return Err(self.wrong(format!(
                "{count} {what} are declared, but only {left} bytes follow: the file is truncated or damaged"
            )));
        }
        Ok(count as usize)
    }

    /// A section name that begins with `$`, or nothing at the end.
    pub(super) fn section(&mut self) -> Result<Option<&'a str>, FileError> {
        let Some(word) = self.word() else {
            return Ok(None);
        };
        match word.strip_prefix('$') {
            Some(name) if !name.is_empty() => Ok(Some(name)),
            _ => {
                let shown: String = word.chars().take(40).collect();
                Err(self.wrong(format!("a section such as $Nodes is expected, not {shown:?}")))
            }
        }
    }

    /// The end of a section.
    pub(super) fn end(&mut self, name: &str) -> Result<(), FileError> {
        let word = self.word();
        if word.and_then(|w| w.strip_prefix("$End")) == Some(name) {
            return Ok(());
        }
        let found: String = word.unwrap_or("the end of the file").chars().take(40).collect();
        Err(self.wrong(format!("$End{name} is expected, not {found:?}")))
    }

    /// Goes behind the end of a section that is not needed.
    pub(super) fn skip(&mut self, name: &str) -> Result<(), FileError> {
        let end = format!("$End{name}");
        let rest = &self.bytes[self.at..];
        // Its words are not read: in a binary file they may be anything.
        let found = rest.windows(end.len()).position(|w| w == end.as_bytes());
        match found {
            Some(place) => {
                self.at += place + end.len();
                Ok(())
            }
            None => Err(self.wrong(format!("the section ${name} has no {end}"))),
        }
    }

    /// Goes behind the next line break.
    pub(super) fn next_line(&mut self) {
        while let Some(b) = self.bytes.get(self.at) {
            self.at += 1;
            if *b == b'\n' {
                break;
            }
        }
    }

    /// Goes behind the line break before binary data.
    pub(super) fn skip_to_data(&mut self) {
        if matches!(self.coding, Coding::Binary { .. }) {
            self.next_line();
        }
    }

    /// The rest of the line, without blanks around it.
    pub(super) fn line(&mut self) -> String {
        self.start = self.at;
        self.next_line();
        String::from_utf8_lossy(&self.bytes[self.start..self.at]).trim().to_owned()
    }

    /// Runs `f` on numbers written as text, whatever the rest of the file is written in.
    pub(super) fn as_text<T>(
        &mut self,
        f: impl FnOnce(&mut Self) -> Result<T, FileError>,
    ) -> Result<T, FileError> {
        let coding = std::mem::replace(&mut self.coding, Coding::Text);
        let result = f(self);
        self.coding = coding;
        result
    }
}
