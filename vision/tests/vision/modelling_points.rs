//! Modelling points: against least squares over the pixels of each cell, and against planes.

use ga_camera::Intrinsics;
use ga_camera::rig::RectifiedRig;
use ga_image::plane::Plane;
use ga_runtime::cga3::{Direction, Point};
use ga_vision::disparity::{DisparityMap, DisparityMapError};
use ga_vision::modelling_points::{
    DistanceControls, ModellingPoint, ModellingPyramid, predicted_distance,
};
use nalgebra_035::{DMatrix, DVector};
use proptest::prelude::*;

fn weighed(map: &DisparityMap) -> Plane<f32> {
    Plane::filled(map.width(), map.height(), 1.0)
}

fn rig() -> RectifiedRig {
    let left = Intrinsics::new([210.0, 190.0], [40.0, 21.0]).unwrap();
    let right = Intrinsics::new([210.0, 190.0], [43.5, 21.0]).unwrap();
    RectifiedRig::new(left, right, 0.12).unwrap()
}

/// A map and weights, some of them unknown or 0.
fn maps() -> impl Strategy<Value = (DisparityMap, Plane<f32>)> {
    let disparity = prop_oneof![6 => 0.5f32..40.0, 1 => Just(f32::NAN)];
    let weight = prop_oneof![5 => 0.01f32..1.0, 1 => Just(0.0)];
    (1usize..14, 1usize..14).prop_flat_map(move |(width, height)| {
        let pixels = prop::collection::vec((disparity.clone(), weight.clone()), width * height);
        pixels.prop_map(move |pixels| {
            let (disparities, weights) = pixels.into_iter().unzip();
            let map = Plane::from_values(width, height, disparities).unwrap();
            let weights = Plane::from_values(width, height, weights).unwrap();
            (DisparityMap::new(map), weights)
        })
    })
}

/// Columns, rows, disparities and weights of the pixels of a cell.
fn pixels_of(
    map: &DisparityMap,
    weights: &Plane<f32>,
    level: usize,
    [column, row]: [usize; 2],
) -> Vec<[f64; 4]> {
    let mut pixels = Vec::new();
    for v in (row << level)..((row + 1) << level).min(map.height()) {
        for u in (column << level)..((column + 1) << level).min(map.width()) {
            let weight = weights.get(u, v).unwrap();
            if let Some(disparity) = map.get(u, v)
                && weight > 0.0
            {
                pixels.push([u as f64, v as f64, f64::from(disparity), f64::from(weight)]);
            }
        }
    }
    pixels
}

/// The greatest difference of residuals that rounding explains. In a map of 14 × 14 a pixel that is
/// not on the line of two others misses it by 1/18 px or more, so that planes are as steep as 40 px
/// over that and differ from their mean by up to 10⁴ px, which double precision resolves to
/// 10⁻¹² px; the rest is for the number of steps, and for weights that differ by a factor of 100.
const ROUNDING: f64 = 1e-9;

/// The residual of the least squares over the pixels, from a singular value decomposition.
fn least_residual(pixels: &[[f64; 4]]) -> f64 {
    let rows = pixels.len();
    let matrix = DMatrix::from_fn(rows, 3, |k, term| {
        let [u, v, _, weight] = pixels[k];
        weight.sqrt() * [u, v, 1.0][term]
    });
    let values = DVector::from_fn(rows, |k, _| pixels[k][3].sqrt() * pixels[k][2]);
    let solution = matrix.clone().svd(true, true).solve(&values, 1e-9).unwrap();
    let weight: f64 = pixels.iter().map(|pixel| pixel[3]).sum();
    (matrix * solution - values).norm() / weight.sqrt()
}

