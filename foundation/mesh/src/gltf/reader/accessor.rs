//! Accessors: numbers in buffers, in bounds, with sparse changes and normalised integers.

use std::cell::Cell;
use std::collections::HashMap;

use super::super::codes::ComponentType;
use super::super::problem::{Element, Problem};
use super::super::{Components, Shape, json};
use super::buffer::Buffers;
use super::draco;
use super::layout::{Layout, replace};
use crate::FormatError;

/// What an accessor may hold that is read as floating-point numbers.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    /// `FLOAT`.
    Float,
    /// `FLOAT`, or unsigned integers of 8 or 16 bits, normalised.
    Unsigned,
    /// `FLOAT`, or integers of 8 or 16 bits, normalised.
    Normalized,
    /// `FLOAT`, or integers of 8 or 16 bits, by `KHR_mesh_quantization`.
    Quantized,
}

/// Reads accessors, as long as what they hold is in proportion to the size of the file.
pub(super) struct Accessors<'a> {
    root: &'a json::Root,
    buffers: &'a Buffers<'a>,
    /// The bytes of accessors that primitives decompress.
    decompressed: HashMap<usize, Vec<u8>>,
    /// How many bytes may still be decoded.
    budget: Cell<u64>,
    limit: u64,
}

/// The numbers of an accessor, one item after the other; matrices column by column.
pub(super) struct Numbers {
    pub(super) shape: Shape,
    pub(super) normalized: bool,
    pub(super) components: Components,
}

impl<'a> Accessors<'a> {
    /// The bytes that a file of any size may hold when decoded, and the bytes for each of its own.
    /// Several primitives may share an accessor, hence the factor.
    const BASE: u64 = 1 << 26;
    const FACTOR: u64 = 64;

    pub(super) fn new(
        root: &'a json::Root,
        buffers: &'a Buffers<'a>,
        file_size: usize,
    ) -> Result<Self, FormatError> {
        let size = file_size as u64 + buffers.size();
        let limit = size.saturating_mul(Self::FACTOR).saturating_add(Self::BASE);
        let budget = Cell::new(limit);
        Ok(Self {
            root,
            buffers,
            decompressed: draco::decompressed(root, buffers)?,
            budget,
            limit,
        })
    }

    /// Vectors or matrices of `N` numbers.
    pub(super) fn floats<const N: usize>(
        &self,
        index: usize,
        shape: Shape,
        format: Format,
    ) -> Result<Vec<[f32; N]>, FormatError> {
        let numbers = self.read(index)?;
        if numbers.shape != shape {
            return Err(numbers.unexpected(index, format.allowed(shape)));
        }
        let floats = numbers.into_floats(index, format)?;
        Ok(floats.as_chunks().0.to_vec())
    }

    /// Colours, with an alpha of `alpha` where the file has none.
    pub(super) fn colours(
        &self,
        index: usize,
        format: Format,
        alpha: f32,
    ) -> Result<Vec<[f32; 4]>, FormatError> {
        let numbers = self.read(index)?;
        let shape = numbers.shape;
        if !matches!(shape, Shape::Vec3 | Shape::Vec4) {
            return Err(numbers.unexpected(index, format.allowed(Shape::Vec4)));
        }
        let floats = numbers.into_floats(index, format)?;
        if shape == Shape::Vec4 {
            return Ok(floats.as_chunks().0.to_vec());
        }
        let opaque = |&[red, green, blue]: &[f32; 3]| [red, green, blue, alpha];
        Ok(floats.as_chunks().0.iter().map(opaque).collect())
    }

    /// Four joints for each vertex.
    pub(super) fn joints(&self, index: usize) -> Result<Vec<[u16; 4]>, FormatError> {
        let numbers = self.read(index)?;
        let flat: Vec<u16> = match (&numbers.components, numbers.shape, numbers.normalized) {
            (Components::U8(joints), Shape::Vec4, false) => {
                joints.iter().map(|&joint| joint.into()).collect()
            }
            (Components::U16(joints), Shape::Vec4, false) => joints.clone(),
            _ => {
                let allowed = "VEC4 of UNSIGNED_BYTE or UNSIGNED_SHORT";
                return Err(numbers.unexpected(index, allowed));
            }
        };
        Ok(flat.as_chunks().0.to_vec())
    }

    /// Indices of vertices.
    pub(super) fn indices(&self, index: usize) -> Result<Vec<u32>, FormatError> {
        let numbers = self.read(index)?;
        match (numbers.components, numbers.shape, numbers.normalized) {
            (Components::U8(indices), Shape::Scalar, false) => {
                Ok(indices.into_iter().map(u32::from).collect())
            }
            (Components::U16(indices), Shape::Scalar, false) => {
                Ok(indices.into_iter().map(u32::from).collect())
            }
            (Components::U32(indices), Shape::Scalar, false) => Ok(indices),
            (components, shape, normalized) => {
                let numbers = Numbers {
                    shape,
                    normalized,
                    components,
                };
                let allowed = "SCALAR of UNSIGNED_BYTE, UNSIGNED_SHORT or UNSIGNED_INT";
                Err(numbers.unexpected(index, allowed))
            }
        }
    }

