//! Y4M (YUV4MPEG2): films without compression, 8 bits for each channel.
//!
//! The reader is our own: the crate `y4m` multiplies the sizes of the header without a check, and
//! does not read the range of the numbers.

use std::borrow::Borrow;
use std::path::Path;

use crate::file::{DecodeError, EncodeError, Format, SaveError, check_claim, save, size_for};
use crate::picture::Picture;
use crate::plane::{Plane, PlaneView};
use crate::ycbcr::{Range, YCbCr, rounded};

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
}

impl Default for Film {
    /// 25 frames in a second, 4:2:0, BT.601, limited range.
    fn default() -> Self {
        Self {
            frames_per_second: [25, 1],
            sampling: Sampling::default(),
            colours: YCbCr::default(),
        }
    }
}

/// The bytes of a film of these frames, which may be borrowed, or made one after another by an
/// iterator.
///
/// # Errors
///
/// [`EncodeError::Frames`] when there are none, [`EncodeError::Size`] when they have no pixels,
/// [`EncodeError::FrameSize`] when a frame differs in size from the first.
///
/// # Examples
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::y4m::{self, Film, Reader};
///
/// let frames = (0..3u8).map(|i| Plane::filled(4, 2, [80 * i; 3]));
/// let bytes = y4m::encode(frames, Film::default())?;
/// assert!(bytes.starts_with(b"YUV4MPEG2 W4 H2 F25:1 Ip A1:1 C420jpeg XCOLORRANGE=LIMITED\n"));
/// let last = Reader::new(&bytes)?.last().unwrap()?;
/// assert_eq!(last.to_rgb(Film::default().colours).get(0, 0), Some([160; 3]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn encode<F: Borrow<Plane<[u8; 3]>>>(
    frames: impl IntoIterator<Item = F>,
    film: Film,
) -> Result<Vec<u8>, EncodeError> {
    let mut bytes = Vec::new();
    let mut first = None;
    for (index, frame) in frames.into_iter().enumerate() {
        let frame = frame.borrow();
        let size = [frame.width(), frame.height()];
        let expected = *first.get_or_insert(size);
        if size != expected {
            return Err(EncodeError::FrameSize {
                frame: index,
                size,
                first: expected,
            });
        }
        if index == 0 {
            size_for(Format::Y4m, size)?;
            bytes.extend(header(size, film).bytes());
        }
        bytes.extend(b"FRAME\n");
        add_frame(&mut bytes, frame, film);
    }
    match first {
        Some(_) => Ok(bytes),
        None => Err(EncodeError::Frames {
            format: Format::Y4m,
            frames: 0,
        }),
    }
}

/// Writes a film, whole or not at all.
///
/// # Errors
///
/// Any [`SaveError`].
pub fn write<F: Borrow<Plane<[u8; 3]>>>(
    path: impl AsRef<Path>,
    frames: impl IntoIterator<Item = F>,
    film: Film,
) -> Result<(), SaveError> {
    save(path.as_ref(), encode(frames, film))
}

