//! `nullcone body`: people in views.

mod dots;
mod evaluate;
mod fit;
mod paint;

use crate::frame::group;

group! {
    /// People in views: poses from their joints in pictures.
    Fit: fit::Arguments,
    Evaluate: evaluate::Arguments,
    Paint: paint::Arguments,
    Dots: dots::Arguments,
}
