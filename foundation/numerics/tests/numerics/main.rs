//! Numerical methods against closed forms and dense algebra.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod conjugate_gradient;
mod least_squares;
mod order_statistics;
mod ransac;
