//! Edges and rings, beside a search through all sides.

use std::collections::{BTreeMap, BTreeSet};

use ga_mesh::topology::{Edges, VertexRings};
use ga_mesh::{Faces, MeshError};
use proptest::prelude::*;

/// The sides of faces as (corner, face, from, to).
fn sides(faces: &Faces) -> Vec<(u32, u32, u32, u32)> {
    let mut sides = Vec::new();
    for (face, polygon) in faces.iter().enumerate() {
        for (here, &from) in polygon.iter().enumerate() {
            let to = polygon[(here + 1) % polygon.len()];
            sides.push((sides.len() as u32, face as u32, from, to));
        }
    }
    sides
}

/// Any polygons at all, degenerate ones and edges of many faces included.
fn soup() -> impl Strategy<Value = (Faces, usize)> {
    (4_usize..12).prop_flat_map(|vertices| {
        let polygon = proptest::collection::vec(0..vertices as u32, 3..6);
        let faces = proptest::collection::vec(polygon, 0..20);
        faces.prop_map(move |faces| (Faces::from_polygons(faces).unwrap(), vertices))
    })
}

proptest! {
    #[test]
    fn edges_are_the_pairs_that_faces_join((faces, vertices) in soup()) {
        let edges = Edges::new(&faces, vertices).unwrap();
        let mut expected: BTreeMap<[u32; 2], Vec<u32>> = BTreeMap::new();
        for (corner, _, a, b) in sides(&faces) {
            expected.entry([a.min(b), a.max(b)]).or_default().push(corner);
        }
        prop_assert!(edges.all().iter().eq(expected.keys()));
        prop_assert_eq!(edges.vertex_count(), vertices);
        for (edge, (&[a, b], corners)) in expected.iter().enumerate() {
            let edge = edge as u32;
            prop_assert_eq!(edges.sides(edge), &corners[..]);
            prop_assert_eq!([edges.between(a, b), edges.between(b, a)], [Some(edge); 2]);
            prop_assert_eq!([edges.other_end(edge, a), edges.other_end(edge, b)], [b, a]);
            prop_assert_eq!(edges.is_boundary(edge), corners.len() == 1);
        }
        for (corner, face, a, b) in sides(&faces) {
            let edge = edges.of_corners()[corner as usize];
            prop_assert_eq!(edges.ends(edge), [a.min(b), a.max(b)]);
            prop_assert_eq!(edges.face_of_corner(corner), face);
        }
        for a in 0..vertices as u32 {
            for b in a..vertices as u32 + 2 {
                prop_assert_eq!(edges.between(a, b).is_some(), expected.contains_key(&[a, b]));
            }
        }
    }

    #[test]
    fn every_corner_is_in_one_fan_of_its_vertex((faces, vertices) in soup()) {
        let edges = Edges::new(&faces, vertices).unwrap();
        let rings = VertexRings::new(&faces, &edges);
        let mut seen = BTreeSet::new();
        for vertex in 0..vertices as u32 {
            for fan in rings.fans(vertex) {
                prop_assert_eq!(fan.edges.len(), fan.corners.len() + usize::from(!fan.closed));
                for &corner in fan.corners {
                    prop_assert_eq!(faces.corners()[corner as usize], vertex);
                    prop_assert!(seen.insert(corner));
                }
            }
        }
        prop_assert_eq!(seen.len(), faces.corners().len());
    }
}

#[test]
fn triangles_and_polygons_have_the_same_edges() {
    let triangles = [[0, 1, 2], [2, 1, 3], [5, 4, 0]];
    let faces = Faces::from_polygons(triangles).unwrap();
    assert_eq!(
        Edges::of_triangles(&triangles, 6).unwrap(),
        Edges::new(&faces, 6).unwrap()
    );
}

