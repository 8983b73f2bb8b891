//! TOML.

use toml::de::{DeTable, DeValue};

use super::lines::Lines;
use crate::format::error::CameraFileError;
use crate::format::node::{Content, DEPTH, Node, too_deep};

/// The names and values of a file, in its order.
pub(in crate::format) fn entries(text: &str) -> Result<Vec<(String, Node)>, CameraFileError> {
    let lines = Lines::new(text);
    let table = DeTable::parse(text).map_err(|error| CameraFileError::Syntax {
        line: error.span().map_or(1, |span| lines.of(span.start)),
        format: "TOML",
        problem: error.message().replace('\n', " "),
    })?;
    entries_of(table.get_ref(), &lines, 0)
}

fn entries_of(
    table: &DeTable<'_>,
    lines: &Lines,
    depth: usize,
) -> Result<Vec<(String, Node)>, CameraFileError> {
    let mut in_order: Vec<_> = table.iter().collect();
    in_order.sort_by_key(|(name, _)| name.span().start);
    let nodes = in_order.into_iter().map(|(name, value)| {
        let line = lines.of(name.span().start);
        let content = content(value.get_ref(), line, lines, depth)?;
        Ok((name.get_ref().to_string(), Node { line, content }))
    });
    nodes.collect()
}

fn content(
    value: &DeValue<'_>,
    line: usize,
    lines: &Lines,
    depth: usize,
) -> Result<Content, CameraFileError> {
    if depth == DEPTH {
        return Err(too_deep(line));
    }
    Ok(match value {
        DeValue::String(text) => Content::Scalar(text.to_string()),
        DeValue::Integer(number) => Content::Scalar(match number.radix() {
            10 => number.as_str().to_owned(),
            // Hexadecimal, octal and binary numbers are whole and positive.
            radix => u64::from_str_radix(number.as_str(), radix)
                .map_or_else(|_| number.to_string(), |number| number.to_string()),
        }),
        DeValue::Float(number) => Content::Scalar(number.as_str().to_owned()),
        DeValue::Boolean(truth) => Content::Scalar(truth.to_string()),
        DeValue::Datetime(time) => Content::Scalar(time.to_string()),
        DeValue::Array(items) => {
            let nodes = items.iter().map(|item| {
                let line = lines.of(item.span().start);
                let content = content(item.get_ref(), line, lines, depth + 1)?;
                Ok(Node { line, content })
            });
            Content::List(nodes.collect::<Result<_, CameraFileError>>()?)
        }
        DeValue::Table(table) => Content::Map(entries_of(table, lines, depth + 1)?),
    })
}
