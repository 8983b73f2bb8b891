//! The pose of the figure from pictures of its painted dots alone.

use std::sync::LazyLock;

use ga_anim::pose::Pose;
use ga_anim::retarget::{Options, Retarget, Soles};
use ga_body::BodyError;
use ga_body::marked::MarkedBody;
use ga_body::marker::{Dot, Hue};
use ga_body::pose_error::mean_per_joint_position_error;
use ga_camera::Camera;
use ga_mannequin::walk;
use ga_render::Shading;
use ga_runtime::vga3::Vector;

use crate::studio::Studio;

static STUDIO: LazyLock<Studio> = LazyLock::new(|| Studio::new(1024).unwrap());
const FRONT_AND_BACK: &[f64] = &[0.4, 3.54];

/// The mean per joint position error of the pose that is found, in millimetres.
fn joint_error(pose: &Pose, sides: &[f64], shading: Shading) -> f64 {
    let cameras = STUDIO.rigs(pose, sides, 4.0).unwrap();
    let dots = STUDIO.dots(pose, &cameras, shading).unwrap();
    let fit = STUDIO.body.fit(&cameras, &dots).unwrap();
    // Hardly any dot is taken for another point: those are some pixels apart.
    let (mut wrong, mut count) = (0, 0);
    let places = STUDIO.points(pose).unwrap();
    for (camera, view) in cameras.iter().zip(&fit.observation.views) {
        for (place, pixel) in places.iter().zip(view) {
            let Some(pixel) = pixel else { continue };
            let [u, v] = camera.project(*place).unwrap();
            let distance = (pixel.position[0] - u).hypot(pixel.position[1] - v);
            wrong += usize::from(distance > 4.0);
            count += 1;
        }
    }
    assert!(count > 150 && 50 * wrong <= count, "{wrong} of {count}");
    let truth = STUDIO.joints(pose).unwrap();
    let found = STUDIO.joints(&fit.fitted.pose).unwrap();
    1e3 * mean_per_joint_position_error(&truth, &found).unwrap()
}

#[test]
fn poses_of_the_walk_are_found_from_two_and_from_four_views() {
    for (time, shading) in [(0.3, Shading::Lit), (0.8, Shading::Unlit)] {
        let pose = walk(1).sample(time);
        let two = joint_error(&pose, &[0.4], shading);
        assert!(two <= 10.0, "{time} s, two views: {two} mm");
        let four = joint_error(&pose, FRONT_AND_BACK, shading);
        assert!(four <= 3.0, "{time} s, four views: {four} mm");
    }
}

/// The dots of a shin are up to two and a half pixels from where a shin can have them: some of them
/// are within reach of its points.
#[test]
fn a_limb_whose_dots_do_not_fit_is_not_recognised() {
    const AWAY: f64 = 2.5;
    let pose = walk(1).sample(0.3);
    let cameras = STUDIO.rigs(&pose, FRONT_AND_BACK, 4.0).unwrap();
    let mut dots = STUDIO.dots(&pose, &cameras, Shading::Unlit).unwrap();
    let places = STUDIO.points(&pose).unwrap();
    let shin = STUDIO.human.skeleton.index("LeftLowerLeg").unwrap();
    let points = STUDIO.body.model().points().iter().zip(&places);
    let of_shin = points.filter(|(point, _)| point.joints[0].0 == shin);
    let of_shin: Vec<_> = of_shin.map(|(_, place)| *place).collect();
    let mut count = 0;
    for (camera, dots) in cameras.iter().zip(&mut dots) {
        for place in &of_shin {
            let [u, v] = camera.project(*place).unwrap();
            let near = |dot: &&mut Dot| (dot.centre[0] - u).hypot(dot.centre[1] - v) < 0.5;
            for dot in dots.iter_mut().filter(near) {
                let (sin, cos) = (2.4 * f64::from(count)).sin_cos();
                dot.centre = [dot.centre[0] + AWAY * cos, dot.centre[1] + AWAY * sin];
                count += 1;
            }
        }
    }
    assert!(count > 20, "{count}");
    let fit = STUDIO.body.fit(&cameras, &dots).unwrap();
    assert_eq!(fit.unrecognised, [shin]);
    let joints = STUDIO.body.joints(&cameras, &fit).unwrap();
    let [thigh, foot] = ["LeftUpperLeg", "LeftFoot"].map(|name| {
        let joint = STUDIO.human.skeleton.index(name).unwrap();
        joints.iter().all(|view| view[joint].is_some())
    });
    assert!(thigh && foot);
}

