//! What is measured of a character in motion, against a motion that is computed by hand.

use std::f64::consts::FRAC_PI_2;

use ga_anim::character::{Character, MotionReport};
use ga_anim::clip::Clip;
use ga_anim::pose::Pose;
use ga_anim::skeleton::{Joint, Skeleton};
use ga_anim::skin::SkinError;
use ga_anim::weights::SkinWeights;
use ga_runtime::cga3::{Motor, Rotor, Translator};

/// A post of height 2 with a joint at half its height, and a vertex beside that joint which both
/// halves move.
fn post() -> Character {
    let joint = |name: &str, parent, y: f64| Joint {
        name: name.into(),
        parent,
        head: [0.0, y, 0.0],
        tail: [0.0, y + 1.0, 0.0],
    };
    let rows = [vec![(0, 1.0)], vec![(0, 0.5), (1, 0.5)], vec![(1, 1.0)]];
    Character {
        mesh: ga_mesh::obj::decode(b"v 0 0 0\nv 1 1 0\nv 0 2 0\nf 1 2 3\n").unwrap(),
        skeleton: Skeleton::new(vec![joint("low", None, 0.0), joint("top", Some(0), 1.0)]).unwrap(),
        weights: SkinWeights::new(2, rows).unwrap(),
    }
}

#[test]
fn a_post_leans_bends_and_sinks() {
    let post = post();
    let about_z = |angle: f64| Rotor::from_axis_angle([0.0, 0.0, 1.0], angle).unwrap();
    let sunk = Motor::from(Translator::from_displacement([0.0, -0.25, 0.0]));
    let rotors = [about_z(-FRAC_PI_2 / 3.0), about_z(FRAC_PI_2)];
    let leaning = Pose::from_rotors(&post.skeleton, sunk, &rotors).unwrap();
    let clip = Clip::new(0.5, vec![Pose::rest(2), leaning]).unwrap();
    let report = MotionReport::new(&post, &clip).unwrap();

    assert_eq!(post.height(), 2.0);
    assert!(report.bone_length_deviation_max_metres < 1e-15);
    // Between 0° and 90° about the joint at distance 1, the linear blend is at the middle of the
    // chord and the motor blend on the arc. It is one vertex of three in one frame of two.
    let gap = 1.0 - 0.5f64.sqrt();
    for (found, expected) in [
        (report.lowest_vertex_min_metres, -0.25),
        (report.lowest_vertex_max_metres, 0.0),
        (report.trunk_from_upright_mean_degrees, 15.0),
        (report.trunk_from_upright_max_degrees, 30.0),
        (report.linear_to_motor_blend_max_metres, gap),
        (report.linear_to_motor_blend_mean_metres, gap / 6.0),
    ] {
        assert!((found - expected).abs() < 1e-13, "{found}, not {expected}");
    }
}

#[test]
fn in_another_unit_everything_is_as_much_longer() {
    let post = post().scaled(10.0).unwrap();
    assert_eq!(post.height(), 20.0);
    let joints = post.joints(&Pose::rest(2)).unwrap();
    assert_eq!(joints, [[0.0; 3], [0.0, 10.0, 0.0]]);
    assert!(post.scaled(f64::INFINITY).is_err());
}

#[test]
fn a_clip_of_another_skeleton_is_refused() {
    let clip = Clip::new(0.5, vec![Pose::rest(3)]).unwrap();
    let report = MotionReport::new(&post(), &clip);
    assert!(matches!(report, Err(SkinError::Skeleton(_))));
}
