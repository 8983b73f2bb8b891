//! Motions of a person who stands, with one thing wrong: what is said of them.

use ga_anim::bvh::{self, Bvh};
use ga_anim::clip::Clip;
use ga_anim::pose::Pose;
use ga_anim::retarget::{Checks, Contact, Fault, FootLocking, Options, Retarget};
use ga_anim::skeleton::Skeleton;
use ga_runtime::cga3::{Motor, Rotor, Translator};
use ga_runtime::vga3::Vector;
use nullcone_shared_data::shared;

/// A centimetre.
const UNIT: f64 = 0.01;
const UP: Vector<f64> = Vector::new(0.0, 1.0, 0.0);

struct Person {
    source: Bvh,
    skeleton: Skeleton,
}

impl Person {
    fn new() -> Option<Self> {
        let path = shared("cases/motion/rest-not-upright/upright.bvh")?;
        let text = std::fs::read_to_string(path).unwrap();
        let (head, frames) = text.split_once("Frame Time: 0.0333333\n").unwrap();
        let head = head.replace("Frames: 4", "Frames: 12");
        let frames = frames.repeat(3);
        let text = format!("{head}Frame Time: 0.0333333\n{frames}");
        let source = bvh::decode(text.as_bytes()).unwrap();
        let skeleton = source.skeleton().unwrap();
        Some(Self { source, skeleton })
    }

    fn joint(&self, name: &str) -> usize {
        self.skeleton.index(name).unwrap()
    }

    fn head(&self, name: &str) -> Vector<f64> {
        self.skeleton.joints()[self.joint(name)].head.into()
    }

    /// From right to left at rest.
    fn left(&self) -> Vector<f64> {
        let way = self.head("LeftUpLeg") - self.head("RightUpLeg");
        way.normalized().unwrap()
    }

    /// What is said of the motion of the person on the person's own skeleton, with a change of each
    /// frame, where both feet stand.
    fn faults(&self, change: impl Fn(usize, &mut Pose)) -> Vec<Fault> {
        self.checks(&Options::default(), |_| true, change).faults
    }

    /// The same where some of the feet stand.
    fn checks(
        &self,
        options: &Options,
        stands: impl Fn(&Contact) -> bool,
        change: impl Fn(usize, &mut Pose),
    ) -> Checks {
        let retarget = Retarget::new(&self.source, &self.skeleton, options).unwrap();
        let locked = retarget.with_foot_locking(&FootLocking::new(UNIT)).unwrap();
        let last = self.source.frame_count() - 1;
        assert!(
            locked
                .contacts()
                .iter()
                .all(|foot| foot.frames == (0..=last))
        );
        assert_eq!(locked.contacts().len(), 2);
        let clip = retarget.clip(0..=last).unwrap();
        let poses = clip.frames().iter().enumerate().map(|(frame, pose)| {
            let mut pose = pose.clone();
            change(frame, &mut pose);
            pose
        });
        let clip = Clip::new(clip.frame_time(), poses.collect()).unwrap();
        let contacts = locked.contacts().iter().filter(|foot| stands(foot));
        let contacts: Vec<Contact> = contacts.cloned().collect();
        retarget.checks(&clip, 0, &contacts, UNIT).unwrap()
    }

    /// The same where a joint is rotated about an axis in some frames.
    fn rotated(
        &self,
        name: &str,
        axis: Vector<f64>,
        degrees: f64,
        is_changed: impl Fn(usize) -> bool,
    ) -> Vec<Fault> {
        self.by_rotor(name, about(axis, degrees), is_changed)
    }

    fn by_rotor(
        &self,
        name: &str,
        rotor: Rotor<f64>,
        is_changed: impl Fn(usize) -> bool,
    ) -> Vec<Fault> {
        let (joint, head) = (self.joint(name), self.head(name));
        let motion = Motor::about(head.coordinates().into(), rotor);
        self.faults(|frame, pose| {
            if is_changed(frame) {
                pose.joints[joint] *= motion;
            }
        })
    }

    fn moved(&self, name: &str, way: [f64; 3]) -> Vec<Fault> {
        let (joint, way) = (self.joint(name), Translator::from_displacement(way));
        self.faults(|_, pose| pose.joints[joint] = way * pose.joints[joint])
    }
}

