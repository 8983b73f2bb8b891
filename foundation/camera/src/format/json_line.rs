//! The lines of values in JSON, whose parser does not keep them.

use super::error::Place;
use super::node::{Content, Node};
use super::syntax::yaml;

/// The lists whose items places count as views.
const LISTS: [&str; 2] = ["views", "frames"];

/// The values of a text with their lines: JSON is YAML too.
pub(super) struct JsonLines(Vec<(String, Node)>);

impl JsonLines {
    pub(super) fn new(text: &str) -> Self {
        let documents = yaml::documents(text).unwrap_or_default();
        Self(documents.into_iter().next().unwrap_or_default())
    }

    /// Adds the line to a place that has none: that of the value, or of what is around it.
    pub(super) fn add_to(&self, place: &mut Place) {
        if place.line.is_some() {
            return;
        }
        let mut entries = Some(&self.0);
        let mut line = entries
            .and_then(|entries| entries.first())
            .map(|(_, node)| node.line);
        if let Some(view) = place.view {
            let list = self
                .0
                .iter()
                .find(|(name, _)| LISTS.contains(&name.as_str()));
            let item = list.and_then(|(_, list)| match &list.content {
                Content::List(items) => items.get(view),
                _ => None,
            });
            // What all views share stands in the file.
            let is_shared = self.0.iter().any(|(name, _)| *name == place.key)
                && !item.is_some_and(|item| has(item, &place.key));
            if !is_shared {
                line = item.map(|item| item.line);
                entries = item.and_then(map);
            }
        }
        for key in place.key.split('.') {
            let found = entries.and_then(|entries| entries.iter().find(|(name, _)| name == key));
            let Some((_, node)) = found else { break };
            line = Some(node.line);
            entries = map(node);
        }
        place.line = line;
    }
}

fn has(node: &Node, key: &str) -> bool {
    let entries = map(node).map(Vec::as_slice).unwrap_or_default();
    entries.iter().any(|(name, _)| name == key)
}

fn map(node: &Node) -> Option<&Vec<(String, Node)>> {
    match &node.content {
        Content::Map(entries) => Some(entries),
        _ => None,
    }
}
