//! Linear maps of elements: matrices, outermorphisms, and other crates' matrices.

mod interop;
mod matrices;
mod outermorphisms;
