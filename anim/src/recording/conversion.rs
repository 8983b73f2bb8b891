//! From recordings to clips of motions in the mesh's coordinates, and back.

use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;

use super::{RecordedJoint, Recording, check_joints, model_maps, model_motors};
use crate::clip::Clip;
use crate::kinematics::KinematicsError;
use crate::pose::{Pose, moved};
use crate::recording::RecordingError;
use crate::skeleton::{Joint, Skeleton, SkeletonError};
use crate::transform::Transform;

impl Recording {
    /// The skeleton at rest, in model space. A bone ends at the mean place of its children; one
    /// without children has no length. Joints are where scaled ones above put them.
    ///
    /// # Errors
    ///
    /// [`RecordingError::Skeleton`] where two joints have the same name.
    pub fn to_skeleton(&self) -> Result<Skeleton, RecordingError> {
        let locals: Vec<_> = self.joints.iter().map(|joint| joint.rest).collect();
        let mut maps = vec![Affine::default(); locals.len()];
        model_maps(&self.parents, &locals, &mut maps)?;
        let heads: Vec<Vector<f64>> = maps.iter().map(|map| map.translation.into()).collect();
        let mut below = vec![(Vector::default(), 0u32); heads.len()];
        for (parent, &head) in self.parents.iter().zip(&heads) {
            if let Some(parent) = *parent {
                below[parent].0 += head;
                below[parent].1 += 1;
            }
        }
        let joints = self.joints.iter().zip(&heads).zip(below);
        let joints = joints.map(|((joint, &head), (sum, count))| Joint {
            name: joint.name.clone(),
            parent: joint.parent,
            head: head.coordinates(),
            tail: match count {
                0 => head.coordinates(),
                _ => (sum * f64::from(count).recip()).coordinates(),
            },
        });
        Ok(Skeleton::new(joints.collect())?)
    }

