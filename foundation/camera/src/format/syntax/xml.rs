//! XML, as OpenCV's storage or as a document of elements with attributes.

use std::collections::HashSet;

use roxmltree::{Document, Node as Element};

use super::lines::Lines;
use crate::format::error::{CameraFileError, Place};
use crate::format::node::{Content, DEPTH, Node, too_deep};

/// A document whose elements have lines.
pub(in crate::format) struct Xml<'a> {
    document: Document<'a>,
    lines: Lines,
}

impl<'a> Xml<'a> {
    pub(in crate::format) fn parse(text: &'a str) -> Result<Self, CameraFileError> {
        let document = Document::parse(text).map_err(|error| CameraFileError::Syntax {
            line: match error {
                roxmltree::Error::UnclosedRootNode => text.lines().count(),
                _ => (error.pos().row as usize).max(1),
            },
            format: "XML",
            problem: error.to_string().replace(['\n', '\r'], " "),
        })?;
        Ok(Self {
            document,
            lines: Lines::new(text),
        })
    }

    pub(in crate::format) fn root(&self) -> Element<'_, 'a> {
        self.document.root_element()
    }

    pub(in crate::format) fn line(&self, element: Element<'_, '_>) -> usize {
        self.lines.of(element.range().start)
    }

    /// The named values of OpenCV's storage.
    pub(in crate::format) fn entries(&self) -> Result<Vec<(String, Node)>, CameraFileError> {
        self.map(self.root(), 0)
    }

    fn map(
        &self,
        element: Element<'_, '_>,
        depth: usize,
    ) -> Result<Vec<(String, Node)>, CameraFileError> {
        let mut entries = Vec::new();
        let mut names = HashSet::new();
        for child in element.children().filter(Element::is_element) {
            let name = child.tag_name().name();
            let node = self.node(child, depth + 1)?;
            if !names.insert(name) {
                return Err(CameraFileError::Duplicate(Place::on_line(node.line, name)));
            }
            entries.push((name.to_owned(), node));
        }
        Ok(entries)
    }

    fn node(&self, element: Element<'_, '_>, depth: usize) -> Result<Node, CameraFileError> {
        let line = self.line(element);
        if depth == DEPTH {
            return Err(too_deep(line));
        }
        let mut children = element.children().filter(Element::is_element).peekable();
        let content = match children.peek() {
            None => words(element, line),
            // Items of a list have no names.
            Some(first) if first.has_tag_name("_") => {
                let items = children.map(|child| self.node(child, depth + 1));
                Content::List(items.collect::<Result<_, _>>()?)
            }
            Some(_) => Content::Map(self.map(element, depth)?),
        };
        Ok(Node { line, content })
    }
}

/// The words of a text: one value, or a list where there are several. A text in quotes is one.
fn words(element: Element<'_, '_>, line: usize) -> Content {
    let parts = element.children().filter_map(|child| child.text());
    let text: String = parts.collect();
    let scalar = |word: &str| Content::Scalar(word.to_owned());
    let trimmed = text.trim();
    let quoted = trimmed
        .strip_prefix('"')
        .and_then(|rest| rest.strip_suffix('"'));
    if let Some(inside) = quoted.filter(|inside| !inside.contains('"')) {
        return scalar(inside);
    }
    let mut items = trimmed.split_whitespace().map(|word| Node {
        line,
        content: scalar(word.trim_matches('"')),
    });
    match (items.next(), items.next()) {
        (Some(only), None) => only.content,
        (first, second) => Content::List(first.into_iter().chain(second).chain(items).collect()),
    }
}
