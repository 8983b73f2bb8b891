//! Pictures read from files that other programs wrote, and written and read again.

use ga_image::file::{self, FileError, FormatError};
use ga_image::grey::Luma;
use ga_image::pfm::ByteOrder;
use ga_image::picture::{Picture, PictureView};
use ga_image::plane::Plane;
use ga_image::{pfm, png, pnm};
use nullcone_shared_data::shared;
use proptest::prelude::*;

use crate::data;

#[test]
fn png_files_written_byte_by_byte_have_their_pixels() {
    let read = |name| file::read(data(name)).unwrap();
    assert_eq!(
        read("grey16.png"),
        Plane::from_values(3, 2, vec![0u16, 1, 256, 65535, 4660, 770])
            .unwrap()
            .into()
    );
    assert_eq!(
        read("rgba16.png"),
        Plane::from_values(2, 1, vec![[1u16, 2, 3, 4], [65535, 500, 600, 700]])
            .unwrap()
            .into()
    );
    let bits = [1u8, 0, 1, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1, 1, 0];
    let grey = bits.iter().map(|bit| 255 * bit).collect();
    assert_eq!(
        read("bits.png"),
        Plane::from_values(10, 2, grey).unwrap().into()
    );
    let colours = [[255, 0, 0], [0, 128, 0], [1, 2, 3]];
    let indices = [0, 1, 2, 0, 2, 0, 1, 1];
    let opaque = indices.iter().map(|i| colours[*i]).collect();
    assert_eq!(
        read("palette_opaque.png"),
        Plane::<[u8; 3]>::from_values(4, 2, opaque).unwrap().into()
    );
    let transparent = indices.iter().map(|i| {
        let [red, green, blue] = colours[*i];
        [red, green, blue, [255, 64, 255][*i]]
    });
    assert_eq!(
        read("palette.png"),
        Plane::<[u8; 4]>::from_values(4, 2, transparent.collect())
            .unwrap()
            .into()
    );
}

/// OpenCV computed the grey picture from the colours.
#[test]
fn grey_is_that_of_opencv() {
    let Some(folder) = shared("oracle/vision/seed1") else {
        return;
    };
    let read = |name: &str| file::read(folder.join(name)).unwrap();
    let (colours, grey) = (read("base.png"), read("gray.png"));
    assert!(matches!(colours, Picture::Rgb8(_)));
    assert!(Picture::from(colours.to_grey::<u8>(Luma::Bt601)) == grey);
}

/// The pixels are those that libjpeg-turbo decodes (by Pillow).
#[test]
fn jpeg_files_are_read() {
    let Some(folder) = shared("data/vision/opencv") else {
        return;
    };
    let grey = file::read(folder.join("left01.jpg")).unwrap();
    let Picture::Grey8(plane) = &grey else {
        panic!("{}", grey.view().kind())
    };
    assert_eq!((plane.width(), plane.height()), (640, 480));
    for (column, row, expected) in JPEG_GREY {
        let got = plane.get(column, row).unwrap();
        assert!(got.abs_diff(expected) <= 2, "{got}, not {expected}");
    }
    let colour = file::read(folder.join("aloeL.jpg")).unwrap();
    let Picture::Rgb8(plane) = &colour else {
        panic!("{}", colour.view().kind())
    };
    assert_eq!((plane.width(), plane.height()), (1282, 1110));
    for (column, row, expected) in JPEG_COLOUR {
        let got = plane.get(column, row).unwrap();
        for channel in 0..3 {
            assert!(
                got[channel].abs_diff(expected[channel]) <= 4,
                "{got:?}, not {expected:?}"
            );
        }
    }
}

const JPEG_GREY: [(usize, usize, u8); 4] = [
    (100, 200, 64),
    (101, 200, 64),
    (320, 240, 28),
    (500, 77, 22),
];

const JPEG_COLOUR: [(usize, usize, [u8; 3]); 5] = [
    (0, 0, [175, 188, 142]),
    (100, 200, [185, 187, 166]),
    (641, 555, [182, 174, 128]),
    (1281, 1109, [234, 234, 200]),
    (900, 300, [174, 144, 80]),
];

#[test]
fn middleburys_disparities_are_read() {
    let Some(path) = shared("data/vision/middlebury/motorcycle_disp.pfm") else {
        return;
    };
    let Picture::GreyF32(disparity) = file::read(path).unwrap() else {
        panic!("not grey floats")
    };
    assert_eq!((disparity.width(), disparity.height()), (741, 500));
    // The oracle's table of depths states these disparities.
    assert_eq!(disparity.get(543, 346), Some(50.514_038));
    assert_eq!(disparity.get(357, 255), Some(48.701_447));
}

