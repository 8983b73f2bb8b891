use ga_mesh::gltf::{Animation, Channel, Document, Element, Keys, Node};
use ga_runtime::cga3::Rotor;
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;

use super::sampler;
use crate::file_error::MotionFileError;
use crate::transform::Transform;

/// Evaluates the animations of a document: the frames of its nodes and the weights of its morph
/// targets at a time.
///
/// # Examples
///
/// A node goes 4 m along x in 2 s.
///
/// ```
/// use ga_anim::gltf::Player;
/// use ga_mesh::gltf::{Animation, Channel, Document, Interpolation, Keys, Node};
///
/// let go = Channel {
///     node: 0,
///     times: vec![0.0, 2.0],
///     interpolation: Interpolation::Linear,
///     keys: Keys::Translation(vec![[0.0; 3], [4.0, 0.0, 0.0]]),
///     extras: None,
/// };
/// let document = Document {
///     nodes: vec![Node::default()],
///     animations: vec![Animation { channels: vec![go], ..Animation::default() }],
///     ..Document::default()
/// };
/// let player = Player::new(&document)?;
/// let pose = player.pose(Some(0), 0.5)?;
/// assert_eq!(pose.world[0].translation, [1.0, 0.0, 0.0]);
/// let at_rest = player.pose(None, 0.0)?;
/// assert_eq!(at_rest.world[0].translation, [0.0; 3]);
/// # Ok::<(), ga_anim::MotionFileError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Player<'a> {
    document: &'a Document,
    parents: Vec<Option<usize>>,
    /// All nodes, each after its parent.
    order: Vec<usize>,
    /// What every evaluation begins with.
    rest: NodePose,
}

/// The frames of all nodes of a document at one time, and the weights of their morph targets.
#[derive(Clone, Debug, PartialEq)]
pub struct NodePose {
    /// For each node its frame relative to its parent's.
    pub locals: Vec<LocalFrame>,
    /// For each node its frame in the world. This is an affine map, since factors along axes and
    /// rotations together shear.
    pub world: Vec<Affine<f64>>,
    weights: Vec<f64>,
    /// Where in `weights` those of each node begin, and the end of the last.
    offsets: Vec<usize>,
}

/// The frame of a node relative to its parent's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LocalFrame {
    /// A translation after a rotation after factors along the axes.
    Parts(Transform<f64>),
    /// The matrix of the file. An animation does not change it.
    Matrix(Affine<f64>),
}

impl LocalFrame {
    /// The frame as an affine map.
    #[must_use]
    pub fn to_affine(&self) -> Affine<f64> {
        match self {
            Self::Parts(parts) => parts.to_affine(),
            Self::Matrix(matrix) => *matrix,
        }
    }
}

impl NodePose {
    /// The weights of the morph targets of a node's mesh; none for a node that does not exist.
    #[must_use]
    pub fn weights(&self, node: usize) -> &[f64] {
        match self.offsets.get(node..node + 2) {
            Some(&[start, end]) => &self.weights[start..end],
            _ => &[],
        }
    }
}

impl<'a> Player<'a> {
    /// Checks the document and prepares its evaluation.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::Document`] where the document is not valid and
    /// [`MotionFileError::AnimatedMatrix`] where an animation moves a node that has a matrix.
    pub fn new(document: &'a Document) -> Result<Self, MotionFileError> {
        document.validate()?;
        for (index, animation) in document.animations.iter().enumerate() {
            for (number, channel) in animation.channels.iter().enumerate() {
                let is_frame = !matches!(channel.keys, Keys::Weights(_));
                let frame = &document.nodes[channel.node].transform;
                if is_frame && matches!(frame, ga_mesh::gltf::Transform::Matrix(_)) {
                    let (element, node) = (element(index, number), channel.node);
                    return Err(MotionFileError::AnimatedMatrix { element, node });
                }
            }
        }
        let mut rest = NodePose {
            locals: document.nodes.iter().map(local).collect(),
            world: vec![Affine::default(); document.nodes.len()],
            weights: Vec::new(),
            offsets: vec![0],
        };
        for node in &document.nodes {
            rest.weights.extend(morph_weights(document, node));
            rest.offsets.push(rest.weights.len());
        }
        Ok(Self {
            document,
            parents: document.parents()?,
            order: document.parents_before_children()?,
            rest,
        })
    }

