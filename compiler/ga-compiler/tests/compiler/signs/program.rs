//! Random programs over scalars and vectors.

use super::algebras::Space;
use crate::random::Random;

/// The generator of a seed.
pub(super) fn random(seed: u64) -> Random {
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    random.below(2);
    random
}

/// A number of either sign and of one of several sizes.
pub(super) fn number(random: &mut Random) -> f64 {
    let size = (random.below(1 << 20) as f64 + 1.0) / f64::from(1 << 18);
    let scale = [0.1, 1.0, 1.0, 10.0][random.below(4)];
    if random.below(2) == 0 {
        size * scale
    } else {
        -size * scale
    }
}

/// A scalar formula.
#[derive(Clone)]
pub(super) enum Scalar {
    Constant(i64, i64),
    X,
    Y,
    Inner(Box<Vector>, Box<Vector>),
    Norm(Box<Vector>),
    NormSquared(Box<Vector>),
    Root(Box<Scalar>),
    Absolute(Box<Scalar>),
    Sign(Box<Scalar>),
    Minimum(Box<Scalar>, Box<Scalar>),
    Maximum(Box<Scalar>, Box<Scalar>),
    Sum(Box<Scalar>, Box<Scalar>),
    Difference(Box<Scalar>, Box<Scalar>),
    Product(Box<Scalar>, Box<Scalar>),
    Quotient(Box<Scalar>, Box<Scalar>),
    /// The third where the first is less than the second, else the fourth.
    Select(Box<[Scalar; 4]>),
}

/// A vector formula.
#[derive(Clone)]
pub(super) enum Vector {
    V,
    W,
    Sum(Box<Vector>, Box<Vector>),
    Difference(Box<Vector>, Box<Vector>),
    Scaled(Box<Scalar>, Box<Vector>),
    Quotient(Box<Vector>, Box<Scalar>),
    Normalized(Box<Vector>),
    Select(Box<[Scalar; 2]>, Box<[Vector; 2]>),
}

/// A function of the vectors v and w and the scalars x and y.
pub(super) enum Program {
    OfScalar(Scalar),
    OfVector(Vector),
}

impl Program {
    pub(super) fn random(random: &mut Random) -> Self {
        let depth = 1 + random.below(3);
        match random.below(3) {
            0 => Self::OfVector(vector(random, depth)),
            1 => Self::OfVector(nearly_zero_vector(random, depth - 1)),
            _ => Self::OfScalar(scalar(random, depth)),
        }
    }

    pub(super) fn text(&self) -> String {
        let (kind, body) = match self {
            Self::OfScalar(value) => ("Scalar", value.text()),
            Self::OfVector(value) => ("Vector", value.text()),
        };
        format!("fn f(v: Vector, w: Vector, x: Scalar, y: Scalar) -> {kind} {{ {body} }}")
    }

    /// How many numbers it takes.
    pub(super) fn inputs(&self, space: &Space) -> usize {
        2 * space.dimension() + 2
    }
}

fn constant(random: &mut Random) -> Scalar {
    let numerators = [1, 2, 3, 5, 6, 7, 9, 12, 89, 107];
    let numerator = numerators[random.below(10)] * if random.below(3) == 0 { -1 } else { 1 };
    Scalar::Constant(numerator, [1, 1, 1, 2, 3, 7][random.below(6)])
}

