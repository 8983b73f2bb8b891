//! The motion, similarity or versor nearest to a matrix, against nalgebra's singular values.

use ga_runtime::cga3::{Bivector, DualSphere, EvenVersor, OddVersor, Point, RoundVector};
use ga_runtime::geometry::{Affine, NotConformal};
use ga_runtime::linear::LinearMap;
use nalgebra_035::{Matrix3, Matrix5};
use nullcone_tests::plain::{dense, near, near_dense, vector};
use proptest::prelude::*;

type Rows = [[f64; 3]; 3];

fn matrix(rows: Rows) -> Matrix3<f64> {
    Matrix3::from_fn(|i, j| rows[i][j])
}

fn rows() -> impl Strategy<Value = Rows> {
    [vector(2.0), vector(2.0), vector(2.0)]
}

/// The orthogonal factor of the polar decomposition by the singular values, the factors along the
/// axes, and the sign of the determinant.
fn polar(rows: Rows) -> (Matrix3<f64>, [f64; 3], f64) {
    let svd = matrix(rows).svd(true, true);
    let (u, v) = (svd.u.expect("vectors"), svd.v_t.expect("vectors"));
    let mut values: [f64; 3] = svd.singular_values.into();
    values.sort_by(|a, b| b.total_cmp(a));
    (u * v, values, (u * v).determinant())
}

fn linear_part(map: impl Fn(Point<f64>) -> Option<Point<f64>>) -> Matrix3<f64> {
    let at = |p: [f64; 3]| map(Point::from(p)).expect("a point").coordinates();
    let origin = at([0.0; 3]);
    let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(at);
    Matrix3::from_fn(|i, j| columns[j][i] - origin[i])
}

