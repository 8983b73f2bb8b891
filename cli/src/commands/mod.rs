//! The subcommands, a file each.

pub(crate) mod animate;
pub(crate) mod body;
pub(crate) mod camera;
pub(crate) mod capture;
pub(crate) mod clip;
pub(crate) mod completions;
pub(crate) mod contour;
pub(crate) mod curve;
pub(crate) mod demo;
pub(crate) mod draw;
pub(crate) mod expand;
pub(crate) mod man;
pub(crate) mod merge;
pub(crate) mod mesh;
pub(crate) mod people;
pub(crate) mod quality;
pub(crate) mod render;
pub(crate) mod skin;
pub(crate) mod stereo;
pub(crate) mod texture;
pub(crate) mod video;
