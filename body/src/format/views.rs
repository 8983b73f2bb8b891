//! The joints of one person in several views.

use serde::{Deserialize, Serialize};

use super::{JointProblem, JointsError, JointsNote};
use crate::{JointPixel, Observation};

/// The joints of one person in all frames of several views.
///
/// # The file
///
/// ```json
/// {
///   "version": 1,
///   "frames_per_second": 120.0,
///   "deviation_px": 2.0,
///   "joints": ["Hips", "LeftUpLeg", "LeftLeg"],
///   "views": [
///     {"name": "left", "frames": [[[640.5, 360.2], [655.0, 362.5], null]]},
///     {"name": "right", "frames": [[[602.1, 360.0], [617.5, 361.8], [618.0, 480.0, 5.0]]]}
///   ]
/// }
/// ```
///
/// Each frame of a view has an entry for each of the `joints`, in their order: `[u, v]` in pixels
/// from the centre of the top left one, `[u, v, deviation]` with the standard deviation of both
/// coordinates in pixels, or `null` where the view does not show the joint. `deviation_px`, 1
/// without it, is the deviation of joints that have none of their own. `frames_per_second` may be
/// left out. All views have the same number of frames, and equal frames were taken at one time.
///
/// ```
/// use ga_body::format::JointViews;
///
/// let text = br#"{"version": 1, "joints": ["Hips", "Head"],
///     "views": [{"name": "left", "frames": [[[640.5, 360.25], null]]}]}"#;
/// let joints = JointViews::decode(text)?;
/// let seen = joints.observation(0, &[Some(1), Some(0)]).ok_or("no frame")?;
/// assert_eq!(seen.views[0][0], None);
/// assert_eq!(seen.views[0][1].map(|pixel| pixel.position), Some([640.5, 360.25]));
/// assert_eq!(JointViews::decode(joints.encode().as_bytes())?, joints);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct JointViews {
    joints: Vec<String>,
    frames_per_second: Option<f64>,
    views: Vec<JointView>,
    notes: Vec<JointsNote>,
}

/// The joints of one person in all frames of a view.
#[derive(Clone, Debug, PartialEq)]
pub struct JointView {
    /// The name of the view.
    pub name: String,
    /// For each frame and each joint where it is; `None` where the view does not show it.
    pub frames: Vec<Vec<Option<JointPixel>>>,
}

/// The version of the format.
const VERSION: u32 = 1;

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct File {
    version: u32,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    frames_per_second: Option<f64>,
    #[serde(default = "default_deviation")]
    deviation_px: f64,
    joints: Vec<String>,
    views: Vec<FileView>,
}

#[derive(Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
struct FileView {
    name: String,
    frames: Vec<Vec<Option<Vec<f64>>>>,
}

fn default_deviation() -> f64 {
    1.0
}

impl JointViews {
    /// Joints of these names, in the views.
    ///
    /// # Errors
    /// [`JointsError`] for names that are not unique, frames of another number of joints or views
    /// of another number of frames, pixels that are not finite, deviations and frame rates that are
    /// not positive, and where there is nothing.
    pub fn new(
        joints: Vec<String>,
        frames_per_second: Option<f64>,
        views: Vec<JointView>,
    ) -> Result<Self, JointsError> {
        if let Some(rate) = frames_per_second
            && !(rate > 0.0 && rate.is_finite())
        {
            return Err(JointsError::FrameRate(rate));
        }
        check_names("joints", joints.iter())?;
        check_names("views", views.iter().map(|view| &view.name))?;
        let expected = views.first().map_or(0, |view| view.frames.len());
        if expected == 0 {
            return Err(JointsError::Empty("frames"));
        }
        for view in &views {
            let found = view.frames.len();
            if found != expected {
                let view = view.name.clone();
                return Err(JointsError::Frames {
                    view,
                    expected,
                    found,
                });
            }
            check_frames(view, &joints)?;
        }
        Ok(Self {
            joints,
            frames_per_second,
            views,
            notes: Vec::new(),
        })
    }

    /// The same with what a user should know of where it is from.
    pub(super) fn with_notes(self, notes: Vec<JointsNote>) -> Self {
        Self { notes, ..self }
    }

