//! Operators, with the precedence that they have in Rust.

use proc_macro2::TokenTree;
use syn::parse::ParseStream;
use syn::{Result, Token};

/// The operators, with the precedence that they have in Rust.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `&`
    And,
    /// `^`
    Xor,
    /// `|`
    Or,
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
    /// `&&`
    Both,
    /// `||`
    Either,
}

/// The operators whose mix is never in doubt.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Family {
    Arithmetic,
    Bitwise,
    Comparison,
    Logical,
}

impl Operator {
    /// Operators of a greater number bind tighter.
    pub(super) const fn precedence(self) -> u8 {
        match self {
            Self::Multiply | Self::Divide => 8,
            Self::Add | Self::Subtract => 7,
            Self::And => 6,
            Self::Xor => 5,
            Self::Or => 4,
            Self::Less
            | Self::LessOrEqual
            | Self::Greater
            | Self::GreaterOrEqual
            | Self::Equal
            | Self::NotEqual => 3,
            Self::Both => 2,
            Self::Either => 1,
        }
    }

    /// The operator as it is written.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Multiply => "*",
            Self::Divide => "/",
            Self::Add => "+",
            Self::Subtract => "-",
            Self::And => "&",
            Self::Xor => "^",
            Self::Or => "|",
            Self::Less => "<",
            Self::LessOrEqual => "<=",
            Self::Greater => ">",
            Self::GreaterOrEqual => ">=",
            Self::Equal => "==",
            Self::NotEqual => "!=",
            Self::Both => "&&",
            Self::Either => "||",
        }
    }

    /// Whether it compares two numbers.
    #[must_use]
    pub const fn is_comparison(self) -> bool {
        matches!(self.family(), Family::Comparison)
    }

    pub(super) const fn family(self) -> Family {
        match self {
            Self::Multiply | Self::Divide | Self::Add | Self::Subtract => Family::Arithmetic,
            Self::And | Self::Xor | Self::Or => Family::Bitwise,
            Self::Less
            | Self::LessOrEqual
            | Self::Greater
            | Self::GreaterOrEqual
            | Self::Equal
            | Self::NotEqual => Family::Comparison,
            Self::Both | Self::Either => Family::Logical,
        }
    }

    /// Whether Rust reads a mix of both without parentheses in a way that readers of formulas do
    /// not expect.
    pub(super) fn is_doubtful_with(self, other: Self) -> bool {
        matches!(
            (self.family(), other.family()),
            (Family::Arithmetic, Family::Bitwise) | (Family::Bitwise, Family::Arithmetic)
        )
    }

    pub(super) fn peek(input: ParseStream<'_>) -> Option<Self> {
        if input.peek(Token![->]) {
            return None;
        }
        // Those of two marks come first, since each starts like another one.
        let operators = [
            (input.peek(Token![||]), Self::Either),
            (input.peek(Token![&&]), Self::Both),
            (input.peek(Token![<=]), Self::LessOrEqual),
            (input.peek(Token![>=]), Self::GreaterOrEqual),
            (input.peek(Token![==]), Self::Equal),
            (input.peek(Token![!=]), Self::NotEqual),
            (input.peek(Token![<]), Self::Less),
            (input.peek(Token![>]), Self::Greater),
            (input.peek(Token![*]), Self::Multiply),
            (input.peek(Token![/]), Self::Divide),
            (input.peek(Token![+]), Self::Add),
            (input.peek(Token![-]), Self::Subtract),
            (input.peek(Token![&]), Self::And),
            (input.peek(Token![^]), Self::Xor),
            (input.peek(Token![|]), Self::Or),
        ];
        operators
            .into_iter()
            .find_map(|(is_next, operator)| is_next.then_some(operator))
    }

    pub(super) fn parse(self, input: ParseStream<'_>) -> Result<()> {
        for _ in self.symbol().bytes() {
            input.parse::<TokenTree>()?;
        }
        if self.family() != Family::Comparison && input.peek(Token![=]) {
            return Err(input.error("names cannot be assigned to; bind a new name with `let`"));
        }
        Ok(())
    }
}
