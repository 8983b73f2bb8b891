//! The figures on a real recording.

use ga_anim::bvh;
use ga_anim::clip::compressed::{Options, Sampler, error_at_skin, measure};
use ga_anim::recording::Recording;
use ga_anim::weights::SkinWeights;
use ga_runtime::cga3::Point;
use glam::DAffine3;
use nullcone_shared_data::shared;

use super::{compressed, found, in_model_space, ratio, shell_error, truth};

#[test]
fn a_real_recording_keeps_its_bound_in_a_twenty_first_of_its_bytes() {
    let Some(path) = shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let motion = bvh::read(path).unwrap();
    let recording = Recording::from_bvh(&motion, 0.056_444).unwrap();
    let clip = compressed(&recording, &Options::default());
    assert!(ratio(&clip) >= 21.0, "{}", ratio(&clip));

    let mut sampler = Sampler::new(&clip);
    let (mut greatest, mut half) = (0.0f64, 0.0f64);
    let mut locals = recording.frame(0).unwrap().to_vec();
    for frame in 0..recording.frame_count() {
        let time = frame as f64 * recording.frame_time();
        sampler.sample(time);
        let pairs = found(&sampler, clip.parents())
            .into_iter()
            .zip(truth(&recording, frame));
        for (found, truth) in pairs {
            greatest = greatest.max(shell_error(&found, &truth, 0.03));
        }
        if frame + 1 == recording.frame_count() {
            break;
        }
        let time = time + 0.5 * recording.frame_time();
        sampler.sample(time);
        recording.sample(time, &mut locals).unwrap();
        let truth = in_model_space(recording.parents(), locals.iter().map(matrix).collect());
        for (found, truth) in found(&sampler, clip.parents()).iter().zip(truth) {
            half = half.max(shell_error(found, &truth, 0.03));
        }
    }
    assert!(greatest <= 1e-4, "{greatest}");
    assert!(half <= 1.1e-4, "{half}");
    let measured = measure(&recording, &clip).unwrap();
    assert!(measured.error <= 1e-4 && measured.error >= greatest - 1e-8);
    let measured = measured.half_frame_error;
    assert!(measured <= 1.1e-4 && measured >= half - 1e-8, "{measured}");
}

fn matrix(local: &ga_anim::transform::Transform<f64>) -> DAffine3 {
    super::affine(
        local.scale.coordinates(),
        local.rotor().to_quaternion(),
        local.translation().coordinates(),
    )
}

/// A part of the recording, so that vertices are moved in few frames.
#[test]
fn the_error_at_a_skin_is_that_of_its_vertices() {
    let Some(path) = shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let motion = bvh::read(path).unwrap();
    let whole = Recording::from_bvh(&motion, 0.056_444).unwrap();
    let count = whole.joints().len();
    let (joints, locals) = (
        whole.joints().to_vec(),
        whole.locals()[..100 * count].to_vec(),
    );
    let recording = Recording::new(joints, whole.frame_time(), locals, Vec::new()).unwrap();
    let clip = compressed(&recording, &Options::default());

    // A vertex 2 cm from each joint, moved by it alone, is within the shell.
    let rest: Vec<_> = recording
        .joints()
        .iter()
        .map(|joint| matrix(&joint.rest))
        .collect();
    let rest = in_model_space(recording.parents(), rest);
    let places = rest
        .iter()
        .map(|frame| frame.transform_point3([0.0, 0.02, 0.0].into()));
    let positions: Vec<Point<f64>> = places.map(|place| place.to_array().into()).collect();
    let alone: Vec<_> = (0..count as u32).map(|joint| [(joint, 1.0)]).collect();
    let weights = SkinWeights::new(count, alone).unwrap();
    let error = error_at_skin(&recording, &clip, &positions, &weights).unwrap();
    let mut sampler = Sampler::new(&clip);
    let mut expected = 0.0f64;
    for frame in 0..100 {
        sampler.sample_frame(frame);
        let pairs = found(&sampler, clip.parents())
            .into_iter()
            .zip(truth(&recording, frame));
        for (found, truth) in pairs {
            let place = [0.0, 0.02, 0.0].into();
            let error = found
                .transform_point3(place)
                .distance(truth.transform_point3(place));
            expected = expected.max(error);
        }
    }
    assert!(
        error <= 1e-4 && (error - expected).abs() < 1e-6,
        "{error} instead of {expected}"
    );

    let few = SkinWeights::new(count - 1, [[(0, 1.0)]]).unwrap();
    let error = error_at_skin(&recording, &clip, &positions, &few).unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("weights for 30 joints and 1 vertices"),
        "{error}"
    );
}
