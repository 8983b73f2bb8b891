//! Poses, expressions and capture matrices as CSV.

use ga_files::table::{Cell, Separator, row};

use super::points::PointTable;
use crate::capture::{CapturedFrame, FrameOutcome};

/// A row for each frame, with the displacement of each point by the expression, in metres. The
/// fields of points that were not seen are empty, and all those of a frame without a pose.
#[must_use]
pub fn expressions_csv(points: &PointTable, frames: &[FrameOutcome]) -> String {
    let has_time = points.frames[0].time.is_some();
    let mut header = vec![text("frame")];
    header.extend(has_time.then(|| text("time_seconds")));
    let columns = |name: &String| ["x", "y", "z"].map(|axis| text(&format!("{name}_{axis}")));
    header.extend(points.names.iter().flat_map(columns));
    let mut table = row(header, Separator::Comma);
    for (point_row, frame) in points.frames.iter().zip(frames) {
        let mut cells = vec![text(&point_row.label)];
        cells.extend(point_row.time.map(Cell::exact));
        for point in 0..points.names.len() {
            let missing = [Cell::Missing, Cell::Missing, Cell::Missing];
            let moved = frame
                .as_ref()
                .ok()
                .and_then(|frame| frame.expression[point]);
            let numbers = moved.map(|vector| vector.coordinates().map(Cell::exact));
            cells.extend(numbers.unwrap_or(missing));
        }
        table += &row(cells, Separator::Comma);
    }
    table
}

/// A row for each frame, with the pose of the head; empty fields where it has none.
#[must_use]
pub fn poses_csv(points: &PointTable, frames: &[FrameOutcome]) -> String {
    let names = [
        "frame",
        "x_metres",
        "y_metres",
        "z_metres",
        "quaternion_x",
        "quaternion_y",
        "quaternion_z",
        "quaternion_w",
        "rms_metres",
        "inliers",
    ];
    let mut table = row(names.map(text), Separator::Comma);
    for (point_row, frame) in points.frames.iter().zip(frames) {
        let mut cells = vec![text(&point_row.label)];
        match frame {
            Ok(frame) => {
                let motor = frame.motor();
                let ([x, y, z], w) = motor.rotor().to_quaternion();
                cells.extend(motor.translator().displacement().map(Cell::exact));
                cells.extend([x, y, z, w, frame.pose.root_mean_square].map(Cell::exact));
                cells.push(text(&frame.pose.inliers.len().to_string()));
            }
            Err(_) => cells.resize(names.len(), Cell::Missing),
        }
        table += &row(cells, Separator::Comma);
    }
    table
}

/// Four rows for each frame: the capture matrix, with empty fields for points that were not seen,
/// and for all of a frame without a pose.
#[must_use]
pub fn matrices_csv(points: &PointTable, frames: &[FrameOutcome]) -> String {
    let header = ["frame", "row"].into_iter();
    let header = header.chain(points.names.iter().map(String::as_str));
    let mut table = row(header.map(text), Separator::Comma);
    for (point_row, frame) in points.frames.iter().zip(frames) {
        let matrix = frame
            .as_ref()
            .map(CapturedFrame::matrix)
            .unwrap_or_default();
        for (axis, values) in ["x", "y", "z", "1"].iter().zip(matrix.rows()) {
            let mut fields = vec![Cell::Missing; points.names.len()];
            for (&point, &value) in matrix.points.iter().zip(&values) {
                fields[point] = Cell::exact(value);
            }
            let start = [text(&point_row.label), text(axis)];
            table += &row(start.into_iter().chain(fields), Separator::Comma);
        }
    }
    table
}

fn text(text: &str) -> Cell {
    Cell::Text(text.to_owned())
}
