//! Whether the two views give depth, and the right one: exchanged, equal and unrelated views.
//!
//! Where a near surface ends, each eye sees a strip of the farther surface that the other eye does
//! not see. It lies at the left of the near surface in the left view, and at its right in the right
//! view. If the views are exchanged, what is nearer by its disparities is hidden by what is
//! farther, so that each strip seems to belong to the wrong side. The views are matched densely at
//! up to 480 columns in both directions; each run of pixels without a partner between two
//! disparities is compared with both sides, by mean colours and by the steps at its ends. The
//! evidence is the difference of the two comparisons, divided by their sum, from −1 to 1. Its
//! standard error comes from leaving out one region of the picture after the other (jackknife;
//! Efron and Tibshirani 1993).
//!
//! The verdict needs evidence of several regions, which adds up over the frames of a shot: see
//! [`StereoscopyMeter`]. Pictures without half-occlusions, such as flat ones, do not show the order
//! of the eyes. Measured settings of our own.

mod alignment;
mod correspondence;
mod strips;
mod view;

use correspondence::{Correspondence, correspond};
use ga_numerics::order_statistics::Sorted;
use strips::{Cues, REGION_COUNT, collect};

use crate::Samples;
pub use alignment::Alignment;
use ga_vision::disparity::StereoError;

/// How a shot uses its two views.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Stereoscopy {
    /// The left eye's view is the left one.
    InOrder,
    /// The views are exchanged.
    Exchanged,
    /// Both views are the same picture: there is no depth.
    Identical,
    /// The views do not show the same scene.
    Unrelated,
    /// The views do not show enough to decide.
    Unknown,
}

impl Stereoscopy {
    /// It, where it is an order of the eyes.
    pub(super) fn order(self) -> Option<Self> {
        Some(self).filter(|order| matches!(order, Self::InOrder | Self::Exchanged))
    }

    /// The order that frames have in common: `None` where none shows one, and
    /// [`Unknown`](Self::Unknown) where they differ.
    pub(super) fn common(orders: impl Iterator<Item = Self>) -> Option<Self> {
        orders.reduce(|common, order| {
            if common == order {
                order
            } else {
                Self::Unknown
            }
        })
    }

    /// The name in files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::InOrder => "in order",
            Self::Exchanged => "exchanged",
            Self::Identical => "identical",
            Self::Unrelated => "unrelated",
            Self::Unknown => "unknown",
        }
    }
}

/// The least evidence that decides, and the least multiple of its standard error, for the likeness
/// of colours and for the steps at the ends of strips.
const LEAST_EVIDENCE: [f64; 2] = [0.15, 0.3];
const LEAST_CERTAINTY: [f64; 2] = [3.5, 4.5];

/// Each view alone must show this part of the evidence.
const AGREEMENT: f64 = 0.25;

/// Evidence for the opposite of this many standard errors leaves the order unknown.
const CONTRADICTION: f64 = 2.0;

/// The least number of strips and of regions with strips.
const LEAST_STRIPS: f64 = 40.0;
const LEAST_REGIONS: usize = 6;

/// The least part of a view that must have texture.
const LEAST_TEXTURE: f64 = 0.01;

/// Below the first part of textured pixels with a partner views are unrelated; from the second on
/// they are related.
const UNRELATED: f64 = 0.2;
const RELATED: f64 = 0.35;

/// Views whose disparities are all within this part of the width of zero are identical.
pub(super) const IDENTICAL: f64 = 0.0006;

/// Collects evidence over frames of one shot.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_video::comfort::stereoscopy::{Alignment, Stereoscopy, StereoscopyMeter};
/// use ga_video::{Planes, Samples};
///
/// // A near square before a background, both of random blocks.
/// let grey = |u: usize, v: usize| {
///     let block = (u / 3 + 1) * 7919 + (v / 3 + 1) * 104_729;
///     (40 + block * block / 977 % 150) as u8
/// };
/// let view = |near: usize, shift: usize| {
///     let luma = Plane::from_fn(240, 160, |column, row| {
///         let inside = (near..near + 100).contains(&column) && (40..120).contains(&row);
///         match inside {
///             true => grey(column + 1000 - near, row + 500) / 2 + 100,
///             false => grey(column + shift, row) / 2,
///         }
///     });
///     Samples::Eight(Planes { luma, ..Planes::default() })
/// };
/// let (left, right) = (view(80, 4), view(68, 4));
/// let mut meter = StereoscopyMeter::default();
/// meter.add(&left, &right, &Alignment::default())?;
/// assert_eq!(meter.verdict(), Stereoscopy::InOrder);
///
/// let mut meter = StereoscopyMeter::default();
/// meter.add(&right, &left, &Alignment::default())?;
/// assert_eq!(meter.verdict(), Stereoscopy::Exchanged);
/// # Ok::<(), ga_vision::disparity::StereoError>(())
/// ```
#[derive(Clone, Debug)]
pub struct StereoscopyMeter {
    /// The evidence in the regions of the left and of the right view.
    regions: [Vec<Cues>; 2],
    textured: [f64; 2],
    confirmed: [f64; 2],
    pixels: f64,
    frames: usize,
    identical: usize,
}

impl Default for StereoscopyMeter {
    fn default() -> Self {
        Self {
            regions: [0, 1].map(|_| vec![Cues::default(); REGION_COUNT]),
            textured: [0.0; 2],
            confirmed: [0.0; 2],
            pixels: 0.0,
            frames: 0,
            identical: 0,
        }
    }
}

