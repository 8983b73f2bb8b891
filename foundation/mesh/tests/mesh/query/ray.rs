//! Rays.

use ga_runtime::cga3::Point;
use ga_runtime::geometry::ray::{Hit, Ray};
use ga_runtime::vga3::Vector;
use proptest::prelude::*;

use super::surface::star;
use super::{Soup, place, placed_soups, triple};

/// All hits by the test of the engine for one triangle, in order.
fn one_by_one(soup: &Soup, ray: Ray<f64>) -> Vec<(u32, Hit<f64>)> {
    let hit = |triangle: usize| ray.first_hit(soup.corners(triangle).map(Point::from));
    let mut hits: Vec<(u32, Hit<f64>)> = (0..soup.triangles.len())
        .filter_map(|triangle| Some((triangle as u32, hit(triangle)?)))
        .collect();
    hits.sort_by(|a, b| a.1.distance.total_cmp(&b.1.distance));
    hits
}

/// The targets of rays: anywhere, or exactly a corner or the middle of an edge.
fn target(soup: &Soup, anywhere: Vector<f64>, choice: usize) -> Vector<f64> {
    let [a, b, _] = soup.corners(choice / 3 % soup.triangles.len());
    match choice % 3 {
        0 => anywhere,
        1 => a,
        _ => (a + b) * 0.5,
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn hits_are_those_of_all_triangles(
        (soup, scale, shift) in placed_soups(),
        queries in prop::collection::vec((triple(), triple(), 0..1000_usize), 1..8),
        far in prop_oneof![Just(1.0), Just(50.0), Just(1e5)],
        limit in 0.1..8.0_f64,
    ) {
        let bvh = soup.bvh();
        for (from, to, choice) in queries {
            let to = target(&soup, place(to, scale, shift).into(), choice);
            let from = Vector::from(place(from, scale, shift));
            let from = to + (from - to) * far;
            let Some(ray) = Ray::through(from.into(), to.into()) else { continue };
            let expected = one_by_one(&soup, ray);

            let found = bvh.all_hits(ray);
            let list: Vec<_> = found.iter().map(|found| (found.triangle, found.hit)).collect();
            prop_assert_eq!(&list, &expected);
            prop_assert_eq!(bvh.first_hit(ray), found.first().copied());
            prop_assert_eq!(bvh.is_hit(ray, f64::INFINITY), !expected.is_empty());

            let limit = limit * scale * far;
            let near = expected.iter().any(|(_, hit)| hit.distance < limit);
            prop_assert_eq!(bvh.is_hit(ray, limit), near);
            let first = bvh.first_hit_within(ray, limit);
            prop_assert_eq!(first, found.first().copied().filter(|_| near));

            for found in found {
                let [a, b, c] = soup.corners(found.triangle as usize);
                let normal = (b - a).cross(c - a);
                // Twice the area as seen along the ray, relative to the square of the longest side.
                let sides = [a.distance(b), b.distance(c), c.distance(a)];
                let longest = sides.into_iter().fold(0.0, f64::max);
                let seen = normal.dot(ray.direction().into()).abs() / (longest * longest);
                let [u, v, w] = found.barycentric;
                prop_assert!((u + v + w - 1.0).abs() < 1e-15);
                prop_assert!([u, v, w].iter().all(|x| (0.0..=1.0).contains(x)));
                if seen > 1e-3 {
                    let place = a * u + b * v + c * w;
                    let size = from.length() + to.length();
                    prop_assert!(place.distance(found.hit.point.into()) < 1e-10 * size);
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// A ray from the inside of a closed surface hits it, also where it is aimed at an edge or a
    /// corner, and one from outside hits it if it is aimed at the inside.
    #[test]
    fn rays_do_not_slip_through_edges(
        bumps in 0.0..6.0_f64,
        shift in prop_oneof![Just([0.0; 3]), triple(), Just([1e4, -3e5, 77.7])],
        part in 0.0..1.0_f64,
        away in prop_oneof![1.0..10.0_f64, Just(1e3), Just(1e6)],
    ) {
        let mut soup = star(3, bumps);
        for position in &mut soup.positions {
            *position = place(*position, 1.0, shift);
        }
        let bvh = soup.bvh();
        let centre = Vector::from(shift);
        for triangle in 0..soup.triangles.len() {
            let [a, b, c] = soup.corners(triangle);
            for target in [a, (a + b) * 0.5, a + (b - a) * part, b + (c - b) * part] {
                let outwards = Ray::through(centre.into(), target.into()).unwrap();
                prop_assert!(bvh.first_hit(outwards).is_some());
                prop_assert!(bvh.is_hit(outwards, f64::INFINITY));
                let outside = target + (target - centre) * away;
                let inwards = Ray::through(outside.into(), centre.into()).unwrap();
                prop_assert!(bvh.first_hit(inwards).is_some());
            }
        }
        for axis in 0..3 {
            let mut direction = Vector::ZERO;
            direction[axis] = 1.0;
            for direction in [direction, -direction] {
                prop_assert!(bvh.first_hit(Ray::new(centre.into(), direction).unwrap()).is_some());
            }
        }
    }
}

#[test]
fn rays_along_the_surface_of_a_plane_and_along_its_edges_miss_it() {
    let soup = Soup {
        positions: vec![
            [0.0, 0.0, 0.0],
            [4.0, 0.0, 0.0],
            [4.0, 4.0, 0.0],
            [0.0, 4.0, 0.0],
        ],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
    };
    let bvh = soup.bvh();
    let ray = |from: [f64; 3], direction: [f64; 3]| Ray::new(from.into(), direction).unwrap();
    // As ga-runtime decides for each triangle.
    for (from, direction) in [
        ([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]),
        ([-1.0, -1.0, 0.0], [1.0, 1.0, 0.0]),
        ([-1.0, 2.0, 0.0], [1.0, 0.0, -0.0]),
        ([4.5, 2.0, 1.0], [0.0, 0.0, -1.0]),
    ] {
        assert_eq!(bvh.first_hit(ray(from, direction)), None);
        assert!(bvh.all_hits(ray(from, direction)).is_empty());
    }
    // Through a corner, an edge and the diagonal, parallel to an axis.
    for (x, y) in [(0.0, 0.0), (4.0, 4.0), (2.0, 0.0), (4.0, 3.0), (2.0, 2.0)] {
        let found = bvh.first_hit(ray([x, y, 3.0], [-0.0, 0.0, -2.0])).unwrap();
        assert_eq!(found.hit.distance, 3.0);
        assert_eq!(found.hit.point, Point::new(x, y, 0.0));
    }
    let through_diagonal = bvh.all_hits(ray([1.0, 1.0, -3.0], [0.0, 0.0, 1.0]));
    assert_eq!(through_diagonal.len(), 2);
}

/// Beside a triangle that is seen edge-on, on the line of its image, rounded areas have one sign.
#[test]
fn triangles_seen_edge_on_are_not_hit_beside_their_edges() {
    let triangles = [
        // The ray is in the plane of each, and its nearest point is at a distance of 3 or more.
        (
            [[2.0, 2.0, -1.0], [1.0, 0.0, 0.0], [-1.0, -1.0, -1.0]],
            [-1.0, -2.0, 0.0],
            [3.0, 1.0, 2.0],
        ),
        (
            [[-4.0, 4.0, 2.0], [0.0, 4.0, 4.0], [4.0, 0.0, 4.0]],
            [-4.0, -2.0, -1.0],
            [3.0, -1.0, 1.0],
        ),
    ];
    for (corners, origin, direction) in triangles {
        let ray = Ray::new(Point::from(origin), direction).unwrap();
        let scaled = Vector::from(direction);
        let from_origin = corners.map(|corner| Vector::from(corner) - Vector::from(origin));
        let [a, b, c] = from_origin;
        assert_eq!((b - a).cross(c - a).dot(scaled), 0.0);
        assert_eq!(ray.first_hit(corners.map(Point::from)), None);
        let bvh = ga_mesh::query::Bvh::new(&corners, &[[0, 1, 2]]).unwrap();
        assert!(bvh.all_hits(ray).is_empty());
        assert!(!bvh.is_hit(ray, f64::INFINITY));
    }
}

/// Rounded areas of a triangle without area may have one sign.
#[test]
fn triangles_without_area_are_not_hit() {
    let corners = [[-2.0, 2.0, 1.0], [2.0, 2.0, -1.0], [0.0, 2.0, 0.0]];
    let bvh = ga_mesh::query::Bvh::new(&corners, &[[0, 1, 2]]).unwrap();
    for step in 0..1000 {
        // Towards points of the line on which the corners lie, from many places.
        let part = f64::from(step) / 1000.0;
        let target = Vector::new(2.0 - 4.0 * part, 2.0, 2.0 * part - 1.0);
        let origin = Vector::new(7.0 * part, -1.0 - part, 3.0 - part * part);
        let Some(ray) = Ray::through(origin.into(), target.into()) else {
            continue;
        };
        assert_eq!(ray.first_hit(corners.map(Point::from)), None);
        assert_eq!(bvh.first_hit(ray), None);
        assert!(!bvh.is_hit(ray, f64::INFINITY) && bvh.all_hits(ray).is_empty());
    }
}
