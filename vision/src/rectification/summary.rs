//! A rectified pair in numbers, under the names of JSON.

use ga_runtime::cga3::Motor;
use serde::Serialize;

use super::{Rectangle, Rectification};

/// Rectified pictures and their cameras, in pixels, metres and degrees. The depth at a disparity d
/// is `focal · baseline/(d + disparity_offset)`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RectificationSummary {
    /// Columns of the pictures.
    #[serde(rename = "width_px")]
    pub width: usize,
    /// Rows.
    #[serde(rename = "height_px")]
    pub height: usize,
    /// The focal length of both cameras.
    #[serde(rename = "focal_px")]
    pub focal: f64,
    /// The principal point of the left camera.
    #[serde(rename = "left_principal_px")]
    pub left_principal: [f64; 2],
    /// The principal point of the right camera.
    #[serde(rename = "right_principal_px")]
    pub right_principal: [f64; 2],
    /// The negative disparity of what is infinitely far away.
    #[serde(rename = "disparity_offset_px")]
    pub disparity_offset: f64,
    /// The distance between the cameras.
    #[serde(rename = "baseline_metres")]
    pub baseline: f64,
    /// By how much the left view is rotated in all.
    pub left_rotation_degrees: f64,
    /// By how much the right view is rotated in all.
    pub right_rotation_degrees: f64,
    /// The right angles in the rotation of the left view about its axis, clockwise: −90 to 180.
    pub left_roll_degrees: i16,
    /// The right angles in the rotation of the right view about its axis, clockwise: −90 to 180.
    pub right_roll_degrees: i16,
    /// Where every pixel of the left picture was seen.
    #[serde(rename = "left_valid_px")]
    pub left_valid: Rectangle,
    /// Where every pixel of the right picture was seen.
    #[serde(rename = "right_valid_px")]
    pub right_valid: Rectangle,
}

impl Rectification {
    /// The pictures and their cameras in numbers.
    #[must_use]
    pub fn summary(&self) -> RectificationSummary {
        let degrees = |motor: Motor<f64>| motor.rotor().canonical().to_axis_angle().1.to_degrees();
        let roll = |count: u8| match count {
            3 => -90,
            count => 90 * i16::from(count),
        };
        let [left_roll_degrees, right_roll_degrees] = self.quarter_turns.map(roll);
        let ([width, height], [left_valid, right_valid]) = (self.size, self.valid);
        RectificationSummary {
            width,
            height,
            focal: self.rig.left().focal()[0],
            left_principal: self.rig.left().principal(),
            right_principal: self.rig.right().principal(),
            disparity_offset: self.rig.disparity_offset(),
            baseline: self.rig.baseline(),
            left_rotation_degrees: degrees(self.left.motor),
            right_rotation_degrees: degrees(self.right.motor),
            left_roll_degrees,
            right_roll_degrees,
            left_valid,
            right_valid,
        }
    }
}
