//! From recordings to clips of motions in the mesh's coordinates, and back.

use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;

use super::{RecordedJoint, Recording, check_joints, model_maps, model_motors};
use crate::clip::Clip;
use crate::gltf::uniform;
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
        let recording = Self::of_joints(joints, &of_skeleton, (skeleton, 1.0), clip)?;
        Ok(recording.with_ends_of(skeleton, 1.0))
    }

    /// The recording of a clip on joints that have axes, and perhaps factors, of their own.
    ///
    /// `of_skeleton` says for each joint which one of the skeleton it is; the skeleton's unit is
    /// given in metres, and the joints stand at rest where those of the skeleton do. With A the
    /// frame of the parent at rest, which has the rotation R and is scaled uniformly, L the joint's
    /// own motion and h its place at rest, its transform T(t) r s at rest becomes
    ///
    /// ```text
    /// T(t + A⁻¹ (L h − h)) (~R L R) r s.
    /// ```
    ///
    /// For a root of the skeleton, L is after the motion of the whole. Joints that are none of the
    /// skeleton stay at rest relative to their parents.
    ///
    /// # Errors
    ///
    /// [`RecordingError::Unit`]; [`RecordingError::Skeleton`] where the clip is for a skeleton with
    /// another number of joints; [`RecordingError::NonUniformScale`] where A is not scaled
    /// uniformly; and those of [`Recording::new`].
    pub(crate) fn of_joints(
        joints: Vec<RecordedJoint>,
        of_skeleton: &[Option<usize>],
        (skeleton, metres_per_unit): (&Skeleton, f64),
        clip: &Clip,
    ) -> Result<Self, RecordingError> {
        if !metres_per_unit.is_finite() || metres_per_unit <= 0.0 {
            return Err(RecordingError::Unit(metres_per_unit));
        }
        check_joints(&joints)?;
        let (mut frames, mut above) = (Vec::<Affine<f64>>::new(), Vec::new());
        for (described, own) in joints.iter().zip(of_skeleton) {
            let parent = described.parent;
            let frame = parent.map_or(Affine::default(), |parent| frames[parent]);
            let back = own.map(|own| {
                let name = parent.map_or(&described.name, |parent| &joints[parent].name);
                let (rotor, back) = way_into(frame)
                    .ok_or_else(|| RecordingError::NonUniformScale { name: name.clone() })?;
                Ok::<_, RecordingError>((own, rotor, back))
            });
            above.push(back.transpose()?);
            frames.push(frame * described.rest.to_affine());
        }
        let mut locals = Vec::with_capacity(clip.frames().len() * joints.len());
        for pose in clip.frames() {
            let (expected, found) = (skeleton.len(), pose.joints.len());
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
        Self::new(joints, clip.frame_time(), locals, Vec::new())
    }

    /// The recording with the [`ends`](Self::ends) of the bones of a skeleton that has the same
    /// joints, and whose unit is given in metres.
    pub(crate) fn with_ends_of(self, skeleton: &Skeleton, metres_per_unit: f64) -> Self {
        let end = |(index, joint): (usize, &Joint)| {
            let way = (Vector::from(joint.tail) - Vector::from(joint.head)) * metres_per_unit;
            let is_end = skeleton.children(index).next().is_none() && joint.head != joint.tail;
            is_end.then(|| way.coordinates())
        };
        let ends = skeleton.joints().iter().enumerate().map(end).collect();
        Self { ends, ..self }
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

/// The rotation of a frame that is scaled uniformly, perhaps by a negative factor, and the way into
/// it.
fn way_into(frame: Affine<f64>) -> Option<(Rotor<f64>, Affine<f64>)> {
    let sign = frame.determinant().signum();
    let positive = frame.linear.map(|row| row.map(|x| sign * x));
    let rotor = uniform(Affine::new(positive, frame.translation))?.rotor();
    Some((rotor, frame.inverse()?))
}
