//! Sampling a compressed clip on a hierarchy of 31 joints, 2,752 frames at 120 Hz: in thirds of a
//! frame, in whole frames and at random, per joint. The rival interpolates the two uncompressed
//! frames around each time with glam: 40 bytes a joint instead of 2.
//!
//! The recording is CMU's 01_01 where the shared data are there, otherwise one made by formulas.

use std::hint::black_box;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use ga_anim::bvh;
use ga_anim::clip::compressed::{Options, Sampler, compress};
use ga_anim::recording::{RecordedJoint, Recording};
use ga_anim::transform::Transform;
use ga_runtime::cga3::{Motor, Rotor, Translator};
use glam::{Quat, Vec3};
use nullcone_benches::comparison;
use nullcone_shared_data::shared;

const JOINTS: usize = 31;
const FRAMES: usize = 2_752;

/// How many samples a round takes.
const SAMPLES: usize = 1_000;

fn all(criterion: &mut Criterion) {
    let recording = recording();
    let Ok(clip) = compress(&recording, &Options::default(), |_, _| ()) else {
        return;
    };
    let frame_time = clip.frame_time();
    let thirds = (0..SAMPLES)
        .map(|sample| sample as f64 / 3.0 * frame_time)
        .collect();
    let whole = (0..SAMPLES)
        .map(|sample| sample as f64 * frame_time)
        .collect();
    let mut state = 1u64;
    let random = (0..SAMPLES).map(|_| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 11) as f64 / (1u64 << 53) as f64 * clip.duration()
    });
    let random: Vec<f64> = random.collect();
    let orders: [(&str, Vec<f64>); 3] = [
        ("third frames", thirds),
        ("whole frames", whole),
        ("random", random),
    ];
    let mut sampler = Sampler::new(&clip);
    let mut rival = Rival::new(&recording);
    for (name, times) in &orders {
        let mut group = criterion.benchmark_group(format!("clip/sample in {name}"));
        let joints = SAMPLES * recording.joints().len();
        group.throughput(Throughput::Elements(joints as u64));
        run(&mut group, "nullcone", times, |time| {
            sampler.sample(time);
            black_box((sampler.rotors(), sampler.translations(), sampler.scales()));
        });
        run(&mut group, "glam, uncompressed", times, |time| {
            rival.sample(time);
            black_box(&rival.pose);
        });
    }
}

fn run(
    group: &mut BenchmarkGroup<'_, WallTime>,
    name: &str,
    times: &[f64],
    mut sample: impl FnMut(f64),
) {
    group.bench_function(name, |bencher| {
        bencher.iter(|| {
            for &time in black_box(times) {
                sample(time);
            }
        });
    });
}

/// Rotation, translation and factors of joints in single precision, frame after frame.
struct Rival {
    frame_time: f64,
    joints: usize,
    frames: Vec<(Quat, Vec3, Vec3)>,
    pose: Vec<(Quat, Vec3, Vec3)>,
}

impl Rival {
    fn new(recording: &Recording) -> Self {
        let locals = recording.locals().iter().map(|local| {
            let ([x, y, z], w) = local.rotor().to_quaternion();
            let [place, scale] = [local.translation(), local.scale].map(|v| v.coordinates());
            (
                Quat::from_array([x, y, z, w].map(|x| x as f32)),
                Vec3::from(place.map(|x| x as f32)),
                Vec3::from(scale.map(|x| x as f32)),
            )
        });
        let joints = recording.joints().len();
        let frames: Vec<_> = locals.collect();
        Self {
            frame_time: recording.frame_time(),
            joints,
            pose: frames[..joints].to_vec(),
            frames,
        }
    }

    fn sample(&mut self, time: f64) {
        let last = self.frames.len() / self.joints - 1;
        let position = (time / self.frame_time).max(0.0).min(last as f64);
        let before = (position as usize).min(last.saturating_sub(1));
        let part = (position - before as f64) as f32;
        let (from, to) = self.frames[before * self.joints..].split_at(self.joints);
        for ((pose, from), to) in self.pose.iter_mut().zip(from).zip(to) {
            *pose = (
                from.0.slerp(to.0, part),
                from.1.lerp(to.1, part),
                from.2.lerp(to.2, part),
            );
        }
    }
}

fn recording() -> Recording {
    let real = shared("data/anim/bvh/01_01.bvh")
        .and_then(|path| bvh::read(path).ok())
        .and_then(|motion| Recording::from_bvh(&motion, 0.056_444).ok());
    real.unwrap_or_else(made)
}

/// Two channels of noise on slow waves for each joint.
fn made() -> Recording {
    let local = |frame: usize, joint: usize| {
        let t = frame as f64 / 120.0;
        let wave = (t * (1.0 + joint as f64 * 0.1)).sin() + 0.004 * (frame as f64 * 12.9).sin();
        let rotor = Rotor::from_rotation_vector([0.5 * wave, 0.2 * wave * wave, 0.0]);
        let place = Translator::from_displacement([0.1, 0.0, 0.0]);
        Transform::from(Motor::from(place) * Motor::from(rotor.unwrap_or_default()))
    };
    let joints = (0..JOINTS).map(|joint| RecordedJoint {
        name: joint.to_string(),
        parent: (joint > 0).then(|| (joint - 1) / 2),
        rest: local(0, joint),
    });
    let locals = (0..FRAMES).flat_map(|frame| (0..JOINTS).map(move |joint| local(frame, joint)));
    Recording::new(joints.collect(), 1.0 / 120.0, locals.collect(), Vec::new())
        .expect("the formulas give unit motors")
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = all
}
criterion_main!(benches);