proptest! {
    #[test]
    fn motions_and_similarities_are_the_polar_factors(rows in rows(), translation in vector(3.0), size in -8.0..8.0_f64) {
        let factor = 10_f64.powf(size);
        let rows = rows.map(|row| row.map(|x| x * factor));
        let (orthogonal, values, sign) = polar(rows);
        // Where the smallest two values nearly vanish, the factor is ill-conditioned.
        prop_assume!(values[2] > 0.05 * values[0]);
        let map = Affine::new(rows, translation);
        let mean = values.iter().sum::<f64>() / 3.0;
        let residual = (matrix(rows) - orthogonal * mean).norm();
        if sign > 0.0 {
            let motion = map.nearest_motion().unwrap();
            let found = matrix(motion.versor.rotor().to_matrix());
            prop_assert!((found - orthogonal).norm() <= 1e-13);
            near((matrix(rows) - orthogonal).norm(), motion.residual, 1e-13 * (factor + 1.0));
            let similarity = map.nearest_similarity().unwrap();
            near(similarity.versor.factor(), mean, 1e-13 * mean);
            near(similarity.residual, residual, 1e-13 * factor);
            for (found, expected) in similarity.stretches.into_iter().zip(values) {
                near(found, expected, 1e-13 * factor);
            }
            let found = similarity.versor.displacement();
            for (found, expected) in found.into_iter().zip(translation) {
                near(found, expected, 1e-13 * 3.0);
            }
            prop_assert_eq!(map.nearest_opposite_similarity().unwrap_err(), NotConformal::DoesNotMirror);
        } else {
            prop_assert_eq!(map.nearest_motion().unwrap_err(), NotConformal::Mirrors);
            prop_assert_eq!(map.nearest_similarity().unwrap_err(), NotConformal::Mirrors);
            let nearest = map.nearest_opposite_similarity().unwrap();
            near(nearest.residual, residual, 1e-13 * factor);
            // The weight of an image by a versor is computed with cancellation for other factors.
            if size.abs() < 1.0 {
                let found = linear_part(|p| nearest.versor.transform_point(p));
                prop_assert!((found - orthogonal * mean).norm() <= 1e-11 * factor);
            }
        }
    }

    #[test]
    fn no_similarity_beside_it_is_nearer(rows in rows(), turn in vector(0.1), growth in 0.9..1.1_f64) {
        let (_, values, sign) = polar(rows);
        prop_assume!(sign > 0.0 && values[2] > 0.05);
        let nearest = Affine::new(rows, [0.0; 3]).nearest_similarity().unwrap();
        let spin = nalgebra_035::Rotation3::new(turn.into());
        let rotation = matrix(nearest.versor.rotor().to_matrix());
        let other = (matrix(rows) - spin * rotation * nearest.versor.factor() * growth).norm();
        prop_assert!(nearest.residual <= other + 1e-12);
        let itself = (matrix(rows) - rotation * nearest.versor.factor()).norm();
        near(nearest.residual, itself, 1e-13);
    }

    #[test]
    fn single_precision_finds_the_rotation(rows in rows()) {
        let (orthogonal, values, sign) = polar(rows);
        prop_assume!(sign > 0.0 && values[2] > 0.1);
        let map = Affine::new(rows.map(|row| row.map(|x| x as f32)), [0.0; 3]);
        let found = map.nearest_motion().unwrap().versor.rotor().to_matrix();
        prop_assert!((matrix(found.map(|row| row.map(f64::from))) - orthogonal).norm() <= 1e-5);
    }

    #[test]
    fn the_projective_part_is_what_is_left(rows in rows(), rest in vector(1.0), last in 0.5..2.0_f64, point in vector(1.0)) {
        let [a, b, c] = rows;
        let matrix = [[a[0], a[1], a[2], 1.0], [b[0], b[1], b[2], 2.0], [c[0], c[1], c[2], 3.0], [rest[0], rest[1], rest[2], last]];
        let (map, left) = Affine::with_projective_part(matrix).unwrap();
        let weight = 1.0 + left[0] * point[0] + left[1] * point[1] + left[2] * point[2];
        prop_assume!(weight.abs() > 0.1);
        let expected = ga_runtime::geometry::homogeneous::transform(matrix, Point::from(point)).unwrap();
        let found = map.transform(Point::from(point)).coordinates().map(|x| x / weight);
        prop_assert!(expected.distance(Point::from(found)) <= 1e-12);
    }

    #[test]
    fn versors_come_back_from_their_maps(c in prop::array::uniform10(-0.8..0.8_f64), weight in prop_oneof![-3.0..-0.1_f64, 0.1..3.0_f64], mirrors in any::<bool>()) {
        let [a, b, c, d, e, f, g, h, i, j] = c;
        let versor = Bivector::new(a, b, c, d, e, f, g, h, i, j).exp().expect("a versor");
        let size = dense(&versor).coefficients().iter().fold(1.0, |most: f64, x| most.max(x.abs()));
        let bound = 1e-13 * size.powi(4);
        if mirrors {
            let odd = versor * mirror();
            let map = LinearMap::of(|x: RoundVector<f64>| odd.transform(x) * weight);
            let nearest = OddVersor::nearest_to(&map).unwrap();
            let same = if nearest.versor.e1() * odd.e1() < 0.0 { -nearest.versor } else { nearest.versor };
            near_dense(&dense(&same), &dense(&odd), bound);
            near(nearest.weight, weight, bound);
            near(nearest.residual, 0.0, bound);
            prop_assert_eq!(EvenVersor::nearest_to(&map).unwrap_err(), NotConformal::Mirrors);
        } else {
            let map = LinearMap::of(|x: RoundVector<f64>| versor.transform(x) * weight);
            let nearest = EvenVersor::nearest_to(&map).unwrap();
            let dot = dense(&nearest.versor).scalar_product(&dense(&versor).reverse());
            let same = if dot < 0.0 { -nearest.versor } else { nearest.versor };
            near_dense(&dense(&same), &dense(&versor), bound);
            near(nearest.weight, weight, bound);
            near(nearest.residual, 0.0, bound);
            prop_assert_eq!(OddVersor::nearest_to(&map).unwrap_err(), NotConformal::DoesNotMirror);
        }
    }

    /// A map `w V(H)` with an H near 1 that is its own adjoint has exactly these factors.
    #[test]
    fn the_orthogonal_factor_is_found(c in prop::array::uniform10(-0.5..0.5_f64), s in prop::array::uniform15(-0.1..0.1_f64)) {
        let [a, b, c, d, e, f, g, h, i, j] = c;
        let versor = Bivector::new(a, b, c, d, e, f, g, h, i, j).exp().expect("a versor");
        // In the orthonormal frame of e₋ and four vectors of square 1 the matrix G S of a symmetric
        // S is its own adjoint.
        let mut entries = s.into_iter();
        let mut symmetric = Matrix5::<f64>::zeros();
        for row in 0..5 {
            for column in 0..=row {
                let entry = entries.next().expect("15 entries");
                symmetric[(row, column)] = entry;
                symmetric[(column, row)] = entry;
            }
        }
        let signs = Matrix5::from_diagonal(&[-1.0, 1.0, 1.0, 1.0, 1.0].into());
        let stretch = Matrix5::identity() + signs * symmetric;
        // Columns: e₋ = eo + ½ ei, e₊ = eo − ½ ei, e1, e2, e3 as conformal vectors.
        let frame = Matrix5::new(
            0.0, 0.0, 1.0, 0.0, 0.0,
            0.0, 0.0, 0.0, 1.0, 0.0,
            0.0, 0.0, 0.0, 0.0, 1.0,
            1.0, 1.0, 0.0, 0.0, 0.0,
            0.5, -0.5, 0.0, 0.0, 0.0,
        );
        let stretch_map = LinearMap::<RoundVector<f64>, RoundVector<f64>>::from(
            frame * stretch * frame.try_inverse().expect("a frame"),
        );
        let map = &LinearMap::of(|x: RoundVector<f64>| versor.transform(x)) * &stretch_map;
        let nearest = EvenVersor::nearest_to(&map).unwrap();
        let dot = dense(&nearest.versor).scalar_product(&dense(&versor).reverse());
        let same = if dot < 0.0 { -nearest.versor } else { nearest.versor };
        near_dense(&dense(&same), &dense(&versor), 1e-11);
        let weight = stretch.determinant().powf(0.2);
        near(nearest.weight, weight, 1e-11);
        near(nearest.residual, (stretch / weight - Matrix5::identity()).norm(), 1e-11);
    }
}

