//! Canny's edges, compared with their definition, pixel by pixel.

use ga_image::canny::Canny;
use ga_image::plane::{Plane, PlaneError, PlaneView};
use proptest::prelude::*;

/// Sobel's slopes at a pixel, `[dx, dy]`, of a picture whose outermost pixels are repeated.
fn slopes(picture: PlaneView<'_, u8>, column: usize, row: usize) -> [i32; 2] {
    let at = |x: isize, y: isize| {
        let inside = |place: usize, offset: isize, length: usize| {
            place.saturating_add_signed(offset).min(length - 1)
        };
        let column = inside(column, x, picture.width());
        i32::from(picture.row(inside(row, y, picture.height()))[column])
    };
    let weights = [(-1, 1), (0, 2), (1, 1)];
    let dx = weights.map(|(k, weight)| weight * (at(1, k) - at(-1, k)));
    let dy = weights.map(|(k, weight)| weight * (at(k, 1) - at(k, -1)));
    [dx.iter().sum(), dy.iter().sum()]
}

/// The squares of the slopes' lengths at the two neighbours of a pixel across the edge, the one
/// before it in reading order first; 0 outside the picture. Directions are those of angles.
fn across(squares: &Plane<i32>, [dx, dy]: [i32; 2], column: usize, row: usize) -> [i32; 2] {
    let angle = f64::from(dy).atan2(f64::from(dx)).to_degrees();
    let (x, y) = match (angle.rem_euclid(180.0) / 45.0).round() as i32 {
        1 => (1, 1),
        2 => (0, 1),
        3 => (-1, 1),
        _ => (1, 0),
    };
    [-1, 1].map(|sign| {
        let column = column.wrapping_add_signed(sign * x);
        squares
            .get(column, row.wrapping_add_signed(sign * y))
            .unwrap_or(0)
    })
}

/// Edges by the definition; weak pixels are added until there are no more beside edges.
fn by_definition(picture: PlaneView<'_, u8>, low: f64, high: f64) -> Plane<u8> {
    let (width, height) = (picture.width(), picture.height());
    let gradient = Plane::from_fn(width, height, |column, row| slopes(picture, column, row));
    let squares = gradient.map(|[dx, dy]| dx * dx + dy * dy);
    let is_ridge = Plane::from_fn(width, height, |column, row| {
        let [dx, dy] = gradient.row(row)[column];
        let square = squares.row(row)[column];
        let [before, after] = across(&squares, [dx, dy], column, row);
        // On a diagonal both neighbours are less steep; else the first of equal ones is the edge.
        let angle = f64::from(dy).atan2(f64::from(dx)).to_degrees();
        let is_diagonal = (angle.rem_euclid(180.0) / 45.0).round() as i32 % 2 == 1;
        square > before && (square > after || square == after && !is_diagonal)
    });
    let above = |threshold: f64, column: usize, row: usize| {
        is_ridge.row(row)[column] && f64::from(squares.row(row)[column]).sqrt() > threshold
    };
    let is_weak = Plane::from_fn(width, height, |column, row| above(low, column, row));
    let mut edges = Plane::from_fn(width, height, |column, row| {
        if above(high, column, row) { 255 } else { 0 }
    });
    loop {
        let mut has_changed = false;
        for row in 0..height {
            for column in 0..width {
                if !is_weak.row(row)[column] || edges.row(row)[column] == 255 {
                    continue;
                }
                let is_beside = (0..9).any(|k: isize| {
                    let column = column.wrapping_add_signed(k % 3 - 1);
                    edges.get(column, row.wrapping_add_signed(k / 3 - 1)) == Some(255)
                });
                if is_beside {
                    edges.row_mut(row)[column] = 255;
                    has_changed = true;
                }
            }
        }
        if !has_changed {
            return edges;
        }
    }
}

/// Pictures of all sizes up to 40 × 40, and of rows longer than two words of bits, with any levels
/// or with few, of which many neighbours are equally steep.
fn pictures() -> impl Strategy<Value = Plane<u8>> {
    let size = prop_oneof![(1usize..=40, 1usize..=40), (1usize..=140, 1usize..=12)];
    let levels = prop::sample::select(vec![1u8, 2, 3, 20, 255]);
    (size, levels).prop_flat_map(|((width, height), levels)| {
        prop::collection::vec(0..levels, width * height).prop_map(move |values| {
            let step = u8::MAX / levels;
            let values = values.into_iter().map(|value| value * step).collect();
            Plane::from_values(width, height, values).unwrap()
        })
    })
}

