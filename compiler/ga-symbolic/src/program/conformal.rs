//! The conformal model in an algebra: its points, its infinity and its origin, found from the
//! metric and the declared types, whatever their names are.

use crate::algebra::{Algebra, Blade, Ratio};
use crate::define::{Definition, PolynomialStep, Role, TypeDefinition};

/// A vector as the coefficients of the basis vectors.
type Vector = Vec<Ratio>;

/// The points of a conformal model.
#[derive(Clone)]
pub struct Conformal<'a> {
    /// The type of points: null vectors P with `P·N = 1`.
    pub point: &'a TypeDefinition,
    /// The null vector N of infinity.
    pub infinity: Vec<(Blade, Ratio)>,
    /// The point whose stored coefficients are zero.
    pub origin: Vec<(Blade, Ratio)>,
}

impl<'a> Conformal<'a> {
    /// All conformal models among the types of an algebra, one for each type of points.
    pub fn all(definition: &'a Definition) -> Vec<Self> {
        let types = definition.types.iter();
        types
            .filter_map(|kind| Self::of(&definition.algebra, kind))
            .collect()
    }

    /// The model whose points have a type, if they are null vectors with two coefficients fewer
    /// than the space has, that have the same inner product with one null vector alone.
    pub(crate) fn of(algebra: &Algebra, kind: &'a TypeDefinition) -> Option<Self> {
        let dimension = algebra.dimension();
        let stored = kind.stored().count();
        let is_candidate = kind.facts_are_implied
            && stored + 2 == dimension
            && kind.coefficients.iter().all(|c| c.blade.grade() == 1);
        if !is_candidate {
            return None;
        }
        let points = members(kind, dimension);
        let is_null = |v: &Vector| inner(algebra, v, v).is_zero();
        if !points.iter().all(is_null) {
            return None;
        }
        let infinity = with_unit_products(algebra, &points).filter(is_null)?;
        Some(Self {
            point: kind,
            infinity: terms(&infinity),
            origin: terms(points.first()?),
        })
    }
}

/// Enough members of a type of vectors for equations that hold for all of them: small whole numbers
/// in one or two of the stored coefficients. The first has zeros.
fn members(kind: &TypeDefinition, dimension: usize) -> Vec<Vector> {
    let count = kind.stored().count();
    let mut choices = vec![vec![0; count]];
    for first in 0..count {
        for value in [1, 2] {
            let mut choice = vec![0; count];
            choice[first] = value;
            choices.push(choice.clone());
            if let Some(next) = choice.get_mut(first + 1) {
                *next = 3;
                choices.push(choice);
            }
        }
    }
    let choices = choices.into_iter();
    choices
        .map(|choice| member(kind, &choice, dimension))
        .collect()
}

fn member(kind: &TypeDefinition, stored: &[i128], dimension: usize) -> Vector {
    let mut fields = stored.iter().map(|value| Ratio::integer(*value));
    let written: Vec<Ratio> = kind
        .coefficients
        .iter()
        .map(|coefficient| match coefficient.role {
            Role::Stored => fields.next().unwrap_or(Ratio::ZERO),
            Role::Constant(value) => value,
            Role::Derived(_) => Ratio::ZERO,
        })
        .collect();
    let mut vector = vec![Ratio::ZERO; dimension];
    for (coefficient, known) in kind.coefficients.iter().zip(&written) {
        let value = match &coefficient.role {
            Role::Derived(polynomial) => polynomial.evaluate(
                &mut |constant| constant,
                &mut |place| written[place],
                &mut |step, a, b| match step {
                    PolynomialStep::Sum => a + b,
                    PolynomialStep::Product => a * b,
                },
            ),
            Role::Stored | Role::Constant(_) => *known,
        };
        for index in coefficient.blade.vectors() {
            vector[index] = if coefficient.is_negative {
                -value
            } else {
                value
            };
        }
    }
    vector
}

fn inner(algebra: &Algebra, a: &[Ratio], b: &[Ratio]) -> Ratio {
    let metric = algebra.metric();
    let mut sum = Ratio::ZERO;
    for (row, x) in a.iter().enumerate() {
        for (column, y) in b.iter().enumerate() {
            sum = sum + *x * metric.get(row, column) * *y;
        }
    }
    sum
}

/// The only vector whose inner product with each of some vectors is 1, by Gauss–Jordan elimination.
/// `None` where there is none or more than one, or the numbers get too large.
fn with_unit_products(algebra: &Algebra, vectors: &[Vector]) -> Option<Vector> {
    let dimension = algebra.dimension();
    let metric = algebra.metric();
    let equation = |vector: &Vector| -> Vector {
        let product = |column: usize| {
            let terms = vector.iter().enumerate();
            terms.fold(Ratio::ZERO, |sum, (row, x)| {
                sum + *x * metric.get(row, column)
            })
        };
        (0..dimension).map(product).chain([Ratio::ONE]).collect()
    };
    let mut rows: Vec<Vector> = vectors.iter().map(equation).collect();
    for column in 0..dimension {
        let pivot = (column..rows.len()).find(|&row| !rows[row][column].is_zero())?;
        rows.swap(column, pivot);
        let inverse = rows[column][column].recip()?;
        let pivot_row: Vector = rows[column].iter().map(|x| *x * inverse).collect();
        for row in &mut rows {
            let factor = row[column];
            for (x, y) in row.iter_mut().zip(&pivot_row) {
                *x = *x + -(factor * *y);
            }
        }
        rows[column] = pivot_row;
    }
    let (solved, rest) = rows.split_at(dimension);
    let is_consistent = rest.iter().all(|row| row[dimension].is_zero());
    let solution: Vector = solved.iter().map(|row| row[dimension]).collect();
    let is_exact = solution.iter().all(|x| !x.is_out_of_range());
    (is_consistent && is_exact).then_some(solution)
}

fn terms(vector: &[Ratio]) -> Vec<(Blade, Ratio)> {
    let terms = vector.iter().enumerate();
    terms
        .filter(|(_, value)| !value.is_zero())
        .map(|(index, value)| (Blade::vector(index), *value))
        .collect()
}
