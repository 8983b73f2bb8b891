//! Operations that are made of several steps: inverses, norms, exponentials and logarithms.
//!
//! Each asks the witness which form its operand allows; where it allows none, the error says what
//! is missing.

use super::{MAX_STEPS, OperationError, Program, Step, StepId, Witness};
use crate::algebra::{Algebra, Blade, Product, Ratio, Unary};
use crate::ir::{Facts, Function};
use crate::signature::Operand;

/// A program under construction, with its values at random points.
#[derive(Clone)]
pub struct Builder<'a> {
    /// The algebra.
    pub algebra: &'a Algebra,
    /// The steps so far.
    pub program: Program<'a>,
    /// Their values at random points.
    pub witness: Witness,
    /// The operands as they are declared, for messages.
    pub operands: Vec<Operand>,
}

/// The step that an operation gives.
pub type Outcome = Result<StepId, OperationError>;

impl Builder<'_> {
    /// Adds a step, which must exist at random points.
    pub fn push(&mut self, step: Step) -> Outcome {
        if self.program.len() >= MAX_STEPS {
            return Err(OperationError::TooManySteps);
        }
        let is_quotient = matches!(step, Step::Quotient(..));
        if let Step::Sandwich(versor, _) | Step::Unary(Unary::Reverse, versor) = step {
            self.program
                .state_parity(versor, self.witness.parity(versor));
        }
        let id = self.program.push(step);
        if self.witness.extend(self.algebra, &self.program) {
            return Ok(id);
        }
        Err(if is_quotient {
            OperationError::DivisorZero
        } else {
            OperationError::NoValue
        })
    }

    /// A number.
    pub fn number(&mut self, value: Ratio) -> Outcome {
        self.push(Step::Constant(Blade::SCALAR, value))
    }

    /// The geometric product.
    pub fn geometric(&mut self, a: StepId, b: StepId) -> Outcome {
        self.push(Step::Binary(Product::Geometric, a, b))
    }

    /// A multiple.
    pub fn scaled(&mut self, a: StepId, numerator: i64, denominator: i64) -> Outcome {
        let factor = Ratio::new(i128::from(numerator), i128::from(denominator));
        let factor = self.number(factor.unwrap_or(Ratio::ZERO))?;
        self.geometric(factor, a)
    }

    pub(super) fn difference(&mut self, a: StepId, b: StepId) -> Outcome {
        let negative = self.push(Step::Negative(b))?;
        self.push(Step::Sum(a, negative))
    }

    fn scalar_of(&mut self, a: StepId) -> Outcome {
        self.push(Step::Coefficient(a, Blade::SCALAR))
    }

    fn reverse(&mut self, a: StepId) -> Outcome {
        self.push(Step::Unary(Unary::Reverse, a))
    }

    /// A function of scalars.
    pub fn function(&mut self, function: Function, arguments: &[StepId]) -> Outcome {
        for &argument in arguments {
            if !self.witness.is_scalar(argument) {
                return Err(OperationError::NotScalar(self.blade_names(argument)));
            }
        }
        self.push(Step::Function(function, arguments.to_vec()))
    }

    /// −1 for a negative number and 1 for a positive one; what is neither, zero or NaN, stays.
    pub fn sign(&mut self, x: StepId) -> Outcome {
        let [zero, one, minus_one] = [0, 1, -1].map(|value| self.number(Ratio::integer(value)));
        let (zero, one, minus_one) = (zero?, one?, minus_one?);
        let is_positive = self.function(Function::Less, &[zero, x])?;
        let is_negative = self.function(Function::Less, &[x, zero])?;
        let other = self.push(Step::Select(is_negative, minus_one, x))?;
        self.push(Step::Select(is_positive, one, other))
    }

    /// The blades of a step, for messages.
    pub fn blade_names(&self, id: StepId) -> String {
        let blades = self.witness.blades(id);
        if blades.is_empty() {
            return "no blade, it is zero".to_owned();
        }
        let names: Vec<_> = blades
            .iter()
            .map(|&blade| self.algebra.names().name(blade))
            .collect();
        names.join(", ")
    }

    /// The scalar part of `a ~a`.
    pub fn norm_squared(&mut self, a: StepId) -> Outcome {
        let reverse = self.reverse(a)?;
        self.push(Step::Binary(Product::ScalarProduct, a, reverse))
    }

    /// `√|⟨a ~a⟩₀|`.
    pub fn norm(&mut self, a: StepId) -> Outcome {
        let square = self.norm_squared(a)?;
        let size = if self.has_definite_norm(a) {
            square
        } else {
            self.function(Function::Absolute, &[square])?
        };
        self.function(Function::SquareRoot, &[size])
    }

    /// `~a/(a ~a)` where `a ~a` is a scalar.
    pub fn inverse(&mut self, a: StepId) -> Outcome {
        let reverse = self.reverse(a)?;
        if self.witness.is_unit_versor(self.algebra, a) {
            return Ok(reverse);
        }
        let norm = self.geometric(a, reverse)?;
        if !self.witness.is_scalar(norm) {
            return Err(OperationError::NotVersor(self.blade_names(norm)));
        }
        let norm = self.scalar_of(norm)?;
        self.push(Step::Quotient(reverse, norm))
    }

    /// `a |a ~a|^(−1/2)` for a blade, whose norm may have either sign; for others
    /// `a (a ~a)^(−1/2)`, where `a ~a` is a scalar n, or a scalar and a part p that commutes with
    /// everything here and has `p² = 0`: then `(n + p)^(−1/2) = n^(−1/2) (1 − p/2n)`.
    pub fn normalize(&mut self, a: StepId) -> Outcome {
        if self.witness.is_unit_versor(self.algebra, a) {
            return Ok(a);
        }
        let reverse = self.reverse(a)?;
        let norm = self.geometric(a, reverse)?;
        let scalar = self.scalar_of(norm)?;
        let is_blade = self.witness.is_scalar(norm) && self.is_of_one_grade(a);
        let size = if is_blade && !self.has_definite_norm(a) {
            self.function(Function::Absolute, &[scalar])?
        } else {
            scalar
        };
        let root = self.function(Function::SquareRoot, &[size])?;
        let unit = self.push(Step::Quotient(a, root))?;
        if self.witness.is_scalar(norm) {
            return Ok(unit);
        }
        let rest = self.difference(norm, scalar)?;
        self.check_null_part(rest, a, "a ~a")?;
        let double = self.push(Step::Sum(scalar, scalar))?;
        let relative = self.push(Step::Quotient(rest, double))?;
        let change = self.geometric(relative, unit)?;
        self.difference(unit, change)
    }

    /// Whether the scalar part of `a ~a` is a sum of squares.
    fn has_definite_norm(&self, a: StepId) -> bool {
        let blades = self.witness.blades(a);
        let is_square = |left: Blade, right: Blade| {
            let is_negative = right.reverse_is_negative();
            Product::ScalarProduct
                .of_blades(self.algebra, left, right)
                .iter()
                .all(|(_, value)| left == right && value.is_negative() == is_negative)
        };
        let mut pairs = blades
            .iter()
            .flat_map(|&left| blades.iter().map(move |&right| (left, right)));
        pairs.all(|(left, right)| is_square(left, right))
    }

    fn is_of_one_grade(&self, a: StepId) -> bool {
        let blades = self.witness.blades(a);
        blades
            .windows(2)
            .all(|pair| pair[0].grade() == pair[1].grade())
    }

    /// The versor `exp B = C(B²) + S(B²) B` with C(x) = cos √−x, S(x) = sin √−x / √−x (cosh and
    /// sinh for x > 0), where B² is a scalar a, or a scalar and a part p as above: then
    /// `C(a + p) = C + ½ S p` and `S(a + p) = S + S′ p`.
    pub fn exponential(&mut self, b: StepId) -> Outcome {
        if self.witness.is_scalar(b) {
            return self.function(Function::Exponential, &[b]);
        }
        let blades = self.witness.blades(b);
        if blades.iter().any(|blade| blade.grade() != 2) {
            return Err(OperationError::NotBivector(self.blade_names(b)));
        }
        let square = self.geometric(b, b)?;
        let scalar = self.scalar_of(square)?;
        let [cosine, sine, slope] = [
            Function::StumpffCosine,
            Function::StumpffSine,
            Function::StumpffSineSlope,
        ]
        .map(|function| self.function(function, &[scalar]));
        let (cosine, sine) = (cosine?, sine?);
        let result = if self.witness.is_scalar(square) {
            let part = self.geometric(sine, b)?;
            self.push(Step::Sum(cosine, part))?
        } else {
            let rest = self.difference(square, scalar)?;
            self.check_null_part(rest, b, "B²")?;
            let half = self.scaled(sine, 1, 2)?;
            let first = self.geometric(half, rest)?;
            let even = self.push(Step::Sum(cosine, first))?;
            let change = self.geometric(slope?, rest)?;
            let factor = self.push(Step::Sum(sine, change))?;
            let odd = self.geometric(factor, b)?;
            self.push(Step::Sum(even, odd))?
        };
        self.unit_versor(result)
    }

    /// The bivector B with `exp B = M`: `⟨M⟩₂ = S(B²) B`, and the part of grade 4 changes B² as
    /// above.
    pub fn logarithm(&mut self, m: StepId) -> Outcome {
        if self.witness.is_scalar(m) && !self.witness.is_unit_versor(self.algebra, m) {
            return self.function(Function::NaturalLogarithm, &[m]);
        }
        let is_even = self
            .witness
            .blades(m)
            .iter()
            .all(|b| [0, 2, 4].contains(&b.grade()));
        if !is_even || !self.witness.is_unit_versor(self.algebra, m) {
            return Err(OperationError::NotEvenUnitVersor);
        }
        let scalar = self.scalar_of(m)?;
        let part = self.push(Step::Unary(Unary::Grade(2), m))?;
        let square = self.push(Step::Binary(Product::ScalarProduct, part, part))?;
        let angle = self.function(Function::VersorAngle, &[scalar, square])?;
        let first = self.geometric(angle, part)?;
        let rest = self.push(Step::Unary(Unary::Grade(4), m))?;
        if self.witness.is_zero(rest) {
            return Ok(first);
        }
        self.check_null_part(rest, m, "the part of grade 4")?;
        let slope = self.function(Function::VersorAngleSlope, &[scalar, square])?;
        let scaled = self.geometric(slope, rest)?;
        let change = self.geometric(scaled, part)?;
        self.push(Step::Sum(first, change))
    }

    /// Checks that a part squares to zero and commutes with the value that it comes from.
    fn check_null_part(
        &mut self,
        part: StepId,
        with: StepId,
        what: &'static str,
    ) -> Result<(), OperationError> {
        let square = self.geometric(part, part)?;
        let commutator = self.push(Step::Binary(Product::Commutator, part, with))?;
        if self.witness.is_zero(square) && self.witness.is_zero(commutator) {
            return Ok(());
        }
        let found = self.blade_names(part);
        Err(OperationError::NotScalarAndNullPart(what, found))
    }

    /// States that a step is a unit versor, if it is.
    pub fn unit_versor(&mut self, id: StepId) -> Outcome {
        let unit_versor = self.witness.is_unit_versor(self.algebra, id);
        let facts = Facts {
            unit_versor,
            ..Facts::default()
        };
        self.program.state(id, facts);
        Ok(id)
    }
}
