//! Skeletons in files, as targets of motions.

use super::soles::Soles;
use super::source::Source;
use crate::MotionFileError;
use crate::clip::Clip;
use crate::gltf::{Player, Rigged, character};
use crate::motion_file::{Contents, MotionFile};
use crate::recording::{GltfMotion, RecordedJoint, Recording};
use crate::skeleton::Skeleton;

/// A skeleton in a file with what it stands on. Its motions are written by
/// [`Written`](crate::motion_file::Written), with the file as
/// [`like`](crate::motion_file::WriteOptions::like) and as a
/// [new animation](crate::motion_file::Animations::First) of it.
///
/// # Examples
///
/// ```
/// use ga_anim::bvh;
/// use ga_anim::motion_file::{Contents, Format, MotionFile, Options, WriteOptions, Written};
/// use ga_anim::recording::Recording;
/// use ga_anim::retarget::Target;
///
/// let body = bvh::decode(
///     b"HIERARCHY ROOT arm { OFFSET 0 0 0 CHANNELS 1 Zrotation
///         JOINT hand { OFFSET 20 0 0 CHANNELS 1 Xrotation } }
///       MOTION Frames: 1 Frame Time: 0.01
///       90 0",
/// )?;
/// let clip = Recording::from_bvh(&body, 1.0)?.to_clip()?;
/// let options = Options { metres_per_unit: Some(0.01), ..Options::default() };
/// let target = Target::new(MotionFile::new(Contents::Bvh(body), options))?;
/// // Lengths are in the unit of the file, those of a recording in metres.
/// assert_eq!(target.skeleton().joints()[1].head, [20.0, 0.0, 0.0]);
/// let recording = target.recording(&clip)?;
/// let [x, ..] = recording.locals()[1].translation().coordinates();
/// assert!((x - 0.2).abs() < 1e-12);
/// let options = WriteOptions { like: Some(target.file()), ..WriteOptions::default() };
/// let written = Written::new(&recording, Format::Bvh, &options, |_, _| {})?;
/// let Contents::Bvh(motion) = &written.contents else { return Err("BVH".into()) };
/// assert_eq!(motion.joints()[1].offset, [20.0, 0.0, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Target {
    file: MotionFile,
    skeleton: Skeleton,
    /// The nodes that are the joints of a document.
    nodes: Vec<usize>,
    /// For a skeleton that stands at rest.
    soles: Option<Soles>,
    /// The motion of a compressed clip.
    recording: Option<Recording>,
}

impl Target {
    /// The skeleton of a file.
    ///
    /// That of BVH is as it is at rest, in the unit of the file, and that of a compressed clip in
    /// metres; their motions say how the axes of their joints are meant. The joints of glTF are
    /// those of all skins, or all nodes where there is none, in the pose in which the skins were
    /// bound; they stand on the lowest vertices where there is a skin, otherwise on the lowest
    /// bones.
    ///
    /// # Errors
    ///
    /// Those of [`Bvh::skeleton`](crate::bvh::Bvh::skeleton); of [`Rigged::new`], and
    /// [`MotionFileError::Skin`]; of [`Recording::from_compressed`] and [`Recording::to_skeleton`].
    pub fn new(file: MotionFile) -> Result<Self, MotionFileError> {
        let (mut nodes, mut soles, mut recording) = (Vec::new(), None, None);
        let skeleton = match file.contents() {
            Contents::Bvh(motion) => motion.skeleton()?,
            Contents::Gltf(document) => {
                let rigged = Rigged::new(document)?;
                nodes = rigged.nodes().to_vec();
                let skeleton = rigged.skeleton().clone();
                if let Ok(body) = character(document)
                    && body.skeleton == skeleton
                {
                    soles = Some(Soles::of_mesh(body.mesh.positions(), &body.weights)?);
                }
                skeleton
            }
            Contents::Clip(_) => {
                let motion = file.recording()?;
                let skeleton = motion.to_skeleton()?;
                recording = Some(motion);
                skeleton
            }
        };
        Ok(Self {
            file,
            skeleton,
            nodes,
            soles,
            recording,
        })
    }

    /// The file.
    #[must_use]
    pub fn file(&self) -> &MotionFile {
        &self.file
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
        match self.file.contents() {
            Contents::Bvh(motion) if motion.frame_count() > 0 => Some(motion),
            Contents::Clip(_) => self.recording.as_ref().map(|motion| motion as &dyn Source),
            _ => None,
        }
    }

    /// The length of one unit of the skeleton in metres.
    #[must_use]
    pub fn metres_per_unit(&self) -> f64 {
        self.file.metres_per_unit()
    }

    /// A motion of the skeleton with the axes that the joints have in the file, in metres.
    ///
    /// # Errors
    ///
    /// [`RecordingError`](crate::recording::RecordingError) for a clip of another skeleton, for a
    /// unit that is not positive, and where a frame that is scaled non-uniformly is above a joint.
    /// For glTF also [`MotionFileError::Shears`] and [`MotionFileError::NonUniformScale`].
    pub fn recording(&self, clip: &Clip) -> Result<Recording, MotionFileError> {
        let unit = self.metres_per_unit();
        let joints = match (self.file.contents(), &self.recording) {
            (Contents::Gltf(document), _) => {
                let player = Player::new(document)?;
                let motion = GltfMotion::of_joints(&player, &self.nodes, unit)?;
                return Ok(motion.recording_of_clip(&self.skeleton, &self.nodes, clip)?);
            }
            (_, Some(recording)) => recording.joints().to_vec(),
            (_, None) => RecordedJoint::of_skeleton(&self.skeleton, unit),
        };
        let of_skeleton: Vec<Option<usize>> = (0..joints.len()).map(Some).collect();
        let skeleton = (&self.skeleton, unit);
        let recording = Recording::of_joints(joints, &of_skeleton, skeleton, clip)?;
        Ok(recording.with_ends_of(&self.skeleton, unit))
    }
}