fn mirror() -> OddVersor<f64> {
    let sphere = DualSphere::from_centre_radius(Point::new(0.3, 0.1, -0.2), 1.5);
    OddVersor::inversion(sphere).expect("a sphere")
}

#[test]
fn maps_without_a_nearest_versor_are_refused() {
    let point = Affine::new([[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [0.0; 3]], [0.0; 3]);
    assert_eq!(point.nearest_motion().unwrap_err(), NotConformal::Singular);
    assert_eq!(
        Affine::scaling([0.0; 3]).nearest_similarity().unwrap_err(),
        NotConformal::Singular
    );
    // Of rank two it is unique.
    assert!(Affine::scaling([1.0, 1.0, 0.0]).nearest_motion().is_ok());
    let bad = Affine::scaling([1.0, f64::NAN, 1.0]);
    assert_eq!(bad.nearest_motion().unwrap_err(), NotConformal::NotFinite);
    let mut rows = [[0.0; 4]; 4];
    assert_eq!(
        Affine::with_projective_part(rows),
        Err(NotConformal::Projective)
    );
    rows[0][1] = f64::INFINITY;
    assert_eq!(
        Affine::with_projective_part(rows),
        Err(NotConformal::NotFinite)
    );

    let of =
        |f: fn(RoundVector<f64>) -> RoundVector<f64>| EvenVersor::nearest_to(&LinearMap::of(f));
    assert_eq!(of(|x| x * f64::NAN).unwrap_err(), NotConformal::NotFinite);
    assert_eq!(of(|x| x * 0.0).unwrap_err(), NotConformal::Singular);
    let flat = of(|x| RoundVector::new(0.0, x.e2, x.e3, x.eo, x.ei));
    assert_eq!(flat.unwrap_err(), NotConformal::Singular);
    // A rotation of e₋ into e1 by a right angle: no factor of it is an isometry.
    let turned = of(|x| {
        let (minus, plus) = (x.eo * 0.5 + x.ei, x.eo * 0.5 - x.ei);
        let (minus, e1) = (-x.e1, minus);
        RoundVector::new(e1, x.e2, x.e3, minus + plus, (minus - plus) * 0.5)
    });
    assert_eq!(turned.unwrap_err(), NotConformal::Shears);
}
