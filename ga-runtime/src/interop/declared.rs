//! Traits of other crates for every declared type, that of users too: `algebra!` hands all to this
//! macro, each in braces.
//!
//! ```text
//! constant Infinity "Infinity"
//! free     Point "Point" { e1 0 "e1", e2 1 "e2", e3 2 "e3" } []
//! linear   Quaternion "Quaternion" { scalar 0 "scalar", … } [scalar one, e12 zero, …]
//! checked  Rotor "Rotor" { scalar 0 "scalar", … } [scalar one, e12 zero, …]
//! ```
//!
//! In braces stand the stored coefficients; `linear` says that sums and multiples stay in the type,
//! `checked` that its facts restrict the coefficients. In brackets stand those of 1, where it is a
//! member and members multiply to members.

/// Emits nothing: the features are off.
#[cfg(not(any(feature = "approx-05", feature = "num-traits-02", feature = "serde-1")))]
#[doc(hidden)]
#[macro_export]
macro_rules! __interoperate {
    ($($description:tt)*) => {};
}

/// Emits what the features ask for.
#[cfg(any(feature = "approx-05", feature = "num-traits-02", feature = "serde-1"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __interoperate {
    ($({ $($description:tt)* })*) => { $(
        $crate::__approximate! { $($description)* }
        $crate::__count! { $($description)* }
        $crate::__serialize! { $($description)* }
    )* };
}

/// Emits nothing: the feature is off.
#[cfg(not(feature = "approx-05"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __approximate {
    ($($description:tt)*) => {};
}

/// Emits nothing: the feature is off.
#[cfg(not(feature = "num-traits-02"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __count {
    ($($description:tt)*) => {};
}

/// Emits nothing: the feature is off.
#[cfg(not(feature = "serde-1"))]
#[doc(hidden)]
#[macro_export]
macro_rules! __serialize {
    ($($description:tt)*) => {};
}
