//! Distances along surfaces, against closed forms.

use std::f64::consts::PI;

use ga_mesh::MeshError;
use ga_mesh::geodesic::{Source, distances};

const ALL: f64 = f64::INFINITY;

/// A grid of squares in two triangles each, with corners (x, y) for whole numbers.
fn grid(width: u32, height: u32) -> (Vec<[f64; 2]>, Vec<[u32; 3]>) {
    let columns = width + 1;
    let places = (0..columns * (height + 1)).map(|k| [k % columns, k / columns].map(f64::from));
    let squares = (0..width * height).map(|k| k % width + k / width * columns);
    let triangles = squares.flat_map(|k| {
        let [a, b, c, d] = [k, k + 1, k + columns, k + columns + 1];
        [[a, b, d], [a, d, c]]
    });
    (places.collect(), triangles.collect())
}

#[test]
fn distances_in_a_plane_are_exact() {
    let (places, triangles) = grid(12, 9);
    let flat: Vec<_> = places.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    for source in [0, 5, 64, 129] {
        let found = distances(&flat, &triangles, &[source.into()], ALL).unwrap();
        let [u, v] = places[source as usize];
        for (found, [x, y]) in found.iter().zip(&places) {
            let expected = (x - u).hypot(y - v);
            assert!(
                (found - expected).abs() < 1e-12,
                "{source}: {found} {expected}"
            );
        }
    }
}

/// A bent sheet has the distances of the flat one, but for the length of its chords.
#[test]
fn a_sheet_that_is_rolled_up_keeps_its_distances() {
    let (places, triangles) = grid(40, 20);
    let angle = 0.5 * PI / 40.0;
    // Chords of the circle that are as long as the squares.
    let radius = 0.5 / (0.5 * angle).sin();
    let rolled: Vec<_> = places
        .iter()
        .map(|&[x, y]| [radius * (angle * x).sin(), y, radius * (angle * x).cos()])
        .collect();
    let found = distances(&rolled, &triangles, &[0.into()], ALL).unwrap();
    for (found, [x, y]) in found.iter().zip(&places) {
        assert!((found - x.hypot(*y)).abs() < 1e-9, "{found} {x} {y}");
    }
}

#[test]
fn distances_on_a_sphere_are_arcs() {
    let (columns, rows) = (96, 48);
    let (grid_places, triangles) = grid(columns, rows);
    // The seam and the poles are left open: the source is on the other side.
    let direction = |&[x, y]: &[f64; 2]| {
        let (longitude, latitude) = (
            2.0 * PI * x / f64::from(columns),
            PI * (0.06 + 0.88 * y / f64::from(rows)) - 0.5 * PI,
        );
        let [c, s] = [latitude.cos(), latitude.sin()];
        [c * longitude.cos(), c * longitude.sin(), s]
    };
    let places: Vec<_> = grid_places.iter().map(direction).collect();
    let source = 24 * (columns + 1) + 48;
    let found = distances(&places, &triangles, &[source.into()], 1.2).unwrap();
    let from = places[source as usize];
    let mut compared = 0;
    for (found, place) in found.iter().zip(&places) {
        let cosine: f64 = (0..3).map(|k| from[k] * place[k]).sum();
        let arc = cosine.clamp(-1.0, 1.0).acos();
        if found.is_finite() {
            assert!((found - arc).abs() < 0.01 * arc + 1e-12, "{found} {arc}");
            compared += 1;
        } else {
            assert!(arc > 1.18, "{arc}");
        }
    }
    assert!(compared > 1000, "{compared}");
}

#[test]
fn several_sources_and_parts() {
    let (places, triangles) = grid(10, 1);
    let mut flat: Vec<_> = places.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    // A vertex without a triangle.
    flat.push([5.0, 5.0, 0.0]);
    let sources = [
        Source::from(0),
        Source {
            vertex: 10,
            distance: 0.25,
            place: 10,
        },
    ];
    let found = distances(&flat, &triangles, &sources, ALL).unwrap();
    for (k, &[x, _, _]) in flat[..11].iter().enumerate() {
        assert!(
            (found[k] - x.min(10.25 - x)).abs() < 1e-12,
            "{k}: {found:?}"
        );
    }
    assert!(found[22].is_infinite());
    let near = distances(&flat, &triangles, &sources[..1], 3.0).unwrap();
    let expected = |k: &usize| flat[*k][0].hypot(flat[*k][1]) <= 3.0;
    assert!(
        (0..22).all(|k| near[k].is_finite() == expected(&k)),
        "{near:?}"
    );
}

/// A front from a whole side of a sheet stays straight.
#[test]
fn a_straight_front() {
    let (places, triangles) = grid(9, 12);
    let flat: Vec<_> = places.iter().map(|&[x, y]| [x, y, 0.0]).collect();
    let side: Vec<_> = (0..10).map(Source::from).collect();
    let found = distances(&flat, &triangles, &side, ALL).unwrap();
    for (found, [_, y]) in found.iter().zip(&places) {
        assert!((found - y).abs() < 1e-12, "{found} {y}");
    }
    // Vertices near to one place: the corners of the triangle that it is in.
    let place = [4.5, 6.25];
    let near = [64, 65, 75].map(|vertex| Source {
        vertex,
        distance: (0..2)
            .map(|k| (places[vertex as usize][k] - place[k]).powi(2))
            .sum::<f64>()
            .sqrt(),
        place: 7,
    });
    let found = distances(&flat, &triangles, &near, ALL).unwrap();
    for (found, [x, y]) in found.iter().zip(&places) {
        let expected = (x - place[0]).hypot(y - place[1]);
        // Near the place the front is curved, and a corner may be reached along an edge first.
        assert!(found - expected >= -1e-12, "{found} {expected}");
        assert!(found - expected <= 0.03 * expected, "{found} {expected}");
    }
}

#[test]
fn data_that_are_no_mesh_are_refused() {
    let places = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    assert!(matches!(
        distances(&places, &[[0, 1, 3]], &[0.into()], ALL),
        Err(MeshError::IndexOutOfRange {
            face: 0,
            index: 3,
            vertices: 3
        })
    ));
    let mut wrong = places;
    wrong[1][2] = f64::NAN;
    assert!(matches!(
        distances(&wrong, &[[0, 1, 2]], &[0.into()], ALL),
        Err(MeshError::NotFinite { vertex: 1, .. })
    ));
    assert_eq!(
        distances(&places, &[[0, 1, 2]], &[0.into(), 3.into()], ALL),
        Err(MeshError::PointOutOfRange {
            point: 1,
            index: 3,
            vertices: 3
        })
    );
    // Triangles without area do no harm.
    let found = distances(&places, &[[0, 1, 2], [1, 1, 2]], &[0.into()], ALL).unwrap();
    assert_eq!(found, [0.0, 1.0, 1.0]);
}
