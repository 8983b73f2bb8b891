//! Motion capture seen by synthetic cameras.

use ga_anim::bvh::Bvh;
use ga_body::pose_error::{mean_per_joint_position_error, procrustes_aligned};
use ga_body::{BodyFit, BodyModel, FittedPose};
use ga_camera::triangulation::triangulate_views;
use ga_runtime::cga3::Point;
use nullcone_shared_data::shared;

use super::{rig, seen};

/// CMU's unit: 0.45 inches.
const UNIT: f64 = 0.0254 / 0.45;

/// A motion, with the places of its distinct joints.
struct Recording {
    bvh: Bvh,
    model: BodyModel,
    points: Vec<usize>,
}

fn recording() -> Option<Recording> {
    let bvh = ga_anim::bvh::read(shared("data/anim/bvh/01_01.bvh")?).unwrap();
    let skeleton = bvh.skeleton().unwrap().scaled(UNIT).unwrap();
    let model = BodyModel::of_distinct_joints(skeleton).unwrap();
    let points = model.points().iter();
    let points = points
        .map(|point| bvh.index(&point.name).unwrap())
        .collect();
    Some(Recording { bvh, model, points })
}

impl Recording {
    fn truth(&self, frame: usize) -> Vec<Point<f64>> {
        let all = self.bvh.joint_positions(frame).unwrap();
        let scaled = |joint: &usize| Point::from(all[*joint].map(|x| x * UNIT));
        self.points.iter().map(scaled).collect()
    }
}

/// Mean errors in millimetres, as they are and after the best alignment.
fn errors<'a>(pairs: impl Iterator<Item = (&'a Vec<Point<f64>>, Vec<Point<f64>>)>) -> [f64; 2] {
    let (mut sums, mut count) = ([0.0; 2], 0.0);
    for (truth, found) in pairs {
        sums[0] += mean_per_joint_position_error(truth, &found).unwrap();
        sums[1] += procrustes_aligned(truth, &found).unwrap().mean_error;
        count += 1.0;
    }
    sums.map(|sum| 1e3 * sum / count)
}

fn of_fits(truth: &[Vec<Point<f64>>], fits: &[FittedPose]) -> [f64; 2] {
    errors(truth.iter().zip(fits.iter().map(|fit| fit.points.clone())))
}

#[test]
fn cmu_has_21_distinct_joints() {
    let Some(recording) = recording() else { return };
    assert_eq!(recording.model.points().len(), 21);
    assert!(
        recording
            .model
            .points()
            .iter()
            .all(|point| point.name != "LHipJoint")
    );
}

#[test]
fn single_frames_are_better_than_triangulation() {
    let Some(recording) = recording() else { return };
    let frames = (0..recording.bvh.frame_count()).step_by(60);
    let truth: Vec<_> = frames.map(|frame| recording.truth(frame)).collect();
    let (mut raw, mut fits) = (Vec::new(), Vec::new());
    for (frame, points) in truth.iter().enumerate() {
        let cameras = rig(std::slice::from_ref(points), 2);
        let fit = BodyFit::new(&recording.model, &cameras).unwrap();
        let whole = seen(&cameras, points, 2.0, 0.0, frame as u64);
        let pairs = (0..points.len()).map(|k| {
            let pixels = [0, 1].map(|view| whole.views[view][k].unwrap().position);
            triangulate_views(&cameras, &pixels).unwrap().position
        });
        raw.push(pairs.collect::<Vec<_>>());
        fits.push(fit.frame(&whole).unwrap());
    }
    let raw = errors(truth.iter().zip(raw));
    let fitted = of_fits(&truth, &fits);
    // What independent prototypes found: 36.8 and 34.2.
    assert!(
        (raw[0] - 36.8).abs() < 2.0 && (raw[1] - 34.2).abs() < 2.0,
        "{raw:?}"
    );
    assert!(fitted[0] <= 22.0 && fitted[1] <= 18.0, "{fitted:?}");
}

/// The fits of every 60th frame by itself, and the truth.
fn single_frames(recording: &Recording, missing: f64) -> (Vec<Vec<Point<f64>>>, Vec<FittedPose>) {
    let frames = (0..recording.bvh.frame_count()).step_by(60);
    let truth: Vec<_> = frames.map(|frame| recording.truth(frame)).collect();
    let fits = truth.iter().enumerate().map(|(frame, points)| {
        let cameras = rig(std::slice::from_ref(points), 2);
        let fit = BodyFit::new(&recording.model, &cameras).unwrap();
        let observed = seen(&cameras, points, 2.0, missing, frame as u64);
        fit.frame(&observed).unwrap()
    });
    let fits = fits.collect();
    (truth, fits)
}

#[test]
fn missing_joints_follow_from_others() {
    let Some(recording) = recording() else { return };
    let [whole, found] = [0.0, 0.2].map(|missing| {
        let (truth, fits) = single_frames(&recording, missing);
        of_fits(&truth, &fits)
    });
    assert!(
        found[1] <= 1.5 * whole[1],
        "{found:?}, of whole ones {whole:?}"
    );
}

#[test]
fn clips_are_better_than_single_frames() {
    let Some(recording) = recording() else { return };
    for (seed, first) in [0, 600, 1200, 2300].into_iter().enumerate() {
        let truth: Vec<_> = (first..first + 240).map(|f| recording.truth(f)).collect();
        let cameras = rig(&truth, 2);
        let fit = BodyFit::new(&recording.model, &cameras).unwrap();
        let found = [0.0, 0.2].map(|missing| {
            let frames = truth.iter().zip((1000 * seed as u64)..);
            let observed = frames.map(|(points, seed)| seen(&cameras, points, 2.0, missing, seed));
            let observed: Vec<_> = observed.collect();
            of_fits(&truth, &fit.clip(&observed, 120.0).unwrap())
        });
        assert!(
            found[0][0] <= 15.0 && found[0][1] <= 10.0,
            "from {first}: {found:?}"
        );
        assert!(found[1][0] <= 1.5 * found[0][0], "from {first}: {found:?}");
    }
}
