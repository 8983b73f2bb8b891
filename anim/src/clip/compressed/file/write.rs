use super::super::bits::BitWriter;
use super::super::layout::JointLayout;
use super::super::options::Options;
use super::super::pack::{Codes, Segment};
use super::cursor::put_variable;
use super::{HEADER, MAGIC, VERSION, joints};
use crate::clip::ClipError;
use crate::recording::Recording;

/// What a file says beside its segments.
pub(in super::super) struct Contents<'a> {
    pub(in super::super) recording: &'a Recording,
    pub(in super::super) options: &'a Options,
    pub(in super::super) layouts: &'a [JointLayout],
    /// Of each track: whether it changes, and its constant.
    pub(in super::super) tracks: Vec<(bool, f64)>,
}

/// The bytes of a file.
pub(in super::super) fn to_bytes(
    contents: &Contents,
    segments: &[Segment],
) -> Result<Vec<u8>, ClipError> {
    let recording = contents.recording;
    let sections = [names(recording), constants(contents), packed(segments)];
    let count =
        |what, count: usize| u32::try_from(count).map_err(|_| ClipError::TooMany { what, count });
    let mut bytes = MAGIC.to_vec();
    for number in [
        VERSION,
        count("joints", recording.joints().len())?,
        count("frames", recording.frame_count())?,
        count("tracks", recording.tracks().len())?,
        count("bounds", contents.options.joints.len())?,
        count("bytes of names", sections[0].len())?,
        count("bytes of joints", sections[1].len())?,
        count("bytes of segments", sections[2].len())?,
    ] {
        bytes.extend(number.to_le_bytes());
    }
    let Options {
        tolerance,
        shell,
        track_tolerance,
        ..
    } = *contents.options;
    for number in [recording.frame_time(), tolerance, shell, track_tolerance] {
        bytes.extend(number.to_le_bytes());
    }
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    debug_assert_eq!(bytes.len(), HEADER);
    for section in sections {
        bytes.extend_from_slice(&section);
        bytes.extend(crc32fast::hash(&section).to_le_bytes());
    }
    Ok(bytes)
}

fn names(recording: &Recording) -> Vec<u8> {
    let mut bytes = Vec::new();
    let joints = recording.joints().iter().map(|joint| &joint.name);
    for name in joints.chain(recording.tracks().iter().map(|track| &track.name)) {
        put_variable(&mut bytes, name.len() as u32);
        bytes.extend_from_slice(name.as_bytes());
    }
    bytes
}

fn constants(contents: &Contents) -> Vec<u8> {
    let mut bytes = Vec::new();
    for (layout, joint) in contents.layouts.iter().zip(contents.recording.joints()) {
        joints::write(&mut bytes, layout, &joint.rest);
    }
    for &(changes, constant) in &contents.tracks {
        bytes.push(changes.into());
        bytes.extend(constant.to_le_bytes());
    }
    for bound in &contents.options.joints {
        put_variable(&mut bytes, bound.joint as u32);
        bytes.extend(bound.tolerance.to_le_bytes());
        bytes.extend(bound.shell.to_le_bytes());
    }
    bytes
}

/// The codes of the channels, the lengths of the segments, and the segments. Without channels there
/// is nothing.
fn packed(segments: &[Segment]) -> Vec<u8> {
    let channels = segments.first().map_or(0, |segment| segment.pieces.len());
    if channels == 0 {
        return Vec::new();
    }
    let codes = Codes::of_segments(segments);
    let mut writer = BitWriter::default();
    Codes::write_all(&codes, &mut writer);
    let mut bytes = writer.into_bytes();
    let packed: Vec<Vec<u8>> = segments
        .iter()
        .map(|segment| segment.to_bytes(&codes))
        .collect();
    for segment in &packed {
        put_variable(&mut bytes, segment.len() as u32);
    }
    for segment in packed {
        bytes.extend_from_slice(&segment);
    }
    bytes
}
