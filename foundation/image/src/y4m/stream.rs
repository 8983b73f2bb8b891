//! Reading a film as it comes.

use std::io::{self, BufRead, BufReader, Read};

use super::header::{Header, MAGIC, parse, syntax};
use crate::format_error::FormatError;
use crate::plane::Plane;

/// The greatest number of bytes in the header, and in the line that begins a frame.
pub const MAX_LINE: usize = 4096;

/// The greatest number of columns and of rows.
pub const MAX_SIDE: usize = 32_768;

/// Bytes that are asked for at once, until a frame has been read.
const PIECE: usize = 1 << 20;

/// A film that is read frame by frame, from a file, a pipe or any other source of bytes.
///
/// It holds no frame itself: the caller's planes are filled, and their memory is used again. No
/// more memory is taken than twice what has arrived, whatever size the header claims.
///
/// ```
/// use ga_image::plane::Plane;
/// use ga_image::y4m::{self, Film, Stream};
///
/// let frames = (0..3u8).map(|i| Plane::filled(5, 3, [80 * i; 3]));
/// let bytes = y4m::encode(frames, Film::default())?;
///
/// let mut stream = Stream::new(&bytes[..])?;
/// assert_eq!((stream.header().size, stream.header().bit_depth), ([5, 3], 8));
/// let [mut luma, mut cb, mut cr] = [(); 3].map(|()| Plane::<u8>::default());
/// let mut means = Vec::new();
/// while stream.read([&mut luma, &mut cb, &mut cr])? {
///     means.push(luma.get(2, 2).unwrap());
/// }
/// assert_eq!(means, [16, 85, 153]);
/// assert_eq!((cb.width(), cb.height()), (3, 2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Stream<R> {
    reader: BufReader<R>,
    header: Header,
    /// Bytes of the first line, with its end.
    header_length: usize,
    line: Vec<u8>,
    /// The number of the next frame.
    frame: usize,
    /// Whether there is nothing more to read: the film has ended, or an error was returned.
    has_ended: bool,
}

/// A number of a film: `u8` for 8 bits, `u16` for 10.
pub trait Number: Copy + Default + private::Sealed {
    /// The bits of the numbers.
    const BIT_DEPTH: u32;
}

impl Number for u8 {
    const BIT_DEPTH: u32 = 8;
}

impl Number for u16 {
    const BIT_DEPTH: u32 = 10;
}

impl<R: Read> Stream<R> {
    /// Reads the header.
    ///
    /// # Errors
    ///
    /// [`FormatError::Syntax`] and the like when it is wrong, longer than [`MAX_LINE`] or states
    /// more columns or rows than [`MAX_SIDE`]; [`FormatError::Read`] when it cannot be read.
    pub fn new(reader: R) -> Result<Self, FormatError> {
        let mut stream = Self {
            reader: BufReader::with_capacity(1 << 16, reader),
            header: Header::default(),
            header_length: 0,
            line: Vec::new(),
            frame: 0,
            has_ended: false,
        };
        stream.read_line()?;
        stream.header_length = stream.line.len();
        let Some((b'\n', line)) = stream.line.split_last() else {
            // The magic bytes are looked at first: a file of another kind may have no lines.
            parse(&stream.line)?;
            return Err(syntax(stream.line.len(), "the first line does not end"));
        };
        stream.header = parse(line)?;
        if stream.header.size.iter().any(|side| *side > MAX_SIDE) {
            return Err(syntax(
                0,
                "the header states more than 32768 columns or rows",
            ));
        }
        Ok(stream)
    }

    /// What the first line says.
    #[must_use]
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// The number of frames in a film of `length` bytes, header included, where frames that begin
    /// with `FRAME` and nothing more fill it; otherwise it is known only when they are read.
    #[must_use]
    pub fn frame_count(&self, length: u64) -> Option<usize> {
        let rest = length.checked_sub(self.header_length as u64)?;
        let frame = (b"FRAME\n".len() + self.frame_length()) as u64;
        let count = rest.is_multiple_of(frame).then_some(rest / frame)?;
        usize::try_from(count).ok()
    }

    /// Reads a frame into planes of luma, Cb and Cr, which get the size that they have in the film
    /// (without pixels for Cb and Cr of a grey film). Returns whether there was one. After an error
    /// there are no more frames.
    ///
    /// # Errors
    ///
    /// Any [`FormatError`] of a frame or of a header before it. What the
    /// planes then hold is not specified.
    pub fn read<T: Number>(&mut self, planes: [&mut Plane<T>; 3]) -> Result<bool, FormatError> {
        if self.has_ended {
            return Ok(false);
        }
        self.has_ended = true;
        if T::BIT_DEPTH != self.header.bit_depth {
            return Err(FormatError::Depth {
                bit_depth: self.header.bit_depth,
            });
        }
        if !self.begin_frame()? {
            return Ok(false);
        }
        let mut found = 0;
        let sizes = self.plane_sizes();
        for (plane, size) in planes.into_iter().zip(sizes) {
            found += self.read_plane(plane, size, found)?;
        }
        self.frame += 1;
        self.has_ended = false;
        Ok(true)
    }

    fn plane_sizes(&self) -> [[usize; 2]; 3] {
        let size = self.header.size;
        let differences = self.header.film.sampling.difference_size(size);
        [size, differences, differences]
    }

