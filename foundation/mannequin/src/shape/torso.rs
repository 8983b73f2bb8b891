//! The torso and the neck.

use super::loft::{Loft, Section, section};
use super::solid::{Bump, Shape, Solid, ellipsoid};
use crate::Vector;
use crate::frame::Frame;

/// Level sections of the middle of the body from the pelvis to the top of the neck.
const SECTIONS: [Section; 19] = [
    level(0.760, 0.160, [-0.090, 0.086], 2.3),
    level(0.830, 0.165, [-0.096, 0.088], 2.3),
    level(0.895, 0.168, [-0.100, 0.092], 2.3),
    level(0.950, 0.165, [-0.100, 0.098], 2.3),
    level(1.000, 0.156, [-0.092, 0.104], 2.3),
    level(1.050, 0.144, [-0.077, 0.103], 2.3),
    level(1.100, 0.137, [-0.070, 0.101], 2.3),
    level(1.150, 0.138, [-0.076, 0.103], 2.4),
    level(1.200, 0.145, [-0.090, 0.108], 2.4),
    level(1.260, 0.154, [-0.106, 0.114], 2.4),
    level(1.320, 0.161, [-0.116, 0.114], 2.4),
    level(1.370, 0.160, [-0.117, 0.103], 2.4),
    level(1.410, 0.146, [-0.110, 0.080], 2.3),
    level(1.440, 0.118, [-0.099, 0.056], 2.1),
    level(1.465, 0.086, [-0.087, 0.040], 2.0),
    level(1.490, 0.066, [-0.077, 0.036], 2.0),
    level(1.515, 0.055, [-0.069, 0.038], 2.0),
    level(1.545, 0.049, [-0.060, 0.036], 2.0),
    level(1.585, 0.043, [-0.052, 0.028], 2.0),
];

const fn level(height: f64, half_width: f64, depth: [f64; 2], exponent: f64) -> Section {
    section(height, [-half_width, half_width], depth, exponent)
}

pub(crate) fn solid() -> Solid {
    let mut solid = Solid::default();
    solid.join(
        0.0,
        Shape::Loft(Loft::new(Frame::UPRIGHT, &SECTIONS, [0.05, 0.05])),
    );
    let chest = ellipsoid(
        Vector::new(0.080, 1.330, 0.061),
        Vector::new(0.088, 0.066, 0.058),
    );
    solid.join_pair(0.05, chest);
    // The slope of the trapezius from the neck to the shoulder.
    let slope = Shape::Cone {
        from: Vector::new(0.030, 1.495, -0.032),
        to: Vector::new(0.150, 1.418, -0.026),
        radii: [0.030, 0.036],
    };
    solid.join_pair(0.05, slope);
    solid
}

/// The buttocks, which lie over the seam of trunk and legs.
pub(crate) fn buttocks() -> Solid {
    let mut solid = Solid::default();
    solid.join_pair(
        0.01,
        ellipsoid(
            Vector::new(0.074, 0.876, -0.060),
            Vector::new(0.076, 0.084, 0.069),
        ),
    );
    solid
}

pub(crate) fn bumps() -> Vec<Bump> {
    vec![
        // The furrow of the spine.
        Bump {
            centre: Vector::new(0.0, 1.20, -0.105),
            radii: Vector::new(0.022, 0.20, 0.05),
            height: -0.007,
        },
        // Between the buttocks.
        Bump {
            centre: Vector::new(0.0, 0.885, -0.125),
            radii: Vector::new(0.014, 0.065, 0.06),
            height: -0.016,
        },
        // Between the breast muscles, and the edge under them.
        Bump {
            centre: Vector::new(0.0, 1.31, 0.12),
            radii: Vector::new(0.024, 0.07, 0.04),
            height: -0.004,
        },
        Bump {
            centre: Vector::new(0.085, 1.250, 0.115),
            radii: Vector::new(0.070, 0.024, 0.05),
            height: -0.003,
        },
        // Navel, and the line from it up to the breastbone.
        Bump {
            centre: Vector::new(0.0, 1.055, 0.104),
            radii: Vector::new(0.009, 0.011, 0.02),
            height: -0.006,
        },
        Bump {
            centre: Vector::new(0.0, 1.15, 0.106),
            radii: Vector::new(0.014, 0.09, 0.03),
            height: -0.003,
        },
        // The pit of the throat, the collarbones, the shoulder blades.
        Bump {
            centre: Vector::new(0.0, 1.455, 0.045),
            radii: Vector::new(0.014, 0.014, 0.03),
            height: -0.006,
        },
        Bump {
            centre: Vector::new(0.070, 1.449, 0.045),
            radii: Vector::new(0.055, 0.011, 0.03),
            height: 0.003,
        },
        Bump {
            centre: Vector::new(0.085, 1.35, -0.115),
            radii: Vector::new(0.045, 0.065, 0.04),
            height: 0.007,
        },
    ]
}