impl StereoscopyMeter {
    /// Takes the views of a frame, and how they lie to each other by rows and columns. Frames too
    /// small to be matched add nothing.
    ///
    /// # Errors
    ///
    /// [`StereoError`] when the views cannot be matched.
    pub fn add(
        &mut self,
        left: &Samples,
        right: &Samples,
        alignment: &Alignment,
    ) -> Result<(), StereoError> {
        let [left, right] = view::reduced(left, right, alignment);
        let Some(found) = correspond(&left, &right)? else {
            return Ok(());
        };
        let [of_left, of_right] = &mut self.regions;
        collect(&left, &found.left, of_left);
        collect(&right, &found.right, of_right);
        for eye in 0..2 {
            self.textured[eye] += found.textured[eye];
            self.confirmed[eye] += found.confirmed[eye];
        }
        self.pixels += found.pixels();
        self.frames += 1;
        self.identical += usize::from(found.is_identical());
        Ok(())
    }

    /// The number of frames that were taken.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.frames
    }

    /// The evidence that the eyes are in order, from −1 to 1: that of colours or that of steps,
    /// whichever is more certain; 0 where there is none.
    #[must_use]
    pub fn evidence(&self) -> f64 {
        let [colours, steps] = self.cues();
        match steps.certainty.abs() > colours.certainty.abs() {
            true => steps.evidence,
            false => colours.evidence,
        }
    }

    /// What the frames so far show.
    #[must_use]
    pub fn verdict(&self) -> Stereoscopy {
        let has_texture = self
            .textured
            .map(|textured| textured > LEAST_TEXTURE * self.pixels);
        match has_texture {
            _ if self.frames == 0 => return Stereoscopy::Unknown,
            [false, false] => return Stereoscopy::Unknown,
            // One view has a picture and the other has none.
            [true, false] | [false, true] => return Stereoscopy::Unrelated,
            [true, true] => {}
        }
        let related = self.related();
        if related < UNRELATED {
            return Stereoscopy::Unrelated;
        }
        if related < RELATED {
            return Stereoscopy::Unknown;
        }
        if 2 * self.identical > self.frames {
            return Stereoscopy::Identical;
        }
        self.order()
    }

    /// The part of the textured pixels that have a partner.
    fn related(&self) -> f64 {
        self.confirmed.iter().sum::<f64>() / self.textured.iter().sum::<f64>().max(1.0)
    }

    fn order(&self) -> Stereoscopy {
        let all = self.regions.iter().flatten();
        let with_strips = all.filter(|cues| cues.strips > 0.0);
        let strips: Vec<f64> = with_strips.map(|cues| cues.strips).collect();
        if strips.iter().sum::<f64>() < LEAST_STRIPS || strips.len() < LEAST_REGIONS {
            return Stereoscopy::Unknown;
        }
        let cues = self.cues();
        for cue in 0..2 {
            let (this, other) = (cues[cue], cues[1 - cue]);
            let sign = this.evidence.signum();
            let decides = this.evidence.abs() >= LEAST_EVIDENCE[cue]
                && this.certainty.abs() >= LEAST_CERTAINTY[cue];
            let agree = |part: f64| part * sign >= AGREEMENT * this.evidence.abs();
            if decides
                && this.of_views.into_iter().all(agree)
                && other.certainty * sign > -CONTRADICTION
            {
                return match sign > 0.0 {
                    true => Stereoscopy::InOrder,
                    false => Stereoscopy::Exchanged,
                };
            }
        }
        Stereoscopy::Unknown
    }

    fn cues(&self) -> [Certain; 2] {
        let sums = self.regions.each_ref().map(|regions| {
            let mut sum = Cues::default();
            regions.iter().for_each(|cues| sum.add(cues));
            sum
        });
        let ratio = |excess: f64, total: f64| if total > 0.0 { excess / total } else { 0.0 };
        [0, 1].map(|cue| {
            let of_views = [0, 1].map(|eye| {
                let sum = &sums[eye];
                // In the right view the sides of a strip are exchanged.
                [1.0, -1.0][eye] * ratio(sum.excess[cue], sum.total[cue])
            });
            let evidence = 0.5 * (of_views[0] + of_views[1]);
            let mut without = Vec::new();
            for eye in 0..2 {
                for cues in self.regions[eye].iter().filter(|cues| cues.strips > 0.0) {
                    let total = sums[eye].total[cue] - cues.total[cue];
                    let rest = ratio(sums[eye].excess[cue] - cues.excess[cue], total);
                    without.push(0.5 * ([1.0, -1.0][eye] * rest + of_views[1 - eye]));
                }
            }
            let error = super::jackknife::standard_error(&without);
            let certainty = match error > 0.0 {
                true => evidence / error,
                false => 0.0,
            };
            Certain {
                evidence,
                of_views,
                certainty,
            }
        })
    }
}

/// Evidence, and how many times its standard error it is.
#[derive(Clone, Copy, Debug)]
struct Certain {
    /// The mean of both views: what they have in common apart from the order of the eyes, such as
    /// a preference of the matcher, cancels out.
    evidence: f64,
    of_views: [f64; 2],
    certainty: f64,
}

impl Correspondence {
    fn pixels(&self) -> f64 {
        (self.left.width() * self.left.height()) as f64 / correspondence::FIRST_LOOK_PIXELS
    }

    /// Whether nearly all disparities are zero.
    fn is_identical(&self) -> bool {
        let mut known: Vec<f32> = self.left.values().to_vec();
        known.retain(|value| !value.is_nan());
        let most = (IDENTICAL * self.left.width() as f64) as f32;
        Sorted::new(&mut known)
            .is_some_and(|known| [0.02, 0.98].iter().all(|p| known.quantile(*p).abs() < most))
    }
}
