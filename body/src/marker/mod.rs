//! Painted markers: discs of two colours that say which point of a scene they are, and smaller dots
//! of one colour ([`find_dots`]) that say it together with their neighbours.
//!
//! A marker is a disc of one saturated colour inside a ring of another, on something grey. The two
//! colours are its [`Code`], so that each marker is known by itself, from any side, in any picture.
//!
//! # How markers are found
//!
//! With linear light, the *chroma* of a pixel is the greatest of its channels less the least one.
//! Grey has none. A pixel of which the marker covers the part α has the light
//! `α m + (1 − α) g`, and since grey g adds the same to all channels, the chroma `α chroma(m)`:
//! it measures how much of a pixel is covered, whatever the brightness of what lies behind.
//!
//! Connected pixels of enough chroma are a candidate. Its centre and its axes are those of the
//! ellipse with the same moments, with α as the weight of a pixel:
//!
//! ```text
//! c = Σ α x / Σ α,   C = Σ α (x − c)(x − c)ᵀ / Σ α − b I,   semi-axes 2 √eigenvalues of C
//! ```
//!
//! b is what the extent of a pixel, 1/12, and blur add to the moments; with it the area of the
//! ellipse is Σ α. A candidate is not a marker where its outline is not that ellipse, as
//! where something hides it in part, or where the ellipse is too thin. The colours are those in the
//! middle of the inner disc and in the outer half of the ring, where no other hue is near: grey
//! beyond the outline does not change a hue.
//!
//! The centre of the ellipse is not exactly the image of the centre of the disc. For a disc of
//! radius r at the distance d, inclined by β, it is off by about `f r² sin β cos β / d²` pixels:
//! with f = 1000 px less than 0.02 px for r = 2 cm and d = 4 m.
//!
//! ```
//! use ga_image::colour::{LinearColour, SrgbEncoder};
//! use ga_image::plane::Plane;
//! use ga_body::marker::{Code, FindOptions, find};
//!
//! let code = Code::new(17).ok_or("no such code")?;
//! let [inner, ring] = code.colours();
//! let [inner, ring, grey] = [inner, ring, [90; 3]].map(LinearColour::from_srgb);
//! let encoder = SrgbEncoder::new();
//! // Pixels on a rim have a part of the light of either side.
//! let picture = Plane::from_fn(60, 40, |column, row| {
//!     let distance = (column as f64 - 31.0).hypot(row as f64 - 18.0);
//!     let part = |radius: f64| (radius + 0.5 - distance).clamp(0.0, 1.0);
//!     encoder.encode(grey.lerp(ring, part(8.0)).lerp(inner, part(4.4)))
//! });
//! let found = find(picture.view(), &FindOptions::default());
//! assert_eq!(found.len(), 1);
//! assert_eq!(found[0].code, code);
//! assert!((found[0].centre[0] - 31.0).hypot(found[0].centre[1] - 18.0) < 0.02);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod blob;
mod code;
mod dot;

use ga_image::colour::LinearColour;
use ga_image::plane::{Plane, PlaneView};

pub use code::Code;
pub use dot::{Dot, DotOptions, Hue, find_dots};

use blob::{Blob, Shade, blobs, is_coloured};

/// The radius of the inner disc as a part of the marker's.
pub const INNER: f64 = 0.55;

/// A marker in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundMarker {
    /// Which marker it is.
    pub code: Code,
    /// The centre of its outline, in pixels that count from the centre of the top left one.
    pub centre: [f64; 2],
    /// The semi-axes of its outline in pixels, the greater one first.
    pub semi_axes: [f64; 2],
}

/// Which candidates are markers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FindOptions {
    /// The least saturation, chroma divided by the greatest channel, of the pixels of a candidate.
    pub least_saturation: f64,
    /// The least smaller semi-axis in pixels.
    pub least_semi_axis: f64,
    /// The least quotient of the smaller and the greater semi-axis. On a limb, the rim of a disc
    /// that is seen more from the side is hidden by the limb.
    pub least_quotient: f64,
    /// The greatest mean distance of the outline from the ellipse in pixels.
    pub outline_tolerance: f64,
}

impl Default for FindOptions {
    /// Saturation 0.4, semi-axes of 1.8 px with a quotient of 0.5, outline to 0.15 px.
    fn default() -> Self {
        Self {
            least_saturation: 0.4,
            least_semi_axis: 1.8,
            least_quotient: 0.5,
            outline_tolerance: 0.15,
        }
    }
}

/// The markers in a picture in 8-bit sRGB, in the order of their codes. A code that is found at
/// several places is left out, since one of them is not what it seems.
#[must_use]
pub fn find(picture: PlaneView<'_, [u8; 3]>, options: &FindOptions) -> Vec<FoundMarker> {
    let light = linear(picture);
    let least = options.least_saturation as f32;
    let classes = light.map(|light| u8::from(is_coloured(light, least)));
    let candidates = blobs(&light, &classes, Shade::Even);
    let found = candidates
        .iter()
        .filter_map(|blob| marker(&light, blob, options));
    let mut found: Vec<FoundMarker> = found.collect();
    found.sort_by_key(|marker| marker.code);
    let codes: Vec<Code> = found.iter().map(|marker| marker.code).collect();
    let is_alone = |code: Code| codes.iter().filter(|other| **other == code).count() == 1;
    found.retain(|marker| is_alone(marker.code));
    found
}

/// The linear light of a picture in 8-bit sRGB.
fn linear(picture: PlaneView<'_, [u8; 3]>) -> Plane<[f32; 3]> {
    let table: Vec<f32> = (0..=255)
        .map(|code| LinearColour::from_srgb([code; 3]).red as f32)
        .collect();
    picture.map(|colour| colour.map(|c| table[usize::from(c)]))
}

/// The marker that a candidate is.
fn marker(light: &Plane<[f32; 3]>, blob: &Blob, options: &FindOptions) -> Option<FoundMarker> {
    let ellipse = blob.ellipse()?;
    let [greater, smaller] = ellipse.semi_axes;
    let is_marker = smaller >= options.least_semi_axis
        && smaller >= options.least_quotient * greater
        && blob.outline_error(&ellipse) <= options.outline_tolerance;
    if !is_marker {
        return None;
    }
    // The light of pixels by their distance from the centre, 1 at the outline; where no pixel is in
    // the range, of the one nearest to its middle.
    let sum = |range: [f64; 2]| {
        let at = |pixel: &[usize; 2]| ellipse.radius(pixel.map(|c| c as f64));
        let middle = 0.5 * (range[0] + range[1]);
        let inside = blob
            .pixels
            .iter()
            .filter(|pixel| (range[0]..range[1]).contains(&at(pixel)));
        let mut chosen: Vec<[usize; 2]> = inside.copied().collect();
        if chosen.is_empty() {
            let nearest = blob.pixels.iter().min_by(|a, b| {
                let distance = |pixel: &[usize; 2]| (at(pixel) - middle).abs();
                distance(a).total_cmp(&distance(b))
            });
            chosen.extend(nearest);
        }
        let mut sum = [0.0; 3];
        for [column, row] in chosen {
            let colour = light.row(row)[column];
            for (sum, channel) in sum.iter_mut().zip(colour) {
                *sum += f64::from(channel);
            }
        }
        sum
    };
    let inner = sum([0.0, 0.5 * INNER]);
    let ring = sum([0.5 * (1.0 + INNER), 1.0]);
    Some(FoundMarker {
        code: Code::of_light(inner, ring)?,
        centre: ellipse.centre,
        semi_axes: ellipse.semi_axes,
    })
}
