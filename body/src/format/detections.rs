//! People that a detector found in the pictures of a view.

use std::collections::HashMap;

use super::{FrameKey, JointProblem, JointsError, Model, keys};
use crate::JointPixel;

/// People in the pictures of a view.
#[derive(Clone, Debug, PartialEq)]
pub struct Detections {
    /// The names of the joints; none where nothing names them and no picture shows a person.
    pub joints: Vec<String>,
    /// The pictures in their order.
    pub frames: Vec<DetectedFrame>,
    /// The frame rate, where the file states it.
    pub frames_per_second: Option<f64>,
    /// How many joints had a negative confidence, and count as not found.
    pub negative_confidences: usize,
}

/// The people in a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct DetectedFrame {
    /// What tells the picture from others of the view, and which picture of another view belongs to
    /// it.
    pub key: FrameKey,
    /// The people in the order of the file.
    pub people: Vec<Person>,
}

/// The joints of a person in a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Person {
    /// For each joint where it is, `None` where it was not found.
    pub joints: Vec<Option<DetectedJoint>>,
}

/// A joint as a detector found it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DetectedJoint {
    /// The pixel `[u, v]`.
    pub position: [f64; 2],
    /// From above 0 to 1.
    pub confidence: f64,
}

/// How detections become the joints of one person.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DetectorOptions {
    /// The standard deviation of a joint of confidence 1, in pixels.
    pub deviation_px: f64,
    /// Joints of less confidence are missing.
    pub least_confidence: f64,
    /// Which person of each picture, from 0 in the order of the file; the one with the greatest sum
    /// of confidences where it is `None`.
    pub person: Option<usize>,
    /// The frame rate, where it is known. It goes before those of the files.
    pub frames_per_second: Option<f64>,
    /// What the joints are, whatever the files say; where it is `None` the file or the number of
    /// joints tells it.
    pub model: Option<Model>,
}

impl Default for DetectorOptions {
    /// 2 px, least confidence 0.05, the person with the greatest sum of confidences, and the model
    /// that the number of joints tells.
    fn default() -> Self {
        Self {
            deviation_px: 2.0,
            least_confidence: 0.05,
            person: None,
            frames_per_second: None,
            model: None,
        }
    }
}

impl Person {
    /// The sum of the confidences.
    #[must_use]
    pub fn score(&self) -> f64 {
        let joints = self.joints.iter().flatten();
        joints.map(|joint| joint.confidence).sum()
    }
}

/// u, v and confidence of each joint of a person.
pub(super) type Keypoints = Vec<[f64; 3]>;

/// A picture with people whose joints have no names yet.
pub(super) struct Picture {
    pub(super) key: FrameKey,
    /// What messages call it.
    pub(super) label: String,
    pub(super) people: Vec<Keypoints>,
}

impl Picture {
    /// A picture that messages call as its key.
    pub(super) fn new(key: FrameKey, people: Vec<Keypoints>) -> Self {
        let label = key.to_string();
        Self { key, label, people }
    }
}

/// Three numbers for each joint of a person.
pub(super) fn keypoints(
    picture: &str,
    person: usize,
    numbers: &[f64],
) -> Result<Keypoints, JointsError> {
    let (triples, rest) = numbers.as_chunks();
    if rest.is_empty() {
        return Ok(triples.to_vec());
    }
    Err(JointsError::Numbers {
        frame: picture.to_owned(),
        person,
        found: numbers.len(),
    })
}

impl Detections {
    /// People whose joints have the names of the model, of the file where no model is given, or of
    /// the model that their number tells. Pictures are put in the order of their keys.
    pub(super) fn new(
        mut pictures: Vec<Picture>,
        names: Option<Vec<String>>,
        model: Option<Model>,
    ) -> Result<Self, JointsError> {
        if pictures.is_empty() {
            return Err(JointsError::Empty("pictures"));
        }
        let order = keys::sorted(pictures.iter().map(|picture| &picture.key));
        let place: HashMap<&FrameKey, usize> = order.iter().zip(0..).collect();
        pictures.sort_by_key(|picture| place.get(&picture.key).copied());
        let joints = joint_names(&pictures, names, model)?;
        let mut negative_confidences = 0;
        let mut frames = Vec::with_capacity(pictures.len());
        for Picture { key, label, people } in pictures {
            let people = people.iter().enumerate().map(|(person, keypoints)| {
                if keypoints.len() != joints.len() {
                    return Err(JointsError::Kind {
                        frame: label.clone(),
                        person,
                        expected: joints.len(),
                        found: keypoints.len(),
                    });
                }
                let negative = keypoints.iter().filter(|[.., c]| *c < 0.0);
                negative_confidences += negative.count();
                Person::of_keypoints(&label, person, &joints, keypoints)
            });
            let people = people.collect::<Result<_, _>>()?;
            frames.push(DetectedFrame { key, people });
        }
        Ok(Self {
            joints,
            frames,
            frames_per_second: None,
            negative_confidences,
        })
    }

