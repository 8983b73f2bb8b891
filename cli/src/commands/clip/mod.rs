//! `nullcone clip`: recordings of motion in files.

mod blend;
mod compress;
mod convert;
mod info;
mod input;
mod mirror;
mod phases;
mod resample;
mod retarget;
mod sample;
mod target;

use crate::frame::group;

group! {
    /// Compress recordings of motion within a bound; convert, sample, resample, retarget, mirror
    /// and blend them.
    ///
    /// A motion may be BVH (.bvh), glTF 2.0 (.glb, .gltf) or a compressed clip (.clip); the ending
    /// of the name says which.
    Compress: compress::Arguments,
    Info: info::Arguments,
    Sample: sample::Arguments,
    Convert: convert::Arguments,
    Resample: resample::Arguments,
    Retarget: retarget::Arguments,
    Mirror: mirror::Arguments,
    Blend: blend::Arguments,
}
