//! Elements of the algebra as Euclidean shapes.

mod drawable;
mod error;
mod flat;
mod motion;
mod multivector;
mod round;
mod trajectory;

pub use drawable::Drawable;
pub use error::NotDrawable;
pub(crate) use multivector::whole;
pub use trajectory::Trajectory;

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

/// An element as Euclidean geometry: places, lengths and directions instead of coefficients.
///
/// A shape has no weight: an element and its multiples have the same shape, except that a
/// [`Direction`](Self::Direction) has a length, and that a negative factor reverses normals and
/// directions.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Shape {
    /// A point, `x + eo + ½x² ei`.
    Point {
        /// The place.
        at: Point<f64>,
    },
    /// A point and infinity, `p∧ei`.
    FlatPoint {
        /// The place.
        at: Point<f64>,
    },
    /// Two points `p∧q`, with `p = centre − radius · direction` and
    /// `q = centre + radius · direction`.
    PointPair {
        /// The midpoint.
        centre: Point<f64>,
        /// The direction from p to q, of length 1.
        direction: Vector<f64>,
        /// Half the distance of the points.
        radius: f64,
        /// Whether the square of the blade is negative. The squared distance of the points is then
        /// negative, and `radius` is √−r².
        imaginary: bool,
    },
    /// A point pair whose points coincide: a point with a direction.
    TangentVector {
        /// The point.
        at: Point<f64>,
        /// The direction, of length 1.
        direction: Vector<f64>,
    },
    /// A circle.
    Circle {
        /// The centre.
        centre: Point<f64>,
        /// The normal of its plane, of length 1.
        normal: Vector<f64>,
        /// The radius; of an imaginary circle √−r².
        radius: f64,
        /// Whether the squared radius is negative.
        imaginary: bool,
    },
    /// A circle of radius zero: a point with a plane.
    TangentBivector {
        /// The point.
        at: Point<f64>,
        /// The normal of the plane, of length 1.
        normal: Vector<f64>,
    },
    /// A sphere. One of radius zero is a [`Point`](Self::Point).
    Sphere {
        /// The centre.
        centre: Point<f64>,
        /// The radius; of an imaginary sphere √−r².
        radius: f64,
        /// Whether the squared radius is negative.
        imaginary: bool,
    },
    /// A line.
    Line {
        /// The point of the line nearest to the origin.
        support: Point<f64>,
        /// The direction, of length 1.
        direction: Vector<f64>,
    },
    /// A plane.
    Plane {
        /// The point of the plane nearest to the origin.
        support: Point<f64>,
        /// The normal, of length 1.
        normal: Vector<f64>,
    },
    /// A free vector, `v∧ei`, drawn from the origin.
    Direction {
        /// The vector.
        vector: Vector<f64>,
    },
    /// A frame: the images of the origin and of the three axes.
    Frame {
        /// The image of the origin.
        origin: Point<f64>,
        /// The images of the axes, each of length 1.
        axes: [Vector<f64>; 3],
    },
    /// A path.
    Trajectory {
        /// The points along it, at least one.
        points: Vec<Point<f64>>,
        /// Frames along it.
        frames: Vec<(Point<f64>, [Vector<f64>; 3])>,
    },
}

impl Shape {
    /// The name of its kind, as in the legend.
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

    /// The shape, or an error where one of its numbers cannot be drawn.
    fn checked(self) -> Result<Self, NotDrawable> {
        let vectors = self.vectors();
        let mut numbers = vectors
            .iter()
            .flat_map(|vector| vector.coordinates())
            .chain(self.radius());
        match numbers.find(|x| x.is_nan() || x.abs() > LARGEST) {
            Some(number) if number.is_finite() => Err(NotDrawable::TooLarge(number)),
            Some(number) => Err(NotDrawable::NotFinite(number)),
            None => Ok(self),
        }
    }

    /// Its places and directions.
    fn vectors(&self) -> Vec<Vector<f64>> {
        let frame = |origin: Point<f64>, axes: [Vector<f64>; 3]| {
            std::iter::once(Vector::from(origin)).chain(axes)
        };
        match self {
            Self::Point { at: place }
            | Self::FlatPoint { at: place }
            | Self::Sphere { centre: place, .. } => vec![Vector::from(*place)],
            Self::TangentVector {
                at: place,
                direction: side,
            }
            | Self::TangentBivector {
                at: place,
                normal: side,
            }
            | Self::PointPair {
                centre: place,
                direction: side,
                ..
            }
            | Self::Circle {
                centre: place,
                normal: side,
                ..
            }
            | Self::Line {
                support: place,
                direction: side,
            }
            | Self::Plane {
                support: place,
                normal: side,
            } => vec![Vector::from(*place), *side],
            Self::Direction { vector } => vec![*vector],
            Self::Frame { origin, axes } => frame(*origin, *axes).collect(),
            Self::Trajectory { points, frames } => {
                let points = points.iter().map(|point| Vector::from(*point));
                let frames = frames
                    .iter()
                    .flat_map(|(origin, axes)| frame(*origin, *axes));
                points.chain(frames).collect()
            }
        }
    }

    fn radius(&self) -> Option<f64> {
        match self {
            Self::PointPair { radius, .. }
            | Self::Circle { radius, .. }
            | Self::Sphere { radius, .. } => Some(*radius),
            Self::Point { .. }
            | Self::FlatPoint { .. }
            | Self::TangentVector { .. }
            | Self::TangentBivector { .. }
            | Self::Line { .. }
            | Self::Plane { .. }
            | Self::Direction { .. }
            | Self::Frame { .. }
            | Self::Trajectory { .. } => None,
        }
    }
}

/// The largest number that is drawn. Sums of a few squares of it are still finite.
const LARGEST: f64 = 1e100;
