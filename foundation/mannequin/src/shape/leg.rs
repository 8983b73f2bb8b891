//! The left leg and foot.

use super::loft::{Loft, Section, section};
use super::solid::{Bump, Shape, Solid, ellipsoid};
use crate::Vector;
use crate::frame::Frame;
use crate::landmarks::Landmarks;

/// Level sections from the ankle to the hip: towards and away from the middle, back and front.
const SECTIONS: [Section; 18] = [
    section(0.095, [0.075, 0.130], [-0.060, 0.000], 2.0),
    section(0.120, [0.074, 0.130], [-0.061, 0.000], 2.0),
    section(0.160, [0.070, 0.134], [-0.064, 0.006], 2.0),
    section(0.200, [0.064, 0.139], [-0.070, 0.014], 2.0),
    section(0.250, [0.056, 0.145], [-0.080, 0.024], 2.0),
    section(0.300, [0.048, 0.150], [-0.087, 0.034], 2.0),
    section(0.345, [0.044, 0.152], [-0.087, 0.041], 2.0),
    section(0.390, [0.044, 0.150], [-0.078, 0.046], 2.0),
    section(0.430, [0.046, 0.146], [-0.064, 0.050], 2.1),
    section(0.465, [0.045, 0.145], [-0.054, 0.056], 2.2),
    section(0.500, [0.043, 0.146], [-0.050, 0.062], 2.2),
    section(0.540, [0.039, 0.148], [-0.054, 0.067], 2.1),
    section(0.590, [0.031, 0.152], [-0.063, 0.074], 2.0),
    section(0.650, [0.022, 0.157], [-0.073, 0.080], 2.0),
    section(0.720, [0.013, 0.161], [-0.082, 0.085], 2.0),
    section(0.790, [0.007, 0.164], [-0.088, 0.086], 2.0),
    section(0.860, [0.004, 0.168], [-0.096, 0.086], 2.1),
    section(0.930, [0.002, 0.166], [-0.098, 0.090], 2.2),
];

/// Upright sections from the heel to the toes: inner and outer side, sole and back of the foot.
const FOOT: [Section; 7] = [
    section(-0.005, [-0.031, 0.031], [0.000, 0.086], 2.4),
    section(0.025, [-0.032, 0.033], [0.000, 0.088], 2.3),
    section(0.060, [-0.036, 0.036], [0.000, 0.073], 2.3),
    section(0.095, [-0.043, 0.042], [0.000, 0.054], 2.4),
    section(0.125, [-0.047, 0.046], [0.000, 0.040], 2.5),
    section(0.145, [-0.048, 0.045], [0.000, 0.033], 2.6),
    section(0.160, [-0.047, 0.041], [0.000, 0.030], 2.6),
];

pub(crate) fn solid(landmarks: &Landmarks) -> Solid {
    let mut solid = Solid::default();
    solid.join(
        0.0,
        Shape::Loft(Loft::new(Frame::UPRIGHT, &SECTIONS, [0.05, 0.05])),
    );
    solid.join(
        0.04,
        Shape::Loft(Loft::new(landmarks.foot, &FOOT, [0.060, 0.042])),
    );
    // The ankle bones, the inner one higher.
    let [x, y, z] = landmarks.ankle.coordinates();
    solid.join(
        0.012,
        ellipsoid(
            Vector::new(x - 0.026, y + 0.012, z + 0.004),
            Vector::new(0.009, 0.016, 0.016),
        ),
    );
    solid.join(
        0.012,
        ellipsoid(
            Vector::new(x + 0.026, y - 0.002, z - 0.006),
            Vector::new(0.009, 0.016, 0.015),
        ),
    );
    solid
}

pub(crate) fn bumps(landmarks: &Landmarks) -> Vec<Bump> {
    let [x, y, _] = landmarks.knee.coordinates();
    vec![
        // The kneecap and the tendon under it; the hollow of the knee.
        Bump {
            centre: Vector::new(x, y + 0.012, 0.066),
            radii: Vector::new(0.024, 0.024, 0.03),
            height: 0.006,
        },
        Bump {
            centre: Vector::new(x, y - 0.045, 0.056),
            radii: Vector::new(0.014, 0.020, 0.03),
            height: 0.002,
        },
        Bump {
            centre: Vector::new(x, y, -0.052),
            radii: Vector::new(0.022, 0.035, 0.02),
            height: -0.004,
        },
        // The two heads of the calf.
        Bump {
            centre: Vector::new(x - 0.024, 0.36, -0.080),
            radii: Vector::new(0.022, 0.06, 0.03),
            height: 0.004,
        },
        // The arch of the foot.
        Bump {
            centre: Vector::new(x - 0.034, 0.004, 0.02),
            radii: Vector::new(0.022, 0.016, 0.045),
            height: -0.010,
        },
    ]
}
