//! H.264 in MP4 as it is written: read back by the reader, and by ffmpeg where it is installed.

use std::io::{self, Cursor, Seek, SeekFrom, Write};
use std::path::Path;
use std::process::Command;

use ga_image::film::Rate;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_image::ycbcr::{Range, YCbCr};
use ga_video::mp4::{Mp4Source, Writer};
use ga_video::{Frame, Source, VideoError, open};

use super::frames;

/// A drawn picture: a disc before a gradient that moves with the frames, and a checkerboard.
fn picture([width, height]: [usize; 2], frame: usize) -> Plane<[u8; 3]> {
    let middle = [width as f64 * 0.3 + 2.0 * frame as f64, height as f64 * 0.5];
    let radius = height as f64 * 0.3;
    Plane::from_fn(width, height, |column, row| {
        let [x, y] = [column as f64 - middle[0], row as f64 - middle[1]];
        if x.hypot(y) < radius {
            return [200, 90, 40];
        }
        if column > 3 * width / 4 && row > height / 2 {
            return [[30; 3], [225; 3]][(column / 8 + row / 8) % 2];
        }
        let grey = (60.0 + 150.0 * row as f64 / height as f64) as u8;
        [grey, grey, grey + 30]
    })
}

fn film(size: [usize; 2], count: usize, rate: f64) -> Vec<u8> {
    let mut bytes = Cursor::new(Vec::new());
    let rate = Rate::new(rate).unwrap();
    let mut writer = Writer::new(&mut bytes, size, count, rate).unwrap();
    for frame in 0..count {
        writer.write(&picture(size, frame)).unwrap();
    }
    writer.finish().unwrap();
    bytes.into_inner()
}

/// Luma, Cb and Cr of BT.709 in the limited range, by the formulas of the standard.
fn encoded(rgb: [u8; 3]) -> [f64; 3] {
    let [red, green, blue] = rgb.map(|code| f64::from(code) / 255.0);
    let luma = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
    [
        16.0 + 219.0 * luma,
        128.0 + 224.0 * (blue - luma) / 1.8556,
        128.0 + 224.0 * (red - luma) / 1.5748,
    ]
}

/// That a frame shows a picture: the PSNR of its planes in dB, where each difference is that of the
/// first of two columns, smoothed with its neighbours, and the mean of two rows.
#[track_caller]
fn check(frame: &Frame, picture: &Plane<[u8; 3]>) {
    let planes = frame.samples.eight_bits();
    for (channel, plane) in planes.as_array().into_iter().enumerate() {
        let of_pixel = |column: usize, row: usize| encoded(picture.row(row)[column])[channel];
        let smoothed = |column: usize, row: usize| {
            let at = |column: usize| of_pixel(column.min(picture.width() - 1), row);
            let before = at(column.saturating_sub(1));
            0.25 * before + 0.5 * at(column) + 0.25 * at(column + 1)
        };
        let mut sum = 0.0;
        for row in 0..plane.height() {
            for column in 0..plane.width() {
                let expected = match channel {
                    0 => of_pixel(column, row),
                    _ => [0, 1]
                        .map(|k| 0.5 * smoothed(2 * column, 2 * row + k))
                        .iter()
                        .sum(),
                };
                sum += (f64::from(plane.row(row)[column]) - expected).powi(2);
            }
        }
        let count = (plane.width() * plane.height()) as f64;
        let psnr = 10.0 * (255.0f64.powi(2) * count / sum).log10();
        let index = frame.index;
        assert!(psnr > 38.0, "frame {index}, plane {channel}: {psnr} dB");
    }
}

#[test]
fn pictures_come_back() {
    const BT709: YCbCr = YCbCr {
        luma: Luma::Bt709,
        range: Range::Limited,
    };
    for (size, count, rate, quotient) in [
        ([320, 240], 75, 30e3 / 1001.0, [30_000, 1001]),
        ([66, 50], 12, 25.0, [25, 1]),
        ([48, 96], 3, 0.5, [1, 2]),
        ([16, 16], 2, 1000.0, [1000, 1]),
    ] {
        let bytes = film(size, count, rate);
        let mut source = Mp4Source::new(Cursor::new(bytes.clone()), "film.mp4").unwrap();
        let properties = *source.properties();
        assert_eq!((properties.size, properties.colours), (size, BT709));
        assert_eq!(properties.frame_count, Some(count));
        assert_eq!(properties.frames_per_second, Some(quotient));
        let (found, end) = frames(&mut source);
        assert!(end.is_ok() && found.len() == count, "{end:?}");
        for (number, frame) in found.iter().enumerate() {
            check(frame, &picture(size, number));
            let seconds = number as f64 * f64::from(quotient[1]) / f64::from(quotient[0]);
            assert!((frame.time_seconds - seconds).abs() < 1e-9);
        }
        // The same bytes each time, and what a player needs first comes first.
        assert!(bytes == film(size, count, rate));
        let place = |name: &[u8]| bytes.windows(4).position(|window| window == name).unwrap();
        assert!(place(b"moov") < place(b"mdat"));
    }
}

/// One frame in two seconds can be found without those before it.
#[test]
fn a_player_can_begin_within_the_film() {
    let bytes = film([64, 48], 45, 10.0);
    let place = bytes.windows(4).position(|name| name == b"stss").unwrap();
    let number = |index: usize| {
        let start = place + 8 + 4 * index;
        u32::from_be_bytes(bytes[start..start + 4].try_into().unwrap())
    };
    let whole: Vec<u32> = (1..=number(0) as usize).map(number).collect();
    assert_eq!(whole, [1, 21, 41]);
}

