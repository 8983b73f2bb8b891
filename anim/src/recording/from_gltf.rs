use ga_mesh::gltf::{Animation, Document, Keys, Node};
use ga_runtime::cga3::Rotor;
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;

use super::{RecordedJoint, Recording, ScalarTrack};
use crate::clip::compressed::ShellError;
use crate::file_error::MotionFileError;
use crate::gltf::{LocalFrame, NodePose, Player};
use crate::recording::RecordingError;
use crate::transform::Transform;

/// An animation of a glTF document as the motion of joints.
///
/// The joints are the joints of all skins, the nodes that the animation moves, and the nodes above
/// them. A node that stays where it is, with all nodes above it, is not a joint where it only
/// moves, rotates and scales evenly: its frame then belongs to the joints below it.
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
    pub(super) animation: usize,
    pub(super) metres_per_unit: f64,
    pub(super) joints: Vec<RecordedJoint>,
    pub(super) sources: Vec<Source>,
    /// The nodes whose morph targets the animation moves.
    pub(super) morphed: Vec<usize>,
}

/// Where the transform of a joint comes from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Source {
    pub(super) node: usize,
    /// The transform at rest, without what lies above.
    rest: Transform<f64>,
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
        if !metres_per_unit.is_finite() || metres_per_unit <= 0.0 {
            return Err(RecordingError::Unit(metres_per_unit).into());
        }
        let document = player.document();
        let Some(played) = document.animations.get(animation) else {
            let count = document.animations.len();
            return Err(MotionFileError::NoAnimation { animation, count });
        };
        let pose = player.pose(None, 0.0)?;
        let is_moving = moving_nodes(document, played);
        let parents = player.parents();
        let is_joint = joint_nodes(player, &is_moving, &pose);
        let mut motion = Self {
            player,
            animation,
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
                Some(parent) if !is_joint[parent] => even(pose.world[parent]).unwrap_or_default(),
                _ => Transform::default(),
            };
            let rest = parts(&pose.locals[node]).ok_or(MotionFileError::Shears { node })?;
            let source = Source { node, rest, above };
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
        let weights = played.channels.iter();
        let weights = weights.filter(|channel| matches!(channel.keys, Keys::Weights(_)));
        motion.morphed = weights.map(|channel| channel.node).collect();
        Ok(motion)
    }

    /// The joints, parents before children. A joint's transform at rest is that of its node.
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
        let pose = self.player.pose(Some(self.animation), time)?;
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
        let pose = self.player.pose(Some(self.animation), time)?;
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
        let keys = key_times(&self.player.document().animations[self.animation]);
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
            self.player
                .pose_into(Some(self.animation), time, &mut pose)?;
            for source in &self.sources {
                let own = match pose.locals[source.node] {
                    LocalFrame::Parts(parts) => parts,
                    LocalFrame::Matrix(_) => source.rest,
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
        let keys = key_times(&self.player.document().animations[self.animation]);
        let grid = Grid::new(rate, &keys)?;
        let mut error = ShellError::new(recording, shell);
        for frame in 0..recording.frame_count() {
            error.compare(frame, &self.model_maps(grid.time(frame, &keys))?);
        }
        Ok(error.greatest())
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

    /// The name of the track of each morph target of a node.
    pub(super) fn track_names(&self, node: usize) -> impl Iterator<Item = String> {
        let document = self.player.document();
        let of_node = &document.nodes[node];
        let mesh = of_node.mesh.and_then(|mesh| document.meshes.get(mesh));
        let primitive = mesh.and_then(|mesh| mesh.primitives.first());
        let count = primitive.map_or(0, |primitive| primitive.targets.len());
        let name = name(node, of_node);
        (0..count).map(move |target| format!("{name}, morph target {target}"))
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

/// Times of frames.
struct Grid {
    step: f64,
    /// How many steps there are from 0 to the last frame.
    steps: f64,
}

impl Grid {
    /// The step where there is nothing to choose it by.
    const DEFAULT_STEP: f64 = 1.0 / 30.0;
    const SHORTEST_STEP: f64 = 1.0 / 240.0;

    /// Frames at a rate, or those that the times of keys suggest.
    fn new(rate: Option<f64>, keys: &[f64]) -> Result<Self, MotionFileError> {
        let last = keys.last().copied().unwrap_or(0.0);
        match rate {
            Some(rate) if rate > 0.0 && rate.is_finite() => Ok(Self::of_step(rate.recip(), last)),
            Some(rate) => Err(MotionFileError::Rate(rate)),
            None => Ok(Self::of_keys(keys)),
        }
    }

    /// Frames at a given step, of which the last is at or after the last key.
    fn of_step(step: f64, last: f64) -> Self {
        // A key that is beyond a frame by rounding alone needs no other frame.
        let steps = (last / step - 1e-4).ceil().max(0.0);
        Self { step, steps }
    }

    fn of_keys(keys: &[f64]) -> Self {
        let last = keys.last().copied().unwrap_or(0.0);
        // From one key to the next, the first interval begins at 0.
        let times = || std::iter::once(0.0).chain(keys.iter().copied());
        let intervals = times().zip(times().skip(1)).map(|(a, b)| b - a);
        let shortest = intervals.filter(|&x| x > 0.0).fold(f64::INFINITY, f64::min);
        if shortest == f64::INFINITY {
            return Self::of_step(Self::DEFAULT_STEP, last);
        }
        let of_steps = |steps: f64| Self {
            step: last / steps,
            steps,
        };
        // One key in each frame, however much the shortest interval is rounded in a long motion.
        let later = || keys.iter().copied().filter(|&key| key > 0.0);
        let whole = of_steps(later().count() as f64);
        let is_next = |(k, key): (usize, f64)| (key / whole.step).round() == (k + 1) as f64;
        if later().all(|key| whole.meets(key)) && later().enumerate().all(is_next) {
            return whole;
        }
        let uniform = of_steps((last / shortest).round());
        let steps = uniform.steps;
        // A step shorter than any film's must not come from a few keys that happen to be close.
        let is_warranted = uniform.step >= Self::SHORTEST_STEP || steps <= 2.0 * keys.len() as f64;
        if is_warranted && keys.iter().all(|&key| uniform.meets(key)) {
            return uniform;
        }
        Self::of_step(shortest.max(Self::SHORTEST_STEP), last)
    }

    /// Whether a frame is at a key, up to the rounding of a sum of times in single precision.
    fn meets(&self, key: f64) -> bool {
        let nearest = (key / self.step).round() * self.step;
        (key - nearest).abs() <= rounding(key).max(1e-3 * self.step)
    }

    /// The time of a frame; that of the key there is, where it differs by rounding alone.
    fn time(&self, frame: usize, keys: &[f64]) -> f64 {
        let time = frame as f64 * self.step;
        let after = keys.partition_point(|&key| key < time);
        let near = [after.wrapping_sub(1), after].map(|key| keys.get(key));
        let is_here = |key: &&f64| (*key - time).abs() <= rounding(**key);
        near.into_iter()
            .flatten()
            .find(is_here)
            .copied()
            .unwrap_or(time)
    }
}

/// The rounding of a sum of times in single precision.
fn rounding(time: f64) -> f64 {
    4.0 * f64::from(f32::EPSILON) * time
}

/// The times of all keys in rising order.
fn key_times(animation: &Animation) -> Vec<f64> {
    let channels = animation.channels.iter();
    let times = channels.flat_map(|channel| channel.times.iter().copied());
    let mut times: Vec<f64> = times.map(f64::from).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// The joints of skins and the nodes whose frames the animation moves.
fn moving_nodes(document: &Document, animation: &Animation) -> Vec<bool> {
    let mut is_moving = vec![false; document.nodes.len()];
    let joints = document.skins.iter().flat_map(|skin| &skin.joints);
    joints.for_each(|&node| is_moving[node] = true);
    for channel in &animation.channels {
        is_moving[channel.node] |= !matches!(channel.keys, Keys::Weights(_));
    }
    is_moving
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
        if is_at_top && !is_moving[node] && even(pose.world[node]).is_some() {
            is_joint[node] = false;
        }
    }
    is_joint
}

/// The transform of a map that translates, rotates and scales evenly.
fn even(map: Affine<f64>) -> Option<Transform<f64>> {
    // A deviation here would be in every frame of every joint below.
    const TOLERANCE: f64 = 1e-6;
    let factor = map.determinant().cbrt();
    let factors = Vector::new(factor, factor, factor);
    let transform = || with_factors(map, factors, TOLERANCE);
    // A mirrored map has no rotation.
    (factor > 0.0).then(transform).flatten()
}

/// A local frame as translation, rotation and factors; `None` for a matrix that has none.
fn parts(frame: &LocalFrame) -> Option<Transform<f64>> {
    // Files write matrices in single precision, some with few digits.
    const TOLERANCE: f64 = 1e-5;
    let map = match frame {
        LocalFrame::Parts(parts) => return Some(*parts),
        LocalFrame::Matrix(map) => *map,
    };
    let column = |column: usize| Vector::from(map.linear.map(|row| row[column]));
    let mut factors = [0, 1, 2].map(|axis| column(axis).length());
    if map.determinant() < 0.0 {
        factors[0] = -factors[0];
    }
    with_factors(map, factors.into(), TOLERANCE)
}

/// The transform that a map is, with these factors: L = R diag(s), up to a part of the largest.
fn with_factors(map: Affine<f64>, factors: Vector<f64>, tolerance: f64) -> Option<Transform<f64>> {
    let pairs = [0, 1, 2].map(|axis| {
        let mut from = [0.0; 3];
        from[axis] = factors[axis].signum();
        (from, map.linear.map(|row| row[axis]))
    });
    let rotor = Rotor::from_direction_pairs(&pairs).ok()?.motion;
    let transform = Transform::from_parts(map.translation.into(), rotor, factors);
    let found = transform.to_affine().linear;
    let numbers = found.as_flattened().iter().zip(map.linear.as_flattened());
    let error = numbers.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let size = factors.abs().coordinates().into_iter().fold(0.0, f64::max);
    (error <= tolerance * size).then_some(transform)
}

/// The name of a node, or its number.
fn name(index: usize, node: &Node) -> String {
    node.name.clone().unwrap_or_else(|| format!("node {index}"))
}
