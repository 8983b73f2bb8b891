//! Second differences of a motion: how joints and body accelerate from frame to frame.
//!
//! With the rotation R of a joint in its parent's frame, `a = log(R' ~R)` is the rotation vector
//! from one frame to the next, and the difference of two such vectors is that of the angular
//! velocities. For a rotation of R' by δ, and of R, the vector a changes by `J⁻¹(a) δ` and by
//! `−J⁻ᵀ(a) δ`, with
//!
//! ```text
//! J⁻¹(a) = 1 − ½ a× + (1/θ² − (1 + cos θ) / (2 θ sin θ)) (a×)²,   θ = |a|
//! ```
//!
//! (T. Barfoot, State Estimation for Robotics, 2017, section 7.1).

use ga_runtime::vga3::Vector;
use nalgebra_035::{Matrix3, Vector3};

use super::super::chain::{Chain, State, TRANSLATION, rotation_vector};
use ga_numerics::banded::frames::Block;

/// A second difference and its derivatives by the unknowns of three frames.
#[derive(Clone, Copy, Debug)]
pub(super) struct Difference {
    /// The first of its unknowns, in each of the frames.
    pub(super) first: usize,
    /// How many they are.
    pub(super) size: usize,
    pub(super) value: Vector3<f64>,
    /// For each of the three frames, the derivatives of the three components: columns for unknowns.
    pub(super) by_frame: [Matrix3<f64>; 3],
}

/// How many covariances there are: one for the translation and one for each joint.
pub(super) fn kinds(chain: &Chain<'_>) -> usize {
    1 + chain.columns.len()
}

/// How many components a second difference has.
pub(super) fn components(chain: &Chain<'_>, kind: usize) -> usize {
    match kind {
        0 => TRANSLATION,
        joint => chain.columns[joint - 1].count,
    }
}

/// A second difference in three frames. `None` for a joint without unknowns.
pub(super) fn difference(
    chain: &Chain<'_>,
    [before, now, after]: [&State; 3],
    kind: usize,
) -> Option<Difference> {
    if kind == 0 {
        let value = after.translation - now.translation * 2.0 + before.translation;
        let one = Matrix3::identity();
        return Some(Difference {
            first: 0,
            size: TRANSLATION,
            value: value.coordinates().into(),
            by_frame: [one, one * -2.0, one],
        });
    }
    let joint = kind - 1;
    let columns = chain.columns[joint];
    if columns.count == 0 {
        return None;
    }
    let between =
        |from: &State, to: &State| rotation_vector(to.rotors[joint] * from.rotors[joint].reverse());
    let (earlier, later) = (between(before, now), between(now, after));
    let directions = Matrix3::from_fn(|row, k| {
        if k < columns.count {
            columns.direction(k).coordinates()[row]
        } else {
            0.0
        }
    });
    let [of_earlier, of_later] = [earlier, later].map(inverse_jacobian);
    Some(Difference {
        first: columns.first,
        size: columns.count,
        value: (later - earlier).coordinates().into(),
        by_frame: [
            of_earlier.transpose() * directions,
            -(of_later.transpose() + of_earlier) * directions,
            of_later * directions,
        ],
    })
}

/// J⁻¹(a).
fn inverse_jacobian(vector: Vector<f64>) -> Matrix3<f64> {
    let [x, y, z] = vector.coordinates();
    let cross = Matrix3::new(0.0, -z, y, z, 0.0, -x, -y, x, 0.0);
    let angle = vector.length();
    let factor = if angle < 1e-2 {
        1.0 / 12.0 + angle * angle / 720.0
    } else {
        let half = 0.5 * angle;
        (1.0 - half / half.tan()) / (angle * angle)
    };
    Matrix3::identity() - cross * 0.5 + cross * cross * factor
}

impl Difference {
    /// The block of the normal equations for the unknowns of two of the frames.
    pub(super) fn block(&self, row: usize, column: usize, precision: &Matrix3<f64>) -> Block {
        let product = self.by_frame[row].tr_mul(&(precision * self.by_frame[column]));
        Block {
            first: self.first,
            size: self.size,
            entries: [0, 1, 2].map(|r| [0, 1, 2].map(|c| product[(r, c)])),
        }
    }

    /// The derivatives of half its weighted square by the unknowns of a frame, of which those
    /// beyond its size are 0.
    pub(super) fn gradient(&self, frame: usize, precision: &Matrix3<f64>) -> Vector3<f64> {
        self.by_frame[frame].tr_mul(&(precision * self.value))
    }

    /// Its square weighted with a precision, the inverse of a covariance.
    pub(super) fn squared(&self, precision: &Matrix3<f64>) -> f64 {
        self.value.dot(&(precision * self.value))
    }
}
