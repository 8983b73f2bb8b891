//! Motions from files of every kind.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};
use ga_anim::clip::compressed::{CompressedClip, Options};
use ga_anim::gltf::Player;
use ga_anim::recording::{GltfMotion, Recording};
use ga_mesh::gltf::{self, Document};

use crate::format::Format;
use crate::frame::Warning;
use crate::motion_file;

/// A motion in a file, and how to read it.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct MotionArguments {
    /// The motion.
    #[arg(value_name = "MOTION")]
    motion: PathBuf,
    /// The length of one unit of the motion in metres [default: 1]. A compressed clip is in metres.
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    metres_per_unit: Option<f64>,
    /// The number of the animation in a glTF file, from 0 [default: 0].
    #[arg(long, value_name = "N")]
    animation: Option<usize>,
    /// Frames per second at which a glTF animation is recorded; by default those of its keys.
    #[arg(long, value_name = "HZ", allow_negative_numbers = true)]
    rate: Option<f64>,
}

/// The kind of a file by the ending of its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Bvh,
    Gltf,
    Clip,
}

impl Kind {
    pub(super) fn of(motion: &Path) -> Result<Self> {
        let formats = [Format::Bvh, Format::Glb, Format::Gltf, Format::Clip];
        match Format::of(motion, &formats) {
            Some(Format::Bvh) => Ok(Self::Bvh),
            Some(Format::Glb | Format::Gltf) => Ok(Self::Gltf),
            Some(Format::Clip) => Ok(Self::Clip),
            _ => bail!(
                "{}: a motion is a file of the kind .bvh, .glb, .gltf or .clip",
                motion.display()
            ),
        }
    }
}

impl MotionArguments {
    pub(super) fn new(
        motion: &Path,
        metres_per_unit: Option<f64>,
        animation: Option<usize>,
    ) -> Self {
        Self {
            motion: motion.to_owned(),
            metres_per_unit,
            animation,
            rate: None,
        }
    }

    /// With a rate at which an animation of glTF is recorded. Other motions have their own.
    pub(super) fn recorded_at(self, rate: f64) -> Result<Self> {
        let rate = (self.kind()? == Kind::Gltf).then_some(rate);
        Ok(Self { rate, ..self })
    }

    pub(super) fn path(&self) -> &Path {
        &self.motion
    }

    /// The file as messages name it.
    pub(super) fn file(&self) -> String {
        self.motion.display().to_string()
    }

    pub(super) fn kind(&self) -> Result<Kind> {
        Kind::of(&self.motion)
    }

    /// The length of one unit in metres, where it is given.
    pub(super) fn given_unit(&self) -> Option<f64> {
        self.metres_per_unit
    }

    /// Fails where an option is given that this kind of file does not have.
    fn check_options(&self) -> Result<()> {
        let kind = self.kind()?;
        let options = [
            (
                "--metres-per-unit",
                self.metres_per_unit.is_some(),
                kind != Kind::Clip,
            ),
            ("--animation", self.animation.is_some(), kind == Kind::Gltf),
            ("--rate", self.rate.is_some(), kind == Kind::Gltf),
        ];
        for (option, is_given, applies) in options {
            ensure!(
                applies || !is_given,
                "{option} does not apply to {}",
                self.file()
            );
        }
        Ok(())
    }

    /// The clip in a compressed file.
    pub(super) fn clip(&self) -> Result<CompressedClip> {
        self.check_options()?;
        Ok(CompressedClip::read(&self.motion)?)
    }

    /// The recording in a file that is not compressed, and what is unusual about the file.
    pub(super) fn recording(&self, warnings: &mut Vec<Warning>) -> Result<Recording> {
        if self.kind()? != Kind::Clip {
            self.check_options()?;
        }
        let unit = self.unit()?;
        match self.kind()? {
            Kind::Bvh => {
                let motion = motion_file::read(&self.motion, warnings)?;
                Recording::from_bvh(&motion, unit).with_context(|| self.file())
            }
            Kind::Gltf => {
                let document = gltf::read(&self.motion)?;
                Recording::from_gltf(&document, self.animation.unwrap_or(0), unit, self.rate)
                    .with_context(|| self.file())
            }
            Kind::Clip => bail!("{}: the motion is already compressed", self.file()),
        }
    }

    /// How far the recording is from what [`gltf_motion`](Self::gltf_motion) shows at its frames,
    /// in metres, for points within a shell about the joints: 0 where the file is not a glTF
    /// document.
    pub(super) fn deviation(&self, recording: &Recording, shell: f64) -> Result<f64> {
        if self.kind()? != Kind::Gltf {
            return Ok(0.0);
        }
        let document = self.document()?;
        let player = Player::new(&document).with_context(|| self.file())?;
        let animation = self.animation.unwrap_or(0);
        let motion = GltfMotion::new(&player, animation, self.unit()?);
        let deviation = motion.and_then(|motion| motion.deviation(recording, self.rate, shell));
        deviation.with_context(|| self.file())
    }

    /// The recording in a file of any kind, and the bounds of a compressed clip.
    pub(super) fn any_recording(
        &self,
        warnings: &mut Vec<Warning>,
    ) -> Result<(Recording, Options)> {
        if self.kind()? != Kind::Clip {
            return Ok((self.recording(warnings)?, Options::default()));
        }
        let clip = self.clip()?;
        let recording = Recording::from_compressed(&clip).with_context(|| self.file())?;
        Ok((recording, clip.options().clone()))
    }

    /// The glTF document, for what a recording does not have.
    pub(super) fn document(&self) -> Result<Document> {
        Ok(gltf::read(&self.motion)?)
    }

    /// The animation of a document, by its own curves and not at a rate.
    pub(super) fn gltf_motion<'a>(&self, player: &'a Player<'a>) -> Result<GltfMotion<'a>> {
        ensure!(
            self.rate.is_none(),
            "--rate does not apply to the curves of {}, which have no frames",
            self.file()
        );
        let unit = self.unit()?;
        GltfMotion::new(player, self.animation.unwrap_or(0), unit).with_context(|| self.file())
    }

    fn unit(&self) -> Result<f64> {
        let unit = self.metres_per_unit.unwrap_or(1.0);
        ensure!(
            unit > 0.0 && unit.is_finite(),
            "--metres-per-unit {unit}: the length of a unit must be greater than 0 and finite"
        );
        Ok(unit)
    }
}

/// How many vertices the primitives of a document have together.
pub(super) fn vertices(document: &Document) -> u64 {
    let primitives = document.meshes.iter().flat_map(|mesh| &mesh.primitives);
    primitives
        .map(|primitive| primitive.positions.len() as u64)
        .sum()
}
