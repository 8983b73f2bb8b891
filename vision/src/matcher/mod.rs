//! Dense stereo: the disparity of every pixel of a rectified pair, by semi-global matching.
//!
//! Cui's §2.1.2 and §2.1.4 need depth at every pixel. The steps are:
//!
//! 1. The right view is brought to the exposure of the left, where they differ much. Views of more
//!    than 8 bits are brought to levels of 8 bits, spread where their contrast is small; the census
//!    compares the numbers themselves.
//! 2. The census transform, the level and the slope of each pixel are compared with those of its
//!    candidates in the same row of the other view (Zabih and Woodfill 1994).
//! 3. The costs are averaged over the region that the arms of a pixel span, on which levels are
//!    near its own (Zhang, Lu and Lafruit 2009).
//! 4. The costs of smooth paths from five directions are added (Hirschmüller 2008), and the
//!    candidate of the least sum is taken, to a fraction of a pixel.
//! 5. What the right view does not confirm is removed, and so are small islands. Where the costs
//!    have no minimum, nothing is certain.
//! 6. Holes are filled by smooth paths from the disparities around them, among the candidates that
//!    the right view cannot see. Where most matches of a region of similar levels lie on a plane,
//!    its holes and its matches without texture are on it.
//! 7. Edges are sharpened by a weighted median, and the rest is smoothed.
//!
//! [`Mode::Fast`] leaves out step 3. [`Mode::Best`] matches the right view as well for steps 5 and
//! 6; the other modes take its disparities from the costs of the left view.
//!
//! Costs of one row are in memory at a time for each strip of rows that is computed, those of step
//! 3 for 42 rows, and those of step 6 for the holes of at most 64 rows or as many as 8 rows have
//! pixels. As many strips are computed at the same time as fit into 12 MiB, or 64 MiB with step 3,
//! and two in any case.
//!
//! The loops are compiled for several sets of instructions, of which the best is taken at run time.
//! Rows are computed in strips whose height does not depend on the number of threads, so neither
//! does the result.
//!
//! ```
//! use ga_image::plane::Plane;
//! use ga_vision::matcher::{Matcher, MatcherOptions, Mode};
//!
//! // A texture, seen 5 px further left by the right camera.
//! let level = |u: usize, v: usize| (u * u * 7 + v * v * 13 + u * v) as u8;
//! let left = Plane::from_fn(120, 60, |column, row| level(column + 5, row));
//! let right = Plane::from_fn(120, 60, |column, row| level(column + 10, row));
//! let options = MatcherOptions { range: [0, 16], mode: Mode::Fast, threads: 1 };
//! let mut matcher = Matcher::new(options, 120, 60)?;
//! let found = matcher.run(&left, &right)?;
//! let disparity = found.disparity.get(60, 30).unwrap();
//! assert!((disparity - 5.0).abs() < 0.2);
//! # Ok::<(), ga_vision::disparity::StereoError>(())
//! ```

// Loops over lanes and pixels by number become vector instructions; chains of iterators over many
// slices often do not.
#![allow(clippy::needless_range_loop)]

mod arms;
mod cost;
mod exposure;
mod features;
mod flat;
mod lanes;
mod parts;
mod path;
mod planes;
mod refine;
mod strips;
mod support;
mod sweep;
mod view;
mod winner;

use ga_image::plane::{Plane, PlaneView};
use ga_image::sample::Sample;
use rayon::{ThreadPool, ThreadPoolBuilder, join};

use crate::disparity::{DisparityMap, StereoError};
use path::Penalties;
use planes::RegionPlanes;
use refine::speckle::Islands;
use refine::visibility::VisibilityFill;
use refine::weighted::WeightedMedian;
use refine::{check, fill, median, smooth};
use serde::Serialize;
use strips::Strips;
use sweep::{Found, Task};
use view::View;
use winner::{STEPS, UNKNOWN};

/// How much work a matcher does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Costs of single pixels.
    Fast,
    /// Costs are averaged over neighbourhoods of similar levels, which flat surfaces need.
    #[default]
    Balanced,
    /// As [`Balanced`](Self::Balanced), and the right view is matched as well: it confirms more,
    /// and tells better what may fill the holes.
    Best,
}

