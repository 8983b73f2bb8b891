//! H.264 in MP4: the shared clips, and small files put together here.

use std::path::{Path, PathBuf};

use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_image::ycbcr::{Range, YCbCr};
use ga_video::mp4::Mp4Source;
use ga_video::{Frame, Properties, Source, VideoError, open};
use nullcone_shared_data::shared;
use openh264::OpenH264API;
use openh264::encoder::{Encoder, EncoderConfig, QpRange, VuiConfig};
use openh264::formats::YUVSlices;
use proptest::prelude::*;
use tempfile::TempDir;

use super::{Failing, count, frames};

/// Columns and rows of the small files: no multiples of 16, so that there is cropping.
const SIZE: [usize; 2] = [66, 50];

/// The luma of the frames of the small files.
const LEVELS: [u8; 6] = [40, 200, 80, 160, 120, 220];

fn named(kind: &[u8; 4], contents: &[&[u8]]) -> Vec<u8> {
    let contents = contents.concat();
    let length = contents.len() as u32 + 8;
    [&length.to_be_bytes()[..], kind, &contents].concat()
}

fn numbers(numbers: &[u32]) -> Vec<u8> {
    numbers
        .iter()
        .flat_map(|number| number.to_be_bytes())
        .collect()
}

/// What makes one file different from another.
#[derive(Clone)]
struct Settings {
    /// Units of time from each frame to the next; 600 are a second.
    durations: Vec<u32>,
    /// Time of the first unit shown, and the duration in milliseconds.
    edit: Option<[u32; 2]>,
    has_long_offsets: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            durations: vec![24; LEVELS.len()],
            edit: None,
            has_long_offsets: false,
        }
    }
}

/// The units of H.264 of each frame; the first two are the parameter sets.
fn encode() -> Vec<Vec<Vec<u8>>> {
    let settings = EncoderConfig::new()
        .skip_frames(false)
        // The finest that the encoder has; it takes a lower bound of 0 for one that is not set. A
        // coarser one changes pixels in the last blocks, which go beyond the picture, by 10.
        .qp(QpRange::new(12, 12))
        .vui(VuiConfig::bt709_full());
    let mut encoder = Encoder::with_api_config(OpenH264API::from_source(), settings).unwrap();
    let [width, height] = SIZE;
    let neutral = vec![128; width * height / 4];
    let encoded = LEVELS.map(|level| {
        let luma = vec![level; width * height];
        let strides = (width, width / 2, width / 2);
        let picture = YUVSlices::new((&luma, &neutral, &neutral), (width, height), strides);
        let bytes = encoder.encode(&picture).unwrap().to_vec();
        let units = openh264::nal_units(&bytes);
        let content = |unit: &[u8]| {
            let start = unit.iter().position(|byte| *byte == 1).unwrap() + 1;
            unit[start..].to_vec()
        };
        units.map(content).collect()
    });
    encoded.into()
}

/// A file with the index first, or last.
fn file(settings: &Settings, has_index_first: bool) -> Vec<u8> {
    let mut encoded = encode();
    let sets: Vec<Vec<u8>> = encoded[0].drain(..2).collect();
    let kinds: Vec<u8> = sets.iter().map(|unit| unit[0] & 31).collect();
    assert_eq!(kinds, [7, 8]);
    let samples: Vec<Vec<u8>> = encoded
        .iter()
        .map(|units| {
            let unit = |unit: &Vec<u8>| [&numbers(&[unit.len() as u32])[..], unit].concat();
            units.iter().flat_map(unit).collect()
        })
        .collect();
    let ftyp = named(b"ftyp", &[b"isom\0\0\x02\0isomavc1"]);
    let mdat = named(b"mdat", &[&samples.concat()]);
    let moov = |start: usize| index(settings, &sets, &samples, start);
    if has_index_first {
        let start = ftyp.len() + moov(0).len() + 8;
        [&ftyp[..], &moov(start), &mdat].concat()
    } else {
        let start = ftyp.len() + 8;
        [&ftyp[..], &mdat, &moov(start)].concat()
    }
}

