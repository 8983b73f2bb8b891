//! The messages of the macros for faulty declarations and functions, each at the token at fault.
//!
//! A file of `ui/` holds the faults of one subject, each in a module of its own, since trybuild
//! compiles each file as a crate. A fault stands alone where it would hide others: an error of Rust
//! itself keeps the compiler from going on. The expected output lies beside the file;
//! `TRYBUILD=overwrite cargo test -p nullcone-ui-tests` writes it anew.

#[test]
fn faulty_declarations_and_functions() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}
