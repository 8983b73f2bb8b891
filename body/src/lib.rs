//! The pose of a body from its joints in pictures: what is seen at pixels in one view or more is
//! fitted by the motors of a skeleton with bones of known lengths.
//!
//! | | |
//! | --- | --- |
//! | [`BodyModel`] | a skeleton, the points of the body that are observed, limits of the joints |
//! | [`Observation`] | for each view the pixels of these points, as far as they were seen |
//! | [`BodyFit`] | the expected pose of a frame by itself, the most likely poses of a clip |
//! | [`FittedPose`] | motors, points and what remains in the pictures |
//! | [`character`] | a character in the poses of a person in views, and what is doubtful of them |
//! | [`registration`] | how views stand to each other in space and time |
//! | [`ground`] | which way is up, how high the floor is, and when feet stand |
//! | [`marked`] | bodies with coloured dots on their skin, in pictures |
//! | [`marker`] | painted discs that say which point they are |
//! | [`format`](mod@format) | files of joints in pictures, of all common detectors and our own |
//! | [`evaluation`], [`pose_error`] | how far reconstructed bodies and joints are from true ones |
//!
//! A pose has the rotation R of each joint and the translation t of the body. It takes a point x at
//! rest to `x' = G x ~G` with the total motion G of its joint, the product of the motors of the
//! joints above it ([`ga_anim::pose`]). For independent Gaussian errors in the pixels the most
//! likely pose is that of the least sum
//!
//! ```text
//! Σ ρ( |π_v(x'_p) − u_vp| / σ_vp )  over all views v and all points p that they see
//! ```
//!
//! with the projection π of the camera and the pixel u with its standard deviation σ. Lengths of
//! bones do not change, so the fit is nearer to the truth than points that are triangulated one by
//! one. The loss ρ ([`Loss`](ga_numerics::least_squares::Loss)) limits what a wrong pixel does.
//!
//! In a [clip](BodyFit::clip) the accelerations of body and joints are part of the sum, each in
//! units of its own standard deviation, which the clip shows. Where lengths of bones are not known,
//! [`fit_lengths`] finds them from several frames.
//!
//! ```
//! use ga_anim::skeleton::{Joint, Skeleton};
//! use ga_runtime::cga3::Point;
//! use ga_body::{BodyFit, BodyModel, JointPixel, Observation};
//! use ga_camera::{Camera, Intrinsics};
//!
//! // An arm: shoulder, elbow and wrist, with bones of 30 and 25 cm.
//! let joint = |name: &str, parent, y: f64, tail: f64| Joint {
//!     name: name.into(),
//!     parent,
//!     head: [0.0, y, 0.0],
//!     tail: [0.0, tail, 0.0],
//! };
//! let arm = Skeleton::new(vec![
//!     joint("shoulder", None, 0.0, 0.3),
//!     joint("elbow", Some(0), 0.3, 0.55),
//!     joint("wrist", Some(1), 0.55, 0.55),
//! ])?;
//! let model = BodyModel::of_distinct_joints(arm)?;
//!
//! // Two cameras see it bent at the elbow.
//! let intrinsics = Intrinsics::new([1000.0, 1000.0], [640.0, 360.0])?;
//! let up = [0.0, 1.0, 0.0];
//! let camera = |x| Camera::look_at(intrinsics, [x, 0.0, 4.0].into(), Point::default(), up);
//! let cameras = [-0.5, 0.5].map(camera).into_iter().flatten().collect::<Vec<_>>();
//! let truth = [[0.0, 0.0, 0.0], [0.3, 0.0, 0.0], [0.3, 0.2, 0.15]].map(Point::from);
//! let mut seen = Observation::unseen(cameras.len(), truth.len());
//! for (camera, view) in cameras.iter().zip(&mut seen.views) {
//!     for (point, pixel) in truth.iter().zip(view) {
//!         *pixel = Some(JointPixel { position: camera.project(*point)?, deviation: 0.1 });
//!     }
//! }
//! let fitted = BodyFit::new(&model, &cameras)?.frame(&seen)?;
//! for (found, truth) in fitted.points.iter().zip(truth) {
//!     assert!(found.distance(truth) < 1e-3);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod agreement;
mod branched;
mod chain;
pub mod character;
mod clip;
mod descent;
mod error;
pub mod evaluation;
#[cfg(test)]
mod example;
mod fit;
pub mod format;
mod frames;
mod gap;
pub mod ground;
mod landmarks;
mod lengths;
mod likelihood;
pub mod marked;
pub mod marker;
mod mean_square;
mod model;
mod normal;
mod one_view;
mod person;
pub mod pose_error;
mod posture;
pub mod registration;
mod sides;
mod skinned;
mod start;

pub use error::BodyError;
pub use fit::{BodyFit, FittedPose};
pub use lengths::{FittedLengths, Lengths, fit_lengths};
pub use model::{BodyModel, BodyPoint};

/// A point of the body as a view shows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointPixel {
    /// The pixel `[u, v]`.
    pub position: [f64; 2],
    /// The standard deviation of each coordinate in pixels, greater than 0.
    pub deviation: f64,
}

/// What all views show at one time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Observation {
    /// For each view, in the order of the cameras, and for each point, in the order of
    /// [`BodyModel::points`], where it is; `None` where the view does not show it.
    pub views: Vec<Vec<Option<JointPixel>>>,
}

impl Observation {
    /// No point seen in any view.
    #[must_use]
    pub fn unseen(views: usize, points: usize) -> Self {
        Self {
            views: vec![vec![None; points]; views],
        }
    }

    /// The same without some points, each given as the index of a view and that of the point.
    fn without(&self, points: &[(usize, usize)]) -> Self {
        let mut others = self.clone();
        for &(view, point) in points {
            others.views[view][point] = None;
        }
        others
    }
}
