//! Times as hours, minutes, seconds and frames.

use std::fmt::Write;

use super::error::TimeBaseError;

/// Rates that are usual in films and video.
const USUAL: [[u32; 2]; 9] = [
    [24, 1],
    [24_000, 1001],
    [25, 1],
    [30, 1],
    [30_000, 1001],
    [48, 1],
    [50, 1],
    [60, 1],
    [60_000, 1001],
];

/// The farthest that times may be from those of a rate, in frames.
const APART: f64 = 0.1;

/// Seconds of a minute, and minutes of an hour.
const MINUTE: usize = 60;

/// In what frames are counted, and from where.
///
/// Times are counted in the nearest whole number of frames in a second, as in SMPTE ST 12-1: at
/// 24000/1001 in 24. With dropped numbers, which 30000/1001 and 60000/1001 may have, frames 0 and 1
/// (to 3 at 60) of each minute but every tenth are left out, so that the code follows the clock.
///
/// ```
/// use ga_video::keyframe::timecode::TimeBase;
///
/// let film = TimeBase::new([24_000, 1001], Some("01:00:00:00"))?;
/// assert_eq!(film.code(8.758_75), "01:00:08:18");
/// let dropped = TimeBase::new([30_000, 1001], Some("00:00:00;00"))?;
/// assert_eq!(dropped.code(1800.0 * 1.001 / 30.0), "00:01:00;02");
/// # Ok::<(), ga_video::keyframe::TimeBaseError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TimeBase {
    rate: [u32; 2],
    first: usize,
    drops: bool,
}

impl TimeBase {
    /// Frames in a second as numerator and denominator, and the timecode of the first frame, as
    /// `HH:MM:SS:FF`, or with `;` before the frames where numbers are dropped.
    ///
    /// # Errors
    ///
    /// Any [`TimeBaseError`].
    pub fn new(rate: [u32; 2], start: Option<&str>) -> Result<Self, TimeBaseError> {
        let [numerator, denominator] = rate;
        if numerator == 0 || denominator == 0 || f64::from(numerator) < 0.5 * f64::from(denominator)
        {
            return Err(TimeBaseError::Rate(format!("{numerator}/{denominator}")));
        }
        let mut base = Self {
            rate,
            first: 0,
            drops: false,
        };
        if let Some(start) = start {
            (base.first, base.drops) = base.parsed(start)?;
        }
        Ok(base)
    }

    /// Frames in a second as numerator and denominator.
    #[must_use]
    pub fn rate(&self) -> [u32; 2] {
        self.rate
    }

    /// Whether numbers of frames are dropped.
    #[must_use]
    pub fn drops(&self) -> bool {
        self.drops
    }

    /// The frames that are counted in a second.
    fn nominal(&self) -> usize {
        let [numerator, denominator] = self.rate.map(|part| part as usize);
        ((numerator + denominator / 2) / denominator).max(1)
    }

    /// How many numbers are left out in a minute.
    fn dropped(&self) -> usize {
        match self.drops {
            true => self.nominal() / 15,
            false => 0,
        }
    }

    /// The number of frame that a timecode says, and whether it drops numbers.
    fn parsed(mut self, text: &str) -> Result<(usize, bool), TimeBaseError> {
        let wrong = || TimeBaseError::Start(text.to_owned());
        self.drops = text.contains(';');
        if self.drops && !matches!(self.rate, [30_000 | 60_000, 1001]) {
            let [numerator, denominator] = self.rate;
            return Err(TimeBaseError::Drop(format!("{numerator}/{denominator}")));
        }
        let two_digits = |part: &str| part.parse().ok().filter(|_: &usize| part.len() == 2);
        let parts: Option<Vec<usize>> = text.split([':', ';']).map(two_digits).collect();
        let parts = parts.and_then(|parts| <[usize; 4]>::try_from(parts).ok());
        let Some([hours, minutes, seconds, frames]) = parts else {
            return Err(wrong());
        };
        let is_left_out = seconds == 0 && frames < self.dropped() && minutes % 10 != 0;
        if hours >= 24
            || minutes >= MINUTE
            || seconds >= MINUTE
            || frames >= self.nominal()
            || is_left_out
            || (self.drops && text.find(';') != Some("HH:MM:SS".len()))
        {
            return Err(wrong());
        }
        let all_minutes = MINUTE * hours + minutes;
        let counted = (MINUTE * all_minutes + seconds) * self.nominal() + frames;
        Ok((
            counted - self.dropped() * (all_minutes - all_minutes / 10),
            self.drops,
        ))
    }

