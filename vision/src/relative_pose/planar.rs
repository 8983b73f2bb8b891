//! The motions that a plane of the scene shows.

use ga_runtime::cga3::Motor;

use super::sampson::{BearingPair, with_unit_translation};
use crate::homography::Homography;
use ga_numerics::ransac::{Consensus, Search};

/// The two motions, with translations of length 1, that explain the pairs of the plane with which
/// most pairs agree alike. Where a scene is one plane, one of them is that of the cameras;
/// elsewhere they are starts of a search like others. `None` where fewer than four pairs agree, or
/// the cameras are in one place.
pub(super) fn motions(pairs: &[BearingPair], search: &Search) -> Option<[Motor<f64>; 2]> {
    /// Enough for a plane with 40 % of the pairs. One with fewer leaves no doubt, as the other
    /// pairs tell its motions apart.
    const SAMPLES: usize = 400;
    // An error has two components here and one in the epipolar geometry.
    let search = Search {
        threshold: search.threshold * std::f64::consts::SQRT_2,
        samples: search.samples.min(SAMPLES),
        ..*search
    };
    let problem = Planes(pairs);
    let mut best = search.run(&problem, 1).into_iter().next()?;
    let agreeing = search.inliers(&problem, &best.model);
    if let Some(fit) = problem.homography(&agreeing)
        && let Some(better) = search.rate(&problem, fit, best.cost)
    {
        best = better;
    }
    let [first, second] = best.model.motions()?;
    Some([
        with_unit_translation(first)?,
        with_unit_translation(second)?,
    ])
}

struct Planes<'a>(&'a [BearingPair]);

impl Planes<'_> {
    /// The homography of some pairs.
    fn homography(&self, chosen: &[usize]) -> Option<Homography> {
        let side = |k: usize| {
            let BearingPair { left, right } = &self.0[k];
            let [left, right] = [left.direction, right.direction];
            let flat = [left, right].map(|d| [d.e1 / d.e3, d.e2 / d.e3]);
            (left.e3 > 0.0 && right.e3 > 0.0).then_some(flat)
        };
        let flat: Option<Vec<[[f64; 2]; 2]>> = chosen.iter().map(|&k| side(k)).collect();
        let (left, right): (Vec<_>, Vec<_>) = flat?.into_iter().map(|[l, r]| (l, r)).unzip();
        Homography::from_pairs(&left, &right)
    }
}

impl Consensus for Planes<'_> {
    type Model = Homography;

    const SAMPLE: usize = 4;

    fn count(&self) -> usize {
        self.0.len()
    }

    fn fit(&self, sample: &[usize], models: &mut Vec<Homography>) {
        models.extend(self.homography(sample));
    }

    fn squared_error(&self, model: &Homography, observation: usize) -> f64 {
        let BearingPair { left, right } = &self.0[observation];
        right.half_squared_distance(model.image(left.direction))
    }
}
