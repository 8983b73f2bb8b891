//! Graphs inside other graphs.

use super::{Arena, Node, Value};

impl Arena {
    /// A node of another arena with the given images of what it reads; `None` where a divisor is
    /// zero. An input must be given an image otherwise.
    pub(crate) fn copied(&mut self, node: &Node, images: &[Value]) -> Option<Value> {
        match node {
            Node::One | Node::Input(_) => Some(Value::ONE),
            Node::Sum(terms) => match &**terms {
                [single] => Some(self.held(single.image(images))),
                _ => Some(self.sum(terms.iter().map(|term| term.image(images)))),
            },
            Node::Product(a, b) => Some(self.product(images[a.index()], images[b.index()])),
            Node::Quotient(a, b) => self.quotient(images[a.index()], images[b.index()]),
            Node::Function(function, arguments) => {
                let arguments: Vec<Value> = arguments.iter().map(|v| v.image(images)).collect();
                Some(self.function(*function, &arguments))
            }
        }
    }

    /// What another graph gives for some values as its inputs. Multiples are held, so that no
    /// multiplication by a constant is done twice and the copy costs no more than that graph. Zero
    /// where a divisor is zero.
    pub(crate) fn splice(
        &mut self,
        graph: &Self,
        inputs: &[Value],
        outputs: &[Value],
    ) -> Vec<Value> {
        let mut is_needed = vec![false; graph.len()];
        for output in outputs {
            is_needed[output.node.index()] = true;
        }
        for id in graph.ids().rev() {
            if is_needed[id.index()] {
                graph
                    .node(id)
                    .for_each_operand(|operand| is_needed[operand.index()] = true);
            }
        }
        let mut images = vec![Value::ZERO; graph.len()];
        for id in graph.ids().filter(|id| is_needed[id.index()]) {
            let image = match graph.node(id) {
                Node::Input(number) => inputs[*number],
                node => self.copied(node, &images).unwrap_or(Value::ZERO),
            };
            images[id.index()] = self.held(image);
        }
        let outputs = outputs.iter();
        outputs.map(|output| output.image(&images)).collect()
    }
}
