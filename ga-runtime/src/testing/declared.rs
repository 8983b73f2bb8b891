//! Members of declared types, and tests generated from declarations.

use alloc::vec::Vec;

use proptest::collection::vec;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestCaseError, TestRunner};

use super::quiet::quietly;
use super::strategy::prime;
use crate::Element;
use crate::dense::{Algebra, Multivector};
use crate::scalar::{Field, Prime61};

/// Emits one test for each declared product of an algebra, which demands exact equality with the
/// dense reference over the prime field on random members of the operands' types, and one for the
/// arithmetic of each type.
///
/// The tests come from the declaration, so that a product is tested as soon as it is declared.
/// Types by parameters that cannot be read, or whose formulas have roots or angles, have no members
/// over the prime field, and no tests.
///
/// ```
/// ga_runtime::algebra! {
///     mod vga2 {
///         basis e1, e2;
///         signature 2, 0, 0;
///         /// A vector.
///         struct Vector { e1, e2 }
///         /// A bivector.
///         struct Bivector { e12 }
///         products { wedge(Vector, Vector); }
///     }
/// }
/// # mod tests {
/// ga_runtime::testing::product_tests!(super::vga2);
/// # }
/// # fn main() {}
/// ```
#[doc(hidden)]
#[macro_export]
macro_rules! __product_tests {
    ($($algebra:tt)*) => {
        $($algebra)* ! { [$crate::__private::macros::product_tests] $($algebra)* }
    };
}

/// The number of random cases of each test.
const CASES: u32 = 256;

/// The dense algebra of a metric given as fractions, its basis vectors named e1, e2 and so on;
/// with the names of a declared algebra: [`Algebra::of`].
///
/// # Panics
/// If the metric is not square and symmetric. That of a declared algebra always is.
pub fn algebra_of<S: Field>(metric: &[&[(i64, i64)]]) -> Algebra<S> {
    let entry = |&(numerator, denominator): &(i64, i64)| S::from_ratio(numerator, denominator);
    let rows = metric.iter().map(|row| row.iter().map(entry).collect());
    match Algebra::new(rows.collect()) {
        Ok(algebra) => algebra,
        Err(error) => panic!("the metric of a declared algebra is invalid: {error}"),
    }
}

/// All coefficients of an element, with the names of its basis vectors, whatever those of the
/// algebra are.
///
/// ```
/// use ga_runtime::cga3::Point;
/// use ga_runtime::testing::{algebra_of, to_dense};
///
/// let algebra = algebra_of(ga_runtime::cga3::METRIC);
/// let dense = to_dense(&algebra, &Point::new(1.0, 0.0, 0.0));
/// assert_eq!(dense.to_string(), "e1 + eo + 0.5 ei");
/// ```
pub fn to_dense<T: Element>(algebra: &Algebra<T::Scalar>, element: &T) -> Multivector<T::Scalar> {
    if algebra.names().iter().eq(T::BASIS) {
        return algebra.element(element);
    }
    match algebra.with_names(T::BASIS.iter().copied()) {
        Ok(named) => named.element(element),
        Err(_) => algebra.element(element),
    }
}

/// The dense form of constants given as (blade, numerator, denominator).
pub fn constant_to_dense<S: Field>(
    algebra: &Algebra<S>,
    terms: &[(usize, i64, i64)],
) -> Multivector<S> {
    algebra.zero().map(|blade, zero| {
        terms
            .iter()
            .filter(|(other, ..)| *other == blade)
            .fold(zero, |sum, &(_, n, d)| sum + S::from_ratio(n, d))
    })
}

