//! Films that are written while their pictures are made, so that few of them need be in memory.

use std::io::Write;

use ::png::{BitDepth, ColorType};

use crate::format_error::FormatError;
use crate::picture::PictureView;
use crate::plane::Plane;
use crate::png::{Animation, AnimationWriter};
use crate::{format, y4m};

/// A format of films.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// An animated PNG, which is played without end.
    Png,
    /// YUV4MPEG2: 8 bits, 4:2:0, BT.601, limited range.
    Y4m,
}

/// Frames in a second, as a quotient of whole numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rate {
    numerator: u16,
    denominator: u16,
}

impl Rate {
    /// 65535 frames in a second.
    pub const HIGHEST: Self = Self {
        numerator: u16::MAX,
        denominator: 1,
    };

    /// The quotient next to a number of frames in a second among the convergents of its continued
    /// fraction, with numbers of 16 bits, which is what PNG can store. `None` for a number that is
    /// not positive.
    ///
    /// ```
    /// use ga_image::film::Rate;
    ///
    /// let quotient = |rate| Rate::new(rate).map(Rate::quotient);
    /// assert_eq!(quotient(25.0), Some([25, 1]));
    /// assert_eq!(quotient(29.97), Some([2997, 100]));
    /// assert_eq!(quotient(30e3 / 1001.0), Some([30_000, 1001]));
    /// assert_eq!(quotient(0.0), None);
    /// ```
    #[must_use]
    pub fn new(frames_per_second: f64) -> Option<Self> {
        const MOST: f64 = u16::MAX as f64;
        let exact = frames_per_second;
        if exact.is_nan() || exact <= 0.0 {
            return None;
        }
        let exact = exact.clamp(1.0 / MOST, MOST);
        let mut earlier = [0.0, 1.0];
        let mut convergent = [1.0, 0.0];
        let mut rest = exact;
        loop {
            let whole = rest.floor();
            let next = [0, 1].map(|i| whole * convergent[i] + earlier[i]);
            if next.iter().any(|&number| number > MOST) {
                break;
            }
            (earlier, convergent) = (convergent, next);
            if (next[0] / next[1] - exact).abs() <= 1e-9 * exact {
                break;
            }
            rest = (rest - whole).recip();
        }
        let [numerator, denominator] = convergent.map(|number| number.clamp(1.0, MOST) as u16);
        Some(Self {
            numerator,
            denominator,
        })
    }

    /// Numerator and denominator.
    #[must_use]
    pub fn quotient(self) -> [u16; 2] {
        [self.numerator, self.denominator]
    }
}

/// A film of any [`Format`] that is written picture by picture.
///
/// ```
/// use ga_image::film::{Format, Rate, Writer};
/// use ga_image::plane::Plane;
///
/// let rate = Rate::new(30.0).ok_or("no rate")?;
/// for format in [Format::Png, Format::Y4m] {
///     let mut bytes = Vec::new();
///     let mut film = Writer::new(&mut bytes, format, [4, 2], 3, rate)?;
///     for frame in 0..3u8 {
///         film.write(&Plane::filled(4, 2, [80 * frame; 3]))?;
///     }
///     film.finish()?;
///     let first = ga_image::file::decode(&bytes)?;
///     assert_eq!([first.width(), first.height()], [4, 2]);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Writer<W: Write> {
    kind: Kind<W>,
    /// How many pictures are to come.
    remaining: usize,
    frames: usize,
}

enum Kind<W: Write> {
    Png(Box<AnimationWriter<W>>),
    Y4m(y4m::Writer<W>),
}

