//! What holds for every mesh.

use ga_mesh::Faces;
use ga_mesh::subdivision::{Limit, Rules, Scheme, Stencils, Tags};
use ga_mesh::topology::Edges;
use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;
use proptest::prelude::*;

use crate::second::case;
use crate::shapes::{Shape, assert_close, refine};

/// The sum of the weights of every row.
fn sums(stencils: &Stencils) -> impl Iterator<Item = f64> {
    stencils.iter().map(|(_, weights)| weights.iter().sum())
}

fn euler_characteristic(faces: &Faces, vertices: usize) -> i64 {
    let edges = Edges::new(faces, vertices).unwrap();
    vertices as i64 - edges.len() as i64 + faces.len() as i64
}

/// The stencils of each level.
fn levels(shape: &Shape, rules: Rules, tags: &Tags, count: usize) -> Vec<Stencils> {
    let mut cage = shape.cage(rules, tags);
    let mut levels = Vec::new();
    for _ in 0..count {
        let fine = cage.refine().unwrap();
        levels.push(fine.stencils);
        cage = fine.cage;
    }
    levels
}

proptest! {
    #[test]
    fn weights_are_a_partition_of_unity((shape, rules, tags) in case()) {
        for stencils in levels(&shape, rules, &tags, 2) {
            prop_assert!(sums(&stencils).all(|sum| (sum - 1.0).abs() < 1e-14));
            prop_assert_eq!(stencils.iter().count(), stencils.row_count());
            for (row, expected) in stencils.iter().enumerate() {
                prop_assert_eq!(stencils.row(row), Some(expected));
            }
            prop_assert_eq!(stencils.row(stencils.row_count()), None);
        }
        let limit = Limit::new(&shape.cage(rules, &tags)).unwrap();
        prop_assert!(sums(&limit.positions).all(|sum| (sum - 1.0).abs() < 1e-14));
        for tangents in limit.tangents {
            prop_assert!(sums(&tangents).all(|sum| sum.abs() < 1e-13));
        }
    }

    #[test]
    fn affine_maps_of_the_coarse_mesh_map_the_fine_one(
        (shape, rules, tags) in case(),
        map in proptest::array::uniform3(proptest::array::uniform4(-2.0..2.0)),
    ) {
        let mapped = |points: &[[f64; 3]]| -> Vec<[f64; 3]> {
            let row = |[a, b, c, d]: [f64; 4], [x, y, z]: [f64; 3]| a * x + b * y + c * z + d;
            points.iter().map(|&point| map.map(|weights| row(weights, point))).collect()
        };
        let (_, fine) = refine(&shape, rules, &tags, 2);
        let moved = Shape { positions: mapped(&shape.positions), faces: shape.faces.clone() };
        let (_, fine_of_moved) = refine(&moved, rules, &tags, 2);
        assert_close(&fine_of_moved, &mapped(&fine), 1e-13);
    }

    #[test]
    fn composed_stencils_give_the_finest_level((shape, rules, tags) in case()) {
        let levels = levels(&shape, rules, &tags, 3);
        let composed = levels[0].then(&levels[1]).unwrap().then(&levels[2]).unwrap();
        let found = composed.applied(&shape.positions).unwrap();
        let (_, expected) = refine(&shape, rules, &tags, 3);
        assert_close(&found, &expected, 1e-14);
        for (indices, _) in composed.iter() {
            prop_assert!(indices.is_sorted_by(|a, b| a < b));
        }
    }

    #[test]
    fn every_kind_of_value_is_summed_alike((shape, rules, tags) in case()) {
        let stencils = shape.cage(rules, &tags).refine().unwrap().stencils;
        let expected = stencils.applied(&shape.positions).unwrap();
        let points: Vec<_> = shape.positions.iter().map(|&x| Point::from(x)).collect();
        let points = stencils.applied(&points).unwrap();
        prop_assert!(points.iter().map(|point| point.coordinates()).eq(expected.iter().copied()));
        let vectors: Vec<_> = shape.positions.iter().map(|&x| Vector::from(x)).collect();
        let vectors = stencils.applied(&vectors).unwrap();
        prop_assert!(vectors.iter().map(|v| v.coordinates()).eq(expected.iter().copied()));
        let mut flat = vec![0.0; 3 * expected.len()];
        stencils.apply_channels(3, &shape.positions.concat(), &mut flat).unwrap();
        prop_assert!(flat.chunks(3).eq(expected.iter().map(|x| &x[..])));
        let single: Vec<_> = shape.positions.iter().map(|x| x.map(|x| x as f32)).collect();
        for (single, double) in stencils.applied(&single).unwrap().iter().zip(&expected) {
            for axis in 0..3 {
                prop_assert!((f64::from(single[axis]) - double[axis]).abs() < 1e-5);
            }
        }
    }

    #[test]
    fn the_euler_characteristic_stays((shape, rules, tags) in case()) {
        let before = euler_characteristic(&shape.faces(), shape.positions.len());
        let (cage, points) = refine(&shape, rules, &tags, 2);
        prop_assert_eq!(euler_characteristic(cage.faces(), points.len()), before);
        let size = match rules.scheme {
            Scheme::Loop => 3,
            Scheme::CatmullClark => 4,
        };
        prop_assert!(cage.faces().iter().all(|face| face.len() == size));
    }

    #[test]
    fn the_order_of_faces_and_their_first_corners_is_of_no_account(
        (shape, rules, tags) in case(),
        seed in any::<u64>(),
    ) {
        let mut other = shape.clone();
        for (place, face) in other.faces.iter_mut().enumerate() {
            let by = (seed.rotate_right(place as u32) % face.len() as u64) as usize;
            face.rotate_left(by);
        }
        let count = other.faces.len();
        other.faces.rotate_left(seed as usize % count);
        other.faces.swap(0, seed as usize % 7 % count);

        let (cage, points) = refine(&shape, rules, &tags, 1);
        let (other_cage, other_points) = refine(&other, rules, &tags, 1);
        // The new vertices in faces are numbered by face, all others by vertex and edge.
        let same = match rules.scheme {
            Scheme::Loop => points.len(),
            Scheme::CatmullClark => points.len() - count,
        };
        let tolerance = if rules.scheme == Scheme::Loop { 0.0 } else { 1e-15 };
        assert_close(&points[..same], &other_points[..same], tolerance);
        prop_assert_eq!(cage.edges().len(), other_cage.edges().len());
    }
}

