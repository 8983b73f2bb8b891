//! Overlaps with spheres, boxes, lines and planes.

use ga_mesh::query::{Bvh, ClosedSurface, NotClosed, QueryError};
use ga_runtime::cga3::{Line, Plane, Point, Sphere};
use ga_runtime::vga3::Vector;
use proptest::prelude::*;

use super::surface::star;
use super::{place, placed_soups, plain, triple};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn within_a_radius_are_the_triangles_that_are_near(
        (soup, scale, shift) in placed_soups(),
        centre in triple(),
        radius in 0.0..3.0_f64,
    ) {
        let bvh = soup.bvh();
        let (centre, radius) = (Vector::from(place(centre, scale, shift)), radius * scale);
        let found = bvh.within(centre.into(), radius).unwrap();
        prop_assert!(found.windows(2).all(|pair| pair[0].triangle < pair[1].triangle));
        let sphere = Sphere::from_centre_radius(centre.into(), radius);
        let on_sphere = (radius > 0.1 * scale).then(|| bvh.on_sphere(sphere).unwrap());
        for triangle in 0..soup.triangles.len() {
            let corners = soup.corners(triangle);
            let distance = centre.distance(plain::closest(centre, corners));
            let is_found = found.iter().any(|near| near.triangle as usize == triangle);
            let tolerance = 1e-8 * scale;
            if (distance - radius).abs() > tolerance {
                prop_assert_eq!(is_found, distance < radius);
            }
            let farthest = corners.map(|c| c.distance(centre)).into_iter().fold(0.0, f64::max);
            if let Some(on_sphere) = &on_sphere {
                let is_on = on_sphere.contains(&(triangle as u32));
                if (distance - radius).abs() > tolerance && (farthest - radius).abs() > tolerance {
                    prop_assert_eq!(is_on, distance < radius && radius < farthest);
                }
            }
        }
    }

    /// A triangle meets a box if a part is left after it was clipped by the six planes of the box.
    #[test]
    fn in_a_box_are_the_triangles_of_which_clipping_leaves_something(
        (soup, scale, shift) in placed_soups(),
        a in triple(),
        b in triple(),
    ) {
        let bvh = soup.bvh();
        let [a, b] = [a, b].map(|p| Vector::from(place(p, scale, shift)));
        let (low, high) = (a.min(b), a.max(b));
        let found = bvh.in_box([low.into(), high.into()]).unwrap();
        for triangle in 0..soup.triangles.len() {
            let is_found = found.contains(&(triangle as u32));
            let clipped = |margin: f64| {
                let margin = Vector::new(margin, margin, margin) * scale;
                !clip(soup.corners(triangle).to_vec(), low - margin, high + margin).is_empty()
            };
            if clipped(-1e-9) {
                prop_assert!(is_found);
            }
            if !clipped(1e-9) {
                prop_assert!(!is_found);
            }
        }
    }
}

/// The part of a polygon in a box, by Sutherland and Hodgman.
fn clip(mut polygon: Vec<Vector<f64>>, low: Vector<f64>, high: Vector<f64>) -> Vec<Vector<f64>> {
    for axis in 0..3 {
        for (bound, sign) in [(low[axis], 1.0), (high[axis], -1.0)] {
            let height = |p: Vector<f64>| (p[axis] - bound) * sign;
            let mut rest = Vec::new();
            for (i, &p) in polygon.iter().enumerate() {
                let q = polygon[(i + 1) % polygon.len()];
                if height(p) >= 0.0 {
                    rest.push(p);
                }
                if (height(p) >= 0.0) != (height(q) >= 0.0) {
                    rest.push(p + (q - p) * (height(p) / (height(p) - height(q))));
                }
            }
            polygon = rest;
        }
    }
    polygon
}

