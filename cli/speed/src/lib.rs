//! How fast a motor moves points, beside a matrix of the crate glam.
//!
//! A crate of its own, since generic functions are compiled where they are called: the program is
//! not optimised, but what it says of speed must be that of a crate which is.

use std::hint::black_box;
use std::time::Instant;

use ga_runtime::batch;
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use glam::{DAffine3, DMat3, DVec3};

/// Points that are moved at once, and how often.
const POINTS: usize = 4096;
const ROUNDS: usize = 400;

/// How long the same rotation and displacement of a point takes, in nanoseconds: the least of many
/// rounds over points that stay in the cache.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Speed {
    /// By a [`Motor`], with [`batch::transform`].
    pub motor_nanoseconds: f64,
    /// By a [`DAffine3`], a point at a time.
    pub glam_nanoseconds: f64,
}

impl Speed {
    /// Measures both. Takes some milliseconds.
    ///
    /// ```
    /// let speed = nullcone_speed::Speed::measure();
    /// assert!(speed.motor_nanoseconds > 0.0 && speed.glam_nanoseconds > 0.0);
    /// ```
    #[must_use]
    pub fn measure() -> Self {
        let rotor = Rotor::from_axis_angle([0.6, 0.0, 0.8], 0.7).unwrap_or_default();
        let motor: Motor<f64> = Translator::from_displacement([0.1, 0.2, 0.3]) * rotor;
        let at = |k: usize| [0.0, 0.3, 0.7].map(|phase| (k as f64 * 0.1 + phase).sin());
        let mut points: Vec<Point<f64>> = (0..POINTS).map(|k| Point::from(at(k))).collect();
        let motor_nanoseconds = fastest(|| batch::transform(&motor, black_box(&mut points)));
        let [x, y, z] = motor.rotor().to_matrix();
        let column = |k: usize| DVec3::new(x[k], y[k], z[k]);
        let matrix = DMat3::from_cols(column(0), column(1), column(2));
        let shift = DVec3::from_array(motor.translator().displacement());
        let affine = DAffine3::from_mat3_translation(matrix, shift);
        let mut rivals: Vec<DVec3> = (0..POINTS).map(|k| at(k).into()).collect();
        let glam_nanoseconds = fastest(|| {
            for point in black_box(&mut rivals) {
                *point = affine.transform_point3(*point);
            }
        });
        Self {
            motor_nanoseconds,
            glam_nanoseconds,
        }
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
