//! A person in views that are wrong in the ways of real films, against the walk that made them.

use std::sync::LazyLock;

use ga_anim::gltf::Rigged;
use ga_anim::pose::Pose;
use ga_anim::skeleton::Skeleton;
use ga_body::character::{CharacterFit, FittedCharacter, Severity};
use ga_body::format::{JointView, JointViews};
use ga_body::ground::{GroundOptions, UpSource};
use ga_body::registration::RegistrationOptions;
use ga_body::{JointPixel, Lengths};
use ga_camera::observation::observe;
use ga_camera::{Camera, Intrinsics};
use ga_mannequin::skeleton;
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};

const RATE: f64 = 30.0;
const FRAMES: usize = 60;
const NOISE: f64 = 2.0;
/// The names of a detector and the joints of the mannequin that they mean.
const JOINTS: [(&str, &str); 12] = [
    ("left_shoulder", "LeftUpperArm"),
    ("right_shoulder", "RightUpperArm"),
    ("left_elbow", "LeftLowerArm"),
    ("right_elbow", "RightLowerArm"),
    ("left_wrist", "LeftHand"),
    ("right_wrist", "RightHand"),
    ("left_hip", "LeftUpperLeg"),
    ("right_hip", "RightUpperLeg"),
    ("left_knee", "LeftLowerLeg"),
    ("right_knee", "RightLowerLeg"),
    ("left_ankle", "LeftFoot"),
    ("right_ankle", "RightFoot"),
];
/// Points of the skin: the joint that each is fixed to, and where it is at rest.
const SKIN: [(&str, &str, [f64; 3]); 5] = [
    ("nose", "Head", [0.0, 1.63, 0.11]),
    ("left_ear", "Head", [0.078, 1.64, 0.0]),
    ("right_ear", "Head", [-0.078, 1.64, 0.0]),
    ("left_heel", "LeftFoot", [0.095, 0.03, -0.085]),
    ("right_heel", "RightFoot", [-0.095, 0.03, -0.085]),
];

struct Walk {
    skeleton: Skeleton,
    /// For each frame the points of `JOINTS` and `SKIN`.
    points: Vec<Vec<Point<f64>>>,
    /// For each frame the heads of all joints.
    heads: Vec<Vec<Point<f64>>>,
}

static WALK: LazyLock<Walk> = LazyLock::new(|| {
    let skeleton = skeleton();
    let clip = ga_mannequin::walk(2);
    let poses: Vec<Pose> = (0..FRAMES)
        .map(|frame| clip.sample(frame as f64 / RATE))
        .collect();
    let of_frame = |pose: &Pose| {
        let motions = pose.motions(&skeleton).unwrap();
        let joint = |name: &str| skeleton.index(name).unwrap();
        let heads = JOINTS.iter().map(|(_, name)| {
            let joint = joint(name);
            motions[joint].transform(Point::from(skeleton.joints()[joint].head))
        });
        let skin = SKIN
            .iter()
            .map(|(_, name, at)| motions[joint(name)].transform(Point::from(*at)));
        heads.chain(skin).collect()
    };
    let heads = |pose: &Pose| {
        let bones = pose.bones(&skeleton).unwrap();
        bones.into_iter().map(|[head, _]| head.into()).collect()
    };
    Walk {
        points: poses.iter().map(of_frame).collect(),
        heads: poses.iter().map(heads).collect(),
        skeleton,
    }
});

fn cameras(count: usize) -> Vec<Camera> {
    let intrinsics = Intrinsics::new([1200.0; 2], [960.0, 540.0]).unwrap();
    let around = (0..count).map(|view| {
        let angle = 0.4 + 1.1 * view as f64;
        let eye = Point::new(4.5 * angle.sin(), 1.6, 1.0 + 4.5 * angle.cos());
        Camera::look_at(intrinsics, eye, Point::new(0.0, 0.9, 1.0), [0.0, 1.0, 0.0]).unwrap()
    });
    around.collect()
}

