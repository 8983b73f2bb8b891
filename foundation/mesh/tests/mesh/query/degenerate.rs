//! Meshes without triangles, with bad ones, and with many at one place.

use ga_mesh::MeshError;
use ga_mesh::query::{Bvh, QueryError};
use ga_runtime::cga3::Point;
use ga_runtime::geometry::ray::Ray;

#[test]
fn without_triangles_there_is_nothing_to_find() {
    for positions in [vec![], vec![[0.0; 3], [f64::NAN; 3]]] {
        let bvh = Bvh::new(&positions, &[]).unwrap();
        assert_eq!((bvh.triangle_count(), bvh.bounds()), (0, None));
        assert_eq!(bvh.nearest(Point::default()), Err(QueryError::NoTriangles));
        assert_eq!(bvh.nearest_within(Point::default(), 1.0), Ok(None));
        let ray = Ray::new(Point::default(), [1.0, 0.0, 0.0]).unwrap();
        assert_eq!(bvh.first_hit(ray), None);
        assert!(!bvh.is_hit(ray, f64::INFINITY) && bvh.all_hits(ray).is_empty());
    }
}

#[test]
fn bad_corners_are_named() {
    let positions = [[0.0; 3], [1.0; 3], [0.0, f64::INFINITY, 0.0]];
    let error = Bvh::new(&positions, &[[0, 1, 0], [0, 1, 3]]).unwrap_err();
    let expected = MeshError::IndexOutOfRange {
        face: 1,
        index: 3,
        vertices: 3,
    };
    assert_eq!(error, expected);
    let error = Bvh::new(&positions, &[[0, 1, 2]]).unwrap_err();
    let expected = MeshError::NotFinite {
        vertex: 2,
        coordinates: positions[2],
    };
    assert_eq!(error, expected);
    // A vertex that no triangle uses does no harm.
    assert!(Bvh::new(&positions, &[[0, 1, 0]]).is_ok());
}

/// The depth of the tree is bounded although nothing tells the triangles apart.
#[test]
fn many_triangles_at_one_place_are_found() {
    let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let bvh = Bvh::new(&positions, &vec![[0, 1, 2]; 5000]).unwrap();
    let nearest = bvh.nearest(Point::new(0.25, 0.25, 2.0)).unwrap();
    assert_eq!((nearest.triangle, nearest.distance), (0, 2.0));
    let ray = Ray::new(Point::new(0.25, 0.25, 2.0), [0.0, 0.0, -1.0]).unwrap();
    assert_eq!(bvh.first_hit(ray).unwrap().triangle, 0);
    let all: Vec<u32> = bvh.all_hits(ray).iter().map(|hit| hit.triangle).collect();
    assert_eq!(all, (0..5000).collect::<Vec<_>>());

    // Each triangle is ten times the size of the one before.
    let positions: Vec<[f64; 3]> = (-60..60)
        .flat_map(|exponent| {
            let size = 10_f64.powi(exponent);
            [[size, 0.0, 0.0], [2.0 * size, 0.0, 0.0], [size, size, 0.0]]
        })
        .collect();
    let triangles: Vec<[u32; 3]> = (0..120).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let bvh = Bvh::new(&positions, &triangles).unwrap();
    for (triangle, corners) in (0..).zip(&triangles) {
        let [x, y, _] = positions[corners[1] as usize];
        let nearest = bvh.nearest(Point::new(x, y, 0.0)).unwrap();
        assert_eq!((nearest.triangle, nearest.distance), (triangle, 0.0));
    }
}

#[test]
fn degenerate_triangles_are_segments_for_distances_and_missed_by_rays() {
    let positions = [
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [5.0, 5.0, 5.0],
    ];
    let bvh = Bvh::new(&positions, &[[0, 1, 2], [3, 3, 3]]).unwrap();
    let nearest = bvh.nearest(Point::new(0.5, 3.0, 0.0)).unwrap();
    assert_eq!(
        (nearest.point, nearest.distance),
        (Point::new(0.5, 0.0, 0.0), 3.0)
    );
    let nearest = bvh.nearest(Point::new(5.0, 5.0, 9.0)).unwrap();
    assert_eq!((nearest.triangle, nearest.distance), (1, 4.0));
    for [x, y, z] in positions {
        let ray = Ray::new(Point::new(x, y, z + 1.0), [0.0, 0.0, -1.0]).unwrap();
        assert_eq!(bvh.first_hit(ray), None);
    }
}
