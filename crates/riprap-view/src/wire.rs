//! The binary answers: a JSON head that lists typed arrays, then the arrays.
//!
//! `u32` length of the head (little endian), the head, zeros up to a multiple of 8, then each array, padded to a
//! multiple of 8. The head is `{"info": ..., "arrays": [{"name", "type", "at", "length"}]}`; `at` counts bytes from the
//! end of the head's padding, `length` counts numbers. Everything is little endian.

use serde_json::{Value, json};

/// An answer being put together.
#[derive(Debug, Default)]
pub struct Wire {
    arrays: Vec<Value>,
    body: Vec<u8>,
}

impl Wire {
    /// Adds numbers of 32-bit floating point.
    pub fn f32(self, name: &str, values: &[f32]) -> Self {
        self.put(name, "f32", values, |v| v.to_le_bytes())
    }

    /// Adds numbers of 64-bit floating point.
    pub fn f64(self, name: &str, values: &[f64]) -> Self {
        self.put(name, "f64", values, |v| v.to_le_bytes())
    }

    /// Adds indices.
    pub fn u32(self, name: &str, values: &[u32]) -> Self {
        self.put(name, "u32", values, |v| v.to_le_bytes())
    }

    /// Adds numbers of 16 bits.
    pub fn i16(self, name: &str, values: &[i16]) -> Self {
        self.put(name, "i16", values, |v| v.to_le_bytes())
    }

    /// Adds bytes.
    pub fn u8(self, name: &str, values: &[u8]) -> Self {
        self.put(name, "u8", values, |v| [*v])
    }

    fn put<T, const N: usize>(
        mut self,
        name: &str,
        kind: &str,
        values: &[T],
        bytes: impl Fn(&T) -> [u8; N],
    ) -> Self {
        self.arrays.push(json!({
            "name": name, "type": kind, "at": self.body.len(), "length": values.len(),
        }));
        let from = self.body.len();
        self.body.resize(from + N * values.len(), 0);
        for (to, v) in self.body[from..].chunks_exact_mut(N).zip(values) {
            to.copy_from_slice(&bytes(v));
        }
        // Typed arrays of a page can only begin at multiples of the size of their numbers.
        pad(&mut self.body);
        self
    }

    /// The bytes, with whatever else there is to say.
    pub fn finish(self, info: &Value) -> Vec<u8> {
        let head = json!({ "info": info, "arrays": self.arrays }).to_string();
        let mut out = Vec::with_capacity(head.len() + self.body.len() + 16);
        // A head of 4 GiB cannot be: it has a few names.
        out.extend_from_slice(&u32::try_from(head.len()).unwrap_or(u32::MAX).to_le_bytes());
        out.extend_from_slice(head.as_bytes());
        pad(&mut out);
        out.extend_from_slice(&self.body);
        out
    }
}

fn pad(bytes: &mut Vec<u8>) {
    bytes.resize(bytes.len().next_multiple_of(8), 0);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrays_lie_where_the_head_says() {
        let bytes =
            Wire::default().u8("a", &[1, 2, 3]).f32("b", &[0.5, -2.0]).finish(&json!({ "k": 1 }));
        let length = u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]) as usize;
        let head: Value = serde_json::from_slice(&bytes[4..4 + length]).unwrap();
        let body = &bytes[(4 + length).next_multiple_of(8)..];
        assert_eq!(head["info"]["k"], 1);
        let at = head["arrays"][1]["at"].as_u64().unwrap() as usize;
        assert_eq!(body[at..at + 4], 0.5_f32.to_le_bytes());
        assert_eq!(at % 8, 0);
    }
}