/// What cameras show: view v shows at its frame t what happens at t − `late`\[v\].
fn seen(cameras: &[Camera], late: &[usize], seed: u64) -> Vec<JointView> {
    let view = |(view, camera): (usize, &Camera)| {
        let frames = (0..FRAMES).map(|frame| {
            let points = &WALK.points[frame.saturating_sub(late[view])];
            let pixels = observe(camera, points, NOISE, seed + (view * FRAMES + frame) as u64);
            let pixels = pixels.unwrap().into_iter();
            pixels
                .map(|position| {
                    Some(JointPixel {
                        position,
                        deviation: NOISE,
                    })
                })
                .collect()
        });
        JointView {
            name: format!("camera {}", view + 1),
            frames: frames.collect(),
        }
    };
    cameras.iter().enumerate().map(view).collect()
}

fn joints(views: Vec<JointView>) -> JointViews {
    let names = JOINTS
        .iter()
        .map(|(name, _)| *name)
        .chain(SKIN.iter().map(|(name, ..)| *name));
    JointViews::new(names.map(str::to_owned).collect(), Some(RATE), views).unwrap()
}

fn fit<'a>(joints: &'a JointViews, cameras: &[Camera]) -> CharacterFit<'a> {
    CharacterFit::new(Rigged::of_skeleton(&WALK.skeleton), joints, cameras).unwrap()
}

fn done(fit: CharacterFit<'_>) -> FittedCharacter {
    fit.fit(RATE, false, |_, _| ()).unwrap()
}

/// The mean distance of the twelve joints from the truth, in metres.
fn error(fitted: &FittedCharacter) -> f64 {
    let frames = fitted.poses.iter().zip(&WALK.points);
    let distances = frames.flat_map(|(pose, truth)| {
        let points = pose.points.iter().zip(truth).take(JOINTS.len());
        points.map(|(found, truth)| found.distance(*truth))
    });
    distances.sum::<f64>() / (FRAMES * JOINTS.len()) as f64
}

/// Exchanges the names of the sides.
fn exchange(frame: &mut [Option<JointPixel>]) {
    for pair in (0..JOINTS.len()).step_by(2) {
        frame.swap(pair, pair + 1);
    }
    frame.swap(13, 14);
    frame.swap(15, 16);
}

#[test]
fn sides_that_are_exchanged_for_a_while_are_put_right() {
    for count in [2, 3] {
        let cameras = cameras(count);
        let clean = joints(seen(&cameras, &[0; 3], 0));
        let clean = error(&done(fit(&clean, &cameras)));
        let mut views = seen(&cameras, &[0; 3], 0);
        // 30 % of the frames: a long stretch, a short one, and single ones.
        let wrong: Vec<usize> = [3, 50, 57]
            .into_iter()
            .chain(12..24)
            .chain(40..43)
            .collect();
        for &frame in &wrong {
            exchange(&mut views[1].frames[frame]);
        }
        let views = joints(views);
        let fitted = done(fit(&views, &cameras));
        let found = error(&fitted);
        assert!(
            found < 1.3 * clean,
            "{count}: {found} m, and {clean} m without"
        );
        let mut expected = wrong.clone();
        expected.sort_unstable();
        assert_eq!(
            fitted.report.per_view[1].frames_with_exchanged_sides,
            expected
        );
        assert!(
            fitted.report.per_view[0]
                .frames_with_exchanged_sides
                .is_empty()
        );
        let finding = fitted
            .findings
            .iter()
            .find(|finding| finding.kind == "exchanged_sides");
        let finding = finding.unwrap();
        assert_eq!(
            (finding.view.as_deref(), finding.frame),
            (Some("camera 2"), Some(3))
        );
        assert!(finding.message.contains("12–23"), "{finding}");
    }
}

#[test]
fn views_that_begin_later_are_shifted_on_request() {
    let cameras = cameras(3);
    let views = joints(seen(&cameras, &[0, 4, 0], 7));
    let options = RegistrationOptions::default();
    let apart = done(fit(&views, &cameras).registered(&options, false, false));
    let offset = apart.report.per_view[1].offset_frames.unwrap();
    assert!((offset - 4.0).abs() < 0.2, "{offset}");
    let finding = apart
        .findings
        .iter()
        .find(|finding| finding.kind == "offset")
        .unwrap();
    assert_eq!(finding.view.as_deref(), Some("camera 2"));
    assert_eq!(finding.severity, Severity::Doubtful);
    let together = done(fit(&views, &cameras).registered(&options, false, true));
    let [before, after] = [&apart, &together].map(error);
    assert!(after < 0.5 * before && after < 0.02, "{before} {after}");
}

