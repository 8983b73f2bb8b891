//! Tags and boards of tags, in rendered pictures against the truth and against OpenCV.

mod boards;
mod calibration;
mod opencv;
mod scene;
mod tags;
