//! The surface of a head: its triangles, their area and their centre of gravity.

use ga_mesh::MeshError;
use ga_mesh::normals::area_vector;
use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

/// Why motion cannot be carried to a surface.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SurfaceError {
    /// The triangles are not those of a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The surface has no area.
    #[error("a surface without area has no centre of gravity")]
    NoArea,
    /// A vertex is at the centre of the sphere.
    #[error("vertex {vertex} is at the centre of the sphere, from where it has no direction")]
    VertexAtCentre {
        /// The vertex.
        vertex: usize,
    },
    /// There are no key points.
    #[error("without key points no motion is known")]
    NoKeys,
    /// There are too many key points.
    #[error("{keys} key points are more than {most}")]
    TooManyKeys {
        /// How many there are.
        keys: usize,
        /// How many there may be.
        most: usize,
    },
    /// A key point is not finite.
    #[error("key point {key} is not finite")]
    KeyNotFinite {
        /// The key point.
        key: usize,
    },
    /// A key point is at the centre of the sphere.
    #[error("key point {key} is at the centre of the sphere, from where it has no direction")]
    KeyAtCentre {
        /// The key point.
        key: usize,
    },
    /// Two key points have the same direction.
    #[error(
        "key points {first} and {second} are seen in the same direction from the centre of the \
         sphere, within {angle:.1e} radians"
    )]
    SameDirection {
        /// The first of them.
        first: usize,
        /// The second.
        second: usize,
        /// The angle between their directions.
        angle: f64,
    },
    /// A list has another length than there are key points, or vertices.
    #[error("{found} {what} are given, and there are {expected}")]
    Counts {
        /// What is counted.
        what: &'static str,
        /// How many there are.
        expected: usize,
        /// How many were given.
        found: usize,
    },
    /// There are too many vertices and key points.
    #[error("the weights of {keys} key points at {vertices} vertices are too many")]
    TooLarge {
        /// How many vertices there are.
        vertices: usize,
        /// How many key points.
        keys: usize,
    },
    /// A radius or the breadth of a border is not positive and finite.
    #[error("{0} is neither the radius of an area nor the breadth of its border")]
    Radius(f64),
    /// No vertex lies in the area.
    #[error("no vertex of the surface is within {radius} of the place")]
    EmptyArea {
        /// The radius of the area.
        radius: f64,
    },
    /// The tolerance of shapes is negative or not finite.
    #[error("{0} is not a tolerance")]
    Tolerance(f64),
    /// A vertex does not exist.
    #[error("vertex {vertex} does not exist; there are {vertices}, which count from 0")]
    NoVertex {
        /// The vertex.
        vertex: u32,
        /// How many there are.
        vertices: usize,
    },
}

/// The triangles of a surface, checked, with the part of their area that belongs to each vertex.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceMesh<'a> {
    positions: &'a [Point<f64>],
    triangles: &'a [[u32; 3]],
    areas: Vec<f64>,
    centre: Point<f64>,
}

impl<'a> SurfaceMesh<'a> {
    /// The surface of these triangles.
    ///
    /// # Errors
    /// [`SurfaceError::Mesh`] for a position that is not finite, and for a triangle with a vertex
    /// that does not exist; [`SurfaceError::NoArea`].
    pub fn new(
        positions: &'a [Point<f64>],
        triangles: &'a [[u32; 3]],
    ) -> Result<Self, SurfaceError> {
        for (vertex, &position) in positions.iter().enumerate() {
            if !Vector::from(position).is_finite() {
                let coordinates = position.coordinates();
                return Err(MeshError::NotFinite {
                    vertex,
                    coordinates,
                }
                .into());
            }
        }
        let vertices = positions.len();
        let mut areas = vec![0.0; vertices];
        for (face, triangle) in triangles.iter().enumerate() {
            if let Some(&index) = triangle.iter().find(|&&k| k as usize >= vertices) {
                return Err(MeshError::IndexOutOfRange {
                    face,
                    index,
                    vertices,
                }
                .into());
            }
            let corners = triangle.map(|k| Vector::from(positions[k as usize]));
            let area = 0.5 * area_vector(corners).length();
            triangle
                .iter()
                .for_each(|&k| areas[k as usize] += area / 3.0);
        }
        let total: f64 = areas.iter().sum();
        let centre = centre_of_gravity(positions, &areas);
        let Some(centre) = centre.filter(|_| total.is_finite()) else {
            return Err(SurfaceError::NoArea);
        };
        Ok(Self {
            positions,
            triangles,
            areas,
            centre,
        })
    }

    /// The positions of the vertices.
    #[must_use]
    pub fn positions(&self) -> &'a [Point<f64>] {
        self.positions
    }

    /// The triangles.
    #[must_use]
    pub fn triangles(&self) -> &'a [[u32; 3]] {
        self.triangles
    }

    /// For each vertex a third of the area of its triangles, in the squared unit of the positions.
    #[must_use]
    pub fn areas(&self) -> &[f64] {
        &self.areas
    }

    /// The centre of gravity of the surface as a shell of even thickness, `Σ aᵥ pᵥ / Σ aᵥ`.
    #[must_use]
    pub fn centre_of_gravity(&self) -> Point<f64> {
        self.centre
    }
}

/// `Σ mᵥ pᵥ / Σ mᵥ`, computed from differences; `None` where the masses are zero or not finite.
pub(super) fn centre_of_gravity(positions: &[Point<f64>], masses: &[f64]) -> Option<Point<f64>> {
    let &start = positions.first()?;
    let pairs = positions.iter().zip(masses);
    let (sum, total) = pairs.fold((Vector::ZERO, 0.0), |(sum, total), (&position, &mass)| {
        (sum + start.vector_to(position) * mass, total + mass)
    });
    let mean = sum / total;
    (total > 0.0 && mean.is_finite()).then(|| Point::from(Vector::from(start) + mean))
}
