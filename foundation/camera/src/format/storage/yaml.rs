//! The text of a file in YAML.

use std::borrow::Cow;
use std::fmt::Write;

use super::entry::Entry;
use super::matrix::Matrix;
use super::number::exact;
use crate::format::node::{Content, Node};

/// The column after which no number begins.
const WIDTH: usize = 70;
/// The greatest length of a name without a mark; YAML allows 1024 characters.
const LONGEST: usize = 1000;

pub(super) fn encode(entries: &[(String, Entry)]) -> String {
    let mut text = String::from("%YAML:1.0\n---\n");
    if entries.is_empty() {
        text.push_str("{}\n");
    }
    for (name, entry) in entries {
        let name = &key(name);
        match entry {
            Entry::Number(value) => _ = writeln!(text, "{name}: {}", plain_number(*value)),
            Entry::Text(value) => _ = writeln!(text, "{name}: {}", quoted(value)),
            Entry::Matrix(matrix) => push_matrix(&mut text, name, matrix),
            Entry::Read(node) => {
                text.push_str(name);
                text.push_str(": ");
                push_node(&mut text, node);
                text.push('\n');
            }
        }
    }
    text
}

fn push_matrix(text: &mut String, name: &str, matrix: &Matrix) {
    let (rows, columns) = (matrix.rows(), matrix.columns());
    _ = write!(
        text,
        "{name}: !!opencv-matrix\n   rows: {rows}\n   cols: {columns}\n   dt: d\n   data: ["
    );
    let mut column = "   data: [".len();
    for (index, value) in matrix.values().iter().enumerate() {
        if index > 0 {
            text.push(',');
            column += 1;
        }
        if column > WIDTH {
            text.push_str("\n      ");
            column = 6;
        }
        let number = exact(*value);
        column += 1 + number.len();
        text.push(' ');
        text.push_str(&number);
    }
    text.push_str(" ]\n");
}

/// A value as it was read, in flow style.
fn push_node(text: &mut String, node: &Node) {
    match &node.content {
        Content::Scalar(value) => text.push_str(&quoted(value)),
        Content::List(items) => {
            text.push('[');
            for (index, item) in items.iter().enumerate() {
                text.push_str(if index == 0 { " " } else { ", " });
                push_node(text, item);
            }
            text.push_str(" ]");
        }
        Content::Map(entries) => {
            text.push('{');
            for (index, (name, value)) in entries.iter().enumerate() {
                text.push_str(if index == 0 { " " } else { ", " });
                text.push_str(&explicit(quoted(name)));
                text.push_str(": ");
                push_node(text, value);
            }
            text.push_str(" }");
        }
    }
}

/// A number of its own: integers without a point.
pub(super) fn plain_number(value: f64) -> String {
    if value.fract() == 0.0 && value.abs() < f64::from(i32::MAX) {
        format!("{value}")
    } else {
        exact(value)
    }
}

/// A name, in double quotes where it is not made of letters, digits, `_`, `-` and `.`.
fn key(name: &str) -> Cow<'_, str> {
    let is_plain = name.len() <= LONGEST
        && name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && name
            .chars()
            .all(|c| c.is_ascii_alphanumeric() || "_-.".contains(c));
    if is_plain {
        Cow::Borrowed(name)
    } else {
        Cow::Owned(explicit(in_quotes(name)))
    }
}

/// A name as YAML has it before `:`. A long one is marked by `?`, and has a line of its own.
fn explicit(name: String) -> String {
    if name.len() > LONGEST {
        format!("? {name}\n")
    } else {
        name
    }
}

/// A text in double quotes, where it would otherwise be read as something else.
fn quoted(value: &str) -> String {
    let is_plain = !value.is_empty()
        && value.starts_with(|c: char| c.is_ascii_alphanumeric() || "+-.".contains(c))
        && value
            .chars()
            .all(|c| c.is_ascii_alphanumeric() || "+-._".contains(c));
    if is_plain && value != "-" {
        return value.to_owned();
    }
    in_quotes(value)
}

/// A text in double quotes, as YAML, TOML and JSON read it.
pub(in crate::format) fn in_quotes(value: &str) -> String {
    let mut text = String::from("\"");
    for c in value.chars() {
        match c {
            '"' | '\\' => text.extend(['\\', c]),
            '\n' => text.push_str("\\n"),
            c if c.is_control() => _ = write!(text, "\\u{:04X}", c as u32),
            c => text.push(c),
        }
    }
    text.push('"');
    text
}
