//! Skin weights from the distance to the bones.
//!
//! A point follows the n nearest bones, and the influence of each decreases with its distance. With
//! L the distance from the point to the bone as a segment and m the exponent of the decrease,
//!
//! ```text
//! wᵢ = Lᵢ⁻ᵐ / Σₖ Lₖ⁻ᵐ,   k over the n nearest bones
//! ```
//!
//! which is inverse distance weighting (D. Shepard, "A two-dimensional interpolation function for
//! irregularly-spaced data", ACM National Conference 1968; Cui, eq. 33). Distance in space ignores
//! the shape of the body: the left leg also follows the right thigh where the two are close. The
//! weights of [`geodesic`](super::geodesic) avoid that.

use ga_runtime::vga3::Vector;

use super::SkinWeights;
use crate::weights::error::SkinError;

/// The head and the tail of a bone.
pub type Bone = [[f64; 3]; 2];

/// The weights of points with respect to bones, given by head and tail in the order of their
/// joints.
///
/// Each point follows the `influences` nearest bones (all, if there are fewer), nearest first and
/// between equals the one listed first, with the weights of the formula above for m = `exponent`. A
/// point on a bone follows that bone alone; one that lies on several, at a joint, follows them
/// equally.
///
/// # Errors
///
/// [`SkinError::NoBones`], [`SkinError::NoInfluences`], [`SkinError::BadExponent`],
/// [`SkinError::BadBone`] and [`SkinError::BadPoint`], and those of [`SkinWeights::new`].
///
/// # Examples
///
/// ```
/// use ga_anim::distance_weights::distance_weights;
///
/// let thigh = [[0.0, 0.9, 0.0], [0.0, 0.5, 0.0]];
/// let shank = [[0.0, 0.5, 0.0], [0.0, 0.1, 0.0]];
/// // 0.1 m from the thigh and 0.2 m from the shank.
/// let weights = distance_weights([[0.1, 0.5 + 0.03f64.sqrt(), 0.0]], &[thigh, shank], 2, 2.0)?;
/// let [first, second] = weights.influences(0) else { panic!("two bones") };
/// assert!((first.weight - 0.8).abs() < 1e-15 && (second.weight - 0.2).abs() < 1e-15);
/// # Ok::<(), ga_anim::skin::SkinError>(())
/// ```
pub fn distance_weights(
    points: impl IntoIterator<Item = [f64; 3]>,
    bones: &[[[f64; 3]; 2]],
    influences: usize,
    exponent: f64,
) -> Result<SkinWeights, SkinError> {
    check(bones, influences, exponent)?;
    let mut rows = Vec::new();
    for (point, coordinates) in points.into_iter().enumerate() {
        let nearest = nearest(coordinates, bones, influences);
        if !nearest.iter().all(|(_, distance)| distance.is_finite()) {
            return Err(SkinError::BadPoint { point, coordinates });
        }
        rows.push(shares(&nearest, exponent));
    }
    SkinWeights::new(bones.len(), rows)
}

/// The distance from a point to a bone, the segment from head to tail. A bone without length is a
/// point.
#[must_use]
pub fn distance_to_bone(point: [f64; 3], [head, tail]: [[f64; 3]; 2]) -> f64 {
    let point = Vector::from(point);
    point.distance(nearest_on_bone(point, [head, tail]))
}

/// The point of a bone that is nearest to a point.
pub(super) fn nearest_on_bone(point: Vector<f64>, ends: Bone) -> Vector<f64> {
    let [head, tail] = ends.map(Vector::from);
    let (axis, from_head) = (tail - head, point - head);
    let square = axis.length_squared();
    let t = if square > 0.0 {
        (from_head.dot(axis) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    head + axis * t
}

/// Checks bones, number of influences and exponent.
pub(super) fn check(bones: &[Bone], influences: usize, exponent: f64) -> Result<(), SkinError> {
    if bones.is_empty() {
        return Err(SkinError::NoBones);
    }
    if influences == 0 {
        return Err(SkinError::NoInfluences);
    }
    if !exponent.is_finite() || exponent <= 0.0 {
        return Err(SkinError::BadExponent { exponent });
    }
    for (bone, &ends) in bones.iter().enumerate() {
        if !ends.iter().flatten().all(|x| x.is_finite()) {
            return Err(SkinError::BadBone { bone, ends });
        }
    }
    Ok(())
}

/// The nearest bones with their distances, nearest first and between equals the one listed first.
pub(super) fn nearest(point: [f64; 3], bones: &[Bone], influences: usize) -> Vec<(u32, f64)> {
    let mut distances: Vec<(u32, f64)> = (0..)
        .zip(bones)
        .map(|(joint, &bone)| (joint, distance_to_bone(point, bone)))
        .collect();
    // NaN comes last only with a positive sign; it must not be cut off.
    if distances.iter().all(|(_, distance)| distance.is_finite()) {
        distances.sort_by(|a, b| a.1.total_cmp(&b.1));
        distances.truncate(influences);
    }
    distances
}

/// The weights of the formula, up to a common factor, for bones with the nearest first.
pub(super) fn shares(distances: &[(u32, f64)], exponent: f64) -> Vec<(u32, f64)> {
    let nearest = distances.first().map_or(0.0, |(_, distance)| *distance);
    // Relative to the nearest bone, no power overflows.
    let weight = |distance: f64| {
        if distance == nearest {
            1.0
        } else {
            (nearest / distance).powf(exponent)
        }
    };
    distances
        .iter()
        .map(|&(joint, distance)| (joint, weight(distance)))
        .collect()
}
