//! Three-dimensional conformal geometry: its axioms, its elements, other libraries' vectors, and
//! numbers of every size.

mod axioms;
mod far_rounds;
mod geometry;
mod homogeneous;
mod kinematics;
mod lanes;
mod nearest;
mod oracle;
mod points;
mod primitives;
mod sizes;
mod view;