#[test]
fn a_vertex_that_no_face_uses_stays() {
    let shape = Shape::new(
        &[[0.0; 3], [1.0, 0.0, 0.0], [9.0, 9.0, 9.0], [0.0, 1.0, 0.0]],
        &[[0, 1, 3]],
    );
    for rules in [Rules::LOOP, Rules::CATMULL_CLARK] {
        let (_, points) = refine(&shape, rules, &Tags::default(), 2);
        assert_eq!(points[2], [9.0; 3]);
    }
}

#[test]
fn a_vertex_where_two_cones_touch_stays() {
    let cones = [
        [0, 1, 2],
        [0, 2, 3],
        [0, 3, 1],
        [0, 5, 4],
        [0, 6, 5],
        [0, 4, 6],
    ];
    let positions: Vec<[f64; 3]> = (0..7)
        .map(|v| [f64::from(v * v % 5), f64::from(v), f64::from(v % 3)])
        .collect();
    let shape = Shape::new(&positions, &cones);
    for rules in [Rules::LOOP, Rules::CATMULL_CLARK] {
        let (cage, points) = refine(&shape, rules, &Tags::default(), 3);
        assert_eq!(points[0], positions[0]);
        assert_eq!(cage.corners()[0].vertex, 0);
        let mut tags = Tags::default();
        tags.corners.push(crate::shapes::corner(0, 0.0));
        assert_eq!(refine(&shape, rules, &tags, 3).1[0], positions[0]);
    }
}
