//! The measured differences of the right view, applied backwards.
//!
//! A [`Plan`] says what is to be done with a video: it is made by reading the video once, or up to
//! three times where one eye is late or views are exchanged, since the other differences are those
//! of views that belong together. [`Plan::apply`] reads the video again and hands over its views
//! without the differences, [`Plan::write`] writes them to a file.

mod correction;
mod delay;
mod output;
mod pairs;
mod steady;

pub use correction::{Correction, Corrector};
pub use delay::CommonDelay;

use super::monitor::{Monitor, Options};
use super::stereoscopy::{Alignment, Stereoscopy};
use super::{FrameMeasures, FrameMeter, FrameRuns, Record, Tone, Viewing};
use crate::comfort::ComfortError;
use crate::stereo::{Layout, StereoSource, pixel_height};
use crate::{Frame, Properties, VideoError};
use pairs::Pairs;
use steady::steady;

/// What is to be done with a video so that its views differ in depth alone.
///
/// - The delay of one eye is one whole number of frames for the whole video: the median of the
///   frames that show one, rounded, where more than half of these agree with it; see
///   [`CommonDelay`]. Frames at the beginning of the late eye and at the end of the other one have
///   no partner and are left out. Parts of a frame remain.
/// - Views are exchanged in the shots, or parts of them, where they are found to be exchanged.
///   Frames that do not show the order of the eyes have that of the others of their
///   [run](Record::run); where these differ or do not show it either, they stay as they are.
/// - Vertical shift, rotation and size of the right view, and the codes of its red, green and blue,
///   are changed by the same amounts in all frames of a shot, so that the picture does not tremble:
///   by the medians of what its frames show. Where a defect begins or ends within a shot, the
///   amounts change at once; where it changes slowly, they follow it over a second. Amounts below
///   0.1 pixel at the border of the picture, or half a code, count as none. A shot in which nothing
///   can be measured is treated as the one before it, or after it at the beginning.
///
/// The left view stays as it is; so do sharpness, the depth of the numbers and the sampling of
/// colours, and parallax where no [shift](Self::with_parallax) is asked for.
///
/// ```
/// use std::io::Cursor;
///
/// use ga_image::plane::Plane;
/// use ga_image::y4m::{self, Film};
/// use ga_video::comfort::align::Plan;
/// use ga_video::comfort::{ComfortError, FrameMeasures};
/// use ga_video::stereo::{Layout, StereoSource};
/// use ga_video::y4m::Y4mSource;
///
/// // Random blocks; the right view is 3 pixels lower, and brighter.
/// let level = |column: usize, row: usize| {
///     let (u, v, brighter) = match column < 320 {
///         true => (column, row + 3, 0),
///         false => (column - 320, row, 20),
///     };
///     let block = (u / 7 + 1) * 7919 + (v / 7 + 1) * 104_729;
///     (40 + block * block / 977 % 150 + brighter) as u8
/// };
/// let frame = Plane::from_fn(640, 180, |column, row| [level(column, row); 3]);
/// let bytes = y4m::encode([&frame; 3], Film::default())?;
/// let open = || {
///     let video = Y4mSource::new(Cursor::new(bytes.clone()), "film.y4m")?;
///     StereoSource::halves(Box::new(video), Layout::SideBySide)
/// };
///
/// let plan = Plan::of(open, Some(Layout::SideBySide), 2, |_, _| {})?;
/// assert_eq!((plan.frames(), plan.delay().frames), (3, 0));
/// let mut source = open()?;
/// let colours = source.properties().colours;
/// plan.apply(&mut source, |[left, right]| {
///     let found = FrameMeasures::of(&left.samples, &right.samples, colours).unwrap();
///     assert!(found.geometry.unwrap().shift_px.abs() < 0.1);
///     assert!(found.photometry.unwrap().offset_codes.abs() < 1.0);
///     Ok::<(), ComfortError>(())
/// })?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    delay: CommonDelay,
    pairs: Vec<Pair>,
    undecided: FrameRuns,
    ends: Option<[f64; 2]>,
    width: usize,
    frames: usize,
    last_seconds: f64,
}

/// What is to be done with two views.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Pair {
    is_exchanged: bool,
    correction: Correction,
}

