//! From tokens to syntax trees. Nothing is resolved here: names are still names.

mod declaration;
mod formula;
mod function;
mod handover;
mod outline;

pub use declaration::{
    BasisSyntax, CoefficientSyntax, DeclarationSyntax, FactSyntax, MetricEntrySyntax, MetricSyntax,
    ProductSyntax, TypeSyntax, parse_declaration,
};
pub use formula::{Formula, FormulaKind, Operator};
pub use function::{
    FunctionSyntax, LetSyntax, OperandSyntax, PatternSyntax, ShapeSyntax, parse_function,
    parse_functions,
};
pub use handover::{Handover, parse_handover, parse_placed};
pub use outline::{Outline, parse_outline};
