//! People in the format of OpenPose, JSON, a file for each frame.
//!
//! A file is `{"version": 1.3, "people": [{"pose_keypoints_2d": […]}]}` with three numbers u, v and
//! confidence for each joint, in pixels, of the 25 joints of [`BODY_25`] or the 18 of [`COCO_18`],
//! see the page "Output" of OpenPose's documentation. Joints that were not found are three zeros.

use serde::Deserialize;

use super::{DetectedFrame, Detections, FrameKey, JointsError, Person};

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

/// The middle of the hips in [`BODY_25`].
const MID_HIP: usize = 8;

/// A file of one frame.
#[derive(Deserialize)]
pub(super) struct File {
    people: Vec<FilePerson>,
}

#[derive(Deserialize)]
struct FilePerson {
    pose_keypoints_2d: Vec<f64>,
}

/// Reads the files of the frames of a view, each with the name that messages give it.
///
/// The number of a frame is the last number in the name of its file, such as 12 in
/// `walk_000000000012_keypoints.json`. Where names have no numbers, or one twice, and where there
/// is one file alone, frames are numbered in the order of their names.
///
/// # Errors
/// [`JointsError`] for text that is not such JSON, a person with a number of joints that is not 25
/// or 18, files of both kinds, a joint with numbers that are not finite or a negative confidence,
/// and an empty list of files.
///
/// ```
/// use ga_body::format::openpose;
///
/// let numbers = vec!["0,0,0"; 24].join(",");
/// let text = format!(r#"{{"people": [{{"pose_keypoints_2d": [310.5, 82, 0.9, {numbers}]}}]}}"#);
/// let people = openpose::decode(&[("a_3_keypoints.json", text.as_bytes())])?;
/// assert_eq!(people.joints[8], "MidHip");
/// assert!(people.frames[0].people[0].joints[0].is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn decode<N: AsRef<str>>(files: &[(N, &[u8])]) -> Result<Detections, JointsError> {
    let files = files.iter().map(|(name, bytes)| {
        let name = name.as_ref();
        Ok((name.to_owned(), decode_file(name, bytes)?))
    });
    join(files.collect::<Result<_, JointsError>>()?)
}

/// Reads the file of a frame, whose people have joints of a known number.
pub(super) fn decode_file(name: &str, bytes: &[u8]) -> Result<File, JointsError> {
    let frame = || FrameKey::Name(name.to_owned()).to_string();
    let file: File = serde_json::from_slice(bytes).map_err(|error| JointsError::JsonOfFrame {
        frame: frame(),
        error,
    })?;
    for (person, numbers) in file.people.iter().enumerate() {
        let found = numbers.pose_keypoints_2d.len();
        if found != 3 * BODY_25.len() && found != 3 * COCO_18.len() {
            return Err(JointsError::Numbers {
                frame: frame(),
                person,
                expected: "75 or 54".to_owned(),
                found,
            });
        }
    }
    Ok(file)
}

/// The frames of a view from the files of them, with their names.
pub(super) fn join(mut files: Vec<(String, File)>) -> Result<Detections, JointsError> {
    if files.is_empty() {
        return Err(JointsError::Empty("pictures"));
    }
    files.sort_by(|(a, _), (b, _)| a.cmp(b));
    let numbers: Option<Vec<i64>> = files.iter().map(|(name, _)| number_in(name)).collect();
    let numbers = numbers.filter(|numbers| {
        let mut sorted = numbers.clone();
        sorted.sort_unstable();
        sorted.dedup();
        numbers.len() > 1 && sorted.len() == numbers.len()
    });
    let people = files.iter().flat_map(|(_, file)| &file.people);
    let expected = people.map(|person| person.pose_keypoints_2d.len()).next();
    let expected = expected.unwrap_or(3 * BODY_25.len());
    let joints: &[&str] = if expected == 3 * COCO_18.len() {
        &COCO_18
    } else {
        &BODY_25
    };
    let joints: Vec<String> = joints.iter().map(|&name| name.to_owned()).collect();
    let mut frames = Vec::with_capacity(files.len());
    for (index, (name, file)) in files.into_iter().enumerate() {
        let number = numbers
            .as_ref()
            .map_or(index as i64, |numbers| numbers[index]);
        let frame = FrameKey::Name(name);
        let people = file.people.iter().enumerate().map(|(person, numbers)| {
            let numbers = &numbers.pose_keypoints_2d;
            if numbers.len() != expected {
                return Err(JointsError::Kind {
                    frame: frame.to_string(),
                    person,
                    expected,
                    found: numbers.len(),
                });
            }
            Person::from_numbers(&frame, person, &joints, numbers)
        });
        frames.push(DetectedFrame {
            key: FrameKey::Number(number),
            people: people.collect::<Result<_, _>>()?,
        });
    }
    frames.sort_by(|a, b| a.key.cmp(&b.key));
    Ok(Detections { joints, frames })
}

/// The last number in a name.
fn number_in(name: &str) -> Option<i64> {
    let name = name.strip_suffix("_keypoints.json").unwrap_or(name);
    let digits = name.split(|character: char| !character.is_ascii_digit());
    digits.rev().find(|digits| !digits.is_empty())?.parse().ok()
}
