//! `nullcone clip blend`: several motions of the same joints at once.

use std::path::PathBuf;

use anyhow::{Context as _, Result, ensure};
use clap::error::ErrorKind;
use ga_anim::motion_file::Format;
use ga_anim::recording::{Recording, blend};

use super::input::MotionArguments;
use super::target::{Report, TargetArguments};
use crate::files::expanded;
use crate::frame::{Command, Context};

/// Write the mean of motions of the same joints, each with a weight.
///
/// Weights are divided by their sum. The rotation of a joint is the normalised sum of the rotors of
/// the motions, by the shorter ways to that of the greatest weight; translations and factors are
/// mixed linearly. Joints must have the same names and parents in the same order.
///
/// All motions begin together. The result is as long as the longest one and has the shortest time
/// between frames; a shorter motion stays at its last frame. A motion with a weight of 0 counts for
/// nothing, so weights of 1 and 0 give the first one as it is. A scalar track that a motion does
/// not have counts as 0.
///
/// For instance
///
///   nullcone clip blend walk.clip run.clip --weights 0.7,0.3 --out jog.clip
///
/// writes a motion that is more a walk than a run. With --json it prints the same keys as
/// `nullcone clip compress`; max_error_metres is the error of compression, against the mean.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    /// The motions, two or more: names, or patterns with `*`, `?` or `[abc]`, whose files are
    /// sorted by the numbers in their names.
    #[arg(value_name = "MOTION or GLOB", required = true)]
    motions: Vec<PathBuf>,
    /// One number of 0 or more for each motion, separated by commas.
    #[arg(long, value_name = "W,W,…", value_delimiter = ',', required = true)]
    weights: Vec<f64>,
    /// The length of one unit of the motions in metres: one for all, or one for each, separated by
    /// commas. A .clip is in metres.
    #[arg(
        long,
        value_name = "N[,N,…]",
        value_delimiter = ',',
        default_value = "1"
    )]
    metres_per_unit: Vec<f64>,
    /// The number of the animation in a glTF file, from 0: one for all, or one for each motion,
    /// separated by commas.
    #[arg(
        long,
        value_name = "N[,N,…]",
        value_delimiter = ',',
        default_value = "0"
    )]
    animation: Vec<usize>,
    #[command(flatten)]
    target: TargetArguments,
}

impl Command for Arguments {
    type Report = Report;

    fn run(&self, context: &Context) -> Result<Report> {
        let Self {
            motions,
            weights,
            target,
            ..
        } = &Self {
            motions: expanded("MOTION", &self.motions)?,
            ..self.clone()
        };
        if motions.len() < 2 {
            let text = "two motions or more are blended\n";
            return Err(clap::Error::raw(ErrorKind::TooFewValues, text).into());
        }
        target.check(motions, context)?;
        ensure!(
            weights.len() == motions.len(),
            "--weights: {} weights for {} motions",
            weights.len(),
            motions.len()
        );
        let units = of_each("--metres-per-unit", &self.metres_per_unit, motions)?;
        let animations = of_each("--animation", &self.animation, motions)?;
        let progress = context.progress(100);
        progress.step("reading the motions");
        let (mut recordings, mut warnings) = (Vec::with_capacity(motions.len()), Vec::new());
        let mut compression = None;
        for ((path, unit), animation) in motions.iter().zip(units).zip(animations) {
            // One value for all motions is for those to which it applies.
            let format = Format::of_path(path)?;
            let motion = MotionArguments {
                motion: path.clone(),
                metres_per_unit: (format != Format::Clip).then_some(unit),
                animation: (format == Format::Gltf).then_some(animation),
                rate: None,
            };
            let (recording, of_motion) = motion.recording(&mut warnings)?;
            recordings.push(recording);
            compression.get_or_insert(of_motion);
        }
        let weighted = recordings.iter().zip(weights.iter().copied());
        let weighted: Vec<(&Recording, f64)> = weighted.collect();
        let names = motions.iter().map(|path| path.display().to_string());
        let file = names.collect::<Vec<_>>().join(", ");
        let mean = blend(&weighted).with_context(|| file.clone())?;
        let compression = compression.unwrap_or_default();
        target.write(&mean, file, compression, &progress, warnings)
    }
}

/// One value for each motion, where there is one for all or one for each.
fn of_each<T: Copy>(name: &str, values: &[T], motions: &[PathBuf]) -> Result<Vec<T>> {
    match values {
        [value] => Ok(vec![*value; motions.len()]),
        values if values.len() == motions.len() => Ok(values.to_vec()),
        values => anyhow::bail!(
            "{name}: {} values for {} motions",
            values.len(),
            motions.len()
        ),
    }
}
