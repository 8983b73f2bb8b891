//! Videos without compression.

use std::io::Cursor;

use ga_image::plane::Plane;
use ga_image::y4m::{self as film, Film, Sampling};
use ga_image::ycbcr::{Range, YCbCr};
use ga_video::y4m::Y4mSource;
use ga_video::{Frame, Samples, Source, VideoError, open};

use super::{Failing, frames, levels};

#[test]
fn frames_have_numbers_times_and_planes() {
    let film = Film {
        frames_per_second: [30000, 1001],
        ..Film::default()
    };
    let bytes = levels([5, 3], &[0, 128, 255], film);
    let mut source = Y4mSource::new(&bytes[..], "film.y4m").unwrap();
    let properties = *source.properties();
    assert_eq!((properties.size, properties.bit_depth), ([5, 3], 8));
    assert_eq!(properties.frames_per_second, Some([30000, 1001]));
    assert_eq!(properties.frame_count, None);
    let (found, end) = frames(&mut source);
    assert!(end.is_ok());
    let times: Vec<f64> = found.iter().map(|frame| frame.time_seconds).collect();
    assert_eq!(times, [0.0, 1001.0 / 30000.0, 2002.0 / 30000.0]);
    for (index, (frame, luma)) in found.iter().zip([16, 126, 235]).enumerate() {
        assert_eq!(frame.index, index);
        let Samples::Eight(planes) = &frame.samples else {
            panic!("8 bits")
        };
        assert_eq!(planes.luma, Plane::filled(5, 3, luma));
        assert_eq!(planes.differences[1], Plane::filled(3, 2, 128));
    }
}

#[test]
fn colours_of_ten_bits_are_those_of_eight() {
    // Red of BT.601 is 81, 90, 240 in the limited range, four times that with 10 bits.
    let samples = [324_u16, 324, 324, 324, 360, 960];
    let mut bytes = b"YUV4MPEG2 W2 H2 F25:1 C420p10\nFRAME\n".to_vec();
    bytes.extend(samples.iter().flat_map(|sample| sample.to_le_bytes()));
    let mut source = Y4mSource::new(&bytes[..], "red.y4m").unwrap();
    let colours = source.properties().colours;
    let (found, _) = frames(&mut source);
    assert_eq!(found[0].to_rgb(colours), Plane::filled(2, 2, [254, 0, 0]));
    assert_eq!(found[0].samples.bit_depth(), 10);
    let eight = found[0].samples.eight_bits();
    assert_eq!(eight.luma, Plane::filled(2, 2, 81));

    let full = YCbCr {
        range: Range::Full,
        ..YCbCr::default()
    };
    for rgb in [[255, 0, 0], [0, 255, 0], [30, 90, 200], [255; 3]] {
        let encoded = full.from_rgb(rgb).map(f32::from);
        // Chroma counts from the middle.
        let ten = encoded.map(|v| (v / 255.0 * 1023.0).round() as u16);
        let differences = [1, 2].map(|i| (512.0 + (encoded[i] - 128.0) * 1023.0 / 255.0).round());
        let decoded = full.to_rgb_of_ten_bits([
            ten[0],
            differences[0].min(1023.0) as u16,
            differences[1].min(1023.0) as u16,
        ]);
        for (a, b) in decoded.iter().zip(rgb) {
            assert!(a.abs_diff(b) <= 2, "{decoded:?}, not {rgb:?}");
        }
    }
}

#[test]
fn colours_of_any_sampling_are_those_of_the_reader_in_memory() {
    let picture = Plane::from_fn(5, 3, |c, r| [50 * c, 80 * r, 120].map(|v| v as u8));
    for sampling in [
        Sampling::Quarter,
        Sampling::Half,
        Sampling::Full,
        Sampling::Grey,
    ] {
        let film = Film {
            sampling,
            ..Film::default()
        };
        let bytes = film::encode([&picture], film).unwrap();
        let expected = film::Reader::new(&bytes).unwrap().next().unwrap().unwrap();
        let mut source = Y4mSource::new(&bytes[..], "film.y4m").unwrap();
        let (found, _) = frames(&mut source);
        let colours = film.colours;
        assert_eq!(found[0].to_rgb(colours), expected.to_rgb(colours));
    }
}

