//! The coordinate axes and the grid.

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;

use super::drawing::Drawing;
use super::pen::Pen;
use super::polyline::{REACH, segment};
use crate::view::Up;

/// How far an axis reaches beyond the scene, in radii of the scene.
const AXIS_MARGIN: f64 = 0.15;

impl Drawing {
    /// The coordinate axes through the origin, from one side of the scene to the other.
    pub(super) fn coordinate_axes(&mut self) {
        let origin = self.extent.place(Point::default());
        let [low, high] = self.extent.corners;
        for (axis, name) in Up::Z.axes().into_iter().zip(["x", "y", "z"]) {
            let height = origin.dot(axis);
            let end = (high.dot(axis) - height).max(0.0) + AXIS_MARGIN;
            let start = (low.dot(axis) - height).min(0.0) - AXIS_MARGIN;
            let (from, to) = (origin + axis * start, origin + axis * end);
            let curve = self.curve(Pen::GREY, segment(from, to, 64));
            (curve.arrow, curve.opacity) = (true, 0.9);
            self.axis_name(None, to + axis * 0.05, name);
        }
    }

    /// Lines in the horizontal plane through the origin; their distance is 1, 2 or 5 times a power
    /// of ten.
    pub(super) fn grid(&mut self) {
        let [u, v, up] = self.axes;
        let extent = self.extent;
        let centre = Vector::from(extent.centre);
        let step = round_step(extent.radius / 4.0);
        // In units of the scene the grid is a square about the middle, with lines at multiples of
        // the step.
        let [a, b] = [u, v].map(|axis| (centre.dot(axis) / step).round());
        let reach = (REACH * extent.radius / step).floor().clamp(1.0, 12.0);
        let height = -centre.dot(up) / extent.radius;
        let corner = |s: f64, t: f64| {
            let point = u * ((a + s) * step) + v * ((b + t) * step);
            let point = extent.place(point.coordinates().into());
            point + up * (height - point.dot(up))
        };
        let count = reach as i32;
        for k in -count..=count {
            let k = f64::from(k);
            for [from, to] in [
                [corner(k, -reach), corner(k, reach)],
                [corner(-reach, k), corner(reach, k)],
            ] {
                let curve = self.curve(Pen::GREY.fine(), segment(from, to, 48));
                curve.opacity = 0.4;
            }
        }
    }
}

/// 1, 2 or 5 times a power of ten, near a positive number.
fn round_step(about: f64) -> f64 {
    let power = 10.0_f64.powf(about.log10().floor());
    let factor = about / power;
    power
        * match factor {
            _ if factor < 1.5 => 1.0,
            _ if factor < 3.5 => 2.0,
            _ if factor < 7.5 => 5.0,
            _ => 10.0,
        }
}
