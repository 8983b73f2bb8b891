//! What a reader of detections found out that may not be what was meant.

/// What was done with detections that a user should know.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum JointsNote {
    /// Pictures of a view are not in its files, and became frames without joints.
    #[error(
        "view {view:?}: {missing} of {frames} frames are not in the file, as pictures without \
         people often are not, and show no joint"
    )]
    FramesWithoutPeople {
        /// The name of the view.
        view: String,
        /// How many frames were added.
        missing: usize,
        /// How many frames there are now.
        frames: usize,
    },
    /// The numbers of the pictures have a distance of their own, and became consecutive frames.
    #[error("pictures are numbered in steps of {step}, and become consecutive frames")]
    Step {
        /// The greatest common divisor of the differences between the numbers.
        step: u64,
    },
    /// The numbers of the pictures are so far apart that they are not counted as frames: more than
    /// nine of ten would be empty.
    #[error(
        "view {view:?}: the numbers of {pictures} pictures are spread over {span}, and are not \
         those of frames: the pictures become consecutive frames"
    )]
    NotFrameNumbers {
        /// The name of the first such view.
        view: String,
        /// How many pictures there are.
        pictures: usize,
        /// How many frames there would be.
        span: u64,
    },
    /// Joints with a negative confidence are missing.
    #[error("view {view:?}: {joints} joints have a negative confidence, and count as not found")]
    NegativeConfidences {
        /// The name of the view.
        view: String,
        /// How many joints of all people in all pictures.
        joints: usize,
    },
}