/// The box `moov`, for samples that begin at `start`.
fn index(settings: &Settings, sets: &[Vec<u8>], samples: &[Vec<u8>], start: usize) -> Vec<u8> {
    let set = |unit: &Vec<u8>| [&(unit.len() as u16).to_be_bytes()[..], unit].concat();
    let profile = &sets[0][1..4];
    let avcc = named(
        b"avcC",
        &[
            &[1],
            profile,
            &[0xff, 0xe1],
            &set(&sets[0]),
            &[1],
            &set(&sets[1]),
        ],
    );
    let mut picture = [0; 78];
    picture[24..26].copy_from_slice(&(SIZE[0] as u16).to_be_bytes());
    picture[26..28].copy_from_slice(&(SIZE[1] as u16).to_be_bytes());
    let avc1 = named(b"avc1", &[&picture, &avcc]);
    let stsd = named(b"stsd", &[&numbers(&[0, 1]), &avc1]);
    let runs: Vec<u32> = settings.durations.iter().flat_map(|d| [1, *d]).collect();
    let stts = named(
        b"stts",
        &[
            &numbers(&[0, settings.durations.len() as u32]),
            &numbers(&runs),
        ],
    );
    // Chunks of two samples.
    let stsc = named(b"stsc", &[&numbers(&[0, 1, 1, 2, 1])]);
    let sizes: Vec<u32> = samples.iter().map(|sample| sample.len() as u32).collect();
    let stsz = named(
        b"stsz",
        &[&numbers(&[0, 0, sizes.len() as u32]), &numbers(&sizes)],
    );
    let mut offset = start as u32;
    let mut offsets = Vec::new();
    for pair in sizes.chunks(2) {
        offsets.push(offset);
        offset += pair.iter().sum::<u32>();
    }
    let count = numbers(&[0, offsets.len() as u32]);
    let places = if settings.has_long_offsets {
        let long: Vec<u32> = offsets.iter().flat_map(|offset| [0, *offset]).collect();
        named(b"co64", &[&count, &numbers(&long)])
    } else {
        named(b"stco", &[&count, &numbers(&offsets)])
    };
    let stbl = named(b"stbl", &[&stsd, &stts, &stsc, &stsz, &places]);
    let minf = named(b"minf", &[&stbl]);
    let hdlr = named(b"hdlr", &[&[0; 8], b"vide", &[0; 13]]);
    let mdhd = named(b"mdhd", &[&numbers(&[0, 0, 0, 600, 0, 0])]);
    let mdia = named(b"mdia", &[&mdhd, &hdlr, &minf]);
    let edts = settings.edit.map(|[first, milliseconds]| {
        let elst = numbers(&[0, 1, milliseconds, first, 0x10000]);
        named(b"edts", &[&named(b"elst", &[&elst])])
    });
    let trak = named(b"trak", &[&edts.unwrap_or_default(), &mdia]);
    let mvhd = named(b"mvhd", &[&numbers(&[0, 0, 0, 1000]), &[0; 84]]);
    named(b"moov", &[&mvhd, &trak])
}

fn write(folder: &TempDir, bytes: &[u8]) -> PathBuf {
    let path = folder.path().join("clip.mp4");
    std::fs::write(&path, bytes).unwrap();
    path
}

fn read(path: &Path) -> (Properties, Vec<Frame>, Result<(), VideoError>) {
    let mut source = Mp4Source::open(path).unwrap();
    let (found, end) = frames(&mut source);
    (*source.properties(), found, end)
}

