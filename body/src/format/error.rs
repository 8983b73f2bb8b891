//! What is wrong with files of joints.

use ga_camera::format::CameraFileError;
use ga_files::table::TableError;

use super::Model;

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
    /// A person has numbers that are not three for each joint.
    #[error("{frame}, person {person}: {found} numbers are not three for each joint")]
    Numbers {
        /// The picture.
        frame: String,
        /// Which person of the picture, from 0.
        person: usize,
        /// How many there are.
        found: usize,
    },
    /// The number of joints tells no model, and none is given.
    #[error(
        "{frame}, person {person}: {found} joints do not say which model they are of; models are {}",
        Model::listed()
    )]
    UnknownCount {
        /// The picture.
        frame: String,
        /// Which person of the picture, from 0.
        person: usize,
        /// How many joints there are.
        found: usize,
    },
    /// A person has another number of joints than the model that is given.
    #[error(
        "{frame}, person {person}: {found} joints, and the model {model} has {}",
        model.joints().len()
    )]
    OfModel {
        /// The picture.
        frame: String,
        /// Which person of the picture, from 0.
        person: usize,
        /// The model.
        model: Model,
        /// How many joints there are.
        found: usize,
    },
    /// A person has another number of joints than the file names.
    #[error("{frame}, person {person}: {found} joints, and {expected} are named")]
    Named {
        /// The picture.
        frame: String,
        /// Which person of the picture, from 0.
        person: usize,
        /// How many joints are named.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A joint of a person is not as many numbers as it should be.
    #[error("{frame}, person {person}, joint {index}: {found} numbers are not {expected}")]
    Nesting {
        /// The picture.
        frame: String,
        /// Which person of the picture, from 0.
        person: usize,
        /// Which joint, from 0.
        index: usize,
        /// How many numbers there are.
        found: usize,
        /// What the numbers should be.
        expected: &'static str,
    },
    /// A person has another number of scores than of joints.
    #[error("{frame}, person {person}: {joints} joints and {scores} scores")]
    Scores {
        /// The picture.
        frame: String,
        /// Which person of the picture, from 0.
        person: usize,
        /// How many joints there are.
        joints: usize,
        /// How many scores there are.
        scores: usize,
    },
    /// An entry of a list of MMPose is neither a frame nor a person.
    #[error(
        "entry {index} has neither frame_id and instances nor keypoints and keypoint_scores, or \
         others have the other"
    )]
    Entry {
        /// Which entry, from 0.
        index: usize,
    },
    /// A film has a frame twice.
    #[error("there are two frames {0}")]
    SameFrame(i64),
    /// A file in a folder is not that of one picture.
    #[error("{frame}: not the people of one picture, as the files of a folder are")]
    NotOnePicture {
        /// The file.
        frame: String,
    },
    /// A table is damaged.
    #[error(transparent)]
    Table(#[from] TableError),
    /// A row at the head of a table of DeepLabCut is another one.
    #[error("line {line} begins with {found:?}, and {wanted} is needed")]
    DeepLabCut {
        /// The line, from 1; 0 where there is none.
        line: usize,
        /// With what it should begin.
        wanted: &'static str,
        /// With what it begins.
        found: String,
    },
    /// A column of a table of DeepLabCut is not one of those of a joint, or is there twice.
    #[error(
        "line {line}, column {column}: {found:?} of {joint:?} is not x, y or likelihood, or is \
         there twice"
    )]
    Coordinate {
        /// The line, from 1.
        line: usize,
        /// The column, from 1.
        column: usize,
        /// The name of the joint.
        joint: String,
        /// What the column should be.
        found: String,
    },
    /// A joint of a table of DeepLabCut has not both coordinates.
    #[error("line {line}: there are no columns x and y of {joint:?}")]
    NoCoordinate {
        /// The line, from 1.
        line: usize,
        /// The name of the joint.
        joint: String,
    },
    /// Two rows of a table of DeepLabCut are of one frame.
    #[error("line {line}: another line is of the frame {name:?} too")]
    SameRow {
        /// The line, from 1.
        line: usize,
        /// The number or name of the frame.
        name: String,
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
    /// Views state different frame rates.
    #[error(
        "the view {:?} has {} frames a second, and the view {:?} has {}",
        views[0], rates[0], views[1], rates[1]
    )]
    FrameRates {
        /// The names of the views.
        views: [String; 2],
        /// What they state.
        rates: [f64; 2],
    },
    /// People of one view have joints of several models.
    #[error("{frame}, person {person}: {found} joints, and the first person has {expected}")]
    Kind {
        /// The picture.
        frame: String,
        /// Which person of the picture, from 0.
        person: usize,
        /// How many joints the first person of all has.
        expected: usize,
        /// How many this one has.
        found: usize,
    },
    /// There is not a camera for each view, and no view has the name of a picture.
    #[error(
        "there are {views} views, whose names are not those of pictures, and {cameras} cameras"
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
    /// Its confidence is not finite.
    #[error("{0} is not a confidence")]
    Confidence(f64),
    /// It is neither `null` nor two or three numbers.
    #[error("{0} numbers are neither [u, v] nor [u, v, deviation]")]
    Numbers(usize),
}
