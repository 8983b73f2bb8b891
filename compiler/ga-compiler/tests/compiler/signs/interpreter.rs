//! The plain meaning of programs among the real numbers, with a bound on rounding.

use super::algebras::Space;
use super::program::{Program, Scalar, Vector};

/// What a program is at a point, and how far rounding may have moved it.
pub(super) struct Value {
    pub(super) numbers: Vec<f64>,
    pub(super) error: f64,
}

/// A number and a bound on its error.
type Bounded = (f64, f64);

/// How much an operation may round, here or in the code that is compared.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The largest error of a value that is compared, relative to it or to 1.
const LARGEST_ERROR: f64 = 1e-4;

/// Programs at a point. There is no value where something does not exist, chosen or not, or where
/// rounding decides a sign.
pub(super) struct Interpreter<'a> {
    space: &'a Space,
    v: &'a [f64],
    w: &'a [f64],
    x: f64,
    y: f64,
}

impl<'a> Interpreter<'a> {
    pub(super) fn new(space: &'a Space, numbers: &'a [f64]) -> Self {
        let (v, rest) = numbers.split_at(space.dimension());
        let (w, rest) = rest.split_at(space.dimension());
        Self {
            space,
            v,
            w,
            x: rest[0],
            y: rest[1],
        }
    }

    pub(super) fn value(&self, program: &Program) -> Option<Value> {
        let bounded = match program {
            Program::OfScalar(value) => vec![self.scalar(value)?],
            Program::OfVector(value) => self.vector(value)?,
        };
        let error = bounded
            .iter()
            .map(|(_, error)| *error)
            .fold(1e-300, f64::max);
        let numbers: Vec<f64> = bounded.into_iter().map(|(number, _)| number).collect();
        let size = numbers.iter().fold(1.0_f64, |size, x| size.max(x.abs()));
        (error <= LARGEST_ERROR * size).then_some(Value { numbers, error })
    }

    fn scalar(&self, formula: &Scalar) -> Option<Bounded> {
        let two = |a: &Scalar, b: &Scalar| Some((self.scalar(a)?, self.scalar(b)?));
        Some(match formula {
            Scalar::Constant(numerator, denominator) => {
                let value = *numerator as f64 / *denominator as f64;
                (value, value.abs() * ROUNDING)
            }
            Scalar::X => (self.x, 0.0),
            Scalar::Y => (self.y, 0.0),
            Scalar::Inner(v, w) => self.inner(&self.vector(v)?, &self.vector(w)?),
            Scalar::NormSquared(v) => {
                let v = self.vector(v)?;
                self.inner(&v, &v)
            }
            Scalar::Norm(v) => self.norm(&self.vector(v)?)?,
            Scalar::Root(a) => root(self.scalar(a)?)?,
            Scalar::Absolute(a) => {
                let (a, error) = self.scalar(a)?;
                (a.abs(), error)
            }
            Scalar::Sign(a) => {
                let a = self.scalar(a)?;
                let is_positive = is_less((0.0, 0.0), a)?;
                (if is_positive { 1.0 } else { -1.0 }, 0.0)
            }
            Scalar::Minimum(a, b) => {
                let (a, b) = two(a, b)?;
                (a.0.min(b.0), a.1 + b.1)
            }
            Scalar::Maximum(a, b) => {
                let (a, b) = two(a, b)?;
                (a.0.max(b.0), a.1 + b.1)
            }
            Scalar::Sum(a, b) => {
                let (a, b) = two(a, b)?;
                sum(a, b)
            }
            Scalar::Difference(a, b) => {
                let (a, b) = two(a, b)?;
                sum(a, (-b.0, b.1))
            }
            Scalar::Product(a, b) => {
                let (a, b) = two(a, b)?;
                product(a, b)
            }
            Scalar::Quotient(a, b) => {
                let (a, b) = two(a, b)?;
                product(a, inverse(b)?)
            }
            Scalar::Select(parts) => {
                let [a, b, first, second] = &**parts;
                let (a, b) = two(a, b)?;
                let is_first = is_less(a, b)?;
                let (first, second) = two(first, second)?;
                if is_first { first } else { second }
            }
        })
    }

