//! Where frames come from.

mod images;
#[cfg(feature = "mp4")]
mod mp4;
#[cfg(feature = "mp4")]
mod mp4_written;
mod reference;
mod stereo;
mod y4m;

use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::Path;

use ga_image::plane::Plane;
use ga_image::y4m::{self as film, Film};
use ga_video::{Frame, Source, VideoError, open};
use nullcone_shared_data::shared;

/// Bytes of which a range cannot be read.
struct Failing {
    bytes: Cursor<Vec<u8>>,
    unreadable: Range<usize>,
}

impl Failing {
    /// From a place on.
    fn new(bytes: Vec<u8>, place: usize) -> Self {
        Self::with_hole(bytes, place..usize::MAX)
    }

    fn with_hole(bytes: Vec<u8>, unreadable: Range<usize>) -> Self {
        let bytes = Cursor::new(bytes);
        Self { bytes, unreadable }
    }
}

impl Read for Failing {
    fn read(&mut self, target: &mut [u8]) -> io::Result<usize> {
        let place = self.bytes.position() as usize;
        if self.unreadable.contains(&place) {
            return Err(io::Error::other("the disk is broken"));
        }
        let readable = self.unreadable.start.checked_sub(place);
        let count = target.len().min(readable.unwrap_or(usize::MAX));
        self.bytes.read(&mut target[..count])
    }
}

impl Seek for Failing {
    fn seek(&mut self, place: SeekFrom) -> io::Result<u64> {
        self.bytes.seek(place)
    }
}

/// All frames until the end or an error.
fn frames(source: &mut dyn Source) -> (Vec<Frame>, Result<(), VideoError>) {
    let (mut frames, mut frame) = (Vec::new(), Frame::default());
    loop {
        match source.read(&mut frame) {
            Ok(true) => frames.push(frame.clone()),
            Ok(false) => return (frames, Ok(())),
            Err(error) => {
                assert!(matches!(source.read(&mut frame), Ok(false)), "{error}");
                return (frames, Err(error));
            }
        }
    }
}

/// The number of frames of a file, and the error at its end, without keeping the frames.
fn count(path: &Path) -> (usize, Result<(), VideoError>) {
    let mut source = open(path).unwrap();
    let mut frame = Frame::default();
    let mut count = 0;
    loop {
        match source.read(&mut frame) {
            Ok(true) => {
                assert_eq!(frame.index, count);
                assert_eq!(frame.samples.size(), source.properties().size);
                count += 1;
            }
            Ok(false) => return (count, Ok(())),
            Err(error) => return (count, Err(error)),
        }
    }
}

/// The bytes of a film in grey levels.
fn levels([width, height]: [usize; 2], levels: &[u8], film: Film) -> Vec<u8> {
    let frames = levels
        .iter()
        .map(|level| Plane::filled(width, height, [*level; 3]));
    film::encode(frames, film).unwrap()
}

#[test]
fn a_file_of_another_kind_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("notes.txt");
    std::fs::write(&path, "no video").unwrap();
    let message = open(&path).err().unwrap().to_string();
    assert!(
        message.contains("notes.txt: not a video of a known format"),
        "{message}"
    );
    std::fs::write(&path, "").unwrap();
    let empty = open(&path).err().unwrap();
    assert!(matches!(empty, VideoError::Empty { .. }), "{empty}");
    let absent = open(folder.path().join("absent.y4m")).err().unwrap();
    assert!(matches!(absent, VideoError::Open { .. }), "{absent}");
    assert_eq!(absent.frame(), None);
}

#[test]
fn shared_clips_have_their_frames() {
    for (name, expected) in [
        ("bbb_f265-305_320x180_cut285.y4m", 41),
        ("motorcycle_sbs_960x324_defects.y4m", 48),
    ] {
        let Some(path) = shared(&format!("data/vision/clips/{name}")) else {
            return;
        };
        assert_eq!(
            open(&path).unwrap().properties().frame_count,
            Some(expected)
        );
        let (found, end) = count(&path);
        assert!(end.is_ok());
        assert_eq!(found, expected);
    }
}
