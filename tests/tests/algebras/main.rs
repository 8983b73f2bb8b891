//! The geometry of the algebras other than cga3, compared with plain coordinates, matrices and the
//! dense reference.

mod cga2;
mod interpolation;
mod lorentz;
mod pga2;
mod pga3;
mod plane;
mod single;
mod sta;
mod vga2;
mod vga3;
mod vga3_vector;
