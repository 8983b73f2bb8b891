//! The nullcone command line.
fn main() {}
