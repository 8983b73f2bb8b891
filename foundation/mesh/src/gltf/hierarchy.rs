//! The tree of the nodes.

use super::problem::{Element, Problem};
use super::{Document, Node};
use crate::FormatError;

impl Document {
    /// The parent of each node.
    ///
    /// # Errors
    ///
    /// [`FormatError`] for a child that does not exist, has two parents or is its own ancestor.
    pub fn parents(&self) -> Result<Vec<Option<usize>>, FormatError> {
        parents(&self.nodes)
    }

    /// All nodes, each after its parent.
    ///
    /// # Errors
    ///
    /// As [`Document::parents`].
    pub fn parents_before_children(&self) -> Result<Vec<usize>, FormatError> {
        let parents = self.parents()?;
        parents_before_children(&self.nodes, &parents)
    }

    /// The nodes of the default scene, of the first scene without a default, and all nodes without
    /// scenes, in rising order.
    #[must_use]
    pub fn shown_nodes(&self) -> Vec<usize> {
        let scene = self.scene.unwrap_or(0);
        let Some(scene) = self.scenes.get(scene) else {
            return (0..self.nodes.len()).collect();
        };
        let mut is_shown = vec![false; self.nodes.len()];
        let mut next = scene.nodes.clone();
        while let Some(index) = next.pop() {
            if let Some(node) = self.nodes.get(index)
                && !std::mem::replace(&mut is_shown[index], true)
            {
                next.extend(&node.children);
            }
        }
        (0..is_shown.len()).filter(|&node| is_shown[node]).collect()
    }

    /// The frame of each node in the world, as the upper three rows of a 4 × 4 matrix: that of its
    /// parent times its own.
    ///
    /// # Errors
    ///
    /// As [`Document::parents`].
    pub fn world_matrices(&self) -> Result<Vec<[[f64; 4]; 3]>, FormatError> {
        world_matrices(&self.nodes)
    }
}

/// The parent of each node.
pub(super) fn parents(nodes: &[Node]) -> Result<Vec<Option<usize>>, FormatError> {
    let mut parents: Vec<Option<usize>> = vec![None; nodes.len()];
    for (parent, node) in nodes.iter().enumerate() {
        for &child in &node.children {
            let fault = |element, problem| Err(FormatError::gltf(Element::Node(element), problem));
            match parents.get(child) {
                None => {
                    let problem = Problem::OutOfRange {
                        what: "node",
                        index: child,
                        count: nodes.len(),
                    };
                    return fault(parent, problem);
                }
                Some(&Some(first)) => {
                    let second = parent;
                    return fault(child, Problem::TwoParents { first, second });
                }
                Some(None) => parents[child] = Some(parent),
            }
        }
    }
    parents_before_children(nodes, &parents)?;
    Ok(parents)
}

/// The frame of each node in the world.
fn world_matrices(nodes: &[Node]) -> Result<Vec<[[f64; 4]; 3]>, FormatError> {
    let parents = parents(nodes)?;
    let mut world: Vec<_> = nodes
        .iter()
        .map(|node| node.transform.to_matrix())
        .collect();
    for node in parents_before_children(nodes, &parents)? {
        if let Some(parent) = parents[node] {
            world[node] = product(&world[parent], &world[node]);
        }
    }
    Ok(world)
}

/// All nodes, each after its parent. A node that cannot be reached from a root is in a cycle or
/// below one.
fn parents_before_children(
    nodes: &[Node],
    parents: &[Option<usize>],
) -> Result<Vec<usize>, FormatError> {
    let mut order: Vec<usize> = (0..nodes.len()).filter(|&n| parents[n].is_none()).collect();
    let mut next = 0;
    while let Some(&node) = order.get(next) {
        order.extend(&nodes[node].children);
        next += 1;
    }
    if order.len() == nodes.len() {
        return Ok(order);
    }
    let mut reached = vec![false; nodes.len()];
    order.iter().for_each(|&node| reached[node] = true);
    // Walking up from any such node enters the cycle after at most as many steps as there are
    // nodes, and as many more go round it.
    let mut node = reached.iter().position(|reached| !reached).unwrap_or(0);
    let mut first = usize::MAX;
    for step in 0..2 * nodes.len() {
        node = parents[node].unwrap_or(node);
        if step >= nodes.len() {
            first = first.min(node);
        }
    }
    Err(FormatError::gltf(Element::Node(first), Problem::Cycle))
}

/// The product of two matrices whose last row is (0, 0, 0, 1).
pub(super) fn product(a: &[[f64; 4]; 3], b: &[[f64; 4]; 3]) -> [[f64; 4]; 3] {
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            let sum: f64 = (0..3).map(|i| a[row][i] * b[i][column]).sum();
            if column == 3 { sum + a[row][3] } else { sum }
        })
    })
}
