//! Total motions of joints from their own.

use ga_runtime::batch::{Batch, Work};
use ga_runtime::cga3::Motor;
use ga_runtime::scalar::Real;

use crate::kinematics::KinematicsError;
use crate::skeleton::Skeleton;

/// The parent of each joint, parents before their children: what forward kinematics needs of a
/// skeleton, checked once.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hierarchy {
    parents: Vec<Option<usize>>,
}

impl Hierarchy {
    /// The hierarchy with these parents, `None` for a root.
    ///
    /// # Errors
    ///
    /// [`KinematicsError::ParentNotBefore`].
    pub fn new(parents: &[Option<usize>]) -> Result<Self, KinematicsError> {
        for (joint, parent) in parents.iter().enumerate() {
            if let Some(parent) = parent.filter(|&parent| parent >= joint) {
                return Err(KinematicsError::ParentNotBefore { joint, parent });
            }
        }
        Ok(Self {
            parents: parents.to_vec(),
        })
    }

    /// The parent of each joint.
    #[must_use]
    pub fn parents(&self) -> &[Option<usize>] {
        &self.parents
    }

    /// The total motion G of each joint of every pose, `G = G_parent L`, from its own motion L; for
    /// a root joint `G = root L`. See [`crate::pose`].
    ///
    /// `own` holds one or more poses one after the other, and `total` receives as many. Products of
    /// unit motors stay unit motors to rounding, about an ε for each level of the hierarchy;
    /// infinite and NaN coefficients propagate to the joints below, and to no others.
    ///
    /// # Errors
    ///
    /// [`KinematicsError`]; nothing is written then.
    pub fn forward<S: Real>(
        &self,
        root: Motor<S>,
        own: &[Motor<S>],
        total: &mut [Motor<S>],
    ) -> Result<(), KinematicsError> {
        whole_poses(self.parents.len(), own.len())?;
        same_length(own.len(), total.len())?;
        let work = Forward {
            parents: self.parents.iter().copied(),
            root,
            own,
            total,
        };
        // A single motor of f64 is multiplied coefficient by coefficient: wider instructions only
        // shuffle them.
        if size_of::<S>() == size_of::<f64>() {
            work.run();
        } else {
            Batch::new().run(work);
        }
        Ok(())
    }
}

impl From<&Skeleton> for Hierarchy {
    fn from(skeleton: &Skeleton) -> Self {
        let parents = skeleton.joints().iter().map(|joint| joint.parent);
        Self {
            parents: parents.collect(),
        }
    }
}

/// The total motions of the joints of one pose of a skeleton, without a [`Hierarchy`]. The slices
/// must be as long as the skeleton.
pub(crate) fn forward_pose(
    skeleton: &Skeleton,
    root: Motor<f64>,
    own: &[Motor<f64>],
    total: &mut [Motor<f64>],
) {
    Forward {
        parents: skeleton.joints().iter().map(|joint| joint.parent),
        root,
        own,
        total,
    }
    .run();
}

struct Forward<'a, P, S> {
    parents: P,
    root: Motor<S>,
    own: &'a [Motor<S>],
    total: &'a mut [Motor<S>],
}

impl<S: Real, P: ExactSizeIterator<Item = Option<usize>> + Clone> Work for Forward<'_, P, S> {
    #[inline(always)]
    fn run(self) {
        let joints = self.parents.len().max(1);
        let poses = self.own.chunks_exact(joints);
        for (own, total) in poses.zip(self.total.chunks_exact_mut(joints)) {
            for (joint, (parent, own)) in self.parents.clone().zip(own).enumerate() {
                // Parents come first, so they have been computed.
                let above = match parent {
                    Some(parent) => total[parent],
                    None => self.root,
                };
                total[joint] = above.compose(*own);
            }
        }
    }
}

pub(super) fn whole_poses(joints: usize, found: usize) -> Result<(), KinematicsError> {
    // Without joints there are no motors: only 0 is a multiple of 0.
    if found.is_multiple_of(joints) {
        Ok(())
    } else {
        Err(KinematicsError::PoseMotors { joints, found })
    }
}

pub(super) fn same_length(expected: usize, found: usize) -> Result<(), KinematicsError> {
    if expected == found {
        Ok(())
    } else {
        Err(KinematicsError::ResultLength { expected, found })
    }
}
