//! `nullcone clip sample`: the frames of joints at given times.

use anyhow::{Context as _, Result, ensure};
use ga_anim::motion_file::{Format, Sample};
use serde::Serialize;

use super::input::MotionArguments;
use crate::frame::{self, Command, Context, Warning};

/// Print the frame of every joint in model space at given times.
///
/// A matrix has three rows of four numbers: it takes a place in the joint's own coordinates, with a
/// 1 behind it, to model space, in metres. Between frames rotations move along the shorter arc at
/// constant speed, in a compressed clip to within 0.00002 rad, translations and factors linearly.
/// Before the first frame and after the last one the pose is that of the frame. A compressed clip
/// is decoded to transforms relative to the parents in single precision, which are composed to
/// model space in double precision.
///
/// For instance
///
///   nullcone clip sample walk.clip --times 0,0.25,1.5 --json
///
/// prints {"metres_per_unit": 1.0, "samples": [{"time": 0.0, "joints": [{"joint": "Hips", "matrix":
/// [[…], […], […]]}, …], "tracks": []}, …]}.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    motion: MotionArguments,
    /// Times in seconds, separated by commas.
    #[arg(long, value_name = "T,T,…", value_delimiter = ',', required = true)]
    times: Vec<f64>,
}

impl Command for Arguments {
    type Report = Samples;

    fn run(&self, context: &Context) -> Result<Samples> {
        let (motion, times, file) = (&self.motion, &self.times, self.motion.file());
        context.files([&motion.motion])?;
        for time in times {
            ensure!(time.is_finite(), "--times {time}: a time must be finite");
        }
        let is_of_curves = motion.format()? == Format::Gltf;
        ensure!(
            !(is_of_curves && motion.rate.is_some()),
            "{file}: --rate does not apply to the curves of {file}, which have no frames"
        );
        let mut warnings = Vec::new();
        let read = motion.read(&mut warnings)?;
        let samples = read.samples(times);
        Ok(Samples {
            metres_per_unit: read.metres_per_unit(),
            samples: samples.context(file)?,
            warnings,
        })
    }
}

#[derive(Debug, Serialize)]
pub(crate) struct Samples {
    metres_per_unit: f64,
    samples: Vec<Sample>,
    #[serde(skip)]
    warnings: Vec<Warning>,
}

impl frame::Report for Samples {
    fn is_result(&self) -> bool {
        true
    }

    fn warnings(&self) -> Option<&[Warning]> {
        Some(&self.warnings)
    }

    fn text(&self) -> String {
        self.samples.iter().map(lines).collect()
    }
}

fn lines(sample: &Sample) -> String {
    let mut lines = format!("time {}\n", sample.time);
    for joint in &sample.joints {
        let [x, y, z] = joint.matrix.map(|row| row[3]);
        lines += &format!("  {:<24}{x:12.6} {y:12.6} {z:12.6}\n", joint.joint);
    }
    for track in &sample.tracks {
        lines += &format!("  {:<24}{:12.6}\n", track.track, track.value);
    }
    lines
}
