//! What depends on uniform operands alone is computed once: what a call costs, and how it rounds.

mod accuracy;
mod counts;
