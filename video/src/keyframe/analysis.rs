//! The analysis of a video, frame by frame.

use std::collections::VecDeque;

use ga_image::plane::Plane;
use ga_image::quality::MutualInformation;
use ga_image::ycbcr::YCbCr;
use serde::{Serialize, Serializer};

use super::colour::usual_colour;
use super::cut::{CutDetector, threshold};
use super::difference::{after_motion, at_rest, moments};
use super::dissolve::{DissolveDetector, REACH, WINDOW};
use super::fade::{FadeDetector, Level};
use super::layout::{Layout, Rectangle};
use super::select::{KeyFrame, Seen, Selector};
use super::shot::{Shot, Transitions};
use super::signature;
use super::window::Window;
use crate::{Frame, VideoError};

/// The time over which the motion of the background is measured, in seconds.
const MOTION_SECONDS: f64 = 0.5;

/// What is looked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// The blocks into which frames are divided.
    pub layout: Layout,
    /// The least number of frames of a shot.
    pub minimum_shot: usize,
    /// The least that is new in a key frame other than the first of its shot, from 0 to 1; see
    /// [`novelty`](super::select::novelty).
    pub threshold: f64,
    /// The most key frames.
    pub budget: Option<usize>,
}

impl Default for Options {
    /// Five blocks, shots of one frame or more, key frames of which 30 % are new, as many as there
    /// are.
    fn default() -> Self {
        Self {
            layout: Layout::Five,
            minimum_shot: 1,
            threshold: 0.3,
            budget: None,
        }
    }
}

/// What is measured of each frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameMeasures {
    /// When it is shown, in seconds after the first frame.
    pub time_seconds: f64,
    /// Mean and deviation of red.
    pub level: Level,
    /// The difference from the frame before it, after the motion of the camera.
    pub change: f32,
    /// The difference of the background from the frame before it, at rest.
    pub background: f32,
    /// The mutual information of its luma and that of the frame before it, at full resolution, in
    /// bits; of the first frame its entropy with itself is not computed, and `None` stands there.
    pub mutual_information_bits: Option<f64>,
}

/// What was found in a video. Its JSON has the number of frames, and what was found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Analysis {
    /// What was measured of each frame.
    #[serde(serialize_with = "number")]
    pub frames: Vec<FrameMeasures>,
    /// The change that a frame has to exceed in order to begin a shot, for each frame.
    #[serde(skip)]
    pub thresholds: Vec<f32>,
    /// The difference of the background from half a second before, for each frame.
    #[serde(skip)]
    pub moving: Vec<f32>,
    /// Cuts, dissolves and fades.
    #[serde(flatten)]
    pub transitions: Transitions,
    /// The shots, which cover all frames.
    pub shots: Vec<Shot>,
    /// The key frames, in order.
    pub key_frames: Vec<KeyFrame>,
}

fn number<S: Serializer>(frames: &[FrameMeasures], serializer: S) -> Result<S::Ok, S::Error> {
    frames.len().serialize(serializer)
}

/// Analyses a video frame by frame. Its memory is that of three frames, of the signatures of 140
/// frames, and some numbers for each frame.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::ycbcr::YCbCr;
/// use ga_video::keyframe::{Analyser, Options};
/// use ga_video::{Frame, Planes, Samples};
///
/// // Stripes for 20 frames, then checks.
/// let mut analyser = Analyser::new(Options::default(), YCbCr::default());
/// for index in 0..40 {
///     let luma = Plane::from_fn(128, 72, |column, row| match index < 20 {
///         true => 60 + 100 * (column as u8 / 16 % 2),
///         false => 60 + 100 * ((column / 32 + row / 12) as u8 % 2),
///     });
///     let samples = Samples::Eight(Planes { luma, ..Planes::default() });
///     let time_seconds = index as f64 / 25.0;
///     analyser.push(&Frame { index, time_seconds, samples })?;
/// }
/// let found = analyser.finish();
/// assert_eq!(found.transitions.cuts, [20]);
/// assert_eq!(found.shots.len(), 2);
/// assert_eq!(found.key_frames.iter().map(|key| key.index).collect::<Vec<_>>(), [0, 20]);
/// # Ok::<(), ga_video::VideoError>(())
/// ```
#[derive(Debug)]
pub struct Analyser {
    options: Options,
    colours: YCbCr,
    window: Window,
    cuts: CutDetector,
    dissolves: DissolveDetector,
    fades: FadeDetector,
    selector: Selector,
    information: MutualInformation,
    /// The mutual information of the next frames and those before them, where it is known.
    measured: VecDeque<Option<f64>>,
    previous: Plane<u8>,
    frames: Vec<FrameMeasures>,
    changes: Vec<f32>,
    moving: Vec<f32>,
    reach: Vec<usize>,
}

impl Analyser {
    /// An analysis of a video with these colours.
    #[must_use]
    pub fn new(options: Options, colours: YCbCr) -> Self {
        Self {
            options,
            colours,
            window: Window::new(WINDOW),
            cuts: CutDetector::default(),
            dissolves: DissolveDetector::default(),
            fades: FadeDetector::default(),
            selector: Selector::default(),
            information: MutualInformation::new(),
            measured: VecDeque::new(),
            previous: Plane::default(),
            frames: Vec::new(),
            changes: Vec::new(),
            moving: Vec::new(),
            reach: Vec::new(),
        }
    }

