//! YAML, also with the first line that OpenCV gives it.

use std::collections::HashSet;

use saphyr_parser::{Event, Parser, Span};

use crate::format::error::{CameraFileError, Place};
use crate::format::node::{Content, DEPTH, Node, too_deep};

/// The names and values of the maps that the documents of a file are. Empty documents, as after the
/// last `---` of a recorded message, are left out.
pub(in crate::format) fn documents(
    text: &str,
) -> Result<Vec<Vec<(String, Node)>>, CameraFileError> {
    // `%YAML:1.0` is not a directive of YAML, and stands within a file where two were joined. As a
    // comment it keeps its line.
    let is_directive = |line: &str| line.starts_with("%YAML");
    let commented = text.lines().any(is_directive).then(|| {
        let lines = text.split_inclusive('\n');
        let lines = lines.map(|line| match is_directive(line) {
            true => format!("#{}", &line[1..]),
            false => line.to_owned(),
        });
        lines.collect::<String>()
    });
    let roots = roots(commented.as_deref().unwrap_or(text))?;
    let maps = roots.into_iter().filter_map(|root| match root.content {
        Content::Map(entries) => Some(Ok(entries)),
        Content::Scalar(text) if text.is_empty() || text == "~" => None,
        _ => Some(Err(CameraFileError::Unsupported {
            line: root.line,
            problem: "not a map of names to values",
        })),
    });
    let maps = maps.collect::<Result<Vec<_>, _>>()?;
    match maps.is_empty() {
        false => Ok(maps),
        true => Err(CameraFileError::Unsupported {
            line: 1,
            problem: "there are no values",
        }),
    }
}

/// A list or map whose end is not reached yet.
struct Open {
    line: usize,
    kind: OpenKind,
}

enum OpenKind {
    List(Vec<Node>),
    Map {
        entries: Vec<(String, Node)>,
        /// Those of the entries and `name`, to find duplicates.
        names: HashSet<String>,
        name: Option<String>,
    },
}

/// The roots of the documents.
fn roots(text: &str) -> Result<Vec<Node>, CameraFileError> {
    let mut roots = Vec::new();
    let mut open: Vec<Open> = Vec::new();
    for event in Parser::new_from_str(text) {
        let (event, span) = event.map_err(|error| CameraFileError::Syntax {
            line: error.marker().line(),
            format: "YAML",
            problem: error.info().to_owned(),
        })?;
        let line = line_of(span);
        let node = match event {
            Event::Scalar(text, ..) => Node {
                line,
                content: Content::Scalar(text.into_owned()),
            },
            Event::SequenceStart(..) => {
                begin(&mut open, line, OpenKind::List(Vec::new()))?;
                continue;
            }
            Event::MappingStart(..) => {
                let kind = OpenKind::Map {
                    entries: Vec::new(),
                    names: HashSet::new(),
                    name: None,
                };
                begin(&mut open, line, kind)?;
                continue;
            }
            Event::SequenceEnd | Event::MappingEnd => match open.pop() {
                Some(Open { line, kind }) => Node {
                    line,
                    content: match kind {
                        OpenKind::List(items) => Content::List(items),
                        OpenKind::Map { entries, .. } => Content::Map(entries),
                    },
                },
                None => continue,
            },
            Event::Alias(_) => {
                return Err(CameraFileError::Unsupported {
                    line,
                    problem: "references to other values are not supported",
                });
            }
            _ => continue,
        };
        match open.last_mut() {
            Some(parent) => insert(parent, node)?,
            None => roots.push(node),
        }
    }
    Ok(roots)
}

fn line_of(span: Span) -> usize {
    span.start.line()
}

fn begin(open: &mut Vec<Open>, line: usize, kind: OpenKind) -> Result<(), CameraFileError> {
    if open.len() == DEPTH {
        return Err(too_deep(line));
    }
    open.push(Open { line, kind });
    Ok(())
}

fn insert(parent: &mut Open, node: Node) -> Result<(), CameraFileError> {
    match &mut parent.kind {
        OpenKind::List(items) => items.push(node),
        OpenKind::Map {
            entries,
            names,
            name,
        } => match name.take() {
            Some(name) => entries.push((name, node)),
            None => {
                let Content::Scalar(text) = node.content else {
                    return Err(CameraFileError::Unsupported {
                        line: node.line,
                        problem: "a name is a list or a map",
                    });
                };
                if !names.insert(text.clone()) {
                    return Err(CameraFileError::Duplicate(Place::on_line(node.line, text)));
                }
                *name = Some(text);
            }
        },
    }
    Ok(())
}