/// What a matcher looks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MatcherOptions {
    /// The least disparity that is looked for, in pixels, and the first one beyond the greatest.
    /// Cameras that are turned towards each other see negative ones.
    pub range: [i32; 2],
    /// How much work is done.
    pub mode: Mode,
    /// The number of threads; 0 for as many as the machine can run at the same time. Results do not
    /// depend on it.
    pub threads: usize,
}

impl MatcherOptions {
    /// The number of disparities that are looked for.
    fn candidates(&self) -> usize {
        self.range[0].abs_diff(self.range[1]) as usize
    }
}

/// What a matcher finds.
#[derive(Clone, Debug)]
pub struct Match {
    /// The disparity of each pixel of the left view, in pixels. All are known.
    pub disparity: DisparityMap,
    /// How clearly the best candidate of each pixel stands out, from 0 to 1: 1 − S / S′, where S is
    /// its cost and S′ the least cost of candidates that are not beside it. It is 0 where there are
    /// none, where the costs have no minimum, as in areas of one level, and where the disparity was
    /// filled in.
    pub confidence: Plane<f32>,
    /// How many pixels have costs with a minimum.
    pub textured: usize,
}

/// What a matcher finds in numbers, under the names of JSON.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MatchSummary {
    /// The least disparity in pixels.
    #[serde(rename = "least_px")]
    pub least: Option<f32>,
    /// The greatest disparity in pixels.
    #[serde(rename = "greatest_px")]
    pub greatest: Option<f32>,
    /// The percentage of the pixels whose disparity is known.
    pub density: f64,
    /// The mean of the confidences, from 0 to 1.
    pub mean_confidence: f64,
    /// The percentage of the pixels whose costs have a minimum.
    pub textured: f64,
}

impl Match {
    /// The disparities and confidences in numbers.
    #[must_use]
    pub fn summary(&self) -> MatchSummary {
        let map = &self.disparity;
        let range = map.range();
        let pixels = (map.width() * map.height()) as f64;
        let values = self.confidence.values().iter();
        MatchSummary {
            least: range.map(|[least, _]| least),
            greatest: range.map(|[_, greatest]| greatest),
            density: 100.0 * map.known() as f64 / pixels,
            mean_confidence: values.map(|c| f64::from(*c)).sum::<f64>() / pixels,
            textured: 100.0 * self.textured as f64 / pixels,
        }
    }

    /// The same with disparities unknown that are less certain.
    #[must_use]
    pub fn at_least(mut self, least_confidence: f32) -> Self {
        let mut pixels = self.disparity.into_plane();
        let confidence = self.confidence.values();
        for (disparity, confidence) in pixels.values_mut().iter_mut().zip(confidence) {
            if *confidence < least_confidence {
                *disparity = f32::NAN;
            }
        }
        self.disparity = DisparityMap::new(pixels);
        self
    }
}

/// The least number of columns and rows of a view: the census reaches over 9 × 7 pixels.
const LEAST_SIDE: usize = 9;
/// The greatest number of pixels, for which places fit in 31 bits.
const MOST_PIXELS: usize = 1 << 30;
/// The greatest number of disparities that are looked for: they fit in 16 bits, in 1/32 px.
pub const GREATEST_RANGE: usize = 2047;
/// Islands of fewer pixels are removed.
const SPECKLE: u32 = 80;
/// How much more than the median of the least costs a candidate outside the right view costs.
const OUTSIDE: u8 = 20;

/// Finds the disparities of rectified pairs of views of one size. The memory for maps and regions,
/// and up to 16 MiB for strips of rows, are kept from one pair to the next.
#[derive(Debug)]
pub struct Matcher {
    options: MatcherOptions,
    width: usize,
    height: usize,
    threads: ThreadPool,
    strips: Strips,
    left: View,
    right: View,
    maps: [Vec<u16>; 2],
    opposite: Vec<u16>,
    confidence: Vec<u8>,
    textured: usize,
    islands: Islands,
    weighted: WeightedMedian,
    visibility: VisibilityFill,
    planes: RegionPlanes,
}

