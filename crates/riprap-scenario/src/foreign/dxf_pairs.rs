//! Group codes and values of a DXF file, text or binary, one pair after the other.
//!
//! Source: Autodesk, "DXF Reference", "Group Code Value Types" and "Binary DXF Files".

use std::borrow::Cow;

use super::{FileError, MARK, Place, at_byte, at_line, shown};

/// First bytes of a binary file.
const SENTINEL: &[u8] = b"AutoCAD Binary DXF\r\n\x1a\0";

/// A value.
#[derive(Clone, Copy, Debug)]
pub(super) enum Value<'a> {
    /// Text, or a number in a text file.
    Written(&'a [u8]),
    /// Of a binary file.
    Whole(i64),
    /// Of a binary file.
    Real(f64),
}

impl<'a> Value<'a> {
    pub(super) fn text(self) -> Cow<'a, str> {
        match self {
            Value::Written(bytes) => String::from_utf8_lossy(bytes),
            Value::Whole(_) | Value::Real(_) => Cow::Borrowed(""),
        }
    }

    fn real(self) -> Option<f64> {
        let number = match self {
            Value::Written(bytes) => std::str::from_utf8(bytes).ok()?.parse().ok()?,
            Value::Whole(number) => number as f64,
            Value::Real(number) => number,
        };
        Some(number).filter(|x| x.is_finite())
    }

    fn whole(self) -> Option<i64> {
        match self {
            Value::Written(bytes) => std::str::from_utf8(bytes).ok()?.parse().ok(),
            Value::Whole(number) => Some(number),
            Value::Real(_) => None,
        }
    }
}

/// Letters of the bytes 0x80 to 0x9f in the code page 1252; those above are Latin-1.
const WESTERN: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}',
    '\u{90}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// A text with its letters for `\U+` and four digits.
fn spelled_out(text: &str) -> String {
    let mut parts = text.split("\\U+");
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let letter = part.get(..4).filter(|digits| digits.bytes().all(|b| b.is_ascii_hexdigit()));
        let letter = letter.and_then(|digits| u32::from_str_radix(digits, 16).ok());
        match letter.and_then(char::from_u32) {
            Some(letter) => {
                out.push(letter);
                out.push_str(&part[4..]);
            }
            // No letter: it stays as it stands.
            None => {
                out.push_str("\\U+");
                out.push_str(part);
            }
        }
    }
    out
}

/// How the pairs are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Coding {
    Text,
    /// Whether codes have two bytes (since release 13).
    Binary {
        wide: bool,
    },
}

/// A place in a file.
pub(super) struct Pairs<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Lines read so far.
    line: usize,
    /// Byte of the pair read last.
    start: usize,
    coding: Coding,
    /// Whether bytes that are no UTF-8 are letters of [`WESTERN`].
    western: bool,
}

