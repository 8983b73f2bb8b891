//! The surface of a head: its triangles, their area and their centre of gravity.

use crate::capture::CaptureError;
use ga_mesh::MeshError;
use ga_mesh::normals::area_vector;
use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

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
    /// [`CaptureError::Mesh`] for a position that is not finite, and for a triangle with a vertex
    /// that does not exist; [`CaptureError::NoArea`].
    pub fn new(
        positions: &'a [Point<f64>],
        triangles: &'a [[u32; 3]],
    ) -> Result<Self, CaptureError> {
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
            return Err(CaptureError::NoArea);
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
