//! H.264 in MP4 (feature `mp4`), read and written.

mod boxes;
mod sequence;
mod table;
mod writer;

use std::collections::VecDeque;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::{Path, PathBuf};

use ga_image::plane::Plane;
use ga_image::y4m::Sampling;
use openh264::OpenH264API;
use openh264::decoder::{DecodedYUV, Decoder, DecoderConfig, Flush};
use openh264::formats::YUVSource;

use self::boxes::{Index, Node};
use self::sequence::{Configuration, Sequence};
use self::table::{Sample, Table};
use super::{Frame, Planes, Properties, Samples, Source};
use crate::VideoError;

pub use self::writer::Writer;

/// A video in MP4, encoded with H.264: 8 bits, 4:2:0, not interlaced.
///
/// Samples are read and decoded one after another. Frames come in the order in which they are
/// shown, each at its own time; those that the edit list leaves out are decoded, not returned. Of
/// an unreadable file, all frames that are shown before the first one that is lost are returned.
pub struct Mp4Source<R = File> {
    path: PathBuf,
    file: R,
    /// Bytes of the file.
    length: u64,
    /// Samples in the order of decoding.
    samples: Vec<Sample>,
    /// The times of all samples, in the order in which they are shown.
    times: Vec<i64>,
    timescale: u32,
    /// Which of the times are returned.
    shown: Range<usize>,
    /// Bytes of the lengths before units.
    length_bytes: usize,
    properties: Properties,
    decoder: Decoder,
    /// What the decoder is given next; before the first sample, the parameter sets.
    packet: Vec<u8>,
    next_sample: usize,
    /// Frames that the decoder has returned.
    decoded: usize,
    /// Frames that were in the decoder at the end.
    rest: VecDeque<Planes<u8>>,
    /// Why no more samples are decoded.
    failure: Option<Failure>,
    is_flushed: bool,
    has_ended: bool,
}

/// A sample that cannot be decoded.
enum Failure {
    Truncated,
    Decoding(String),
    Read(io::Error),
}

impl Mp4Source {
    /// Reads the index of a file, and begins to decode.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn open(path: impl AsRef<Path>) -> Result<Self, VideoError> {
        let path = path.as_ref();
        let file = File::open(path).map_err(|source| VideoError::Open {
            file: path.into(),
            source,
        })?;
        Self::new(file, path)
    }
}

impl<R: Read + Seek> Mp4Source<R> {
    /// Reads the index, and begins to decode. `path` is the name for errors.
    ///
    /// # Errors
    ///
    /// [`VideoError::Open`] when the index cannot be read, [`VideoError::Mp4`] when it is wrong or
    /// the video is of a kind that is not decoded, [`VideoError::Interlaced`],
    /// [`VideoError::Empty`].
    pub fn new(mut file: R, path: impl AsRef<Path>) -> Result<Self, VideoError> {
        let path = path.as_ref();
        let unreadable = |source| VideoError::Open {
            file: path.into(),
            source,
        };
        let wrong = |problem| VideoError::Mp4 {
            file: path.into(),
            problem,
        };
        let length = file.seek(SeekFrom::End(0)).map_err(unreadable)?;
        let index = Index::read(&mut file, length).map_err(unreadable)?;
        let index = index.map_err(wrong)?;
        let (configuration, table) = read_index(index.root(), length).map_err(wrong)?;
        let sequence = sequence(&configuration).map_err(wrong)?;
        if sequence.is_interlaced {
            return Err(VideoError::Interlaced { file: path.into() });
        }
        let mut times: Vec<i64> = table.samples.iter().map(|sample| sample.time).collect();
        times.sort_unstable();
        let shown = times.partition_point(|time| *time < table.shown.start)
            ..times.partition_point(|time| *time < table.shown.end);
        if shown.is_empty() {
            return Err(VideoError::Empty { file: path.into() });
        }
        let settings = DecoderConfig::new().flush_after_decode(Flush::NoFlush);
        let decoder = Decoder::with_api_config(OpenH264API::from_source(), settings)
            .map_err(|error| wrong(format!("the decoder did not start: {error}")))?;
        Ok(Self {
            path: path.into(),
            file,
            length,
            properties: Properties {
                size: sequence.size,
                sampling: Sampling::Quarter,
                bit_depth: 8,
                colours: sequence.colours,
                frames_per_second: constant_rate(&times[shown.clone()], table.timescale),
                frame_count: Some(shown.len()),
            },
            samples: table.samples,
            times,
            timescale: table.timescale,
            shown,
            length_bytes: configuration.length_bytes,
            decoder,
            packet: parameter_sets(&configuration),
            next_sample: 0,
            decoded: 0,
            rest: VecDeque::new(),
            failure: None,
            is_flushed: false,
            has_ended: false,
        })
    }

