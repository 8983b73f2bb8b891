//! The joints of a document, and clips of them as its animation.

use ga_mesh::gltf::{Document, Node, Scene, Transform as NodeTransform};

use super::Player;
use super::character::{all_joints, skeleton_of};
use crate::clip::Clip;
use crate::file_error::MotionFileError;
use crate::motion_file::Loss;
use crate::recording::GltfMotion;
use crate::skeleton::{Skeleton, SkeletonError};

/// The joints of a document as a skeleton, and the nodes that they are.
///
/// These are the joints of all skins, as of a [`character`](super::character); in a document
/// without skins they are all nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct Rigged {
    pub(super) document: Document,
    pub(super) skeleton: Skeleton,
    pub(super) nodes: Vec<usize>,
}

impl Rigged {
    /// Finds the joints of a document, in the pose in which its skins were bound; nodes without a
    /// skin as they stand without an animation.
    ///
    /// # Errors
    ///
    /// Those of [`Player::new`], [`MotionFileError::FrameNotFinite`] and
    /// [`MotionFileError::Skeleton`].
    pub fn new(document: &Document) -> Result<Self, MotionFileError> {
        let player = Player::new(document)?;
        let nodes = all_joints(document, &player);
        let skeleton = skeleton_of(document, &player, &nodes)??;
        Ok(Self {
            document: document.clone(),
            skeleton,
            nodes,
        })
    }

    /// A document with the nodes that are the joints of a skeleton, which may be known more exactly
    /// than nodes are.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::Skeleton`] for another number of nodes than joints, and
    /// [`MotionFileError::NoNode`] for a node that the document does not have.
    pub fn from_nodes(
        document: Document,
        skeleton: Skeleton,
        nodes: Vec<usize>,
    ) -> Result<Self, MotionFileError> {
        let (expected, found) = (skeleton.len(), nodes.len());
        if expected != found {
            return Err(SkeletonError::PoseLength { expected, found }.into());
        }
        let count = document.nodes.len();
        if let Some(&node) = nodes.iter().find(|&&node| node >= count) {
            return Err(MotionFileError::NoNode { node, count });
        }
        Ok(Self {
            document,
            skeleton,
            nodes,
        })
    }

    /// A document with a node for each joint of a skeleton and nothing else. A node stands at its
    /// joint, with the axes of the world.
    #[must_use]
    pub fn of_skeleton(skeleton: &Skeleton) -> Self {
        let joints = skeleton.joints();
        let node = |(index, joint): (usize, &crate::skeleton::Joint)| {
            let above = joint.parent.map_or([0.0; 3], |parent| joints[parent].head);
            Node {
                name: Some(joint.name.clone()),
                children: skeleton.children(index).collect(),
                transform: NodeTransform::Decomposed {
                    translation: [0, 1, 2].map(|k| (joint.head[k] - above[k]) as f32),
                    rotation: [0.0, 0.0, 0.0, 1.0],
                    scale: [1.0; 3],
                },
                ..Node::default()
            }
        };
        let roots = (0..joints.len()).filter(|&joint| joints[joint].parent.is_none());
        let document = Document {
            scene: Some(0),
            scenes: vec![Scene {
                nodes: roots.collect(),
                ..Scene::default()
            }],
            nodes: joints.iter().enumerate().map(node).collect(),
            ..Document::default()
        };
        Self {
            document,
            skeleton: skeleton.clone(),
            nodes: (0..joints.len()).collect(),
        }
    }

    /// The joints at rest, in the world.
    #[must_use]
    pub fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    /// The node of each joint.
    #[must_use]
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// The document with a clip as its first animation. Its own animations follow; where one of
    /// them has the name already, the clip gets a number at the end of its name. The result also
    /// says what of the clip is not in the document.
    ///
    /// With A the frame of the node above a joint as its skin was bound, which has the rotation R,
    /// L the joint's own motion and h its place at rest, the transform T(t) r s of its node becomes
    ///
    /// ```text
    /// T(t + A⁻¹ (L h − h)) (~R L R) r s,
    /// ```
    ///
    /// where L is after the motion of the whole for a root. A node has keys for what it does not
    /// have by itself. Factors stay as they are, so that skins and inverse bind matrices keep their
    /// meaning.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::Shears`] and [`MotionFileError::NonUniformScale`], and
    /// [`RecordingError`](crate::recording::RecordingError) for a clip of another skeleton and for
    /// frames above a joint that are scaled non-uniformly.
    pub fn with_clip(
        &self,
        name: &str,
        clip: &Clip,
    ) -> Result<(Document, Vec<Loss>), MotionFileError> {
        let player = Player::new(&self.document)?;
        let motion = GltfMotion::of_joints(&player, &self.nodes, 1.0)?;
        let recording = motion.recording_of_clip(&self.skeleton, &self.nodes, clip)?;
        motion.with_first(name, &recording, true)
    }
}
