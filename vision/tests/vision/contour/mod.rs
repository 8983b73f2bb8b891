//! Borders, snakes and fits, compared with OpenCV, with the shapes that were drawn, and with points
//! of known figures.

mod snake;

use std::f64::consts::TAU;
use std::path::Path;

use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_vision::contour::fit::{self};
use ga_vision::contour::{
    ContourError, MeasuredContour, borders, centroid, perimeter, resampled, signed_area,
};
use nullcone_shared_data::shared;
use proptest::prelude::*;
use serde_json::Value;

fn truth(folder: &Path) -> Value {
    let text = std::fs::read_to_string(folder.join("truth.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn grey(path: impl AsRef<Path>) -> Plane<u8> {
    file::read(path.as_ref()).unwrap().to_grey(Luma::Bt601)
}

#[test]
fn opencv_finds_the_same_borders() {
    let Some(folder) = shared("oracle/vision/seed1") else {
        return;
    };
    let case = &truth(&folder)["contours"];
    let picture = grey(folder.join(case["file"].as_str().unwrap()));
    let mut found = borders(&picture);
    // OpenCV lists them from the bottom.
    found.reverse();
    let expected = case["found"].as_array().unwrap();
    assert_eq!(found.len(), expected.len());
    for (contour, expected) in found.iter().zip(expected) {
        let number = |name: &str| expected[name].as_f64().unwrap();
        assert_eq!(contour.area(), number("area"));
        assert!((contour.perimeter() - number("perimeter")).abs() < 1e-5);
        assert_eq!(contour.pixels.len() as f64, number("n"));
        assert_eq!(serde_json::json!(contour.bounding_box()), expected["bbox"]);
        assert!(!contour.is_hole && contour.parent.is_none());
        assert!(signed_area(&contour.points()) < 0.0, "counterclockwise");
    }
}

fn from_text(rows: &[&str]) -> Plane<u8> {
    Plane::from_fn(rows[0].len(), rows.len(), |column, row| {
        u8::from(rows[row].as_bytes()[column] == b'#')
    })
}

#[test]
fn borders_have_a_hierarchy() {
    let picture = from_text(&[
        "#########.",
        "#.......#.",
        "#.###.#.#.",
        "#.#.#...#.",
        "#.###...#.",
        "#.......##",
        "#########.",
        "..........",
        "##........",
    ]);
    let found = borders(&picture);
    let hierarchy: Vec<_> = found.iter().map(|c| (c.is_hole, c.parent)).collect();
    let expected = [
        (false, None),
        (true, Some(0)),
        (false, Some(1)),
        (false, Some(1)),
        (true, Some(2)),
        (false, None),
    ];
    assert_eq!(hierarchy, expected);
    assert_eq!(found[3].pixels, [[6, 2]]);
    assert_eq!(found[5].pixels, [[0, 8], [1, 8]]);
    assert!(borders(&Plane::filled(5, 4, 0u8)).is_empty());
    assert!(borders(&Plane::<u8>::default()).is_empty());
}

/// The number of sets of connected pixels of one kind, with four or eight neighbours.
fn count_regions(picture: &Plane<u8>, kind: u8, eight: bool) -> usize {
    let (width, height) = (
        picture.width().cast_signed(),
        picture.height().cast_signed(),
    );
    let mut pixels = picture.clone();
    let mut count = 0;
    for start in 0..pixels.values().len() {
        if pixels.values()[start] != kind {
            continue;
        }
        count += 1;
        let mut pending = vec![start.cast_signed()];
        while let Some(index) = pending.pop() {
            let value = &mut pixels.values_mut()[index.cast_unsigned()];
            if *value != kind {
                continue;
            }
            *value = 2;
            let (column, row) = (index % width, index / width);
            for k in 0..9 {
                let (x, y) = (k % 3 - 1, k / 3 - 1);
                let place = (column + x, row + y);
                let is_inside = (0..width).contains(&place.0) && (0..height).contains(&place.1);
                if is_inside && (eight || x * y == 0) {
                    pending.push(place.1 * width + place.0);
                }
            }
        }
    }
    count
}

proptest! {
    #[test]
    fn every_region_and_every_hole_has_a_border(
        size in (1usize..14, 1usize..14),
        pixels in prop::collection::vec(0u8..2, 196),
    ) {
        let picture = Plane::from_fn(size.0, size.1, |column, row| pixels[14 * row + column]);
        let found = borders(&picture);
        let holes = found.iter().filter(|contour| contour.is_hole).count();
        prop_assert_eq!(found.len() - holes, count_regions(&picture, 1, true));
        // A frame of background makes one region of all the background that is not a hole.
        let framed = Plane::from_fn(size.0 + 2, size.1 + 2, |column, row| {
            picture.get(column.wrapping_sub(1), row.wrapping_sub(1)).unwrap_or(0)
        });
        prop_assert_eq!(holes + 1, count_regions(&framed, 0, false));
        for contour in &found {
            let next = contour.pixels.iter().cycle().skip(1);
            for (a, b) in contour.pixels.iter().zip(next) {
                prop_assert_eq!(picture.get(a[0] as usize, a[1] as usize), Some(1));
                prop_assert!(a[0].abs_diff(b[0]) <= 1 && a[1].abs_diff(b[1]) <= 1);
            }
            match contour.parent {
                None => prop_assert!(!contour.is_hole),
                Some(parent) => prop_assert_ne!(found[parent].is_hole, contour.is_hole),
            }
        }
    }

    #[test]
    fn points_of_ellipses_give_these_ellipses(
        centre in [-50.0..50.0f64, -50.0..50.0],
        semi_axes in (2.0..9.0f64, 10.0..40.0f64),
        angle in -1.5..1.5f64,
        count in 6usize..30,
    ) {
        let (short, long) = semi_axes;
        let points = |[a, b]: [f64; 2]| -> Vec<[f64; 2]> {
            let point = |k: usize| {
                let t = 2.5 + TAU * k as f64 / count as f64;
                let [x, y] = [a * t.cos(), b * t.sin()];
                let [c, s] = [f64::cos(angle), f64::sin(angle)];
                [centre[0] + c * x - s * y, centre[1] + s * x + c * y]
            };
            (0..count).map(point).collect()
        };
        let ellipse = fit::ellipse(&points([long, short])).unwrap();
        for (found, truth) in ellipse.centre.into_iter().zip(centre) {
            prop_assert!((found - truth).abs() < 1e-6);
        }
        prop_assert!((ellipse.semi_axes[0] - long).abs() < 1e-6);
        prop_assert!((ellipse.semi_axes[1] - short).abs() < 1e-6);
        prop_assert!((ellipse.angle - angle).abs() < 1e-6);
    }

    #[test]
    fn points_on_a_line_have_no_centroid(
        origin in [-1e4..1e4f64, -1e4..1e4],
        direction in [-1.0..1.0f64, -1.0..1.0],
        along in prop::collection::vec(-300.0..300.0f64, 0..60),
    ) {
        let point = |t: &f64| [0, 1].map(|axis| origin[axis] + t * direction[axis]);
        let points: Vec<[f64; 2]> = along.iter().map(point).collect();
        prop_assert_eq!(centroid(&points), None);
    }
}

#[test]
fn points_that_determine_no_ellipse_are_errors() {
    let line: Vec<[f64; 2]> = (0..8).map(|k| [f64::from(k), 2.0 * f64::from(k)]).collect();
    assert!(matches!(
        fit::ellipse(&line),
        Err(ContourError::Degenerate { .. })
    ));
    assert!(matches!(
        fit::ellipse(&[[1.0, 2.0]; 5]),
        Err(ContourError::Degenerate { .. })
    ));
    assert!(matches!(
        fit::ellipse(&line[..4]),
        Err(ContourError::EllipseTooFew { count: 4, least: 5 })
    ));
    let mut wrong = line.clone();
    wrong[1] = [1.0, f64::NAN];
    assert_eq!(
        fit::ellipse(&wrong).err(),
        Some(ContourError::EllipseNotFinite { index: 1 })
    );
}

#[test]
fn polygons_have_areas_lengths_and_equal_parts() {
    let square = [[1.0, 1.0], [5.0, 1.0], [5.0, 5.0], [1.0, 5.0]];
    assert_eq!((signed_area(&square), perimeter(&square)), (16.0, 16.0));
    assert_eq!(centroid(&square), Some([3.0, 3.0]));
    assert_eq!(centroid(&square[..2]), None);
    // Far from the origin a small square still has a centre.
    let small = square.map(|corner| corner.map(|x| 1e6 + 1e-3 * x));
    let centre = centroid(&small).unwrap();
    assert!(centre.iter().all(|x| (x - 1e6 - 3e-3).abs() < 1e-5));
    let parts = resampled(&square, 8);
    let expected = [
        [1, 1],
        [3, 1],
        [5, 1],
        [5, 3],
        [5, 5],
        [3, 5],
        [1, 5],
        [1, 3],
    ];
    assert_eq!(parts, expected.map(|point| point.map(f64::from)));
    assert!(resampled(&[[2.0, 2.0]; 3], 4).is_empty());
}

/// What a border of the picture cuts off is fitted by what is left of it, whichever side it is at.
#[test]
fn circles_are_not_fitted_along_the_border_of_the_picture() {
    let size = [80, 60];
    for centre in [[6.0, 30.0], [74.0, 30.0], [40.0, 5.0], [40.0, 54.0]] {
        let picture = Plane::from_fn(size[0], size[1], |column, row| {
            let [x, y] = [column as f64 - centre[0], row as f64 - centre[1]];
            if x.hypot(y) < 16.0 { 255u8 } else { 0 }
        });
        let found = borders(&picture);
        let contour = MeasuredContour::new(found[0].points(), false, None, size);
        let circle = contour.circle.unwrap();
        // Through the centres of the outermost pixels, about half a pixel inside.
        assert!((circle.radius - 15.5).abs() < 0.4, "{centre:?}: {circle:?}");
        let ellipse = contour.ellipse.unwrap();
        for (axis, expected) in centre.into_iter().enumerate() {
            assert!((circle.centre[axis] - expected).abs() < 0.4, "{circle:?}");
            assert!((ellipse.centre[axis] - expected).abs() < 1.5, "{ellipse:?}");
        }
        let at_border = |[u, v]: &&[f64; 2]| *u == 0.0 || *v == 0.0 || *u == 79.0 || *v == 59.0;
        assert_eq!(
            contour.at_border,
            contour.points.iter().filter(at_border).count()
        );
        assert!(contour.at_border > 20);
    }
    // A picture that is bright everywhere has no outline but its own.
    let all = borders(&Plane::filled(20, 20, 255u8));
    let contour = MeasuredContour::new(all[0].points(), false, None, [20, 20]);
    assert_eq!(
        (contour.at_border, contour.circle),
        (contour.points.len(), None)
    );
}
