//! Tables of captured points, of keys on a mesh, and of results, as [`ga_files::table`] reads and
//! writes them.

mod describe;
mod keys;
mod points;
mod results;

pub use keys::{Key, KeyTableError, decode_keys};
pub use points::{PointRow, PointTable, PointTableError};
pub use results::{expressions_csv, matrices_csv, poses_csv};
