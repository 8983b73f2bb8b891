//! A skeleton as a function of its rotations, with derivatives.

use ga_anim::pose::Pose;
use ga_runtime::cga3::{Direction, Motor, Point, Rotor, Translator};
use ga_runtime::geometry::RotationPath;
use ga_runtime::vga3::Vector;

use super::branched::Above;
use super::model::{BodyModel, BodyPoint};
use super::posture::{Spread, spreads};
use super::skinned::Skinned;

/// The columns of the translation, which come first.
pub(super) const TRANSLATION: usize = 3;

/// The standard deviation of a joint's rotation from its mean in radians, where nothing else is
/// known: about that of a human's limbs. It is weak beside pixels and decides what they leave open.
const LIMB: f64 = 0.7;
/// That of joints of the trunk, which carry more than a third of the body's points and several
/// ends, and of bones that begin where their parent does: pelvis and shoulders hardly deform.
const TRUNK: f64 = 0.2;

/// The unknowns of a joint's rotation.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Columns {
    /// The first of them.
    pub(super) first: usize,
    /// 3 for a joint that rotates freely, 1 for a hinge, 0 for one that is fixed, or whose rotation
    /// no point shows.
    pub(super) count: usize,
    /// The unit axis of a hinge, in the coordinates of the skeleton at rest.
    axis: Vector<f64>,
}

/// A joint that moves a point, and which of the point's joints it carries.
#[derive(Clone, Debug)]
struct Mover {
    joint: usize,
    carries: Vec<usize>,
}

/// A model prepared for fits.
#[derive(Clone, Debug)]
pub(super) struct Chain<'a> {
    pub(super) model: &'a BodyModel,
    /// For each joint, where its head is at rest, relative to that of its parent.
    offsets: Vec<Vector<f64>>,
    /// For each point, where it is at rest, relative to the heads of its joints.
    levers: Vec<Vec<Vector<f64>>>,
    pub(super) columns: Vec<Columns>,
    /// The number of all unknowns.
    pub(super) count: usize,
    /// For each point, what moves it, from the root on.
    movers: Vec<Vec<Mover>>,
    /// For each unknown the one above it, where those that move a point are always one chain.
    pub(super) above: Option<Above>,
    /// For each joint the mean of its rotations.
    means: Vec<Rotor<f64>>,
    /// For each joint the standard deviation of its rotation from the mean in radians.
    pub(super) deviations: Vec<f64>,
    /// The points that follow several joints by a blend of motors.
    skinned: Option<Skinned>,
}

/// A pose by numbers and rotors: rotations relative to the parent, in the axes of rest.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct State {
    pub(super) translation: Vector<f64>,
    pub(super) rotors: Vec<Rotor<f64>>,
}

/// Where everything is in a state.
#[derive(Clone, Debug)]
pub(super) struct Places {
    /// For each joint the rotation of its bone from rest.
    rotors: Vec<Rotor<f64>>,
    /// For each joint the axes of its unknowns.
    axes: Vec<[Vector<f64>; 3]>,
    heads: Vec<Vector<f64>>,
    /// For each point, where each of its joints would take it.
    parts: Vec<Vec<Vector<f64>>>,
    pub(super) points: Vec<Vector<f64>>,
}

impl<'a> Chain<'a> {
    pub(super) fn new(model: &'a BodyModel) -> Self {
        let joints = model.skeleton().joints();
        let offsets = joints.iter().map(|joint| {
            let above = joint.parent.map_or([0.0; 3], |parent| joints[parent].head);
            Vector::from(joint.head) - Vector::from(above)
        });
        let levers = model.points().iter().map(|point| {
            let of_joint = |&(joint, _): &(usize, f64)| {
                Vector::from(point.at_rest) - Vector::from(joints[joint].head)
            };
            point.joints.iter().map(of_joint).collect()
        });
        let movers: Vec<Vec<Mover>> = model.points().iter().map(|p| movers(model, p)).collect();
        let mut count = TRANSLATION;
        let columns = (0..joints.len()).map(|joint| {
            let axis = model.limits().and_then(|limits| limits.hinge_axis(joint));
            let is_fixed = model.limits().is_some_and(|limits| limits.is_fixed(joint));
            let own = match (is_fixed || is_redundant(model, &movers, joint), axis) {
                (true, _) => 0,
                (false, Some(_)) => 1,
                (false, None) => 3,
            };
            count += own;
            Columns {
                first: count - own,
                count: own,
                axis: axis.unwrap_or_default(),
            }
        });
        let columns: Vec<Columns> = columns.collect();
        let (means, deviations) = spread(model, &movers, &columns);
        Self {
            above: above(model, &movers, &columns),
            means,
            deviations,
            columns,
            offsets: offsets.collect(),
            levers: levers.collect(),
            skinned: Skinned::new(model),
            count,
            movers,
            model,
        }
    }

