//! Where two rays come closest.
//!
//! Two lines that are neither parallel nor meet have one common perpendicular. With unit directions
//! d₁, d₂, moments m₁, m₂ and `n = d₁ × d₂`, the plane through the second line along n is
//! `d₂ × n + (m₂·n) ei` in dual form, and the first line meets it in the foot of the perpendicular,
//! `F₁∧ei = L₁ ∨ P₂`; the second foot is found likewise. The point halfway between the feet is what
//! the two rays say of the place. It minimises the sum of squared distances from the rays, not that
//! of squared pixel errors (Hartley and Sturm, Triangulation, 1997): fine for pictures that are
//! good to a fraction of the angle between the rays, biased for almost parallel ones.

use ga_runtime::cga3::{DualPlane, Line, Point};

use crate::camera::Ray;
use crate::vector::{cross, dot};

/// The place that two rays agree on, and how well.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangulation {
    /// The middle of the common perpendicular.
    pub position: Point<f64>,
    /// Its ends on the first and on the second ray.
    pub feet: [Point<f64>; 2],
    /// Its length: the shortest distance of the rays, in metres.
    pub gap: f64,
    /// How far along each ray its foot is, in metres; negative behind the camera.
    pub depths: [f64; 2],
    /// The angle between the rays in radians, in (0, π).
    pub angle: f64,
}

/// Why two rays fix no place.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum TriangulationError {
    /// The rays are parallel up to rounding.
    #[error("the rays are parallel: the sine of the angle between them is {sine:e}")]
    Parallel {
        /// The sine of the angle.
        sine: f64,
    },
    /// A ray has a coefficient that is infinite or no number.
    #[error("a ray is not finite")]
    NotFinite,
}

impl Triangulation {
    /// Whether the place is in front of both cameras.
    #[must_use]
    pub fn is_in_front(&self) -> bool {
        self.depths.iter().all(|depth| *depth > 0.0)
    }
}

/// The place where two rays come closest.
///
/// # Errors
/// [`TriangulationError`] for rays that are parallel or not finite.
///
/// ```
/// use ga_runtime::cga3::{Line, Point};
/// use ga_vision::camera::Ray;
/// use ga_vision::triangulation::triangulate;
///
/// let ray = |centre: [f64; 3], direction| {
///     let centre = Point::from(centre);
///     Ray {
///         line: Line::from_point_direction(centre, direction),
///         centre,
///     }
/// };
/// // Along x at height 0 and along y at height 2, through the z axis.
/// let found = triangulate(
///     &ray([-3.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
///     &ray([0.0, 5.0, 2.0], [0.0, 1.0, 0.0]),
/// )?;
/// assert_eq!(found.position.coordinates(), [0.0, 0.0, 1.0]);
/// assert_eq!((found.gap, found.depths), (2.0, [3.0, -5.0]));
/// assert!(!found.is_in_front());
/// # Ok::<(), ga_vision::triangulation::TriangulationError>(())
/// ```
pub fn triangulate(first: &Ray, second: &Ray) -> Result<Triangulation, TriangulationError> {
    let (d1, d2) = (first.direction(), second.direction());
    let normal = cross(d1, d2);
    let square = dot(normal, normal);
    if !square.is_finite() {
        return Err(TriangulationError::NotFinite);
    }
    // Below this the directions differ by no more than they are rounded.
    let sine = square.sqrt();
    if sine <= 4.0 * f64::EPSILON {
        return Err(TriangulationError::Parallel { sine });
    }
    let meet = |line: Line<f64>, other: Line<f64>| {
        let normal_of_wall = cross(other.direction(), normal);
        let distance = dot(other.moment(), normal);
        let wall = DualPlane::from_normal_distance(normal_of_wall, distance).undual();
        (line & wall)
            .to_point()
            .ok_or(TriangulationError::NotFinite)
    };
    let feet = [
        meet(first.line, second.line)?,
        meet(second.line, first.line)?,
    ];
    let [a, b] = feet.map(Point::coordinates);
    let position = Point::from([0, 1, 2].map(|k| 0.5 * (a[k] + b[k])));
    let gap = feet[0].distance(feet[1]);
    if !gap.is_finite() {
        return Err(TriangulationError::NotFinite);
    }
    Ok(Triangulation {
        position,
        feet,
        gap,
        depths: [first.depth(feet[0]), second.depth(feet[1])],
        angle: sine.atan2(dot(d1, d2)),
    })
}
