//! A file under construction: its JSON and its binary part.

use std::collections::BTreeMap;

use gltf_json::accessor::{ComponentType, GenericComponentType, Type};
use gltf_json::buffer::{Buffer, Target, View};
use gltf_json::mesh::Semantic;
use gltf_json::validation::{Checked, USize64};
use gltf_json::{Accessor, Index, Root, Value};

use super::GltfError;

/// The attributes of the vertices: which accessor holds them.
pub(super) type Attributes = BTreeMap<Checked<Semantic>, Index<Accessor>>;

/// A document and the bytes that its accessors describe: little-endian, every accessor at a
/// multiple of four.
#[derive(Default)]
pub(super) struct Document {
    pub(super) root: Root,
    bytes: Vec<u8>,
}

impl Document {
    /// Appends elements as a buffer view of their own.
    pub(super) fn add(&mut self, target: Option<Target>, elements: Elements) -> Index<Accessor> {
        let (view, start) = self.begin_view(target);
        let accessor = self.append(view, start, elements);
        self.end_view(view, start);
        accessor
    }

    /// Appends several lists of elements as one buffer view.
    pub(super) fn add_together(
        &mut self,
        lists: impl IntoIterator<Item = Elements>,
    ) -> Vec<Index<Accessor>> {
        let (view, start) = self.begin_view(None);
        let accessors = lists
            .into_iter()
            .map(|elements| self.append(view, start, elements))
            .collect();
        self.end_view(view, start);
        accessors
    }

    fn begin_view(&mut self, target: Option<Target>) -> (Index<View>, usize) {
        let start = self.bytes.len();
        let view = self.root.push(View {
            buffer: Index::new(0),
            byte_length: USize64(0),
            byte_offset: Some(USize64::from(start)),
            byte_stride: None,
            name: None,
            target: target.map(Checked::Valid),
            extensions: None,
            extras: Default::default(),
        });
        (view, start)
    }

    fn append(&mut self, view: Index<View>, start: usize, elements: Elements) -> Index<Accessor> {
        let offset = self.bytes.len() - start;
        self.bytes.extend_from_slice(&elements.bytes);
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let (min, max) = elements.bounds.unzip();
        self.root.push(Accessor {
            buffer_view: Some(view),
            byte_offset: Some(USize64::from(offset)),
            count: USize64::from(elements.count),
            component_type: Checked::Valid(GenericComponentType(elements.component)),
            type_: Checked::Valid(elements.shape),
            min,
            max,
            name: None,
            normalized: false,
            sparse: None,
            extensions: None,
            extras: Default::default(),
        })
    }

    fn end_view(&mut self, view: Index<View>, start: usize) {
        self.root.buffer_views[view.value()].byte_length = USize64::from(self.bytes.len() - start);
    }

    /// The bytes of the GLB file: a header, a chunk of JSON and a chunk of binary data.
    pub(super) fn into_glb(mut self) -> Result<Vec<u8>, GltfError> {
        self.root.push(Buffer {
            byte_length: USize64::from(self.bytes.len()),
            name: None,
            uri: None,
            extensions: None,
            extras: Default::default(),
        });
        let mut text = self
            .root
            .to_vec()
            .expect("a document of valid items has a JSON form");
        text.resize(text.len().next_multiple_of(4), b' ');

        let length = HEADER + 2 * CHUNK_HEADER + text.len() + self.bytes.len();
        let length = u32::try_from(length).map_err(|_| GltfError::TooLarge)?;
        let mut file = Vec::with_capacity(length as usize);
        file.extend_from_slice(b"glTF");
        file.extend_from_slice(&2u32.to_le_bytes());
        file.extend_from_slice(&length.to_le_bytes());
        for (kind, chunk) in [(b"JSON", &text), (b"BIN\0", &self.bytes)] {
            // Both chunks are shorter than the file, whose length fits into 32 bits.
            file.extend_from_slice(&(chunk.len() as u32).to_le_bytes());
            file.extend_from_slice(kind);
            file.extend_from_slice(chunk);
        }
        Ok(file)
    }
}

const HEADER: usize = 12;
const CHUNK_HEADER: usize = 8;

/// The contents of an accessor.
pub(super) struct Elements {
    component: ComponentType,
    shape: Type,
    count: usize,
    bytes: Vec<u8>,
    /// The least and the greatest value of each component.
    bounds: Option<(Value, Value)>,
}

impl Elements {
    /// Vectors or matrices of `N` numbers.
    pub(super) fn floats<const N: usize>(elements: &[[f32; N]]) -> Self {
        let shape = match N {
            1 => Type::Scalar,
            2 => Type::Vec2,
            3 => Type::Vec3,
            4 => Type::Vec4,
            _ => Type::Mat4,
        };
        let numbers = elements.as_flattened().iter();
        Self {
            component: ComponentType::F32,
            shape,
            count: elements.len(),
            bytes: numbers.flat_map(|number| number.to_le_bytes()).collect(),
            bounds: None,
        }
    }

    /// As [`floats`](Self::floats), with the least and the greatest value of each component stated.
    pub(super) fn bounded_floats<const N: usize>(elements: &[[f32; N]]) -> Self {
        let fold = |start: f32, pick: fn(f32, f32) -> f32| {
            let bound = elements.iter().fold([start; N], |bound, element| {
                std::array::from_fn(|i| pick(bound[i], element[i]))
            });
            Value::from(bound.to_vec())
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
    /// of a type must not be used, since it restarts primitives.)
    pub(super) fn indices(indices: impl Iterator<Item = u32> + Clone, limit: usize) -> Self {
        let count = indices.clone().count();
        let (component, bytes) = if limit <= usize::from(u16::MAX) {
            let short = indices.flat_map(|i| (i as u16).to_le_bytes());
            (ComponentType::U16, short.collect())
        } else {
            (
                ComponentType::U32,
                indices.flat_map(u32::to_le_bytes).collect(),
            )
        };
        Self {
            component,
            shape: Type::Scalar,
            count,
            bytes,
            bounds: None,
        }
    }

    /// Four joints for each vertex, of `joints` in total.
    pub(super) fn joints(elements: &[[u16; 4]], joints: usize) -> Self {
        let numbers = elements.as_flattened().iter();
        let (component, bytes) = if joints <= 256 {
            (ComponentType::U8, numbers.map(|&j| j as u8).collect())
        } else {
            (
                ComponentType::U16,
                numbers.flat_map(|j| j.to_le_bytes()).collect(),
            )
        };
        Self {
            component,
            shape: Type::Vec4,
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
