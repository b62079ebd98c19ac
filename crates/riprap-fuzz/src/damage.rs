//! Damage: numbers that look like chance, and what they do to bytes and texts.

/// Numbers that look like chance, the same for the same seed.
#[derive(Clone, Debug)]
pub struct Chance(u64);

impl Chance {
    /// The stream of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        let mut chance = Self(seed);
        // The first numbers of neighbouring seeds are nearly the same.
        chance.below(2);
        chance
    }

    /// A whole number below `limit`, or 0.
    pub fn below(&mut self, limit: usize) -> usize {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        // The low bits of such a generator repeat soon.
        usize::try_from(self.0 >> 33).unwrap_or(0) % limit.max(1)
    }

    /// One of a list that is not empty.
    pub fn of<'a, T>(&mut self, list: &'a [T]) -> &'a T {
        &list[self.below(list.len())]
    }
}

/// Numbers that no model means.
pub const SILLY: [&str; 16] = [
    "nan",
    "inf",
    "-inf",
    "1e308",
    "-1e308",
    "1e-320",
    "0",
    "-0.0",
    "-1",
    "1e18",
    "-1e-300",
    "1e999",
    "9223372036854775807",
    "-9223372036854775808",
    "0.1",
    "1e6",
];

/// Words that mean something to a reader.
const WORDS: [&str; 22] = [
    "=",
    "[[blocks]]",
    "[phases]",
    "\"",
    "'''",
    "{",
    "}",
    "]",
    ",",
    "\n",
    "\0",
    "\u{202e}",
    "#",
    "\\u0000",
    "true",
    "\"1 m\"",
    "\"all\"",
    "name = \"a\"",
    "..",
    "-",
    "9e9",
    "\u{feff}",
];

/// A text with one to three changes.
pub fn text(original: &str, chance: &mut Chance) -> Vec<u8> {
    let mut bytes = original.as_bytes().to_vec();
    for _ in 0..=chance.below(3) {
        match chance.below(8) {
            0 => {
                let now = String::from_utf8_lossy(&bytes).into_owned();
                let places = numbers(&now);
                // What was no text has other places than the text made of it.
                bytes = now.into_bytes();
                if let Some((begin, end)) = pick(&places, chance) {
                    bytes.splice(begin..end, chance.of(&SILLY).bytes());
                }
            }
            1 => {
                let at = chance.below(bytes.len() + 1);
                bytes.splice(at..at, chance.of(&WORDS).bytes());
            }
            2 => lines(&mut bytes, chance),
            _ => raw(&mut bytes, chance),
        }
    }
    bytes
}

/// A text with one number replaced, the first `keep` of them apart.
pub fn number(original: &str, keep: usize, chance: &mut Chance) -> String {
    let mut text = original.to_owned();
    let places = numbers(original);
    if let Some((begin, end)) = pick(places.get(keep..).unwrap_or_default(), chance) {
        let put: &&str = chance.of(&SILLY);
        text.replace_range(begin..end, put);
    }
    text
}

/// Bytes with one to three changes; never the same as before.
pub fn bytes(original: &[u8], chance: &mut Chance) -> Vec<u8> {
    let mut changed = original.to_vec();
    for _ in 0..=chance.below(3) {
        raw(&mut changed, chance);
    }
    if changed == original {
        match changed.first_mut() {
            Some(first) => *first ^= 1,
            None => changed.push(0),
        }
    }
    changed
}

fn pick(all: &[(usize, usize)], chance: &mut Chance) -> Option<(usize, usize)> {
    (!all.is_empty()).then(|| *chance.of(all))
}

/// One change of bytes.
fn raw(bytes: &mut Vec<u8>, chance: &mut Chance) {
    if bytes.is_empty() {
        bytes.push(chance.below(256) as u8);
        return;
    }
    let at = chance.below(bytes.len());
    let end = (at + 1 + chance.below(64)).min(bytes.len());
    match chance.below(7) {
        0 => bytes[at] ^= 1 << chance.below(8),
        1 => bytes[at] = chance.below(256) as u8,
        2 => bytes.truncate(at),
        3 => {
            bytes.drain(at..end);
        }
        4 => {
            let copy = bytes[at..end].to_vec();
            let to = chance.below(bytes.len());
            bytes.splice(to..to, copy);
        }
        5 => bytes[at..end].fill(0),
        _ => {
            let value = chance.below(256) as u8;
            bytes.insert(at, value);
        }
    }
}

/// Takes out, doubles or swaps lines.
fn lines(bytes: &mut Vec<u8>, chance: &mut Chance) {
    let mut all: Vec<Vec<u8>> = bytes.split(|b| *b == b'\n').map(<[u8]>::to_vec).collect();
    let (a, b) = (chance.below(all.len()), chance.below(all.len()));
    match chance.below(3) {
        0 => drop(all.remove(a)),
        1 => {
            let copy = all[a].clone();
            all.insert(b, copy);
        }
        _ => all.swap(a, b),
    }
    *bytes = all.join(&b'\n');
}

/// Places of the numbers in a text, comments apart.
pub fn numbers(text: &str) -> Vec<(usize, usize)> {
    let bytes = text.as_bytes();
    let (mut found, mut at, mut comment) = (Vec::new(), 0, false);
    while at < bytes.len() {
        let word = |b: u8| b.is_ascii_alphanumeric() || b == b'_';
        match bytes[at] {
            b'\n' => comment = false,
            b'#' => comment = true,
            b if b.is_ascii_digit() && !comment && (at == 0 || !word(bytes[at - 1])) => {
                let begin = at - usize::from(at > 0 && bytes[at - 1] == b'-');
                while at < bytes.len()
                    && (bytes[at].is_ascii_digit() || b".eE_".contains(&bytes[at]))
                {
                    at += 1;
                }
                found.push((begin, at));
                continue;
            }
            _ => {}
        }
        at += 1;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_found_with_their_signs() {
        let text = "a1 = -2.5e3 # 7\nb = [\"30 deg\", 4]";
        let found: Vec<&str> = numbers(text).iter().map(|(a, b)| &text[*a..*b]).collect();
        assert_eq!(found, ["-2.5e3", "30", "4"]);
    }

    #[test]
    fn damage_is_the_same_for_the_same_seed_and_always_there() {
        let original = b"one\ntwo = 3\n".to_vec();
        for seed in 0..500 {
            let damaged = bytes(&original, &mut Chance::new(seed));
            assert_ne!(damaged, original);
            assert_eq!(damaged, bytes(&original, &mut Chance::new(seed)));
            // Nothing panics on what is short.
            text("", &mut Chance::new(seed));
            bytes(b"", &mut Chance::new(seed));
        }
    }
}