fn scalar(random: &mut Random, depth: usize) -> Scalar {
    use Scalar as S;
    if depth == 0 {
        return match random.below(6) {
            0 => constant(random),
            1 | 2 => S::X,
            3 => S::Y,
            4 => S::Norm(Box::new(vector(random, 0))),
            _ => S::NormSquared(Box::new(vector(random, 0))),
        };
    }
    let below = depth - 1;
    if random.below(4) == 0 {
        return nearly_zero(random, below);
    }
    let kind = random.below(15);
    let mut next = || Box::new(scalar(random, below));
    match kind {
        0 => S::Sum(next(), next()),
        1 => S::Difference(next(), next()),
        2 => S::Product(next(), next()),
        3 => S::Quotient(next(), next()),
        4 => S::Absolute(next()),
        5 => S::Sign(next()),
        6 => S::Minimum(next(), next()),
        7 => S::Maximum(next(), next()),
        8 => S::Root(Box::new(S::Absolute(next()))),
        9 => {
            let same = next();
            S::Root(Box::new(S::Product(same.clone(), same)))
        }
        10 => S::Root(next()),
        11 => S::Select(Box::new([(); 4].map(|()| *next()))),
        12 => S::Norm(Box::new(vector(random, below))),
        13 => S::Inner(
            Box::new(vector(random, below)),
            Box::new(vector(random, below)),
        ),
        _ => S::Product(Box::new(constant(random)), Box::new(scalar(random, below))),
    }
}

fn vector(random: &mut Random, depth: usize) -> Vector {
    if depth == 0 {
        return if random.below(2) == 0 {
            Vector::V
        } else {
            Vector::W
        };
    }
    let below = depth - 1;
    if random.below(5) == 0 {
        return nearly_zero_vector(random, below);
    }
    let kind = random.below(8);
    if kind < 3 {
        let factor = if kind == 0 {
            scalar(random, below)
        } else {
            constant(random)
        };
        return Vector::Scaled(Box::new(factor), Box::new(vector(random, below)));
    }
    if kind == 3 {
        let conditions = Box::new([scalar(random, below), scalar(random, below)]);
        return Vector::Select(
            conditions,
            Box::new([vector(random, below), vector(random, below)]),
        );
    }
    if kind == 4 {
        let divisor = scalar(random, below);
        return Vector::Quotient(Box::new(vector(random, below)), Box::new(divisor));
    }
    let mut next = || Box::new(vector(random, below));
    match kind {
        5 => Vector::Sum(next(), next()),
        6 => Vector::Difference(next(), next()),
        _ => Vector::Normalized(next()),
    }
}

/// The difference of two formulas that are equal, or would be if some number were positive.
fn nearly_zero(random: &mut Random, depth: usize) -> Scalar {
    use Scalar as S;
    let boxed = |value: S| Box::new(value);
    let (a, b) = (scalar(random, depth), scalar(random, depth));
    let (v, c) = (vector(random, depth), constant(random));
    let size = |x: &S| boxed(S::Absolute(boxed(x.clone())));
    let times = |x: &S, y: &S| boxed(S::Product(boxed(x.clone()), boxed(y.clone())));
    let scaled =
        |c: &S, v: &Vector| Box::new(Vector::Scaled(boxed(c.clone()), Box::new(v.clone())));
    let (left, right) = match random.below(9) {
        0 => (
            boxed(S::Norm(scaled(&c, &v))),
            times(&c, &S::Norm(Box::new(v))),
        ),
        1 => (
            boxed(S::Norm(scaled(&a, &v))),
            times(&S::Absolute(boxed(a)), &S::Norm(Box::new(v))),
        ),
        2 => (boxed(S::Root(times(&a, &a))), size(&a)),
        3 => (boxed(S::Root(times(&a, &a))), boxed(a)),
        4 => (
            boxed(S::Absolute(times(&a, &b))),
            boxed(S::Product(size(&a), size(&b))),
        ),
        5 => (
            times(&S::Root(boxed(a.clone())), &S::Root(boxed(b.clone()))),
            boxed(S::Root(times(&a, &b))),
        ),
        6 => (
            times(&S::Sign(boxed(a.clone())), &S::Absolute(boxed(a.clone()))),
            boxed(a),
        ),
        7 => {
            let sum = boxed(S::Sum(boxed(a.clone()), boxed(b.clone())));
            let (least, most) = (
                S::Minimum(boxed(a.clone()), boxed(b.clone())),
                S::Maximum(boxed(b), boxed(a)),
            );
            (boxed(S::Sum(boxed(least), boxed(most))), sum)
        }
        _ => (
            boxed(S::Absolute(times(&c, &a))),
            times(&c, &S::Absolute(boxed(a))),
        ),
    };
    if random.below(4) == 0 {
        S::Sum(left, right)
    } else {
        S::Difference(left, right)
    }
}

