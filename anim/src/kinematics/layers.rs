//! One layer of poses over another.

use ga_runtime::batch::{Batch, Work};
use ga_runtime::cga3::Motor;
use ga_runtime::scalar::{Mask, Real};

use super::forward::{same_length, whole_poses};
use crate::kinematics::KinematicsError;

/// Blends a layer of poses over others, joint by joint: `(1 − w) M ± w N`, normalised, with the
/// motor M of the joint below, N above and the weight w of the joint ([`Motor::nlerp`]).
///
/// `below`, `above` and `blended` hold as many poses, one after the other, and `weights` a weight
/// for each joint. Weight 0 leaves M as it is to rounding, and 1 gives N up to its sign. The result
/// has the sign of M, and the shorter rotation is taken. More layers are blended one after the
/// other, each over what is below it. What is below may be any motors of the joints: their own
/// motions, or total ones.
///
/// # Errors
///
/// [`KinematicsError`]; nothing is written then.
///
/// ```
/// use ga_anim::kinematics::blend_layers;
/// use ga_runtime::cga3::{Motor, Translator};
///
/// let standing = [Motor::<f64>::default(); 2];
/// let reaching = [1.0, 2.0].map(|x| Motor::from(Translator::from_displacement([x, 0.0, 0.0])));
/// let mut blended = standing;
/// blend_layers(&standing, &reaching, &[0.5, 0.25], &mut blended)?;
/// assert_eq!(blended.map(|m| m.translator().displacement()[0]), [0.5, 0.5]);
/// # Ok::<(), ga_anim::kinematics::KinematicsError>(())
/// ```
pub fn blend_layers<S: Real>(
    below: &[Motor<S>],
    above: &[Motor<S>],
    weights: &[S],
    blended: &mut [Motor<S>],
) -> Result<(), KinematicsError> {
    whole_poses(weights.len(), below.len())?;
    same_length(below.len(), above.len())?;
    same_length(below.len(), blended.len())?;
    let mut are_shares = false;
    Batch::new().run(Check {
        weights,
        are_shares: &mut are_shares,
    });
    if !are_shares {
        let wrong = |weight: &S| !is_share(*weight).all();
        let joint = weights.iter().position(wrong).unwrap_or_default();
        return Err(KinematicsError::LayerWeight { joint });
    }
    let joints = weights.len().max(1);
    let batch = Batch::new();
    let poses = below.chunks_exact(joints).zip(above.chunks_exact(joints));
    for ((below, above), blended) in poses.zip(blended.chunks_exact_mut(joints)) {
        // The lengths are equal.
        let _ = batch.nlerp(below, above, weights, blended);
    }
    Ok(())
}

/// Whether all weights are from 0 to 1.
struct Check<'a, S> {
    weights: &'a [S],
    are_shares: &'a mut bool,
}

impl<S: Real> Work for Check<'_, S> {
    #[inline(always)]
    fn run(self) {
        // A count of what is wrong stays in vector registers, which a mask across the loop does
        // not.
        let faults = self.weights.iter().fold(S::zero(), |faults, weight| {
            let count = |is_right| S::select(is_right, S::zero(), S::one());
            let below = count(S::zero().less_or_equal(*weight));
            let above = count(weight.less_or_equal(S::one()));
            faults + (below + above)
        });
        *self.are_shares = faults.is_zero().all();
    }
}

#[inline(always)]
fn is_share<S: Real>(weight: S) -> S::Mask {
    S::zero().less_or_equal(weight) & weight.less_or_equal(S::one())
}