    /// Reads the text of a file.
    ///
    /// # Errors
    /// As [`new`](Self::new), and for text that is not such JSON.
    pub fn decode(bytes: &[u8]) -> Result<Self, JointsError> {
        let file: File = serde_json::from_slice(bytes)?;
        if file.version != VERSION {
            return Err(JointsError::Version {
                expected: VERSION,
                found: file.version,
            });
        }
        let views = file.views.into_iter().map(|view| {
            let frames = view.frames.iter().enumerate().map(|(number, frame)| {
                let pixels = frame.iter().enumerate().map(|(index, numbers)| {
                    let Some(numbers) = numbers else {
                        return Ok(None);
                    };
                    let (position, deviation) = match numbers[..] {
                        [u, v] => ([u, v], file.deviation_px),
                        [u, v, deviation] => ([u, v], deviation),
                        _ => {
                            return Err(JointsError::Joint {
                                view: view.name.clone(),
                                frame: number,
                                joint: file.joints.get(index).cloned().unwrap_or_default(),
                                index,
                                problem: JointProblem::Numbers(numbers.len()),
                            });
                        }
                    };
                    Ok(Some(JointPixel {
                        position,
                        deviation,
                    }))
                });
                pixels.collect::<Result<Vec<_>, _>>()
            });
            let frames = frames.collect::<Result<Vec<_>, _>>()?;
            let name = view.name;
            Ok(JointView { name, frames })
        });
        let views = views.collect::<Result<Vec<_>, JointsError>>()?;
        Self::new(file.joints, file.frames_per_second, views)
    }

    /// The text of a file that [`decode`](Self::decode) reads.
    #[must_use]
    pub fn encode(&self) -> String {
        let numbers = |pixel: &Option<JointPixel>| {
            pixel.map(
                |JointPixel {
                     position: [u, v],
                     deviation,
                 }| vec![u, v, deviation],
            )
        };
        let view = |view: &JointView| FileView {
            name: view.name.clone(),
            frames: view
                .frames
                .iter()
                .map(|frame| frame.iter().map(numbers).collect())
                .collect(),
        };
        let file = File {
            version: VERSION,
            frames_per_second: self.frames_per_second,
            deviation_px: default_deviation(),
            joints: self.joints.clone(),
            views: self.views.iter().map(view).collect(),
        };
        // Strings and finite numbers are always JSON.
        serde_json::to_string(&file).unwrap_or_default() + "\n"
    }

    /// The names of the joints.
    #[must_use]
    pub fn joints(&self) -> &[String] {
        &self.joints
    }

    /// The frame rate, where it is known.
    #[must_use]
    pub fn frames_per_second(&self) -> Option<f64> {
        self.frames_per_second
    }

    /// The views.
    #[must_use]
    pub fn views(&self) -> &[JointView] {
        &self.views
    }

    /// The names of the views.
    #[must_use]
    pub fn view_names(&self) -> Vec<&str> {
        self.views.iter().map(|view| view.name.as_str()).collect()
    }

    /// What a user should know of how detections became these joints, such as frames that were
    /// added. They are not written into a file.
    #[must_use]
    pub fn notes(&self) -> &[JointsNote] {
        &self.notes
    }

    /// How many frames each view has; at least 1.
    #[must_use]
    pub fn frame_count(&self) -> usize {
        self.views.first().map_or(0, |view| view.frames.len())
    }

    /// What the views show in a frame, for the points of a body: `order` says for each point which
    /// of the joints it is, and `None` where the file does not have it. `None` from
    /// [`frame_count`](Self::frame_count) on.
    #[must_use]
    pub fn observation(&self, frame: usize, order: &[Option<usize>]) -> Option<Observation> {
        let views = self.views.iter().map(|view| {
            let pixels = view.frames.get(frame)?;
            let of_point = |joint: &Option<usize>| *pixels.get((*joint)?)?;
            Some(order.iter().map(of_point).collect())
        });
        Some(Observation {
            views: views.collect::<Option<_>>()?,
        })
    }
}

fn check_names<'a>(
    what: &'static str,
    names: impl Iterator<Item = &'a String>,
) -> Result<(), JointsError> {
    let names: Vec<&String> = names.collect();
    if names.is_empty() {
        return Err(JointsError::Empty(what));
    }
    let mut sorted = names.clone();
    sorted.sort();
    match sorted.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => Err(JointsError::Duplicate {
            what,
            name: pair[0].clone(),
        }),
        None => Ok(()),
    }
}

fn check_frames(view: &JointView, joints: &[String]) -> Result<(), JointsError> {
    for (frame, pixels) in view.frames.iter().enumerate() {
        if pixels.len() != joints.len() {
            return Err(JointsError::Joints {
                view: view.name.clone(),
                frame,
                expected: joints.len(),
                found: pixels.len(),
            });
        }
        for (index, pixel) in pixels.iter().enumerate() {
            let Some(JointPixel {
                position,
                deviation,
            }) = *pixel
            else {
                continue;
            };
            let problem = if !position.iter().all(|u| u.is_finite()) {
                JointProblem::Position(position)
            } else if !(deviation > 0.0 && deviation.is_finite()) {
                JointProblem::Deviation(deviation)
            } else {
                continue;
            };
            return Err(JointsError::Joint {
                view: view.name.clone(),
                frame,
                joint: joints[index].clone(),
                index,
                problem,
            });
        }
    }
    Ok(())
}
