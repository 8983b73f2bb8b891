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

/// The centre of the left eyeball.
const EYE: Vector = Vector::new(0.0320, 1.6400, 0.0905);

pub(crate) fn add_to(solid: &mut Solid) {
    solid.join(
        0.03,
        Shape::Loft(Loft::new(Frame::UPRIGHT, &SKULL, [0.098, 0.070])),
    );
    solid.join(
        0.03,
        Shape::Loft(Loft::new(Frame::UPRIGHT, &FACE, [0.026, 0.040])),
    );
    // The ridge of the brows, the cheekbones and the chin.
    let brow = Shape::Cone {
        from: Vector::new(0.010, 1.6610, 0.0965),
        to: Vector::new(0.046, 1.6590, 0.0800),
        radii: [0.0095, 0.0075],
    };
    solid.join_pair(0.018, brow);
    let cheek = ellipsoid(
        Vector::new(0.040, 1.606, 0.068),
        Vector::new(0.023, 0.019, 0.022),
    );
    solid.join_pair(0.025, cheek);
    let chin = ellipsoid(
        Vector::new(0.0, 1.546, 0.090),
        Vector::new(0.021, 0.015, 0.019),
    );
    solid.join(0.020, chin);
    let nose = Shape::Cone {
        from: Vector::new(0.0, 1.6520, 0.0985),
        to: Vector::new(0.0, 1.6080, 0.1160),
        radii: [0.0060, 0.0090],
    };
    solid.join(0.016, nose);
    let tip = ellipsoid(
        Vector::new(0.0, 1.6045, 0.1165),
        Vector::new(0.0105, 0.0090, 0.0100),
    );
    solid.join(0.008, tip);
    let nostril = ellipsoid(
        Vector::new(0.0105, 1.6010, 0.1070),
        Vector::new(0.0070, 0.0070, 0.0095),
    );
    solid.join_pair(0.009, nostril);
    let upper_lip = Shape::Cone {
        from: Vector::new(0.003, 1.5770, 0.1050),
        to: Vector::new(0.0200, 1.5735, 0.0955),
        radii: [0.0055, 0.0030],
    };
    solid.join_pair(0.006, upper_lip);
    let lower_lip = Shape::Cone {
        from: Vector::new(0.004, 1.5655, 0.1040),
        to: Vector::new(0.0170, 1.5695, 0.0955),
        radii: [0.0062, 0.0030],
    };
    solid.join_pair(0.006, lower_lip);
    let eye = ellipsoid(EYE, Vector::new(0.0128, 0.0128, 0.0128));
    solid.join_pair(0.003, eye);
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
        // The hollows of the eyes, and the lids over the balls.
        Bump {
            centre: Vector::new(0.031, 1.641, 0.100),
            radii: Vector::new(0.021, 0.0135, 0.025),
            height: -0.0095,
        },
        Bump {
            centre: Vector::new(0.032, 1.6485, 0.094),
            radii: Vector::new(0.0150, 0.0032, 0.015),
            height: 0.0022,
        },
        Bump {
            centre: Vector::new(0.032, 1.6325, 0.094),
            radii: Vector::new(0.0140, 0.0030, 0.015),
            height: 0.0014,
        },
        // The nostrils, the furrow below the nose, the line of the mouth, the dent above the chin.
        Bump {
            centre: Vector::new(0.0065, 1.5955, 0.112),
            radii: Vector::new(0.0035, 0.0035, 0.008),
            height: -0.0030,
        },
        Bump {
            centre: Vector::new(0.0, 1.5880, 0.110),
            radii: Vector::new(0.0040, 0.0060, 0.012),
            height: -0.0012,
        },
        Bump {
            centre: Vector::new(0.0, 1.5720, 0.107),
            radii: Vector::new(0.0240, 0.0022, 0.020),
            height: -0.0030,
        },
        Bump {
            centre: Vector::new(0.0, 1.5555, 0.110),
            radii: Vector::new(0.0200, 0.0055, 0.020),
            height: -0.0030,
        },
        // The hollow of the ear.
        Bump {
            centre: Vector::new(0.0810, 1.6340, -0.0080),
            radii: Vector::new(0.0080, 0.0150, 0.0080),
            height: -0.0040,
        },
        // Temples.
        Bump {
            centre: Vector::new(0.070, 1.668, 0.055),
            radii: Vector::new(0.02, 0.022, 0.03),
            height: -0.004,
        },
    ]
}
