//! serde 1: serialization of every type, those of your own algebras included.
//!
//! # The form
//!
//! In human-readable formats, such as JSON, a type is a map from the names of the stored blades to
//! their coefficients; blades that are constant or derived are not written. In other formats it is
//! a tuple of the same numbers in the order of the declaration, without a length or names: 12 bytes
//! for a [`Point`](crate::cga3::Point) in `f32`. Types without stored blades, such as
//! [`Infinity`](crate::cga3::Infinity), are units.
//!
//! ```
//! use ga_runtime::cga3::{Point, Quaternion, Rotor};
//!
//! let p = Point::new(1.0, 2.0, 3.0);
//! assert_eq!(serde_json::to_string(&p).unwrap(), r#"{"e1":1.0,"e2":2.0,"e3":3.0}"#);
//! assert_eq!(serde_json::from_str::<Point<f64>>(r#"{"e3": 3, "e1": 1, "e2": 2}"#).unwrap(), p);
//!
//! let error = serde_json::from_str::<Point<f64>>(r#"{"e1": 1, "e2": 2}"#).unwrap_err();
//! assert!(error.to_string().contains("`e3`"));
//!
//! // Half the identity is not a rotor. It is read as a sum of rotors and then normalised.
//! let half = r#"{"scalar": 0.5, "e12": 0, "e13": 0, "e23": 0}"#;
//! let error = serde_json::from_str::<Rotor<f64>>(half).unwrap_err();
//! assert!(error.to_string().contains("not a `Rotor`"));
//! let sum: Quaternion<f64> = serde_json::from_str(half).unwrap();
//! assert_eq!(Rotor::normalize(sum), Some(Rotor::default()));
//! ```
//!
//! Scalars that are not plain numbers have forms of their own, and so has [`Affine`]:
//!
//! | type | human-readable | otherwise |
//! | --- | --- | --- |
//! | [`Lanes`] | a list of its N numbers | the same |
//! | [`Dual`] | a map of `value` and `derivatives`, a list | the same 1 + N numbers |
//! | [`Affine`] | a map of `linear`, by rows, and `translation` | the same 12 numbers |
//!
//! ```
//! use ga_runtime::geometry::Affine;
//! use ga_runtime::scalar::{Dual, Lanes};
//!
//! let lanes = Lanes::from_array([1.5, 2.0]);
//! assert_eq!(serde_json::to_string(&lanes).unwrap(), "[1.5,2.0]");
//! let dual = Dual::new(4.0, [1.0, 0.5]);
//! let text = r#"{"value":4.0,"derivatives":[1.0,0.5]}"#;
//! assert_eq!(serde_json::to_string(&dual).unwrap(), text);
//! assert_eq!(serde_json::from_str::<Dual<f64, 2>>(text).unwrap(), dual);
//! let map = Affine::scaling([1.0, 2.0, 3.0]);
//! let text = serde_json::to_string(&map).unwrap();
//! assert_eq!(serde_json::from_str::<Affine<f64>>(&text).unwrap(), map);
//! ```
//!
//! serde_json reads numbers with an error in their last digit, unless its feature `float_roundtrip`
//! is enabled.
//!
//! # What is refused
//!
//! - In a map, a blade that the type does not store, a missing blade and a repeated blade. The
//!   error names the blade. In a tuple, too few or too many numbers.
//! - Coefficients that break the facts of the type. A unit versor is read where every coefficient
//!   of `M ~M − 1` is within √ε of zero, ε being [`Real::epsilon`](crate::scalar::Real::epsilon) of
//!   the scalar. Where the products of which such a coefficient is the sum are large, as in the
//!   Study condition of a motor far from the origin, that is relative to half the sum of their
//!   sizes. Reading does not change coefficients. A versor whose coefficients have been rounded to
//!   fewer digits, such as one written in `f32` and read in `f64`, can be read as the hull of its
//!   type (a [`Rotor`](crate::cga3::Rotor) as a [`Quaternion`](crate::cga3::Quaternion)) and
//!   normalised.
//! - Infinities and NaN in a type whose facts restrict it. Other types accept what the format and
//!   the scalar accept: JSON has neither, binary formats have both.

