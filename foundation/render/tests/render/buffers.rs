//! What is seen in each pixel, against spheres and rays cast by plain arithmetic.

use ga_image::picture::Picture;
use ga_render::{Attribute, Buffers, MaterialChoice, Object, RenderError, Scene, View};
use proptest::prelude::*;

use crate::pictures::sphere;
use crate::scenes::{CORNERS, UNIT_SQUARE, cross, dot, minus, square};
use crate::view::point;
use crate::{FIELD_OF_VIEW, front};

const SIZE: u32 = 41;

/// The direction, of depth 1, in which [`front`] sees the middle of a pixel.
fn ray(column: usize, row: usize) -> [f64; 3] {
    let half = f64::from(SIZE) / 2.0;
    let slope = (FIELD_OF_VIEW / 2.0).tan() / half;
    let offset = |pixel: usize| (pixel as f64 + 0.5 - half) * slope;
    [offset(column), -offset(row), -1.0]
}

#[test]
fn a_sphere_is_as_far_away_as_its_equation_says() {
    let (positions, triangles) = sphere(1.0, [0.0; 3]);
    let scene = Scene::new(&positions, &triangles);
    let buffers = Buffers::new(&scene, &front(5.0), SIZE, SIZE).unwrap();
    let (depth, distance) = (buffers.depth(), buffers.distance());
    let (normals, positions_seen) = (buffers.normals(), buffers.positions());
    let mut seen = 0;
    for row in 0..SIZE as usize {
        for column in 0..SIZE as usize {
            let ray = ray(column, row);
            // |eye + d ray|² = 1 with eye = (0, 0, 5).
            let (a, b, c) = (dot(ray, ray), 5.0 * ray[2], 24.0);
            let discriminant = b * b - a * c;
            let found = f64::from(depth.get(column, row).unwrap());
            if discriminant > 0.2 {
                let exact = (-b - discriminant.sqrt()) / a;
                // The mesh lies up to 1 − cos(π/96) = 0.0005 within the sphere.
                assert!((found - exact).abs() < 2e-3, "({column}, {row})");
                let far = f64::from(distance.get(column, row).unwrap());
                assert!((far - exact * a.sqrt()).abs() < 2e-3);
                let place = [ray[0] * exact, ray[1] * exact, 5.0 - exact];
                let normal = normals.get(column, row).unwrap().map(f64::from);
                for axis in 0..3 {
                    assert!((normal[axis] - place[axis]).abs() < 5e-3);
                }
                seen += 1;
            } else if discriminant < -0.2 {
                assert_eq!(found, f64::INFINITY);
                assert_eq!(normals.get(column, row), Some([0.0; 3]));
                assert_eq!(positions_seen.get(column, row), Some([f32::INFINITY; 3]));
            }
        }
    }
    assert!(seen > 200, "{seen}");
}

#[test]
fn texture_coordinates_are_those_of_the_place() {
    let positions = square(0.0);
    let mut object = Object::new(&positions, &UNIT_SQUARE);
    object.texture_coordinates = Some(Attribute::of_vertices(&CORNERS));
    let bare = square(1.0).map(|[x, y, z]| [0.2 * x, 0.2 * y, z]);
    let scene = Scene {
        objects: vec![object, Object::new(&bare, &UNIT_SQUARE)],
        ..Scene::default()
    };
    let buffers = Buffers::new(&scene, &front(5.0), SIZE, SIZE).unwrap();
    let coordinates = buffers.texture_coordinates();
    let mut seen = [0, 0];
    for row in 0..SIZE as usize {
        for column in 0..SIZE as usize {
            let ray = ray(column, row);
            let here = coordinates.get(column, row).unwrap().map(f64::from);
            let (x, y) = (5.0 * ray[0], 5.0 * ray[1]);
            let in_front = (4.0 * ray[0]).abs() < 0.2 && (4.0 * ray[1]).abs() < 0.2;
            if in_front || x.abs() > 1.0 || y.abs() > 1.0 {
                assert_eq!(here, [0.0; 3]);
                seen[0] += u32::from(in_front);
            } else {
                assert!((here[0] - (x + 1.0) / 2.0).abs() < 1e-6);
                assert!((here[1] - (y + 1.0) / 2.0).abs() < 1e-6);
                assert_eq!(here[2], 1.0);
                seen[1] += 1;
            }
        }
    }
    assert!(seen[0] > 4 && seen[1] > 100, "{seen:?}");
}

