//! Versors as products: of reflections and inversions, and of a similarity and another versor.

use std::f64::consts::PI;

use ga_runtime::Element;
use ga_runtime::cga3::{
    Bivector, Dilator, DualPlane, DualSphere, EvenVersor, OddVersor, Point, Rotor, RoundVector,
    Similarity, Translator, Transversor,
};
use ga_runtime::dense::Multivector;
use ga_runtime::testing::cga3::{motors, similarities};
use nullcone_tests::plain::{dense, largest, near_dense, unit, vector};
use proptest::prelude::*;

fn even(c: [f64; 10], scale: f64) -> EvenVersor<f64> {
    let [a, b, c, d, e, f, g, h, i, j] = c.map(|x| x * scale);
    let generator = Bivector::new(a, b, c, d, e, f, g, h, i, j);
    generator.exp().expect("a moderate bivector")
}

/// General versors, near the identity too, and special ones of each kind, of both signs.
fn even_versors() -> impl Strategy<Value = EvenVersor<f64>> {
    let general = (prop::array::uniform10(-1.0..1.0_f64), -14.0..0.5_f64)
        .prop_map(|(c, size)| even(c, 10_f64.powf(size)));
    // Boxed, since trees of values of all these would be too large for the stack of a test.
    let special = prop_oneof![
        Just(EvenVersor::default()),
        motors(3.0).prop_map(EvenVersor::from).boxed(),
        similarities(3.0, 4.0).prop_map(EvenVersor::from).boxed(),
        vector(2.0)
            .prop_map(|k| Transversor::from_vector(k).into())
            .boxed(),
        unit().prop_map(half_turn).boxed(),
        Just(half_turn([1.0, 0.0, 0.0])),
        Just(half_turn([0.0, 1.0, 0.0])),
        Just(half_turn([0.0, 0.0, 1.0])),
        vector(3.0)
            .prop_map(|t| Translator::from_displacement(t).into())
            .boxed(),
        (0.1..10.0_f64)
            .prop_map(|s| Dilator::from_factor(s).expect("a factor").into())
            .boxed(),
        // The product with the inversion in the unit sphere maps the origin to infinity.
        similarities(1.0, 2.0)
            .prop_map(|s| {
                let bend = inversion([0.0; 3], 1.0) * mirror([0.0, 0.6, 0.8], 0.0);
                EvenVersor::from(s) * bend
            })
            .boxed(),
    ];
    (prop_oneof![general.boxed(), special.boxed()], any::<bool>())
        .prop_map(|(v, turned)| if turned { -v } else { v })
        .boxed()
}

fn half_turn(axis: [f64; 3]) -> EvenVersor<f64> {
    Rotor::from_axis_angle(axis, PI).expect("an axis").into()
}

fn odd_versors() -> impl Strategy<Value = OddVersor<f64>> {
    let mirrors = prop_oneof![
        (unit(), -2.0..2.0_f64).prop_map(|(normal, distance)| mirror(normal, distance)),
        (vector(2.0), 0.1..3.0_f64).prop_map(|(centre, radius)| inversion(centre, radius)),
    ];
    (even_versors(), mirrors).prop_map(|(even, odd)| even * odd)
}

fn mirror(normal: [f64; 3], distance: f64) -> OddVersor<f64> {
    OddVersor::reflection(DualPlane::from_normal_distance(normal, distance)).expect("a plane")
}

fn inversion(centre: [f64; 3], radius: f64) -> OddVersor<f64> {
    OddVersor::inversion(DualSphere::from_centre_radius(Point::from(centre), radius))
        .expect("a sphere")
}

fn size(element: &Multivector<f64>) -> f64 {
    largest(element.coefficients().iter().copied())
}

/// Asserts that vectors are unit vectors with this product, by the dense reference.
fn assert_factors(vectors: &[RoundVector<f64>], expected: &Multivector<f64>) {
    let mut product = expected.algebra().one();
    for vector in vectors {
        let vector = dense(vector);
        let square = vector.scalar_product(&vector);
        assert!(
            (square - 1.0).abs() <= 1e-13 * size(&vector).powi(2),
            "{vector}² = {square}"
        );
        product = &product * &vector;
    }
    near_dense(&product, expected, rounding(expected));
}

