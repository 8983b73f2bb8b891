//! Euclidean geometry in cga2: that of cga3 without the third axis.

mod circle;
mod line;
mod motor;
mod point;
mod point_pair;
mod similarity;
