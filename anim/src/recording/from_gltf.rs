use ga_mesh::gltf::{Document, Keys, Mesh, Node};
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;

use super::grid::Grid;
use super::{RecordedJoint, Recording, ScalarTrack};
use crate::clip::Clip;
use crate::clip::compressed::ShellError;
use crate::file_error::MotionFileError;
use crate::gltf::{LocalFrame, NodePose, Player, bind_pose, parts, uniform_parts, uniform_within};
use crate::recording::RecordingError;
use crate::skeleton::Skeleton;
use crate::transform::Transform;

/// An animation of a glTF document as the motion of joints.
///
/// The joints are the joints of all skins, the nodes that the animation moves, and the nodes above
/// them. A node that stays where it is, with all nodes above it, is not a joint where it only
/// moves, rotates and scales uniformly: its frame then belongs to the joints below it.
///
/// # Examples
///
/// ```
/// use ga_anim::gltf::Player;
/// use ga_anim::recording::GltfMotion;
/// use ga_mesh::gltf::{Animation, Channel, Document, Interpolation, Keys, Node};
///
/// let go = Channel {
///     node: 0,
///     times: vec![0.0, 0.5, 1.0],
///     interpolation: Interpolation::Linear,
///     keys: Keys::Translation(vec![[0.0; 3], [100.0, 0.0, 0.0], [100.0, 50.0, 0.0]]),
///     extras: None,
/// };
/// let document = Document {
///     nodes: vec![Node { name: Some("box".into()), ..Node::default() }],
///     animations: vec![Animation { channels: vec![go], ..Animation::default() }],
///     ..Document::default()
/// };
/// let player = Player::new(&document)?;
/// let recording = GltfMotion::new(&player, 0, 0.01)?.recording(None)?;
/// assert_eq!((recording.frame_count(), recording.frame_time()), (3, 0.5));
/// let last = &recording.frame(2).ok_or("no frame")?[0];
/// assert_eq!(last.translation().coordinates(), [1.0, 0.5, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct GltfMotion<'a> {
    pub(super) player: &'a Player<'a>,
    /// `None` for joints without an animation, which are written as a new one.
    pub(super) animation: Option<usize>,
    pub(super) metres_per_unit: f64,
    pub(super) joints: Vec<RecordedJoint>,
    pub(super) sources: Vec<Source>,
    /// The nodes whose morph targets the animation moves.
    pub(super) morphed: Vec<usize>,
}

/// As a part of the factor, by how much a frame that belongs to the joints below may deviate from
/// one that is scaled uniformly: the deviation is in every frame of them.
const UNIFORM: f64 = 1e-6;

/// Between the name of a node and the number of a morph target.
const NUMBERED: &str = ", morph target ";

impl ScalarTrack {
    /// Whether it is of a morph target without a name, which in another document may have this
    /// number for another thing.
    #[must_use]
    pub fn is_of_numbered_target(&self) -> bool {
        self.name.contains(NUMBERED)
    }
}

/// Where the transform of a joint comes from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Source {
    pub(super) node: usize,
    /// The transform of the node without an animation.
    stands: Transform<f64>,
    /// The frame in the world of the nodes above that are not joints.
    pub(super) above: Transform<f64>,
}

impl Recording {
    /// An animation of a glTF document; see [`GltfMotion`], and [`GltfMotion::recording`] for the
    /// rate.
    ///
    /// # Errors
    ///
    /// As [`GltfMotion::new`] and [`GltfMotion::recording`], and [`MotionFileError::Document`] for
    /// a document that is not valid.
    pub fn from_gltf(
        document: &Document,
        animation: usize,
        metres_per_unit: f64,
        rate: Option<f64>,
    ) -> Result<Self, MotionFileError> {
        let player = Player::new(document)?;
        GltfMotion::new(&player, animation, metres_per_unit)?.recording(rate)
    }
}

