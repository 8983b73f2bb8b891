//! The names of the joints of each model, one by one.

/// The names of COCO's joints in their order, left and right of the person.
pub const COCO_17: [&str; 17] = [
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

/// The joints of the model BODY_25 in their order, R and L right and left of the person.
pub const BODY_25: [&str; 25] = [
    "Nose",
    "Neck",
    "RShoulder",
    "RElbow",
    "RWrist",
    "LShoulder",
    "LElbow",
    "LWrist",
    "MidHip",
    "RHip",
    "RKnee",
    "RAnkle",
    "LHip",
    "LKnee",
    "LAnkle",
    "REye",
    "LEye",
    "REar",
    "LEar",
    "LBigToe",
    "LSmallToe",
    "LHeel",
    "RBigToe",
    "RSmallToe",
    "RHeel",
];

/// The joints of OpenPose's model COCO in their order: those of [`BODY_25`] but for the middle of
/// the hips and the feet.
pub const COCO_18: [&str; 18] = {
    let mut joints = [""; 18];
    let mut index = 0;
    while index < joints.len() {
        joints[index] = BODY_25[if index < MID_HIP { index } else { index + 1 }];
        index += 1;
    }
    joints
};

/// The six points of the feet as COCO-WholeBody and BODY_25B have them.
pub(super) const FEET: [&str; 6] = [
    "left_big_toe",
    "left_small_toe",
    "left_heel",
    "right_big_toe",
    "right_small_toe",
    "right_heel",
];

pub(super) const HALPE_MIDDLE: [&str; 3] = ["head_top", "neck", "hip"];

pub(super) const HALPE_FEET: [&str; 6] = [
    "left_big_toe",
    "right_big_toe",
    "left_small_toe",
    "right_small_toe",
    "left_heel",
    "right_heel",
];

pub(super) const MEDIAPIPE: [&str; 33] = [
    "nose",
    "left_eye_inner",
    "left_eye",
    "left_eye_outer",
    "right_eye_inner",
    "right_eye",
    "right_eye_outer",
    "left_ear",
    "right_ear",
    "left_mouth",
    "right_mouth",
    "left_shoulder",
    "right_shoulder",
    "left_elbow",
    "right_elbow",
    "left_wrist",
    "right_wrist",
    "left_pinky",
    "right_pinky",
    "left_index",
    "right_index",
    "left_thumb",
    "right_thumb",
    "left_hip",
    "right_hip",
    "left_knee",
    "right_knee",
    "left_ankle",
    "right_ankle",
    "left_heel",
    "right_heel",
    "left_foot_index",
    "right_foot_index",
];

pub(super) const MPII: [&str; 16] = [
    "right_ankle",
    "right_knee",
    "right_hip",
    "left_hip",
    "left_knee",
    "left_ankle",
    "pelvis",
    "thorax",
    "upper_neck",
    "head_top",
    "right_wrist",
    "right_elbow",
    "right_shoulder",
    "left_shoulder",
    "left_elbow",
    "left_wrist",
];

pub(super) const LSP: [&str; 14] = [
    "right_ankle",
    "right_knee",
    "right_hip",
    "left_hip",
    "left_knee",
    "left_ankle",
    "right_wrist",
    "right_elbow",
    "right_shoulder",
    "left_shoulder",
    "left_elbow",
    "left_wrist",
    "neck",
    "head_top",
];

/// With what the names of the points of a face begin that have numbers.
pub(super) const FACE: &str = "face-";

/// The points of a face.
pub(super) fn face(count: usize) -> Vec<String> {
    (0..count).map(|index| format!("{FACE}{index}")).collect()
}

/// The points of a hand: four of each finger from the palm on, with that of the wrist where there
/// is one.
pub(super) fn hand(side: &str, has_root: bool) -> Vec<String> {
    let root = has_root.then(|| format!("{side}_hand_root"));
    let fingers = [
        "thumb",
        "forefinger",
        "middle_finger",
        "ring_finger",
        "pinky_finger",
    ];
    let of_finger = |finger| (1..=4).map(move |place| format!("{side}_{finger}{place}"));
    root.into_iter()
        .chain(fingers.into_iter().flat_map(of_finger))
        .collect()
}

/// The middle of the hips in [`BODY_25`].
const MID_HIP: usize = 8;
