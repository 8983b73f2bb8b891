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

/// The joints of OpenPose's model COCO in their order.
pub const COCO_18: [&str; 18] = [
    "Nose",
    "Neck",
    "RShoulder",
    "RElbow",
    "RWrist",
    "LShoulder",
    "LElbow",
    "LWrist",
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
];

#[derive(Deserialize)]
struct File {
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
/// use ga_vision::body::format::openpose;
///
/// let numbers = vec!["0,0,0"; 24].join(",");
/// let text = format!(r#"{{"people": [{{"pose_keypoints_2d": [310.5, 82, 0.9, {numbers}]}}]}}"#);
/// let people = openpose::decode(&[("a_3_keypoints.json", text.as_bytes())])?;
/// assert_eq!(people.joints[8], "MidHip");
/// assert!(people.frames[0].people[0].joints[0].is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn decode<N: AsRef<str>>(files: &[(N, &[u8])]) -> Result<Detections, JointsError> {
    let mut files: Vec<(&str, &[u8])> = files.iter().map(|(name, f)| (name.as_ref(), *f)).collect();
    files.sort_by_key(|(name, _)| *name);
    let numbers: Option<Vec<i64>> = files.iter().map(|(name, _)| number_in(name)).collect();
    let numbers = numbers.filter(|numbers| {
        let mut sorted = numbers.clone();
        sorted.sort_unstable();
        sorted.dedup();
        numbers.len() > 1 && sorted.len() == numbers.len()
    });
    let mut kind: Option<usize> = None;
    let mut read = Vec::with_capacity(files.len());
    for (index, (name, bytes)) in files.into_iter().enumerate() {
        let file: File = serde_json::from_slice(bytes)?;
        let number = numbers
            .as_ref()
            .map_or(index as i64, |numbers| numbers[index]);
        let of_file = FrameKey::Name(name.to_owned());
        for (person, numbers) in file.people.iter().enumerate() {
            let found = numbers.pose_keypoints_2d.len();
            if kind.is_some_and(|kind| kind != found) {
                return Err(JointsError::Kind {
                    frame: of_file.to_string(),
                    expected: kind.unwrap_or(0),
                    found,
                });
            }
            if found != 3 * BODY_25.len() && found != 3 * COCO_18.len() {
                return Err(JointsError::Numbers {
                    frame: of_file.to_string(),
                    person,
                    expected: "75 or 54".to_owned(),
                    found,
                });
            }
            kind = Some(found);
        }
        read.push((number, of_file, file));
    }
    if read.is_empty() {
        return Err(JointsError::Empty("pictures"));
    }
    let joints: Vec<String> = if kind == Some(3 * COCO_18.len()) {
        COCO_18.map(str::to_owned).to_vec()
    } else {
        BODY_25.map(str::to_owned).to_vec()
    };
    read.sort_by_key(|(number, ..)| *number);
    let frames = read.into_iter().map(|(number, name, file)| {
        let people = file.people.iter().enumerate().map(|(person, numbers)| {
            Person::from_numbers(&name, person, &joints, &numbers.pose_keypoints_2d)
        });
        Ok(DetectedFrame {
            key: FrameKey::Number(number),
            people: people.collect::<Result<_, _>>()?,
        })
    });
    let frames = frames.collect::<Result<_, JointsError>>()?;
    Ok(Detections { joints, frames })
}

/// The last number in a name.
fn number_in(name: &str) -> Option<i64> {
    let name = name.strip_suffix("_keypoints.json").unwrap_or(name);
    let digits = name.split(|character: char| !character.is_ascii_digit());
    digits.rev().find(|digits| !digits.is_empty())?.parse().ok()
}
