//! Gradients, thresholds and edges, compared with OpenCV and with their definitions.

use std::path::Path;

use ga_image::canny::Canny;
use ga_image::filter::{Border, Gradient};
use ga_image::grey::Luma;
use ga_image::plane::{Plane, PlaneError};
use ga_image::threshold::{adaptive, histogram, otsu};
use nullcone_shared_data::shared;
use proptest::prelude::*;
use serde_json::Value;

fn truth(folder: &Path) -> Value {
    let text = std::fs::read_to_string(folder.join("truth.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn grey(folder: &Path, name: &str) -> Plane<u8> {
    let picture = ga_image::file::read(folder.join(name)).unwrap();
    picture.to_grey(Luma::Bt601)
}

fn plane(rows: &Value) -> Plane<i16> {
    let rows = rows.as_array().unwrap();
    let rows: Vec<&Vec<Value>> = rows.iter().map(|row| row.as_array().unwrap()).collect();
    Plane::from_fn(rows[0].len(), rows.len(), |column, row| {
        rows[row][column].as_i64().unwrap() as i16
    })
}

#[test]
fn opencv_has_the_same_gradients() {
    let Some(folder) = shared("oracle/vision/seed1") else {
        return;
    };
    let truth = truth(&folder);
    let picture = plane(&truth["small32"]).map(|value| value as u8);
    for (name, gradient) in [("sobel", Gradient::Sobel), ("scharr", Gradient::Scharr)] {
        let [dx, dy] = gradient.of(&picture, Border::Mirror);
        assert_eq!(dx, plane(&truth[name]["gx"]), "{name}");
        assert_eq!(dy, plane(&truth[name]["gy"]), "{name}");
    }
}

#[test]
fn opencv_has_the_same_thresholds() {
    let Some(folder) = shared("oracle/vision/seed1") else {
        return;
    };
    for case in truth(&folder)["otsu"].as_array().unwrap() {
        let name = case["file"].as_str().unwrap();
        let level = otsu(&grey(&folder, name)).unwrap();
        assert_eq!(f64::from(level), case["cv2"].as_f64().unwrap(), "{name}");
    }
}

#[test]
fn opencv_has_the_same_edges() {
    let Some(folder) = shared("oracle/vision/seed1") else {
        return;
    };
    let case = &truth(&folder)["canny"];
    let [low, high] = ["lo", "hi"].map(|name| case[name].as_f64().unwrap());
    let mut canny = Canny::new(low, high).unwrap();
    let picture = grey(&folder, "gray.png");
    let expected = grey(&folder, case["file"].as_str().unwrap());
    assert_eq!(canny.edges(&picture), expected);
    // The memory of another picture does not matter.
    let _ = canny.edges(&Plane::filled(2000, 3, 9));
    assert_eq!(canny.edges(&picture), expected);
}

/// Border, as an index into a picture that is continued.
fn inside(border: Border, index: isize, length: usize) -> usize {
    let last = length.cast_signed() - 1;
    let mut index = index;
    while !(0..=last).contains(&index) {
        index = match border {
            Border::Replicate => index.clamp(0, last),
            Border::Reflect if index < 0 => -1 - index,
            Border::Reflect => 2 * last + 1 - index,
            Border::Mirror if last == 0 => 0,
            Border::Mirror if index < 0 => -index,
            Border::Mirror => 2 * last - index,
        };
    }
    index.cast_unsigned()
}

fn pictures() -> impl Strategy<Value = Plane<u8>> {
    (1usize..40, 1usize..12).prop_flat_map(|(width, height)| {
        prop::collection::vec(any::<u8>(), width * height)
            .prop_map(move |values| Plane::from_values(width, height, values).unwrap())
    })
}

fn borders() -> impl Strategy<Value = Border> {
    prop::sample::select(vec![Border::Reflect, Border::Mirror, Border::Replicate])
}

proptest! {
    #[test]
    fn gradients_are_their_weighted_sums(picture in pictures(), border in borders()) {
        for (gradient, across) in [(Gradient::Sobel, [1, 2, 1]), (Gradient::Scharr, [3, 10, 3])] {
            let slope = |column: usize, row: usize, is_vertical: bool| {
                let mut sum = 0;
                for (k, weight) in (-1isize..).zip(across) {
                    for sign in [-1isize, 1] {
                        let (x, y) = if is_vertical { (k, sign) } else { (sign, k) };
                        let column = inside(border, column.cast_signed() + x, picture.width());
                        let row = inside(border, row.cast_signed() + y, picture.height());
                        let value = picture.get(column, row).unwrap();
                        sum += sign as i16 * weight * i16::from(value);
                    }
                }
                sum
            };
            let [width, height] = [picture.width(), picture.height()];
            let dx = Plane::from_fn(width, height, |column, row| slope(column, row, false));
            let dy = Plane::from_fn(width, height, |column, row| slope(column, row, true));
            let mut alone = Plane::filled(width, height, 0);
            gradient.horizontal_into(&picture, border, &mut alone).unwrap();
            prop_assert_eq!(&alone, &dx);
            gradient.vertical_into(&picture, border, &mut alone).unwrap();
            prop_assert_eq!(&alone, &dy);
            prop_assert_eq!(gradient.of(&picture, border), [dx, dy]);
        }
    }

    #[test]
    fn adaptive_thresholds_are_those_of_means(
        picture in pictures(),
        radius in 0u16..9,
        offset in -40i16..40,
        border in borders(),
    ) {
        let reach = radius as isize;
        let expected = Plane::from_fn(picture.width(), picture.height(), |column, row| {
            let mut sum = 0.0;
            for y in -reach..=reach {
                for x in -reach..=reach {
                    let column = inside(border, column.cast_signed() + x, picture.width());
                    let row = inside(border, row.cast_signed() + y, picture.height());
                    sum += f64::from(picture.get(column, row).unwrap());
                }
            }
            let area = f64::from(2 * radius + 1).powi(2);
            let level = f64::from(picture.get(column, row).unwrap()) + f64::from(offset);
            if level * area > sum { 255 } else { 0 }
        });
        prop_assert_eq!(adaptive(&picture, radius, offset, border), expected);
    }

    #[test]
    fn histograms_count_every_pixel(picture in pictures()) {
        let counts = histogram(&picture);
        for (count, level) in counts.iter().zip(0u8..=255) {
            let expected = picture.values().iter().filter(|value| **value == level).count();
            prop_assert_eq!(*count, expected as u64);
        }
    }

    /// The variance between the classes, by counting pixels and in whole numbers, has no greater
    /// value. Of levels that divide the pixels in the same way the least is given, which occurs.
    #[test]
    fn otsu_divides_by_the_greatest_variance(picture in pictures(), levels in 1u8..=255) {
        let picture = picture.map(|value| value % levels);
        let variance = |level: u8| {
            let sums = [false, true].map(|is_above| {
                let class = picture.values().iter().filter(|value| (**value > level) == is_above);
                class.fold((0, 0), |(n, sum), value| (n + 1, sum + i128::from(*value)))
            });
            let [(n0, sum0), (n1, sum1)] = sums;
            // (m0 - m1)^2 n0 n1 as a fraction.
            let difference: i128 = sum0 * n1 - sum1 * n0;
            (n0 * n1 > 0).then(|| (difference * difference) as f64 / (n0 * n1) as f64)
        };
        let greatest = (0..=254).filter_map(variance).fold(0.0, f64::max);
        match otsu(&picture) {
            None => prop_assert_eq!(greatest, 0.0),
            Some(level) => {
                prop_assert!(variance(level).unwrap() >= greatest * (1.0 - 1e-12));
                prop_assert!(picture.values().contains(&level));
            }
        }
    }

    /// Canny's edges are found by thresholds alone where these are equal, and lie between those of
    /// the upper and of the lower threshold otherwise.
    #[test]
    fn edges_grow_from_strong_to_weak_pixels(picture in pictures()) {
        let edges = |low, high| Canny::new(low, high).unwrap().edges(&picture);
        let [strong, both, weak] = [edges(400.0, 400.0), edges(100.0, 400.0), edges(100.0, 100.0)];
        let [width, height] = [picture.width().cast_signed(), picture.height().cast_signed()];
        for row in 0..height {
            for column in 0..width {
                let at = |plane: &Plane<u8>, x: isize, y: isize| {
                    plane.get((column + x).cast_unsigned(), (row + y).cast_unsigned()) == Some(255)
                };
                prop_assert!(!at(&strong, 0, 0) || at(&both, 0, 0));
                prop_assert!(!at(&both, 0, 0) || at(&weak, 0, 0));
                let neighbours = (0..9).any(|k| k != 4 && at(&both, k % 3 - 1, k / 3 - 1));
                // A weak pixel beside an edge is one, and an edge that is not strong is beside one.
                prop_assert!(!(at(&weak, 0, 0) && neighbours) || at(&both, 0, 0));
                prop_assert!(!at(&both, 0, 0) || at(&strong, 0, 0) || neighbours);
            }
        }
    }
}

#[test]
fn planes_of_other_sizes_and_thresholds_out_of_order_are_errors() {
    let picture = Plane::filled(4, 3, 7u8);
    let mut slopes = Plane::filled(3, 4, 0);
    let differs = PlaneError::Differs {
        first: [4, 3],
        second: [3, 4],
    };
    let found = Gradient::Sobel.horizontal_into(&picture, Border::Mirror, &mut slopes);
    assert_eq!(found, Err(differs.clone()));
    let mut edges = Plane::filled(3, 4, 0);
    let mut canny = Canny::new(1.0, 2.0).unwrap();
    assert_eq!(canny.edges_into(&picture, &mut edges), Err(differs));
    for [low, high] in [[2.0, 1.0], [-1.0, 1.0], [f64::NAN, 1.0], [0.0, f64::NAN]] {
        assert!(Canny::new(low, high).is_err(), "{low} {high}");
    }
    assert_eq!(otsu(&picture), None);
    assert_eq!(otsu(&Plane::<u8>::default()), None);
    assert!(canny.edges(&Plane::<u8>::default()).is_empty());
}

/// Large pictures, whose rows are not a multiple of what is read at once, seen as a part of a
/// picture and alone.
#[test]
fn histograms_of_large_pictures_count_every_pixel() {
    let mut state = 9u32;
    let picture = Plane::from_fn(803, 701, |column, row| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        if (column / 50 + row / 40) % 3 == 0 {
            90
        } else {
            (state >> 24) as u8
        }
    });
    for view in [picture.view(), picture.view().part(5, 3, 797, 690).unwrap()] {
        let mut expected = [0; 256];
        for row in view.rows() {
            for value in row {
                expected[usize::from(*value)] += 1;
            }
        }
        assert_eq!(histogram(view), expected);
    }
}
