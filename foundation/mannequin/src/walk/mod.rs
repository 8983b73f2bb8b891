//! A walk: the gait put on the ground.
//!
//! The joint angles alone would let the feet slide. So the position of the pelvis is computed from
//! the standing leg: with its foot fixed on the ground, forward kinematics through ankle, knee and
//! hip gives the hips. Then, with hips that also sway and rotate, inverse kinematics gives the
//! final angles of every leg that touches the ground, so that heel, ball and toe stay where they
//! were set down.

mod gait;
mod leg;

use ga_runtime::cga3::{Direction, Motor, Rotor, Translator};

use crate::landmarks::{ARM_DROP, HEEL, Landmarks, TOE_TIP};
use crate::skeleton::{ARM, CHEST, COUNT, HEAD, HIPS, LEG, NECK, SPINE, skeleton};
use crate::{Vector, mirror};
use ga_anim::clip::Clip;
use ga_anim::pose::Pose;
use gait::{HEEL_OFF, HEEL_STRIKE, LegMoment, TOE_OFF};
use leg::{Leg, LegAngles};

pub use gait::{KEY_NAMES, KEYS_PER_STRIDE};

/// Seconds from one key pose to the next: 110 steps a minute.
pub const KEY_TIME: f64 = 60.0 / 110.0 / 4.0;

/// A walk of `strides` strides of two steps each, straight along +z: [`KEYS_PER_STRIDE`] key poses
/// a stride, [`KEY_TIME`] apart, and one more that ends the last stride.
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
    let stride = stride(&landmarks, skeleton.joints()[HIPS].head.into());
    let frames = (0..=usize::from(strides) * KEYS_PER_STRIDE).map(|frame| {
        let key = &stride.keys[frame % KEYS_PER_STRIDE];
        let before = (frame / KEYS_PER_STRIDE) as f64 * stride.length;
        let place = Translator::from_displacement((key.root + Vector::Z * before).coordinates());
        Pose::from_rotors(&skeleton, Motor::from(place), &key.rotors)
            .expect("a rotor for each joint")
    });
    Clip::new(KEY_TIME, frames.collect()).expect("one frame or more, all of one skeleton")
}

