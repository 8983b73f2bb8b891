//! Reading a film whose bytes are in memory.

use super::header::{Header, parse, syntax};
use super::{Film, Sampling};
use crate::format::Format;
use crate::format_error::FormatError;
use crate::picture::Picture;
use crate::plane::{Plane, PlaneView};
use crate::size::check_claim;
use crate::ycbcr::YCbCr;

/// The frames of a film of 8 bits, one after another, borrowed from the bytes of its file. For
/// films of 10 bits, and for those larger than memory, see [`Stream`](super::Stream).
#[derive(Clone, Debug)]
pub struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
    size: [usize; 2],
    film: Film,
}

/// One frame of a film.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// Luma.
    pub luma: PlaneView<'a, u8>,
    /// The colour differences Cb and Cr, as wide and high as the sampling says; without pixels in a
    /// grey film.
    pub differences: [PlaneView<'a, u8>; 2],
}

impl<'a> Reader<'a> {
    /// Reads the header.
    ///
    /// # Errors
    ///
    /// [`FormatError::Syntax`] when it is wrong, [`FormatError::Claim`] when the file is too short
    /// for one frame, [`FormatError::Unsupported`] for other samplings than those of [`Sampling`]
    /// and for other depths than 8 bits.
    pub fn new(bytes: &'a [u8]) -> Result<Self, FormatError> {
        let Some(end) = bytes.iter().position(|byte| *byte == b'\n') else {
            return Err(syntax(0, "the first line does not end"));
        };
        let header = parse(&bytes[..end])?;
        if header.bit_depth != 8 {
            return Err(FormatError::Unsupported {
                format: Format::Y4m,
                what: format!("a depth of {} bits", header.bit_depth),
            });
        }
        let Header { size, film, .. } = header;
        check_claim(Format::Y4m, size, bytes.len(), 1.0)?;
        Ok(Self {
            bytes,
            at: end + 1,
            size,
            film,
        })
    }

    /// Columns.
    #[must_use]
    pub fn width(&self) -> usize {
        self.size[0]
    }

    /// Rows.
    #[must_use]
    pub fn height(&self) -> usize {
        self.size[1]
    }

    /// What the header says. It does not say the weights of luma; BT.601 stands there.
    #[must_use]
    pub fn film(&self) -> Film {
        self.film
    }

    fn frame(&mut self) -> Result<Frame<'a>, FormatError> {
        let start = self.at;
        let rest = &self.bytes[start..];
        let line = rest.iter().position(|byte| *byte == b'\n');
        let Some(line) = line.filter(|_| rest.starts_with(b"FRAME")) else {
            return Err(syntax(start, "a line FRAME is expected"));
        };
        self.at += line + 1;
        let differences = self.film.sampling.difference_size(self.size);
        Ok(Frame {
            luma: self.plane(self.size)?,
            differences: [self.plane(differences)?, self.plane(differences)?],
        })
    }

    fn plane(&mut self, [width, height]: [usize; 2]) -> Result<PlaneView<'a, u8>, FormatError> {
        // The first plane fits into the file, so this does not overflow.
        let length = width * height;
        let plane = PlaneView::new(&self.bytes[self.at..], width, height, width);
        self.at += length;
        plane.map_err(|_| syntax(self.bytes.len(), "the film ends within a frame"))
    }
}

impl<'a> Iterator for Reader<'a> {
    type Item = Result<Frame<'a>, FormatError>;

    fn next(&mut self) -> Option<Self::Item> {
        (self.at < self.bytes.len()).then(|| {
            self.frame().inspect_err(|_| {
                // What follows an error is not looked at.
                self.at = self.bytes.len();
            })
        })
    }
}

impl Frame<'_> {
    /// The frame in red, green and blue. Each pixel takes the stored colour differences of the
    /// square or pair to which it belongs, without interpolation.
    #[must_use]
    pub fn to_rgb(&self, colours: YCbCr) -> Plane<[u8; 3]> {
        let [cb, cr] = self.differences;
        // 1 or 2 pixels for each stored number.
        let across = self.luma.width().div_ceil(cb.width().max(1));
        let down = self.luma.height().div_ceil(cb.height().max(1));
        let difference = |plane: PlaneView<'_, u8>, column, row| {
            plane.get(column / across, row / down).unwrap_or(128)
        };
        Plane::from_fn(self.luma.width(), self.luma.height(), |column, row| {
            colours.to_rgb([
                self.luma.row(row)[column],
                difference(cb, column, row),
                difference(cr, column, row),
            ])
        })
    }
}

/// The first frame as a picture: in grey where the film is grey.
pub(crate) fn decode_first(bytes: &[u8]) -> Result<Picture, FormatError> {
    let mut reader = Reader::new(bytes)?;
    let film = reader.film();
    let frame = reader
        .next()
        .unwrap_or_else(|| Err(syntax(bytes.len(), "the film has no frames")))?;
    Ok(match film.sampling {
        Sampling::Grey => frame.luma.to_plane().into(),
        _ => frame.to_rgb(film.colours).into(),
    })
}
