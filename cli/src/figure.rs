//! The figure that is animated.

use ga_anim::pose::Pose;
use ga_anim::skeleton::Skeleton;
use ga_anim::skin::{self, Method, SkinError};
use ga_anim::weights::SkinWeights;
use ga_image::plane::Plane;
use ga_mesh::Mesh;

/// A mesh, its skeleton and its skin weights, in metres with y up.
pub(crate) struct Figure {
    pub(crate) name: String,
    pub(crate) mesh: Mesh,
    pub(crate) skeleton: Skeleton,
    pub(crate) weights: SkinWeights,
    /// The picture on its skin, for the texture coordinates of the mesh.
    pub(crate) paint: Option<Plane<[u8; 3]>>,
}

impl Figure {
    /// The height of the mesh at rest.
    pub(crate) fn height(&self) -> f64 {
        self.mesh
            .bounds()
            .map_or(0.0, |[low, high]| high[1] - low[1])
    }

    /// The vertices in a pose.
    pub(crate) fn skinned(&self, pose: &Pose, method: Method) -> Result<Vec<[f64; 3]>, SkinError> {
        let motions = pose.motions(&self.skeleton)?;
        let moved = skin::skin(self.mesh.positions(), &self.weights, &motions, method)?;
        Ok(moved
            .iter()
            .map(|position| position.coordinates())
            .collect())
    }

    /// The positions of the joints in a pose.
    pub(crate) fn joints(&self, pose: &Pose) -> Result<Vec<[f64; 3]>, SkinError> {
        let bones = pose.bones(&self.skeleton)?;
        Ok(bones.into_iter().map(|[head, _]| head).collect())
    }
}
