//! A body with dots on its skin.

use super::super::BodyModel;
use super::parts::Mark;
use super::parts::Part;

/// A body with dots on its skin.
#[derive(Clone, Debug, PartialEq)]
pub struct MarkedBody {
    pub(super) model: BodyModel,
    pub(super) marks: Vec<Mark>,
    /// For each point the joint of its greatest weight.
    pub(super) strongest: Vec<usize>,
    pub(super) parts: Vec<Part>,
}
