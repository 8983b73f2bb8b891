//! The binary part of a file, and the views and accessors that describe it.

use serde_json::{Value, json};

use super::GltfError;

/// What a buffer view is for.
#[derive(Clone, Copy)]
pub(super) enum Target {
    /// Vertex attributes.
    Array = 34962,
    /// Triangle indices.
    ElementArray = 34963,
}

/// Bytes laid out as glTF wants them: little-endian, every accessor at a multiple of four.
#[derive(Default)]
pub(super) struct Buffer {
    pub(super) bytes: Vec<u8>,
    pub(super) views: Vec<Value>,
    pub(super) accessors: Vec<Value>,
}

impl Buffer {
    /// A view of its own for one accessor; the index of the accessor.
    pub(super) fn add(&mut self, target: Option<Target>, elements: Elements) -> usize {
        let view = self.begin_view();
        let accessor = self.push(view, elements);
        self.end_view(view, target);
        accessor
    }

    /// Starts a view that the following calls of [`push`](Self::push) fill.
    pub(super) fn begin_view(&mut self) -> usize {
        self.views
            .push(json!({ "buffer": 0, "byteOffset": self.bytes.len() }));
        self.views.len() - 1
    }

    /// Appends elements to the view begun last; the index of their accessor.
    pub(super) fn push(&mut self, view: usize, elements: Elements) -> usize {
        let start = self.views[view]["byteOffset"].as_u64().unwrap_or(0);
        let mut accessor = json!({
            "bufferView": view,
            "byteOffset": self.bytes.len() as u64 - start,
            "componentType": elements.component as u32,
            "count": elements.count,
            "type": elements.shape,
        });
        if let Some((least, greatest)) = elements.bounds {
            accessor["min"] = json!(least);
            accessor["max"] = json!(greatest);
        }
        self.bytes.extend_from_slice(&elements.bytes);
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    pub(super) fn end_view(&mut self, view: usize, target: Option<Target>) {
        let start = self.views[view]["byteOffset"].as_u64().unwrap_or(0);
        self.views[view]["byteLength"] = json!(self.bytes.len() as u64 - start);
        if let Some(target) = target {
            self.views[view]["target"] = json!(target as u32);
        }
    }
}

#[derive(Clone, Copy)]
enum Component {
    UnsignedByte = 5121,
    UnsignedShort = 5123,
    UnsignedInt = 5125,
    Float = 5126,
}

/// The contents of an accessor.
pub(super) struct Elements {
    component: Component,
    shape: &'static str,
    count: usize,
    bytes: Vec<u8>,
    bounds: Option<(Vec<f32>, Vec<f32>)>,
}

impl Elements {
    /// Vectors or matrices of `N` numbers.
    pub(super) fn floats<const N: usize>(elements: &[[f32; N]]) -> Self {
        let shape = match N {
            1 => "SCALAR",
            2 => "VEC2",
            3 => "VEC3",
            4 => "VEC4",
            _ => "MAT4",
        };
        Self {
            component: Component::Float,
            shape,
            count: elements.len(),
            bytes: elements
                .iter()
                .flatten()
                .flat_map(|f| f.to_le_bytes())
                .collect(),
            bounds: None,
        }
    }

    /// As [`floats`](Self::floats), with the least and greatest of each component stated.
    pub(super) fn bounded_floats<const N: usize>(elements: &[[f32; N]]) -> Self {
        let fold = |start: f32, pick: fn(f32, f32) -> f32| {
            let columns = elements.iter().fold([start; N], |bound, element| {
                std::array::from_fn(|i| pick(bound[i], element[i]))
            });
            columns.to_vec()
        };
        Self {
            bounds: Some((
                fold(f32::INFINITY, f32::min),
                fold(f32::NEG_INFINITY, f32::max),
            )),
            ..Self::floats(elements)
        }
    }

    /// Indices below `limit`, in the smallest type that glTF allows for them. (The greatest value
    /// of a type may not be used: it restarts primitives.)
    pub(super) fn indices(indices: impl Iterator<Item = u32> + Clone, limit: usize) -> Self {
        let count = indices.clone().count();
        let (component, bytes) = if limit <= usize::from(u16::MAX) {
            let short = indices.flat_map(|i| (i as u16).to_le_bytes());
            (Component::UnsignedShort, short.collect())
        } else {
            (
                Component::UnsignedInt,
                indices.flat_map(u32::to_le_bytes).collect(),
            )
        };
        Self {
            component,
            shape: "SCALAR",
            count,
            bytes,
            bounds: None,
        }
    }

    /// Four joints for each vertex, out of `joints` in all.
    pub(super) fn joints(elements: &[[u16; 4]], joints: usize) -> Self {
        let numbers = elements.iter().flatten();
        let (component, bytes) = if joints <= 256 {
            (Component::UnsignedByte, numbers.map(|&j| j as u8).collect())
        } else {
            (
                Component::UnsignedShort,
                numbers.flat_map(|j| j.to_le_bytes()).collect(),
            )
        };
        Self {
            component,
            shape: "VEC4",
            count: elements.len(),
            bytes,
            bounds: None,
        }
    }
}

/// Rounds to single precision; `what` and `index` name the vector when it does not fit.
pub(super) fn single<const N: usize>(
    vector: [f64; N],
    what: &'static str,
    index: usize,
) -> Result<[f32; N], GltfError> {
    let rounded = vector.map(|c| c as f32);
    if rounded.iter().all(|c| c.is_finite()) {
        Ok(rounded)
    } else {
        Err(GltfError::NotFinite { what, index })
    }
}

/// The unit vector along a vector, `None` when it has no direction.
pub(super) fn unit<const N: usize>(vector: [f64; N]) -> Option<[f64; N]> {
    let largest = vector.iter().fold(0.0, |m: f64, c| m.max(c.abs()));
    if !(largest > 0.0 && vector.iter().all(|c| c.is_finite())) {
        return None;
    }
    // Dividing by the largest component first keeps the squares in range.
    let scaled = vector.map(|c| c / largest);
    let length = scaled.iter().map(|c| c * c).sum::<f64>().sqrt();
    Some(scaled.map(|c| c / length))
}
