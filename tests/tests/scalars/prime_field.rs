//! The prime field against `u128` arithmetic, and its axioms.

use std::collections::HashSet;

use ga_runtime::scalar::{Field, Prime61, Ring};
use ga_runtime::testing::strategy::{nonzero_prime, prime};
use proptest::prelude::*;

const P: u128 = (1 << 61) - 1;

/// Any number; those near the multiples of the modulus are drawn more often.
fn integer() -> impl Strategy<Value = u64> {
    prop_oneof![
        3 => any::<u64>(),
        1 => (0_u64..8, -3_i64..=3).prop_map(|(multiple, offset)| (multiple * P as u64).wrapping_add_signed(offset)),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1024))]

    #[test]
    fn agrees_with_wide_integers(a in integer(), b in integer()) {
        let (x, y) = (Prime61::new(a), Prime61::new(b));
        let (a, b) = (u128::from(a), u128::from(b));
        prop_assert_eq!(u128::from(x.value()), a % P);
        prop_assert_eq!(u128::from((x + y).value()), (a + b) % P);
        prop_assert_eq!(u128::from((x - y).value()), (a % P + P - b % P) % P);
        prop_assert_eq!(u128::from((x * y).value()), (a % P) * (b % P) % P);
        prop_assert_eq!(u128::from((-x).value()), (P - a % P) % P);
        prop_assert_eq!(u128::from(x.mul_add(y, x).value()), ((a % P) * (b % P) + a % P) % P);
    }

    #[test]
    fn assignment_is_the_operator(x in prime(), y in prime()) {
        let mut z = x;
        z += y;
        prop_assert_eq!(z, x + y);
        z -= x;
        prop_assert_eq!(z, y);
        z *= x;
        prop_assert_eq!(z, y * x);
        z /= x;
        prop_assert_eq!(z, y * x / x);
    }

    #[test]
    fn signed_integers_keep_their_sums_and_products(a in -(1_i64 << 31)..1 << 31, b in -(1_i64 << 31)..1 << 31) {
        let (x, y) = (Prime61::from(a), Prime61::from(b));
        prop_assert_eq!(x + y, Prime61::from(a + b));
        prop_assert_eq!(x * y, Prime61::from(a * b));
        prop_assert_eq!(x - y, Prime61::from_integer(a - b));
    }

    #[test]
    fn any_signed_integer(a in prop_oneof![any::<i64>(), Just(i64::MIN), Just(i64::MAX)]) {
        prop_assert_eq!(i128::from(Prime61::from(a).value()), i128::from(a).rem_euclid(P as i128));
    }

    #[test]
    fn ring_axioms(x in prime(), y in prime(), z in prime()) {
        prop_assert_eq!((x + y) + z, x + (y + z));
        prop_assert_eq!((x * y) * z, x * (y * z));
        prop_assert_eq!(x + y, y + x);
        prop_assert_eq!(x * y, y * x);
        prop_assert_eq!(x * (y + z), x * y + x * z);
        prop_assert_eq!(x + Prime61::zero(), x);
        prop_assert_eq!(x * Prime61::one(), x);
        prop_assert_eq!(x + -x, Prime61::zero());
    }

    #[test]
    fn inverses(x in nonzero_prime(), y in prime()) {
        prop_assert_ne!(x, Prime61::zero());
        prop_assert_eq!(x * x.inverse(), Prime61::one());
        prop_assert_eq!(x * x.recip(), Prime61::one());
        prop_assert_eq!(y / x * x, y);
    }

    #[test]
    fn fractions(numerator in any::<i64>(), denominator in 1_i64..) {
        let fraction = Prime61::from_ratio(numerator, denominator);
        prop_assume!(Prime61::from(denominator) != Prime61::zero());
        prop_assert_eq!(fraction * Prime61::from(denominator), Prime61::from(numerator));
        prop_assert_eq!(Prime61::from_ratio(-numerator.saturating_abs(), -denominator),
            Prime61::from_ratio(numerator.saturating_abs(), denominator));
    }

    #[test]
    fn powers(x in prime(), exponent in 0_u64..40) {
        let product = (0..exponent).fold(Prime61::one(), |product, _| product * x);
        prop_assert_eq!(x.power(exponent), product);
    }

    #[test]
    fn every_square_has_roots_and_its_negative_none(x in nonzero_prime()) {
        let root = (x * x).square_root();
        prop_assert!(root == Some(x) || root == Some(-x));
        prop_assert_eq!((-(x * x)).square_root(), None);
    }

    #[test]
    fn text_is_the_nearest_integer(a in -(P as i64 / 2)..=P as i64 / 2) {
        prop_assert_eq!(Prime61::from(a).to_string(), a.to_string());
        prop_assert_eq!(format!("{:?}", Prime61::from(a)), a.to_string());
    }
}

#[test]
fn the_modulus_is_prime() {
    // Lucas–Lehmer: 2^q − 1 is prime if and only if it divides s(q − 2), with s(0) = 4, s(k + 1) =
    // s(k)² − 2.
    let last = (0..61 - 2).fold(4, |s: u128, _| (s * s + P - 2) % P);
    assert_eq!(last, 0);
    assert_eq!(u128::from(Prime61::MODULUS), P);
}

#[test]
fn zero_has_zero_for_an_inverse() {
    let (zero, one) = (Prime61::zero(), Prime61::one());
    assert_eq!(zero.inverse(), zero);
    assert_eq!(one / zero, zero);
    assert_eq!(Prime61::from_ratio(1, 0), zero);
    assert_eq!(zero.square_root(), Some(zero));
    assert_eq!(zero.power(0), one);
}

#[test]
fn each_residue_has_one_representation() {
    let zeros = [
        Prime61::new(0),
        Prime61::new(P as u64),
        Prime61::new(7 * P as u64),
        -Prime61::zero(),
        Prime61::default(),
    ];
    assert_eq!(HashSet::from(zeros).len(), 1);
    assert_eq!(Prime61::one() - Prime61::one(), Prime61::zero());
    assert_eq!(Prime61::from(-1) + Prime61::one(), Prime61::zero());
}
