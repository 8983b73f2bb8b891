//! People that a detector found in the pictures of a view.

use std::collections::{BTreeSet, HashMap};

use super::{JointProblem, JointView, JointViews, JointsError};
use crate::JointPixel;

/// People in the pictures of a view.
#[derive(Clone, Debug, PartialEq)]
pub struct Detections {
    /// The names of the joints.
    pub joints: Vec<String>,
    /// The pictures in their order.
    pub frames: Vec<DetectedFrame>,
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

/// The number or the name of a picture.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum FrameKey {
    /// A number.
    Number(i64),
    /// A name.
    Name(String),
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
    /// The frame rate, where it is known.
    pub frames_per_second: Option<f64>,
}

impl Default for DetectorOptions {
    /// 2 px, least confidence 0.05, the person with the greatest sum of confidences.
    fn default() -> Self {
        Self {
            deviation_px: 2.0,
            least_confidence: 0.05,
            person: None,
            frames_per_second: None,
        }
    }
}

impl std::fmt::Display for FrameKey {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Number(number) => write!(f, "picture {number}"),
            Self::Name(name) => write!(f, "picture {name:?}"),
        }
    }
}

impl DetectedJoint {
    /// The joint of three numbers u, v and confidence; `None` where the confidence is 0. A
    /// confidence above 1 counts as 1.
    pub(super) fn new([u, v, confidence]: [f64; 3]) -> Result<Option<Self>, JointProblem> {
        if !(confidence >= 0.0 && confidence.is_finite()) {
            return Err(JointProblem::Confidence(confidence));
        }
        if confidence == 0.0 {
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

impl Person {
    /// The sum of the confidences.
    #[must_use]
    pub fn score(&self) -> f64 {
        let joints = self.joints.iter().flatten();
        joints.map(|joint| joint.confidence).sum()
    }

    /// A person of three numbers for each joint.
    pub(super) fn from_numbers(
        frame: &FrameKey,
        person: usize,
        names: &[String],
        numbers: &[f64],
    ) -> Result<Self, JointsError> {
        if numbers.len() != 3 * names.len() {
            return Err(JointsError::Numbers {
                frame: frame.to_string(),
                person,
                expected: (3 * names.len()).to_string(),
                found: numbers.len(),
            });
        }
        let joints = numbers.chunks_exact(3).enumerate().map(|(index, numbers)| {
            let joint = DetectedJoint::new([numbers[0], numbers[1], numbers[2]]);
            joint.map_err(|problem| JointsError::OfPerson {
                frame: frame.to_string(),
                person,
                joint: names[index].clone(),
                index,
                problem,
            })
        });
        Ok(Self {
            joints: joints.collect::<Result<_, _>>()?,
        })
    }
}

impl Detections {
    /// The joints of one person in each picture: of that of the options, or of the one with the
    /// greatest sum of confidences. A picture without people shows no joint.
    fn frame(
        &self,
        frame: &DetectedFrame,
        options: &DetectorOptions,
    ) -> Result<Vec<Option<JointPixel>>, JointsError> {
        let person = match options.person {
            Some(person) if !frame.people.is_empty() => {
                let found = frame.people.get(person);
                Some(found.ok_or_else(|| JointsError::NoPerson {
                    frame: frame.key.to_string(),
                    person,
                    found: frame.people.len(),
                })?)
            }
            _ => {
                let people = frame.people.iter();
                // Of equal ones the first.
                people.rev().max_by(|a, b| a.score().total_cmp(&b.score()))
            }
        };
        let Some(person) = person else {
            return Ok(vec![None; self.joints.len()]);
        };
        let pixel = |joint: &Option<DetectedJoint>| {
            let joint = joint.filter(|joint| joint.confidence >= options.least_confidence)?;
            Some(JointPixel {
                position: joint.position,
                deviation: options.deviation_px / joint.confidence.sqrt(),
            })
        };
        Ok(person.joints.iter().map(pixel).collect())
    }
}

impl JointViews {
    /// The joints of one person in views with detections of the same joints, by the names of the
    /// views.
    ///
    /// Pictures of several views belong together where their keys are equal; a picture that a view
    /// does not have shows no joint. Where no picture of the first view has its key in another
    /// view, as where pictures are numbered on from one view to the next, they belong together by
    /// their order.
    ///
    /// # Errors
    /// [`JointsError`] for views of different joints, a person that a picture does not have, views
    /// without common keys and of different numbers of pictures, and as [`new`](Self::new).
    pub fn from_detections(
        views: &[(String, Detections)],
        options: &DetectorOptions,
    ) -> Result<Self, JointsError> {
        let deviation = options.deviation_px;
        if !(deviation > 0.0 && deviation.is_finite()) {
            return Err(JointsError::Deviation(deviation));
        }
        let Some((_, first)) = views.first() else {
            return Err(JointsError::Empty("views"));
        };
        let keys = |detections: &Detections| {
            // Of pictures with equal keys the first.
            let frames = detections.frames.iter().enumerate().rev();
            let keys = frames.map(|(index, frame)| (frame.key.clone(), index));
            keys.collect::<HashMap<FrameKey, usize>>()
        };
        let own: Vec<HashMap<FrameKey, usize>> = views.iter().map(|(_, view)| keys(view)).collect();
        let mut all: BTreeSet<&FrameKey> = own[0].keys().collect();
        let mut by_key = true;
        for ((name, view), own) in views.iter().zip(&own).skip(1) {
            if view.joints != first.joints {
                return Err(JointsError::Kinds { view: name.clone() });
            }
            by_key &= own.keys().any(|key| all.contains(key));
            all.extend(own.keys());
        }
        let view = |((name, detections), own): (&(String, Detections), &HashMap<_, usize>)| {
            let frame = |frame: &DetectedFrame| detections.frame(frame, options);
            let frames = if by_key {
                let by_key = all.iter().map(|key| match own.get(*key) {
                    Some(&index) => frame(&detections.frames[index]),
                    None => Ok(vec![None; first.joints.len()]),
                });
                by_key.collect::<Result<Vec<_>, _>>()?
            } else {
                let in_order = detections.frames.iter().map(frame);
                in_order.collect::<Result<Vec<_>, _>>()?
            };
            let name = name.clone();
            Ok(JointView { name, frames })
        };
        let views = views.iter().zip(&own).map(view);
        let views = views.collect::<Result<_, JointsError>>()?;
        Self::new(first.joints.clone(), options.frames_per_second, views)
    }
}
