//! Primitives fitted to points: against known primitives, another library and simulations.

mod covariance;
mod cylinder;
mod exact;
mod nearest;
mod optimum;
mod refused;
mod robust;
mod sample;
