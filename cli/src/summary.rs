//! The summary that is printed at the end.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::time::Duration;

use serde::Serialize;

use crate::frame::{self, Warning};
use crate::report::Report;

/// A motion that was written, and where.
#[derive(Debug, Serialize)]
pub(crate) struct Performed {
    #[serde(flatten)]
    report: Report,
    written: Vec<Written>,
    seconds: f64,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

/// A file that was written.
#[derive(Debug, Serialize)]
pub(crate) struct Written {
    file: String,
    bytes: usize,
}

impl Written {
    pub(crate) fn new(path: PathBuf, contents: &[u8]) -> Self {
        Self {
            file: path.display().to_string(),
            bytes: contents.len(),
        }
    }
}

impl Performed {
    pub(crate) fn new(report: Report, written: Vec<Written>, elapsed: Duration) -> Self {
        Self {
            report,
            written,
            seconds: elapsed.as_secs_f64(),
            warnings: Vec::new(),
        }
    }

    /// With what is unusual about the input.
    pub(crate) fn with_warnings(self, warnings: Vec<Warning>) -> Self {
        Self { warnings, ..self }
    }

    fn write_to(&self, text: &mut String) -> std::fmt::Result {
        write_input(text, &self.report)?;
        write_checks(text, &self.report)?;
        for (index, Written { file, bytes }) in self.written.iter().enumerate() {
            let label = if index == 0 { "wrote" } else { "" };
            writeln!(text, "{label:10} {file}, {}", size(*bytes))?;
        }
        writeln!(text, "took       {:.1} s", self.seconds)
    }
}

impl frame::Report for Performed {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn text(&self) -> String {
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = self.write_to(&mut text);
        text
    }
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
