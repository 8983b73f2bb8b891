//! Actions of conformal versors on points, against formulas and over the prime field.

use ga_runtime::Element;
use ga_runtime::cga3::{
    Bivector, Circle, DualCircle, DualPlane, DualPointPair, DualSphere, EvenVersor, Multivector,
    OddVersor, Point, PointPair, Quadvector, RoundVector, Sphere, Translator, Transversor,
    Trivector,
};
use ga_runtime::testing::{algebra_of, assert_close, exact_member, for_all, to_dense};
use nullcone_tests::plain::{along, dot, vector};
use proptest::prelude::*;

/// Every product and action of general versors is that of the reference, exactly.
#[test]
fn products_and_actions_are_exact() {
    let versors = (
        exact_member::<EvenVersor<_>>(),
        exact_member::<EvenVersor<_>>(),
        exact_member::<OddVersor<_>>(),
        exact_member::<OddVersor<_>>(),
        exact_member::<Transversor<_>>(),
    );
    for_all(versors, |(a, b, v, w, k)| {
        let algebra = algebra_of(Multivector::<ga_runtime::testing::Prime61>::METRIC);
        let dense = |x: Multivector<_>| to_dense(&algebra, &x);
        let product = |x: Multivector<_>, y: Multivector<_>| dense(x).geometric(&dense(y));
        assert_eq!(dense((a * b).into()), product(a.into(), b.into()));
        assert_eq!(dense((a * v).into()), product(a.into(), v.into()));
        assert_eq!(dense((v * a).into()), product(v.into(), a.into()));
        assert_eq!(dense((v * w).into()), product(v.into(), w.into()));
        assert_eq!(dense((k * k).into()), product(k.into(), k.into()));
        assert_eq!(product(v.into(), v.inverse().into()), algebra.one());
    });
    macro_rules! actions {
        ($($Blade:ident)*) => {$(
            let operands = (
                exact_member::<EvenVersor<_>>(),
                exact_member::<OddVersor<_>>(),
                exact_member::<Transversor<_>>(),
                exact_member::<$Blade<_>>(),
            );
            for_all(operands, |(a, v, k, x)| {
                let algebra = algebra_of(Multivector::<ga_runtime::testing::Prime61>::METRIC);
                let check = |versor: Multivector<_>, image: Multivector<_>| {
                    let versor = to_dense(&algebra, &versor);
                    let expected = versor.transform(&to_dense(&algebra, &x)).expect("a versor");
                    assert_eq!(to_dense(&algebra, &image), expected);
                };
                check(a.into(), a.transform(x).into());
                check(v.into(), v.transform(x).into());
                check(k.into(), k.transform(x).into());
            });
        )*};
    }
    actions!(Point RoundVector DualSphere PointPair DualCircle Circle DualPointPair Sphere Bivector Trivector Quadvector);
    for_all(
        (
            exact_member::<EvenVersor<_>>(),
            exact_member::<OddVersor<_>>(),
            exact_member::<DualPlane<_>>(),
        ),
        |(a, v, x)| {
            assert_eq!(a.transform(x), a.transform(RoundVector::from(x)));
            assert_eq!(v.transform(x), v.transform(RoundVector::from(x)));
        },
    );
}

