//! Measured times, which differ from run to run: the only place where the demonstration has them.

use std::hint::black_box;
use std::time::Instant;

use anyhow::Result;
use ga_runtime::batch;
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use serde::Serialize;

/// The file beside the page.
pub(super) const FILE: &str = "times.js";
/// Points that are moved at once, and how often.
const POINTS: usize = 4096;
const ROUNDS: usize = 400;

/// Seconds of each step, by its name, and how fast points are moved.
#[derive(Debug, Default, Serialize)]
pub(super) struct Times {
    pub(super) steps: Vec<(String, f64)>,
    /// A motor beside an affine matrix of the crate glam, in nanoseconds for each point.
    pub(super) motor_nanoseconds: f64,
    pub(super) glam_nanoseconds: f64,
}

impl Times {
    /// The script of the page.
    pub(super) fn script(&self) -> Result<String> {
        let mut names = serde_json::Map::new();
        for (name, seconds) in &self.steps {
            names.insert(name.clone(), format!("{seconds:.2} s").into());
        }
        let nanoseconds = |value: f64| format!("{value:.2} ns");
        names.insert(
            "motor".to_owned(),
            nanoseconds(self.motor_nanoseconds).into(),
        );
        names.insert("glam".to_owned(), nanoseconds(self.glam_nanoseconds).into());
        Ok(format!(
            "for (const [name, time] of Object.entries({})) {{\n  \
             for (const place of document.querySelectorAll(`[data-time=\"${{name}}\"]`)) {{\n    \
             place.textContent = time;\n  }}\n}}\n",
            serde_json::to_string_pretty(&names)?
        ))
    }

    /// Measures how fast points are moved.
    pub(super) fn measure_kernels(&mut self) {
        let rotor = Rotor::from_axis_angle([0.6, 0.0, 0.8], 0.7).unwrap_or_default();
        let motor: Motor<f64> = Translator::from_displacement([0.1, 0.2, 0.3]) * rotor;
        let at = |k: usize| [0.0, 0.3, 0.7].map(|phase| (k as f64 * 0.1 + phase).sin());
        let mut points: Vec<Point<f64>> = (0..POINTS).map(|k| Point::from(at(k))).collect();
        self.motor_nanoseconds = fastest(|| batch::transform(&motor, black_box(&mut points)));
        let [x, y, z] = motor.rotor().to_matrix();
        let column = |k: usize| glam::DVec3::new(x[k], y[k], z[k]);
        let matrix = glam::DMat3::from_cols(column(0), column(1), column(2));
        let shift = glam::DVec3::from_array(motor.translator().displacement());
        let affine = glam::DAffine3::from_mat3_translation(matrix, shift);
        let mut rivals: Vec<glam::DVec3> = (0..POINTS).map(|k| at(k).into()).collect();
        self.glam_nanoseconds = fastest(|| {
            for point in black_box(&mut rivals) {
                *point = affine.transform_point3(*point);
            }
        });
    }
}

/// The least time of many rounds, in nanoseconds for each point.
fn fastest(mut work: impl FnMut()) -> f64 {
    let rounds = (0..ROUNDS).map(|_| {
        let begin = Instant::now();
        work();
        begin.elapsed().as_secs_f64()
    });
    1e9 * rounds.fold(f64::INFINITY, f64::min) / POINTS as f64
}
