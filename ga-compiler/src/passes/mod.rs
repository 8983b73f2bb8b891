//! What happens to a graph between lowering and emission.

mod cost;
mod live;

pub use cost::{Cost, cost};
pub use live::{Schedule, schedule};
