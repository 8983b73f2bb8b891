//! From tokens to syntax trees. Nothing is resolved here: names are still names.

mod basis;
mod declaration;
mod faulty;
mod formula;
mod function;
mod handover;
mod import;
mod name;
mod nesting;
mod number;
mod operator;
mod outline;
mod place;
mod precedence;
mod product;
mod type_declaration;

pub use basis::{BasisSyntax, MetricEntrySyntax, MetricSyntax};
pub use declaration::{DeclarationSyntax, parse_declaration};
pub use faulty::{FaultyFunctions, parse_faulty};
pub use formula::{Formula, FormulaKind};
pub use function::{
    Block, FunctionSyntax, Import, LetSyntax, OperandSyntax, PatternSyntax, ShapeSyntax,
    parse_function, parse_functions,
};
pub use handover::{
    Handover, Imported, Pending, parse_handover, parse_import, parse_pending, parse_placed,
};
pub use import::{UseSyntax, parse_use};
pub use nesting::{MAX_NESTING, MAX_OPERATORS, check_brackets};
pub use operator::Operator;
pub use outline::{Outline, parse_outline};
pub use place::Place;
pub use product::{OperandTypeSyntax, ProductSyntax};
pub use type_declaration::{
    CoefficientSyntax, FactSyntax, ParametersSyntax, ReadingSyntax, TypeSyntax,
};
