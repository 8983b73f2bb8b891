//! Traits of other crates for every declared type, those of users included: `algebra!` passes all
//! types to this macro, each in braces.
//!
//! ```text
//! constant Infinity "Infinity"
//! free     Point "Point" { e1 0 "e1", e2 1 "e2", e3 2 "e3" } []
//! linear   Quaternion "Quaternion" { scalar 0 "scalar", … } [scalar one, e12 zero, …]
//! checked  Rotor "Rotor" { scalar 0 "scalar", … } [scalar one, e12 zero, …]
//! ```
//!
//! The braces contain the stored coefficients; `linear` means that sums and multiples stay in the
//! type, `checked` that its facts restrict the coefficients. The brackets contain the coefficients
//! of 1, if 1 is a member and products of members are members.

/// Emits nothing: the features are off.
#[cfg(not(any(feature = "approx-05", feature = "num-traits-02", feature = "serde-1")))]
#[doc(hidden)]
#[macro_export]
macro_rules! __interoperate {
    ($($description:tt)*) => {};
}

/// Emits the traits of the enabled features.
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
