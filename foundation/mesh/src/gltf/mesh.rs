//! Meshes: primitives with attributes of their vertices, and morph targets.

use super::Extras;

/// Geometry to place in a node.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Its name.
    pub name: Option<String>,
    /// Its parts. All have the same number of morph targets.
    pub primitives: Vec<Primitive>,
    /// The weights of the morph targets, one for each or none; zero where absent.
    pub weights: Vec<f32>,
    /// Data of an application.
    pub extras: Extras,
}

impl Mesh {
    /// The names of the morph targets, which most programs write as `targetNames` in the extras of
    /// the mesh; none where there is not one for each.
    #[must_use]
    pub fn target_names(&self) -> Vec<&str> {
        let count = self.primitives.first().map_or(0, |it| it.targets.len());
        let extras = self.extras.as_ref();
        let names = extras.and_then(|extras| extras.get("targetNames")?.as_array());
        let names = names.map(|names| names.iter().map(|name| name.as_str()).collect());
        names
            .flatten()
            .filter(|names: &Vec<&str>| names.len() == count)
            .unwrap_or_default()
    }
}

/// Points, lines or triangles with one material. Every attribute that is not empty has an item for
/// each vertex.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Primitive {
    /// What the vertices form.
    pub mode: Mode,
    /// `POSITION`: places.
    pub positions: Vec<[f32; 3]>,
    /// `NORMAL`: unit normals.
    pub normals: Vec<[f32; 3]>,
    /// `TANGENT`: unit tangents along u and, as fourth number, the sign of the bitangent
    /// sign · normal × tangent.
    pub tangents: Vec<[f32; 4]>,
    /// `TEXCOORD_n`: sets of texture coordinates (u, v), u to the right and v *down*.
    pub texcoords: Vec<Vec<[f32; 2]>>,
    /// `COLOR_n`: sets of red, green, blue as linear light, and alpha.
    pub colours: Vec<Vec<[f32; 4]>>,
    /// `JOINTS_n`: sets of four joints of the skin each.
    pub joints: Vec<Vec<[u16; 4]>>,
    /// `WEIGHTS_n`: the influence of each of those joints.
    pub weights: Vec<Vec<[f32; 4]>>,
    /// Attributes of an application.
    pub custom: Vec<CustomAttribute>,
    /// The vertices in the order in which [`Mode`] connects them; all in rising order where absent.
    pub indices: Option<Vec<u32>>,
    /// The material; that of [`MaterialElement::default`](super::MaterialElement) where absent.
    pub material: Option<usize>,
    /// Displacements of the vertices. A vertex with weights w is at p + Σ wᵢ dᵢ.
    pub targets: Vec<MorphTarget>,
    /// Data of an application.
    pub extras: Extras,
}

/// Displacements of the attributes of a primitive. Every list that is not empty has an item for
/// each vertex.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MorphTarget {
    /// `POSITION`.
    pub positions: Vec<[f32; 3]>,
    /// `NORMAL`.
    pub normals: Vec<[f32; 3]>,
    /// `TANGENT`, without the sign.
    pub tangents: Vec<[f32; 3]>,
    /// `TEXCOORD_n`.
    pub texcoords: Vec<Vec<[f32; 2]>>,
    /// `COLOR_n`.
    pub colours: Vec<Vec<[f32; 4]>>,
    /// Attributes of an application.
    pub custom: Vec<CustomAttribute>,
}

/// An attribute of an application.
#[derive(Clone, Debug, PartialEq)]
pub struct CustomAttribute {
    /// Its name, which begins with an underscore.
    pub name: String,
    /// How many numbers an item has, and how they are arranged.
    pub shape: Shape,
    /// Whether integers stand for fractions of the greatest integer of their type.
    pub normalized: bool,
    /// The numbers of all items, one item after the other; matrices column by column.
    pub components: Components,
}

/// What the vertices of a primitive form.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Points.
    Points,
    /// Line segments of two vertices each.
    Lines,
    /// A closed chain of line segments.
    LineLoop,
    /// A chain of line segments.
    LineStrip,
    /// Triangles of three vertices each.
    #[default]
    Triangles,
    /// A triangle for each vertex from the third, with the two before it.
    TriangleStrip,
    /// A triangle for each vertex from the third, with the one before it and the first.
    TriangleFan,
}

/// The arrangement of the numbers of an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shape {
    /// One number.
    Scalar,
    /// Two numbers.
    Vec2,
    /// Three numbers.
    Vec3,
    /// Four numbers.
    Vec4,
    /// A 2 × 2 matrix.
    Mat2,
    /// A 3 × 3 matrix.
    Mat3,
    /// A 4 × 4 matrix.
    Mat4,
}

