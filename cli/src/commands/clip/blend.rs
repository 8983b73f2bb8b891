//! `nullcone clip blend`: several motions of the same joints at once.

use std::path::{Path, PathBuf};

use anyhow::{Context as _, Result, ensure};
use clap::error::ErrorKind;
use ga_anim::gait::{Aligned, vertical};
use ga_anim::motion_file::Format;
use ga_anim::recording::{Cycle, Played, Recording, Seam, blend, blend_played};

use super::input::{Input, MotionArguments};
use super::phases::{Phase, Phases};
use super::target::{Output, Report, TargetArguments};
use crate::files::expanded;
use crate::frame::{Command, Context, Warning};

/// Write the mean of motions of the same joints, each with a weight.
///
/// Weights are divided by their sum. The rotation of a joint is the normalised sum of the rotors of
/// the motions, by the shorter ways to that of the greatest weight; translations and factors are
/// mixed linearly. Joints must have the same names and parents in the same order.
///
/// All motions begin together. The result is as long as the longest one and has the shortest time
/// between frames; a shorter motion stays at its last frame, which a warning says. A motion with a
/// weight of 0 counts for nothing, so weights of 1 and 0 give the first one as it is. A scalar
/// track that a motion does not have counts as 0.
///
/// With --loop, a shorter motion begins again when it ends, and the way of its root on the ground
/// goes on. Where it ends as it begins, up to 15° of each joint and 5 cm of height, there is no
/// jump; otherwise a warning names the joint.
///
/// With --align-phases, the steps of the motions coincide: a footfall is when an ankle that was
/// lifted and swung forwards comes down. The result begins with the first footfall of the first
/// motion and goes to the last one that all of them have; all begin at the place and in the
/// direction of the first. Each step lasts the mean of what it lasts in the motions, by their
/// weights. With --loop, motions with fewer steps repeat their whole strides.
///
/// For instance
///
///   nullcone clip blend walk.clip run.clip --weights 0.7,0.3 --align-phases --loop --out jog.clip
///
/// writes a motion that is more a walk than a run. With --json it prints the same keys as
/// `nullcone clip convert`, and with --align-phases "footfalls": [{"foot": "left", "time_seconds":
/// …}, …] and "phases": [{"file": …, "begin_seconds": …, "end_seconds": …, "footfalls": […]}, …];
/// max_error_metres is the error of compression to .clip, against the mean.
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
    /// commas [default: of BVH found from the length of the legs, of glTF 1]. A .clip is in metres.
    #[arg(long, value_name = "METRES[,METRES,…]", value_delimiter = ',')]
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
    /// Repeat motions that end before others.
    #[arg(long = "loop")]
    is_looped: bool,
    /// Bring the motions in step: their footfalls coincide.
    #[arg(long)]
    align_phases: bool,
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
        let format = target.check(motions, context)?;
        ensure!(
            weights.len() == motions.len(),
            "--weights: {} weights for {} motions",
            weights.len(),
            motions.len()
        );
        let units = match self.metres_per_unit.as_slice() {
            [] => vec![None; motions.len()],
            given => {
                let units = of_each("--metres-per-unit", given, motions)?;
                units.into_iter().map(Some).collect()
            }
        };
        let animations = of_each("--animation", &self.animation, motions)?;
        let progress = context.progress(100);
        progress.step("reading the motions");
        let mut warnings = Vec::new();
        let (mut read, mut recordings, mut inputs) = (Vec::new(), Vec::new(), Vec::new());
        for ((path, unit), animation) in motions.iter().zip(units).zip(animations) {
            // One value for all motions is for those to which it applies.
            let format = Format::of_path(path)?;
            let motion = MotionArguments {
                motion: path.clone(),
                metres_per_unit: unit.filter(|_| format != Format::Clip),
                animation: (format == Format::Gltf).then_some(animation),
                rate: None,
            };
            let (file, recording) = motion.recording(&mut warnings)?;
            inputs.push(Input::new(motion.file(), &file, &recording));
            read.push(file);
            recordings.push(recording);
        }
        let weighted = recordings.iter().zip(weights.iter().copied());
        let weighted: Vec<(&Recording, f64)> = weighted.collect();
        let names = motions.iter().map(|path| path.display().to_string());
        let file = names.collect::<Vec<_>>().join(", ");
        let (mean, phases) = match self.align_phases {
            true => {
                let (mean, phases) = self.aligned(motions, &weighted, &mut warnings)?;
                (mean, Some(phases))
            }
            false => {
                let mean = self.together(motions, &weighted, &mut warnings);
                (mean.with_context(|| file.clone())?, None)
            }
        };
        let (Some(first), Some(path)) = (read.first(), motions.first()) else {
            anyhow::bail!("there is no motion");
        };
        let output = Output {
            recording: &mean,
            inputs,
            like: (path, first),
            warnings,
        };
        let report = target.write(format, output, context.outputs(), &progress)?;
        Ok(report.in_step(phases))
    }
}