#[test]
fn netpbm_files_of_every_kind_are_read() {
    let grey = Plane::from_values(3, 1, vec![0u8, 128, 255]).unwrap();
    for bytes in [
        &b"P2 3 1 255 0 128 255"[..],
        b"P2\n# by hand\n3 1 # size\n255\n0\n128 255\n",
        b"P5 3 1 255\n\x00\x80\xff",
        b"P5\t3\r\n1\n255 \x00\x80\xff and what follows",
    ] {
        assert_eq!(file::decode(bytes).unwrap(), grey.clone().into());
    }
    // 1 of 3 is 85 of 255.
    let scaled = Plane::from_values(4, 1, vec![0u8, 85, 170, 255]).unwrap();
    assert_eq!(file::decode(b"P2 4 1 3 0 1 2 3").unwrap(), scaled.into());
    let deep = Plane::from_values(1, 2, vec![[1u16, 256, 65535], [2, 3, 4]]).unwrap();
    for bytes in [
        &b"P3 1 2 65535 1 256 65535 2 3 4"[..],
        b"P6 1 2 65535\n\0\x01\x01\0\xff\xff\0\x02\0\x03\0\x04",
    ] {
        assert_eq!(file::decode(bytes).unwrap(), deep.clone().into());
    }
}

#[test]
fn text_of_netpbm_has_short_lines() {
    let plane = Plane::filled(40, 2, [65535u16, 1, 300]);
    let text = pnm::encode_text(&plane).unwrap();
    assert!(text.lines().all(|line| line.len() <= 70));
    assert_eq!(pnm::decode(text.as_bytes()).unwrap(), plane.into());
}

#[test]
fn floats_of_both_byte_orders_are_read_from_the_bottom() {
    let little = b"PF\n1 2\n-1.0\n\0\0\x80\x3f\0\0\0\x40\0\0\x40\x40\0\0\0\0\0\0\0\0\0\0\x80\xbf";
    let big = b"PF\n1 2\n1.0\n\x3f\x80\0\0\x40\0\0\0\x40\x40\0\0\0\0\0\0\0\0\0\0\xbf\x80\0\0";
    let plane = Plane::from_values(1, 2, vec![[0.0, 0.0, -1.0f32], [1.0, 2.0, 3.0]]).unwrap();
    assert_eq!(pfm::decode(little).unwrap(), plane.clone().into());
    assert_eq!(pfm::decode(big).unwrap(), plane.clone().into());
    assert_eq!(pfm::encode(&plane, ByteOrder::Little).unwrap(), little);
    assert_eq!(pfm::encode(&plane, ByteOrder::Big).unwrap(), big);
}

/// Written under Windows, the lines of a header may end in CR LF. Where only the last one does, the
/// length of the file tells whether the LF is data.
#[test]
fn headers_of_floats_end_in_any_line_end() {
    // Its first byte is LF.
    let first = f32::from_le_bytes([b'\n', 0, 0x50, 0x40]);
    let plane = Plane::from_values(1, 2, vec![-1.5, first]).unwrap();
    let data = [first, -1.5].map(f32::to_le_bytes).concat();
    for header in [
        "Pf\n1 2\n-1.0\n",
        "Pf\r\n1 2\r\n-1.0\r\n",
        "Pf\n1 2\n-1.0\r\n",
        "Pf 1 2 -1.0\r\n",
        "Pf\r1 2\r-1.0\r",
        "Pf 1 2 -1.0 ",
    ] {
        let file = [header.as_bytes(), &data].concat();
        assert_eq!(
            pfm::decode(&file).unwrap(),
            plane.clone().into(),
            "{header:?}"
        );
    }
    for header in [
        "Pf\n1 2\n-1.0\n",
        "Pf\r\n1 2\r\n-1.0\r\n",
        "Pf\n1 2\n-1.0\r\n",
    ] {
        let header = header.as_bytes();
        for (bytes, found) in [
            ([header, &data, b"\0"].concat(), 9),
            ([header, &data, &[7; 4000]].concat(), 4008),
            ([header, &data[..7]].concat(), 7),
            ([header, &data[1..]].concat(), 7),
            (header.to_vec(), 0),
        ] {
            let error = pfm::decode(&bytes).unwrap_err();
            let message = format!(
                "PFM: the header claims 1 × 2 pixels, which are 8 bytes, and {found} bytes follow it"
            );
            assert_eq!(error.to_string(), message);
        }
    }
    // The letters that tell the format are the first two bytes.
    for before in [" ", "\n", "#\n"] {
        let file = [before.as_bytes(), b"Pf 1 2 -1.0 ", &data].concat();
        assert!(pfm::decode(&file).is_err(), "{before:?}");
    }
}

