//! Conditions that many elements have in common.

use super::super::Document;
use super::super::problem::{Element, Problem};
use crate::FormatError;

pub(super) type Checked = Result<(), FormatError>;

/// The number of morph targets of a mesh.
pub(super) fn targets_of(document: &Document, mesh: usize) -> usize {
    let mesh = document.meshes.get(mesh);
    let primitive = mesh.and_then(|mesh| mesh.primitives.first());
    primitive.map_or(0, |primitive| primitive.targets.len())
}

pub(super) fn fault<T>(element: Element, problem: Problem) -> Result<T, FormatError> {
    Err(FormatError::gltf(element, problem))
}

pub(super) fn exists(what: &'static str, index: usize, count: usize) -> Checked {
    if index < count {
        Ok(())
    } else {
        Err(FormatError::dangling(what, index, count))
    }
}

pub(super) fn distinct(what: &'static str, indices: &[usize]) -> Checked {
    let mut sorted = indices.to_vec();
    sorted.sort_unstable();
    match sorted.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => {
            let index = pair[0];
            fault(Element::File, Problem::Duplicate { what, index })
        }
        None => Ok(()),
    }
}

pub(super) fn count(what: &'static str, expected: usize, found: usize) -> Checked {
    if expected == found {
        return Ok(());
    }
    let problem = Problem::Count {
        what,
        expected,
        found,
    };
    fault(Element::File, problem)
}

pub(super) fn finite<const N: usize>(items: &[[f32; N]]) -> Checked {
    let is_finite = |item: &[f32; N]| item.iter().all(|number| number.is_finite());
    match items.iter().position(|item| !is_finite(item)) {
        Some(item) => fault(Element::File, Problem::NotFinite { item }),
        None => Ok(()),
    }
}

pub(super) fn in_range(
    property: &'static str,
    value: f32,
    range: std::ops::RangeInclusive<f32>,
) -> Checked {
    if range.contains(&value) {
        return Ok(());
    }
    let value = value.to_string();
    fault(Element::File, Problem::Value { property, value })
}
