//! Features of views: corners that are found again in another view.
//!
//! [`detect`] finds corners in all scales of a grey view and describes their surroundings by bits,
//! [`match_features`] pairs those of two views, and [`match_views`] does both and then aligns the
//! surroundings of each pair to a fraction of a pixel.
//!
//! Pixels count from the centre of the top left one, as everywhere in this crate.

mod alignment;
mod corner;
mod descriptor;
mod matching;
mod point;
mod scale;

use ga_image::plane::PlaneView;
use ga_image::sample::Sample;

pub use alignment::PixelPair;
pub use descriptor::Descriptor;
pub use matching::{Match, MatchOptions, match_features};

pub use point::Feature;
pub use scale::LEAST_SIDE;

use alignment::align;
use scale::Scale;

/// How features are found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DetectOptions {
    /// The greatest number of features.
    pub features: usize,
    /// How many scales there are, each smaller than the one before by a factor of √2. Those with a
    /// side below [`LEAST_SIDE`] pixels are left out.
    pub scales: usize,
    /// Weaker corners are left out; see [`Feature::strength`].
    pub least_strength: f64,
}

impl Default for DetectOptions {
    /// 3000 features in 6 scales of strength 4 or more.
    fn default() -> Self {
        Self {
            features: 3000,
            scales: 6,
            least_strength: 4.0,
        }
    }
}

/// How the points of two views are paired.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ViewOptions {
    /// How features are found.
    pub detect: DetectOptions,
    /// How features are paired.
    pub matching: MatchOptions,
}

/// The features of a grey view of any depth, by scale and in each by rows. None for a view that is
/// too small.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::feature::{DetectOptions, detect};
///
/// // A bright square has four corners.
/// let inside = |x: usize| (60..100).contains(&x);
/// let view = Plane::from_fn(160, 160, |u, v| if inside(u) && inside(v) { 200u8 } else { 40 });
/// let options = DetectOptions { scales: 1, ..DetectOptions::default() };
/// let found = detect(&view, &options);
/// assert_eq!(found.len(), 4);
/// let [u, v] = found[0].pixel;
/// assert!((u - 59.5).abs() < 1.5 && (v - 59.5).abs() < 1.5);
/// ```
#[must_use]
pub fn detect<'a, T: Sample>(
    view: impl Into<PlaneView<'a, T>>,
    options: &DetectOptions,
) -> Vec<Feature> {
    let scales = scale::scales(view.into(), options.scales);
    detect_in(&scales, options)
}

fn detect_in(scales: &[Scale], options: &DetectOptions) -> Vec<Feature> {
    let area = |scale: &Scale| (scale.smooth.width() * scale.smooth.height()) as f64;
    let whole: f64 = scales.iter().map(area).sum();
    let pattern = descriptor::Pattern::new();
    let mut features = Vec::new();
    for (index, scale) in scales.iter().enumerate() {
        let share = (options.features as f64 * area(scale) / whole).round() as usize;
        for corner in corner::corners(&scale.smooth, options.least_strength, share) {
            let angle = descriptor::direction(&scale.blurred, corner.place);
            features.push(Feature {
                pixel: scale.to_view(corner.place),
                size: scale.size(),
                angle,
                strength: corner.strength,
                descriptor: pattern.describe(&scale.blurred, corner.place, angle),
                scale: index,
                place: corner.place,
            });
        }
    }
    features
}

/// Pairs of pixels at which two grey views show the same points, in the order of the left view's
/// features. Some pairs may be wrong: what uses them must be robust.
///
/// Features of both views are paired by their descriptors ([`match_features`]). Then an affine map,
/// a gain and an offset align the surroundings in the right view with those in the left one, by
/// least squares of grey levels (B. D. Lucas and T. Kanade, "An iterative image registration
/// technique with an application to stereo vision", 1981); pairs that cannot be aligned are left
/// out. The views may differ in size; empty views give no pairs.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_vision::feature::{ViewOptions, match_views};
///
/// // Random blocks, and the same moved by 7 pixels.
/// let grey = |u: usize, v: usize| {
///     let block = (u / 9 + 1) * 7919 + (v / 9 + 1) * 104_729;
///     (block * block / 977 % 200) as u8
/// };
/// let left = Plane::from_fn(240, 200, |u, v| grey(u + 7, v));
/// let right = Plane::from_fn(240, 200, grey);
/// let pairs = match_views(&left, &right, &ViewOptions::default());
/// assert!(pairs.len() > 50);
/// let moved = |u: f64| (u - 7.0).abs() < 0.1;
/// let right_ones = pairs.iter().filter(|pair| moved(pair.right[0] - pair.left[0]));
/// assert!(10 * right_ones.count() > 9 * pairs.len());
/// ```
#[must_use]
pub fn match_views<'a, 'b, T: Sample, U: Sample>(
    left: impl Into<PlaneView<'a, T>>,
    right: impl Into<PlaneView<'b, U>>,
    options: &ViewOptions,
) -> Vec<PixelPair> {
    let left_scales = scale::scales(left.into(), options.detect.scales);
    let right_scales = scale::scales(right.into(), options.detect.scales);
    let left_features = detect_in(&left_scales, &options.detect);
    let right_features = detect_in(&right_scales, &options.detect);
    let matches = match_features(&left_features, &right_features, &options.matching);
    let pair = |found: &Match| {
        let (left, right) = (&left_features[found.left], &right_features[found.right]);
        align(&left_scales, left, &right_scales, right)
    };
    matches.iter().filter_map(pair).collect()
}