proptest! {
    #[test]
    fn every_cell_is_the_least_squares_of_its_pixels((map, weights) in maps()) {
        let pyramid = ModellingPyramid::new(&map, &weights, 9, 0.25).unwrap();
        for level in 0..pyramid.levels() {
            let [width, height] = pyramid.size(level);
            prop_assert_eq!(width, map.width().div_ceil(1 << level));
            prop_assert_eq!(height, map.height().div_ceil(1 << level));
            for cell in (0..width).flat_map(|c| (0..height).map(move |r| [c, r])) {
                let pixels = pixels_of(&map, &weights, level, cell);
                let Some(point) = pyramid.point(level, cell) else {
                    prop_assert!(pixels.is_empty());
                    continue;
                };
                prop_assert_eq!(point.pixels, pixels.len());
                let weight: f64 = pixels.iter().map(|pixel| pixel[3]).sum();
                let mean = |k: usize| pixels.iter().map(|p| p[3] * p[k]).sum::<f64>() / weight;
                let found = [point.centre[0], point.centre[1], point.disparity_px];
                for (k, found) in found.into_iter().enumerate() {
                    prop_assert!((found - mean(k)).abs() < 1e-9);
                }
                let least = least_residual(&pixels);
                prop_assert!((point.residual_px - least).abs() < ROUNDING, "{point:?} {least}");
                prop_assert!((point.deviation_px - least.hypot(0.25)).abs() < ROUNDING);
                // The plane has that residual.
                let squares = pixels.iter().map(|[u, v, d, weight]| {
                    let plane = point.disparity_px
                        + point.slope[0] * (u - point.centre[0])
                        + point.slope[1] * (v - point.centre[1]);
                    weight * (d - plane).powi(2)
                });
                let residual = (squares.sum::<f64>() / weight).sqrt();
                prop_assert!((residual - point.residual_px).abs() < ROUNDING, "{point:?} {residual}");
            }
        }
        let last = pyramid.size(pyramid.levels() - 1);
        prop_assert_eq!(last, [1, 1]);
    }

    #[test]
    fn selected_cells_are_flat_and_cover_each_pixel_once(
        (map, weights) in maps(),
        tolerance in 0.0..12.0,
    ) {
        let pyramid = ModellingPyramid::new(&map, &weights, 4, 0.0).unwrap();
        let mut covered = Plane::filled(map.width(), map.height(), 0u8);
        for point in pyramid.select(tolerance) {
            let is_surface = |point: &ModellingPoint| {
                point.residual_px <= tolerance && point.slope[0].hypot(point.slope[1]) <= 1.0
            };
            prop_assert!(point.level == 0 || is_surface(&point));
            for [u, v, ..] in pixels_of(&map, &weights, point.level, point.cell) {
                covered.row_mut(v as usize)[u as usize] += 1;
            }
            // No larger cell would have done.
            let above = pyramid.point(point.level + 1, point.cell.map(|index| index / 2));
            prop_assert!(above.is_none_or(|above| !is_surface(&above)));
        }
        for (row, (values, weights)) in covered.rows().zip(weights.rows()).enumerate() {
            for (column, (count, weight)) in values.iter().zip(weights).enumerate() {
                let counts = map.get(column, row).is_some() && *weight > 0.0;
                prop_assert_eq!(*count, u8::from(counts));
            }
        }
    }

    /// The disparity of a plane n·X = c is `f B (n·r)/c` less the offset, where r is the ray of the
    /// pixel of depth 1; the points of all levels lie on the plane, and predict each other.
    #[test]
    fn points_of_a_plane_lie_on_it(
        tilt in (-0.4..0.4, -0.4..0.4),
        distance in 0.8..3.0,
    ) {
        let rig = rig();
        let normal = [tilt.0, tilt.1, 1.0];
        let ([fx, fy], [cx, cy]) = (rig.left().focal(), rig.left().principal());
        let map = DisparityMap::new(Plane::from_fn(80, 42, |column, row| {
            let along = normal[0] * (column as f64 - cx) / fx + normal[1] * (row as f64 - cy) / fy;
            (fx * rig.baseline() * (along + 1.0) / distance - rig.disparity_offset()) as f32
        }));
        let pyramid = ModellingPyramid::new(&map, &weighed(&map), 5, 0.1).unwrap();
        let length: f64 = normal.iter().map(|x| x * x).sum::<f64>().sqrt();
        for point in (1..5).flat_map(|level| pyramid.points(level)) {
            prop_assert!(point.residual_px < 1e-5);
            let place = point.place(&rig).unwrap();
            let [x, y, z] = place.position.coordinates();
            let beside: f64 = (normal[0] * x + normal[1] * y + z - distance) / length;
            // Disparities are stored in single precision.
            prop_assert!(beside.abs() < 1e-5, "{beside}");
            prop_assert_eq!(place.depth, z);
            // Any other point of the plane lies on the surface of this one.
            let other = Point::new(0.0, 0.0, distance);
            prop_assert!(place.surface.signed_distance(other).unwrap().abs() < 1e-3);
            let toward = Direction::from_vector(place.surface.unit_normal().unwrap());
            prop_assert!(toward.dot(place.position.to(Point::default())) > 0.0);
            // The deviation of the depth is half of what two deviations of the disparity change.
            let sigma = point.deviation_px;
            let depth = |d: f64| rig.depth(d).unwrap();
            let change = depth(point.disparity_px - sigma) - depth(point.disparity_px + sigma);
            prop_assert!((place.depth_deviation / (0.5 * change) - 1.0).abs() < 1e-2);
            if let Some(predicted) = pyramid.predicted_disparity(&point) {
                prop_assert!((predicted - point.disparity_px).abs() < 1e-5);
            } else {
                prop_assert_eq!(point.level, 4);
            }
        }
        prop_assert_eq!(pyramid.select(1e-4).len(), 5 * 3);
    }
}