fn nearly_zero_vector(random: &mut Random, depth: usize) -> Vector {
    let (v, c) = (vector(random, depth), constant(random));
    let norm = |v: &Vector| Box::new(Scalar::Norm(Box::new(v.clone())));
    let scaled =
        |c: &Scalar, v: &Vector| Box::new(Vector::Scaled(Box::new(c.clone()), Box::new(v.clone())));
    let normalized = |v: Box<Vector>| Box::new(Vector::Normalized(v));
    let (left, right) = match random.below(4) {
        0 => {
            let unit = normalized(Box::new(v.clone()));
            (
                Box::new(Vector::Scaled(norm(&scaled(&c, &v)), unit)),
                Box::new(v),
            )
        }
        1 => (normalized(scaled(&c, &v)), normalized(Box::new(v))),
        2 => (
            Box::new(Vector::Quotient(scaled(&c, &v), norm(&scaled(&c, &v)))),
            Box::new(v),
        ),
        _ => {
            let unit = normalized(Box::new(v.clone()));
            (
                Box::new(Vector::Quotient(Box::new(v.clone()), norm(&v))),
                unit,
            )
        }
    };
    if random.below(4) == 0 {
        Vector::Sum(left, right)
    } else {
        Vector::Difference(left, right)
    }
}

impl Scalar {
    fn text(&self) -> String {
        match self {
            Self::Constant(numerator, 1) => format!("({numerator})"),
            Self::Constant(numerator, denominator) => format!("({numerator}/{denominator})"),
            Self::X => "x".to_owned(),
            Self::Y => "y".to_owned(),
            Self::Inner(v, w) => format!("scalar_product({}, {})", v.text(), w.text()),
            Self::Norm(v) => format!("norm({})", v.text()),
            Self::NormSquared(v) => format!("norm_squared({})", v.text()),
            Self::Root(a) => format!("sqrt({})", a.text()),
            Self::Absolute(a) => format!("abs({})", a.text()),
            Self::Sign(a) => format!("sign({})", a.text()),
            Self::Minimum(a, b) => format!("min({}, {})", a.text(), b.text()),
            Self::Maximum(a, b) => format!("max({}, {})", a.text(), b.text()),
            Self::Sum(a, b) => format!("({} + {})", a.text(), b.text()),
            Self::Difference(a, b) => format!("({} - {})", a.text(), b.text()),
            Self::Product(a, b) => format!("({} * {})", a.text(), b.text()),
            Self::Quotient(a, b) => format!("({} / {})", a.text(), b.text()),
            Self::Select(parts) => {
                let [a, b, c, d] = parts.each_ref().map(Self::text);
                format!("select({a} < {b}, {c}, {d})")
            }
        }
    }
}

impl Vector {
    fn text(&self) -> String {
        match self {
            Self::V => "v".to_owned(),
            Self::W => "w".to_owned(),
            Self::Sum(a, b) => format!("({} + {})", a.text(), b.text()),
            Self::Difference(a, b) => format!("({} - {})", a.text(), b.text()),
            Self::Scaled(c, v) => format!("({} * {})", c.text(), v.text()),
            Self::Quotient(v, c) => format!("({} / {})", v.text(), c.text()),
            Self::Normalized(v) => format!("normalize({})", v.text()),
            Self::Select(conditions, values) => {
                let [a, b] = conditions.each_ref().map(Scalar::text);
                let [c, d] = values.each_ref().map(Self::text);
                format!("select({a} < {b}, {c}, {d})")
            }
        }
    }
}
