//! Members of types: random ones over the prime field, with real ones where signs matter, and
//! whether a multivector is one.
//!
//! A type is the variety of the multivectors that have its blades, its constants and its facts. An
//! equation between polynomials that holds at a random point of the variety holds everywhere with a
//! probability of error below 2⁻⁵⁰ (Schwartz 1980, Zippel 1979), or else on the component of that
//! point; so points are drawn from every component.

mod components;
mod implied;
mod membership;
pub mod numbers;
mod reason;
mod sample;
mod stored;

pub use implied::facts_not_implied;
pub use membership::membership;
pub use numbers::Numbers;
pub use reason::Reason;
pub use sample::{is_family, points};
pub use sample::{sample, sequence};
pub use stored::{from_stored, stored};