/// What was measured of two views.
#[derive(Clone, Copy, Debug)]
struct Found {
    begins_shot: bool,
    run: usize,
    order: Stereoscopy,
    alignment: Option<Alignment>,
    tones: Option<[Tone; 3]>,
    /// The parallax of the nearest and of the farthest points in per cent of the width.
    ends: Option<[f64; 2]>,
}

/// Amounts of shift, rotation and size are tolerated that move no point farther than this number of
/// pixels, or than this share of the columns.
const TOLERATED_PX: f64 = 0.3;
const TOLERATED_SHARE: f64 = 0.0003;

/// The codes at which lines are compared, and by how many they may differ.
const CODES: [f64; 2] = [64.0, 192.0];
const TOLERATED_CODES: f64 = 1.0;

/// Changes that are not made, in pixels and codes: interpolation would cost more than they are
/// worth.
const LEAST_PX: f64 = 0.1;
const LEAST_CODES: f64 = 0.5;

/// Frames that are read together.
const BATCH: usize = 4;

impl Plan {
    /// The plan for a video, which is opened for each time that it is read. `layout` says how the
    /// views lie in a frame, with `None` for two videos; `threads` is as in [`Options::threads`].
    /// `progress` hears how many times the video has been read, and how many frames since.
    ///
    /// # Errors
    ///
    /// [`ComfortError`]; [`ComfortError::TooShort`] where no frames would remain.
    pub fn of(
        mut open: impl FnMut() -> Result<StereoSource, VideoError>,
        layout: Option<Layout>,
        threads: usize,
        mut progress: impl FnMut(usize, usize),
    ) -> Result<Self, ComfortError> {
        let options = Options {
            viewing: Viewing::default(),
            layout,
            threads,
        };
        let mut delays = Vec::new();
        let mut source = open()?;
        let properties = *source.properties();
        let (mut readings, mut frames, mut last_seconds) = (0, 0, 0.0);
        let mut found = measured(
            &mut Pairs::new(&mut source, 0),
            &properties,
            options,
            |record| {
                delays.extend(record.asynchrony.delay().map(|delay| delay.frames));
                frames += 1;
                last_seconds = record.time_seconds;
                progress(readings, record.frame);
            },
        )?;
        let delay = CommonDelay::of(delays);
        if delay.frames != 0 {
            readings += 1;
            let mut source = open()?;
            let mut pairs = Pairs::new(&mut source, delay.frames);
            found = measured(&mut pairs, &properties, options, |record| {
                progress(readings, record.frame);
            })?;
            if found.is_empty() {
                return Err(ComfortError::TooShort {
                    frames,
                    delay: delay.frames.unsigned_abs(),
                });
            }
        }
        decide(&mut found);
        if found.iter().any(Found::is_exchanged) {
            readings += 1;
            let mut source = open()?;
            let mut pairs = Pairs::new(&mut source, delay.frames);
            measure_exchanged(&mut pairs, &properties, &mut found, |frame| {
                progress(readings, frame);
            })?;
        }
        let mut undecided = FrameRuns::default();
        let unknown = |(_, found): &(usize, &Found)| found.order == Stereoscopy::Unknown;
        let all = found.iter().enumerate();
        all.filter(unknown)
            .for_each(|(frame, _)| undecided.add(frame));
        let ends = found.iter().filter_map(|found| found.ends);
        Ok(Self {
            delay,
            pairs: pairs_of(&found, &properties),
            undecided,
            ends: ends.reduce(|[near, far], more| [near.min(more[0]), far.max(more[1])]),
            width: properties.size[0],
            frames,
            last_seconds,
        })
    }

    /// The delay that is removed.
    #[must_use]
    pub fn delay(&self) -> &CommonDelay {
        &self.delay
    }

