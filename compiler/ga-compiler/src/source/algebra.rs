//! The algebra that functions are written in.

use proc_macro2::TokenStream;

use crate::define::Definition;

/// An algebra, and where emitted code finds it.
pub struct Algebra {
    /// The types of the algebra, without its products.
    pub definition: Definition,
    /// The path of its module.
    pub path: TokenStream,
}
