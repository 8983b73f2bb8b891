//! `report.json`, and what is printed of it at the end. Equal input gives equal bytes of the file.

use std::fmt::Write as _;

use ga_anim::retarget::Checks;
use ga_character::TwoViews;
use ga_character::model::File;
use ga_character::report::{AnimationReport, FigureReport};
use serde::Serialize;

use crate::frame::{self, Warning};

/// What is known of a motion that was written.
#[derive(Debug, Serialize)]
pub(crate) struct Report {
    pub(crate) tool: Tool,
    pub(crate) command: &'static str,
    pub(crate) input: Input,
    pub(crate) figure: FigureReport,
    pub(crate) animation: AnimationReport,
    /// What a motion that came from elsewhere looks like on the figure.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) checks: Option<Checks>,
    pub(crate) two_views: TwoViews,
    /// The files that are written beside this one.
    pub(crate) files: Vec<File>,
}

#[derive(Debug, Serialize)]
pub(crate) struct Tool {
    name: &'static str,
    version: &'static str,
}

impl Tool {
    pub(crate) const NULLCONE: Self = Self {
        name: "nullcone",
        version: env!("CARGO_PKG_VERSION"),
    };
}

/// The input.
#[derive(Debug, Serialize)]
pub(crate) struct Input {
    /// File names without their folders, or what the program made itself.
    pub(crate) mesh: String,
    pub(crate) rig: String,
    pub(crate) weights: String,
    pub(crate) motion: MotionInput,
}

/// The motion of the input.
#[derive(Debug, Serialize)]
pub(crate) struct MotionInput {
    pub(crate) name: String,
    pub(crate) joints: usize,
    pub(crate) frames: usize,
    pub(crate) frames_per_second: f64,
    /// The frames that were used, counted from 0.
    pub(crate) first_frame: usize,
    pub(crate) last_frame: usize,
    /// Whether frame 0 was taken for a calibration pose and left out.
    pub(crate) calibration_frame_left_out: bool,
    /// Joints of the rig that the motion does not have: they move with their parents.
    pub(crate) joints_without_counterpart: Vec<String>,
    /// How long one unit of the motion is on the figure.
    pub(crate) metres_per_unit: f64,
}

/// A motion that was written, and where.
#[derive(Debug, Serialize)]
pub(crate) struct Performed {
    #[serde(flatten)]
    pub(crate) report: Report,
    pub(crate) written: Vec<Written>,
    pub(crate) seconds: f64,
    /// What is unusual about the input.
    #[serde(skip)]
    pub(crate) warnings: Vec<Warning>,
}

/// A file that was written.
#[derive(Debug, Serialize)]
pub(crate) struct Written {
    pub(crate) file: String,
    pub(crate) bytes: usize,
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

impl Performed {
    fn write_to(&self, text: &mut String) -> std::fmt::Result {
        self.report.write_to(text)?;
        for (index, Written { file, bytes }) in self.written.iter().enumerate() {
            let label = if index == 0 { "wrote" } else { "" };
            writeln!(text, "{label:10} {file}, {}", size(*bytes))?;
        }
        writeln!(text, "took       {:.1} s", self.seconds)
    }
}

impl Report {
    /// The input, and what was measured.
    fn write_to(&self, text: &mut String) -> std::fmt::Result {
        let Self {
            figure,
            animation,
            two_views: views,
            ..
        } = self;
        let (motion, checks) = (&self.input.motion, &animation.checks);
        let group = figure.group.as_ref();
        writeln!(
            text,
            "figure     {}{}: {:.3} m tall, {} vertices, {} triangles, {} joints, up to {} influences",
            figure.name,
            group
                .map(|group| format!(", group {group}"))
                .unwrap_or_default(),
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
            *text += "           frame 0 is a calibration pose and left out; --from 0 keeps it\n";
        }
        if !motion.joints_without_counterpart.is_empty() {
            let joints = motion.joints_without_counterpart.join(", ");
            writeln!(
                text,
                "           not in the motion, so moved by their parents: {joints}"
            )?;
        }
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
}

/// A size in bytes as a person reads it.
fn size(bytes: usize) -> String {
    match bytes as f64 {
        few if few < 1e3 => format!("{bytes} bytes"),
        some if some < 1e6 => format!("{:.0} kB", some / 1e3),
        many => format!("{:.1} MB", many / 1e6),
    }
}
