//! What a curve may be a curve of.

use std::fmt::Debug;

use ga_runtime::vga3::Vector;

/// A value of a curve: a number, a vector, or several numbers that share their keys.
///
/// Distances between values are Euclidean, over all components.
pub trait Value: Copy + Debug + PartialEq {
    /// The number of components.
    const DIMENSION: usize;

    /// A component, by its index below [`Value::DIMENSION`].
    fn component(&self, index: usize) -> f64;

    /// The value with these components.
    fn from_components(component: impl FnMut(usize) -> f64) -> Self;

    /// The value with all components 0.
    #[must_use]
    fn zero() -> Self {
        Self::from_components(|_| 0.0)
    }
}

impl Value for f64 {
    const DIMENSION: usize = 1;

    #[inline(always)]
    fn component(&self, _: usize) -> f64 {
        *self
    }

    #[inline(always)]
    fn from_components(mut component: impl FnMut(usize) -> f64) -> Self {
        component(0)
    }
}

impl<const N: usize> Value for [f64; N] {
    const DIMENSION: usize = N;

    #[inline(always)]
    fn component(&self, index: usize) -> f64 {
        self[index]
    }

    #[inline(always)]
    fn from_components(mut component: impl FnMut(usize) -> f64) -> Self {
        // This becomes straight-line code more reliably than `std::array::from_fn`.
        let mut values = [0.0; N];
        for (index, value) in values.iter_mut().enumerate() {
            *value = component(index);
        }
        values
    }
}

impl Value for Vector<f64> {
    const DIMENSION: usize = 3;

    #[inline(always)]
    fn component(&self, index: usize) -> f64 {
        self[index]
    }

    #[inline(always)]
    fn from_components(component: impl FnMut(usize) -> f64) -> Self {
        <[f64; 3]>::from_components(component).into()
    }
}
