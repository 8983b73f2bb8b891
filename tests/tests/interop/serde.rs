//! serde: the serialised form against text and numbers written by hand, a round trip of every type,
//! and errors.

use std::fmt::Debug;

use crate::every_type::every_type;
use ga_runtime::Element;
use ga_runtime::cga3::{Dilator, Infinity, Motor, Point, Rotor, Similarity, Translator};
use ga_runtime::testing::{for_all, member, strategy};
use ga_runtime::{cga2, cga3, pga2, pga3, sta, vga2, vga3};
use nullcone_embedder::sta as spacetime;
use proptest::prelude::*;
use serde_1::Serialize;
use serde_1::de::DeserializeOwned;

/// Algebras of this crate, with vectors in another order, names that are keywords, and a type that
/// stores few coefficients.
mod own {
    ga_runtime::algebra! {
        pub(super) mod space {
            basis e1, e2, e3;
            signature 3;

            struct Vector { e1, e2, e3 }
            struct Bivector { e31, e12, e23 }
            #[hull(Vector)]
            struct Lifted { e1, e2 = 2, e3 = e1*e1 }
            struct E3 { e3 = 1 }
            products { wedge(Vector, Vector) -> Bivector; }
        }
    }

    ga_runtime::algebra! {
        pub(super) mod words {
            basis r#in, r#as;
            signature 2;

            struct r#Move { r#in, r#as }
            products { left_contraction(r#Move, r#Move) -> Scalar; }
        }
    }
}
use own::space::{Bivector, E3, Lifted};
use own::words::Move;

fn json<T: Serialize>(value: &T) -> String {
    serde_json::to_string(value).expect("numbers are written")
}

fn cbor<T: Serialize>(value: &T) -> Vec<u8> {
    let mut bytes = Vec::new();
    ciborium::into_writer(value, &mut bytes).expect("memory takes all");
    bytes
}

/// The message of the error with which JSON text is refused.
fn refusal<T: DeserializeOwned + Debug>(text: &str) -> String {
    serde_json::from_str::<T>(text).expect_err(text).to_string()
}

fn from_cbor<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, String> {
    ciborium::from_reader(bytes).map_err(|error| error.to_string())
}

#[test]
fn text_names_the_stored_blades() {
    assert_eq!(
        json(&Point::new(1.0, -2.5, 1e300)),
        r#"{"e1":1.0,"e2":-2.5,"e3":1e+300}"#
    );
    assert_eq!(
        json(&Translator::from_displacement([2.0_f32, 0.0, -4.0])),
        r#"{"e1i":-1.0,"e2i":-0.0,"e3i":2.0}"#
    );
    assert_eq!(
        json(&Motor::<f64>::default()),
        r#"{"scalar":1.0,"e12":0.0,"e13":0.0,"e23":0.0,"e1i":0.0,"e2i":0.0,"e3i":0.0,"e123i":0.0}"#
    );
    assert_eq!(
        json(&pga3::Plane::new(1, 2, 3, 4)),
        r#"{"e1":1,"e2":2,"e3":3,"e0":4}"#
    );
    assert_eq!(
        json(&Bivector::new(1, 2, 3)),
        r#"{"e31":1,"e12":2,"e23":3}"#
    );
    assert_eq!(json(&Move::new(1, 2)), r#"{"in":1,"as":2}"#);
    assert_eq!(json(&Lifted::new(5)), r#"{"e1":5}"#);
    assert_eq!(
        json(&spacetime::Vector::new(0, 1, 2, 3)),
        r#"{"g0":0,"g1":1,"g2":2,"g3":3}"#
    );
    assert_eq!(json(&(Infinity, E3)), "[null,null]");
}

#[test]
fn text_is_read_in_any_order() {
    let read: Bivector<i64> = serde_json::from_str(r#"{"e12": 2, "e23": 3, "e31": 1}"#).unwrap();
    assert_eq!(read, Bivector::new(1, 2, 3));
    let read: Move<i64> = serde_json::from_str(r#"{"as": 2, "in": 1}"#).unwrap();
    assert_eq!(read, Move::new(1, 2));
    let read: Lifted<f64> = serde_json::from_str(r#"{"e1": 3}"#).unwrap();
    assert_eq!((read.e1(), read.e2(), read.e3()), (3.0, 2.0, 9.0));
    let [a, b]: [Infinity; 2] = serde_json::from_str("[null, null]").unwrap();
    assert_eq!(a, b);
}

/// CBOR by its standard: an array of three is 0x83, a double 0xfb and eight bytes.
#[test]
fn binary_form_is_a_tuple_of_numbers() {
    let p = Point::new(1.5_f64, -2.1, 1e300);
    let mut expected = vec![0x83];
    for x in p.coordinates() {
        expected.push(0xfb);
        expected.extend(x.to_be_bytes());
    }
    // 1.5 is a half-precision number, and CBOR is written as short as it can be.
    expected.splice(1..10, [0xf9, 0x3e, 0x00]);
    assert_eq!(cbor(&p), expected);
    assert_eq!(from_cbor(&expected), Ok(p));
    assert_eq!(cbor(&Infinity), [0xf6]);
    assert_eq!(from_cbor(&[0xf6]), Ok(Infinity));
}

fn comes_back<T>()
where
    T: Element<Scalar = f64> + Serialize + DeserializeOwned + PartialEq + Debug,
{
    for_all(member::<T>(strategy::float(0.9)), |value| {
        assert_eq!(from_cbor(&cbor(&value)), Ok(value));
        let read: T = serde_json::from_str(&json(&value)).expect("what was written is read");
        for place in 0..T::BLADES.len() {
            let (a, b) = (value.number(place), read.number(place));
            assert!((a - b).abs() <= 2.0 * f64::EPSILON * a.abs(), "{a} {b}");
        }
    });
}

macro_rules! all_come_back {
    ($($module:ident { $($name:ident),* }),*) => { $( $(
        comes_back::<$module::$name<f64>>();
    )* )* };
}

#[test]
fn every_type_comes_back() {
    every_type!(all_come_back);
    all_come_back! { spacetime { Vector, Bivector, Even, Rotor } }
    comes_back::<Bivector<f64>>();
    comes_back::<Move<f64>>();
    comes_back::<Lifted<f64>>();
}

#[test]
fn blades_that_are_wrong_are_named() {
    let error = refusal::<Point<f64>>(r#"{"e1": 1, "e2": 2, "ei": 3}"#);
    assert!(
        error.contains("`ei`") && error.contains("`e1`, `e2`, `e3`"),
        "{error}"
    );
    let error = refusal::<Point<f64>>(r#"{"e1": 1, "e3": 2}"#);
    assert!(
        error.contains("missing") && error.contains("`e2`"),
        "{error}"
    );
    let error = refusal::<Point<f64>>(r#"{"e1": 1, "e2": 2, "e3": 3, "e2": 2}"#);
    assert!(
        error.contains("duplicate") && error.contains("`e2`"),
        "{error}"
    );
    let error = refusal::<Point<f64>>("{}");
    assert!(error.contains("`e1`"), "{error}");
    // JSON has names of fields, so they must be given.
    let error = refusal::<Point<f64>>("[1, 2, 3]");
    assert!(error.contains("`Point`"), "{error}");
    let error = refusal::<Point<f64>>(r#"{"e1": null, "e2": 2, "e3": 3}"#);
    assert!(error.contains("null"), "{error}");
    let error = refusal::<Infinity>("1");
    assert!(error.contains("`Infinity`"), "{error}");
}

#[test]
fn tuples_of_another_length_are_refused() {
    for length in [0, 1, 2, 4, 5] {
        let list = vec![1.0; length];
        let error = from_cbor::<Point<f64>>(&cbor(&list)).expect_err("three numbers make a point");
        assert!(error.contains("`Point`"), "{error}");
    }
    assert_eq!(
        from_cbor(&cbor(&[1.0, 2.0, 3.0])),
        Ok(Point::new(1.0, 2.0, 3.0))
    );
}

#[test]
fn facts_are_checked() {
    let rotor = |scalar: f64, e12: f64| {
        let text = format!(r#"{{"scalar": {scalar}, "e12": {e12}, "e13": 0, "e23": 0}}"#);
        serde_json::from_str::<Rotor<f64>>(&text).map_err(|error| error.to_string())
    };
    assert!(rotor(0.6, 0.8).is_ok() && rotor(-0.6, 0.8).is_ok());
    // M ~M − 1 is 2·0.6·δ to first order; √ε is 1.49·10⁻⁸.
    assert!(rotor(0.6 + 1.2e-8, 0.8).is_ok());
    for (scalar, e12) in [(0.6 + 1.3e-8, 0.8), (0.6, 0.7), (0.0, 0.0), (1e200, 0.0)] {
        let error = rotor(scalar, e12).expect_err("no unit versor");
        assert!(
            error.contains("`Rotor`") && error.contains("M ~M"),
            "{error}"
        );
    }

    // The Study condition: a translator's coefficient in e123i.
    let motor = |e123i: f64| {
        let values = [1.0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, e123i];
        from_cbor::<Motor<f64>>(&cbor(&values))
    };
    assert!(motor(0.0).is_ok() && motor(5e-9).is_ok());
    let error = motor(1e-7).expect_err("the Study condition does not hold");
    assert!(error.contains("`Motor`"), "{error}");

    // cosh² − sinh² of a large scaling is a difference of large numbers.
    let dilator = Dilator::from_factor(1e12_f64).unwrap();
    assert_eq!(from_cbor(&cbor(&dilator)), Ok(dilator));
    let error = from_cbor::<Dilator<f64>>(&cbor(&[dilator.scalar() * 1.000_001, dilator.eoi()]))
        .expect_err("no unit versor");
    assert!(error.contains("`Dilator`"), "{error}");

    // A Lorentz transformation of another crate's algebra.
    let boost = [0.5_f64.cosh(), 0.5_f64.sinh(), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    assert!(from_cbor::<spacetime::Rotor<f64>>(&cbor(&boost)).is_ok());
    let error =
        from_cbor::<spacetime::Rotor<f64>>(&cbor(&boost.map(|x| x * 1.1))).expect_err("1.21");
    assert!(error.contains("`Rotor`"), "{error}");
}

#[test]
fn numbers_that_are_not_finite_are_refused_where_facts_hold() {
    for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..4 {
            let mut values = [1.0, 0.0, 0.0, 0.0];
            values[place] = odd;
            let error = from_cbor::<Rotor<f64>>(&cbor(&values)).expect_err("no rotor");
            assert!(error.contains("not finite"), "{error}");
        }
        for place in 0..8 {
            let mut values = [0.0; 8];
            values[0] = 1.0;
            values[place] = odd;
            assert!(from_cbor::<Motor<f64>>(&cbor(&values)).is_err(), "{place}");
        }
        // A point may have any coordinates, and binary formats keep them.
        let p = from_cbor::<Point<f64>>(&cbor(&[odd, 0.0, 0.0])).expect("a format with NaN");
        assert_eq!(p.e1().to_bits(), odd.to_bits());
    }
    // JSON writes null for numbers that it cannot represent, and null is not a number.
    let text = json(&Point::new(f64::NAN, 0.0, 0.0));
    assert!(refusal::<Point<f64>>(&text).contains("null"));
}

proptest! {
    /// Everything that the library constructs is accepted when read, however far from the origin it
    /// is.
    #[test]
    fn far_motions_survive_a_round_trip(
        axis in [-1.0..1.0_f64, -1.0..1.0, 0.1..1.0], angle in -6.0..6.0_f64,
        direction in [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0], exponent in 0.0..12.0_f64, scale in -9.0..9.0_f64,
    ) {
        let turn = Rotor::from_axis_angle(axis, angle).unwrap();
        let shift = Translator::from_displacement(direction.map(|x| x * 10.0_f64.powf(exponent)));
        let motor: Motor<f64> = shift * turn * shift * turn;
        prop_assert_eq!(from_cbor(&cbor(&motor)), Ok(motor));
        let similarity: Similarity<f64> = motor * Dilator::from_factor(10.0_f64.powf(scale)).unwrap();
        prop_assert_eq!(from_cbor(&cbor(&similarity)), Ok(similarity));

        let turn = Rotor::from_axis_angle(axis.map(|x| x as f32), angle as f32).unwrap();
        let shift = Translator::from_displacement(direction.map(|x| (x * 10.0_f64.powf(exponent / 2.0)) as f32));
        let motor: Motor<f32> = shift * turn * shift * turn;
        prop_assert_eq!(from_cbor(&cbor(&motor)), Ok(motor));
    }
}
