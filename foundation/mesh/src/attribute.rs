//! Attributes of the corners of faces.

use ga_runtime::vga3::Vector;

use crate::{Faces, MeshError};

/// Values at the corners of faces, numbered independently of the vertices: a vertex may have a
/// different value in each of its faces, and corners may share one.
///
/// # Examples
///
/// Texture coordinates of a square and a triangle that lacks them:
///
/// ```
/// use ga_mesh::CornerAttribute;
///
/// let coordinates = CornerAttribute {
///     values: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
///     corners: vec![Some(0), Some(1), Some(2), Some(3), None, None, None],
/// };
/// assert_eq!(coordinates.get(2), Some(&[1.0, 1.0]));
/// assert_eq!(coordinates.get(4), None);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CornerAttribute<T> {
    /// The values.
    pub values: Vec<T>,
    /// For each corner of each face, in the order of [`Faces::corners`], the index of its value, or
    /// `None` where the corner has none.
    pub corners: Vec<Option<u32>>,
}

/// Coordinates (u, v) of a picture, u to the right and v up; the unit square is the whole picture.
pub type TextureCoordinates = CornerAttribute<[f64; 2]>;

/// Unit normals.
pub type Normals = CornerAttribute<Vector<f64>>;

/// Tangents of a surface with texture coordinates.
pub type Tangents = CornerAttribute<Tangent>;

/// The direction in which the texture coordinate u grows along the surface, and the sign of the
/// direction in which v grows.
///
/// With the normal n the frame of a normal map is (t, b, n), where b = σ n × t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tangent {
    /// t, a unit vector.
    pub direction: Vector<f64>,
    /// σ: 1, or −1 where the picture lies mirrored on the surface.
    pub handedness: f64,
}

/// Red, green, blue and alpha (opacity). The colour is linear light, not multiplied by alpha; each
/// number is between 0 and 1 unless a surface is brighter than white.
pub type Rgba = [f64; 4];

impl<T> CornerAttribute<T> {
    /// One value for each vertex, which all corners at that vertex have.
    #[must_use]
    pub fn of_vertices(values: Vec<T>, faces: &Faces) -> Self {
        Self {
            values,
            corners: faces.corners().iter().copied().map(Some).collect(),
        }
    }

    /// The value at a corner, given by its index in [`Faces::corners`].
    #[must_use]
    pub fn get(&self, corner: usize) -> Option<&T> {
        self.values.get((*self.corners.get(corner)?)? as usize)
    }

    /// The same values, chosen for other corners, by the indices of corners of this attribute.
    ///
    /// # Panics
    ///
    /// When there is no such corner.
    #[must_use]
    pub fn at_corners(&self, corners: impl Iterator<Item = usize>) -> Self
    where
        T: Clone,
    {
        Self {
            values: self.values.clone(),
            corners: corners.map(|corner| self.corners[corner]).collect(),
        }
    }

    /// Checks the lengths and indices; `attribute` is the name of one value.
    pub(crate) fn check(&self, attribute: &'static str, faces: &Faces) -> Result<(), MeshError> {
        let (expected, found) = (faces.corners().len(), self.corners.len());
        if expected != found {
            return Err(MeshError::AttributeLength {
                attribute,
                expected,
                found,
            });
        }
        let values = self.values.len();
        for (corner, index) in self.corners.iter().enumerate() {
            if let Some(index) = index.filter(|&index| index as usize >= values) {
                return Err(MeshError::AttributeOutOfRange {
                    attribute,
                    corner,
                    index,
                    values,
                });
            }
        }
        Ok(())
    }
}

impl CornerAttribute<Vector<f64>> {
    /// Directions of vertices, such as [`vertex_normals`](crate::normals::vertex_normals), which
    /// all corners at that vertex have. The zero vector, as of a vertex that no face uses, stands
    /// for none.
    #[must_use]
    pub fn of_directions(of_vertices: &[Vector<f64>], faces: &Faces) -> Self {
        let mut values = Vec::with_capacity(of_vertices.len());
        let numbers: Vec<Option<u32>> = of_vertices
            .iter()
            .map(|&direction| {
                (direction != Vector::default()).then(|| {
                    values.push(direction);
                    values.len() as u32 - 1
                })
            })
            .collect();
        let number = |&vertex: &u32| numbers.get(vertex as usize).copied().flatten();
        let corners = faces.corners().iter().map(number).collect();
        Self { values, corners }
    }
}

/// Checks that all numbers of the value at `index` are finite.
pub(crate) fn check_finite(
    attribute: &'static str,
    index: usize,
    numbers: &[f64],
) -> Result<(), MeshError> {
    if numbers.iter().all(|number| number.is_finite()) {
        return Ok(());
    }
    Err(MeshError::AttributeNotFinite {
        attribute,
        index,
        value: numbers.to_vec(),
    })
}

/// The vector with length 1. One that has it but for an error of 10⁻⁶ stays as it is, so that
/// numbers of single precision come back unchanged.
pub(crate) fn unit(
    attribute: &'static str,
    index: usize,
    vector: Vector<f64>,
) -> Result<Vector<f64>, MeshError> {
    check_finite(attribute, index, &vector.coordinates())?;
    if (vector.length() - 1.0).abs() <= 1e-6 {
        return Ok(vector);
    }
    vector
        .normalized()
        .ok_or(MeshError::ZeroVector { attribute, index })
}
