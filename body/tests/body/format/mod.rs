//! Files of joints in pictures.

mod coco;
mod correspondence;
mod deeplabcut;
mod films;
mod frames;
mod joint_views;
mod models;
mod openpose;

use ga_body::format::{Detections, DetectorOptions, JointView, JointViews};

/// Three numbers for each of `count` joints: (10 k, 20 k, c).
fn keypoints(count: usize, confidence: f64) -> String {
    let numbers = (0..count).map(|k| format!("{}, {}, {confidence}", 10 * k, 20 * k));
    numbers.collect::<Vec<_>>().join(", ")
}

fn pixel(view: &JointView, frame: usize, joint: usize) -> Option<([f64; 2], f64)> {
    view.frames[frame][joint].map(|pixel| (pixel.position, pixel.deviation))
}

fn views(detections: Detections, options: &DetectorOptions) -> JointViews {
    JointViews::from_detections(&[("a".to_owned(), detections)], options).unwrap()
}