impl Arguments {
    /// The mean of motions that begin together.
    fn together(
        &self,
        files: &[PathBuf],
        motions: &[(&Recording, f64)],
        warnings: &mut Vec<Warning>,
    ) -> Result<Recording> {
        let counting = || motions.iter().filter(|(_, weight)| *weight > 0.0);
        let durations = counting().map(|(recording, _)| recording.duration());
        let duration = durations.fold(0.0, f64::max);
        let mut played = Vec::with_capacity(motions.len());
        for (file, &(recording, weight)) in files.iter().zip(motions) {
            let mut on_clock = Played::new(recording);
            let step = counting().map(|(recording, _)| recording.frame_time());
            let step = step.fold(recording.frame_time(), f64::max);
            if weight > 0.0 && recording.duration() < duration - 0.5 * step {
                let end = recording.duration();
                if self.is_looped {
                    let cycle = Cycle::of_whole(recording, vertical(recording))?;
                    if !cycle.seam().is_cyclic() {
                        warnings.push(jump(file, recording, cycle.seam(), "jumps"));
                    }
                    on_clock = on_clock.in_cycles(cycle);
                } else {
                    let message = format!(
                        "it ends at {end:.2} s, before the result at {duration:.2} s, and stays at \
                         its last frame; --loop repeats it"
                    );
                    warnings.push(Warning::new("ends_early", message).in_file(file));
                }
            }
            played.push((on_clock, weight));
        }
        // Of one motion alone nothing is computed.
        if counting().count() == 1 {
            return Ok(blend(motions)?);
        }
        Ok(blend_played(&played, duration)?)
    }

    /// The mean of motions whose steps coincide.
    fn aligned(
        &self,
        files: &[PathBuf],
        motions: &[(&Recording, f64)],
        warnings: &mut Vec<Warning>,
    ) -> Result<(Recording, Phases)> {
        // What cannot be blended at all is said first.
        blend(motions)?;
        let aligned = Aligned::new(motions, self.is_looped);
        let aligned = aligned.map_err(|error| {
            let file = files[error.motion].display();
            anyhow::anyhow!("{file}: --align-phases: {}", error.problem)
        })?;
        let mean = blend_played(&aligned.played, aligned.duration_seconds)?;
        let mut phases = Vec::new();
        for ((file, (recording, _)), in_step) in files.iter().zip(motions).zip(&aligned.in_step) {
            let Some(in_step) = in_step else { continue };
            let [begin, end] = in_step.times;
            let after = recording.duration() - end;
            let message = format!(
                "{begin:.2} s before the first step and {after:.2} s after the last are left out"
            );
            warnings.push(Warning::new("left_out", message).in_file(file));
            if let Some(seam) = in_step.seam.as_ref().filter(|seam| !seam.is_cyclic()) {
                warnings.push(jump(
                    file,
                    recording,
                    seam,
                    "is bent evenly over its strides",
                ));
            }
            phases.push(Phase {
                file: file.display().to_string(),
                begin_seconds: begin,
                end_seconds: end,
                footfalls: in_step.footfalls.clone(),
            });
        }
        Ok((
            mean,
            Phases {
                footfalls: aligned.footfalls,
                phases,
            },
        ))
    }
}

/// The warning of a motion that does not end as it begins.
fn jump(file: &Path, recording: &Recording, seam: &Seam, what: &str) -> Warning {
    let joint = recording.joints().get(seam.joint);
    let joint = joint.map(|joint| joint.name.clone());
    let message = format!(
        "it does not end as it begins, and {what} where it is repeated: {} is rotated by {:.0}°, and \
         the body is {:.2} m higher",
        joint.as_deref().unwrap_or("a joint"),
        seam.angle.to_degrees(),
        seam.height,
    );
    Warning {
        joint,
        ..Warning::new("not_cyclic", message).in_file(file)
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
