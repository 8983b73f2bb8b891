//! Points, point pairs, circles and spheres.

use ga_runtime::Element;
use ga_runtime::cga3::{
    Bivector, Circle, DualCircle, DualFlatPoint, DualPointPair, DualSphere, FlatPoint, Line, Plane,
    Point, PointPair, Quadvector, RoundVector, Sphere, Trivector,
};
use ga_runtime::vga3::Vector;

use super::drawable::{balanced, check_coefficients};
use super::{Drawable, NotDrawable, Shape};

impl Drawable for Point<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        Shape::Point { at: *self }.checked()
    }
}

/// A dual sphere or a dual plane.
impl Drawable for RoundVector<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        balanced(self)?.undual().shape()
    }
}

/// A sphere or a plane.
impl Drawable for Quadvector<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let sum = balanced(self)?;
        match sum.e123o == 0.0 {
            true => Plane::new(sum.e123i, sum.e12oi, sum.e13oi, sum.e23oi).shape(),
            false => read::<Sphere<f64>>(sum).shape(),
        }
    }
}

/// A circle or a line.
impl Drawable for Trivector<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let sum = balanced(self)?;
        let rounds = [sum.e123, sum.e12o, sum.e13o, sum.e23o];
        match rounds == [0.0; 4] {
            true => Line::new(sum.e12i, sum.e13i, sum.e23i, sum.e1oi, sum.e2oi, sum.e3oi).shape(),
            false => read::<Circle<f64>>(sum).shape(),
        }
    }
}

/// A point pair, a flat point or a free vector.
impl Drawable for Bivector<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let sum = balanced(self)?;
        let rounds = [sum.e1o, sum.e2o, sum.e3o, sum.e12, sum.e13, sum.e23];
        match rounds == [0.0; 6] {
            // The original coefficients: the length of a free vector is part of its shape.
            true => FlatPoint::new(self.e1i, self.e2i, self.e3i, self.eoi).shape(),
            false => read::<PointPair<f64>>(sum).shape(),
        }
    }
}

/// The parameters of a blade that is a round.
fn read<T: Element<Scalar = f64>>(sum: impl Element<Scalar = f64>) -> T {
    T::from_coefficients_unchecked(&mut |blade| sum.coefficient(blade))
}

impl Drawable for Sphere<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let centre = placed(self.centre, [self.weight, 0.0, 0.0], self.radius_squared)?;
        let (radius, imaginary) = match Radius::new(self.radius_squared, centre) {
            Radius::Zero => return Shape::Point { at: centre }.checked(),
            Radius::Real(radius) => (radius, false),
            Radius::Imaginary(radius) => (radius, true),
        };
        Shape::Sphere {
            centre,
            radius,
            imaginary,
        }
        .checked()
    }
}

impl Drawable for Circle<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let centre = placed(self.centre, self.normal.vector(), self.radius_squared)?;
        let normal = Vector::from(self.unit_normal().ok_or(NotDrawable::NoWeight)?);
        let (radius, imaginary) = match Radius::new(self.radius_squared, centre) {
            Radius::Zero => return Shape::TangentBivector { at: centre, normal }.checked(),
            Radius::Real(radius) => (radius, false),
            Radius::Imaginary(radius) => (radius, true),
        };
        Shape::Circle {
            centre,
            normal,
            radius,
            imaginary,
        }
        .checked()
    }
}

impl Drawable for PointPair<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let centre = placed(self.centre, self.direction.vector(), self.radius_squared)?;
        let direction = Vector::from(self.unit_direction().ok_or(NotDrawable::NoWeight)?);
        let (radius, imaginary) = match Radius::new(self.radius_squared, centre) {
            Radius::Zero => {
                return Shape::TangentVector {
                    at: centre,
                    direction,
                }
                .checked();
            }
            Radius::Real(radius) => (radius, false),
            Radius::Imaginary(radius) => (radius, true),
        };
        Shape::PointPair {
            centre,
            direction,
            radius,
            imaginary,
        }
        .checked()
    }
}

/// The centre of a round, whose weight is not zero and whose numbers are finite.
fn placed(
    centre: Point<f64>,
    weight: [f64; 3],
    radius_squared: f64,
) -> Result<Point<f64>, NotDrawable> {
    match check_coefficients(weight) {
        Err(NotDrawable::Zero) => return Err(NotDrawable::NoWeight),
        checked => checked?,
    }
    let numbers = centre.coordinates().into_iter().chain([radius_squared]);
    match numbers.into_iter().find(|number| !number.is_finite()) {
        Some(number) => Err(NotDrawable::NotFinite(number)),
        None => Ok(centre),
    }
}

macro_rules! by_the_direct_form {
    ($($Dual:ident)*) => {$(
        impl Drawable for $Dual<f64> {
            fn shape(&self) -> Result<Shape, NotDrawable> {
                self.undual().shape()
            }
        }
    )*};
}

by_the_direct_form!(DualPointPair DualCircle DualSphere);

impl Drawable for DualFlatPoint<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        balanced(self)?.undual().shape()
    }
}

/// A radius, classified by the sign of its square.
enum Radius {
    Real(f64),
    Zero,
    Imaginary(f64),
}

impl Radius {
    /// The squared radius is compared with the squared distance of the centre from the origin.
    fn new(squared: f64, centre: Point<f64>) -> Self {
        let measure = centre.distance_squared(Point::default());
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
