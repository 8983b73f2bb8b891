//! How a body stands, read from the places of its joints alone.

use ga_runtime::vga3::Vector;

use super::human::{Human, Role};

/// A frame of three axes of length 1 at right angles, in the order left, up, forward for a body
/// that stands.
pub(super) type Axes = [Vector<f64>; 3];

/// A knee or an elbow that is bent by less does not say about which axis it bends.
const BENT: f64 = 15.0;
/// Of an ankle's way to the toes, the least horizontal part that says where a foot points.
const HORIZONTAL: f64 = 0.4;

/// The places of the joints of a body at one moment, y up.
pub(super) struct Posture<'a> {
    pub(super) human: &'a Human,
    pub(super) places: &'a [Vector<f64>],
}

/// What one moment says of the rotation of a joint.
pub(super) struct Observation {
    pub(super) axes: Axes,
    /// How much it says, from 0.
    pub(super) weight: f64,
    /// Whether it counts only where no moment says more.
    pub(super) is_fallback: bool,
}

const UP: Vector<f64> = Vector {
    e1: 0.0,
    e2: 1.0,
    e3: 0.0,
};

impl Posture<'_> {
    fn between(&self, from: usize, to: usize) -> Vector<f64> {
        self.places[to] - self.places[from]
    }

    /// From the hips to the head.
    pub(super) fn trunk(&self) -> Vector<f64> {
        self.between(self.human.hips, self.human.head)
    }

    /// From the right hip to the left one, of length 1.
    fn hip_line(&self) -> Option<Vector<f64>> {
        let [left, right] = self.human.legs.map(|leg| leg[0]);
        self.between(right, left).normalized()
    }

    /// From the right shoulder to the left one, of length 1; the hips' line for a body without
    /// arms.
    fn shoulder_line(&self) -> Option<Vector<f64>> {
        let Some(arms) = self.human.arms else {
            return self.hip_line();
        };
        self.between(arms[1][0], arms[0][0]).normalized()
    }

    /// The mean length of the legs.
    pub(super) fn leg_length(&self) -> f64 {
        let legs = self.human.legs.iter();
        let length = |&[hip, knee, ankle]: &[usize; 3]| {
            self.between(hip, knee).length() + self.between(knee, ankle).length()
        };
        legs.map(length).sum::<f64>() / 2.0
    }

    /// The horizontal direction in which the body looks.
    fn forward(&self) -> Option<Vector<f64>> {
        self.hip_line()?.cross(UP).normalized()
    }

    /// How little it stands upright: 0 with a vertical trunk and straight vertical legs.
    pub(super) fn cost_of_standing(&self) -> f64 {
        let square = |angle: Option<f64>, usual: f64| {
            (angle.unwrap_or(std::f64::consts::PI).to_degrees() / usual).powi(2)
        };
        let angle = |a: Vector<f64>, b: Vector<f64>| a.angle(b);
        let legs: f64 = self
            .human
            .legs
            .iter()
            .map(|&[hip, knee, ankle]| {
                let leg = square(angle(self.between(hip, ankle), -UP), 20.0);
                leg + square(
                    angle(self.between(hip, knee), self.between(knee, ankle)),
                    30.0,
                )
            })
            .sum();
        square(angle(self.trunk(), UP), 12.0) + legs / 2.0
    }

    /// What the places say of a joint's rotation. `head` is what is upright in the head, and
    /// `standing` and `contact` are how much the body stands and how much each foot stands on the
    /// ground, from 0 to 1.
    pub(super) fn observe(
        &self,
        role: Role,
        head: Vector<f64>,
        standing: f64,
        contact: [f64; 2],
    ) -> Vec<Observation> {
        let single = |axes: Option<Axes>, weight: f64| {
            let observation = axes.map(|axes| Observation {
                axes,
                weight,
                is_fallback: false,
            });
            observation.into_iter().collect()
        };
        match role {
            Role::Trunk(part) => single(self.trunk_axes(part), standing),
            Role::Clavicle => single(self.trunk_axes(1.0), standing),
            Role::Head => single(self.head_axes(head), standing),
            Role::Foot { side } => single(self.foot_axes(side), contact[side]),
            Role::Leg { side, bone } => {
                let usual = self.hip_line();
                self.limb(self.human.legs[side], bone, usual, standing)
            }
            Role::Arm { side, bone } => {
                let Some(arms) = self.human.arms else {
                    return Vec::new();
                };
                let [shoulder, _, wrist] = arms[side];
                let arm = self.between(shoulder, wrist);
                let usual = self.forward().map(|forward| arm.cross(forward));
                self.limb(arms[side], bone, usual, standing)
            }
        }
    }

    /// Left exactly along the line of hips or shoulders, up as near as can be along the trunk.
    fn trunk_axes(&self, part: f64) -> Option<Axes> {
        let (hips, shoulders) = (self.hip_line()?, self.shoulder_line()?);
        let left = hips.lerp(shoulders, part).normalized()?;
        from_left_and_up(left, self.trunk())
    }

    /// Left exactly along the line of the shoulders.
    fn head_axes(&self, up: Vector<f64>) -> Option<Axes> {
        from_left_and_up(self.shoulder_line()?, up)
    }

    /// Up vertical, forward to the toes, or where the body looks.
    fn foot_axes(&self, side: usize) -> Option<Axes> {
        let to_toes = self.human.toes[side].and_then(|toes| {
            let bone = self.between(self.human.legs[side][2], toes);
            let level = Vector::new(bone.e1, 0.0, bone.e3);
            (level.length() > HORIZONTAL * bone.length()).then_some(level)
        });
        let forward = to_toes.or_else(|| self.forward())?.normalized()?;
        Some([UP.cross(forward), UP, forward])
    }

    /// Up exactly against a bone, left along the axis about which the limb bends.
    fn limb(
        &self,
        [first, middle, last]: [usize; 3],
        bone: usize,
        usual: Option<Vector<f64>>,
        standing: f64,
    ) -> Vec<Observation> {
        let (upper, lower) = (self.between(first, middle), self.between(middle, last));
        let along = [upper, lower][bone];
        let bend = upper.angle(lower).map_or(0.0, f64::to_degrees);
        let hinge = (bend > BENT).then(|| upper.cross(lower));
        let observation = |axis: Option<Vector<f64>>, weight, is_fallback| {
            axis.and_then(|axis| from_up_and_left(-along, axis))
                .map(|axes| Observation {
                    axes,
                    weight,
                    is_fallback,
                })
        };
        let found = [
            observation(hinge, bend, false),
            observation(usual, standing, true),
        ];
        found.into_iter().flatten().collect()
    }
}

/// The axes with left exact and up as near as can be.
fn from_left_and_up(left: Vector<f64>, up: Vector<f64>) -> Option<Axes> {
    let left = left.normalized()?;
    let forward = left.cross(up).normalized()?;
    Some([left, forward.cross(left), forward])
}

/// The axes with up exact and left as near as can be.
fn from_up_and_left(up: Vector<f64>, left: Vector<f64>) -> Option<Axes> {
    let up = up.normalized()?;
    let forward = left.cross(up).normalized()?;
    Some([up.cross(forward), up, forward])
}