    /// The same motion as motions of the mesh's coordinates: the total motion of a joint is
    /// G = F ~F₀, and its own motion ~G_parent G. The poses are for [`Recording::to_skeleton`].
    ///
    /// # Errors
    ///
    /// [`RecordingError::Kinematics`] where a joint is scaled.
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_anim::recording::Recording;
    ///
    /// let motion = ga_anim::bvh::decode(
    ///     b"HIERARCHY ROOT arm { OFFSET 0 0 0 CHANNELS 1 Zrotation
    ///         JOINT hand { OFFSET 1 0 0 CHANNELS 1 Xrotation } }
    ///       MOTION Frames: 1 Frame Time: 0.01
    ///       90 0",
    /// )?;
    /// let recording = Recording::from_bvh(&motion, 1.0)?;
    /// let (skeleton, clip) = (recording.to_skeleton()?, recording.to_clip()?);
    /// let [hand, _] = clip.frames()[0].bones(&skeleton)?[1];
    /// assert!((hand[1] - 1.0).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn to_clip(&self) -> Result<Clip, RecordingError> {
        let rest = self.rest_motors()?;
        let mut frames = Vec::with_capacity(self.frame_count());
        let mut motors = vec![Motor::default(); self.joints.len()];
        for locals in self.locals.chunks_exact(self.joints.len()) {
            model_motors(&self.parents, locals, &mut motors)?;
            let mut pose = Pose::rest(motors.len());
            for (motor, rest) in motors.iter_mut().zip(&rest) {
                *motor *= rest.reverse();
            }
            for (own, (parent, &total)) in
                pose.joints.iter_mut().zip(self.parents.iter().zip(&motors))
            {
                *own = parent.map_or(total, |parent| motors[parent].reverse() * total);
            }
            frames.push(pose);
        }
        Ok(Clip::new(self.frame_time, frames)?)
    }

    /// The recording of a clip. A joint's frame stands at the joint with the axes of the mesh, so
    /// with h the joint's place at rest, p its parent's, and L its own motion, its transform is
    /// T(−p) L T(h). For a root, the motion of the whole skeleton takes the place of T(−p).
    ///
    /// # Errors
    ///
    /// [`RecordingError::Skeleton`] where the clip is for a skeleton with another number of joints.
    pub fn from_clip(skeleton: &Skeleton, clip: &Clip) -> Result<Self, RecordingError> {
        let of_skeleton: Vec<Option<usize>> = (0..skeleton.len()).map(Some).collect();
        let joints = RecordedJoint::of_skeleton(skeleton, 1.0);
        Self::of_joints(joints, &of_skeleton, (skeleton, 1.0), clip)
    }

    /// The recording of a clip on joints that have axes, and perhaps factors, of their own.
    ///
    /// `of_skeleton` says for each joint which one of the skeleton it is; the skeleton's unit is
    /// given in metres. With A the frame of the parent at rest, which has the rotation R and is
    /// scaled evenly, L the joint's own motion and h its place at rest, its transform T(t) r s at
    /// rest becomes
    ///
    /// ```text
    /// T(t + A⁻¹ (L h − h)) (~R L R) r s.
    /// ```
    ///
    /// For a root of the skeleton, L is after the motion of the whole. Joints that are none of the
    /// skeleton stay at rest relative to their parents. The [`ends`](Self::ends) of bones are those
    /// of the skeleton.
    ///
    /// # Errors
    ///
    /// [`RecordingError::Skeleton`] where the clip is for a skeleton with another number of joints,
    /// [`RecordingError::ScaledUnevenly`] where A is not scaled evenly, and those of
    /// [`Recording::new`].
    ///
    /// # Examples
    ///
    /// ```
    /// use ga_anim::recording::{RecordedJoint, Recording};
    /// use ga_anim::skeleton::{Joint, Skeleton};
    /// use ga_anim::transform::Transform;
    /// use ga_anim::{clip::Clip, pose::Pose};
    /// use ga_runtime::cga3::{Motor, Rotor};
    ///
    /// let axis = |axis| Rotor::from_axis_angle(axis, 0.5).ok_or("no axis");
    /// let hip = Joint { name: "hip".into(), parent: None, head: [0.0; 3], tail: [1.0; 3] };
    /// let leg = Skeleton::new(vec![hip])?;
    /// let pose = Pose::from_rotors(&leg, Motor::default(), &[axis([0.0, 0.0, 1.0])?])?;
    /// let clip = Clip::new(0.01, vec![pose])?;
    /// let rest = Transform::from(Motor::from(axis([0.0, 0.0, 1.0])?));
    /// let joint = RecordedJoint { name: "hip".into(), parent: None, rest };
    /// let recording = Recording::of_joints(vec![joint], &[Some(0)], (&leg, 0.01), &clip)?;
    /// let (_, angle) = recording.locals()[0].rotor().to_axis_angle();
    /// assert!((angle - 1.0).abs() < 1e-12);
    /// assert_eq!(recording.ends(), [Some([0.01; 3])]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of_joints(
        joints: Vec<RecordedJoint>,
        of_skeleton: &[Option<usize>],
        (skeleton, metres_per_unit): (&Skeleton, f64),
        clip: &Clip,
    ) -> Result<Self, RecordingError> {
        let count = skeleton.len();
        let is_known = |joint: &Option<usize>| joint.is_none_or(|joint| joint < count);
        if joints.len() != of_skeleton.len() || !of_skeleton.iter().all(is_known) {
            let (expected, found) = (joints.len(), of_skeleton.len());
            return Err(SkeletonError::PoseLength { expected, found }.into());
        }
        check_joints(&joints)?;
        let (mut frames, mut above) = (Vec::<Frame>::new(), Vec::with_capacity(joints.len()));
        for (described, own) in joints.iter().zip(of_skeleton) {
            let parent = described.parent;
            let frame = parent.map_or(Frame::default(), |parent| frames[parent]);
            let back = own.map(|own| {
                let name = parent.map_or(&described.name, |parent| &joints[parent].name);
                let uneven = || RecordingError::ScaledUnevenly { name: name.clone() };
                Ok::<_, RecordingError>((own, frame.rotor, frame.back().ok_or_else(uneven)?))
            });
            above.push(back.transpose()?);
            frames.push(frame.then(&described.rest));
        }
        let mut locals = Vec::with_capacity(clip.frames().len() * joints.len());
        for pose in clip.frames() {
            let (expected, found) = (count, pose.joints.len());
            if expected != found {
                return Err(SkeletonError::PoseLength { expected, found }.into());
            }
            for (described, above) in joints.iter().zip(&above) {
                let Some((joint, rotor, back)) = above else {
                    locals.push(described.rest);
                    continue;
                };
                let Joint { head, parent, .. } = skeleton.joints()[*joint];
                let own = match parent {
                    Some(_) => pose.joints[*joint],
                    None => pose.root * pose.joints[*joint],
                };
                let way = way_of(own, head);
                let way = back.transform_direction((way * metres_per_unit).into());
                let rest = &described.rest;
                locals.push(Transform::from_parts(
                    rest.translation() + Vector::from(way),
                    rotor.reverse() * own.rotor() * *rotor * rest.rotor(),
                    rest.scale,
                ));
            }
        }
        let end = |(joint, own): (usize, &Option<usize>)| {
            let own = (*own)?;
            let Joint { head, tail, .. } = &skeleton.joints()[own];
            let is_leaf = joints.iter().all(|other| other.parent != Some(joint));
            let way = (Vector::from(*tail) - Vector::from(*head)) * metres_per_unit;
            (is_leaf && head != tail).then(|| way.coordinates())
        };
        let ends = of_skeleton.iter().enumerate().map(end).collect();
        let recording = Self::new(joints, clip.frame_time(), locals, Vec::new())?;
        Ok(Self { ends, ..recording })
    }

    fn rest_motors(&self) -> Result<Vec<Motor<f64>>, KinematicsError> {
        let locals: Vec<_> = self.joints.iter().map(|joint| joint.rest).collect();
        let mut motors = vec![Motor::default(); locals.len()];
        model_motors(&self.parents, &locals, &mut motors)?;
        Ok(motors)
    }
}

