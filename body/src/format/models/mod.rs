//! The joints of detectors' models in their orders.
//!
//! A file of numbers does not say which joint is which: that is the order of the detector's model.
//! A number of joints that one model in wide use has tells the model ([`Model::of_count`]); any
//! other must be [given](super::DetectorOptions::model).
//!
//! | name | joints | source of the order | known by its number |
//! | --- | --- | --- | --- |
//! | `coco17` | 17 | COCO's `person_keypoints` | yes |
//! | `coco18` | 18 | OpenPose, `poseParameters.cpp` | yes |
//! | `body25` | 25 | OpenPose, `poseParameters.cpp` | yes |
//! | `halpe26` | 26 | Halpe-FullBody; `halpe26.py` of MMPose | yes |
//! | `mediapipe` | 33 | MediaPipe Pose (BlazePose), "Pose landmark detection guide" | yes |
//! | `coco133` | 133 | COCO-WholeBody; `coco_wholebody.py` of MMPose | yes |
//! | `body135` | 135 | OpenPose, `poseParameters.cpp` | yes |
//! | `halpe136` | 136 | Halpe-FullBody; `halpe.py` of MMPose | yes |
//! | `body25b` | 25 | OpenPose, `poseParameters.cpp` | no: as many as `body25` |
//! | `mpii16` | 16 | MPII Human Pose; `mpii.py` of MMPose | no: others have as many |
//! | `lsp14` | 14 | Leeds Sports Pose | no: others have as many |
//!
//! Names are the projects' own in the form of COCO's, and as OpenPose has them for its models
//! `coco18` and `body25`. `head_top` is the top of the head, which Halpe calls `head`; `hip` and
//! `pelvis` are the middle of the hips, `neck` is between the shoulders, `upper_neck` where the
//! head begins, and `thorax` the middle of the shoulders.
//!
//! ```
//! use ga_body::format::Model;
//!
//! let model = Model::of_count(26).ok_or("no model")?;
//! assert_eq!(model.to_string(), "halpe26");
//! assert_eq!(model.joints()[19], "hip");
//! assert_eq!("mediapipe".parse(), Ok(Model::MediaPipe));
//! # Ok::<(), &str>(())
//! ```

pub(super) mod orders;

use std::fmt;
use std::str::FromStr;

use orders::{
    BODY_25, COCO_17, COCO_18, FACE, FEET, HALPE_FEET, HALPE_MIDDLE, LSP, MEDIAPIPE, MPII, face,
    hand,
};

/// The model of a detector, which says which joints it finds and in which order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Model {
    /// COCO, 17 joints.
    Coco17,
    /// COCO with the neck in OpenPose's order, 18 joints.
    Coco18,
    /// OpenPose's BODY_25: with the middle of the hips and the feet.
    Body25,
    /// Halpe's 26 joints: COCO with head, neck, middle of the hips and feet.
    Halpe26,
    /// MediaPipe Pose (BlazePose), 33 joints.
    MediaPipe,
    /// COCO-WholeBody, 133 points: COCO with feet, face and hands.
    Coco133,
    /// OpenPose's BODY_135: BODY_25B with hands and face.
    Body135,
    /// Halpe's 136 points: its 26 joints with face and hands.
    Halpe136,
    /// OpenPose's BODY_25B: COCO with neck, head and feet.
    Body25b,
    /// MPII Human Pose, 16 joints.
    Mpii16,
    /// Leeds Sports Pose, 14 joints.
    Lsp14,
}

/// A model that is not known.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{name:?} is not the name of a model of joints, as are {}",
    names_of_models()
)]
pub struct UnknownModel {
    /// What should have been a name.
    pub name: String,
}

impl Model {
    /// All models: first those that their numbers of joints tell.
    pub const ALL: [Self; 11] = [
        Self::Coco17,
        Self::Coco18,
        Self::Body25,
        Self::Halpe26,
        Self::MediaPipe,
        Self::Coco133,
        Self::Body135,
        Self::Halpe136,
        Self::Body25b,
        Self::Mpii16,
        Self::Lsp14,
    ];

