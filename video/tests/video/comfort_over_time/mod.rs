//! What needs several frames, or the depth of a shot: delays, the order of the eyes, the monitor.

mod align;
mod asynchrony;
mod exchanges;
mod monitor;
mod scene;
mod stereoscopy;
mod summary;
mod timeline;
