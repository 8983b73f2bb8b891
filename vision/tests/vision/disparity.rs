//! Disparity maps: their files against numbers from elsewhere, and their errors against
//! definitions written out.

use ga_image::pfm::{self, ByteOrder};
use ga_image::picture::Picture;
use ga_image::plane::Plane;
use ga_image::png;
use ga_vision::disparity::evaluation::{ErrorMap, ErrorMeasures, Evaluation};
use ga_vision::disparity::picture::ColourScale;
use ga_vision::disparity::visibility::Visibility;
use ga_vision::disparity::{DisparityMap, DisparityMapError, file};
use nullcone_shared_data::shared;
use proptest::prelude::*;

fn map(width: usize, values: &[f32]) -> DisparityMap {
    let height = values.len() / width;
    DisparityMap::new(Plane::from_values(width, height, values.to_vec()).unwrap())
}

/// The expected numbers are those of the array in `motorcycle_disp.npz`, as NumPy reads it.
#[test]
fn the_truth_of_the_motorcycle_is_upright() {
    let Some(path) = shared("data/vision/middlebury/motorcycle_disp.pfm") else {
        return;
    };
    let truth = file::read(path, None).unwrap();
    assert_eq!((truth.width(), truth.height()), (741, 500));
    for (column, row, disparity) in [
        (0, 0, None),
        (740, 0, None),
        (0, 499, Some(58.974_007)),
        (370, 250, Some(48.999_874)),
        (100, 20, Some(9.811_464)),
        (600, 400, Some(50.850_796)),
    ] {
        assert_eq!(truth.get(column, row), disparity, "{column}, {row}");
    }
    assert_eq!(truth.known(), 343_274);
    assert_eq!(truth.range(), Some([7.191_355_7, 59.908_96]));
}

#[test]
fn rows_are_stored_from_the_bottom_in_either_order_of_bytes() {
    let expected = map(2, &[1.0, 2.0, 3.0, f32::NAN]);
    let little = b"Pf\n2 2\n-1.0\n\0\0\x40\x40\0\0\x80\x7f\0\0\x80\x3f\0\0\0\x40";
    let big = b"Pf\n2 2\n1.0\n\x40\x40\0\0\x7f\x80\0\0\x3f\x80\0\0\x40\0\0\0";
    assert_eq!(file::encode(&expected).unwrap(), little);
    assert_eq!(file::decode(little, None).unwrap(), expected);
    assert_eq!(file::decode(big, None).unwrap(), expected);
}

#[test]
fn truths_are_stored_as_multiples() {
    let deep = Plane::from_fn(3, 2, |column, row| (1000 * column + 7 * row) as u16);
    // Without a scale, 16 bits are those of KITTI. 0 is unknown.
    let deep = png::encode(&deep).unwrap();
    for scale in [None, Some(256.0)] {
        let truth = file::decode(&deep, scale).unwrap();
        assert_eq!(truth.get(2, 1), Some(2007.0 / 256.0));
        assert_eq!(truth.get(0, 0), None);
    }
    assert_eq!(
        file::decode(&deep, Some(1.0)).unwrap().get(2, 1),
        Some(2007.0)
    );
    let shallow = b"P5 3 1 255\n\x09\xff\0";
    let expected = map(3, &[3.0, 85.0, f32::NAN]);
    assert_eq!(file::decode(shallow, Some(3.0)).unwrap(), expected);
    let expected = map(3, &[9.0, 255.0, f32::NAN]);
    assert_eq!(file::decode(shallow, None).unwrap(), expected);
    let floats = Plane::from_values(2, 1, vec![5.0, f32::INFINITY]).unwrap();
    let bytes = pfm::encode(&floats, ByteOrder::Big).unwrap();
    assert_eq!(
        file::decode(&bytes, Some(2.0)).unwrap(),
        map(2, &[2.5, f32::NAN])
    );
    // Beyond the range of floats a disparity is unknown.
    let huge = pfm::encode(&Plane::filled(1, 1, 3e38f32), ByteOrder::Big).unwrap();
    assert_eq!(file::decode(&huge, Some(1e-3)).unwrap().known(), 0);
}

#[test]
fn what_is_no_map_is_named() {
    let colour = Plane::filled(2, 2, [1.0f32, 2.0, 3.0]);
    let colour = pfm::encode(&colour, ByteOrder::Little).unwrap();
    let picture = png::encode(&Plane::filled(2, 2, [1u8; 4])).unwrap();
    for (error, part) in [
        (file::decode(&colour, None), "this picture is RGB of floats"),
        (
            file::decode(b"Pf\n2 2\n-1.0\nabc", None),
            "16 bytes, and 3 bytes follow",
        ),
        (
            file::decode(b"Pf\n2 2\n0\n", None),
            "neither positive nor negative",
        ),
        (file::decode(&picture, Some(1.0)), "8-bit RGBA"),
        (file::decode(b"none", None), "not a picture"),
        (file::decode(&picture, Some(0.0)), "the scale 0"),
        (file::decode(&picture, Some(f64::NAN)), "the scale NaN"),
    ] {
        let error = error.unwrap_err().to_string();
        assert!(error.contains(part), "{error}");
    }
    assert!(file::encode(&DisparityMap::default()).is_err());
}

