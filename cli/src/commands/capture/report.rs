//! What `nullcone capture` prints.

use std::fmt::Write;
use std::path::PathBuf;

use ga_runtime::vga3::Vector;
use ga_vision::capture::CapturedFrame;
use ga_vision::capture::table::PointTable;
use serde::Serialize;

use super::Arguments;
use super::arguments::Area;
use super::surface::{Motion, Surface};
use crate::frame::{self, Warning};
use crate::rotation::smaller_rotation;

#[derive(Serialize)]
pub(crate) struct Report {
    #[serde(skip)]
    warnings: Vec<Warning>,
    /// What was written.
    #[serde(skip)]
    pub(super) files: Vec<PathBuf>,
    frames: usize,
    points: usize,
    calibrated: Vec<String>,
    reference_frame: String,
    expression: Expression,
    poses: Vec<Pose>,
    #[serde(skip_serializing_if = "Option::is_none")]
    surface: Option<SurfaceReport>,
    pub(super) seconds: f64,
}

/// How far points move beyond the pose.
#[derive(Serialize)]
struct Expression {
    /// Over all points that were seen.
    rms_metres: f64,
    max_metres: f64,
    max_point: String,
    max_frame: String,
    points: Vec<PointReport>,
}

#[derive(Serialize)]
struct PointReport {
    name: String,
    frames_seen: usize,
    rms_metres: f64,
    max_metres: f64,
}

/// The pose of the head in a frame.
#[derive(Serialize)]
struct Pose {
    frame: String,
    translation_metres: [f64; 3],
    /// x, y, z, w.
    rotation_quaternion: [f64; 4],
    rotation_axis: [f64; 3],
    rotation_degrees: f64,
    /// Of the calibrated points that agree.
    rms_metres: f64,
    inliers: usize,
    /// Calibrated points that were seen and do not agree.
    outliers: Vec<String>,
    missing: Vec<String>,
}

/// The surface, in the coordinates of the mesh, scaled to metres.
#[derive(Serialize)]
struct SurfaceReport {
    vertices: usize,
    keys: usize,
    /// How often a key was not seen, and moved as its neighbours do.
    keys_filled: usize,
    key_fit_rms_metres: f64,
    sphere_centre_metres: [f64; 3],
    folded_triangles: usize,
    morph_targets: usize,
    morph_error_max_metres: f64,
    metres_per_mesh_unit: f64,
    area: AreaReport,
}

#[derive(Serialize)]
struct AreaReport {
    #[serde(skip_serializing_if = "Option::is_none")]
    key: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    radius_metres: Option<f64>,
    vertices: usize,
    centre_metres: [f64; 3],
    centre_kept: bool,
    /// In each frame.
    centre_displacement_metres: Vec<[f64; 3]>,
}