proptest! {
    #[test]
    fn inversions_in_spheres(x in vector(3.0), c in vector(3.0), r in 0.1..3.0) {
        let from_centre = along(x, -1.0, c);
        let squared = dot(from_centre, from_centre);
        prop_assume!(squared > 1e-2);
        let sphere = DualSphere::from_centre_radius(Point::from(c), r) * -2.5;
        let inversion = OddVersor::inversion(sphere).expect("real");
        let image = inversion.transform_point(Point::from(x)).expect("a point");
        assert_close!(image.coordinates(), along(c, r * r / squared, from_centre), 1e-11, 100.0);
        // An imaginary sphere maps the point to the opposite side and preserves handedness.
        let imaginary = DualSphere::from_centre_radius_squared(Point::from(c), -r * r);
        let even = Multivector::from(imaginary).dual().extract_even();
        let versor = EvenVersor::normalize(even).expect("a versor");
        let image = versor.transform_point(Point::from(x)).expect("a point");
        assert_close!(image.coordinates(), along(c, -r * r / squared, from_centre), 1e-11, 100.0);
        prop_assert_eq!(OddVersor::inversion(imaginary), None);
    }

    #[test]
    fn reflections_in_planes(x in vector(3.0), n in vector(3.0), d in -3.0..3.0) {
        let squared = dot(n, n);
        prop_assume!(squared > 1e-2);
        let mirror = OddVersor::reflection(DualPlane::new(n[0], n[1], n[2], d)).expect("a plane");
        let image = mirror.transform_point(Point::from(x)).expect("a point");
        let expected = along(x, 2.0 * (d - dot(n, x)) / squared, n);
        assert_close!(image.coordinates(), expected, 1e-12, 100.0);
        // Two reflections are a motion.
        let other = OddVersor::reflection(DualPlane::new(1.0, 0.0, 0.0, 0.5)).expect("a plane");
        let motion = other * mirror;
        prop_assert_eq!([motion.e1o(), motion.e2o(), motion.e3o(), motion.eoi()], [0.0; 4]);
    }

    #[test]
    fn transversors_are_special_conformal_maps(x in vector(3.0), k in vector(3.0), t in -2.0..2.0) {
        let (square, inner) = (dot(x, x), dot(k, x));
        let divisor = 1.0 + 2.0 * inner + dot(k, k) * square;
        prop_assume!(divisor > 1e-2);
        let bend = Transversor::from_vector(k);
        let image = bend.transform_point(Point::from(x)).expect("a point");
        let expected = along(x, square, k).map(|x| x / divisor);
        assert_close!(image.coordinates(), expected, 1e-11, 100.0);
        prop_assert_eq!(bend.vector(), k);
        // Inversion, translation, inversion.
        let unit = OddVersor::inversion(DualSphere::from_centre_radius(Point::ORIGIN, 1.0)).expect("real");
        let shift = EvenVersor::from(Translator::from_displacement(k));
        assert_close!(unit * (shift * unit), EvenVersor::from(bend), 1e-15);
        assert_close!(
            EvenVersor::from(bend.powf(t)),
            EvenVersor::from(bend).powf(t).expect("in range"),
            1e-14
        );
        prop_assert_eq!(bend.log().exp(), Some(bend.into()));
        assert_close!(EvenVersor::from(bend.sqrt() * bend.sqrt()), EvenVersor::from(bend), 1e-15);
    }
}

#[test]
fn vectors_without_a_reflection() {
    assert_eq!(
        OddVersor::reflection(DualPlane::new(0.0, 0.0, 0.0, 1.0)),
        None
    );
    assert_eq!(
        OddVersor::reflection(DualPlane::new(f64::NAN, 0.0, 0.0, 1.0)),
        None
    );
    assert_eq!(
        OddVersor::reflection(DualPlane::new(1.0, 0.0, 0.0, f64::INFINITY)),
        None
    );
    let point = DualSphere::from_centre_radius(Point::new(1.0, 2.0, 3.0), 0.0);
    assert_eq!(OddVersor::inversion(point), None);
    assert_eq!(OddVersor::<f64>::inversion(DualSphere::default()), None);
    // Only the squares of these small and large numbers leave the range.
    for factor in [1e-200, 1e200] {
        let mirror = OddVersor::reflection(DualPlane::new(0.0, factor, 0.0, 0.0));
        assert_eq!(
            mirror,
            OddVersor::reflection(DualPlane::new(0.0, 1.0, 0.0, 0.0))
        );
    }
    let bend = Transversor::from_vector([1.0, 0.0, 0.0]);
    assert_eq!(bend.transform_point(Point::new(f64::NAN, 0.0, 0.0)), None);
    assert_eq!(
        EvenVersor::from(bend).transform_point(Point::new(-1.0, 0.0, 0.0)),
        None
    );
}
