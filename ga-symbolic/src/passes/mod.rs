//! What happens to a graph between lowering and emission.

mod coefficients;
mod cost;
mod factor;
mod flatten;
mod fraction;
mod hoist;
mod optimise;
mod proportional;
mod reciprocal;
mod reduce;
mod rewrite;
mod scale;
mod schedule;
mod share;
mod signs;
mod stage;
mod substitute;
mod uniformity;

pub(crate) use coefficients::{Collected, uniform_coefficients};
pub use cost::{Cost, cost};
pub use factor::{factor, factor_together};
pub use flatten::flatten;
pub use fraction::fraction;
pub use hoist::{hoist, hoist as part};
pub use optimise::optimise;
pub(crate) use optimise::varying_cost;
pub use proportional::proportional;
pub use reciprocal::reciprocal;
pub use reduce::{reduce, relations};
pub use rewrite::Graph;
pub use scale::scale;
pub use schedule::{Schedule, schedule};
pub use share::share;
pub use signs::{choose_signs, choose_signs as orient};
pub use stage::{Stage, Stages};
pub use substitute::substitute;
