//! Normals against those of a sphere.

use ga_mesh::normals::vertex_normals;
use ga_runtime::vga3::Vector;

/// A band of a sphere between two circles of latitude, and the vertices that are not on its
/// boundary.
fn band(
    radius: f64,
    centre: Vector<f64>,
) -> (Vec<[f64; 3]>, Vec<[u32; 3]>, std::ops::Range<usize>) {
    let (rings, sides) = (47u32, 96u32);
    let mut positions = Vec::new();
    for ring in 1..=rings {
        let polar = std::f64::consts::PI * f64::from(ring) / f64::from(rings + 1);
        for side in 0..sides {
            let around = std::f64::consts::TAU * f64::from(side) / f64::from(sides);
            let (sine, cosine) = polar.sin_cos();
            let outward = Vector::new(sine * around.sin(), cosine, sine * around.cos());
            positions.push((centre + outward * radius).coordinates());
        }
    }
    let mut triangles = Vec::new();
    for ring in 1..rings {
        for side in 0..sides {
            let at = |ring: u32, side: u32| (ring - 1) * sides + side % sides;
            let [a, b] = [at(ring, side), at(ring, side + 1)];
            let [c, d] = [at(ring + 1, side), at(ring + 1, side + 1)];
            triangles.extend([[a, c, d], [a, d, b]]);
        }
    }
    let inner = sides as usize..positions.len() - sides as usize;
    (positions, triangles, inner)
}

#[test]
fn normals_of_a_sphere_point_away_from_its_centre() {
    let centre = Vector::new(3.0, -2.0, 1.0);
    let (positions, triangles, inner) = band(0.25, centre);
    let normals = vertex_normals(&positions, &triangles);
    for vertex in inner {
        let outward = (Vector::from(positions[vertex]) - centre) * 4.0;
        let cosine = outward.dot(normals[vertex].into());
        assert!(cosine > 0.9999, "{:?} {outward:?}", normals[vertex]);
    }
}

#[test]
fn a_vertex_without_a_triangle_has_no_normal() {
    assert_eq!(vertex_normals(&[[1.0; 3]], &[]), [[0.0; 3]]);
    let flat = [[0.0; 3], [1.0, 1.0, 1.0], [2.0, 2.0, 2.0]];
    assert_eq!(vertex_normals(&flat, &[[0, 1, 2]]), [[0.0; 3]; 3]);
}
