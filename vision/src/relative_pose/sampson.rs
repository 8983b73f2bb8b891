//! The epipolar condition of rays as lines, and its first-order distance in pixels.

use ga_runtime::cga3::{Line, Motor, MotorGenerator, Quaternion, Rotor, Translator};
use ga_runtime::vga3::Vector;

use super::bearing::Bearing;
use super::matrix::EssentialMatrix;
use ga_numerics::least_squares::{Columns, Equations, Problem};

/// The directions in which two cameras see one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingPair {
    /// In the frame of the left camera.
    pub left: Bearing,
    /// In the frame of the right camera.
    pub right: Bearing,
}

impl BearingPair {
    /// How far the rays of the two pixels are from meeting, for a motion M from the left camera's
    /// frame to the right one's.
    ///
    /// Rays that meet satisfy the epipolar condition `M l ~M ∨ r = 0` with the lines `l = eo ∧ d ∧
    /// ei` and `r` of the directions. The meet of two lines is a multiple e of ei, the distance of
    /// the lines times the sine of their angle times their weights. Divided by the length of its
    /// gradient by the four pixel coordinates, e becomes to first order the distance, in pixels, by
    /// which the pixels must be moved for the rays to meet (P. D. Sampson, "Fitting conic sections
    /// to very scattered data", 1982). It does not depend on the length of the translation. NaN
    /// where the motion has no translation.
    #[must_use]
    pub fn sampson_distance(&self, left_to_right: Motor<f64>) -> f64 {
        let Meets { value, slopes } = Meets::new(self, left_to_right);
        let square: f64 = slopes.iter().map(|slope| slope.value.powi(2)).sum();
        value.value / square.sqrt()
    }

    /// The same for an essential matrix.
    pub(super) fn sampson_distance_by(&self, essential: &EssentialMatrix) -> f64 {
        let at_left = essential.times(self.left.direction);
        let at_right = essential.transposed_times(self.right.direction);
        let [a, b] = self.left.derivatives.map(|along| at_right.dot(along));
        let [c, d] = self.right.derivatives.map(|along| at_left.dot(along));
        let square = a * a + b * b + c * c + d * d;
        self.right.direction.dot(at_left) / square.sqrt()
    }

    /// The distance with its derivatives by the motion: for an angular velocity and a velocity of
    /// the origin of `exp(B) M` in the right frame.
    fn linearised(&self, left_to_right: Motor<f64>) -> (f64, [Vector<f64>; 2]) {
        let Meets { value, slopes } = Meets::new(self, left_to_right);
        let square: f64 = slopes.iter().map(|slope| slope.value.powi(2)).sum();
        let inverse = square.sqrt().recip();
        let distance = value.value * inverse;
        let by = |part: fn(&Meet) -> Vector<f64>| {
            let shrink = slopes
                .iter()
                .fold(Vector::ZERO, |sum, slope| sum + part(slope) * slope.value);
            part(&value) * inverse - shrink * (distance / square)
        };
        (
            distance,
            [by(|meet| meet.by_rotation), by(|meet| meet.by_translation)],
        )
    }
}

/// The meet of two lines and its derivatives by a motion of the first one.
#[derive(Clone, Copy)]
struct Meet {
    value: f64,
    by_rotation: Vector<f64>,
    by_translation: Vector<f64>,
}

impl Meet {
    /// For a generator B of the motion, the line l changes by twice the commutator `B × l`, and the
    /// meet with r by the product of B with the commutator of the lines. That is the screw about
    /// their common perpendicular: what it has as an angular velocity is the derivative by the
    /// translation, and the other way round.
    fn new(moved: Line<f64>, right: Line<f64>) -> Self {
        let screw: MotorGenerator<f64> = moved.commutator(right);
        let [by_rotation, by_translation] = [
            -Vector::new(screw.e1i, screw.e2i, screw.e3i),
            Vector::new(-screw.e23, screw.e13, -screw.e12),
        ];
        Self {
            value: (moved & right).ei,
            by_rotation,
            by_translation,
        }
    }
}

/// The meet of two rays, and its derivatives by the four pixel coordinates: the meet is linear in
/// each of the lines.
struct Meets {
    value: Meet,
    slopes: [Meet; 4],
}

