//! Conformal geometric algebra that costs nothing.
#![cfg_attr(not(feature = "std"), no_std)]
extern crate alloc;

pub mod dense;
pub mod scalar;
#[cfg(feature = "testing")]
pub mod testing;
