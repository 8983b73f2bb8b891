//! The program, run as a user runs it.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod animate;
mod bad_input;
mod bake;
mod body_evaluate;
mod body_fit;
mod camera_calibrate;
mod camera_files;
mod capture;
mod clip;
mod clip_convert;
mod clip_edit;
mod clip_retarget;
mod common;
mod contour;
mod contour_in_space;
mod curve;
mod demo;
mod draw;
mod expand;
mod frame;
mod kept;
mod manuals;
mod mesh;
mod mesh_subdivide;
mod outputs;
mod pages;
mod patterns;
mod quality;
mod quality_opinion;
mod reconstruct;
mod render;
mod render_animation;
mod signals;
mod skin;
mod stereo;
mod stereo_calibrate;
mod stereo_cameras;
mod stereo_pose;
mod texture;
mod tolerant;
mod video;
mod video_align;
mod video_comfort;
mod video_comfort_report;
