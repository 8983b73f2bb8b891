//! The operations that have a name.

use crate::algebra::{Product, Ratio, Unary};
use crate::ir::Function;
use crate::program::build::{Builder, Outcome};
use crate::program::{OperationError, Step, StepId};

use super::condition::SELECT;
use super::place::{ENDPOINTS, POINT};
use super::power::POWER;

/// An operation with a name.
#[derive(Clone, Copy)]
pub(super) enum Operation {
    /// A linear operation.
    Unary(Unary),
    /// A product.
    Product(Product),
    /// The action of a versor.
    Sandwich,
    /// A function of scalars.
    Function(Function),
    /// A number between two others.
    Clamp,
    /// −1, 0 or 1.
    Sign,
    /// `1/x` of a scalar.
    Reciprocal,
    /// The tangent of an angle.
    Tangent,
    /// The angle of a sine.
    ArcSine,
    /// The angle of a cosine.
    ArcCosine,
    /// The exponential of a scalar or a bivector.
    Exponential,
    /// The logarithm of a scalar or a unit versor.
    Logarithm,
    /// `√|⟨a ~a⟩₀|`.
    Norm,
    /// `⟨a ~a⟩₀`.
    NormSquared,
    /// The multiple with norm 1.
    Normalize,
    /// The inverse of a blade or a versor.
    Inverse,
}

/// The operation that takes a number, the grade, beside its operand: `grade(a, 2)`.
pub(super) const GRADE: &str = "grade";

/// The other operations of multivectors by name; some have two names. Functions of scalars have the
/// names of their [properties](crate::ir::Properties).
const NAMES: [(&str, Operation); 28] = [
    ("reverse", Operation::Unary(Unary::Reverse)),
    ("rev", Operation::Unary(Unary::Reverse)),
    ("involute", Operation::Unary(Unary::Involute)),
    ("conjugate", Operation::Unary(Unary::Conjugate)),
    ("dual", Operation::Unary(Unary::Dual)),
    ("undual", Operation::Unary(Unary::Undual)),
    ("geometric", Operation::Product(Product::Geometric)),
    ("wedge", Operation::Product(Product::Wedge)),
    (
        "left_contraction",
        Operation::Product(Product::LeftContraction),
    ),
    (
        "right_contraction",
        Operation::Product(Product::RightContraction),
    ),
    ("scalar_product", Operation::Product(Product::ScalarProduct)),
    ("commutator", Operation::Product(Product::Commutator)),
    ("vee", Operation::Product(Product::Vee)),
    ("sandwich", Operation::Sandwich),
    ("transform", Operation::Sandwich),
    ("tan", Operation::Tangent),
    ("asin", Operation::ArcSine),
    ("acos", Operation::ArcCosine),
    ("clamp", Operation::Clamp),
    ("sign", Operation::Sign),
    ("recip", Operation::Reciprocal),
    ("exp", Operation::Exponential),
    ("log", Operation::Logarithm),
    ("norm", Operation::Norm),
    ("norm_squared", Operation::NormSquared),
    ("normalize", Operation::Normalize),
    ("inverse", Operation::Inverse),
    ("inv", Operation::Inverse),
];

/// The functions of scalars that have a name in `ga!`.
fn functions() -> impl Iterator<Item = (&'static str, Function)> {
    let named = |function: &Function| Some((function.properties().operation?, *function));
    Function::ALL.iter().filter_map(named)
}

impl Operation {
    /// All names, those of operations that take something else than multivectors included.
    pub(super) fn names() -> impl Iterator<Item = &'static str> {
        NAMES
            .iter()
            .map(|(name, _)| *name)
            .chain(functions().map(|(name, _)| name))
            .chain([GRADE, POWER, SELECT, POINT, ENDPOINTS])
    }

    /// The operation of that name, with the name.
    pub(super) fn from_name(name: &str) -> Option<(&'static str, Self)> {
        let functions = functions().map(|(name, function)| (name, Self::Function(function)));
        let mut all = NAMES.iter().copied().chain(functions);
        all.find(|(known, _)| *known == name)
    }

    /// How many operands it takes.
    pub(super) fn arity(self) -> usize {
        match self {
            Self::Clamp => 3,
            Self::Product(_) | Self::Sandwich => 2,
            Self::Function(function) => function.arity(),
            Self::Unary(_)
            | Self::Sign
            | Self::Reciprocal
            | Self::Tangent
            | Self::ArcSine
            | Self::ArcCosine
            | Self::Exponential
            | Self::Logarithm
            | Self::Norm
            | Self::NormSquared
            | Self::Normalize
            | Self::Inverse => 1,
        }
    }

    /// The steps of the operation on as many operands as it takes.
    pub(super) fn apply(self, builder: &mut Builder<'_>, operands: &[StepId]) -> Outcome {
        let result = self.steps(builder, operands)?;
        // Some give back an operand.
        if !operands.contains(&result) {
            builder.program.state_operation(result, operands.to_vec());
        }
        Ok(result)
    }

    fn steps(self, builder: &mut Builder<'_>, operands: &[StepId]) -> Outcome {
        let first = operands[0];
        match self {
            Self::Unary(operation) => builder.push(Step::Unary(operation, first)),
            Self::Product(product) => builder.push(Step::Binary(product, first, operands[1])),
            Self::Sandwich => builder.push(Step::Sandwich(first, operands[1])),
            Self::Function(function) => builder.function(function, operands),
            Self::Clamp => {
                let raised = builder.function(Function::Maximum, &[first, operands[1]])?;
                builder.function(Function::Minimum, &[raised, operands[2]])
            }
            Self::Sign => builder.sign(first),
            Self::Reciprocal => {
                let one = builder.number(Ratio::ONE)?;
                if !builder.witness.is_scalar(first) {
                    return Err(OperationError::NotScalar(builder.blade_names(first)));
                }
                builder.push(Step::Quotient(one, first))
            }
            Self::Tangent => builder.tangent(first),
            Self::ArcSine => builder.arc_sine(first),
            Self::ArcCosine => builder.arc_cosine(first),
            Self::Exponential => builder.exponential(first),
            Self::Logarithm => builder.logarithm(first),
            Self::Norm => builder.norm(first),
            Self::NormSquared => builder.norm_squared(first),
            Self::Normalize => builder.normalize(first),
            Self::Inverse => builder.inverse(first),
        }
    }
}
