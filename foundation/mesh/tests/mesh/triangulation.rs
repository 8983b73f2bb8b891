//! Polygons of any shape split into triangles, against their areas by the formula of Gauss and
//! against what a triangulation is.

use std::collections::HashMap;
use std::f64::consts::TAU;

use ga_mesh::topology::Report;
use ga_mesh::{Faces, Mesh, obj};
use ga_runtime::vga3::Vector;
use glam::{DQuat, DVec3};
use nullcone_shared_data::shared;
use proptest::prelude::*;

/// The area of a polygon in a plane, by the formula of Gauss.
fn area(polygon: &[[f64; 2]]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    let terms = polygon.iter().zip(next);
    0.5 * terms.map(|([a, b], [c, d])| a * d - c * b).sum::<f64>()
}

fn triangles_of(corners: &[[f64; 3]]) -> Vec<[u32; 3]> {
    let all: Vec<u32> = (0..corners.len() as u32).collect();
    Faces::from_polygons([all]).unwrap().triangles(corners)
}

/// Checks that each side of the polygon belongs to one triangle and each other edge to two, which
/// run along it in opposite directions, and that there are n − 2. Triangles with these properties
/// whose areas all have the sign of the polygon's cover it once.
fn check_edges(triangles: &[[u32; 3]], count: u32) {
    assert_eq!(triangles.len() as u32, count - 2);
    let mut edges: HashMap<[u32; 2], usize> = HashMap::new();
    for &[a, b, c] in triangles {
        for edge in [[a, b], [b, c], [c, a]] {
            *edges.entry(edge).or_default() += 1;
        }
    }
    for (&[a, b], &uses) in &edges {
        assert_eq!(uses, 1, "{a} {b}");
        let is_side = b == (a + 1) % count;
        assert_eq!(edges.contains_key(&[b, a]), !is_side, "{a} {b}");
    }
}

/// Checks the triangles of a polygon that does not cross itself, turned in space.
fn check(polygon: &[[f64; 2]], turn: [f64; 3], shift: [f64; 3]) {
    let rotation = DQuat::from_scaled_axis(turn.into());
    let place = |&[x, y]: &[f64; 2]| rotation * DVec3::new(x, y, 0.0) + DVec3::from(shift);
    let corners: Vec<[f64; 3]> = polygon.iter().map(|p| place(p).to_array()).collect();
    let triangles = triangles_of(&corners);
    check_edges(&triangles, polygon.len() as u32);
    let whole = area(polygon);
    let of_all = triangles.iter().map(|triangle| {
        let [a, b, c] = triangle.map(|corner| polygon[corner as usize]);
        let one = area(&[a, b, c]) * whole.signum();
        assert!(
            one > -1e-12 * whole.abs(),
            "a triangle is turned over: {one:e}"
        );
        one
    });
    let sum: f64 = of_all.sum();
    assert!(
        (sum - whole.abs()).abs() <= 1e-9 * whole.abs(),
        "{sum} instead of {whole}"
    );
}

fn vector() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-3.0..3.0_f64)
}

/// In polar coordinates with angles that rise by less than 180°, so that no sides cross.
fn star() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let corners = prop::collection::vec((0.05..1.0_f64, 0.1..1.0_f64), 4..80);
    let is_around = |corners: &Vec<(f64, f64)>| {
        let steps = corners.iter().map(|(_, step)| *step);
        steps.clone().fold(0.0, f64::max) < 0.49 * steps.sum::<f64>()
    };
    corners
        .prop_filter("the centre inside", is_around)
        .prop_map(|corners| {
            let turn: f64 = corners.iter().map(|(_, step)| step).sum();
            let mut angle = 0.0;
            let place = |(radius, step): (f64, f64)| {
                angle += step * TAU / turn;
                [radius * angle.cos(), radius * angle.sin()]
            };
            corners.into_iter().map(place).collect()
        })
}

/// Between two chains that rise in x, with corners on whole numbers, many on straight lines.
fn monotone() -> impl Strategy<Value = Vec<[f64; 2]>> {
    let heights = |range| prop::collection::vec(range, 1..30);
    (heights(0..4_i32), heights(-4..0_i32)).prop_map(|(above, below)| {
        let width = above.len().max(below.len()) + 1;
        let chain = |heights: Vec<i32>| -> Vec<[f64; 2]> {
            let places = heights.iter().enumerate();
            places
                .map(|(x, &y)| [(x + 1) as f64, f64::from(y)])
                .collect()
        };
        let (above, below) = (chain(above), chain(below));
        let mut polygon = vec![[0.0, -0.5]];
        polygon.extend(below);
        polygon.push([width as f64, -0.5]);
        polygon.extend(above.into_iter().rev());
        polygon
    })
}

/// A comb of stairs with holes, each reached by a bridge from the base, which runs along the side
/// of the hole where `is_straight`.
fn with_holes(holes: &[(f64, f64)], is_straight: bool) -> Vec<[f64; 2]> {
    let mut polygon = vec![[0.0, 0.0]];
    for (number, &(size, height)) in holes.iter().enumerate() {
        let x = 2.0 * number as f64 + if is_straight { 0.5 } else { 0.25 };
        let [left, low] = [2.0 * number as f64 + 0.5, 0.5];
        let (right, high) = (left + size, low + height);
        let base = [x, 0.0];
        polygon.extend([base, [left, low], [left, high], [right, high], [right, low]]);
        polygon.extend([[left, low], base]);
    }
    let width = 2.0 * holes.len() as f64;
    polygon.extend([[width, 0.0], [width, 3.0], [0.0, 3.0]]);
    polygon
}

