//! The rotations that rectify the two views of a rig.

use std::f64::consts::FRAC_PI_2;

use ga_runtime::cga3::{Direction, Motor, Rotor};

use super::view::LARGEST_TANGENT;
use crate::geometry_error::ViewGeometryError;

/// Cameras whose axes are further apart, by 155°, have no roll between them.
const LEAST_ROLL: f64 = 0.1;

/// The rotations of the two cameras into their rectified frames.
pub(super) struct Rotations {
    pub(super) rotors: [Rotor<f64>; 2],
    /// The part of each rotation that puts its pictures on their side or head, in right angles
    /// from x to y, which is clockwise in a picture: 0 to 3.
    pub(super) quarter_turns: [u8; 2],
}

impl Rotations {
    /// The rotations of the cameras of a rig, from the motion of the left one's frame into the
    /// right one's, whose rotation is R.
    ///
    /// A roll Q of the right camera, a multiple of 90°, first brings its picture nearest to the
    /// left one. With H² = Q R the rotations are `W P H` and `W P ~H Q`: both cameras look the same
    /// way half way between, a roll P by a multiple of 90° puts the right one on the right, and the
    /// least rotation W puts the baseline along x.
    pub(super) fn of_rig(between: Motor<f64>) -> Result<Self, ViewGeometryError> {
        let displacement = between.translator().displacement();
        let [x, y, z] = displacement;
        let baseline = x.hypot(y).hypot(z);
        if !(baseline > 0.0 && baseline.is_finite()) {
            return Err(ViewGeometryError::Baseline(baseline));
        }
        let [[xx, xy, _], [yx, yy, _], _] = between.rotor().to_matrix();
        // This vector has the length 1 + cos of the angle between the axes.
        let roll_back = [xx + yy, xy - yx];
        if roll_back[0].hypot(roll_back[1]) < LEAST_ROLL {
            return Err(ViewGeometryError::Axis);
        }
        let right = quarter_turns(roll_back);
        let right_roll = roll(right)?;
        // The root of the short way.
        let half = (right_roll * between.rotor()).canonical().sqrt();
        let seen_half_way =
            (half.reverse() * right_roll).transform(Direction::from_vector(displacement));
        // The centre of the right camera is at −t.
        let [x, y, z] = seen_half_way.vector().map(|k| -k);
        if z.abs() > LARGEST_TANGENT * x.hypot(y) {
            return Err(ViewGeometryError::Forward([x, y, z]));
        }
        let both = quarter_turns([x, -y]);
        // Pictures that are not on their head now would be so after a half turn.
        if both == 2 && right == 0 {
            return Err(ViewGeometryError::Exchanged([x, y, z]));
        }
        let roll = roll(both)?;
        let centre = roll.transform(Direction::from_vector([x, y, z])).vector();
        let to_rows = Rotor::between(centre, [1.0, 0.0, 0.0]);
        let to_rows = to_rows.ok_or(ViewGeometryError::Baseline(baseline))? * roll;
        Ok(Self {
            rotors: [to_rows * half, to_rows * half.reverse() * right_roll],
            quarter_turns: [both, (both + right) % 4],
        })
    }
}

/// The angle of a vector from x to y in right angles, rounded to 0, 1, 2 or 3.
fn quarter_turns([x, y]: [f64; 2]) -> u8 {
    (y.atan2(x) / FRAC_PI_2).round().rem_euclid(4.0) as u8
}

/// The rotation about the axis of a camera.
fn roll(quarter_turns: u8) -> Result<Rotor<f64>, ViewGeometryError> {
    let angle = f64::from(quarter_turns) * FRAC_PI_2;
    Rotor::about_z(angle).ok_or(ViewGeometryError::Axis)
}
