//! Nearest points.

use ga_mesh::query::{Bvh, Nearest, QueryError};
use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;
use proptest::prelude::*;

use super::surface::star;
use super::{Soup, place, placed_soups, plain, triple};

/// The nearest point of one triangle, by a hierarchy over that triangle alone: the same kernel
/// without a tree.
fn alone(soup: &Soup, triangle: usize, point: Point<f64>) -> Nearest {
    let bvh = Bvh::new(&soup.positions, &soup.triangles[triangle..=triangle]).unwrap();
    Nearest {
        triangle: triangle as u32,
        ..bvh.nearest(point).unwrap()
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn nearest_points_are_those_of_all_triangles(
        (soup, scale, shift) in placed_soups(),
        points in prop::collection::vec(triple(), 1..8),
        far in prop_oneof![Just(1.0), Just(40.0), Just(1e7), Just(1e20)],
    ) {
        let bvh = soup.bvh();
        for point in points {
            let point = Vector::from(place(point, scale, shift)) * far;
            let found = bvh.nearest(point.into()).unwrap();
            prop_assert_eq!(found, alone(&soup, found.triangle as usize, point.into()));
            for triangle in 0..soup.triangles.len() {
                let other = alone(&soup, triangle, point.into());
                prop_assert!(found.distance <= other.distance);
            }

            let distances = (0..soup.triangles.len()).map(|t| {
                point.distance(plain::closest(point, soup.corners(t)))
            });
            let least = distances.fold(f64::INFINITY, f64::min);
            let tolerance = 1e-9 * scale + 1e-12 * least;
            prop_assert!((found.distance - least).abs() <= tolerance);

            // The point lies where it says, at the distance it says.
            let on_surface = Vector::from(found.point);
            prop_assert!((on_surface.distance(point) - found.distance).abs() <= tolerance);
            let corners = soup.corners(found.triangle as usize);
            let weights = found.barycentric;
            let sum = corners.iter().zip(weights).fold(Vector::ZERO, |sum, (c, w)| sum + *c * w);
            prop_assert!(sum.distance(on_surface) <= tolerance);
            prop_assert!(weights.iter().all(|w| (0.0..=1.0).contains(w)));
            prop_assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn a_radius_bounds_the_distance(
        (soup, scale, shift) in placed_soups(),
        point in triple(),
        factor in 0.0..2.0_f64,
    ) {
        let bvh = soup.bvh();
        let point = Point::from(place(point, scale, shift));
        let nearest = bvh.nearest(point).unwrap();
        let radius = nearest.distance * factor;
        let within = bvh.nearest_within(point, radius).unwrap();
        if factor > 1.0 + 1e-12 || nearest.distance == 0.0 {
            prop_assert_eq!(within, Some(nearest));
        } else if factor < 1.0 - 1e-12 {
            prop_assert_eq!(within, None);
        }
    }
}

#[test]
fn points_of_the_surface_are_their_own_nearest_points() {
    let soup = star(4, 5.0);
    let bvh = soup.bvh();
    for (vertex, &position) in soup.positions.iter().enumerate() {
        let nearest = bvh.nearest(position.into()).unwrap();
        assert_eq!(nearest.distance, 0.0);
        assert_eq!(nearest.point, position.into());
        let first = soup
            .triangles
            .iter()
            .position(|triangle| triangle.contains(&(vertex as u32)));
        assert_eq!(Some(nearest.triangle as usize), first);
        let zeros = nearest.barycentric.iter().filter(|&&w| w == 0.0).count();
        assert_eq!(zeros, 2);
    }
    for triangle in 0..soup.triangles.len() {
        let [a, b, c] = soup.corners(triangle);
        let nearest = bvh.nearest(((a + b) * 0.5).into()).unwrap();
        assert!(nearest.distance < 1e-15);
        let middle = (a + b + c) * (1.0 / 3.0);
        let nearest = bvh.nearest(middle.into()).unwrap();
        assert!(nearest.distance < 1e-15 && nearest.triangle as usize == triangle);
    }
}

#[test]
fn what_is_not_finite_is_an_error() {
    let bvh = star(1, 0.0).bvh();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let point = Point::new(0.0, bad, 1.0);
        let expected = Err(QueryError::NotFinite { what: "point" });
        assert_eq!(bvh.nearest(point), expected);
    }
    let expected = Err(QueryError::NotFinite { what: "radius" });
    assert_eq!(bvh.nearest_within(Point::default(), f64::NAN), expected);
    // Its squared distance is beyond the range of the scalar.
    let expected = Err(QueryError::NotFinite { what: "point" });
    assert_eq!(bvh.nearest(Point::new(1e200, 0.0, 0.0)), expected);
    assert_eq!(bvh.nearest_within(Point::default(), -1.0), Ok(None));
}
