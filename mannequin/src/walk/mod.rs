//! A walk: the gait put on the ground.
//!
//! The joint angles alone would let the feet slide. So where the pelvis is follows from the leg
//! that stands: with its foot fixed on the ground, forward kinematics through ankle, knee and hip
//! says where the hips are. Then, with hips that also sway and turn, inverse kinematics gives the
//! last of the angles of every leg that touches the ground, so that heel, ball and toe stay where
//! they have been set down.

mod gait;
mod leg;

use ga_runtime::cga3::{Motor, Point, Rotor, Translator};

use crate::landmarks::{ARM_DROP, HEEL, Landmarks, TOE_TIP};
use crate::skeleton::{ARM, CHEST, COUNT, HEAD, HIPS, LEG, NECK, SPINE, skeleton};
use crate::vector::{Vector, add, sub};
use ga_anim::clip::Clip;
use ga_anim::pose::Pose;
use gait::{HEEL_OFF, HEEL_STRIKE, LegMoment, TOE_OFF};
use leg::{Leg, LegAngles};

pub use gait::{KEY_NAMES, KEYS_PER_STRIDE};

/// Seconds from one key pose to the next: 110 steps a minute.
pub const KEY_TIME: f64 = 60.0 / 110.0 / 4.0;

/// A walk of so many strides, two steps each, straight along +z: [`KEYS_PER_STRIDE`] key poses a
/// stride, [`KEY_TIME`] apart, and one more that ends the last stride.
///
/// It begins as the left heel touches the ground, with the left ankle at z = 0. Interpolated
/// between the keys, the foot that stands stays within a centimetre of where it has been set down.
/// The poses are for [`Human::skeleton`](super::Human::skeleton).
///
/// # Examples
///
/// ```
/// use ga_mannequin::{KEYS_PER_STRIDE, walk};
///
/// let two_strides = walk(2);
/// assert_eq!(two_strides.frames().len(), 2 * KEYS_PER_STRIDE + 1);
/// ```
#[must_use]
pub fn walk(strides: u16) -> Clip {
    let landmarks = Landmarks::new();
    let skeleton = skeleton(&landmarks);
    let stride = stride(&landmarks, skeleton.joints()[HIPS].head);
    let frames = (0..=usize::from(strides) * KEYS_PER_STRIDE).map(|frame| {
        let key = &stride.keys[frame % KEYS_PER_STRIDE];
        let before = (frame / KEYS_PER_STRIDE) as f64 * stride.length;
        let place = Translator::from_displacement(add(key.root, [0.0, 0.0, before]));
        Pose::from_rotors(&skeleton, Motor::from(place), &key.rotors)
            .expect("a rotor for each joint")
    });
    Clip::new(KEY_TIME, frames.collect()).expect("one frame or more, all of one skeleton")
}

/// The pose of one moment: how far the whole body has moved and how each joint is turned from rest.
#[derive(Clone, Debug)]
struct Key {
    root: Vector,
    rotors: Vec<Rotor<f64>>,
}

/// One stride as [`KEYS_PER_STRIDE`] key poses, and how far it goes. It begins as the left heel
/// touches the ground, with the left ankle over z = 0.
#[derive(Clone, Debug)]
struct Stride {
    keys: Vec<Key>,
    length: f64,
}

/// Walking, the feet are this far from the middle, in metres.
const TRACK: f64 = 0.072;
/// How far the upper arms are off the vertical, to the sides, in radians.
const ARM_SPREAD: f64 = 0.16;
/// How far the trunk leans forward, in radians.
const LEAN: f64 = 0.03;
/// The slope of the toes as they leave the ground, in radians.
const PUSH_OFF: f64 = -0.45;

fn stride(landmarks: &Landmarks, hips: Vector) -> Stride {
    let walker = Walker {
        landmarks,
        leg: Leg::new(landmarks),
        hips,
    };
    let heel_off = walker.heel_off();
    let pelvis: Vec<Pelvis> = (0..=KEYS_PER_STRIDE / 2)
        .map(|key| walker.pelvis(key, heel_off))
        .collect();
    let step = pelvis[KEYS_PER_STRIDE / 2].place[2] - pelvis[0].place[2];
    let keys = (0..KEYS_PER_STRIDE).map(|key| {
        let half = key / (KEYS_PER_STRIDE / 2);
        let mut now = pelvis[key % (KEYS_PER_STRIDE / 2)];
        if half == 1 {
            now = now.mirrored();
        }
        now.place[2] += half as f64 * step;
        walker.key(key, now, heel_off, step)
    });
    Stride {
        keys: keys.collect(),
        length: 2.0 * step,
    }
}

