//! The tables that are printed, in the shape of Cui's.

use std::fmt::Write;

use super::report::Report;
use super::rows::Row;
use crate::frame::{self, Warning};

/// Cui, table 2: reconstruction errors on Human3.6M, protocol 2, in millimetres.
const TABLE_2: [(&str, f64); 6] = [
    ("SMPLify", 82.2),
    ("NBF", 60.2),
    ("GraphCMR", 76.2),
    ("SPIN", 94.0),
    ("METRO", 87.2),
    ("Cui", 57.2),
];

/// Cui, table 3: mean per joint position errors on Human3.6M, protocol 1, in millimetres.
const TABLE_3: [(&str, f64); 6] = [
    ("NeRF", 88.57),
    ("SMPL", 87.59),
    ("VIBE", 80.35),
    ("Deep Kinematic Pose", 106.95),
    ("HMR", 87.54),
    ("Cui", 85.23),
];

const PRINTED: &str = "as Cui prints it, on Human3.6M";
const MEASURED: &str = "measured here, on this motion, not on Human3.6M";

impl frame::Report for Report {
    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn text(&self) -> String {
        text(self)
    }
}

fn text(report: &Report) -> String {
    let mut text = format!(
        "{}: {} frames, {} joints, {} m a unit, cameras with f = {} px at {} m, pairs {} m apart\n",
        report.motion,
        report.frames,
        report.joints,
        report.metres_per_unit,
        report.focal_length_px,
        report.distance_metres,
        report.baseline_metres
    );
    /// Title, name of the column, printed figures, and where a row has its own.
    type Table<'a> = (
        &'a str,
        &'a str,
        &'a [(&'a str, f64)],
        fn(&Row) -> Option<f64>,
    );
    let tables: [Table<'_>; 2] = [
        (
            "Reconstruction error after Procrustes alignment (shape of Cui, table 2)",
            "Reconst. Error (mm)",
            &TABLE_2,
            |row| row.aligned_mm,
        ),
        (
            "Mean per joint position error (shape of Cui, table 3)",
            "MPJPE (mm)",
            &TABLE_3,
            |row| Some(row.mpjpe_mm),
        ),
    ];
    for (title, column, printed, value) in tables {
        // Writing to a string does not fail.
        let _ = writeln!(text, "\n{title}\n{:54}{column:>20}", "Method");
        let _ = writeln!(text, "  {PRINTED}");
        for (name, error) in printed {
            let _ = writeln!(text, "{name:54}{error:20.2}");
        }
        let _ = writeln!(text, "  {MEASURED}");
        for row in &report.rows {
            let error = value(row).map_or("-".to_owned(), |error| format!("{error:.2}"));
            let _ = writeln!(text, "{:54}{error:>20}", name(row));
        }
    }
    let _ = writeln!(
        text,
        "\nOther errors and times (shape of Cui, figs 9 and 10)\n{:54}{:>14}{:>14}{:>14}{:>14}",
        "Method", "root-rel. (mm)", "2-D (px)", "ms a frame", "joints found"
    );
    for row in &report.rows {
        let relative = row.root_relative_mm;
        let relative = relative.map_or("-".to_owned(), |error| format!("{error:.2}"));
        let found = format!("{:.1} %", 100.0 * row.joints_found);
        let _ = writeln!(
            text,
            "{:54}{relative:>14}{:14.2}{:14.3}{found:>14}",
            name(row),
            row.joint_error_px,
            row.milliseconds_per_frame
        );
    }
    let _ = writeln!(
        text,
        "Errors are means over the joints found; triangulation needs two views that show a joint."
    );
    text += &over_noise(&report.rows);
    text
}

/// The mean per joint position errors with a column for each noise.
fn over_noise(rows: &[Row]) -> String {
    let mut noises: Vec<f64> = rows.iter().map(|row| row.noise_px).collect();
    noises.sort_by(f64::total_cmp);
    noises.dedup();
    let mut lines: Vec<(String, &Row)> = Vec::new();
    for row in rows {
        let line = format!("{}{}", of_method(row), of_missing(row));
        if !lines.iter().any(|(other, _)| *other == line) {
            lines.push((line, row));
        }
    }
    let mut text = format!(
        "\nMPJPE (mm) with the standard deviation of the noise, {MEASURED}\n{:54}",
        "Method"
    );
    for noise in &noises {
        let _ = write!(text, "{:>10}", format!("{noise} px"));
    }
    text.push('\n');
    for (line, first) in lines {
        let _ = write!(text, "{line:54}");
        for noise in &noises {
            let is_there = |row: &&Row| {
                let a = (row.method, row.views, row.missing, row.noise_px);
                a == (first.method, first.views, first.missing, *noise)
            };
            let error = rows.iter().find(is_there);
            let error = error.map_or("-".to_owned(), |row| format!("{:.2}", row.mpjpe_mm));
            let _ = write!(text, "{error:>10}");
        }
        text.push('\n');
    }
    text
}

fn name(row: &Row) -> String {
    let noise = format!(", {} px of noise", row.noise_px);
    of_method(row) + &noise + &of_missing(row)
}

fn of_method(row: &Row) -> String {
    let views = if row.views == 1 { "view" } else { "views" };
    format!("{}, {} {views}", row.method.name(), row.views)
}

fn of_missing(row: &Row) -> String {
    match row.missing {
        0.0 => String::new(),
        missing => format!(", {} % missing", 100.0 * missing),
    }
}
