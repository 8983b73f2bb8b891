//! Polygon meshes: vertices in the order of their file, faces with any number of corners.
//!
//! A mesh is a list of points and a list of polygons that refer to them by index. Polygons are kept
//! as they were read, quadrilaterals included; whoever needs triangles asks for them. Nothing here
//! splits or merges vertices, so that weights, targets and other data numbered by vertex go on
//! fitting.

mod faces;
mod part;

use ga_runtime::cga3::Point;

pub use faces::{Faces, Polygons};
pub use part::Part;

/// The place of one vertex, as a conformal point: three coordinates, and the whole vector to every
/// product.
pub type Position = Point<f64>;

/// A polygon mesh whose indices are all in range and whose numbers are all finite.
///
/// Positions carry the unit and the axes of their source; see [`Mesh::scaled`].
///
/// # Examples
///
/// ```
/// use ga_anim::mesh::{Faces, Mesh};
///
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
/// let square = Mesh::new(corners.to_vec(), Faces::from_polygons([[0, 1, 2, 3]])?)?;
/// assert_eq!(square.triangles(), [[0, 1, 2], [0, 2, 3]]);
/// # Ok::<(), ga_anim::mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    positions: Vec<Position>,
    faces: Faces,
    texture: Option<Texture>,
    groups: Vec<Group>,
}

/// Texture coordinates, numbered apart from the vertices: one vertex may have another coordinate in
/// each of its faces.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// The coordinates (u, v), u to the right and v up, the unit square being one picture.
    pub coordinates: Vec<[f64; 2]>,
    /// For each corner of each face, in the order of [`Faces::corners`], the coordinate it has, if
    /// any.
    pub corners: Vec<Option<u32>>,
}

/// A named set of faces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// The name, as the file has it.
    pub name: String,
    /// The faces in the group, in rising order.
    pub faces: Vec<u32>,
}

/// Data that are no mesh. Vertices, faces and corners are counted from 0.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// A face has fewer than three corners.
    #[error("face {face} has {corners} corners; a polygon has at least 3")]
    FaceTooShort {
        /// The face.
        face: usize,
        /// How many corners it has.
        corners: usize,
    },
    /// A face refers to a vertex that does not exist.
    #[error("face {face} refers to vertex {index}, but there are {vertices} vertices")]
    IndexOutOfRange {
        /// The face.
        face: usize,
        /// The vertex it refers to.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A coordinate of a vertex is infinite or not a number.
    #[error("vertex {vertex} has a coordinate that is not finite: {coordinates:?}")]
    NotFinite {
        /// The vertex.
        vertex: usize,
        /// Its coordinates.
        coordinates: [f64; 3],
    },
    /// A texture coordinate is infinite or not a number.
    #[error("texture coordinate {index} is not finite: {coordinates:?}")]
    TextureNotFinite {
        /// The texture coordinate.
        index: usize,
        /// Its value.
        coordinates: [f64; 2],
    },
    /// The list of texture corners is not as long as the list of face corners.
    #[error("{found} texture corners for {expected} corners of faces")]
    TextureLength {
        /// Corners of faces.
        expected: usize,
        /// Corners with texture.
        found: usize,
    },
    /// A corner refers to a texture coordinate that does not exist.
    #[error("corner {corner} refers to texture coordinate {index}, but there are {coordinates}")]
    TextureIndexOutOfRange {
        /// The corner.
        corner: usize,
        /// The texture coordinate it refers to.
        index: u32,
        /// How many there are.
        coordinates: usize,
    },
    /// A group refers to a face that does not exist.
    #[error("group {group:?} refers to face {face}, but there are {faces} faces")]
    GroupOutOfRange {
        /// The group.
        group: String,
        /// The face it refers to.
        face: u32,
        /// How many faces there are.
        faces: usize,
    },
    /// More vertices or corners than 32-bit indices can tell apart.
    #[error("{count} {what} are more than 32-bit indices can tell apart")]
    TooLarge {
        /// What there is too much of.
        what: &'static str,
        /// How many there are.
        count: usize,
    },
}

