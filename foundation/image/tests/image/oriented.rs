//! Files that note which side of the picture is up. What each number means is that of Exif 2.32,
//! tag 274: which sides of the upright picture the first row and the first column are.

use ga_image::file;
use ga_image::orientation::Orientation;
use ga_image::picture::Picture;
use ga_image::plane::Plane;
use ga_image::{jpeg, png};

use crate::data;
use crate::other_formats::colours;

/// A side of the upright picture.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Side {
    Top,
    Right,
    Bottom,
    Left,
}

use Side::{Bottom, Left, Right, Top};

/// Where the first row and the first column are, of orientation 1 and so on.
const SIDES: [[Side; 2]; 8] = [
    [Top, Left],
    [Top, Right],
    [Bottom, Right],
    [Bottom, Left],
    [Left, Top],
    [Right, Top],
    [Right, Bottom],
    [Left, Bottom],
];

/// The stored pixel that is to be seen at a place of the upright picture.
fn stored_place([row, column]: [Side; 2], place: [usize; 2], stored: [usize; 2]) -> [usize; 2] {
    let upright = if matches!(row, Top | Bottom) {
        stored
    } else {
        [stored[1], stored[0]]
    };
    // How far a place is from a side.
    let from = |side: Side| match side {
        Top => place[1],
        Bottom => upright[1] - 1 - place[1],
        Left => place[0],
        Right => upright[0] - 1 - place[0],
    };
    [from(column), from(row)]
}

/// Exif metadata, in either order of bytes, that note an orientation alone.
fn exif(orientation: u8, big_endian: bool) -> Vec<u8> {
    let (begin, one, tag, three) = if big_endian {
        (&b"MM\0\x2a\0\0\0\x08"[..], [0, 1], [0x01, 0x12], [0, 3])
    } else {
        (&b"II\x2a\0\x08\0\0\0"[..], [1, 0], [0x12, 0x01], [3, 0])
    };
    let (count, value) = match big_endian {
        true => ([0, 0, 0, 1], [0, orientation, 0, 0]),
        false => ([1, 0, 0, 0], [orientation, 0, 0, 0]),
    };
    [begin, &one, &tag, &three, &count, &value, &[0; 4]].concat()
}

#[test]
fn planes_are_oriented_as_exif_defines() {
    let stored = Plane::from_fn(5, 3, |column, row| 10 * row + column);
    for (index, sides) in SIDES.into_iter().enumerate() {
        let orientation = Orientation::from_exif(index as u8 + 1).unwrap();
        let upright = stored.oriented(orientation);
        let turned = matches!(sides[0], Left | Right);
        let size = if turned { (3, 5) } else { (5, 3) };
        assert_eq!((upright.width(), upright.height()), size);
        for (row, pixels) in upright.view().rows().enumerate() {
            for (column, pixel) in pixels.iter().enumerate() {
                let [c, r] = stored_place(sides, [column, row], [5, 3]);
                assert_eq!(*pixel, 10 * r + c, "{orientation:?} at {column}, {row}");
            }
        }
    }
}

