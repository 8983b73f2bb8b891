//! Single tags in rendered pictures.

use ga_image::picture::Picture;
use ga_image::plane::Plane;
use ga_vision::tag::{Dictionary, Tag, TagOptions, detect};

use super::scene::{View, rms};

const SIZE: [usize; 2] = [400, 320];

fn options(dictionary: Dictionary) -> TagOptions {
    TagOptions {
        dictionary,
        border: 1,
    }
}

/// The brightness of a tag whose border begins at the origin, in modules.
pub(super) fn tag_brightness(
    dictionary: Dictionary,
    id: usize,
    border: usize,
    [x, y]: [f64; 2],
) -> f64 {
    let modules = dictionary.modules(id).unwrap();
    let (data, end) = (dictionary.side(), (dictionary.side() + 2 * border) as f64);
    if !(0.0..end).contains(&x) || !(0.0..end).contains(&y) {
        return 1.0;
    }
    let [column, row] = [x, y].map(|place| (place as usize).wrapping_sub(border));
    let is_white = column < data && row < data && modules[row * data + column];
    f64::from(u8::from(is_white))
}

/// The corners of such a tag, clockwise from its top left one.
fn corners(view: &View, dictionary: Dictionary) -> [[f64; 2]; 4] {
    let end = (dictionary.side() + 2) as f64;
    [[0.0, 0.0], [end, 0.0], [end, end], [0.0, end]].map(|place| view.pixel(place))
}

/// One tag of each dictionary in every orientation, nearly from the side too.
#[test]
fn tags_of_every_dictionary_are_found_where_they_are() {
    let poses = [
        [0.0, 0.0, 0.0],
        [25.0, -10.0, 95.0],
        [-40.0, 20.0, 182.0],
        [10.0, 55.0, 260.0],
        [-55.0, -15.0, 317.0],
    ];
    let mut all = Vec::new();
    for (k, dictionary) in Dictionary::all().enumerate() {
        let middle = 0.5 * (dictionary.side() + 2) as f64;
        for (n, pose) in poses.into_iter().enumerate() {
            let id = (17 + 311 * k + 97 * n) % dictionary.count();
            let pixel = [117.0 + 3.3 * n as f64, 106.3 - 4.7 * n as f64];
            let view = View::new(pose, [middle; 2], (500.0, 34.0), pixel);
            let brightness = |place| tag_brightness(dictionary, id, 1, place);
            let picture = view.picture([240, 200], brightness, (0.7, 1.5), 7 * k as u64 + n as u64);
            let found = detect(&picture, options(dictionary));
            assert_eq!(found.len(), 1, "{dictionary} {id} {pose:?}");
            assert_eq!(
                (found[0].id, found[0].hamming),
                (id, 0),
                "{dictionary} {pose:?}"
            );
            let truth = corners(&view, dictionary);
            let error = rms(found[0].corners.into_iter().zip(truth));
            assert!(error < 0.12, "{dictionary} {pose:?}: {error} px");
            all.push(error);
        }
    }
    let mean = (all.iter().map(|error| error * error).sum::<f64>() / all.len() as f64).sqrt();
    assert!(mean < 0.05, "{mean} px");
}

/// Without noise nothing but the pixels limits the corners.
#[test]
fn corners_have_no_bias() {
    let dictionary = Dictionary::April36h11;
    for (n, blur) in [0.4, 0.7, 1.2].into_iter().enumerate() {
        let view = View::new([20.0, 30.0, 10.0], [4.0; 2], (500.0, 28.0), [200.4, 151.7]);
        let brightness = |place| tag_brightness(dictionary, 100, 1, place);
        let picture = view.picture(SIZE, brightness, (blur, 1e-6), n as u64);
        let found = detect(&picture, options(dictionary));
        let error = rms(found[0].corners.into_iter().zip(corners(&view, dictionary)));
        assert!(error < 0.03, "blur {blur}: {error} px");
    }
}

/// A tag of 2.5 pixels for each module, and one that fills the picture.
#[test]
fn small_and_large_tags_are_found() {
    let dictionary = Dictionary::Aruco4x4_50;
    let brightness = |place| tag_brightness(dictionary, 3, 1, place);
    for (distance, least) in [(200.0, 0.2), (14.0, 0.1)] {
        let view = View::new(
            [8.0, 5.0, 20.0],
            [3.0; 2],
            (500.0, distance),
            [200.0, 160.0],
        );
        let picture = view.picture(SIZE, brightness, (0.6, 1.0), 1);
        let found = detect(&picture, options(dictionary));
        let ids: Vec<usize> = found.iter().map(|tag| tag.id).collect();
        assert_eq!(ids, [3], "{distance}");
        let error = rms(found[0].corners.into_iter().zip(corners(&view, dictionary)));
        assert!(error < least, "{distance}: {error} px");
    }
}

