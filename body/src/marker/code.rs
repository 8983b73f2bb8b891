//! The colours of markers.

use ga_image::colour::SrgbEncoder;

/// How many hues there are, 36° from each other.
const HUES: usize = 10;
/// For each inner hue, the hues of the ring that differ from it by 72° or more.
const RINGS: usize = HUES - 3;
/// The linear light of the brightest channel: less than white, so that light which is brighter than
/// white does not change the hue.
pub(super) const BRIGHTNESS: f64 = 0.6;
/// The greatest distance from a hue in degrees; there are 36 between two.
const TOLERANCE_DEGREES: f64 = 15.0;

/// The colours of a marker as a number, from 0 to 69: the hue of the inner disc and another one of
/// the ring, of ten hues that are 36° from each other in linear light. Both differ by 72° or more,
/// since pixels on the edge between them have the hues between.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Code(u8);

impl Code {
    /// How many codes there are.
    pub const COUNT: usize = HUES * RINGS;

    /// The code of a number; `None` from [`COUNT`](Self::COUNT) on.
    #[must_use]
    pub fn new(number: usize) -> Option<Self> {
        let number = u8::try_from(number).ok()?;
        (usize::from(number) < Self::COUNT).then_some(Self(number))
    }

    /// The number.
    #[must_use]
    pub fn number(self) -> usize {
        usize::from(self.0)
    }

    /// The 8-bit sRGB colours of the inner disc and of the ring.
    #[must_use]
    pub fn colours(self) -> [[u8; 3]; 2] {
        let encoder = SrgbEncoder::new();
        self.hues().map(|hue| {
            let light = light(360.0 * hue as f64 / HUES as f64);
            encoder.encode(light.map(|channel| BRIGHTNESS * channel).into())
        })
    }

    fn hues(self) -> [usize; 2] {
        let (inner, step) = (self.number() / RINGS, self.number() % RINGS);
        [inner, (inner + step + 2) % HUES]
    }

    /// The code with the hues of the linear light of the inner disc and of the ring; `None` where a
    /// hue is between those of codes.
    pub(super) fn of_light(inner: [f64; 3], ring: [f64; 3]) -> Option<Self> {
        let [inner, ring] = [nearest(inner)?, nearest(ring)?];
        let step = (ring + HUES - inner) % HUES;
        (2..HUES - 1)
            .contains(&step)
            .then(|| Self((inner * RINGS + step - 2) as u8))
    }
}

/// The number of the hue of some light; `None` where it is between two or where the light is grey.
fn nearest(light: [f64; 3]) -> Option<usize> {
    let hue = hue(light)?;
    let step = 360.0 / HUES as f64;
    let number = (hue / step).round();
    ((hue - number * step).abs() <= TOLERANCE_DEGREES).then_some(number as usize % HUES)
}

/// The hue of linear light in degrees from 0 to 360: 0 is red, 120 green and 240 blue, and between
/// them the middle channel is linear (A. R. Smith, Color gamut transform pairs, SIGGRAPH 1978).
pub(super) fn hue([red, green, blue]: [f64; 3]) -> Option<f64> {
    let most = red.max(green).max(blue);
    let chroma = most - red.min(green).min(blue);
    let sixths = if most == red {
        ((green - blue) / chroma).rem_euclid(6.0)
    } else if most == green {
        (blue - red) / chroma + 2.0
    } else {
        (red - green) / chroma + 4.0
    };
    (chroma > 0.0).then_some(60.0 * sixths)
}

/// The saturated light of a hue in degrees, with the greatest channel 1.
pub(super) fn light(hue: f64) -> [f64; 3] {
    [0.0, 120.0, 240.0].map(|primary: f64| {
        let between = (hue - primary).rem_euclid(360.0);
        let distance = between.min(360.0 - between);
        (2.0 - distance / 60.0).clamp(0.0, 1.0)
    })
}
