//! Videos without compression.

use std::io::Read;
use std::path::PathBuf;

use ga_image::file::FormatError;
use ga_image::plane::Plane;
use ga_image::y4m::{Header, Interlacing, Number, Stream};

use super::{Frame, Planes, Properties, Samples, Source};
use crate::VideoError;

/// A video in Y4M with 8 or 10 bits, from any source of bytes.
///
/// Frames are shown at the constant rate of the header, or 25 in a second where it states none.
#[derive(Debug)]
pub struct Y4mSource<R> {
    stream: Stream<R>,
    properties: Properties,
    file: PathBuf,
    /// The number of the next frame.
    next: usize,
    /// Whether there is nothing more to read: the video has ended, or an error was returned.
    has_ended: bool,
}

impl<R: Read> Y4mSource<R> {
    /// Reads the header. `file` is the name for errors.
    ///
    /// # Errors
    ///
    /// [`VideoError::Header`] when it is wrong, [`VideoError::Samples`],
    /// [`VideoError::Interlaced`], [`VideoError::Open`] when it cannot be read.
    pub fn new(reader: R, file: impl Into<PathBuf>) -> Result<Self, VideoError> {
        let file = file.into();
        let stream = match Stream::new(reader) {
            Ok(stream) => stream,
            Err(FormatError::Read { source, .. }) => {
                return Err(VideoError::Open { file, source });
            }
            Err(problem @ FormatError::Unsupported { .. }) => {
                let problem = problem.to_string();
                return Err(VideoError::Samples { file, problem });
            }
            Err(problem) => return Err(VideoError::Header { file, problem }),
        };
        let header = *stream.header();
        if header.interlacing != Interlacing::Progressive {
            return Err(VideoError::Interlaced { file });
        }
        Ok(Self {
            stream,
            properties: properties(&header),
            file,
            next: 0,
            has_ended: false,
        })
    }

    /// States the length of the file in bytes, from which the number of frames is known where they
    /// fill it.
    pub(super) fn expect_length(&mut self, length: Option<u64>) {
        self.properties.frame_count = length.and_then(|length| self.stream.frame_count(length));
    }

    fn error(&self, problem: FormatError) -> VideoError {
        let (file, frame) = (self.file.clone(), self.next);
        match problem {
            FormatError::Truncated { .. } => VideoError::Truncated { file, frame },
            FormatError::Read { source, .. } => VideoError::Read {
                file,
                frame,
                source,
            },
            FormatError::FrameSize { size, first, .. } => VideoError::Size {
                file,
                frame,
                size,
                first,
            },
            problem => VideoError::Y4m {
                file,
                frame,
                problem,
            },
        }
    }
}

impl<R: Read> Source for Y4mSource<R> {
    fn properties(&self) -> &Properties {
        &self.properties
    }

    fn read(&mut self, frame: &mut Frame) -> Result<bool, VideoError> {
        if self.has_ended {
            return Ok(false);
        }
        self.has_ended = true;
        let stream = &mut self.stream;
        let outcome;
        if self.properties.bit_depth == 8 {
            let mut planes = frame.samples.take_eight();
            outcome = stream.read(arrays(&mut planes));
            frame.samples = Samples::Eight(planes);
        } else {
            let mut planes = frame.samples.take_ten();
            outcome = stream.read(arrays(&mut planes));
            frame.samples = Samples::Ten(planes);
        }
        match outcome {
            Ok(true) => {
                frame.index = self.next;
                let [numerator, denominator] = self.stream.header().film.frames_per_second;
                // The product is exact, so that the time is the nearest number to the true one.
                frame.time_seconds =
                    self.next as f64 * f64::from(denominator) / f64::from(numerator);
                self.next += 1;
                self.has_ended = false;
                Ok(true)
            }
            Ok(false) if self.next == 0 => Err(VideoError::Empty {
                file: self.file.clone(),
            }),
            Ok(false) => Ok(false),
            Err(problem) => Err(self.error(problem)),
        }
    }
}

fn properties(header: &Header) -> Properties {
    Properties {
        size: header.size,
        sampling: header.film.sampling,
        bit_depth: header.bit_depth,
        colours: header.film.colours,
        pixel_aspect: header.film.pixel_aspect,
        frames_per_second: header.has_rate.then_some(header.film.frames_per_second),
        frame_count: None,
    }
}

fn arrays<T: Number>(planes: &mut Planes<T>) -> [&mut Plane<T>; 3] {
    let [cb, cr] = &mut planes.differences;
    [&mut planes.luma, cb, cr]
}
