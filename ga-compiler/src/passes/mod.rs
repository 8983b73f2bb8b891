//! What happens to a graph between lowering and emission.

mod cost;
mod factor;
mod flatten;
mod live;
mod optimise;
mod orient;
mod part;
mod rate;
mod reciprocal;
mod reduce;
mod rewrite;
mod scale;
mod share;
mod substitute;

pub use cost::{Cost, cost};
pub use factor::factor;
pub use flatten::flatten;
pub use live::{Schedule, schedule};
pub use optimise::optimise;
pub use orient::orient;
pub use part::part;
pub use reciprocal::reciprocal;
pub use reduce::{reduce, relations};
pub use rewrite::Graph;
pub use scale::scale;
pub use share::share;
pub use substitute::substitute;
