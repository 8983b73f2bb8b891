//! Poses, expressions and capture matrices as CSV.

use csv::Writer;

use super::points::PointTable;
use crate::capture::CapturedFrame;

/// A number so that it reads back exactly.
fn exact(number: f64) -> String {
    format!("{number:?}")
}

/// The bytes that were written.
fn finished(writer: Writer<Vec<u8>>) -> Result<Vec<u8>, csv::Error> {
    writer
        .into_inner()
        .map_err(|error| error.into_error().into())
}

/// A row for each frame, with the displacement of each point by the expression, in metres.
///
/// # Errors
/// A name cannot be written as CSV.
pub fn expressions_csv(
    points: &PointTable,
    frames: &[CapturedFrame],
) -> Result<Vec<u8>, csv::Error> {
    let mut writer = Writer::from_writer(Vec::new());
    let has_time = points.frames[0].time.is_some();
    let mut header = vec!["frame".to_owned()];
    header.extend(has_time.then(|| "time_seconds".to_owned()));
    let columns = |name: &String| ["x", "y", "z"].map(|axis| format!("{name}_{axis}"));
    header.extend(points.names.iter().flat_map(columns));
    writer.write_record(&header)?;
    for (row, frame) in points.frames.iter().zip(frames) {
        let mut record = vec![row.label.clone()];
        record.extend(row.time.map(exact));
        for displacement in &frame.expression {
            let fields = displacement.map(|vector| vector.coordinates().map(exact));
            record.extend(fields.unwrap_or_default());
        }
        writer.write_record(&record)?;
    }
    finished(writer)
}

/// A row for each frame, with the pose of the head.
///
/// # Errors
/// A name cannot be written as CSV.
pub fn poses_csv(points: &PointTable, frames: &[CapturedFrame]) -> Result<Vec<u8>, csv::Error> {
    let mut writer = Writer::from_writer(Vec::new());
    writer.write_record([
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
    ])?;
    for (row, frame) in points.frames.iter().zip(frames) {
        let motor = frame.motor();
        let ([x, y, z], w) = motor.rotor().to_quaternion();
        let mut record = vec![row.label.clone()];
        record.extend(motor.translator().displacement().map(exact));
        record.extend([x, y, z, w, frame.pose.root_mean_square].map(exact));
        record.push(frame.pose.inliers.len().to_string());
        writer.write_record(&record)?;
    }
    finished(writer)
}

/// Four rows for each frame: the capture matrix, with empty fields for points that were not seen.
///
/// # Errors
/// A name cannot be written as CSV.
pub fn matrices_csv(points: &PointTable, frames: &[CapturedFrame]) -> Result<Vec<u8>, csv::Error> {
    let mut writer = Writer::from_writer(Vec::new());
    let header = ["frame", "row"].into_iter();
    writer.write_record(header.chain(points.names.iter().map(String::as_str)))?;
    for (row, frame) in points.frames.iter().zip(frames) {
        let matrix = frame.matrix();
        for (axis, values) in ["x", "y", "z", "1"].iter().zip(matrix.rows()) {
            let mut fields = vec![String::new(); points.names.len()];
            for (&point, &value) in matrix.points.iter().zip(&values) {
                fields[point] = exact(value);
            }
            let start = [row.label.clone(), (*axis).to_owned()];
            writer.write_record(start.into_iter().chain(fields))?;
        }
    }
    finished(writer)
}