    fn vector(&self, formula: &Vector) -> Option<Vec<Bounded>> {
        let exact = |numbers: &[f64]| numbers.iter().map(|x| (*x, 0.0)).collect();
        let scaled = |v: Vec<Bounded>, factor: Bounded| -> Vec<Bounded> {
            v.into_iter().map(|x| product(x, factor)).collect()
        };
        Some(match formula {
            Vector::V => exact(self.v),
            Vector::W => exact(self.w),
            Vector::Sum(a, b) | Vector::Difference(a, b) => {
                let sign = if matches!(formula, Vector::Sum(..)) {
                    1.0
                } else {
                    -1.0
                };
                let (a, b) = (self.vector(a)?, self.vector(b)?);
                a.into_iter()
                    .zip(b)
                    .map(|(a, b)| sum(a, (sign * b.0, b.1)))
                    .collect()
            }
            Vector::Scaled(factor, v) => scaled(self.vector(v)?, self.scalar(factor)?),
            Vector::Quotient(v, divisor) => {
                scaled(self.vector(v)?, inverse(self.scalar(divisor)?)?)
            }
            Vector::Normalized(v) => {
                let v = self.vector(v)?;
                let norm = self.norm(&v)?;
                scaled(v, inverse(norm)?)
            }
            Vector::Select(conditions, values) => {
                let [a, b] = &**conditions;
                let is_first = is_less(self.scalar(a)?, self.scalar(b)?)?;
                let [first, second] = &**values;
                let (first, second) = (self.vector(first)?, self.vector(second)?);
                if is_first { first } else { second }
            }
        })
    }

    fn inner(&self, v: &[Bounded], w: &[Bounded]) -> Bounded {
        let numbers = |v: &[Bounded]| v.iter().map(|x| x.0).collect::<Vec<f64>>();
        let errors = |v: &[Bounded]| v.iter().map(|x| x.1).collect::<Vec<f64>>();
        let (inner, size) = self.space.inner(&numbers(v), &numbers(w));
        let moved = self.space.inner(&errors(v), &numbers(w)).1
            + self.space.inner(&numbers(v), &errors(w)).1
            + self.space.inner(&errors(v), &errors(w)).1;
        (inner, moved + ROUNDING * size)
    }

    /// `√|v²|`.
    fn norm(&self, v: &[Bounded]) -> Option<Bounded> {
        let (square, error) = self.inner(v, v);
        root((square.abs(), error))
    }
}

fn sum(a: Bounded, b: Bounded) -> Bounded {
    // The parts may be summed in another order.
    (a.0 + b.0, a.1 + b.1 + ROUNDING * (a.0.abs() + b.0.abs()))
}

fn product(a: Bounded, b: Bounded) -> Bounded {
    let value = a.0 * b.0;
    (
        value,
        a.0.abs() * b.1 + b.0.abs() * a.1 + a.1 * b.1 + ROUNDING * value.abs(),
    )
}

fn inverse(a: Bounded) -> Option<Bounded> {
    let size = a.0.abs();
    if size <= 4.0 * a.1 || size == 0.0 {
        return None;
    }
    Some((1.0 / a.0, 2.0 * a.1 / (size * size) + ROUNDING / size))
}

fn root(a: Bounded) -> Option<Bounded> {
    if a.0 <= 4.0 * a.1 {
        return None;
    }
    let root = a.0.sqrt();
    Some((root, a.1 / root + ROUNDING * root))
}

fn is_less(a: Bounded, b: Bounded) -> Option<bool> {
    let is_certain = (a.0 - b.0).abs() > 4.0 * (a.1 + b.1) + 1e-300;
    is_certain.then_some(a.0 < b.0)
}
