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
//! Joints have the names of [`JOINTS`] or of the other [`Model`] that their number tells, or those
//! of `categories`. AlphaPose writes results with the names of pictures as `image_id`: these are
//! ordered by the last number in the names that differs, so that `2.jpg` comes before `10.jpg`.
//!
//! ```
//! use ga_body::format::coco;
//!
//! let numbers = vec!["0"; 16 * 3].join(",");
//! let text = format!(r#"[{{"image_id": 7, "keypoints": [310.5, 82, 0.9, {numbers}]}}]"#);
//! let people = coco::decode(text.as_bytes(), None)?;
//! assert_eq!(people.joints[0], "nose");
//! let nose = people.frames[0].people[0].joints[0].ok_or("no nose")?;
//! assert_eq!((nose.position, nose.confidence), ([310.5, 82.0], 0.9));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::collections::{BTreeMap, BTreeSet};

use serde::Deserialize;

use super::detections::{Picture, keypoints};
pub use super::models::orders::COCO_17 as JOINTS;
use super::{Detections, FrameKey, JointsError, Model, keys};

/// The number of a picture; some detectors write its name.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
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

/// Reads results or annotations. Pictures come in the order of their numbers or names. The joints
/// are those of the model where one is given.
///
/// # Errors
/// [`JointsError`] for text that is not such JSON, a person with a number of joints that is not
/// that of the model or the category, or that tells no model, a joint with numbers that are not
/// finite, an annotation of a picture that is not among the `images`, and where there is no
/// picture.
pub fn decode(bytes: &[u8], model: Option<Model>) -> Result<Detections, JointsError> {
    let first = bytes.iter().find(|byte| !byte.is_ascii_whitespace());
    if first == Some(&b'[') {
        let results: Vec<Annotation> = serde_json::from_slice(bytes)?;
        let pictures = pictures(results, None, |confidence| confidence)?;
        return Detections::new(pictures, None, model);
    }
    let file: Annotations = serde_json::from_slice(bytes)?;
    let of_people = file.annotations.iter();
    let category = of_people
        .filter(|a| !a.keypoints.is_empty())
        .find_map(|a| a.category_id);
    let names = names(file.categories, category);
    let images = file
        .images
        .map(|images| images.into_iter().map(|image| image.id));
    let images = images.map(Iterator::collect);
    let pictures = pictures(file.annotations, images, |visibility| 0.5 * visibility)?;
    Detections::new(pictures, names, model)
}

/// The joints of a category of things with joints.
fn names(categories: Vec<Category>, wanted: Option<i64>) -> Option<Vec<String>> {
    let mut with_joints = categories.into_iter().filter(|c| !c.keypoints.is_empty());
    let category = with_joints.find(|c| wanted.is_none() || c.id == wanted)?;
    Some(category.keypoints)
}

fn pictures(
    annotations: Vec<Annotation>,
    images: Option<BTreeSet<ImageId>>,
    confidence: impl Fn(f64) -> f64,
) -> Result<Vec<Picture>, JointsError> {
    let of_annotations = annotations.iter().map(|a| a.image_id.clone());
    let ids = images.clone().unwrap_or_default().into_iter();
    let mut pictures = empty_pictures(ids.chain(of_annotations).collect());
    for (index, annotation) in annotations.into_iter().enumerate() {
        let id = annotation.image_id;
        let picture = pictures.get_mut(&id);
        let picture = picture.filter(|_| images.as_ref().is_none_or(|images| images.contains(&id)));
        let Some(picture) = picture else {
            return Err(JointsError::NoImage {
                annotation: index,
                image: id.plain_key().to_string(),
            });
        };
        let mut numbers = annotation.keypoints;
        // Things without joints are not people.
        if numbers.is_empty() {
            continue;
        }
        for third in numbers.iter_mut().skip(2).step_by(3) {
            *third = confidence(*third);
        }
        let person = keypoints(&picture.label, picture.people.len(), &numbers)?;
        picture.people.push(person);
    }
    Ok(pictures.into_values().collect())
}

/// A picture without people for each number or name.
fn empty_pictures(ids: BTreeSet<ImageId>) -> BTreeMap<ImageId, Picture> {
    let names = ids.iter().map(|id| match id {
        ImageId::Number(_) => None,
        ImageId::Name(name) => Some(name.as_str()),
    });
    let found = names
        .collect::<Option<Vec<&str>>>()
        .map(|names| keys::keys(&names));
    // Numbers and names beside each other.
    let found = found.unwrap_or_else(|| ids.iter().map(ImageId::plain_key).collect());
    let picture = |(id, key): (ImageId, FrameKey)| {
        let label = id.plain_key().to_string();
        let people = Vec::new();
        (id, Picture { key, label, people })
    };
    ids.into_iter().zip(found).map(picture).collect()
}

impl ImageId {
    /// The number or name as it is.
    fn plain_key(&self) -> FrameKey {
        match self {
            Self::Number(number) => FrameKey::Number(*number),
            Self::Name(name) => FrameKey::Name(name.clone()),
        }
    }
}
