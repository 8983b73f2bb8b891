//! Products of basis blades, each computed once.

use std::cell::RefCell;
use std::rc::Rc;

use rustc_hash::FxHashMap;

use super::{Blade, Product, Ratio};

/// A sum of basis blades with constant coefficients, sorted by blade.
pub type BladeSum = Rc<[(Blade, Ratio)]>;

/// The largest dimension whose products are found by their place in a table.
const LARGEST: usize = 6;

/// Known products of basis blades.
#[derive(Debug)]
pub(super) struct Table {
    dimension: usize,
    /// For each product the results, by the bits of the left and then of the right blade.
    placed: RefCell<Vec<Vec<Option<BladeSum>>>>,
    /// The results in algebras of many dimensions.
    others: RefCell<FxHashMap<(Product, Blade, Blade), BladeSum>>,
}

impl Table {
    /// An empty table for an algebra of a dimension.
    pub(super) fn new(dimension: usize) -> Self {
        Self {
            dimension,
            placed: RefCell::new(vec![Vec::new(); Product::ALL.len()]),
            others: RefCell::default(),
        }
    }

    /// The known product of two blades, or the one that is made.
    pub(super) fn get(
        &self,
        product: Product,
        left: Blade,
        right: Blade,
        make: impl FnOnce() -> BladeSum,
    ) -> BladeSum {
        if self.dimension > LARGEST {
            let key = (product, left, right);
            if let Some(known) = self.others.borrow().get(&key) {
                return BladeSum::clone(known);
            }
            let made = make();
            let mut others = self.others.borrow_mut();
            others.insert(key, BladeSum::clone(&made));
            return made;
        }
        let kind = product as usize;
        let place = (left.0 as usize) << self.dimension | right.0 as usize;
        if let Some(Some(known)) = self.placed.borrow()[kind].get(place) {
            return BladeSum::clone(known);
        }
        let made = make();
        let results = &mut self.placed.borrow_mut()[kind];
        if results.is_empty() {
            results.resize(1 << (2 * self.dimension), None);
        }
        results[place] = Some(BladeSum::clone(&made));
        made
    }
}