impl Meets {
    fn new(pair: &BearingPair, left_to_right: Motor<f64>) -> Self {
        let [left, right] = [pair.left.line(), pair.right.line()];
        let moved = left_to_right.transform(left);
        let [u, v] = pair
            .left
            .line_derivatives()
            .map(|line| left_to_right.transform(line));
        let [x, y] = pair.right.line_derivatives();
        Self {
            value: Meet::new(moved, right),
            slopes: [
                Meet::new(u, right),
                Meet::new(v, right),
                Meet::new(moved, x),
                Meet::new(moved, y),
            ],
        }
    }
}

/// The sum of the squared Sampson distances, as a function of a motion with a translation of length
/// 1. A step has five numbers: a rotation vector, and a change of the translation across itself.
pub(super) struct SampsonCost<'a> {
    pub(super) pairs: &'a [BearingPair],
}

impl Problem for SampsonCost<'_> {
    type State = Motor<f64>;

    fn columns(&self) -> Columns {
        Columns::dense(5)
    }

    fn evaluate(&self, motor: &Motor<f64>, equations: &mut Equations) -> Option<()> {
        let across = across_translation(*motor);
        for pair in self.pairs {
            let (distance, [by_rotation, by_translation]) = pair.linearised(*motor);
            let [x, y, z] = by_rotation.coordinates();
            let [a, b] = across.map(|direction| direction.dot(by_translation));
            equations.add(
                [distance],
                &[(0, [x]), (1, [y]), (2, [z]), (3, [a]), (4, [b])],
            );
        }
        Some(())
    }

    fn stepped(&self, motor: &Motor<f64>, step: &[f64]) -> Option<Motor<f64>> {
        let [a, b] = across_translation(*motor);
        let rotation = Vector::new(step[0], step[1], step[2]);
        let velocity = a * step[3] + b * step[4];
        let change = MotorGenerator::from_velocities(rotation.into(), velocity.into());
        with_unit_translation(change.exp() * *motor)
    }
}

/// Two unit vectors across the translation and each other.
pub(super) fn across_translation(motor: Motor<f64>) -> [Vector<f64>; 2] {
    Vector::from(motor.translator().displacement()).orthonormal_pair()
}

/// The motion with its translation scaled to length 1; `None` where it has none.
pub(super) fn with_unit_translation(motor: Motor<f64>) -> Option<Motor<f64>> {
    let unit = Vector::from(motor.translator().displacement()).normalized()?;
    let rotor = Quaternion::from(motor.rotor());
    let rotor = Rotor::normalize(rotor)?;
    Some(Translator::from_displacement(unit.coordinates()) * rotor)
}

#[cfg(test)]
mod tests {
    use super::*;
    use ga_camera::Intrinsics;

    #[test]
    fn derivatives_by_the_motion_agree_with_central_differences() {
        let camera = Intrinsics::new([700.0, 650.0], [310.0, 250.0]).expect("a camera");
        let rotor = Rotor::from_axis_angle([0.3, 1.0, -0.2], 0.2).expect("a rotation");
        let motor = Translator::from_displacement([0.6, 0.0, 0.8]) * rotor;
        let bearing = |pixel| Bearing::of_pixel(&camera, pixel).expect("a direction");
        let pair = BearingPair {
            left: bearing([100.0, 400.0]),
            right: bearing([250.0, 80.0]),
        };
        let (distance, [by_rotation, by_translation]) = pair.linearised(motor);
        assert!((distance - pair.sampson_distance(motor)).abs() < 1e-12);
        let essential = EssentialMatrix::from_motor(motor).expect("a translation");
        let by_matrix = pair.sampson_distance_by(&essential);
        assert!(
            (distance.abs() - by_matrix.abs()).abs() < 1e-9,
            "{distance} {by_matrix}"
        );
        for (axis, unit) in [Vector::X, Vector::Y, Vector::Z].into_iter().enumerate() {
            for (derivative, rotates) in [(by_rotation, true), (by_translation, false)] {
                let moved = |step: f64| {
                    let (rotation, velocity) = match rotates {
                        true => (unit * step, Vector::ZERO),
                        false => (Vector::ZERO, unit * step),
                    };
                    let change = MotorGenerator::from_velocities(rotation.into(), velocity.into());
                    pair.sampson_distance(change.exp() * motor)
                };
                let difference = (moved(1e-5) - moved(-1e-5)) / 2e-5;
                let found = derivative.coordinates()[axis];
                let tolerance = 1e-5 * difference.abs().max(1.0);
                assert!(
                    (found - difference).abs() < tolerance,
                    "{axis} {rotates}: {found} {difference}"
                );
            }
        }
    }
}