    /// The same chain with the way to each joint times a factor, and what lies beside the bones
    /// times another; points that follow several joints are at the means of their places.
    pub(super) fn with_factors(&self, factors: &[f64], beside: f64) -> Self {
        let offsets = self.offsets.iter().zip(factors);
        let levers = self.levers.iter();
        Self {
            offsets: offsets.map(|(offset, factor)| *offset * *factor).collect(),
            levers: levers
                .map(|levers| levers.iter().map(|lever| *lever * beside).collect())
                .collect(),
            skinned: None,
            ..self.clone()
        }
    }

    /// The same chain with points beside their places at rest, as far as that is given.
    pub(super) fn with_displacements(
        mut self,
        displacements: impl Iterator<Item = Option<Vector<f64>>>,
    ) -> Self {
        for (levers, displacement) in self.levers.iter_mut().zip(displacements) {
            for lever in levers {
                *lever += displacement.unwrap_or_default();
            }
        }
        self
    }

    /// A direction at rest, where the strongest joint of a point takes it.
    pub(super) fn rotated_with(
        &self,
        places: &Places,
        point: usize,
        direction: Vector<f64>,
    ) -> Vector<f64> {
        let joints = self.model.points()[point].joints.iter();
        let strongest = joints.max_by(|a, b| a.1.total_cmp(&b.1));
        let rotor = strongest.map(|(joint, _)| places.rotors[*joint]);
        rotated(rotor.unwrap_or_default(), direction)
    }

    /// The derivatives of a point by the logarithms of the lengths of the ways to joints.
    pub(super) fn derivatives_by_bones(
        &self,
        places: &Places,
        point: usize,
        mut by_bone: impl FnMut(usize, Vector<f64>),
    ) {
        let joints = self.model.skeleton().joints();
        let point = &self.model.points()[point];
        let total = weights(point);
        for &(joint, weight) in &point.joints {
            let mut below = joint;
            while let Some(parent) = joints[below].parent {
                let way = places.heads[below] - places.heads[parent];
                by_bone(below, way * (weight / total));
                below = parent;
            }
        }
    }

    /// Whether a joint has no joint above it: its rotation is that of the whole body.
    pub(super) fn is_root(&self, joint: usize) -> bool {
        self.model.skeleton().joints()[joint].parent.is_none()
    }

    /// The body where it is at rest, with all joints at the means of their rotations.
    pub(super) fn usual(&self) -> State {
        State {
            translation: Vector::default(),
            rotors: self.means.clone(),
        }
    }

    /// The rotation of a joint's bone from rest in the usual posture, where that above is rotated.
    pub(super) fn usual_rotor(&self, joint: usize, above: Rotor<f64>) -> Rotor<f64> {
        above * self.means[joint]
    }

    /// The rotation vector of a joint from the mean of its rotations.
    pub(super) fn deviation(&self, state: &State, joint: usize) -> Vector<f64> {
        rotation_vector(state.rotors[joint] * self.means[joint].reverse())
    }

