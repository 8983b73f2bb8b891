//! The text of a file in XML.

use std::fmt::Write;

use super::entry::Entry;
use super::number::exact;
use super::yaml::plain_number;
use crate::format::node::{Content, Node};

/// How many numbers are in a line.
const IN_A_LINE: usize = 4;

pub(super) fn encode(entries: &[(String, Entry)]) -> String {
    let mut text = String::from("<?xml version=\"1.0\"?>\n<opencv_storage>\n");
    // Writing to a string does not fail.
    for (name, entry) in entries {
        _ = match entry {
            Entry::Number(value) => writeln!(text, "<{name}>{}</{name}>", plain_number(*value)),
            Entry::Text(value) => writeln!(text, "<{name}>\"{}\"</{name}>", escaped(value)),
            Entry::Matrix(matrix) => {
                let values: Vec<String> = matrix.values().iter().map(|x| exact(*x)).collect();
                let lines: Vec<String> =
                    values.chunks(IN_A_LINE).map(|row| row.join(" ")).collect();
                writeln!(
                    text,
                    "<{name} type_id=\"opencv-matrix\">\n  <rows>{}</rows>\n  <cols>{}</cols>\n  \
                     <dt>d</dt>\n  <data>\n    {}</data></{name}>",
                    matrix.rows(),
                    matrix.columns(),
                    lines.join("\n    ")
                )
            }
            Entry::Read(node) => {
                push_node(&mut text, name, node);
                writeln!(text)
            }
        };
    }
    text + "</opencv_storage>\n"
}

/// A value as it was read.
fn push_node(text: &mut String, name: &str, node: &Node) {
    _ = write!(text, "<{name}>");
    match &node.content {
        Content::Scalar(value) if value.contains(char::is_whitespace) || value.is_empty() => {
            _ = write!(text, "\"{}\"", escaped(value));
        }
        Content::Scalar(value) => text.push_str(&escaped(value)),
        Content::List(items) => items.iter().for_each(|item| push_node(text, "_", item)),
        Content::Map(entries) => {
            let entries = entries.iter();
            entries.for_each(|(name, value)| push_node(text, name, value));
        }
    }
    _ = write!(text, "</{name}>");
}

fn escaped(value: &str) -> String {
    let mut text = String::new();
    for c in value.chars() {
        match c {
            '&' => text.push_str("&amp;"),
            '<' => text.push_str("&lt;"),
            '>' => text.push_str("&gt;"),
            '"' => text.push_str("&quot;"),
            c => text.push(c),
        }
    }
    text
}