fn comes_back<'a>(picture: impl Into<PictureView<'a>>) -> Result<(), TestCaseError> {
    let picture: PictureView<'_> = picture.into();
    prop_assert_eq!(
        png::decode(&png::encode(picture).unwrap()).unwrap(),
        picture.to_picture()
    );
    Ok(())
}

proptest! {
    #[test]
    fn what_is_written_is_read_again(
        (width, height) in (1usize..20, 1usize..20),
        seed in any::<u32>(),
    ) {
        let number = |column: usize, row: usize, channel: usize| {
            let mixed = (column + 31 * row + 997 * channel) as u32;
            (mixed.wrapping_mul(2_654_435_761).wrapping_add(seed) >> 8) as u16
        };
        let deep = Plane::from_fn(width, height, |c, r| [0, 1, 2, 3].map(|i| number(c, r, i)));
        let shallow = deep.map(|pixel| pixel.map(|v| (v >> 8) as u8));
        comes_back(&deep)?;
        comes_back(&shallow)?;
        comes_back(&deep.map(|[r, g, ..]| [r, g]))?;
        comes_back(&shallow.map(|[r, g, ..]| [r, g]))?;
        let (deep, shallow) = (deep.map(|[r, g, b, _]| [r, g, b]), shallow.map(|[r, g, b, _]| [r, g, b]));
        comes_back(&deep)?;
        comes_back(&shallow)?;
        prop_assert_eq!(pnm::decode(&pnm::encode(&deep).unwrap()).unwrap(), deep.clone().into());
        prop_assert_eq!(pnm::decode(&pnm::encode(&shallow).unwrap()).unwrap(), shallow.clone().into());
        let (deep, shallow) = (deep.map(|[r, ..]| r), shallow.map(|[r, ..]| r));
        comes_back(&deep)?;
        comes_back(&shallow)?;
        prop_assert_eq!(pnm::decode(&pnm::encode(&deep).unwrap()).unwrap(), deep.clone().into());
        prop_assert_eq!(
            pnm::decode(pnm::encode_text(&shallow).unwrap().as_bytes()).unwrap(),
            shallow.clone().into()
        );
        // A part of a picture is written without what lies around it.
        let part = shallow.view().part(width / 2, height / 2, width - width / 2, height - height / 2);
        comes_back(part.unwrap())?;
    }
}

/// The crate `image` reads what this one writes.
#[test]
fn other_readers_understand_what_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("deep.png");
    let plane = Plane::from_fn(5, 4, |column, row| {
        [1000 * column as u16, row as u16, 65535]
    });
    file::write(&path, &plane).unwrap();
    let read = image::open(&path).unwrap().into_rgb16();
    assert_eq!(read.into_raw(), plane.values().as_flattened());
}

#[test]
fn a_picture_without_a_form_in_the_format_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("depth.png");
    let error = file::write(&path, &Plane::filled(2, 2, 0.5f32)).unwrap_err();
    assert!(matches!(
        error,
        FileError::Contents {
            problem: FormatError::Kind { .. },
            ..
        }
    ));
    assert!(
        error
            .to_string()
            .ends_with("depth.png: PNG cannot hold grey of floats")
    );
    assert!(!path.exists());
    let error = file::write(folder.path().join("a.jpg"), &Plane::filled(2, 2, 0u8)).unwrap_err();
    assert!(matches!(error, FileError::Unknown { .. }));
    assert!(png::encode(&Plane::filled(0, 2, 0u8)).is_err());
    assert!(pnm::encode(&Plane::filled(1, 2, [0u8; 2])).is_err());
    assert!(pnm::encode_text(&Plane::filled(1, 2, 0.0f32)).is_err());
    assert!(pfm::encode(&Plane::filled(1, 2, 0u8), ByteOrder::Big).is_err());
    let indices = Plane::filled(2, 2, 3u8);
    assert!(png::encode_indexed(&indices, &[[0; 3]; 3]).is_err());
    assert!(png::encode_indexed(&indices, &[[0; 3]; 257]).is_err());
}

#[test]
fn a_file_of_no_known_format_says_how_it_begins() {
    let error = file::decode(b"GIF89a").unwrap_err();
    assert!(matches!(error, FormatError::UnknownFormat { .. }));
    assert!(error.to_string().contains("[47, 49, 46, 38, 39, 61]"));
    assert!(file::decode(b"").is_err());
}
