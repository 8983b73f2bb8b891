//! A motion in a file of any format.

use std::path::Path;

use ga_files::{ReadError, Reading};
use ga_mesh::gltf;

use super::contents::Contents;
use super::format::Format;
use super::sample::{self, Sample};
use crate::MotionFileError;
use crate::bvh::{self, BvhWarning};
use crate::clip::compressed::{self, CompressedClip};
use crate::gltf::Player;
use crate::recording::{GltfMotion, Recording};
use crate::unit::{LikelyUnit, likely_unit};

/// How a file is understood as a motion. What is left out is found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// The length of one unit of BVH or glTF in metres. By default that of BVH is the
    /// [likely one](likely_unit), and that of glTF a metre; a compressed clip is in metres.
    pub metres_per_unit: Option<f64>,
    /// The number of the animation in glTF, from 0.
    pub animation: usize,
    /// The frames per second at which an animation of glTF is recorded; where none are given,
    /// those of its keys, see [`GltfMotion::recording`]. The other formats have frames.
    pub rate: Option<f64>,
    /// Whether what deviates from the format of BVH is an error.
    pub reading: Reading,
}

/// A motion in a file of any format.
#[derive(Clone, Debug)]
pub struct MotionFile {
    contents: Contents,
    options: Options,
    metres_per_unit: f64,
    /// How the length of a unit was found, where neither the format nor the options say it.
    likely_unit: Option<LikelyUnit>,
}

impl MotionFile {
    /// Reads a file in the format that its name says.
    ///
    /// # Errors
    ///
    /// [`ReadError::Io`], or [`ReadError::Contents`] with [`MotionFileError::Ending`] or with what
    /// is wrong in the file.
    pub fn read(
        path: impl AsRef<Path>,
        options: Options,
    ) -> Result<Self, ReadError<MotionFileError>> {
        let path = path.as_ref();
        let contents = match Format::of_path(path)? {
            Format::Bvh => Contents::Bvh(bvh::read_as(path, options.reading)?),
            Format::Gltf => {
                let document = gltf::read(path);
                Contents::Gltf(Box::new(document.map_err(|error| error.map(Into::into))?))
            }
            Format::Clip => {
                let clip = CompressedClip::read(path);
                Contents::Clip(Box::new(clip.map_err(|error| error.map(Into::into))?))
            }
        };
        Ok(Self::new(contents, options))
    }

    /// These contents of a file.
    #[must_use]
    pub fn new(contents: Contents, options: Options) -> Self {
        let likely_unit = match (&contents, options.metres_per_unit) {
            (Contents::Bvh(motion), None) => Some(likely_unit(motion)),
            _ => None,
        };
        let found = likely_unit.map_or(1.0, |unit| unit.metres);
        let given = options.metres_per_unit;
        Self {
            metres_per_unit: match contents {
                Contents::Clip(_) => 1.0,
                _ => given.unwrap_or(found),
            },
            contents,
            options,
            likely_unit,
        }
    }

    /// What is in the file.
    #[must_use]
    pub fn contents(&self) -> &Contents {
        &self.contents
    }

    /// The length of one unit in metres.
    #[must_use]
    pub fn metres_per_unit(&self) -> f64 {
        self.metres_per_unit
    }

    /// How the length of a unit was found from the body in motion; `None` where the format or the
    /// options say it.
    #[must_use]
    pub fn likely_unit(&self) -> Option<LikelyUnit> {
        self.likely_unit
    }

    /// The number of the animation in glTF, from 0.
    #[must_use]
    pub fn animation(&self) -> usize {
        self.options.animation
    }

    /// What deviates from the format and was read nevertheless.
    #[must_use]
    pub fn warnings(&self) -> &[BvhWarning] {
        match &self.contents {
            Contents::Bvh(motion) => motion.warnings(),
            Contents::Gltf(_) | Contents::Clip(_) => &[],
        }
    }

    /// The motion frame by frame, in metres.
    ///
    /// # Errors
    ///
    /// Those of [`Recording::from_bvh`], [`Recording::from_gltf`] and
    /// [`Recording::from_compressed`].
    pub fn recording(&self) -> Result<Recording, MotionFileError> {
        self.recording_of_unit(self.metres_per_unit)
    }

