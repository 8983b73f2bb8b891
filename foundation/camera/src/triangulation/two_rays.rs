//! The point halfway between two rays.

use ga_runtime::cga3::Point;
use ga_runtime::geometry::ray::Ray;
use ga_runtime::geometry::relation::Tolerance;
use ga_runtime::vga3::Vector;

use super::TriangulationError;

/// The point that two rays determine, and how well they agree on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangulation {
    /// The middle of the common perpendicular.
    pub position: Point<f64>,
    /// The ends of the common perpendicular on the first and on the second ray.
    pub feet: [Point<f64>; 2],
    /// The length of the common perpendicular: the distance of the rays, in metres.
    pub gap: f64,
    /// The distance along each ray from its camera to its foot, in metres; negative behind the
    /// camera.
    pub depths: [f64; 2],
    /// The angle between the rays in radians, in (0, π).
    pub angle: f64,
}

impl Triangulation {
    /// Whether the point is in front of both cameras.
    #[must_use]
    pub fn is_in_front(&self) -> bool {
        self.depths.iter().all(|depth| *depth > 0.0)
    }
}

/// The point where two rays come closest: the middle of their common perpendicular.
///
/// # Errors
/// [`TriangulationError`] for rays that are parallel or not finite.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_runtime::geometry::ray::Ray;
/// use ga_camera::triangulation::triangulate;
///
/// // Along x at height 0 and along y at height 2, through the z axis.
/// let first = Ray::new(Point::new(-3.0, 0.0, 0.0), [1.0, 0.0, 0.0]).unwrap();
/// let second = Ray::new(Point::new(0.0, 5.0, 2.0), [0.0, 1.0, 0.0]).unwrap();
/// let found = triangulate(first, second)?;
/// assert_eq!(found.position.coordinates(), [0.0, 0.0, 1.0]);
/// assert_eq!((found.gap, found.depths), (2.0, [3.0, -5.0]));
/// assert!(!found.is_in_front());
/// # Ok::<(), ga_camera::triangulation::TriangulationError>(())
/// ```
pub fn triangulate(first: Ray<f64>, second: Ray<f64>) -> Result<Triangulation, TriangulationError> {
    let [d1, d2] = [first, second].map(|ray| Vector::from(ray.direction()));
    let angle = d1.cross(d2).length().atan2(d1.dot(d2));
    if !angle.is_finite() {
        return Err(TriangulationError::NotFinite);
    }
    let parallel = TriangulationError::Parallel { sine: angle.sin() };
    let exact = Tolerance::new(0.0, 0.0);
    let Some(found) = first.line().common_perpendicular(second.line(), exact) else {
        let coincide = first
            .line()
            .coincides_with(second.line(), Tolerance::default());
        return Err(if coincide {
            parallel
        } else {
            TriangulationError::NotFinite
        });
    };
    if found.is_parallel {
        return Err(parallel);
    }
    let [a, b] = found.feet.map(Vector::from);
    Ok(Triangulation {
        position: a.lerp(b, 0.5).into(),
        feet: found.feet,
        gap: found.distance,
        depths: [first.depth(found.feet[0]), second.depth(found.feet[1])],
        angle,
    })
}
