//! Outermorphisms: linear maps of vectors, extended to all grades.

use alloc::vec::Vec;
use core::ops::Add;

use super::LinearMap;
use crate::element::{default_tolerance, member};
use crate::scalar::{Real, Ring};
use crate::{Element, NotMember};

impl<A, B> LinearMap<A, B>
where
    A: Element + Add<Output = A>,
    B: Element<Scalar = A::Scalar> + Add<Output = B>,
{
    /// The extension of a linear map of vectors to other types, with `f(a ∧ b) = f(a) ∧ f(b)`
    /// (Dorst, Fontijne and Mann, Geometric Algebra for Computer Science, 2007, chapter 4). Scalars
    /// stay as they are, and the pseudoscalar is multiplied by the determinant.
    ///
    /// A and B must be types of all vectors of their algebras, and C and D types of the same
    /// algebras; others do not compile.
    ///
    /// # Errors
    /// [`NotMember`] where the image of a blade of C has a blade that D does not have, within a
    /// tolerance of 1024 ε.
    ///
    /// ```
    /// use ga_runtime::linear::LinearMap;
    /// use ga_runtime::vga3::{Bivector, Vector};
    /// // A scaling by 2, 3 and 5 along the axes multiplies areas by the products of two of these.
    /// let stretch = LinearMap::<Vector<f64>, Vector<f64>>::from_rows([
    ///     [2.0, 0.0, 0.0],
    ///     [0.0, 3.0, 0.0],
    ///     [0.0, 0.0, 5.0],
    /// ]);
    /// let areas = stretch.outermorphism::<Bivector<f64>, Bivector<f64>>().unwrap();
    /// let (a, b) = (Vector::new(1.0, 2.0, 3.0), Vector::new(-1.0, 0.5, 2.0));
    /// assert_eq!(areas.apply(a ^ b), stretch.apply(a) ^ stretch.apply(b));
    /// assert_eq!(stretch.determinant(), 30.0);
    /// ```
    pub fn outermorphism<C, D>(&self) -> Result<LinearMap<C, D>, NotMember>
    where
        A::Scalar: Real<Mask = bool>,
        C: Element<Scalar = A::Scalar> + Add<Output = C>,
        D: Element<Scalar = A::Scalar> + Add<Output = D>,
    {
        const { assert!(are_all_vectors::<A>(), "A has all vectors of its algebra") };
        const { assert!(are_all_vectors::<B>(), "B has all vectors of its algebra") };
        const { assert!(are_of_one_algebra::<A, C>(), "A and C are of one algebra") };
        const { assert!(are_of_one_algebra::<B, D>(), "B and D are of one algebra") };
        let blades: Vec<usize> = (0..1 << B::BASIS.len()).collect();
        let columns = C::BLADES.iter().map(|&blade| {
            let image = self.image_of_blade(blade);
            member(&blades, &|blade| image[blade], default_tolerance())
        });
        Ok(LinearMap::of_columns(columns.collect::<Result<_, _>>()?))
    }

    /// The coefficients of the outer product of the images of the vectors of a blade.
    fn image_of_blade(&self, blade: usize) -> Vec<A::Scalar> {
        let dimension = B::BASIS.len();
        let mut image = alloc::vec![A::Scalar::zero(); 1 << dimension];
        image[0] = A::Scalar::one();
        // In rising order, whatever the order of the type.
        for of in (0..A::BASIS.len()).map(|k| 1 << k) {
            let place = A::BLADES.iter().position(|&vector| vector == of & blade);
            let Some(column) = place.map(|place| self.columns()[place]) else {
                continue;
            };
            let mut product = alloc::vec![A::Scalar::zero(); 1 << dimension];
            for (left, &coefficient) in image.iter().enumerate() {
                for vector in (0..dimension).filter(|k| left >> k & 1 == 0) {
                    let term = coefficient * column.coefficient(1 << vector);
                    // The vector moves past those of the blade that are after it in the basis.
                    let is_odd = (left >> vector).count_ones() % 2 == 1;
                    product[left | 1 << vector] += if is_odd { -term } else { term };
                }
            }
            image = product;
        }
        image
    }
}

impl<A: Element + Add<Output = A>> LinearMap<A, A> {
    /// The determinant of a linear map of vectors: the factor of the pseudoscalar, and of volumes.
    #[must_use]
    pub fn determinant(&self) -> A::Scalar {
        const { assert!(are_all_vectors::<A>(), "A has all vectors of its algebra") };
        let pseudoscalar = (1 << A::BASIS.len()) - 1;
        self.image_of_blade(pseudoscalar)[pseudoscalar]
    }
}

/// Whether the blades of a type are all vectors of its algebra.
const fn are_all_vectors<A: Element>() -> bool {
    let mut found = 0;
    let mut k = 0;
    while k < A::BLADES.len() {
        if !A::BLADES[k].is_power_of_two() {
            return false;
        }
        found |= A::BLADES[k];
        k += 1;
    }
    found + 1 == 1 << A::BASIS.len()
}

/// Whether two types have the same basis vectors, by their names.
const fn are_of_one_algebra<A: Element, B: Element>() -> bool {
    let mut k = 0;
    while k < A::BASIS.len() && k < B::BASIS.len() {
        let (a, b) = (A::BASIS[k].as_bytes(), B::BASIS[k].as_bytes());
        let mut letter = 0;
        while letter < a.len() && letter < b.len() && a[letter] == b[letter] {
            letter += 1;
        }
        if letter < a.len() || letter < b.len() {
            return false;
        }
        k += 1;
    }
    A::BASIS.len() == B::BASIS.len()
}
