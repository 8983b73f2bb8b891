//! Numbers of about 32 digits, for the truth about computations in `f64`.

use std::ops::{Add, Div, Mul, Sub};

/// The sum of two numbers, of which the second is within the rounding of the first (Dekker 1971).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Twofold(f64, f64);

impl Twofold {
    /// A sum of two numbers of any sizes (Knuth's two-sum).
    pub(crate) fn sum(a: f64, b: f64) -> Self {
        let sum = a + b;
        let part = sum - a;
        Self(sum, (a - (sum - part)) + (b - part))
    }

    /// The number in double precision.
    pub(crate) fn rounded(self) -> f64 {
        self.0
    }

    /// The square root.
    pub(crate) fn sqrt(self) -> Self {
        let root = Self::from(self.0.sqrt());
        if root.0 > 0.0 {
            root + (self - root * root) / (root + root)
        } else {
            root
        }
    }
}

impl From<f64> for Twofold {
    fn from(number: f64) -> Self {
        Self(number, 0.0)
    }
}

impl Add for Twofold {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (first, second) = (Self::sum(self.0, other.0), Self::sum(self.1, other.1));
        let sum = Self::sum(first.0, first.1 + second.0);
        Self::sum(sum.0, sum.1 + second.1)
    }
}

impl Sub for Twofold {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + Self(-other.0, -other.1)
    }
}

impl Mul for Twofold {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = self.0 * other.0;
        let rest = self.0.mul_add(other.0, -product);
        Self::sum(product, rest + (self.0 * other.1 + self.1 * other.0))
    }
}

impl Div for Twofold {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.0 / other.0;
        let rest = self - Self::from(first) * other;
        let second = rest.0 / other.0;
        let rest = rest - Self::from(second) * other;
        Self::sum(first, second) + Self::from(rest.0 / other.0)
    }
}

#[cfg(test)]
mod tests {
    use super::Twofold;

    #[test]
    fn it_keeps_what_one_number_rounds_away() {
        let [one, two, three] = [1.0, 2.0, 3.0].map(Twofold::from);
        let tiny = Twofold::from(1e-25);
        assert_eq!(one + tiny - one, tiny);
        for error in [one / three * three - one, two.sqrt() * two.sqrt() - two] {
            assert!(error.rounded().abs() < 1e-30, "{error:?}");
        }
    }
}
