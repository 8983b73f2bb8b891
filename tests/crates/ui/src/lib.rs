//! What `algebra!` and `ga!` say of faulty declarations and functions: see `tests/ui`.
