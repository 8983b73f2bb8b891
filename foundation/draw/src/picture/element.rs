//! The elements of a scene, each kind drawn with primitives.

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use super::data::{Form, Label};
use super::drawing::{Drawing, FRAME};
use super::pen::Pen;
use super::polyline::{clipped, refined, segment};
use crate::ring::{Ring, basis_across};
use crate::scene::Element;
use crate::shape::Shape;

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
    fn shape(&mut self, pen: Pen, shape: &Shape, opacity: f64) -> Vector<f64> {
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
                let (centre, half) = (extent.place(*centre), *direction * length(radius));
                let ends = [centre - half, centre + half];
                self.point_pair(pen, ends, *imaginary)
            }
            Shape::TangentVector { at, direction } => {
                let at = self.anchored_dot(pen, extent.place(*at), Form::Full);
                self.arrow(pen, at, *direction * FRAME);
                at
            }
            Shape::Circle {
                centre,
                normal,
                radius,
                imaginary,
            } => {
                let ring = Ring {
                    centre: extent.place(*centre),
                    basis: basis_across(*normal, self.axes),
                    radius: length(radius),
                };
                self.curve(pen, ring.points(96)).dashed = *imaginary;
                ring.at(0.7)
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
                self.ball(pen, centre, radius, *imaginary, opacity);
                // On the outline as seen from most sides.
                centre + self.axes[2] * radius
            }
            Shape::Line { support, direction } => {
                let (middle, half) = clipped(extent.place(*support), *direction);
                let [from, to] = [-half, half].map(|t| middle + *direction * t);
                self.curve(pen, segment(from, to, 64)).arrow = true;
                middle + *direction * (0.8 * half)
            }
            Shape::Plane { support, normal } => {
                let distance = extent.place(*support).dot(*normal);
                self.plane(pen, *normal * distance, *normal, opacity)
            }
            Shape::Direction { vector } => {
                let from = extent.place(Point::default());
                let vector = *vector * extent.radius.recip();
                self.arrow(pen, from, vector);
                from + vector * 0.6
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

    fn anchored_dot(&mut self, pen: Pen, at: Vector<f64>, form: Form) -> Vector<f64> {
        self.dot(pen, at, form);
        at
    }

    fn point_pair(&mut self, pen: Pen, [p, q]: [Vector<f64>; 2], imaginary: bool) -> Vector<f64> {
        self.curve(pen.thin(), segment(p, q, 24)).dashed = imaginary;
        let form = if imaginary { Form::Hollow } else { Form::Full };
        self.dot(pen, p, form);
        self.anchored_dot(pen, q, form)
    }

    fn tangent_bivector(&mut self, pen: Pen, at: Vector<f64>, normal: Vector<f64>) -> Vector<f64> {
        let ring = Ring {
            centre: at,
            basis: basis_across(normal, self.axes),
            radius: 0.4 * FRAME,
        };
        self.curve(pen.thin(), ring.points(48));
        self.arrow(pen.thin(), at, normal * (0.6 * FRAME));
        self.anchored_dot(pen, at, Form::Full)
    }

    /// A frame with the names of its axes.
    fn named_frame(&mut self, pen: Pen, at: Vector<f64>, axes: &[Vector<f64>; 3]) -> Vector<f64> {
        self.frame(pen, at, axes, FRAME);
        for (axis, name) in axes.iter().zip(["x", "y", "z"]) {
            self.axis_name(pen.element, at + *axis * (1.12 * FRAME), name);
        }
        self.anchored_dot(pen, at, Form::Full)
    }

    /// A path through at least one point.
    fn path(&mut self, pen: Pen, points: Vec<Vector<f64>>) -> Vector<f64> {
        let middle = points[points.len() / 2];
        let (first, last) = (points[0], points[points.len() - 1]);
        if points.iter().all(|point| *point == first) {
            return self.anchored_dot(pen, first, Form::Full);
        }
        self.curve(pen, refined(&points)).arrow = first != last;
        middle
    }
}
