//! The summary that is printed at the end.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Duration;

use anyhow::{Context, Result};

use crate::output;
use crate::report::Report;

/// Prints where everything was written and the main results. It is not an error when the reader of
/// standard output closes it early.
pub(crate) fn print(report: &Report, files: &[(PathBuf, usize)], elapsed: Duration) -> Result<()> {
    let text = text(report, files, elapsed);
    output::print(&text).context("the files are written, but the summary cannot be printed")
}

fn text(report: &Report, files: &[(PathBuf, usize)], elapsed: Duration) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    let _ = write_to(&mut text, report, files, elapsed);
    text
}

fn write_to(
    text: &mut String,
    report: &Report,
    files: &[(PathBuf, usize)],
    elapsed: Duration,
) -> std::fmt::Result {
    write_input(text, report)?;
    write_checks(text, report)?;
    for (index, (path, bytes)) in files.iter().enumerate() {
        let label = if index == 0 { "wrote" } else { "" };
        writeln!(text, "{label:10} {}, {}", path.display(), size(*bytes))?;
    }
    writeln!(text, "took       {:.1} s", elapsed.as_secs_f64())
}

/// The figure and its motion.
fn write_input(text: &mut String, report: &Report) -> std::fmt::Result {
    let (figure, animation, motion) = (&report.figure, &report.animation, &report.input.motion);
    let group = figure
        .group
        .as_ref()
        .map(|group| format!(", group {group}"));
    writeln!(
        text,
        "figure     {}{}: {:.3} m tall, {} vertices, {} triangles, {} joints, up to {} influences",
        figure.name,
        group.unwrap_or_default(),
        figure.height_metres,
        figure.vertices,
        figure.triangles,
        figure.joints,
        figure.influences_max,
    )?;
    writeln!(
        text,
        "motion     {}: frames {} to {} of {}, {:.2} s, as {} frames at {:.2} Hz",
        motion.name,
        motion.first_frame,
        motion.last_frame,
        motion.frames,
        animation.duration_seconds,
        animation.frames,
        animation.frames_per_second,
    )?;
    if motion.calibration_frame_left_out {
        writeln!(
            text,
            "           frame 0 is a calibration pose and left out; --from 0 keeps it"
        )?;
    }
    if !motion.joints_without_counterpart.is_empty() {
        writeln!(
            text,
            "           not in the motion, so moved by their parents: {}",
            motion.joints_without_counterpart.join(", ")
        )?;
    }
    Ok(())
}

/// What was measured.
fn write_checks(text: &mut String, report: &Report) -> std::fmt::Result {
    let (checks, views) = (&report.animation.checks, &report.two_views);
    writeln!(
        text,
        "body       bones keep their length to {:.1e} m; lowest point {:+.1} to {:+.1} cm; \
         trunk {:.0}° from upright on average, {:.0}° at most",
        checks.bone_length_deviation_max_metres,
        100.0 * checks.lowest_vertex_min_metres,
        100.0 * checks.lowest_vertex_max_metres,
        checks.trunk_from_upright_mean_degrees,
        checks.trunk_from_upright_max_degrees,
    )?;
    writeln!(
        text,
        "skinning   linear and motor blend differ by {:.2} mm on average, {:.1} mm at most",
        1000.0 * checks.linear_to_motor_blend_mean_metres,
        1000.0 * checks.linear_to_motor_blend_max_metres,
    )?;
    writeln!(
        text,
        "two views  cameras {:.2} m apart find the joints to {:.1e} m without noise, \
         {:.1} mm with 1 px of noise (MPJPE, seed {})",
        views.baseline_metres,
        views.noise_free.mean_per_joint_position_error_metres,
        1000.0 * views.one_pixel_noise.mean_per_joint_position_error_metres,
        views.seed,
    )
}

/// A size in bytes as a person reads it.
fn size(bytes: usize) -> String {
    match bytes as f64 {
        few if few < 1e3 => format!("{bytes} bytes"),
        some if some < 1e6 => format!("{:.0} kB", some / 1e3),
        many => format!("{:.1} MB", many / 1e6),
    }
}
