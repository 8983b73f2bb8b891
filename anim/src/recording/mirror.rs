//! The mirror image of a recording: left and right change places.

use std::collections::HashMap;

use ga_runtime::cga3::{DualPlane, Motor, Rotor, Translator};
use ga_runtime::vga3::Vector;

use super::mirror_axes::mirror_axes;
use super::{RecordedJoint, Recording, ScalarTrack};
use crate::clip::{other_side, reflected};
use crate::recording::RecordingError;
use crate::transform::Transform;

impl Recording {
    /// The mirror image in the plane through the origin with this normal.
    ///
    /// Each joint moves as its counterpart on the other side does, seen in the mirror; joints whose
    /// names say neither left nor right are their own counterparts. Names tell the sides as in
    /// [`Mirror::by_names`](crate::clip::Mirror::by_names). The joints at rest stay as they are.
    /// With t and R the counterpart's translation from its place at rest and its rotation, the
    /// plane π, and a rotor Q for each joint, Q_p for its parent,
    ///
    /// ```text
    /// T' R' = ~Q_p π (T R) π Q.
    /// ```
    ///
    /// π Q takes a vector in the axes of the joint to its mirror image in those of the counterpart.
    /// It is found from the bones: it takes those that begin at the joint to those that begin at
    /// the counterpart, so that every joint comes to lie at the reflected place, whatever the axes
    /// of the joints and their pose at rest. What the bones leave open is π in model space at rest,
    /// with axes A there, and B of the counterpart: `Q = π ~B π A`. Where the body at rest is not
    /// nearly its own mirror image, the body in the mean over all frames takes the place of rest.
    ///
    /// To this the joint's own place at rest is added, so that bones keep their lengths where the
    /// skeleton is not its own mirror image. Joints without a parent are reflected as a whole. Even
    /// scaling is kept. Scalar tracks change places by their names in the same way, where both of a
    /// pair are there.
    ///
    /// The mirror image of a mirror image is the recording itself, up to rounding.
    ///
    /// # Errors
    ///
    /// [`RecordingError::MirrorPlane`] for a normal of zero, [`RecordingError::NoCounterpart`]
    /// where only one side is there, [`RecordingError::PairedTwice`] where the names do not form
    /// pairs, [`RecordingError::PairParents`] and [`RecordingError::MirrorScaled`], and
    /// [`RecordingError::Transform`] where the mirror image overflows.
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_anim::recording::Recording;
    /// use ga_runtime::vga3::Vector;
    ///
    /// let motion = ga_anim::bvh::decode(
    ///     b"HIERARCHY ROOT hip { OFFSET 0 0 0 CHANNELS 3 Xposition Yposition Zposition
    ///         JOINT LeftLeg { OFFSET 1 0 0 CHANNELS 1 Xrotation }
    ///         JOINT RightLeg { OFFSET -1 0 0 CHANNELS 1 Xrotation } }
    ///       MOTION Frames: 1 Frame Time: 0.01
    ///       5 1 0 30 0",
    /// )?;
    /// let recording = Recording::from_bvh(&motion, 1.0)?.mirrored(Vector::new(1.0, 0.0, 0.0))?;
    /// let [hip, left, right] = recording.locals() else { return Err("three joints".into()) };
    /// assert_eq!(hip.translation(), Vector::new(-5.0, 1.0, 0.0));
    /// assert_eq!(left.rotor().to_axis_angle().1, 0.0);
    /// let (axis, angle) = right.rotor().to_axis_angle();
    /// assert!((axis[0] - 1.0).abs() < 1e-15 && (angle.to_degrees() - 30.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn mirrored(&self, normal: Vector<f64>) -> Result<Self, RecordingError> {
        let normal = normal.normalized().ok_or(RecordingError::MirrorPlane)?;
        let plane = DualPlane::new(normal.e1, normal.e2, normal.e3, 0.0);
        let images = images(self, plane)?;
        let count = self.joints.len();
        let mut locals = Vec::with_capacity(self.locals.len());
        for (frame, before) in self.locals.chunks_exact(count).enumerate() {
            for image in &images {
                let local = image.of(plane, &before[image.other]);
                locals.push(local.ok_or_else(|| RecordingError::MirrorScaled {
                    name: self.joints[image.other].name.clone(),
                    frame: Some(frame),
                })?);
            }
        }
        Self::new(
            self.joints.clone(),
            self.frame_time,
            locals,
            mirrored_tracks(&self.tracks),
        )
    }
}

/// How a joint follows its counterpart.
struct Image {
    /// The counterpart.
    other: usize,
    /// Q_p of the parent, reversed, and Q of the joint.
    axes: [Rotor<f64>; 2],
    /// The places at rest of the counterpart and of the joint, relative to their parents.
    places: [Vector<f64>; 2],
    /// The length of the parent's unit beside that of the counterpart's parent.
    factor: f64,
    /// The factors of the joint at rest beside those of the counterpart.
    scale: Vector<f64>,
    /// The factors of the counterpart at rest.
    rest_scale: Vector<f64>,
}

