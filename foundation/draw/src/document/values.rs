//! A value of JSON as a table.

use serde_json::Value;

use super::page::Page;

impl Page {
    /// A table of the values in `value`, each under the keys that lead to it, below the heading
    /// "Values"; nothing where there are none. Lists are shown up to their twentieth element, and
    /// texts of several lines are left out.
    ///
    /// ```
    /// use ga_draw::document::Page;
    ///
    /// let mut page = Page::new("A point");
    /// page.values(&serde_json::json!({"point": {"place": [1, 2.5], "seen": true}}));
    /// let html = page.into_html();
    /// assert!(html.contains("<td>point.place</td><td>1, 2.5</td>"));
    /// assert!(html.contains("<td>point.seen</td><td>yes</td>"));
    /// ```
    pub fn values(&mut self, value: &Value) {
        let mut rows = Vec::new();
        add_rows("", value, &mut rows);
        if !rows.is_empty() {
            self.heading("Values");
            self.table(["key", "value"], rows);
        }
    }
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
