//! What a storage holds under a name.

use super::matrix::Matrix;
use crate::format::node::Node;

/// What a storage holds under a name.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Entry {
    /// As read: its type shows when it is asked for.
    Read(Node),
    Number(f64),
    Text(String),
    Matrix(Matrix),
}