    /// Decodes until there is a frame. Returns whether there is one.
    fn decode(&mut self, planes: &mut Planes<u8>) -> Result<bool, VideoError> {
        loop {
            if let Some(last) = self.rest.pop_front() {
                *planes = last;
                return Ok(true);
            }
            if self.is_flushed {
                return Ok(false);
            }
            if self.failure.is_none() && self.next_sample < self.samples.len() {
                if let Err(failure) = self.load_sample() {
                    self.failure = Some(failure);
                    continue;
                }
                let decoded = self.decoder.decode(&self.packet);
                self.packet.clear();
                match decoded {
                    Ok(frame) => {
                        self.next_sample += 1;
                        if let Some(frame) = frame {
                            copy(&frame, planes);
                            return Ok(true);
                        }
                    }
                    Err(error) => self.failure = Some(Failure::Decoding(error.to_string())),
                }
                continue;
            }
            self.is_flushed = true;
            match self.decoder.flush_remaining() {
                Ok(frames) => {
                    for frame in frames {
                        let mut planes = Planes::default();
                        copy(&frame, &mut planes);
                        self.rest.push_back(planes);
                    }
                }
                Err(error) => {
                    let problem = Failure::Decoding(error.to_string());
                    self.failure.get_or_insert(problem);
                }
            }
        }
    }

    /// Adds a sample to the packet, each unit after the bytes that begin one.
    fn load_sample(&mut self) -> Result<(), Failure> {
        let sample = self.samples[self.next_sample];
        let end = sample.offset.saturating_add(u64::from(sample.size));
        if end > self.length {
            return Err(Failure::Truncated);
        }
        let mut units = Vec::with_capacity(sample.size as usize);
        let mut read = || {
            self.file.seek(SeekFrom::Start(sample.offset))?;
            (&mut self.file)
                .take(sample.size.into())
                .read_to_end(&mut units)
        };
        read().map_err(Failure::Read)?;
        if units.len() < sample.size as usize {
            return Err(Failure::Truncated);
        }
        let mut rest = units.as_slice();
        while !rest.is_empty() {
            let unit = rest
                .split_at_checked(self.length_bytes)
                .and_then(|(length, rest)| {
                    let length = length
                        .iter()
                        .fold(0, |sum, byte| sum << 8 | usize::from(*byte));
                    rest.split_at_checked(length)
                });
            let Some((unit, others)) = unit else {
                return Err(Failure::Decoding(
                    "a unit does not fit into its sample".into(),
                ));
            };
            add_unit(&mut self.packet, unit);
            rest = others;
        }
        Ok(())
    }

    /// How many of the frames that are shown come before all that are lost.
    fn intact(&self) -> usize {
        let lost = self.samples.get(self.next_sample..).unwrap_or_default();
        let first = lost.iter().map(|sample| sample.time).min();
        match first {
            Some(first) if self.failure.is_some() => {
                self.times.partition_point(|time| *time < first)
            }
            _ => self.times.len(),
        }
    }

    fn error(&mut self) -> VideoError {
        let file = self.path.clone();
        let last = self.intact().min(self.decoded);
        let frame = last.saturating_sub(self.shown.start);
        match self.failure.take() {
            Some(Failure::Truncated) => VideoError::Truncated { file, frame },
            Some(Failure::Read(source)) => VideoError::Read {
                file,
                frame,
                source,
            },
            Some(Failure::Decoding(problem)) => VideoError::Decoding {
                file,
                frame,
                problem,
            },
            None => VideoError::Decoding {
                file,
                frame,
                problem: format!(
                    "{} samples gave {} frames",
                    self.samples.len(),
                    self.decoded
                ),
            },
        }
    }
}

impl<R: Read + Seek> Source for Mp4Source<R> {
    fn properties(&self) -> &Properties {
        &self.properties
    }

    fn read(&mut self, frame: &mut Frame) -> Result<bool, VideoError> {
        let mut planes = frame.samples.take_eight();
        while !self.has_ended {
            self.has_ended = true;
            let has_frame = self.decode(&mut planes)?;
            // The decoder returns frames in the order in which they are shown.
            let number = self.decoded;
            if !has_frame && self.failure.is_none() && number == self.samples.len() {
                break;
            }
            if !has_frame || number >= self.intact() {
                return Err(self.error());
            }
            self.decoded += 1;
            if number >= self.shown.end {
                break;
            }
            let size = [planes.luma.width(), planes.luma.height()];
            if size != self.properties.size {
                return Err(VideoError::Size {
                    file: self.path.clone(),
                    frame: number.saturating_sub(self.shown.start),
                    size,
                    first: self.properties.size,
                });
            }
            self.has_ended = false;
            if number < self.shown.start {
                continue;
            }
            frame.samples = Samples::Eight(planes);
            frame.index = number - self.shown.start;
            let since = self.times[number].saturating_sub(self.times[self.shown.start]);
            frame.time_seconds = since as f64 / f64::from(self.timescale);
            return Ok(true);
        }
        Ok(false)
    }
}