    /// The numbers of an accessor, as they are.
    pub(super) fn read(&self, index: usize) -> Result<Numbers, FormatError> {
        let fault = |problem| FormatError::gltf(Element::Accessor(index), problem);
        let Some(accessor) = self.root.accessors.get(index) else {
            return Err(FormatError::dangling(
                "accessor",
                index,
                self.root.accessors.len(),
            ));
        };
        let layout = Layout {
            component: component(accessor.component_type).map_err(fault)?,
            shape: Shape::from_name(&accessor.shape).ok_or_else(|| {
                let value = accessor.shape.clone();
                fault(Problem::Value {
                    property: "type",
                    value,
                })
            })?,
        };
        if accessor.count == 0 {
            let (property, value) = ("count", "0".to_owned());
            return Err(fault(Problem::Value { property, value }));
        }
        let bytes = match accessor.buffer_view {
            Some(view) => {
                let items = Items {
                    view,
                    offset: accessor.byte_offset,
                    count: accessor.count,
                    size: layout.size(),
                    stride: layout.stride(),
                    may_interleave: true,
                };
                Some(self.items(&items).map_err(|e| e.of(index))?)
            }
            None => {
                let bytes = self.decompressed.get(&index);
                bytes.map(|bytes| (&bytes[..], layout.stride()))
            }
        };
        let size = 4 * layout.shape.components() as u64;
        self.charge(accessor.count.saturating_mul(size))
            .map_err(fault)?;
        // A count that the buffers or the budget have room for.
        let count = accessor.count as usize;
        let mut components = match bytes {
            Some((bytes, stride)) => layout.gather(bytes, stride, count),
            None => layout.zeros(count),
        };
        if let Some(sparse) = &accessor.sparse {
            self.apply(sparse, &layout, count, &mut components)
                .map_err(|e| e.of(index))?;
        }
        if let Components::F32(numbers) = &components
            && let Some(at) = numbers.iter().position(|number| !number.is_finite())
        {
            let item = at / layout.shape.components();
            return Err(fault(Problem::NotFinite { item }));
        }
        Ok(Numbers {
            shape: layout.shape,
            normalized: accessor.normalized,
            components,
        })
    }

    /// Takes bytes off the budget.
    pub(super) fn charge(&self, needed: u64) -> Result<(), Problem> {
        let limit = self.limit;
        let left = self.budget.get().checked_sub(needed);
        self.budget
            .set(left.ok_or(Problem::TooLarge { needed, limit })?);
        Ok(())
    }

    /// The bytes from the first item to the last and how many bytes apart the items begin.
    fn items(&self, items: &Items) -> Result<(&'a [u8], usize), Fault> {
        let &Items {
            view,
            offset,
            count,
            size,
            ..
        } = items;
        let (bytes, stride) = self.buffers.view(self.root, view).map_err(Fault::Other)?;
        let stride = stride.filter(|_| items.may_interleave);
        let stride = stride.unwrap_or(items.stride as u64);
        if stride < size as u64 {
            let (property, value) = ("byteStride", stride.to_string());
            return Err(Fault::Here(Problem::Value { property, value }));
        }
        let all = (count.saturating_sub(1)).checked_mul(stride);
        let needed = all
            .and_then(|all| all.checked_add(size as u64)?.checked_add(offset))
            .unwrap_or(u64::MAX);
        let found = bytes.len() as u64;
        if needed > found {
            return Err(Fault::Here(Problem::TooShort { needed, found }));
        }
        // Both are at most the length of a slice.
        Ok((&bytes[offset as usize..needed as usize], stride as usize))
    }

    /// Replaces the items that a sparse accessor lists.
    fn apply(
        &self,
        sparse: &json::Sparse,
        layout: &Layout,
        count: usize,
        components: &mut Components,
    ) -> Result<(), Fault> {
        let changes = sparse.count;
        if changes > count as u64 || changes == 0 {
            let value = changes.to_string();
            let property = "sparse count";
            return Err(Fault::Here(Problem::Value { property, value }));
        }
        let indices = &sparse.indices;
        let width = component(indices.component_type).map_err(Fault::Here)?;
        if !matches!(
            width,
            ComponentType::U8 | ComponentType::U16 | ComponentType::U32
        ) {
            let property = "type of sparse indices";
            let value = width.name().to_owned();
            return Err(Fault::Here(Problem::Value { property, value }));
        }
        let items = Items {
            view: indices.buffer_view,
            offset: indices.byte_offset,
            count: changes,
            size: width.size(),
            stride: width.size(),
            may_interleave: false,
        };
        let (index_bytes, _) = self.items(&items)?;
        let items = Items {
            view: sparse.values.buffer_view,
            offset: sparse.values.byte_offset,
            count: changes,
            size: layout.size(),
            stride: layout.stride(),
            may_interleave: false,
        };
        let (value_bytes, stride) = self.items(&items)?;
        let bytes = changes.saturating_mul(layout.stride() as u64);
        self.charge(bytes).map_err(Fault::Here)?;
        let values = layout.gather(value_bytes, stride, changes as usize);
        let mut targets = Vec::with_capacity(changes as usize);
        let mut least = 0;
        for (position, bytes) in index_bytes.chunks_exact(width.size()).enumerate() {
            let index = bytes
                .iter()
                .rev()
                .fold(0, |index, &byte| index << 8 | u32::from(byte));
            if (index as usize) < least || index as usize >= count {
                return Err(Fault::Here(Problem::SparseIndex {
                    position,
                    index,
                    count,
                }));
            }
            least = index as usize + 1;
            targets.push(index as usize);
        }
        replace(components, &values, &targets, layout.shape.components());
        Ok(())
    }
}

