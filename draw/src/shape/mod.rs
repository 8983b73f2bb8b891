//! What an element of the algebra is in Euclidean terms.

mod flat;
mod motion;
mod multivector;
mod round;

pub use motion::Trajectory;
pub(crate) use multivector::whole;
pub(crate) use round::ends;

use crate::vector3::Vector3;

/// What an element is as Euclidean geometry: places, lengths and directions instead of
/// coefficients.
///
/// Weights are gone: an element and its multiples have the same shape, but for
/// [`Direction`](Self::Direction), which has a length, and for the sign of normals and directions.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Shape {
    /// A point, `x + eo + ½x² ei`.
    Point {
        /// The place.
        at: [f64; 3],
    },
    /// A point and infinity, `p∧ei`.
    FlatPoint {
        /// The place.
        at: [f64; 3],
    },
    /// Two points `p∧q`: `centre ± radius · direction`, q being the one with plus.
    PointPair {
        /// Half way between them.
        centre: [f64; 3],
        /// From p to q, of length 1.
        direction: [f64; 3],
        /// Half their distance.
        radius: f64,
        /// Whether the square of the blade is negative: the squared distance of the points is, and
        /// `radius` is √−r².
        imaginary: bool,
    },
    /// A point pair whose points coincide: a point with a direction.
    TangentVector {
        /// The point.
        at: [f64; 3],
        /// The direction, of length 1.
        direction: [f64; 3],
    },
    /// A circle.
    Circle {
        /// The centre.
        centre: [f64; 3],
        /// The normal of its plane, of length 1.
        normal: [f64; 3],
        /// The radius, of an imaginary circle √−r².
        radius: f64,
        /// Whether the squared radius is negative.
        imaginary: bool,
    },
    /// A circle of radius zero: a point with a plane.
    TangentBivector {
        /// The point.
        at: [f64; 3],
        /// The normal of the plane, of length 1.
        normal: [f64; 3],
    },
    /// A sphere. One of radius zero is a [`Point`](Self::Point).
    Sphere {
        /// The centre.
        centre: [f64; 3],
        /// The radius, of an imaginary sphere √−r².
        radius: f64,
        /// Whether the squared radius is negative.
        imaginary: bool,
    },
    /// A line.
    Line {
        /// The point of the line nearest to the origin.
        support: [f64; 3],
        /// The direction, of length 1.
        direction: [f64; 3],
    },
    /// A plane.
    Plane {
        /// The point of the plane nearest to the origin.
        support: [f64; 3],
        /// The normal, of length 1.
        normal: [f64; 3],
    },
    /// A free vector, `v∧ei`, drawn from the origin.
    Direction {
        /// The vector.
        vector: [f64; 3],
    },
    /// A frame: the image of the origin and of the three axes.
    Frame {
        /// The origin's image.
        origin: [f64; 3],
        /// The images of the axes, each of length 1.
        axes: [[f64; 3]; 3],
    },
    /// A path.
    Trajectory {
        /// The places along it, at least one.
        points: Vec<[f64; 3]>,
        /// Frames along it.
        frames: Vec<([f64; 3], [[f64; 3]; 3])>,
    },
}

impl Shape {
    /// The name of its kind, as the legend has it.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Point { .. } => "point",
            Self::FlatPoint { .. } => "flat point",
            Self::PointPair {
                imaginary: false, ..
            } => "point pair",
            Self::PointPair { .. } => "imaginary point pair",
            Self::TangentVector { .. } => "tangent vector",
            Self::Circle {
                imaginary: false, ..
            } => "circle",
            Self::Circle { .. } => "imaginary circle",
            Self::TangentBivector { .. } => "tangent bivector",
            Self::Sphere {
                imaginary: false, ..
            } => "sphere",
            Self::Sphere { .. } => "imaginary sphere",
            Self::Line { .. } => "line",
            Self::Plane { .. } => "plane",
            Self::Direction { .. } => "direction",
            Self::Frame { .. } => "frame",
            Self::Trajectory { .. } => "trajectory",
        }
    }

    /// The same where all its numbers can be drawn.
    fn checked(self) -> Result<Self, NotDrawable> {
        let mut numbers: Vec<f64> = Vec::new();
        match &self {
            Self::Point { at } | Self::FlatPoint { at } => numbers.extend(at),
            Self::TangentVector { at, direction } => numbers.extend(at.iter().chain(direction)),
            Self::TangentBivector { at, normal } => numbers.extend(at.iter().chain(normal)),
            Self::PointPair {
                centre,
                direction: side,
                radius,
                ..
            }
            | Self::Circle {
                centre,
                normal: side,
                radius,
                ..
            } => numbers.extend(centre.iter().chain(side).chain([radius])),
            Self::Sphere { centre, radius, .. } => numbers.extend(centre.iter().chain([radius])),
            Self::Line {
                support,
                direction: side,
            }
            | Self::Plane {
                support,
                normal: side,
            } => numbers.extend(support.iter().chain(side)),
            Self::Direction { vector } => numbers.extend(vector),
            Self::Frame { origin, axes } => {
                numbers.extend(origin.iter().chain(axes.as_flattened()))
            }
            Self::Trajectory { points, frames } => {
                numbers.extend(points.as_flattened());
                for (origin, axes) in frames {
                    numbers.extend(origin.iter().chain(axes.as_flattened()));
                }
            }
        }
        match numbers
            .into_iter()
            .find(|x| x.is_nan() || x.abs() > LARGEST)
        {
            Some(number) if number.is_finite() => Err(NotDrawable::TooLarge(number)),
            Some(number) => Err(NotDrawable::NotFinite(number)),
            None => Ok(self),
        }
    }
}

