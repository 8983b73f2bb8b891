//! Euclidean geometry in vga2: directions of the plane, turns and complex numbers.

mod complex;
mod rotor;
mod vector;
