//! Elements made from the JSON text.

use ga_runtime::Element;
use ga_runtime::cga3::Multivector;

use super::error::ElementProblem;
use crate::shape::{Drawable, Shape, whole};

/// What an element is, and the blade from which others can be made. A motor or a path has none.
pub(super) struct Made {
    pub(super) shape: Shape,
    pub(super) blade: Option<Multivector<f64>>,
}

/// A blade, which can be met, joined and moved.
pub(super) fn blade<E: Element<Scalar = f64> + Drawable>(
    element: E,
) -> Result<Made, ElementProblem> {
    let shape = element.shape()?;
    let blade = Some(whole(&element));
    Ok(Made { shape, blade })
}

/// An element that can only be drawn.
pub(super) fn plain(element: impl Drawable) -> Result<Made, ElementProblem> {
    let shape = element.shape()?;
    Ok(Made { shape, blade: None })
}

/// An element of any kind. One that is not a motor can be met, joined and moved.
pub(super) fn general(element: Multivector<f64>) -> Result<Made, ElementProblem> {
    let shape = element.shape()?;
    let blade = (!matches!(shape, Shape::Frame { .. })).then_some(element);
    Ok(Made { shape, blade })
}