impl<'a> GltfMotion<'a> {
    /// Finds the joints of an animation of a document, of which one unit is `metres_per_unit` long;
    /// glTF's unit is the metre.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::NoAnimation`]; [`RecordingError::Unit`]; [`RecordingError::NoJoints`]
    /// where there is no skin and the animation moves no node; [`MotionFileError::Shears`].
    pub fn new(
        player: &'a Player<'a>,
        animation: usize,
        metres_per_unit: f64,
    ) -> Result<Self, MotionFileError> {
        let document = player.document();
        let Some(played) = document.animations.get(animation) else {
            let count = document.animations.len();
            return Err(MotionFileError::NoAnimation { animation, count });
        };
        let mut is_moving = vec![false; document.nodes.len()];
        let joints = document.skins.iter().flat_map(|skin| &skin.joints);
        joints.for_each(|&node| is_moving[node] = true);
        for channel in &played.channels {
            is_moving[channel.node] |= !matches!(channel.keys, Keys::Weights(_));
        }
        let rest = player.pose(None, 0.0)?;
        let mut motion = Self::of_nodes(player, &is_moving, &rest, metres_per_unit)?;
        let weights = played.channels.iter();
        let weights = weights.filter(|channel| matches!(channel.keys, Keys::Weights(_)));
        motion.morphed = weights.map(|channel| channel.node).collect();
        motion.animation = Some(animation);
        Ok(motion)
    }

    /// These nodes of a document as joints, in the pose in which its skins were bound, and the
    /// nodes above them as of [`new`](Self::new), for a motion that the document does not have.
    ///
    /// # Errors
    ///
    /// [`RecordingError::Unit`]; [`RecordingError::NoJoints`] where no nodes are given;
    /// [`MotionFileError::Shears`] and [`MotionFileError::NonUniformScale`].
    ///
    /// # Panics
    ///
    /// When there is no such node.
    pub(crate) fn of_joints(
        player: &'a Player<'a>,
        nodes: &[usize],
        metres_per_unit: f64,
    ) -> Result<Self, MotionFileError> {
        let document = player.document();
        let mut is_moving = vec![false; document.nodes.len()];
        nodes.iter().for_each(|&node| is_moving[node] = true);
        let mut motion = Self::of_nodes(player, &is_moving, &bind_pose(player)?, metres_per_unit)?;
        let is_morphed = |&node: &usize| motion.track_names(node).next().is_some();
        motion.morphed = (0..document.nodes.len()).filter(is_morphed).collect();
        Ok(motion)
    }

    /// The nodes that move as joints, with their transforms at rest in a pose.
    fn of_nodes(
        player: &'a Player<'a>,
        is_moving: &[bool],
        pose: &NodePose,
        metres_per_unit: f64,
    ) -> Result<Self, MotionFileError> {
        if !metres_per_unit.is_finite() || metres_per_unit <= 0.0 {
            return Err(RecordingError::Unit(metres_per_unit).into());
        }
        let document = player.document();
        let stands = player.pose(None, 0.0)?;
        let parents = player.parents();
        let is_joint = joint_nodes(player, is_moving, pose);
        let lengths = (0..is_joint.len()).filter(|&node| is_joint[node]);
        let lengths = lengths.map(|node| pose.locals[node].to_affine().translation);
        let longest = lengths
            .map(|way| Vector::from(way).length())
            .fold(0.0, f64::max);
        let mut motion = Self {
            player,
            animation: None,
            metres_per_unit,
            joints: Vec::new(),
            sources: Vec::new(),
            morphed: Vec::new(),
        };
        let mut joint_of = vec![None; document.nodes.len()];
        for &node in player.parents_before_children() {
            if !is_joint[node] {
                continue;
            }
            let above = match parents[node] {
                Some(parent) if !is_joint[parent] => {
                    uniform_within(pose.world[parent], UNIFORM).unwrap_or_default()
                }
                _ => Transform::default(),
            };
            let own = parts(&stands.locals[node]).ok_or(MotionFileError::Shears { node })?;
            let rest = match pose.locals[node] == stands.locals[node] {
                true => own,
                false => {
                    let bound = uniform_parts(&pose.locals[node]);
                    let bound = bound.ok_or(MotionFileError::NonUniformScale { node })?;
                    bound_rest(&own, &bound, longest)
                }
            };
            let source = Source {
                node,
                stands: own,
                above,
            };
            joint_of[node] = Some(motion.joints.len());
            motion.joints.push(RecordedJoint {
                name: name(node, &document.nodes[node]),
                parent: parents[node].and_then(|parent| joint_of[parent]),
                rest: motion.local(&source, rest),
            });
            motion.sources.push(source);
        }
        if motion.joints.is_empty() {
            return Err(RecordingError::NoJoints.into());
        }
        Ok(motion)
    }