#[test]
fn jpeg_files_are_upright() {
    // Four fields of one colour each, in blocks of 16 pixels.
    let field = |column: usize, row: usize| match (column < 32, row < 16) {
        (true, true) => [220u8, 30, 30],
        (false, true) => [30, 220, 30],
        (true, false) => [30, 30, 220],
        (false, false) => [220, 220, 220],
    };
    let stored = jpeg::encode(&Plane::from_fn(64, 32, field), 95).unwrap();
    for (index, sides) in SIDES.into_iter().enumerate() {
        for big_endian in [false, true] {
            let metadata = [b"Exif\0\0", &*exif(index as u8 + 1, big_endian)].concat();
            let length = (metadata.len() as u16 + 2).to_be_bytes();
            let segment = [&[0xff, 0xe1][..], &length, &metadata].concat();
            let bytes = [&stored[..2], &segment, &stored[2..]].concat();
            let read = file::decode_oriented(&bytes).unwrap();
            assert_eq!(usize::from(read.applied.to_exif()), index + 1);
            assert_eq!(read.change().is_none(), index == 0);
            assert_eq!(jpeg::decode(&bytes).unwrap(), read.picture);
            let picture = read.picture.to_rgb::<u8>();
            for [column, row] in [[5, 5], [25, 5], [5, 25], [25, 25]] {
                // The longer side has places from 0 to 63.
                let place = match picture.width() {
                    64 => [2 * column, row],
                    _ => [column, 2 * row],
                };
                let pixel = picture.row(place[1])[place[0]];
                let [c, r] = stored_place(sides, place, [64, 32]);
                let expected = field(c, r);
                assert!(
                    (0..3).all(|k| pixel[k].abs_diff(expected[k]) < 40),
                    "orientation {} at {place:?}: {pixel:?}, not {expected:?}",
                    index + 1
                );
            }
        }
    }
}

/// Pillow wrote the files.
#[test]
fn files_of_every_format_with_metadata_are_upright() {
    for (name, number) in [("turned.tif", 6), ("turned.webp", 8), ("turned.png", 8)] {
        let read = file::read_oriented(data(name)).unwrap();
        assert_eq!(read.applied.to_exif(), number, "{name}");
        let Picture::Rgb8(picture) = &read.picture else {
            panic!("{name} is not RGB");
        };
        assert_eq!((picture.width(), picture.height()), (5, 7), "{name}");
        let sides = SIDES[usize::from(number) - 1];
        for (row, pixels) in picture.view().rows().enumerate() {
            for (column, pixel) in pixels.iter().enumerate() {
                let [c, r] = stored_place(sides, [column, row], [7, 5]);
                assert_eq!(*pixel, colours().row(r)[c], "{name} at {column}, {row}");
            }
        }
        assert_eq!(file::read(data(name)).unwrap(), read.picture);
    }
}

/// PNG's chunk eXIf may stand before the pixels or behind them.
#[test]
fn metadata_behind_the_pixels_of_a_png_file_count() {
    let stored = Plane::from_values(2, 1, vec![1u8, 2]).unwrap();
    let bytes = png::encode(&stored).unwrap();
    let metadata = exif(3, true);
    let mut chunk = [b"eXIf", &*metadata].concat();
    let sum = crc(&chunk).to_be_bytes();
    chunk.splice(..0, (metadata.len() as u32).to_be_bytes());
    chunk.extend(sum);
    // The last chunk, IEND, has 12 bytes.
    let end = bytes.len() - 12;
    let bytes = [&bytes[..end], &chunk, &bytes[end..]].concat();
    let turned = Plane::from_values(2, 1, vec![2u8, 1]).unwrap();
    assert_eq!(png::decode(&bytes).unwrap(), turned.into());
}

#[test]
fn metadata_that_note_nothing_change_nothing() {
    let stored = Plane::from_fn(16, 8, |column, row| [column as u8, row as u8, 9]);
    let bytes = jpeg::encode(&stored, 95).unwrap();
    let plain = jpeg::decode(&bytes).unwrap();
    for metadata in [exif(0, true), exif(9, false), b"II*".to_vec(), vec![7; 40]] {
        let metadata = [b"Exif\0\0", &*metadata].concat();
        let length = (metadata.len() as u16 + 2).to_be_bytes();
        let segment = [&[0xff, 0xe1][..], &length, &metadata].concat();
        let bytes = [&bytes[..2], &segment, &bytes[2..]].concat();
        let read = file::decode_oriented(&bytes).unwrap();
        assert_eq!((read.change(), &read.picture), (None, &plain));
    }
}

/// The check sum of PNG, bit by bit, as its specification has it.
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |sum, byte| {
        (0..8).fold(sum ^ u32::from(*byte), |sum, _| {
            (sum >> 1) ^ if sum & 1 == 1 { 0xedb8_8320 } else { 0 }
        })
    })
}
