//! The words of dictionaries, as data: row by row from the top left module of the upright tag,
//! which is the highest bit; 1 is white.

pub(super) mod april;
pub(super) mod aruco_4x4;
pub(super) mod aruco_5x5;
pub(super) mod aruco_6x6;
