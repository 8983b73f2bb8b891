//! The procedural macros of Nullcone.
