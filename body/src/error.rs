//! Why no pose can be fitted.

use ga_anim::kinematics::KinematicsError;
use ga_camera::CameraError;

/// Why no pose can be fitted to what views show.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BodyError {
    /// There is no camera.
    #[error("a pose cannot be fitted without a view")]
    NoViews,
    /// There are other numbers of cameras and of views.
    #[error("{found} views are observed by {expected} cameras")]
    Views {
        /// How many cameras there are.
        expected: usize,
        /// How many views are observed.
        found: usize,
    },
    /// A view has another number of points than the model.
    #[error("view {view} has {found} points, but the model of the body has {expected}")]
    Points {
        /// Which view, from 0.
        view: usize,
        /// How many points the model has.
        expected: usize,
        /// How many the view has.
        found: usize,
    },
    /// A pixel is not finite.
    #[error("view {view}: the pixel {pixel:?} of {point:?} is not finite")]
    Pixel {
        /// Which view, from 0.
        view: usize,
        /// The name of the point.
        point: String,
        /// The pixel.
        pixel: [f64; 2],
    },
    /// The standard deviation of a pixel is not positive and finite.
    #[error("view {view}: {deviation} px is not a standard deviation of {point:?}")]
    Deviation {
        /// Which view, from 0.
        view: usize,
        /// The name of the point.
        point: String,
        /// The deviation.
        deviation: f64,
    },
    /// Too few points are seen to say where the body is and how it stands.
    #[error("{seen} points are seen, and a pose needs {needed} that are not at one place at rest")]
    TooFewPoints {
        /// How many are seen in at least one view.
        seen: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A point is behind a camera that sees it.
    #[error("view {view}: {point:?} is behind the camera: its depth is {depth} m")]
    Behind {
        /// Which view, from 0.
        view: usize,
        /// The name of the point.
        point: String,
        /// Its depth along the optical axis.
        depth: f64,
    },
    /// A camera does not see the place of a point that it observes.
    #[error("view {view}: {point:?}: {error}")]
    Camera {
        /// Which view, from 0.
        view: usize,
        /// The name of the point.
        point: String,
        /// What is wrong.
        error: Box<CameraError>,
    },
    /// No pose was found at which all cameras see the points that were observed.
    #[error("no pose was found that the cameras see")]
    NoPose,
    /// The frame rate of a clip is not positive and finite.
    #[error("{0} frames a second is not a frame rate")]
    FrameRate(f64),
    /// The skeleton cannot be fitted.
    #[error(transparent)]
    Kinematics(#[from] KinematicsError),
}

/// Why no poses can be fitted to a clip.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("frame {frame}: {error}")]
pub struct ClipError {
    /// Which frame, from 0.
    pub frame: usize,
    /// What is wrong with it.
    #[source]
    pub error: BodyError,
}

impl BodyError {
    /// The error of a camera about a point.
    pub(super) fn of_point(view: usize, point: &str, error: CameraError) -> Self {
        let point = point.to_owned();
        match error {
            CameraError::Behind { depth, .. } => Self::Behind { view, point, depth },
            error => Self::Camera {
                view,
                point,
                error: Box::new(error),
            },
        }
    }
}