proptest! {
    #[test]
    fn edges_are_those_of_the_definition(
        picture in pictures(),
        low in prop_oneof![Just(0.0), 0.0..600.0],
        difference in prop_oneof![Just(0.0), 0.0..900.0],
    ) {
        let high = low + difference;
        let found = Canny::new(low, high).unwrap().edges(&picture);
        prop_assert_eq!(found, by_definition(picture.view(), low, high));
    }

    #[test]
    fn edges_of_a_part_are_those_of_its_copy(picture in pictures(), left in 0usize..9) {
        let (width, height) = (picture.width(), picture.height());
        let left = left.min(width - 1);
        let part = picture.view().part(left, 0, width - left, height).unwrap();
        let mut canny = Canny::new(50.0, 300.0).unwrap();
        // What is left of another picture in the memory does not matter.
        let _ = canny.edges(&picture);
        prop_assert_eq!(canny.edges(part), canny.edges(&part.to_plane()));
        prop_assert_eq!(canny.edges(part), by_definition(part, 50.0, 300.0));
    }
}

/// A faint line that winds from the middle of the picture, where it is bright, or goes up and down.
#[test]
fn edges_follow_long_faint_lines() {
    let size = 150;
    let mut spiral = Plane::filled(size, size, 20u8);
    let (mut column, mut row) = (size / 2, size / 2);
    let mut length = 6;
    for (x, y) in [(1isize, 0isize), (0, 1), (-1, 0), (0, -1)]
        .into_iter()
        .cycle()
        .take(22)
    {
        for _ in 0..length {
            spiral.row_mut(row)[column] = 60;
            column = column.saturating_add_signed(x).min(size - 1);
            row = row.saturating_add_signed(y).min(size - 1);
        }
        length += 5;
    }
    spiral.row_mut(size / 2)[size / 2] = 255;
    let waves = Plane::from_fn(size, 60, |column, row| {
        let end = if column / 5 % 2 == 0 { 5 } else { 54 };
        let is_bright = column % 5 == 0 && (3..57).contains(&row) || row == end;
        if [column, row] == [5, 30] {
            255
        } else {
            20 + 40 * u8::from(is_bright)
        }
    });
    for picture in [
        spiral.clone(),
        spiral.transposed(),
        waves.clone(),
        waves.transposed(),
    ] {
        let edges = Canny::new(60.0, 500.0).unwrap().edges(&picture);
        assert_eq!(edges, by_definition(picture.view(), 60.0, 500.0));
        let count = edges.values().iter().filter(|value| **value == 255).count();
        let strong = Canny::new(500.0, 500.0).unwrap().edges(&picture);
        let seeds = strong
            .values()
            .iter()
            .filter(|value| **value == 255)
            .count();
        assert!(seeds > 0 && count > 20 * seeds, "{count} {seeds}");
    }
}

#[test]
fn pictures_of_one_level_have_no_edges() {
    for (width, height) in [
        (1, 1),
        (1, 40),
        (40, 1),
        (63, 2),
        (64, 3),
        (65, 1),
        (128, 2),
    ] {
        let edges = Canny::new(0.0, 0.0)
            .unwrap()
            .edges(&Plane::filled(width, height, 77));
        assert_eq!(edges, Plane::filled(width, height, 0));
    }
}

#[test]
fn thresholds_that_are_no_order_are_errors_with_their_values() {
    for [low, high] in [[2.0, 1.0], [-1.0, 1.0], [f64::NAN, 1.0], [0.0, f64::NAN]] {
        let error: PlaneError = Canny::new(low, high).unwrap_err();
        let text = error.to_string();
        assert!(text.contains(&format!("{low} and {high}")), "{text}");
    }
    // There is no slope above an infinite threshold.
    let steps = Plane::from_fn(9, 9, |column, _| if column < 4 { 0 } else { 255u8 });
    let edges = Canny::new(0.0, f64::INFINITY).unwrap().edges(&steps);
    assert_eq!(edges, Plane::filled(9, 9, 0));
}
