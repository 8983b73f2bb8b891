//! The traits of coefficients, in three levels, and the scalar types.
//!
//! | trait | adds | sufficient for |
//! | --- | --- | --- |
//! | [`Ring`] | `+ - *`, integers | products of multivectors with stored blades |
//! | [`Field`] | `/`, fractions | derived blades (`x²/2`), inverses, duals in any metric |
//! | [`Real`] | roots, angles, ordering by masks | lengths, rotors from angles, exponentials |
//!
//! Generic code requires the weakest trait that it needs, so that products run over integers and
//! over a prime field as well as over floating point, and tests can require exact equality.
//!
//! | scalar | is | implements |
//! | --- | --- | --- |
//! | `f32`, `f64` | floating point | [`Real`] |
//! | `i64` | integers | [`Ring`] |
//! | [`Prime61`] | the prime field modulo 2⁶¹ − 1, exact | [`Field`] |
//! | [`Lanes<T, N>`](Lanes) | N scalars side by side, one vector register | what T does |
//! | [`Dual<S, N>`](Dual) | a value with N derivatives | what S does |
//! | `f32x4`, `f32x8`, `f64x2`, `f64x4` of `wide` | vector registers (feature `wide`) | [`Real`] |
//!
//! Scalars nest: `Dual<Lanes<f64, 4>, 3>` carries the gradients of four numbers, `Dual<Dual<f64>>`
//! second derivatives.

mod arc;
mod dual;
mod float;
mod half_angle;
mod integer;
mod lane_mask;
mod lanes;
mod mask;
mod prime;
mod real;
mod ring;
mod step;
mod versor;
#[cfg(feature = "wide")]
mod wide;

#[cfg(feature = "wide")]
pub use self::wide::WideMask;
pub use arc::ArcFactors;
pub use dual::Dual;
pub use lane_mask::{LaneMask, Masked};
pub use lanes::Lanes;
pub use mask::{Mask, Maybe, Optional, Select, Single};
pub use prime::Prime61;
pub use real::{Real, versor_exponential};
pub use ring::{ConstRing, Field, Ring};
pub use step::smooth_step;
pub use versor::versor_logarithm;
