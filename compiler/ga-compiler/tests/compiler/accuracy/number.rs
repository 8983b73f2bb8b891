//! What graphs are evaluated in: `f64`, and twice its precision.

use ga_compiler::algebra::Ratio;

use super::twofold::Twofold;

pub(crate) trait Number: Copy {
    fn of(value: f64) -> Self;
    fn sum(self, other: Self) -> Self;
    fn product(self, other: Self) -> Self;
    fn quotient(self, other: Self) -> Self;
    fn root(self) -> Self;

    fn of_ratio(ratio: Ratio) -> Self {
        let [numerator, denominator] =
            [ratio.numerator(), ratio.denominator()].map(|part| Self::of(part as f64));
        numerator.quotient(denominator)
    }
}

impl Number for f64 {
    fn of(value: f64) -> Self {
        value
    }

    fn sum(self, other: Self) -> Self {
        self + other
    }

    fn product(self, other: Self) -> Self {
        self * other
    }

    fn quotient(self, other: Self) -> Self {
        self / other
    }

    fn root(self) -> Self {
        self.sqrt()
    }
}

impl Number for Twofold {
    fn of(value: f64) -> Self {
        value.into()
    }

    fn sum(self, other: Self) -> Self {
        self + other
    }

    fn product(self, other: Self) -> Self {
        self * other
    }

    fn quotient(self, other: Self) -> Self {
        self / other
    }

    fn root(self) -> Self {
        self.sqrt()
    }
}
