//! Films that are read as they come.

use std::io::{self, Read};

use ga_image::file::FormatError;
use ga_image::plane::Plane;
use ga_image::y4m::{self, Film, Interlacing, MAX_LINE, Number, Reader, Sampling, Stream};
use ga_image::ycbcr::{Range, YCbCr};
use nullcone_shared_data::shared;
use proptest::prelude::*;

type Planes<T> = [Plane<T>; 3];

/// All frames until the end or an error.
fn frames<T: Number>(bytes: impl Read) -> (Vec<Planes<T>>, Result<(), FormatError>) {
    let mut frames = Vec::new();
    let mut stream = match Stream::new(bytes) {
        Ok(stream) => stream,
        Err(error) => return (frames, Err(error)),
    };
    loop {
        let mut planes = [(); 3].map(|()| Plane::default());
        let [luma, cb, cr] = &mut planes;
        match stream.read([luma, cb, cr]) {
            Ok(true) => frames.push(planes),
            Ok(false) => return (frames, Ok(())),
            Err(error) => {
                // Nothing comes after an error.
                let [luma, cb, cr] = &mut planes;
                assert!(matches!(stream.read([luma, cb, cr]), Ok(false)));
                return (frames, Err(error));
            }
        }
    }
}

fn message<T: Number>(bytes: &[u8]) -> String {
    frames::<T>(bytes).1.unwrap_err().to_string()
}

/// A source that gives at most a few bytes at once, as a pipe may, and is interrupted.
struct Slow<'a> {
    bytes: &'a [u8],
    step: usize,
    is_interrupted: bool,
}

impl Read for Slow<'_> {
    fn read(&mut self, target: &mut [u8]) -> io::Result<usize> {
        self.is_interrupted = !self.is_interrupted;
        if self.is_interrupted {
            return Err(io::ErrorKind::Interrupted.into());
        }
        let length = self.step.min(target.len());
        (&mut self.bytes).read(&mut target[..length])
    }
}

#[test]
fn ten_bits_are_two_bytes_the_low_one_first() {
    let bytes = b"YUV4MPEG2 W3 H1 F30000:1001 Ip A1:1 C420p10 XYSCSS=420P10 XCOLORRANGE=FULL\n\
        FRAME Ip XCOMMENT=1\n\x00\x00\xff\x03\x02\x01\x10\x00\x11\x00\x20\x01\x21\x02";
    let (found, end) = frames::<u16>(&bytes[..]);
    assert!(end.is_ok(), "{end:?}");
    let [luma, cb, cr] = &found[0];
    assert_eq!(luma.values(), [0, 1023, 258]);
    // Three columns have two colour differences, one row has one.
    assert_eq!((cb.width(), cb.height()), (2, 1));
    assert_eq!((cb.values(), cr.values()), (&[16, 17][..], &[288, 545][..]));
    let header = *Stream::new(&bytes[..]).unwrap().header();
    assert_eq!(header.film.frames_per_second, [30000, 1001]);
    assert_eq!(header.film.colours.range, Range::Full);
    assert_eq!((header.bit_depth, header.has_rate), (10, true));
    assert!(matches!(
        frames::<u8>(&bytes[..]).1,
        Err(FormatError::Depth { bit_depth: 10 })
    ));
}

#[test]
fn a_number_of_more_than_ten_bits_is_an_error() {
    let bytes = b"YUV4MPEG2 W2 H1 Cmono10\nFRAME\n\xff\x03\x00\x04";
    assert_eq!(
        message::<u16>(bytes),
        "frame 0 has the number 1024, which needs more than 10 bits"
    );
}

#[test]
fn samplings_are_those_of_their_names() {
    let cases = [
        ("420", Sampling::Quarter, 8),
        ("420jpeg", Sampling::Quarter, 8),
        ("420mpeg2", Sampling::Quarter, 8),
        ("420paldv", Sampling::Quarter, 8),
        ("422", Sampling::Half, 8),
        ("444", Sampling::Full, 8),
        ("mono", Sampling::Grey, 8),
        ("420p10", Sampling::Quarter, 10),
        ("422p10", Sampling::Half, 10),
        ("444p10", Sampling::Full, 10),
    ];
    for (name, sampling, depth) in cases {
        let line = format!("YUV4MPEG2 W2 H2 C{name}\n");
        let header = *Stream::new(line.as_bytes()).unwrap().header();
        let found = (header.film.sampling, header.bit_depth);
        assert_eq!(found, (sampling, depth), "{name}");
    }
    for (letter, interlacing) in [
        ("p", Interlacing::Progressive),
        ("?", Interlacing::Progressive),
        ("t", Interlacing::TopFirst),
        ("b", Interlacing::BottomFirst),
        ("m", Interlacing::Mixed),
    ] {
        let line = format!("YUV4MPEG2 W2 H2 I{letter}\n");
        let header = *Stream::new(line.as_bytes()).unwrap().header();
        assert_eq!(header.interlacing, interlacing);
    }
}