/// A run of items in a part of a buffer.
struct Items {
    view: usize,
    offset: u64,
    count: u64,
    /// The bytes of an item.
    size: usize,
    /// The bytes from an item to the next, unless the buffer view says otherwise.
    stride: usize,
    /// Whether the buffer view may say otherwise.
    may_interleave: bool,
}

/// A problem of the accessor itself, or an error of what it refers to.
enum Fault {
    Here(Problem),
    Other(FormatError),
}

impl Fault {
    fn of(self, accessor: usize) -> FormatError {
        let element = Element::Accessor(accessor);
        match self {
            Self::Here(problem) => FormatError::gltf(element, problem),
            Self::Other(error) => error.within(element),
        }
    }
}

impl Format {
    fn allows(self, component: ComponentType, normalized: bool) -> bool {
        use ComponentType::{F32, I8, I16, U8, U16, U32};
        match component {
            F32 => true,
            U8 | U16 => match self {
                Self::Float => false,
                Self::Unsigned | Self::Normalized => normalized,
                Self::Quantized => true,
            },
            I8 | I16 => match self {
                Self::Float | Self::Unsigned => false,
                Self::Normalized => normalized,
                Self::Quantized => true,
            },
            U32 => false,
        }
    }

    fn allowed(self, shape: Shape) -> &'static str {
        match (self, shape) {
            (Self::Float, Shape::Scalar) => "SCALAR of FLOAT",
            (Self::Float, Shape::Vec2) => "VEC2 of FLOAT",
            (Self::Float, Shape::Vec3) => "VEC3 of FLOAT",
            (Self::Float, Shape::Vec4) => "VEC4 of FLOAT",
            (Self::Float, _) => "MAT4 of FLOAT",
            (Self::Unsigned, _) => {
                "vectors of FLOAT or of normalised UNSIGNED_BYTE or UNSIGNED_SHORT"
            }
            (Self::Normalized, _) => "numbers of FLOAT or of normalised integers of 8 or 16 bits",
            (Self::Quantized, _) => "vectors of FLOAT or of integers of 8 or 16 bits",
        }
    }
}

impl Numbers {
    /// The numbers in single precision; normalised integers as section 3.11 of the specification
    /// prescribes.
    fn into_floats(self, index: usize, format: Format) -> Result<Vec<f32>, FormatError> {
        let component = ComponentType::of(&self.components);
        if !format.allows(component, self.normalized) {
            return Err(self.unexpected(index, format.allowed(self.shape)));
        }
        fn convert<T: Copy + Into<f32>>(integers: Vec<T>, greatest: Option<f32>) -> Vec<f32> {
            let plain = |integer: T| integer.into();
            let fraction = |integer: f32, greatest: f32| (integer / greatest).max(-1.0);
            match greatest {
                None => integers.into_iter().map(plain).collect(),
                Some(greatest) => {
                    let fraction = |integer| fraction(plain(integer), greatest);
                    integers.into_iter().map(fraction).collect()
                }
            }
        }
        let greatest = |greatest: f32| self.normalized.then_some(greatest);
        Ok(match self.components {
            Components::F32(numbers) => numbers,
            Components::I8(numbers) => convert(numbers, greatest(i8::MAX.into())),
            Components::U8(numbers) => convert(numbers, greatest(u8::MAX.into())),
            Components::I16(numbers) => convert(numbers, greatest(i16::MAX.into())),
            Components::U16(numbers) => convert(numbers, greatest(u16::MAX.into())),
            // No format allows these.
            Components::U32(numbers) => numbers.into_iter().map(|n| n as f32).collect(),
        })
    }

    fn unexpected(&self, index: usize, allowed: &'static str) -> FormatError {
        let component = ComponentType::of(&self.components).name();
        let normalized = if self.normalized { "normalised " } else { "" };
        let found = format!("{} of {normalized}{component}", self.shape.name());
        FormatError::gltf(Element::Accessor(index), Problem::Format { found, allowed })
    }
}

fn component(code: u64) -> Result<ComponentType, Problem> {
    ComponentType::from_code(code).ok_or_else(|| Problem::Value {
        property: "componentType",
        value: code.to_string(),
    })
}
