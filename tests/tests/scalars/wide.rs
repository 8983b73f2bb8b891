//! The vectors of the `wide` crate against single numbers.

use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_runtime::scalar::{Field, Mask, Real, Ring, WideMask};
use proptest::array::{uniform2, uniform4, uniform8};
use proptest::prelude::*;
use wide::{f32x4, f32x8, f64x2, f64x4};

/// Equality of bits, with all NaNs equal, and distance in units in the last place.
trait Number: Real<Mask = bool> {
    fn same(self, other: Self) -> bool;
    fn units_apart(self, other: Self) -> f64;
    fn to_f64(self) -> f64;
}

macro_rules! implement_number {
    ($type:ident) => {
        impl Number for $type {
            fn same(self, other: Self) -> bool {
                self.to_bits() == other.to_bits() || self.is_nan() && other.is_nan()
            }
            fn units_apart(self, other: Self) -> f64 {
                if self.same(other) {
                    return 0.0;
                }
                let unit = (other.next_up() - other)
                    .abs()
                    .max((other - other.next_down()).abs());
                f64::from((self - other).abs() / unit)
            }
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
        }
    };
}
implement_number!(f32);
implement_number!(f64);

/// What exact arithmetic gives in one vector, in the order of [`exact`] of single numbers.
fn exact<S: Real>(x: S, y: S, z: S) -> [S; 17] {
    let mut sum = x;
    sum += y;
    sum -= z;
    sum *= x;
    [
        x + y,
        x - y,
        x * y,
        x / y,
        -x,
        sum,
        x.mul_add(y, z),
        x.recip(),
        x.sqrt(),
        x.abs(),
        x.max(y),
        x.min(y),
        S::select(x.less_than(y) | x.is_zero(), y, z),
        x.sinh(),
        x.cosh(),
        x.tanh(),
        x.hypot(y),
    ]
}

fn elementary<S: Real>(x: S, y: S) -> [S; 3] {
    [x.atan2(y), x.exp(), x.ln()]
}

/// Bound of the absolute error of sine and cosine in ε, and of the others in units in the last
/// place.
const SINE_BOUND: f64 = 2.0;
const ULP_BOUND: f64 = 4.0;

fn check<V, T, const N: usize>(a: [T; N], b: [T; N], c: [T; N]) -> Result<(), TestCaseError>
where
    V: Real<Mask = WideMask<V>> + From<[T; N]> + Into<[T; N]>,
    WideMask<V>: Mask,
    T: Number,
{
    let [x, y, z] = [a, b, c].map(V::from);
    for (index, vector) in exact(x, y, z).into_iter().enumerate() {
        let lanes: [T; N] = vector.into();
        for k in 0..N {
            let alone = exact(a[k], b[k], c[k])[index];
            prop_assert!(
                lanes[k].same(alone),
                "result {index}: {:?}, alone {alone:?}",
                lanes[k]
            );
        }
    }
    for (index, vector) in elementary(x, y).into_iter().enumerate() {
        let lanes: [T; N] = vector.into();
        for k in 0..N {
            let alone = elementary(a[k], b[k])[index];
            prop_assert!(
                lanes[k].units_apart(alone) <= ULP_BOUND,
                "function {index} of {:?}, {:?}: {:?}, alone {alone:?}",
                a[k],
                b[k],
                lanes[k]
            );
        }
    }
    let (sine, cosine): ([T; N], [T; N]) = {
        let (sine, cosine) = x.sin_cos();
        (sine.into(), cosine.into())
    };
    for k in 0..N {
        for (found, alone) in [(sine[k], a[k].sin()), (cosine[k], a[k].cos())] {
            let apart = (found.to_f64() - alone.to_f64()).abs() / T::epsilon().to_f64();
            prop_assert!(
                found.same(alone) || apart <= SINE_BOUND,
                "at {:?}: {found:?}, alone {alone:?}",
                a[k]
            );
        }
    }
    let less: Vec<_> = (0..N).map(|k| a[k].less_than(b[k])).collect();
    let mask = x.less_than(y);
    prop_assert_eq!(
        (0..N).map(|k| mask.lane(k)).collect::<Vec<_>>(),
        less.clone()
    );
    prop_assert_eq!(mask.any(), less.contains(&true));
    prop_assert_eq!(mask.all(), !less.contains(&false));
    prop_assert_eq!((!mask).any(), less.contains(&false));
    let finite = a.iter().all(|x| x.is_finite());
    prop_assert_eq!((x.is_finite() & WideMask::<V>::splat(true)).all(), finite);
    prop_assert!(!(x.is_finite() & WideMask::<V>::splat(false)).any());
    prop_assert_eq!(x.is_invertible(), a.iter().all(|x| !x.is_zero()));
    Ok(())
}

