//! A pose near to one that fits, by rotations that are known in closed form.

use crate::inverse_kinematics::motion::with_rotation;
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_runtime::vga3::Vector;

use super::{PoseFit, Target};
use crate::pose::Pose;

impl PoseFit<'_> {
    /// Moves the body as a whole so that the markers come as near as possible, and then rotates
    /// each joint, from the root on, so that the markers at a fixed distance from it are in the
    /// directions of their targets.
    pub(super) fn align(&mut self, pose: &mut Pose, targets: &[Target], root_motion: bool) {
        self.update_motions(pose);
        if root_motion {
            self.align_root(pose, targets);
        }
        for joint in 0..self.skeleton.len() {
            self.motions[joint] = self.above(pose, joint) * pose.joints[joint];
            if self.columns[joint].1 == 0 {
                continue;
            }
            let head = self.head(joint);
            let seen = |marker: &usize| targets[*marker].weight > 0.0;
            let levers = &self.levers[joint];
            let goal = match levers.at_head.filter(seen) {
                Some(marker) => Vector::from(targets[marker].position),
                None => head,
            };
            self.pairs.clear();
            for &marker in levers.markers.iter().filter(|marker| seen(marker)) {
                let Target { position, weight } = targets[marker];
                let [now, then] = [self.place(marker) - head, Vector::from(position) - goal];
                if now.normalized().is_some() && then.normalized().is_some() {
                    // A longer lever shows the rotation more sharply.
                    let weight = weight * now.length_squared();
                    self.pairs.push((weight, now.into(), then.into()));
                }
            }
            let rotor = match self.pairs.as_slice() {
                [] => None,
                [(_, now, then)] => Rotor::between(*now, *then),
                pairs @ [(_, now, then), ..] => Rotor::from_weighted_direction_pairs(pairs)
                    .map_or_else(|_| Rotor::between(*now, *then), |fit| Some(fit.motion)),
            };
            let Some(rotor) = rotor else { continue };
            let above = self.above(pose, joint);
            let local = above.rotor().reverse() * rotor * above.rotor();
            let head = self.skeleton.joints()[joint].head;
            pose.joints[joint] = with_rotation(self.limits, joint, head, pose.joints[joint], local);
            self.motions[joint] = above * pose.joints[joint];
        }
    }

    /// The rigid motion of the whole body that brings the markers as near as possible, as a
    /// rotation of its root joints and a translation.
    fn align_root(&mut self, pose: &mut Pose, targets: &[Target]) {
        let pairs: Vec<(f64, Point<f64>, Point<f64>)> = targets
            .iter()
            .enumerate()
            .filter(|(_, target)| target.weight > 0.0)
            .map(|(marker, target)| (target.weight, self.place(marker).into(), target.position))
            .collect();
        let roots = self.skeleton.joints().iter().enumerate();
        let mut roots = roots.filter(|(_, joint)| joint.parent.is_none());
        if let (Some((root, joint)), None) = (roots.next(), roots.next())
            && self.columns[root].1 == 3
            && let Ok(fit) = Motor::from_weighted_point_pairs(&pairs)
        {
            let above = pose.root.rotor();
            let local = above.reverse() * fit.motion.rotor() * above;
            pose.joints[root] =
                with_rotation(self.limits, root, joint.head, pose.joints[root], local);
            self.update_motions(pose);
        }
        let mut mean = (0.0, Vector::default());
        for (marker, target) in targets.iter().enumerate() {
            if target.weight > 0.0 {
                let away = Vector::from(target.position) - self.place(marker);
                mean = (mean.0 + target.weight, mean.1 + away * target.weight);
            }
        }
        let mut displacement = mean.1 / mean.0;
        // A marker at the root says exactly where the body is.
        let at_root = self
            .skeleton
            .joints()
            .iter()
            .position(|joint| joint.parent.is_none());
        if let Some(marker) = at_root
            .and_then(|root| self.levers[root].at_head)
            .filter(|&marker| targets[marker].weight > 0.0)
        {
            displacement = Vector::from(targets[marker].position) - self.place(marker);
        }
        pose.root = Translator::from_displacement(displacement.into()) * pose.root;
        self.update_motions(pose);
    }
}
