//! Versors nearest to sums of versors.

use ga_runtime::cga3::{DualPlane, Even, EvenVersor, Odd, OddVersor, Point, RoundVector};
use nullcone_tests::random::SplitMix64;

use super::{deviation, random_bivector, size};

/// `X ~X` and `X ~V` of a sum and the versor nearest to it.
#[test]
fn sums_have_nearest_versors() {
    let mut n = SplitMix64(8);
    for _ in 0..2000 {
        let (a, b) = (
            random_bivector(&mut n).exp().expect("in range"),
            random_bivector(&mut n).exp().expect("in range"),
        );
        let sum = Even::from(a) * 0.7 + Even::from(b) * 0.3;
        let norm = sum * sum.reverse();
        let rest = norm.extract_quadvector();
        let square: f64 = rest.scalar_product(rest);
        let smallest = norm.scalar - square.max(0.0).sqrt();
        let Some(versor) = EvenVersor::normalize(sum) else {
            assert!(smallest < 1e-12, "{smallest}");
            continue;
        };
        if square > 0.0 && smallest < 1e-3 {
            continue;
        }
        let unit = Even::from(versor) * Even::from(versor.reverse());
        assert!(deviation(&unit, &Even::from(EvenVersor::default())) <= 1e-11);
        // X = √N V with a root of N, a scalar and a 4-vector.
        let root = sum * Even::from(versor.reverse());
        assert!(size(&root.extract_bivector()) <= 1e-11 * size(&root));
        assert!(root.scalar > 0.0);
        assert!(deviation(&(root * root), &norm) <= 1e-11);
        for factor in [1e-300, 1e-10, 3.0, 1e300] {
            let again = EvenVersor::normalize(Even::from(a) * factor).expect("a versor");
            assert!(deviation(&again, &a) <= 1e-12);
            let odd =
                OddVersor::reflection(DualPlane::new(0.0, 1.0, 0.0, 2.0)).expect("a plane") * a;
            let again = OddVersor::normalize(Odd::from(odd) * factor).expect("a versor");
            assert!(deviation(&again, &odd) <= 1e-12);
        }
    }
}

#[test]
fn sums_without_a_nearest_versor_give_none() {
    let none = |sum: Even<f64>| assert_eq!(EvenVersor::normalize(sum), None);
    let one = Even::from(EvenVersor::<f64>::default());
    none(Even::default());
    none(one * f64::NAN);
    none(Even {
        e1i: f64::INFINITY,
        ..one
    });
    // The product of two vectors of which one is a point, and of one with a negative square.
    let point = RoundVector::from(Point::new(1.0, 2.0, 3.0));
    none(point * RoundVector::new(1.0, 0.0, 0.0, 0.0, 0.0));
    let imaginary = RoundVector::new(0.0, 0.0, 0.0, 1.0, 0.5);
    none(imaginary * RoundVector::new(1.0, 0.0, 0.0, 0.0, 0.0));
    // The same times the pseudoscalar.
    assert_eq!(OddVersor::<f64>::normalize(Odd::default()), None);
    assert_eq!(OddVersor::normalize(Odd::from(imaginary)), None);
    assert_eq!(
        OddVersor::normalize(Odd {
            eo: f64::NAN,
            ..Odd::default()
        }),
        None
    );
}
