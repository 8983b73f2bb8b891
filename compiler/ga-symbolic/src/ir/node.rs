//! Scalar nodes, and multiples of them.

use super::Function;
use crate::algebra::Ratio;

/// The place of a node in its arena. A node comes after everything that it refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct NodeId(pub(super) usize);

impl NodeId {
    /// The node of the number 1, the first of every arena.
    pub(super) const ONE: Self = Self(0);

    /// The place as an index.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0
    }
}

/// A scalar operation.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// The number 1.
    One,
    /// An input, by its number.
    Input(usize),
    /// A sum of values with different nodes in rising order. The factors are coprime integers, the
    /// first of them positive. Or a single value with a positive factor, see
    /// [`Arena::held`](super::Arena::held).
    Sum(Box<[Value]>),
    /// A product of two nodes in rising order.
    Product(NodeId, NodeId),
    /// The first node divided by the second.
    Quotient(NodeId, NodeId),
    /// A function of its arguments.
    Function(Function, Box<[Value]>),
}

impl Node {
    /// Calls back for every node that this one reads, as often as it reads it.
    pub fn for_each_operand(&self, mut call: impl FnMut(NodeId)) {
        match self {
            Self::One | Self::Input(_) => {}
            Self::Sum(values) | Self::Function(_, values) => {
                values.iter().for_each(|value| call(value.node));
            }
            Self::Product(a, b) | Self::Quotient(a, b) => {
                call(*a);
                call(*b);
            }
        }
    }

    /// The nodes that this one reads, each as often as it is read.
    #[must_use]
    pub fn operands(&self) -> Vec<NodeId> {
        let mut operands = Vec::new();
        self.for_each_operand(|operand| operands.push(operand));
        operands
    }
}

/// A node times a constant factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Value {
    /// The constant factor.
    pub factor: Ratio,
    /// The node.
    pub node: NodeId,
}

impl Value {
    /// Zero.
    pub const ZERO: Self = Self::constant(Ratio::ZERO);
    /// One.
    pub const ONE: Self = Self::constant(Ratio::ONE);

    /// A node itself, with the factor 1.
    #[must_use]
    pub const fn of(node: NodeId) -> Self {
        Self {
            factor: Ratio::ONE,
            node,
        }
    }

    /// A constant.
    #[must_use]
    pub const fn constant(factor: Ratio) -> Self {
        Self {
            factor,
            node: NodeId::ONE,
        }
    }

    /// The constant that the value is, if it is one.
    #[must_use]
    pub fn as_constant(self) -> Option<Ratio> {
        (self.node == NodeId::ONE || self.factor.is_zero()).then_some(self.factor)
    }

    /// Whether the value is known to be zero.
    #[must_use]
    pub const fn is_zero(self) -> bool {
        self.factor.is_zero()
    }

    /// What the value is where the nodes have the given images.
    #[must_use]
    pub(crate) fn image(self, images: &[Self]) -> Self {
        images[self.node.index()].scaled(self.factor)
    }

    /// The value times a constant.
    #[must_use]
    pub fn scaled(self, factor: Ratio) -> Self {
        if factor.is_zero() || self.is_zero() {
            return Self::ZERO;
        }
        Self {
            factor: self.factor * factor,
            ..self
        }
    }
}

impl std::ops::Neg for Value {
    type Output = Self;
    fn neg(self) -> Self {
        self.scaled(Ratio::integer(-1))
    }
}
