//! The nodes of a YAML file with their lines.

use std::collections::HashSet;

use saphyr_parser::{Event, Parser, Span};

use crate::format::error::{CameraFileError, Place, wrong_type};
use crate::format::text::text;

/// How deeply lists and maps may be nested: files of cameras have four levels.
const DEPTH: usize = 16;

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Node {
    /// From 1.
    pub(super) line: usize,
    pub(super) content: Content,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Content {
    Scalar(String),
    List(Vec<Node>),
    Map(Vec<(String, Node)>),
}

impl Node {
    /// The finite number that a value is.
    pub(super) fn number(&self, name: &str) -> Result<f64, CameraFileError> {
        let Content::Scalar(text) = &self.content else {
            return Err(wrong_type(name, self.line, "a number"));
        };
        let number = match text.to_ascii_lowercase().as_str() {
            ".nan" => f64::NAN,
            ".inf" | "+.inf" => f64::INFINITY,
            "-.inf" => f64::NEG_INFINITY,
            other => other
                .parse()
                .map_err(|_| wrong_type(name, self.line, "a number"))?,
        };
        if number.is_finite() {
            Ok(number)
        } else {
            Err(CameraFileError::NotFinite {
                place: Place::on_line(self.line, name),
                value: number,
            })
        }
    }
}

/// The names and values of the map that a file is.
pub(super) fn entries(bytes: &[u8]) -> Result<Vec<(String, Node)>, CameraFileError> {
    let text = text(bytes)?;
    if text.starts_with("<?xml") {
        return Err(CameraFileError::Xml);
    }
    // `%YAML:1.0` is not a directive of YAML. As a comment it keeps its line.
    let commented = text
        .starts_with("%YAML")
        .then(|| format!("#{}", &text[1..]));
    let root = document(commented.as_deref().unwrap_or(text))?;
    match root.map(|root| (root.line, root.content)) {
        Some((_, Content::Map(entries))) => Ok(entries),
        Some((line, _)) => Err(CameraFileError::Unsupported {
            line,
            problem: "not a map of names to values",
        }),
        None => Err(CameraFileError::Unsupported {
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

/// The root of the only document; `None` for an empty text.
fn document(text: &str) -> Result<Option<Node>, CameraFileError> {
    let mut root = None;
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
            Event::DocumentStart(_) if root.is_some() => {
                return Err(CameraFileError::Unsupported {
                    line,
                    problem: "a second document begins here",
                });
            }
            _ => continue,
        };
        match open.last_mut() {
            Some(parent) => insert(parent, node)?,
            None => root = Some(node),
        }
    }
    Ok(root)
}

fn line_of(span: Span) -> usize {
    span.start.line()
}

fn begin(open: &mut Vec<Open>, line: usize, kind: OpenKind) -> Result<(), CameraFileError> {
    if open.len() == DEPTH {
        return Err(CameraFileError::Unsupported {
            line,
            problem: "lists and maps are nested too deeply",
        });
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