    /// The recording of a clip of a skeleton whose joints are these nodes; see
    /// [`Recording::of_joints`]. Joints of this motion that the skeleton does not have stay.
    ///
    /// # Errors
    ///
    /// As [`Recording::of_joints`].
    pub(crate) fn recording_of_clip(
        &self,
        skeleton: &Skeleton,
        nodes: &[usize],
        clip: &Clip,
    ) -> Result<Recording, RecordingError> {
        let place = |node: usize| nodes.iter().position(|&other| other == node);
        let of_skeleton: Vec<Option<usize>> = self.nodes().map(place).collect();
        let skeleton = (skeleton, self.metres_per_unit);
        Recording::of_joints(self.joints.clone(), &of_skeleton, skeleton, clip)
    }

    /// The joints, parents before children. A joint's transform at rest is that of its node without
    /// an animation.
    #[must_use]
    pub fn joints(&self) -> &[RecordedJoint] {
        &self.joints
    }

    /// The node of each joint.
    pub fn nodes(&self) -> impl ExactSizeIterator<Item = usize> + '_ {
        self.sources.iter().map(|source| source.node)
    }

    /// The map of each joint's frame to the world at a time in seconds, in metres, as the document
    /// has it: no frames are involved.
    ///
    /// # Errors
    ///
    /// As [`Player::pose`].
    pub fn model_maps(&self, time: f64) -> Result<Vec<Affine<f64>>, MotionFileError> {
        let pose = self.player.pose(self.animation, time)?;
        let in_metres = |node: usize| {
            let map = pose.world[node];
            let translation = map.translation.map(|x| x * self.metres_per_unit);
            Affine::new(map.linear, translation)
        };
        Ok(self.nodes().map(in_metres).collect())
    }

    /// The weights of the morph targets that the animation moves, with their names, at a time in
    /// seconds.
    ///
    /// # Errors
    ///
    /// As [`Player::pose`].
    pub fn track_values(&self, time: f64) -> Result<Vec<(String, f64)>, MotionFileError> {
        let pose = self.player.pose(self.animation, time)?;
        let weights = self.morphed.iter().flat_map(|&node| pose.weights(node));
        let names = self.tracks(0).into_iter().map(|track| track.name);
        Ok(names.zip(weights.copied()).collect())
    }

    /// The motion as frames at equal time steps, from 0 to the last key.
    ///
    /// Where no rate is given and all keys are at multiples of the shortest interval between two
    /// of them, up to a thousandth of it, that interval is the step. A key whose time is that of a
    /// frame up to the rounding of single precision is kept as it is; every other frame shows the
    /// document at its own time.
    /// Otherwise the step is the shortest interval, but not below 1/240 s. Between frames a
    /// recording is linear: a rate well above that of the keys shows steps and splines as they are.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::Rate`], [`MotionFileError::RecordingTooLarge`] past four million
    /// transforms, and as [`Player::pose`].
    pub fn recording(&self, rate: Option<f64>) -> Result<Recording, MotionFileError> {
        const LIMIT: usize = 1 << 22;
        let keys = self.key_times();
        let last = keys.last().copied().unwrap_or(0.0);
        let grid = Grid::new(rate, &keys)?;
        if (grid.steps + 1.0) * self.joints.len() as f64 > LIMIT as f64 {
            return Err(MotionFileError::RecordingTooLarge {
                rate: grid.step.recip(),
                seconds: last,
                joints: self.joints.len(),
                limit: LIMIT,
            });
        }
        let frames = grid.steps as usize + 1;
        let mut locals = Vec::with_capacity(frames * self.joints.len());
        let mut tracks = self.tracks(frames);
        let mut pose = self.player.pose(None, 0.0)?;
        for frame in 0..frames {
            let time = grid.time(frame, &keys);
            self.player.pose_into(self.animation, time, &mut pose)?;
            for source in &self.sources {
                let own = match pose.locals[source.node] {
                    LocalFrame::Parts(parts) => parts,
                    // An animation does not move it.
                    LocalFrame::Matrix(_) => source.stands,
                };
                locals.push(self.local(source, own));
            }
            let weights = self.morphed.iter().flat_map(|&node| pose.weights(node));
            for (track, &weight) in tracks.iter_mut().zip(weights) {
                track.values.push(weight);
            }
        }
        Ok(Recording::new(
            self.joints.clone(),
            grid.step,
            locals,
            tracks,
        )?)
    }

    /// How far a recording at this rate is from the document: the greatest error of a joint in a
    /// frame, in metres, as [`Options`](crate::clip::compressed::Options) describes it, for
    /// points within `shell` metres. A matrix of a node may have a little shear by its rounding,
    /// which the factors of a recording do not have.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::Rate`], and as [`Player::pose`].
    pub fn deviation(
        &self,
        recording: &Recording,
        rate: Option<f64>,
        shell: f64,
    ) -> Result<f64, MotionFileError> {
        let keys = self.key_times();
        let grid = Grid::new(rate, &keys)?;
        let mut error = ShellError::new(recording, shell);
        for frame in 0..recording.frame_count() {
            error.compare(frame, &self.model_maps(grid.time(frame, &keys))?);
        }
        Ok(error.greatest())
    }

    /// The times of all keys in rising order.
    fn key_times(&self) -> Vec<f64> {
        let animations = &self.player.document().animations;
        let played = self
            .animation
            .and_then(|animation| animations.get(animation));
        let channels = played.into_iter().flat_map(|played| &played.channels);
        let times = channels.flat_map(|channel| channel.times.iter().copied());
        let mut times: Vec<f64> = times.map(f64::from).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }

    /// A track without numbers for each morph target that moves.
    fn tracks(&self, frames: usize) -> Vec<ScalarTrack> {
        let names = self.morphed.iter().flat_map(|&node| self.track_names(node));
        let track = |name| ScalarTrack {
            name,
            values: Vec::with_capacity(frames),
        };
        names.map(track).collect()
    }

    /// The name of the track of each morph target of a node: its name as most programs write it, in
    /// the `targetNames` of the mesh, or its number.
    pub(super) fn track_names(&self, node: usize) -> impl Iterator<Item = String> {
        let document = self.player.document();
        let of_node = &document.nodes[node];
        let mesh = of_node.mesh.and_then(|mesh| document.meshes.get(mesh));
        let primitive = mesh.and_then(|mesh| mesh.primitives.first());
        let count = primitive.map_or(0, |primitive| primitive.targets.len());
        let names = mesh.map_or(Vec::new(), Mesh::target_names);
        let name = name(node, of_node);
        (0..count).map(move |target| match names.get(target) {
            Some(of_target) => format!("{name}, {of_target}"),
            None => format!("{name}{NUMBERED}{target}"),
        })
    }

    /// The transform of a joint in metres: that of its node, after what lies above.
    fn local(&self, source: &Source, own: Transform<f64>) -> Transform<f64> {
        let above = &source.above;
        let place = above
            .to_affine()
            .transform(own.translation().coordinates().into());
        Transform::from_parts(
            Vector::from(place.coordinates()) * self.metres_per_unit,
            above.rotor() * own.rotor(),
            above.scale.component_product(own.scale),
        )
    }
}

