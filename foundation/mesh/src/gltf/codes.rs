//! The codes and names that stand for shapes, types, modes and filters in the JSON.

use super::json::{component_type, sampling};
use super::{Components, Interpolation, Mode, Shape};
use crate::{Filter, Minification, Wrap};

/// The type of the numbers of an accessor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum ComponentType {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl ComponentType {
    pub(super) fn from_code(code: u64) -> Option<Self> {
        Some(match code {
            component_type::BYTE => Self::I8,
            component_type::UNSIGNED_BYTE => Self::U8,
            component_type::SHORT => Self::I16,
            component_type::UNSIGNED_SHORT => Self::U16,
            component_type::UNSIGNED_INT => Self::U32,
            component_type::FLOAT => Self::F32,
            _ => return None,
        })
    }

    pub(super) fn code(self) -> u64 {
        match self {
            Self::I8 => component_type::BYTE,
            Self::U8 => component_type::UNSIGNED_BYTE,
            Self::I16 => component_type::SHORT,
            Self::U16 => component_type::UNSIGNED_SHORT,
            Self::U32 => component_type::UNSIGNED_INT,
            Self::F32 => component_type::FLOAT,
        }
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::I8 => "BYTE",
            Self::U8 => "UNSIGNED_BYTE",
            Self::I16 => "SHORT",
            Self::U16 => "UNSIGNED_SHORT",
            Self::U32 => "UNSIGNED_INT",
            Self::F32 => "FLOAT",
        }
    }

    /// The bytes of a number.
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    pub(super) fn of(components: &Components) -> Self {
        match components {
            Components::I8(_) => Self::I8,
            Components::U8(_) => Self::U8,
            Components::I16(_) => Self::I16,
            Components::U16(_) => Self::U16,
            Components::U32(_) => Self::U32,
            Components::F32(_) => Self::F32,
        }
    }
}

impl Shape {
    const NAMES: [(Self, &'static str); 7] = [
        (Self::Scalar, "SCALAR"),
        (Self::Vec2, "VEC2"),
        (Self::Vec3, "VEC3"),
        (Self::Vec4, "VEC4"),
        (Self::Mat2, "MAT2"),
        (Self::Mat3, "MAT3"),
        (Self::Mat4, "MAT4"),
    ];

    pub(super) fn from_name(name: &str) -> Option<Self> {
        let mut names = Self::NAMES.into_iter();
        names.find(|pair| pair.1 == name).map(|pair| pair.0)
    }

    pub(super) fn name(self) -> &'static str {
        Self::NAMES[self as usize].1
    }

    /// How many bytes apart the columns of an item begin: those of a matrix begin at multiples of
    /// four bytes.
    pub(super) fn column_stride(self, component: ComponentType) -> usize {
        let size = self.rows() * component.size();
        if self.columns() > 1 {
            size.next_multiple_of(4)
        } else {
            size
        }
    }

    /// The bytes from an item to the next where nothing else is stated.
    pub(super) fn stride(self, component: ComponentType) -> usize {
        self.columns() * self.column_stride(component)
    }

    /// The bytes of an item, without padding behind its last column.
    pub(super) fn size(self, component: ComponentType) -> usize {
        (self.columns() - 1) * self.column_stride(component) + self.rows() * component.size()
    }
}

impl Mode {
    pub(super) fn from_code(code: u64) -> Option<Self> {
        Some(match code {
            0 => Self::Points,
            1 => Self::Lines,
            2 => Self::LineLoop,
            3 => Self::LineStrip,
            4 => Self::Triangles,
            5 => Self::TriangleStrip,
            6 => Self::TriangleFan,
            _ => return None,
        })
    }

    pub(super) fn code(self) -> u64 {
        self as u64
    }
}

impl Interpolation {
    pub(super) fn from_name(name: &str) -> Option<Self> {
        Some(match name {
            "LINEAR" => Self::Linear,
            "STEP" => Self::Step,
            "CUBICSPLINE" => Self::CubicSpline,
            _ => return None,
        })
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Linear => "LINEAR",
            Self::Step => "STEP",
            Self::CubicSpline => "CUBICSPLINE",
        }
    }
}

impl Filter {
    pub(super) fn from_code(code: u64) -> Option<Self> {
        match code {
            sampling::NEAREST => Some(Self::Nearest),
            sampling::LINEAR => Some(Self::Linear),
            _ => None,
        }
    }

    pub(super) fn code(self) -> u64 {
        match self {
            Self::Nearest => sampling::NEAREST,
            Self::Linear => sampling::LINEAR,
        }
    }
}

impl Minification {
    pub(super) fn from_code(code: u64) -> Option<Self> {
        use Filter::{Linear, Nearest};
        let (filter, levels) = match code {
            sampling::NEAREST => (Nearest, None),
            sampling::LINEAR => (Linear, None),
            sampling::NEAREST_MIPMAP_NEAREST => (Nearest, Some(Nearest)),
            sampling::LINEAR_MIPMAP_NEAREST => (Linear, Some(Nearest)),
            sampling::NEAREST_MIPMAP_LINEAR => (Nearest, Some(Linear)),
            sampling::LINEAR_MIPMAP_LINEAR => (Linear, Some(Linear)),
            _ => return None,
        };
        Some(Self { filter, levels })
    }

    pub(super) fn code(self) -> u64 {
        use Filter::{Linear, Nearest};
        match (self.filter, self.levels) {
            (filter, None) => filter.code(),
            (Nearest, Some(Nearest)) => sampling::NEAREST_MIPMAP_NEAREST,
            (Linear, Some(Nearest)) => sampling::LINEAR_MIPMAP_NEAREST,
            (Nearest, Some(Linear)) => sampling::NEAREST_MIPMAP_LINEAR,
            (Linear, Some(Linear)) => sampling::LINEAR_MIPMAP_LINEAR,
        }
    }
}

impl Wrap {
    pub(super) fn from_code(code: u64) -> Option<Self> {
        match code {
            sampling::REPEAT => Some(Self::Repeat),
            sampling::MIRRORED_REPEAT => Some(Self::MirroredRepeat),
            sampling::CLAMP_TO_EDGE => Some(Self::ClampToEdge),
            _ => None,
        }
    }

    pub(super) fn code(self) -> u64 {
        match self {
            Self::Repeat => sampling::REPEAT,
            Self::MirroredRepeat => sampling::MIRRORED_REPEAT,
            Self::ClampToEdge => sampling::CLAMP_TO_EDGE,
        }
    }
}
