//! The motion of key points, carried to a whole surface.

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;
use rayon::prelude::*;

use super::sphere::SphericalParameterisation;
use super::spline::SphericalSpline;
use crate::capture::CaptureError;

/// The most weights, which take 8 bytes each.
const MOST_WEIGHTS: usize = 1 << 28;

/// How many vertices are computed together.
const CHUNK: usize = 64;

/// How a surface follows its key points.
///
/// Key points and vertices become directions from one centre ([`SphericalParameterisation`]), and
/// between the keys the displacement is the thin-plate spline of the sphere through theirs
/// ([`SphericalSpline`]), each coordinate for itself. So a vertex at a key point moves exactly as
/// that does, displacements that are equal move the whole surface alike, and the motion is smooth.
/// It is linear in the displacements of the keys: the weights are computed once.
///
/// ```
/// use ga_runtime::{cga3::Point, vga3::Vector};
/// use ga_vision::capture::{SphericalParameterisation, SurfaceMesh, SurfaceMotion};
///
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
///
/// // The top rises, and the bottom stays.
/// let motion = SurfaceMotion::new(&sphere, &[corners[4], corners[5]])?;
/// let mut moved = [Vector::ZERO; 6];
/// motion.displacements(&[Vector::new(0.0, 0.0, 0.1), Vector::ZERO], &mut moved)?;
/// assert!((moved[4].z() - 0.1).abs() < 1e-15 && moved[5].length() < 1e-15);
/// assert!((moved[0].z() - 0.05).abs() < 1e-15);
/// # Ok::<(), ga_vision::capture::CaptureError>(())
/// ```
#[derive(Clone, Debug)]
pub struct SurfaceMotion {
    spline: SphericalSpline,
    /// For each vertex the weight of each key.
    weights: Vec<f64>,
}

impl SurfaceMotion {
    /// The motion of a surface by key points, which need not be vertices.
    ///
    /// # Errors
    /// [`CaptureError`]: no keys or more than 8192, a key that is not finite or at the centre, two
    /// keys in the same direction, more than 2²⁸ weights.
    pub fn new(
        sphere: &SphericalParameterisation,
        keys: &[Point<f64>],
    ) -> Result<Self, CaptureError> {
        let directions = keys.iter().enumerate().map(|(key, &place)| {
            if !Vector::from(place).is_finite() {
                return Err(CaptureError::KeyNotFinite { key });
            }
            let direction = sphere.direction(place);
            direction.ok_or(CaptureError::KeyAtCentre { key })
        });
        let directions: Vec<_> = directions.collect::<Result<_, _>>()?;
        let (vertices, keys) = (sphere.directions().len(), keys.len());
        if vertices.saturating_mul(keys) > MOST_WEIGHTS {
            return Err(CaptureError::TooLarge { vertices, keys });
        }
        let spline = SphericalSpline::new(&directions)?;
        let mut weights = vec![0.0; vertices * keys];
        weights
            .par_chunks_mut(CHUNK * keys)
            .zip(sphere.directions().par_chunks(CHUNK))
            .for_each(|(weights, directions)| spline.write_weights(directions, weights));
        Ok(Self { spline, weights })
    }

    /// How many key points there are.
    #[must_use]
    pub fn key_count(&self) -> usize {
        self.spline.keys().len()
    }

    /// How many vertices there are.
    #[must_use]
    pub fn vertex_count(&self) -> usize {
        self.weights.len() / self.key_count()
    }

    /// The weight of each key in the displacement of a vertex; their sum is 1. Empty for a vertex
    /// that does not exist.
    #[must_use]
    pub fn weights(&self, vertex: usize) -> &[f64] {
        let keys = self.key_count();
        let range = vertex.saturating_mul(keys)..vertex.saturating_add(1).saturating_mul(keys);
        self.weights.get(range).unwrap_or_default()
    }

    /// Computes the displacements of all vertices from those of the keys.
    ///
    /// # Errors
    /// [`CaptureError::ListCounts`] where a list has another length;
    /// [`CaptureError::KeyNotFinite`].
    pub fn displacements(
        &self,
        keys: &[Vector<f64>],
        vertices: &mut [Vector<f64>],
    ) -> Result<(), CaptureError> {
        let counts = |what, expected, found| CaptureError::ListCounts {
            what,
            expected,
            found,
        };
        if keys.len() != self.key_count() {
            return Err(counts("displacements", self.key_count(), keys.len()));
        }
        if vertices.len() != self.vertex_count() {
            return Err(counts("vertices", self.vertex_count(), vertices.len()));
        }
        if let Some(key) = keys.iter().position(|key| !key.is_finite()) {
            return Err(CaptureError::KeyNotFinite { key });
        }
        let weights = self.weights.par_chunks_exact(keys.len());
        let moved = vertices.par_iter_mut().zip(weights).with_min_len(CHUNK);
        moved.for_each(|(vertex, weights)| {
            let terms = keys.iter().zip(weights);
            *vertex = terms.fold(Vector::ZERO, |sum, (&key, &weight)| sum + key * weight);
        });
        Ok(())
    }

    /// The displacements of all keys from those that are known: the others move as the surface does
    /// that follows the known ones alone.
    ///
    /// # Errors
    /// [`CaptureError::ListCounts`] for another number of keys; [`CaptureError::KeyNotFinite`];
    /// [`CaptureError::NoKeys`] where none is known.
    pub fn filled(&self, keys: &[Option<Vector<f64>>]) -> Result<Vec<Vector<f64>>, CaptureError> {
        let (expected, found) = (self.key_count(), keys.len());
        if expected != found {
            let what = "displacements";
            return Err(CaptureError::ListCounts {
                what,
                expected,
                found,
            });
        }
        let is_wrong = |key: &Option<Vector<f64>>| key.is_some_and(|key| !key.is_finite());
        if let Some(key) = keys.iter().position(is_wrong) {
            return Err(CaptureError::KeyNotFinite { key });
        }
        let known: Vec<_> = keys.iter().copied().flatten().collect();
        if known.len() == keys.len() {
            return Ok(known);
        }
        let places = self.spline.keys().iter().zip(keys);
        let places: Vec<_> = places
            .filter_map(|(&place, key)| key.map(|_| place))
            .collect();
        let spline = SphericalSpline::new(&places)?;
        let all = self.spline.keys().iter().zip(keys);
        let filled = all.map(|(&place, key)| {
            key.unwrap_or_else(|| {
                let weights = spline.weights(place);
                let terms = known.iter().zip(weights);
                terms.fold(Vector::ZERO, |sum, (&key, weight)| sum + key * weight)
            })
        });
        Ok(filled.collect())
    }
}
