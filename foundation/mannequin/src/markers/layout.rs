//! Where on the body the markers are.

use ga_anim::skeleton::{Joint, Skeleton};

use crate::Vector;

/// Markers round a bone.
pub(super) struct Ring {
    /// The name of the joint, on either side where it has two.
    name: &'static str,
    has_sides: bool,
    /// Where on the bone, from 0 at its head to 1 at its tail.
    along: f64,
    /// The angles of the markers about the bone in degrees: 0 to the front of the body, or upwards
    /// for a bone that points to the front, and 90 to the left.
    pub(super) angles: &'static [f64],
    /// The radius of the markers in metres.
    pub(super) radius: f64,
}

const AROUND: &[f64] = &[0.0, 90.0, 180.0, 270.0];
const DIAGONAL: &[f64] = &[45.0, 135.0, 225.0, 315.0];

/// A long bone has its markers round the middle, where the skin moves with the bone alone; limbs
/// get discs of about their own radius, since those of neighbours must not touch.
pub(super) const LAYOUT: &[Ring] = &[
    middle("Hips", 0.2, &[40.0, 140.0, 220.0, 320.0], 0.024),
    middle("Spine", 0.5, &[30.0, 150.0, 210.0, 330.0], 0.024),
    middle("Chest", 0.15, &[40.0, 140.0, 220.0, 320.0], 0.024),
    middle("Chest", 0.55, &[30.0, 150.0, 210.0, 330.0], 0.024),
    middle("Head", 0.45, &[45.0, 135.0, 225.0, 315.0], 0.022),
    sides("Shoulder", 0.7, &[0.0, 90.0, 180.0], 0.020),
    sides("UpperArm", 0.5, AROUND, 0.018),
    sides("LowerArm", 0.5, AROUND, 0.016),
    sides("Hand", 0.35, &[90.0, 270.0], 0.016),
    sides("UpperLeg", 0.5, DIAGONAL, 0.024),
    sides("LowerLeg", 0.4, DIAGONAL, 0.020),
    sides("Foot", 0.5, &[0.0, 90.0, 270.0], 0.018),
    sides("Toe", 0.2, &[0.0], 0.016),
];

const fn middle(name: &'static str, along: f64, angles: &'static [f64], radius: f64) -> Ring {
    Ring {
        name,
        has_sides: false,
        along,
        angles,
        radius,
    }
}

const fn sides(name: &'static str, along: f64, angles: &'static [f64], radius: f64) -> Ring {
    Ring {
        has_sides: true,
        ..middle(name, along, angles, radius)
    }
}

impl Ring {
    /// The joints that have this ring.
    pub(super) fn joints(&self, skeleton: &Skeleton) -> Vec<usize> {
        let sides: &[&str] = if self.has_sides {
            &["Left", "Right"]
        } else {
            &[""]
        };
        let names = sides.iter().map(|side| format!("{side}{}", self.name));
        names.filter_map(|name| skeleton.index(&name)).collect()
    }

    /// A point of the bone, and the direction from there to a marker.
    pub(super) fn ray(&self, joint: &Joint, angle: f64) -> Option<(Vector, Vector)> {
        let [head, tail] = [joint.head, joint.tail].map(Vector::from);
        let along = (tail - head).normalized()?;
        let forwards = if along.e3.abs() > 0.7 {
            Vector::Y
        } else {
            Vector::Z
        };
        let front = (forwards - along * along.dot(forwards)).normalized()?;
        let side = along.cross(front);
        let left = if side.e1 + side.e2 < 0.0 { -side } else { side };
        let (sin, cos) = angle.to_radians().sin_cos();
        Some((head + (tail - head) * self.along, front * cos + left * sin))
    }
}
