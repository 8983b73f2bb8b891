//! A local area of a surface, and its centre of gravity.

use ga_mesh::geodesic::{Source, distances};
use ga_mesh::query::Bvh;
use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use super::surface_mesh::{SurfaceMesh, centre_of_gravity};
use crate::capture::CaptureError;

/// A part of a surface that moves, while the rest stays.
///
/// A displacement in the area is multiplied by a falloff w, which is 1 in the middle and falls
/// smoothly to 0 at the edge, with two continuous derivatives:
///
/// ```text
/// w(t) = 1 − t³ (10 − 15 t + 6 t²)    t from 0 in the middle to 1 at the edge
/// ```
///
/// The centre of gravity of the area is `g = Σ aᵥ pᵥ / Σ aᵥ` over its vertices, with a third of the
/// area of the triangles at each vertex as its mass, which it keeps when it moves. Where g shall be
/// kept, the mean displacement is taken out with the same falloff, so that the edge stays:
///
/// ```text
/// d'ᵥ = wᵥ (dᵥ − s)    s = Σ aᵥ wᵥ dᵥ / Σ aᵥ wᵥ
/// ```
///
/// Key points of the area then no longer move exactly as captured, but by s less.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalArea {
    falloff: Vec<f64>,
    /// The masses of the vertices in the area; 0 for the others.
    masses: Vec<f64>,
    centre: Point<f64>,
}

impl LocalArea {
    /// The whole surface, everywhere with falloff 1.
    ///
    /// # Errors
    /// None for a valid surface; [`CaptureError::EmptyArea`] stands for a surface without area.
    pub fn whole(surface: &SurfaceMesh<'_>) -> Result<Self, CaptureError> {
        Self::new(surface, vec![1.0; surface.positions().len()], f64::INFINITY)
    }

    /// What lies within a radius of a place, along the surface: from the point of the surface that
    /// is nearest to the place. There the falloff is 1.
    ///
    /// # Errors
    /// [`CaptureError::Radius`] unless the radius is positive and finite;
    /// [`CaptureError::EmptyArea`] where no vertex is so near.
    ///
    /// ```
    /// use ga_runtime::{cga3::Point, vga3::Vector};
    /// use ga_vision::capture::{LocalArea, SurfaceMesh};
    ///
    /// // A strip of 10 × 1 squares of 1 cm.
    /// let corner = |k: u32| Point::new(0.01 * f64::from(k / 2), 0.01 * f64::from(k % 2), 0.0);
    /// let corners: Vec<_> = (0..22).map(corner).collect();
    /// let squares = (0..10).map(|k| 2 * k);
    /// let triangles: Vec<_> =
    ///     squares.flat_map(|k| [[k, k + 2, k + 1], [k + 1, k + 2, k + 3]]).collect();
    /// let strip = SurfaceMesh::new(&corners, &triangles)?;
    /// let area = LocalArea::around(&strip, corners[0], 0.04)?;
    /// assert_eq!(area.falloff()[0], 1.0);
    /// assert!((area.falloff()[4] - 0.5).abs() < 1e-12); // 2 cm away
    /// assert_eq!(area.falloff()[10], 0.0);
    ///
    /// let mut moved = vec![Vector::new(0.0, 0.0, 0.01); 22];
    /// area.apply(&mut moved, false);
    /// assert!((moved[4].z() - 0.005).abs() < 1e-12 && moved[10] == Vector::ZERO);
    /// # Ok::<(), ga_vision::capture::CaptureError>(())
    /// ```
    pub fn around(
        surface: &SurfaceMesh<'_>,
        place: Point<f64>,
        radius: f64,
    ) -> Result<Self, CaptureError> {
        if !(radius.is_finite() && radius > 0.0) {
            return Err(CaptureError::Radius(radius));
        }
        let (positions, triangles) = (surface.positions(), surface.triangles());
        let nearest = Bvh::new(positions, triangles)?
            .nearest(place)
            .map_err(|_| CaptureError::EmptyArea { radius })?;
        let sources = triangles[nearest.triangle as usize].map(|vertex| Source {
            vertex,
            distance: positions[vertex as usize].distance(nearest.point),
            place: 0,
        });
        let distances = distances(positions, triangles, &sources, radius)?;
        let falloff = distances.iter().map(|distance| falloff(distance / radius));
        Self::new(surface, falloff.collect(), radius)
    }