/// Cameras that stand a fifth nearer than they did, so that the body is a fifth smaller.
#[test]
fn no_body_is_recognised_with_other_cameras() {
    const NEARER: f64 = 0.8;
    const DISTANCE: f64 = 5.0;
    for time in [0.1, 0.6] {
        let pose = walk(1).sample(time);
        let cameras = STUDIO.rigs(&pose, &[0.0, 1.57], DISTANCE).unwrap();
        let dots = STUDIO.dots(&pose, &cameras, Shading::Lit).unwrap();
        let nearer = cameras.iter().map(|camera| {
            let along = camera
                .ray(camera.intrinsics.principal())
                .unwrap()
                .direction();
            let eye = Vector::from(camera.centre());
            let middle = eye + Vector::from(along) * DISTANCE;
            let eye = middle + (eye - middle) * NEARER;
            let up = [0.0, 1.0, 0.0];
            Camera::look_at(camera.intrinsics, eye.into(), middle.into(), up).unwrap()
        });
        let error = STUDIO.body.fit(&nearer.collect::<Vec<_>>(), &dots);
        let error = error.map(|fit| fit.unrecognised).unwrap_err();
        let is_expected = matches!(
            error,
            BodyError::Unrecognised { .. }
                | BodyError::TooFewPoints { .. }
                | BodyError::TooFewMarkers { .. }
        );
        assert!(is_expected, "{error}");
    }
}

/// The head of a joint is in the pictures where the true pose has it, within its deviation.
#[test]
fn joints_are_in_the_pictures_where_the_pose_has_them() {
    let (mut sum, mut count) = (0.0, 0);
    for time in [0.1, 0.5, 0.9] {
        let pose = walk(1).sample(time);
        let cameras = STUDIO.rigs(&pose, FRONT_AND_BACK, 4.0).unwrap();
        let dots = STUDIO.dots(&pose, &cameras, Shading::Unlit).unwrap();
        let fit = STUDIO.body.fit(&cameras, &dots).unwrap();
        let joints = STUDIO.body.joints(&cameras, &fit).unwrap();
        for (camera, joints) in cameras.iter().zip(joints) {
            for (place, joint) in STUDIO.joints(&pose).unwrap().into_iter().zip(joints) {
                let Some(joint) = joint else { continue };
                let [u, v] = camera.project(place).unwrap();
                let distance = (joint.position[0] - u).hypot(joint.position[1] - v);
                assert!(distance < 3.0, "{time} s: {distance} px");
                assert!((0.01..1.5).contains(&joint.deviation), "{joint:?}");
                sum += (distance / joint.deviation).powi(2);
                count += 1;
            }
        }
    }
    assert!(count > 200, "{count}");
    let rms = (sum / f64::from(count)).sqrt();
    assert!((0.3..4.0).contains(&rms), "{rms} deviations");
}

#[test]
fn a_pose_of_motion_capture_is_found() {
    let Some(path) = nullcone_shared_data::shared("data/anim/bvh/01_01.bvh") else {
        return;
    };
    let motion = ga_anim::bvh::read(path).unwrap();
    let human = &STUDIO.human;
    let soles = Soles::of_mesh(human.mesh.positions(), &human.weights).unwrap();
    let retarget = Retarget::new(
        &motion,
        &human.skeleton,
        &Options {
            soles: Some(&soles),
            ..Options::default()
        },
    )
    .unwrap();
    let error = joint_error(&retarget.pose(1400).unwrap(), FRONT_AND_BACK, Shading::Lit);
    assert!(error <= 10.0, "{error} mm");
}

#[test]
fn what_is_missing_is_named() {
    let pose = Pose::rest(STUDIO.human.skeleton.len());
    let cameras = STUDIO.rigs(&pose, &[0.4], 4.0).unwrap();
    let dot = |hue, u, v| Dot {
        hue,
        centre: [u, v],
        semi_axes: [3.0, 3.0],
    };
    let one = vec![dot(Hue::Red, 300.0, 300.0)];
    let fit = |dots: &[Vec<Dot>]| STUDIO.body.fit(&cameras, dots).unwrap_err();
    assert_eq!(
        fit(std::slice::from_ref(&one)),
        BodyError::DotViews {
            expected: 2,
            found: 1
        }
    );
    assert_eq!(fit(&[one.clone(), vec![]]), BodyError::NoDots { view: 1 });
    let error = fit(&[one.clone(), one.clone()]);
    assert!(
        matches!(error, BodyError::TooFewMarkers { found: 0, .. }),
        "{error}"
    );
    let infinite = vec![dot(Hue::Red, f64::NAN, 3.0)];
    assert!(matches!(
        fit(&[infinite, one]),
        BodyError::DotNotFinite { view: 0, .. }
    ));

    let body = &STUDIO.body;
    let mut marks = body.marks().to_vec();
    let last = marks.pop().unwrap();
    let count = marks.len() + 1;
    assert_eq!(
        MarkedBody::new(body.model().clone(), marks.clone()),
        Err(BodyError::Marks {
            expected: count,
            found: count - 1
        })
    );
    marks.push(last);
    marks[3].normal = [0.0; 3];
    let error = MarkedBody::new(body.model().clone(), marks).unwrap_err();
    assert!(
        error.to_string().contains(&body.model().points()[3].name),
        "{error}"
    );
}
