//! Euclidean geometry in vga3: directions, areas and turns about the origin.

mod bivector;
mod rotor;
mod vector;
