//! Motions as far as points show them, and as far as the calibration is right.
//!
//! All errors of a detector at one joint are related, so that the deviations of independent errors
//! are too small. How much a result depends on which joints are used shows the true ones: the
//! jackknife with groups of joints left out (B. Efron, "The jackknife, the bootstrap and other
//! resampling plans", 1982). With that covariance C of the motions x, and the covariance P that the
//! calibration states, the most likely ones are
//!
//! ```text
//! P (P + C)⁻¹ x
//! ```

use nalgebra_035::{Cholesky, DMatrix, DVector};
use rayon::prelude::*;

use super::bundle::Bundle;
use super::motion::{Motion, OFFSET, SIZE};
use super::options::RegistrationOptions;

/// How many groups of joints are left out in turn.
const GROUPS: usize = 8;
/// The variance of what is exact, so that equations have a solution.
const EXACT: f64 = 1e-12;

/// The motions of all views, and the standard deviations of their coordinates. Offsets are not
/// drawn to anything.
pub(super) fn shrunk(
    bundle: &Bundle<'_>,
    found: &[Motion],
    options: &RegistrationOptions,
) -> Option<(Vec<Motion>, Vec<Motion>)> {
    let (_, formal) = bundle.without(found, &[]).adjusted_near()?;
    let joints = bundle.joints();
    let groups = GROUPS.min(joints.len());
    let count = SIZE * found.len();
    let left_out = (0..groups).into_par_iter().filter_map(|group| {
        let own: Vec<usize> = joints.iter().skip(group).step_by(groups).copied().collect();
        let (motions, _) = bundle.without(found, &own).adjusted_near()?;
        Some(DVector::from_iterator(count, motions.into_iter().flatten()))
    });
    let left_out: Vec<DVector<f64>> = left_out.collect();
    let mean = left_out.iter().fold(DVector::zeros(count), |sum, own| {
        sum + own / left_out.len() as f64
    });
    let spread = left_out
        .iter()
        .fold(DMatrix::zeros(count, count), |sum: DMatrix<f64>, own| {
            let way = own - &mean;
            let way = &way;
            sum + way * way.transpose()
        });
    let parts = left_out.len().max(1) as f64;
    let covariance = formal + spread * ((parts - 1.0) / parts);
    let stated = (0..found.len()).flat_map(|view| {
        let mut deviations = bundle.deviations(view);
        if options.most_frames > 0 && view > 0 {
            // Far more than any offset.
            deviations[OFFSET] = 1e3 * options.most_frames as f64;
        }
        deviations
    });
    let stated = stated.map(|deviation| deviation * deviation + EXACT);
    let stated = DMatrix::from_diagonal(&DVector::from_iterator(count, stated));
    let sum = Cholesky::new(&stated + &covariance)?;
    let values = DVector::from_iterator(count, found.iter().flatten().copied());
    let shrunk = &stated * sum.solve(&values);
    let left = &stated - &stated * sum.solve(&stated);
    let of_view = |values: &dyn Fn(usize) -> f64| -> Vec<Motion> {
        let views = 0..found.len();
        views
            .map(|view| std::array::from_fn(|k| values(SIZE * view + k)))
            .collect()
    };
    Some((
        of_view(&|k| shrunk[k]),
        of_view(&|k| left[(k, k)].max(0.0).sqrt()),
    ))
}
