//! H.264 in MP4 (feature `mp4`), read and written.

mod boxes;
mod stream;
mod table;
mod writer;

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::{Path, PathBuf};

use ga_image::orientation::Orientation;
use ga_image::plane::Plane;
use ga_image::y4m::Sampling;
use rusty_h264_decoder::Decoder;

use self::boxes::{Index, Node};
use self::stream::{PictureSlices, Stream};
use self::table::{Sample, Table};
use super::{Frame, Planes, Properties, Samples, Source};
use crate::VideoError;

pub use self::writer::Writer;

/// A video in MP4, encoded with H.264: 8 bits, 4:2:0, not interlaced.
///
/// Pictures are those of the encoder to the bit: a stream is refused that uses what the decoder
/// does not do exactly, whose names the errors give. They are upright, as the file says. Samples
/// are read and decoded one after another. Frames come in the order in which they are shown, each
/// at its own time; those that the edit list leaves out are decoded, not returned. Of an unreadable
/// file, all frames that are shown before the first one that is lost are returned.
pub struct Mp4Source<R = File> {
    path: PathBuf,
    file: R,
    /// Bytes of the file.
    length: u64,
    /// Samples in the order of decoding.
    samples: Vec<Sample>,
    /// The place of each sample in the order in which they are shown.
    places: Vec<usize>,
    /// The times of all samples, in the order in which they are shown.
    times: Vec<i64>,
    timescale: u32,
    /// Which of the places are returned.
    shown: Range<usize>,
    /// Bytes of the lengths before units.
    length_bytes: usize,
    orientation: Orientation,
    properties: Properties,
    decoder: Decoder,
    /// What the decoder is given next; before the first sample, the parameter sets.
    packet: Vec<u8>,
    next_sample: usize,
    next_place: usize,
    /// Pictures that are decoded before others that are shown earlier, by their places.
    waiting: BTreeMap<usize, Planes<u8>>,
    /// Why no more samples are decoded.
    failure: Option<Failure>,
    has_ended: bool,
}

/// The most pictures that are decoded before one that is shown earlier: H.264 has 16.
const MOST_WAITING: usize = 17;

/// Bytes within which the header of a slice ends.
const HEADER: u64 = 512;

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
    /// the video is of a kind that is not decoded, [`VideoError::Empty`].
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
        let (stream, table) = read_index(index.root(), length).map_err(wrong)?;
        let mut order: Vec<usize> = (0..table.samples.len()).collect();
        order.sort_by_key(|&sample| table.samples[sample].time);
        let mut places = vec![0; order.len()];
        for (place, &sample) in order.iter().enumerate() {
            places[sample] = place;
        }
        let times: Vec<i64> = order
            .iter()
            .map(|&sample| table.samples[sample].time)
            .collect();
        let shown = times.partition_point(|time| *time < table.shown.start)
            ..times.partition_point(|time| *time < table.shown.end);
        if shown.is_empty() {
            return Err(VideoError::Empty { file: path.into() });
        }
        let mut source = Self {
            path: path.into(),
            file,
            length,
            properties: Properties {
                size: oriented(stream.size, stream.orientation),
                sampling: Sampling::Quarter,
                bit_depth: 8,
                colours: stream.colours,
                pixel_aspect: match exchanges_sides(stream.orientation) {
                    true => [table.pixel_aspect[1], table.pixel_aspect[0]],
                    false => table.pixel_aspect,
                },
                frames_per_second: constant_rate(&times[shown.clone()], table.timescale),
                frame_count: Some(shown.len()),
            },
            samples: table.samples,
            places,
            times,
            timescale: table.timescale,
            shown,
            length_bytes: stream.length_bytes,
            orientation: stream.orientation,
            decoder: Decoder::new(),
            packet: parameter_sets(&stream),
            next_sample: 0,
            next_place: 0,
            waiting: BTreeMap::new(),
            failure: None,
            has_ended: false,
        };
        source.check(stream).map_err(|problem| VideoError::Mp4 {
            file: path.into(),
            problem,
        })?;
        Ok(source)
    }

    /// Reads the headers of all samples that are in the file: whether they are decoded exactly.
    fn check(&mut self, mut stream: Stream) -> Result<(), String> {
        for (sample, &Sample { offset, size, .. }) in self.samples.iter().enumerate() {
            let end = offset.saturating_add(u64::from(size));
            let (mut at, mut picture) = (offset, PictureSlices::default());
            while at < end {
                let mut length = [0; 4];
                let used = &mut length[4 - self.length_bytes..];
                if read_at(&mut self.file, at, used).is_err() {
                    return Ok(());
                }
                at += self.length_bytes as u64;
                let length = u64::from(u32::from_be_bytes(length));
                let mut unit = vec![0; length.min(HEADER) as usize];
                // What cannot be read is said when its frame is.
                if at + length > end || read_at(&mut self.file, at, &mut unit).is_err() {
                    return Ok(());
                }
                let checked = stream.check(&unit, &mut picture);
                checked.map_err(|problem| {
                    let frame = self.places[sample].saturating_sub(self.shown.start);
                    format!("frame {frame}: {problem}")
                })?;
                at += length;
            }
        }
        Ok(())
    }

    /// Decodes the next sample.
    fn decode(&mut self) -> Result<Planes<u8>, Failure> {
        self.load_sample()?;
        let decoded = self.decoder.decode(&self.packet);
        self.packet.clear();
        let decoded = decoded.map_err(|error| Failure::Decoding(error.to_string()))?;
        let picture =
            decoded.ok_or_else(|| Failure::Decoding("its sample holds no picture".into()))?;
        let size = [picture.width, picture.height];
        let plane = |size: [usize; 2], values| {
            let plane = Plane::from_values(size[0], size[1], values);
            plane.map_err(|error| Failure::Decoding(error.to_string()))
        };
        let half = Sampling::Quarter.difference_size(size);
        let differences = [plane(half, picture.u)?, plane(half, picture.v)?];
        let luma = plane(size, picture.y)?;
        Ok(match self.orientation {
            Orientation::NoTransforms => Planes { luma, differences },
            orientation => Planes {
                luma: luma.oriented(orientation),
                differences: differences.map(|plane| plane.oriented(orientation)),
            },
        })
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

    /// Why there is no frame at the next place.
    fn error(&mut self) -> VideoError {
        let file = self.path.clone();
        let frame = self.next_place.saturating_sub(self.shown.start);
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
            None => VideoError::Empty { file },
        }
    }
}

