//! A recording as a skeleton and its poses.

use ga_runtime::cga3::{Motor, Translator};

use super::Bvh;
use crate::pose::Pose;
use crate::skeleton::{Joint, Skeleton, SkeletonError};

impl Bvh {
    /// The skeleton of the recording at rest, in the file's unit, with the joints in the order of
    /// the file. A bone ends at the first joint below that is not at its beginning, otherwise at
    /// the joint's End Site, otherwise where it begins.
    ///
    /// # Errors
    ///
    /// [`SkeletonError::NotFinite`] where a sum of offsets overflows.
    pub fn skeleton(&self) -> Result<Skeleton, SkeletonError> {
        let heads = self.rest_positions();
        let mut tails: Vec<Option<[f64; 3]>> = vec![None; heads.len()];
        for (joint, &head) in self.joints().iter().zip(&heads) {
            if let Some(parent) = joint.parent.filter(|&parent| heads[parent] != head) {
                tails[parent].get_or_insert(head);
            }
        }
        let joints = self.joints().iter().zip(heads).zip(tails);
        let joints = joints.map(|((joint, head), tail)| Joint {
            name: joint.name.clone(),
            parent: joint.parent,
            head,
            tail: tail
                .or_else(|| {
                    let end = joint.end_site?;
                    Some(std::array::from_fn(|axis| head[axis] + end[axis]))
                })
                .unwrap_or(head),
        });
        Skeleton::new(joints.collect())
    }

    /// The pose of [`Bvh::skeleton`] in one frame of time, or `None` when there is no such frame.
    /// Position channels are in the motions of their joints, and the motion of the whole skeleton
    /// is the identity.
    ///
    /// ```
    /// # let text = b"HIERARCHY ROOT hip { OFFSET 0 0 0 CHANNELS 2 Yposition Xrotation
    /// #     JOINT knee { OFFSET 0 -4 0 CHANNELS 1 Xrotation End Site { OFFSET 0 -3 0 } } }
    /// #     MOTION Frames: 1 Frame Time: 0.01\n1 90 0\n";
    /// let motion = ga_anim::bvh::decode(text)?;
    /// let (leg, pose) = (motion.skeleton()?, motion.pose(0).ok_or("no frame")?);
    /// let [knee, ankle] = pose.bones(&leg)?[1];
    /// // The hip is at (0, 1, 0), and the leg is raised to the back.
    /// assert!((knee[1] - 1.0).abs() < 1e-15 && (knee[2] + 4.0).abs() < 1e-15);
    /// assert!((ankle[2] + 7.0).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn pose(&self, frame: usize) -> Option<Pose> {
        let heads = self.rest_positions();
        let own = self.own_motions(frame)?;
        let joints = self.joints().iter().zip(&heads).zip(own);
        let joints = joints.map(|((joint, head), own)| {
            let above = joint.parent.map_or([0.0; 3], |parent| heads[parent]);
            let to_rest = Translator::from_displacement(head.map(|x| -x));
            Translator::from_displacement(above) * own * to_rest
        });
        Some(Pose {
            root: Motor::default(),
            joints: joints.collect(),
        })
    }
}
