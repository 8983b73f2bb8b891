//! Functions of scalars beyond arithmetic.

/// What is known of a function beside its values, from which whatever reads or writes it follows.
#[derive(Clone, Copy, Debug)]
pub struct Properties {
    /// The number of arguments.
    pub operands: usize,
    /// Its name or sign in formulas and graphs.
    pub symbol: &'static str,
    /// Its name in `ga!`, where it has one there.
    pub operation: Option<&'static str>,
    /// The function of ga-runtime that gives it, or all of its family, below `scalar`.
    pub rust: &'static str,
    /// Its name or operator in WGSL: of a built-in function, or the wished name of one of ours.
    pub wgsl: &'static str,
    /// Its definition, where textbooks have no name for it.
    pub explanation: Option<&'static str>,
    /// Whether the result is a condition, not a number.
    pub is_condition: bool,
    /// Whether an identity may hold for stand-ins and not for real numbers, since it depends on
    /// which of two numbers is positive, or larger.
    pub depends_on_signs: bool,
    /// Whether the stand-in makes a random choice between two outcomes.
    pub is_random_choice: bool,
    /// Whether it has a value with a bounded derivative, or none that is wrong, for all arguments.
    pub is_without_limit: bool,
    /// The functions that come out of one computation with this one, itself among them; none where
    /// it comes out alone.
    pub family: &'static [Function],
}

const PLAIN: Properties = Properties {
    operands: 1,
    symbol: "",
    operation: None,
    rust: "",
    wgsl: "",
    explanation: None,
    is_condition: false,
    depends_on_signs: false,
    is_random_choice: false,
    is_without_limit: false,
    family: &[],
};

/// A comparison of two numbers.
const COMPARISON: Properties = Properties {
    operands: 2,
    is_condition: true,
    depends_on_signs: true,
    is_random_choice: true,
    ..PLAIN
};

/// A condition made of conditions.
const CONNECTIVE: Properties = Properties {
    operands: 2,
    is_condition: true,
    depends_on_signs: true,
    ..PLAIN
};

/// The smaller or the larger of two numbers.
const CHOICE: Properties = Properties {
    operands: 2,
    depends_on_signs: true,
    is_random_choice: true,
    ..PLAIN
};

