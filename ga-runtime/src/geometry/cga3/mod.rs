//! The geometry of cga3: conversion between its types and Euclidean data, versors, and relations.

// One type each, before what concerns several: so the constructors come first on the pages.
mod circle;
mod dilator;
mod direction;
mod dual_motion;
mod dual_round;
mod even_versor;
mod flat_point;
mod line;
mod motor;
mod odd_versor;
mod plane;
mod point;
mod point_pair;
mod rotor;
mod similarity;
mod sphere;
mod translator;
mod transversor;

pub(crate) mod affine;
pub(crate) mod composition;
mod conformal_exponential;
mod conformal_logarithm;
mod dual_quaternion;
mod euler;
pub mod fit;
pub mod homogeneous;
mod interpolation;
mod kind;
pub mod kinematics;
mod logarithm;
mod matrix;
pub mod motion;
mod motor_lanes;
mod number_pair;
mod power;
pub mod ray;
pub mod relation;
mod rotation_path;
mod round;
mod screw;
mod velocity;
mod versor_action;
mod view;
mod weight;

pub use affine::{Affine, NotConformal};
pub use dual_quaternion::{DualQuaternionParts, NotUnit};
pub use euler::EulerOrder;
pub use kind::Kind;
pub use rotation_path::RotationPath;
pub use screw::Screw;
pub use view::LookAtError;
