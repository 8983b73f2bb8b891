//! The head and the face.

use super::loft::{Loft, Section, section};
use super::solid::{Bump, Shape, Solid, ellipsoid};
use crate::Vector;
use crate::frame::Frame;

/// Level sections of the skull; the caps make its base and its crown.
const SKULL: [Section; 2] = [
    level(1.660, 0.0735, [-0.092, 0.100], 2.2),
    level(1.680, 0.0745, [-0.093, 0.102], 2.2),
];

/// Level sections of the face from the chin to the brow.
const FACE: [Section; 6] = [
    level(1.546, 0.039, [0.030, 0.106], 2.1),
    level(1.560, 0.046, [0.018, 0.107], 2.2),
    level(1.580, 0.054, [0.002, 0.106], 2.3),
    level(1.605, 0.061, [-0.010, 0.104], 2.3),
    level(1.635, 0.064, [-0.014, 0.103], 2.3),
    level(1.660, 0.066, [-0.014, 0.102], 2.3),
];

const fn level(height: f64, half_width: f64, depth: [f64; 2], exponent: f64) -> Section {
    section(height, [-half_width, half_width], depth, exponent)
}

pub(crate) fn add_to(solid: &mut Solid) {
    solid.join(
        0.03,
        Shape::Loft(Loft::new(Frame::UPRIGHT, &SKULL, [0.098, 0.070])),
    );
    solid.join(
        0.03,
        Shape::Loft(Loft::new(Frame::UPRIGHT, &FACE, [0.026, 0.040])),
    );
    let nose = Shape::Cone {
        from: Vector::new(0.0, 1.645, 0.103),
        to: Vector::new(0.0, 1.605, 0.117),
        radii: [0.006, 0.0095],
    };
    solid.join(0.012, nose);
    let nostril = ellipsoid(
        Vector::new(0.009, 1.601, 0.110),
        Vector::new(0.0075, 0.0065, 0.009),
    );
    solid.join_pair(0.008, nostril);
    // A horizontal unit vector.
    let back = Vector::new(0.30, 0.0, -0.95) / 0.30f64.hypot(0.95);
    let up = Vector::Y;
    let ear = Shape::Ellipsoid {
        centre: Vector::new(0.072, 1.632, -0.012),
        axes: [back, up, back.cross(up)],
        radii: Vector::new(0.018, 0.031, 0.009),
    };
    solid.join_pair(0.010, ear);
}

pub(crate) fn bumps() -> Vec<Bump> {
    vec![
        // The hollows of the eyes with the closed lids in them, and the brow above.
        Bump {
            centre: Vector::new(0.032, 1.641, 0.102),
            radii: Vector::new(0.023, 0.014, 0.02),
            height: -0.010,
        },
        Bump {
            centre: Vector::new(0.032, 1.638, 0.098),
            radii: Vector::new(0.012, 0.009, 0.02),
            height: 0.006,
        },
        Bump {
            centre: Vector::new(0.030, 1.661, 0.106),
            radii: Vector::new(0.024, 0.008, 0.02),
            height: 0.003,
        },
        // Cheekbones.
        Bump {
            centre: Vector::new(0.050, 1.615, 0.075),
            radii: Vector::new(0.018, 0.014, 0.03),
            height: 0.003,
        },
        // Lips with the mouth between them, and the dent above the chin.
        Bump {
            centre: Vector::new(0.0, 1.578, 0.110),
            radii: Vector::new(0.022, 0.006, 0.02),
            height: 0.005,
        },
        Bump {
            centre: Vector::new(0.0, 1.564, 0.110),
            radii: Vector::new(0.019, 0.006, 0.02),
            height: 0.005,
        },
        Bump {
            centre: Vector::new(0.0, 1.571, 0.112),
            radii: Vector::new(0.024, 0.0025, 0.02),
            height: -0.004,
        },
        Bump {
            centre: Vector::new(0.0, 1.553, 0.110),
            radii: Vector::new(0.020, 0.006, 0.02),
            height: -0.004,
        },
        Bump {
            centre: Vector::new(0.0, 1.536, 0.108),
            radii: Vector::new(0.016, 0.010, 0.02),
            height: 0.004,
        },
        // Temples.
        Bump {
            centre: Vector::new(0.070, 1.668, 0.055),
            radii: Vector::new(0.02, 0.022, 0.03),
            height: -0.004,
        },
    ]
}
