//! Y4M (YUV4MPEG2): films without compression.
//!
//! - [`Reader`]: the frames of a film whose bytes are in memory, 8 bits for each number.
//! - [`Stream`]: the frames of a film that is read as it comes, from a file or a pipe, with 8 or 10
//!   bits for each number; [`Header`]: what its first line says.
//! - [`encode`](fn@encode) and [`write`](fn@write): films of 8 bits, of pictures in red, green and
//!   blue; [`Writer`]: films of 8 or 10 bits that are written as they come, of luma and colour
//!   differences or of such pictures, of which [`planes`](fn@planes) makes the former.
//!
//! The reader is our own: the crate `y4m` multiplies the sizes of the header without a check, and
//! does not read the range of the numbers.

mod encode;
mod header;
mod planes;
mod reader;
mod stream;
mod writer;

pub use encode::{encode, write};
pub use header::{Header, Interlacing};
pub use planes::{Siting, planes};
pub use reader::{Frame, Reader};
pub use stream::{MAX_LINE, MAX_SIDE, Number, Stream};
pub use writer::Writer;

pub(crate) use reader::decode_first;

use crate::ycbcr::YCbCr;

/// At how many places the colour differences are stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sampling {
    /// 4:2:0: one for each square of four pixels, in its middle.
    #[default]
    Quarter,
    /// 4:2:2: one for each two pixels of a row.
    Half,
    /// 4:4:4: one for each pixel.
    Full,
    /// None: the film is grey.
    Grey,
}

/// How a film is stored and played.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Film {
    /// Frames in a second, as numerator and denominator.
    pub frames_per_second: [u32; 2],
    /// Where colour differences are stored.
    pub sampling: Sampling,
    /// Weights and range of the colours. The file states the range, not the weights.
    pub colours: YCbCr,
    /// Width and height of a pixel: 1 and 1 for a square.
    pub pixel_aspect: [u32; 2],
}

impl Default for Film {
    /// 25 frames in a second, 4:2:0, BT.601, limited range, square pixels.
    fn default() -> Self {
        Self {
            frames_per_second: [25, 1],
            sampling: Sampling::default(),
            colours: YCbCr::default(),
            pixel_aspect: [1, 1],
        }
    }
}

impl Sampling {
    /// Columns and rows of the planes of colour differences in a film of this size. Halves round
    /// up.
    ///
    /// ```
    /// use ga_image::y4m::Sampling;
    ///
    /// assert_eq!(Sampling::Quarter.difference_size([5, 3]), [3, 2]);
    /// assert_eq!(Sampling::Half.difference_size([5, 3]), [3, 3]);
    /// ```
    #[must_use]
    pub fn difference_size(self, [width, height]: [usize; 2]) -> [usize; 2] {
        match self {
            Self::Quarter => [width.div_ceil(2), height.div_ceil(2)],
            Self::Half => [width.div_ceil(2), height],
            Self::Full => [width, height],
            Self::Grey => [0, 0],
        }
    }
}