/// A plane goes through any three pixels that are not in one line. The root of a difference of
/// squares would be off by half the digits here.
#[test]
fn three_pixels_have_no_residual() {
    let pixels = || (0..16).map(|index| [index % 4, index / 4]);
    for [a, b, c] in
        pixels().flat_map(|a| pixels().flat_map(move |b| pixels().map(move |c| [a, b, c])))
    {
        let [b_from_a, c_from_a] =
            [b, c].map(|[u, v]| [u as f64 - a[0] as f64, v as f64 - a[1] as f64]);
        let area = b_from_a[0] * c_from_a[1] - b_from_a[1] * c_from_a[0];
        if area == 0.0 {
            continue;
        }
        let mut disparities = Plane::filled(4, 4, f32::NAN);
        let mut weights = Plane::filled(4, 4, 0.0);
        for ([u, v], disparity, weight) in [(a, 39.75, 1.0), (b, 0.5, 0.01), (c, 17.125, 0.3)] {
            disparities.row_mut(v)[u] = disparity;
            weights.row_mut(v)[u] = weight;
        }
        let pyramid =
            ModellingPyramid::new(&DisparityMap::new(disparities), &weights, 3, 0.0).unwrap();
        let point = pyramid.point(2, [0, 0]).unwrap();
        // Cramer's rule.
        let [down, up] = [0.5 - 39.75, 17.125 - 39.75];
        let slope = [
            (down * c_from_a[1] - up * b_from_a[1]) / area,
            (up * b_from_a[0] - down * c_from_a[0]) / area,
        ];
        assert!(point.residual_px < ROUNDING, "{point:?}");
        assert!(
            (0..2).all(|k| (point.slope[k] - slope[k]).abs() < ROUNDING),
            "{point:?} {slope:?}"
        );
    }
}

#[test]
fn cells_along_an_edge_are_small() {
    // A board of 20 px before a wall of 8 px, whose left edge is not on the border of a cell of
    // more than one pixel.
    let map = Plane::from_fn(64, 64, |column, _| if column < 21 { 8.0 } else { 20.0 });
    let map = DisparityMap::new(map);
    let pyramid = ModellingPyramid::new(&map, &weighed(&map), 7, 0.1).unwrap();
    let points = pyramid.select(0.5);
    for point in &points {
        assert_eq!(point.residual_px, 0.0);
        assert!([8.0, 20.0].contains(&point.disparity_px));
    }
    // By halving: 16 columns, then 4, then 1 left of the edge; 1, 2, 8 and 32 right of it.
    let count = |side: u32| points.iter().filter(|p| p.level == side as usize).count();
    assert_eq!([0, 1, 2, 3, 4, 5].map(count), [2 * 64, 32, 16, 8, 4, 2]);
    // The plane through 8, 20, 20 and 20 px in the columns 20 to 23 has the slope 3.6.
    let predicted = pyramid
        .predicted_disparity(&pyramid.point(1, [10, 4]).unwrap())
        .unwrap();
    assert!((predicted - 13.4).abs() < 1e-12);
}