    /// The joints that rotate relative to one above them.
    pub(super) fn rotating(&self) -> impl Iterator<Item = usize> + '_ {
        let joints = 0..self.columns.len();
        joints.filter(|&joint| self.columns[joint].count > 0 && !self.is_root(joint))
    }

    /// The squared deviations of all joints from the means of their rotations, in variances.
    pub(super) fn unusual(&self, state: &State) -> f64 {
        let squares = self.rotating().map(|joint| {
            self.deviation(state, joint).length_squared() / self.deviations[joint].powi(2)
        });
        squares.sum()
    }

    pub(super) fn pose_of(&self, state: &State) -> Pose {
        let joints = self.model.skeleton().joints().iter().zip(&state.rotors);
        Pose {
            root: Translator::from_displacement(state.translation.into()).into(),
            joints: joints
                .map(|(joint, &rotor)| Motor::about(joint.head.into(), rotor))
                .collect(),
        }
    }

    /// The state that a pose is of.
    pub(super) fn state_of(&self, pose: &Pose) -> State {
        State {
            translation: pose.root.transform(Point::default()).into(),
            rotors: pose.joints.iter().map(|motor| motor.rotor()).collect(),
        }
    }

    pub(super) fn places(&self, state: &State) -> Places {
        let joints = self.model.skeleton().joints();
        let mut rotors: Vec<Rotor<f64>> = Vec::with_capacity(joints.len());
        let mut heads: Vec<Vector<f64>> = Vec::with_capacity(joints.len());
        let mut axes: Vec<[Vector<f64>; 3]> = Vec::with_capacity(joints.len());
        for (index, joint) in joints.iter().enumerate() {
            let (own, offset) = (state.rotors[index], self.offsets[index]);
            let above = joint
                .parent
                .map_or(Rotor::default(), |parent| rotors[parent]);
            let columns = self.columns[index];
            axes.push([0, 1, 2].map(|k| {
                if k < columns.count {
                    rotated(above, columns.direction(k))
                } else {
                    Vector::default()
                }
            }));
            let (rotor, head) = match joint.parent {
                Some(parent) => (
                    rotors[parent] * own,
                    heads[parent] + rotated(rotors[parent], offset),
                ),
                None => (own, offset + state.translation),
            };
            rotors.push(rotor);
            heads.push(head);
        }
        let (mut parts, mut points) = (Vec::new(), Vec::new());
        for (point, levers) in self.model.points().iter().zip(&self.levers) {
            let parts_of_point = point.joints.iter().zip(levers);
            let parts_of_point = parts_of_point
                .map(|(&(joint, _), lever)| heads[joint] + rotated(rotors[joint], *lever));
            let parts_of_point: Vec<Vector<f64>> = parts_of_point.collect();
            let weighted = parts_of_point.iter().zip(&point.joints);
            let sum = weighted.fold(Vector::default(), |sum, (part, (_, weight))| {
                sum + *part * *weight
            });
            points.push(sum / weights(point));
            parts.push(parts_of_point);
        }
        let mut places = Places {
            rotors,
            axes,
            heads,
            parts,
            points,
        };
        if let Some(skinned) = &self.skinned {
            skinned.blend(
                &self.motions(&places),
                &mut places.points,
                &mut places.parts,
            );
        }
        places
    }

    /// Where the heads of all joints are.
    pub(super) fn heads(&self, state: &State) -> Vec<Vector<f64>> {
        self.places(state).heads
    }

    /// The total motions of all joints.
    fn motions(&self, places: &Places) -> Vec<Motor<f64>> {
        let joints = self.model.skeleton().joints().iter();
        let placed = joints.zip(places.rotors.iter().zip(&places.heads));
        placed
            .map(|(joint, (rotor, head))| {
                let displacement = *head - rotated(*rotor, joint.head.into());
                Translator::from_displacement(displacement.into()) * *rotor
            })
            .collect()
    }

    /// The derivatives of a point by the unknowns, in ascending order: by the translation, and by
    /// rotations of the joints, whose axes are those of the parent.
    pub(super) fn derivatives(
        &self,
        places: &Places,
        point: usize,
        rows: &mut Vec<(usize, Vector<f64>)>,
    ) {
        rows.clear();
        rows.extend((0..TRANSLATION).map(|k| (k, unit(k))));
        let BodyPoint { joints, .. } = &self.model.points()[point];
        let total = weights(&self.model.points()[point]);
        for Mover { joint, carries } in &self.movers[point] {
            let columns = self.columns[*joint];
            if columns.count == 0 {
                continue;
            }
            let head = places.heads[*joint];
            // The sum of the levers of what the joint carries.
            let lever = carries.iter().fold(Vector::default(), |sum, &part| {
                sum + (places.parts[point][part] - head) * (joints[part].1 / total)
            });
            for (k, axis) in places.axes[*joint][..columns.count].iter().enumerate() {
                rows.push((columns.first + k, axis.cross(lever)));
            }
        }
    }

    /// The derivatives of the head of a joint by the unknowns.
    pub(super) fn derivatives_of_head(
        &self,
        places: &Places,
        joint: usize,
    ) -> Vec<(usize, Vector<f64>)> {
        let joints = self.model.skeleton().joints();
        let above = std::iter::successors(joints[joint].parent, |&above| joints[above].parent);
        let by_rotations = above.flat_map(|above| {
            let lever = places.heads[joint] - places.heads[above];
            let Columns { first, count, .. } = self.columns[above];
            let axes = places.axes[above].into_iter().take(count).enumerate();
            axes.map(move |(k, axis)| (first + k, axis.cross(lever)))
        });
        let by_translation = (0..TRANSLATION).map(|k| (k, unit(k)));
        by_translation.chain(by_rotations).collect()
    }

    /// The state after a step of all unknowns, with joints within their limits.
    pub(super) fn stepped(&self, state: &State, step: &[f64]) -> Option<State> {
        let mut next = state.clone();
        next.translation = state.translation + Vector::new(step[0], step[1], step[2]);
        for (joint, columns) in self.columns.iter().enumerate() {
            if columns.count > 0 {
                let own = &step[columns.first..columns.first + columns.count];
                let vector = columns.vector(own);
                let rotor = Rotor::from_rotation_vector(vector.into())? * state.rotors[joint];
                next.rotors[joint] = match self.model.limits() {
                    Some(limits) => limits.clamp(joint, rotor),
                    None => rotor,
                };
            }
        }
        let finite = next.translation.coordinates().iter().all(|x| x.is_finite());
        finite.then_some(next)
    }
}