/// Random members of a declared type, their free numbers drawn from `number`.
///
/// If any stored coefficients make a member, they are the free numbers. Unit versors are products
/// of `(1 + αb)²/(1 − α²b²)` with random α over the 2-blades b of the basis that the type has or
/// that its vectors span; for a type of vectors, that versor acts on a basis vector of square 1.
/// Members of a type of blades of one grade are outer products of vectors: of those basis vectors
/// that all of its blades contain, and of sums of the others with free coefficients.
/// Over floating point, `number` should be within ±0.9.
///
/// ```
/// use ga_runtime::cga3::{Motor, Point};
/// use ga_runtime::testing::{assert_close, member, strategy};
/// use proptest::prelude::*;
///
/// let motors = member::<Motor<f64>>(strategy::float(0.9));
/// let points = member::<Point<f64>>(strategy::float(10.0));
/// proptest!(|(motor in motors, p in points.clone(), q in points)| {
///     let moved = motor.transform(p).distance(motor.transform(q));
///     assert_close!(moved, p.distance(q), 1e-12, 100.0);
/// });
/// ```
pub fn member<T: Element<Scalar: Field> + core::fmt::Debug>(
    number: impl Strategy<Value = T::Scalar> + Clone,
) -> impl Strategy<Value = T> + Clone {
    let members = Members::new(T::METRIC, T::BLADES, T::IS_FREE);
    vec(number, members.count()).prop_filter_map("a plane with α²b² = 1", move |numbers| {
        members.member(&numbers)
    })
}

/// Random members over the prime field.
pub fn exact_member<T: Element<Scalar = Prime61> + core::fmt::Debug>()
-> impl Strategy<Value = T> + Clone {
    member::<T>(prime())
}

/// A strategy for the one value of a constant.
pub fn only<T: Clone + core::fmt::Debug>(value: T) -> impl Strategy<Value = T> + Clone {
    Just(value)
}

/// Runs a test on random values, the same in every run unless the variable `PROPTEST_RNG_SEED` asks
/// for others. A test that fails panics, and the values are then shrunk.
///
/// # Panics
/// Once, with the smallest failing values that were found and with the panic of the test for them.
pub fn for_all<V: Strategy>(strategy: V, test: impl Fn(V::Value)) {
    let outcome = runner().run(&strategy, |values| {
        quietly(|| test(values)).map_err(TestCaseError::fail)
    });
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
}

/// A runner that tries the same cases in every run, unless the environment gives a seed.
pub(super) fn runner() -> TestRunner {
    let default = Config::default();
    TestRunner::new(Config {
        cases: CASES,
        failure_persistence: None,
        rng_seed: match default.rng_seed {
            RngSeed::Random => RngSeed::Fixed(1),
            given => given,
        },
        ..default
    })
}

/// The construction of members of a type from free numbers. It is not generic over the type, so
/// that it is compiled once for all types.
#[derive(Clone)]
pub struct Members<S> {
    algebra: Algebra<S>,
    blades: &'static [usize],
    is_free: bool,
    planes: Vec<BasisPlane<S>>,
    /// For a type of blades, what they are made of.
    factors: Option<Factors>,
}

impl<S: Field> Members<S> {
    /// For a type with these blades: of any coefficients if `is_free`, otherwise of blades where
    /// all have the same grade, 2 or more, and of unit versors where not.
    ///
    /// # Panics
    /// If the metric is not that of a declared algebra.
    #[must_use]
    pub fn new(metric: &[&[(i64, i64)]], blades: &'static [usize], is_free: bool) -> Self {
        let algebra = algebra_of(metric);
        let factors = Factors::of(blades).filter(|_| !is_free);
        let planes = if is_free || factors.is_some() {
            Vec::new()
        } else {
            planes(&algebra, blades)
        };
        Self {
            algebra,
            blades,
            is_free,
            planes,
            factors,
        }
    }

    /// The number of free numbers of a member.
    #[must_use]
    pub fn count(&self) -> usize {
        match &self.factors {
            _ if self.is_free => self.blades.len(),
            Some(factors) => factors.count * factors.vectors.len(),
            None => self.planes.len(),
        }
    }

    /// The member of some numbers. `None` where a divisor happens to be zero.
    #[must_use]
    pub fn member<T: Element<Scalar = S>>(&self, numbers: &[S]) -> Option<T> {
        if self.is_free {
            let mut numbers = numbers.iter().copied();
            let mut next = |_| numbers.next().unwrap_or_else(S::zero);
            return Some(T::from_coefficients_unchecked(&mut next));
        }
        let of_type = |dense: &Multivector<S>| -> T {
            T::from_coefficients_unchecked(&mut |blade| dense.coefficient(blade))
        };
        let Some(factors) = &self.factors else {
            return Some(of_type(&self.unit_versor(numbers)?));
        };
        let dense = factors.product(&self.algebra, numbers)?;
        let element = of_type(&dense);
        // A constant coefficient is that of a multiple of the blade.
        let is_changed =
            |blade: &&usize| element.coefficient(**blade) != dense.coefficient(**blade);
        let Some(&constant) = self.blades.iter().find(is_changed) else {
            return Some(element);
        };
        let found = dense.coefficient(constant);
        let scale = element.coefficient(constant) / found;
        (found != S::zero()).then(|| of_type(&dense.scale(scale)))
    }

