//! Complex numbers `a + b I` with I² = −1, which commute with every bivector: bivectors of
//! spacetime are complex vectors over them.

use crate::geometry::number::logarithm_above_one;
use crate::scalar::{Field, Real};

#[derive(Clone, Copy)]
pub(super) struct Complex<S> {
    pub(super) real: S,
    pub(super) imaginary: S,
}

impl<S: Field> Complex<S> {
    pub(super) fn new(real: S, imaginary: S) -> Self {
        Self { real, imaginary }
    }

    pub(super) fn times(self, other: Self) -> Self {
        Self::new(
            self.real * other.real - self.imaginary * other.imaginary,
            self.real * other.imaginary + self.imaginary * other.real,
        )
    }

    pub(super) fn plus(self, other: Self) -> Self {
        Self::new(self.real + other.real, self.imaginary + other.imaginary)
    }

    pub(super) fn negative(self) -> Self {
        Self::new(-self.real, -self.imaginary)
    }
}

impl<S: Real<Mask = bool>> Complex<S> {
    pub(super) fn modulus(self) -> S {
        crate::vga3::Vector::new(self.real, self.imaginary, S::zero()).length()
    }

    /// `self / other`, scaled by the larger part of the divisor so that no square is beyond the
    /// range of the scalar (Smith, 1962).
    pub(super) fn divided_by(self, other: Self) -> Self {
        let (c, d) = (other.real, other.imaginary);
        if c.abs().less_than(d.abs()) {
            let ratio = c / d;
            let divisor = c * ratio + d;
            return Self::new(
                (self.real * ratio + self.imaginary) / divisor,
                (self.imaginary * ratio - self.real) / divisor,
            );
        }
        let ratio = d / c;
        let divisor = c + d * ratio;
        Self::new(
            (self.real + self.imaginary * ratio) / divisor,
            (self.imaginary - self.real * ratio) / divisor,
        )
    }

    /// The square root with a real part that is not negative.
    pub(super) fn root(self) -> Self {
        let modulus = self.modulus();
        if !S::zero().less_than(modulus) {
            return self;
        }
        let half = S::from_ratio(1, 2);
        let large = ((modulus + self.real.abs()) * half).sqrt();
        let small = self.imaginary.abs() * half / large;
        let (real, imaginary) = if self.real.less_than(S::zero()) {
            (small, large)
        } else {
            (large, small)
        };
        if self.imaginary.less_than(S::zero()) {
            Self::new(real, -imaginary)
        } else {
            Self::new(real, imaginary)
        }
    }

    /// `cosh z`.
    pub(super) fn cosh(self) -> Self {
        let (sinh, cosh) = sinh_cosh(self.real);
        let (sine, cosine) = self.imaginary.sin_cos();
        Self::new(cosh * cosine, sinh * sine)
    }

    /// `sinh z`.
    pub(super) fn sinh(self) -> Self {
        let (sinh, cosh) = sinh_cosh(self.real);
        let (sine, cosine) = self.imaginary.sin_cos();
        Self::new(sinh * cosine, cosh * sine)
    }

    /// `z/w` for `self = cosh z`, `w = sinh z`, with the imaginary part of z in [−π, π] and
    /// `|cosh z + w|` at least one.
    pub(super) fn arcosh_over_sinh(self, sinh: Self) -> Self {
        let size = sinh.modulus();
        if !S::zero().less_than(size) {
            return Self::new(S::one(), S::zero());
        }
        let is_near_one = S::zero().less_than(self.real) && size.less_than(S::from_ratio(1, 2));
        let log = if is_near_one {
            // ln(1 + y) with y = w + w²/(1 + cosh z), which is accurate for a small w.
            let above = Self::new(S::one() + self.real, self.imaginary);
            let y = sinh.plus(sinh.times(sinh).divided_by(above));
            let excess = y.real + y.real + (y.real * y.real + y.imaginary * y.imaginary);
            let real = logarithm_above_one(excess) * S::from_ratio(1, 2);
            Self::new(real, y.imaginary.atan2(S::one() + y.real))
        } else {
            let exponential = self.plus(sinh);
            let angle = exponential.imaginary.atan2(exponential.real);
            Self::new(exponential.modulus().ln(), angle)
        };
        log.divided_by(sinh)
    }

    /// `sinh z / z` as a function of `z`, one at zero.
    pub(super) fn sinh_ratio(self) -> Self {
        if S::zero().less_than(self.modulus()) {
            self.sinh().divided_by(self)
        } else {
            // One, and NaN for NaN.
            Self::new(S::one() + self.modulus(), S::zero())
        }
    }
}

/// sinh and cosh of a real number; sinh by its series where the difference would cancel.
pub(super) fn sinh_cosh<S: Real<Mask = bool>>(x: S) -> (S, S) {
    let half = S::from_ratio(1, 2);
    let growing = x.exp();
    let cosh = half * (growing + growing.recip());
    if S::from_ratio(1, 4).less_than(x.abs()) {
        return (half * (growing - growing.recip()), cosh);
    }
    let square = x * x;
    let denominators = [39_916_800, 362_880, 5_040, 120, 6, 1];
    let series = denominators
        .into_iter()
        .fold(S::zero(), |sum, d| sum * square + S::from_ratio(1, d));
    (x * series, cosh)
}

/// The real number with a given sinh, which is not negative, and cosh.
pub(super) fn arsinh<S: Real<Mask = bool>>(sinh: S, cosh: S) -> S {
    if S::from_ratio(1, 4).less_than(sinh) {
        return (sinh + cosh).ln();
    }
    logarithm_above_one(sinh + sinh * sinh / (S::one() + cosh))
}
