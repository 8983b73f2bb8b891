//! People in the format of OpenPose, JSON, a file for each frame.
//!
//! A file is `{"version": 1.3, "people": [{"pose_keypoints_2d": […]}]}` with three numbers u, v and
//! confidence for each joint, in pixels, see the page "Output" of OpenPose's documentation. Joints
//! that were not found are three zeros. Points of hands and faces in lists of their own are not
//! read.
//!
//! The joints are those of the [`Model`] that their number tells: OpenPose has the 25 of
//! [`BODY_25`] and the 18 of [`COCO_18`], and other detectors' joints are written in this form too,
//! by Pose2Sim for instance those of Halpe. BODY_25B has as many joints as [`BODY_25`] and must be
//! given.

use serde::Deserialize;

use super::detections::{Keypoints, Picture, keypoints};
pub use super::models::orders::{BODY_25, COCO_18};
use super::{Detections, FrameKey, JointsError, Model, keys};

/// A file of one frame.
#[derive(Deserialize)]
pub(super) struct File {
    people: Vec<FilePerson>,
}

#[derive(Deserialize)]
struct FilePerson {
    pose_keypoints_2d: Vec<f64>,
}

/// Reads the files of the frames of a view, each with the name that messages give it. The joints
/// are those of the model where one is given.
///
/// The number of a frame is the last number that differs in the names of the files, such as 12 in
/// `walk_000000000012_keypoints.json`. Where names have no such numbers, and where there is one
/// file alone, frames have their names, in which numbers count as numbers.
///
/// # Errors
/// [`JointsError`] for text that is not such JSON, a person with a number of joints that is not
/// that of the model or that tells none, people of several kinds, a joint with numbers that are not
/// finite, and an empty list of files.
///
/// ```
/// use ga_body::format::openpose;
///
/// let numbers = vec!["0,0,0"; 24].join(",");
/// let text = format!(r#"{{"people": [{{"pose_keypoints_2d": [310.5, 82, 0.9, {numbers}]}}]}}"#);
/// let people = openpose::decode(&[("a_3_keypoints.json", text.as_bytes())], None)?;
/// assert_eq!(people.joints[8], "MidHip");
/// assert!(people.frames[0].people[0].joints[0].is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn decode<N: AsRef<str>>(
    files: &[(N, &[u8])],
    model: Option<Model>,
) -> Result<Detections, JointsError> {
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_ref()).collect();
    let pictures = names.iter().zip(keys::keys(&names)).zip(files);
    let pictures = pictures.map(|((&name, key), (_, bytes))| {
        let label = FrameKey::Name(name.to_owned()).to_string();
        let file = File::parse(bytes).map_err(|error| JointsError::JsonOfFrame {
            frame: label.clone(),
            error,
        })?;
        let people = file.people(&label)?;
        Ok(Picture { key, label, people })
    });
    Detections::new(pictures.collect::<Result<_, JointsError>>()?, None, model)
}

impl File {
    pub(super) fn parse(bytes: &[u8]) -> Result<Self, serde_json::Error> {
        serde_json::from_slice(bytes)
    }

    /// The people of the picture that messages call so.
    pub(super) fn people(&self, picture: &str) -> Result<Vec<Keypoints>, JointsError> {
        let people = self.people.iter().enumerate();
        let people =
            people.map(|(person, numbers)| keypoints(picture, person, &numbers.pose_keypoints_2d));
        people.collect()
    }
}
