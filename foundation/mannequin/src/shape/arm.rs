//! The left arm and hand.

use super::loft::{Loft, Section, section};
use super::solid::{Bump, Shape, Solid};
use crate::Vector;
use crate::frame::Frame;
use crate::landmarks::{ELBOW, Landmarks, WRIST, WRIST_FORWARD};

/// Sections across the arm from the shoulder to the knuckles: palm and back of the hand, back and
/// front of the arm (on the hand from the little finger to the index).
const SECTIONS: [Section; 17] = [
    section(0.030, [-0.052, 0.056], [-0.060, 0.062], 2.0),
    section(0.060, [-0.053, 0.056], [-0.060, 0.061], 2.0),
    section(0.100, [-0.050, 0.052], [-0.058, 0.056], 2.0),
    section(0.150, [-0.045, 0.046], [-0.054, 0.052], 2.0),
    section(0.200, [-0.042, 0.042], [-0.049, 0.050], 2.0),
    section(0.250, [-0.040, 0.039], [-0.043, 0.044], 2.0),
    section(0.300, [-0.042, 0.041], [-0.039, 0.041], 2.1),
    section(0.345, [-0.043, 0.044], [-0.034, 0.045], 2.0),
    section(0.390, [-0.040, 0.041], [-0.029, 0.048], 2.0),
    section(0.440, [-0.033, 0.034], [-0.022, 0.047], 2.0),
    section(0.500, [-0.025, 0.026], [-0.015, 0.045], 2.1),
    section(0.545, [-0.0205, 0.0205], [-0.012, 0.044], 2.2),
    section(0.570, [-0.019, 0.019], [-0.014, 0.046], 2.3),
    section(0.595, [-0.0175, 0.0170], [-0.019, 0.051], 2.4),
    section(0.620, [-0.0155, 0.0145], [-0.024, 0.056], 2.5),
    section(0.642, [-0.0130, 0.0120], [-0.025, 0.057], 2.5),
    section(0.656, [-0.0110, 0.0100], [-0.024, 0.055], 2.4),
];

/// A finger: where its knuckle is on the hand (along, towards the thumb), how far it spreads
/// towards the thumb (radians), how far it bends towards the palm at the knuckle and at each joint
/// after it (radians), the lengths of its three bones and the radii at their ends.
struct Finger {
    knuckle: [f64; 2],
    spread: f64,
    bends: [f64; 3],
    lengths: [f64; 3],
    radii: [f64; 4],
}

/// At rest the fingers curl, the little finger most.
const FINGERS: [Finger; 4] = [
    Finger {
        knuckle: [0.092, 0.0335],
        spread: 0.13,
        bends: [0.16, 0.26, 0.18],
        lengths: [0.040, 0.024, 0.017],
        radii: [0.0094, 0.0090, 0.0082, 0.0066],
    },
    Finger {
        knuckle: [0.096, 0.0110],
        spread: 0.035,
        bends: [0.20, 0.32, 0.22],
        lengths: [0.044, 0.028, 0.018],
        radii: [0.0096, 0.0092, 0.0084, 0.0068],
    },
    Finger {
        knuckle: [0.093, -0.0115],
        spread: -0.065,
        bends: [0.23, 0.37, 0.25],
        lengths: [0.041, 0.026, 0.018],
        radii: [0.0092, 0.0088, 0.0080, 0.0065],
    },
    Finger {
        knuckle: [0.084, -0.0320],
        spread: -0.17,
        bends: [0.27, 0.40, 0.27],
        lengths: [0.032, 0.019, 0.016],
        radii: [0.0085, 0.0079, 0.0072, 0.0060],
    },
];

pub(crate) fn solid(landmarks: &Landmarks) -> Solid {
    let mut solid = Solid::default();
    solid.join(
        0.0,
        Shape::Loft(Loft::new(landmarks.arm, &SECTIONS, [0.085, 0.010])),
    );
    let hand = hand_frame(landmarks);
    for finger in &FINGERS {
        let mut from = hand.point(finger.knuckle[0] - 0.006, -0.001, finger.knuckle[1]);
        let sideways = finger.spread;
        let mut bend = 0.0;
        for (i, length) in finger.lengths.iter().enumerate() {
            let length = if i == 0 { length + 0.006 } else { *length };
            bend += finger.bends[i];
            let to = from + direction(&hand, sideways, bend) * length;
            let radii = [finger.radii[i], finger.radii[i + 1]];
            solid.join(
                if i == 0 { 0.012 } else { 0.0 },
                Shape::Cone { from, to, radii },
            );
            from = to;
        }
    }
    let thumb = [
        hand.point(0.012, -0.006, 0.020),
        hand.point(0.046, -0.021, 0.047),
        hand.point(0.078, -0.032, 0.060),
        hand.point(0.104, -0.040, 0.062),
    ];
    let radii = [0.0150, 0.0118, 0.0102, 0.0080];
    for i in 0..3 {
        let shape = Shape::Cone {
            from: thumb[i],
            to: thumb[i + 1],
            radii: [radii[i], radii[i + 1]],
        };
        solid.join(if i == 0 { 0.016 } else { 0.002 }, shape);
    }
    solid
}

pub(crate) fn bumps(landmarks: &Landmarks) -> Vec<Bump> {
    let arm = &landmarks.arm;
    vec![
        // The point of the elbow.
        Bump {
            centre: arm.point(ELBOW, 0.0, -0.040),
            radii: Vector::new(0.018, 0.018, 0.02),
            height: 0.005,
        },
        // The hollow of the palm.
        Bump {
            centre: arm.point(WRIST + 0.055, -0.016, WRIST_FORWARD),
            radii: Vector::new(0.02, 0.02, 0.02),
            height: -0.003,
        },
    ]
}

/// Where the hand begins, with the axes of the arm.
fn hand_frame(landmarks: &Landmarks) -> Frame {
    Frame {
        origin: landmarks.arm.point(WRIST, 0.0, WRIST_FORWARD),
        ..landmarks.arm
    }
}

/// The unit vector along the hand, rotated towards the thumb by `sideways` and towards the palm by
/// `bend`.
fn direction(hand: &Frame, sideways: f64, bend: f64) -> Vector {
    let level = hand.along * sideways.cos() + hand.depth * sideways.sin();
    level * bend.cos() - hand.across * bend.sin()
}
