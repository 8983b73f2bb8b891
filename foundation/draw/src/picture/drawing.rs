//! A picture while it is drawn, and the primitives for that.

use ga_runtime::vga3::Vector;

use super::data::{Ball, Curve, Dot, Form, Label, Patch, Picture};
use super::pen::Pen;
use super::polyline::{REACH, segment};
use crate::colour::Colour;
use crate::extent::Extent;
use crate::ring::{Ring, basis_across};

/// The length of the axes of a frame.
pub(super) const FRAME: f64 = 0.24;

/// The colours of the three axes of a frame.
const AXES: [Colour; 3] = [
    Colour([0xd5, 0x5e, 0x00]),
    Colour([0x00, 0x94, 0x6c]),
    Colour([0x00, 0x72, 0xb2]),
];

pub(super) struct Drawing {
    pub(super) extent: Extent,
    /// The horizontal axes at azimuth 0 and 90 degrees, and the upward one.
    pub(super) axes: [Vector<f64>; 3],
    pub(super) picture: Picture,
}

impl Drawing {
    pub(super) fn new(extent: Extent, axes: [Vector<f64>; 3]) -> Self {
        let picture = Picture::default();
        Self {
            extent,
            axes,
            picture,
        }
    }

    /// Adds a curve, and returns it for further changes.
    pub(super) fn curve(&mut self, pen: Pen, points: Vec<Vector<f64>>) -> &mut Curve {
        let index = self.picture.curves.len();
        self.picture.curves.push(Curve {
            element: pen.element,
            colour: pen.colour,
            points,
            width: pen.width,
            opacity: 1.0,
            dashed: false,
            arrow: false,
        });
        &mut self.picture.curves[index]
    }

    pub(super) fn dot(&mut self, pen: Pen, at: Vector<f64>, form: Form) {
        self.picture.dots.push(Dot {
            element: pen.element,
            colour: pen.colour,
            at,
            radius: 2.6 + 0.8 * pen.width,
            form,
        });
    }

    pub(super) fn arrow(&mut self, pen: Pen, from: Vector<f64>, vector: Vector<f64>) {
        self.curve(pen, segment(from, from + vector, 16)).arrow = true;
    }

    /// Adds the name of an axis.
    pub(super) fn axis_name(&mut self, element: Option<usize>, at: Vector<f64>, name: &str) {
        self.picture.labels.push(Label {
            element,
            at,
            text: name.to_owned(),
            strong: false,
        });
    }

    pub(super) fn frame(&mut self, pen: Pen, at: Vector<f64>, axes: &[Vector<f64>; 3], size: f64) {
        for (axis, colour) in axes.iter().zip(AXES) {
            let pen = Pen { colour, ..pen };
            self.arrow(pen, at, *axis * size);
        }
    }

    /// A sphere with its equator and two meridians.
    pub(super) fn ball(
        &mut self,
        pen: Pen,
        centre: Vector<f64>,
        radius: f64,
        imaginary: bool,
        opacity: f64,
    ) {
        self.picture.balls.push(Ball {
            element: pen.element,
            colour: pen.colour,
            centre,
            radius,
            opacity: if imaginary { 0.25 * opacity } else { opacity },
            width: 0.75 * pen.width,
            imaginary,
        });
        let [u, v, up] = self.axes;
        for basis in [[u, v], [u, up], [v, up]] {
            let curve = self.curve(
                pen.fine(),
                Ring {
                    centre,
                    basis,
                    radius,
                }
                .points(72),
            );
            (curve.opacity, curve.dashed) = (0.55, imaginary);
        }
    }

    /// A square of a plane about the point nearest to the middle of the picture, with a grid of
    /// lines and its normal; returns the corner for the label.
    pub(super) fn plane(
        &mut self,
        pen: Pen,
        middle: Vector<f64>,
        normal: Vector<f64>,
        opacity: f64,
    ) -> Vector<f64> {
        let [u, v] = basis_across(normal, self.axes);
        let half = 0.92 * REACH;
        let corner = |a: f64, b: f64| middle + u * (a * half) + v * (b * half);
        let corners = vec![
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(1.0, 1.0),
            corner(-1.0, 1.0),
        ];
        self.picture.patches.push(Patch {
            element: pen.element,
            colour: pen.colour,
            corners: corners.clone(),
            normal,
            opacity,
        });
        for side in 0..4 {
            let points = segment(corners[side], corners[(side + 1) % 4], 32);
            self.curve(pen.thin(), points).opacity = 0.8;
        }
        for k in -3..=3 {
            let t = f64::from(k) / 4.0;
            for [from, to] in [
                [corner(t, -1.0), corner(t, 1.0)],
                [corner(-1.0, t), corner(1.0, t)],
            ] {
                self.curve(pen.fine(), segment(from, to, 32)).opacity = 0.35;
            }
        }
        let foot = corner(0.75, 0.75);
        self.arrow(pen.thin(), foot, normal * (0.8 * FRAME));
        corner(-0.9, 0.9)
    }
}
