//! Outermorphisms against the dense reference and determinants of minors.

use ga_runtime::cga3::{Bivector, Even, Line, Multivector, Quadvector, RoundVector, Trivector};
use ga_runtime::linear::LinearMap;
use ga_runtime::testing::cga3::similarities;
use ga_runtime::vga3::{self, Vector};
use ga_runtime::{Element, cga2, pga3, sta};
use nalgebra_035::{DMatrix, Matrix3, SMatrix};
use nullcone_tests::plain::{dense, near, near_dense};
use proptest::prelude::*;

fn entries<const N: usize>() -> impl Strategy<Value = [[f64; N]; N]> {
    prop::collection::vec(-2.0..2.0_f64, N * N).prop_map(|entries| {
        core::array::from_fn(|row| core::array::from_fn(|column| entries[row * N + column]))
    })
}

/// The determinant of the rows and columns of two blades, which is the coefficient of the one in
/// the image of the other.
fn minor<const N: usize>(rows: &[[f64; N]; N], of: usize, at: usize) -> f64 {
    let vectors = |blade: usize| {
        (0..N)
            .filter(move |k| blade >> k & 1 == 1)
            .collect::<Vec<_>>()
    };
    let (rows_at, columns) = (vectors(at), vectors(of));
    DMatrix::from_fn(rows_at.len(), columns.len(), |i, j| {
        rows[rows_at[i]][columns[j]]
    })
    .determinant()
}

