//! Texture coordinates and their seams.

use ga_mesh::subdivision::{Cage, CornerValues, Rules, Tags, TextureRule};
use ga_mesh::{Faces, MeshError};

use crate::shapes::{Shape, cube, grid};

const TEXTURE_RULES: [TextureRule; 3] = [
    TextureRule::LinearAll,
    TextureRule::LinearBoundaries,
    TextureRule::LinearCorners,
];

/// The values at the corners after some levels.
fn refined(
    shape: &Shape,
    rules: Rules,
    corners: &[Option<u32>],
    values: &[[f64; 2]],
    levels: usize,
) -> (Cage, Vec<Option<[f64; 2]>>) {
    let mut cage = shape.cage(rules, &Tags::default());
    let mut level = CornerValues::new(&cage, corners).unwrap().unwrap();
    let mut points: Vec<_> = level
        .sources()
        .iter()
        .map(|&at| values[at as usize])
        .collect();
    for _ in 0..levels {
        let (fine, stencils) = level.refine().unwrap();
        points = stencils.applied(&points).unwrap();
        level = fine;
        cage = cage.refine().unwrap().cage;
    }
    let corners = level.corners().into_iter();
    let at_corners = corners
        .map(|value| value.map(|value| points[value as usize]))
        .collect();
    (cage, at_corners)
}

/// A square of quadrilaterals, as a chart of its own shape.
fn square() -> (Shape, Vec<Option<u32>>, Vec<[f64; 2]>) {
    let shape = grid(3, 3);
    let corners = shape.faces.concat().into_iter().map(Some).collect();
    let values = (0..16)
        .map(|v| [f64::from(v % 4), f64::from(v / 4)])
        .collect();
    (shape, corners, values)
}

#[test]
fn values_without_seams_move_like_positions() {
    let (shape, corners, _) = square();
    let rules = Rules {
        texture: TextureRule::LinearCorners,
        ..Rules::CATMULL_CLARK
    };
    let rules = Rules {
        boundary: ga_mesh::subdivision::Boundary::EdgeAndCorner,
        ..rules
    };
    let values: Vec<_> = shape.positions.iter().map(|&[x, y, _]| [x, y]).collect();
    let (cage, found) = refined(&shape, rules, &corners, &values, 2);
    let (_, points) = crate::shapes::refine(&shape, rules, &Tags::default(), 2);
    for (&vertex, found) in cage.faces().corners().iter().zip(found) {
        let [x, y, _] = points[vertex as usize];
        let [u, v] = found.unwrap();
        assert!((u - x).abs() < 1e-14 && (v - y).abs() < 1e-14);
    }
}

/// Rules that keep the boundary of a chart keep a chart that is a plain square in it, whatever they
/// do inside.
#[test]
fn charts_keep_their_outline() {
    let (shape, corners, values) = square();
    for texture in [TextureRule::LinearAll, TextureRule::LinearBoundaries] {
        let rules = Rules {
            texture,
            ..Rules::CATMULL_CLARK
        };
        let (cage, found) = refined(&shape, rules, &corners, &values, 2);
        let edges = cage.edges();
        for (corner, found) in found.iter().enumerate() {
            let [u, v] = found.unwrap();
            assert!((0.0..=3.0).contains(&u) && (0.0..=3.0).contains(&v));
            if edges.is_boundary(edges.of_corners()[corner]) {
                let on_outline = [u, v].iter().any(|x| *x == 0.0 || *x == 3.0);
                assert!(on_outline, "({u}, {v}) has left the outline");
            }
        }
        assert!(found.contains(&Some([3.0, 3.0])));
    }
}

