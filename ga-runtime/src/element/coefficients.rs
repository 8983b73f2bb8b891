//! The coefficients of an element with their names.

use core::iter::FusedIterator;

use super::Element;

/// The coefficients of an element with the names of their blades, in the order of the declaration:
/// see [`Element::coefficients`].
///
/// ```
/// use ga_runtime::cga3::Point;
/// let terms: Vec<_> = Point::new(1.0, 2.0, 2.0).coefficients().collect();
/// assert_eq!(terms, [("e1", 1.0), ("e2", 2.0), ("e3", 2.0), ("eo", 1.0), ("ei", 4.5)]);
/// ```
#[derive(Clone, Debug)]
pub struct Coefficients<T> {
    element: T,
    next: usize,
}

impl<T: Element> Coefficients<T> {
    #[inline]
    pub(super) fn new(element: T) -> Self {
        Self { element, next: 0 }
    }
}

impl<T: Element> Iterator for Coefficients<T> {
    type Item = (&'static str, T::Scalar);

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        let (&blade, &name) = (T::BLADES.get(self.next)?, T::NAMES.get(self.next)?);
        self.next += 1;
        let value = self.element.coefficient(blade);
        let is_reversed = T::REVERSED.contains(&blade);
        Some((name, if is_reversed { -value } else { value }))
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        let rest = T::BLADES.len() - self.next;
        (rest, Some(rest))
    }
}

impl<T: Element> ExactSizeIterator for Coefficients<T> {}
impl<T: Element> FusedIterator for Coefficients<T> {}
