//! Numbers of twice the precision of `f64`, as sums of two of them (Dekker 1971).

use ga_compiler::algebra::Ratio;

/// What graphs are evaluated in.
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

/// `high + low`, where low is less than half a unit in the last place of high.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Twofold {
    pub(crate) high: f64,
    low: f64,
}

/// The sum of two numbers, exactly (Knuth).
fn exact_sum(a: f64, b: f64) -> Twofold {
    let high = a + b;
    let part = high - a;
    let low = (a - (high - part)) + (b - part);
    Twofold { high, low }
}

impl Number for Twofold {
    fn of(value: f64) -> Self {
        Self {
            high: value,
            low: 0.0,
        }
    }

    fn sum(self, other: Self) -> Self {
        let (high, low) = (
            exact_sum(self.high, other.high),
            exact_sum(self.low, other.low),
        );
        let middle = exact_sum(high.high, high.low + low.high);
        exact_sum(middle.high, middle.low + low.low)
    }

    fn product(self, other: Self) -> Self {
        let high = self.high * other.high;
        let low = self.high.mul_add(other.high, -high);
        exact_sum(high, low + (self.high * other.low + self.low * other.high))
    }

    fn quotient(self, other: Self) -> Self {
        let first = self.high / other.high;
        let rest = self.sum(other.product(Self::of(-first)));
        let second = rest.high / other.high;
        let rest = rest.sum(other.product(Self::of(-second)));
        exact_sum(first, second).sum(Self::of(rest.high / other.high))
    }

    /// One step of Newton's method from the root of the high part.
    fn root(self) -> Self {
        let first = self.high.sqrt();
        if first == 0.0 {
            return Self::of(0.0);
        }
        let rest = self.sum(Self::of(first).product(Self::of(-first)));
        exact_sum(first, rest.high / (2.0 * first))
    }
}

#[test]
fn a_third_has_32_digits() {
    let three = Twofold::of(3.0);
    let third = Twofold::of(1.0).quotient(three);
    let rest = third.product(three).sum(Twofold::of(-1.0));
    assert!(rest.high.abs() < 1e-31, "{rest:?}");
    let root = three.root();
    let rest = root.product(root).sum(Twofold::of(-3.0));
    assert!(rest.high.abs() < 1e-31, "{rest:?}");
    let far = Twofold::of(1e16)
        .sum(Twofold::of(1.0))
        .sum(Twofold::of(-1e16));
    assert_eq!(far, Twofold::of(1.0));
}
