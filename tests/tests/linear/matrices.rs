//! Maps of functions and of matrices.

use ga_runtime::cga3::{Line, Motor, RoundVector};
use ga_runtime::linear::LinearMap;
use ga_runtime::testing::cga3::{lines, motors};
use ga_runtime::vga3::Vector;
use ga_runtime::{Element, pga3, sta};
use nullcone_tests::plain::{dense, near_dense};
use proptest::prelude::*;

fn round_vector() -> impl Strategy<Value = RoundVector<f64>> {
    prop::array::uniform5(-3.0..3.0_f64).prop_map(|[a, b, c, d, e]| RoundVector::new(a, b, c, d, e))
}

ga_runtime::ga! { ga_runtime::cga3;
    /// Twice the commutator with a fixed line, and the line itself again.
    fn sheared(fixed: Line, moving: Line) -> Multivector { fixed * moving * fixed + 3 * moving }
}

proptest! {
    #[test]
    fn the_map_of_a_versor_acts_as_it_does(motor in motors::<f64>(3.0), line in lines::<f64>(3.0)) {
        let map = LinearMap::of(|line: Line<f64>| motor.transform(line));
        let expected = dense(&motor).sandwich(&dense(&line));
        near_dense(&dense(&map.apply(line)), &expected, 1e-13);
        let rows: [[f64; 6]; 6] = map.to_rows();
        // By rows: the coefficients of the image are those of the line times each row.
        for (row, &blade) in rows.iter().zip(Line::<f64>::BLADES) {
            let terms = row.iter().zip(Line::<f64>::BLADES);
            let found: f64 = terms.map(|(x, &of)| x * line.coefficient(of)).sum();
            prop_assert!((found - expected.coefficient(blade)).abs() <= 1e-12 * (1.0 + expected.coefficients().iter().fold(0.0_f64, |m, x| m.max(x.abs()))));
        }
        prop_assert_eq!(LinearMap::from_rows(rows), map);
    }

    #[test]
    fn a_product_of_maps_applies_the_right_one_first(a in motors::<f64>(3.0), b in motors::<f64>(3.0), x in round_vector()) {
        let of = |motor: Motor<f64>| LinearMap::of(move |x: RoundVector<f64>| motor.transform(x));
        let both = &of(a) * &of(b);
        let expected = dense(&(a * b)).sandwich(&dense(&x));
        near_dense(&dense(&both.apply(x)), &expected, 1e-12);
    }

    #[test]
    fn functions_of_the_compiler_are_linear(fixed in lines::<f64>(3.0), line in lines::<f64>(3.0)) {
        let map = LinearMap::try_of(|moving: Line<f64>| sheared(fixed, moving), 1e-12).expect("linear");
        let (a, x) = (dense(&fixed), dense(&line));
        let expected = &(&a * &x) * &a + x.scale(3.0);
        near_dense(&dense(&map.apply(line)), &expected, 1e-12);
    }

    #[test]
    fn a_deviation_above_the_tolerance_is_found(place in 0..3_usize, size in 1e-3..1.0_f64) {
        // Linear but for the square of one coordinate.
        let bent = |x: Vector<f64>| Vector::new(x.y(), x.x() + size * x[place] * x[place], 0.0);
        let error = LinearMap::try_of(bent, 1e-9).unwrap_err();
        prop_assert_eq!(error.found, bent(error.element));
        prop_assert_ne!(error.found, error.expected);
        prop_assert!(LinearMap::try_of(bent, 1e3).is_ok());
    }
}

/// Each deviates at one kind of the elements at which linearity is tested.
#[test]
fn the_first_element_that_deviates_is_named() {
    type V = Vector<f64>;
    let error = |f: fn(V) -> V| LinearMap::try_of(f, 1e-12).unwrap_err().element;
    assert_eq!(error(|x| x + Vector::new(0.0, 1.0, 0.0)), Vector::default());
    assert_eq!(
        error(|x| Vector::new(x.x().abs(), 0.0, 0.0)),
        Vector::new(-1.0, 0.0, 0.0)
    );
    assert_eq!(
        error(|x| Vector::new(0.0, 0.0, x.y() * x.y())),
        Vector::new(0.0, 2.0, 0.0)
    );
    assert_eq!(
        error(|x| Vector::new(x.x() * x.z(), 0.0, 0.0)),
        Vector::new(1.0, 0.0, 1.0)
    );
    let three = error(|x| Vector::new(x.x() * x.y() * x.z(), 0.0, 0.0));
    assert!(three.x() * three.y() * three.z() != 0.0);
    let error = LinearMap::try_of(|x: V| x * f64::NAN, 1e-12).unwrap_err();
    assert!(error.to_string().starts_with("the function is not linear"));
}

#[test]
fn other_algebras_have_maps() {
    let square = LinearMap::of(|v: sta::Vector<f64>| v * 2.0);
    let rows: [[f64; 4]; 4] = square.to_rows();
    assert_eq!(rows[0], [2.0, 0.0, 0.0, 0.0]);
    let plane = pga3::Plane::new(0.0, 0.0, 1.0, 0.0);
    let wedge = LinearMap::of(|other: pga3::Plane<f64>| plane ^ other);
    let other = pga3::Plane::new(1.0, 2.0, 3.0, 4.0);
    assert_eq!(wedge.apply(other), plane ^ other);
}
