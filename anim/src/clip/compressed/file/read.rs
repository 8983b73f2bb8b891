use super::super::basis::{Basis, SEGMENT};
use super::super::bits::BitReader;
use super::super::layout::JointLayout;
use super::super::options::{JointBound, Options};
use super::super::pack::{Codes, Segment, frames_of, segment_count};
use super::super::tables::{Channel, channels};
use super::cursor::Cursor;
use super::{HEADER, MAGIC, MOST_BIVECTOR, MOST_CHANNELS, MOST_LENGTH, VERSION, joints};
use crate::clip::ClipError;
use crate::transform::Transform;

/// What a file says beside its segments.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Parsed {
    pub(in super::super) names: Vec<String>,
    pub(in super::super) parents: Vec<Option<usize>>,
    pub(in super::super) rest: Vec<Transform<f32>>,
    pub(in super::super) layouts: Vec<JointLayout>,
    pub(in super::super) tracks: Vec<Track>,
    pub(in super::super) frames: usize,
    pub(in super::super) frame_time: f64,
    pub(in super::super) options: Options,
}

/// A scalar track.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Track {
    pub(in super::super) name: String,
    pub(in super::super) changes: bool,
    pub(in super::super) constant: f64,
}

/// Reads a file. Nothing is allocated that the bytes do not fill.
pub(in super::super) fn parse(bytes: &[u8]) -> Result<(Parsed, Vec<Segment>), ClipError> {
    let header = Header::read(bytes)?;
    let [names, constants, packed] = header.sections(bytes)?;
    let (joint_count, track_count) = (header.joints as usize, header.tracks as usize);
    let invalid = |what, index: usize| ClipError::Invalid {
        what,
        index: index as u64,
    };

    let mut cursor = Cursor::new(names);
    let mut texts = Vec::new();
    for index in 0..joint_count.saturating_add(track_count) {
        let text = name(&mut cursor).ok_or(invalid("unreadable name", index))?;
        texts.push(text);
    }
    if !cursor.is_empty() {
        return Err(invalid("there are more names than", texts.len()));
    }
    let track_names = texts.split_off(joint_count);

    let mut cursor = Cursor::new(constants);
    let (mut layouts, mut rest) = (Vec::new(), Vec::new());
    for index in 0..joint_count {
        let joint = joints::read(&mut cursor, index);
        let (layout, at_rest) = joint.ok_or(invalid("wrong constants in joint", index))?;
        layouts.push(layout);
        rest.push(at_rest);
    }
    let mut tracks = Vec::new();
    for (index, name) in track_names.into_iter().enumerate() {
        let changes = cursor.u8().filter(|&flag| flag < 2);
        let (Some(changes), Some(constant)) = (changes, cursor.f64()) else {
            return Err(invalid("wrong constants in track", index));
        };
        let changes = changes == 1;
        tracks.push(Track {
            name,
            changes,
            constant,
        });
    }
    let mut options = header.options.clone();
    for index in 0..header.bounds as usize {
        let bound = bound(&mut cursor).ok_or(invalid("unreadable bound", index))?;
        options.joints.push(bound);
    }
    if !cursor.is_empty() {
        return Err(invalid("unexpected bytes after joint", joint_count));
    }
    if options.check(joint_count).is_err() {
        return Err(invalid(
            "the bounds do not fit the joints, whose number is",
            joint_count,
        ));
    }
    let parsed = Parsed {
        names: texts,
        parents: layouts.iter().map(|layout| layout.parent).collect(),
        rest,
        layouts,
        tracks,
        frames: header.frames as usize,
        frame_time: header.frame_time,
        options,
    };
    let segments = segments(packed, &parsed)?;
    Ok((parsed, segments))
}

/// The numbers at the beginning.
struct Header {
    joints: u32,
    frames: u32,
    tracks: u32,
    bounds: u32,
    lengths: [u32; 3],
    frame_time: f64,
    options: Options,
}

/// The sections in their order.
const SECTIONS: [&str; 3] = ["names", "joints", "segments"];

