//! A skeleton of few bones in a pose that is made by hand.

use ga_anim::pose::Pose;
use ga_anim::skeleton::{JointLimits, Limit};
use ga_anim::skin::{Method, skin};
use ga_anim::weights::SkinWeights;
use ga_body::{BodyFit, BodyModel, BodyPoint, Observation};
use ga_camera::Camera;
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};

use super::{biped, greatest_error, heads, moved_biped, rig, seen, turned};

#[test]
fn exact_pixels_give_the_exact_pose() {
    let skeleton = biped();
    let model = BodyModel::of_distinct_joints(skeleton.clone()).unwrap();
    let truth = heads(&skeleton, &moved_biped(&skeleton));
    for views in [2, 4] {
        let cameras = rig(std::slice::from_ref(&truth), views);
        let observed = seen(&cameras, &truth, 0.0, 0.0, 1);
        let fit = BodyFit::new(&model, &cameras).unwrap();
        let found = fit.frame(&observed).unwrap();
        assert!(greatest_error(&truth, &found.points) < 1e-6);
        assert!(found.root_mean_square_px < 1e-3 && found.unseen.is_empty());
        // The motors take the skeleton to the same places.
        assert!(greatest_error(&heads(&skeleton, &found.pose), &found.points) < 1e-12);
    }
}

/// Hip and ankle leave the knee a circle, on which a knee is in front.
#[test]
fn knees_that_no_view_shows_are_in_front() {
    let skeleton = biped();
    let model = BodyModel::of_distinct_joints(skeleton.clone()).unwrap();
    for facing in [0.0, 0.6, 1.2] {
        let mut rotors = vec![Rotor::default(); skeleton.len()];
        rotors[0] = turned([0.0, 1.0, 0.0], facing);
        for (hip, [raised, bent]) in [(3, [-0.9, 1.2]), (6, [-0.7, 1.1])] {
            rotors[hip] = turned([1.0, 0.0, 0.0], raised);
            rotors[hip + 1] = turned([1.0, 0.0, 0.0], bent);
        }
        let truth = heads(
            &skeleton,
            &Pose::from_rotors(&skeleton, Motor::default(), &rotors).unwrap(),
        );
        let cameras = rig(std::slice::from_ref(&truth), 2);
        let mut observed = seen(&cameras, &truth, 0.0, 0.0, 1);
        for view in &mut observed.views {
            (view[4], view[7]) = (None, None);
        }
        let fit = BodyFit::new(&model, &cameras).unwrap();
        let found = fit.frame(&observed).unwrap();
        assert_eq!(found.unseen, [4, 7]);
        let error = greatest_error(&truth, &found.points);
        assert!(error < 0.03, "{facing}: {error}");
    }
}

#[test]
fn the_fit_moves_with_cameras_and_world() {
    let skeleton = biped();
    let model = BodyModel::of_distinct_joints(skeleton.clone()).unwrap();
    let truth = heads(&skeleton, &moved_biped(&skeleton));
    let cameras = rig(std::slice::from_ref(&truth), 2);
    let observed = seen(&cameras, &truth, 2.0, 0.0, 3);
    let motion: Motor<f64> =
        Translator::from_displacement([3.0, -2.0, 1.0]) * turned([1.0, 2.0, -0.5], 1.1);
    let elsewhere: Vec<Camera> = cameras
        .iter()
        .map(|camera| Camera {
            world_to_camera: camera.world_to_camera * motion.reverse(),
            ..*camera
        })
        .collect();
    let here = BodyFit::new(&model, &cameras)
        .unwrap()
        .frame(&observed)
        .unwrap();
    let there = BodyFit::new(&model, &elsewhere)
        .unwrap()
        .frame(&observed)
        .unwrap();
    let moved: Vec<_> = here.points.iter().map(|p| motion.transform(*p)).collect();
    assert!(greatest_error(&moved, &there.points) < 1e-4);
}

#[test]
fn hinges_and_cones_hold() {
    let skeleton = biped();
    let truth = moved_biped(&skeleton);
    let mut limits = vec![Limit::Free; skeleton.len()];
    // The truth bends the left knee by 1.2, which is too much, and the right one not at all.
    for knee in [4, 7] {
        let (axis, range) = ([1.0, 0.0, 0.0], [0.0, 0.8]);
        limits[knee] = Limit::Hinge { axis, range };
    }
    limits[6] = Limit::SwingTwist {
        axis: [0.0, -1.0, 0.0],
        swing: 0.4,
        twist: [-0.5, 0.5],
    };
    limits[8] = Limit::Fixed;
    let limits = JointLimits::new(&skeleton, limits).unwrap();
    let points = heads(&skeleton, &truth);
    let model = BodyModel::of_distinct_joints(skeleton).unwrap();
    let model = model.with_limits(limits.clone()).unwrap();
    let cameras = rig(std::slice::from_ref(&points), 2);
    let observed = seen(&cameras, &points, 1.0, 0.0, 7);
    let found = BodyFit::new(&model, &cameras)
        .unwrap()
        .frame(&observed)
        .unwrap();
    for (joint, motor) in found.pose.joints.iter().enumerate() {
        assert!(limits.excess(joint, motor.rotor()) < 1e-9, "joint {joint}");
    }
    // The knee goes as far as it may towards the truth, in every pose of which this is the mean.
    let knee = found.pose.joints[4].rotor().to_axis_angle();
    assert!((knee.1 - 0.8).abs() < 1e-3, "{knee:?}");
}

