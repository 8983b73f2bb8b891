//! Texts of Rust with `algebra!` and `ga!` blocks: the algebra that one declares, its functions,
//! compiled, and errors with the lines that they are in.
//!
//! ```
//! use ga_compiler::source::Source;
//!
//! let text = "
//!     algebra! { pub mod vga2 { basis e1, e2; signature 2, 0; struct Vector { e1, e2 } } }
//!     ga! { vga2; fn doubled(v: Vector) -> Vector { v + v } }
//!     mod more { ga! { vga2; use crate::doubled; fn f(v: Vector) -> Vector { doubled(v) } } }
//! ";
//! let source = Source::new("plane.rs", text)?;
//! let algebra = source.algebra(source.algebra_name().as_deref())?;
//! let functions = source.compile(&algebra.definition)?;
//! let names: Vec<String> = functions.iter().map(|function| function.label()).collect();
//! assert_eq!(names, ["doubled", "f"]);
//!
//! let wrong = Source::new("wrong", "fn f(v: Vector) -> Vector {\n  v + w\n}")?;
//! let error = wrong.compile(&algebra.definition).unwrap_err();
//! assert!(error.to_string().contains("wrong:2:7"));
//! # Ok::<(), ga_compiler::source::SourceError>(())
//! ```

mod algebra;
mod blocks;
mod calls;
mod error;
mod text;

pub use algebra::Algebra;
pub use error::{Fault, Faults, SourceError};
pub use text::Source;
