//! Views that differ by a rotation alone, which have no epipolar geometry.

use ga_runtime::cga3::{Direction, Rotor};

use super::sampson::BearingPair;
use crate::geometry_error::ViewGeometryError;
use ga_numerics::order_statistics::Sorted;
use ga_numerics::ransac::{Consensus, Search};

/// Refuses pairs that a rotation explains about as well as a motion with a translation, and those
/// of which it explains most to a tenth of a pixel: corners are found no better, and lenses known
/// no better, so that what is left then tells nothing, however well a translation fits it.
pub(super) fn check(
    pairs: &[BearingPair],
    search: &Search,
    agreeing: usize,
    variance: f64,
) -> Result<(), ViewGeometryError> {
    /// The part of the pairs that must agree with the rotation.
    const PART: f64 = 0.9;
    /// Variances whose quotient is below this are about equal.
    const RATIO: f64 = 2.0;
    /// What a rotation may leave of the median pair, in pixels.
    const FINEST: f64 = 0.1;
    /// The standard deviation, in pixels, that rounding may cause.
    const ROUNDING: f64 = 1e-7;
    let Some(fit) = fit_rotation(pairs, search) else {
        return Ok(());
    };
    let explains_most = fit.inliers as f64 >= PART * agreeing as f64;
    let is_about_equal = fit.variance < RATIO * variance.max(ROUNDING * ROUNDING);
    if explains_most && (is_about_equal || fit.median < FINEST) {
        return Err(ViewGeometryError::PureRotation {
            rotation_rms: fit.variance.sqrt(),
            motion_rms: variance.sqrt(),
        });
    }
    Ok(())
}

/// The rotation that explains most pairs.
struct RotationFit {
    /// How many pairs agree with it.
    inliers: usize,
    /// The variance of a pixel coordinate that they show.
    variance: f64,
    /// The median distance, in pixels, shared by both views.
    median: f64,
}

/// The rotation that explains most pairs. `None` where no two pairs determine one.
fn fit_rotation(pairs: &[BearingPair], search: &Search) -> Option<RotationFit> {
    let problem = Rotations(pairs);
    // An error has two components here and one in the epipolar geometry.
    let search = Search {
        threshold: search.threshold * std::f64::consts::SQRT_2,
        ..*search
    };
    let mut best = search.run(&problem, 1).into_iter().next()?;
    let agreeing = search.inliers(&problem, &best.model);
    let directions = agreeing.iter().map(|&k| directions(&pairs[k]));
    if let Ok(fit) = Rotor::from_direction_pairs(&directions.collect::<Vec<_>>())
        && let Some(better) = search.rate(&problem, fit.motion, best.cost)
    {
        best = better;
    }
    let inliers = search.inliers(&problem, &best.model);
    let squares = inliers
        .iter()
        .map(|&k| problem.squared_error(&best.model, k));
    let mut squares: Vec<f64> = squares.collect();
    let redundancy = (2 * inliers.len()).saturating_sub(3).max(1);
    Some(RotationFit {
        variance: squares.iter().sum::<f64>() / redundancy as f64,
        median: Sorted::new(&mut squares)?.quantile(0.5).sqrt(),
        inliers: inliers.len(),
    })
}

fn directions(pair: &BearingPair) -> ([f64; 3], [f64; 3]) {
    (
        pair.left.direction.coordinates(),
        pair.right.direction.coordinates(),
    )
}

struct Rotations<'a>(&'a [BearingPair]);

impl Consensus for Rotations<'_> {
    type Model = Rotor<f64>;

    const SAMPLE: usize = 2;

    fn count(&self) -> usize {
        self.0.len()
    }

    fn fit(&self, sample: &[usize], models: &mut Vec<Rotor<f64>>) {
        let pairs = [0, 1].map(|k| directions(&self.0[sample[k]]));
        models.extend(Rotor::from_direction_pairs(&pairs).map(|fit| fit.motion));
    }

    /// The error is shared by the pixels of both views.
    fn squared_error(&self, rotor: &Rotor<f64>, observation: usize) -> f64 {
        let BearingPair { left, right } = &self.0[observation];
        let moved = rotor.transform(Direction::from_vector(left.direction.coordinates()));
        right.half_squared_distance(moved.into())
    }
}
