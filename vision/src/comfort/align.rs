//! The measured differences of the right view, applied backwards.

use ga_image::plane::{Plane, SizeError};
use ga_image::warp::Warp;
use ga_image::ycbcr::YCbCr;

use super::stereoscopy::Alignment;
use super::{FrameMeasures, FrameMeter, Photometry};
use crate::video::{Frame, Planes, Samples};

/// How the colours of the right view are changed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ColourCorrection {
    /// They stay as they are.
    None,
    /// These codes are subtracted from red, green and blue.
    Offsets([f64; 3]),
    /// Red, green and blue are divided by these.
    Ratios([f64; 3]),
}

impl ColourCorrection {
    fn apply(self, rgb: [u8; 3]) -> [u8; 3] {
        let codes = rgb.map(f64::from);
        let changed: [f64; 3] = match self {
            Self::None => return rgb,
            Self::Offsets(offsets) => std::array::from_fn(|k| codes[k] - offsets[k]),
            Self::Ratios(ratios) => std::array::from_fn(|k| codes[k] / ratios[k]),
        };
        // A cast from float saturates.
        changed.map(|code| code.round() as u8)
    }
}

/// Removes what is measured between the views, frame by frame: vertical shift, rotation and size,
/// then brightness and colour. Frames in which it cannot be measured are treated as the frame
/// before them. Parallax and sharpness stay as they are.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::ycbcr::YCbCr;
/// use ga_vision::comfort::FrameMeasures;
/// use ga_vision::comfort::align::{Aligner, encoded};
/// use ga_vision::video::{Frame, Planes, Samples};
///
/// // Random blocks; the right view is 3 pixels lower, and brighter.
/// let grey = |u: usize, v: usize| {
///     let block = (u / 7 + 1) * 7919 + (v / 7 + 1) * 104_729;
///     (40 + block * block / 977 % 150) as u8
/// };
/// let view = |v: usize, brighter: u8| {
///     let luma = Plane::from_fn(480, 270, |column, row| grey(column, row + v) + brighter);
///     let samples = Samples::Eight(Planes { luma, ..Planes::default() });
///     Frame { samples, ..Frame::default() }
/// };
/// let (left, right) = (view(3, 0), view(0, 20));
/// let colours = YCbCr::default();
/// let mut aligner = Aligner::new([480, 270], colours);
/// let right = encoded(&aligner.align(&left, &right)?, colours);
/// let found = FrameMeasures::of(&left.samples, &right, colours)?;
/// assert!(found.geometry.unwrap().shift_px.abs() < 0.1);
/// assert!(found.photometry.unwrap().offset_codes.abs() < 1.0);
/// # Ok::<(), ga_image::plane::SizeError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Aligner {
    meter: FrameMeter,
    colours: YCbCr,
    size: [usize; 2],
    alignment: Alignment,
    correction: ColourCorrection,
}

impl Aligner {
    /// For views of so many columns and rows, in this encoding of colours.
    #[must_use]
    pub fn new(size: [usize; 2], colours: YCbCr) -> Self {
        Self {
            meter: FrameMeter::new(size, colours),
            colours,
            size,
            alignment: Alignment::default(),
            correction: ColourCorrection::None,
        }
    }

    /// The right view as it fits the left one.
    ///
    /// # Errors
    ///
    /// [`SizeError::Differs`] when a view has another size than the aligner.
    pub fn align(&mut self, left: &Frame, right: &Frame) -> Result<Plane<[u8; 3]>, SizeError> {
        let measures = self.meter.measure(&left.samples, &right.samples)?;
        if let Some(geometry) = &measures.geometry {
            self.alignment = geometry.into();
        }
        let photometry = measures.photometry;
        let moved = self.moved(&right.to_rgb(self.colours))?;
        if let Some(photometry) = photometry {
            self.correction = self.best(left, &moved, &photometry)?;
        }
        Ok(moved.map(|rgb| self.correction.apply(rgb)))
    }

    /// The correction after which brightness and colour differ least. Whether a view is brighter by
    /// an offset or by a factor is seen when either is undone.
    fn best(
        &mut self,
        left: &Frame,
        right: &Plane<[u8; 3]>,
        photometry: &Photometry,
    ) -> Result<ColourCorrection, SizeError> {
        let mut best = (f64::INFINITY, ColourCorrection::None);
        for correction in [
            ColourCorrection::None,
            ColourCorrection::Offsets(photometry.channel_offsets),
            ColourCorrection::Ratios(photometry.channel_ratios),
        ] {
            let corrected = right.map(|rgb| correction.apply(rgb));
            let samples = encoded(&corrected, self.colours);
            let measures = self.meter.measure(&left.samples, &samples)?;
            let difference = difference(measures);
            if difference < best.0 {
                best = (difference, correction);
            }
        }
        Ok(best.1)
    }

    /// The right view without vertical shift, rotation and difference of size.
    fn moved(&self, right: &Plane<[u8; 3]>) -> Result<Plane<[u8; 3]>, SizeError> {
        let Alignment {
            shift_px,
            rotation_degrees,
            zoom_percent,
        } = self.alignment;
        let (sine, cosine) = rotation_degrees.to_radians().sin_cos();
        let zoom = 1.0 + 0.01 * zoom_percent;
        let sides = self.size.map(|side| side as f64);
        let warp = Warp::new(self.size, self.size, |[x, y]| {
            let (x, y) = (x - 0.5 * sides[0], y - 0.5 * sides[1]);
            let place = [
                0.5 * sides[0] + zoom * (x * cosine + y * sine),
                0.5 * sides[1] + zoom * (y * cosine - x * sine) + shift_px,
            ];
            // The border continues outside.
            Some([place[0].clamp(0.0, sides[0]), place[1].clamp(0.0, sides[1])])
        });
        warp.warped(right, [0; 3])
    }
}

/// How much brightness and colour differ, in multiples of what is comfortable.
fn difference(measures: &FrameMeasures) -> f64 {
    measures.photometry.map_or(f64::INFINITY, |found| {
        found.luminance_percent / 20.0 + found.colour_difference / 3.0
    })
}

/// A picture as luma and colour differences for each pixel.
#[must_use]
pub fn encoded(picture: &Plane<[u8; 3]>, colours: YCbCr) -> Samples {
    let encoded = picture.map(|rgb| colours.from_rgb(rgb));
    let plane = |channel: usize| encoded.map(|colour| colour[channel]);
    Samples::Eight(Planes {
        luma: plane(0),
        differences: [plane(1), plane(2)],
    })
}
