//! Serialization of affine maps, lanes and dual numbers.

use core::fmt::{Formatter, Result as FormatResult};
use core::marker::PhantomData;

use serde_1::de::{Error, MapAccess, Visitor};
use serde_1::ser::{SerializeStruct, SerializeTuple};
use serde_1::{Deserialize, Deserializer, Serialize, Serializer};

use super::coefficients::{Listed, Name};
use crate::geometry::Affine;
use crate::scalar::{Dual, Lanes, Ring};

/// In human-readable formats a map of `linear`, the rows of L, and `translation`; otherwise the
/// same twelve numbers.
impl<S: Serialize> Serialize for Affine<S> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        let parts = (&self.linear, &self.translation);
        serialize_parts(serializer, "Affine", AFFINE, parts)
    }
}

impl<'de, S: Deserialize<'de> + Ring> Deserialize<'de> for Affine<S> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (linear, translation) = deserialize_parts(deserializer, "Affine", AFFINE)?;
        Ok(Self::new(linear, translation))
    }
}

/// A list of N numbers.
impl<T: Serialize + Copy, const N: usize> Serialize for Lanes<T, N> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        List(self.to_array()).serialize(serializer)
    }
}

impl<'de, T: Deserialize<'de> + Copy, const N: usize> Deserialize<'de> for Lanes<T, N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        List::deserialize(deserializer).map(|List(lanes)| Self::from_array(lanes))
    }
}

/// In human-readable formats a map of `value` and `derivatives`, a list; otherwise the same
/// numbers.
impl<S: Serialize + Copy, const N: usize> Serialize for Dual<S, N> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        let parts = (&self.value, &List(self.derivatives));
        serialize_parts(serializer, "Dual", DUAL, parts)
    }
}

impl<'de, S: Deserialize<'de> + Copy, const N: usize> Deserialize<'de> for Dual<S, N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (value, List(derivatives)) = deserialize_parts(deserializer, "Dual", DUAL)?;
        Ok(Self::new(value, derivatives))
    }
}

type Names = &'static [&'static str; 2];
const AFFINE: Names = &["linear", "translation"];
const DUAL: Names = &["value", "derivatives"];

fn serialize_parts<A: Serialize, B: Serialize, Z: Serializer>(
    serializer: Z,
    name: &'static str,
    names: Names,
    (first, second): (&A, &B),
) -> Result<Z::Ok, Z::Error> {
    if serializer.is_human_readable() {
        let mut map = serializer.serialize_struct(name, 2)?;
        map.serialize_field(names[0], first)?;
        map.serialize_field(names[1], second)?;
        return map.end();
    }
    (first, second).serialize(serializer)
}

fn deserialize_parts<'de, A: Deserialize<'de>, B: Deserialize<'de>, D: Deserializer<'de>>(
    deserializer: D,
    name: &'static str,
    names: Names,
) -> Result<(A, B), D::Error> {
    if deserializer.is_human_readable() {
        let parts = PhantomData;
        return deserializer.deserialize_struct(name, names, Parts { name, names, parts });
    }
    Deserialize::deserialize(deserializer)
}

/// Two named parts.
struct Parts<A, B> {
    name: &'static str,
    names: Names,
    parts: PhantomData<(A, B)>,
}

impl<'de, A: Deserialize<'de>, B: Deserialize<'de>> Visitor<'de> for Parts<A, B> {
    type Value = (A, B);

    fn expecting(&self, f: &mut Formatter<'_>) -> FormatResult {
        let [first, second] = self.names;
        write!(f, "`{}`, a map of `{first}` and `{second}`", self.name)
    }

    fn visit_map<M: MapAccess<'de>>(self, mut map: M) -> Result<(A, B), M::Error> {
        let [first, second] = *self.names;
        let (mut a, mut b) = (None, None);
        while let Some(name) = map.next_key_seed(Name(self.names))? {
            let is_repeated = if name == 0 { a.is_some() } else { b.is_some() };
            if is_repeated {
                return Err(M::Error::duplicate_field(self.names[name]));
            }
            if name == 0 {
                a = Some(map.next_value()?);
            } else {
                b = Some(map.next_value()?);
            }
        }
        Ok((
            a.ok_or_else(|| M::Error::missing_field(first))?,
            b.ok_or_else(|| M::Error::missing_field(second))?,
        ))
    }
}

/// An array of any length, as a tuple.
struct List<S, const N: usize>([S; N]);

impl<S: Serialize, const N: usize> Serialize for List<S, N> {
    fn serialize<Z: Serializer>(&self, serializer: Z) -> Result<Z::Ok, Z::Error> {
        let mut tuple = serializer.serialize_tuple(N)?;
        for number in &self.0 {
            tuple.serialize_element(number)?;
        }
        tuple.end()
    }
}

impl<'de, S: Deserialize<'de> + Copy, const N: usize> Deserialize<'de> for List<S, N> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (name, scalar) = ("a list", PhantomData);
        deserializer
            .deserialize_tuple(N, Listed { name, scalar })
            .map(Self)
    }
}
