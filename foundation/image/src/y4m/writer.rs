//! Writing a film as it comes.

use std::io::Write;

use super::planes::{Siting, planes};
use super::{Film, Number, Sampling};
use crate::format::Format;
use crate::format_error::FormatError;
use crate::plane::Plane;
use crate::size::size_for;
use crate::ycbcr::Range;

/// A film that is written frame by frame, of planes as they are stored, with 8 or 10 bits, or of
/// pictures in red, green and blue: the counterpart of [`Stream`](super::Stream).
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::y4m::{Film, Stream, Writer};
///
/// let (luma, difference) = (Plane::filled(5, 3, 700_u16), Plane::filled(3, 2, 512_u16));
/// let mut bytes = Vec::new();
/// let mut writer = Writer::new(&mut bytes, [5, 3], 10, Film::default())?;
/// writer.write([&luma, &difference, &difference])?;
/// assert!(bytes.starts_with(b"YUV4MPEG2 W5 H3 F25:1 Ip A1:1 C420p10 XCOLORRANGE=LIMITED\n"));
///
/// let mut stream = Stream::new(&bytes[..])?;
/// let [mut first, mut cb, mut cr] = [(); 3].map(|()| Plane::<u16>::default());
/// assert!(stream.read([&mut first, &mut cb, &mut cr])?);
/// assert_eq!(first, luma);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Writer<W> {
    writer: W,
    size: [usize; 2],
    bit_depth: u32,
    film: Film,
    /// The number of the next frame.
    frame: usize,
    bytes: Vec<u8>,
}

impl<W: Write> Writer<W> {
    /// Writes the first line, for frames of this size with numbers of 8 or 10 bits.
    ///
    /// # Errors
    ///
    /// [`FormatError::Size`] for frames without pixels, [`FormatError::Kind`] for other depths.
    pub fn new(
        writer: W,
        size: [usize; 2],
        bit_depth: u32,
        film: Film,
    ) -> Result<Self, FormatError> {
        size_for(Format::Y4m, size)?;
        if ![8, 10].contains(&bit_depth) {
            return Err(depth_error());
        }
        let mut film = Self {
            writer,
            size,
            bit_depth,
            film,
            frame: 0,
            bytes: header(size, bit_depth, film).into_bytes(),
        };
        film.send()?;
        Ok(film)
    }

    /// Writes a frame of luma, Cb and Cr, the latter two as wide and high as the sampling of the
    /// film says.
    ///
    /// # Errors
    ///
    /// [`FormatError::FrameSize`] and [`FormatError::Kind`] where the planes have another size or
    /// depth than those of the film; nothing is written then.
    pub fn write<T: Number>(&mut self, planes: [&Plane<T>; 3]) -> Result<(), FormatError> {
        if T::BIT_DEPTH != self.bit_depth {
            return Err(depth_error());
        }
        let differences = self.film.sampling.difference_size(self.size);
        for (plane, expected) in planes
            .into_iter()
            .zip([self.size, differences, differences])
        {
            let size = [plane.width(), plane.height()];
            if size != expected {
                return Err(FormatError::FrameSize {
                    frame: self.frame,
                    size,
                    first: expected,
                });
            }
        }
        self.bytes.clear();
        self.bytes.extend(b"FRAME\n");
        for plane in planes {
            T::append(plane.values(), &mut self.bytes);
        }
        self.send()?;
        self.frame += 1;
        Ok(())
    }

    /// Writes a picture as a frame of a film with 8 bits.
    ///
    /// # Errors
    ///
    /// As [`write`](Self::write).
    pub fn write_rgb(&mut self, picture: &Plane<[u8; 3]>) -> Result<(), FormatError> {
        let Film {
            sampling, colours, ..
        } = self.film;
        let planes = planes(picture, sampling, Siting::Centre, colours);
        self.write(planes.each_ref())
    }

    fn send(&mut self) -> Result<(), FormatError> {
        let frame = self.frame;
        let written = self.writer.write_all(&self.bytes);
        written.map_err(|source| FormatError::Write { frame, source })
    }
}

fn depth_error() -> FormatError {
    FormatError::Kind {
        format: Format::Y4m,
        kind: "numbers of this depth",
    }
}

/// The first line of a film with numbers of this depth, with its end.
fn header([width, height]: [usize; 2], bit_depth: u32, film: Film) -> String {
    let sampling = match (film.sampling, bit_depth) {
        // "jpeg" says that the differences lie in the middle of the square.
        (Sampling::Quarter, 8) => "420jpeg",
        (Sampling::Half, 8) => "422",
        (Sampling::Full, 8) => "444",
        (Sampling::Grey, 8) => "mono",
        (Sampling::Quarter, _) => "420p10",
        (Sampling::Half, _) => "422p10",
        (Sampling::Full, _) => "444p10",
        (Sampling::Grey, _) => "mono10",
    };
    let range = match film.colours.range {
        Range::Limited => "LIMITED",
        Range::Full => "FULL",
    };
    let [numerator, denominator] = film.frames_per_second;
    let [across, down] = film.pixel_aspect;
    format!(
        "YUV4MPEG2 W{width} H{height} F{numerator}:{denominator} Ip A{across}:{down} C{sampling} \
         XCOLORRANGE={range}\n"
    )
}
