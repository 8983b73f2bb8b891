//! Parts of a body whose dots are not where its pose has them.

use super::MarkedBody;
use crate::agreement::OUTLIER;
use crate::mean_square::MeanSquare;
use crate::{FittedPose, Observation};

/// The root mean square of the length of a plane vector with two Gaussian coordinates of deviation
/// 1.
const EXPECTED: f64 = std::f64::consts::SQRT_2;

impl MarkedBody {
    /// The joint whose dots are farthest from where a pose has them, as the root mean square in
    /// their standard deviations, where that is more than [`OUTLIER`]: they are other dots. Where
    /// the dots of all other joints are farther away than their deviations explain, as in blurred
    /// pictures, the deviations are taken for so much larger.
    pub(super) fn worst_joint(&self, fitted: &FittedPose, seen: &Observation) -> Option<usize> {
        let count = self.model.skeleton().len();
        let mut of_joints = vec![MeanSquare::default(); count];
        let mut of_others = of_joints.clone();
        for (residuals, pixels) in fitted.residuals_px.iter().zip(&seen.views) {
            let dots = residuals.iter().zip(pixels).zip(&self.strongest);
            for ((residual, pixel), own) in dots {
                let (Some(residual), Some(pixel)) = (residual, pixel) else {
                    continue;
                };
                let deviations = residual / pixel.deviation;
                for (joint, other) in of_others.iter_mut().enumerate() {
                    match joint == *own {
                        true => of_joints[joint].add(deviations),
                        false => other.add(deviations),
                    }
                }
            }
        }
        let joints = of_joints.iter().zip(&of_others).enumerate();
        let far = joints.filter_map(|(joint, (own, others))| {
            let explained = others.root().map_or(1.0, |root| (root / EXPECTED).max(1.0));
            let deviations = own.root()? / explained;
            (deviations > OUTLIER).then_some((joint, deviations))
        });
        Some(far.max_by(|a, b| a.1.total_cmp(&b.1))?.0)
    }
}
