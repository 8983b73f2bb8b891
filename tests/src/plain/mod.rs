//! Plain vector arithmetic, with which tests compare results. It shares no code with ga-runtime,
//! whose own vectors are tested too.

mod figure;
mod near;
mod sampling;
mod vector;

pub use figure::{
    circle, circle_of_square, line, motor_coefficients, motor_of, on_circle, pair, plane, point,
    sphere, sphere_of_square,
};
pub use near::{
    dense, largest, largest_difference, near, near_all, near_dense, near_vector, positive_multiple,
    tolerance,
};
pub use sampling::least_by_sampling;
pub use vector::{
    Number, O, Vector, X, Y, Z, along, cross, dot, frame, length, minus, plus, rotated, times,
    unit, unit_of, vector,
};
