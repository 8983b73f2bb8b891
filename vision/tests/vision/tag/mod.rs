//! Tags and boards of tags, in rendered pictures against the truth and against OpenCV.

mod boards;
mod opencv;
mod scene;
mod tags;