#[doc(hidden)]
pub mod coefficients;
mod plain;

pub use crate::element::Relative;

#[cfg(doc)]
use crate::{
    geometry::Affine,
    scalar::{Dual, Lanes},
};

/// Emits serialization and deserialization for a declared type.
#[doc(hidden)]
#[macro_export]
macro_rules! __serialize {
    (constant $name:ident $text:literal) => {
        impl $crate::__private::serde::Serialize for $name {
            fn serialize<Z: $crate::__private::serde::Serializer>(
                &self, serializer: Z,
            ) -> ::core::result::Result<Z::Ok, Z::Error> {
                <Z as $crate::__private::serde::Serializer>::serialize_unit_struct(serializer, $text)
            }
        }

        impl<'de> $crate::__private::serde::Deserialize<'de> for $name {
            fn deserialize<D: $crate::__private::serde::Deserializer<'de>>(
                deserializer: D,
            ) -> ::core::result::Result<Self, D::Error> {
                match $crate::__private::coefficients::deserialize_unit(deserializer, $text) {
                    ::core::result::Result::Ok(()) => ::core::result::Result::Ok($name),
                    ::core::result::Result::Err(error) => ::core::result::Result::Err(error),
                }
            }
        }
    };
    (checked $name:ident $text:literal { $($field:ident $place:tt $blade:literal),* } $one:tt) => {
        $crate::__serialize! { write $name $text { $($field $blade),* } }

        impl<'de, S> $crate::__private::serde::Deserialize<'de> for $name<S>
        where
            S: $crate::__private::serde::Deserialize<'de>
                + $crate::scalar::Real<Mask = ::core::primitive::bool>,
        {
            fn deserialize<D: $crate::__private::serde::Deserializer<'de>>(
                deserializer: D,
            ) -> ::core::result::Result<Self, D::Error> {
                $crate::__private::coefficients::deserialize_checked(
                    deserializer,
                    $text,
                    &[$($blade),*],
                    |values, tolerance| {
                        $name::<$crate::interop::serde::Relative<S>>::try_new(
                            $(values[$place],)* tolerance
                        ).is_some()
                    },
                    |values| $name { $($field: values[$place]),* },
                )
            }
        }
    };
    (parameters $name:ident $text:literal { $($field:ident $place:tt $label:literal [$path:ty]),* }) => {
        impl<S> $crate::__private::serde::Serialize for $name<S>
        where
            $($path: $crate::__private::serde::Serialize),*
        {
            fn serialize<Z: $crate::__private::serde::Serializer>(
                &self, serializer: Z,
            ) -> ::core::result::Result<Z::Ok, Z::Error> {
                use $crate::__private::serde::ser::{SerializeStruct, SerializeTuple};
                const COUNT: ::core::primitive::usize = [$($label),*].len();
                if $crate::__private::serde::Serializer::is_human_readable(&serializer) {
                    let mut map = $crate::__private::serde::Serializer::serialize_struct(
                        serializer, $text, COUNT,
                    )?;
                    $(map.serialize_field($label, &self.$field)?;)*
                    return SerializeStruct::end(map);
                }
                let mut tuple = $crate::__private::serde::Serializer::serialize_tuple(
                    serializer, COUNT,
                )?;
                $(tuple.serialize_element(&self.$field)?;)*
                SerializeTuple::end(tuple)
            }
        }

        impl<'de, S> $crate::__private::serde::Deserialize<'de> for $name<S>
        where
            $($path: $crate::__private::serde::Deserialize<'de>),*
        {
            fn deserialize<D: $crate::__private::serde::Deserializer<'de>>(
                deserializer: D,
            ) -> ::core::result::Result<Self, D::Error> {
                use $crate::__private::serde::de::{Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
                const LABELS: &[&::core::primitive::str; [$($label),*].len()] = &[$($label),*];
                struct Parameters_<S_>(::core::marker::PhantomData<S_>);
                impl<'de, S> Visitor<'de> for Parameters_<S>
                where
                    $($path: $crate::__private::serde::Deserialize<'de>),*
                {
                    type Value = $name<S>;
                    fn expecting(
                        &self, f: &mut ::core::fmt::Formatter<'_>,
                    ) -> ::core::fmt::Result {
                        ::core::write!(f, "the parameters {:?} of `{}`", LABELS, $text)
                    }
                    fn visit_map<A: MapAccess<'de>>(
                        self, mut map: A,
                    ) -> ::core::result::Result<Self::Value, A::Error> {
                        $(let mut $field = ::core::option::Option::None;)*
                        while let ::core::option::Option::Some(place) =
                            map.next_key_seed($crate::__private::coefficients::Name(LABELS))?
                        {
                            $(if place == $place {
                                if $field.is_some() {
                                    return ::core::result::Result::Err(
                                        A::Error::duplicate_field($label),
                                    );
                                }
                                $field = ::core::option::Option::Some(map.next_value()?);
                            })*
                        }
                        ::core::result::Result::Ok($name {
                            $($field: match $field {
                                ::core::option::Option::Some(value) => value,
                                ::core::option::Option::None => {
                                    return ::core::result::Result::Err(
                                        A::Error::missing_field($label),
                                    );
                                }
                            }),*
                        })
                    }
                    fn visit_seq<A: SeqAccess<'de>>(
                        self, mut list: A,
                    ) -> ::core::result::Result<Self::Value, A::Error> {
                        let value = $name {
                            $($field: match list.next_element()? {
                                ::core::option::Option::Some(value) => value,
                                ::core::option::Option::None => {
                                    return ::core::result::Result::Err(
                                        A::Error::invalid_length($place, &self),
                                    );
                                }
                            }),*
                        };
                        if list.next_element::<IgnoredAny>()?.is_some() {
                            let count = LABELS.len() + 1;
                            return ::core::result::Result::Err(
                                A::Error::invalid_length(count, &self),
                            );
                        }
                        ::core::result::Result::Ok(value)
                    }
                }
                let visitor = Parameters_(::core::marker::PhantomData);
                if deserializer.is_human_readable() {
                    return deserializer.deserialize_struct($text, LABELS, visitor);
                }
                deserializer.deserialize_tuple(LABELS.len(), visitor)
            }
        }
    };
    (write $name:ident $text:literal { $($field:ident $blade:literal),* }) => {
        impl<S: $crate::__private::serde::Serialize> $crate::__private::serde::Serialize for $name<S> {
            fn serialize<Z: $crate::__private::serde::Serializer>(
                &self, serializer: Z,
            ) -> ::core::result::Result<Z::Ok, Z::Error> {
                $crate::__private::coefficients::serialize(
                    serializer,
                    $text,
                    &[$(($blade, &self.$field)),*],
                )
            }
        }
    };
    ($role:ident $name:ident $text:literal { $($field:ident $place:tt $blade:literal),* } $one:tt) => {
        $crate::__serialize! { write $name $text { $($field $blade),* } }

        impl<'de, S> $crate::__private::serde::Deserialize<'de> for $name<S>
        where
            S: $crate::__private::serde::Deserialize<'de> + ::core::marker::Copy,
        {
            fn deserialize<D: $crate::__private::serde::Deserializer<'de>>(
                deserializer: D,
            ) -> ::core::result::Result<Self, D::Error> {
                $crate::__private::coefficients::deserialize(
                    deserializer,
                    $text,
                    &[$($blade),*],
                    |values| $name { $($field: values[$place]),* },
                )
            }
        }
    };
}