    /// Reads a line with its end, or what there is before the end of the film.
    fn read_line(&mut self) -> Result<(), FormatError> {
        self.line.clear();
        let mut limited = (&mut self.reader).take(MAX_LINE as u64);
        match limited.read_until(b'\n', &mut self.line) {
            Ok(_) => Ok(()),
            Err(source) => Err(FormatError::Read {
                frame: self.frame,
                source,
            }),
        }
    }

    /// Reads the line that begins a frame, and before it headers that repeat the first one, as they
    /// stand between films that were joined. Returns whether there is a frame.
    fn begin_frame(&mut self) -> Result<bool, FormatError> {
        let frame = self.frame;
        loop {
            self.read_line()?;
            let Some((b'\n', line)) = self.line.split_last() else {
                let rest = self.line.as_slice();
                return match rest {
                    [] => Ok(false),
                    _ if rest.starts_with(b"FRAME") || b"FRAME".starts_with(rest) => {
                        Err(self.truncated(0))
                    }
                    _ => Err(FormatError::Marker { frame }),
                };
            };
            if line == b"FRAME" || line.starts_with(b"FRAME ") {
                return Ok(true);
            }
            if !line.starts_with(MAGIC.as_bytes()) {
                return Err(FormatError::Marker { frame });
            }
            let (next, first) = (parse(line)?, self.header);
            if next.size != first.size {
                return Err(FormatError::FrameSize {
                    frame,
                    size: next.size,
                    first: first.size,
                });
            }
            if next != first {
                return Err(FormatError::Differs { frame });
            }
        }
    }

    /// Fills a plane, and returns the number of its bytes. `before` are those of the planes before
    /// it.
    fn read_plane<T: Number>(
        &mut self,
        plane: &mut Plane<T>,
        [width, height]: [usize; 2],
        before: usize,
    ) -> Result<usize, FormatError> {
        let length = width * height;
        let bytes_of_number = size_of::<T>();
        let mut values = std::mem::take(plane).into_values();
        values.truncate(length);
        let (mut read, frame) = (0, self.frame);
        while read < length {
            let piece = PIECE / bytes_of_number;
            let known = values.len().max(2 * read).max(piece).min(length);
            values.resize(known, T::default());
            let found = T::fill(&mut self.reader, &mut values[read..])
                .map_err(|source| FormatError::Read { frame, source })?;
            if found < (known - read) * bytes_of_number {
                return Err(self.truncated(before + read * bytes_of_number + found));
            }
            read = known;
        }
        if let Some(value) = T::too_large(&values) {
            return Err(FormatError::Number { frame, value });
        }
        // The length is that of the size.
        if let Ok(filled) = Plane::from_values(width, height, values) {
            *plane = filled;
        }
        Ok(length * bytes_of_number)
    }

    fn truncated(&self, found: usize) -> FormatError {
        FormatError::Truncated {
            frame: self.frame,
            found,
            expected: self.frame_length(),
        }
    }

    /// Bytes of the planes of a frame.
    fn frame_length(&self) -> usize {
        let numbers: usize = self.plane_sizes().iter().map(|[w, h]| w * h).sum();
        numbers * self.header.bit_depth.div_ceil(8) as usize
    }
}

/// Reads until `bytes` is full or the end is reached. Returns the number of bytes.
fn read_full(reader: &mut impl Read, bytes: &mut [u8]) -> io::Result<usize> {
    let mut found = 0;
    while found < bytes.len() {
        match reader.read(&mut bytes[found..]) {
            Ok(0) => break,
            Ok(count) => found += count,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(found)
}

mod private {
    use super::{Read, io, read_full};

    pub trait Sealed: Sized {
        /// Reads numbers; returns how many bytes there were.
        fn fill(reader: &mut impl Read, values: &mut [Self]) -> io::Result<usize>;

        /// A number that needs more bits than it may have.
        fn too_large(values: &[Self]) -> Option<u16>;

        /// Adds the bytes of numbers, the low one first.
        fn append(values: &[Self], bytes: &mut Vec<u8>);
    }

    impl Sealed for u8 {
        fn fill(reader: &mut impl Read, values: &mut [Self]) -> io::Result<usize> {
            read_full(reader, values)
        }

        fn too_large(_: &[Self]) -> Option<u16> {
            None
        }

        fn append(values: &[Self], bytes: &mut Vec<u8>) {
            bytes.extend_from_slice(values);
        }
    }

    impl Sealed for u16 {
        fn fill(reader: &mut impl Read, values: &mut [Self]) -> io::Result<usize> {
            // Small enough to stay in the cache between the two passes.
            let mut bytes = [0; 1 << 14];
            let mut found = 0;
            for piece in values.chunks_mut(bytes.len() / 2) {
                let wanted = &mut bytes[..2 * piece.len()];
                let count = read_full(reader, wanted)?;
                found += count;
                for (value, pair) in piece.iter_mut().zip(wanted.chunks_exact(2)) {
                    *value = u16::from_le_bytes([pair[0], pair[1]]);
                }
                if count < wanted.len() {
                    break;
                }
            }
            Ok(found)
        }

        fn too_large(values: &[Self]) -> Option<u16> {
            // A maximum is quicker to find than a first one, as it needs no branches.
            let greatest = values.iter().copied().max();
            greatest.filter(|value| *value > 1023)
        }

        fn append(values: &[Self], bytes: &mut Vec<u8>) {
            bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
        }
    }
}
