//! No function at all.

use ga_runtime::ga;

ga! { ga_runtime::cga3; }

fn main() {}