    fn unit_versor(&self, numbers: &[S]) -> Option<Multivector<S>> {
        let one = S::one();
        let mut versor = self.algebra.one();
        for (plane, &alpha) in self.planes.iter().zip(numbers) {
            let square = alpha * alpha * plane.square;
            let norm = one - square;
            if norm == S::zero() {
                return None;
            }
            // (1 + αb)² = 1 + α²b² + 2αb
            let (scalar, bivector) = ((one + square) / norm, (alpha + alpha) / norm);
            versor = versor.scale(scalar) + versor.geometric(&plane.blade.scale(bivector));
        }
        let is_even = |blade: &usize| blade.count_ones().is_multiple_of(2);
        if self.blades.iter().any(is_even) {
            return Some(versor);
        }
        let unit = self
            .blades
            .iter()
            .filter_map(|&blade| self.algebra.blade(blade).ok())
            .find(|vector| vector.scalar_product(vector) == one)?;
        Some(if self.blades.iter().all(|blade| blade.count_ones() == 1) {
            versor.sandwich(&unit)
        } else {
            versor.geometric(&unit)
        })
    }
}

/// What the blades of a type of one grade are made of.
#[derive(Clone)]
struct Factors {
    /// The basis vectors that every blade of the type contains, together.
    common: usize,
    /// The other basis vectors.
    vectors: Vec<usize>,
    /// How many sums of the others are the further factors.
    count: usize,
}

impl Factors {
    /// `None` for blades of several grades, and of grades in which everything is a blade.
    fn of(blades: &[usize]) -> Option<Self> {
        let grade = blades.first()?.count_ones();
        if grade < 2 || blades.iter().any(|blade| blade.count_ones() != grade) {
            return None;
        }
        let all = blades.iter().fold(0, |all, blade| all | blade);
        let common = blades.iter().fold(all, |common, blade| common & blade);
        let bits = (0..usize::BITS).map(|bit| 1 << bit);
        Some(Self {
            common,
            vectors: bits.filter(|bit| all & !common & bit != 0).collect(),
            count: grade.checked_sub(common.count_ones())? as usize,
        })
    }

    fn product<S: Field>(&self, algebra: &Algebra<S>, numbers: &[S]) -> Option<Multivector<S>> {
        let mut blade = algebra.blade(self.common).ok()?;
        for coefficients in numbers.chunks(self.vectors.len().max(1)) {
            let mut vector = algebra.zero();
            for (&bit, &coefficient) in self.vectors.iter().zip(coefficients) {
                vector.set_coefficient(bit, coefficient).ok()?;
            }
            blade = blade.wedge(&vector);
        }
        Some(blade)
    }
}

/// A 2-blade of the basis.
#[derive(Clone)]
struct BasisPlane<S> {
    blade: Multivector<S>,
    square: S,
}

/// The planes in which the versors of a type rotate: its 2-blades, and those that its vectors span.
fn planes<S: Field>(algebra: &Algebra<S>, blades: &[usize]) -> Vec<BasisPlane<S>> {
    let of_grade = |grade: u32| {
        let is_of_grade = move |blade: &usize| blade.count_ones() == grade;
        blades.iter().copied().filter(is_of_grade)
    };
    let vectors: Vec<_> = of_grade(1).collect();
    let spanned = vectors
        .iter()
        .flat_map(|a| vectors.iter().filter(move |b| *b > a).map(move |b| a | b));
    let mut planes: Vec<_> = of_grade(2).chain(spanned).collect();
    planes.sort_unstable();
    planes.dedup();
    let blades = planes.iter().filter_map(|&plane| algebra.blade(plane).ok());
    blades
        .map(|blade| BasisPlane {
            square: blade.scalar_product(&blade),
            blade,
        })
        .collect()
}
