//! Where a mesh is in the world.

use ga_mesh::gltf::Transform;
use ga_runtime::cga3::{Motor, Point, Similarity};
use ga_runtime::vga3::{Rotor, Vector};

use crate::capture::CaptureError;

/// p ↦ translation + factor · R p ~R.
pub(super) struct Placement {
    rotor: Rotor<f64>,
    factor: f64,
    translation: Vector<f64>,
}

impl Default for Placement {
    fn default() -> Self {
        Self {
            rotor: Rotor::default(),
            factor: 1.0,
            translation: Vector::ZERO,
        }
    }
}

impl Placement {
    /// From a mesh to where the head is in a pose, where `to_mesh` takes the head at rest to the
    /// mesh.
    pub(super) fn new(to_mesh: Similarity<f64>, pose: Motor<f64>) -> Result<Self, CaptureError> {
        let factor = to_mesh.factor().recip();
        // rest = S⁻¹ mesh: the displacement belongs to the origin of the mesh.
        let back = Rotor::from(to_mesh.rotor()).reverse();
        let origin = back.transform(Vector::from(to_mesh.displacement())) * -factor;
        let rotor = Rotor::from(pose.rotor()) * back;
        let translation = Vector::from(pose.transform(Point::from(origin)));
        if !(translation.is_finite() && factor.is_finite()) {
            return Err(CaptureError::NoPlace);
        }
        Ok(Self {
            rotor,
            factor,
            translation,
        })
    }

    pub(super) fn apply(&self, place: Vector<f64>) -> Vector<f64> {
        self.translation + self.rotor.transform(place) * self.factor
    }

    pub(super) fn translation(&self) -> [f32; 3] {
        self.translation.coordinates().map(|x| x as f32)
    }

    pub(super) fn quaternion(&self) -> [f32; 4] {
        let ([x, y, z], w) = self.rotor.to_quaternion();
        [x, y, z, w].map(|x| x as f32)
    }

    pub(super) fn transform(&self) -> Transform {
        Transform::Decomposed {
            translation: self.translation(),
            rotation: self.quaternion(),
            scale: [self.factor as f32; 3],
        }
    }
}
