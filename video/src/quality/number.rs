//! Numbers that may be infinite, as values of JSON, which has no infinite numbers.

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A number, or in words one that JSON does not have.
#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Number {
    Finite(f64),
    Word(String),
}

impl Number {
    fn of(number: f64) -> Self {
        match number.is_finite() {
            true => Self::Finite(number),
            false => Self::Word(number.to_string()),
        }
    }

    fn value<E: Error>(self) -> Result<f64, E> {
        match self {
            Self::Finite(number) => Ok(number),
            Self::Word(word) => word.parse().map_err(E::custom),
        }
    }
}

pub(super) fn serialize<S: Serializer>(number: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    Number::of(*number).serialize(serializer)
}

pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    Number::deserialize(deserializer)?.value()
}

/// Two of them, where there are any.
pub(super) mod pair {
    use super::{Deserialize, Deserializer, Number, Serialize, Serializer};

    pub(in crate::quality) fn serialize<S: Serializer>(
        pair: &Option<[f64; 2]>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        pair.map(|pair| pair.map(Number::of)).serialize(serializer)
    }

    pub(in crate::quality) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Option<[f64; 2]>, D::Error> {
        let pair: Option<[Number; 2]> = Option::deserialize(deserializer)?;
        let pair = pair.map(|[first, second]| Ok([first.value()?, second.value()?]));
        pair.transpose()
    }
}
