//! Dots of one colour.

use ga_image::colour::SrgbEncoder;
use ga_image::plane::PlaneView;
use ga_runtime::vga3::Vector;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

use super::blob::{Shade, blobs, is_coloured};
use super::code::{BRIGHTNESS, hue, light};
use super::linear;

/// The hue of a dot: one of the three primary and the three secondary colours of additive mixing,
/// 60° from each other. In coloured light, or where paint is not quite pure, a hue is still nearer
/// to its own than to others.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Hue {
    /// 0°.
    Red,
    /// 60°.
    Yellow,
    /// 120°.
    Green,
    /// 180°.
    Cyan,
    /// 240°.
    Blue,
    /// 300°.
    Magenta,
}

impl Hue {
    /// All hues, by their angles.
    pub const ALL: [Self; 6] = [
        Self::Red,
        Self::Yellow,
        Self::Green,
        Self::Cyan,
        Self::Blue,
        Self::Magenta,
    ];

    /// The 8-bit sRGB colour with which it is painted.
    #[must_use]
    pub fn colour(self) -> [u8; 3] {
        let light = light(60.0 * f64::from(self as u8));
        SrgbEncoder::new().encode(light.map(|channel| BRIGHTNESS * channel).into())
    }

    /// The nearest hue of some linear light; `None` where it is grey.
    fn of_light(light: [f64; 3]) -> Option<Self> {
        let number = (hue(light)? / 60.0).round() as usize % Self::ALL.len();
        Some(Self::ALL[number])
    }

    /// Hues for dots at these places: at random, but for those of the nearest three dots that have
    /// one already. So every group of neighbours has a sequence of hues of its own. Equal seeds
    /// give equal hues.
    ///
    /// ```
    /// use ga_body::marker::Hue;
    ///
    /// let row: Vec<[f64; 3]> = (0..20).map(|k| [0.05 * f64::from(k), 0.0, 0.0]).collect();
    /// let hues = Hue::scattered(&row, 1);
    /// assert!(hues.windows(2).all(|pair| pair[0] != pair[1]));
    /// ```
    #[must_use]
    pub fn scattered(places: &[[f64; 3]], seed: u64) -> Vec<Self> {
        /// The number of neighbours that have other hues.
        const NEIGHBOURS: usize = 3;
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut hues: Vec<Self> = Vec::with_capacity(places.len());
        for place in places {
            let place = Vector::from(*place);
            let mut before: Vec<(f64, Self)> = places
                .iter()
                .zip(&hues)
                .map(|(other, hue)| (place.distance(Vector::from(*other)), *hue))
                .collect();
            before.sort_by(|a, b| a.0.total_cmp(&b.0));
            before.truncate(NEIGHBOURS);
            let is_free = |hue: &Self| before.iter().all(|(_, other)| other != hue);
            let free: Vec<Self> = Self::ALL.into_iter().filter(is_free).collect();
            // There are more hues than neighbours; 2³² is so large that the rest does not matter.
            hues.push(free[random.next_u32() as usize % free.len()]);
        }
        hues
    }
}

/// A dot in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dot {
    /// Its hue.
    pub hue: Hue,
    /// The centre of its outline, in pixels that count from the centre of the top left one.
    pub centre: [f64; 2],
    /// The semi-axes of its outline in pixels, the greater one first.
    pub semi_axes: [f64; 2],
}

/// Which coloured spots are dots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DotOptions {
    /// The least saturation, chroma divided by the greatest channel, of the pixels of a dot.
    pub least_saturation: f64,
    /// The least smaller semi-axis in pixels.
    pub least_semi_axis: f64,
    /// The greatest greater semi-axis in pixels.
    pub greatest_semi_axis: f64,
    /// The greatest mean distance of the outline from an ellipse in pixels: dots that something
    /// hides in part have another outline.
    pub outline_tolerance: f64,
}

impl Default for DotOptions {
    /// Saturation 0.4, semi-axes from 0.8 to 60 px, outline to 0.3 px.
    fn default() -> Self {
        Self {
            least_saturation: 0.4,
            least_semi_axis: 0.8,
            greatest_semi_axis: 60.0,
            outline_tolerance: 0.3,
        }
    }
}

/// The dots in a picture in 8-bit sRGB, from top to bottom.
///
/// A dot is a disc of one [`Hue`] on something grey. Pixels of the hue that touch are one spot. The
/// part α of a pixel that it covers is its chroma divided by that of covered pixels, which may
/// change linearly over the dot, as light does on a limb. The centre is the mean of the pixels with
/// the weights α, so that blur does not move it (see [the module](super) for the ellipse).
///
/// A dot of 3 px in radius is found to a few hundredths of a pixel.
///
/// ```
/// use ga_image::colour::{LinearColour, SrgbEncoder};
/// use ga_image::plane::Plane;
/// use ga_body::marker::{DotOptions, Hue, find_dots};
///
/// let [green, grey] = [Hue::Green.colour(), [90; 3]].map(LinearColour::from_srgb);
/// let encoder = SrgbEncoder::new();
/// // Pixels on the rim have a part of the light of either side.
/// let picture = Plane::from_fn(40, 30, |column, row| {
///     let distance = (column as f64 - 20.3).hypot(row as f64 - 12.6);
///     encoder.encode(grey.lerp(green, (3.0 + 0.5 - distance).clamp(0.0, 1.0)))
/// });
/// let found = find_dots(picture.view(), &DotOptions::default());
/// assert_eq!((found.len(), found[0].hue), (1, Hue::Green));
/// assert!((found[0].centre[0] - 20.3).hypot(found[0].centre[1] - 12.6) < 0.03);
/// ```
#[must_use]
pub fn find_dots(picture: PlaneView<'_, [u8; 3]>, options: &DotOptions) -> Vec<Dot> {
    let light = linear(picture);
    let least = options.least_saturation as f32;
    let classes = light.map(|light| {
        if !is_coloured(light, least) {
            return 0;
        }
        Hue::of_light(light.map(f64::from)).map_or(0, |hue| hue as u8 + 1)
    });
    let spots = blobs(&light, &classes, Shade::Inclined);
    let dots = spots.iter().filter_map(|spot| {
        let ellipse = spot.ellipse()?;
        let [greater, smaller] = ellipse.semi_axes;
        let is_dot = smaller >= options.least_semi_axis
            && greater <= options.greatest_semi_axis
            && spot.outline_error(&ellipse) <= options.outline_tolerance;
        let hue = Hue::of_light(spot.mean_light(&light))?;
        is_dot.then_some(Dot {
            hue,
            centre: ellipse.centre,
            semi_axes: ellipse.semi_axes,
        })
    });
    dots.collect()
}
