//! Fades from and to black or white.

use std::ops::Range;

/// The greatest standard deviation of a frame without a picture, in numbers of 8 bits.
const FLAT: f32 = 1.5;

/// Below this mean a flat frame is black.
const BLACK: f32 = 16.0;

/// The least frames of a fade.
const LEAST: usize = 4;

/// A fade, as a half-open interval of frames.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fade {
    /// The frames in which brightness changes; where the video begins or ends with flat frames,
    /// with these.
    pub frames: Range<usize>,
    /// Whether the picture appears or disappears.
    pub direction: Direction,
    /// What it fades from or to.
    pub colour: Colour,
}

/// Whether a picture appears or disappears.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// The picture appears.
    In,
    /// The picture disappears.
    Out,
}

/// What a picture fades from or to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Colour {
    /// Black.
    Black,
    /// White, or another bright colour.
    White,
}

/// The mean and the standard deviation of a signature.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Level {
    /// The mean of red, from 0 to 255.
    pub mean: f32,
    /// Its standard deviation.
    pub deviation: f32,
}

impl Level {
    /// Whether there is no picture.
    #[must_use]
    pub fn is_flat(self) -> bool {
        self.deviation < FLAT
    }

    /// The root of the mean squared difference from a level.
    fn contrast(self, level: f32) -> f32 {
        (self.mean - level).hypot(self.deviation)
    }
}

/// The fades of a video, in order.
#[must_use]
pub fn fades(levels: &[Level]) -> Vec<Fade> {
    let mut found = Vec::new();
    let mut start = 0;
    while start < levels.len() {
        if !levels[start].is_flat() {
            start += 1;
            continue;
        }
        let length = levels[start..]
            .iter()
            .take_while(|level| level.is_flat())
            .count();
        let end = start + length;
        let flat = levels[start].mean;
        let colour = match flat < BLACK {
            true => Colour::Black,
            false => Colour::White,
        };
        let backwards: Vec<f32> = levels[..start]
            .iter()
            .rev()
            .map(|level| level.contrast(flat))
            .collect();
        if let Some(length) = ramp(&backwards) {
            let end = if end == levels.len() { end } else { start };
            found.push(Fade {
                frames: start - length..end,
                direction: Direction::Out,
                colour,
            });
        }
        let flat = levels[end - 1].mean;
        let forwards: Vec<f32> = levels[end..]
            .iter()
            .map(|level| level.contrast(flat))
            .collect();
        if let Some(length) = ramp(&forwards) {
            let start = if start == 0 { 0 } else { end };
            found.push(Fade {
                frames: start..end + length,
                direction: Direction::In,
                colour,
            });
        }
        start = end;
    }
    // Under flicker a fade may be found twice.
    found.dedup_by(|next, fade| next.frames.start < fade.frames.end);
    found
}

/// The number of frames in which the contrast rises from almost nothing, where it rises steadily
/// and not at once.
fn ramp(contrast: &[f32]) -> Option<usize> {
    let mut length = 0;
    for index in 0..contrast.len() {
        let later = contrast[(index + 3).min(contrast.len() - 1)];
        let slope = contrast[index] / (index + 1) as f32;
        length = index + 1;
        // What is left of the rise is slower by far than what was.
        if later - contrast[index] < 0.25 * slope * 3.0_f32.min((contrast.len() - 1 - index) as f32)
        {
            break;
        }
    }
    let rise = *contrast.get(length.checked_sub(1)?)?;
    let steps = contrast[..length].windows(2).map(|pair| pair[1] - pair[0]);
    let greatest = steps.fold(contrast[0], f32::max);
    (length >= LEAST && rise > 3.0 * FLAT && greatest < 0.5 * rise).then_some(length)
}
