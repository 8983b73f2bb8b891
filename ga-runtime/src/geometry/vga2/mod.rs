//! Euclidean geometry in vga2: directions of the plane, rotations and complex numbers.

mod complex;
mod rotor;
mod vector;
