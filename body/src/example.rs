//! A small body and cameras for the tests of the parts of a fit.

use ga_anim::skeleton::{Joint, Skeleton};
use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::vga3::Vector;

use super::BodyModel;
use super::chain::{Chain, State};
use ga_camera::{Camera, Intrinsics};

/// A trunk with an arm of two bones and a head.
pub(super) fn model() -> BodyModel {
    let joint = |name: &str, parent, head| Joint {
        name: name.to_owned(),
        parent,
        head,
        tail: head,
    };
    let joints = vec![
        joint("hips", None, [0.0, 0.0, 3.0]),
        joint("chest", Some(0), [0.0, 0.5, 3.1]),
        joint("elbow", Some(1), [0.4, 0.6, 2.9]),
        joint("hand", Some(2), [0.7, 0.5, 2.8]),
        joint("head", Some(1), [-0.1, 0.8, 3.0]),
    ];
    BodyModel::of_distinct_joints(Skeleton::new(joints).expect("a tree")).expect("a body")
}

/// A pose with rotations of up to half a radian about each axis, others for another seed.
pub(super) fn state(chain: &Chain<'_>, seed: usize) -> State {
    let number = |k: usize| ((7 * (k + seed) + 3) % 11) as f64 / 11.0 - 0.5;
    State {
        translation: Vector::new(0.1, -0.2, 0.05 + 0.03 * number(5)),
        rotors: (0..chain.columns.len())
            .map(|k| [number(k), number(k + 4), number(k + 9)])
            .map(|vector| Rotor::from_rotation_vector(vector).expect("finite"))
            .collect(),
    }
}

/// A camera beside the origin that looks along the z axis.
pub(super) fn camera(aside: f64) -> Camera {
    Camera {
        intrinsics: Intrinsics::new([500.0; 2], [320.0, 240.0]).expect("a camera"),
        world_to_camera: Motor::from(Translator::from_displacement([-aside, 0.0, 0.0])),
    }
}
