//! What a picture shows.

use ga_image::colour::LinearColour;
use ga_runtime::cga3::Motor;

use crate::{Appearance, Ground};

/// What a picture shows: objects with their materials, lines and dots over them, the ground.
#[derive(Clone, Debug, Default)]
pub struct Scene<'a> {
    /// The objects. What is seen does not depend on their order.
    pub objects: Vec<Object<'a>>,
    /// The materials that objects name by index.
    pub materials: &'a [Appearance<'a>],
    /// Lines, drawn over the objects one after the other.
    pub lines: &'a [Polyline<'a>],
    /// Dots, drawn over the lines.
    pub dots: &'a [Dot],
    /// Segments drawn over the picture in the style's colours, with a dot at each end; hidden by
    /// nothing.
    pub bones: &'a [[[f64; 3]; 2]],
    /// The ground, if there is one.
    pub ground: Option<Ground>,
}

/// A triangle mesh in the world.
#[derive(Clone, Debug)]
pub struct Object<'a> {
    /// One point for each vertex, in the object's own coordinates.
    pub positions: &'a [[f64; 3]],
    /// Three vertex indices for each triangle, counter-clockwise seen from outside.
    pub triangles: &'a [[u32; 3]],
    /// The normals by which it is shaded.
    pub normals: Normals<'a>,
    /// Texture coordinates (u, v), u to the right and v up: the unit square is one picture, and
    /// (0, 0) its lower left corner. glTF counts v downwards, so that its v is 1 − v here.
    pub texture_coordinates: Option<Attribute<'a, [f64; 2]>>,
    /// A second set of texture coordinates, for materials with textures that are placed by it.
    pub second_texture_coordinates: Option<Attribute<'a, [f64; 2]>>,
    /// Tangents for normal maps: the direction in which u grows, and the sign σ of the bitangent
    /// `b = σ n × t` along which v grows, as MikkTSpace defines them. Where they are left out, each
    /// triangle's own direction of growing u is taken.
    pub tangents: Option<Attribute<'a, [f64; 4]>>,
    /// Factors of the base colour, in linear light, and of the opacity.
    pub colours: Option<Attribute<'a, [f64; 4]>>,
    /// The materials of its triangles.
    pub material: MaterialChoice<'a>,
    /// The motion from the object's coordinates to the world.
    pub transform: Motor<f64>,
}

/// Values at the corners of triangles.
#[derive(Clone, Copy, Debug)]
pub struct Attribute<'a, T> {
    /// The values.
    pub values: &'a [T],
    /// For each triangle the values at its corners, or `None` where it has none. Without this list,
    /// values are numbered as vertices are.
    pub corners: Option<&'a [Option<[u32; 3]>]>,
}

/// The normals by which an object is shaded.
#[derive(Clone, Copy, Debug, Default)]
pub enum Normals<'a> {
    /// At each vertex the mean of the normals of its triangles, weighted by area; between vertices
    /// linear.
    #[default]
    Smooth,
    /// The normal of each triangle.
    Flat,
    /// These, in the object's coordinates; of any length. A triangle without them is shaded flat.
    Given(Attribute<'a, [f64; 3]>),
}

/// Which materials an object has.
#[derive(Clone, Copy, Debug, Default)]
pub enum MaterialChoice<'a> {
    /// The surface that the [`Style`](crate::Style) describes.
    #[default]
    Style,
    /// One material, by its index in [`Scene::materials`].
    One(u32),
    /// A material for each triangle, or `None` for the style's.
    PerTriangle(&'a [Option<u32>]),
}

/// A line through points of the world.
#[derive(Clone, Copy, Debug)]
pub struct Polyline<'a> {
    /// The points, two at least for a line to be seen.
    pub points: &'a [[f64; 3]],
    /// Its colour.
    pub colour: LinearColour,
    /// Its width in pixels.
    pub width: f64,
    /// Whether surfaces hide it.
    pub visibility: Visibility,
}

/// A disc around a point of the world, which faces the camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dot {
    /// Its centre.
    pub position: [f64; 3],
    /// Its colour.
    pub colour: LinearColour,
    /// Its diameter in pixels.
    pub diameter: f64,
    /// Whether surfaces hide it.
    pub visibility: Visibility,
}

/// Whether surfaces hide a line or a dot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Visibility {
    /// It is hidden where a surface lies in front of it by more than 0.2 % of its depth, so that
    /// what lies on a surface is seen. A dot is hidden or seen as a whole, a line place by place.
    #[default]
    Hidden,
    /// It is seen through everything.
    OnTop,
}

impl<'a> Scene<'a> {
    /// One mesh alone, in the style's colour.
    pub fn new(positions: &'a [[f64; 3]], triangles: &'a [[u32; 3]]) -> Self {
        Self {
            objects: vec![Object::new(positions, triangles)],
            ..Self::default()
        }
    }
}

impl<'a> Object<'a> {
    /// A mesh in its place, smooth, in the style's colour.
    pub fn new(positions: &'a [[f64; 3]], triangles: &'a [[u32; 3]]) -> Self {
        Self {
            positions,
            triangles,
            normals: Normals::Smooth,
            texture_coordinates: None,
            second_texture_coordinates: None,
            tangents: None,
            colours: None,
            material: MaterialChoice::Style,
            transform: Motor::default(),
        }
    }
}

impl<'a, T: Copy> Attribute<'a, T> {
    /// One value for each vertex.
    pub fn of_vertices(values: &'a [T]) -> Self {
        Self {
            values,
            corners: None,
        }
    }

    /// Values with numbers of their own.
    pub fn of_corners(values: &'a [T], corners: &'a [Option<[u32; 3]>]) -> Self {
        Self {
            values,
            corners: Some(corners),
        }
    }

    /// The values at the corners of a triangle, whose vertices are `vertices`.
    pub(crate) fn at(&self, triangle: usize, vertices: [u32; 3]) -> Option<[T; 3]> {
        let indices = match self.corners {
            None => vertices,
            Some(corners) => corners[triangle]?,
        };
        Some(indices.map(|index| self.values[index as usize]))
    }
}

impl MaterialChoice<'_> {
    /// The material of a triangle.
    pub(crate) fn of(&self, triangle: usize) -> Option<u32> {
        match self {
            Self::Style => None,
            Self::One(material) => Some(*material),
            Self::PerTriangle(materials) => materials[triangle],
        }
    }
}
