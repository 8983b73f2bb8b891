//! Circles in space.

use std::f64::consts::TAU;

use ga_runtime::vga3::Vector;

/// A circle by its centre, two orthonormal vectors in its plane, and its radius.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ring {
    pub(crate) centre: Vector<f64>,
    pub(crate) basis: [Vector<f64>; 2],
    pub(crate) radius: f64,
}

impl Ring {
    /// The point at an angle from the first vector of the basis towards the second.
    pub(crate) fn at(&self, angle: f64) -> Vector<f64> {
        let (sine, cosine) = angle.sin_cos();
        let [u, v] = self.basis;
        self.centre + u * (self.radius * cosine) + v * (self.radius * sine)
    }

    /// Points at equal distances; the first is also the last.
    pub(crate) fn points(&self, pieces: u32) -> Vec<Vector<f64>> {
        let angle = |k: u32| TAU * f64::from(k % pieces) / f64::from(pieces);
        (0..=pieces).map(|k| self.at(angle(k))).collect()
    }
}

/// Two vectors u and v that form a right-handed orthonormal basis with a unit vector n,
/// `u × v = n`. Given the axes at azimuth 0 and 90 degrees and the upward axis, u is horizontal;
/// where n is vertical, u is the axis at azimuth 0.
pub(crate) fn basis_across(
    normal: Vector<f64>,
    [_, aside, up]: [Vector<f64>; 3],
) -> [Vector<f64>; 2] {
    let is_horizontal = up.cross(normal).length() < 1e-6;
    let up = if is_horizontal {
        aside * normal.dot(up)
    } else {
        up
    };
    normal.orthonormal_pair_with_up(up)
}