/// Numbers of one of the types that glTF has.
#[derive(Clone, Debug, PartialEq)]
pub enum Components {
    /// `BYTE`.
    I8(Vec<i8>),
    /// `UNSIGNED_BYTE`.
    U8(Vec<u8>),
    /// `SHORT`.
    I16(Vec<i16>),
    /// `UNSIGNED_SHORT`.
    U16(Vec<u16>),
    /// `UNSIGNED_INT`.
    U32(Vec<u32>),
    /// `FLOAT`.
    F32(Vec<f32>),
}

impl Primitive {
    /// How many vertices there are.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        let lengths = [
            self.positions.len(),
            self.normals.len(),
            self.tangents.len(),
            self.texcoords.first().map_or(0, Vec::len),
            self.colours.first().map_or(0, Vec::len),
            self.joints.first().map_or(0, Vec::len),
            self.weights.first().map_or(0, Vec::len),
            self.custom.first().map_or(0, CustomAttribute::len),
        ];
        lengths.into_iter().find(|&length| length > 0).unwrap_or(0)
    }

    /// The triangles as vertices, in the order of the primitive and all with the same orientation;
    /// none for points and lines. Indices that are left over are ignored.
    #[must_use]
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        let indices: Vec<u32>;
        let corners = match &self.indices {
            Some(indices) => indices,
            None => {
                indices = (0..self.vertex_count() as u32).collect();
                &indices
            }
        };
        match self.mode {
            Mode::Triangles => corners.as_chunks().0.to_vec(),
            Mode::TriangleStrip => {
                let numbered = corners.windows(3).enumerate();
                let triangle = |(i, w): (usize, &[u32])| [w[0], w[1 + i % 2], w[2 - i % 2]];
                numbered.map(triangle).collect()
            }
            Mode::TriangleFan => {
                let edges = corners.get(1..).unwrap_or_default().windows(2);
                edges.map(|w| [w[0], w[1], corners[0]]).collect()
            }
            Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => Vec::new(),
        }
    }
}

impl Primitive {
    /// The chains of line segments as vertices, in the order of the primitive; none for points and
    /// triangles. A closed chain ends with the vertex that it begins with. An index that is left
    /// over is ignored.
    #[must_use]
    pub fn polylines(&self) -> Vec<Vec<u32>> {
        match self.mode {
            Mode::Lines => {
                let vertices = self.vertices_in_order();
                let pairs = vertices.as_chunks::<2>().0;
                pairs.iter().map(|pair| pair.to_vec()).collect()
            }
            Mode::LineLoop | Mode::LineStrip => {
                let mut vertices = self.vertices_in_order();
                if self.mode == Mode::LineLoop {
                    vertices.extend(vertices.first().copied());
                }
                if vertices.len() > 1 {
                    vec![vertices]
                } else {
                    Vec::new()
                }
            }
            _ => Vec::new(),
        }
    }

    /// The points as vertices, in the order of the primitive; none for lines and triangles.
    #[must_use]
    pub fn points(&self) -> Vec<u32> {
        if self.mode == Mode::Points {
            self.vertices_in_order()
        } else {
            Vec::new()
        }
    }

    fn vertices_in_order(&self) -> Vec<u32> {
        let all = || (0..self.vertex_count() as u32).collect();
        self.indices.clone().unwrap_or_else(all)
    }
}

impl CustomAttribute {
    /// How many items there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.components.len() / self.shape.components()
    }

    /// Whether there is no item.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Shape {
    /// How many numbers an item has.
    #[must_use]
    pub fn components(self) -> usize {
        self.columns() * self.rows()
    }

    /// How many columns of numbers an item has.
    pub(super) fn columns(self) -> usize {
        match self {
            Self::Scalar | Self::Vec2 | Self::Vec3 | Self::Vec4 => 1,
            Self::Mat2 => 2,
            Self::Mat3 => 3,
            Self::Mat4 => 4,
        }
    }

    /// How many numbers a column has.
    pub(super) fn rows(self) -> usize {
        match self {
            Self::Scalar => 1,
            Self::Vec2 | Self::Mat2 => 2,
            Self::Vec3 | Self::Mat3 => 3,
            Self::Vec4 | Self::Mat4 => 4,
        }
    }
}

impl Components {
    /// How many numbers there are.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::I8(numbers) => numbers.len(),
            Self::U8(numbers) => numbers.len(),
            Self::I16(numbers) => numbers.len(),
            Self::U16(numbers) => numbers.len(),
            Self::U32(numbers) => numbers.len(),
            Self::F32(numbers) => numbers.len(),
        }
    }

    /// Whether the list is empty.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