impl Columns {
    /// The axis of an unknown in the coordinates of the parent.
    pub(super) fn direction(&self, k: usize) -> Vector<f64> {
        if self.count == 1 { self.axis } else { unit(k) }
    }

    /// The rotation vector of a step.
    fn vector(&self, step: &[f64]) -> Vector<f64> {
        let parts = step.iter().enumerate();
        parts.fold(Vector::default(), |sum, (k, part)| {
            sum + self.direction(k) * *part
        })
    }
}

/// The rotation vector of a rotor, the shorter way.
pub(super) fn rotation_vector(rotor: Rotor<f64>) -> Vector<f64> {
    rotor.along(RotationPath::Short).to_rotation_vector().into()
}

pub(super) fn rotated(rotor: Rotor<f64>, vector: Vector<f64>) -> Vector<f64> {
    let direction = Direction::from_vector(vector.into());
    rotor.transform(direction).vector().into()
}

fn unit(k: usize) -> Vector<f64> {
    Vector::from([0, 1, 2].map(|i| f64::from(u8::from(i == k))))
}

fn weights(point: &BodyPoint) -> f64 {
    point.joints.iter().map(|(_, weight)| weight).sum()
}

/// The unknown above each, where the joints that move a point are always one chain.
fn above(model: &BodyModel, movers: &[Vec<Mover>], columns: &[Columns]) -> Option<Above> {
    let joints = model.skeleton().joints();
    let with_columns = |joint: usize| {
        let above = std::iter::successors(Some(joint), |&joint| joints[joint].parent);
        above.skip(1).find(|&joint| columns[joint].count > 0)
    };
    for movers in movers {
        let own = movers.iter().map(|mover| mover.joint);
        let own: Vec<usize> = own.filter(|&joint| columns[joint].count > 0).collect();
        if own
            .windows(2)
            .any(|pair| with_columns(pair[1]) != Some(pair[0]))
        {
            return None;
        }
        if own
            .first()
            .is_some_and(|&joint| with_columns(joint).is_some())
        {
            return None;
        }
    }
    let mut above: Above = (0..TRANSLATION).map(|k| k.checked_sub(1)).collect();
    for (joint, own) in columns.iter().enumerate() {
        let before = with_columns(joint).map_or(TRANSLATION - 1, |above| {
            columns[above].first + columns[above].count - 1
        });
        above.extend((0..own.count).map(|k| match k {
            0 => Some(before),
            _ => Some(own.first + k - 1),
        }));
    }
    Some(above)
}

