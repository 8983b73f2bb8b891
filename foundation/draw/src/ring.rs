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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::Up;

    #[test]
    fn bases_are_orthonormal_right_handed_and_horizontal() {
        for up in [Up::Y, Up::Z] {
            let axes = up.axes();
            let up = axes[2];
            for normal in [
                up,
                -up,
                axes[0],
                Vector::new(0.36, 0.48, -0.8),
                Vector::new(-2.0, 1.0, 2.0) / 3.0,
            ] {
                let [u, v] = basis_across(normal, axes);
                assert!((u.length() - 1.0).abs() < 1e-15 && (v.length() - 1.0).abs() < 1e-15);
                assert!(u.dot(v).abs() < 1e-15 && u.dot(normal).abs() < 1e-15);
                assert!((u.cross(v) - normal).length() < 1e-15);
                assert!(u.dot(up).abs() < 1e-15);
            }
            assert_eq!(basis_across(up, axes), [axes[0], axes[1]]);
            assert_eq!(basis_across(-up, axes)[0], axes[0]);
        }
    }

    #[test]
    fn points_of_a_ring_go_round_counterclockwise() {
        let ring = Ring {
            centre: Vector::new(1.0, 2.0, 3.0),
            basis: [Vector::new(1.0, 0.0, 0.0), Vector::new(0.0, 1.0, 0.0)],
            radius: 2.0,
        };
        let expected = [
            [3.0, 2.0, 3.0],
            [1.0, 4.0, 3.0],
            [-1.0, 2.0, 3.0],
            [1.0, 0.0, 3.0],
        ];
        let points = ring.points(4);
        assert_eq!(points[4], points[0]);
        for (point, expected) in points.into_iter().zip(expected) {
            assert!((point - Vector::from(expected)).length() < 1e-15);
        }
    }
}
