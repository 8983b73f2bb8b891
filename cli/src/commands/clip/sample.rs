//! `nullcone clip sample`: the frames of joints at given times.

use anyhow::{Context as _, Result, ensure};
use ga_anim::clip::compressed::{CompressedClip, Sampler};
use ga_anim::gltf::Player;
use ga_anim::recording::{Recording, model_maps};
use ga_anim::transform::Transform;
use ga_runtime::geometry::Affine;
use serde::Serialize;

use super::input::{Kind, MotionArguments};
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
/// prints {"samples": [{"time": 0.0, "joints": [{"joint": "Hips", "matrix": [[…], […], […]]}, …],
/// "tracks": []}, …]}.
#[derive(Clone, Debug, clap::Args)]
#[command(verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    motion: MotionArguments,
    /// Times in seconds, separated by commas.
    #[arg(
        long,
        value_name = "T,T,…",
        value_delimiter = ',',
        required = true,
        allow_negative_numbers = true
    )]
    times: Vec<f64>,
}

impl Command for Arguments {
    type Report = Samples;

    fn run(&self, context: &Context) -> Result<Samples> {
        let (motion, times) = (&self.motion, &self.times);
        context.files([motion.path()])?;
        for time in times {
            ensure!(time.is_finite(), "--times {time}: a time must be finite");
        }
        let mut warnings = Vec::new();
        let samples = match motion.kind()? {
            Kind::Clip => of_clip(&motion.clip()?, times),
            Kind::Gltf => of_gltf(motion, times),
            Kind::Bvh => of_recording(&motion.recording(&mut warnings)?, times),
        };
        Ok(Samples {
            samples: samples.with_context(|| motion.file())?,
            warnings,
        })
    }
}

#[derive(Debug, Serialize)]
pub(crate) struct Samples {
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
        self.samples.iter().map(Sample::lines).collect()
    }
}

/// A moment.
#[derive(Debug, Serialize)]
struct Sample {
    time: f64,
    joints: Vec<Joint>,
    tracks: Vec<Track>,
}

#[derive(Debug, Serialize)]
struct Joint {
    joint: String,
    matrix: [[f64; 4]; 3],
}

#[derive(Debug, Serialize)]
struct Track {
    track: String,
    value: f64,
}

impl Sample {
    fn lines(&self) -> String {
        let mut lines = format!("time {}\n", self.time);
        for Joint { joint, matrix } in &self.joints {
            let [x, y, z] = matrix.map(|row| row[3]);
            lines += &format!("  {joint:<24}{x:12.6} {y:12.6} {z:12.6}\n");
        }
        for Track { track, value } in &self.tracks {
            lines += &format!("  {track:<24}{value:12.6}\n");
        }
        lines
    }
}

fn of_clip(clip: &CompressedClip, times: &[f64]) -> Result<Vec<Sample>> {
    let count = clip.parents().len();
    let mut sampler = Sampler::new(clip);
    let mut locals = vec![Transform::default(); count];
    let mut maps: Vec<Affine<f64>> = vec![Affine::default(); count];
    let mut sample = |&time: &f64| {
        sampler.sample(time);
        sampler.locals(&mut locals)?;
        model_maps(clip.parents(), &locals, &mut maps)?;
        let names = clip.names().iter().zip(&maps);
        Ok(Sample {
            time,
            joints: names
                .map(|(name, map)| Joint {
                    joint: name.clone(),
                    matrix: matrix(map.linear, map.translation),
                })
                .collect(),
            tracks: clip
                .track_names()
                .zip(sampler.tracks())
                .map(|(track, &value)| Track {
                    track: track.to_owned(),
                    value,
                })
                .collect(),
        })
    };
    times.iter().map(&mut sample).collect()
}

fn of_recording(recording: &Recording, times: &[f64]) -> Result<Vec<Sample>> {
    let count = recording.joints().len();
    let mut locals = vec![Transform::default(); count];
    let mut maps: Vec<Affine<f64>> = vec![Affine::default(); count];
    let mut sample = |&time: &f64| {
        recording.sample(time, &mut locals)?;
        model_maps(recording.parents(), &locals, &mut maps)?;
        let joints = recording.joints().iter().zip(&maps);
        let tracks = recording.tracks().iter().enumerate();
        Ok(Sample {
            time,
            joints: joints
                .map(|(joint, map)| Joint {
                    joint: joint.name.clone(),
                    matrix: matrix(map.linear, map.translation),
                })
                .collect(),
            tracks: tracks
                .filter_map(|(index, track)| {
                    let value = recording.sample_track(index, time)?;
                    Some(Track {
                        track: track.name.clone(),
                        value,
                    })
                })
                .collect(),
        })
    };
    times.iter().map(&mut sample).collect()
}

/// The frames of a glTF animation by its own curves, without frames in between.
fn of_gltf(motion: &MotionArguments, times: &[f64]) -> Result<Vec<Sample>> {
    let document = motion.document()?;
    let player = Player::new(&document)?;
    let motion = motion.gltf_motion(&player)?;
    let sample = |&time: &f64| {
        let maps = motion.model_maps(time)?;
        let joints = motion.joints().iter().zip(maps);
        Ok(Sample {
            time,
            joints: joints
                .map(|(joint, map)| Joint {
                    joint: joint.name.clone(),
                    matrix: matrix(map.linear, map.translation),
                })
                .collect(),
            tracks: motion
                .track_values(time)?
                .into_iter()
                .map(|(track, value)| Track { track, value })
                .collect(),
        })
    };
    times.iter().map(sample).collect()
}

fn matrix(linear: [[f64; 3]; 3], translation: [f64; 3]) -> [[f64; 4]; 3] {
    [0, 1, 2].map(|row| {
        let [x, y, z] = linear[row];
        [x, y, z, translation[row]]
    })
}
