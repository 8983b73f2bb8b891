//! Files that lie about their size, end early or are not what they seem: an error, no panic, and no
//! memory for what is not there.

use ga_image::file::{self, FormatError};
use ga_image::plane::Plane;
use ga_image::{pfm, png, pnm, y4m};
use nullcone_shared_data::shared;
use proptest::prelude::*;

use crate::data;

#[test]
fn claims_that_the_file_cannot_hold_are_errors() {
    let mut claims = vec![std::fs::read(data("claim.png")).unwrap()];
    claims.extend(
        [
            "P5 1000000 1000000 255\n",
            "P2 1000000 1000000 255\n0 0 0",
            "P6 18446744073709551615 18446744073709551615 255\n",
            "Pf 100000 100000 -1.0\n",
            "YUV4MPEG2 W4000000000 H4000000000 F25:1\nFRAME\n",
        ]
        .map(Vec::from),
    );
    // A frame header of 65,535 × 65,535 pixels.
    let mut jpeg = vec![
        0xff, 0xd8, 0xff, 0xc0, 0, 11, 8, 0xff, 0xff, 0xff, 0xff, 1, 1, 0x11, 0,
    ];
    jpeg.extend([0xff, 0xda, 0, 8, 1, 1, 0, 0, 63, 0, 1, 2, 3]);
    claims.push(jpeg);
    for bytes in claims {
        let error = file::decode(&bytes).unwrap_err();
        assert!(matches!(error, FormatError::Claim { .. }), "{error}");
    }
}

#[test]
fn errors_say_where_and_why() {
    let message = |bytes: &[u8]| file::decode(bytes).unwrap_err().to_string();
    assert_eq!(
        message(b"P5 3 x 255\n"),
        "PNM, byte 6: a whole number is expected"
    );
    assert_eq!(
        message(b"P2 2 1 9 3 10"),
        "PNM, byte 13: a sample is greater than the greatest number of the header"
    );
    assert_eq!(
        message(b"P5 1 1 0\n1"),
        "PNM, byte 8: the greatest number is not between 1 and 65535"
    );
    assert_eq!(
        message(b"Pf 1 1 0\n1234"),
        "PFM, byte 8: the scale is neither positive nor negative"
    );
    assert_eq!(
        message(b"YUV4MPEG2 W2 H2 C411\nFRAME\n123456"),
        "Y4M: the sampling 411 is not supported"
    );
    assert_eq!(
        message(b"Pf 1 1 -1\n1234 and more"),
        "PFM: the header claims 1 × 1 pixels, which are 4 bytes, and 13 bytes follow it"
    );
    assert!(message(b"P5").contains("the file ends where a number is expected"));
}

fn samples() -> Vec<Vec<u8>> {
    let plane = Plane::from_fn(9, 6, |column, row| [column as u8, row as u8, 100]);
    let deep = plane.map(|pixel| pixel.map(u16::from));
    vec![
        png::encode(&plane).unwrap(),
        png::encode(&deep).unwrap(),
        pnm::encode(&plane).unwrap(),
        pnm::encode_text(&deep).unwrap().into_bytes(),
        pfm::encode(&plane.map(|p| p.map(f32::from)), pfm::ByteOrder::Big).unwrap(),
        y4m::encode([&plane, &plane], y4m::Film::default()).unwrap(),
    ]
}

#[test]
fn shortened_files_are_errors() {
    for bytes in samples() {
        // A film may end after any frame.
        let whole = if bytes.starts_with(b"YUV") {
            bytes.len() / 2
        } else {
            bytes.len() - 1
        };
        for length in 0..whole.min(bytes.len() - 13) {
            assert!(file::decode(&bytes[..length]).is_err(), "{length}");
        }
    }
}

proptest! {
    #[test]
    fn changed_files_give_a_picture_or_an_error(
        which in 0usize..6,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let mut bytes = samples().swap_remove(which);
        for (place, value) in changes {
            let place = place.index(bytes.len());
            bytes[place] = value;
        }
        // Whatever comes out: there must be no panic.
        let _ = file::decode(&bytes);
    }
}

#[test]
fn changed_and_shortened_jpeg_files_give_a_picture_or_an_error() {
    let Some(path) = shared("data/vision/opencv/left01.jpg") else {
        return;
    };
    let bytes = std::fs::read(path).unwrap();
    assert!(file::decode(&bytes[..bytes.len() / 2]).is_err());
    for place in (0..700).step_by(7) {
        let mut changed = bytes.clone();
        changed[place] ^= 0x55;
        let _ = file::decode(&changed);
    }
}
