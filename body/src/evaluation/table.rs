//! The tables of an evaluation, in the shape of Cui's.

use super::case::Case;
use super::evaluated::Evaluation;
use super::rows::Row;

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
const NOTE: &str =
    "Errors are means over the joints found; triangulation needs two views that show a joint.\n";

/// A table of Cui, and what is measured for it.
struct Table {
    title: &'static str,
    column: &'static str,
    printed: [(&'static str, f64); 6],
    /// The error in millimetres, where a method has one.
    error: fn(&Row) -> Option<f64>,
}

const TABLES: [Table; 2] = [
    Table {
        title: "Reconstruction error after Procrustes alignment (shape of Cui, table 2)",
        column: "Reconst. Error (mm)",
        printed: TABLE_2,
        error: |row| row.aligned_mm,
    },
    Table {
        title: "Mean per joint position error (shape of Cui, table 3)",
        column: "MPJPE (mm)",
        printed: TABLE_3,
        error: |row| Some(row.mpjpe_mm),
    },
];

impl Evaluation {
    /// A line that says what was measured on, and tables of the errors, with the numbers that Cui
    /// prints beside them. Those were measured on Human3.6M, and these on another motion, so that
    /// they cannot be compared one by one.
    #[must_use]
    pub fn tables(&self) -> String {
        let mut text = format!(
            "{} frames, {} joints, {} m a unit, cameras with f = {} px at {} m, pairs {} m apart\n",
            self.frames,
            self.joints,
            self.metres_per_unit,
            self.focal_length_px,
            self.distance_metres,
            self.baseline_metres
        );
        for table in TABLES {
            let Table { title, column, .. } = table;
            text += &format!("\n{title}\n{:54}{column:>20}\n  {PRINTED}\n", "Method");
            for (name, error) in table.printed {
                text += &format!("{name:54}{error:20.2}\n");
            }
            text += &format!("  {MEASURED}\n");
            for row in &self.rows {
                text += &format!("{:54}{:>20}\n", name(row), rounded((table.error)(row)));
            }
        }
        text + &others(&self.rows) + &over_noise(&self.rows)
    }
}

/// A number with two digits after the point.
fn rounded(error: Option<f64>) -> String {
    error.map_or("-".to_owned(), |error| format!("{error:.2}"))
}

/// The errors and times that are in no table of Cui.
fn others(rows: &[Row]) -> String {
    let mut text = format!(
        "\nOther errors and times (shape of Cui, figs 9 and 10)\n{:54}{:>14}{:>14}{:>14}{:>14}\n",
        "Method", "root-rel. (mm)", "2-D (px)", "ms a frame", "joints found"
    );
    for row in rows {
        let found = format!("{:.1} %", 100.0 * row.joints_found);
        text += &format!(
            "{:54}{:>14}{:14.2}{:14.3}{found:>14}\n",
            name(row),
            rounded(row.root_relative_mm),
            row.joint_error_px,
            row.milliseconds_per_frame
        );
    }
    text + NOTE
}

/// The mean per joint position errors with a column for each noise.
fn over_noise(rows: &[Row]) -> String {
    let mut noises: Vec<f64> = rows.iter().map(|row| row.case.noise_px).collect();
    noises.sort_by(f64::total_cmp);
    noises.dedup();
    let line = |row: &Row| (row.method, row.case.views, row.case.missing);
    let mut lines: Vec<&Row> = Vec::new();
    for row in rows {
        if !lines.iter().any(|other| line(other) == line(row)) {
            lines.push(row);
        }
    }
    let mut text = format!(
        "\nMPJPE (mm) with the standard deviation of the noise, {MEASURED}\n{:54}",
        "Method"
    );
    for noise in &noises {
        text += &format!("{:>10}", format!("{noise} px"));
    }
    text.push('\n');
    for first in lines {
        text += &format!("{:54}", of_method(first) + &of_missing(first));
        for noise in &noises {
            let is_there = |row: &&Row| line(row) == line(first) && row.case.noise_px == *noise;
            let error = rows.iter().find(is_there).map(|row| row.mpjpe_mm);
            text += &format!("{:>10}", rounded(error));
        }
        text.push('\n');
    }
    text
}

fn name(row: &Row) -> String {
    let noise = format!(", {} px of noise", row.case.noise_px);
    of_method(row) + &noise + &of_missing(row)
}

fn of_method(row: &Row) -> String {
    let views = Case::counted_views(row.case.views);
    format!("{}, {views}", row.method.name())
}

fn of_missing(row: &Row) -> String {
    Case::missing_in_words(row.case.missing)
}