/// Möller and Trumbore: distance along the ray and barycentric coordinates, of the unclamped plane.
fn hit(eye: [f64; 3], ray: [f64; 3], [a, b, c]: [[f64; 3]; 3]) -> Option<(f64, [f64; 3])> {
    let (ab, ac, to_eye) = (minus(b, a), minus(c, a), minus(eye, a));
    let across = cross(ray, ac);
    let volume = dot(ab, across);
    if volume.abs() < 1e-9 {
        return None;
    }
    let second = dot(to_eye, across) / volume;
    let other = cross(to_eye, ab);
    let third = dot(ray, other) / volume;
    Some((
        dot(ac, other) / volume,
        [1.0 - second - third, second, third],
    ))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Every pixel shows the triangle that a search of all of them finds first along its ray.
    #[test]
    fn the_nearest_triangle_is_seen(
        triangles in prop::collection::vec(prop::array::uniform3(point()), 1..14),
        split in any::<prop::sample::Index>(),
    ) {
        // As soups of triangles in two objects, in front of the camera and behind it.
        let positions: Vec<[f64; 3]> = triangles.concat();
        let indices: Vec<[u32; 3]> = (0..triangles.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
        let split = split.index(triangles.len() + 1);
        let materials: Vec<Option<u32>> = (0..triangles.len()).map(|t| (t % 3 == 0).then_some(0)).collect();
        let mut objects = [Object::new(&positions, &indices[..split]), Object::new(&positions, &indices[split..])];
        objects[0].material = MaterialChoice::PerTriangle(&materials[..split]);
        let near = 2.0;
        let eye = [0.0, 0.0, 30.0];
        let scene = Scene { objects: objects.to_vec(), materials: &[Default::default()], ..Scene::default() };
        let camera = View::look_at(eye, [0.0; 3], [0.0, 1.0, 0.0], FIELD_OF_VIEW, near).unwrap();
        let buffers = Buffers::new(&scene, &camera, SIZE, SIZE).unwrap();
        for row in 0..SIZE as usize {
            for column in 0..SIZE as usize {
                let ray = ray(column, row);
                let mut nearest = f64::INFINITY;
                let mut first = None;
                let mut unclear = false;
                for (index, &triangle) in triangles.iter().enumerate() {
                    let Some((depth, weights)) = hit(eye, ray, triangle) else {
                        unclear = true;
                        continue;
                    };
                    let least = weights.into_iter().fold(f64::INFINITY, f64::min);
                    // Outlines lie on a grid of 1/4096 pixel, depths in single precision.
                    if depth > 0.5 * near && least.abs() < 1e-2 {
                        unclear = true;
                    }
                    if least > 0.0 && (depth - near).abs() < 1e-3 || (depth - nearest).abs() < 1e-3 * nearest {
                        unclear = true;
                    }
                    if least > 0.0 && depth > near && depth < nearest {
                        (nearest, first) = (depth, Some((index, weights)));
                    }
                }
                if unclear {
                    continue;
                }
                let seen = buffers.get(column, row);
                prop_assert_eq!(seen.is_some(), first.is_some(), "({}, {})", column, row);
                let (Some(seen), Some((index, weights))) = (seen, first) else { continue };
                let expected = if index < split { (0, index) } else { (1, index - split) };
                prop_assert_eq!((seen.object, seen.triangle), expected);
                let material = (index < split && index % 3 == 0).then_some(0);
                prop_assert_eq!(seen.material, material);
                prop_assert!((seen.depth - nearest).abs() < 1e-6 * nearest);
                for (seen, expected) in seen.barycentric.into_iter().zip(weights) {
                    prop_assert!((seen - expected).abs() < 1e-6);
                }
            }
        }
    }
}

#[test]
fn sizes_and_scenes_are_checked() {
    let positions = square(0.0);
    let scene = Scene::new(&positions, &[[0, 1, 4]]);
    let buffers = |scene, width| Buffers::new(scene, &front(5.0), width, 5).map(|_| ());
    assert!(matches!(
        buffers(&scene, 5),
        Err(RenderError::Triangle { vertex: 4, .. })
    ));
    assert!(matches!(buffers(&scene, 0), Err(RenderError::Style(_))));
    assert!(matches!(
        buffers(&scene, 20_000),
        Err(RenderError::Style(_))
    ));
    let empty = Scene::default();
    let nothing = Buffers::new(&empty, &front(5.0), 5, 5).unwrap();
    assert_eq!(nothing.points().values(), [None; 25]);
    assert_eq!(nothing.get(5, 0), None);
}

/// The files hold what the buffers say, in the order and of the kinds that the page lists.
#[test]
fn the_files_of_buffers_hold_their_numbers() {
    let (positions, triangles) = sphere(1.0, [0.0; 3]);
    let scene = Scene::new(&positions, &triangles);
    let buffers = Buffers::new(&scene, &front(5.0), SIZE, SIZE).unwrap();
    let files = ga_render::buffer_files::encode(&buffers).unwrap();
    let names: Vec<&str> = files.iter().map(|(name, _)| *name).collect();
    assert_eq!(names, ga_render::buffer_files::NAMES);
    let floats = |file: usize| match ga_image::pfm::decode(&files[file].1).unwrap() {
        Picture::GreyF32(plane) => plane,
        other => panic!("one float a pixel, not {other:?}"),
    };
    assert_eq!(floats(0).values(), buffers.depth().values());
    assert_eq!(floats(1).values(), buffers.distance().values());
    let triples = |file: usize| match ga_image::pfm::decode(&files[file].1).unwrap() {
        Picture::RgbF32(plane) => plane,
        other => panic!("three floats a pixel, not {other:?}"),
    };
    assert_eq!(triples(2).values(), buffers.texture_coordinates().values());
    assert_eq!(triples(3).values(), buffers.normals().values());
    let Picture::Rgb16(identities) = ga_image::png::decode(&files[4].1).unwrap() else {
        panic!("three numbers of 16 bits")
    };
    let points = buffers.points();
    for (identity, point) in identities.values().iter().zip(points.values()) {
        let expected = point.map_or([0; 3], |point| [1, 0, point.triangle as u16 + 1]);
        assert_eq!(*identity, expected);
    }
    assert!(identities.values().iter().any(|identity| identity[2] > 1));
    let Picture::Grey16(materials) = ga_image::png::decode(&files[5].1).unwrap() else {
        panic!("a number of 16 bits")
    };
    assert!(materials.values().iter().all(|material| *material == 0));
}
