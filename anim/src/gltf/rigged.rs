//! The joints of a document, and clips of them as its animation.

use ga_mesh::gltf::{
    Animation, Channel, Document, Interpolation, Keys, Node, Scene, Transform as NodeTransform,
};
use ga_runtime::cga3::{Motor, Point, Rotor};
use ga_runtime::geometry::Affine;
use ga_runtime::vga3::Vector;

use super::bind_pose::bind_pose;
use super::character::{all_joints, skeleton_of};
use super::{LocalFrame, Player};
use crate::clip::Clip;
use crate::file_error::MotionFileError;
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
    /// [`MotionFileError::Skeleton`] for another number of nodes than joints.
    pub fn of_nodes(
        document: Document,
        skeleton: Skeleton,
        nodes: Vec<usize>,
    ) -> Result<Self, MotionFileError> {
        let (expected, found) = (skeleton.len(), nodes.len());
        if expected != found {
            return Err(SkeletonError::PoseLength { expected, found }.into());
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
    /// them has the name already, the clip gets a number at the end of its name. With F₀ the frame
    /// of a node in the world at rest, G the total motion of its joint, and the same of its parent,
    /// its rotation is that of
    ///
    /// ```text
    /// (G_parent F₀_parent)⁻¹ G F₀.
    /// ```
    ///
    /// Its translation is the place of the joint in the frame above; below the roots it is only
    /// written where it differs from that of the node, as for a foot that hangs on the root.
    /// Factors stay as they are, so that skins and inverse bind matrices keep their meaning.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::Skeleton`] for a clip of another skeleton, [`MotionFileError::Uneven`],
    /// and [`MotionFileError::FrameNotFinite`].
    pub fn with_clip(&self, name: &str, clip: &Clip) -> Result<Document, MotionFileError> {
        let (expected, found) = (self.nodes.len(), clip.joint_count());
        if expected != found {
            return Err(SkeletonError::PoseLength { expected, found }.into());
        }
        let mut document = self.document.clone();
        let others = std::mem::take(&mut document.animations);
        let player = Player::new(&document)?;
        let own = player.pose(None, 0.0)?.locals;
        let rest = bind_pose(&player)?;
        let parents = player.parents().to_vec();
        let mut joints = Vec::with_capacity(self.nodes.len());
        for (joint, &node) in self.nodes.iter().enumerate() {
            joints.push(JointNode {
                local: parts(&rest.locals[node]).ok_or(MotionFileError::Uneven { node })?,
                above: match parents[node] {
                    Some(parent) => {
                        let world = rest.world[parent];
                        let rotor =
                            rotor_of(world).ok_or(MotionFileError::Uneven { node: parent })?;
                        let back = world
                            .inverse()
                            .ok_or(MotionFileError::Uneven { node: parent })?;
                        (rotor, back)
                    }
                    None => (Rotor::default(), Affine::default()),
                },
                parent: self.skeleton.joints()[joint].parent,
            });
        }
        /// Of the longest bone, what a place in single precision may differ by.
        const NEAR: f64 = 1e-5;
        let bones = joints
            .iter()
            .map(|joint| Vector::from(joint.local.translation).length());
        let longest = bones.fold(0.0, f64::max);
        let frames = 0..clip.frames().len();
        let times: Vec<f32> = frames
            .map(|k| (k as f64 * clip.frame_time()) as f32)
            .collect();
        let mut rotations = vec![Vec::with_capacity(times.len()); self.nodes.len()];
        let mut translations: Vec<Vec<[f64; 3]>> = vec![Vec::new(); self.nodes.len()];
        for pose in clip.frames() {
            let motions = pose.motions(&self.skeleton)?;
            for (joint, described) in joints.iter().enumerate() {
                rotations[joint].push(described.rotation(&motions, joint));
                let head = Point::from(self.skeleton.joints()[joint].head);
                let place = motions[joint].transform(head);
                let place = match described.parent {
                    Some(parent) => motions[parent].reverse().transform(place),
                    None => place,
                };
                translations[joint].push(described.above.1.transform(place).coordinates());
            }
        }
        let mut channels = Vec::new();
        for (joint, &node) in self.nodes.iter().enumerate() {
            let own = parts(&own[node]).ok_or(MotionFileError::Uneven { node })?;
            document.nodes[node].transform = own.to_node();
            let mut add = |keys| {
                channels.push(Channel {
                    node,
                    times: times.clone(),
                    interpolation: Interpolation::Linear,
                    keys,
                    extras: None,
                });
            };
            add(Keys::Rotation(continuous(&rotations[joint])));
            let place = Vector::from(own.translation);
            let differs = |other: &[f64; 3]| Vector::from(*other).distance(place) > NEAR * longest;
            if joints[joint].parent.is_none() || translations[joint].iter().any(differs) {
                let places = translations[joint].iter();
                add(Keys::Translation(
                    places.map(|place| place.map(|x| x as f32)).collect(),
                ));
            }
        }
        document.animations.push(Animation {
            name: Some(unused_name(name, &others)),
            channels,
            extras: None,
        });
        document.animations.extend(others);
        Ok(document)
    }
}

/// The name, or where an animation has it the first name with a number that none has.
fn unused_name(name: &str, animations: &[Animation]) -> String {
    let numbered = (2..).map(|number| format!("{name} {number}"));
    let mut names = std::iter::once(name.to_owned()).chain(numbered);
    let is_used = |name: &String| animations.iter().any(|it| it.name.as_ref() == Some(name));
    names.find(|name| !is_used(name)).unwrap_or_default()
}

/// A joint's node at rest.
struct JointNode {
    local: Parts,
    /// The rotation of the frame above in the world, and the way back into that frame.
    above: (Rotor<f64>, Affine<f64>),
    /// The parent's joint.
    parent: Option<usize>,
}

impl JointNode {
    /// The rotation of the node relative to its parent's frame after these motions.
    fn rotation(&self, motions: &[Motor<f64>], joint: usize) -> Rotor<f64> {
        let above = self
            .parent
            .map_or(Rotor::default(), |parent| motions[parent].rotor());
        let own = above.reverse() * motions[joint].rotor();
        let (axes, _) = self.above;
        axes.reverse() * own * axes * self.local.rotor
    }
}

/// A frame as translation, rotation and factors.
pub(super) struct Parts {
    pub(super) translation: [f64; 3],
    rotor: Rotor<f64>,
    pub(super) scale: [f64; 3],
}

impl Parts {
    pub(super) fn to_node(&self) -> NodeTransform {
        let single = |v: [f64; 3]| v.map(|x| x as f32);
        NodeTransform::Decomposed {
            translation: single(self.translation),
            rotation: quaternion(self.rotor),
            scale: single(self.scale),
        }
    }
}

pub(super) fn parts(frame: &LocalFrame) -> Option<Parts> {
    match frame {
        LocalFrame::Parts(parts) => Some(Parts {
            translation: parts.translation().coordinates(),
            rotor: parts.rotor(),
            scale: parts.scale.coordinates(),
        }),
        LocalFrame::Matrix(map) => Some(Parts {
            translation: map.translation,
            rotor: rotor_of(*map)?,
            scale: [map.determinant().cbrt(); 3],
        }),
    }
}

/// The rotation of a map that rotates and scales evenly.
fn rotor_of(map: Affine<f64>) -> Option<Rotor<f64>> {
    // Files write factors in single precision, some with few digits.
    const TOLERANCE: f64 = 1e-4;
    let factor = map.determinant().cbrt();
    if !(factor > 0.0 && factor.is_finite()) {
        return None;
    }
    let rows = map.linear.map(|row| row.map(|x| x / factor));
    let pairs = [0, 1, 2].map(|axis| {
        let mut from = [0.0; 3];
        from[axis] = 1.0;
        (from, rows.map(|row| row[axis]))
    });
    let rotor = Rotor::from_direction_pairs(&pairs).ok()?.motion;
    let found = rotor.to_matrix();
    let pairs = found.as_flattened().iter().zip(rows.as_flattened());
    pairs
        .map(|(a, b)| (a - b).abs())
        .all(|error| error <= TOLERANCE)
        .then_some(rotor)
}

fn quaternion(rotor: Rotor<f64>) -> [f32; 4] {
    let ([x, y, z], w) = rotor.to_quaternion();
    [x, y, z, w].map(|x| x as f32)
}

/// The quaternions of rotors, each with the sign that is nearer to the one before.
fn continuous(rotors: &[Rotor<f64>]) -> Vec<[f32; 4]> {
    let mut keys: Vec<[f32; 4]> = Vec::with_capacity(rotors.len());
    for &rotor in rotors {
        let key = quaternion(rotor);
        let along = keys.last().map_or(1.0, |before: &[f32; 4]| {
            before.iter().zip(key).map(|(a, b)| a * b).sum()
        });
        keys.push(if along < 0.0 { key.map(|x| -x) } else { key });
    }
    keys
}
