//! Creases and corners beside formulas.

use ga_mesh::subdivision::{Boundary, CreaseMethod, Limit, Rules, Scheme, Tags};

use crate::shapes::{Shape, assert_close, corner, crease, cube, edges, grid, refine, umbrella};

const BOTH: [Rules; 2] = [Rules::LOOP, Rules::CATMULL_CLARK];

fn split(shape: &Shape, rules: Rules) -> Shape {
    match rules.scheme {
        Scheme::Loop => shape.triangulated(),
        Scheme::CatmullClark => shape.clone(),
    }
}

/// The closed uniform cubic B-spline curve of these control points at t; the basis functions are
/// those of de Boor in monomial form.
fn spline(control: &[[f64; 3]], t: f64) -> [f64; 3] {
    let (first, u) = (t.floor() as usize, t - t.floor());
    let v = 1.0 - u;
    let basis = [
        v * v * v / 6.0,
        (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
        (3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0,
        u * u * u / 6.0,
    ];
    let count = control.len();
    [0, 1, 2].map(|axis| {
        let term = |(place, weight): (usize, f64)| {
            weight * control[(first + count + place - 1) % count][axis]
        };
        basis.into_iter().enumerate().map(term).sum()
    })
}

/// Vertices along a closed curve, each followed by the one that refines its edge to the next.
fn finer(curve: &[u32], cage: &ga_mesh::subdivision::Cage) -> Vec<u32> {
    let mut fine = Vec::new();
    for (place, &vertex) in curve.iter().enumerate() {
        let next = curve[(place + 1) % curve.len()];
        let edge = cage.edges().between(vertex, next).unwrap();
        fine.extend([vertex, cage.vertex_count() as u32 + edge]);
    }
    fine
}

/// The limit of a closed chain of vertices is the B-spline curve of its control points.
fn assert_spline(shape: &Shape, rules: Rules, tags: &Tags, chain: &[u32]) {
    let control: Vec<_> = chain.iter().map(|&v| shape.positions[v as usize]).collect();
    let (mut cage, mut points) = (shape.cage(rules, tags), shape.positions.clone());
    let mut chain = chain.to_vec();
    for level in 0..4 {
        let limit = Limit::new(&cage)
            .unwrap()
            .positions
            .applied(&points)
            .unwrap();
        let step = 0.5_f64.powi(level);
        let found: Vec<_> = chain.iter().map(|&v| limit[v as usize]).collect();
        let expected: Vec<_> = (0..chain.len())
            .map(|place| spline(&control, place as f64 * step))
            .collect();
        assert_close(&found, &expected, 1e-13);
        let fine = cage.refine().unwrap();
        points = fine.stencils.applied(&points).unwrap();
        chain = finer(&chain, &cage);
        cage = fine.cage;
    }
}

#[test]
fn a_boundary_is_a_cubic_spline() {
    let shape = umbrella(7);
    for rules in BOTH {
        let chain: Vec<u32> = (7..14).collect();
        assert_spline(&split(&shape, rules), rules, &Tags::default(), &chain);
    }
}

#[test]
fn an_infinitely_sharp_crease_is_a_cubic_spline() {
    let shape = umbrella(7);
    for rules in BOTH {
        for sharpness in [10.0, f64::INFINITY] {
            let creases = (0..7).map(|side| crease(side, (side + 1) % 7, sharpness));
            let tags = Tags {
                creases: creases.collect(),
                ..Tags::default()
            };
            let chain: Vec<u32> = (0..7).collect();
            assert_spline(&split(&shape, rules), rules, &tags, &chain);
        }
    }
}

#[test]
fn a_cube_with_sharp_edges_stays_a_cube() {
    for rules in BOTH {
        let shape = split(&cube(), rules);
        let cube_edges = edges(&cube()).into_iter();
        let tags = Tags {
            creases: cube_edges
                .map(|[a, b]| crease(a, b, f64::INFINITY))
                .collect(),
            ..Tags::default()
        };
        let (_, points) = refine(&shape, rules, &tags, 3);
        for point in points {
            let far = point.iter().fold(0.0, |far: f64, x| far.max(x.abs()));
            assert!((far - 1.0).abs() < 1e-15, "{point:?} is not on the cube");
        }
    }
}

#[test]
fn sharp_corners_stay_and_their_edges_do_not() {
    for rules in BOTH {
        let shape = split(&cube(), rules);
        let tags = Tags {
            corners: vec![corner(3, f64::INFINITY), corner(4, 2.0)],
            ..Tags::default()
        };
        let (_, points) = refine(&shape, rules, &tags, 2);
        assert_eq!(
            [points[3], points[4]],
            [shape.positions[3], shape.positions[4]]
        );
        let (cage, points) = refine(&shape, rules, &tags, 3);
        assert_eq!(points[3], shape.positions[3]);
        assert!(points[4] != shape.positions[4]);
        assert_eq!(cage.corners(), [corner(3, f64::INFINITY)]);
    }
}

#[test]
fn a_whole_sharpness_is_that_many_sharp_levels() {
    for rules in BOTH {
        let shape = split(&cube(), rules);
        let tags = |sharpness| Tags {
            creases: [[0, 1], [1, 3], [3, 7], [7, 5]]
                .map(|[a, b]| crease(a, b, sharpness))
                .to_vec(),
            ..Tags::default()
        };
        let (cage, points) = refine(&shape, rules, &tags(2.0), 4);
        assert!(cage.creases().is_empty());
        let (cage, sharp) = refine(&shape, rules, &tags(f64::INFINITY), 2);
        let faces: Vec<&[u32]> = cage.faces().iter().collect();
        let (_, expected) = refine(&Shape::new(&sharp, &faces), rules, &Tags::default(), 2);
        assert_close(&points, &expected, 1e-15);
    }
}

#[test]
fn a_fraction_blends_the_sharp_and_the_smooth_rule() {
    for rules in BOTH {
        let shape = split(&umbrella(6), rules);
        let step = |sharpness| {
            let creases = (0..6).map(|side| crease(side, (side + 1) % 6, sharpness));
            let tags = Tags {
                creases: creases.collect(),
                ..Tags::default()
            };
            refine(&shape, rules, &tags, 1).1
        };
        let (smooth, sharp) = (step(0.0), step(1.0));
        let blend =
            |(a, b): (&[f64; 3], &[f64; 3])| [0, 1, 2].map(|axis| 0.3 * b[axis] + 0.7 * a[axis]);
        let expected: Vec<_> = smooth.iter().zip(&sharp).map(blend).collect();
        assert_close(&step(0.3), &expected, 1e-15);
    }
}

/// A row of quadrilaterals with creases along the middle line, sharpness from left to right.
fn sharpness_along(method: CreaseMethod, along: [f64; 4]) -> Vec<(u32, u32, f64)> {
    let rules = Rules {
        creases: method,
        ..Rules::CATMULL_CLARK
    };
    let shape = grid(4, 2);
    let creases = (5..9)
        .zip(along)
        .map(|(a, sharpness)| crease(a, a + 1, sharpness));
    let tags = Tags {
        creases: creases.collect(),
        ..Tags::default()
    };
    let fine = shape.cage(rules, &tags).refine().unwrap().cage;
    let creases = fine.creases().iter();
    creases
        .map(|crease| (crease.vertices[0], crease.vertices[1], crease.sharpness))
        .collect()
}

#[test]
fn chaikin_averages_the_sharpness_at_each_vertex() {
    let halves = |method, along| {
        let mut halves = Vec::new();
        for (end, _, sharpness) in sharpness_along(method, along) {
            halves.push((end, sharpness));
        }
        halves
    };
    // Vertices 5 to 9 of the middle line; each half has its old end. At vertex 6 the mean of
    // 3/4 · 3 + 1/4 · 2 and so on; the infinite edge has no part in it.
    let chaikin = [
        (5, 2.0),
        (6, 0.75 * 3.0 + 0.25 * 2.0 - 1.0),
        (6, 0.75 * 2.0 + 0.25 * 3.0 - 1.0),
        (7, 0.75 * 2.0 + 0.25 * 1.5 - 1.0),
        (7, 0.75 * 1.5 + 0.25 * 2.0 - 1.0),
        (8, 0.5),
        (8, f64::INFINITY),
        (9, f64::INFINITY),
    ];
    assert_eq!(
        halves(CreaseMethod::Chaikin, [3.0, 2.0, 1.5, f64::INFINITY]),
        chaikin
    );
    let normal = [
        (5, 2.0),
        (6, 2.0),
        (6, 1.0),
        (7, 1.0),
        (7, 0.5),
        (8, 0.5),
        (8, 10.0),
        (9, 10.0),
    ];
    assert_eq!(halves(CreaseMethod::Normal, [3.0, 2.0, 1.5, 10.0]), normal);
}

#[test]
fn equal_sharpness_falls_by_one_with_either_method() {
    let along = [2.5; 4];
    let [normal, chaikin] =
        [CreaseMethod::Normal, CreaseMethod::Chaikin].map(|method| sharpness_along(method, along));
    assert_eq!(normal, chaikin);
    assert_eq!(normal.len(), 8);
    assert!(normal.iter().all(|&(_, _, sharpness)| sharpness == 1.5));
}

#[test]
fn corners_of_a_boundary_are_kept_when_the_rules_say_so() {
    let shape = grid(2, 2);
    for rules in BOTH {
        let shape = split(&shape, rules);
        let (_, smooth) = refine(&shape, rules, &Tags::default(), 1);
        let rules = Rules {
            boundary: Boundary::EdgeAndCorner,
            ..rules
        };
        let (_, kept) = refine(&shape, rules, &Tags::default(), 1);
        let of_one_face =
            |&v: &u32| shape.faces.iter().filter(|face| face.contains(&v)).count() == 1;
        let corners: Vec<u32> = (0..9).filter(of_one_face).collect();
        assert_eq!(
            corners.len(),
            if rules.scheme == Scheme::Loop { 2 } else { 4 }
        );
        for v in 0..9 {
            let is_corner = corners.contains(&v);
            assert_eq!(kept[v as usize] == shape.positions[v as usize], is_corner);
            assert_eq!(kept[v as usize] == smooth[v as usize], !is_corner);
        }
    }
}

#[test]
fn regular_vertices_have_the_known_masks() {
    // A vertex of six triangles keeps 5/8 and takes 1/16 of each neighbour.
    let shape = grid(2, 2).triangulated();
    let stencils = shape
        .cage(Rules::LOOP, &Tags::default())
        .refine()
        .unwrap()
        .stencils;
    let (indices, weights) = stencils.row(4).unwrap();
    assert_eq!(indices, [4, 0, 1, 3, 5, 7, 8]);
    assert_eq!(
        weights,
        [0.625, 0.0625, 0.0625, 0.0625, 0.0625, 0.0625, 0.0625]
    );

    // A vertex of four quadrilaterals: the tensor product of 1/8, 6/8, 1/8 with itself.
    let shape = grid(2, 2);
    let stencils = shape
        .cage(Rules::CATMULL_CLARK, &Tags::default())
        .refine()
        .unwrap()
        .stencils;
    let (indices, weights) = stencils.row(4).unwrap();
    for (index, weight) in indices.iter().zip(weights) {
        let one = |place: u32| if place == 1 { 0.75 } else { 0.125 };
        assert_eq!(*weight, one(index % 3) * one(index / 3));
    }
    assert_eq!(indices.len(), 9);
}
