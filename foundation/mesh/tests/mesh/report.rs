//! Reports on surfaces whose topology is known.

use ga_mesh::topology::Report;
use ga_mesh::{Faces, Mesh, obj};
use nullcone_shared_data::shared;

fn report(vertices: usize, faces: &[&[u32]]) -> Report {
    // Places in general position: no three on a line.
    let places = (0..vertices).map(|v| {
        let v = v as f64;
        [v, v * v, v * v * v]
    });
    let faces = Faces::from_polygons(faces).unwrap();
    Report::of_mesh(&Mesh::new(places.collect(), faces).unwrap())
}

const CUBE: [&[u32]; 6] = [
    &[0, 3, 2, 1],
    &[4, 5, 6, 7],
    &[0, 1, 5, 4],
    &[1, 2, 6, 5],
    &[2, 3, 7, 6],
    &[3, 0, 4, 7],
];

#[test]
fn a_cube_is_a_sphere() {
    let cube = report(8, &CUBE);
    assert_eq!((cube.vertices, cube.edges, cube.faces), (8, 12, 6));
    assert_eq!((cube.components, cube.euler_characteristic), (1, 2));
    assert_eq!(cube.genus, Some(0));
    assert!(cube.is_closed() && cube.orientable);
    assert!(cube.boundary_loops.is_empty() && cube.degenerate_faces.is_empty());
}

#[test]
fn a_box_without_lid_and_floor_is_a_tube() {
    let tube = report(8, &CUBE[2..]);
    assert_eq!(tube.euler_characteristic, 0);
    assert_eq!(tube.boundary_edges, 8);
    assert_eq!(tube.boundary_loops, [[0, 1, 2, 3], [4, 5, 6, 7]]);
    assert_eq!(tube.genus, Some(0));
    assert!(tube.is_manifold() && !tube.is_closed());
}

#[test]
fn a_reversed_face_is_found() {
    let mut faces = CUBE;
    faces[1] = &[7, 6, 5, 4];
    let cube = report(8, &faces);
    assert_eq!(cube.inconsistent_edges, [[4, 5], [4, 7], [5, 6], [6, 7]]);
    assert!(!cube.is_oriented() && cube.orientable);
}

/// Seven vertices: Möbius's triangulation of the torus.
#[test]
fn a_torus_has_one_handle() {
    let faces: Vec<[u32; 3]> = (0..7)
        .flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]])
        .collect();
    let faces: Vec<&[u32]> = faces.iter().map(|face| &face[..]).collect();
    let torus = report(7, &faces);
    assert_eq!((torus.edges, torus.euler_characteristic), (21, 0));
    assert_eq!(torus.genus, Some(1));
    assert!(torus.is_closed());
}

/// Five triangles on five vertices.
#[test]
fn a_moebius_strip_cannot_be_oriented() {
    let faces: Vec<[u32; 3]> = (0..5).map(|i| [i, (i + 1) % 5, (i + 2) % 5]).collect();
    let faces: Vec<&[u32]> = faces.iter().map(|face| &face[..]).collect();
    let strip = report(5, &faces);
    assert_eq!((strip.edges, strip.euler_characteristic), (10, 0));
    assert_eq!((strip.boundary_edges, strip.boundary_loops.len()), (5, 1));
    assert!(strip.is_manifold() && !strip.orientable && !strip.is_oriented());
    assert_eq!(strip.genus, None);
}

