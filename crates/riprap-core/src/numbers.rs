//! Numbers that stand for things in lists, of a state that came from a file.

/// Whether each of some numbers is a place in a list of `count` things; else what is wrong with `what`.
///
/// # Errors
/// The first number that is none.
pub fn below(
    what: &str,
    numbers: impl IntoIterator<Item = u32>,
    count: usize,
) -> Result<(), String> {
    match numbers.into_iter().find(|k| *k as usize >= count) {
        Some(k) => Err(format!("{what} {k} is out of range ({count})")),
        None => Ok(()),
    }
}

/// Whether a list has an entry for each of `count` things; else what is wrong with `what`.
///
/// # Errors
/// A list of another length.
pub fn one_each(what: &str, length: usize, count: usize) -> Result<(), String> {
    if length == count {
        Ok(())
    } else {
        Err(format!("there are {length} {what} instead of {count}"))
    }
}

/// A number of things in words: `1 block`, `2 blocks`.
#[must_use]
pub fn counted(number: usize, one: &str) -> String {
    let many = if number == 1 { "" } else { "s" };
    format!("{number} {one}{many}")
}
