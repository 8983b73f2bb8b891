//! A surface as a part of the unit sphere about its centre of gravity.

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use super::surface_mesh::SurfaceMesh;
use crate::capture::CaptureError;

/// The spherical parameterisation of a surface: each vertex p becomes the direction in which it is
/// seen from a centre c,
///
/// ```text
/// u = (p − c) / |p − c|
/// ```
///
/// For a surface that every ray from the centre meets once, such as a head without its ears, it is
/// one to one. Where the surface folds back, as under the chin, several of its points have one
/// direction and therefore the same motion; [`folded_triangles`](Self::folded_triangles) counts
/// those places.
#[derive(Clone, Debug, PartialEq)]
pub struct SphericalParameterisation {
    centre: Point<f64>,
    directions: Vec<Vector<f64>>,
    folded: usize,
}

impl SphericalParameterisation {
    /// The parameterisation about the centre of gravity of the surface.
    ///
    /// # Errors
    /// [`CaptureError::VertexAtCentre`].
    ///
    /// ```
    /// use ga_runtime::{cga3::Point, vga3::Vector};
    /// use ga_vision::capture::{SphericalParameterisation, SurfaceMesh};
    ///
    /// // An octahedron that is twice as high as it is wide.
    /// let corners = [
    ///     [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0],
    ///     [0.0, 0.0, 2.0], [0.0, 0.0, -2.0],
    /// ];
    /// let corners = corners.map(Point::from);
    /// let triangles = [
    ///     [0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5],
    /// ];
    /// let surface = SurfaceMesh::new(&corners, &triangles)?;
    /// let sphere = SphericalParameterisation::new(&surface)?;
    /// assert!(sphere.centre().distance(Point::ORIGIN) < 1e-15);
    /// assert!(sphere.directions()[4].distance(Vector::new(0.0, 0.0, 1.0)) < 1e-15);
    /// assert_eq!(sphere.folded_triangles(), 0);
    /// # Ok::<(), ga_vision::capture::CaptureError>(())
    /// ```
    pub fn new(surface: &SurfaceMesh<'_>) -> Result<Self, CaptureError> {
        Self::about(surface.centre_of_gravity(), surface)
    }

    /// The parameterisation about any centre, such as the middle of the skull for a surface that is
    /// a face only.
    ///
    /// # Errors
    /// [`CaptureError::VertexAtCentre`].
    pub fn about(centre: Point<f64>, surface: &SurfaceMesh<'_>) -> Result<Self, CaptureError> {
        let positions = surface.positions().iter().enumerate();
        let directions: Result<Vec<_>, _> = positions
            .map(|(vertex, &position)| {
                direction(centre, position).ok_or(CaptureError::VertexAtCentre { vertex })
            })
            .collect();
        let directions = directions?;
        let volumes = surface.triangles().iter().map(|triangle| {
            let [a, b, c] = triangle.map(|k| centre.vector_to(surface.positions()[k as usize]));
            a.cross(b).dot(c)
        });
        // A triangle shows its back to the centre, or its front where the surface is folded; which
        // side is which depends on the orientation of the mesh.
        let total: f64 = volumes.clone().sum();
        let folded = volumes.filter(|volume| volume * total < 0.0).count();
        Ok(Self {
            centre,
            directions,
            folded,
        })
    }

    /// The centre of the sphere.
    #[must_use]
    pub fn centre(&self) -> Point<f64> {
        self.centre
    }

    /// The unit direction of each vertex from the centre.
    #[must_use]
    pub fn directions(&self) -> &[Vector<f64>] {
        &self.directions
    }

    /// How many triangles are seen from the other side than most of the area is.
    #[must_use]
    pub fn folded_triangles(&self) -> usize {
        self.folded
    }

    /// The unit direction of any place; `None` for the centre.
    #[must_use]
    pub fn direction(&self, place: Point<f64>) -> Option<Vector<f64>> {
        direction(self.centre, place)
    }
}

fn direction(centre: Point<f64>, place: Point<f64>) -> Option<Vector<f64>> {
    centre.vector_to(place).normalized()
}
