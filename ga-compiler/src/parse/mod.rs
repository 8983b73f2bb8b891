//! From tokens to syntax trees. Nothing is resolved here: names are still names.

mod declaration;
mod expression;
mod handover;
mod outline;

pub use declaration::{
    BasisSyntax, CoefficientSyntax, DeclarationSyntax, FactSyntax, MetricEntrySyntax, MetricSyntax,
    ProductSyntax, TypeSyntax, parse_declaration,
};
pub use expression::{FunctionSyntax, parse_function};
pub use handover::{Handover, parse_handover, parse_placed};
pub use outline::{Outline, parse_outline};