#[test]
fn points_of_the_skin_are_fitted_as_they_are_skinned() {
    let skeleton = biped();
    let pose = moved_biped(&skeleton);
    type SkinPoint = (&'static str, [f64; 3], Vec<(u32, f64)>);
    let influences: Vec<SkinPoint> = vec![
        ("belly", [0.0, 1.2, 0.12], vec![(0, 1.0)]),
        ("back", [0.05, 1.4, -0.12], vec![(0, 0.7), (1, 0.3)]),
        ("chin", [0.0, 1.6, 0.1], vec![(1, 1.0)]),
        ("ear", [0.1, 1.7, 0.0], vec![(1, 1.0)]),
        ("left thigh", [0.2, 0.7, 0.05], vec![(3, 1.0)]),
        (
            "left knee cap",
            [0.15, 0.52, 0.06],
            vec![(3, 0.5), (4, 0.5)],
        ),
        ("left shin", [0.15, 0.3, 0.06], vec![(4, 1.0)]),
        ("left calf", [0.2, 0.2, -0.05], vec![(4, 1.0)]),
        ("right thigh", [-0.2, 0.7, 0.05], vec![(6, 1.0)]),
        (
            "right knee cap",
            [-0.15, 0.52, 0.06],
            vec![(6, 0.5), (7, 0.5)],
        ),
        ("right shin", [-0.15, 0.3, 0.06], vec![(7, 1.0)]),
    ];
    let at_rest: Vec<Point<f64>> = influences
        .iter()
        .map(|(_, place, _)| (*place).into())
        .collect();
    let weights = influences.iter().map(|(_, _, weights)| weights.clone());
    let weights = SkinWeights::new(skeleton.len(), weights).unwrap();
    let motions = pose.motions(&skeleton).unwrap();
    let points = influences.iter().map(|(name, at_rest, joints)| BodyPoint {
        name: (*name).to_owned(),
        at_rest: *at_rest,
        joints: joints
            .iter()
            .map(|(joint, weight)| (*joint as usize, *weight))
            .collect(),
    });
    let points: Vec<BodyPoint> = points.collect();
    for method in [Method::Linear, Method::Motor] {
        let truth = skin(&at_rest, &weights, &motions, method).unwrap();
        let model = BodyModel::new(skeleton.clone(), points.clone()).unwrap();
        let model = model.with_blending(method);
        let cameras = rig(std::slice::from_ref(&truth), 2);
        let observed = seen(&cameras, &truth, 0.0, 0.0, 1);
        let found = BodyFit::new(&model, &cameras)
            .unwrap()
            .frame(&observed)
            .unwrap();
        assert!(greatest_error(&truth, &found.points) < 1e-5, "{method:?}");
        // The joints were not seen, but follow.
        let (truth, found) = (heads(&skeleton, &pose), heads(&skeleton, &found.pose));
        assert!(
            greatest_error(&truth[..8], &found[..8]) < 1e-3,
            "{method:?}"
        );
    }
}

#[test]
fn one_view_finds_the_pose_up_to_what_depth_leaves_open() {
    let skeleton = biped();
    let model = BodyModel::of_distinct_joints(skeleton.clone()).unwrap();
    let truth = heads(&skeleton, &moved_biped(&skeleton));
    let cameras = rig(std::slice::from_ref(&truth), 1);
    let observed = seen(&cameras, &truth, 1.0, 0.0, 9);
    let found = BodyFit::new(&model, &cameras)
        .unwrap()
        .frame(&observed)
        .unwrap();
    assert!(found.root_mean_square_px < 3.0);
    // Known lengths of bones give the distance.
    let distance = |points: &[Point<f64>]| cameras[0].centre().distance(points[0]);
    assert!((distance(&found.points) / distance(&truth) - 1.0).abs() < 0.1);
}

#[test]
fn frames_without_pixels_follow_from_their_neighbours() {
    let skeleton = biped();
    let model = BodyModel::of_distinct_joints(skeleton.clone()).unwrap();
    let pose = |frame: usize| {
        let mut rotors = vec![Rotor::default(); skeleton.len()];
        let phase = 0.05 * frame as f64;
        rotors[0] = turned([0.0, 1.0, 0.0], 0.5 * phase);
        rotors[3] = turned([1.0, 0.0, 0.0], 0.6 * phase.sin());
        rotors[4] = turned([1.0, 0.0, 0.0], 0.5 + 0.4 * phase.cos());
        let root = Translator::from_displacement([0.0, 0.0, 0.01 * frame as f64]);
        Pose::from_rotors(&skeleton, root.into(), &rotors).unwrap()
    };
    let truth: Vec<_> = (0..60)
        .map(|frame| heads(&skeleton, &pose(frame)))
        .collect();
    let cameras = rig(&truth, 2);
    let frames = truth.iter().enumerate();
    let observed = frames.map(|(k, points)| match k {
        0..2 | 30..36 => Observation::unseen(2, points.len()),
        _ => seen(&cameras, points, 1.0, 0.0, k as u64),
    });
    let observed: Vec<_> = observed.collect();
    let fits = BodyFit::new(&model, &cameras)
        .unwrap()
        .clip(&observed, 60.0)
        .unwrap();
    for (frame, (truth, fit)) in truth.iter().zip(&fits).enumerate() {
        assert!(greatest_error(truth, &fit.points) < 0.06, "frame {frame}");
    }
    assert_eq!(fits[32].unseen.len(), skeleton.len());
}
