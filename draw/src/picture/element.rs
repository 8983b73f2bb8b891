//! The elements of a scene, each kind by the primitives that show it.

use super::data::{Form, Label};
use super::drawing::{Drawing, FRAME};
use super::pen::Pen;
use super::polyline::{clipped, refined, ring, segment};
use crate::scene::Element;
use crate::shape::{Shape, ends};
use crate::vector3::{Vector3, along, basis_across, dot, on_circle, scaled};

impl Drawing {
    /// Draws an element with its label.
    pub(super) fn element(&mut self, index: usize, element: &Element) {
        let pen = Pen {
            element: Some(index),
            colour: element.colour,
            width: element.width,
        };
        let anchor = self.shape(pen, &element.shape, element.opacity);
        if let Some(text) = &element.label {
            self.picture.labels.push(Label {
                element: Some(index),
                at: anchor,
                text: text.clone(),
                strong: true,
            });
        }
    }

    /// Draws a shape; returns the point that its label belongs to.
    fn shape(&mut self, pen: Pen, shape: &Shape, opacity: f64) -> Vector3 {
        let extent = self.extent;
        let length = |radius: &f64| radius / extent.radius;
        match shape {
            Shape::Point { at } => self.anchored_dot(pen, extent.place(*at), Form::Full),
            Shape::FlatPoint { at } => self.anchored_dot(pen, extent.place(*at), Form::Square),
            Shape::PointPair {
                centre,
                direction,
                radius,
                imaginary,
            } => {
                let ends = ends(*centre, *direction, *radius).map(|end| extent.place(end));
                self.point_pair(pen, ends, *imaginary)
            }
            Shape::TangentVector { at, direction } => {
                let at = self.anchored_dot(pen, extent.place(*at), Form::Full);
                self.arrow(pen, at, scaled(*direction, FRAME));
                at
            }
            Shape::Circle {
                centre,
                normal,
                radius,
                imaginary,
            } => {
                let (centre, radius) = (extent.place(*centre), length(radius));
                let basis = basis_across(*normal, self.up);
                self.curve(pen, ring(centre, basis, radius, 96)).dashed = *imaginary;
                on_circle(centre, basis, radius, 0.7)
            }
            Shape::TangentBivector { at, normal } => {
                self.tangent_bivector(pen, extent.place(*at), *normal)
            }
            Shape::Sphere {
                centre,
                radius,
                imaginary,
            } => {
                let (centre, radius) = (extent.place(*centre), length(radius));
                self.ball(pen, (centre, radius), *imaginary, opacity);
                // On the outline as seen from most sides.
                along(centre, self.up, radius)
            }
            Shape::Line { support, direction } => {
                let (middle, half) = clipped(extent.place(*support), *direction);
                let [from, to] = [-half, half].map(|t| along(middle, *direction, t));
                self.curve(pen, segment(from, to, 64)).arrow = true;
                along(middle, *direction, 0.8 * half)
            }
            Shape::Plane { support, normal } => {
                let distance = dot(extent.place(*support), *normal);
                self.plane(pen, scaled(*normal, distance), *normal, opacity)
            }
            Shape::Direction { vector } => {
                let from = extent.place([0.0; 3]);
                let vector = scaled(*vector, extent.radius.recip());
                self.arrow(pen, from, vector);
                along(from, vector, 0.6)
            }
            Shape::Frame { origin, axes } => self.named_frame(pen, extent.place(*origin), axes),
            Shape::Trajectory { points, frames } => {
                for (origin, axes) in frames {
                    self.frame(pen.thin(), extent.place(*origin), axes, 0.6 * FRAME);
                }
                self.path(
                    pen,
                    points.iter().map(|point| extent.place(*point)).collect(),
                )
            }
        }
    }

    fn anchored_dot(&mut self, pen: Pen, at: Vector3, form: Form) -> Vector3 {
        self.dot(pen, at, form);
        at
    }

    fn point_pair(&mut self, pen: Pen, [p, q]: [Vector3; 2], imaginary: bool) -> Vector3 {
        self.curve(pen.thin(), segment(p, q, 24)).dashed = imaginary;
        let form = if imaginary { Form::Hollow } else { Form::Full };
        self.dot(pen, p, form);
        self.anchored_dot(pen, q, form)
    }

    fn tangent_bivector(&mut self, pen: Pen, at: Vector3, normal: Vector3) -> Vector3 {
        let basis = basis_across(normal, self.up);
        self.curve(pen.thin(), ring(at, basis, 0.4 * FRAME, 48));
        self.arrow(pen.thin(), at, scaled(normal, 0.6 * FRAME));
        self.anchored_dot(pen, at, Form::Full)
    }

    /// A frame with the names of its axes.
    fn named_frame(&mut self, pen: Pen, at: Vector3, axes: &[Vector3; 3]) -> Vector3 {
        self.frame(pen, at, axes, FRAME);
        for (axis, name) in axes.iter().zip(["x", "y", "z"]) {
            self.axis_name(pen.element, along(at, *axis, 1.12 * FRAME), name);
        }
        self.anchored_dot(pen, at, Form::Full)
    }

    /// A path through at least one point.
    fn path(&mut self, pen: Pen, points: Vec<Vector3>) -> Vector3 {
        let middle = points[points.len() / 2];
        let (first, last) = (points[0], points[points.len() - 1]);
        if points.iter().all(|point| *point == first) {
            return self.anchored_dot(pen, first, Form::Full);
        }
        self.curve(pen, refined(&points)).arrow = first != last;
        middle
    }
}