#[test]
fn errors_name_file_and_frame() {
    let bytes = levels([4, 2], &[0, 50, 100], Film::default());
    let message = |bytes: &[u8]| {
        let mut source = Y4mSource::new(bytes, "cut.y4m").unwrap();
        let (found, end) = frames(&mut source);
        (found.len(), end.unwrap_err())
    };
    let (count, error) = message(&bytes[..bytes.len() - 1]);
    assert_eq!((count, error.frame()), (2, Some(2)));
    assert_eq!(error.to_string(), "cut.y4m: the video ends within frame 2");

    let other = levels([6, 2], &[0], Film::default());
    let (count, error) = message(&[&bytes[..], &other[..]].concat());
    assert_eq!(count, 3);
    assert_eq!(
        error.to_string(),
        "cut.y4m: frame 3 has 6 × 2 pixels, the first has 4 × 2"
    );

    let (count, error) = message(b"YUV4MPEG2 W4 H2\n");
    assert_eq!(
        (count, error.to_string().as_str()),
        (0, "cut.y4m: the video has no frames")
    );

    let error = Y4mSource::new(&b"YUV4MPEG2 W4 H2 It\n"[..], "cut.y4m")
        .err()
        .unwrap();
    assert!(matches!(error, VideoError::Interlaced { .. }));
    assert!(
        error
            .to_string()
            .starts_with("cut.y4m: the video is interlaced")
    );
    let error = Y4mSource::new(&b"YUV4MPEG2 W4 H2 C411\n"[..], "cut.y4m")
        .err()
        .unwrap();
    assert_eq!(
        error.to_string(),
        "cut.y4m: Y4M: the sampling 411 is not supported; let ffmpeg convert the video: ffmpeg -i \
         cut.y4m -pix_fmt yuv420p10le -strict -1 -f yuv4mpegpipe -"
    );
}

/// A film that ends anywhere: the frames before, then an error with the frame.
#[test]
fn videos_may_end_anywhere() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("film.y4m");
    let bytes = levels([3, 3], &[0, 50], Film::default());
    let frame = 6 + 9 + 2 * 4;
    let header = bytes.len() - 2 * frame;
    for length in 0..=bytes.len() {
        std::fs::write(&path, &bytes[..length]).unwrap();
        let Ok(mut source) = open(&path) else {
            assert!(length < header, "{length}");
            continue;
        };
        let known = source.properties().frame_count;
        let (found, end) = frames(&mut *source);
        assert_eq!(found.len(), (length - header) / frame);
        let is_whole = (length - header).is_multiple_of(frame);
        assert_eq!(known, is_whole.then_some(found.len()));
        match end {
            Ok(()) => assert!(is_whole && length > header),
            Err(VideoError::Empty { .. }) => assert_eq!(length, header),
            Err(error) => assert_eq!(error.frame(), Some(found.len())),
        }
    }
}

/// The operating system cannot read bytes from a place on.
#[test]
fn an_error_while_reading_names_the_frame() {
    let bytes = levels([3, 3], &[0, 50], Film::default());
    let frame = 6 + 9 + 2 * 4;
    let header = bytes.len() - 2 * frame;
    for place in 0..bytes.len() {
        let outcome = Y4mSource::new(Failing::new(bytes.clone(), place), "film.y4m");
        if place < header {
            assert!(matches!(outcome, Err(VideoError::Open { .. })), "{place}");
            continue;
        }
        let (found, end) = frames(&mut outcome.unwrap());
        assert_eq!(found.len(), (place - header) / frame);
        let error = end.unwrap_err();
        let expected = format!("frame {} cannot be read: the disk is broken", found.len());
        assert_eq!(error.to_string(), format!("film.y4m: {expected}"));
        assert_eq!(error.frame(), Some(found.len()));
    }
}

#[test]
fn memory_of_a_frame_is_used_again() {
    let bytes = levels([64, 48], &[0, 1, 2, 3], Film::default());
    let mut source = Y4mSource::new(Cursor::new(bytes), "film.y4m").unwrap();
    let mut frame = Frame::default();
    let mut places = Vec::new();
    while source.read(&mut frame).unwrap() {
        let Samples::Eight(planes) = &frame.samples else {
            panic!("8 bits")
        };
        places.push(planes.luma.values().as_ptr());
    }
    assert!(places.len() == 4 && places.iter().all(|place| *place == places[0]));
}
