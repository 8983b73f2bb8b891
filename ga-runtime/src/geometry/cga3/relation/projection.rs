//! Projection and rejection: the nearest point of a primitive, and the rest.
//!
//! `a.project_onto(b)` is the part of a in b, and `a.reject_from(b)` is the difference from there
//! to a.
//!
//! - Point onto line or plane: the foot of the perpendicular, the centre of `(P⌋B) B⁻¹`.
//! - Point onto sphere with centre c: the end of the radius through the point, which is the nearer
//!   point of `(c∧P∧ei) ∨ S`.
//! - Point onto circle: the nearest point, found as on a sphere, for the sphere about c through the
//!   circle and the foot of P in the plane of the circle.
//! - Point onto point or point pair: the nearer point.
//! - Direction onto line: `(v·d) d`; onto plane or circle: `v − (v·n) n`. In blades `(V⌋B) B⁻¹`,
//!   where for a circle B is its plane `C∧ei`.
//! - Line onto plane: the line of the feet, `(L⌋Π) Π⁻¹`.
//! - Line onto circle: the points of the circle nearest to those of the line, [`LineOnCircle`].
//! - Circle onto plane: the feet of its points, an ellipse in general, [`CircleOnPlane`].
//! - Line onto sphere: the great circle below the line, `S ∨ (c∧L)` with c the centre, by
//!   [`great_circle_on`](crate::cga3::Line::great_circle_on).
//!
//! The result is `None` where the nearest point is not unique: for a sphere's centre, for a point
//! on the axis of a circle and for a point midway between the two of a pair. It is also `None` for
//! a line perpendicular to a plane, whose image is a point, for a line through the centre of a
//! sphere, and where one of the two is not a [`Figure`].
//!
//! ```
//! use ga_runtime::cga3::{Circle, Line, Plane, Point, Sphere};
//!
//! let p = Point::new(3.0, 4.0, 2.0);
//! let ground = Plane::from_point_normal(Point::default(), [0.0, 0.0, 1.0]);
//! assert_eq!(p.project_onto(ground), Some(Point::new(3.0, 4.0, 0.0)));
//! assert_eq!(p.reject_from(ground).unwrap().vector(), [0.0, 0.0, 2.0]);
//!
//! let ring = Circle::from_centre_normal_radius(Point::default(), [0.0, 0.0, 1.0], 1.0).unwrap();
//! assert!(p.project_onto(ring).unwrap().distance(Point::new(0.6, 0.8, 0.0)) < 1e-15);
//! // All points of a sphere are equally near to its centre.
//! assert_eq!(p.project_onto(Sphere::from_centre_radius(p, 1.0)), None);
//!
//! let line = Line::from_point_direction(p, [1.0, 0.0, 1.0]);
//! assert_eq!(line.project_onto(ground).unwrap().unit_direction(), Some([1.0, 0.0, 0.0]));
//! ```

use super::incidence::Directed;
use super::{Figure, FromPoint, Primitive, parallel};
use crate::cga3::{
    Circle, Direction, DualCircle, DualPlane, FlatPoint, Line, Plane, Point, PointPair, Sphere,
};
use crate::geometry::number::are_numbers;
use crate::scalar::{Maybe, Optional, Real};
use crate::vga3::Vector;

impl<S: Real> Point<S> {
    /// The point of the other primitive that is nearest to this one; see
    /// [`projection`](crate::geometry::relation::projection). `None` where there are several such
    /// points, or where the other is not a figure.
    #[inline]
    #[must_use]
    pub fn project_onto<T: FromPoint<S>>(self, other: T) -> Maybe<Self, S> {
        other.nearest_place(self.into()).map(Point::from)
    }

    /// The free vector `p − p'` to this point from the [nearest point](Self::project_onto) p' of
    /// the other primitive. Its length is the distance. `None` where the nearest point is not
    /// unique or not defined.
    #[inline]
    #[must_use]
    pub fn reject_from<T: FromPoint<S>>(self, other: T) -> Maybe<Direction<S>, S> {
        let way = self.project_onto(other).map(|place| place.vector_to(self));
        way.filter(|way| are_numbers(way.coordinates()))
            .map(Direction::from)
    }
}

impl<S: Real> FlatPoint<S> {
    /// The projection of its [point](Self::to_point); see [`Point::project_onto`].
    #[must_use]
    pub fn project_onto<T: FromPoint<S>>(self, other: T) -> Maybe<Point<S>, S> {
        self.to_point().and_then(|place| place.project_onto(other))
    }

    /// The rejection of its [point](Self::to_point); see [`Point::reject_from`].
    #[must_use]
    pub fn reject_from<T: FromPoint<S>>(self, other: T) -> Maybe<Direction<S>, S> {
        self.to_point().and_then(|place| place.reject_from(other))
    }
}

