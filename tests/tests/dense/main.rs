//! The dense reference, which shares no code with the compiler: its axioms, its interface, and test
//! vectors of other libraries.

mod axioms;
mod interface;
mod oracle;
