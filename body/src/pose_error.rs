//! The distance of reconstructed joints from the true ones: as they are, relative to a root joint,
//! and after the alignment that fits best.
//!
//! Alignments are fits of ga-runtime ([`Motor::from_point_pairs`] and
//! [`Similarity::from_point_pairs`]). They are proper: for a mirror image the best rotation without
//! a reflection is taken.

use crate::BodyError;
use ga_runtime::cga3::{Motor, Point, Similarity};

/// Two poses after an alignment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aligned<V> {
    /// The motion that moves the reconstructed joints as near as possible to the true ones: the sum
    /// of squared distances is least.
    pub motion: V,
    /// The mean distance that remains.
    pub mean_error: f64,
    /// The root mean square of the distances that remain.
    pub root_mean_square_error: f64,
}

/// The mean distance between reconstructed and true joints, in the unit of the coordinates (mean
/// per joint position error, MPJPE; Cui, table 3).
///
/// # Errors
/// [`BodyError`] where there are no joints, different numbers of them, or joints that are not
/// finite.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_body::pose_error::mean_per_joint_position_error;
/// let truth = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point::from);
/// let found = [[0.0, 0.0, 0.5], [0.0, 1.0, 0.0]].map(Point::from);
/// assert_eq!(mean_per_joint_position_error(&truth, &found), Ok(0.25));
/// ```
pub fn mean_per_joint_position_error(
    truth: &[Point<f64>],
    found: &[Point<f64>],
) -> Result<f64, BodyError> {
    check(truth, found)?;
    let distances = truth.iter().zip(found).map(|(a, b)| a.distance(*b));
    Ok(mean(distances, truth.len()))
}

/// The same between joints relative to a root joint, the one of index `root` in both poses: the
/// error apart from where the body is. The root counts with its error of 0.
///
/// # Errors
/// [`BodyError`] where there are no joints, different numbers of them, joints that are not
/// finite, or no such root.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_body::pose_error::root_aligned_error;
/// let truth = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point::from);
/// let found = [[5.0, 0.0, 0.0], [5.0, 1.5, 0.0]].map(Point::from);
/// assert_eq!(root_aligned_error(&truth, &found, 0), Ok(0.25));
/// ```
pub fn root_aligned_error(
    truth: &[Point<f64>],
    found: &[Point<f64>],
    root: usize,
) -> Result<f64, BodyError> {
    check(truth, found)?;
    let joints = truth.len();
    let (Some(&here), Some(&there)) = (truth.get(root), found.get(root)) else {
        return Err(BodyError::Root { root, joints });
    };
    let pairs = truth.iter().zip(found);
    let distances = pairs.map(|(&a, &b)| here.vector_to(a).distance(there.vector_to(b)));
    Ok(mean(distances, joints))
}

/// The error after Procrustes analysis (PA-MPJPE): the reconstructed joints are rotated, translated
/// and scaled to the true ones first.
///
/// # Errors
/// [`BodyError`] where there are fewer than three joints or different numbers of them, for
/// joints that are not finite, and where several similarities fit equally well, as for joints on a
/// line.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_body::pose_error::procrustes_aligned;
/// let truth = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]].map(Point::from);
/// // Twice as large, and rotated by 90° about z.
/// let found = [[0.0, 0.0, 3.0], [-2.0, 0.0, 3.0], [0.0, 2.0, 3.0]].map(Point::from);
/// let aligned = procrustes_aligned(&truth, &found)?;
/// assert!(aligned.mean_error < 1e-15 && (aligned.motion.factor() - 0.5).abs() < 1e-15);
/// # Ok::<(), ga_body::BodyError>(())
/// ```
pub fn procrustes_aligned(
    truth: &[Point<f64>],
    found: &[Point<f64>],
) -> Result<Aligned<Similarity<f64>>, BodyError> {
    let pairs = pairs(truth, found)?;
    let fit = Similarity::from_point_pairs(&pairs)?;
    Ok(aligned(fit.motion, fit.residual(&pairs), &pairs, |found| {
        fit.motion.transform_point(found)
    }))
}

/// The error after the best rigid motion: the reconstructed joints are rotated and translated to
/// the true ones first, and keep their size.
///
/// # Errors
/// As [`procrustes_aligned`].
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_body::pose_error::rigidly_aligned;
/// let truth = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]].map(Point::from);
/// let found = [[0.0, 0.0, 3.0], [-1.0, 0.0, 3.0], [0.0, 1.0, 3.0]].map(Point::from);
/// assert!(rigidly_aligned(&truth, &found)?.mean_error < 1e-15);
/// # Ok::<(), ga_body::BodyError>(())
/// ```
pub fn rigidly_aligned(
    truth: &[Point<f64>],
    found: &[Point<f64>],
) -> Result<Aligned<Motor<f64>>, BodyError> {
    let pairs = pairs(truth, found)?;
    let fit = Motor::from_point_pairs(&pairs)?;
    Ok(aligned(fit.motion, fit.residual(&pairs), &pairs, |found| {
        fit.motion.transform(found)
    }))
}

fn aligned<V>(
    motion: V,
    root_mean_square_error: f64,
    pairs: &[(Point<f64>, Point<f64>)],
    moved: impl Fn(Point<f64>) -> Point<f64>,
) -> Aligned<V> {
    let distances = pairs
        .iter()
        .map(|&(found, truth)| moved(found).distance(truth));
    Aligned {
        mean_error: mean(distances, pairs.len()),
        motion,
        root_mean_square_error,
    }
}

/// A reconstructed joint and the true one.
type Pair = (Point<f64>, Point<f64>);

/// The reconstructed joints with the true ones.
fn pairs(truth: &[Point<f64>], found: &[Point<f64>]) -> Result<Vec<Pair>, BodyError> {
    check(truth, found)?;
    Ok(found.iter().copied().zip(truth.iter().copied()).collect())
}

fn mean(distances: impl Iterator<Item = f64>, count: usize) -> f64 {
    distances.sum::<f64>() / count as f64
}

fn check(truth: &[Point<f64>], reconstructed: &[Point<f64>]) -> Result<(), BodyError> {
    let (expected, found) = (truth.len(), reconstructed.len());
    if expected != found {
        return Err(BodyError::JointCounts { expected, found });
    }
    if expected == 0 {
        return Err(BodyError::NoJoints);
    }
    let is_finite = |point: &Point<f64>| point.coordinates().iter().all(|x| x.is_finite());
    let mut pairs = truth.iter().zip(reconstructed);
    match pairs.position(|(a, b)| !is_finite(a) || !is_finite(b)) {
        Some(joint) => Err(BodyError::JointNotFinite { joint }),
        None => Ok(()),
    }
}