#[test]
fn maps_that_cannot_be_compared_are_errors() {
    let (small, large) = (map(1, &[1.0]), map(2, &[1.0, 1.0]));
    let error = ErrorMap::new(&small, &large).unwrap_err();
    assert!(error.to_string().contains("1 × 1 and 2 × 1"), "{error}");
    for truth in [&[0.0][..], &[f32::NAN], &[f32::INFINITY]] {
        let compared = ErrorMap::new(&small, &map(1, truth));
        assert_eq!(compared.unwrap_err(), DisparityMapError::NoTruth);
    }
    let nothing = ErrorMap::new(&map(1, &[f32::NAN]), &small).unwrap();
    assert_eq!(nothing.average_px(), None);
    assert_eq!((nothing.density(), nothing.bad(3.0)), (0.0, 100.0));
}

#[test]
fn an_error_of_the_threshold_is_not_bad() {
    let truth = map(4, &[10.0, 10.0, 10.0, 10.0]);
    let above = |x: f32| x.next_up();
    let found = map(4, &[10.5, above(10.5), 8.0, 13.0]);
    let errors = ErrorMap::new(&found, &truth).unwrap();
    assert_eq!(
        [0.5, 1.0, 2.0, 3.0].map(|t| errors.bad(t)),
        [75.0, 50.0, 25.0, 0.0]
    );
}

#[test]
fn marks_are_not_among_the_colours() {
    let colours = [
        ColourScale::viridis([0.0, 1.0]),
        ColourScale::inferno([0.0, 1.0]),
    ];
    let marks: Vec<_> = (0..6).map(|c| ColourScale::unknown([c, 0])).collect();
    for step in 0..=1000 {
        for scale in &colours {
            let colour = scale.colour(f64::from(step) / 1000.0);
            for mark in marks.iter().chain([&ColourScale::left_out()]) {
                let far = (0..3).map(|k| colour[k].abs_diff(mark[k])).max();
                assert!(far > Some(20), "{colour:?} {mark:?}");
            }
        }
    }
    let picture = colours[0].disparities(&map(3, &[0.0, f32::NAN, 1.0]));
    assert_eq!(
        picture.values(),
        [[68, 1, 84], ColourScale::unknown([1, 0]), [253, 231, 37]]
    );
    assert_eq!(ColourScale::viridis([2.0, 2.0]).colour(2.0), [68, 1, 84]);
    assert_eq!(ColourScale::viridis([2.0, 2.0]).colour(9.0), [253, 231, 37]);
}

/// Disparities in quarters of a pixel, so that errors meet the thresholds exactly.
fn disparity() -> impl Strategy<Value = f32> {
    prop_oneof![
        8 => (-8i16..40).prop_map(|quarters| f32::from(quarters) / 4.0),
        1 => Just(f32::NAN),
        1 => Just(f32::INFINITY),
        1 => Just(0.0),
    ]
}

proptest! {
    #[test]
    fn the_measures_are_those_of_the_definition(
        pairs in prop::collection::vec((disparity(), disparity()), 1..60),
    ) {
        let (found, truth): (Vec<f32>, Vec<f32>) = pairs.iter().copied().unzip();
        let errors = ErrorMap::new(&map(1, &found), &map(1, &truth));
        let used: Vec<_> = pairs.iter().filter(|(_, t)| t.is_finite() && *t != 0.0).collect();
        if used.is_empty() {
            prop_assert_eq!(errors.unwrap_err(), DisparityMapError::NoTruth);
            return Ok(());
        }
        let errors = errors.unwrap();
        prop_assert_eq!(errors.pixels(), used.len());
        let percent = |count: usize| 100.0 * count as f64 / used.len() as f64;
        for quarters in [2, 4, 8, 12] {
            // In whole quarters of a pixel.
            let bad = used.iter().filter(|(d, t)| {
                !d.is_finite() || ((4.0 * d) as i32 - (4.0 * t) as i32).abs() > quarters
            });
            prop_assert_eq!(errors.bad(f64::from(quarters) / 4.0), percent(bad.count()));
        }
        let known: Vec<_> = used.iter().filter(|(d, _)| d.is_finite()).collect();
        prop_assert_eq!(errors.density(), percent(known.len()));
        let sum: i32 = known.iter().map(|(d, t)| ((4.0 * (d - t)) as i32).abs()).sum();
        let average = (!known.is_empty()).then(|| f64::from(sum) / 4.0 / known.len() as f64);
        prop_assert_eq!(errors.average_px(), average);
    }

    #[test]
    fn maps_come_back_from_their_files(
        width in 1usize..7,
        values in prop::collection::vec(any::<f32>(), 1..50),
    ) {
        prop_assume!(values.len() >= width);
        let map = map(width, &values[..values.len() / width * width]);
        prop_assert_eq!(file::decode(&file::encode(&map).unwrap(), None).unwrap(), map);
    }
}

