//! People in the format of COCO, JSON.
//!
//! Two forms are read, see <https://cocodataset.org/#format-data>:
//!
//! - *results* of a detector, a list of `{"image_id", "keypoints", "score"}`. The third number of a
//!   joint is its confidence; what is above 1, such as COCO's 2 for visible, counts as 1.
//! - *annotations*, an object with `annotations` and, where they are there, `images` and
//!   `categories`. The third number v is 0 for a joint that is not labelled, 1 for one that is
//!   hidden, which gets the confidence ½, and 2 for one that is visible. A picture without people
//!   is in `images`.
//!
//! `keypoints` are three numbers u, v and confidence for each joint, in pixels. COCO counts pixels
//! from the corner of the top left one; many detectors count from its centre, as this crate does.
//! Numbers are taken as they are.
//!
//! Joints have the names of [`JOINTS`], or those of `categories`.
//!
//! ```
//! use ga_body::format::coco;
//!
//! let numbers = vec!["0"; 16 * 3].join(",");
//! let text = format!(r#"[{{"image_id": 7, "keypoints": [310.5, 82, 0.9, {numbers}]}}]"#);
//! let people = coco::decode(text.as_bytes())?;
//! assert_eq!(people.joints[0], "nose");
//! let nose = people.frames[0].people[0].joints[0].ok_or("no nose")?;
//! assert_eq!((nose.position, nose.confidence), ([310.5, 82.0], 0.9));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::collections::BTreeMap;

use serde::Deserialize;

use super::{DetectedFrame, Detections, FrameKey, JointsError, Person};

/// The names of COCO's joints in their order, left and right of the person.
pub const JOINTS: [&str; 17] = [
    "nose",
    "left_eye",
    "right_eye",
    "left_ear",
    "right_ear",
    "left_shoulder",
    "right_shoulder",
    "left_elbow",
    "right_elbow",
    "left_wrist",
    "right_wrist",
    "left_hip",
    "right_hip",
    "left_knee",
    "right_knee",
    "left_ankle",
    "right_ankle",
];

/// The number of a picture; some detectors write its name.
#[derive(Clone, Deserialize)]
#[serde(untagged)]
enum ImageId {
    Number(i64),
    Name(String),
}

#[derive(Deserialize)]
struct Annotation {
    image_id: ImageId,
    #[serde(default)]
    category_id: Option<i64>,
    #[serde(default)]
    keypoints: Vec<f64>,
}

#[derive(Deserialize)]
struct Annotations {
    #[serde(default)]
    images: Option<Vec<Image>>,
    annotations: Vec<Annotation>,
    #[serde(default)]
    categories: Vec<Category>,
}

#[derive(Deserialize)]
struct Image {
    id: ImageId,
}

#[derive(Deserialize)]
struct Category {
    #[serde(default)]
    id: Option<i64>,
    #[serde(default)]
    keypoints: Vec<String>,
}

impl From<ImageId> for FrameKey {
    fn from(id: ImageId) -> Self {
        match id {
            ImageId::Number(number) => Self::Number(number),
            ImageId::Name(name) => Self::Name(name),
        }
    }
}

/// Reads results or annotations. Pictures come in the order of their numbers or names.
///
/// # Errors
/// [`JointsError`] for text that is not such JSON, a person with another number of joints, a joint
/// with numbers that are not finite or a negative confidence, an annotation of a picture that is
/// not among the `images`, and where there is no picture.
pub fn decode(bytes: &[u8]) -> Result<Detections, JointsError> {
    let first = bytes.iter().find(|byte| !byte.is_ascii_whitespace());
    if first == Some(&b'[') {
        let results: Vec<Annotation> = serde_json::from_slice(bytes)?;
        return detections(results, None, names(&[], None), |confidence| confidence);
    }
    let file: Annotations = serde_json::from_slice(bytes)?;
    let of_people = file.annotations.iter();
    let category = of_people
        .filter(|a| !a.keypoints.is_empty())
        .find_map(|a| a.category_id);
    let names = names(&file.categories, category);
    let images = file.images.map(|images| {
        let ids = images.into_iter().map(|image| FrameKey::from(image.id));
        ids.collect()
    });
    detections(file.annotations, images, names, |visibility| {
        0.5 * visibility
    })
}

/// The joints of a category of things with joints, or those of COCO.
fn names(categories: &[Category], wanted: Option<i64>) -> Vec<String> {
    let mut with_joints = categories.iter().filter(|c| !c.keypoints.is_empty());
    let category = with_joints.find(|c| wanted.is_none() || c.id == wanted);
    match category {
        Some(category) => category.keypoints.clone(),
        None => JOINTS.map(str::to_owned).to_vec(),
    }
}

fn detections(
    annotations: Vec<Annotation>,
    images: Option<Vec<FrameKey>>,
    joints: Vec<String>,
    confidence: impl Fn(f64) -> f64,
) -> Result<Detections, JointsError> {
    let are_listed = images.is_some();
    let mut frames: BTreeMap<FrameKey, Vec<Person>> = BTreeMap::new();
    for key in images.into_iter().flatten() {
        frames.entry(key).or_default();
    }
    for (index, annotation) in annotations.into_iter().enumerate() {
        let key = FrameKey::from(annotation.image_id);
        if are_listed && !frames.contains_key(&key) {
            return Err(JointsError::NoImage {
                annotation: index,
                image: key.to_string(),
            });
        }
        let people = frames.entry(key.clone()).or_default();
        // Things without joints are not people.
        if annotation.keypoints.is_empty() {
            continue;
        }
        let mut numbers = annotation.keypoints;
        for third in numbers.iter_mut().skip(2).step_by(3) {
            *third = confidence(*third);
        }
        let person = Person::from_numbers(&key, people.len(), &joints, &numbers)?;
        people.push(person);
    }
    if frames.is_empty() {
        return Err(JointsError::Empty("pictures"));
    }
    let frames = frames.into_iter();
    Ok(Detections {
        joints,
        frames: frames
            .map(|(key, people)| DetectedFrame { key, people })
            .collect(),
    })
}
