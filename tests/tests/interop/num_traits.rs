//! num-traits: zero and one satisfy their laws exactly, and types without them do not implement the
//! traits.

use ga_runtime::cga3::{self, Point, Rotor, Translator};
use ga_runtime::interop::num_traits::FromFloat;
use ga_runtime::pga3;
use ga_runtime::scalar::{Dual, Lanes, Prime61, Real};
use ga_runtime::testing::{exact_member, for_all};
use nullcone_embedder::{sta, with_a_path::complex};
use num_traits_02::{One, Zero};
use proptest::prelude::*;

/// Whether a type implements a trait: the inherent constant takes precedence over that of the
/// trait.
macro_rules! has {
    ($type:ty: $bound:path) => {{
        #[allow(dead_code)]
        trait Otherwise {
            const HAS: bool = false;
        }
        struct Asked<T>(core::marker::PhantomData<T>);
        impl<T> Otherwise for Asked<T> {}
        #[allow(dead_code)]
        impl<T: $bound> Asked<T> {
            const HAS: bool = true;
        }
        <Asked<$type>>::HAS
    }};
}

macro_rules! zeros {
    ($($module:ident { $($name:ident),* }),*) => { $( $( {
        type T = $module::$name<Prime61>;
        assert!(T::zero().is_zero());
        for_all(exact_member::<T>(), |value| {
            assert_eq!(value + T::zero(), value);
            assert_eq!(T::zero() + value, value);
            assert_eq!(value.is_zero(), value == T::zero());
            assert!((value - value).is_zero());
        });
    } )* )* };
}

macro_rules! ones {
    ($($module:ident { $($name:ident),* }),*) => { $( $( {
        type T = $module::$name<Prime61>;
        assert!(T::one().is_one());
        for_all(exact_member::<T>(), |value| {
            assert_eq!(value * T::one(), value);
            assert_eq!(T::one() * value, value);
            assert_eq!(value.is_one(), value == T::one());
        });
    } )* )* };
}

#[test]
fn zeros_are_neutral() {
    zeros! {
        cga3 {
            RoundVector, Bivector, Trivector, Quadvector, DualPlane, FlatPoint, Direction, MotorGenerator,
            DualFlatPoint, DualDirection, Line, Plane, Pseudoscalar, Quaternion, DualQuaternion, Even, Multivector
        },
        pga3 { Plane, Line, Point, Pseudoscalar, MotorSum, Multivector },
        sta { Vector, Bivector, Even },
        complex { Complex }
    }
}

#[test]
fn ones_are_neutral() {
    ones! {
        cga3 { Rotor, Translator, Motor, Dilator, Similarity, Quaternion, DualQuaternion, Even, Multivector },
        pga3 { Rotor, Translator, Motor, MotorSum, Multivector },
        sta { Rotor, Even },
        complex { Complex }
    }
}

#[test]
fn where_the_laws_do_not_hold_there_is_none() {
    assert!(has!(cga3::RoundVector<f64>: Zero) && has!(cga3::Rotor<f64>: One));
    // Sums of points, rotors and translators are not of the same type.
    assert!(!has!(cga3::Point<f64>: Zero));
    assert!(!has!(cga3::Rotor<f64>: Zero));
    assert!(!has!(cga3::Translator<f64>: Zero));
    // A product of vectors is not a vector, a product of lines is not a line.
    assert!(!has!(cga3::Point<f64>: One));
    assert!(!has!(cga3::RoundVector<f64>: One));
    assert!(!has!(cga3::Line<f64>: One));
    assert!(!has!(sta::Bivector<f64>: One));
}

#[test]
fn zero_is_seen_in_each_coefficient() {
    for place in 0..8 {
        let mut values = [0.0; 8];
        values[place] = 1e-300;
        let [a, b, c, d, e, f, g, h] = values;
        assert!(!cga3::DualQuaternion::new(a, b, c, d, e, f, g, h).is_zero());
        values[place] = f64::NAN;
        let [a, b, c, d, e, f, g, h] = values;
        assert!(!cga3::DualQuaternion::new(a, b, c, d, e, f, g, h).is_zero());
    }
    assert!(cga3::Direction::new(0.0, -0.0, 0.0).is_zero());
}

#[test]
fn scalars_have_both() {
    assert!(Prime61::zero().is_zero() && Prime61::one().is_one() && !Prime61::one().is_zero());
    let lanes = Lanes::from_array([0.0, 1.0]);
    assert!(!Zero::is_zero(&lanes) && !lanes.is_one());
    assert_eq!(lanes + Lanes::zero(), lanes);
    assert_eq!(lanes * Lanes::one(), lanes);
    assert!(Zero::is_zero(&Dual::<f64, 2>::zero()) && Dual::<f64, 2>::one().is_one());
}

proptest! {
    /// Results over a wrapped number are bit-identical to those over the number.
    #[test]
    fn foreign_numbers_compute_as_themselves(
        axis in [-1.0..1.0_f64, -1.0..1.0, 0.1..1.0], angle in -6.0..6.0_f64, p in [-9.0..9.0_f64, -9.0..9.0, -9.0..9.0],
    ) {
        let plain = Translator::from_displacement(p) * Rotor::from_axis_angle(axis, angle).unwrap();
        let (wrapped_axis, wrapped_p) = (axis.map(FromFloat), p.map(FromFloat));
        let wrapped = Translator::from_displacement(wrapped_p)
            * Rotor::from_axis_angle(wrapped_axis, FromFloat(angle)).unwrap();
        let image = plain.transform(Point::from(p)).coordinates();
        prop_assert_eq!(wrapped.transform(Point::from(wrapped_p)).coordinates(), image.map(FromFloat));
        let (log, wrapped_log) = (plain.log(), wrapped.log());
        prop_assert_eq!(wrapped_log.e1i.0, log.e1i);
        prop_assert_eq!(wrapped_log.e12.0, log.e12);
        prop_assert_eq!(wrapped_log.exp().e123i().0, log.exp().e123i());
    }
}

#[test]
fn foreign_numbers_keep_infinities_and_nan() {
    assert_eq!(
        Rotor::from_axis_angle([0.0, 0.0, f64::NAN].map(FromFloat), FromFloat(1.0)),
        None
    );
    assert_eq!(
        Rotor::from_axis_angle([0.0, 0.0, 1.0].map(FromFloat), FromFloat(f64::INFINITY)),
        None
    );
    assert!(!FromFloat(f32::NAN).less_than(FromFloat(1.0)));
    assert_eq!(FromFloat::<f32>::from_f64(0.1).0, 0.1_f32);
    assert_eq!(<FromFloat<f32> as Real>::epsilon().0, f32::EPSILON);
}
