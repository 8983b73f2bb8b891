//! `nullcone body`: people in views.

mod evaluate;
mod fit;

use crate::frame::group;

group! {
    /// People in views: poses from their joints in pictures.
    Fit: fit::Arguments,
    Evaluate: evaluate::Arguments,
}
