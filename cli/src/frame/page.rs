//! The page of a report that has none of its own.

use serde_json::Value;

use super::verdict::Verdict;
use super::warning::Warning;
use ga_draw::document::Page;

/// A page with verdict, warnings, text, and a table of the values that the text may round.
pub(super) fn of(
    title: &str,
    verdict: Option<Verdict>,
    warnings: &[Warning],
    text: &str,
    values: &Value,
) -> Page {
    let mut page = Page::new(title);
    if let Some(verdict) = verdict {
        let text = format!("The result is {}.", verdict.word());
        match verdict {
            Verdict::Good => page.paragraph(&text),
            Verdict::Doubtful | Verdict::Failed => page.warning(&text),
        }
    }
    for warning in warnings {
        page.warning(&warning.line_of_text());
    }
    page.code(text.trim_end());
    let mut rows = Vec::new();
    add_rows("", values, &mut rows);
    if !rows.is_empty() {
        page.heading("Values");
        page.table(["key", "value"], rows);
    }
    page
}

/// The number of elements of a list that have rows.
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
            if let Some(more) = values.len().checked_sub(LISTED).filter(|more| *more > 0) {
                rows.push([key.to_owned(), format!("and {more} more")]);
            }
        }
        Value::String(text) => rows.push([key.to_owned(), text.clone()]),
        value => rows.push([key.to_owned(), value.to_string()]),
    }
}