    /// The timecode of a time in seconds after the first frame: that of the nearest frame. After 24
    /// hours it begins again.
    #[must_use]
    pub fn code(&self, seconds: f64) -> String {
        let [numerator, denominator] = self.rate.map(f64::from);
        let frames = (seconds * numerator / denominator).round();
        // A cast from float saturates.
        self.code_of_frame((frames as usize).saturating_add(self.first))
    }

    fn code_of_frame(&self, frame: usize) -> String {
        let (nominal, dropped) = (self.nominal(), self.dropped());
        let minute = MINUTE * nominal - dropped;
        let ten_minutes = 10 * minute + dropped;
        let (tens, rest) = (frame / ten_minutes, frame % ten_minutes);
        // The first of ten minutes is whole.
        let later = rest.saturating_sub(dropped) / minute;
        let number = frame + dropped * (9 * tens + later);
        let (seconds, frames) = (number / nominal, number % nominal);
        let mut text = format!(
            "{:02}:{:02}:{:02}",
            seconds / 3600 % 24,
            seconds / 60 % 60,
            seconds % 60
        );
        let separator = if self.drops { ';' } else { ':' };
        // Writing to a string does not fail.
        let _ = write!(text, "{separator}{frames:02}");
        text
    }
}

/// Frames in a second as numerator and denominator, from text such as `25`, `30000/1001` or
/// `29.97`, which is 30000/1001.
///
/// ```
/// use ga_video::keyframe::timecode::rate;
///
/// assert_eq!(rate("23.976"), Some([24_000, 1001]));
/// assert_eq!(rate("24000/1001"), Some([24_000, 1001]));
/// assert_eq!(rate("12.5"), Some([12_500, 1000]));
/// assert_eq!(rate("0"), None);
/// ```
#[must_use]
pub fn rate(text: &str) -> Option<[u32; 2]> {
    if let Some((numerator, denominator)) = text.split_once('/') {
        let rate = [numerator.parse().ok()?, denominator.parse().ok()?];
        return rate.iter().all(|part| *part > 0).then_some(rate);
    }
    let number: f64 = text.parse().ok()?;
    let is_usual = |[numerator, denominator]: &[u32; 2]| {
        (number - f64::from(*numerator) / f64::from(*denominator)).abs() < 0.0051
    };
    // 24 is nearer to 24 than to 24000/1001.
    let exact = number.fract() == 0.0;
    let usual = USUAL.into_iter().filter(|_| !exact).find(is_usual);
    // A cast from float saturates.
    let thousandths = || [(1000.0 * number).round() as u32, 1000];
    let rate = match exact {
        true => [number as u32, 1],
        false => usual.unwrap_or_else(thousandths),
    };
    (number.is_finite() && rate[0] > 0).then_some(rate)
}

/// The usual rate at whose frames all times in seconds are, the least one; `None` where there is
/// none, or too few times to tell. Frames may be left out, as where a rate varies.
///
/// ```
/// use ga_video::keyframe::timecode::rate_of_times;
///
/// let frames = (0..300).filter(|frame| frame % 3 != 2);
/// let times: Vec<f64> = frames.map(|frame| f64::from(frame) * 1.001 / 24.0).collect();
/// assert_eq!(rate_of_times(&times), Some([24_000, 1001]));
/// ```
#[must_use]
pub fn rate_of_times(times: &[f64]) -> Option<[u32; 2]> {
    let farthest = |[numerator, denominator]: [u32; 2]| {
        let frames = times
            .iter()
            .map(|time| time * f64::from(numerator) / f64::from(denominator));
        frames
            .map(|frame| (frame - frame.round()).abs())
            .fold(0.0, f64::max)
    };
    let fitting = USUAL.into_iter().map(|rate| (rate, farthest(rate)));
    let fitting: Vec<([u32; 2], f64)> = fitting.filter(|(_, apart)| *apart < APART).collect();
    // Rates that differ by a thousandth are told apart by long films alone.
    let (first, _) = *fitting.first()?;
    let close = |rate: [u32; 2]| {
        let [a, b] = [first, rate].map(|[n, d]| f64::from(n) / f64::from(d));
        (a / b - 1.0).abs() < 0.002
    };
    let near = fitting.iter().filter(|(rate, _)| close(*rate));
    let best = near.min_by(|a, b| a.1.total_cmp(&b.1));
    best.filter(|_| times.len() > 1).map(|(rate, _)| *rate)
}
