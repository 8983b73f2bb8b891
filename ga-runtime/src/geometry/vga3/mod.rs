//! The geometry of vga3: vectors, areas and rotations of space.

mod bivector;
mod component;
mod orthonormal;
mod rotor;
mod vector;
