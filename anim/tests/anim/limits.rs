//! Joint limits against plain quaternions, and skeletons in any order.

use std::f64::consts::{PI, TAU};

use ga_anim::skeleton::{Joint, JointLimits, Limit, Skeleton, SkeletonError};
use ga_runtime::cga3::Rotor;
use proptest::prelude::*;

/// A quaternion x, y, z, w.
type Quaternion = [f64; 4];

fn quaternion(axis: [f64; 3], angle: f64) -> Quaternion {
    let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
    let (sine, cosine) = (0.5 * angle).sin_cos();
    let [x, y, z] = axis.map(|x| x / length * sine);
    [x, y, z, cosine]
}

fn product([a, b, c, d]: Quaternion, [e, f, g, h]: Quaternion) -> Quaternion {
    [
        d * e + a * h + b * g - c * f,
        d * f - a * g + b * h + c * e,
        d * g + a * f - b * e + c * h,
        d * h - a * e - b * f - c * g,
    ]
}

fn of(rotor: Rotor<f64>) -> Quaternion {
    let ([x, y, z], w) = rotor.to_quaternion();
    [x, y, z, w]
}

/// The angle of the rotation between two.
fn between(a: Quaternion, b: Quaternion) -> f64 {
    let dot: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
    let sign = if dot < 0.0 { -1.0 } else { 1.0 };
    let length = |s: f64| -> f64 {
        let squares = a.iter().zip(b).map(|(a, b)| (a + s * sign * b).powi(2));
        squares.sum::<f64>().sqrt()
    };
    4.0 * length(-1.0).atan2(length(1.0))
}

fn one_joint() -> Skeleton {
    let joint = Joint {
        name: "joint".into(),
        parent: None,
        head: [0.0; 3],
        tail: [0.0, 1.0, 0.0],
    };
    Skeleton::new(vec![joint]).unwrap()
}

fn limits(limit: Limit) -> JointLimits {
    JointLimits::new(&one_joint(), vec![limit]).unwrap()
}

fn axes() -> impl Strategy<Value = [f64; 3]> {
    let not_short = |axis: &[f64; 3]| axis.iter().map(|x| x * x).sum::<f64>() > 1e-2;
    prop::array::uniform3(-1.0..1.0_f64).prop_filter("short", not_short)
}

fn rotors() -> impl Strategy<Value = Rotor<f64>> {
    (axes(), -TAU..TAU).prop_map(|(axis, angle)| Rotor::from_axis_angle(axis, angle).unwrap())
}

fn ranges() -> impl Strategy<Value = [f64; 2]> {
    (-4.0..4.0_f64, 0.0..TAU).prop_map(|(low, width)| [low, low + width])
}

/// A unit vector perpendicular to an axis, at an angle about it.
fn aside(axis: [f64; 3], angle: f64) -> [f64; 3] {
    let cross =
        |[a, b, c]: [f64; 3], [d, e, f]: [f64; 3]| [b * f - c * e, c * d - a * f, a * e - b * d];
    let unit = |v: [f64; 3]| {
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        v.map(|x| x / length)
    };
    let axis = unit(axis);
    let other = if axis[0].abs() < 0.6 {
        [1.0, 0.0, 0.0]
    } else {
        [0.0, 1.0, 0.0]
    };
    let first = unit(cross(axis, other));
    let second = cross(axis, first);
    std::array::from_fn(|k| angle.cos() * first[k] + angle.sin() * second[k])
}