/// The bound of errors relative to a versor, which itself is one only within `ε |V|²`.
fn rounding(versor: &Multivector<f64>) -> f64 {
    1e-14 * (1.0 + size(versor).powi(2))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1024))]

    #[test]
    fn an_even_versor_is_a_product_of_at_most_four_reflections(versor in even_versors()) {
        let vectors = versor.reflections().expect("finite");
        prop_assert!(vectors.len() <= 4 && vectors.len().is_multiple_of(2), "{}", vectors.len());
        assert_factors(&vectors, &dense(&versor));
    }

    #[test]
    fn an_odd_versor_is_a_product_of_at_most_five_reflections(versor in odd_versors()) {
        let vectors = versor.reflections().expect("finite");
        prop_assert!(vectors.len() <= 5 && vectors.len() % 2 == 1, "{}", vectors.len());
        assert_factors(&vectors, &dense(&versor));
    }

    #[test]
    fn a_motion_is_a_product_of_reflections_in_planes(motor in motors::<f64>(5.0)) {
        for plane in EvenVersor::from(motor).reflections().expect("finite") {
            prop_assert!(plane.eo.abs() <= 1e-13, "{plane}");
        }
    }

    #[test]
    fn single_precision_has_the_same_factors(versor in even_versors()) {
        let single: EvenVersor<f32> = versor.map(|x| x as f32);
        let single = single.normalized().expect("a versor");
        let vectors = single.reflections().expect("finite");
        prop_assert!(vectors.len() <= 4 && vectors.len().is_multiple_of(2));
        let exact: EvenVersor<f64> = single.map(f64::from);
        let mut product = dense(&exact).algebra().one();
        for vector in vectors {
            let vector: RoundVector<f64> = vector.map(f64::from);
            product = &product * &dense(&vector);
        }
        // As `rounding`, for the other precision.
        let exact = dense(&exact);
        near_dense(&product, &exact, 5e-6 * (1.0 + size(&exact).powi(2)));
    }

    #[test]
    fn an_even_versor_is_a_similarity_after_a_transversor(
        similarity in similarities::<f64>(3.0, 4.0),
        size in -12.0..0.5_f64,
        direction in unit(),
    ) {
        let k = direction.map(|x| x * 10_f64.powf(size));
        let versor = EvenVersor::from(similarity) * EvenVersor::from(Transversor::from_vector(k));
        let (found, transversor) = versor.similarity_and_transversor().expect("the origin is not a pole");
        // The factors are unique.
        near_dense(&dense(&transversor), &dense(&Transversor::from_vector(k)), 1e-13);
        near_dense(&dense(&found), &dense(&similarity), 1e-12);
        let product = &dense(&found) * &dense(&transversor);
        near_dense(&product, &dense(&versor), 1e-12);
    }

    #[test]
    fn general_versors_have_their_parts(versor in even_versors()) {
        if let Some((similarity, transversor)) = versor.similarity_and_transversor() {
            let product = &dense(&similarity) * &dense(&transversor);
            let bend = size(&dense(&transversor));
            near_dense(&product, &dense(&versor), 1e-12 * bend * bend);
        }
    }

    #[test]
    fn an_odd_versor_is_a_similarity_after_an_inversion(versor in odd_versors()) {
        let (similarity, sphere) = versor.similarity_and_inversion().expect("finite");
        let vector = dense(&sphere);
        prop_assert!((vector.scalar_product(&vector) - 1.0).abs() <= 1e-14);
        let product = &dense(&similarity) * &vector;
        near_dense(&product, &dense(&versor), 1e-12);
    }
}

#[test]
fn minus_one_is_a_vector_and_its_negative() {
    let vectors = (-EvenVersor::<f64>::default()).reflections().unwrap();
    assert_eq!((vectors.len(), vectors[0]), (2, -vectors[1]));
    assert_factors(&vectors, &dense(&-EvenVersor::<f64>::default()));
    assert!(
        EvenVersor::<f64>::default()
            .reflections()
            .unwrap()
            .is_empty()
    );
}

#[test]
fn the_similarity_of_a_reflection_is_a_translation() {
    let (similarity, plane) = mirror([0.6, 0.0, 0.8], 2.0)
        .similarity_and_inversion()
        .unwrap();
    let expected = Translator::from_displacement([2.4, 0.0, 3.2]);
    near_dense(
        &dense(&similarity),
        &dense(&Similarity::from(expected)),
        1e-15,
    );
    near_dense(
        &dense(&plane),
        &dense(&RoundVector::new(0.6, 0.0, 0.8, 0.0, 0.0)),
        1e-15,
    );
    // The reflection in the origin has no axis.
    let centre = mirror([1.0, 0.0, 0.0], 0.0) * mirror([0.0, 1.0, 0.0], 0.0);
    let centre = centre * mirror([0.0, 0.0, 1.0], 0.0);
    let (similarity, plane) = centre.similarity_and_inversion().unwrap();
    near_dense(
        &(&dense(&similarity) * &dense(&plane)),
        &dense(&centre),
        1e-15,
    );
}

#[test]
fn a_versor_that_maps_the_origin_to_infinity_has_no_transversor() {
    let bend = inversion([0.0; 3], 1.0) * mirror([0.0, 0.0, 1.0], 0.0);
    assert_eq!(bend.similarity_and_transversor(), None);
    assert_eq!(bend.reflections().map(|vectors| vectors.len()), Some(2));
    // By way of another point, so that it does so only within rounding.
    let centre = [0.1, 0.2, 0.3];
    let shift = Translator::from_displacement(centre);
    let bend = inversion(centre, 0.7) * mirror([0.6, 0.0, 0.8], 0.3) * EvenVersor::from(shift);
    assert_eq!(bend.similarity_and_transversor(), None);
}

#[test]
fn numbers_that_are_not_finite_have_no_factors() {
    let bad: EvenVersor<f64> = EvenVersor::default().map(|x: f64| x * f64::NAN);
    assert_eq!(bad.reflections(), None);
    assert_eq!(bad.similarity_and_transversor(), None);
    let bad: OddVersor<f64> = mirror([1.0, 0.0, 0.0], 0.0).map(|x| x * f64::INFINITY);
    assert_eq!(bad.reflections(), None);
    assert_eq!(bad.similarity_and_inversion(), None);
}