impl Matcher {
    /// A matcher for views of this size.
    ///
    /// # Errors
    ///
    /// [`StereoError::Range`], [`StereoError::TooSmall`], [`StereoError::TooLarge`] or
    /// [`StereoError::Threads`].
    pub fn new(options: MatcherOptions, width: usize, height: usize) -> Result<Self, StereoError> {
        if width.min(height) < LEAST_SIDE {
            let least = LEAST_SIDE;
            return Err(StereoError::TooSmall {
                width,
                height,
                least,
            });
        }
        let most = MOST_PIXELS;
        let Some(pixels) = width.checked_mul(height).filter(|pixels| *pixels <= most) else {
            return Err(StereoError::TooLarge {
                width,
                height,
                most,
            });
        };
        let [least, beyond] = options.range.map(i64::from);
        let greatest = width.min(GREATEST_RANGE);
        if !(1..=greatest as i64).contains(&(beyond - least)) {
            return Err(StereoError::Range {
                range: beyond - least,
                greatest,
                width,
            });
        }
        if least <= -(width as i64) || beyond > width as i64 {
            let range = options.range;
            return Err(StereoError::OutOfView { range, width });
        }
        let range = options.candidates();
        let threads = ThreadPoolBuilder::new()
            .num_threads(options.threads)
            .build()?;
        Ok(Self {
            options,
            width,
            height,
            threads,
            strips: Strips::new(width, height, range, options.mode != Mode::Fast),
            left: View::new(width, height, false),
            right: View::new(width, height, true),
            maps: [vec![0; pixels], vec![0; pixels]],
            opposite: vec![0; pixels],
            confidence: vec![0; pixels],
            textured: 0,
            islands: Islands::default(),
            weighted: WeightedMedian::new(),
            visibility: VisibilityFill::new(width, range),
            planes: RegionPlanes::default(),
        })
    }

    /// What the matcher looks for.
    #[must_use]
    pub fn options(&self) -> MatcherOptions {
        self.options
    }