#[test]
fn errors_name_the_frame() {
    let header = "YUV4MPEG2 W2 H2 Cmono\n";
    let film = |rest: &str| format!("{header}FRAME\n1234{rest}").into_bytes();
    assert_eq!(
        message::<u8>(&film("FRAME\n12")),
        "the film ends within frame 1, after 2 of 4 bytes"
    );
    assert_eq!(
        message::<u8>(&film("FRAME")),
        "the film ends within frame 1, after 0 of 4 bytes"
    );
    assert_eq!(
        message::<u8>(&film("5\n")),
        "frame 1 does not begin with a line FRAME"
    );
    assert_eq!(
        message::<u8>(&film("FRAMES\n5678")),
        "frame 1 does not begin with a line FRAME"
    );
    assert_eq!(
        message::<u8>(&film("YUV4MPEG2 W4 H2 Cmono\nFRAME\n12345678")),
        "frame 1 has 4 × 2 pixels, the first has 2 × 2"
    );
    assert_eq!(
        message::<u8>(&film("YUV4MPEG2 W2 H2 C444\n")),
        "the header before frame 1 differs from the first header"
    );
    // Films that were joined.
    let (found, end) = frames::<u8>(&film(&format!("{header}FRAME\n5678"))[..]);
    assert_eq!((found.len(), end.is_ok()), (2, true));
    assert_eq!(found[1][0].values(), b"5678");
}

#[test]
fn headers_are_checked() {
    let cases = [
        ("", "byte 0: the first line does not begin with YUV4MPEG2"),
        ("YUV4MPEG2", "no width or no height"),
        ("YUV4MPEG2 W2 H2", "byte 15: the first line does not end"),
        ("YUV4MPEG2 W2\n", "byte 12: the header states no width"),
        ("YUV4MPEG2 W2 Hx\n", "byte 13: a number of the header"),
        ("YUV4MPEG2 W+2 H2\n", "byte 10: a number of the header"),
        ("YUV4MPEG2 W2 H2 F25\n", "byte 16: the rate of frames"),
        ("YUV4MPEG2 W2 H2 F25:0\n", "byte 16: the rate of frames is"),
        ("YUV4MPEG2 W40000 H2\n", "more than 32768 columns or rows"),
        (
            "YUV4MPEG2 W2 H2 C411\n",
            "the sampling 411 is not supported",
        ),
    ];
    for (header, expected) in cases {
        let found = message::<u8>(header.as_bytes());
        assert!(found.contains(expected), "{header}: {found}");
    }
    let long = format!("YUV4MPEG2 W2 H2 X{}\n", "x".repeat(MAX_LINE));
    assert!(message::<u8>(long.as_bytes()).contains("the first line does not end"));
    // A rate that is said to be unknown, and one that is not stated.
    for header in ["YUV4MPEG2 W2 H2 F0:0\n", "YUV4MPEG2 W2 H2\n"] {
        let header = *Stream::new(header.as_bytes()).unwrap().header();
        assert_eq!(
            (header.has_rate, header.film.frames_per_second),
            (false, [25, 1])
        );
    }
}

/// A header may claim a gigapixel; memory is taken for what arrives.
#[test]
fn no_memory_is_taken_for_what_is_not_there() {
    let bytes = b"YUV4MPEG2 W32768 H32768 C444p10\nFRAME\n12";
    let mut stream = Stream::new(&bytes[..]).unwrap();
    let [mut luma, mut cb, mut cr] = [(); 3].map(|()| Plane::<u16>::default());
    let outcome = stream.read([&mut luma, &mut cb, &mut cr]);
    assert!(matches!(
        outcome,
        Err(FormatError::Truncated {
            frame: 0,
            found: 2,
            ..
        })
    ));
}

