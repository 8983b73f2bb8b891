//! The binary part of a file under construction, with the accessors that describe it.

use std::collections::HashMap;

use super::super::codes::ComponentType;
use super::super::json;
use super::super::{Components, Shape};

/// What a list of numbers is for.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Use {
    /// Attributes of vertices.
    Vertices,
    /// Indices of vertices.
    Indices,
    /// Anything else.
    Other,
}

/// Bytes and what describes them: little-endian, every list at a multiple of four. Equal lists are
/// written once. Views and accessors may follow those of a file that stands before them.
#[derive(Default)]
pub(super) struct Buffer {
    pub(super) bytes: Vec<u8>,
    pub(super) views: Vec<json::BufferView>,
    pub(super) accessors: Vec<json::Accessor>,
    /// How many views and accessors stand before.
    first_view: usize,
    first_accessor: usize,
    /// The accessors of each hash of contents, by their places in `accessors`.
    known: HashMap<u64, Vec<usize>>,
}

impl Use {
    /// The code of the target of the buffer view.
    fn target(self) -> Option<u64> {
        match self {
            Self::Vertices => Some(34962),
            Self::Indices => Some(34963),
            Self::Other => None,
        }
    }
}

impl Buffer {
    /// What follows these bytes, views and accessors.
    pub(super) fn after(mut bytes: Vec<u8>, views: usize, accessors: usize) -> Self {
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        Self {
            bytes,
            first_view: views,
            first_accessor: accessors,
            ..Self::default()
        }
    }

    /// Appends vectors or matrices of `N` numbers.
    pub(super) fn floats<const N: usize>(&mut self, items: &[[f32; N]], purpose: Use) -> usize {
        let shape = match N {
            1 => Shape::Scalar,
            2 => Shape::Vec2,
            3 => Shape::Vec3,
            4 => Shape::Vec4,
            _ => Shape::Mat4,
        };
        let bytes = bytes_of(items.as_flattened(), f32::to_le_bytes);
        self.push(
            items.len(),
            shape,
            ComponentType::F32,
            false,
            purpose,
            &bytes,
        )
    }

    /// As [`floats`](Self::floats), with the least and the greatest value of each number stated.
    pub(super) fn bounded_floats<const N: usize>(
        &mut self,
        items: &[[f32; N]],
        purpose: Use,
    ) -> usize {
        let accessor = self.floats(items, purpose);
        let fold = |start: f32, pick: fn(f32, f32) -> f32| {
            let bounds = items.iter().fold([start; N], |bounds, item| {
                std::array::from_fn(|i| pick(bounds[i], item[i]))
            });
            bounds.to_vec()
        };
        let described = &mut self.accessors[accessor - self.first_accessor];
        described.min = fold(f32::INFINITY, f32::min);
        described.max = fold(f32::NEG_INFINITY, f32::max);
        accessor
    }

    /// Appends indices of `vertices` vertices, in the smallest type that glTF allows for them. (The
    /// greatest value of a type must not be used, since it restarts primitives.)
    pub(super) fn indices(&mut self, indices: &[u32], vertices: usize) -> usize {
        let (component, bytes) = if vertices <= usize::from(u16::MAX) {
            let short = bytes_of(indices, |index| (index as u16).to_le_bytes());
            (ComponentType::U16, short)
        } else {
            (ComponentType::U32, bytes_of(indices, u32::to_le_bytes))
        };
        let count = indices.len();
        self.push(count, Shape::Scalar, component, false, Use::Indices, &bytes)
    }

    /// Appends four joints for each vertex, in the smallest type that holds them.
    pub(super) fn joints(&mut self, joints: &[[u16; 4]]) -> usize {
        let numbers = joints.as_flattened();
        let greatest = numbers.iter().copied().max().unwrap_or(0);
        let (component, bytes) = if u8::try_from(greatest).is_ok() {
            (ComponentType::U8, bytes_of(numbers, |joint| [joint as u8]))
        } else {
            (ComponentType::U16, bytes_of(numbers, u16::to_le_bytes))
        };
        let count = joints.len();
        self.push(count, Shape::Vec4, component, false, Use::Vertices, &bytes)
    }

