//! The number at the head of a quantity.

use super::{ANY_EXAMPLE, UnitError};

/// The number and the text behind it.
///
/// # Errors
/// No number, one that is not finite, or one with a comma.
pub(super) fn split_number(text: &str) -> Result<(f64, &str), UnitError> {
    let bytes = text.as_bytes();
    let digits = |mut at: usize| {
        while bytes.get(at).is_some_and(u8::is_ascii_digit) {
            at += 1;
        }
        at
    };
    let start = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let mut end = digits(start);
    let mut count = end - start;
    if bytes.get(end) == Some(&b'.') {
        let fraction = digits(end + 1);
        count += fraction - end - 1;
        end = fraction;
    }
    if count == 0 {
        // Elsewhere these words are numbers: to say that there is none would puzzle.
        let word: String =
            text[start..].chars().take_while(|c| c.is_alphabetic()).collect::<String>();
        let lower = word.to_lowercase();
        if ["nan", "inf", "infinity"].contains(&lower.as_str()) {
            return Err(UnitError::new("this is not a finite number", "write a finite number"));
        }
        return Err(UnitError::new(
            "this does not begin with a number",
            format!("a value is a number and a unit, for example {ANY_EXAMPLE}"),
        ));
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits(end + 1 + sign);
        // An `e` without digits behind it begins a unit.
        if exponent > end + 1 + sign {
            end = exponent;
        }
    }
    if bytes.get(end) == Some(&b',') {
        return Err(UnitError::new("a comma in a number", comma_help(text, end)));
    }
    match text[..end].parse::<f64>() {
        Ok(number) if number.is_finite() => Ok((number, &text[end..])),
        Ok(_) => Err(UnitError::new("this is not a finite number", "write a finite number")),
        Err(_) => {
            let help = format!("write for example {ANY_EXAMPLE}");
            Err(UnitError::new("this is not a number", help))
        }
    }
}

/// What to write for a number whose first comma is at byte `comma`: groups of three digits behind a
/// number that is not 0 are thousands, everything else is a decimal comma.
fn comma_help(text: &str, comma: usize) -> String {
    let head = &text[..comma];
    let written: String =
        text[comma..].chars().take_while(|c| c.is_ascii_digit() || *c == ',').collect();
    let groups: Vec<&str> = written.split(',').skip(1).collect();
    let whole = head.trim_start_matches(['+', '-']);
    let thousands = groups.iter().all(|group| group.len() == 3)
        && (1..=3).contains(&whole.len())
        && whole.bytes().all(|b| b.is_ascii_digit())
        && !whole.starts_with('0');
    if !thousands {
        return "write a decimal point: 1.5, not 1,5".to_owned();
    }
    let plain = format!("write {head}{}, without a comma", groups.concat());
    match groups[..] {
        [group] => format!("{plain}; or {head}.{group} if the comma is a decimal one"),
        _ => plain,
    }
}
