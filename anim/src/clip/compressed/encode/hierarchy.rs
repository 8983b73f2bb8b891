//! The joints below each joint.

use std::ops::Range;

/// Joints in depth-first order, so that a joint and all below it are one range.
pub(super) struct Hierarchy {
    order: Vec<usize>,
    /// Where in `order` a joint and all below it are.
    subtrees: Vec<Range<usize>>,
    /// The joints by their parents.
    by_parent: Vec<usize>,
    /// Where in `by_parent` the children of a joint are.
    children: Vec<Range<usize>>,
}

impl Hierarchy {
    /// The hierarchy of joints each of which comes after its parent.
    pub(super) fn new(parents: &[Option<usize>]) -> Self {
        let mut sizes = vec![1; parents.len()];
        let mut child_counts = vec![0; parents.len()];
        for (joint, parent) in parents.iter().enumerate().rev() {
            if let Some(parent) = *parent {
                sizes[parent] += sizes[joint];
                child_counts[parent] += 1;
            }
        }
        let mut children = Vec::with_capacity(parents.len());
        let mut begin = 0;
        for count in child_counts {
            children.push(begin..begin);
            begin += count;
        }
        let mut by_parent = vec![0; begin];
        let mut order = vec![0; parents.len()];
        // The place in `order` at which the next child of each joint begins, and the next root.
        let mut next = vec![0; parents.len()];
        let mut next_root = 0;
        let mut subtrees = Vec::with_capacity(parents.len());
        for (joint, parent) in parents.iter().enumerate() {
            let next_place = match *parent {
                Some(parent) => {
                    by_parent[children[parent].end] = joint;
                    children[parent].end += 1;
                    &mut next[parent]
                }
                None => &mut next_root,
            };
            let place = *next_place;
            *next_place += sizes[joint];
            next[joint] = place + 1;
            order[place] = joint;
            subtrees.push(place..place + sizes[joint]);
        }
        Self {
            order,
            subtrees,
            by_parent,
            children,
        }
    }

    /// A joint and all below it, each after its parent.
    pub(super) fn subtree(&self, joint: usize) -> &[usize] {
        &self.order[self.subtrees[joint].clone()]
    }

    /// The joints whose parent a joint is.
    pub(super) fn children(&self, joint: usize) -> &[usize] {
        &self.by_parent[self.children[joint].clone()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn subtrees_and_children_of_two_interleaved_trees() {
        let parents = [
            None,
            None,
            Some(0),
            Some(1),
            Some(0),
            Some(2),
            Some(4),
            Some(2),
        ];
        let hierarchy = Hierarchy::new(&parents);
        assert_eq!(hierarchy.subtree(0), [0, 2, 5, 7, 4, 6]);
        assert_eq!(hierarchy.subtree(1), [1, 3]);
        assert_eq!(hierarchy.subtree(2), [2, 5, 7]);
        assert_eq!(hierarchy.subtree(6), [6]);
        assert_eq!(hierarchy.children(0), [2, 4]);
        assert_eq!(hierarchy.children(2), [5, 7]);
        assert!(hierarchy.children(3).is_empty());
    }
}