fn single() -> impl Strategy<Value = f32> {
    const SPECIAL: [f32; 8] = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::NAN,
        1e-41,
    ];
    prop_oneof![
        1 => prop::num::f32::ANY,
        6 => -30.0_f32..30.0,
        1 => -120.0_f32..120.0,
        1 => -2000.0_f32..2000.0,
        1 => prop::sample::select(&SPECIAL[..]),
    ]
}

fn double() -> impl Strategy<Value = f64> {
    const SPECIAL: [f64; 8] = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::NAN,
        1e-310,
    ];
    prop_oneof![
        1 => prop::num::f64::ANY,
        6 => -30.0_f64..30.0,
        1 => -800.0_f64..800.0,
        1 => -2e5_f64..2e5,
        1 => prop::sample::select(&SPECIAL[..]),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2048))]

    #[test]
    fn four_singles(a in uniform4(single()), b in uniform4(single()), c in uniform4(single())) {
        check::<f32x4, _, 4>(a, b, c)?;
    }

    #[test]
    fn eight_singles(a in uniform8(single()), b in uniform8(single()), c in uniform8(single())) {
        check::<f32x8, _, 8>(a, b, c)?;
    }

    #[test]
    fn two_doubles(a in uniform2(double()), b in uniform2(double()), c in uniform2(double())) {
        check::<f64x2, _, 2>(a, b, c)?;
    }

    #[test]
    fn four_doubles(a in uniform4(double()), b in uniform4(double()), c in uniform4(double())) {
        check::<f64x4, _, 4>(a, b, c)?;
    }

    #[test]
    fn four_points_at_once(x in uniform4(-10.0_f64..10.0), y in uniform4(-10.0_f64..10.0), angle in 0.0_f64..6.0) {
        let turn = Rotor::from_axis_angle([1.0, 2.0, 2.0], angle).expect("an axis");
        let motor = Translator::from_displacement([1.0, -2.0, 3.0]) * turn;
        let [s, e12, e13, e23] = [motor.scalar(), motor.e12(), motor.e13(), motor.e23()].map(f64x4::splat);
        let [e1i, e2i, e3i, e123i] = [motor.e1i(), motor.e2i(), motor.e3i(), motor.e123i()].map(f64x4::splat);
        let same = Motor::new_unchecked(s, e12, e13, e23, e1i, e2i, e3i, e123i);
        let moved = same.transform(Point::new(x.into(), y.into(), f64x4::splat(0.5)));
        for k in 0..4 {
            let alone = motor.transform(Point::new(x[k], y[k], 0.5)).coordinates();
            prop_assert_eq!(moved.coordinates().map(|x| x.to_array()[k].to_bits()), alone.map(f64::to_bits));
        }
    }
}

#[test]
fn constants() {
    assert_eq!(f32x8::from_ratio(1, 4), f32x8::splat(0.25));
    assert_eq!(f64x4::from_integer(-7), f64x4::splat(-7.0));
    assert_eq!(<f64x2 as Ring>::one(), f64x2::splat(1.0));
    assert_eq!(<f32x4 as Ring>::zero(), f32x4::splat(0.0));
    assert_eq!(f64x2::from_f64(0.1), f64x2::splat(0.1));
    assert_eq!(<f32x4 as Real>::epsilon(), f32x4::splat(f32::EPSILON));
}