#[test]
fn irregular_elements_are_named() {
    // Three triangles at one edge, one of them twice, and a vertex without a face.
    let fin = report(
        6,
        &[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4], &[2, 0, 1], &[1, 1, 2]],
    );
    assert_eq!(fin.non_manifold_edges, [[0, 1], [1, 2]]);
    assert_eq!(fin.unreferenced_vertices, [5]);
    assert_eq!(fin.duplicate_faces, [3]);
    assert_eq!(fin.degenerate_faces, [4]);
    assert_eq!(fin.genus, None);

    // Two triangles that touch with their tips.
    let bow = report(5, &[&[0, 1, 2], &[0, 3, 4]]);
    assert_eq!(bow.non_manifold_vertices, [0]);
    assert_eq!(bow.boundary_loops.len(), 2);
    assert_eq!(bow.components, 1);

    let places = vec![[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [-0.0, 0.0, 0.0]];
    let faces = Faces::from_polygons([[0, 1, 2]]).unwrap();
    let flat = Report::of_mesh(&Mesh::new(places, faces).unwrap());
    assert_eq!(flat.duplicate_vertices, [3]);
    assert_eq!(flat.degenerate_faces, [0]);

    // Half of a square is half of a square, however small; points of a line are on it.
    for size in [1e-300, 1e-170, 1.0, 1e170, 1e300] {
        let places = vec![
            [0.0; 3],
            [size, 0.0, 0.0],
            [0.0, size, 0.0],
            [size, size, 0.0],
            [3.0 * size, 3.0 * size, 0.0],
        ];
        // The second face is a bow tie, the third has its corners on a diagonal.
        let faces: [&[u32]; 3] = [&[0, 1, 2], &[0, 1, 2, 3], &[0, 3, 4]];
        let faces = Faces::from_polygons(faces).unwrap();
        let report = Report::of_mesh(&Mesh::new(places, faces).unwrap());
        assert_eq!(report.degenerate_faces, [1, 2], "{size}");
    }

    let nothing = report(0, &[]);
    assert_eq!((nothing.components, nothing.euler_characteristic), (0, 0));
    assert!(!nothing.is_closed());
}

/// A square plate with a square hole: one face, whose outline runs along an edge to the hole and
/// back. It is a ring: two boundaries, no handle.
#[test]
fn a_face_with_a_keyhole_is_regular() {
    let text = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\n\
                f 1 2 3 4 1 5 6 7 8 5\n";
    let plate = Report::of_mesh(&obj::decode(text.as_bytes()).unwrap());
    assert_eq!(
        (&plate.keyhole_faces[..], plate.degenerate_faces.len()),
        (&[0][..], 0)
    );
    assert!(plate.is_manifold() && plate.is_oriented() && plate.orientable);
    assert_eq!((plate.edges, plate.euler_characteristic), (9, 0));
    assert_eq!((plate.boundary_edges, plate.genus), (8, Some(0)));
    assert_eq!(plate.boundary_loops, [[0, 1, 2, 3], [4, 5, 6, 7]]);

    // A plate with a thickness is a torus: a face with a keyhole above and one below, four walls
    // around and four in the hole.
    let top = vec![0, 1, 2, 3, 0, 4, 7, 6, 5, 4];
    let bottom = top.iter().rev().map(|vertex| vertex + 8).collect();
    let mut faces: Vec<Vec<u32>> = vec![top, bottom];
    for side in 0..4_u32 {
        let next = (side + 1) % 4;
        faces.push(vec![side, side + 8, next + 8, next]);
        faces.push(vec![side + 4, next + 4, next + 12, side + 12]);
    }
    let faces: Vec<&[u32]> = faces.iter().map(Vec::as_slice).collect();
    let torus = report(16, &faces);
    assert_eq!(torus.keyhole_faces, [0, 1]);
    assert!(torus.degenerate_faces.is_empty() && torus.non_manifold_vertices.is_empty());
    assert!(torus.is_closed() && torus.orientable);
    assert_eq!((torus.euler_characteristic, torus.genus), (0, Some(1)));
}

/// The numbers are those of the literature: the bunny has 34,834 vertices in use and five holes;
/// the cow is a sphere.
#[test]
fn real_meshes_have_their_known_topology() {
    let Some(path) = shared("data/anim/stanford-bunny.obj") else {
        return;
    };
    let bunny = Report::of_mesh(&obj::read(path).unwrap());
    assert_eq!(bunny.vertices - bunny.unreferenced_vertices.len(), 34_834);
    assert_eq!(bunny.euler_characteristic, 2 - 5);
    assert_eq!((bunny.boundary_loops.len(), bunny.components), (5, 1));
    assert_eq!(bunny.edges, (3 * 69_451 + bunny.boundary_edges) / 2);
    let Some(path) = shared("data/anim/spot.obj") else {
        return;
    };
    let spot = Report::of_mesh(&obj::read(path).unwrap());
    assert_eq!(spot.euler_characteristic, 2);
    assert!(spot.is_closed());
}