    /// The same for a video of whose first frames it is known how much each says of the one before
    /// it: [`FrameMeasures::mutual_information_bits`], as [`information`](super::information)
    /// measures it.
    #[must_use]
    pub fn with_information(self, measured: impl Into<VecDeque<Option<f64>>>) -> Self {
        Self {
            measured: measured.into(),
            ..self
        }
    }

    /// Analyses the next frame. Returns whether it may become a key frame, so that its picture has
    /// to be kept.
    ///
    /// # Errors
    ///
    /// [`VideoError::KeyFrameSize`] when it differs in size from the first.
    pub fn push(&mut self, frame: &Frame) -> Result<bool, VideoError> {
        let index = self.frames.len();
        let size = frame.samples.size();
        let first = match index {
            0 => size,
            _ => [self.previous.width(), self.previous.height()],
        };
        let error = || VideoError::KeyFrameSize {
            frame: index,
            size,
            first,
        };
        if size != first || size[0] * size[1] == 0 {
            return Err(error());
        }
        let layout = self.options.layout;
        let eight = frame.samples.eight_bits();
        let signature = signature::red(&frame.samples, self.colours);
        let mut measures = FrameMeasures {
            time_seconds: frame.time_seconds,
            level: level(&signature),
            change: 0.0,
            background: 0.0,
            mutual_information_bits: None,
        };
        let mut at_rest_change = 0.0;
        let known = self.measured.pop_front().flatten();
        if let Some(before) = index
            .checked_sub(1)
            .and_then(|before| self.window.get(before))
        {
            measures.change = after_motion(before, &signature, layout).typical();
            let rest = at_rest(before, &signature, layout);
            measures.background = rest.background(layout);
            at_rest_change = rest.typical();
            let bits = match known {
                Some(bits) => bits,
                None => {
                    let information = self.information.compare(&self.previous, &eight.luma);
                    information.map_err(|_| error())?.mutual_bits()
                }
            };
            measures.mutual_information_bits = Some(bits);
        }
        self.frames.push(measures);
        self.changes.push(measures.change);
        self.window.push(signature);
        self.measure_motion(index);
        let forced = self.detect(index, usual_colour(&eight, self.colours));
        let Some(signature) = self.window.get(index) else {
            return Err(error());
        };
        let seen = Seen {
            index,
            time_seconds: measures.time_seconds,
            signature,
            level: measures.level,
            luma: eight.luma.view(),
            change: measures.change,
            change_at_rest: at_rest_change,
            mutual_bits: measures.mutual_information_bits,
            forced,
        };
        let candidate = self.selector.examine(&seen, layout, &mut self.information);
        let candidate = candidate.map_err(|_| error())?;
        match self.previous.is_empty() {
            true => self.previous = eight.luma.clone(),
            false => self
                .previous
                .values_mut()
                .copy_from_slice(eight.luma.values()),
        }
        Ok(candidate)
    }

    /// Examines the last frames, and gives what was found.
    #[must_use]
    pub fn finish(mut self) -> Analysis {
        let Options {
            layout,
            minimum_shot,
            threshold: least_new,
            budget,
        } = self.options;
        self.cuts.advance(&self.changes, &self.window, layout, true);
        let mut transitions = Transitions {
            cuts: self.cuts.cuts(),
            dissolves: self.dissolves.finish(&self.window, layout),
            fades: self.fades.finish(&self.window),
            flashes: self.cuts.flashes().to_vec(),
        };
        transitions.reconcile(&self.changes);
        let shots = transitions.shots(&self.moving, &self.reach, minimum_shot);
        let key_frames = self
            .selector
            .finish(&transitions, &shots, least_new, budget);
        let thresholds = (0..self.changes.len()).map(|index| threshold(&self.changes, index));
        Analysis {
            thresholds: thresholds.collect(),
            moving: self.moving,
            frames: self.frames,
            transitions,
            shots,
            key_frames,
        }
    }

    /// The difference of the background from half a second before, and how many frames that are.
    fn measure_motion(&mut self, index: usize) {
        let time = self.frames[index].time_seconds;
        let reach = (1..=REACH.min(index))
            .find(|back| time - self.frames[index - back].time_seconds >= MOTION_SECONDS - 1e-6);
        let reach = reach.unwrap_or(REACH.min(index));
        let pair = (self.window.get(index - reach), self.window.get(index));
        let moving = match pair {
            (Some(before), Some(now)) if reach > 0 => {
                at_rest(before, now, self.options.layout).surroundings()
            }
            _ => 0.0,
        };
        self.moving.push(moving);
        self.reach.push(reach);
    }

    /// Looks for transitions in the frames so far; returns whether a new shot has no candidate.
    fn detect(&mut self, index: usize, colour: [u8; 3]) -> bool {
        let layout = self.options.layout;
        self.cuts
            .advance(&self.changes, &self.window, layout, false);
        self.dissolves.advance(&self.window, layout);
        self.fades.advance(&self.window, colour);
        let dissolve = self
            .dissolves
            .found()
            .last()
            .map(|dissolve| dissolve.frames.end);
        let boundary = self
            .cuts
            .last()
            .max(dissolve)
            .filter(|start| *start <= index);
        boundary.is_some_and(|start| self.selector.last().is_some_and(|last| last < start))
    }
}

fn level(signature: &Plane<f32>) -> Level {
    let [mean, deviation] = moments(signature, Rectangle::of(signature));
    Level { mean, deviation }
}