#[test]
fn an_offset_at_the_limit_of_the_search_is_not_said_to_be_put_right() {
    let cameras = cameras(3);
    let views = joints(seen(&cameras, &[0, 6, 0], 7));
    let options = RegistrationOptions {
        most_frames: 4,
        ..RegistrationOptions::default()
    };
    for synchronise in [false, true] {
        let fitted = done(fit(&views, &cameras).registered(&options, true, synchronise));
        assert_eq!(fitted.report.per_view[1].offset_frames, None);
        let of_times = fitted.findings.iter();
        let of_times: Vec<_> = of_times
            .filter(|finding| finding.kind.contains("offset"))
            .collect();
        let [finding] = of_times.as_slice() else {
            panic!("{of_times:?}");
        };
        assert_eq!(finding.kind, "unknown_offset");
        assert_eq!(finding.severity, Severity::Doubtful);
        assert_eq!(finding.view.as_deref(), Some("camera 2"));
        assert!(
            finding.message.contains("4 frames or more before"),
            "{finding}"
        );
        // Nothing of that view is changed.
        assert!(fitted.report.per_view[1].rotation_degrees.unwrap() < 1e-6);
    }
}

#[test]
fn a_rig_that_is_pitched_stands_on_its_floor() {
    let pitch = Rotor::from_axis_angle([1.0, 0.0, 0.3], 0.12).unwrap();
    let to_world = Motor::from(pitch);
    // The world of the cameras is pitched against the one in which the person walks.
    let pitched = cameras(3).into_iter().map(|camera| Camera {
        world_to_camera: camera.world_to_camera * to_world.reverse(),
        ..camera
    });
    let pitched: Vec<Camera> = pitched.collect();
    let views = joints(seen(&cameras(3), &[0; 3], 20));
    let fitted = done(
        fit(&views, &pitched)
            .with_lengths(Some(Lengths::EachBone))
            .with_ground(GroundOptions::default()),
    );
    let ground = fitted.report.ground.as_ref().unwrap();
    let truth = to_world
        .transform(ga_runtime::cga3::Direction::new(0.0, 1.0, 0.0))
        .vector();
    let cosine: f64 = ground.up.iter().zip(truth).map(|(a, b)| a * b).sum();
    assert!(cosine.acos().to_degrees() < 2.0, "{ground:?}");
    assert!(cosine.acos().to_degrees() < 3.0 * ground.up_deviation_degrees.max(0.1));
    assert_ne!(ground.up_is, UpSource::Given);
    assert!(!ground.contacts.is_empty());
    for contact in &ground.contacts {
        assert!(contact.slide_metres < 0.01, "{contact:?}");
    }
    // The result has y up and the floor at 0: ankles are as high as in the truth.
    let foot = WALK.skeleton.index("LeftFoot").unwrap();
    for (pose, truth) in fitted.poses.iter().zip(&WALK.heads) {
        let found = pose.pose.bones(fitted.character.skeleton()).unwrap()[foot][0][1];
        let truth = truth[foot].coordinates()[1];
        assert!((found - truth).abs() < 0.04, "{found} {truth}");
    }
}

/// For each of `cameras(3)` the rotation vector and the translation of the other pose in which it
/// sees the 6 × 5 corners of a board almost alike, with squares of 15 cm, from the origin along x
/// and z: the local minimum of the squared distances of the corners, by
/// `scipy.optimize.least_squares` from the reflected board. The distances are 4 to 6 px, RMS.
const OTHER_POSES: [[[f64; 3]; 2]; 3] = [
    [
        [-0.453785, -0.156224, 0.110099],
        [0.30724, 0.641415, 4.89969],
    ],
    [
        [-0.426365, -1.125468, 0.436405],
        [0.872907, 0.725009, 4.014432],
    ],
    [
        [-0.233844, -2.456118, 0.854469],
        [0.512539, 1.064072, 3.972255],
    ],
];