fn about(axis: Vector<f64>, degrees: f64) -> Rotor<f64> {
    Rotor::from_axis_angle(axis.coordinates(), degrees.to_radians()).unwrap()
}

fn degrees(faults: &[Fault]) -> Option<f64> {
    faults.iter().find_map(|fault| match fault {
        Fault::Sole { degrees, .. } | Fault::Heading { degrees, .. } => Some(*degrees),
        _ => None,
    })
}

fn always(_: usize) -> bool {
    true
}

/// The joints that are named for one kind of fault.
fn named<'a>(faults: &'a [Fault], kind: &str) -> Vec<&'a str> {
    let faults = faults.iter().filter(|fault| fault.kind() == kind);
    faults.map(|fault| fault.place().joint.as_str()).collect()
}

#[test]
fn a_motion_as_it_was_recorded_has_no_faults() {
    let Some(person) = Person::new() else { return };
    assert_eq!(person.faults(|_, _| {}), []);
    // Somewhere else and turned round.
    let turned = Rotor::from_axis_angle([0.0, 1.0, 0.0], 2.0).unwrap();
    let motion = Translator::from_displacement([300.0, 0.0, -40.0]) * turned;
    assert_eq!(person.faults(|_, pose| pose.root = motion * pose.root), []);
}

#[test]
fn soles_lie_flat_in_half_of_the_frames() {
    let Some(person) = Person::new() else { return };
    let kind = "sole_not_flat";
    for axis in [person.left(), person.left().cross(UP)] {
        for foot in ["LeftFoot", "RightFoot"] {
            let faults = person.rotated(foot, axis, 25.0, always);
            assert_eq!(named(&faults, kind), [foot]);
            assert!((degrees(&faults).unwrap() - 25.0).abs() < 1.0, "{faults:?}");
        }
        assert!(named(&person.rotated("LeftFoot", axis, 10.0, always), kind).is_empty());
        let once = person.rotated("LeftFoot", axis, 25.0, |frame| frame == 2);
        assert!(named(&once, kind).is_empty());
        let worst = person.rotated("LeftFoot", axis, 25.0, |frame| frame != 0);
        let place = worst
            .iter()
            .find(|fault| fault.kind() == kind)
            .unwrap()
            .place();
        assert!(place.frame != 0, "{worst:?}");
    }
    // A sole that is turned on the ground is flat.
    assert!(named(&person.rotated("LeftFoot", UP, 60.0, always), kind).is_empty());
}

#[test]
fn feet_point_as_the_pelvis_looks() {
    let Some(person) = Person::new() else { return };
    let kind = "foot_turned_away";
    for foot in ["LeftFoot", "RightFoot"] {
        for angle in [120.0, -120.0, 180.0] {
            let faults = person.rotated(foot, UP, angle, always);
            assert_eq!(named(&faults, kind), [foot]);
            let found = degrees(&faults).unwrap();
            assert!((found - f64::abs(angle)).abs() < 5.0, "{faults:?}");
        }
        assert!(named(&person.rotated(foot, UP, 60.0, always), kind).is_empty());
        assert!(named(&person.rotated(foot, UP, 120.0, |frame| frame == 1), kind).is_empty());
    }
    // It is the direction on the ground that counts: a foot on its toes points ahead.
    let on_toes = person.rotated("LeftFoot", person.left(), 70.0, always);
    assert!(named(&on_toes, kind).is_empty(), "{on_toes:?}");
    let both = about(UP, 120.0) * about(person.left(), 45.0);
    let faults = person.by_rotor("LeftFoot", both, always);
    let heading = faults.iter().filter(|fault| fault.kind() == kind).cloned();
    let found = degrees(&heading.collect::<Vec<_>>()).unwrap();
    assert!((found - 120.0).abs() < 5.0, "{faults:?}");
    // The legs turn below a pelvis that does not.
    let pelvis = person.rotated("LeftUpLeg", UP, 120.0, always);
    assert_eq!(named(&pelvis, kind), ["LeftFoot"]);
}

