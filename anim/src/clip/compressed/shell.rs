//! How far an error of a joint's frame moves the points about the joint.

use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;
use nalgebra_035::Matrix3;

use crate::kinematics::KinematicsError;
use crate::recording::{Recording, model_maps};
use crate::transform::Transform;

/// A frame scaled below this part of its greatest scale in the recording counts as scaled by the
/// part: the points near a joint that shrinks to nothing have no end.
const LEAST_PART: f64 = 0.01;

/// The scale of each joint's frame in model space.
pub(super) struct Sizes {
    /// The greatest factor along any direction in any frame of the recording.
    pub(super) greatest: Vec<f64>,
}

impl Sizes {
    pub(super) fn new(recording: &Recording) -> Result<Self, KinematicsError> {
        let count = recording.joints().len();
        if recording.locals().iter().all(Transform::is_rigid) {
            let greatest = vec![1.0; count];
            return Ok(Self { greatest });
        }
        let mut greatest = vec![0.0f64; count];
        let mut models = vec![Affine::default(); count];
        for locals in recording.locals().chunks_exact(count) {
            model_maps(recording.parents(), locals, &mut models)?;
            for (greatest, model) in greatest.iter_mut().zip(&models) {
                *greatest = greatest.max(spectral_norm(model.linear, [[0.0; 3]; 3]));
            }
        }
        Ok(Self { greatest })
    }

    /// The least factor that counts for the points about a joint.
    pub(super) fn least(&self, joint: usize) -> f64 {
        least_of(self.greatest[joint])
    }
}

/// The least factor that counts beside a greatest one.
pub(super) fn least_of(greatest: f64) -> f64 {
    if greatest > 0.0 {
        LEAST_PART * greatest
    } else {
        1.0
    }
}

/// The greatest error of other maps to model space than those of a recording.
pub(crate) struct ShellError<'a> {
    recording: &'a Recording,
    shell: f64,
    sizes: Option<Sizes>,
    models: Vec<Affine<f64>>,
    greatest: f64,
}

impl<'a> ShellError<'a> {
    pub(crate) fn new(recording: &'a Recording, shell: f64) -> Self {
        Self {
            recording,
            shell,
            sizes: Sizes::new(recording).ok(),
            models: vec![Affine::default(); recording.joints().len()],
            greatest: 0.0,
        }
    }

    /// Takes the maps of a frame into account; others than one for each joint are infinitely wrong.
    pub(crate) fn compare(&mut self, frame: usize, truth: &[Affine<f64>]) {
        let (Some(sizes), Some(locals)) = (&self.sizes, self.recording.frame(frame)) else {
            self.greatest = f64::INFINITY;
            return;
        };
        let composed = model_maps(self.recording.parents(), locals, &mut self.models);
        if composed.is_err() || truth.len() != self.models.len() {
            self.greatest = f64::INFINITY;
            return;
        }
        for (joint, (found, truth)) in self.models.iter().zip(truth).enumerate() {
            let moved = Vector::from(found.translation).distance(truth.translation.into());
            let least = sizes.least(joint);
            let error = moved + self.shell * relative_difference(found.linear, truth.linear, least);
            // Not a number is infinitely wrong, too.
            let error = if error.is_nan() { f64::INFINITY } else { error };
            self.greatest = self.greatest.max(error);
        }
    }

    /// The greatest error so far, in metres.
    pub(crate) fn greatest(&self) -> f64 {
        self.greatest
    }
}

/// The greatest length of the difference of the images u ↦ L u under two linear maps, by rows, over
/// the u that the true map takes to vectors of length 1, with factors of at least `least`:
/// ‖(L' − L) L⁻¹‖.
pub(super) fn relative_difference(found: [[f64; 3]; 3], truth: [[f64; 3]; 3], least: f64) -> f64 {
    let truth = matrix(truth);
    let difference = matrix(found) - truth;
    let size = truth.amax();
    if size == 0.0 || !size.is_finite() {
        return norm(difference) / least;
    }
    // L is scaled by the roots of the eigenvalues of L^T L along its eigenvectors. The squares of
    // the numbers themselves could leave the range of numbers.
    let unit = truth / size;
    let gram = unit.transpose() * unit;
    let mean = gram.trace() / 3.0;
    if (gram - Matrix3::from_diagonal_element(mean)).amax() <= 1e-12 * mean {
        return norm(difference) / (size * mean.sqrt()).max(least);
    }
    let eigen = gram.symmetric_eigen();
    let mut images = difference * eigen.eigenvectors;
    for (mut image, square) in images.column_iter_mut().zip(&eigen.eigenvalues) {
        image /= (size * square.max(0.0).sqrt()).max(least);
    }
    norm(images)
}

/// The greatest singular value of the difference of two matrices, by rows.
pub(super) fn spectral_norm(a: [[f64; 3]; 3], b: [[f64; 3]; 3]) -> f64 {
    norm(matrix(a) - matrix(b))
}

fn matrix(rows: [[f64; 3]; 3]) -> Matrix3<f64> {
    Matrix3::from_fn(|row, column| rows[row][column])
}

/// The greatest singular value.
fn norm(matrix: Matrix3<f64>) -> f64 {
    // The Gram matrix of values near the rounding error would underflow.
    let size = matrix.amax();
    if size == 0.0 || !size.is_finite() {
        return size;
    }
    let unit = matrix / size;
    let eigenvalues = (unit.transpose() * unit).symmetric_eigenvalues();
    size * eigenvalues.max().max(0.0).sqrt()
}
