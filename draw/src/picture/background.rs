//! The coordinate axes and the grid.

use super::drawing::Drawing;
use super::pen::Pen;
use super::polyline::{REACH, clipped, segment};
use crate::vector3::{Vector3, along, difference, dot, scaled};

impl Drawing {
    /// The coordinate axes through the origin.
    pub(super) fn axes(&mut self) {
        let origin = self.extent.place([0.0; 3]);
        for (axis, name) in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
            .into_iter()
            .zip(["x", "y", "z"])
        {
            let (middle, half) = clipped(origin, axis);
            let (from, to) = (along(middle, axis, -half), along(middle, axis, half));
            let curve = self.curve(Pen::GREY, segment(from, to, 64));
            (curve.arrow, curve.opacity) = (true, 0.9);
            self.axis_name(None, along(to, axis, 0.05), name);
        }
    }

    /// Lines in the horizontal plane through the origin; their distance is 1, 2 or 5 times a power
    /// of ten.
    pub(super) fn grid(&mut self, [u, v, up]: [Vector3; 3]) {
        let extent = self.extent;
        let step = round_step(extent.radius / 4.0);
        // In units of the scene the grid is a square about the middle, with lines at multiples of
        // the step.
        let [a, b] = [u, v].map(|axis| (dot(extent.centre, axis) / step).round());
        let reach = (REACH * extent.radius / step).floor().clamp(1.0, 12.0);
        let height = -dot(extent.centre, up) / extent.radius;
        let corner = |s: f64, t: f64| {
            let point = along(scaled(u, (a + s) * step), v, (b + t) * step);
            let flat = difference(
                extent.place(point),
                scaled(up, dot(extent.place(point), up)),
            );
            along(flat, up, height)
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
