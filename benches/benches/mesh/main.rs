//! Meshes beside other crates that do the same work.

mod bake;
mod obj;
mod queries;
mod subdivision;

use criterion::{criterion_group, criterion_main};
use nullcone_benches::comparison;

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = bake::all, obj::all, queries::all, subdivision::all
}
criterion_main!(benches);
