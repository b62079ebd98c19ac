//! Numbers that prose quotes from runs are those of the verification table.
//!
//! `docs/src/quotes.csv` has a line for each: the page, the words around the number with `{}` in its place, and scene, case and check of the
//! row of `verification.csv` that it is, times `factor`. The page has as many digits as it wants, and the row rounds to them.

use super::{pages, read};

/// Cells of a line of CSV.
fn cells(line: &str) -> Vec<String> {
    let (mut cells, mut cell, mut quoted) = (Vec::new(), String::new(), false);
    let mut letters = line.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '"' if quoted && letters.peek() == Some(&'"') => {
                letters.next();
                cell.push('"');
            }
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(std::mem::take(&mut cell)),
            other => cell.push(other),
        }
    }
    cells.push(cell);
    cells
}

/// What of a page stands where `quote` has `{}`: it must stand there once.
fn quoted<'a>(page: &'a str, quote: &str) -> Result<&'a str, String> {
    let (before, after) = quote.split_once("{}").ok_or("no {} in it")?;
    let number = |at: usize| {
        let rest = &page[at + before.len()..];
        let end = rest.find(|c: char| !(c.is_ascii_digit() || ".-+e".contains(c)));
        let (number, rest) = rest.split_at(end.unwrap_or(rest.len()));
        (!number.is_empty() && rest.starts_with(after)).then_some(number)
    };
    let found: Vec<&str> = page.match_indices(before).filter_map(|(at, _)| number(at)).collect();
    match found[..] {
        [one] => Ok(one),
        [] => Err("the page does not say so".to_owned()),
        [..] => Err(format!("the page says so {} times", found.len())),
    }
}

/// Whether a number is the value rounded to the digits that it has.
fn is_rounded(number: &str, value: f64) -> bool {
    let digits = number.split_once('.').map_or(0, |(_, after)| after.len());
    format!("{value:.digits$}") == number
}

#[test]
fn prose_quotes_what_runs_gave() {
    let table = read(&pages().join("verification.csv"));
    let rows: Vec<Vec<String>> = table.lines().skip(1).map(cells).collect();
    let quotes = read(&pages().join("quotes.csv"));
    let mut wrong = Vec::new();
    for line in quotes.lines().skip(1) {
        let quote = cells(line);
        let [page, words, scene, case, check, factor] = &quote[..] else {
            panic!("quotes.csv has six columns: {line}");
        };
        let number = match quoted(&read(&pages().join(page)), words) {
            Ok(number) => number.to_owned(),
            Err(reason) => {
                wrong.push(format!("{page}: {words}: {reason}"));
                continue;
            }
        };
        let of_case = |row: &&Vec<String>| {
            let own = &row[1];
            row[0] == *scene
                && (own == case || (own.is_empty() && case == "default"))
                && row[2] == *check
        };
        let Some(row) = rows.iter().find(of_case) else {
            wrong.push(format!("verification.csv has no row {scene}, {case}, {check}"));
            continue;
        };
        let (measured, factor): (f64, f64) = match (row[4].parse(), factor.parse()) {
            (Ok(measured), Ok(factor)) => (measured, factor),
            _ => panic!("no numbers: {line}"),
        };
        if !is_rounded(&number, measured * factor) {
            wrong.push(format!(
                "{page} says {number} where the run gave {}: {words}",
                measured * factor
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(quotes.lines().count() > 40, "the list is cut short");
}

#[test]
fn a_wrong_digit_is_seen() {
    let page = "| 1 | 0.561 (0.56) |\n| 2 | 0.5 |";
    assert_eq!(quoted(page, "| 1 | {} ("), Ok("0.561"));
    assert!(quoted(page, "| 3 | {} (").is_err());
    assert!(quoted(page, "| {} ").is_err());
    assert!(is_rounded("0.561", 0.56143) && !is_rounded("0.561", 0.5616));
    assert!(is_rounded("65", 64.77) && !is_rounded("0.56", 0.5));
    assert_eq!(cells("a,\"b,\"\"c\"\"\",d"), ["a", "b,\"c\"", "d"]);
}
