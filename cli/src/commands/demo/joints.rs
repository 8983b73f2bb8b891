//! How far the joints that were found are from the true ones.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};
use ga_body::pose_error::{mean_per_joint_position_error, procrustes_aligned};
use ga_camera::Camera;
use ga_files::table;
use ga_runtime::cga3::Point;
use serde::Serialize;

use super::inputs::Truth;

/// Mean distances over all joints and frames.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct JointErrors {
    /// In the world of the cameras (MPJPE).
    pub(super) mean_per_joint_position_error_millimetres: f64,
    /// After the best similarity of each frame.
    pub(super) aligned_error_millimetres: f64,
    /// In the pictures of the left camera.
    pub(super) joint_error_px: f64,
    /// Of the head alone, where a joint is called so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) head_error_millimetres: Option<f64>,
}

/// The joints of a table that `nullcone people` wrote.
pub(super) struct Table {
    table: table::Table,
    path: PathBuf,
    columns: Vec<[usize; 3]>,
}

impl Table {
    /// The joints of these names.
    pub(super) fn read(path: &Path, names: &[String]) -> Result<Self> {
        let bytes = std::fs::read(path).with_context(|| path.display().to_string())?;
        let table = table::Table::with_names(&bytes)?;
        let columns = names.iter().map(|name| {
            let column = |axis: &str| {
                let name = format!("{name}_{axis}");
                let column = table.column(&name);
                column.with_context(|| format!("{}: no column {name}", path.display()))
            };
            Ok([column("x")?, column("y")?, column("z")?])
        });
        Ok(Self {
            columns: columns.collect::<Result<_>>()?,
            path: path.to_path_buf(),
            table,
        })
    }

    /// Where the joints are in a frame.
    pub(super) fn frame(&self, frame: usize) -> Result<Vec<Point<f64>>> {
        let places = self.columns.iter().map(|axes| {
            let number = |column: usize| {
                let number = self.table.number(frame, column)?;
                number.with_context(|| format!("{}: an empty cell", self.path.display()))
            };
            Ok(Point::new(
                number(axes[0])?,
                number(axes[1])?,
                number(axes[2])?,
            ))
        });
        places.collect()
    }
}

impl JointErrors {
    /// Those of a table, seen by a camera.
    pub(super) fn of_table(path: &Path, truth: &Truth, camera: &Camera) -> Result<Self> {
        let table = Table::read(path, &truth.names)?;
        ensure!(
            table.table.len() == truth.joints.len(),
            "{}: {} frames, and the films have {}",
            path.display(),
            table.table.len(),
            truth.joints.len()
        );
        let head = truth.names.iter().position(|name| name == "Head");
        let (mut error, mut aligned, mut in_picture, mut of_head) = (0.0, 0.0, 0.0, 0.0);
        for (frame, expected) in truth.joints.iter().enumerate() {
            let found = table.frame(frame)?;
            error += mean_per_joint_position_error(expected, &found)?;
            aligned += procrustes_aligned(expected, &found)?.mean_error;
            for (expected, found) in expected.iter().zip(&found) {
                let [a, b] = [camera.project(*expected)?, camera.project(*found)?];
                in_picture += (a[0] - b[0]).hypot(a[1] - b[1]) / truth.names.len() as f64;
            }
            of_head += head.map_or(0.0, |head| expected[head].distance(found[head]));
        }
        let frames = truth.joints.len() as f64;
        Ok(Self {
            mean_per_joint_position_error_millimetres: 1e3 * error / frames,
            aligned_error_millimetres: 1e3 * aligned / frames,
            joint_error_px: in_picture / frames,
            head_error_millimetres: head.map(|_| 1e3 * of_head / frames),
        })
    }
}
