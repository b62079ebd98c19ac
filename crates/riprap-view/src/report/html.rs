//! Text, tables and numbers of the page.

use serde_json::Value;
use std::fmt::Write as _;

/// Text for HTML.
pub(super) fn escape(text: &str) -> String {
    // First, or it would escape what the others put in.
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

pub(super) fn table<'a>(
    out: &mut String,
    class: &str,
    rows: impl IntoIterator<Item = (&'a str, String)>,
) {
    let _ = writeln!(out, "<table class=\"{class}\">");
    for (name, value) in rows {
        if !value.is_empty() {
            let _ = writeln!(out, "<tr><th>{}</th><td>{}</td></tr>", escape(name), escape(&value));
        }
    }
    out.push_str("</table>\n");
}

/// A number with few digits.
pub(super) fn short(v: f64) -> String {
    if v == 0.0 || (1e-3..1e5).contains(&v.abs()) {
        let text = format!("{v:.6}");
        let text = text.trim_end_matches('0').trim_end_matches('.');
        text.to_owned()
    } else {
        format!("{v:.4e}")
    }
}

/// Units with their powers raised.
pub(super) fn superscript(text: &str) -> String {
    text.replace("m3", "m³").replace("m2", "m²").replace("s2", "s²")
}

/// Shares of the largest number below which nothing but round-off is reported.
const ROUND_OFF: f64 = 1e-12;

/// A number with four digits; 0 where it is nothing beside `largest`.
pub(super) fn rounded(v: f64, largest: f64) -> String {
    if v.abs() <= ROUND_OFF * largest || v == 0.0 {
        return "0".to_owned();
    }
    let power = v.abs().log10().floor();
    if !power.is_finite() || !(-3.0..6.0).contains(&power) {
        return format!("{v:.3e}");
    }
    let unit = 10_f64.powf(power - 3.0);
    let text = format!("{:.*}", (3.0 - power).max(0.0) as usize, (v / unit).round() * unit);
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

pub(super) fn text_of(value: &Value, key: &str) -> String {
    match &value[key] {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        Value::Number(n) => n.as_f64().map_or_else(|| n.to_string(), short),
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn energies_have_four_digits() {
        let all = [12345.678901, -0.0123456, 123456.7, 2.0, 9999.9, 5e-10, 4e9, 1e-20];
        let said: Vec<String> = all.iter().map(|v| rounded(*v, 1e-4)).collect();
        assert_eq!(
            said,
            ["12350", "-0.01235", "123500", "2", "10000", "5.000e-10", "4.000e9", "0"]
        );
        assert_eq!(rounded(1e-3, 1e10), "0");
        assert_eq!(rounded(f64::NAN, 1.0), "NaN");
    }

    #[test]
    fn text_of_a_run_cannot_become_html() {
        assert_eq!(escape("<b>\"&\"</b>"), "&lt;b&gt;&quot;&amp;&quot;&lt;/b&gt;");
    }
}
