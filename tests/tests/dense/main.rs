//! The dense reference, which shares no code with the compiler: its axioms, its interface, and
//! other libraries' vectors.

mod axioms;
mod interface;
mod oracle;