macro_rules! functions {
    ($($(#[$doc:meta])* $name:ident: $kind:ident { $($field:ident: $value:expr),* $(,)? })*) => {
        /// A function of scalars beyond arithmetic. The graph knows only that equal arguments give
        /// equal results.
        ///
        /// Over the prime field each has a stand-in that satisfies the equations on which
        /// membership in a type may depend: squares of roots, `sin² + cos² = 1`, and the like. A
        /// function without such an equation is a random function of its arguments. A condition is
        /// 0 or 1 there. A field that wraps around has no order, so a comparison is a random
        /// condition, the same wherever the same numbers are compared. Constants are compared as
        /// they are, and roots and absolute values of them have the right sign.
        /// [`Real`](super::Real) has the functions themselves.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Function {
            $($(#[$doc])* $name,)*
        }

        impl Function {
            /// Every function.
            pub const ALL: &'static [Self] = &[$(Self::$name),*];

            /// What is known of it.
            #[must_use]
            pub const fn properties(self) -> &'static Properties {
                match self {
                    $(Self::$name => &const { Properties { $($field: $value,)* ..$kind } },)*
                }
            }
        }
    };
}

const VERSOR_EXPONENTIAL: &[Function] = &[
    Function::StumpffCosine,
    Function::StumpffSine,
    Function::StumpffSineSlope,
];
const VERSOR_LOGARITHM: &[Function] = &[Function::VersorAngle, Function::VersorAngleSlope];
const CIRCLE: &[Function] = &[Function::Sine, Function::Cosine];

functions! {
    /// `√x`.
    SquareRoot: PLAIN {
        symbol: "√", operation: Some("sqrt"), rust: "Real::sqrt", wgsl: "sqrt",
        depends_on_signs: true,
    }
    /// `|x|`.
    Absolute: PLAIN {
        symbol: "abs", operation: Some("abs"), rust: "Real::abs", wgsl: "abs",
        depends_on_signs: true,
    }
    /// `sin x`.
    Sine: PLAIN {
        symbol: "sin", operation: Some("sin"), rust: "Real::sin_cos", wgsl: "sin",
        is_without_limit: true, family: CIRCLE,
    }
    /// `cos x`.
    Cosine: PLAIN {
        symbol: "cos", operation: Some("cos"), rust: "Real::sin_cos", wgsl: "cos",
        is_without_limit: true, family: CIRCLE,
    }
    /// The angle of the point (second argument, first argument).
    ArcTangent: PLAIN {
        operands: 2, symbol: "atan2", operation: Some("atan2"), rust: "Real::atan2",
        wgsl: "atan2",
    }
    /// `eˣ`.
    Exponential: PLAIN {
        symbol: "exp", rust: "Real::exp", wgsl: "exp",
    }
    /// `ln x`.
    NaturalLogarithm: PLAIN {
        symbol: "ln", operation: Some("ln"), rust: "Real::ln", wgsl: "log",
    }
    /// The Stumpff function c₀(−x), which is C(x) of `exp B = C(B²) + S(B²) B`: cos √−x, for x > 0
    /// cosh √x.
    StumpffCosine: PLAIN {
        symbol: "C", rust: "versor_exponential", wgsl: "versor_cosine",
        explanation: Some("C(x) = cos √(-x), for x > 0 cosh √x"), is_without_limit: true,
        family: VERSOR_EXPONENTIAL,
    }
    /// The Stumpff function c₁(−x), which is S(x) of `exp B = C(B²) + S(B²) B`: sin √−x / √−x, for
    /// x > 0 sinh √x / √x.
    StumpffSine: PLAIN {
        symbol: "S", rust: "versor_exponential", wgsl: "versor_sine",
        explanation: Some("S(x) = sin √(-x) / √(-x), for x > 0 sinh √x / √x"),
        is_without_limit: true, family: VERSOR_EXPONENTIAL,
    }
    /// The derivative of S, `(C − S)/(2x)`.
    StumpffSineSlope: PLAIN {
        symbol: "S′", rust: "versor_exponential", wgsl: "versor_sine_slope",
        explanation: Some("S′(x) = dS/dx"), is_without_limit: true, family: VERSOR_EXPONENTIAL,
    }
    /// 1/S(B²) from C(B²) and `S(B²)² B²`.
    VersorAngle: PLAIN {
        operands: 2, symbol: "A", rust: "versor_logarithm", wgsl: "versor_angle",
        explanation: Some("A(C(x), S(x)² x) = 1 / S(x)"), family: VERSOR_LOGARITHM,
    }
    /// `−2 S′(B²)/S(B²)³` from the same.
    VersorAngleSlope: PLAIN {
        operands: 2, symbol: "A′", rust: "versor_logarithm", wgsl: "versor_angle_slope",
        explanation: Some("A′(C(x), S(x)² x) = -2 S′(x) / S(x)³"), family: VERSOR_LOGARITHM,
    }
    /// The smaller of two numbers.
    Minimum: CHOICE {
        symbol: "min", operation: Some("min"), rust: "Real::min", wgsl: "min",
    }
    /// The larger of two numbers.
    Maximum: CHOICE {
        symbol: "max", operation: Some("max"), rust: "Real::max", wgsl: "max",
    }
    /// The condition `x < y`.
    Less: COMPARISON {
        symbol: "<", rust: "Real::less_than", wgsl: "<",
    }
    /// The condition `x ≤ y`.
    LessOrEqual: COMPARISON {
        symbol: "≤", rust: "Real::less_or_equal", wgsl: "<=",
    }
    /// The condition `x = y`.
    Equal: COMPARISON {
        symbol: "=", rust: "Real::equals", wgsl: "==",
    }
    /// Whether two conditions both hold.
    And: CONNECTIVE {
        symbol: "and", rust: "&", wgsl: "&&",
    }
    /// Whether one of two conditions holds, or both.
    Or: CONNECTIVE {
        symbol: "or", rust: "|", wgsl: "||",
    }
    /// Whether a condition does not hold.
    Not: CONNECTIVE {
        operands: 1, symbol: "not", rust: "!", wgsl: "!",
    }
    /// The second argument where the condition that comes first holds, else the third.
    Select: PLAIN {
        operands: 3, symbol: "select", rust: "Select::select", wgsl: "select",
        depends_on_signs: true,
    }
    /// `sinh x`.
    HyperbolicSine: PLAIN {
        symbol: "sinh", operation: Some("sinh"), rust: "Real::sinh", wgsl: "hyperbolic_sine",
        is_without_limit: true,
    }
    /// `cosh x`.
    HyperbolicCosine: PLAIN {
        symbol: "cosh", operation: Some("cosh"), rust: "Real::cosh", wgsl: "cosh",
        is_without_limit: true,
    }
    /// `tanh x`.
    HyperbolicTangent: PLAIN {
        symbol: "tanh", operation: Some("tanh"), rust: "Real::tanh", wgsl: "hyperbolic_tangent",
        is_without_limit: true,
    }
    /// `√(x² + y²)`, without overflow in the squares.
    Hypotenuse: PLAIN {
        operands: 2, symbol: "hypot", operation: Some("hypot"), rust: "Real::hypot",
        wgsl: "hypotenuse", depends_on_signs: true,
    }
    /// `1/x`, and 0 where x is 0. What an identity says where x is 0 does not count, so that
    /// `x · (1/x)` is 1.
    Reciprocal: PLAIN {
        symbol: "recip_or_zero", operation: Some("recip_or_zero"), rust: "Field::recip_or_zero",
        wgsl: "reciprocal", explanation: Some("recip_or_zero(x) = 1 / x, 0 for x = 0"),
        is_without_limit: true,
    }
    /// A divisor x by which every quotient is 0 where x is 0; otherwise it is x.
    Divisor: PLAIN {
        symbol: "nonzero", rust: "Field::recip_or_zero", wgsl: "divided",
        explanation: Some("a / nonzero(x) = a / x, 0 for x = 0"),
    }
}

/// Earlier names of variants.
#[allow(non_upper_case_globals)]
impl Function {
    /// Another name of [`StumpffCosine`](Self::StumpffCosine).
    pub const VersorCosine: Self = Self::StumpffCosine;
    /// Another name of [`StumpffSine`](Self::StumpffSine).
    pub const VersorSine: Self = Self::StumpffSine;
    /// Another name of [`StumpffSineSlope`](Self::StumpffSineSlope).
    pub const VersorSineSlope: Self = Self::StumpffSineSlope;
}

impl Function {
    /// The number of arguments.
    #[must_use]
    pub const fn arity(self) -> usize {
        self.properties().operands
    }

    /// Whether the result is a condition, not a number.
    #[must_use]
    pub const fn is_condition(self) -> bool {
        self.properties().is_condition
    }

    /// The functions that come out of one computation with this one, where there are others.
    #[must_use]
    pub const fn family(self) -> &'static [Self] {
        self.properties().family
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn properties_agree_with_each_other() {
        for &function in Function::ALL {
            let properties = function.properties();
            assert!(
                !properties.symbol.is_empty()
                    && !properties.rust.is_empty()
                    && !properties.wgsl.is_empty()
            );
            // Each of a family names the same family and the same function of ga-runtime.
            for other in properties.family {
                assert_eq!(other.properties().family, properties.family);
                assert_eq!(other.properties().rust, properties.rust);
            }
            assert!(properties.family.is_empty() || properties.family.contains(&function));
            let same = |other: &&Function| other.properties().symbol == properties.symbol;
            assert_eq!(
                Function::ALL.iter().filter(same).count(),
                1,
                "{}",
                properties.symbol
            );
        }
    }
}
