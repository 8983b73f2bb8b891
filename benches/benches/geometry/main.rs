//! The methods that users call most, beside the same written with glam or nalgebra in `f64`.
//!
//! All contenders start from the same numbers: a plane is a normal of any length and a distance
//! times that length, a line a direction of any length and its moment, a sphere its centre, weight
//! and squared radius, a circle or a pair its centre, its normal or direction, whose length is the
//! weight, and its squared radius. What glam has no type for is written by hand with its vectors,
//! as a user of glam would.

mod by_hand;
mod construction;
mod fit;
mod measurement;
mod meets;
mod motions;
mod primitive_fit;
mod reading;

use criterion::{Criterion, criterion_group, criterion_main};
use nullcone_benches::comparison::{self, Comparison};

/// The group of one operation.
fn group<'a>(criterion: &'a mut Criterion, operation: &str) -> Comparison<'a> {
    Comparison::new(criterion, &format!("geometry/{operation}"))
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = construction::all, reading::all, measurement::all, meets::all, motions::all, fit::all,
        primitive_fit::all
}
criterion_main!(benches);