    /// The number of frames that the video has after it.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.pairs.len()
    }

    /// The number of frames that the video has before it, and when the last one is shown, in
    /// seconds after the first.
    #[must_use]
    pub fn source_frames(&self) -> (usize, f64) {
        (self.frames, self.last_seconds)
    }

    /// The number of frames whose views are exchanged.
    #[must_use]
    pub fn exchanged_frames(&self) -> usize {
        self.pairs.iter().filter(|pair| pair.is_exchanged).count()
    }

    /// The frames after alignment in which the order of the eyes could not be decided.
    #[must_use]
    pub fn undecided(&self) -> &FrameRuns {
        &self.undecided
    }

    /// The parallax of the nearest and of the farthest points of all frames, with the eyes in
    /// order, in per cent of the picture's width; `None` where no frame shows it.
    #[must_use]
    pub fn ends(&self) -> Option<[f64; 2]> {
        self.ends
    }

    /// The plan that also moves the right views of all frames by this part of the picture's width,
    /// in per cent, to the right: what is shown moves away from the viewer, or towards him where it
    /// is negative. What lies outside the right view is mirrored at its border.
    #[must_use]
    pub fn with_parallax(mut self, percent: f64) -> Self {
        let columns = 0.01 * percent * self.width as f64;
        for pair in &mut self.pairs {
            pair.correction.parallax_px = columns;
        }
        self
    }

    /// What is changed in the right view of each frame, after delay and exchange are undone.
    pub fn corrections(&self) -> impl ExactSizeIterator<Item = &Correction> {
        self.pairs.iter().map(|pair| &pair.correction)
    }

    /// Reads the video, and hands over the views of each frame as they should be.
    ///
    /// # Errors
    ///
    /// Those of the source, and those that `each` returns.
    pub fn apply<E: From<ComfortError>>(
        &self,
        source: &mut StereoSource,
        mut each: impl FnMut([&Frame; 2]) -> Result<(), E>,
    ) -> Result<(), E> {
        let properties = source.properties();
        let mut corrector =
            Corrector::new(properties.colours).with_pixel_aspect(properties.pixel_aspect);
        let mut pairs = Pairs::new(source, self.delay.frames);
        let mut views = <[Frame; 2]>::default();
        for pair in &self.pairs {
            if !pairs.read(&mut views).map_err(ComfortError::from)? {
                break;
            }
            if pair.is_exchanged {
                views.swap(0, 1);
            }
            let [left, right] = &mut views;
            right.samples = corrector.corrected(&right.samples, &pair.correction);
            each([left, right])?;
        }
        Ok(())
    }
}

/// What all pairs show.
fn measured(
    pairs: &mut Pairs<'_>,
    properties: &Properties,
    options: Options,
    mut each: impl FnMut(&Record),
) -> Result<Vec<Found>, ComfortError> {
    let mut found = Vec::new();
    let mut take = |record: Record| {
        each(&record);
        found.push(Found {
            begins_shot: record.begins_shot,
            run: record.run,
            order: record.stereoscopy,
            ..Found::of(&record.measures)
        });
    };
    let mut monitor = Monitor::new(properties, options)?;
    let mut batch: Vec<[Frame; 2]> = vec![Default::default(); BATCH];
    loop {
        let mut count = 0;
        while count < BATCH && pairs.read(&mut batch[count])? {
            count += 1;
        }
        monitor.push(&batch[..count], &mut take)?;
        if count < BATCH {
            break;
        }
    }
    monitor.finish(&mut take);
    Ok(found)
}

/// Measures the pairs that are exchanged in their right order.
fn measure_exchanged(
    pairs: &mut Pairs<'_>,
    properties: &Properties,
    found: &mut [Found],
    mut each: impl FnMut(usize),
) -> Result<(), ComfortError> {
    let mut meter = FrameMeter::new(properties.size, properties.colours)
        .with_pixel_aspect(properties.pixel_aspect);
    let mut views = <[Frame; 2]>::default();
    for (index, found) in found.iter_mut().enumerate() {
        if !pairs.read(&mut views)? {
            break;
        }
        if found.is_exchanged() {
            let [right, left] = &views;
            let measures = meter.measure(&left.samples, &right.samples);
            let frame = left.index;
            let measures = measures.map_err(|source| ComfortError::Size { frame, source })?;
            *found = Found {
                begins_shot: found.begins_shot,
                run: found.run,
                order: Stereoscopy::Exchanged,
                ..Found::of(measures)
            };
        }
        each(index);
    }
    Ok(())
}

impl Found {
    fn of(measures: &FrameMeasures) -> Self {
        Self {
            begins_shot: false,
            run: 0,
            order: Stereoscopy::Unknown,
            alignment: measures.geometry.as_ref().map(Alignment::from),
            tones: measures.photometry.as_ref().map(|found| found.tones),
            ends: measures
                .parallax
                .as_ref()
                .map(|found| [found.near_px, found.far_px].map(|pixels| found.percent(pixels))),
        }
    }