impl<S: Real<Mask = bool>> Direction<S> {
    /// The part of this vector along a line or in a plane, for a circle in the plane of the circle:
    /// `(v·d) d` or `v − (v·n) n`. It may be zero. `None` where this vector is not finite or the
    /// other is not a figure.
    ///
    /// ```
    /// use ga_runtime::cga3::{Direction, Line, Point};
    /// let line = Line::from_point_direction(Point::new(7.0, 8.0, 9.0), [0.0, 2.0, 0.0]);
    /// let v = Direction::from_vector([1.0, 2.0, 3.0]);
    /// assert_eq!(v.project_onto(line).unwrap().vector(), [0.0, 2.0, 0.0]);
    /// assert_eq!(v.reject_from(line).unwrap().vector(), [1.0, 0.0, 3.0]);
    /// ```
    #[must_use]
    pub fn project_onto<T: Directed<S>>(self, other: T) -> Option<Self> {
        Some(self.parts(other.figure()?)?[0])
    }

    /// The rest, `v − v'` with v' the [projection](Self::project_onto), which is perpendicular to
    /// it.
    #[must_use]
    pub fn reject_from<T: Directed<S>>(self, other: T) -> Option<Self> {
        Some(self.parts(other.figure()?)?[1])
    }

    /// Projection and rejection.
    fn parts(self, figure: Figure<S>) -> Option<[Self; 2]> {
        let vector = Vector::from(self);
        let along = |unit| unit * vector.dot(unit);
        let parts = match figure {
            Figure::Line { direction, .. } => [along(direction), vector.across(direction)],
            Figure::Plane { normal, .. } | Figure::Circle { normal, .. } => {
                [vector.across(normal), along(normal)]
            }
            Figure::Point(_) | Figure::PointPair(_) | Figure::Sphere { .. } => return None,
        };
        let finite = parts[0].is_finite() && parts[1].is_finite();
        finite.then(|| parts.map(Direction::from))
    }
}

impl<S: Real<Mask = bool>> Line<S> {
    /// The points of a plane or a circle that are nearest to those of this line.
    ///
    /// In a plane it is the line of the feet, `(L⌋Π) Π⁻¹`, with a direction of length 1; `None`
    /// where the line is perpendicular to the plane. On a circle it is a [`LineOnCircle`]; `None`
    /// for the axis of the circle and a radius of zero. `None` also where either is not a figure.
    ///
    /// ```
    /// use ga_runtime::cga3::{Circle, Line, Point};
    /// use ga_runtime::geometry::relation::projection::LineOnCircle;
    /// let (o, up) = (Point::default(), [0.0, 0.0, 1.0]);
    /// let ring = Circle::from_centre_normal_radius(o, up, 2.0).unwrap();
    /// let line = Line::from_point_direction(Point::new(0.0, 5.0, 1.0), [1.0, 0.0, 0.0]);
    /// let Some(LineOnCircle::HalfCircle { start, middle, end }) = line.project_onto(ring) else {
    ///     panic!()
    /// };
    /// assert_eq!(middle, Point::new(0.0, 2.0, 0.0));
    /// assert_eq!((start, end), (Point::new(-2.0, 0.0, 0.0), Point::new(2.0, 0.0, 0.0)));
    /// ```
    #[must_use]
    pub fn project_onto<T: ProjectLine<S>>(self, other: T) -> Option<T::Image> {
        other.project_line(self)
    }

    /// The rest of this line beside its [projection](Self::project_onto) onto a plane,
    /// `L − (L⌋Π) Π⁻¹`: the line along the normal of the plane through the point where this line
    /// crosses it. Its direction has length 1 and points to the side of the plane that this line's
    /// direction points to. `None` where they are parallel, or where either is not a figure.
    ///
    /// ```
    /// use ga_runtime::cga3::{Line, Plane, Point};
    /// let ground = Plane::from_point_normal(Point::default(), [0.0, 0.0, 1.0]);
    /// let line = Line::from_point_direction(Point::new(2.0, 0.0, 1.0), [1.0, 0.0, -1.0]);
    /// let upright = line.reject_from(ground).unwrap();
    /// assert_eq!(upright.direction(), [0.0, 0.0, -1.0]);
    /// let off: f64 = upright.distance(Point::new(3.0, 0.0, 0.0)).unwrap();
    /// assert!(off < 1e-15);
    /// ```
    #[must_use]
    pub fn reject_from(self, plane: Plane<S>) -> Option<Self> {
        let LineAndPlane {
            point,
            direction,
            normal,
            distance,
        } = line_and_plane(self, plane)?;
        let slope = direction.dot(normal);
        if slope.abs().less_than(parallel()) {
            return None;
        }
        let crossing = point + direction * ((distance - point.dot(normal)) / slope);
        let upright = if slope.less_than(S::zero()) {
            -normal
        } else {
            normal
        };
        line(crossing, upright)
    }