/// The standard deviations of rotations from rest.
fn deviations(model: &BodyModel, movers: &[Vec<Mover>]) -> Vec<f64> {
    let joints = model.skeleton().joints();
    let of_joint = |joint: usize| {
        let carried = movers
            .iter()
            .filter(|m| m.iter().any(|m| m.joint == joint))
            .count();
        let is_below = |end: usize| {
            std::iter::successors(Some(end), |&end| joints[end].parent).any(|above| above == joint)
        };
        let is_end = |end: usize| joints.iter().all(|other| other.parent != Some(end));
        let ends = (0..joints.len())
            .filter(|&end| is_end(end) && is_below(end))
            .count();
        let is_trunk = 3 * carried > movers.len() && ends > 1;
        let parent = joints[joint].parent;
        let is_branch = parent.is_some_and(|parent| joints[parent].head == joints[joint].head);
        if is_trunk || is_branch { TRUNK } else { LIMB }
    };
    (0..joints.len()).map(of_joint).collect()
}

/// The means and the standard deviations of rotations from rest.
fn spread(
    model: &BodyModel,
    movers: &[Vec<Mover>],
    columns: &[Columns],
) -> (Vec<Rotor<f64>>, Vec<f64>) {
    let joints = model.skeleton().joints();
    let mut means = vec![Rotor::default(); joints.len()];
    let mut deviations = deviations(model, movers);
    for Spread {
        joint,
        mean,
        deviation,
    } in spreads(model.skeleton())
    {
        // What rotates nothing beside its parent is rotated by that.
        let mut own = Some(joint);
        while let Some(fixed) = own.filter(|&own| columns[own].count == 0) {
            own = joints[fixed].parent;
            own = own.filter(|&parent| joints[parent].head == joints[fixed].head);
        }
        let Some(own) = own.filter(|&own| joints[own].parent.is_some()) else {
            continue;
        };
        let limits = model.limits();
        means[own] = limits.map_or(mean, |limits| limits.clamp(own, mean));
        deviations[own] = deviation;
    }
    (means, deviations)
}

/// The joints that move a point, from the root on. A joint does not move what is at its own head.
fn movers(model: &BodyModel, point: &BodyPoint) -> Vec<Mover> {
    let joints = model.skeleton().joints();
    let mut movers: Vec<Mover> = Vec::new();
    for (part, &(joint, weight)) in point.joints.iter().enumerate() {
        if weight == 0.0 {
            continue;
        }
        let mut above = Some(joint);
        let mut is_at_head = true;
        while let Some(joint) = above {
            is_at_head &= joints[joint].head == point.at_rest;
            if !is_at_head {
                match movers.iter_mut().find(|mover| mover.joint == joint) {
                    Some(mover) => mover.carries.push(part),
                    None => movers.push(Mover {
                        joint,
                        carries: vec![part],
                    }),
                }
            }
            above = joints[joint].parent;
        }
    }
    movers.sort_by_key(|mover| mover.joint);
    movers
}

/// Whether a joint moves nothing, or exactly what its parent moves and about the same centre.
fn is_redundant(model: &BodyModel, movers: &[Vec<Mover>], joint: usize) -> bool {
    let joints = model.skeleton().joints();
    let carried = |joint: usize, point: usize| {
        let mover = movers[point].iter().find(|mover| mover.joint == joint);
        mover.map(|mover| mover.carries.as_slice())
    };
    let moves = |joint: usize| (0..movers.len()).any(|point| carried(joint, point).is_some());
    let Some(parent) = joints[joint].parent else {
        return !moves(joint);
    };
    let is_same = || (0..movers.len()).all(|point| carried(joint, point) == carried(parent, point));
    !moves(joint) || (joints[joint].head == joints[parent].head && is_same())
}