impl Image {
    /// The image of the counterpart's transform; `None` where it is scaled non-uniformly.
    fn of(&self, plane: DualPlane<f64>, other: &Transform<f64>) -> Option<Transform<f64>> {
        even_factor(quotient(other.scale, self.rest_scale))?;
        let moved = (other.translation() - self.places[0]) * self.factor;
        let there = translation(moved) * other.rotor();
        let [back, axes] = self.axes;
        let image = back * reflected(plane, there) * axes;
        let place = image.translator().displacement();
        Some(Transform::from_parts(
            Vector::from(place) + self.places[1],
            image.rotor(),
            other.scale.component_product(self.scale),
        ))
    }
}

fn images(recording: &Recording, plane: DualPlane<f64>) -> Result<Vec<Image>, RecordingError> {
    let joints = &recording.joints;
    let counterparts = counterparts(joints)?;
    // The length of the unit of each joint's axes.
    let mut units: Vec<f64> = Vec::with_capacity(joints.len());
    for joint in joints {
        let factor = even_factor(joint.rest.scale).ok_or_else(|| RecordingError::MirrorScaled {
            name: joint.name.clone(),
            frame: None,
        })?;
        units.push(joint.parent.map_or(1.0, |parent| units[parent]) * factor);
    }
    let axes = mirror_axes(recording, &counterparts, plane);
    let image = |(joint, &other): (usize, &usize)| {
        let (own, counterpart) = (&joints[joint], &joints[other]);
        let unit = |parent: Option<usize>| parent.map_or(1.0, |parent| units[parent]);
        let place = |joint: &RecordedJoint| match joint.parent {
            Some(_) => joint.rest.translation(),
            None => Vector::default(),
        };
        let above = own.parent.map_or(Rotor::default(), |parent| axes[parent]);
        Image {
            other,
            axes: [above.reverse(), axes[joint]],
            places: [place(counterpart), place(own)],
            factor: unit(counterpart.parent) / unit(own.parent),
            scale: quotient(own.rest.scale, counterpart.rest.scale),
            rest_scale: counterpart.rest.scale,
        }
    };
    Ok(counterparts.iter().enumerate().map(image).collect())
}

/// The counterpart of each joint by its name.
fn counterparts(joints: &[RecordedJoint]) -> Result<Vec<usize>, RecordingError> {
    let names = joints.iter().enumerate();
    let places: HashMap<&str, usize> = names.map(|(k, joint)| (joint.name.as_str(), k)).collect();
    let mut counterparts: Vec<usize> = (0..joints.len()).collect();
    for (counterpart, joint) in counterparts.iter_mut().zip(joints) {
        let Some(expected) = other_side(&joint.name) else {
            continue;
        };
        match places.get(expected.name.as_str()) {
            Some(&other) => *counterpart = other,
            None if expected.is_certain => {
                return Err(RecordingError::NoCounterpart {
                    name: joint.name.clone(),
                    expected: expected.name,
                });
            }
            None => {}
        }
    }
    for (joint, &other) in counterparts.iter().enumerate() {
        let name = joints[joint].name.clone();
        if counterparts[other] != joint {
            return Err(RecordingError::PairedTwice { name });
        }
        if joints[joint].parent.map(|parent| counterparts[parent]) != joints[other].parent {
            let other = joints[other].name.clone();
            return Err(RecordingError::PairParents { name, other });
        }
    }
    Ok(counterparts)
}

/// The tracks with the numbers of their counterparts, where there is one by its name.
fn mirrored_tracks(tracks: &[ScalarTrack]) -> Vec<ScalarTrack> {
    let place = |name: &str| tracks.iter().position(|track| track.name == name);
    let counterpart = |name: &str| other_side(name).and_then(|other| place(&other.name));
    let numbers = |track: &ScalarTrack| {
        // Only pairs change places, so that doing it twice changes nothing.
        let other = counterpart(&track.name).map(|other| &tracks[other]);
        let other = other
            .filter(|other| other_side(&other.name).is_some_and(|back| back.name == track.name));
        other.unwrap_or(track).values.clone()
    };
    tracks
        .iter()
        .map(|track| ScalarTrack {
            name: track.name.clone(),
            values: numbers(track),
        })
        .collect()
}

/// The factor of a scaling that is positive and the same along all axes, up to the rounding of
/// files in single precision.
fn even_factor(scale: Vector<f64>) -> Option<f64> {
    const TOLERANCE: f64 = 1e-4;
    let [x, y, z] = scale.coordinates();
    let is_even = |other: f64| (other - x).abs() <= TOLERANCE * x;
    (x > 0.0 && is_even(y) && is_even(z)).then_some(x)
}

fn quotient(a: Vector<f64>, b: Vector<f64>) -> Vector<f64> {
    let (a, b) = (a.coordinates(), b.coordinates());
    [0, 1, 2].map(|axis| a[axis] / b[axis]).into()
}

fn translation(displacement: Vector<f64>) -> Motor<f64> {
    Motor::from(Translator::from_displacement(displacement.coordinates()))
}