    /// The great circle of a sphere below this line: its intersection with the plane `c∧L` through
    /// the centre c, oriented so that it runs in the direction of the line on the side of the line.
    /// Its half on that side consists of the points of the sphere nearest to those of the line.
    /// `None` where the line passes the centre at a distance below 16 ε times that of the centre
    /// from the origin, or where either is not a figure.
    ///
    /// ```
    /// use ga_runtime::cga3::{Line, Point, Sphere};
    /// let line = Line::from_point_direction(Point::new(0.0, 5.0, 0.0), [1.0, 0.0, 0.0]);
    /// let below = line
    ///     .great_circle_on(Sphere::from_centre_radius(Point::default(), 2.0))
    ///     .unwrap();
    /// assert_eq!(below.radius(), Some(2.0));
    /// assert_eq!(below.unit_normal(), Some([0.0, 0.0, -1.0]));
    /// ```
    #[must_use]
    pub fn great_circle_on(self, sphere: Sphere<S>) -> Option<Circle<S>> {
        let Figure::Line { point, direction } = self.figure()? else {
            return None;
        };
        let Figure::Sphere { centre, radius } = sphere.figure()? else {
            return None;
        };
        let arm = (point - centre).across(direction);
        let least = point.length().max(centre.length()) * parallel();
        if !least.less_than(arm.length()) {
            return None;
        }
        let normal = arm.cross(direction).normalized()?;
        Circle::from_centre_normal_radius(centre.into(), normal.into(), radius)
    }
}

impl<S: Real<Mask = bool>> Circle<S> {
    /// The feet of this circle's points in a plane, which form an ellipse in general; see
    /// [`CircleOnPlane`]. `None` where either is not a figure, or the result is beyond the range of
    /// the scalar.
    ///
    /// ```
    /// use ga_runtime::cga3::{Circle, Direction, Plane, Point};
    /// use ga_runtime::geometry::relation::projection::CircleOnPlane;
    /// let ground = Plane::from_point_normal(Point::default(), [0.0, 0.0, 1.0]);
    /// let tilted = [0.0, -0.6, 0.8];
    /// let circle =
    ///     Circle::from_centre_normal_radius(Point::new(1.0, 2.0, 3.0), tilted, 5.0).unwrap();
    /// let found = circle.project_onto(ground);
    /// let Some(CircleOnPlane::Ellipse { centre, major, minor }) = found else {
    ///     panic!()
    /// };
    /// assert!(centre.distance(Point::new(1.0, 2.0, 0.0)) < 1e-14);
    /// let (major, minor): (f64, f64) = (major.length(), minor.length());
    /// assert!((major - 5.0).abs() < 1e-14 && (minor - 4.0).abs() < 1e-14);
    /// ```
    #[must_use]
    pub fn project_onto(self, plane: Plane<S>) -> Option<CircleOnPlane<S>> {
        let Figure::Circle {
            centre,
            normal,
            radius,
        } = self.figure()?
        else {
            return None;
        };
        let Figure::Plane {
            normal: m,
            distance,
        } = plane.figure()?
        else {
            return None;
        };
        let foot = centre - m * (centre.dot(m) - distance);
        let (along, cosine) = (m.cross(normal), m.dot(normal));
        let place = foot.is_finite().then(|| Point::from(foot))?;
        if along.length().less_than(parallel()) {
            let upward = if cosine.less_than(S::zero()) { -m } else { m };
            let circle = Circle::from_centre_normal_radius(place, upward.into(), radius)?;
            return Some(CircleOnPlane::Circle(circle));
        }
        let direction = along.normalized()?;
        if cosine.abs().less_than(parallel()) {
            let squared = radius * radius;
            let pair =
                PointPair::from_centre_axis_radius_squared(place, direction.into(), squared)?;
            return Some(CircleOnPlane::Segment(pair));
        }
        Some(CircleOnPlane::Ellipse {
            centre: place,
            major: (direction * radius).into(),
            minor: (m.cross(direction) * (radius * cosine)).into(),
        })
    }
}

/// What the points of a circle have as their feet in a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CircleOnPlane<S> {
    /// A circle of the same radius: the planes are parallel within 16 ε. It is oriented as the
    /// projected circle.
    Circle(Circle<S>),
    /// An ellipse, which is not an element of the algebra: the points
    /// `centre + cos φ · major + sin φ · minor`, in the order in which the circle runs.
    Ellipse {
        /// The foot of the circle's centre.
        centre: Point<S>,
        /// Half the major axis. Its length is the radius, and it is along the line in which the two
        /// planes meet.
        major: Direction<S>,
        /// Half the minor axis. Its length is the radius times the cosine of the angle between the
        /// planes.
        minor: Direction<S>,
    },
    /// The segment between two points: the planes are perpendicular within 16 ε, and the circle is
    /// seen from the side.
    Segment(PointPair<S>),
}

