//! Points, point pairs, circles and spheres.

use ga_runtime::cga3::{
    Circle, DualCircle, DualFlatPoint, DualPointPair, DualSphere, FlatPoint, Line, Plane, Point,
    PointPair, RoundVector, Sphere,
};
use ga_runtime::vga3::Vector;

use super::drawable::balanced;
use super::{Drawable, NotDrawable, Shape};

impl Drawable for Point<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        Shape::Point { at: *self }.checked()
    }
}

impl Drawable for RoundVector<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        balanced(self)?.undual().shape()
    }
}

impl Drawable for Sphere<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let sphere = balanced(self)?;
        if sphere.e123o == 0.0 {
            return Plane::new(sphere.e123i, sphere.e12oi, sphere.e13oi, sphere.e23oi).shape();
        }
        let centre = sphere.centre().ok_or(NotDrawable::NoWeight)?;
        let squared = sphere.radius_squared().ok_or(NotDrawable::NoWeight)?;
        let (radius, imaginary) = match Radius::new(squared, centre) {
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
        let circle = balanced(self)?;
        let rounds = [circle.e123, circle.e12o, circle.e13o, circle.e23o];
        if rounds == [0.0; 4] {
            return Line::new(
                circle.e12i,
                circle.e13i,
                circle.e23i,
                circle.e1oi,
                circle.e2oi,
                circle.e3oi,
            )
            .shape();
        }
        let centre = circle.centre().ok_or(NotDrawable::NoWeight)?;
        let normal = Vector::from(circle.unit_normal().ok_or(NotDrawable::NoWeight)?);
        let squared = circle.radius_squared().ok_or(NotDrawable::NoWeight)?;
        let (radius, imaginary) = match Radius::new(squared, centre) {
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
        let pair = balanced(self)?;
        if [pair.e1o, pair.e2o, pair.e3o, pair.e12, pair.e13, pair.e23] == [0.0; 6] {
            // The original coefficients: the length of a free vector is part of its shape.
            return FlatPoint::new(self.e1i, self.e2i, self.e3i, self.eoi).shape();
        }
        let direction = Vector::from(pair.unit_direction().ok_or(NotDrawable::NoWeight)?);
        let centre = pair.centre().ok_or(NotDrawable::NoWeight)?;
        let squared = pair.radius_squared().ok_or(NotDrawable::NoWeight)?;
        let (radius, imaginary) = match Radius::new(squared, centre) {
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

macro_rules! by_the_direct_form {
    ($($Dual:ident)*) => {$(
        impl Drawable for $Dual<f64> {
            fn shape(&self) -> Result<Shape, NotDrawable> {
                balanced(self)?.undual().shape()
            }
        }
    )*};
}

by_the_direct_form!(DualFlatPoint DualPointPair DualCircle DualSphere);

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
