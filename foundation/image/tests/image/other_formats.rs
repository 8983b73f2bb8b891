//! TIFF, BMP and WebP files that Pillow and OpenCV wrote, of pixels that are known by formulas.

use ga_image::file::{self, Format, FormatError};
use ga_image::picture::Picture;
use ga_image::plane::Plane;

use crate::data;

/// The colours of most of the files.
pub(crate) fn colours() -> Plane<[u8; 3]> {
    Plane::from_fn(7, 5, |column, row| {
        [
            30 * column + 5 * row,
            40 * row + column,
            255 - 20 * column - 9 * row,
        ]
        .map(|v| v as u8)
    })
}

#[test]
fn files_of_other_programs_have_their_pixels() {
    let read = |name| file::read(data(name)).unwrap();
    for name in ["rgb.bmp", "rgb_lzw.tif"] {
        assert_eq!(read(name), colours().into(), "{name}");
    }
    let deep = Plane::from_fn(7, 5, |column, row| (500 * column + 200 * row + 3) as u16);
    assert_eq!(read("grey12.tif"), deep.into());
    let grey = Plane::from_fn(7, 5, |column, row| [(10 * column + row) as u8; 3]);
    assert_eq!(read("grey.bmp"), grey.into());
    let transparent = Plane::from_fn(7, 5, |column, row| {
        let [r, g, b] = colours().row(row)[column];
        [r, g, b, (50 * row + 3 * column) as u8]
    });
    assert_eq!(read("rgba.webp"), transparent.into());
    let Picture::Rgb8(even) = read("lossy.webp") else {
        panic!("not RGB");
    };
    assert_eq!((even.width(), even.height()), (60, 40));
    let is_near = |pixel: &[u8; 3]| (0..3).all(|k| pixel[k].abs_diff([200, 100, 50][k]) <= 4);
    assert!(even.values().iter().all(is_near));
}

#[test]
fn formats_are_known_by_their_beginning() {
    for (name, format) in [
        ("rgb.bmp", Format::Bmp),
        ("grey12.tif", Format::Tiff),
        ("rgba.webp", Format::WebP),
        ("lossy.webp", Format::WebP),
        ("turned.png", Format::Png),
    ] {
        assert_eq!(file::detect(data(name)).unwrap(), Some(format), "{name}");
    }
}

/// 60,000 × 60,000 pixels in files of a few bytes.
#[test]
fn pictures_that_are_too_large_are_refused() {
    let side = 60_000u32.to_le_bytes();
    let mut bitmap = std::fs::read(data("rgb.bmp")).unwrap();
    bitmap[18..22].copy_from_slice(&side);
    bitmap[22..26].copy_from_slice(&side);
    let mut tiff = std::fs::read(data("grey12.tif")).unwrap();
    let directory = u32::from_le_bytes(tiff[4..8].try_into().unwrap()) as usize;
    for tag in [256u16, 257, 278] {
        let entries = tiff[directory + 2..].chunks(12);
        let place = entries.map(|entry| u16::from_le_bytes([entry[0], entry[1]]));
        let place = directory + 2 + 12 * place.clone().position(|found| found == tag).unwrap();
        // The type: whole numbers of 32 bits.
        tiff[place + 2] = 4;
        tiff[place + 8..place + 12].copy_from_slice(&side);
    }
    for (bytes, format) in [(bitmap, "BMP"), (tiff, "TIFF")] {
        let error = file::decode(&bytes).unwrap_err();
        assert!(matches!(error, FormatError::TooLarge { .. }), "{error}");
        assert_eq!(
            error.to_string(),
            format!(
                "{format}: the header claims 60000 × 60000 pixels, which take more than \
                 1073741824 bytes"
            )
        );
    }
}

/// Whatever comes out, there is no panic; and what is cut off is missed.
#[test]
fn changed_and_shortened_files_give_a_picture_or_an_error() {
    let names = [
        "rgb.bmp",
        "grey.bmp",
        "rgb_lzw.tif",
        "grey12.tif",
        "turned.tif",
    ];
    for name in names
        .into_iter()
        .chain(["rgba.webp", "lossy.webp", "turned.webp", "turned.png"])
    {
        let bytes = std::fs::read(data(name)).unwrap();
        assert!(file::decode(&bytes[..bytes.len() / 2]).is_err(), "{name}");
        for place in 0..bytes.len() {
            for change in [0x01, 0x55, 0xff] {
                let mut changed = bytes.clone();
                changed[place] ^= change;
                let _ = file::decode(&changed);
            }
        }
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("cut.webp");
    std::fs::write(&path, &std::fs::read(data("lossy.webp")).unwrap()[..40]).unwrap();
    let message = file::read(&path).unwrap_err().to_string();
    assert!(message.contains("cut.webp: WebP: "), "{message}");
}
