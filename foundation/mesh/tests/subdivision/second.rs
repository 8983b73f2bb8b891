//! Every rule at random, beside the implementation in [`crate::dense`].

use ga_mesh::subdivision::{Boundary, CreaseMethod, Rules, Scheme, Tags};
use proptest::prelude::*;

use crate::dense::Dense;
use crate::shapes::{Shape, assert_close, corner, crease, cube, edges, grid, umbrella};

/// Shapes with valences from 2 to 9, with and without boundaries.
fn shape() -> impl Strategy<Value = Shape> {
    prop_oneof![
        Just(cube()),
        (1_u32..4, 1_u32..4).prop_map(|(columns, rows)| grid(columns, rows)),
        (3_u32..9).prop_map(umbrella),
    ]
}

fn sharpness() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => Just(0.0),
        2 => 0.0..1.0,
        3 => 0.0..4.0,
        1 => Just(1.0),
        1 => Just(2.0),
        1 => Just(9.5),
        1 => Just(10.0),
        1 => Just(f64::INFINITY),
    ]
}

pub(crate) fn rules() -> impl Strategy<Value = Rules> {
    let schemes = prop_oneof![Just(Scheme::Loop), Just(Scheme::CatmullClark)];
    let boundaries = prop_oneof![Just(Boundary::EdgeOnly), Just(Boundary::EdgeAndCorner)];
    let methods = prop_oneof![Just(CreaseMethod::Normal), Just(CreaseMethod::Chaikin)];
    (schemes, boundaries, methods).prop_map(|(scheme, boundary, creases)| Rules {
        boundary,
        creases,
        ..Rules::new(scheme)
    })
}

/// A shape that the rules can refine, with random sharpness everywhere.
pub(crate) fn case() -> impl Strategy<Value = (Shape, Rules, Tags)> {
    (shape(), rules())
        .prop_map(|(shape, rules)| match rules.scheme {
            Scheme::Loop => (shape.triangulated(), rules),
            Scheme::CatmullClark => (shape, rules),
        })
        .prop_flat_map(|(shape, rules)| {
            let edges = edges(&shape);
            let creases = proptest::collection::vec(sharpness(), edges.len());
            let corners = proptest::collection::vec(sharpness(), shape.positions.len());
            let few = (creases, corners, 0..4_usize);
            few.prop_map(move |(creases, corners, keep)| {
                let creases = edges.iter().zip(creases);
                let corners = (0..).zip(corners);
                let tags = Tags {
                    creases: creases.map(|(&[a, b], s)| crease(b, a, s)).collect(),
                    corners: corners
                        .filter(|(vertex, _)| *vertex as usize % 4 < keep)
                        .map(|(vertex, s)| corner(vertex, s))
                        .collect(),
                };
                (shape.clone(), rules, tags)
            })
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn a_second_implementation_agrees((shape, rules, tags) in case()) {
        let mut dense = Dense::new(&shape, rules, &tags);
        let (mut cage, mut points) = (shape.cage(rules, &tags), shape.positions.clone());
        for _ in 0..3 {
            dense = dense.refined();
            let fine = cage.refine().unwrap();
            points = fine.stencils.applied(&points).unwrap();
            cage = fine.cage;
            assert_close(&points, &dense.points, 1e-13);
            prop_assert!(cage.faces().iter().eq(dense.faces.iter().map(Vec::as_slice)));
        }
    }
}