/// The settings of the decoder and the samples of the first video track.
fn read_index(moov: Node<'_>, length: u64) -> Result<(Configuration, Table), String> {
    if moov.find(b"mvex")?.is_some() {
        return Err("an MP4 in fragments is not read".into());
    }
    for trak in moov.children(0)? {
        if trak.name != *b"trak" {
            continue;
        }
        let mdia = trak.child(b"mdia")?;
        // A version and a name that is not used stand before the kind of the track.
        if mdia.child(b"hdlr")?.contents().get(8..12) != Some(&b"vide"[..]) {
            continue;
        }
        let stsd = mdia.child(b"minf")?.child(b"stbl")?.child(b"stsd")?;
        // A version and a count stand before the entries.
        let Some(entry) = stsd.children(8)?.into_iter().next() else {
            return Err("the video has no description".into());
        };
        if !matches!(&entry.name, b"avc1" | b"avc3") {
            return Err(format!(
                "the video is encoded as {}; H.264 (avc1) is decoded",
                entry.name.escape_ascii()
            ));
        }
        // The description of a picture has 78 bytes, then boxes.
        let boxes = entry.children(78)?.into_iter();
        let Some(settings) = boxes.into_iter().find(|child| child.name == *b"avcC") else {
            return Err("the box avcC is missing".into());
        };
        let configuration = Configuration::read(settings.contents())
            .ok_or("the box avcC ends within a parameter set")?;
        return Ok((configuration, Table::new(moov, trak, length)?));
    }
    Err("the file has no video".into())
}

/// The first sequence parameter set, if it is of a kind that the decoder knows.
fn sequence(configuration: &Configuration) -> Result<Sequence, String> {
    let unit = configuration.sets.first();
    let sequence = unit
        .and_then(|unit| Sequence::read(unit))
        .ok_or("the sequence parameter set is missing or wrong")?;
    if sequence.chroma != 1 {
        return Err("only 4:2:0 is decoded of H.264".into());
    }
    if sequence.bit_depth != 8 {
        return Err(format!(
            "{} bits are not decoded of H.264, only 8",
            sequence.bit_depth
        ));
    }
    Ok(sequence)
}

fn parameter_sets(configuration: &Configuration) -> Vec<u8> {
    let mut packet = Vec::new();
    for unit in &configuration.sets {
        add_unit(&mut packet, unit);
    }
    packet
}

/// Adds a unit as byte streams have it (ITU-T H.264, annex B).
fn add_unit(packet: &mut Vec<u8>, unit: &[u8]) {
    packet.extend([0, 0, 0, 1]);
    packet.extend(unit);
}

/// The rate of frames as numerator and denominator, where all are equally far apart.
fn constant_rate(times: &[i64], timescale: u32) -> Option<[u32; 2]> {
    let mut steps = times.windows(2).map(|pair| pair[1].saturating_sub(pair[0]));
    let first = steps.next()?;
    let step = u32::try_from(first).ok().filter(|step| *step > 0)?;
    let divisor = greatest_divisor(timescale, step);
    steps
        .all(|step| step == first)
        .then_some([timescale / divisor, step / divisor])
}

fn greatest_divisor(a: u32, b: u32) -> u32 {
    if b == 0 {
        a
    } else {
        greatest_divisor(b, a % b)
    }
}

fn copy(frame: &DecodedYUV<'_>, planes: &mut Planes<u8>) {
    let (width, height) = frame.dimensions();
    let half = Sampling::Quarter.difference_size([width, height]);
    let strides = frame.strides();
    let [cb, cr] = &mut planes.differences;
    copy_plane(frame.y(), strides.0, [width, height], &mut planes.luma);
    copy_plane(frame.u(), strides.1, half, cb);
    copy_plane(frame.v(), strides.2, half, cr);
}

fn copy_plane(source: &[u8], stride: usize, [width, height]: [usize; 2], target: &mut Plane<u8>) {
    let mut values = std::mem::take(target).into_values();
    values.clear();
    for row in source.chunks(stride.max(1)).take(height) {
        values.extend_from_slice(&row[..width.min(row.len())]);
    }
    // A decoder that returns less than it says would leave the plane empty, which is then found to
    // differ in size.
    *target = Plane::from_values(width, height, values).unwrap_or_default();
}