impl Mesh {
    /// A mesh of these vertices and faces, without texture coordinates or groups.
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
            texture: None,
            groups: Vec::new(),
        })
    }

    /// The same mesh with these texture coordinates.
    ///
    /// # Errors
    ///
    /// [`MeshError::TextureNotFinite`], [`MeshError::TextureLength`] and
    /// [`MeshError::TextureIndexOutOfRange`].
    pub fn with_texture(mut self, texture: Texture) -> Result<Self, MeshError> {
        for (index, &coordinates) in texture.coordinates.iter().enumerate() {
            if !coordinates.iter().all(|x| x.is_finite()) {
                return Err(MeshError::TextureNotFinite { index, coordinates });
            }
        }
        let (expected, found) = (self.faces.corners().len(), texture.corners.len());
        if expected != found {
            return Err(MeshError::TextureLength { expected, found });
        }
        let coordinates = texture.coordinates.len();
        for (corner, index) in texture.corners.iter().enumerate() {
            if let Some(index) = index.filter(|&index| index as usize >= coordinates) {
                return Err(MeshError::TextureIndexOutOfRange {
                    corner,
                    index,
                    coordinates,
                });
            }
        }
        self.texture = Some(texture);
        Ok(self)
    }

    /// The same mesh with these groups; the faces of each are put in rising order, each once.
    ///
    /// # Errors
    ///
    /// [`MeshError::GroupOutOfRange`].
    pub fn with_groups(mut self, mut groups: Vec<Group>) -> Result<Self, MeshError> {
        let faces = self.faces.len();
        for group in &mut groups {
            group.faces.sort_unstable();
            group.faces.dedup();
            if let Some(&face) = group.faces.last().filter(|&&face| face as usize >= faces) {
                let group = group.name.clone();
                return Err(MeshError::GroupOutOfRange { group, face, faces });
            }
        }
        self.groups = groups;
        Ok(self)
    }

    /// How many vertices there are, those that no face uses included.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.positions.len()
    }

    /// The places of the vertices.
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

    /// The polygons cut into triangles, fan-wise; see [`Faces::triangles`].
    #[must_use]
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        self.faces.triangles()
    }

    /// The texture coordinates, if the mesh has any.
    #[must_use]
    pub fn texture(&self) -> Option<&Texture> {
        self.texture.as_ref()
    }

    /// The groups, in the order of the file.
    #[must_use]
    pub fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// The group of this name.
    #[must_use]
    pub fn group(&self, name: &str) -> Option<&Group> {
        self.groups.iter().find(|group| group.name == name)
    }

    /// The least and the greatest of each coordinate, or `None` without vertices.
    #[must_use]
    pub fn bounds(&self) -> Option<[[f64; 3]; 2]> {
        self.coordinates().fold(None, |bounds, x| {
            let [low, high] = bounds.unwrap_or([x, x]);
            Some([
                std::array::from_fn(|axis| low[axis].min(x[axis])),
                std::array::from_fn(|axis| high[axis].max(x[axis])),
            ])
        })
    }

    /// The same mesh with its vertices elsewhere, as after skinning.
    ///
    /// # Errors
    ///
    /// As [`Mesh::new`]; fewer positions than before leave faces with
    /// [`MeshError::IndexOutOfRange`].
    pub fn with_positions<P: Into<Position>>(&self, positions: Vec<P>) -> Result<Self, MeshError> {
        let moved = Self::new(positions, self.faces.clone())?;
        Ok(Self {
            texture: self.texture.clone(),
            groups: self.groups.clone(),
            ..moved
        })
    }

    /// The same mesh in another unit: every coordinate times `factor`.
    ///
    /// A mesh in decimetres becomes one in metres with `0.1`.
    ///
    /// # Errors
    ///
    /// [`MeshError::NotFinite`] when a product overflows or `factor` is no number.
    pub fn scaled(&self, factor: f64) -> Result<Self, MeshError> {
        self.with_positions(self.coordinates().map(|x| x.map(|x| x * factor)).collect())
    }
}