struct Walker<'a> {
    landmarks: &'a Landmarks,
    leg: Leg,
    /// The joint of the hips at rest.
    hips: Vector,
}

/// The pelvis: where it is, as a displacement from rest, and how it is turned.
#[derive(Clone, Copy, Debug)]
struct Pelvis {
    place: Vector,
    turn: f64,
    list: f64,
}

impl Pelvis {
    fn mirrored(self) -> Self {
        let [x, y, z] = self.place;
        Pelvis {
            place: [-x, y, z],
            turn: -self.turn,
            list: -self.list,
        }
    }

    /// How it is turned; on the right side, how its mirror image is.
    fn rotor(&self, side: Side) -> Rotor<f64> {
        side.turn(Y, self.turn) * side.turn(Z, self.list)
    }
}

const X: Vector = [1.0, 0.0, 0.0];
const Y: Vector = [0.0, 1.0, 0.0];
const Z: Vector = [0.0, 0.0, 1.0];

impl Walker<'_> {
    /// The pelvis from the left leg, which stands with its footprint at z = 0: forward kinematics
    /// from the ground up.
    fn pelvis(&self, key: usize, heel_off: f64) -> Pelvis {
        let moment = gait::LEG[key];
        let trunk = gait::trunk(key);
        let mut pelvis = Pelvis {
            place: [trunk.sway, 0.0, 0.0],
            turn: trunk.turn,
            list: trunk.list,
        };
        let angles = self
            .leg
            .clinical(moment.hip.to_radians(), moment.knee.to_radians());
        let hip = self.hip(&pelvis);
        let below = self.leg.ankle(angles);
        let (ankle, _) = self.planted(key, heel_off, 0.0);
        for k in 1..3 {
            pelvis.place[k] = ankle[k] - below[k] - hip[k];
        }
        pelvis
    }

    /// The slope of the rear sole as the other heel touches the ground: that with which both legs
    /// reach the ground from one pelvis.
    fn heel_off(&self) -> f64 {
        let front = self.pelvis(HEEL_STRIKE, 0.0).place[1];
        let (mut low, mut high) = (-0.9, 0.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if self.pelvis(HEEL_OFF, middle).place[1] > front {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    /// The left hip joint of a pelvis.
    fn hip(&self, pelvis: &Pelvis) -> Vector {
        let arm = turned(pelvis.rotor(Side::Left), sub(self.landmarks.hip, self.hips));
        add(add(self.hips, pelvis.place), arm)
    }

    /// The ankle of a left foot that touches the ground at this moment of its stride, and the slope
    /// of its sole; the footprint is at `z`.
    fn planted(&self, moment: usize, heel_off: f64, z: f64) -> (Vector, f64) {
        let foot = &self.landmarks.foot;
        let sole = if moment == HEEL_OFF {
            heel_off
        } else {
            gait::LEG[moment].sole.to_radians()
        };
        let at = |along: f64, up: f64| sub(foot.point(along, 0.0, up), foot.origin);
        let ankle = sub(self.landmarks.ankle, foot.origin);
        let swung = |pivot: Vector, slope: f64, p: Vector| {
            add(pivot, turned(self.slope(slope), sub(p, pivot)))
        };
        let ball = sub(self.landmarks.ball, foot.origin);
        let over = match moment {
            HEEL_STRIKE => swung(at(HEEL + 0.018, 0.004), sole, ankle),
            TOE_OFF => {
                let tip = at(TOE_TIP - 0.008, 0.004);
                let lifted = swung(tip, PUSH_OFF, ball);
                add(lifted, turned(self.slope(sole), sub(ankle, ball)))
            }
            _ => swung(ball, sole, ankle),
        };
        (add([TRACK, 0.0, z], over), sole)
    }

    /// The left foot turned so that its sole rises towards the toes.
    fn slope(&self, angle: f64) -> Rotor<f64> {
        turn(self.landmarks.foot.across, -angle)
    }

    /// The pose at a key, with the pelvis where it is then.
    fn key(&self, key: usize, pelvis: Pelvis, heel_off: f64, step: f64) -> Key {
        let mut rotors = vec![Rotor::default(); COUNT];
        rotors[HIPS] = pelvis.rotor(Side::Left);
        self.spine_rotors(&pelvis, &mut rotors);
        let opposite = (key + KEYS_PER_STRIDE / 2) % KEYS_PER_STRIDE;
        // The right foot leaves its print one step behind the left one's and sets the next one step
        // ahead of it.
        let right_print = if key < KEYS_PER_STRIDE / 2 {
            -step
        } else {
            step
        };
        let left = self.leg_rotors(Side::Left, key, &pelvis, heel_off, 0.0);
        let right = self.leg_rotors(
            Side::Right,
            opposite,
            &pelvis.mirrored(),
            heel_off,
            right_print,
        );
        for (side, moment, leg) in [(Side::Left, key, left), (Side::Right, opposite, right)] {
            let arm = self.arm_rotors(side, moment);
            rotors[ARM[side as usize]..][..4].copy_from_slice(&arm);
            rotors[LEG[side as usize]..][..4].copy_from_slice(&leg);
        }
        Key {
            root: pelvis.place,
            rotors,
        }
    }

    /// The rotors of a leg's four joints at a moment of its stride. For the right leg the pelvis is
    /// a mirror image.
    fn leg_rotors(
        &self,
        side: Side,
        moment: usize,
        pelvis: &Pelvis,
        heel_off: f64,
        print: f64,
    ) -> [Rotor<f64>; 4] {
        let LegMoment { hip, knee, sole } = gait::LEG[moment];
        let literature = self.leg.clinical(hip.to_radians(), knee.to_radians());
        let frame = pelvis.rotor(Side::Left);
        let hip = self.hip(pelvis);
        let (angles, sole, toes) = if moment <= TOE_OFF {
            let (ankle, sole) = self.planted(moment, heel_off, print);
            let target = turned(frame.reverse(), sub(ankle, hip));
            let angles = self.leg.reach(target).unwrap_or(literature);
            let toes = match moment {
                HEEL_OFF => -sole,
                TOE_OFF => PUSH_OFF - sole,
                _ => 0.0,
            };
            (angles, sole, toes)
        } else {
            let angles = self.over_track(literature, frame, hip);
            (angles, sole.to_radians(), 0.0)
        };
        let across = self.landmarks.foot.across;
        let thigh = side.turn(Z, angles.spread) * side.turn(X, angles.flexion);
        let shank = side.turn(X, angles.knee);
        let above = pelvis.rotor(side) * thigh * shank;
        [
            thigh,
            shank,
            above.reverse() * side.turn(across, -sole),
            side.turn(across, -toes),
        ]
    }

    /// The leg spread so that the ankle passes over the foot's track.
    fn over_track(&self, mut angles: LegAngles, frame: Rotor<f64>, hip: Vector) -> LegAngles {
        for _ in 0..8 {
            let ankle = add(hip, turned(frame, self.leg.ankle(angles)));
            angles.spread += (TRACK - ankle[0]) / (hip[1] - ankle[1]);
        }
        angles
    }

    /// The rotors of an arm's four joints at a moment of the stride of its side.
    fn arm_rotors(&self, side: Side, key: usize) -> [Rotor<f64>; 4] {
        let arm = gait::left_arm(key);
        let drop = std::f64::consts::FRAC_PI_2 - ARM_DROP - ARM_SPREAD;
        let bend = |angle: f64| side.turn(self.landmarks.arm.across, -angle);
        let upper = side.turn(X, -arm.shoulder) * side.turn(Z, -drop);
        let (lower, hand) = (bend(arm.elbow), bend(0.08));
        [Rotor::default(), upper, lower, hand]
    }

    /// The spine turns the chest against the pelvis and the neck turns the head back to look ahead.
    fn spine_rotors(&self, pelvis: &Pelvis, rotors: &mut [Rotor<f64>]) {
        let part = |turns: f64, lists: f64, lean: f64| {
            turn(Y, turns * pelvis.turn) * turn(Z, lists * pelvis.list) * turn(X, lean)
        };
        rotors[SPINE] = part(-0.8, -0.6, 0.6 * LEAN);
        rotors[CHEST] = part(-0.9, -0.5, 0.4 * LEAN);
        rotors[NECK] = part(0.4, 0.1, -0.5 * LEAN);
        rotors[HEAD] = part(0.3, 0.0, -0.5 * LEAN);
    }
}

/// A side of the body. What holds on the left holds on the right in the mirror.
#[derive(Clone, Copy, Debug)]
enum Side {
    Left,
    Right,
}

impl Side {
    /// A rotation of the left side, or its mirror image in the plane x = 0 on the right: there the
    /// axis keeps its x and turns the other way round in y and z.
    fn turn(self, [x, y, z]: Vector, angle: f64) -> Rotor<f64> {
        match self {
            Side::Left => turn([x, y, z], angle),
            Side::Right => turn([x, -y, -z], angle),
        }
    }
}

fn turn(axis: Vector, angle: f64) -> Rotor<f64> {
    Rotor::from_axis_angle(axis, angle).unwrap_or_default()
}

fn turned(rotor: Rotor<f64>, vector: Vector) -> Vector {
    rotor.transform(Point::from(vector)).coordinates()
}