impl Header {
    fn read(bytes: &[u8]) -> Result<Self, ClipError> {
        let begin = &bytes[..bytes.len().min(MAGIC.len())];
        if !MAGIC.starts_with(begin) || begin.is_empty() {
            return Err(ClipError::NotAClip);
        }
        let truncated = ClipError::Truncated {
            section: "header",
            expected: HEADER as u64,
            found: bytes.len() as u64,
        };
        let header = bytes.get(..HEADER).ok_or(truncated.clone())?;
        let (numbers, sum) = header.split_at(HEADER - 4);
        if Cursor::new(sum).u32() != Some(crc32fast::hash(numbers)) {
            return Err(ClipError::Checksum {
                section: "numbers at the beginning",
            });
        }
        let mut cursor = Cursor::new(&numbers[MAGIC.len()..]);
        let version = cursor.u32().ok_or(truncated.clone())?;
        if version != VERSION {
            return Err(ClipError::Version(version));
        }
        let mut whole = || cursor.u32().ok_or(truncated.clone());
        let [joints, frames, tracks, bounds] = [whole()?, whole()?, whole()?, whole()?];
        let lengths = [whole()?, whole()?, whole()?];
        let mut number = || {
            cursor
                .f64()
                .ok_or(ClipError::Header("a number at the beginning is not finite"))
        };
        let frame_time = number()?;
        let options = Options {
            tolerance: number()?,
            shell: number()?,
            track_tolerance: number()?,
            joints: Vec::new(),
        };
        for (what, count) in [
            ("the number of joints is", joints),
            ("the number of frames is", frames),
        ] {
            if count == 0 {
                return Err(ClipError::Invalid { what, index: 0 });
            }
        }
        if frame_time <= 0.0 {
            return Err(ClipError::Header("the frame time is not positive"));
        }
        Ok(Self {
            joints,
            frames,
            tracks,
            bounds,
            lengths,
            frame_time,
            options,
        })
    }

    /// The bytes of the sections, each whole by its checksum.
    fn sections<'a>(&self, bytes: &'a [u8]) -> Result<[&'a [u8]; 3], ClipError> {
        let found = bytes.len() as u64;
        let mut sections = [&bytes[..0]; 3];
        let mut begin = HEADER as u64;
        for ((section, place), length) in SECTIONS.into_iter().zip(&mut sections).zip(self.lengths)
        {
            let end = begin + u64::from(length) + 4;
            if end > found {
                return Err(ClipError::Truncated {
                    section,
                    expected: end,
                    found,
                });
            }
            let whole = &bytes[begin as usize..end as usize];
            let (contents, sum) = whole.split_at(length as usize);
            if Cursor::new(sum).u32() != Some(crc32fast::hash(contents)) {
                return Err(ClipError::Checksum { section });
            }
            *place = contents;
            begin = end;
        }
        if found > begin {
            return Err(ClipError::TooLong {
                expected: begin,
                found,
            });
        }
        Ok(sections)
    }
}

fn name(cursor: &mut Cursor) -> Option<String> {
    let length = cursor.variable()?;
    let bytes = cursor.take(length as usize)?;
    std::str::from_utf8(bytes).ok().map(str::to_owned)
}

fn bound(cursor: &mut Cursor) -> Option<JointBound> {
    Some(JointBound {
        joint: cursor.variable()? as usize,
        tolerance: cursor.f64()?,
        shell: cursor.f64()?,
    })
}

/// The greatest value that each channel may have.
fn limits(parsed: &Parsed) -> Vec<f64> {
    let changes = parsed.tracks.iter().map(|track| track.changes);
    let limit = |channel| match channel {
        Channel::OfJoint { joint, channel } => {
            let layout = &parsed.layouts[joint];
            let rotates = channel >= layout.translation.live + layout.scale.live;
            if rotates { MOST_BIVECTOR } else { MOST_LENGTH }
        }
        Channel::Track(_) => MOST_LENGTH,
    };
    let channels = channels(&parsed.layouts, changes);
    channels
        .into_iter()
        .map(|(channel, _)| limit(channel))
        .collect()
}

fn segments(packed: &[u8], parsed: &Parsed) -> Result<Vec<Segment>, ClipError> {
    let limits = limits(parsed);
    let invalid = |what, index: usize| ClipError::Invalid {
        what,
        index: index as u64,
    };
    if limits.len() > MOST_CHANNELS {
        return Err(invalid("too many channels:", limits.len()));
    }
    if limits.is_empty() {
        return match packed {
            [] => Ok(Vec::new()),
            _ => Err(invalid(
                "no channel changes, but the size of the segments in bytes is",
                packed.len(),
            )),
        };
    }
    let mut reader = BitReader::new(packed);
    let mut codes = Vec::new();
    for channel in 0..limits.len() {
        let read = Codes::read_after(codes.last(), &mut reader)
            .ok_or(invalid("unreadable code of channel", channel))?;
        codes.push(read);
    }
    let mut cursor = Cursor::new(reader.rest());
    let count = segment_count(parsed.frames);
    let mut lengths = Vec::new();
    for segment in 0..count {
        let length = cursor
            .variable()
            .ok_or(invalid("unreadable length of segment", segment))?;
        lengths.push(length as usize);
    }
    let bases = [SEGMENT, frames_of(count - 1, parsed.frames)].map(Basis::new);
    let mut segments = Vec::with_capacity(count);
    for (index, length) in lengths.into_iter().enumerate() {
        let basis = &bases[usize::from(index + 1 == count)];
        let segment = cursor
            .take(length)
            .and_then(|bytes| Segment::from_bytes(bytes, &codes, &limits, basis))
            .ok_or(invalid("wrong numbers in segment", index))?;
        segments.push(segment);
    }
    if !cursor.rest().is_empty() {
        return Err(invalid("unexpected bytes after segment", count));
    }
    Ok(segments)
}