    /// The document.
    #[must_use]
    pub fn document(&self) -> &'a Document {
        self.document
    }

    /// The parent of each node.
    #[must_use]
    pub fn parents(&self) -> &[Option<usize>] {
        &self.parents
    }

    /// All nodes, each after its parent.
    #[must_use]
    pub fn parents_before_children(&self) -> &[usize] {
        &self.order
    }

    /// The pose at a time in seconds of an animation, or that of the nodes without one.
    ///
    /// Before the first key of a channel its value is that of the first, after the last that of
    /// the last. What no channel moves stays as the node has it.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::NoAnimation`], [`MotionFileError::Time`], [`MotionFileError::NoRotation`]
    /// and [`MotionFileError::FrameNotFinite`].
    pub fn pose(&self, animation: Option<usize>, time: f64) -> Result<NodePose, MotionFileError> {
        let mut pose = self.rest.clone();
        self.pose_into(animation, time, &mut pose)?;
        Ok(pose)
    }

    /// As [`Player::pose`], into a pose that an earlier call for the same document has returned, so
    /// that nothing is allocated. After an error the pose is not to be used.
    ///
    /// # Errors
    ///
    /// As [`Player::pose`].
    pub fn pose_into(
        &self,
        animation: Option<usize>,
        time: f64,
        pose: &mut NodePose,
    ) -> Result<(), MotionFileError> {
        pose.clone_from(&self.rest);
        if time.is_nan() {
            return Err(MotionFileError::Time(time));
        }
        if let Some(index) = animation {
            let count = self.document.animations.len();
            let animation = self.document.animations.get(index);
            let animation = animation.ok_or(MotionFileError::NoAnimation {
                animation: index,
                count,
            })?;
            self.move_nodes(index, animation, time, pose)?;
        }
        for &node in &self.order {
            let local = pose.locals[node].to_affine();
            pose.world[node] = match self.parents[node] {
                Some(parent) => pose.world[parent] * local,
                None => local,
            };
            if !is_finite(pose.world[node]) {
                let seconds = time;
                return Err(MotionFileError::FrameNotFinite { node, seconds });
            }
        }
        Ok(())
    }

    fn move_nodes(
        &self,
        index: usize,
        animation: &Animation,
        time: f64,
        pose: &mut NodePose,
    ) -> Result<(), MotionFileError> {
        for (number, channel) in animation.channels.iter().enumerate() {
            if let Keys::Weights(keys) = &channel.keys {
                let weights = pose.offsets[channel.node]..pose.offsets[channel.node + 1];
                sampler::weights(channel, keys, time, &mut pose.weights[weights]);
            } else if let LocalFrame::Parts(parts) = &mut pose.locals[channel.node] {
                *parts =
                    moved(*parts, channel, time).ok_or_else(|| MotionFileError::NoRotation {
                        element: element(index, number),
                        seconds: time,
                    })?;
            }
        }
        Ok(())
    }
}

/// The frame with one of its parts replaced by that of a channel; `None` where a rotation is zero.
fn moved(parts: Transform<f64>, channel: &Channel, time: f64) -> Option<Transform<f64>> {
    let (translation, rotor, scale) = (parts.translation(), parts.rotor(), parts.scale);
    Some(match &channel.keys {
        Keys::Translation(keys) => {
            let translation = sampler::vector(channel, keys, time);
            Transform::from_parts(translation, rotor, scale)
        }
        Keys::Rotation(keys) => {
            let rotor = sampler::rotation(channel, keys, time)?;
            Transform::from_parts(translation, rotor, scale)
        }
        Keys::Scale(keys) => {
            let scale = sampler::vector(channel, keys, time);
            Transform { scale, ..parts }
        }
        Keys::Weights(_) => parts,
    })
}

/// The frame of a node as the file has it. A document that is valid has no zero rotation.
fn local(node: &Node) -> LocalFrame {
    match &node.transform {
        ga_mesh::gltf::Transform::Decomposed {
            translation,
            rotation,
            scale,
        } => {
            let rotor: Option<Rotor<f64>> = Rotor::normalize(sampler::quaternion(*rotation));
            let [translation, scale] = [translation, scale].map(|v| Vector::from(v.map(f64::from)));
            let rotor = rotor.unwrap_or_default();
            LocalFrame::Parts(Transform::from_parts(translation, rotor, scale))
        }
        matrix => {
            let rows = matrix.to_matrix();
            let linear = rows.map(|[x, y, z, _]| [x, y, z]);
            LocalFrame::Matrix(Affine::new(linear, rows.map(|row| row[3])))
        }
    }
}

/// The weights of the morph targets of a node's mesh without an animation: those of the node, else
/// those of the mesh, else zero.
fn morph_weights(document: &Document, node: &Node) -> Vec<f64> {
    let Some(mesh) = node.mesh.map(|mesh| &document.meshes[mesh]) else {
        return Vec::new();
    };
    let targets = mesh.primitives.first().map_or(0, |p| p.targets.len());
    let weights = node.weights.as_ref().unwrap_or(&mesh.weights);
    let mut weights: Vec<f64> = weights.iter().copied().map(f64::from).collect();
    weights.resize(targets, 0.0);
    weights
}

fn element(animation: usize, channel: usize) -> Element {
    Element::Channel { animation, channel }
}

pub(super) fn is_finite(map: Affine<f64>) -> bool {
    let numbers = map.linear.as_flattened().iter().chain(&map.translation);
    numbers.copied().all(f64::is_finite)
}