    /// A set of vertices, with falloff 1 from a border of this breadth inwards, along the surface.
    ///
    /// # Errors
    /// [`CaptureError::Radius`] unless the border is positive and finite;
    /// [`CaptureError::NoVertex`]; [`CaptureError::EmptyArea`] without vertices.
    pub fn of_vertices(
        surface: &SurfaceMesh<'_>,
        vertices: &[u32],
        border: f64,
    ) -> Result<Self, CaptureError> {
        if !(border.is_finite() && border > 0.0) {
            return Err(CaptureError::Radius(border));
        }
        let (positions, triangles) = (surface.positions(), surface.triangles());
        let mut is_inside = vec![false; positions.len()];
        for &vertex in vertices {
            match is_inside.get_mut(vertex as usize) {
                Some(is_inside) => *is_inside = true,
                None => {
                    let vertices = positions.len();
                    return Err(CaptureError::NoVertex { vertex, vertices });
                }
            }
        }
        let outside = (0..).zip(&is_inside).filter(|(_, is_inside)| !**is_inside);
        let sources: Vec<_> = outside.map(|(vertex, _)| Source::from(vertex)).collect();
        // What is farther from the outside than the border has an infinite distance.
        let distances = distances(positions, triangles, &sources, border)?;
        let falloff = distances
            .iter()
            .map(|distance| falloff(1.0 - (distance / border).min(1.0)));
        Self::new(surface, falloff.collect(), border)
    }

    fn new(
        surface: &SurfaceMesh<'_>,
        falloff: Vec<f64>,
        radius: f64,
    ) -> Result<Self, CaptureError> {
        let pairs = surface.areas().iter().zip(&falloff);
        let masses: Vec<_> = pairs
            .map(|(&area, &falloff)| if falloff > 0.0 { area } else { 0.0 })
            .collect();
        let centre = centre_of_gravity(surface.positions(), &masses);
        Ok(Self {
            centre: centre.ok_or(CaptureError::EmptyArea { radius })?,
            falloff,
            masses,
        })
    }

    /// The falloff of each vertex, 0 outside the area.
    #[must_use]
    pub fn falloff(&self) -> &[f64] {
        &self.falloff
    }

    /// How many vertices the area has.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.falloff
            .iter()
            .filter(|&&falloff| falloff > 0.0)
            .count()
    }

    /// The centre of gravity of the area at rest.
    #[must_use]
    pub fn centre_of_gravity(&self) -> Point<f64> {
        self.centre
    }

    /// The displacement of the centre of gravity where the vertices move by `displacements`,
    /// `Σ aᵥ dᵥ / Σ aᵥ`.
    ///
    /// # Panics
    /// When there is not one displacement for each vertex.
    #[must_use]
    pub fn centre_displacement(&self, displacements: &[Vector<f64>]) -> Vector<f64> {
        self.mean(displacements, |vertex| self.masses[vertex])
    }

    /// Multiplies displacements of all vertices by the falloff, and takes out their mean where the
    /// centre of gravity of the area shall be kept.
    ///
    /// # Panics
    /// When there is not one displacement for each vertex.
    pub fn apply(&self, displacements: &mut [Vector<f64>], keep_centre: bool) {
        let mean = match keep_centre {
            true => self.mean(displacements, |k| self.masses[k] * self.falloff[k]),
            false => Vector::ZERO,
        };
        for (displacement, &falloff) in displacements.iter_mut().zip(&self.falloff) {
            *displacement = if falloff > 0.0 {
                (*displacement - mean) * falloff
            } else {
                Vector::ZERO
            };
        }
    }

    fn mean(&self, displacements: &[Vector<f64>], mass: impl Fn(usize) -> f64) -> Vector<f64> {
        assert_eq!(
            displacements.len(),
            self.falloff.len(),
            "one for each vertex"
        );
        let terms = displacements.iter().enumerate();
        let (sum, total) = terms.fold((Vector::ZERO, 0.0), |(sum, total), (vertex, &moved)| {
            let mass = mass(vertex);
            (sum + moved * mass, total + mass)
        });
        sum / total
    }
}

/// 1 for 0, 0 for 1 and more, with two continuous derivatives.
fn falloff(t: f64) -> f64 {
    if t < 1.0 {
        1.0 - t * t * t * (10.0 - t * (15.0 - 6.0 * t))
    } else {
        0.0
    }
}