/// Which points of a circle are nearest to the points of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineOnCircle<S> {
    /// Half the circle without its two ends, which belong to the points at infinity of the line.
    HalfCircle {
        /// The end from which the line comes.
        start: Point<S>,
        /// The middle, nearest to the point of the line that is nearest to the axis of the circle.
        middle: Point<S>,
        /// The end towards which the line goes.
        end: Point<S>,
    },
    /// Two opposite points, in the order in which the line passes them: the line crosses the axis
    /// of the circle.
    Points(PointPair<S>),
    /// One point: the line is parallel to the axis.
    Point(Point<S>),
}

/// A primitive onto which lines are projected.
pub trait ProjectLine<S> {
    /// What a line is projected to.
    type Image;
    /// The projection of a line; see [`Line::project_onto`].
    fn project_line(self, line: Line<S>) -> Option<Self::Image>;
}

impl<S: Real<Mask = bool>> ProjectLine<S> for Plane<S> {
    type Image = Line<S>;
    fn project_line(self, line_above: Line<S>) -> Option<Line<S>> {
        let LineAndPlane {
            point,
            direction,
            normal,
            distance,
        } = line_and_plane(line_above, self)?;
        let flat = direction.across(normal);
        if flat.length().less_than(parallel()) {
            return None;
        }
        let foot = point - normal * (point.dot(normal) - distance);
        line(foot, flat.normalized()?)
    }
}

impl<S: Real<Mask = bool>> ProjectLine<S> for DualPlane<S> {
    type Image = Line<S>;
    fn project_line(self, line: Line<S>) -> Option<Line<S>> {
        self.undual().project_line(line)
    }
}

impl<S: Real<Mask = bool>> ProjectLine<S> for Circle<S> {
    type Image = LineOnCircle<S>;
    fn project_line(self, line: Line<S>) -> Option<LineOnCircle<S>> {
        let Figure::Line { point, direction } = line.figure()? else {
            return None;
        };
        let Figure::Circle {
            centre,
            normal,
            radius,
        } = self.figure()?
        else {
            return None;
        };
        if !S::zero().less_than(radius) {
            return None;
        }
        // What is left of a vector after the subtraction of its part along the normal is noise if
        // it is no longer than this.
        let noise = (point.length() + centre.length()) * parallel();
        let (flat, from) = (direction.across(normal), (point - centre).across(normal));
        let place = |way: Vector<S>| {
            let place = centre + way * radius;
            place.is_finite().then(|| Point::from(place))
        };
        if flat.length().less_than(parallel()) {
            let is_off = noise.less_than(from.length());
            let out = from.normalized().filter(|_| is_off)?;
            return place(out).map(LineOnCircle::Point);
        }
        let along = flat.normalized()?;
        let arm = from.across(along);
        if !noise.less_than(arm.length()) {
            let squared = radius * radius;
            return PointPair::from_centre_axis_radius_squared(
                centre.into(),
                along.into(),
                squared,
            )
            .map(LineOnCircle::Points);
        }
        Some(LineOnCircle::HalfCircle {
            start: place(-along)?,
            middle: place(arm.normalized()?)?,
            end: place(along)?,
        })
    }
}

impl<S: Real<Mask = bool>> ProjectLine<S> for DualCircle<S> {
    type Image = LineOnCircle<S>;
    fn project_line(self, line: Line<S>) -> Option<LineOnCircle<S>> {
        self.undual().project_line(line)
    }
}

/// A line and a plane as plain vectors.
struct LineAndPlane<S> {
    point: Vector<S>,
    direction: Vector<S>,
    normal: Vector<S>,
    distance: S,
}

fn line_and_plane<S: Real<Mask = bool>>(line: Line<S>, plane: Plane<S>) -> Option<LineAndPlane<S>> {
    match (line.figure()?, plane.figure()?) {
        (Figure::Line { point, direction }, Figure::Plane { normal, distance }) => {
            Some(LineAndPlane {
                point,
                direction,
                normal,
                distance,
            })
        }
        _ => None,
    }
}

/// The line through a point, where it is finite.
fn line<S: Real<Mask = bool>>(point: Vector<S>, direction: Vector<S>) -> Option<Line<S>> {
    let line = Line::from_point_direction(point.into(), direction.into());
    Vector::from(line.moment()).is_finite().then_some(line)
}
