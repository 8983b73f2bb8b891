//! What each step found, in a sentence with its most important numbers.

use anyhow::Result;

use super::run::Run;
use super::scores::{Scores, in_words};
use super::steps::{
    ALIGNED, ALIGNMENT, CALIBRATION, COMFORT, CONTOUR, DISPARITIES, DOTS, EVALUATION, KEY_FRAMES,
    MAPS, OPERATIONS, PEOPLE, QUALITY, RECTIFICATION, STATISTICS, SUBDIVISION, SURFACE, TEXTURE,
};
use super::studio::{BASELINE, FOCAL, SQUARE};
use crate::counted::counted;

/// The finding of a step; `None` where its picture shows it.
pub(super) fn finding(step: &str, run: &Run, scores: &Scores) -> Result<Option<String>> {
    let number = |key: &str| run.number(step, key);
    let sentence = match step {
        CALIBRATION => format!(
            "The cameras are {:.2} mm apart (true: {:.0}), the left one has a focal length of {:.1} \
             px (true: {FOCAL:.0}), and the squares have edges of {:.3} mm (true: {:.0}).",
            1e3 * number("/baseline_metres")?,
            1e3 * BASELINE,
            number("/left/focal_px/0")?,
            1e3 * number("/square_edge_mean_metres")?,
            1e3 * SQUARE,
        ),
        RECTIFICATION => format!(
            "The left camera is rotated by {:.2}°, the right one by {:.2}°.",
            number("/left_rotation_degrees")?,
            number("/right_rotation_degrees")?,
        ),
        DISPARITIES => format!(
            "Disparities go from {:.1} to {:.1} px; {:.0} % of the pixels have one.",
            number("/least_px")?,
            number("/greatest_px")?,
            number("/density")?,
        ),
        EVALUATION => format!(
            "{:.2} % of all pixels are wrong by more than 2, and {:.2} % of those that both cameras \
             see.",
            scores.bad_2_percent, scores.bad_2_visible_percent,
        ),
        SURFACE => format!(
            "{} points and {} triangles, from {:.2} to {:.2} m away.",
            number("/points")?,
            number("/triangles")?,
            number("/nearest_metres")?,
            number("/farthest_metres")?,
        ),
        CONTOUR => format!(
            "The disc has a radius of {:.1} mm and is {:.1} mm from its true place (the true radius \
             is {:.0} mm).",
            1e3 * number("/circle/radius_metres")?,
            scores.circle_centre_error_millimetres,
            1e3 * scores.circle_radius_metres,
        ),
        DOTS => format!(
            "{} of {} dots in the left film and {} of {} in the right one are recognised; they lie \
             {:.2} px (RMS) from where the pose has them.",
            number("/views/0/dots_recognised")?,
            number("/views/0/dots")?,
            number("/views/1/dots_recognised")?,
            number("/views/1/dots")?,
            number("/reprojection_rms_px")?,
        ),
        PEOPLE => format!(
            "The joints are {:.1} mm from the true ones on average, and {:.2} px in the left film. \
             The figure with the films is at the beginning of this page.",
            scores.joints.mean_per_joint_position_error_millimetres, scores.joints.joint_error_px,
        ),
        KEY_FRAMES => {
            let keys = run.said(step)?.values["key_frames"].as_array();
            let keys: Vec<String> = keys
                .into_iter()
                .flatten()
                .map(|key| key["index"].to_string())
                .collect();
            let shots = run.said(step)?.values["shots"].as_array();
            let shots = counted(shots.map_or(0, Vec::len), "shot");
            let keys = keys.join(", ");
            format!("The film has {shots}; its key frames are {keys}.")
        }
        STATISTICS => format!(
            "Shots: {}, with a static background: {}. The cameras stand still.",
            number("/total/shots")?,
            number("/total/static")?,
        ),
        QUALITY => format!(
            "Noise leaves a PSNR of {:.2} dB and an SSIM of {:.4}.",
            number("/psnr_of_mean_mse")?,
            number("/ssim")?,
        ),
        COMFORT => strains(&scores.uncomfortable_before),
        ALIGNMENT => format!(
            "The views are shifted by {:.2} % of their width.",
            number("/shift_parallax_percent")?
        ),
        ALIGNED => strains(&scores.uncomfortable_after),
        SUBDIVISION => format!(
            "{} vertices and {} faces.",
            number("/vertices")?,
            number("/faces")?
        ),
        TEXTURE => format!(
            "{:.0} % of the texture is covered by charts; {} texels come from the left picture and \
             {} from the right one.",
            100.0 * number("/utilisation")?,
            number("/views/0/best_texels")?,
            number("/views/1/best_texels")?,
        ),
        MAPS => format!(
            "The fine surface is up to {:.1} mm outside and {:.1} mm inside the coarse one.",
            1e3 * number("/displacement/maximum")?,
            -1e3 * number("/displacement/minimum")?,
        ),
        OPERATIONS => format!(
            "{} multiplications and {} additions.",
            number("/mul")?,
            number("/add")?
        ),
        _ => return Ok(None),
    };
    Ok(Some(sentence))
}

fn strains(checks: &[String]) -> String {
    match checks {
        [] => "Nothing strains the eyes: no check is orange or red in any frame, apart from too little \
               depth, which does not strain them."
            .to_owned(),
        checks => format!("These strain the eyes: {}.", in_words(checks)),
    }
}
