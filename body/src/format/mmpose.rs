//! People in MMPose's format, JSON.
//!
//! A person is `{"keypoints": [[u, v], …], "keypoint_scores": [c, …]}`, in pixels. Three forms are
//! read:
//!
//! - of a film, as the demonstration programs write it with `--save-predictions`:
//!   `{"meta_info": …, "instance_info": [{"frame_id": 1, "instances": […]}, …]}`,
//! - of a film, as `MMPoseInferencer` writes it: the list of its `instance_info` alone,
//! - of one picture: the list of its people, alone or as `instance_info`. A folder of such files is
//!   a film.
//!
//! Joints have the names of `keypoint_id2name` in `meta_info`, or those of the [`Model`] that their
//! number tells. The hands of Halpe, whose wrists MMPose names twice, have those of the model, and
//! so has the top of its head, which MMPose calls `head`.
//!
//! The scores of RTMPose and other models of the kind SimCC are not probabilities: those above 1
//! count as 1, and joints with a negative one as not found.
//!
//! ```
//! use ga_body::format::mmpose;
//!
//! let person = format!(
//!     r#"{{"keypoints": [{}], "keypoint_scores": [{}]}}"#,
//!     vec!["[310.5, 82]"; 17].join(","),
//!     vec!["1.1"; 17].join(",")
//! );
//! let text = format!(r#"{{"instance_info": [{{"frame_id": 1, "instances": [{person}]}}]}}"#);
//! let people = mmpose::decode(text.as_bytes(), None)?;
//! let nose = people.frames[0].people[0].joints[0].ok_or("no nose")?;
//! assert_eq!((nose.position, nose.confidence), ([310.5, 82.0], 1.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::collections::BTreeMap;

use serde::Deserialize;

use super::detections::{Keypoints, Picture};
use super::{Detections, FrameKey, JointsError, Model};

/// A file of a film or a picture.
#[derive(Default, Deserialize)]
pub(super) struct File {
    #[serde(default)]
    meta_info: MetaInfo,
    instance_info: Vec<Entry>,
}

#[derive(Default, Deserialize)]
struct MetaInfo {
    #[serde(default)]
    keypoint_id2name: BTreeMap<usize, String>,
}

/// A frame with its people, or a person.
#[derive(Deserialize)]
struct Entry {
    frame_id: Option<i64>,
    instances: Option<Vec<Instance>>,
    keypoints: Option<Vec<Vec<f64>>>,
    keypoint_scores: Option<Vec<f64>>,
}

#[derive(Deserialize)]
struct Instance {
    keypoints: Vec<Vec<f64>>,
    keypoint_scores: Vec<f64>,
}

/// Reads the people of a film or of one picture. The joints are those of the model where one is
/// given.
///
/// # Errors
/// [`JointsError`] for text that is not such JSON, a person with a number of joints that is not
/// that of the model or of the names, or that tells no model, another number of scores than of
/// joints, people of several kinds, a joint with numbers that are not finite or not two, a frame
/// that is there twice, and where there is none.
pub fn decode(bytes: &[u8], model: Option<Model>) -> Result<Detections, JointsError> {
    let file = File::parse(bytes)?;
    let names = file.names();
    let is_film = file
        .instance_info
        .iter()
        .any(|entry| entry.instances.is_some());
    if !is_film && !file.instance_info.is_empty() {
        let key = FrameKey::Number(0);
        let people = file.people(&key.to_string())?;
        return Detections::new(vec![Picture::new(key, people)], names, model);
    }
    let mut pictures = BTreeMap::new();
    for (index, entry) in file.instance_info.iter().enumerate() {
        let (Some(frame), Some(instances)) = (entry.frame_id, &entry.instances) else {
            return Err(JointsError::Entry { index });
        };
        let key = FrameKey::Number(frame);
        let instances = instances
            .iter()
            .map(|one| (&one.keypoints, &one.keypoint_scores));
        let people = people(&key.to_string(), instances)?;
        if pictures.insert(frame, Picture::new(key, people)).is_some() {
            return Err(JointsError::SameFrame(frame));
        }
    }
    Detections::new(pictures.into_values().collect(), names, model)
}

impl File {
    pub(super) fn parse(bytes: &[u8]) -> Result<Self, serde_json::Error> {
        let first = bytes.iter().find(|byte| !byte.is_ascii_whitespace());
        if first == Some(&b'[') {
            return Ok(Self {
                instance_info: serde_json::from_slice(bytes)?,
                ..Self::default()
            });
        }
        serde_json::from_slice(bytes)
    }

    /// The names of the joints, where the file has them: those of the model with these joints,
    /// whose points of faces and hands, and the top of the head, may have other names.
    pub(super) fn names(&self) -> Option<Vec<String>> {
        let names = &self.meta_info.keypoint_id2name;
        if names.is_empty() || !names.keys().copied().eq(0..names.len()) {
            return None;
        }
        let names: Vec<String> = names.values().cloned().collect();
        let is_same = |joints: &Vec<String>| {
            let mut pairs = joints.iter().zip(&names);
            pairs.all(|(joint, name)| {
                joint == name
                    || Model::is_face_or_hand(joint)
                    || (joint == "head_top" && name == "head")
            })
        };
        let of_model = Model::of_count(names.len()).map(Model::joints);
        Some(of_model.filter(is_same).unwrap_or(names))
    }

    /// The people of a file of one picture, which messages call so.
    pub(super) fn people(&self, picture: &str) -> Result<Vec<Keypoints>, JointsError> {
        let mut persons = Vec::with_capacity(self.instance_info.len());
        for (index, entry) in self.instance_info.iter().enumerate() {
            if entry.instances.is_some() {
                let frame = picture.to_owned();
                return Err(JointsError::NotOnePicture { frame });
            }
            let person = entry.keypoints.as_ref().zip(entry.keypoint_scores.as_ref());
            persons.push(person.ok_or(JointsError::Entry { index })?);
        }
        people(picture, persons)
    }
}

/// People of the places and scores of their joints.
fn people<'a>(
    picture: &str,
    instances: impl IntoIterator<Item = (&'a Vec<Vec<f64>>, &'a Vec<f64>)>,
) -> Result<Vec<Keypoints>, JointsError> {
    let people = instances
        .into_iter()
        .enumerate()
        .map(|(person, (places, scores))| {
            if places.len() != scores.len() {
                return Err(JointsError::Scores {
                    frame: picture.to_owned(),
                    person,
                    joints: places.len(),
                    scores: scores.len(),
                });
            }
            let joints = places.iter().zip(scores).enumerate();
            let joints = joints.map(|(index, (place, &score))| match place[..] {
                [u, v] => Ok([u, v, score]),
                _ => Err(JointsError::Nesting {
                    frame: picture.to_owned(),
                    person,
                    index,
                    found: place.len(),
                    expected: "u and v",
                }),
            });
            joints.collect()
        });
    people.collect()
}
