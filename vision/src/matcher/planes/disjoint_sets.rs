//! Disjoint sets of numbers, which are joined two at a time.

/// A forest in which each tree is a set. (R. E. Tarjan, "Efficiency of a good but not linear set
/// union algorithm", Journal of the ACM 22, 1975.)
#[derive(Debug, Default)]
pub(super) struct DisjointSets {
    parents: Vec<u32>,
    sizes: Vec<u32>,
}

impl DisjointSets {
    /// Makes each of `count` numbers alone.
    pub(super) fn separate(&mut self, count: usize) {
        self.parents.clear();
        self.parents.extend(0..count as u32);
        self.sizes.clear();
        self.sizes.resize(count, 1);
    }

    /// The number that stands for the set of a number.
    #[inline(always)]
    pub(super) fn find(&mut self, number: usize) -> usize {
        let mut number = number;
        loop {
            let parent = self.parents[number] as usize;
            if parent == number {
                return number;
            }
            let above = self.parents[parent];
            self.parents[number] = above;
            number = above as usize;
        }
    }

    /// The numbers that stand for the sets of two numbers.
    #[inline(always)]
    pub(super) fn find_both(&mut self, [a, b]: [usize; 2]) -> [usize; 2] {
        [self.find(a), self.find(b)]
    }

    /// How many numbers are in the set for which a number stands.
    #[inline(always)]
    pub(super) fn size(&self, root: usize) -> u32 {
        self.sizes[root]
    }

    /// Joins the sets for which two different numbers stand. The first of the result stands for
    /// both, the second no longer.
    #[inline(always)]
    pub(super) fn join(&mut self, [a, b]: [usize; 2]) -> [usize; 2] {
        let [root, other] = if self.sizes[a] >= self.sizes[b] {
            [a, b]
        } else {
            [b, a]
        };
        self.parents[other] = root as u32;
        self.sizes[root] += self.sizes[other];
        [root, other]
    }
}
