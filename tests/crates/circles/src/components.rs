//! Strongly connected components of a graph, by Tarjan's algorithm.

/// The components of the graph in which node `i` has edges to the nodes `edges[i]`; each is sorted.
pub(crate) fn strongly_connected(edges: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let mut search = Search {
        edges,
        order: vec![None; edges.len()],
        lowest: vec![0; edges.len()],
        open: Vec::new(),
        is_open: vec![false; edges.len()],
        visited: 0,
        components: Vec::new(),
    };
    for node in 0..edges.len() {
        if search.order[node].is_none() {
            search.visit(node);
        }
    }
    search.components
}

struct Search<'a> {
    edges: &'a [Vec<usize>],
    /// When a node was reached.
    order: Vec<Option<usize>>,
    /// The earliest open node that is reached from a node.
    lowest: Vec<usize>,
    open: Vec<usize>,
    is_open: Vec<bool>,
    visited: usize,
    components: Vec<Vec<usize>>,
}

impl Search<'_> {
    fn visit(&mut self, node: usize) {
        let at = self.visited;
        self.visited += 1;
        self.order[node] = Some(at);
        self.lowest[node] = at;
        self.open.push(node);
        self.is_open[node] = true;

        let edges = self.edges;
        for &next in &edges[node] {
            match self.order[next] {
                None => {
                    self.visit(next);
                    self.lowest[node] = self.lowest[node].min(self.lowest[next]);
                }
                Some(reached) if self.is_open[next] => {
                    self.lowest[node] = self.lowest[node].min(reached);
                }
                Some(_) => {}
            }
        }

        if self.lowest[node] == at {
            let first = self.open.iter().rposition(|&n| n == node).unwrap_or(0);
            let mut component = self.open.split_off(first);
            for &member in &component {
                self.is_open[member] = false;
            }
            component.sort_unstable();
            self.components.push(component);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::strongly_connected;

    #[test]
    fn nodes_that_reach_each_other_are_one_component() {
        // 0 → 1 → 2 → 0 is a cycle that leads to the cycle 3 ⇄ 4; 5 leads into both.
        let edges = [vec![1], vec![2], vec![0, 3], vec![4], vec![3], vec![0, 4]];
        let mut components = strongly_connected(&edges);
        components.sort();
        assert_eq!(components, [vec![0, 1, 2], vec![3, 4], vec![5]]);
    }

    #[test]
    fn two_ways_to_a_node_are_no_cycle() {
        let components = strongly_connected(&[vec![1, 2], vec![3], vec![3], vec![]]);
        assert_eq!(components.len(), 4);
    }
}