#[test]
fn knees_bend_to_the_back() {
    let Some(person) = Person::new() else { return };
    let kind = "knee_backwards";
    for knee in ["LeftLeg", "RightLeg"] {
        let backwards = person.rotated(knee, person.left(), -60.0, always);
        assert_eq!(named(&backwards, kind), [knee]);
        assert!(named(&person.rotated(knee, person.left(), 60.0, always), kind).is_empty());
    }
}

#[test]
fn feet_are_on_the_ground() {
    let Some(person) = Person::new() else { return };
    let lifted = |y: f64| {
        let way = Translator::from_displacement([0.0, y, 0.0]);
        person.faults(|_, pose| pose.root = way * pose.root)
    };
    for (y, metres) in [(30.0, 0.3), (-30.0, -0.3)] {
        let faults = lifted(y);
        let [Fault::Height { metres: found, .. }] = &faults[..] else {
            panic!("{faults:?}");
        };
        assert!((found - metres).abs() < 0.02, "{found}");
    }
    assert_eq!(lifted(1.0), []);
}

/// In three quarters of the frames, and unless the height is that of the motion.
#[test]
fn a_leap_is_no_fault() {
    let Some(person) = Person::new() else { return };
    let lifted = |options: &Options, from: usize| {
        let way = Translator::from_displacement([0.0, 30.0, 0.0]);
        let change = |frame: usize, pose: &mut Pose| {
            if frame >= from {
                pose.root = way * pose.root;
            }
        };
        person.checks(options, |_| true, change)
    };
    let leap = lifted(&Options::default(), 6);
    assert_eq!(leap.faults, []);
    assert!(leap.lowest_foot_metres.abs() < 0.02, "{leap:?}");
    assert!(
        leap.worst
            .lowest_foot_metres
            .is_some_and(|place| place.frame < 6)
    );
    assert!((lifted(&Options::default(), 0).lowest_foot_metres - 0.3).abs() < 0.02);
    let keeps_height = Options {
        keeps_height: true,
        ..Options::default()
    };
    assert!(named(&lifted(&keeps_height, 0).faults, "feet_off_ground").is_empty());
}

/// A sole is looked at while its own foot stands on the ground.
#[test]
fn feet_in_the_air_need_not_be_flat() {
    let Some(person) = Person::new() else { return };
    let kind = "sole_not_flat";
    let tilt = about(person.left(), 25.0);
    let tilted = |name: &str| {
        let (joint, head) = (person.joint(name), person.head(name));
        let motion = Motor::about(head.coordinates().into(), tilt);
        move |_: usize, pose: &mut Pose| pose.joints[joint] *= motion
    };
    let right = person.joint("RightFoot");
    for (name, expected) in [("LeftFoot", &[][..]), ("RightFoot", &["RightFoot"])] {
        let stands = |foot: &Contact| foot.ankle == right;
        let checks = person.checks(&Options::default(), stands, tilted(name));
        assert_eq!(named(&checks.faults, kind), expected);
    }
    // Tilted in the seven frames of twelve in which it is lifted.
    let up = Translator::from_displacement([0.0, 30.0, 0.0]);
    let change = tilted("LeftFoot");
    let left = person.joint("LeftFoot");
    let faults = person.faults(|frame, pose| {
        if frame < 7 {
            change(frame, pose);
            pose.joints[left] = up * pose.joints[left];
        }
    });
    assert!(named(&faults, kind).is_empty(), "{faults:?}");
}

#[test]
fn other_faults_name_their_joints() {
    let Some(person) = Person::new() else { return };
    let head = person.rotated("Head", person.left(), 80.0, always);
    assert_eq!(named(&head, "head_off_trunk"), ["Head"]);
    assert!(
        named(
            &person.rotated("Head", person.left(), 40.0, always),
            "head_off_trunk"
        )
        .is_empty()
    );
    let stretched = person.moved("LeftHand", [0.0, 0.0, 2.0]);
    assert_eq!(named(&stretched, "bone_stretched"), ["LeftHand"]);
    let spins = person.rotated("LeftHand", UP, 90.0, |frame| frame == 2);
    assert_eq!(named(&spins, "rotation_too_fast"), ["LeftHand"]);
    assert!(
        named(
            &person.rotated("LeftHand", UP, 90.0, always),
            "rotation_too_fast"
        )
        .is_empty()
    );
}