/// By hand: KITTI's file has 256 × the disparity, and 0 for what is unknown.
#[test]
fn maps_are_stored_as_kitti_has_them() {
    let found = map(4, &[0.0, 12.25, f32::NAN, 255.99]);
    let Picture::Grey16(stored) = png::decode(&file::encode_png(&found).unwrap()).unwrap() else {
        panic!("not 16 bits of grey")
    };
    assert_eq!(stored.values(), [1, 3136, 0, 65533]);
    for disparity in [-0.5, 256.0] {
        let error = file::encode_png(&map(2, &[disparity, 3.0])).unwrap_err();
        let part = format!("from 0 to 255.996 px, and the map has {disparity:.3} px");
        assert!(error.to_string().contains(&part), "{error}");
    }
    assert!(file::encode_png(&DisparityMap::default()).is_err());
}

/// By hand: 3 px of 60 are 5 %.
#[test]
fn d1_counts_errors_that_are_large_in_pixels_and_in_percent() {
    let truth = map(6, &[60.0, 60.0, 100.0, 100.0, 10.0, 0.0]);
    let found = map(6, &[63.0, 63.5, 104.5, 105.5, f32::NAN, 99.0]);
    let errors = ErrorMap::new(&found, &truth).unwrap();
    assert_eq!(errors.d1(), 60.0);
    assert_eq!(errors.bad(3.0), 80.0);
    let part = errors.within(|column, _| column < 3).unwrap();
    assert_eq!((part.pixels(), part.d1()), (3, 100.0 / 3.0));
    assert!(errors.within(|column, _| column == 5).is_none());
}

#[test]
fn visible_and_occluded_pixels_are_told_apart() {
    let truth = map(5, &[10.0, 10.0, 10.0, 10.0, f32::NAN]);
    let found = map(5, &[10.5, 14.0, 10.0, f32::NAN, 3.0]);
    let mask = |levels: &[u8]| {
        let plane = Plane::from_values(levels.len(), 1, levels.to_vec()).unwrap();
        Visibility::decode_mask(&png::encode(&plane).unwrap()).unwrap()
    };
    let with = |visibility: &Visibility| Evaluation::new(&found, &truth, Some(visibility));
    let counts = |found: &Evaluation| {
        let pixels = |part: Option<ErrorMeasures>| part.map_or(0, |part| part.truth_pixels);
        [
            found.all.truth_pixels,
            pixels(found.visible),
            pixels(found.occluded),
        ]
    };
    let middlebury = with(&mask(&[255, 128, 0, 128, 255])).unwrap();
    assert_eq!(counts(&middlebury), [3, 1, 2]);
    assert_eq!(middlebury.visible.unwrap().average_px, Some(0.5));
    assert_eq!(middlebury.occluded.unwrap().bad_3, 100.0);
    assert_eq!(middlebury.errors.pixels(), 3);
    // In black and white, and with 0 and 1, only what counts is told.
    for levels in [[255, 0, 255, 0, 0], [1, 0, 1, 0, 0]] {
        let found = with(&mask(&levels)).unwrap();
        assert_eq!((counts(&found), found.occluded), ([2, 2, 0], None));
    }
    let kitti = map(5, &[10.0, f32::NAN, 10.0, 0.0, f32::NAN]);
    let kitti = with(&Visibility::from_truth_of_visible(&kitti)).unwrap();
    assert_eq!(counts(&kitti), [4, 2, 2]);
    let without = Evaluation::new(&found, &truth, None).unwrap();
    assert_eq!((counts(&without), without.visible), ([4, 0, 0], None));
    assert!(matches!(
        with(&mask(&[255; 4])),
        Err(DisparityMapError::MaskSize(_))
    ));
    // Nothing that both cameras see.
    let found = with(&mask(&[0, 128, 128, 0, 0])).unwrap();
    assert_eq!((counts(&found), found.visible), ([2, 0, 2], None));
    let odd = png::encode(&Plane::from_values(2, 1, vec![255u8, 9]).unwrap()).unwrap();
    let error = Visibility::decode_mask(&odd).unwrap_err().to_string();
    assert!(error.ends_with("and not 9"), "{error}");
    let nothing = with(&mask(&[0, 0, 0, 0, 255])).unwrap_err();
    assert_eq!(nothing, DisparityMapError::NoTruth);
    let colour = png::encode(&Plane::filled(2, 2, [1u8; 3])).unwrap();
    let error = Visibility::decode_mask(&colour).unwrap_err().to_string();
    assert!(error.contains("this picture is 8-bit RGB"), "{error}");
}
