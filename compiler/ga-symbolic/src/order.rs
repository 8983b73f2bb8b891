//! One stable sort for lists of all types: each copy of the standard one takes as long to compile
//! as a large file, and whoever uses the macros waits for it.

use std::cmp::Ordering;

pub(crate) trait Order<T> {
    /// Puts a list in the order of a comparison. Equal elements keep their order.
    fn order_by(&mut self, compare: impl Fn(&T, &T) -> Ordering);

    /// Puts a list in the order of a key, which is computed for each comparison.
    fn order_by_key<K: Ord>(&mut self, key: impl Fn(&T) -> K) {
        self.order_by(|a, b| key(a).cmp(&key(b)));
    }

    /// Puts a list in the order of its elements.
    fn order(&mut self)
    where
        T: Ord,
    {
        self.order_by(T::cmp);
    }
}

impl<T> Order<T> for [T] {
    fn order_by(&mut self, compare: impl Fn(&T, &T) -> Ordering) {
        if self.is_sorted_by(|a, b| compare(a, b) != Ordering::Greater) {
            return;
        }
        let mut places = places(self.len(), &|a, b| compare(&self[a], &self[b]));
        for start in 0..places.len() {
            // Along a cycle of the permutation the element of its start moves to the end.
            let mut to = start;
            loop {
                let from = std::mem::replace(&mut places[to], to);
                if from == start {
                    break;
                }
                self.swap(to, from);
                to = from;
            }
        }
    }
}

/// The places of a list's elements, in their order.
fn places(length: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut places: Vec<usize> = (0..length).collect();
    places.sort_by(|a, b| compare(*a, *b));
    places
}

#[cfg(test)]
mod tests {
    use super::Order as _;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn lists_are_ordered_as_by_the_stable_sort(list in prop::collection::vec((0..9_u8, 0..9_u8), 0..40)) {
            let mut expected = list.clone();
            expected.sort_by_key(|(key, _)| *key);
            let mut found = list.clone();
            found.order_by_key(|(key, _)| *key);
            prop_assert_eq!(found, expected);
        }
    }
}