    /// The disparities of a rectified pair in grey of any depth, whose numbers are compared to
    /// 16 bits.
    ///
    /// # Errors
    ///
    /// [`StereoError::Views`] or [`StereoError::Size`].
    pub fn run<'a, T: Sample>(
        &mut self,
        left: impl Into<PlaneView<'a, T>>,
        right: impl Into<PlaneView<'a, T>>,
    ) -> Result<Match, StereoError> {
        let (left, right) = (left.into(), right.into());
        let size = |view: PlaneView<'_, T>| [view.width(), view.height()];
        if size(left) != size(right) {
            return Err(StereoError::Views {
                left: size(left),
                right: size(right),
            });
        }
        let expected = [self.width, self.height];
        if size(left) != expected {
            return Err(StereoError::Size {
                found: size(left),
                expected,
            });
        }
        let threads = &self.threads;
        let views = [&mut self.left, &mut self.right];
        let least = self.options.range[0] as isize;
        threads.install(|| view::fill([left, right], views, least));
        Ok(self.matched())
    }

    /// Memory is made and given back between the steps, in the thread of the caller.
    fn matched(&mut self) -> Match {
        let threads = self.threads.current_num_threads();
        self.strips.prepare(threads);
        self.find();
        self.strips.release();
        self.visibility.prepare(&self.maps[0], threads);
        self.fill();
        self.visibility.release();
        let plane = || Plane::filled(self.width, self.height, 0.0);
        let (mut disparity, mut clear) = (plane(), plane());
        let (map, confidence, width) = (&self.maps[0], &self.confidence, self.width);
        self.threads.install(|| {
            smooth::smooth(
                map,
                width,
                self.options.range[0] as f32,
                disparity.values_mut(),
            );
            refine::over_rows(clear.values_mut(), width, |first, rows| {
                for (value, level) in rows.iter_mut().zip(&confidence[first * width..]) {
                    *value = f32::from(*level) / 255.0;
                }
            });
        });
        Match {
            disparity: DisparityMap::new(disparity),
            confidence: clear,
            textured: self.textured,
        }
    }

    /// Finds the disparities that the other view confirms, and its own in whole pixels.
    fn find(&mut self) {
        let Self {
            options,
            width,
            threads,
            strips,
            left,
            right,
            maps: [map, spare],
            opposite,
            confidence,
            textured,
            islands,
            ..
        } = self;
        let range = options.candidates();
        let width = *width;
        threads.install(|| {
            let noise = join(|| view::noise(left), || view::noise(right));
            let noise = (noise.0.max(noise.1) - 1.5).max(0.0);
            let median_cost = strips.median_cost(left, right, range);
            let penalties = Penalties::new(median_cost, noise);
            let task = Task {
                reference: left,
                other: right,
                range,
                penalties: &penalties,
                outside: median_cost.saturating_add(OUTSIDE).min(cost::HIGHEST),
                threshold: (3.0 + 1.7 * noise) as u8,
            };
            let mut of_left = Found {
                disparities: spare,
                confidence: Some(confidence),
                opposite: None,
            };
            if options.mode == Mode::Best {
                let of_right = Found {
                    disparities: opposite,
                    confidence: None,
                    opposite: None,
                };
                let mirrored = Task {
                    reference: right,
                    other: left,
                    ..task
                };
                strips.run([(task, of_left), (mirrored, of_right)]);
            } else {
                of_left.opposite = Some(opposite);
                strips.run([(task, of_left)]);
            }
            median::median(spare, width, map);
            median::median(opposite, width, spare);
            std::mem::swap(opposite, spare);
            if options.mode == Mode::Best {
                check::to_pixels(opposite, width);
            }
            check::hide(opposite, width, right.seen());
            confirm(map, opposite, spare, width, islands, options.mode);
            keep(confidence, width, |place| map[place] != UNKNOWN);
            *textured = flat::doubt(left, confidence);
        });
    }

    /// Fills the holes, and sharpens the edges.
    fn fill(&mut self) {
        let Self {
            options,
            width,
            threads,
            left,
            maps: [map, spare],
            opposite,
            confidence,
            weighted,
            visibility,
            planes,
            ..
        } = self;
        threads.install(|| {
            visibility.fill(map, left, opposite, spare);
            fill::fill_rows(spare, *width);
            planes.apply(map, options.candidates(), left, opposite, spare);
            keep(confidence, *width, |place| map[place] == spare[place]);
            weighted.at_edges(spare, left, map);
            median::median(map, *width, spare);
            median::median(spare, *width, map);
        });
    }
}

/// Marks as unknown, in the maps of both views, what the other one does not confirm, and small
/// islands in that of the left. `opposite` has whole pixels.
fn confirm(
    map: &mut [u16],
    opposite: &mut [u16],
    pixels: &mut [u16],
    width: usize,
    islands: &mut Islands,
    mode: Mode,
) {
    pixels.copy_from_slice(map);
    check::check::<STEPS>(map, width, opposite);
    let confirm_opposite = |opposite: &mut [u16], pixels: &mut [u16]| {
        check::to_pixels(pixels, width);
        check::check::<1>(opposite, width, pixels);
    };
    if mode == Mode::Best {
        join(
            || islands.remove(map, width, SPECKLE),
            || confirm_opposite(opposite, pixels),
        );
    } else {
        // A map of the right view that comes from the costs of the left agrees with it even where
        // both are wrong, so that it is compared with what is left of that map.
        islands.remove(map, width, SPECKLE);
        pixels.copy_from_slice(map);
        confirm_opposite(opposite, pixels);
    }
}

/// Sets the confidence to 0 but for the pixels that are kept.
fn keep(confidence: &mut [u8], width: usize, is_kept: impl Fn(usize) -> bool + Sync + Send) {
    refine::over_rows(confidence, width, |first, rows| {
        for (place, level) in (first * width..).zip(rows) {
            if !is_kept(place) {
                *level = 0;
            }
        }
    });
}