    fn is_exchanged(&self) -> bool {
        self.order == Stereoscopy::Exchanged
    }
}

/// Gives frames that do not show the order of the eyes that which the others of their run have in
/// common.
fn decide(found: &mut [Found]) {
    for run in found.chunk_by_mut(|frame, next| frame.run == next.run) {
        let orders = run.iter().filter_map(|found| found.order.order());
        let common = Stereoscopy::common(orders).unwrap_or(Stereoscopy::Unknown);
        let open = run.iter_mut();
        let open = open.filter(|found| found.order == Stereoscopy::Unknown);
        open.for_each(|found| found.order = common);
    }
}

/// Steady changes for all pairs of views.
fn pairs_of(found: &[Found], properties: &Properties) -> Vec<Pair> {
    let size = properties.size;
    let pixel_height = pixel_height(properties.pixel_aspect);
    let [half_width, half_height] = size.map(|side| 0.5 * side.max(1) as f64);
    let half_height = pixel_height * half_height;
    let begins = |frame: usize| {
        let [before, now] = [&found[frame - 1], &found[frame]];
        now.begins_shot || now.is_exchanged() != before.is_exchanged()
    };
    // How far each difference moves a point at the border, in columns.
    let moves = found.iter().map(|found| {
        let alignment = found.alignment?;
        let rotation = alignment.rotation_degrees.to_radians().tan();
        let zoom = 0.01 * alignment.zoom_percent;
        Some([
            pixel_height * alignment.shift_px,
            half_width * rotation,
            half_width.max(half_height) * zoom,
        ])
    });
    let codes = found.iter().map(|found| {
        let [r, g, b] = found
            .tones?
            .map(|tone| CODES.map(|code| tone.apply(code) - code));
        Some([r[0], r[1], g[0], g[1], b[0], b[1]])
    });
    let tolerated = TOLERATED_PX.max(TOLERATED_SHARE * size[0] as f64);
    let moves = steady(&moves.collect::<Vec<_>>(), begins, tolerated);
    let codes = steady(&codes.collect::<Vec<_>>(), begins, TOLERATED_CODES);
    let pair = |((found, moves), codes): ((&Found, [f64; 3]), [f64; 6])| {
        let mut correction = Correction::default();
        if moves.iter().map(|pixels| pixels.abs()).sum::<f64>() >= LEAST_PX {
            correction.alignment = Alignment {
                shift_px: moves[0] / pixel_height,
                rotation_degrees: (moves[1] / half_width).atan().to_degrees(),
                zoom_percent: 100.0 * moves[2] / half_width.max(half_height),
            };
        }
        if codes.iter().any(|codes| codes.abs() >= LEAST_CODES) {
            correction.tones = [0, 1, 2].map(|channel: usize| {
                let [a, b] = [0, 1].map(|k| CODES[k] + codes[2 * channel + k]);
                Tone::through(CODES, [a, b])
            });
        }
        Pair {
            is_exchanged: found.is_exchanged(),
            correction,
        }
    };
    found.iter().zip(moves).zip(codes).map(pair).collect()
}

#[cfg(test)]
mod tests {
    use super::{Found, Stereoscopy, decide};
    use crate::comfort::FrameMeasures;

    #[test]
    fn undecided_frames_have_the_order_of_their_run() {
        use Stereoscopy::{Exchanged, Identical, InOrder, Unknown};
        let decided = |runs: &[&[Stereoscopy]]| -> Vec<Stereoscopy> {
            let frames = runs.iter().enumerate().flat_map(|(run, orders)| {
                orders.iter().map(move |order| Found {
                    run,
                    order: *order,
                    ..Found::of(&FrameMeasures::default())
                })
            });
            let mut found: Vec<Found> = frames.collect();
            decide(&mut found);
            found.into_iter().map(|found| found.order).collect()
        };
        let found = decided(&[
            &[Unknown, Exchanged, Unknown, Exchanged],
            &[Unknown, Unknown],
            &[InOrder, Identical, Unknown],
            // They contradict each other.
            &[InOrder, Unknown, Exchanged],
        ]);
        let expected = [
            [Exchanged; 4].as_slice(),
            &[Unknown; 2],
            &[InOrder, Identical, InOrder],
            &[InOrder, Unknown, Exchanged],
        ];
        assert_eq!(found, expected.concat());
    }
}
