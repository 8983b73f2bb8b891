//! People in AlphaPose's formats `cmu` and `open`, JSON, a file for each view.
//!
//! A file is an object with a member for each picture, by its name:
//! `{"0.jpg": {"version": …, "bodies": [{"joints": […]}]}}` with `--format cmu`, and
//! `{"0.jpg": {"version": …, "people": [{"pose_keypoints_2d": […]}]}}` with `--format open`. There
//! are three numbers u, v and confidence for each joint, in pixels, of OpenPose's model
//! [`COCO_18`](super::openpose::COCO_18). AlphaPose's own format is a [list of COCO](super::coco).
//!
//! Pictures without people are not in the file. Their names are ordered by the last number in them
//! that differs.
//!
//! ```
//! use ga_body::format::{FrameKey, alphapose};
//!
//! let numbers = vec!["5,7,0.5"; 18].join(",");
//! let body = format!(r#"{{"version": "", "bodies": [{{"joints": [{numbers}]}}]}}"#);
//! let text = format!(r#"{{"10.jpg": {body}, "9.jpg": {body}}}"#);
//! let people = alphapose::decode(text.as_bytes(), None)?;
//! assert_eq!(people.joints[1], "Neck");
//! assert_eq!(people.frames[0].key, FrameKey::Number(9));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::collections::BTreeMap;

use serde::Deserialize;

use super::detections::{Picture, keypoints};
use super::{Detections, FrameKey, JointsError, Model, keys};

#[derive(Deserialize)]
struct FilePicture {
    #[serde(alias = "people")]
    bodies: Vec<Body>,
}

#[derive(Deserialize)]
struct Body {
    #[serde(alias = "pose_keypoints_2d")]
    joints: Vec<f64>,
}

/// Reads the people of a view. The joints are those of the model where one is given.
///
/// # Errors
/// [`JointsError`] for text that is not such JSON, a person with a number of joints that is not
/// that of the model or that tells none, people of several kinds, a joint with numbers that are not
/// finite, and where there is no picture.
pub fn decode(bytes: &[u8], model: Option<Model>) -> Result<Detections, JointsError> {
    let file: BTreeMap<String, FilePicture> = serde_json::from_slice(bytes)?;
    let names: Vec<&str> = file.keys().map(String::as_str).collect();
    let pictures = keys::keys(&names).into_iter().zip(&file);
    let pictures = pictures.map(|(key, (name, picture))| {
        let label = FrameKey::Name(name.clone()).to_string();
        let people = picture.bodies.iter().enumerate();
        let people = people.map(|(person, body)| keypoints(&label, person, &body.joints));
        let people = people.collect::<Result<_, _>>()?;
        Ok(Picture { key, label, people })
    });
    Detections::new(pictures.collect::<Result<_, JointsError>>()?, None, model)
}
