//! The studio in which the films of the demonstration are made: a room, two cameras, a board, and a
//! person with dots on the skin. All of it is known, which is the truth that results are measured
//! by.

mod board;
mod film;
mod room;
mod standpoint;

pub(super) use board::{SQUARE, board_pictures};
pub(super) use film::{FRAMES_PER_SECOND, Filmed, Stage};
pub(super) use room::{Disc, Room};
pub(super) use standpoint::{BASELINE, FOCAL, Standpoint};

/// Columns and rows of all pictures.
pub(super) const SIZE: [usize; 2] = [960, 720];