/// That frames show the levels, up to what encoding loses.
fn check(found: &[Frame], levels: &[u8]) {
    assert_eq!(found.len(), levels.len());
    for (index, (frame, level)) in found.iter().zip(levels).enumerate() {
        assert_eq!(frame.index, index);
        let planes = frame.samples.eight_bits();
        assert_eq!([planes.luma.width(), planes.luma.height()], SIZE);
        assert_eq!(
            [
                planes.differences[0].width(),
                planes.differences[0].height()
            ],
            [33, 25]
        );
        for value in planes.luma.values() {
            assert!(
                value.abs_diff(*level) <= 4,
                "frame {index}: {value}, not {level}"
            );
        }
    }
}

#[test]
fn frames_come_back_with_their_properties() {
    let folder = tempfile::tempdir().unwrap();
    for (has_index_first, has_long_offsets) in [(false, false), (true, false), (true, true)] {
        let settings = Settings {
            has_long_offsets,
            ..Settings::default()
        };
        let path = write(&folder, &file(&settings, has_index_first));
        let (properties, found, end) = read(&path);
        assert!(end.is_ok(), "{end:?}");
        check(&found, &LEVELS);
        let expected = YCbCr {
            luma: Luma::Bt709,
            range: Range::Full,
        };
        assert_eq!((properties.size, properties.colours), (SIZE, expected));
        assert_eq!(properties.frames_per_second, Some([25, 1]));
        assert_eq!(properties.frame_count, Some(LEVELS.len()));
    }
}

#[test]
fn times_are_those_of_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let settings = Settings {
        durations: vec![24, 30, 600, 24, 24, 24],
        ..Settings::default()
    };
    let (properties, found, end) = read(&write(&folder, &file(&settings, true)));
    assert!(end.is_ok());
    assert_eq!(properties.frames_per_second, None);
    let times: Vec<f64> = found.iter().map(|frame| frame.time_seconds).collect();
    let expected = [0, 24, 54, 654, 678, 702].map(|units| f64::from(units) / 600.0);
    assert_eq!(times, expected);
}

#[test]
fn the_edit_list_says_what_is_shown() {
    let folder = tempfile::tempdir().unwrap();
    let settings = Settings {
        // From the third frame, 80 ms: two frames.
        edit: Some([48, 80]),
        ..Settings::default()
    };
    let (properties, found, end) = read(&write(&folder, &file(&settings, true)));
    assert!(end.is_ok());
    check(&found, &LEVELS[2..4]);
    assert_eq!(properties.frame_count, Some(2));
    assert_eq!([found[0].time_seconds, found[1].time_seconds], [0.0, 0.04]);
}

/// A file that ends anywhere: with the index before the frames, those that are whole, then an error
/// with the frame.
#[test]
fn files_may_end_anywhere() {
    let folder = tempfile::tempdir().unwrap();
    let bytes = file(&Settings::default(), true);
    let start = bytes.windows(4).position(|name| name == b"mdat").unwrap() - 4;
    let mut most = 0;
    for length in 0..bytes.len() {
        let path = write(&folder, &bytes[..length]);
        match Mp4Source::open(&path) {
            Ok(mut source) => {
                assert!(length >= start);
                let (found, end) = frames(&mut source);
                check(&found, &LEVELS[..found.len()]);
                assert!(found.len() >= most && found.len() < LEVELS.len());
                most = found.len();
                let error = end.unwrap_err();
                assert!(
                    matches!(error, VideoError::Truncated { frame, .. } if frame == most),
                    "{length}: {error}"
                );
            }
            Err(error) => {
                assert!(length < start, "{length}: {error}");
                assert!(error.to_string().contains("clip.mp4"), "{error}");
            }
        }
    }
    assert_eq!(most, LEVELS.len() - 1);
    // The index is last, and lost.
    let bytes = file(&Settings::default(), false);
    let path = write(&folder, &bytes[..bytes.len() - 1]);
    let message = Mp4Source::open(&path).err().unwrap().to_string();
    assert!(
        message.contains("the file ends before its index"),
        "{message}"
    );
}