proptest! {
    #[test]
    fn nothing_admissible_is_nearer_than_the_clamped_rotation(
        rotor in rotors(),
        axis in axes(),
        range in ranges(),
        swing in 0.0..PI,
        samples in prop::collection::vec((0.0..1.0_f64, 0.0..1.0_f64, 0.0..TAU), 200),
    ) {
        let hinge = limits(Limit::Hinge { axis, range }).clamp(0, rotor);
        let least = between(of(hinge), of(rotor));
        // The hinge itself: about its axis, by an angle in the range.
        let about_hinge = |angle| quaternion(axis, angle);
        let nearest_on_grid = (0..=2000)
            .map(|k| about_hinge(range[0] + (range[1] - range[0]) * f64::from(k) / 2000.0))
            .map(|on_grid| between(on_grid, of(hinge)))
            .fold(f64::INFINITY, f64::min);
        prop_assert!(nearest_on_grid < 2e-3, "not admissible: {nearest_on_grid}");

        let cone = limits(Limit::SwingTwist { axis, swing, twist: range });
        let clamped = cone.clamp(0, rotor);
        let least_of_cone = between(of(clamped), of(rotor));
        for (twist, part, direction) in samples {
            let twist = about_hinge(range[0] + (range[1] - range[0]) * twist);
            prop_assert!(between(twist, of(rotor)) >= least - 1e-9);
            let admissible = product(quaternion(aside(axis, direction), swing * part), twist);
            prop_assert!(between(admissible, of(rotor)) >= least_of_cone - 1e-9);
        }
        // It is admissible: how far the axis swings, and whether it is clamped again.
        let ([x, y, z], w) = clamped.to_quaternion();
        let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
        let along = (x * axis[0] + y * axis[1] + z * axis[2]) / length;
        let swung = 2.0 * (along.hypot(w)).min(1.0).acos();
        prop_assert!(swung <= swing + 1e-7, "{swung} in a cone of {swing}");
        prop_assert!(between(of(cone.clamp(0, clamped)), of(clamped)) < 1e-9);
        if along.hypot(w) > 1e-6 {
            let found = 2.0 * along.atan2(w);
            let above = range[0] + (found - range[0]).rem_euclid(TAU);
            let beyond = (above - range[1]).max(0.0).min(range[0] + TAU - above);
            prop_assert!(beyond < 1e-7, "twist {found} in {range:?}");
        }
    }

    #[test]
    fn what_is_admissible_stays(
        axis in axes(), range in ranges(), swing in 0.0..PI,
        part in 0.0..1.0_f64, tilt in 0.0..0.999_f64, direction in 0.0..TAU,
    ) {
        let angle = range[0] + (range[1] - range[0]) * part;
        let twist = Rotor::from_axis_angle(axis, angle).unwrap();
        let hinge = limits(Limit::Hinge { axis, range });
        prop_assert!(hinge.excess(0, twist) < 1e-14);
        let rotor = Rotor::from_axis_angle(aside(axis, direction), swing * tilt).unwrap() * twist;
        let cone = limits(Limit::SwingTwist { axis, swing, twist: range });
        prop_assert!(cone.excess(0, rotor) < 1e-13);
        prop_assert!(limits(Limit::Free).excess(0, rotor) < 1e-15);
        prop_assert!((limits(Limit::Fixed).excess(0, rotor) - between(of(rotor), [0.0, 0.0, 0.0, 1.0])).abs() < 1e-14);
    }

    #[test]
    fn joints_in_any_order_form_the_same_tree(
        parents in prop::collection::vec(any::<prop::sample::Index>(), 1..12),
        order in Just((0..12).collect::<Vec<usize>>()).prop_shuffle(),
    ) {
        // Joint k has a parent before it; then all are shuffled.
        let count = parents.len();
        let order: Vec<usize> = order.into_iter().filter(|&k| k < count).collect();
        let place = |k: usize| order.iter().position(|&other| other == k).unwrap();
        let parent = |k: usize| (k > 0).then(|| parents[k].index(k));
        let joints = order.iter().map(|&k| Joint {
            name: format!("j{k}"),
            parent: parent(k).map(place),
            head: [k as f64; 3],
            tail: [0.0; 3],
        });
        let (skeleton, from) = Skeleton::in_any_order(joints.collect()).unwrap();
        prop_assert_eq!(skeleton.len(), count);
        for (index, joint) in skeleton.joints().iter().enumerate() {
            let k = order[from[index]];
            prop_assert_eq!(&joint.name, &format!("j{k}"));
            let above = joint.parent.map(|parent| skeleton.joints()[parent].name.clone());
            prop_assert_eq!(above, parent(k).map(|parent| format!("j{parent}")));
        }
    }
}

#[test]
fn faults_name_the_joint() {
    let skeleton = one_joint();
    let wrong = |limit| {
        JointLimits::new(&skeleton, vec![limit])
            .unwrap_err()
            .to_string()
    };
    let (axis, range) = ([0.0, 0.0, 1.0], [-1.0, 1.0]);
    let hinge = |axis, range| Limit::Hinge { axis, range };
    assert_eq!(
        wrong(hinge([0.0; 3], range)),
        "joint \"joint\": [0.0, 0.0, 0.0] is not an axis"
    );
    assert_eq!(
        wrong(hinge(axis, [1.0, 0.5])),
        "joint \"joint\": from 1 to 0.5 rad is not a range of angles"
    );
    for range in [[0.0, 7.0], [f64::NAN, 1.0], [f64::NEG_INFINITY, 0.0]] {
        assert!(wrong(hinge(axis, range)).contains("is not a range of angles"));
    }
    for swing in [-0.1, 3.2, f64::NAN] {
        let limit = Limit::SwingTwist {
            axis,
            swing,
            twist: range,
        };
        assert!(wrong(limit).ends_with("is not the angle of a cone"));
    }
    assert_eq!(
        JointLimits::new(&skeleton, vec![]),
        Err(SkeletonError::LimitCount {
            expected: 1,
            found: 0
        })
    );
}

#[test]
fn cycles_and_missing_parents_are_named() {
    let joint = |name: &str, parent| Joint {
        name: name.into(),
        parent,
        head: [0.0; 3],
        tail: [0.0; 3],
    };
    let of = |parents: &[(&str, Option<usize>)]| {
        Skeleton::in_any_order(
            parents
                .iter()
                .map(|&(name, parent)| joint(name, parent))
                .collect(),
        )
    };
    let name = || "b".to_owned();
    assert_eq!(of(&[]), Err(SkeletonError::Empty));
    let ring = [
        ("a", Some(3)),
        ("b", Some(2)),
        ("c", Some(3)),
        ("d", Some(1)),
    ];
    assert_eq!(of(&ring), Err(SkeletonError::Cycle { name: name() }));
    assert_eq!(
        of(&[("b", Some(0))]),
        Err(SkeletonError::Cycle { name: name() })
    );
    let missing = SkeletonError::ParentMissing {
        name: name(),
        parent: 2,
    };
    assert_eq!(of(&[("a", None), ("b", Some(2))]), Err(missing));
    let twice = SkeletonError::DuplicateName { name: name() };
    assert_eq!(of(&[("b", None), ("b", Some(0))]), Err(twice));
}