    /// The model that a number of joints tells; `None` for a number that no model has, or several
    /// that are in wide use.
    #[must_use]
    pub fn of_count(count: usize) -> Option<Self> {
        let mut told = Self::ALL.into_iter().filter(|model| model.is_told());
        told.find(|model| model.joints().len() == count)
    }

    /// The name, such as `halpe26`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Coco17 => "coco17",
            Self::Coco18 => "coco18",
            Self::Body25 => "body25",
            Self::Halpe26 => "halpe26",
            Self::MediaPipe => "mediapipe",
            Self::Coco133 => "coco133",
            Self::Body135 => "body135",
            Self::Halpe136 => "halpe136",
            Self::Body25b => "body25b",
            Self::Mpii16 => "mpii16",
            Self::Lsp14 => "lsp14",
        }
    }

    /// The names of the joints in their order, left and right of the person.
    #[must_use]
    pub fn joints(self) -> Vec<String> {
        let own = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect();
        match self {
            Self::Coco17 => own(&COCO_17),
            Self::Coco18 => own(&COCO_18),
            Self::Body25 => own(&BODY_25),
            Self::Halpe26 => own(&[&COCO_17[..], &HALPE_MIDDLE, &HALPE_FEET].concat()),
            Self::MediaPipe => own(&MEDIAPIPE),
            Self::Coco133 => {
                let body: Vec<String> = own(&[&COCO_17[..], &FEET].concat());
                let hands = SIDES.map(|side| hand(side, true)).concat();
                [body, face(68), hands].concat()
            }
            Self::Body135 => {
                let hands = SIDES.map(|side| hand(side, false)).concat();
                [Self::Body25b.joints(), hands, face(70)].concat()
            }
            Self::Halpe136 => {
                let hands = SIDES.map(|side| hand(side, true)).concat();
                [Self::Halpe26.joints(), face(68), hands].concat()
            }
            Self::Body25b => own(&[&COCO_17[..], &["upper_neck", "head_top"], &FEET].concat()),
            Self::Mpii16 => own(&MPII),
            Self::Lsp14 => own(&LSP),
        }
    }

    /// Whether the joint of this name is a point of a face or a hand, which the bones of a body do
    /// not have: `face-` and a number, a finger, `left_hand_root` beside `left_wrist`, the mouth or
    /// a corner of an eye. Nose, eyes, ears and wrists are joints.
    ///
    /// ```
    /// use ga_body::format::Model;
    ///
    /// let joints = Model::Coco133.joints();
    /// let body = joints.iter().filter(|name| !Model::is_face_or_hand(name));
    /// assert_eq!(body.count(), 23);
    /// ```
    #[must_use]
    pub fn is_face_or_hand(name: &str) -> bool {
        let bare = name
            .strip_prefix("left_")
            .or_else(|| name.strip_prefix("right_"));
        let mut beginnings = FACE_OR_HAND.iter();
        name.starts_with(FACE)
            || bare.is_some_and(|bare| beginnings.any(|beginning| bare.starts_with(beginning)))
    }

    /// The models and how many joints they have, in words.
    pub(super) fn listed() -> String {
        let counts = Self::ALL.map(|model| format!("{model} ({})", model.joints().len()));
        counts.join(", ")
    }

    /// Whether no other model in wide use has as many joints.
    fn is_told(self) -> bool {
        !matches!(self, Self::Body25b | Self::Mpii16 | Self::Lsp14)
    }
}

impl fmt::Display for Model {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Model {
    type Err = UnknownModel;

    /// The model of a name, in small or capital letters.
    fn from_str(name: &str) -> Result<Self, UnknownModel> {
        let mut models = Self::ALL.into_iter();
        let found = models.find(|model| model.name().eq_ignore_ascii_case(name));
        found.ok_or_else(|| UnknownModel {
            name: name.to_owned(),
        })
    }
}

fn names_of_models() -> String {
    Model::ALL.map(Model::name).join(", ")
}

const SIDES: [&str; 2] = ["left", "right"];

/// With what the names of the other points of a face or hand begin, without their sides.
const FACE_OR_HAND: [&str; 10] = [
    "hand_root",
    "thumb",
    "index",
    "forefinger",
    "middle_finger",
    "ring_finger",
    "pinky",
    "eye_inner",
    "eye_outer",
    "mouth",
];
