//! Motions as files of any format.

use super::contents::Contents;
use super::file::MotionFile;
use super::format::Format;
use super::loss::Loss;
use crate::MotionFileError;
use crate::bvh::Bvh;
use crate::clip::compressed::{self, compress};
use crate::gltf::{Player, all_joints};
use crate::recording::{GltfMotion, Recording};

/// Which animation of a document a motion becomes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Animations {
    /// The one that was read, in its place.
    #[default]
    InPlace,
    /// A new one, which is the first: the others follow.
    First,
    /// A new one, which is the only one.
    Alone,
}

/// How a motion is written.
#[derive(Clone, Debug, Default)]
pub struct WriteOptions<'a> {
    /// The name of a new animation of glTF.
    pub name: &'a str,
    /// A file with a motion of the same joints, from which a file of the same format takes what a
    /// recording does not have: the nodes, meshes, skins and other animations of a document; the
    /// unit, channels, offsets and End Sites of BVH.
    pub like: Option<&'a MotionFile>,
    /// Which animation of a document [`like`](Self::like) it becomes.
    pub animations: Animations,
    /// The length of one unit of BVH in metres; by default that of [`like`](Self::like) where it is
    /// BVH, otherwise a metre. The other formats are in metres.
    pub metres_per_unit: Option<f64>,
    /// The bounds within which a clip is compressed.
    pub compression: compressed::Options,
}

/// A motion in the form of a file, and what of it is not there.
///
/// ```
/// use ga_anim::motion_file::{Contents, Format, WriteOptions, Written};
/// use ga_anim::recording::Recording;
///
/// let motion = ga_anim::bvh::decode(
///     b"HIERARCHY ROOT arm { OFFSET 0 0 0 CHANNELS 1 Zrotation
///         JOINT hand { OFFSET 20 0 0 CHANNELS 1 Xrotation } }
///       MOTION Frames: 2 Frame Time: 0.5
///       0 0
///       90 0",
/// )?;
/// let recording = Recording::from_bvh(&motion, 0.01)?;
/// let options = WriteOptions { name: "bend", ..WriteOptions::default() };
/// let written = Written::new(&recording, Format::Gltf, &options, |_, _| {})?;
/// let Contents::Gltf(document) = &written.contents else { return Err("glTF".into()) };
/// let again = Recording::from_gltf(document, 0, 1.0, None)?;
/// assert_eq!((again.frame_count(), again.joints()[1].name.as_str()), (2, "hand"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Written {
    /// What is in the file.
    pub contents: Contents,
    /// What is not.
    pub losses: Vec<Loss>,
    /// The length of one unit of the file in metres.
    pub metres_per_unit: f64,
}

impl Written {
    /// A recording as a file. `progress` is told of compression as by [`compress`].
    ///
    /// # Errors
    ///
    /// [`MotionFileError::Clip`] where the recording cannot be compressed within the bounds, and
    /// where `like` is a document, those of [`GltfMotion::with_recording`] and
    /// [`GltfMotion::with_first`].
    pub fn new(
        recording: &Recording,
        format: Format,
        options: &WriteOptions,
        progress: impl Fn(usize, usize) + Sync,
    ) -> Result<Self, MotionFileError> {
        let like = options.like;
        let mut losses = like.map_or(Vec::new(), |like| {
            beside_the_motion(like, format, options.animations)
        });
        let mut metres_per_unit = 1.0;
        let contents = match format {
            Format::Bvh => {
                let own = like.and_then(|like| match like.contents() {
                    Contents::Bvh(motion) => Some((motion, like.metres_per_unit())),
                    _ => None,
                });
                let unit = options.metres_per_unit.or(own.map(|(_, unit)| unit));
                metres_per_unit = unit.unwrap_or(1.0);
                let (motion, lost) = Bvh::from_recording(recording, metres_per_unit, own);
                losses.extend(lost);
                Contents::Bvh(motion)
            }
            Format::Gltf => {
                let own = like.and_then(|like| match like.contents() {
                    Contents::Gltf(document) => Some((like, document)),
                    _ => None,
                });
                let (document, lost) =
                    match own {
                        Some((like, document)) => {
                            let player = Player::new(document)?;
                            metres_per_unit = like.metres_per_unit();
                            let animations = options.animations;
                            if animations == Animations::InPlace {
                                GltfMotion::new(&player, like.animation(), metres_per_unit)?
                                    .with_recording(recording)?
                            } else {
                                let keeps = animations == Animations::First;
                                let joints = all_joints(document, &player);
                                GltfMotion::of_joints(&player, &joints, metres_per_unit)?
                                    .with_first(options.name, recording, keeps)?
                            }
                        }
                        None => recording.to_gltf(options.name),
                    };
                losses.extend(lost);
                Contents::Gltf(Box::new(document))
            }
            Format::Clip => {
                let clip = compress(recording, &options.compression, progress)?;
                Contents::Clip(Box::new(clip))
            }
        };
        Ok(Self {
            contents,
            losses,
            metres_per_unit,
        })
    }

    /// The bytes of the file; of glTF as GLB.
    ///
    /// # Errors
    ///
    /// [`MotionFileError::Document`].
    pub fn encode(&self) -> Result<Vec<u8>, MotionFileError> {
        match &self.contents {
            Contents::Bvh(motion) => Ok(motion.encode().into_bytes()),
            Contents::Gltf(document) => Ok(ga_mesh::gltf::encode(document)?),
            Contents::Clip(clip) => Ok(clip.as_bytes().to_vec()),
        }
    }
}

/// What a file has beside its motion that one of another format does not have.
fn beside_the_motion(file: &MotionFile, format: Format, animations: Animations) -> Vec<Loss> {
    let mut losses = Vec::new();
    match file.contents() {
        Contents::Gltf(document) if format != Format::Gltf => {
            let replaced = match animations {
                Animations::InPlace => 1,
                Animations::First => 0,
                Animations::Alone => document.animations.len(),
            };
            losses.extend(Loss::of_document(document, replaced));
        }
        Contents::Bvh(motion) if format != Format::Bvh => {
            let ends = motion.joints().iter();
            // An end at its joint says nothing.
            let is_end = |end: &[f64; 3]| *end != [0.0; 3];
            let joints = ends.filter(|joint| joint.end_site.as_ref().is_some_and(is_end));
            let joints = joints.count();
            if joints > 0 {
                losses.push(Loss::EndSites { joints });
            }
        }
        _ => {}
    }
    losses
}