/// The frames of a film, one after another, borrowed from the bytes of its file.
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
    /// [`DecodeError::Syntax`] when it is wrong, [`DecodeError::Claim`] when the file is too short
    /// for one frame, [`DecodeError::Unsupported`] for other samplings than those of [`Sampling`].
    pub fn new(bytes: &'a [u8]) -> Result<Self, DecodeError> {
        let end = bytes.iter().position(|byte| *byte == b'\n');
        let line = end.and_then(|end| str::from_utf8(&bytes[..end]).ok());
        let (Some(end), Some(words)) = (end, line.and_then(|l| l.strip_prefix("YUV4MPEG2"))) else {
            return Err(syntax(0, "the first line does not begin with YUV4MPEG2"));
        };
        let (mut width, mut height, mut film) = (0, 0, Film::default());
        for word in words.split_ascii_whitespace() {
            let mut letters = word.chars();
            let (name, value) = (letters.next(), letters.as_str());
            match name {
                Some('W') => width = number(value)?,
                Some('H') => height = number(value)?,
                Some('F') => film.frames_per_second = ratio(value)?,
                Some('C') => film.sampling = sampling(value)?,
                Some('X') if value == "COLORRANGE=FULL" => film.colours.range = Range::Full,
                _ => {}
            }
        }
        if width == 0 || height == 0 {
            return Err(syntax(end, "the header states no width or no height"));
        }
        check_claim(Format::Y4m, [width, height], bytes.len(), 1.0)?;
        Ok(Self {
            bytes,
            at: end + 1,
            size: [width, height],
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

    fn frame(&mut self) -> Result<Frame<'a>, DecodeError> {
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

    fn plane(&mut self, [width, height]: [usize; 2]) -> Result<PlaneView<'a, u8>, DecodeError> {
        // The first plane fits into the file, so this does not overflow.
        let length = width * height;
        let plane = PlaneView::new(&self.bytes[self.at..], width, height, width);
        self.at += length;
        plane.map_err(|_| syntax(self.bytes.len(), "the film ends within a frame"))
    }
}

impl<'a> Iterator for Reader<'a> {
    type Item = Result<Frame<'a>, DecodeError>;

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

impl Sampling {
    /// Columns and rows of the planes of colour differences.
    fn difference_size(self, [width, height]: [usize; 2]) -> [usize; 2] {
        match self {
            Self::Quarter => [width.div_ceil(2), height.div_ceil(2)],
            Self::Half => [width.div_ceil(2), height],
            Self::Full => [width, height],
            Self::Grey => [0, 0],
        }
    }
}

/// The first frame as a picture: in grey where the film is grey.
pub(crate) fn decode_first(bytes: &[u8]) -> Result<Picture, DecodeError> {
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

fn header([width, height]: [usize; 2], film: Film) -> String {
    let sampling = match film.sampling {
        // "jpeg" says that the differences lie in the middle of the square.
        Sampling::Quarter => "420jpeg",
        Sampling::Half => "422",
        Sampling::Full => "444",
        Sampling::Grey => "mono",
    };
    let range = match film.colours.range {
        Range::Limited => "LIMITED",
        Range::Full => "FULL",
    };
    let [numerator, denominator] = film.frames_per_second;
    format!(
        "YUV4MPEG2 W{width} H{height} F{numerator}:{denominator} Ip A1:1 C{sampling} \
         XCOLORRANGE={range}\n"
    )
}

fn add_frame(bytes: &mut Vec<u8>, frame: &Plane<[u8; 3]>, film: Film) {
    let encoded = frame.map(|rgb| film.colours.unrounded(rgb.map(f32::from)));
    bytes.extend(encoded.values().iter().map(|[y, ..]| rounded(*y)));
    let size = [frame.width(), frame.height()];
    let [width, height] = film.sampling.difference_size(size);
    if width * height == 0 {
        return;
    }
    let (across, down) = (size[0].div_ceil(width), size[1].div_ceil(height));
    for channel in [1, 2] {
        for row in 0..height {
            for column in 0..width {
                // A square at the border may have fewer pixels.
                let rows = (row * down..size[1]).take(down);
                let (mut sum, mut count) = (0.0, 0.0);
                for row in rows {
                    for pixel in encoded.row(row)[column * across..].iter().take(across) {
                        sum += pixel[channel];
                        count += 1.0;
                    }
                }
                bytes.push(rounded(sum / count));
            }
        }
    }
}

fn sampling(value: &str) -> Result<Sampling, DecodeError> {
    match value {
        "420" | "420jpeg" | "420mpeg2" | "420paldv" => Ok(Sampling::Quarter),
        "422" => Ok(Sampling::Half),
        "444" => Ok(Sampling::Full),
        "mono" => Ok(Sampling::Grey),
        _ => Err(DecodeError::Unsupported {
            format: Format::Y4m,
            what: format!("the sampling {value}"),
        }),
    }
}

fn number<N: std::str::FromStr>(word: &str) -> Result<N, DecodeError> {
    word.parse()
        .map_err(|_| syntax(0, "a number of the header is not one, or too large"))
}

fn ratio(value: &str) -> Result<[u32; 2], DecodeError> {
    let (numerator, denominator) = value
        .split_once(':')
        .ok_or_else(|| syntax(0, "the rate of frames is not a ratio"))?;
    Ok([number(numerator)?, number(denominator)?])
}

fn syntax(offset: usize, problem: &'static str) -> DecodeError {
    DecodeError::Syntax {
        format: Format::Y4m,
        offset,
        problem,
    }
}