proptest! {
    #[test]
    fn stars_are_covered(polygon in star(), turn in vector(), shift in vector()) {
        check(&polygon, turn, shift);
        check(&polygon.into_iter().rev().collect::<Vec<_>>(), turn, shift);
    }

    #[test]
    fn chains_are_covered(polygon in monotone(), turn in vector(), start in 0..60_usize) {
        let mut polygon = polygon;
        let start = start % polygon.len();
        polygon.rotate_left(start);
        check(&polygon, turn, [0.0; 3]);
        // In the plane z = 0 the corners on straight lines are there without an error.
        let flat: Vec<[f64; 3]> = polygon.iter().map(|&[x, y]| [x, y, 0.0]).collect();
        let triangles = triangles_of(&flat);
        check_edges(&triangles, polygon.len() as u32);
        for triangle in triangles {
            prop_assert!(area(&triangle.map(|corner| polygon[corner as usize])) >= 0.0);
        }
    }

    #[test]
    fn bridges_to_holes_are_allowed(
        holes in prop::collection::vec((0.1..1.2_f64, 0.1..2.0_f64), 1..8),
        is_straight: bool,
        turn in vector(),
        start in 0..60_usize,
    ) {
        let mut polygon = with_holes(&holes, is_straight);
        let holes: f64 = holes.iter().map(|(width, height)| width * height).sum();
        let width = polygon[polygon.len() - 2][0];
        prop_assert!((area(&polygon) - (3.0 * width - holes)).abs() < 1e-12 * width);
        let start = start % polygon.len();
        polygon.rotate_left(start);
        check(&polygon, turn, [0.0; 3]);
    }

    /// Polygons that cross themselves, with corners at one place and on one line.
    #[test]
    fn no_polygon_is_too_odd(
        corners in prop::collection::vec(prop::array::uniform3(0..3_i8), 3..16),
        size in prop::sample::select(vec![1.0, 1e-300, 1e300, 5e-324, f64::MAX / 2.0]),
    ) {
        let corners: Vec<[f64; 3]> = corners
            .into_iter()
            .map(|corner| corner.map(|x| f64::from(x - 1) * size))
            .collect();
        check_edges(&triangles_of(&corners), corners.len() as u32);
    }
}

#[test]
fn quadrilaterals_have_the_diagonal_inside() {
    let arrow = [[0.0, 0.0], [2.0, 1.0], [0.0, 2.0], [0.5, 1.0]];
    for start in 0..4 {
        let mut polygon = arrow;
        polygon.rotate_left(start);
        check(&polygon, [0.0; 3], [0.0; 3]);
    }
    // With three corners on a line the other diagonal gives no triangle without an area.
    let line = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
    ];
    assert_eq!(triangles_of(&line), [[0, 1, 3], [1, 2, 3]]);
    let square = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
    ];
    assert_eq!(triangles_of(&square), [[0, 1, 2], [0, 2, 3]]);
}

/// What all triangles of a mesh are together.
fn surface(mesh: &Mesh) -> f64 {
    let at = |vertex: u32| Vector::from(mesh.positions()[vertex as usize]);
    let triangles = mesh.triangles();
    let areas = triangles.iter().map(|triangle| {
        let [a, b, c] = triangle.map(at);
        0.5 * (b - a).cross(c - a).length()
    });
    areas.sum()
}

/// An L, an arrow head, a square with a square hole behind a bridge, a square that is bent.
#[test]
fn concave_and_bent_faces_are_counted() {
    let l = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n";
    let arrow = "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 0.5 1 0\nf 4 1 2 3\n";
    let hole = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\n\
        f 1 2 3 4 1 5 6 7 8 5\n";
    let bent = "v 0 0 0\nv 1 0 1\nv 1 1 0\nv 0 1 1\nf 1 2 3 4\n";
    let (half, slant) = (1.5_f64, 3.0_f64.sqrt() / 2.0);
    for (text, expected, counts) in [
        (l, 3.0, [1, 0]),
        (arrow, half, [1, 0]),
        (hole, 12.0, [1, 0]),
        (bent, 2.0 * slant, [0, 1]),
    ] {
        let mesh = obj::decode(text.as_bytes()).unwrap();
        assert!((surface(&mesh) - expected).abs() < 1e-12, "{text}");
        let report = Report::of_mesh(&mesh);
        let found = [report.concave_faces.len(), report.non_planar_faces.len()];
        assert_eq!(found, counts, "{text}");
    }
}

/// A star, a polygon of 2000 corners, and a square with a hole, which programs have split wrongly.
#[test]
fn polygons_of_other_programs_have_their_areas() {
    for (name, expected) in [
        ("23_star", 3.527),
        ("25_big_polygon", 3.282),
        ("27_hole_keyhole", 12.0),
    ] {
        let Some(path) = shared(&format!("cases/motion/concave-polygons/{name}.obj")) else {
            return;
        };
        let mesh = obj::read(path).unwrap();
        let polygon: Vec<[f64; 2]> = mesh
            .faces()
            .corners()
            .iter()
            .map(|&corner| mesh.positions()[corner as usize].coordinates())
            .map(|[x, y, _]| [x, y])
            .collect();
        let exact = area(&polygon).abs();
        assert!((exact - expected).abs() < 1e-3, "{name}: {exact}");
        assert!((surface(&mesh) - exact).abs() < 1e-9 * exact, "{name}");
    }
}
