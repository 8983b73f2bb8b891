//! Versors: rigid motions, similarities and general conformal versors.

mod composition;
mod conformal;
mod dual_quaternion;
mod edges;
mod factors;
mod interpolation;
mod logarithm;
mod rigid;
mod rotations;
mod similarity;
