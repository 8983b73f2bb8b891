//! Lines, planes, flat points and directions.

use ga_runtime::cga3::{Direction, DualPlane, FlatPoint, Line, MotorGenerator, Plane, Point};

use super::{Drawable, NotDrawable, Shape, balanced, check_coefficients};
use crate::vector3::scaled;

impl Drawable for FlatPoint<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let point = balanced(self)?;
        if point.eoi == 0.0 {
            // The length of a free vector is part of it.
            return Direction::new(self.e1i, self.e2i, self.e3i).shape();
        }
        let at = point.to_point().ok_or(NotDrawable::NoWeight)?.coordinates();
        Shape::FlatPoint { at }.checked()
    }
}

impl Drawable for Direction<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let vector = self.vector();
        check_coefficients(vector)?;
        Shape::Direction { vector }.checked()
    }
}

impl Drawable for Line<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let line = balanced(self)?;
        let direction = line.unit_direction().ok_or(NotDrawable::NoWeight)?;
        let support = line.support().ok_or(NotDrawable::NoWeight)?.coordinates();
        Shape::Line { support, direction }.checked()
    }
}

impl Drawable for MotorGenerator<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        balanced(self)?.undual().shape()
    }
}

impl Drawable for Plane<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let plane = balanced(self)?;
        let normal = plane.unit_normal().ok_or(NotDrawable::NoWeight)?;
        let distance = plane.signed_distance(Point::default());
        let distance = distance.ok_or(NotDrawable::NoWeight)?;
        let support = scaled(normal, -distance);
        Shape::Plane { support, normal }.checked()
    }
}

impl Drawable for DualPlane<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        balanced(self)?.undual().shape()
    }
}