impl Report {
    pub(super) fn new(
        arguments: &Arguments,
        points: &PointTable,
        calibrated: &[usize],
        reference: usize,
        frames: &[CapturedFrame],
        surface: Option<(&Surface, &Motion)>,
    ) -> Self {
        let name = |point: &usize| points.names[*point].clone();
        let poses = frames.iter().enumerate().map(|(index, frame)| {
            let row = &points.frames[index];
            let motor = frame.motor();
            let rotor = motor.rotor();
            let (rotation_axis, rotation_degrees) = smaller_rotation(rotor);
            let ([x, y, z], w) = rotor.to_quaternion();
            let is_seen = |point: &&usize| row.points[**point].is_some();
            let is_outlier =
                |point: &&usize| is_seen(point) && !frame.pose.inliers.contains(*point);
            Pose {
                frame: row.label.clone(),
                translation_metres: motor.translator().displacement(),
                rotation_quaternion: [x, y, z, w],
                rotation_axis,
                rotation_degrees,
                rms_metres: frame.pose.root_mean_square,
                inliers: frame.pose.inliers.len(),
                outliers: calibrated.iter().filter(is_outlier).map(name).collect(),
                missing: calibrated
                    .iter()
                    .filter(|p| !is_seen(p))
                    .map(name)
                    .collect(),
            }
        });
        let warnings = surface.map(|(surface, _)| surface.warnings.clone());
        Self {
            warnings: warnings.unwrap_or_default(),
            files: Vec::new(),
            frames: frames.len(),
            points: points.names.len(),
            calibrated: calibrated.iter().map(name).collect(),
            reference_frame: points.frames[reference].label.clone(),
            expression: Expression::new(points, frames),
            poses: poses.collect(),
            surface: surface.map(|(surface, motion)| {
                SurfaceReport::new(
                    surface,
                    motion,
                    arguments.area.as_ref(),
                    arguments.keep_centre,
                )
            }),
            seconds: 0.0,
        }
    }
}

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn text(&self) -> String {
        let mut lines = format!(
            "{} frames of {} points; {} of them calibrated, at rest in frame {}\n",
            self.frames,
            self.points,
            self.calibrated.len(),
            self.reference_frame
        );
        let greatest = |of: fn(&Pose) -> f64| self.poses.iter().map(of).fold(0.0, f64::max);
        let outliers: usize = self.poses.iter().map(|pose| pose.outliers.len()).sum();
        let rotation = greatest(|pose| pose.rotation_degrees);
        let rms = 1e3 * greatest(|pose| pose.rms_metres);
        let expression = &self.expression;
        // Writing to a string cannot fail.
        let _ = writeln!(
            lines,
            "pose: rotations up to {rotation:.2}°, calibrated points agree to {rms:.3} mm, \
             {outliers} left out\n\
             expression: {:.2} mm on average, up to {:.2} mm at point {} in frame {}",
            1e3 * expression.rms_metres,
            1e3 * expression.max_metres,
            expression.max_point,
            expression.max_frame
        );
        if let Some(surface) = &self.surface {
            let _ = writeln!(
                lines,
                "surface: {} of {} vertices move with {} keys; {} morph targets, exact to {:.4} mm",
                surface.area.vertices,
                surface.vertices,
                surface.keys,
                surface.morph_targets,
                1e3 * surface.morph_error_max_metres
            );
            let [x, y, z] = surface.area.centre_metres;
            let kept = if surface.area.centre_kept {
                ", kept"
            } else {
                ""
            };
            let _ = writeln!(lines, "centre of gravity ({x:.4}, {y:.4}, {z:.4}){kept}");
        }
        for path in &self.files {
            let _ = writeln!(lines, "wrote {}", path.display());
        }
        lines
    }
}

impl Expression {
    fn new(points: &PointTable, frames: &[CapturedFrame]) -> Self {
        let mut of_points = Vec::with_capacity(points.names.len());
        let (mut squares, mut count) = (0.0, 0);
        // The greatest, its point and its frame.
        let mut greatest = (0.0, 0, 0);
        for (point, name) in points.names.iter().enumerate() {
            let (mut sum, mut seen, mut max) = (0.0, 0, 0.0_f64);
            for (index, frame) in frames.iter().enumerate() {
                let Some(length) = frame.expression[point].map(Vector::length) else {
                    continue;
                };
                sum += length * length;
                seen += 1;
                max = max.max(length);
                if length > greatest.0 {
                    greatest = (length, point, index);
                }
            }
            squares += sum;
            count += seen;
            of_points.push(PointReport {
                name: name.clone(),
                frames_seen: seen,
                rms_metres: (sum / seen.max(1) as f64).sqrt(),
                max_metres: max,
            });
        }
        let (max_metres, point, frame) = greatest;
        Self {
            rms_metres: (squares / count.max(1) as f64).sqrt(),
            max_metres,
            max_point: points.names[point].clone(),
            max_frame: points.frames[frame].label.clone(),
            points: of_points,
        }
    }
}

impl SurfaceReport {
    fn new(surface: &Surface, motion: &Motion, area: Option<&Area>, kept: bool) -> Self {
        let metres = surface.metres_per_unit();
        let scaled = |place: Vector<f64>| (place * metres).coordinates();
        let displacements = surface.centre_displacements(motion).into_iter();
        Self {
            vertices: surface.vertex_count(),
            keys: surface.key_count(),
            keys_filled: motion.filled,
            key_fit_rms_metres: metres * surface.fit,
            sphere_centre_metres: scaled(surface.centre.into()),
            folded_triangles: surface.folded_triangles,
            morph_targets: motion.shapes.shapes.len(),
            morph_error_max_metres: metres * motion.shapes.error,
            metres_per_mesh_unit: metres,
            area: AreaReport {
                key: area.map(|area| area.key.clone()),
                radius_metres: area.map(|area| metres * area.radius),
                vertices: surface.area.vertex_count(),
                centre_metres: scaled(surface.area.centre_of_gravity().into()),
                centre_kept: kept,
                centre_displacement_metres: displacements.map(scaled).collect(),
            },
        }
    }
}
