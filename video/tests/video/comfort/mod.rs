//! The comfort of stereoscopic video: closed forms, pictures with known defects, and real ones.

mod align;
mod cases;
mod clip;
mod defects;
mod degenerate;
mod inputs;
mod oracle;
mod scores;
