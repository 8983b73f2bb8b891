//! What is wrong with files of joints.

use ga_camera::format::CameraFileError;

/// What is wrong with a file of joints.
#[derive(Debug, thiserror::Error)]
pub enum JointsError {
    /// It is not JSON of the expected form.
    #[error("not JSON of joints: {0}")]
    Json(#[from] serde_json::Error),
    /// One of several files is not JSON of the expected form.
    #[error("{frame}: not JSON of joints: {error}")]
    JsonOfFrame {
        /// The file.
        frame: String,
        /// What is wrong with it.
        error: serde_json::Error,
    },
    /// It says that it is of another format or version.
    #[error("the version of the file is {found}, and {expected} is read")]
    Version {
        /// The version that is read.
        expected: u32,
        /// The version of the file.
        found: u32,
    },
    /// It names no joint, or has no view or no frame.
    #[error("there are no {0}")]
    Empty(&'static str),
    /// Two joints or views have one name.
    #[error("two {what} are called {name:?}")]
    Duplicate {
        /// Joints or views.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// The frame rate is not positive and finite.
    #[error("{0} frames a second is not a frame rate")]
    FrameRate(f64),
    /// Views have different numbers of frames.
    #[error("view {view:?} has {found} frames, and the first view has {expected}")]
    Frames {
        /// The name of the view.
        view: String,
        /// How many frames the first view has.
        expected: usize,
        /// How many this one has.
        found: usize,
    },
    /// A frame has another number of joints than there are names.
    #[error("view {view:?}, frame {frame}: {found} joints, and {expected} are named")]
    Joints {
        /// The name of the view.
        view: String,
        /// Which frame, from 0.
        frame: usize,
        /// How many joints are named.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A joint of a view is wrong.
    #[error("view {view:?}, frame {frame}, joint {joint:?} ({index}): {problem}")]
    Joint {
        /// The name of the view.
        view: String,
        /// Which frame, from 0.
        frame: usize,
        /// The name of the joint.
        joint: String,
        /// Its number, from 0.
        index: usize,
        /// What is wrong with it.
        problem: JointProblem,
    },
    /// A person has numbers that are not a whole number of joints, or not as many as there are.
    #[error("{frame}, person {person}: {found} numbers, and {expected} are needed")]
    Numbers {
        /// The picture.
        frame: String,
        /// Which person of the picture, from 0.
        person: usize,
        /// How many numbers there should be.
        expected: String,
        /// How many there are.
        found: usize,
    },
    /// A joint of a person is wrong.
    #[error("{frame}, person {person}, joint {joint:?} ({index}): {problem}")]
    OfPerson {
        /// The picture.
        frame: String,
        /// Which person of the picture, from 0.
        person: usize,
        /// The name of the joint.
        joint: String,
        /// Its number, from 0.
        index: usize,
        /// What is wrong with it.
        problem: JointProblem,
    },
    /// There is no such person.
    #[error("{frame}: there is no person {person}, but {found} of them, from 0")]
    NoPerson {
        /// The picture.
        frame: String,
        /// The person that is asked for.
        person: usize,
        /// How many there are.
        found: usize,
    },
    /// An annotation is of a picture that the file does not list.
    #[error("annotation {annotation} is of picture {image}, which is not listed")]
    NoImage {
        /// Which annotation, from 0.
        annotation: usize,
        /// The number of the picture.
        image: String,
    },
    /// Views name other joints.
    #[error("view {view:?} has joints of another kind than the first view")]
    Kinds {
        /// The name of the view.
        view: String,
    },
    /// The files of an OpenPose folder are of several kinds of bodies.
    #[error("{frame}, person {person}: {found} numbers, and the first person has {expected}")]
    Kind {
        /// The file.
        frame: String,
        /// Which person of the file, from 0.
        person: usize,
        /// How many numbers the first person of all has.
        expected: usize,
        /// How many this one has.
        found: usize,
    },
    /// There is not a camera for each view, and no view has the name of a picture.
    #[error(
        "the joints are in {views} views, whose names are not those of pictures, and there are \
         {cameras} cameras"
    )]
    CameraCount {
        /// How many views there are.
        views: usize,
        /// How many cameras there are.
        cameras: usize,
    },
    /// A view has not the name of a picture, and others have.
    #[error("no picture has the name of the view {view:?}")]
    NoPicture {
        /// The name of the view.
        view: String,
    },
    /// Two views belong to one picture.
    #[error("the views {:?} and {:?} are of one picture", views[0], views[1])]
    SamePicture {
        /// The names of the views.
        views: [String; 2],
    },
    /// A camera cannot be used.
    #[error(transparent)]
    Camera(#[from] CameraFileError),
    /// The deviation of a joint of confidence 1 is not positive and finite.
    #[error("{0} px is not the standard deviation of a joint")]
    Deviation(f64),
}

/// What is wrong with a joint.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum JointProblem {
    /// Its position is not finite.
    #[error("the pixel {0:?} is not finite")]
    Position([f64; 2]),
    /// Its standard deviation is not positive and finite.
    #[error("{0} px is not a standard deviation")]
    Deviation(f64),
    /// Its confidence is negative or not finite.
    #[error("{0} is not a confidence")]
    Confidence(f64),
    /// It is neither `null` nor two or three numbers.
    #[error("{0} numbers are neither [u, v] nor [u, v, deviation]")]
    Numbers(usize),
}
