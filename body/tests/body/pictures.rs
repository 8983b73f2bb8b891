//! The pose of the figure from pictures of its painted dots alone.

use std::sync::LazyLock;

use ga_anim::pose::Pose;
use ga_anim::retarget::{Options, Retarget, Soles};
use ga_body::BodyError;
use ga_body::marked::MarkedBody;
use ga_body::marker::{Dot, Hue};
use ga_body::pose_error::mean_per_joint_position_error;
use ga_mannequin::walk;
use ga_render::Shading;

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
