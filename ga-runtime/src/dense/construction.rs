//! The multivectors of an algebra, made of coefficients.

use alloc::vec;
use alloc::vec::Vec;

use super::{Algebra, DenseError, Multivector};
use crate::Element;
use crate::scalar::Ring;

impl<S: Ring> Algebra<S> {
    /// The multivector zero.
    pub fn zero(&self) -> Multivector<S> {
        Multivector::from_parts(self.clone(), vec![S::zero(); self.size()])
    }

    /// A scalar as a multivector.
    pub fn scalar(&self, value: S) -> Multivector<S> {
        let mut coefficients = vec![S::zero(); self.size()];
        coefficients[0] = value;
        Multivector::from_parts(self.clone(), coefficients)
    }

    /// The multivector 1.
    pub fn one(&self) -> Multivector<S> {
        self.scalar(S::one())
    }

    /// The vector of the given components, one for each basis vector.
    ///
    /// # Errors
    ///
    /// [`DenseError::CoefficientCount`].
    pub fn vector(
        &self,
        components: impl IntoIterator<Item = S>,
    ) -> Result<Multivector<S>, DenseError> {
        let components: Vec<S> = components.into_iter().collect();
        if components.len() != self.dimension() {
            return Err(DenseError::CoefficientCount {
                expected: self.dimension(),
                found: components.len(),
            });
        }
        let mut coefficients = vec![S::zero(); self.size()];
        for (vector, component) in components.into_iter().enumerate() {
            coefficients[1 << vector] = component;
        }
        Ok(Multivector::from_parts(self.clone(), coefficients))
    }

    /// The basis blade of a bitmask: the outer product of its vectors in rising order.
    ///
    /// # Errors
    ///
    /// [`DenseError::NoSuchBlade`].
    pub fn blade(&self, blade: usize) -> Result<Multivector<S>, DenseError> {
        self.sparse([(blade, S::one())])
    }

    /// The outer product of all basis vectors, I.
    pub fn pseudoscalar(&self) -> Multivector<S> {
        let mut coefficients = vec![S::zero(); self.size()];
        coefficients[self.size() - 1] = S::one();
        Multivector::from_parts(self.clone(), coefficients)
    }

    /// The multivector of the given coefficients, indexed by the bitmasks of the basis blades.
    ///
    /// # Errors
    ///
    /// [`DenseError::CoefficientCount`].
    pub fn multivector(
        &self,
        coefficients: impl Into<Vec<S>>,
    ) -> Result<Multivector<S>, DenseError> {
        let coefficients = coefficients.into();
        if coefficients.len() != self.size() {
            return Err(DenseError::CoefficientCount {
                expected: self.size(),
                found: coefficients.len(),
            });
        }
        Ok(Multivector::from_parts(self.clone(), coefficients))
    }

    /// The multivector with the given coefficients on the blades of the given bitmasks and zero on
    /// all others.
    ///
    /// # Errors
    ///
    /// [`DenseError::NoSuchBlade`] or [`DenseError::RepeatedBlade`].
    pub fn sparse(
        &self,
        terms: impl IntoIterator<Item = (usize, S)>,
    ) -> Result<Multivector<S>, DenseError> {
        let mut coefficients = vec![None; self.size()];
        for (blade, value) in terms {
            match coefficients.get_mut(blade) {
                None => {
                    return Err(DenseError::NoSuchBlade {
                        blade,
                        dimension: self.dimension(),
                    });
                }
                Some(Some(_)) => return Err(DenseError::RepeatedBlade { blade }),
                Some(coefficient) => *coefficient = Some(value),
            }
        }
        let coefficients: Vec<S> = coefficients
            .into_iter()
            .map(|coefficient| coefficient.unwrap_or(S::zero()))
            .collect();
        Ok(Multivector::from_parts(self.clone(), coefficients))
    }

    /// An element of a declared type with all its coefficients.
    pub fn element<T: Element<Scalar = S>>(&self, element: &T) -> Multivector<S> {
        self.zero().map(|blade, _| element.coefficient(blade))
    }
}
