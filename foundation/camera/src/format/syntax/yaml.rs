//! YAML, also with the first line that OpenCV gives it. Values that are given once and repeated, by
//! `&name` and `*name`, and maps that others take in, by `<<`, are written out.

use std::collections::{HashMap, HashSet};

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

/// How many values may be written out: references in references make many of few.
const MOST: usize = 1 << 20;
/// The name under which a map takes others in.
const MERGE: &str = "<<";

/// A list or map whose end is not reached yet.
struct Open {
    line: usize,
    /// The number of the name by which it is repeated; 0 for none.
    anchor: usize,
    kind: OpenKind,
}

enum OpenKind {
    List(Vec<Node>),
    Map {
        entries: Vec<(String, Node)>,
        /// Those of the entries and `name`, to find duplicates.
        names: HashSet<String>,
        /// The name of the next value, and its line.
        name: Option<(String, usize)>,
    },
}

/// The roots of the documents.
fn roots(text: &str) -> Result<Vec<Node>, CameraFileError> {
    let mut roots = Vec::new();
    let mut open: Vec<Open> = Vec::new();
    let mut named: HashMap<usize, Node> = HashMap::new();
    let mut written = 0;
    for event in Parser::new_from_str(text) {
        let (event, span) = event.map_err(|error| CameraFileError::Syntax {
            line: error.marker().line(),
            format: "YAML",
            problem: error.info().to_owned(),
        })?;
        let line = line_of(span);
        let (anchor, node) = match event {
            Event::Scalar(text, _, anchor, _) => {
                let content = Content::Scalar(text.into_owned());
                (anchor, Node { line, content })
            }
            Event::SequenceStart(anchor, _) => {
                begin(&mut open, line, anchor, OpenKind::List(Vec::new()))?;
                continue;
            }
            Event::MappingStart(anchor, _) => {
                let kind = OpenKind::Map {
                    entries: Vec::new(),
                    names: HashSet::new(),
                    name: None,
                };
                begin(&mut open, line, anchor, kind)?;
                continue;
            }
            Event::SequenceEnd | Event::MappingEnd => match open.pop() {
                Some(Open { line, anchor, kind }) => {
                    let content = match kind {
                        OpenKind::List(items) => Content::List(items),
                        OpenKind::Map { entries, .. } => Content::Map(merged(entries)?),
                    };
                    (anchor, Node { line, content })
                }
                None => continue,
            },
            Event::Alias(anchor) => {
                let refuse = |problem| CameraFileError::Unsupported { line, problem };
                let node = named
                    .get(&anchor)
                    .ok_or_else(|| refuse("a value refers to itself"))?;
                let [count, depth] = extent(node);
                written += count;
                if written > MOST {
                    return Err(refuse("references make too many values"));
                }
                if open.len() + depth > DEPTH {
                    return Err(too_deep(line));
                }
                (0, node.clone())
            }
            _ => continue,
        };
        if anchor > 0 {
            named.insert(anchor, node.clone());
        }
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

fn begin(
    open: &mut Vec<Open>,
    line: usize,
    anchor: usize,
    kind: OpenKind,
) -> Result<(), CameraFileError> {
    if open.len() == DEPTH {
        return Err(too_deep(line));
    }
    open.push(Open { line, anchor, kind });
    Ok(())
}

/// How many values there are in one, and how deeply they are nested.
fn extent(node: &Node) -> [usize; 2] {
    let inner: Vec<&Node> = match &node.content {
        Content::Scalar(_) => return [1, 0],
        Content::List(items) => items.iter().collect(),
        Content::Map(entries) => entries.iter().map(|(_, node)| node).collect(),
    };
    let extents = inner.into_iter().map(extent);
    extents.fold([1, 1], |[count, depth], [more, below]| {
        [count + more, depth.max(1 + below)]
    })
}

/// The entries of a map and of those that it takes in, of which its own come first.
fn merged(entries: Vec<(String, Node)>) -> Result<Vec<(String, Node)>, CameraFileError> {
    let (taken, mut own): (Vec<_>, Vec<_>) =
        entries.into_iter().partition(|(name, _)| name == MERGE);
    if taken.is_empty() {
        return Ok(own);
    }
    let mut names: HashSet<String> = own.iter().map(|(name, _)| name.clone()).collect();
    for (_, node) in taken {
        let maps = match node.content {
            Content::List(items) => items,
            _ => vec![node],
        };
        for map in maps {
            let Content::Map(entries) = map.content else {
                return Err(CameraFileError::Unsupported {
                    line: map.line,
                    problem: "what a map takes in is not a map",
                });
            };
            own.extend(
                entries
                    .into_iter()
                    .filter(|(name, _)| names.insert(name.clone())),
            );
        }
    }
    Ok(own)
}

fn insert(parent: &mut Open, node: Node) -> Result<(), CameraFileError> {
    match &mut parent.kind {
        OpenKind::List(items) => items.push(node),
        OpenKind::Map {
            entries,
            names,
            name,
        } => match name.take() {
            // A value that begins below its name is looked for at the name.
            Some((name, line)) => entries.push((name, Node { line, ..node })),
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
                *name = Some((text, node.line));
            }
        },
    }
    Ok(())
}
