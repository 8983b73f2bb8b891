//! The page of a report that has none of its own.

use anyhow::Result;
use serde_json::Value;

use super::command::Report;
use super::verdict::Verdict;
use ga_draw::document::Page;

/// A page with verdict, warnings, text, and a table of the values that the text may round.
pub(super) fn of(report: &impl Report, title: &str) -> Result<Page> {
    let mut page = Page::new(title);
    if let Some(verdict) = report.verdict() {
        let text = format!("The result is {}.", verdict.word());
        match verdict {
            Verdict::Good => page.paragraph(&text),
            Verdict::Doubtful | Verdict::Failed => page.warning(&text),
        }
    }
    for warning in report.warnings().unwrap_or_default() {
        page.warning(&warning.line_of_text());
    }
    page.code(report.text().trim_end());
    let mut rows = Vec::new();
    add_rows("", &serde_json::to_value(report)?, &mut rows);
    if !rows.is_empty() {
        page.heading("Values");
        page.table(["key", "value"], rows);
    }
    Ok(page)
}

/// The number of elements of a list that are shown.
const LISTED: usize = 20;

/// Adds a row for each value, under the keys that lead to it.
fn add_rows(key: &str, value: &Value, rows: &mut Vec<[String; 2]>) {
    let below = |name: &str| match key {
        "" => name.to_owned(),
        key => format!("{key}.{name}"),
    };
    match value {
        Value::Object(map) => {
            for (name, value) in map {
                add_rows(&below(name), value, rows);
            }
        }
        Value::Array(values)
            if values
                .iter()
                .any(|value| value.is_object() || value.is_array()) =>
        {
            for (index, value) in values.iter().take(LISTED).enumerate() {
                add_rows(&below(&index.to_string()), value, rows);
            }
            if values.len() > LISTED {
                rows.push([key.to_owned(), more(values)]);
            }
        }
        Value::Array(values) => {
            let mut words: Vec<String> = values.iter().take(LISTED).map(word).collect();
            if values.is_empty() {
                words.push("none".to_owned());
            } else if values.len() > LISTED {
                words.push(more(values));
            }
            rows.push([key.to_owned(), words.join(", ")]);
        }
        // A text of several lines is that of the report.
        Value::String(text) if text.contains('\n') => {}
        value => rows.push([key.to_owned(), word(value)]),
    }
}

/// A value that is neither a list nor an object.
fn word(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Bool(true) => "yes".to_owned(),
        Value::Bool(false) => "no".to_owned(),
        Value::Null => "–".to_owned(),
        value => value.to_string(),
    }
}

/// How many elements of a list are not shown.
fn more(values: &[Value]) -> String {
    format!("and {} more", values.len() - LISTED)
}