    /// Whether a picture shows a person.
    pub(super) fn has_people(&self) -> bool {
        self.frames.iter().any(|frame| !frame.people.is_empty())
    }

    /// The joints of one person in a picture: of that of the options, or of the one with the
    /// greatest sum of confidences; `None` where there are no people.
    pub(super) fn person(
        &self,
        frame: usize,
        options: &DetectorOptions,
    ) -> Result<Option<Vec<Option<JointPixel>>>, JointsError> {
        let Some(DetectedFrame { key, people }) = self.frames.get(frame) else {
            return Ok(None);
        };
        let person = match options.person {
            Some(person) if !people.is_empty() => {
                let found = people.get(person);
                Some(found.ok_or_else(|| JointsError::NoPerson {
                    frame: key.to_string(),
                    person,
                    found: people.len(),
                })?)
            }
            _ => {
                // Of equal ones the first.
                let people = people.iter().rev();
                people.max_by(|a, b| a.score().total_cmp(&b.score()))
            }
        };
        let pixel = |joint: &Option<DetectedJoint>| {
            let joint = joint.filter(|joint| joint.confidence >= options.least_confidence)?;
            Some(JointPixel {
                position: joint.position,
                deviation: options.deviation_px / joint.confidence.sqrt(),
            })
        };
        Ok(person.map(|person| person.joints.iter().map(pixel).collect()))
    }
}

/// The names of the joints, as many as the first person has.
fn joint_names(
    pictures: &[Picture],
    names: Option<Vec<String>>,
    model: Option<Model>,
) -> Result<Vec<String>, JointsError> {
    let mut shown = pictures.iter();
    let first = shown.find_map(|picture| Some((&picture.label, picture.people.first()?.len())));
    let named = model.map(Model::joints).or(names);
    let Some((label, found)) = first else {
        return Ok(named.unwrap_or_default());
    };
    let (frame, person) = (label.clone(), 0);
    match (named, model) {
        (Some(named), _) if named.len() == found => Ok(named),
        (Some(_), Some(model)) => Err(JointsError::OfModel {
            frame,
            person,
            model,
            found,
        }),
        (Some(named), None) => Err(JointsError::Named {
            frame,
            person,
            expected: named.len(),
            found,
        }),
        (None, _) => {
            let told = Model::of_count(found).map(Model::joints);
            told.ok_or(JointsError::UnknownCount {
                frame,
                person,
                found,
            })
        }
    }
}

impl Person {
    fn of_keypoints(
        picture: &str,
        person: usize,
        names: &[String],
        keypoints: &[[f64; 3]],
    ) -> Result<Self, JointsError> {
        let joints = keypoints.iter().enumerate().map(|(index, numbers)| {
            DetectedJoint::new(*numbers).map_err(|problem| JointsError::OfPerson {
                frame: picture.to_owned(),
                person,
                joint: names.get(index).cloned().unwrap_or_default(),
                index,
                problem,
            })
        });
        let joints = joints.collect::<Result<_, _>>()?;
        Ok(Self { joints })
    }
}

impl DetectedJoint {
    /// The joint of three numbers u, v and confidence; `None` where the confidence is not above 0,
    /// as scores that a network writes as they are can be. A confidence above 1 counts as 1.
    fn new([u, v, confidence]: [f64; 3]) -> Result<Option<Self>, JointProblem> {
        if !confidence.is_finite() {
            return Err(JointProblem::Confidence(confidence));
        }
        if confidence <= 0.0 {
            return Ok(None);
        }
        if !(u.is_finite() && v.is_finite()) {
            return Err(JointProblem::Position([u, v]));
        }
        Ok(Some(Self {
            position: [u, v],
            confidence: confidence.min(1.0),
        }))
    }
}
