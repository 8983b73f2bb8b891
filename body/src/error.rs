//! Why no pose can be fitted.

use ga_anim::MotionFileError;
use ga_anim::kinematics::KinematicsError;
use ga_anim::skeleton::SkeletonError;
use ga_camera::CameraError;
use ga_camera::triangulation::TriangulationError;
use ga_numerics::least_squares::LeastSquaresError;
use ga_runtime::geometry::FitError;

/// Why a skeleton and points are not a body, why no pose or lengths can be fitted to what views
/// show, or why poses cannot be simulated or compared. Frames, views and joints are counted from 0.
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
    /// No pose can be fitted to a frame of a clip.
    #[error("frame {frame}: {error}")]
    Frame {
        /// Which frame, from 0.
        frame: usize,
        /// What is wrong with it.
        #[source]
        error: Box<BodyError>,
    },
    /// One view does not show how large a body is.
    #[error("the size of a body needs two views, and there is {0}")]
    OneView(usize),
    /// No bone is seen with both its ends.
    #[error("no bone is seen with both ends in two views of a frame")]
    NoBone,
    /// No lengths are most likely.
    #[error("the lengths of the bones: {0}")]
    LeastSquares(#[from] LeastSquaresError),
    /// The lengths found do not form a skeleton.
    #[error(transparent)]
    Skeleton(#[from] SkeletonError),
    /// The lengths found do not fit the character.
    #[error(transparent)]
    Character(#[from] MotionFileError),
    /// There are other numbers of points and of marks.
    #[error("{found} marks for the {expected} points of the body")]
    Marks {
        /// How many points the model has.
        expected: usize,
        /// How many marks are given.
        found: usize,
    },
    /// A normal has no direction.
    #[error("the normal {normal:?} of the point {point:?} is not a direction")]
    Normal {
        /// The name of the point.
        point: String,
        /// Its normal.
        normal: [f64; 3],
    },
    /// There are other numbers of cameras and of pictures.
    #[error("dots of {found} pictures are given for {expected} cameras")]
    DotViews {
        /// How many cameras there are.
        expected: usize,
        /// How many pictures have dots.
        found: usize,
    },
    /// A picture has no dots.
    #[error("no marker was found in view {view}")]
    NoDots {
        /// Which view, from 0.
        view: usize,
    },
    /// A dot is not at finite pixels.
    #[error("view {view}: the dot at {centre:?} is not finite")]
    DotNotFinite {
        /// Which view, from 0.
        view: usize,
        /// Its centre.
        centre: [f64; 2],
    },
    /// Too few dots are seen by two views or more: no part of the body can be recognised.
    #[error(
        "no part of the body is recognised by its markers: of {joint:?}, most likely, {found} are \
         seen by two views in their places, and {needed} are needed"
    )]
    TooFewMarkers {
        /// The joint of which most are seen.
        joint: String,
        /// How many they are.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// Too few dots of the body are recognised: they may be those of another body, or of cameras
    /// that stand elsewhere.
    #[error(
        "{recognised} markers are recognised in all views, and {facing} would face the cameras: \
         they may be those of another body, or of cameras that stand elsewhere"
    )]
    Unrecognised {
        /// How many dots are recognised.
        recognised: usize,
        /// How many points of the body face the cameras in the most likely pose.
        facing: usize,
    },
    /// No point is observed.
    #[error("no point of the body is observed")]
    NoPoints,
    /// The skeleton has no joint of a name.
    #[error("the skeleton has no joint {name:?}; its joints are {}", .joints.join(", "))]
    NoJoint {
        /// The name.
        name: String,
        /// The names of the skeleton's joints.
        joints: Vec<String>,
    },
    /// Two points have the same name.
    #[error("two points of the body are called {name:?}")]
    DuplicateName {
        /// The name.
        name: String,
    },
    /// A point follows a joint that does not exist.
    #[error("the point {name:?} follows joint {joint}, and the skeleton has {count}")]
    JointMissing {
        /// The point.
        name: String,
        /// The joint.
        joint: usize,
        /// How many joints there are.
        count: usize,
    },
    /// The weights of a point are not shares that sum to 1.
    #[error("the weights {weights:?} of the point {name:?} are not shares of 1")]
    Weights {
        /// The point.
        name: String,
        /// Its weights.
        weights: Vec<f64>,
    },
    /// The coordinates of a point are not finite.
    #[error("the point {name:?} is at {at_rest:?}, which is not finite")]
    PointNotFinite {
        /// The point.
        name: String,
        /// Where it is at rest.
        at_rest: [f64; 3],
    },
    /// A name is neither that of a joint nor known.
    #[error("joint {name:?} ({index}) is not a joint of the skeleton, which has {}", .joints.join(", "))]
    UnknownJoint {
        /// The name.
        name: String,
        /// Its number, from 0.
        index: usize,
        /// The names of the skeleton's joints.
        joints: Vec<String>,
    },
    /// Too few names are those of joints.
    #[error("{found} of the joints are the skeleton's, and a pose needs {needed}")]
    TooFewJoints {
        /// How many names match.
        found: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A camera does not see a joint, or the noise is not a standard deviation.
    #[error("frame {frame}, view {view}: {error}")]
    Observation {
        /// Which frame, from 0.
        frame: usize,
        /// Which view, from 0.
        view: usize,
        /// What is wrong.
        error: Box<TriangulationError>,
    },
    /// A probability is not between 0 and 1.
    #[error("{0} is not a probability that a joint is missing")]
    Missing(f64),
    /// The poses have different numbers of joints.
    #[error("{found} joints were reconstructed, but there are {expected} true ones")]
    JointCounts {
        /// How many there should be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// There are no joints.
    #[error("poses without joints have no mean error")]
    NoJoints,
    /// A joint of either pose is infinite or not a number.
    #[error("joint {joint}, from 0, has a coordinate that is not finite")]
    JointNotFinite {
        /// Which joint, from 0.
        joint: usize,
    },
    /// There is no such joint.
    #[error("joint {root} cannot be the root of {joints} joints, which count from 0")]
    Root {
        /// The joint that should be the root.
        root: usize,
        /// How many joints there are.
        joints: usize,
    },
    /// No alignment fits best.
    #[error("the poses cannot be aligned: {0}")]
    Alignment(#[from] FitError<f64>),
}

impl BodyError {
    /// The error of a frame of a clip.
    pub(super) fn of_frame(self, frame: usize) -> Self {
        let error = Box::new(self);
        Self::Frame { frame, error }
    }

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
