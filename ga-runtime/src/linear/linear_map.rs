//! Linear maps as the images of basis elements.

use alloc::vec::Vec;
use core::fmt::{Debug, Display, Formatter, Result as FormatResult};
use core::ops::{Add, Mul};

use crate::Element;
use crate::scalar::{Real, Ring};

/// A linear map from the elements of one type to those of another, as the images of the basis
/// elements: its columns.
///
/// Both are types whose sums are members, such as vectors, bivectors, lines or multivectors. A
/// conformal [`Point`](crate::cga3::Point) or a unit versor is not linear; use the type that
/// contains it, such as [`RoundVector`](crate::cga3::RoundVector).
///
/// ```
/// use ga_runtime::cga3::{DualPlane, OddVersor, RoundVector};
/// use ga_runtime::linear::LinearMap;
/// // The reflection in the plane z = 1 as a map of conformal vectors e1, e2, e3, eo, ei.
/// let mirror = OddVersor::reflection(DualPlane::new(0.0, 0.0, 1.0, 1.0)).unwrap();
/// let map = LinearMap::of(|x: RoundVector<f64>| mirror.transform(x));
/// let rows: [[f64; 5]; 5] = map.to_rows();
/// assert_eq!(rows[2], [0.0, 0.0, -1.0, 2.0, 0.0]);
/// assert_eq!(rows[4], [0.0, 0.0, -2.0, 2.0, 1.0]);
/// let x = RoundVector::new(1.0, 2.0, 3.0, 1.0, 7.0);
/// assert_eq!(map.apply(x), mirror.transform(x));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct LinearMap<A, B> {
    columns: Vec<B>,
    domain: core::marker::PhantomData<fn(A)>,
}

/// A function that is not linear: at an element its value is not the sum of the values at the
/// parts of the element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotLinear<A, B> {
    /// The element.
    pub element: A,
    /// The sum of the values at its parts.
    pub expected: B,
    /// The value of the function.
    pub found: B,
}

impl<A: Debug, B: Debug> Display for NotLinear<A, B> {
    fn fmt(&self, f: &mut Formatter<'_>) -> FormatResult {
        let Self {
            element,
            expected,
            found,
        } = self;
        write!(
            f,
            "the function is not linear: its value at {element:?} is {found:?} instead of {expected:?}"
        )
    }
}

impl<A: Debug, B: Debug> core::error::Error for NotLinear<A, B> {}