#[test]
fn lines_cross_a_closed_surface_in_and_out() {
    let soup = star(3, 0.0);
    let bvh = soup.bvh();
    let line = Line::through(Point::new(0.1, 0.2, -9.0), Point::new(0.1, 0.2, -8.0));
    let crossings = bvh.crossings(line).unwrap();
    assert_eq!(crossings.len(), 2);
    let height = (1.0_f64 - 0.05).sqrt();
    for (crossing, expected) in crossings.iter().zip([-height, height]) {
        assert!((crossing.position - expected).abs() < 0.02);
        assert!((crossing.point.e3() - crossing.position).abs() < 1e-12);
    }
    assert!(
        bvh.crossings(Line::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
            .is_err()
    );
}

#[test]
fn the_section_of_a_sphere_is_a_circle() {
    let soup = star(4, 0.0);
    let bvh = soup.bvh();
    for height in [0.0, 0.3, -0.77] {
        let normal = [0.36, 0.48, 0.8];
        let point = Point::from(normal.map(|x| x * height));
        let plane = Plane::from_point_normal(point, normal);
        let contours = bvh.contours(plane).unwrap();
        assert_eq!(contours.len(), 1);
        assert!(contours[0].is_closed);
        let points: Vec<_> = contours[0]
            .points
            .iter()
            .map(|&p| Vector::from(p))
            .collect();
        let around = (0..points.len()).map(|i| points[i].distance(points[(i + 1) % points.len()]));
        let circle = std::f64::consts::TAU * (1.0_f64 - height * height).sqrt();
        assert!((around.sum::<f64>() / circle - 1.0).abs() < 0.01);
        for p in &points {
            assert!((p.dot(normal.into()) - height).abs() < 1e-12);
        }
        // Counter-clockwise about the normal, seen from its tip, runs with the outside to the
        // right.
        let area = (0..points.len())
            .map(|i| {
                points[i]
                    .cross(points[(i + 1) % points.len()])
                    .dot(normal.into())
            })
            .sum::<f64>();
        let segments = bvh.section(plane).unwrap();
        assert_eq!(segments.len(), points.len());
        let area_of_segments: f64 = segments
            .iter()
            .map(|s| {
                Vector::from(s.ends[0])
                    .cross(s.ends[1].into())
                    .dot(normal.into())
            })
            .sum();
        assert!(area_of_segments > 0.0);
        assert!((area.abs() - area_of_segments).abs() < 1e-9);
    }
    let beside = Plane::from_point_normal(Point::new(0.0, 0.0, 2.0), [0.0, 0.0, 1.0]);
    assert!(bvh.contours(beside).unwrap().is_empty());
    let none = Plane::from_point_normal(Point::default(), [0.0; 3]);
    let expected = Err(QueryError::Degenerate { what: "plane" });
    assert_eq!(bvh.section(none), expected);
}

/// The sign is that of the parity of crossings.
#[test]
fn signed_distances_are_negative_inside() {
    let soup = star(3, 5.0);
    let surface = ClosedSurface::new(&soup.positions, &soup.triangles).unwrap();
    let mut inside = 0;
    for i in 0..4000_u32 {
        let number = |k: u32| f64::from(i.wrapping_mul(k) % 4001) / 2000.5 - 1.0;
        let point = Point::new(number(7) * 1.3, number(1301) * 1.3, number(2903) * 1.3);
        let line = Line::from_point_direction(point, [0.3, 0.5, 0.81]);
        let along = Vector::from(line.unit_direction().unwrap());
        let position = Vector::from(point).dot(along);
        let crossings = surface.bvh().crossings(line).unwrap();
        let after = crossings.iter().filter(|c| c.position > position).count();
        let distance = surface.signed_distance(point).unwrap();
        assert_eq!(distance < 0.0, after % 2 == 1, "{point:?} {distance}");
        let nearest = surface.bvh().nearest(point).unwrap();
        assert_eq!(distance.abs(), nearest.distance);
        inside += u32::from(distance < 0.0);
    }
    assert!((200..3800).contains(&inside));
    for &vertex in &soup.positions {
        assert_eq!(surface.signed_distance(vertex.into()), Ok(0.0));
    }
    let open = ClosedSurface::new(&soup.positions, &soup.triangles[1..]).unwrap_err();
    assert!(matches!(open, NotClosed::Edge { .. }));
    let none: [[f64; 3]; 0] = [];
    let empty = ClosedSurface::new(&none, &[]).unwrap();
    assert_eq!(
        empty.signed_distance(Point::default()),
        Err(QueryError::NoTriangles)
    );
}

#[test]
fn queries_that_are_not_finite_are_errors() {
    let bvh = star(1, 0.0).bvh();
    let bad = Point::new(f64::NAN, 0.0, 0.0);
    assert_eq!(
        bvh.within(bad, 1.0),
        Err(QueryError::NotFinite { what: "point" })
    );
    let radius = bvh.within(Point::default(), f64::NAN);
    assert_eq!(radius, Err(QueryError::NotFinite { what: "radius" }));
    let corners = [Point::default(), bad];
    assert_eq!(
        bvh.in_box(corners),
        Err(QueryError::NotFinite { what: "box" })
    );
    let imaginary = Sphere::from_centre_radius_squared(Point::default(), -1.0);
    let expected = Err(QueryError::Degenerate { what: "sphere" });
    assert_eq!(bvh.on_sphere(imaginary), expected);
    let empty = Bvh::new(&[[0.0; 3]], &[]).unwrap();
    let line = Line::through(Point::default(), Point::new(1.0, 0.0, 0.0));
    assert_eq!(empty.crossings(line), Ok(vec![]));
    assert_eq!(empty.within(Point::default(), 1.0), Ok(vec![]));
}