/// Modules that are printed wrongly are corrected up to what a dictionary allows, and counted.
#[test]
fn wrong_modules_are_counted_and_too_many_are_refused() {
    let view = View::new([5.0, 10.0, 30.0], [4.0; 2], (500.0, 25.0), [200.0, 160.0]);
    for (wrong, expected) in [(0, Some(0)), (2, Some(2)), (3, Some(3)), (5, None)] {
        let brightness = |[x, y]: [f64; 2]| {
            let is_wrong = (1.0..2.0).contains(&y) && (1.0..1.0 + f64::from(wrong)).contains(&x);
            let right = tag_brightness(Dictionary::April36h11, 30, 1, [x, y]);
            if is_wrong { 1.0 - right } else { right }
        };
        let picture = view.picture(SIZE, brightness, (0.6, 1.0), 2);
        let found = detect(&picture, options(Dictionary::April36h11));
        let hamming = found.first().map(|tag: &Tag| (tag.id, tag.hamming));
        assert_eq!(hamming, expected.map(|hamming| (30, hamming)), "{wrong}");
    }
}

#[test]
fn what_is_no_tag_is_none() {
    let tag = |place| tag_brightness(Dictionary::Aruco6x6_250, 5, 1, place);
    let view = View::new([0.0; 3], [4.0; 2], (500.0, 25.0), [200.0, 160.0]);
    let found = |brightness: &dyn Fn([f64; 2]) -> f64, dictionary| {
        detect(
            &view.picture(SIZE, brightness, (0.6, 1.0), 3),
            options(dictionary),
        )
    };
    assert_eq!(found(&tag, Dictionary::Aruco6x6_250).len(), 1);
    // In a mirror, in a negative, and by another dictionary.
    assert!(found(&|[x, y]| tag([8.0 - x, y]), Dictionary::Aruco6x6_250).is_empty());
    assert!(found(&|place| 1.0 - tag(place), Dictionary::Aruco6x6_250).is_empty());
    assert!(found(&tag, Dictionary::April36h11).is_empty());
    // Dark squares, and pictures without room.
    let square = |[x, y]: [f64; 2]| f64::from(u8::from(x.abs() > 3.0 || y.abs() > 3.0));
    assert!(found(&square, Dictionary::April36h11).is_empty());
    for side in [0, 1, 5] {
        let picture = Plane::filled(side, side, 9u8);
        assert!(detect(&picture, options(Dictionary::Aruco4x4_50)).is_empty());
    }
}

/// A picture of 12 bits in 16 that uses a part of their range.
#[test]
fn deep_pictures_have_the_same_tags() {
    let dictionary = Dictionary::April25h9;
    let view = View::new([15.0, -20.0, 40.0], [3.5; 2], (500.0, 30.0), [200.0, 160.0]);
    let brightness = |place| tag_brightness(dictionary, 12, 1, place);
    let picture = view.picture(SIZE, brightness, (0.6, 1.0), 4);
    let bytes = detect(&picture, options(dictionary));
    let [deep] = Picture::spread([picture.map(|v| u16::from(v) * 16).into()]);
    let Picture::Grey16(deep) = deep else {
        panic!("not grey");
    };
    let deep = detect(&deep, options(dictionary));
    assert_eq!((deep.len(), deep[0].id), (1, 12));
    assert!(rms(deep[0].corners.into_iter().zip(bytes[0].corners)) < 0.01);
}

/// Noise and blocks: no tag is invented.
#[test]
fn clutter_has_no_tags() {
    let level = |u: usize, v: usize| {
        let block = (u / 7 + 1) * 7919 + (v / 9 + 1) * 104_729;
        (block * block / 977 % 200) as u8
    };
    let picture = Plane::from_fn(640, 480, level);
    for dictionary in [
        Dictionary::April36h11,
        Dictionary::Aruco6x6_250,
        Dictionary::April25h9,
    ] {
        assert!(
            detect(&picture, options(dictionary)).is_empty(),
            "{dictionary}"
        );
    }
}