impl<R: Read + Seek> Source for Mp4Source<R> {
    fn properties(&self) -> &Properties {
        &self.properties
    }

    fn read(&mut self, frame: &mut Frame) -> Result<bool, VideoError> {
        while !self.has_ended && self.next_place < self.shown.end {
            if let Some(planes) = self.waiting.remove(&self.next_place) {
                let place = self.next_place;
                self.next_place += 1;
                if place < self.shown.start {
                    continue;
                }
                let index = place - self.shown.start;
                let size = [planes.luma.width(), planes.luma.height()];
                if size != self.properties.size {
                    self.has_ended = true;
                    return Err(VideoError::Size {
                        file: self.path.clone(),
                        frame: index,
                        size,
                        first: self.properties.size,
                    });
                }
                frame.samples = Samples::Eight(planes);
                frame.index = index;
                let since = self.times[place].saturating_sub(self.times[self.shown.start]);
                frame.time_seconds = since as f64 / f64::from(self.timescale);
                return Ok(true);
            }
            if self.failure.is_some() || self.next_sample == self.samples.len() {
                self.has_ended = true;
                return Err(self.error());
            }
            match self.decode() {
                Ok(planes) => {
                    self.waiting.insert(self.places[self.next_sample], planes);
                    self.next_sample += 1;
                    if self.waiting.len() > MOST_WAITING {
                        let problem = "it is decoded later than H.264 allows".into();
                        self.failure = Some(Failure::Decoding(problem));
                    }
                }
                Err(failure) => self.failure = Some(failure),
            }
        }
        Ok(false)
    }
}

fn read_at(file: &mut (impl Read + Seek), at: u64, bytes: &mut [u8]) -> io::Result<()> {
    file.seek(SeekFrom::Start(at))?;
    file.read_exact(bytes)
}

/// Whether columns become rows.
fn exchanges_sides(orientation: Orientation) -> bool {
    oriented([0, 1], orientation) != [0, 1]
}

/// Columns and rows of pictures of this size that are made upright.
fn oriented([width, height]: [usize; 2], orientation: Orientation) -> [usize; 2] {
    match orientation {
        Orientation::NoTransforms
        | Orientation::FlipHorizontal
        | Orientation::FlipVertical
        | Orientation::Rotate180 => [width, height],
        Orientation::Rotate90
        | Orientation::Rotate90FlipH
        | Orientation::Rotate270
        | Orientation::Rotate270FlipH => [height, width],
    }
}

/// What the headers say, and the samples of the first video track.
fn read_index(moov: Node<'_>, length: u64) -> Result<(Stream, Table), String> {
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
        let entries = stsd.children(8)?;
        let Some(entry) = entries.first() else {
            return Err("the video has no description".into());
        };
        if entries.len() > 1 {
            return Err("a video with several descriptions is not read".into());
        }
        if !matches!(&entry.name, b"avc1" | b"avc3") {
            return Err(format!(
                "the video is encoded as {}; H.264 (avc1) is decoded",
                entry.name.escape_ascii()
            ));
        }
        // The description of a picture has 78 bytes, then boxes.
        let boxes = entry.children(78)?;
        let found = |name: &[u8; 4]| boxes.iter().find(|child| child.name == *name);
        let settings = found(b"avcC").ok_or("the box avcC is missing")?;
        let stream = Stream::read(settings.contents(), table::orientation(trak)?)?;
        let mut table = Table::new(moov, trak, length)?;
        let of_file = found(b"pasp").and_then(|pasp| table::pixel_aspect(pasp.contents()));
        table.pixel_aspect = of_file.or(stream.pixel_aspect).unwrap_or([1, 1]);
        return Ok((stream, table));
    }
    Err("the file has no video".into())
}

fn parameter_sets(stream: &Stream) -> Vec<u8> {
    let mut packet = Vec::new();
    for unit in &stream.sets {
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
