//! Forward kinematics on the skeleton of a recording of the CMU motion capture database: a frame at
//! a time, and eight frames in lanes.

use std::error::Error;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use ga_anim::bvh;
use ga_anim::kinematics::Hierarchy;
use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::scalar::Lanes;
use glam::Affine3A;
use nullcone_benches::comparison;
use nullcone_benches::precision::Precision;
use nullcone_shared_data::shared;

/// How many frames are computed in each pass: few enough for the first-level cache.
const FRAMES: usize = 32;
const LANES: usize = 8;

/// The parents of the joints, and their own motions in [`FRAMES`] frames.
struct Recording {
    hierarchy: Hierarchy,
    frames: Vec<Vec<Motor<f32>>>,
}

fn recording() -> Result<Option<Recording>, Box<dyn Error>> {
    let Some(path) = shared("data/anim/bvh/01_01.bvh") else {
        return Ok(None);
    };
    let motion = bvh::read(path)?;
    let parents: Vec<_> = motion.joints().iter().map(|joint| joint.parent).collect();
    let own_motions = |frame: usize| -> Option<Vec<Motor<f32>>> {
        let total = motion.frames_of_joints(50 * frame)?;
        let own = parents.iter().zip(&total).map(|(parent, motor)| {
            let above = parent.map_or(Motor::default(), |parent: usize| total[parent]);
            single(above.reverse() * *motor)
        });
        Some(own.collect())
    };
    let frames: Option<Vec<_>> = (0..FRAMES).map(own_motions).collect();
    Ok(Some(Recording {
        hierarchy: Hierarchy::new(&parents)?,
        frames: frames.ok_or("the recording is too short")?,
    }))
}

fn single(motor: Motor<f64>) -> Motor<f32> {
    let [x, y, z] = motor.translator().displacement().map(|x| x as f32);
    let (vector, scalar) = motor.rotor().to_quaternion();
    let rotor = Rotor::from_quaternion(vector.map(|x| x as f32), scalar as f32).unwrap_or_default();
    Translator::from_displacement([x, y, z]) * rotor
}

fn forward(criterion: &mut Criterion) {
    let Ok(Some(Recording { hierarchy, frames })) = recording() else {
        return;
    };
    let joints = hierarchy.parents().len();
    let mut group = criterion.benchmark_group("kinematics/forward-f32");
    group.throughput(Throughput::Elements((FRAMES * joints) as u64));

    let own = frames.concat();
    let mut total = own.clone();
    group.bench_function("nullcone, frame by frame", |bencher| {
        bencher.iter(|| {
            for (own, total) in own.chunks(joints).zip(total.chunks_mut(joints)) {
                // The lengths are those of the hierarchy.
                let _ = hierarchy.forward(Motor::default(), own, total);
            }
        });
    });

    let blocks: Vec<Motor<Lanes<f32, LANES>>> = frames
        .as_chunks::<LANES>()
        .0
        .iter()
        .flat_map(|block| {
            (0..joints)
                .map(|joint| Motor::from_lanes(&std::array::from_fn(|frame| block[frame][joint])))
        })
        .collect();
    let mut total = blocks.clone();
    group.bench_function("nullcone, 8 frames in lanes", |bencher| {
        bencher.iter(|| {
            let _ = hierarchy.forward(Motor::default(), &blocks, &mut total);
        });
    });

    let own: Vec<Affine3A> = own
        .iter()
        .map(|motor| f32::affine(motor.to_matrix()))
        .collect();
    let mut total = own.clone();
    group.bench_function("glam Affine3A", |bencher| {
        bencher.iter(|| {
            for (own, total) in own.chunks(joints).zip(total.chunks_mut(joints)) {
                for (joint, (parent, own)) in hierarchy.parents().iter().zip(own).enumerate() {
                    let above = parent.map_or(Affine3A::IDENTITY, |parent| total[parent]);
                    total[joint] = above * *own;
                }
            }
        });
    });
}

criterion_group! {
    name = benches;
    config = comparison::criterion();
    targets = forward
}
criterion_main!(benches);
