//! Systems of linear equations in which each part is joined to its two neighbours on either side.
//!
//! - [`frames`]: the parts are frames, one after the other, with many unknowns each.
//! - [`ring`]: the parts are the points of a closed curve, with two unknowns each.
//!
//! The effort grows as the number of parts.

pub mod frames;
pub mod ring;
