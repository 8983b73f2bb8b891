//! Motors on slices.

use super::error::same_length;
use super::{Batch, LengthMismatch, Moved};
use crate::cga3::Motor;
use crate::scalar::Real;
use crate::unsafe_code::{Work, run};

impl Batch {
    /// See [`transform`](super::transform).
    pub fn transform<S: Real, X: Moved<S>>(self, motor: &Motor<S>, elements: &mut [X]) {
        let map = X::map(*motor);
        run(self.instruction_set, InPlace { map, elements });
    }

    /// See [`transform_into`](super::transform_into).
    ///
    /// # Errors
    /// The slices have different lengths.
    pub fn transform_into<S: Real, X: Moved<S>>(
        self,
        motor: &Motor<S>,
        elements: &[X],
        moved: &mut [X],
    ) -> Result<(), LengthMismatch> {
        same_length(elements.len(), moved.len())?;
        let map = X::map(*motor);
        run(
            self.instruction_set,
            Into {
                map,
                elements,
                moved,
            },
        );
        Ok(())
    }

    /// See [`transform_each`](super::transform_each).
    ///
    /// # Errors
    /// The slices have different lengths.
    pub fn transform_each<S: Real, X: Moved<S>>(
        self,
        motors: &[Motor<S>],
        elements: &[X],
        moved: &mut [X],
    ) -> Result<(), LengthMismatch> {
        same_length(motors.len(), elements.len())?;
        same_length(motors.len(), moved.len())?;
        run(
            self.instruction_set,
            Each {
                motors,
                elements,
                moved,
            },
        );
        Ok(())
    }

    /// See [`compose`](super::compose).
    ///
    /// # Errors
    /// The slices have different lengths.
    pub fn compose<S: Real>(
        self,
        left: &[Motor<S>],
        right: &[Motor<S>],
        products: &mut [Motor<S>],
    ) -> Result<(), LengthMismatch> {
        same_length(left.len(), right.len())?;
        same_length(left.len(), products.len())?;
        run(
            self.instruction_set,
            Compose {
                left,
                right,
                products,
            },
        );
        Ok(())
    }
}

struct InPlace<'a, S: Real, X: Moved<S>> {
    map: X::Map,
    elements: &'a mut [X],
}

impl<S: Real, X: Moved<S>> Work for InPlace<'_, S, X> {
    const WIDE: bool = true;

    #[inline(always)]
    fn run(self) {
        for element in self.elements {
            *element = element.mapped(&self.map);
        }
    }
}

struct Into<'a, S: Real, X: Moved<S>> {
    map: X::Map,
    elements: &'a [X],
    moved: &'a mut [X],
}

impl<S: Real, X: Moved<S>> Work for Into<'_, S, X> {
    const WIDE: bool = true;

    #[inline(always)]
    fn run(self) {
        for (element, moved) in self.elements.iter().zip(self.moved) {
            *moved = element.mapped(&self.map);
        }
    }
}

struct Each<'a, S, X> {
    motors: &'a [Motor<S>],
    elements: &'a [X],
    moved: &'a mut [X],
}

impl<S: Real, X: Moved<S>> Work for Each<'_, S, X> {
    const WIDE: bool = true;

    #[inline(always)]
    fn run(self) {
        let pairs = self.motors.iter().zip(self.elements);
        for ((motor, element), moved) in pairs.zip(self.moved) {
            *moved = element.moved(*motor);
        }
    }
}

struct Compose<'a, S> {
    left: &'a [Motor<S>],
    right: &'a [Motor<S>],
    products: &'a mut [Motor<S>],
}

impl<S: Real> Work for Compose<'_, S> {
    const WIDE: bool = true;

    #[inline(always)]
    fn run(self) {
        for ((left, right), product) in self.left.iter().zip(self.right).zip(self.products) {
            *product = *left * *right;
        }
    }
}
