//! Numbered pictures.

use std::path::Path;

use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_video::images::ImageSource;
use ga_video::{Source, VideoError, open, open_with_stills};
use tempfile::TempDir;

use super::frames;

fn row(names: &[&str]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (index, name) in names.iter().enumerate() {
        write(&folder.path().join(name), [6, 4], index);
    }
    folder
}

fn write(path: &Path, [width, height]: [usize; 2], index: usize) {
    let picture = Plane::from_fn(width, height, |c, r| {
        [40 * c, 60 * r, 50 * index].map(|v| v as u8)
    });
    file::write(path, &picture).unwrap();
}

fn error(path: impl AsRef<Path>) -> VideoError {
    ImageSource::new(path, None).err().unwrap()
}

#[test]
fn a_folder_a_pattern_and_a_first_picture_are_one_row() {
    let folder = row(&["shot2_0009.png", "shot2_0010.png", "shot2_0011.png"]);
    std::fs::write(folder.path().join("notes.txt"), "7").unwrap();
    let ways = [
        folder.path().to_path_buf(),
        folder.path().join("shot2_%04d.png"),
        folder.path().join("shot2_0009.png"),
    ];
    for way in ways {
        let mut source = open(&way).unwrap();
        let properties = *source.properties();
        assert_eq!((properties.size, properties.frame_count), ([6, 4], Some(3)));
        let (found, end) = frames(&mut *source);
        assert!(end.is_ok());
        assert_eq!(found.len(), 3, "{}", way.display());
        for (index, frame) in found.iter().enumerate() {
            assert_eq!(
                (frame.index, frame.time_seconds),
                (index, index as f64 * 0.04)
            );
            let picture =
                Plane::from_fn(6, 4, |c, r| [40 * c, 60 * r, 50 * index].map(|v| v as u8));
            // Luma is grey as pictures have it, and colours come back.
            let grey = Luma::Bt601.plane(&picture);
            let planes = frame.samples.eight_bits();
            for (a, b) in planes.luma.values().iter().zip(grey.values()) {
                assert!(a.abs_diff(*b) <= 1);
            }
            let back = frame.to_rgb(properties.colours);
            for (a, b) in back.values().iter().zip(picture.values()) {
                assert!((0..3).all(|i| a[i].abs_diff(b[i]) <= 2), "{a:?}, not {b:?}");
            }
        }
    }
    // From the second picture on.
    let mut source = open(folder.path().join("shot2_0010.png")).unwrap();
    assert_eq!(frames(&mut *source).0.len(), 2);
}

#[test]
fn a_picture_alone_can_be_a_video_of_one_frame() {
    let folder = row(&["left.png", "c3_L.png", "c4_L.png"]);
    for name in ["left.png", "c3_L.png"] {
        let mut source = open_with_stills(folder.path().join(name)).unwrap();
        assert_eq!(source.properties().frame_count, Some(1));
        let (found, end) = frames(&mut *source);
        assert_eq!((found.len(), end.is_ok()), (1, true), "{name}");
    }
    // The rows are still there.
    let row = open_with_stills(folder.path().join("c%d_L.png")).unwrap();
    assert_eq!(row.properties().frame_count, Some(2));
    std::fs::write(folder.path().join("left.png"), "\u{89}PNG and no more").unwrap();
    let found = open_with_stills(folder.path().join("left.png"))
        .err()
        .unwrap();
    assert!(found.to_string().contains("left.png"), "{found}");
}

#[test]
fn numbers_count_and_not_their_digits() {
    let folder = row(&["8.png", "9.png", "10.png", "11.png"]);
    let mut source = open(folder.path()).unwrap();
    let (found, _) = frames(&mut *source);
    // Blue says in which order the files were written.
    let blues: Vec<u8> = found
        .iter()
        .map(|frame| frame.to_rgb(source.properties().colours).get(0, 0).unwrap()[2])
        .collect();
    for (blue, expected) in blues.iter().zip([0, 50, 100, 150]) {
        assert!(blue.abs_diff(expected) <= 2, "{blues:?}");
    }
}

#[test]
fn gaps_and_other_faults_are_named() {
    let folder = row(&["a_08.png", "a_09.png", "a_11.png"]);
    let found = error(folder.path());
    assert_eq!(found.frame(), Some(2));
    let message = found.to_string();
    assert!(
        message.ends_with("a_10.png: the picture of frame 2 is missing"),
        "{message}"
    );

    let folder = row(&["a_1.png", "b_1.png"]);
    assert!(error(folder.path()).to_string().contains("several rows"));
    assert!(ImageSource::new(folder.path().join("b_%d.png"), None).is_ok());
    let folder = row(&["a_1.png", "a_01.png"]);
    assert!(error(folder.path()).to_string().contains("the same number"));
    let folder = row(&["picture.png"]);
    assert!(matches!(error(folder.path()), VideoError::Empty { .. }));
    let found = error(folder.path().join("picture.png")).to_string();
    assert!(
        found.contains("the name of the picture has no number"),
        "{found}"
    );
    let found = error(folder.path().join("x_%03d.png"));
    assert!(matches!(found, VideoError::Empty { .. }), "{found}");
    let folder = row(&["a_99999999999999999999.png"]);
    assert!(error(folder.path()).to_string().contains("too large"));
}

#[test]
fn pictures_that_do_not_fit_are_named_and_those_before_stay() {
    let folder = row(&["a1.png", "a2.png", "a3.png", "a4.png"]);
    write(&folder.path().join("a3.png"), [6, 5], 0);
    let (found, end) = frames(&mut *open(folder.path()).unwrap());
    assert_eq!(found.len(), 2);
    let message = end.unwrap_err().to_string();
    let expected = "a3.png: frame 2 has 6 × 5 pixels, the first has 6 × 4";
    assert!(message.ends_with(expected), "{message}");

    std::fs::write(folder.path().join("a3.png"), "no picture").unwrap();
    let (found, end) = frames(&mut *open(folder.path()).unwrap());
    assert_eq!(found.len(), 2);
    let found = end.unwrap_err();
    assert_eq!(found.frame(), Some(2));
    assert!(found.to_string().contains("a3.png"), "{found}");
}
