//! Skeletons in files, as targets of motions that are written in the form of these files.

use ga_mesh::gltf::{self, Document};

use super::soles::Soles;
use super::source::Source;
use crate::MotionFileError;
use crate::bvh::Bvh;
use crate::clip::Clip;
use crate::clip::compressed;
use crate::gltf::{Rigged, character};
use crate::motion_file::Format;
use crate::recording::Recording;
use crate::skeleton::{Skeleton, SkeletonError};

/// A skeleton in a file with what it stands on, and how motions of it are written.
///
/// # Examples
///
/// ```
/// use ga_anim::bvh;
/// use ga_anim::retarget::Target;
///
/// let body = bvh::decode(
///     b"HIERARCHY ROOT arm { OFFSET 0 0 0 CHANNELS 1 Zrotation
///         JOINT hand { OFFSET 20 0 0 CHANNELS 1 Xrotation } }
///       MOTION Frames: 1 Frame Time: 0.01
///       90 0",
/// )?;
/// let clip = ga_anim::recording::Recording::from_bvh(&body, 1.0)?.to_clip()?;
/// let target = Target::from_bvh(body, 0.01)?;
/// // Lengths are in the unit of the file, those of a recording in metres.
/// assert_eq!(target.skeleton().joints()[1].head, [20.0, 0.0, 0.0]);
/// assert_eq!(target.to_bvh(&clip)?.joints()[1].offset, [20.0, 0.0, 0.0]);
/// let recording = target.to_recording(&clip)?;
/// let [x, ..] = recording.locals()[1].translation().coordinates();
/// assert!((x - 0.2).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Target {
    skeleton: Skeleton,
    /// For a skeleton that stands at rest.
    soles: Option<Soles>,
    metres_per_unit: f64,
    origin: Origin,
}

/// What the skeleton was made of.
#[derive(Clone, Debug)]
enum Origin {
    Bvh(Bvh),
    Gltf(Box<Rigged>),
}

impl Target {
    /// The skeleton of a BVH file at rest, in the unit of the file, which is `metres_per_unit`
    /// long. Its motion says how
    /// the axes of its joints are meant.
    ///
    /// # Errors
    ///
    /// Those of [`Bvh::skeleton`].
    pub fn from_bvh(motion: Bvh, metres_per_unit: f64) -> Result<Self, SkeletonError> {
        let skeleton = motion.skeleton()?;
        Ok(Self {
            soles: None,
            skeleton,
            metres_per_unit,
            origin: Origin::Bvh(motion),
        })
    }

    /// The joints of a glTF document in the pose in which its skins were bound, in metres. They
    /// stand on the lowest vertices where there is a skin, otherwise on the lowest bones.
    ///
    /// # Errors
    ///
    /// Those of [`Rigged::new`], and [`MotionFileError::Skin`].
    pub fn from_gltf(document: &Document) -> Result<Self, MotionFileError> {
        let rigged = Rigged::new(document)?;
        let skeleton = rigged.skeleton().clone();
        let soles = match character(document) {
            Ok(body) if body.skeleton == skeleton => {
                Some(Soles::of_mesh(body.mesh.positions(), &body.weights)?)
            }
            _ => None,
        };
        Ok(Self {
            skeleton,
            soles,
            metres_per_unit: 1.0,
            origin: Origin::Gltf(Box::new(rigged)),
        })
    }

    /// The skeleton at rest.
    #[must_use]
    pub fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    /// What it stands on; `None` where only its bones say it.
    #[must_use]
    pub fn soles(&self) -> Option<&Soles> {
        self.soles.as_ref()
    }

    /// The motion of the skeleton in its file, where that is a recording.
    #[must_use]
    pub fn motion(&self) -> Option<&dyn Source> {
        match &self.origin {
            Origin::Bvh(motion) if motion.frame_count() > 0 => Some(motion),
            _ => None,
        }
    }

    /// The length of one unit of the skeleton in metres.
    #[must_use]
    pub fn metres_per_unit(&self) -> f64 {
        self.metres_per_unit
    }

    /// A motion of the skeleton as BVH, in the unit of the skeleton, with the channels of a BVH
    /// file that it was made of.
    ///
    /// # Errors
    ///
    /// Those of [`Bvh::with_clip`] and [`Bvh::from_clip`].
    pub fn to_bvh(&self, clip: &Clip) -> Result<Bvh, MotionFileError> {
        match &self.origin {
            Origin::Bvh(motion) => motion.with_clip(&self.skeleton, clip),
            Origin::Gltf(_) => Bvh::from_clip(&self.skeleton, clip),
        }
    }

    /// A motion of the skeleton as glTF, in metres, with all that a document has that it was made
    /// of. The motion is its first animation and has this name, or one with a number where another
    /// animation has it.
    ///
    /// # Errors
    ///
    /// Those of [`Rigged::with_clip`], and of [`to_recording`](Self::to_recording).
    pub fn to_gltf(&self, name: &str, clip: &Clip) -> Result<Document, MotionFileError> {
        match &self.origin {
            Origin::Bvh(_) => {
                let recording = self.to_recording(clip)?;
                let rigged = Rigged::of_skeleton(&recording.to_skeleton()?);
                rigged.with_clip(name, &recording.to_clip()?)
            }
            Origin::Gltf(rigged) => rigged.with_clip(name, clip),
        }
    }

    /// The bytes of a file of a motion: BVH as of [`to_bvh`](Self::to_bvh), GLB as of
    /// [`to_gltf`](Self::to_gltf), or the [`to_recording`](Self::to_recording) as a clip that is
    /// compressed within these bounds, of which `progress` is told as by
    /// [`compress`](compressed::compress).
    ///
    /// # Errors
    ///
    /// Those of these functions, and [`MotionFileError::Document`] or [`MotionFileError::Clip`]
    /// where the motion does not fit the format.
    pub fn encode(
        &self,
        format: Format,
        name: &str,
        clip: &Clip,
        compression: &compressed::Options,
        progress: impl Fn(usize, usize) + Sync,
    ) -> Result<Vec<u8>, MotionFileError> {
        match format {
            Format::Bvh => Ok(self.to_bvh(clip)?.encode().into_bytes()),
            Format::Gltf => Ok(gltf::encode(&self.to_gltf(name, clip)?)?),
            Format::Clip => {
                let recording = self.to_recording(clip)?;
                let compressed = compressed::compress(&recording, compression, progress)?;
                Ok(compressed.as_bytes().to_vec())
            }
        }
    }

    /// A motion of the skeleton with the axes of the joints in its file, in metres.
    ///
    /// # Errors
    ///
    /// Those of [`to_bvh`](Self::to_bvh) and [`to_gltf`](Self::to_gltf), and
    /// [`MotionFileError::Recording`].
    pub fn to_recording(&self, clip: &Clip) -> Result<Recording, MotionFileError> {
        match &self.origin {
            Origin::Bvh(_) => {
                let motion = self.to_bvh(clip)?;
                Ok(Recording::from_bvh(&motion, self.metres_per_unit)?)
            }
            Origin::Gltf(rigged) => {
                let document = rigged.with_clip("", clip)?;
                Recording::from_gltf(&document, 0, self.metres_per_unit, None)
            }
        }
    }
}
