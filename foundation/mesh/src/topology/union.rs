//! Disjoint sets.

/// A partition of 0..n into sets, which can be united.
pub(crate) struct DisjointSets {
    /// A parent of each element in the tree of its set; roots are their own.
    parents: Vec<u32>,
}

impl DisjointSets {
    /// `count` elements, a set each.
    pub(crate) fn new(count: usize) -> Self {
        Self {
            parents: (0..count as u32).collect(),
        }
    }

    /// The element that stands for the set of an element.
    pub(crate) fn find(&mut self, mut element: u32) -> u32 {
        loop {
            let parent = self.parents[element as usize];
            if parent == element {
                return element;
            }
            // Halving the path keeps trees flat.
            let above = self.parents[parent as usize];
            self.parents[element as usize] = above;
            element = above;
        }
    }

    pub(crate) fn unite(&mut self, a: u32, b: u32) {
        let (a, b) = (self.find(a), self.find(b));
        self.parents[a.max(b) as usize] = a.min(b);
    }
}