#[test]
fn cameras_in_the_other_pose_of_a_board_on_the_floor_are_turned_back() {
    let right = cameras(3);
    let views = joints(seen(&right, &[0; 3], 80));
    let with_ground = GroundOptions {
        has_upright_axis: true,
        ..GroundOptions::default()
    };
    let fitted = |cameras: &[Camera]| {
        let fit = fit(&views, cameras).with_board_poses();
        let fit = fit.registered(&RegistrationOptions::default(), false, false);
        done(fit.with_ground(with_ground))
    };
    let kinds = |fitted: &FittedCharacter, kind: &str| {
        let own = fitted
            .findings
            .iter()
            .filter(|finding| finding.kind == kind);
        own.filter_map(|finding| finding.view.clone())
            .collect::<Vec<String>>()
    };
    for wrong in [vec![0, 1, 2], vec![1]] {
        let mut given = right.clone();
        for &view in &wrong {
            let [rotation, way] = OTHER_POSES[view];
            let angle = rotation.iter().map(|x| x * x).sum::<f64>().sqrt();
            let rotor = Rotor::from_axis_angle(rotation, angle).unwrap();
            given[view].world_to_camera = Translator::from_displacement(way) * rotor;
        }
        let found = fitted(&given);
        let expected: Vec<String> = wrong.iter().map(|v| format!("camera {}", v + 1)).collect();
        assert_eq!(kinds(&found, "mirrored_pose"), expected);
        let ground = found.report.ground.as_ref().unwrap();
        assert_eq!(ground.up, [0.0, 1.0, 0.0]);
        assert!(kinds(&found, "below_floor").is_empty());
        for (camera, truth) in found.cameras.iter().zip(&right) {
            let (_, angle) = (camera.world_to_camera.rotor()
                * truth.world_to_camera.rotor().reverse())
            .canonical()
            .to_axis_angle();
            let apart = camera.centre().distance(truth.centre());
            assert!(
                angle.to_degrees() < 1.0,
                "{wrong:?}: {}°",
                angle.to_degrees()
            );
            assert!(apart < 0.1, "{wrong:?}: {apart} m");
        }
        assert!(error(&found) < 0.06, "{wrong:?}: {} m", error(&found));
    }
    // Right cameras stay, also those that hang upside down from a ceiling.
    for angle in [0.0, std::f64::consts::PI] {
        let rolled = Rotor::from_axis_angle([0.0, 0.0, 1.0], angle).unwrap();
        let hung: Vec<Camera> = right
            .iter()
            .map(|camera| Camera {
                world_to_camera: Motor::from(rolled) * camera.world_to_camera,
                ..*camera
            })
            .collect();
        let views = joints(seen(&hung, &[0; 3], 90));
        let fit = fit(&views, &hung).with_board_poses();
        let found = done(fit.with_ground(with_ground));
        assert!(kinds(&found, "mirrored_pose").is_empty(), "{angle}");
        assert!(error(&found) < 0.03, "{angle}: {} m", error(&found));
    }
}

#[test]
fn a_view_of_somebody_else_is_named() {
    let cameras = cameras(3);
    let mut views = seen(&cameras, &[0; 3], 40);
    for frame in &mut views[2].frames {
        for pixel in frame.iter_mut().flatten() {
            pixel.position[0] -= 250.0;
        }
    }
    let views = joints(views);
    let fitted = done(fit(&views, &cameras));
    let finding = fitted
        .findings
        .iter()
        .find(|finding| finding.kind == "bad_view")
        .unwrap();
    assert_eq!(finding.view.as_deref(), Some("camera 3"));
    assert!(error(&fitted) < 0.04, "{} m", error(&fitted));
}

#[test]
fn points_of_the_skin_orient_the_head() {
    let cameras = cameras(3);
    let views = joints(seen(&cameras, &[0; 3], 60));
    let fitted = done(fit(&views, &cameras).with_lengths(Some(Lengths::EachBone)));
    let nose = JOINTS.len();
    for (pose, truth) in fitted.poses.iter().zip(&WALK.points) {
        let facing = |points: &[Point<f64>]| {
            let [nose, left, right] = [0, 1, 2].map(|k| points[nose + k].coordinates());
            let way = [0, 1, 2].map(|k| nose[k] - 0.5 * (left[k] + right[k]));
            let length = way.iter().map(|x| x * x).sum::<f64>().sqrt();
            way.map(|x| x / length)
        };
        let [found, truth] = [facing(&pose.points), facing(truth)];
        let cosine: f64 = found.iter().zip(truth).map(|(a, b)| a * b).sum();
        assert!(cosine.min(1.0).acos().to_degrees() < 8.0);
    }
    assert_eq!(fitted.report.points_of_the_skin.len(), SKIN.len());
}
