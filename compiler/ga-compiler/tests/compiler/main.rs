//! The compiler as a library, with no macro involved.

mod accuracy;
mod action_counts;
mod algebras;
mod by_hand;
mod components;
mod counts;
mod declarations;
mod emit;
mod forms;
mod kernels;
mod language;
mod literals;
mod passes;
mod random;
mod rules;
mod sharing;
mod signs;
mod snapshots;
mod spelling;
mod staging;
