//! The items that emitted code uses. They are not for hand-written code and may change in any
//! version.

/// The procedural macros behind the macros of this crate.
pub mod macros {
    pub use ga_macros::{algebra, functions, import, product_tests, stand_ins};
}

/// Traits of other crates for a declared type.
pub use crate::__interoperate as interoperate;
/// Methods and traits that every declared type has.
pub use crate::__surface as surface;
pub use crate::element::{
    Relative, are_within, default_tolerance, divided_by_largest, grade, largest, one, parse,
    scaled_norm, select, write,
};
#[cfg(feature = "serde-1")]
pub use crate::interop::serde::coefficients;
#[cfg(feature = "approx-05")]
pub use approx_05 as approx;
#[cfg(feature = "num-traits-02")]
pub use num_traits_02 as num_traits;
#[cfg(feature = "serde-1")]
pub use serde_1 as serde;

/// A type without values, as the right operand of operators that an algebra does not declare.
#[derive(Debug)]
pub struct NoFactor<S>(core::convert::Infallible, core::marker::PhantomData<S>);
