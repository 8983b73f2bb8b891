//! Functions written in `ga!`, against truth that the compiler did not produce: the dense reference
//! over the prime field, exactly, where no real function is involved, and closed forms otherwise.

mod conditions;
mod elementary;
mod exact;
mod language;
mod places;
mod places_of_figures;
mod real;
mod scalars;
mod uniform;
mod witness;