impl<'a> Pairs<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let coding = match bytes.strip_prefix(SENTINEL) {
            // The first pair is 0 SECTION: its code is one byte or two.
            Some(rest) => Coding::Binary { wide: rest.get(1) == Some(&0) },
            None => Coding::Text,
        };
        Self {
            bytes,
            at: match coding {
                Coding::Text if bytes.starts_with(MARK) => MARK.len(),
                Coding::Text => 0,
                Coding::Binary { .. } => SENTINEL.len(),
            },
            line: 0,
            start: 0,
            coding,
            western: false,
        }
    }

    /// Place of the pair read last.
    pub(super) fn place(&self) -> Place {
        match self.coding {
            Coding::Text => Place::Line(self.line.max(1)),
            Coding::Binary { .. } => Place::Byte(self.start),
        }
    }

    /// An error at the pair read last.
    pub(super) fn wrong(&self, text: impl Into<String>) -> FileError {
        match self.place() {
            Place::Line(line) => at_line(line, text),
            Place::Byte(byte) => at_byte(byte, text),
        }
    }

    /// The next pair, or nothing at the end of the file.
    pub(super) fn next(&mut self) -> Result<Option<(i32, Value<'a>)>, FileError> {
        self.start = self.at;
        match self.coding {
            Coding::Text => {
                let Some(code) = self.text_line() else {
                    return Ok(None);
                };
                let number = std::str::from_utf8(code).ok().and_then(|c| c.parse().ok());
                let Some(number) = number else {
                    let code = shown(&String::from_utf8_lossy(code));
                    return Err(self.wrong(format!(
                        "a group code is expected, not {code:?}: this is not a DXF drawing, or it is damaged"
                    )));
                };
                match self.text_line() {
                    Some(value) => Ok(Some((number, Value::Written(value)))),
                    None => Err(self.cut_off()),
                }
            }
            Coding::Binary { wide } => {
                if self.at >= self.bytes.len() {
                    return Ok(None);
                }
                let code = if wide {
                    i32::from(i16::from_le_bytes(self.take()?))
                } else {
                    match u8::from_le_bytes(self.take()?) {
                        // A code that does not fit into one byte stands behind this one.
                        255 => i32::from(i16::from_le_bytes(self.take()?)),
                        code => i32::from(code),
                    }
                };
                Ok(Some((code, self.binary_value(code)?)))
            }
        }
    }

    /// A coordinate or another number.
    pub(super) fn real(&self, value: Value) -> Result<f64, FileError> {
        value.real().ok_or_else(|| {
            self.wrong(format!("a number is expected, not {:?}", shown(&value.text())))
        })
    }

    /// Takes note of the code page that the drawing names (`$DWGCODEPAGE`).
    pub(super) fn code_page(&mut self, value: Value) {
        self.western = value.text().eq_ignore_ascii_case("ANSI_1252");
    }

    /// A name as its letters: of UTF-8, else of the code page; letters may stand as `\U+00FC` in both. Bytes of a code page that is not
    /// known are written as `\xFC`, so that different names stay different.
    pub(super) fn name(&self, value: Value) -> String {
        let Value::Written(bytes) = value else {
            return String::new();
        };
        let Ok(text) = std::str::from_utf8(bytes) else {
            let letters = bytes.iter().map(|b| match b {
                0x80..=0x9f if self.western => WESTERN[usize::from(b - 0x80)].to_string(),
                0xa0.. if self.western => char::from(*b).to_string(),
                0x80.. => format!("\\x{b:02X}"),
                _ => char::from(*b).to_string(),
            });
            return spelled_out(&letters.collect::<String>());
        };
        spelled_out(text)
    }

    /// A whole number.
    pub(super) fn whole(&self, value: Value) -> Result<i64, FileError> {
        value.whole().ok_or_else(|| {
            let text = shown(&value.text());
            self.wrong(format!("an integer is expected, not {text:?}"))
        })
    }

    pub(super) fn cut_off(&self) -> FileError {
        self.wrong("the drawing ends here, before its EOF: it is truncated, or not a DXF drawing")
    }

    /// The next line, without blanks around it.
    fn text_line(&mut self) -> Option<&'a [u8]> {
        let rest = self.bytes.get(self.at..).filter(|rest| !rest.is_empty())?;
        let length = rest.iter().position(|b| *b == b'\n').unwrap_or(rest.len());
        self.at += length + 1;
        self.line += 1;
        Some(rest[..length].trim_ascii())
    }

    fn take<const N: usize>(&mut self) -> Result<[u8; N], FileError> {
        let part = self.bytes.get(self.at..self.at.saturating_add(N));
        let part = part.and_then(|part| part.try_into().ok());
        self.at += N;
        part.ok_or_else(|| self.cut_off())
    }

    fn binary_value(&mut self, code: i32) -> Result<Value<'a>, FileError> {
        Ok(match code {
            10..=59 | 110..=149 | 210..=239 | 460..=469 | 1010..=1059 => {
                Value::Real(f64::from_le_bytes(self.take()?))
            }
            60..=79 | 170..=179 | 270..=289 | 370..=389 | 400..=409 | 1060..=1070 => {
                Value::Whole(i64::from(i16::from_le_bytes(self.take()?)))
            }
            90..=99 | 420..=429 | 440..=459 | 1071 => {
                Value::Whole(i64::from(i32::from_le_bytes(self.take()?)))
            }
            160..=169 => Value::Whole(i64::from_le_bytes(self.take()?)),
            290..=299 => Value::Whole(i64::from(i8::from_le_bytes(self.take()?))),
            310..=319 | 1004 => {
                let [count] = self.take()?;
                let end = self.at + usize::from(count);
                let chunk = self.bytes.get(self.at..end).ok_or_else(|| self.cut_off())?;
                self.at = end;
                Value::Written(chunk)
            }
            _ => {
                let rest = self.bytes.get(self.at..).unwrap_or_default();
                let end = rest.iter().position(|b| *b == 0);
                let end = end.ok_or_else(|| self.cut_off())?;
                self.at += end + 1;
                Value::Written(rest[..end].trim_ascii())
            }
        })
    }
}
