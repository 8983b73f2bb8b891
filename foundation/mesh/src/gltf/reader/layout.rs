//! How the numbers of an accessor lie in bytes.

use super::super::codes::ComponentType;
use super::super::{Components, Shape};

/// Where the numbers of an item are.
pub(super) struct Layout {
    pub(super) component: ComponentType,
    pub(super) shape: Shape,
}

impl Layout {
    /// The bytes of an item.
    pub(super) fn size(&self) -> usize {
        self.shape.size(self.component)
    }

    /// The bytes from an item to the next where nothing else is stated.
    pub(super) fn stride(&self) -> usize {
        self.shape.stride(self.component)
    }

    pub(super) fn zeros(&self, count: usize) -> Components {
        let numbers = count * self.shape.components();
        match self.component {
            ComponentType::I8 => Components::I8(vec![0; numbers]),
            ComponentType::U8 => Components::U8(vec![0; numbers]),
            ComponentType::I16 => Components::I16(vec![0; numbers]),
            ComponentType::U16 => Components::U16(vec![0; numbers]),
            ComponentType::U32 => Components::U32(vec![0; numbers]),
            ComponentType::F32 => Components::F32(vec![0.0; numbers]),
        }
    }

    pub(super) fn gather(&self, bytes: &[u8], stride: usize, count: usize) -> Components {
        match self.component {
            ComponentType::I8 => {
                Components::I8(self.numbers(bytes, stride, count, i8::from_le_bytes))
            }
            ComponentType::U8 => {
                Components::U8(self.numbers(bytes, stride, count, u8::from_le_bytes))
            }
            ComponentType::I16 => {
                Components::I16(self.numbers(bytes, stride, count, i16::from_le_bytes))
            }
            ComponentType::U16 => {
                Components::U16(self.numbers(bytes, stride, count, u16::from_le_bytes))
            }
            ComponentType::U32 => {
                Components::U32(self.numbers(bytes, stride, count, u32::from_le_bytes))
            }
            ComponentType::F32 => {
                Components::F32(self.numbers(bytes, stride, count, f32::from_le_bytes))
            }
        }
    }

    /// `count` items, `stride` bytes apart; the last may end where `bytes` ends.
    fn numbers<T, const SIZE: usize>(
        &self,
        bytes: &[u8],
        stride: usize,
        count: usize,
        number: fn([u8; SIZE]) -> T,
    ) -> Vec<T> {
        let column_size = self.shape.rows() * SIZE;
        let column_stride = self.shape.column_stride(self.component);
        let mut numbers = Vec::with_capacity(count * self.shape.components());
        for item in bytes.chunks(stride).take(count) {
            for column in item.chunks(column_stride).take(self.shape.columns()) {
                let column = &column[..column_size.min(column.len())];
                numbers.extend(column.as_chunks().0.iter().map(|&bytes| number(bytes)));
            }
        }
        numbers
    }
}

/// Replaces the items at `targets` by `values`; both are of one type.
pub(super) fn replace(
    components: &mut Components,
    values: &Components,
    targets: &[usize],
    width: usize,
) {
    fn copy<T: Copy>(numbers: &mut [T], values: &[T], targets: &[usize], width: usize) {
        for (value, &target) in values.chunks_exact(width).zip(targets) {
            numbers[target * width..][..width].copy_from_slice(value);
        }
    }
    match (components, values) {
        (Components::I8(n), Components::I8(v)) => copy(n, v, targets, width),
        (Components::U8(n), Components::U8(v)) => copy(n, v, targets, width),
        (Components::I16(n), Components::I16(v)) => copy(n, v, targets, width),
        (Components::U16(n), Components::U16(v)) => copy(n, v, targets, width),
        (Components::U32(n), Components::U32(v)) => copy(n, v, targets, width),
        (Components::F32(n), Components::F32(v)) => copy(n, v, targets, width),
        _ => {}
    }
}
