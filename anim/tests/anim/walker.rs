//! People who walk and run, whose feet come down and lift off at known times.

use ga_anim::recording::{RecordedJoint, Recording};
use ga_anim::transform::Transform;
use ga_runtime::cga3::{Motor, Rotor, Translator};

/// A gait along a straight line. The left foot comes down at whole multiples of the stride, the
/// right one half a stride later.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gait {
    /// Metres per second.
    pub(crate) speed: f64,
    /// The time from a footfall to the next of the same foot, in seconds.
    pub(crate) stride: f64,
    /// The part of the stride in which a foot is on the ground.
    pub(crate) duty: f64,
    /// How high an ankle is lifted, in metres.
    pub(crate) lift: f64,
    /// The direction, as an angle about the vertical from z.
    pub(crate) heading: f64,
    /// What time the recording begins with.
    pub(crate) begin: f64,
    pub(crate) seconds: f64,
    pub(crate) rate: f64,
}

pub(crate) const WALK: Gait = Gait {
    speed: 1.0,
    stride: 1.2,
    duty: 0.6,
    lift: 0.12,
    heading: 0.0,
    begin: 0.35,
    seconds: 9.0,
    rate: 60.0,
};

pub(crate) const RUN: Gait = Gait {
    speed: 2.4,
    stride: 0.7,
    duty: 0.35,
    lift: 0.25,
    heading: 1.9,
    begin: 0.1,
    seconds: 2.3,
    rate: 60.0,
};

/// The joints, each with its parent and its place relative to it.
const JOINTS: [(&str, Option<usize>, [f64; 3]); 11] = [
    ("Hips", None, [0.0, 0.85, 0.0]),
    ("Spine", Some(0), [0.0, 0.25, 0.0]),
    ("Head", Some(1), [0.0, 0.35, 0.0]),
    ("LeftUpLeg", Some(0), [0.09, -0.05, 0.0]),
    ("LeftLeg", Some(3), [0.0, -THIGH, 0.0]),
    ("LeftFoot", Some(4), [0.0, -SHIN, 0.0]),
    ("LeftToeBase", Some(5), [0.0, -0.06, 0.15]),
    ("RightUpLeg", Some(0), [-0.09, -0.05, 0.0]),
    ("RightLeg", Some(7), [0.0, -THIGH, 0.0]),
    ("RightFoot", Some(8), [0.0, -SHIN, 0.0]),
    ("RightToeBase", Some(9), [0.0, -0.06, 0.15]),
];
pub(crate) const ANKLES: [usize; 2] = [5, 9];
const THIGH: f64 = 0.42;
const SHIN: f64 = 0.4;
/// The height of hips and standing ankles.
const HIPS: f64 = 0.85;
const ANKLE: f64 = 0.08;

impl Gait {
    /// When a foot comes down in the time of the recording: 0 for the left one.
    pub(crate) fn down(&self, side: usize) -> Vec<f64> {
        let first = 0.5 * self.stride * side as f64 - self.begin;
        let times = (0..100).map(|k| first + f64::from(k) * self.stride);
        times
            .filter(|time| (0.0..self.seconds).contains(time))
            .collect()
    }

    /// How far an ankle is before the hips and above its place on the ground.
    fn ankle(&self, side: usize, time: f64) -> [f64; 2] {
        let phase = (time / self.stride - 0.5 * side as f64).rem_euclid(1.0);
        let half = 0.5 * self.duty * self.stride * self.speed;
        if phase < self.duty {
            return [half - phase * self.stride * self.speed, 0.0];
        }
        let part = (phase - self.duty) / (1.0 - self.duty);
        // In the world: from one place to the next, at rest at both.
        let way = self.stride * self.speed;
        let eased = part * part * (3.0 - 2.0 * part);
        let in_world = way * eased - half;
        let moved = part * (1.0 - self.duty) * way;
        let lift = self.lift * (std::f64::consts::PI * part).sin().powi(2);
        [in_world - moved, lift]
    }

    pub(crate) fn recording(&self) -> Recording {
        let about = |axis: [f64; 3], angle| Rotor::from_axis_angle(axis, angle).unwrap();
        let x = [1.0, 0.0, 0.0];
        let at = |place: [f64; 3], rotor: Rotor<f64>| {
            Transform::from(Motor::from(Translator::from_displacement(place)) * rotor)
        };
        let frames = (self.seconds * self.rate).floor() as usize + 1;
        let mut locals = Vec::new();
        for frame in 0..frames {
            let time = self.begin + frame as f64 / self.rate;
            let mut rotors = [Rotor::default(); JOINTS.len()];
            rotors[0] = about([0.0, 1.0, 0.0], self.heading);
            for (side, ankle) in ANKLES.into_iter().enumerate() {
                let [before, lift] = self.ankle(side, time);
                let down = HIPS - 0.05 - ANKLE - lift;
                let far = before.hypot(down);
                let ahead = before.atan2(down);
                let cosine = |a: f64, b: f64, c: f64| (a * a + b * b - c * c) / (2.0 * a * b);
                let thigh = -(ahead + cosine(THIGH, far, SHIN).acos());
                let bend = std::f64::consts::PI - cosine(THIGH, SHIN, far).acos();
                assert!(
                    thigh.is_finite() && bend.is_finite(),
                    "the leg is too short"
                );
                rotors[ankle - 2] = about(x, thigh);
                rotors[ankle - 1] = about(x, bend);
                rotors[ankle] = about(x, -thigh - bend);
            }
            for (joint, &(_, parent, place)) in JOINTS.iter().enumerate() {
                let place = match parent {
                    Some(_) => place,
                    None => {
                        let way = self.speed * time;
                        let (sin, cos) = self.heading.sin_cos();
                        [way * sin, HIPS, way * cos]
                    }
                };
                locals.push(at(place, rotors[joint]));
            }
        }
        let joints = JOINTS.iter().map(|&(name, parent, place)| RecordedJoint {
            name: name.into(),
            parent,
            rest: at(place, Rotor::default()),
        });
        Recording::new(joints.collect(), self.rate.recip(), locals, vec![]).unwrap()
    }
}
