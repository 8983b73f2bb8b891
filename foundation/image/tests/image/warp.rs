//! Pictures seen through maps, compared with OpenCV and with interpolation written out.

use ga_image::interpolation::bilinear;
use ga_image::picture::Picture;
use ga_image::plane::{Plane, PlaneError};
use ga_image::warp::Warp;
use nullcone_shared_data::shared;
use proptest::prelude::*;
use serde_json::Value;

/// The bilinear interpolation at a place, by its definition, of a picture that continues beyond its
/// border.
fn expected(picture: &Plane<f32>, [x, y]: [f64; 2]) -> Option<f64> {
    let [width, height] = [picture.width() as f64, picture.height() as f64];
    if !(0.0..=width).contains(&x) || !(0.0..=height).contains(&y) {
        return None;
    }
    let mut sum = 0.0;
    for row in 0..=picture.height() + 1 {
        for column in 0..=picture.width() + 1 {
            // The hat functions of the centres of pixels, one of them beyond each border.
            let (u, v) = (column as f64 - 0.5, row as f64 - 0.5);
            let weight = (1.0 - (x - u).abs()).max(0.0) * (1.0 - (y - v).abs()).max(0.0);
            let column = column.clamp(1, picture.width()) - 1;
            let row = row.clamp(1, picture.height()) - 1;
            sum += weight * f64::from(picture.get(column, row).unwrap());
        }
    }
    Some(sum)
}

proptest! {
    #[test]
    fn pixels_are_interpolated(
        size in (1usize..5, 1usize..5),
        values in prop::collection::vec(-9.0f32..9.0, 16),
        places in prop::collection::vec([-1.0..6.0, -1.0..6.0], 12),
    ) {
        let picture = Plane::from_fn(size.0, size.1, |column, row| values[4 * row + column]);
        let mut list = places.iter();
        let warp = Warp::new([4, 3], [size.0, size.1], |_| list.next().copied());
        let found = warp.warped(&picture, 77.0).unwrap();
        for ((value, place), inside) in
            found.values().iter().zip(places).zip(warp.inside().values())
        {
            match expected(&picture, place) {
                Some(truth) => prop_assert!(*inside && (f64::from(*value) - truth).abs() < 1e-4),
                None => prop_assert!(!*inside && *value == 77.0),
            }
        }
    }

    /// Between the outermost centres, single places have the values of maps.
    #[test]
    fn single_places_are_interpolated(
        size in (1usize..5, 1usize..5),
        values in prop::collection::vec(-9.0f32..9.0, 16),
        places in prop::collection::vec([-1.0..5.0, -1.0..5.0], 12),
    ) {
        let picture = Plane::from_fn(size.0, size.1, |column, row| values[4 * row + column]);
        let last = [size.0, size.1].map(|count| (count - 1) as f64);
        for place in places.into_iter().chain([[0.0; 2], last]) {
            let is_inside = (0..2).all(|axis| (0.0..=last[axis]).contains(&place[axis]));
            let truth = expected(&picture, place.map(|x| x + 0.5)).filter(|_| is_inside);
            match (bilinear(&picture, place), truth) {
                (Some(found), Some(truth)) => prop_assert!((found - truth).abs() < 1e-6),
                (found, truth) => prop_assert_eq!(found, truth),
            }
        }
    }

    #[test]
    fn the_map_of_every_place_to_itself_changes_nothing(
        values in prop::collection::vec([any::<u8>(), any::<u8>(), any::<u8>()], 12),
    ) {
        let picture = Plane::from_values(4, 3, values).unwrap();
        let warp = Warp::new([4, 3], [4, 3], Some);
        prop_assert_eq!(&warp.warped(&picture, [0; 3]).unwrap(), &picture);
        let any_kind = Picture::from(picture);
        prop_assert_eq!(any_kind.view().warped(&warp).unwrap(), any_kind);
    }
}