#[test]
fn unknown_pixels_have_no_points() {
    let map = DisparityMap::new(Plane::filled(6, 5, f32::NAN));
    let pyramid = ModellingPyramid::new(&map, &weighed(&map), 8, 0.1).unwrap();
    assert_eq!(pyramid.levels(), 4);
    assert!(pyramid.select(1.0).is_empty() && pyramid.point(3, [0, 0]).is_none());
    assert!(pyramid.point(0, [6, 0]).is_none() && pyramid.point(9, [0, 0]).is_none());
    assert_eq!(pyramid.size(4), [0, 0]);
}

#[test]
fn points_at_infinity_and_behind_have_no_place() {
    let point = |disparity_px: f64| ModellingPoint {
        level: 0,
        cell: [0; 2],
        pixels: 1,
        centre: [3.0, 4.0],
        disparity_px,
        slope: [0.0; 2],
        residual_px: 0.0,
        deviation_px: 0.1,
    };
    // The offset of the rig is 3.5 px.
    assert!(point(-3.0).place(&rig()).is_some());
    assert!(point(-3.5).place(&rig()).is_none() && point(-4.0).place(&rig()).is_none());
    assert!(point(f64::NAN).place(&rig()).is_none());
}

#[test]
fn what_is_wrong_with_the_input_is_named() {
    let map = DisparityMap::new(Plane::filled(3, 2, 1.0));
    let make = |weights: &Plane<f32>, levels, deviation| {
        ModellingPyramid::new(&map, weights, levels, deviation).unwrap_err()
    };
    let good = weighed(&map);
    assert!(matches!(
        make(&Plane::filled(2, 3, 1.0), 2, 0.1),
        DisparityMapError::WeightsSize(_)
    ));
    for weight in [-1.0, f32::INFINITY] {
        let mut weights = good.clone();
        weights.values_mut()[4] = weight;
        let expected = DisparityMapError::Weight {
            weight,
            column: 1,
            row: 1,
        };
        assert_eq!(make(&weights, 2, 0.1), expected);
    }
    assert_eq!(make(&good, 0, 0.1), DisparityMapError::Levels(0));
    assert_eq!(make(&good, 33, 0.1), DisparityMapError::Levels(33));
    assert_eq!(make(&good, 2, -0.1), DisparityMapError::Deviation(-0.1));
}

#[test]
fn the_distance_of_the_paper() {
    let controls = |position, direction, constant| DistanceControls {
        position,
        direction,
        constant,
    };
    // By hand: 4 · 8 · 0.75/(2 · 8 − 4) − 2 = 0.
    assert_eq!(
        predicted_distance(2.0, 8.0, controls(2.0, -4.0, 0.25)),
        Ok(0.0)
    );
    let vanishing = predicted_distance(2.0, 8.0, controls(2.0, -16.0, 0.25));
    assert!(matches!(
        vanishing,
        Err(DisparityMapError::Denominator { .. })
    ));
    for wrong in [f64::NAN, f64::INFINITY, 1e200] {
        let result = predicted_distance(2.0, 8.0, controls(wrong, 1.0, 0.0));
        assert!(matches!(result, Err(DisparityMapError::NotFinite(_))));
    }
    let far = predicted_distance(1e200, 1e200, controls(1.0, 1.0, 0.0));
    assert!(matches!(far, Err(DisparityMapError::NotFinite(_))));
    let map = DisparityMap::new(Plane::filled(8, 8, 2.0));
    let pyramid = ModellingPyramid::new(&map, &weighed(&map), 4, 0.1).unwrap();
    let point = pyramid.point(3, [0, 0]).unwrap();
    assert_eq!(point.predicted_distance(controls(2.0, -4.0, 0.25)), Ok(0.0));
}