impl<A, B> LinearMap<A, B>
where
    A: Element + Add<Output = A>,
    B: Element<Scalar = A::Scalar> + Add<Output = B>,
{
    /// The map of a function that is linear, by its values at the basis elements. Of a function
    /// that is not, these values say nothing about others: [`try_of`](Self::try_of) tests it.
    ///
    /// ```
    /// use ga_runtime::cga3::{Circle, Point, RoundVector, Sphere};
    /// use ga_runtime::linear::LinearMap;
    /// // The join with a circle: from vectors to spheres, a matrix with five rows and columns.
    /// let [p, q, r, s] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 2.0]]
    ///     .map(Point::from);
    /// let circle = Circle::through(p, q, r);
    /// let join = LinearMap::of(|x: RoundVector<f64>| circle ^ x);
    /// let sphere = Sphere::try_from(join.apply(s.into())).unwrap();
    /// assert!(sphere.centre.distance(Sphere::through(p, q, r, s).centre) < 1e-15);
    /// ```
    #[must_use]
    pub fn of(function: impl Fn(A) -> B) -> Self {
        let basis = A::BLADES.iter();
        Self::of_columns(basis.map(|&blade| function(basis_element(blade))).collect())
    }

    /// The map of a function, if it is linear at sample elements: zero, multiples of the basis
    /// elements, sums of two of them, and sums of all with several factors. The values may deviate
    /// by the tolerance times the largest coefficient among the values at the basis elements.
    ///
    /// A function may deviate elsewhere, by a branch for instance.
    ///
    /// # Errors
    /// [`NotLinear`] with the first of these elements at which the function deviates.
    ///
    /// ```
    /// use ga_runtime::linear::LinearMap;
    /// use ga_runtime::vga3::Vector;
    /// let axis = Vector::new(0.0, 0.0, 1.0);
    /// let cross = LinearMap::try_of(|x: Vector<f64>| axis.cross(x), 1e-12).unwrap();
    /// assert_eq!(cross.to_rows(), [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0; 3]]);
    /// // A translation is not linear in vectors: it moves the origin.
    /// let error = LinearMap::try_of(|x: Vector<f64>| x + axis, 1e-12).unwrap_err();
    /// assert_eq!((error.element, error.found), (Vector::default(), axis));
    /// ```
    pub fn try_of(function: impl Fn(A) -> B, tolerance: A::Scalar) -> Result<Self, NotLinear<A, B>>
    where
        A::Scalar: Real<Mask = bool>,
    {
        let map = Self::of(&function);
        let size = map.columns.iter().fold(A::Scalar::zero(), |most, column| {
            let coefficients = B::BLADES
                .iter()
                .map(|&blade| column.coefficient(blade).abs());
            coefficients.fold(most, Real::max)
        });
        let allowed = tolerance * size;
        for factors in samples(A::BLADES.len()) {
            let mut factors = factors.iter().copied();
            let element = A::from_coefficients_unchecked(&mut |_| {
                factors
                    .next()
                    .map_or(A::Scalar::zero(), A::Scalar::from_integer)
            });
            let (expected, found) = (map.apply(element), function(element));
            let is_equal = B::BLADES.iter().all(|&blade| {
                let deviation = found.coefficient(blade) - expected.coefficient(blade);
                deviation.abs().less_or_equal(allowed)
            });
            if !is_equal {
                return Err(NotLinear {
                    element,
                    expected,
                    found,
                });
            }
        }
        Ok(map)
    }

    /// The map of a matrix, an array of rows: one row for each blade of B, one column for each of
    /// A. Another size does not compile.
    #[must_use]
    pub fn from_rows<const ROWS: usize, const COLUMNS: usize>(
        rows: [[A::Scalar; COLUMNS]; ROWS],
    ) -> Self {
        const { assert!(ROWS == B::BLADES.len(), "one row for each blade of B") };
        const { assert!(COLUMNS == A::BLADES.len(), "one column for each blade of A") };
        let column = |column: usize| {
            B::from_coefficients_unchecked(&mut |blade| match place::<B>(blade) {
                Some(row) => rows[row][column],
                None => A::Scalar::zero(),
            })
        };
        Self::of_columns((0..COLUMNS).map(column).collect())
    }

    /// The matrix as an array of rows: one row for each blade of B, one column for each of A.
    /// Another size does not compile.
    #[must_use]
    pub fn to_rows<const ROWS: usize, const COLUMNS: usize>(&self) -> [[A::Scalar; COLUMNS]; ROWS] {
        const { assert!(ROWS == B::BLADES.len(), "one row for each blade of B") };
        const { assert!(COLUMNS == A::BLADES.len(), "one column for each blade of A") };
        core::array::from_fn(|row| {
            core::array::from_fn(|column| self.columns[column].coefficient(B::BLADES[row]))
        })
    }

    /// The images of the basis elements of A, in the order of its blades.
    #[must_use]
    pub fn columns(&self) -> &[B] {
        &self.columns
    }

    /// The image of an element.
    #[must_use]
    pub fn apply(&self, element: A) -> B {
        B::from_coefficients_unchecked(&mut |blade| {
            let terms = A::BLADES.iter().zip(&self.columns);
            terms.fold(A::Scalar::zero(), |sum, (&of, column)| {
                element
                    .coefficient(of)
                    .mul_add(column.coefficient(blade), sum)
            })
        })
    }

    pub(super) fn of_columns(columns: Vec<B>) -> Self {
        Self {
            columns,
            domain: core::marker::PhantomData,
        }
    }
}

/// One map after the other, the right one first.
impl<A, B, C> Mul<&LinearMap<A, B>> for &LinearMap<B, C>
where
    A: Element + Add<Output = A>,
    B: Element<Scalar = A::Scalar> + Add<Output = B>,
    C: Element<Scalar = A::Scalar> + Add<Output = C>,
{
    type Output = LinearMap<A, C>;

    fn mul(self, first: &LinearMap<A, B>) -> LinearMap<A, C> {
        LinearMap::of_columns(first.columns.iter().map(|&b| self.apply(b)).collect())
    }
}

/// The element whose only coefficient is 1, of this blade.
fn basis_element<A: Element>(of: usize) -> A {
    A::from_coefficients_unchecked(&mut |blade| {
        if blade == of {
            A::Scalar::one()
        } else {
            A::Scalar::zero()
        }
    })
}

/// The place of a blade in the order of the type.
fn place<B: Element>(blade: usize) -> Option<usize> {
    B::BLADES.iter().position(|&other| other == blade)
}

/// Factors of the basis elements by which linearity is tested.
fn samples(count: usize) -> impl Iterator<Item = Vec<i64>> {
    let with = move |terms: &[(usize, i64)]| {
        let mut factors = alloc::vec![0; count];
        for &(place, factor) in terms {
            factors[place] += factor;
        }
        factors
    };
    let multiples = (0..count).flat_map(move |k| [2, -1].map(|factor| with(&[(k, factor)])));
    let pairs = (0..count).flat_map(move |k| (0..k).map(move |l| with(&[(l, 1), (k, 1)])));
    // Residues of a linear congruence, from −8 to 8.
    let several = (1..5).map(move |seed: usize| {
        let factor = |k: usize| ((k + 1) * (5 * seed + 2) + seed * seed) % 17;
        (0..count).map(|k| factor(k) as i64 - 8).collect()
    });
    core::iter::once(with(&[]))
        .chain(multiples)
        .chain(pairs)
        .chain(several)
}
