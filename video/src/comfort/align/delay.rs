//! The delay of one eye in the whole of a video.

use ga_numerics::order_statistics::median;

/// The delay of the right eye that most frames of a video show.
///
/// ```
/// use ga_video::comfort::align::CommonDelay;
///
/// let found = CommonDelay::of([2.1, 1.9, 2.0, 5.0, 2.1]);
/// assert_eq!((found.frames, found.measured, found.agreeing), (2, 5, 4));
/// assert!((found.rest_frames - 0.05).abs() < 1e-9);
/// // No delay holds for more than half of the frames.
/// let found = CommonDelay::of([1.0, 1.0, -3.0, 4.0]);
/// assert_eq!((found.frames, found.agreeing), (0, 0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CommonDelay {
    /// By how many whole frames the right eye is late; negative when the left one is late. 0 where
    /// no delay holds for more than half of the frames that show one.
    pub frames: i64,
    /// What the delay exceeds that by, from −½ to ½ frame: the median of the frames that agree.
    pub rest_frames: f64,
    /// How many frames show a delay.
    pub measured: usize,
    /// How many of these are within half a frame of the median of all.
    pub agreeing: usize,
}

/// Delays agree that differ by no more than this from their median, in frames.
const WITHIN: f64 = 0.5;

impl CommonDelay {
    /// The common delay of frames that show these.
    #[must_use]
    pub fn of(delays: impl IntoIterator<Item = f64>) -> Self {
        let mut delays: Vec<f64> = delays.into_iter().collect();
        let measured = delays.len();
        // The median is among a majority that agrees, if there is one.
        let Some(middle) = median(&mut delays) else {
            return Self::default();
        };
        delays.retain(|delay| (delay - middle).abs() <= WITHIN);
        let agreeing = delays.len();
        if 2 * agreeing <= measured {
            return Self {
                measured,
                ..Self::default()
            };
        }
        let common = median(&mut delays).unwrap_or(0.0);
        Self {
            // A cast from float saturates.
            frames: common.round() as i64,
            rest_frames: common - common.round(),
            measured,
            agreeing,
        }
    }
}