proptest! {
    #[test]
    fn coefficients_are_minors(rows in entries::<5>()) {
        let map = LinearMap::<RoundVector<f64>, RoundVector<f64>>::from_rows(rows);
        let all: [[f64; 32]; 32] = map.outermorphism::<Multivector<f64>, Multivector<f64>>().unwrap().to_rows();
        let blades = Multivector::<f64>::BLADES;
        for (row, &at) in all.iter().zip(blades) {
            for (&found, &of) in row.iter().zip(blades) {
                let expected = if at.count_ones() == of.count_ones() { minor(&rows, of, at) } else { 0.0 };
                near(found, expected, 1e-11);
            }
        }
        near(map.determinant(), SMatrix::<f64, 5, 5>::from_fn(|i, j| rows[i][j]).determinant(), 1e-11);
    }

    #[test]
    fn outer_products_are_kept(rows in entries::<5>(), x in prop::array::uniform5(-2.0..2.0_f64), y in prop::array::uniform5(-2.0..2.0_f64)) {
        let map = LinearMap::<RoundVector<f64>, RoundVector<f64>>::from_rows(rows);
        let pairs = map.outermorphism::<Bivector<f64>, Bivector<f64>>().unwrap();
        let [x, y] = [x, y].map(|[a, b, c, d, e]| RoundVector::new(a, b, c, d, e));
        let expected = &dense(&map.apply(x)) ^ &dense(&map.apply(y));
        near_dense(&dense(&pairs.apply(x ^ y)), &expected, 1e-12);
    }

    #[test]
    fn that_of_a_versor_is_its_action(similarity in similarities::<f64>(2.0, 3.0)) {
        let map = LinearMap::of(|x: RoundVector<f64>| similarity.transform(x));
        let circles = map.outermorphism::<Trivector<f64>, Trivector<f64>>().unwrap();
        let spheres = map.outermorphism::<Quadvector<f64>, Quadvector<f64>>().unwrap();
        let lines = map.outermorphism::<Line<f64>, Line<f64>>().unwrap();
        for column in 0..4 {
            let (circle, sphere) = (Trivector::<f64>::BLADES[column], Quadvector::<f64>::BLADES[column]);
            let one = |blade| move |other| f64::from(u8::from(other == blade));
            let circle = Trivector::from_coefficients_unchecked(&mut one(circle));
            near_dense(&dense(&circles.apply(circle)), &dense(&similarity).sandwich(&dense(&circle)), 1e-12);
            let sphere = Quadvector::from_coefficients_unchecked(&mut one(sphere));
            near_dense(&dense(&spheres.apply(sphere)), &dense(&similarity).sandwich(&dense(&sphere)), 1e-12);
            let line = Line::from_coefficients_unchecked(&mut one(Line::<f64>::BLADES[column]));
            near_dense(&dense(&lines.apply(line)), &dense(&similarity).sandwich(&dense(&line)), 1e-12);
        }
        near(map.determinant(), 1.0, 1e-10);
    }

    #[test]
    fn areas_are_mapped_by_cofactors(rows in entries::<3>()) {
        let map = LinearMap::<Vector<f64>, Vector<f64>>::from_rows(rows);
        let areas = map.outermorphism::<vga3::Bivector<f64>, vga3::Bivector<f64>>().unwrap();
        let matrix = Matrix3::from_fn(|i, j| rows[i][j]);
        let cofactor = |i, j| {
            let sign = if (i + j) % 2 == 0 { 1.0 } else { -1.0 };
            sign * matrix.remove_row(i).remove_column(j).determinant()
        };
        let normal = Vector::new(0.3, -0.7, 1.1);
        let found = areas.apply(vga3::Bivector::from_normal(normal.coordinates())).normal();
        for (i, found) in found.into_iter().enumerate() {
            near(found, (0..3).map(|j| cofactor(i, j) * normal[j]).sum(), 1e-12);
        }
        near(map.determinant(), matrix.determinant(), 1e-12);
    }

    #[test]
    fn other_algebras_have_outermorphisms(rows in entries::<4>(), plane in entries::<4>()) {
        let map = LinearMap::<sta::Vector<f64>, sta::Vector<f64>>::from_rows(rows);
        near(map.determinant(), SMatrix::<f64, 4, 4>::from_fn(|i, j| rows[i][j]).determinant(), 1e-11);
        let planes = LinearMap::<pga3::Plane<f64>, pga3::Plane<f64>>::from_rows(plane);
        let all: [[f64; 6]; 6] = planes.outermorphism::<pga3::Line<f64>, pga3::Line<f64>>().unwrap().to_rows();
        let order = pga3::Plane::<f64>::BLADES;
        // Rows and columns in the order of the bits, not of the declaration.
        let place = |bit: usize| order.iter().position(|&blade| blade == 1 << bit).unwrap();
        let sorted: [[f64; 4]; 4] = core::array::from_fn(|i| core::array::from_fn(|j| plane[place(i)][place(j)]));
        let lines = pga3::Line::<f64>::BLADES;
        for (row, &at) in all.iter().zip(lines) {
            for (&found, &of) in row.iter().zip(lines) {
                near(found, minor(&sorted, of, at), 1e-11);
            }
        }
    }
}

#[test]
fn a_type_that_lacks_a_blade_of_an_image_is_named() {
    // The exchange of eo and ei does not map lines to lines.
    let swap = LinearMap::of(|x: RoundVector<f64>| RoundVector::new(x.e1, x.e2, x.e3, x.ei, x.eo));
    let error = swap.outermorphism::<Line<f64>, Line<f64>>().unwrap_err();
    assert!(error.to_string().contains("not a Line"), "{error}");
    assert!(swap.outermorphism::<Line<f64>, Trivector<f64>>().is_ok());
    assert!(swap.outermorphism::<Even<f64>, Even<f64>>().is_ok());
    assert_eq!(swap.determinant(), -1.0);
    // Between algebras: the plane in the conformal model of space.
    let embed =
        LinearMap::of(|x: cga2::RoundVector<f64>| RoundVector::new(x.e1, x.e2, 0.0, x.eo, x.ei));
    let pairs = embed
        .outermorphism::<cga2::PointPair<f64>, Bivector<f64>>()
        .unwrap();
    let [p, q] = [[1.0, 2.0], [-3.0, 0.5]].map(cga2::Point::from);
    let expected =
        ga_runtime::cga3::Point::new(1.0, 2.0, 0.0) ^ ga_runtime::cga3::Point::new(-3.0, 0.5, 0.0);
    assert_eq!(pairs.apply(p ^ q), expected.into());
}
