//! The coefficients of a type as a map or a tuple; emitted code calls these functions.

use core::fmt::{Formatter, Result as FormatResult};
use core::marker::PhantomData;

use serde_1::de::{DeserializeSeed, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_1::ser::{SerializeStruct, SerializeTuple};
use serde_1::{Deserialize, Deserializer, Serialize, Serializer};

use super::Relative;
use crate::scalar::Real;

/// Writes the coefficients of the named blades.
///
/// # Errors
/// Those of the serializer.
pub fn serialize<S: Serialize, Z: Serializer>(
    serializer: Z,
    name: &'static str,
    coefficients: &[(&'static str, &S)],
) -> Result<Z::Ok, Z::Error> {
    if serializer.is_human_readable() {
        let mut map = serializer.serialize_struct(name, coefficients.len())?;
        for (blade, coefficient) in coefficients {
            map.serialize_field(blade, coefficient)?;
        }
        return map.end();
    }
    let mut tuple = serializer.serialize_tuple(coefficients.len())?;
    for (_, coefficient) in coefficients {
        tuple.serialize_element(coefficient)?;
    }
    tuple.end()
}

/// Reads a type of which any coefficients are a member.
///
/// # Errors
/// Those of the deserializer, and coefficients that do not match the blades.
pub fn deserialize<'de, S, T, D, const N: usize>(
    deserializer: D,
    name: &'static str,
    blades: &'static [&'static str; N],
    build: impl FnOnce([S; N]) -> T,
) -> Result<T, D::Error>
where
    S: Deserialize<'de> + Copy,
    D: Deserializer<'de>,
{
    read(deserializer, name, blades).map(build)
}

/// Reads a type of unit versors.
///
/// # Errors
/// Those of [`deserialize`], and coefficients for which `is_member` is false with the tolerance √ε.
pub fn deserialize_checked<'de, S, T, D, const N: usize>(
    deserializer: D,
    name: &'static str,
    blades: &'static [&'static str; N],
    is_member: impl FnOnce([Relative<S>; N], Relative<S>) -> bool,
    build: impl FnOnce([S; N]) -> T,
) -> Result<T, D::Error>
where
    S: Deserialize<'de> + Real<Mask = bool>,
    D: Deserializer<'de>,
{
    let values = read(deserializer, name, blades)?;
    let tolerance = Relative::new(S::epsilon().sqrt());
    if is_member(values.map(Relative::new), tolerance) {
        return Ok(build(values));
    }
    Err(D::Error::custom(format_args!(
        "not a `{name}`, which is a unit versor: M ~M differs from 1 by more than the square root of \
         the scalar's epsilon, or is not finite"
    )))
}

/// Reads a type of one member.
///
/// # Errors
/// Those of the deserializer.
pub fn deserialize_unit<'de, D: Deserializer<'de>>(
    deserializer: D,
    name: &'static str,
) -> Result<(), D::Error> {
    deserializer.deserialize_unit_struct(name, Unit { name })
}

fn read<'de, S, D, const N: usize>(
    deserializer: D,
    name: &'static str,
    blades: &'static [&'static str; N],
) -> Result<[S; N], D::Error>
where
    S: Deserialize<'de> + Copy,
    D: Deserializer<'de>,
{
    let scalar = PhantomData;
    if deserializer.is_human_readable() {
        let visitor = Named {
            name,
            blades,
            scalar,
        };
        return deserializer.deserialize_struct(name, blades, visitor);
    }
    deserializer.deserialize_tuple(N, Listed { name, scalar })
}

struct Unit {
    name: &'static str,
}

impl Visitor<'_> for Unit {
    type Value = ();

    fn expecting(&self, f: &mut Formatter<'_>) -> FormatResult {
        write!(f, "nothing, for the constant `{}`", self.name)
    }

    fn visit_unit<E: Error>(self) -> Result<(), E> {
        Ok(())
    }
}

/// Coefficients by the names of their blades.
struct Named<S, const N: usize> {
    name: &'static str,
    blades: &'static [&'static str; N],
    scalar: PhantomData<S>,
}

impl<'de, S: Deserialize<'de> + Copy, const N: usize> Visitor<'de> for Named<S, N> {
    type Value = [S; N];

    fn expecting(&self, f: &mut Formatter<'_>) -> FormatResult {
        write!(
            f,
            "a map from the {N} blades of `{}` to coefficients",
            self.name
        )
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<[S; N], A::Error> {
        let mut found = [None; N];
        while let Some(place) = map.next_key_seed(Name(self.blades))? {
            if found[place].is_some() {
                return Err(A::Error::duplicate_field(self.blades[place]));
            }
            found[place] = Some(map.next_value()?);
        }
        collected(found).map_err(|missing| A::Error::missing_field(self.blades[missing]))
    }
}

/// The index of a blade, or of another part, from its name.
pub struct Name<const N: usize>(pub &'static [&'static str; N]);

impl<'de, const N: usize> DeserializeSeed<'de> for Name<N> {
    type Value = usize;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<usize, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl<const N: usize> Visitor<'_> for Name<N> {
    type Value = usize;

    fn expecting(&self, f: &mut Formatter<'_>) -> FormatResult {
        write!(f, "one of the names {:?}", self.0)
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<usize, E> {
        let place = self.0.iter().position(|blade| *blade == name);
        place.ok_or_else(|| E::unknown_field(name, self.0))
    }
}

/// Coefficients in the order of the declaration.
pub(super) struct Listed<S, const N: usize> {
    pub(super) name: &'static str,
    pub(super) scalar: PhantomData<S>,
}

impl<'de, S: Deserialize<'de> + Copy, const N: usize> Visitor<'de> for Listed<S, N> {
    type Value = [S; N];

    fn expecting(&self, f: &mut Formatter<'_>) -> FormatResult {
        write!(f, "the {N} coefficients of `{}`", self.name)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<[S; N], A::Error> {
        let mut found = [None; N];
        for value in &mut found {
            *value = list.next_element()?;
        }
        if list.next_element::<IgnoredAny>()?.is_some() {
            return Err(A::Error::invalid_length(N + 1, &self));
        }
        collected(found).map_err(|missing| A::Error::invalid_length(missing, &self))
    }
}

/// All the values, or the index of the first that is missing.
fn collected<S: Copy, const N: usize>(found: [Option<S>; N]) -> Result<[S; N], usize> {
    let first = found.iter().flatten().next().copied().ok_or(0_usize)?;
    let mut values = [first; N];
    for (place, value) in found.into_iter().enumerate() {
        values[place] = value.ok_or(place)?;
    }
    Ok(values)
}
