//! Affine maps, lanes and dual numbers in serialised form and compared by approx.

use std::fmt::Debug;

use approx_05::{AbsDiffEq, RelativeEq, UlpsEq, assert_abs_diff_eq};
use ga_runtime::cga3::{Point, Rotor};
use ga_runtime::geometry::Affine;
use ga_runtime::scalar::{Dual, Lanes};
use serde_1::Serialize;
use serde_1::de::DeserializeOwned;

fn cbor<T: Serialize>(value: &T) -> Vec<u8> {
    let mut bytes = Vec::new();
    ciborium::into_writer(value, &mut bytes).expect("memory takes all");
    bytes
}

/// Writes a value as the given text, and reads it again from both forms.
fn round_trip<T: Serialize + DeserializeOwned + PartialEq + Debug>(value: T, text: &str) {
    assert_eq!(serde_json::to_string(&value).expect("a round trip"), text);
    assert_eq!(
        serde_json::from_str::<T>(text).expect("a round trip"),
        value
    );
    assert_eq!(
        ciborium::from_reader::<T, _>(&cbor(&value)[..]).expect("a round trip"),
        value
    );
}

fn refusal<T: DeserializeOwned + Debug>(text: &str) -> String {
    serde_json::from_str::<T>(text).expect_err(text).to_string()
}

const MAP: Affine<f64> = Affine::new(
    [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.5]],
    [10.0, 11.0, 12.0],
);

#[test]
fn plain_values_survive_a_round_trip() {
    round_trip(
        MAP,
        r#"{"linear":[[1.0,2.0,3.0],[4.0,5.0,6.0],[7.0,8.0,9.5]],"translation":[10.0,11.0,12.0]}"#,
    );
    round_trip(
        Lanes::from_array([1.0_f32, 2.5, -3.0, 0.0]),
        "[1.0,2.5,-3.0,0.0]",
    );
    round_trip(
        Dual::new(2.0, [0.5, 1.5]),
        r#"{"value":2.0,"derivatives":[0.5,1.5]}"#,
    );
    round_trip(
        Dual::new(Lanes::from_array([1, 2]), [Lanes::from_array([3, 4])]),
        r#"{"value":[1,2],"derivatives":[[3,4]]}"#,
    );
    // As coefficients of types of an algebra.
    round_trip(
        Point::from([1.0, 2.0, 3.0].map(|x| Dual::new(x, [1.0]))),
        concat!(
            r#"{"e1":{"value":1.0,"derivatives":[1.0]},"e2":{"value":2.0,"derivatives":[1.0]},"#,
            r#""e3":{"value":3.0,"derivatives":[1.0]}}"#,
        ),
    );
    round_trip(
        Point::from([1.0, 2.0, 3.0].map(|x| Lanes::from_array([x, -x]))),
        r#"{"e1":[1.0,-1.0],"e2":[2.0,-2.0],"e3":[3.0,-3.0]}"#,
    );
    let rotor = Rotor::from_axis_angle([0.0, 0.0, 1.0], 0.5).unwrap();
    let rotor: Rotor<Dual<f64>> = ga_runtime::Element::map(rotor, Dual::constant);
    let bytes = cbor(&rotor);
    assert_eq!(
        ciborium::from_reader::<Rotor<Dual<f64>>, _>(&bytes[..]).unwrap(),
        rotor
    );
}

/// Names are only written for people: the compact form has the numbers alone.
#[test]
fn the_compact_form_has_no_names() {
    for bytes in [cbor(&MAP), cbor(&Dual::new(2.0, [0.5]))] {
        let holds = |name: &[u8]| bytes.windows(name.len()).any(|part| part == name);
        assert!(!holds(b"linear") && !holds(b"value"));
    }
}

#[test]
fn other_shapes_are_refused() {
    assert!(refusal::<Lanes<f64, 3>>("[1, 2]").contains("invalid length 2"));
    assert!(refusal::<Lanes<f64, 3>>("[1, 2, 3, 4]").contains("invalid length 4"));
    let message = refusal::<Dual<f64, 1>>(r#"{"value": 1}"#);
    assert!(message.contains("missing field `derivatives`"), "{message}");
    let message = refusal::<Dual<f64, 1>>(r#"{"value": 1, "slope": [2]}"#);
    assert!(message.contains("unknown field `slope`"), "{message}");
    let message = refusal::<Dual<f64, 1>>(r#"{"value": 1, "value": 1}"#);
    assert!(message.contains("duplicate field `value`"), "{message}");
    let message =
        refusal::<Affine<f64>>(r#"{"linear": [[1, 0, 0], [0, 1, 0]], "translation": [0, 0, 0]}"#);
    assert!(message.contains("invalid length 2"), "{message}");
    let message = refusal::<Affine<f64>>(r#"{"translation": [0, 0, 0]}"#);
    assert!(message.contains("missing field `linear`"), "{message}");
    assert!(refusal::<Affine<f64>>("7").contains("`linear` and `translation`"));
}

#[test]
fn affine_maps_are_compared_entry_by_entry() {
    assert_abs_diff_eq!(MAP, MAP);
    for place in 0..12 {
        let changed = |by: f64| {
            let mut map = MAP;
            let entry = if place < 9 {
                &mut map.linear[place / 3][place % 3]
            } else {
                &mut map.translation[place - 9]
            };
            *entry += by;
            map
        };
        assert!(MAP.abs_diff_eq(&changed(0.5), 0.5) && !MAP.abs_diff_eq(&changed(0.5), 0.49));
        let off = changed(1e-9);
        assert!(MAP.relative_eq(&off, 0.0, 1e-8) && !MAP.relative_eq(&off, 0.0, 1e-11));
        assert!(MAP.ulps_eq(&off, 0.0, u32::MAX) && !MAP.ulps_eq(&off, 0.0, 1));
    }
}
