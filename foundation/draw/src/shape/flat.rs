//! Lines, planes, flat points and directions.

use ga_runtime::cga3::{Direction, DualPlane, FlatPoint, Line, MotorGenerator, Plane, Point};
use ga_runtime::vga3::Vector;

use super::drawable::{balanced, check_coefficients};
use super::{Drawable, NotDrawable, Shape};

impl Drawable for FlatPoint<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let point = balanced(self)?;
        if point.eoi == 0.0 {
            // The original coefficients: the length of a free vector is part of its shape.
            return Direction::new(self.e1i, self.e2i, self.e3i).shape();
        }
        let at = point.to_point().ok_or(NotDrawable::NoWeight)?;
        Shape::FlatPoint { at }.checked()
    }
}

impl Drawable for Direction<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let vector = self.vector();
        check_coefficients(vector)?;
        let vector = Vector::from(vector);
        Shape::Direction { vector }.checked()
    }
}

impl Drawable for Line<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        let line = balanced(self)?;
        let direction = Vector::from(line.unit_direction().ok_or(NotDrawable::NoWeight)?);
        let support = line.support().ok_or(NotDrawable::NoWeight)?;
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
        let normal = Vector::from(plane.unit_normal().ok_or(NotDrawable::NoWeight)?);
        let distance = plane.signed_distance(Point::default());
        let distance = distance.ok_or(NotDrawable::NoWeight)?;
        let support = Point::from(normal * -distance);
        Shape::Plane { support, normal }.checked()
    }
}

impl Drawable for DualPlane<f64> {
    fn shape(&self) -> Result<Shape, NotDrawable> {
        balanced(self)?.undual().shape()
    }
}