/// The pose of one moment: the displacement of the whole body and the rotation of each joint from
/// rest.
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
    let step = pelvis[KEYS_PER_STRIDE / 2].place.e3 - pelvis[0].place.e3;
    let keys = (0..KEYS_PER_STRIDE).map(|key| {
        let half = key / (KEYS_PER_STRIDE / 2);
        let mut now = pelvis[key % (KEYS_PER_STRIDE / 2)];
        if half == 1 {
            now = now.mirrored();
        }
        now.place.e3 += half as f64 * step;
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

/// The pelvis: its displacement from rest and its rotation about the vertical and about the way
/// ahead.
#[derive(Clone, Copy, Debug)]
struct Pelvis {
    place: Vector,
    turn: f64,
    list: f64,
}

impl Pelvis {
    fn mirrored(self) -> Self {
        Pelvis {
            place: mirror(self.place),
            turn: -self.turn,
            list: -self.list,
        }
    }

    /// Its rotation; on the right side, that of its mirror image.
    fn rotor(&self, side: Side) -> Rotor<f64> {
        side.turn(Vector::Y, self.turn) * side.turn(Vector::Z, self.list)
    }
}

impl Walker<'_> {
    /// The pelvis from the left leg, which stands with its footprint at z = 0: forward kinematics
    /// from the ground up.
    fn pelvis(&self, key: usize, heel_off: f64) -> Pelvis {
        let moment = gait::LEG[key];
        let trunk = gait::trunk(key);
        let mut pelvis = Pelvis {
            place: Vector::X * trunk.sway,
            turn: trunk.turn,
            list: trunk.list,
        };
        let angles = self
            .leg
            .clinical(moment.hip.to_radians(), moment.knee.to_radians());
        let hip = self.hip(&pelvis);
        let below = self.leg.ankle(angles);
        let (ankle, _) = self.planted(key, heel_off, 0.0);
        let reached = ankle - below - hip;
        pelvis.place = Vector::new(trunk.sway, reached.e2, reached.e3);
        pelvis
    }

    /// The slope of the rear sole as the other heel touches the ground: that with which both legs
    /// reach the ground from one pelvis.
    fn heel_off(&self) -> f64 {
        let front = self.pelvis(HEEL_STRIKE, 0.0).place.e2;
        let (mut low, mut high) = (-0.9, 0.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if self.pelvis(HEEL_OFF, middle).place.e2 > front {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high)
    }

    /// The left hip joint of a pelvis.
    fn hip(&self, pelvis: &Pelvis) -> Vector {
        let arm = rotated(pelvis.rotor(Side::Left), self.landmarks.hip - self.hips);
        self.hips + pelvis.place + arm
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
        let at = |along: f64, up: f64| foot.point(along, 0.0, up) - foot.origin;
        let ankle = self.landmarks.ankle - foot.origin;
        let swung =
            |pivot: Vector, slope: f64, p: Vector| pivot + rotated(self.slope(slope), p - pivot);
        let ball = self.landmarks.ball - foot.origin;
        let over = match moment {
            HEEL_STRIKE => swung(at(HEEL + 0.018, 0.004), sole, ankle),
            TOE_OFF => {
                let tip = at(TOE_TIP - 0.008, 0.004);
                let lifted = swung(tip, PUSH_OFF, ball);
                lifted + rotated(self.slope(sole), ankle - ball)
            }
            _ => swung(ball, sole, ankle),
        };
        (Vector::new(TRACK, 0.0, z) + over, sole)
    }

    /// The rotation of the left foot by which its sole rises towards the toes.
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
            let target = rotated(frame.reverse(), ankle - hip);
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
        let thigh = side.turn(Vector::Z, angles.spread) * side.turn(Vector::X, angles.flexion);
        let shank = side.turn(Vector::X, angles.knee);
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
            let ankle = hip + rotated(frame, self.leg.ankle(angles));
            angles.spread += (TRACK - ankle.e1) / (hip.e2 - ankle.e2);
        }
        angles
    }

    /// The rotors of an arm's four joints at a moment of the stride of its side.
    fn arm_rotors(&self, side: Side, key: usize) -> [Rotor<f64>; 4] {
        let arm = gait::left_arm(key);
        let drop = std::f64::consts::FRAC_PI_2 - ARM_DROP - ARM_SPREAD;
        let bend = |angle: f64| side.turn(self.landmarks.arm.across, -angle);
        let upper = side.turn(Vector::X, -arm.shoulder) * side.turn(Vector::Z, -drop);
        let (lower, hand) = (bend(arm.elbow), bend(0.08));
        [Rotor::default(), upper, lower, hand]
    }

    /// The spine rotates the chest against the pelvis, and the neck rotates the head to look ahead.
    fn spine_rotors(&self, pelvis: &Pelvis, rotors: &mut [Rotor<f64>]) {
        let part = |turns: f64, lists: f64, lean: f64| {
            turn(Vector::Y, turns * pelvis.turn)
                * turn(Vector::Z, lists * pelvis.list)
                * turn(Vector::X, lean)
        };
        rotors[SPINE] = part(-0.8, -0.6, 0.6 * LEAN);
        rotors[CHEST] = part(-0.9, -0.5, 0.4 * LEAN);
        rotors[NECK] = part(0.4, 0.1, -0.5 * LEAN);
        rotors[HEAD] = part(0.3, 0.0, -0.5 * LEAN);
    }
}

/// A side of the body. The right side is the mirror image of the left.
#[derive(Clone, Copy, Debug)]
enum Side {
    Left,
    Right,
}

impl Side {
    /// A rotation of the left side, or its mirror image in the plane x = 0 on the right: there the
    /// axis keeps its x component and the other two change sign.
    fn turn(self, axis: Vector, angle: f64) -> Rotor<f64> {
        match self {
            Side::Left => turn(axis, angle),
            Side::Right => turn(-mirror(axis), angle),
        }
    }
}

fn turn(axis: Vector, angle: f64) -> Rotor<f64> {
    Rotor::from_axis_angle(axis.coordinates(), angle).unwrap_or_default()
}

fn rotated(rotor: Rotor<f64>, vector: Vector) -> Vector {
    rotor.transform(Direction::from(vector)).into()
}