#[test]
fn odd_pictures_repeat_their_last_column_and_row() {
    let size = [33, 21];
    let levels = |column: usize| if column < 32 { [60; 3] } else { [200; 3] };
    let picture = Plane::from_fn(33, 21, |column, _| levels(column));
    let mut bytes = Cursor::new(Vec::new());
    let mut writer = Writer::new(&mut bytes, size, 1, Rate::new(25.0).unwrap()).unwrap();
    writer.write(&picture).unwrap();
    writer.finish().unwrap();
    let (found, end) = frames(&mut Mp4Source::new(bytes, "film.mp4").unwrap());
    assert!(end.is_ok());
    let found = &found[0].samples.eight_bits().luma;
    assert_eq!([found.width(), found.height()], [34, 22]);
    for row in 0..22 {
        for column in 0..34 {
            let [expected, ..] = encoded(levels(column));
            let error = f64::from(found.row(row)[column]) - expected;
            assert!(error.abs() < 4.0, "({column}, {row}): {error}");
        }
    }
}

/// A file on a full disk.
struct Full(Cursor<Vec<u8>>, u64);

impl Write for Full {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.0.position() + bytes.len() as u64 > self.1 {
            return Err(io::Error::other("the disk is full"));
        }
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Seek for Full {
    fn seek(&mut self, place: SeekFrom) -> io::Result<u64> {
        self.0.seek(place)
    }
}

#[test]
fn what_cannot_be_written_is_named() {
    let rate = Rate::new(25.0).unwrap();
    let new = |size| Writer::new(Cursor::new(Vec::new()), size, 1, rate);
    for size in [[0, 0], [14, 64], [3842, 100], [2400, 2200], [64, 13]] {
        let error = new(size).err().unwrap();
        assert!(matches!(error, VideoError::EncodedSize { size: found } if found == size));
        let message = error.to_string();
        assert!(
            message.contains(&format!("{} × {}", size[0], size[1])),
            "{message}"
        );
    }
    assert!(new([15, 2160]).is_ok());
    let mut writer = new([32, 32]).unwrap();
    let other = writer.write(&Plane::filled(32, 30, [0; 3]));
    assert!(matches!(
        other,
        Err(VideoError::KeyFrameSize { frame: 0, .. })
    ));
    // Without a picture there is no film.
    assert!(matches!(writer.finish(), Err(VideoError::Encoding { .. })));

    let whole = film([64, 48], 5, 25.0).len() as u64;
    for room in [100, 2000, whole - 1] {
        let disk = Full(Cursor::new(Vec::new()), room);
        let written = Writer::new(disk, [64, 48], 5, rate).and_then(|mut writer| {
            for frame in 0..5 {
                writer.write(&picture([64, 48], frame))?;
            }
            writer.finish()
        });
        let error = written.unwrap_err();
        let is_write = matches!(
            error,
            VideoError::Write { .. } | VideoError::WriteIndex { .. }
        );
        assert!(is_write, "{room}: {error}");
        assert!(error.to_string().contains("the disk is full"), "{error}");
    }
}

/// What a program prints; `None` where it is not installed.
fn output(program: &str, arguments: &[&str], file: &Path) -> Option<String> {
    let mut command = Command::new(program);
    let output = match command.args(arguments).arg(file).output() {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            println!("skipped: {program} is not installed");
            return None;
        }
        output => output.unwrap(),
    };
    assert!(output.status.success(), "{output:?}");
    Some(String::from_utf8(output.stdout).unwrap())
}

/// Another program finds the same frames, bit for bit, with their times and colours.
#[test]
fn ffmpeg_reads_the_same_film() {
    let folder = tempfile::tempdir().unwrap();
    let [path, decoded] = ["film.mp4", "film.y4m"].map(|name| folder.path().join(name));
    std::fs::write(&path, film([176, 144], 60, 24e3 / 1001.0)).unwrap();
    let entries = "stream=codec_name,width,height,r_frame_rate,avg_frame_rate,nb_read_frames,\
        color_range,color_space,pix_fmt,duration";
    let arguments = [
        "-v",
        "error",
        "-count_frames",
        "-of",
        "default=noprint_wrappers=1",
    ];
    let probe = [&arguments[..], &["-show_entries", entries]].concat();
    let Some(said) = output("ffprobe", &probe, &path) else {
        return;
    };
    for line in [
        "codec_name=h264",
        "width=176",
        "height=144",
        "r_frame_rate=24000/1001",
        "avg_frame_rate=24000/1001",
        "nb_read_frames=60",
        "color_range=tv",
        "color_space=bt709",
        "pix_fmt=yuv420p",
        "duration=2.502500",
    ] {
        assert!(said.lines().any(|found| found == line), "{line}: {said}");
    }
    let input = path.to_str().unwrap();
    let convert = ["-v", "error", "-i", input, "-f", "yuv4mpegpipe"];
    if output("ffmpeg", &convert, &decoded).is_none() {
        return;
    }
    let [ours, theirs] = [&path, &decoded].map(|path| frames(&mut *open(path).unwrap()).0);
    assert_eq!((ours.len(), theirs.len()), (60, 60));
    for (a, b) in ours.iter().zip(&theirs) {
        assert!(a.samples == b.samples, "frame {}", a.index);
    }
}
