//! What is kept of the file that a document was read from.

use serde::Serialize;
use serde_json::{Map, Value};

use super::super::json::DRACO;
use super::super::origin::File;
use super::super::problem::{Element, Problem};
use super::super::reader;
use super::super::{Animation, Document};
use crate::FormatError;

/// The file that a document was read from, and the document as it was then.
pub(super) struct Kept<'a> {
    pub(super) file: &'a File,
    pub(super) before: Document,
}

/// The extensions that a document has itself: they are not kept beside what replaces them.
const OWN: [&str; 4] = [
    DRACO,
    "KHR_materials_emissive_strength",
    "KHR_materials_unlit",
    "KHR_texture_transform",
];

impl<'a> Kept<'a> {
    pub(super) fn new(document: &'a Document) -> Result<Option<Self>, FormatError> {
        let Some(file) = document.origin.file() else {
            return Ok(None);
        };
        let before = reader::document_of(file)?;
        Ok(Some(Self { file, before }))
    }

    /// The elements of the JSON that a document has no place for.
    pub(super) fn others(&self, known: &[&str]) -> Map<String, Value> {
        let others = self.file.json.iter();
        let others = others.filter(|(key, _)| !known.contains(&key.as_str()));
        others
            .map(|(key, value)| (key.clone(), value.clone()))
            .collect()
    }
}

/// The list of a document as JSON: items that are as they were as they stand in the file, others as
/// `write` gives them, with the extensions that they have in the file.
pub(super) fn list<T: PartialEq>(
    kept: Option<&Kept>,
    name: &str,
    items: &[T],
    before: impl Fn(&Document) -> &[T],
    mut write: impl FnMut(usize, &T) -> Result<Value, FormatError>,
) -> Result<Vec<Value>, FormatError> {
    let written = items.iter().enumerate().map(|(index, item)| {
        let old = kept.and_then(|kept| Some((kept, kept.file.element(name, index)?)));
        match old {
            Some((kept, old)) if before(&kept.before).get(index) == Some(item) => Ok(old.clone()),
            Some((_, old)) => Ok(with_extensions(write(index, item)?, old)),
            None => write(index, item),
        }
    });
    written.collect()
}

/// The animations of a document as JSON: those that the file has as they stand there, wherever that
/// is, since nothing refers to them by their places.
pub(super) fn animations(
    kept: Option<&Kept>,
    items: &[Animation],
    mut write: impl FnMut(&Animation) -> Result<Value, FormatError>,
) -> Result<Vec<Value>, FormatError> {
    // Equal ones are taken in their order.
    let mut taken: Vec<bool> = Vec::new();
    let written = items.iter().map(|item| {
        let old = kept.and_then(|kept| {
            let before = &kept.before.animations;
            taken.resize(before.len(), false);
            let mut places = 0..before.len();
            let place = places.find(|&place| !taken[place] && before[place] == *item)?;
            taken[place] = true;
            kept.file.element("animations", place)
        });
        match old {
            Some(old) => Ok(old.clone()),
            None => write(item),
        }
    });
    written.collect()
}

/// Something as JSON. Numbers have the digits that they have in a text.
pub(super) fn value(item: &impl Serialize) -> Result<Value, FormatError> {
    let text = serde_json::to_vec(item).map_err(not_json)?;
    serde_json::from_slice(&text).map_err(not_json)
}

pub(super) fn not_json(error: serde_json::Error) -> FormatError {
    FormatError::gltf(Element::Json, Problem::Json(error.to_string()))
}

/// An element with the extensions of the one that it replaces, on all levels.
pub(super) fn with_extensions(mut new: Value, old: &Value) -> Value {
    let (Some(object), Some(old)) = (new.as_object_mut(), old.as_object()) else {
        return new;
    };
    for (key, old) in old {
        match object.get_mut(key) {
            Some(own) if own.is_object() && key != "extras" && key != "extensions" => {
                *own = with_extensions(own.take(), old);
            }
            _ => {}
        }
    }
    let extensions = old.get("extensions").and_then(Value::as_object);
    for (name, extension) in extensions.into_iter().flatten() {
        if !OWN.contains(&name.as_str()) {
            let own = object.entry("extensions");
            let own = own.or_insert_with(|| Value::Object(Map::new()));
            if let Some(own) = own.as_object_mut() {
                own.entry(name.clone()).or_insert_with(|| extension.clone());
            }
        }
    }
    new
}