    /// The motion frame by frame, in the unit of the file.
    ///
    /// # Errors
    ///
    /// As [`recording`](Self::recording).
    pub fn recording_in_units(&self) -> Result<Recording, MotionFileError> {
        self.recording_of_unit(1.0)
    }

    /// The motion at another number of frames per second: of glTF by its own curves, of the other
    /// formats between the frames of their [`recording`](Self::recording).
    ///
    /// # Errors
    ///
    /// Those of [`Recording::resampled`] and [`Recording::from_gltf`].
    pub fn resampled(
        &self,
        recording: &Recording,
        rate: f64,
    ) -> Result<Recording, MotionFileError> {
        match &self.contents {
            Contents::Gltf(document) => {
                let (animation, unit) = (self.options.animation, self.metres_per_unit);
                Recording::from_gltf(document, animation, unit, Some(rate))
            }
            _ => Ok(recording.resampled(rate)?),
        }
    }

    fn recording_of_unit(&self, metres_per_unit: f64) -> Result<Recording, MotionFileError> {
        let Options {
            animation, rate, ..
        } = self.options;
        match &self.contents {
            Contents::Bvh(motion) => Ok(Recording::from_bvh(motion, metres_per_unit)?),
            Contents::Gltf(document) => {
                Recording::from_gltf(document, animation, metres_per_unit, rate)
            }
            Contents::Clip(clip) => Ok(Recording::from_compressed(clip)?),
        }
    }

    /// Joints and tracks at times in seconds: of glTF by its own curves, of a compressed clip as it
    /// is decoded between frames, of BVH between frames as [`Recording::sample`] does.
    ///
    /// # Errors
    ///
    /// As [`recording`](Self::recording), and those of [`GltfMotion::model_maps`].
    pub fn samples(&self, times: &[f64]) -> Result<Vec<Sample>, MotionFileError> {
        match &self.contents {
            Contents::Bvh(_) => sample::of_recording(&self.recording()?, times),
            Contents::Gltf(document) => {
                let player = Player::new(document)?;
                sample::of_gltf(&self.gltf_motion(&player)?, times)
            }
            Contents::Clip(clip) => sample::of_clip(clip, times),
        }
    }

    /// How far a [`recording`](Self::recording) of this file is from it at its frames, in metres,
    /// for points within `shell` metres of the joints; see [`GltfMotion::deviation`]. It is 0 where
    /// the file itself has frames.
    ///
    /// # Errors
    ///
    /// Those of [`GltfMotion::new`] and [`GltfMotion::deviation`].
    pub fn deviation(&self, recording: &Recording, shell: f64) -> Result<f64, MotionFileError> {
        let Contents::Gltf(document) = &self.contents else {
            return Ok(0.0);
        };
        let player = Player::new(document)?;
        let motion = self.gltf_motion(&player)?;
        motion.deviation(recording, self.options.rate, shell)
    }

    /// The bounds within which the motion is compressed: those of a compressed clip, otherwise the
    /// usual ones.
    #[must_use]
    pub fn compression(&self) -> compressed::Options {
        match &self.contents {
            Contents::Clip(clip) => clip.options().clone(),
            Contents::Bvh(_) | Contents::Gltf(_) => compressed::Options::default(),
        }
    }

    /// How many vertices the primitives in the file have together; `None` where it is not glTF.
    #[must_use]
    pub fn vertex_count(&self) -> Option<u64> {
        let Contents::Gltf(document) = &self.contents else {
            return None;
        };
        let primitives = document.meshes.iter().flat_map(|mesh| &mesh.primitives);
        let counts = primitives.map(|primitive| primitive.positions.len() as u64);
        Some(counts.sum())
    }

    fn gltf_motion<'a>(&self, player: &'a Player<'a>) -> Result<GltfMotion<'a>, MotionFileError> {
        GltfMotion::new(player, self.options.animation, self.metres_per_unit)
    }
}