impl<W: Write> Writer<W> {
    /// Writes what stands before the first of `frames` pictures, all of this size.
    ///
    /// # Errors
    ///
    /// [`FormatError::Frames`] without frames or with more than the format counts,
    /// [`FormatError::Size`] where they have no pixels, and where the header cannot be written.
    pub fn new(
        writer: W,
        format: Format,
        size: [usize; 2],
        frames: usize,
        rate: Rate,
    ) -> Result<Self, FormatError> {
        let frames_per_second = rate.quotient();
        let kind = match format {
            _ if frames == 0 => return Err(frames_error(format, 0)),
            Format::Png => {
                let animation = Animation {
                    frames_per_second,
                    ..Animation::default()
                };
                let kind = (ColorType::Rgb, BitDepth::Eight);
                let writer = AnimationWriter::new(writer, size, kind, frames, animation)?;
                Kind::Png(Box::new(writer))
            }
            Format::Y4m => {
                let film = y4m::Film {
                    frames_per_second: frames_per_second.map(u32::from),
                    ..y4m::Film::default()
                };
                Kind::Y4m(y4m::Writer::new(writer, size, 8, film)?)
            }
        };
        Ok(Self {
            kind,
            remaining: frames,
            frames,
        })
    }

    /// Writes the next picture.
    ///
    /// # Errors
    ///
    /// [`FormatError::FrameSize`] for a picture of another size, [`FormatError::Frames`] for one
    /// more than was said, and where it cannot be written.
    pub fn write(&mut self, picture: &Plane<[u8; 3]>) -> Result<(), FormatError> {
        let remaining = self.remaining.checked_sub(1);
        self.remaining = remaining.ok_or_else(|| frames_error(self.format(), self.frames + 1))?;
        match &mut self.kind {
            Kind::Png(writer) => writer.write(&PictureView::from(picture)),
            Kind::Y4m(writer) => writer.write_rgb(picture),
        }
    }

    /// Ends the film.
    ///
    /// # Errors
    ///
    /// [`FormatError::Frames`] where pictures are missing, and where the end cannot be written.
    pub fn finish(self) -> Result<(), FormatError> {
        if self.remaining > 0 {
            return Err(frames_error(self.format(), self.frames - self.remaining));
        }
        match self.kind {
            Kind::Png(writer) => writer.finish(),
            Kind::Y4m(_) => Ok(()),
        }
    }

    fn format(&self) -> Format {
        match self.kind {
            Kind::Png(_) => Format::Png,
            Kind::Y4m(_) => Format::Y4m,
        }
    }
}

fn frames_error(film: Format, frames: usize) -> FormatError {
    let format = match film {
        Format::Png => format::Format::Png,
        Format::Y4m => format::Format::Y4m,
    };
    FormatError::Frames { format, frames }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use super::*;

    #[test]
    fn rates_are_the_nearest_quotients() {
        let quotient = |rate| Rate::new(rate).unwrap().quotient();
        assert_eq!(quotient(1000.0), [1000, 1]);
        assert_eq!(quotient(0.5), [1, 2]);
        assert_eq!(quotient(24e3 / 1001.0), [24_000, 1001]);
        // The frame time of 0.0083333 s of motion capture at 120 frames in a second.
        assert_eq!(quotient(1.0 / 0.008_333_3), [120, 1]);
        assert_eq!(quotient(1e9), [u16::MAX, 1]);
        assert_eq!(quotient(1e-9), [1, u16::MAX]);
        for wrong in [-1.0, 0.0, f64::NAN] {
            assert_eq!(Rate::new(wrong), None);
        }
    }

    #[test]
    fn a_film_has_as_many_pictures_as_was_said() {
        let rate = Rate::new(25.0).unwrap();
        let picture = Plane::filled(2, 2, [9; 3]);
        for format in [Format::Png, Format::Y4m] {
            let writer = |frames| Writer::new(Vec::new(), format, [2, 2], frames, rate);
            assert!(matches!(
                writer(0),
                Err(FormatError::Frames { frames: 0, .. })
            ));
            let mut film = writer(1).unwrap();
            film.write(&picture).unwrap();
            let more = film.write(&picture);
            assert!(matches!(more, Err(FormatError::Frames { frames: 2, .. })));
            let mut film = writer(3).unwrap();
            film.write(&picture).unwrap();
            assert!(matches!(
                film.finish(),
                Err(FormatError::Frames { frames: 1, .. })
            ));
            let mut film = writer(1).unwrap();
            let wide = film.write(&Plane::filled(3, 2, [9; 3]));
            assert!(matches!(wide, Err(FormatError::FrameSize { frame: 0, .. })));
        }
    }
}