impl RecordedJoint {
    /// The joints of a skeleton whose unit is given in metres, with the axes of the mesh at rest.
    pub(crate) fn of_skeleton(skeleton: &Skeleton, metres_per_unit: f64) -> Vec<Self> {
        let joints = skeleton.joints();
        let joint = |joint: &Joint| {
            let above = joint.parent.map_or([0.0; 3], |parent| joints[parent].head);
            let way = Vector::from(joint.head) - Vector::from(above);
            let way = (way * metres_per_unit).coordinates();
            Self {
                name: joint.name.clone(),
                parent: joint.parent,
                rest: Motor::from(Translator::from_displacement(way)).into(),
            }
        };
        joints.iter().map(joint).collect()
    }
}

/// By how much a motion takes a place from where it is; rounding alone is no way.
fn way_of(motion: Motor<f64>, place: [f64; 3]) -> Vector<f64> {
    const ROUNDING: f64 = 1e-13;
    let displacement = motion.translator().displacement();
    let size = Vector::from(place).length() + Vector::from(displacement).length();
    let way = Vector::from(moved(motion, place)) - Vector::from(place);
    match way.length() <= ROUNDING * size {
        true => Vector::ZERO,
        false => way,
    }
}

/// The frame of a joint in model space at rest, and its rotation.
#[derive(Clone, Copy, Default)]
struct Frame {
    map: Affine<f64>,
    rotor: Rotor<f64>,
}

impl Frame {
    /// The frame of a joint below with this transform.
    fn then(&self, local: &Transform<f64>) -> Self {
        Self {
            map: self.map * local.to_affine(),
            rotor: self.rotor * local.rotor(),
        }
    }

    /// The way back into the frame, where it is scaled evenly.
    fn back(&self) -> Option<Affine<f64>> {
        // Files write factors in single precision, some with few digits.
        const TOLERANCE: f64 = 1e-4;
        let factor = self.map.determinant().cbrt();
        let even = self.rotor.to_matrix();
        let pairs = even
            .as_flattened()
            .iter()
            .zip(self.map.linear.as_flattened());
        let is_even =
            |(even, found): (&f64, &f64)| (even * factor - found).abs() <= TOLERANCE * factor.abs();
        pairs
            .into_iter()
            .all(is_even)
            .then(|| self.map.inverse())
            .flatten()
    }
}
