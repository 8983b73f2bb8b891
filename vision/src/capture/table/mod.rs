//! Tables of captured points, of keys on a mesh, and of results, as CSV.

mod keys;
mod points;
mod results;

pub use keys::{Key, KeyTableError, parse_keys};
pub use points::{PointRow, PointTable, PointTableError};
pub use results::{expressions_csv, matrices_csv, poses_csv};