/// The operating system cannot read bytes from a place on: the frames before them are returned, and
/// the error names the first of the others.
#[test]
fn an_error_while_reading_names_the_frame() {
    let bytes = file(&Settings::default(), true);
    let start = bytes.windows(4).position(|name| name == b"mdat").unwrap() + 4;
    let mut most = 0;
    for place in (start..bytes.len()).step_by(5) {
        let reader = Failing::new(bytes.clone(), place);
        let mut source = Mp4Source::new(reader, "clip.mp4").unwrap();
        let (found, end) = frames(&mut source);
        check(&found, &LEVELS[..found.len()]);
        assert!(found.len() >= most && found.len() < LEVELS.len());
        most = found.len();
        let error = end.unwrap_err();
        assert!(
            matches!(error, VideoError::Read { frame, .. } if frame == most),
            "{error}"
        );
        assert_eq!(error.frame(), Some(most));
        assert!(error.to_string().starts_with("clip.mp4: frame"), "{error}");
    }
    assert_eq!(most, LEVELS.len() - 1);
    // The index itself cannot be read.
    let error = Mp4Source::new(Failing::new(bytes, start / 2), "clip.mp4").err();
    assert!(matches!(error, Some(VideoError::Open { .. })));
}

/// Pictures that are decoded before others that are shown earlier: none is returned in the place of
/// one that is lost.
#[test]
fn frames_before_a_lost_one_are_those_of_the_whole_clip() {
    let Some(path) = shared("data/vision/clips/bbb_1080p_npm.mp4") else {
        return;
    };
    let bytes = std::fs::read(&path).unwrap();
    let index = bytes.windows(4).position(|name| name == b"moov").unwrap() - 4;
    for place in (200_000..400_000).step_by(40_000) {
        let reader = Failing::with_hole(bytes.clone(), place..index);
        let mut broken = Mp4Source::new(reader, "clip.mp4").unwrap();
        let mut whole = open(&path).unwrap();
        let [mut found, mut expected] = [Frame::default(), Frame::default()];
        let mut count = 0;
        let error = loop {
            match broken.read(&mut found) {
                Ok(has_frame) => assert!(has_frame),
                Err(error) => break error,
            }
            assert!(whole.read(&mut expected).unwrap());
            assert!(found == expected, "frame {count} before {place}");
            count += 1;
        };
        assert!(count > 0);
        assert!(matches!(error, VideoError::Read { frame, .. } if frame == count));
    }
}

/// An edit of 3 ms ends within the second unit of 1/600 s, and shows its frame.
#[test]
fn an_edit_shows_the_frame_in_which_it_ends() {
    let folder = tempfile::tempdir().unwrap();
    let settings = Settings {
        durations: vec![1; LEVELS.len()],
        edit: Some([0, 3]),
        ..Settings::default()
    };
    let path = write(&folder, &file(&settings, true));
    let (found, end) = frames(&mut Mp4Source::open(&path).unwrap());
    assert!(end.is_ok());
    assert_eq!(found.len(), 2);
}

#[test]
fn videos_that_are_not_decoded_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let replaced = |from: &[u8; 4], to: &[u8; 4]| {
        let mut bytes = file(&Settings::default(), true);
        let place = bytes.windows(4).position(|name| name == from).unwrap();
        bytes[place..place + 4].copy_from_slice(to);
        let path = write(&folder, &bytes);
        Mp4Source::open(&path).err().unwrap().to_string()
    };
    // The first place of each is in the index; `avc1` is also a brand, in the first box.
    let cases = [
        (b"avcC", b"free", "the box avcC is missing"),
        (b"vide", b"soun", "the file has no video"),
        (b"stsz", b"free", "the box stsz is missing"),
        (b"stts", b"free", "the box stts is missing"),
        (b"mvhd", b"mvex", "an MP4 in fragments is not read"),
    ];
    for (from, to, expected) in cases {
        let message = replaced(from, to);
        assert!(message.contains(expected), "{message}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Changes in the index; the decoder is given what it is given.
    #[test]
    fn changed_indices_give_frames_or_an_error(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..4),
    ) {
        let folder = tempfile::tempdir().unwrap();
        let mut bytes = file(&Settings { edit: Some([0, 0]), ..Settings::default() }, true);
        let end = bytes.windows(4).position(|name| name == b"mdat").unwrap() - 4;
        for (place, value) in changes {
            let place = place.index(end);
            bytes[place] = value;
        }
        let path = write(&folder, &bytes);
        if let Ok(mut source) = Mp4Source::open(&path) {
            let _ = frames(&mut source);
        }
    }
}

