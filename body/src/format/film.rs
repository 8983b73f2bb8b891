//! The joints of one person in a film, JSON, as programs with MediaPipe Pose write them.
//!
//! ```json
//! {"width": 1080, "height": 1920, "frames_per_second": 60,
//!  "frames": [[[509.31, 444.11, 0.9999], …], null, …]}
//! ```
//!
//! A frame is a list of `[u, v, confidence]` for each joint, in pixels, or `null` where no person
//! was found; a joint may be `null` too. MediaPipe's own landmarks have `visibility` as the
//! confidence, and x and y from 0 to 1, which are to be multiplied by the width and height of the
//! picture.
//!
//! Joints have the names of a list `joints` where there is one, or those of the [`Model`] that
//! their number tells. `width`, `height` and `frames_per_second` may be left out.
//!
//! ```
//! use ga_body::format::film;
//!
//! let joints = vec!["[310.5, 82, 0.9]"; 33].join(",");
//! let text = format!(r#"{{"frames_per_second": 60, "frames": [null, [{joints}]]}}"#);
//! let people = film::decode(text.as_bytes(), None)?;
//! assert_eq!(people.frames_per_second, Some(60.0));
//! assert!(people.frames[0].people.is_empty());
//! assert_eq!(people.joints[11], "left_shoulder");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use serde::Deserialize;

use super::detections::{Keypoints, Picture};
use super::{Detections, FrameKey, JointsError, Model};

#[derive(Deserialize)]
struct File {
    #[serde(default)]
    frames_per_second: Option<f64>,
    #[serde(default)]
    joints: Option<Vec<String>>,
    frames: Vec<Option<Vec<Option<Vec<f64>>>>>,
}

/// Reads the joints of a film. They are those of the model where one is given.
///
/// # Errors
/// [`JointsError`] for text that is not such JSON, a frame with a number of joints that is not that
/// of the model or of the names, or that tells no model, frames of several kinds, a joint with
/// numbers that are not finite or not three, a frame rate that is not positive, and where there is
/// no frame.
pub fn decode(bytes: &[u8], model: Option<Model>) -> Result<Detections, JointsError> {
    let file: File = serde_json::from_slice(bytes)?;
    if let Some(rate) = file.frames_per_second
        && !(rate > 0.0 && rate.is_finite())
    {
        return Err(JointsError::FrameRate(rate));
    }
    let frames = (0..).zip(&file.frames).map(|(number, frame)| {
        let key = FrameKey::Number(number);
        let people = frame.iter().map(|joints| person(&key, joints));
        let people = people.collect::<Result<_, _>>()?;
        Ok(Picture::new(key, people))
    });
    let frames = frames.collect::<Result<_, JointsError>>()?;
    Ok(Detections {
        frames_per_second: file.frames_per_second,
        ..Detections::new(frames, file.joints, model)?
    })
}

fn person(key: &FrameKey, joints: &[Option<Vec<f64>>]) -> Result<Keypoints, JointsError> {
    let joints = joints.iter().enumerate().map(|(index, joint)| {
        let Some(numbers) = joint.as_deref() else {
            return Ok([0.0; 3]);
        };
        numbers.try_into().map_err(|_| JointsError::Nesting {
            frame: key.to_string(),
            person: 0,
            index,
            found: numbers.len(),
            expected: "u, v and the confidence",
        })
    });
    joints.collect()
}