/// The largest number that is drawn: its square and the sum of a few such are in range.
const LARGEST: f64 = 1e100;

/// An element that has no picture.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NotDrawable {
    /// All coefficients are zero.
    #[error("all its coefficients are zero")]
    Zero,
    /// A coefficient, or a place worked out from them, is not finite.
    #[error("one of its numbers is {0}, which is not finite")]
    NotFinite(f64),
    /// A coordinate or a length is beyond 1e100 in size.
    #[error("one of its coordinates or lengths is {0:e}, and nothing beyond 1e100 is drawn")]
    TooLarge(f64),
    /// Its weight is zero: it is at infinity, or an attitude without a place.
    #[error("its weight is zero: it is at infinity and has no place")]
    NoWeight,
    /// It is neither a blade, which is an outer product of vectors, nor a motor.
    #[error("it is neither a blade nor a motor")]
    NeitherBladeNorMotor,
    /// A trajectory of no places.
    #[error("the trajectory has no place")]
    EmptyTrajectory,
}

/// An element that can be drawn.
///
/// It is implemented for the types of [`cga3`](ga_runtime::cga3) over `f64`, for [`Trajectory`] and
/// for [`Shape`] itself. Types of a single vector ([`RoundVector`](ga_runtime::cga3::RoundVector),
/// [`DualPlane`](ga_runtime::cga3::DualPlane)) and the dual line
/// ([`MotorGenerator`](ga_runtime::cga3::MotorGenerator)) are read in dual form, all other blades
/// in direct form.
///
/// Squared radii within 1e-12 of zero, measured by the squared distance of the centre from the
/// origin, count as zero.
///
/// ```
/// use ga_draw::{Drawable, Shape};
/// use ga_runtime::cga3::{Point, Sphere};
/// let [a, b] = [0.0, 1.0].map(|x| Sphere::from_centre_radius(Point::new(x, 0.0, 0.0), 1.0));
/// let Shape::Circle { centre, radius, imaginary, .. } = (a & b).shape()? else { panic!() };
/// assert_eq!((centre, imaginary), ([0.5, 0.0, 0.0], false));
/// assert!((radius * radius - 0.75).abs() < 1e-15);
/// # Ok::<(), ga_draw::NotDrawable>(())
/// ```
pub trait Drawable {
    /// What the element is in Euclidean terms.
    ///
    /// # Errors
    ///
    /// [`NotDrawable`] where it has no place, or numbers that cannot be drawn.
    fn shape(&self) -> Result<Shape, NotDrawable>;
}

impl Drawable for Shape {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        self.clone().checked()
    }
}

impl<D: Drawable + ?Sized> Drawable for &D {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        (**self).shape()
    }
}

/// Fails where a coefficient is not finite, or all are zero.
fn check_coefficients(coefficients: impl IntoIterator<Item = f64>) -> Result<(), NotDrawable> {
    let mut all_zero = true;
    for coefficient in coefficients {
        if !coefficient.is_finite() {
            return Err(NotDrawable::NotFinite(coefficient));
        }
        all_zero &= coefficient == 0.0;
    }
    if all_zero {
        return Err(NotDrawable::Zero);
    }
    Ok(())
}

/// The coefficients of an element, divided by a power of two that brings the largest to about 1, so
/// that products of them stay in range; an error where one is not finite or all are zero.
fn balanced<E: ga_runtime::Element<Scalar = f64>>(element: &E) -> Result<E, NotDrawable> {
    let coefficients = || E::BLADES.iter().map(|&blade| element.coefficient(blade));
    check_coefficients(coefficients())?;
    let largest = coefficients().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    // In two steps, since the reciprocal of the smallest numbers is out of range.
    let root = (-0.5 * largest.log2()).round().exp2();
    Ok(E::from_coefficients_unchecked(&mut |blade| {
        element.coefficient(blade) * root * root
    }))
}

/// What a squared radius amounts to.
enum Radius {
    Real(f64),
    Zero,
    Imaginary(f64),
}

impl Radius {
    /// With the squared distance of the centre from the origin as the measure of what is zero.
    fn new(squared: f64, centre: Vector3) -> Self {
        let measure = crate::vector3::dot(centre, centre);
        if squared.abs() <= 1e-12 * measure {
            Self::Zero
        } else if squared < 0.0 {
            Self::Imaginary((-squared).sqrt())
        } else if squared == 0.0 {
            Self::Zero
        } else {
            Self::Real(squared.sqrt())
        }
    }
}
