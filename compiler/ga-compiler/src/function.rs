//! A compiled function: what `ga!` makes from its source, before any code is written.

use std::fmt;

use proc_macro2::Ident;
use syn::{Attribute, Visibility};

pub use crate::define::SCALAR_TYPE;
pub use crate::signature::{Operand, Shape};

use crate::diag::Warning;
use crate::kernel::Kernel;

/// A function in an algebra, compiled.
#[derive(Clone)]
pub struct CompiledFunction {
    /// Doc comments and other attributes.
    pub attributes: Vec<Attribute>,
    /// The visibility.
    pub visibility: Visibility,
    /// The name; a closure has none.
    pub name: Option<Ident>,
    /// The operands in order.
    pub operands: Vec<Operand>,
    /// What comes out.
    pub result: Shape,
    /// The graph. Its inputs are the stored coefficients of all operands, its outputs those of the
    /// result, each in order of declaration, arrays and tuples element by element.
    pub kernel: Kernel,
    /// What is allowed but is probably a mistake.
    pub warnings: Vec<Warning>,
}

impl CompiledFunction {
    /// The name, as messages have it; `closure` for a closure.
    #[must_use]
    pub fn label(&self) -> String {
        let name = self.name.as_ref();
        name.map_or_else(|| "closure".to_owned(), Ident::to_string)
    }
}

impl fmt::Debug for CompiledFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("CompiledFunction")
            .field("name", &self.name)
            .field("operands", &self.operands)
            .field("result", &self.result)
            .field("kernel", &self.kernel)
            .finish_non_exhaustive()
    }
}
