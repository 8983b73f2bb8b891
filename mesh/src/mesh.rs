//! Meshes.

use ga_runtime::cga3::Point;

use crate::{Faces, MeshError};

/// The position of one vertex, as a conformal point: three coordinates are stored, and products see
/// the whole conformal vector.
pub type Position = Point<f64>;

/// A polygon mesh whose indices are all in range and whose numbers are all finite.
///
/// Positions carry the unit and the axes of their source; see [`Mesh::scaled`].
///
/// # Examples
///
/// ```
/// use ga_mesh::{Faces, Mesh};
///
/// let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
/// let square = Mesh::new(corners.to_vec(), Faces::from_polygons([[0, 1, 2, 3]])?)?;
/// assert_eq!(square.triangles(), [[0, 1, 2], [0, 2, 3]]);
/// # Ok::<(), ga_mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    pub(crate) positions: Vec<Position>,
    pub(crate) faces: Faces,
    pub(crate) texture: Option<Texture>,
    pub(crate) groups: Vec<Group>,
}

/// Texture coordinates, numbered independently of the vertices: a vertex may have a different
/// coordinate in each of its faces.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    /// The coordinates (u, v), u to the right and v up; the unit square is one picture.
    pub coordinates: Vec<[f64; 2]>,
    /// For each corner of each face, in the order of [`Faces::corners`], the index of its
    /// coordinate, if it has one.
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

    /// The least and the greatest value of each coordinate, or `None` without vertices.
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

    /// The same mesh with other positions of its vertices, as after skinning.
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
    /// [`MeshError::NotFinite`] when a product overflows or `factor` is not a number.
    pub fn scaled(&self, factor: f64) -> Result<Self, MeshError> {
        self.with_positions(self.coordinates().map(|x| x.map(|x| x * factor)).collect())
    }
}
