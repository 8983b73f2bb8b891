//! Linear maps between the types of an algebra, and their matrices.
//!
//! A [`LinearMap`] holds the images of the basis elements of a type. It is made of any function
//! that is linear, such as the action of a versor, a product with a fixed factor or a function that
//! `ga!` compiled, of a matrix, or, as an [outermorphism](LinearMap::outermorphism), of a linear
//! map of vectors.
//!
//! Matrices are arrays of rows and act on columns of coefficients, `y = M x`, in the order of the
//! declared blades, [`Element::BLADES`](crate::Element::BLADES). With the features `nalgebra-035`
//! and `glam-034` maps convert to matrices of these crates and back.

mod linear_map;
mod outermorphism;

pub use linear_map::{LinearMap, NotLinear};
