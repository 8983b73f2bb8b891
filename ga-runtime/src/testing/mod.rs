//! The tools with which Nullcone is tested, for the tests of crates that build on it.
//!
//! - [`assert_close!`] compares floating-point results of types that implement [`Coefficients`].
//! - [`strategy`] holds proptest strategies for scalars and for multivectors of any algebra,
//!   [`member`] one for every declared type, [`cga3`] those for geometric objects, special
//!   positions included. [`sample`] draws values of any of them, the same values for the same seed.
//! - [`product_tests!`] emits the tests of an algebra's products from its declaration.
//! - [`bench_product!`] registers a criterion group for products of any algebra.
//! - [`Prime61`] is the scalar of exact tests, [`dense`] the reference to test against.
//!
//! An exact test of an identity, in an algebra given by its signature:
//!
//! ```
//! use ga_runtime::testing::{Prime61, dense::Algebra, strategy};
//! use proptest::prelude::*;
//!
//! # fn main() -> Result<(), ga_runtime::dense::DenseError> {
//! let spacetime = Algebra::<Prime61>::with_signature(1, 3, 0)?;
//! let vector = strategy::vector(&spacetime, strategy::prime());
//! proptest!(|(a in vector.clone(), b in vector)| {
//!     // Vectors anticommute up to twice their inner product.
//!     prop_assert_eq!(&a * &b + &b * &a, (&a | &b).scale(2.into()));
//! });
//! # Ok(())
//! # }
//! ```

/// The crate behind the strategies, in the version that they are written for.
pub use proptest;

mod bench;
pub mod cga3;
mod close;
mod declared;
mod quiet;
mod sample;
pub mod strategy;
mod written;

#[doc(inline)]
pub use crate::__bench_product as bench_product;
#[doc(inline)]
pub use crate::__product_tests as product_tests;
pub use crate::assert_close;
pub use crate::dense;
pub use crate::scalar::Prime61;
#[doc(hidden)]
pub use bench::{OPERANDS, operand, pass};
pub use close::{Coefficients, Deviation, check_close};
#[doc(hidden)]
pub use declared::Members;
pub use declared::{algebra_of, constant_to_dense, exact_member, for_all, member, only, to_dense};
pub use sample::sample;
#[doc(hidden)]
pub use written::{
    assert_same, blades, check_coefficients, check_linear, check_product, for_all_numbers, members,
};
