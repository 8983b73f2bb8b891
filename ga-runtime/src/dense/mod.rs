//! The dense reference: any geometric algebra of up to 16 dimensions, with all 2ⁿ coefficients and
//! every product.
//!
//! It is written for correctness, not for speed. Tests compare the compiled algebras with it,
//! exactly, over [`Prime61`](crate::scalar::Prime61); for that purpose it shares no code with the
//! compiler. Blades are lists of vectors, signs come from counting swaps in these lists, and a
//! metric that is not diagonal, such as that of the null basis of conformal geometry, is used as it
//! stands rather than through an orthogonal frame.
//!
//! ```
//! use ga_runtime::dense::{Algebra, DenseError};
//! use ga_runtime::scalar::{Field, Prime61};
//!
//! # fn main() -> Result<(), DenseError> {
//! // Conformal space with the null vectors eo (origin) and ei (infinity), eo·ei = −1.
//! let metric = [
//!     [1, 0, 0, 0, 0],
//!     [0, 1, 0, 0, 0],
//!     [0, 0, 1, 0, 0],
//!     [0, 0, 0, 0, -1],
//!     [0, 0, 0, -1, 0],
//! ];
//! let cga3 = Algebra::new(metric.map(|row| row.map(Prime61::from).to_vec()).to_vec())?
//!     .with_names(["e1", "e2", "e3", "eo", "ei"])?;
//!
//! // A point is null, and the inner product of two is −½ times their squared distance.
//! let point = |x: i64, y: i64, z: i64| {
//!     let half_square = Prime61::from_ratio(x * x + y * y + z * z, 2);
//!     cga3.vector([x.into(), y.into(), z.into(), 1.into(), half_square])
//! };
//! let (p, q) = (point(1, 1, 2)?, point(1, 1, 4)?);
//! assert_eq!(p.to_string(), "e1 + e2 + 2 e3 + eo + 3 ei");
//! assert!((&p * &p).is_zero());
//! assert_eq!(&p | &q, cga3.scalar((-2).into()));
//!
//! // The line through both contains a third point m exactly if line ∧ m = 0.
//! let infinity = cga3.blade(0b10000)?;
//! let line = &p ^ &q ^ infinity;
//! assert!((&line ^ point(1, 1, 6)?).is_zero());
//! assert!(!(&line ^ point(1, 3, 4)?).is_zero());
//! # Ok(())
//! # }
//! ```
//!
//! # Basis blades
//!
//! A basis blade is named by a bitmask: bit k stands for the k-th basis vector. The blade of a mask
//! is the *outer* product of its vectors in rising order, in any metric; mask 0 is the scalar 1.
//! With a metric that is not diagonal it differs from the geometric product of the same vectors: eo
//! ∧ ei = eo ei + 1 where eo·ei = −1.
//!
//! # Products
//!
//! With a and b split into their grades, a = Σ aᵣ and b = Σ bₛ:
//!
//! | method | operator | definition |
//! | --- | --- | --- |
//! | [`geometric`](Multivector::geometric) | `a * b` | associative, v v = v·v for vectors |
//! | [`wedge`](Multivector::wedge) | `a ^ b` | Σ ⟨aᵣ bₛ⟩ of grade r + s |
//! | [`left_contraction`](Multivector::left_contraction) | `a \| b` | Σ ⟨aᵣ bₛ⟩ of grade s − r |
//! | [`right_contraction`](Multivector::right_contraction) | | Σ ⟨aᵣ bₛ⟩ of grade r − s |
//! | [`dot`](Multivector::dot) | | Σ ⟨aᵣ bₛ⟩ of grade \|r − s\| |
//! | [`hestenes`](Multivector::hestenes) | | the same without r = 0 and s = 0 |
//! | [`scalar_product`](Multivector::scalar_product) | | ⟨a b⟩₀, without reversal |
//! | [`commutator`](Multivector::commutator) | | (a b − b a) / 2 |
//! | [`vee`](Multivector::vee) | `a & b` | the regressive product, see below |
//!
//! In Rust `^`, `&` and `|` bind looser than `+` and `*`, so `a + b ^ c` is `(a + b) ^ c`. The
//! operators take multivectors by value and by reference.
//!
//! # Duality
//!
//! The pseudoscalar I is the outer product of all basis vectors in order. Where the metric is not
//! singular, I has an inverse, and
//!
//! - [`dual`](Multivector::dual)(a) = a I⁻¹ and [`undual`](Multivector::undual)(a) = a I.
//!
//! Where it is singular, as in projective geometric algebra, dual is the [right
//! complement](Multivector::right_complement), the linear map with a ∧ complement(a) = I on basis
//! blades, and undual its inverse, the [left complement](Multivector::left_complement). In both
//! cases
//!
//! - a ∨ b = undual(dual(a) ∧ dual(b)).
//!
//! # How the products are computed
//!
//! All products are reduced to a basis vector e that acts on a blade from the left:
//!
//! - e ∧ (a₁ ∧ … ∧ aᵣ) moves e to its place, with a change of sign for each vector that it passes,
//!   and is zero if the blade already contains e;
//! - e ⌋ (a₁ ∧ … ∧ aᵣ) = Σₖ (−1)ᵏ⁻¹ (e·aₖ) a₁ ∧ … ∧ aₖ₋₁ ∧ aₖ₊₁ ∧ … ∧ aᵣ;
//! - e B = e ⌋ B + e ∧ B.
//!
//! The left operand is written as a = a′ + e ∧ a″ with the first basis vector e, neither a′ nor a″
//! containing it. Then
//!
//! - a ∧ b = a′ ∧ b + e ∧ (a″ ∧ b),
//! - a ⌋ b = a′ ⌋ b + e ⌋ (a″ ⌋ b),
//! - a b = (a′ − e ⌋ a″) b + e (a″ b), since e ∧ a″ = e a″ − e ⌋ a″,
//!
//! and the products with a′ and a″ are taken in the same way with the next basis vector. The other
//! products follow from these three by their definitions.
//!
//! The identities can be found in Dorst, Fontijne and Mann, *Geometric Algebra for Computer
//! Science* (Morgan Kaufmann, 2007), chapters 2, 3 and 6.

mod algebra;
mod blade;
mod construction;
mod duality;
mod error;
mod multivector;
mod notation;
mod operators;
mod product;
mod versor;

pub use algebra::Algebra;
pub(crate) use blade::blade_name;
pub use error::DenseError;
pub use multivector::Multivector;
