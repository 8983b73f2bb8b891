//! The direction from the hips to the head.

use ga_runtime::cga3::{Direction, Rotor};
use ga_runtime::vga3::Vector;

use super::hierarchy::Hanging;
use super::human::Human;
use crate::skeleton::Skeleton;

/// The joints from the hips to the head, which together give the trunk its direction.
#[derive(Clone, Debug)]
pub(super) struct Trunk {
    /// The joints of the target from the hips to the head.
    pub(super) chain: Vec<usize>,
    /// Hips and head of the source.
    pub(super) source: [usize; 2],
}

impl Trunk {
    pub(super) fn new(here: &Human, there: &Human, hanging: &Hanging) -> Self {
        let up = std::iter::successors(Some(here.head), |&joint| hanging.parents[joint]);
        let mut chain: Vec<usize> = Vec::new();
        let mut meets_hips = false;
        for joint in up {
            chain.push(joint);
            if joint == here.hips {
                meets_hips = true;
                break;
            }
        }
        chain.reverse();
        if !meets_hips {
            chain.clear();
        }
        Self {
            chain,
            source: [there.hips, there.head],
        }
    }

    /// The rotation of all joints between hips and head, as one, by which the head comes to lie in
    /// a direction from the hips, or as near to it as they reach. The hips and the head itself keep
    /// their rotations.
    ///
    /// With the bone f of the hips, the way m from its end to the head, and the direction d,
    /// `f + R m = t d` has the solutions `t = f·d ± √((f·d)² − f² + m²)`. The one that changes the
    /// distance from hips to head less is taken.
    pub(super) fn correction(
        &self,
        target: &Skeleton,
        rotors: &[Rotor<f64>],
        direction: Vector<f64>,
    ) -> Rotor<f64> {
        let bone = |pair: &[usize]| {
            let [from, to] =
                [pair[0], pair[1]].map(|joint| Vector::from(target.joints()[joint].head));
            Vector::from(rotors[pair[0]].transform(Direction::from(to - from)))
        };
        let mut bones = self.chain.windows(2).map(bone);
        let fixed = bones.next().unwrap_or_default();
        let moved: Vector<f64> = bones.sum();
        let Some(direction) = direction.normalized() else {
            return Rotor::default();
        };
        let along = fixed.dot(direction);
        let square = along * along - fixed.length_squared() + moved.length_squared();
        let half = square.max(0.0).sqrt();
        let now = (fixed + moved).length();
        let change = |t: f64| (t - now).abs();
        let [far, near] = [along + half, along - half];
        let wanted = match (near > 0.0 && change(near) < change(far), far > 0.0) {
            (true, _) => direction * near - fixed,
            (_, true) => direction * far - fixed,
            // The head stays behind the hips whatever the rotation.
            _ => direction,
        };
        Rotor::between(moved.coordinates(), wanted.coordinates()).unwrap_or_default()
    }
}
