//! Limits beside what refinement tends to.

use ga_mesh::subdivision::{Boundary, Limit, Rules, Scheme, Tags};

use crate::shapes::{Shape, assert_close, corner, crease, cube, distance, grid, refine, umbrella};

fn split(shape: &Shape, rules: Rules) -> Shape {
    match rules.scheme {
        Scheme::Loop => shape.triangulated(),
        Scheme::CatmullClark => shape.clone(),
    }
}

/// Shapes with smooth vertices of valence 3 to 8, boundary vertices of one to three faces, and
/// faces that are not quadrilaterals.
fn shapes() -> Vec<Shape> {
    let mut shapes = vec![cube(), grid(3, 3), grid(1, 1)];
    shapes.extend((3..9).map(umbrella));
    shapes
}

/// Creases through the umbrella's apex, one of infinite sharpness, one side of which has one face.
fn creased(sides: u32) -> Tags {
    let apex = 2 * sides;
    Tags {
        creases: vec![
            crease(0, apex, f64::INFINITY),
            crease(sides / 2, apex, f64::INFINITY),
            crease(0, sides, f64::INFINITY),
            crease(sides / 2, sides + sides / 2, f64::INFINITY),
        ],
        corners: vec![corner(1, f64::INFINITY)],
    }
}

#[test]
fn limits_are_the_same_at_every_level() {
    for rules in [Rules::LOOP, Rules::CATMULL_CLARK] {
        for shape in shapes() {
            let shape = split(&shape, rules);
            let count = shape.positions.len();
            let at = |level| {
                let (cage, points) = refine(&shape, rules, &Tags::default(), level);
                let limit = Limit::new(&cage).unwrap();
                (
                    limit.positions.applied(&points).unwrap(),
                    limit.normals(&points).unwrap(),
                )
            };
            let (positions, normals) = at(0);
            for level in 1..4 {
                let (fine_positions, fine_normals) = at(level);
                assert_close(&fine_positions[..count], &positions, 1e-13);
                assert_close(&fine_normals[..count], &normals, 1e-9);
            }
        }
    }
}

#[test]
fn refinement_tends_to_the_limit() {
    for rules in [Rules::LOOP, Rules::CATMULL_CLARK] {
        for (shape, tags) in [
            (cube(), Tags::default()),
            (umbrella(5), creased(5)),
            (umbrella(8), creased(8)),
        ] {
            let shape = split(&shape, rules);
            let limit = Limit::new(&shape.cage(rules, &tags)).unwrap();
            let limit = limit.positions.applied(&shape.positions).unwrap();
            let (_, points) = refine(&shape, rules, &tags, 7);
            for (limit, point) in limit.iter().zip(&points) {
                assert!(distance(*limit, *point) < 1e-3);
            }
        }
    }
}

/// The largest distance of the unit normal of a face at an old vertex from the limit normal there,
/// after some levels.
fn normals_off(shape: &Shape, rules: Rules, level: usize) -> f64 {
    let normals = Limit::new(&shape.cage(rules, &Tags::default())).unwrap();
    let normals = normals.normals(&shape.positions).unwrap();
    let (cage, points) = refine(shape, rules, &Tags::default(), level);
    let mut off = 0.0_f64;
    for face in cage.faces() {
        let Some(&vertex) = face.iter().find(|&&v| (v as usize) < normals.len()) else {
            continue;
        };
        let [a, b, c] = [0, 1, face.len() - 1].map(|at| points[face[at] as usize]);
        let edge = |to: [f64; 3]| [0, 1, 2].map(|axis| to[axis] - a[axis]);
        let ([x, y, z], [u, v, w]) = (edge(b), edge(c));
        let cross = [y * w - z * v, z * u - x * w, x * v - y * u];
        let length = distance(cross, [0.0; 3]);
        off = off.max(distance(
            cross.map(|x| x / length),
            normals[vertex as usize],
        ));
    }
    off
}

#[test]
fn face_normals_tend_to_the_limit_normal() {
    for rules in [Rules::LOOP, Rules::CATMULL_CLARK] {
        for shape in shapes() {
            let shape = split(&shape, rules);
            let [early, late] = [3, 7].map(|level| normals_off(&shape, rules, level));
            // The error falls slowest at vertices of valence 8: by the ratio of two eigenvalues of
            // the ring, which is 0.82 a level for Catmull and Clark, 0.45 in four levels.
            assert!(
                late < 0.46 * early + 1e-9,
                "{rules:?}: {early}, then {late}"
            );
            assert!(late < 0.1, "{rules:?}: {late}");
        }
    }
}

#[test]
fn normals_of_a_plane_are_its_normal() {
    for rules in [Rules::LOOP, Rules::CATMULL_CLARK] {
        let kept = Rules {
            boundary: Boundary::EdgeAndCorner,
            ..rules
        };
        for (rules, tags) in [
            (rules, Tags::default()),
            (kept, Tags::default()),
            (rules, creased(6)),
        ] {
            let mut shape = umbrella(6);
            for point in &mut shape.positions {
                point[2] = 0.0;
            }
            let shape = split(&shape, rules);
            let limit = Limit::new(&shape.cage(rules, &tags)).unwrap();
            for normal in limit.normals(&shape.positions).unwrap() {
                assert!(distance(normal, [0.0, 0.0, 1.0]) < 1e-12, "{normal:?}");
            }
        }
    }
}

/// Loop: with β = 3/16 for valence 3, ω = 1/(3 + 2) = 1/5. Catmull and Clark: 9, 4, 1 parts of 24
/// (Halstead, Kass and DeRose).
#[test]
fn vertices_of_valence_three_have_the_published_masks() {
    let tetrahedron = Shape::new(
        &[[0.0; 3]; 4],
        &[[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]],
    );
    let limit = Limit::new(&tetrahedron.cage(Rules::LOOP, &Tags::default())).unwrap();
    for (found, expected) in limit
        .positions
        .row(0)
        .unwrap()
        .1
        .iter()
        .zip([0.4, 0.2, 0.2, 0.2])
    {
        assert!((found - expected).abs() < 1e-15);
    }
    let limit = Limit::new(&cube().cage(Rules::CATMULL_CLARK, &Tags::default())).unwrap();
    let (indices, weights) = limit.positions.row(0).unwrap();
    for (index, weight) in indices.iter().zip(weights) {
        // The number of bits is the number of edges from vertex 0.
        let expected = [9.0, 4.0, 1.0][index.count_ones() as usize] / 24.0;
        assert!((weight - expected).abs() < 1e-15);
    }
    assert_eq!(indices.len(), 7);
}

#[test]
fn degenerate_vertices_have_no_normal() {
    // Two triangles back to back, and a vertex without faces.
    let shape = Shape::new(
        &[
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [5.0, 5.0, 5.0],
        ],
        &[[0, 1, 2], [0, 2, 1]],
    );
    let limit = Limit::new(&shape.cage(Rules::LOOP, &Tags::default())).unwrap();
    assert_eq!(limit.normals(&shape.positions).unwrap(), [[0.0; 3]; 4]);
    assert_eq!(
        limit.positions.applied(&shape.positions).unwrap()[3],
        [5.0; 3]
    );
}
