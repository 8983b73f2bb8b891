//! How far fitted poses are from their pixels, in the standard deviations of these.

pub use crate::likelihood::OUTLIER;
use crate::mean_square::MeanSquare;
use crate::{FittedPose, Observation};

/// The root mean squares of distances from pixels, each in the standard deviation of its pixel, so
/// that √2 is expected of Gaussian noise. `None` where nothing is seen.
#[derive(Clone, Debug, PartialEq)]
pub struct Agreement {
    /// Of each view, over all frames.
    pub of_views: Vec<Option<f64>>,
    /// Of each frame, over all views.
    pub of_frames: Vec<Option<f64>>,
}

impl Agreement {
    /// Of poses with what they were fitted to, in the same order.
    #[must_use]
    pub fn new(fitted: &[FittedPose], observations: &[Observation]) -> Self {
        let views = fitted.first().map_or(0, |fit| fit.residuals_px.len());
        let mut of_views = vec![MeanSquare::default(); views];
        let of_frames = fitted.iter().zip(observations).map(|(fit, observation)| {
            let mut of_frame = MeanSquare::default();
            let seen = fit.residuals_px.iter().zip(&observation.views);
            for ((residuals, pixels), of_view) in seen.zip(&mut of_views) {
                for (residual, pixel) in residuals.iter().zip(pixels) {
                    if let (Some(residual), Some(pixel)) = (residual, pixel) {
                        let deviations = residual / pixel.deviation;
                        of_frame.add(deviations);
                        of_view.add(deviations);
                    }
                }
            }
            of_frame.root()
        });
        let of_frames = of_frames.collect();
        Self {
            of_views: of_views.iter().map(MeanSquare::root).collect(),
            of_frames,
        }
    }

    /// The numbers of the views that are fitted badly, and how far they are from their pixels: more
    /// than [`OUTLIER`] standard deviations.
    pub fn bad_views(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        bad(&self.of_views)
    }

    /// The same of frames.
    pub fn bad_frames(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        bad(&self.of_frames)
    }
}

fn bad(values: &[Option<f64>]) -> impl Iterator<Item = (usize, f64)> + '_ {
    let numbered = values.iter().enumerate();
    numbered.filter_map(|(index, value)| Some((index, value.filter(|value| *value > OUTLIER)?)))
}

#[cfg(test)]
mod tests {
    use ga_anim::pose::Pose;

    use super::*;
    use crate::JointPixel;

    fn frame(residuals_px: Vec<Vec<Option<f64>>>, deviation: f64) -> (FittedPose, Observation) {
        let pixel = |residual: &Option<f64>| {
            residual.map(|_| JointPixel {
                position: [0.0; 2],
                deviation,
            })
        };
        let views = residuals_px.iter();
        let views = views.map(|view| view.iter().map(pixel).collect()).collect();
        let fit = FittedPose {
            pose: Pose::rest(1),
            points: Vec::new(),
            residuals_px,
            root_mean_square_px: 0.0,
            unseen: Vec::new(),
        };
        (fit, Observation { views })
    }

    #[test]
    fn distances_are_in_the_deviations_of_their_pixels() {
        let (fitted, observations): (Vec<_>, Vec<_>) = [
            frame(vec![vec![Some(6.0), None], vec![Some(8.0), None]], 2.0),
            frame(vec![vec![Some(5.0), Some(5.0)], vec![None, None]], 1.0),
            frame(vec![vec![None, None], vec![None, None]], 1.0),
        ]
        .into_iter()
        .unzip();
        let found = Agreement::new(&fitted, &observations);
        // 3 and 4; 5 and 5.
        assert_eq!(found.of_frames, [Some(12.5f64.sqrt()), Some(5.0), None]);
        assert_eq!(found.of_views, [Some((59.0f64 / 3.0).sqrt()), Some(4.0)]);
        let bad: Vec<_> = found.bad_frames().collect();
        assert_eq!(bad, [(0, 12.5f64.sqrt()), (1, 5.0)]);
        let (small, seen) = frame(vec![vec![Some(2.9)], vec![Some(3.1)]], 1.0);
        let found = Agreement::new(&[small], &[seen]);
        assert_eq!(found.bad_views().collect::<Vec<_>>(), [(1, 3.1)]);
    }
}
