//! Points, point pairs, circles and spheres.

use ga_runtime::cga3::{Circle, FlatPoint, Line, Plane, Point, PointPair, RoundVector, Sphere};

use super::{Drawable, NotDrawable, Radius, Shape, balanced};
use crate::vector3::{along, cross, dot, length, normalized, scaled, sum};

impl Drawable for Point<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let at = self.coordinates();
        Shape::Point { at }.checked()
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
        let centre = sphere.centre().ok_or(NotDrawable::NoWeight)?.coordinates();
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
        let centre = circle.centre().ok_or(NotDrawable::NoWeight)?.coordinates();
        let normal = circle.unit_normal().ok_or(NotDrawable::NoWeight)?;
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
    /// `p∧q` holds `q − p` in minus e1o, e2o, e3o, the moment `p × q` in e23, −e13, e12, `½(q² − p²)` in eoi and
    /// `½(p q² − q p²)` in e1i, e2i, e3i; centre and squared radius follow.
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let pair = balanced(self)?;
        let difference = [-pair.e1o, -pair.e2o, -pair.e3o];
        let moment = [pair.e23, -pair.e13, pair.e12];
        if difference == [0.0; 3] && moment == [0.0; 3] {
            // Unbalanced, since the length of a free vector is part of it.
            return FlatPoint::new(self.e1i, self.e2i, self.e3i, self.eoi).shape();
        }
        let direction = normalized(difference).ok_or(NotDrawable::NoWeight)?;
        let scale = length(difference).recip();
        let height = pair.eoi * scale;
        let centre = sum(
            scaled(direction, height),
            scaled(cross(direction, moment), scale),
        );
        let infinite = scaled([pair.e1i, pair.e2i, pair.e3i], scale);
        let squared = 2.0 * (height * height - dot(infinite, direction)) - dot(centre, centre);
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

/// The two points of a pair, the first of the outer product first.
pub(crate) fn ends(centre: [f64; 3], direction: [f64; 3], radius: f64) -> [[f64; 3]; 2] {
    [-radius, radius].map(|t| along(centre, direction, t))
}
