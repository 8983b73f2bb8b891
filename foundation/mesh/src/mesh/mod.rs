//! Meshes.

mod attributes;
mod part;

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use crate::{
    Faces, Material, MeshError, Normals, Polylines, Rgba, Tangents, TextureCoordinates, bounds,
};

pub use part::Part;

/// The position of one vertex, as a conformal point: three coordinates are stored, and products see
/// the whole conformal vector.
pub type Position = Point<f64>;

/// A polygon mesh whose indices are all in range and whose numbers are all finite.
///
/// Vertices have positions and may have colours. Corners of faces may have texture coordinates,
/// normals and tangents, each with its own numbering, so that vertices need not be split where
/// these differ between faces. Faces may be in groups and objects and may have a material.
/// Polylines and single points may be drawn beside the faces. Positions carry the unit and the axes
/// of their source; see [`Mesh::scaled`].
///
/// # Examples
///
/// ```
/// use ga_mesh::{CornerAttribute, Faces, Material, Mesh};
///
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
/// let square = Mesh::new(corners.to_vec(), Faces::from_polygons([[0, 1, 2, 3]])?)?;
/// assert_eq!(square.triangles(), [[0, 1, 2], [0, 2, 3]]);
///
/// let picture = corners.map(|[x, y, _]| [x, y]).to_vec();
/// let coordinates = CornerAttribute::of_vertices(picture, square.faces());
/// let painted = square
///     .with_texture_coordinates(vec![coordinates])?
///     .with_materials(vec![Material::named("paint")], vec![Some(0)])?;
/// assert_eq!(painted.material(0).map(|material| material.name.as_str()), Some("paint"));
/// # Ok::<(), ga_mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    positions: Vec<Position>,
    faces: Faces,
    colours: Option<Vec<Rgba>>,
    texture_coordinates: Vec<TextureCoordinates>,
    normals: Option<Normals>,
    tangents: Option<Tangents>,
    groups: Vec<Group>,
    objects: Vec<Group>,
    materials: Vec<Material>,
    /// Empty without materials, else one for each face.
    face_materials: Vec<Option<u32>>,
    polylines: Polylines,
    points: Vec<u32>,
}

/// A named set of faces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// The name, as the file has it.
    pub name: String,
    /// The faces in the group, in rising order.
    pub faces: Vec<u32>,
}

impl Mesh {
    /// A mesh of these vertices and faces, without any other attribute.
    ///
    /// # Errors
    ///
    /// [`MeshError::NotFinite`] and [`MeshError::IndexOutOfRange`]; [`MeshError::TooLarge`] past
    /// 2³² − 1 vertices.
    pub fn new<P: Into<Position>>(positions: Vec<P>, faces: Faces) -> Result<Self, MeshError> {
        let positions: Vec<Position> = positions.into_iter().map(Into::into).collect();
        if u32::try_from(positions.len()).is_err() {
            let count = positions.len();
            return Err(MeshError::TooLarge {
                what: "vertices",
                count,
            });
        }
        for (vertex, position) in positions.iter().enumerate() {
            let coordinates = position.coordinates();
            if !coordinates.iter().all(|x| x.is_finite()) {
                return Err(MeshError::NotFinite {
                    vertex,
                    coordinates,
                });
            }
        }
        let vertices = positions.len();
        for (face, corners) in faces.iter().enumerate() {
            if let Some(&index) = corners.iter().find(|&&index| index as usize >= vertices) {
                return Err(MeshError::IndexOutOfRange {
                    face,
                    index,
                    vertices,
                });
            }
        }
        Ok(Self {
            positions,
            faces,
            colours: None,
            texture_coordinates: Vec::new(),
            normals: None,
            tangents: None,
            groups: Vec::new(),
            objects: Vec::new(),
            materials: Vec::new(),
            face_materials: Vec::new(),
            polylines: Polylines::default(),
            points: Vec::new(),
        })
    }

    /// The number of vertices, including those that no face uses.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.positions.len()
    }

    /// The positions of the vertices.
    #[must_use]
    pub fn positions(&self) -> &[Position] {
        &self.positions
    }

    /// The Euclidean coordinates of the vertices, one after the other.
    pub fn coordinates(&self) -> impl ExactSizeIterator<Item = [f64; 3]> + '_ {
        self.positions.iter().map(|position| position.coordinates())
    }

    /// The polygons.
    #[must_use]
    pub fn faces(&self) -> &Faces {
        &self.faces
    }

    /// The polygons split into triangles; see [`Faces::triangles`].
    #[must_use]
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        self.faces.triangles(&self.positions)
    }

    /// The same triangles as indices into the corners of all faces; see
    /// [`Faces::corner_triangles`].
    #[must_use]
    pub fn corner_triangles(&self) -> Vec<[u32; 3]> {
        self.faces.corner_triangles(&self.positions)
    }

    /// The least and the greatest value of each coordinate, or `None` without vertices.
    #[must_use]
    pub fn bounds(&self) -> Option<[[f64; 3]; 2]> {
        let corners = bounds(self.coordinates().map(Vector::from))?;
        Some(corners.map(Vector::coordinates))
    }

    /// The same mesh with other positions of its vertices, as after skinning. Normals and tangents
    /// are left out, since they belong to the shape as it was.
    ///
    /// # Errors
    ///
    /// As [`Mesh::new`]; fewer positions than before leave faces with
    /// [`MeshError::IndexOutOfRange`], and another number with [`MeshError::VertexCount`].
    pub fn with_positions<P: Into<Position>>(&self, positions: Vec<P>) -> Result<Self, MeshError> {
        let moved = Self::new(positions, self.faces.clone())?;
        let (expected, found) = (self.vertex_count(), moved.vertex_count());
        if expected != found {
            return Err(MeshError::VertexCount { expected, found });
        }
        Ok(Self {
            positions: moved.positions,
            faces: moved.faces,
            colours: self.colours.clone(),
            texture_coordinates: self.texture_coordinates.clone(),
            normals: None,
            tangents: None,
            groups: self.groups.clone(),
            objects: self.objects.clone(),
            materials: self.materials.clone(),
            face_materials: self.face_materials.clone(),
            polylines: self.polylines.clone(),
            points: self.points.clone(),
        })
    }

    /// The same mesh in another unit: every coordinate times `factor`. Normals and tangents stay.
    ///
    /// A mesh in decimetres becomes one in metres with `0.1`.
    ///
    /// # Errors
    ///
    /// [`MeshError::NotFinite`] when a product overflows or `factor` is not a number.
    pub fn scaled(&self, factor: f64) -> Result<Self, MeshError> {
        let scaled =
            self.with_positions(self.coordinates().map(|x| x.map(|x| x * factor)).collect())?;
        Ok(Self {
            normals: self.normals.clone(),
            tangents: self.tangents.clone(),
            ..scaled
        })
    }
}
