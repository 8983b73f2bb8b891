//! The text of a file in JSON.

use serde_json::Value;

use super::entry::Entry;
use super::number::exact;
use super::yaml::plain_number;
use crate::format::node::{Content, Node};

pub(super) fn encode(entries: &[(String, Entry)]) -> String {
    let members = entries.iter().map(|(name, entry)| {
        let value = match entry {
            Entry::Number(value) => in_json(plain_number(*value)),
            Entry::Text(value) => string(value),
            Entry::Matrix(matrix) => {
                let values = matrix.values().iter().map(|x| in_json(exact(*x)));
                let values: Vec<String> = values.collect();
                format!(
                    "{{\n        \"type_id\": \"opencv-matrix\",\n        \"rows\": {},\n        \
                     \"cols\": {},\n        \"dt\": \"d\",\n        \"data\": [ {} ]\n    }}",
                    matrix.rows(),
                    matrix.columns(),
                    values.join(", ")
                )
            }
            Entry::Read(node) => of_node(node),
        };
        format!("    {}: {value}", string(name))
    });
    let members: Vec<String> = members.collect();
    format!("{{\n{}\n}}\n", members.join(",\n"))
}

/// A number of OpenCV, which may end in a point.
fn in_json(number: String) -> String {
    match number.ends_with('.') {
        true => number + "0",
        false => number,
    }
}

fn string(text: &str) -> String {
    Value::from(text).to_string()
}

/// A value as it was read.
fn of_node(node: &Node) -> String {
    match &node.content {
        Content::Scalar(text) => match text.parse::<f64>() {
            Ok(number) if number.is_finite() => Value::from(number).to_string(),
            _ => string(text),
        },
        Content::List(items) => {
            let items: Vec<String> = items.iter().map(of_node).collect();
            format!("[ {} ]", items.join(", "))
        }
        Content::Map(entries) => {
            let members = entries.iter();
            let members =
                members.map(|(name, value)| format!("{}: {}", string(name), of_node(value)));
            let members: Vec<String> = members.collect();
            format!("{{ {} }}", members.join(", "))
        }
    }
}