/// The factors of a node, the rotation in which it was bound, and its place unless it was bound
/// elsewhere by more than rounding. `longest` is the longest bone.
fn bound_rest(own: &Transform<f64>, bound: &Transform<f64>, longest: f64) -> Transform<f64> {
    /// Of the longest bone, what a place in single precision may differ by.
    const NEAR: f64 = 1e-5;
    let is_near = own.translation().distance(bound.translation()) <= NEAR * longest;
    let place = if is_near { own } else { bound }.translation();
    Transform::from_parts(place, bound.rotor(), own.scale)
}

/// The nodes that move and those above them, but for nodes at the top that stay and whose frames in
/// the world can belong to the nodes below.
fn joint_nodes(player: &Player, is_moving: &[bool], pose: &NodePose) -> Vec<bool> {
    let (parents, order) = (player.parents(), player.parents_before_children());
    let mut is_needed = is_moving.to_vec();
    for &node in order.iter().rev() {
        if let (true, Some(parent)) = (is_needed[node], parents[node]) {
            is_needed[parent] = true;
        }
    }
    let mut is_joint = is_needed;
    for &node in order {
        let is_at_top = parents[node].is_none_or(|parent| !is_joint[parent]);
        if is_at_top && !is_moving[node] && uniform_within(pose.world[node], UNIFORM).is_some() {
            is_joint[node] = false;
        }
    }
    is_joint
}

/// The name of a node, or its number.
fn name(index: usize, node: &Node) -> String {
    node.name.clone().unwrap_or_else(|| format!("node {index}"))
}