#[test]
fn no_frame_of_the_shared_clips_is_lost() {
    for (name, size, expected, rate) in [
        ("bigbuckbunny.mp4", [1280, 720], 132, [25, 1]),
        ("bbb_1080p_npm.mp4", [1920, 1080], 720, [24, 1]),
    ] {
        let Some(path) = shared(&format!("data/vision/clips/{name}")) else {
            return;
        };
        let properties = *open(&path).unwrap().properties();
        assert_eq!(
            (properties.size, properties.frame_count),
            (size, Some(expected))
        );
        assert_eq!(properties.frames_per_second, Some(rate));
        let (found, end) = count(&path);
        assert!(end.is_ok(), "{end:?}");
        assert_eq!(found, expected);
    }
}

/// Frames 265 to 305 of the clip, as another decoder gave them, smaller: the frame at each place is
/// the one that is most like it, so that none is out of order. All those frames are about a level
/// darker than ours, more than some of them differ from the next, so that this offset is left out.
#[test]
fn frames_are_in_the_order_in_which_they_are_shown() {
    let (Some(whole), Some(part)) = (
        shared("data/vision/clips/bbb_1080p_npm.mp4"),
        shared("data/vision/clips/bbb_f265-305_320x180_cut285.y4m"),
    ) else {
        return;
    };
    let mut source = open(whole).unwrap();
    let mut frame = Frame::default();
    let mut small = Vec::new();
    while small.len() < 41 && source.read(&mut frame).unwrap() {
        if frame.index >= 265 {
            let planes = frame.samples.eight_bits();
            // Means of 6 × 6 pixels.
            let mean = |column: usize, row: usize| {
                let rows = (6 * row..6 * row + 6).map(|row| &planes.luma.row(row)[6 * column..]);
                rows.flat_map(|row| &row[..6])
                    .map(|v| f64::from(*v))
                    .sum::<f64>()
                    / 36.0
            };
            small.push(Plane::from_fn(320, 180, mean));
        }
    }
    let (expected, end) = frames(&mut *open(part).unwrap());
    assert!(end.is_ok() && expected.len() == 41 && small.len() == 41);
    for (index, expected) in expected.iter().enumerate() {
        let planes = expected.samples.eight_bits();
        let found: Vec<[f64; 2]> = small
            .iter()
            .map(|other| difference(&planes.luma, other))
            .collect();
        let best = (0..41).min_by(|a, b| found[*a][1].total_cmp(&found[*b][1]));
        assert_eq!(best, Some(index));
        // Numbers that are rounded are 0.25 from the true ones on average.
        let [offset, rest] = found[index];
        assert!((-1.5..=0.0).contains(&offset), "frame {index}: {offset}");
        assert!(rest < 0.4, "frame {index}: {rest}");
    }
}

/// The mean of the differences of two pictures, and the mean deviation of the differences from it.
fn difference(one: &Plane<u8>, other: &Plane<f64>) -> [f64; 2] {
    let pairs = one.values().iter().zip(other.values());
    let differences: Vec<f64> = pairs.map(|(a, b)| f64::from(*a) - b).collect();
    let count = differences.len() as f64;
    let mean = differences.iter().sum::<f64>() / count;
    let deviations = differences.iter().map(|value| (value - mean).abs());
    [mean, deviations.sum::<f64>() / count]
}