#[test]
fn linear_values_are_linear_on_each_face() {
    let shape = cube();
    // Every face is a chart of its own: the unit square, moved to the right.
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let chart = |face: u32| square.map(|[u, v]| [u + 2.0 * f64::from(face), v]);
    let values: Vec<_> = (0..6).flat_map(chart).collect();
    let corners: Vec<_> = (0..24).map(Some).collect();
    for texture in [TextureRule::LinearAll, TextureRule::LinearBoundaries] {
        let rules = Rules {
            texture,
            ..Rules::CATMULL_CLARK
        };
        let (_, found) = refined(&shape, rules, &corners, &values, 1);
        // Each old corner becomes a quadrilateral with the corner, the next side's middle, the
        // centre and the last side's middle.
        let mut expected = Vec::new();
        for face in 0..6 {
            let chart = chart(face);
            for at in 0..4 {
                let middle = |a: usize, b: usize| {
                    [0, 1].map(|axis| (chart[a % 4][axis] + chart[b % 4][axis]) / 2.0)
                };
                expected.extend([
                    chart[at],
                    middle(at, at + 1),
                    middle(0, 2),
                    middle(at, at + 3),
                ]);
            }
        }
        assert!(found.into_iter().map(Option::unwrap).eq(expected));
    }
}

#[test]
fn seams_stay_seams_and_nothing_else_becomes_one() {
    let (shape, _, _) = square();
    // Two charts: the faces of the left column, and the rest.
    let columns = (0..9).map(|face| u32::from(face % 3 > 0));
    let corners: Vec<_> = columns
        .zip(&shape.faces)
        .flat_map(|(chart, face)| face.iter().map(move |&v| Some(v + 16 * chart)))
        .collect();
    let values: Vec<_> = (0..32)
        .map(|at| [f64::from(at % 4), f64::from(at / 4)])
        .collect();
    for texture in TEXTURE_RULES {
        let rules = Rules {
            texture,
            ..Rules::CATMULL_CLARK
        };
        let (cage, found) = refined(&shape, rules, &corners, &values, 2);
        let edges = cage.edges();
        let mut seams = 0;
        for edge in 0..edges.len() as u32 {
            let &[one, other] = edges.sides(edge) else {
                continue;
            };
            let differ = found[one as usize].unwrap()[1] > 3.5
                && found[other as usize].unwrap()[1] < 3.5
                || found[one as usize].unwrap()[1] < 3.5 && found[other as usize].unwrap()[1] > 3.5;
            seams += usize::from(differ);
        }
        assert_eq!(seams, 3 * 4);
    }
}

#[test]
fn faces_without_values_stay_without() {
    let faces = Faces::from_polygons([[0, 1, 2], [2, 1, 3]]).unwrap();
    let cage = Cage::new(faces, 4, Rules::LOOP).unwrap();
    let corners = [Some(0), Some(1), Some(2), Some(2), None, Some(3)];
    let values = CornerValues::new(&cage, &corners).unwrap().unwrap();
    let (fine, _) = values.refine().unwrap();
    let fine = fine.corners();
    assert!(fine[..12].iter().all(Option::is_some));
    assert_eq!(fine[12..], [None; 12]);
    assert!(CornerValues::new(&cage, &[None; 6]).unwrap().is_none());
    let error = CornerValues::new(&cage, &corners[..5]).unwrap_err();
    let expected = MeshError::Length {
        what: "values",
        expected: 6,
        found: 5,
    };
    assert_eq!(error, expected);
}

/// A seam that ends inside: its last vertex has one value, which all faces there share.
#[test]
fn a_seam_may_end_inside() {
    let shape = grid(2, 2);
    // The side from vertex 1 to vertex 4 is a seam: vertex 1 has another value in the right face.
    let mut corners: Vec<_> = shape.faces.concat().into_iter().map(Some).collect();
    let place = 4 + shape.faces[1].iter().position(|&v| v == 1).unwrap();
    corners[place] = Some(9);
    let cage = shape.cage(Rules::CATMULL_CLARK, &Tags::default());
    let values = CornerValues::new(&cage, &corners).unwrap().unwrap();
    let mut sources = values.sources().to_vec();
    sources.sort_unstable();
    assert!(sources.into_iter().eq(0..10));
}
