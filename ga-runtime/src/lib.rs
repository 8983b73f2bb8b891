//! Conformal geometric algebra that costs nothing.
#![cfg_attr(not(feature = "std"), no_std)]
extern crate alloc;

pub mod scalar;