#[test]
fn a_vertex_out_of_range_is_named() {
    let error =
        |polygons: &[&[u32]]| Edges::new(&Faces::from_polygons(polygons).unwrap(), 4).unwrap_err();
    let expected = |face| MeshError::IndexOutOfRange {
        face,
        index: 4,
        vertices: 4,
    };
    assert_eq!(error(&[&[0, 1, 2], &[1, 2, 4]]), expected(1));
    assert_eq!(error(&[&[0, 1, 2, 3], &[1, 2, 3], &[1, 4, 9]]), expected(2));
}

#[test]
fn no_faces_have_no_edges() {
    let edges = Edges::new(&Faces::default(), 3).unwrap();
    assert!(edges.is_empty());
    let rings = VertexRings::new(&Faces::default(), &edges);
    assert_eq!((0..3).map(|v| rings.fans(v).len()).sum::<usize>(), 0);
}

/// The other ends of a fan's edges.
fn neighbours(edges: &Edges, rings: &VertexRings, vertex: u32) -> Vec<(bool, Vec<u32>)> {
    let fans = rings.fans(vertex);
    fans.map(|fan| {
        let ends = fan.edges.iter().map(|&edge| edges.other_end(edge, vertex));
        (fan.closed, ends.collect())
    })
    .collect()
}

#[test]
fn rings_run_counter_clockwise() {
    // A 3 × 3 grid of vertices, rows from below.
    let faces = [[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7]];
    let faces = Faces::from_polygons(faces).unwrap();
    let edges = Edges::new(&faces, 9).unwrap();
    let rings = VertexRings::new(&faces, &edges);
    assert_eq!(neighbours(&edges, &rings, 4), [(true, vec![3, 1, 5, 7])]);
    assert_eq!(neighbours(&edges, &rings, 0), [(false, vec![1, 3])]);
    assert_eq!(neighbours(&edges, &rings, 5), [(false, vec![8, 4, 2])]);
    assert!((0..9).all(|vertex| rings.is_manifold(vertex)));
}

#[test]
fn tips_that_touch_have_two_fans() {
    // Two tetrahedra without a face each, with vertex 0 in common; and one with an open fan.
    let cones = [
        [0, 1, 2],
        [0, 2, 3],
        [0, 3, 1],
        [0, 5, 4],
        [0, 6, 5],
        [0, 4, 6],
    ];
    let faces = Faces::from_polygons(cones).unwrap();
    let edges = Edges::new(&faces, 7).unwrap();
    let rings = VertexRings::new(&faces, &edges);
    let expected = [(true, vec![1, 2, 3]), (true, vec![5, 4, 6])];
    assert_eq!(neighbours(&edges, &rings, 0), expected);
    assert!(!rings.is_manifold(0));

    let faces = Faces::from_polygons(&cones[..5]).unwrap();
    let edges = Edges::new(&faces, 7).unwrap();
    let rings = VertexRings::new(&faces, &edges);
    let expected = [(false, vec![6, 5, 4]), (true, vec![1, 2, 3])];
    assert_eq!(neighbours(&edges, &rings, 0), expected);
}

#[test]
fn fans_end_at_edges_of_three_faces() {
    let faces = Faces::from_polygons([[0, 1, 2], [1, 0, 3], [0, 1, 4]]).unwrap();
    let edges = Edges::new(&faces, 5).unwrap();
    let shared = edges.between(0, 1).unwrap();
    assert!(edges.non_manifold().eq([shared]));
    assert!(edges.faces(shared).eq([0, 1, 2]));
    let rings = VertexRings::new(&faces, &edges);
    assert_eq!(rings.fans(0).len(), 3);
    assert!(rings.fans(0).all(|fan| !fan.closed && fan.edges.len() == 2));
}

#[test]
fn faces_that_are_oriented_differently_share_a_fan() {
    // A fan of four triangles around 0, the second and third of which are turned over.
    let faces = [[0, 1, 2], [0, 3, 2], [0, 4, 3], [0, 4, 5]];
    let faces = Faces::from_polygons(faces).unwrap();
    let edges = Edges::new(&faces, 6).unwrap();
    let rings = VertexRings::new(&faces, &edges);
    assert_eq!(
        neighbours(&edges, &rings, 0),
        [(false, vec![1, 2, 3, 4, 5])]
    );
}