proptest! {
    #[test]
    fn what_is_written_comes_back(
        (width, height) in (1usize..9, 1usize..9),
        count in 1usize..4,
        sampling in prop::sample::select(vec![
            Sampling::Quarter, Sampling::Half, Sampling::Full, Sampling::Grey,
        ]),
        step in 1usize..40,
        seed in any::<u8>(),
    ) {
        let film = Film {
            frames_per_second: [24000, 1001],
            sampling,
            colours: YCbCr { range: Range::Full, ..YCbCr::default() },
            ..Film::default()
        };
        let pictures = (0..count).map(|index| Plane::from_fn(width, height, |column, row| {
            let mix = seed.wrapping_mul(31).wrapping_add((17 * column + 5 * row + index) as u8);
            [mix, mix.wrapping_mul(7), mix.wrapping_add(91)]
        }));
        let bytes = y4m::encode(pictures, film).unwrap();
        let slow = Slow { bytes: &bytes, step, is_interrupted: false };
        let mut stream = Stream::new(slow).unwrap();
        prop_assert_eq!(stream.header().film, film);
        prop_assert_eq!(stream.frame_count(bytes.len() as u64), Some(count));
        // The reader of films in memory was written before, against other programs' files.
        let mut expected = Reader::new(&bytes).unwrap();
        let [mut luma, mut cb, mut cr] = [(); 3].map(|()| Plane::<u8>::default());
        let mut found = 0;
        while stream.read([&mut luma, &mut cb, &mut cr]).unwrap() {
            let frame = expected.next().unwrap().unwrap();
            prop_assert_eq!(&luma, &frame.luma.to_plane());
            prop_assert_eq!(&cb, &frame.differences[0].to_plane());
            prop_assert_eq!(&cr, &frame.differences[1].to_plane());
            prop_assert_eq!([cb.width(), cb.height()], sampling.difference_size([width, height]));
            found += 1;
        }
        prop_assert_eq!(found, count);
    }

    #[test]
    fn changed_films_give_frames_or_an_error(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let pictures = vec![Plane::filled(5, 3, [9, 90, 200]); 3];
        let mut bytes = y4m::encode(&pictures, Film::default()).unwrap();
        for (place, value) in changes {
            let place = place.index(bytes.len());
            bytes[place] = value;
        }
        // Whatever comes out: there must be no panic.
        let _ = (frames::<u8>(&bytes[..]), frames::<u16>(&bytes[..]));
    }
}

/// A film that ends anywhere gives the frames that are whole, then an error if one is not.
#[test]
fn films_may_end_anywhere() {
    let pictures = [0, 100, 200].map(|level| Plane::filled(5, 3, [level; 3]));
    let bytes = y4m::encode(&pictures, Film::default()).unwrap();
    let (all, _) = frames::<u8>(&bytes[..]);
    let frame = "FRAME\n".len() + 15 + 2 * 6;
    let header = bytes.len() - 3 * frame;
    for length in 0..bytes.len() {
        let (found, end) = frames::<u8>(&bytes[..length]);
        let whole = length.saturating_sub(header) / frame;
        assert_eq!(found, all[..whole], "{length}");
        let is_between = length >= header && (length - header).is_multiple_of(frame);
        assert_eq!(end.is_ok(), is_between, "{length}: {end:?}");
        if length > header && !is_between {
            let found = end.unwrap_err();
            assert!(
                matches!(found, FormatError::Truncated { frame, .. } if frame == whole),
                "{length}: {found}"
            );
        }
    }
}

#[test]
fn clips_of_other_programs_have_their_frames() {
    for (name, size, count) in [
        ("bbb_f265-305_320x180_cut285.y4m", [320, 180], 41),
        ("motorcycle_sbs_960x324_defects.y4m", [960, 324], 48),
    ] {
        let Some(path) = shared(&format!("data/vision/clips/{name}")) else {
            return;
        };
        let file = std::fs::File::open(&path).unwrap();
        let length = file.metadata().unwrap().len();
        let stream = Stream::new(file).unwrap();
        assert_eq!(
            (stream.header().size, stream.frame_count(length)),
            (size, Some(count))
        );
        let (found, end) = frames::<u8>(std::fs::File::open(&path).unwrap());
        assert!(end.is_ok());
        assert_eq!(found.len(), count);
    }
}