    /// Appends an attribute of an application. Items begin at multiples of four bytes.
    pub(super) fn custom(&mut self, shape: Shape, normalized: bool, numbers: &Components) -> usize {
        let bytes = match numbers {
            Components::I8(numbers) => bytes_of(numbers, i8::to_le_bytes),
            Components::U8(numbers) => bytes_of(numbers, u8::to_le_bytes),
            Components::I16(numbers) => bytes_of(numbers, i16::to_le_bytes),
            Components::U16(numbers) => bytes_of(numbers, u16::to_le_bytes),
            Components::U32(numbers) => bytes_of(numbers, u32::to_le_bytes),
            Components::F32(numbers) => bytes_of(numbers, f32::to_le_bytes),
        };
        let component = ComponentType::of(numbers);
        let column = shape.rows() * component.size();
        let column_stride = shape.column_stride(component);
        let stride = shape.stride(component).next_multiple_of(4);
        let mut padded = Vec::with_capacity(bytes.len());
        for item in bytes.chunks(column * shape.columns()) {
            let start = padded.len();
            for column in item.chunks(column) {
                let end = padded.len() + column_stride;
                padded.extend_from_slice(column);
                padded.resize(end, 0);
            }
            padded.resize(start + stride, 0);
        }
        let count = numbers.len() / shape.components();
        let purpose = Use::Vertices;
        let accessor = self.push(count, shape, component, normalized, purpose, &padded);
        // Stated too where nothing but the padding of the last column makes the difference.
        if stride != shape.size(component)
            && let Some(view) = self.accessors[accessor - self.first_accessor].buffer_view
        {
            self.views[view - self.first_view].byte_stride = Some(stride as u64);
        }
        accessor
    }

    /// Appends bytes that are not numbers, such as those of an image; returns their buffer view.
    pub(super) fn blob(&mut self, bytes: &[u8]) -> usize {
        self.view(bytes, Use::Other)
    }

    fn view(&mut self, bytes: &[u8], purpose: Use) -> usize {
        self.views.push(json::BufferView {
            buffer: 0,
            byte_offset: self.bytes.len() as u64,
            byte_length: bytes.len() as u64,
            byte_stride: None,
            target: purpose.target(),
        });
        self.bytes.extend_from_slice(bytes);
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        self.first_view + self.views.len() - 1
    }

    fn push(
        &mut self,
        count: usize,
        shape: Shape,
        component: ComponentType,
        normalized: bool,
        purpose: Use,
        bytes: &[u8],
    ) -> usize {
        use std::hash::{DefaultHasher, Hash, Hasher};
        let mut hasher = DefaultHasher::new();
        (shape, component, normalized, purpose, bytes).hash(&mut hasher);
        let hash = hasher.finish();
        let is_same = |&accessor: &usize| {
            let accessor = &self.accessors[accessor];
            let Some(view) = accessor.buffer_view else {
                return false;
            };
            let view = &self.views[view - self.first_view];
            let start = view.byte_offset as usize;
            accessor.shape == shape.name()
                && accessor.component_type == component.code()
                && accessor.normalized == normalized
                && view.target == purpose.target()
                && self.bytes.get(start..start + view.byte_length as usize) == Some(bytes)
        };
        let known = self.known.get(&hash);
        if let Some(&same) = known.and_then(|known| known.iter().find(|known| is_same(known))) {
            return self.first_accessor + same;
        }
        let view = self.view(bytes, purpose);
        self.accessors.push(json::Accessor {
            buffer_view: Some(view),
            byte_offset: 0,
            component_type: component.code(),
            count: count as u64,
            shape: shape.name().to_owned(),
            normalized,
            sparse: None,
            min: Vec::new(),
            max: Vec::new(),
        });
        let accessor = self.accessors.len() - 1;
        self.known.entry(hash).or_default().push(accessor);
        self.first_accessor + accessor
    }
}

fn bytes_of<T: Copy, const N: usize>(numbers: &[T], bytes: impl Fn(T) -> [u8; N]) -> Vec<u8> {
    numbers.iter().flat_map(|&number| bytes(number)).collect()
}