#[test]
fn opencv_warps_alike() {
    let Some(folder) = shared("oracle/vision/seed1") else {
        return;
    };
    let text = std::fs::read_to_string(folder.join("truth.json")).unwrap();
    let truth: Value = serde_json::from_str(&text).unwrap();
    let record = &truth["warpAffine"];
    let number = |row: usize, column: usize| record["M"][row][column].as_f64().unwrap();
    let picture = ga_image::file::read(folder.join("gray.png")).unwrap();
    let grey = picture.to_grey::<u8>(ga_image::grey::Luma::Bt601);
    let size = [grey.width(), grey.height()];
    let [[a, b, c], [d, e, f]] = [0, 1].map(|row| [0, 1, 2].map(|column| number(row, column)));
    let determinant = a * e - b * d;
    let source = |[x, y]: [f64; 2]| {
        let (x, y) = (x - 0.5 - c, y - 0.5 - f);
        let (u, v) = ((e * x - b * y) / determinant, (a * y - d * x) / determinant);
        [u + 0.5, v + 0.5]
    };
    let warp = Warp::new(size, size, |place| Some(source(place)));
    let found = warp.warped(&grey, 0).unwrap();
    let file = record["file"].as_str().unwrap();
    let expected = ga_image::file::read(folder.join(file)).unwrap();
    let expected = expected.to_grey::<u8>(ga_image::grey::Luma::Bt601);
    let [mut total, mut inside] = [0.0; 2];
    for (index, (own, other)) in found.values().iter().zip(expected.values()).enumerate() {
        let pixel = [index % size[0], index / size[0]];
        let place = source(pixel.map(|k| k as f64 + 0.5));
        // How far inside the picture: OpenCV fades to the outer value within a pixel of the border.
        let depths = [0, 1].map(|k| place[k].min(size[k] as f64 - place[k]));
        let depth = depths[0].min(depths[1]);
        if depth.abs() > 1.0 {
            let difference = f64::from(own.abs_diff(*other));
            assert!(difference <= 2.0, "{pixel:?}: {own} and {other}");
            total += difference;
            inside += f64::from(u8::from(depth > 0.0));
        }
    }
    assert!(inside > 0.3 * found.values().len() as f64, "{inside}");
    assert!(total < 0.1 * inside, "{total} of {inside}");
}

#[test]
fn sizes_are_checked() {
    let warp = Warp::new([4, 3], [5, 5], Some);
    assert_eq!((warp.size(), warp.source_size()), ([4, 3], [5, 5]));
    let small = Plane::filled(4, 5, 0u8);
    let differs = PlaneError::Differs {
        first: [4, 5],
        second: [5, 5],
    };
    assert_eq!(warp.warped(&small, 0), Err(differs));
    let picture = Plane::filled(5, 5, 0u8);
    let mut result = Plane::filled(3, 3, 0u8);
    assert!(warp.apply(&picture, 0, result.view_mut()).is_err());
    // Places that are not numbers, and pictures without pixels.
    let nowhere = Warp::new([2, 1], [0, 3], Some);
    let empty = Plane::filled(0, 3, 0u8);
    assert_eq!(nowhere.warped(&empty, 9).unwrap().values(), [9, 9]);
    let nan = Warp::new([2, 1], [5, 5], |_| Some([f64::NAN, 1.0]));
    assert_eq!(nan.warped(&picture, 9).unwrap().values(), [9, 9]);
}

#[test]
fn pixels_without_weight_have_no_influence() {
    let values = vec![1.0, f32::INFINITY, f32::NAN, f32::NEG_INFINITY];
    let picture = Plane::from_values(2, 2, values).unwrap();
    assert_eq!(bilinear(&picture, [0.0, 0.0]), Some(1.0));
    assert_eq!(bilinear(&picture, [1.0, 0.0]), Some(f64::INFINITY));
    assert_eq!(bilinear(&picture, [f64::NAN, 0.0]), None);
    assert_eq!(bilinear(&Plane::filled(0, 3, 1.0_f32), [0.0, 0.0]), None);
    let warp = Warp::new([2, 1], [2, 2], Some);
    let upper = warp.warped(&picture, 0.0).unwrap();
    assert_eq!(upper.values(), [1.0, f32::INFINITY]);
}
