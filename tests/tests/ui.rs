//! What `algebra!` says of faulty declarations, each message at the token at fault.
//!
//! Each file of `ui/` holds a declaration with one fault, or with several where that is the point.
//! The expected output lies beside it; `TRYBUILD=overwrite cargo test -p nullcone-tests --test ui`
//! writes it anew.

#[test]
fn faulty_declarations() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}
