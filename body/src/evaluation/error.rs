//! Why a reconstruction cannot be evaluated on a motion.

use ga_anim::recording::RecordingError;
use ga_anim::skeleton::SkeletonError;
use ga_camera::CameraError;
use ga_camera::triangulation::TriangulationError;

use super::case::Case;
use crate::BodyError;

/// A motion on which no reconstruction can be evaluated, or a case in which it cannot. Frames are
/// those of the motion as it was recorded, counted from 0 as views are.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum EvaluationError {
    /// No frames are left of the motion.
    #[error("the motion has no frames")]
    NoFrames,
    /// Every 0th frame was to be taken.
    #[error("every 0th frame: there is no such frame")]
    Every,
    /// The recording is not a motion of a skeleton.
    #[error(transparent)]
    Recording(#[from] RecordingError),
    /// The poses are not those of the skeleton.
    #[error(transparent)]
    Skeleton(#[from] SkeletonError),
    /// There is no such camera.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// The cameras look nowhere: the body is not at finite coordinates.
    #[error("the cameras have no direction")]
    NoDirection,
    /// A case cannot be evaluated.
    #[error("{case}: {error}")]
    Case {
        /// The case.
        case: Case,
        /// What is wrong with it.
        #[source]
        error: Box<EvaluationError>,
    },
    /// A camera does not see a joint.
    #[error("frame {frame}, view {view}, joint {joint:?}: {error}")]
    Joint {
        /// Which frame.
        frame: usize,
        /// Which view.
        view: usize,
        /// The name of the joint.
        joint: String,
        /// What is wrong.
        error: Box<CameraError>,
    },
    /// A camera makes no observations.
    #[error("frame {frame}, view {view}: {error}")]
    Observation {
        /// Which frame.
        frame: usize,
        /// Which view.
        view: usize,
        /// What is wrong.
        #[source]
        error: Box<TriangulationError>,
    },
    /// No body can be found in what is seen.
    #[error(transparent)]
    Body(#[from] BodyError),
    /// The threads for the work cannot be started.
    #[error(transparent)]
    Threads(#[from] rayon::ThreadPoolBuildError),
    /// A thread panicked.
    #[error("a thread panicked")]
    Panic,
}
