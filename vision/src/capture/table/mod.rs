//! Tables of captured points, of keys on a mesh, and of results, as [`ga_files::table`] reads and
//! writes them.
//!
//! [`PointTable::decode`] reads points as programs for motion capture and spreadsheets write them.
//! It finds by what the file says, not by its name, which dialect it is:
//!
//! | dialect | how it begins | lengths |
//! | --- | --- | --- |
//! | plain | `NAME_x,NAME_y,NAME_z`, before them `frame` and `time`; or no names | metres |
//! | Motive (OptiTrack) | `Format Version` | `Length Units` |
//! | Nexus (Vicon) | a section `Trajectories` | the row of units |
//! | TRC (OpenSim, Pose2Sim) | `PathFileType` | `Units` |
//!
//! Cells of plain tables are separated by commas, tabs or semicolons. Fields of a marker that was
//! not seen are empty or `NaN`, `NA`, `N/A`, `#N/A` or `null`; [`Zeros`] says what 0,0,0 means.
//! Markers that a program did not recognise, and columns that are not positions of markers, are
//! passed over, and [`PointTable::notes`] names them.
//!
//! C3D is binary and is not read: [`PointTableError::C3d`].

mod describe;
mod error;
mod keys;
mod layout;
mod lost;
mod motive;
mod note;
mod plain;
mod points;
mod reading;
mod results;
mod row;
mod trc;
mod vicon;

pub use error::PointTableError;
pub use keys::{Key, KeyTableError, decode_keys};
pub use lost::Zeros;
pub use note::PointTableNote;
pub use points::PointTable;
pub use results::{expressions_csv, matrices_csv, poses_csv};
pub use row::PointRow;
