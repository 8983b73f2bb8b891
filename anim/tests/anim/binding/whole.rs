//! Whole bindings: twists, mixtures, threads, and what does not fit.

use ga_anim::skin::{Binding, Method, Mix, Palette, Posed, SkinError, Stretched, skin};
use ga_anim::weights::SkinWeights;
use ga_runtime::cga3::{Motor, Point, Rotor};
use ga_runtime::vga3::Vector;

use super::{assert_near, case, double};

fn posed(binding: &Binding<f64>, palette: &Palette<f64>, rest: &[Point<f64>]) -> Vec<Point<f64>> {
    let mut moved = rest.to_vec();
    binding.pose(palette, Posed::of_points(&mut moved)).unwrap();
    moved
}

/// A joint that scales about its place at rest scales its vertices by the motor blend as well, and
/// not by dual quaternions.
#[test]
fn motors_keep_scale_and_dual_quaternions_drop_it() {
    let centre = [1.0, 2.0, 3.0];
    let rest = [Point::new(1.0, 3.0, 3.0), Point::new(0.0, 0.0, 0.0)];
    let weights = SkinWeights::new(2, [vec![(1, 1.0)], vec![(0, 0.5), (1, 0.5)]]).unwrap();
    let binding = Binding::new(&rest, &weights).unwrap();
    let scaled = |s: f64| {
        let axis = |r: usize| {
            std::array::from_fn(|c| match c {
                3 => (1.0 - s) * centre[r],
                c if c == r => s,
                _ => 0.0,
            })
        };
        [axis(0), axis(1), axis(2)]
    };
    let matrices = [scaled(1.0), scaled(3.0)];
    for (method, expected) in [
        (Method::Linear, [[1.0, 5.0, 3.0], [-1.0, -2.0, -3.0]]),
        (Method::Motor, [[1.0, 5.0, 3.0], [-1.0, -2.0, -3.0]]),
        (
            Method::DualQuaternion,
            [[-1.0, -1.0, -3.0], [-1.0, -2.0, -3.0]],
        ),
    ] {
        let mut palette = binding.palette(method);
        palette.set_matrices(&matrices).unwrap();
        for (moved, expected) in posed(&binding, &palette, &rest).iter().zip(expected) {
            assert!(
                moved.distance(Point::from(expected)) < 1e-14,
                "{method:?}: {moved:?}"
            );
        }
        let stretched = matrices.map(|rows| Stretched::from_matrix(&rows).unwrap());
        palette.set_stretched(&stretched).unwrap();
        for (moved, expected) in posed(&binding, &palette, &rest).iter().zip(expected) {
            assert!(
                moved.distance(Point::from(expected)) < 1e-14,
                "{method:?}: {moved:?}"
            );
        }
    }
}

/// A cylinder whose end is twisted by 180° collapses to its axis half way by the linear blend, and
/// keeps its radius by the motor blend.
#[test]
fn a_twist_does_not_collapse() {
    let rest: Vec<Point<f64>> = (0..12)
        .map(|k| f64::from(k) * std::f64::consts::TAU / 12.0)
        .map(|angle| Point::new(0.5, angle.cos(), angle.sin()))
        .collect();
    let weights = SkinWeights::new(2, vec![[(0, 0.5), (1, 0.5)]; 12]).unwrap();
    for degrees in [179.0_f64, 180.0, 181.0] {
        let rotor = Rotor::from_axis_angle([1.0, 0.0, 0.0], degrees.to_radians()).unwrap();
        let motions = [Motor::default(), Motor::from(rotor)];
        for (method, radius) in [(Method::Linear, 0.0), (Method::Motor, 1.0)] {
            for moved in skin(&rest, &weights, &motions, method).unwrap() {
                let [_, y, z] = moved.coordinates();
                assert!(
                    (y.hypot(z) - radius).abs() < 0.01,
                    "{method:?} {degrees}: {moved:?}"
                );
            }
        }
    }
}

#[test]
fn a_mixture_is_between_both() {
    let case = case(700);
    let rest = case.points::<f64>();
    let binding = Binding::new(&rest, &case.weights).unwrap();
    let motors = case.motors();
    let [mut linear, mut blend] = [Method::Linear, Method::Motor].map(|m| binding.palette(m));
    linear.set_motions(&motors).unwrap();
    blend.set_motions(&motors).unwrap();
    let (a, b) = (
        posed(&binding, &linear, &rest),
        posed(&binding, &blend, &rest),
    );
    let shares: Vec<f64> = (0..rest.len())
        .map(|vertex| vertex as f64 / 700.0)
        .collect();
    let mut moved = rest.clone();
    for mix in [Mix::Each(&shares), Mix::Whole(0.25)] {
        binding
            .pose_mixed(&linear, &blend, mix, Posed::of_points(&mut moved))
            .unwrap();
        for vertex in 0..rest.len() {
            let share = match mix {
                Mix::Each(shares) => shares[vertex],
                Mix::Whole(share) => share,
            };
            let known =
                double(a[vertex].coordinates()).lerp(double(b[vertex].coordinates()), share);
            assert_near(moved[vertex].coordinates(), known, 1e-13, "mixture");
        }
    }
    let error = binding.pose_mixed(
        &blend,
        &linear,
        Mix::Whole(0.5),
        Posed::of_points(&mut moved),
    );
    assert_eq!(error, Err(SkinError::NotBoth));
}

/// There are enough vertices to be moved on several threads.
#[test]
fn threads_do_not_change_the_result() {
    let case = case(300_000);
    let rest = case.points::<f32>();
    let binding = Binding::new(&rest, &case.weights).unwrap();
    let threads = |count: usize| {
        rayon::ThreadPoolBuilder::new()
            .num_threads(count)
            .build()
            .unwrap()
    };
    for method in [Method::Linear, Method::Motor] {
        let mut palette = binding.palette(method);
        palette.set_motions(&case.motors()).unwrap();
        let [one, several] = [1, 3].map(|count| {
            let mut moved = rest.clone();
            threads(count).install(|| {
                binding
                    .pose(&palette, Posed::of_points(&mut moved))
                    .unwrap()
            });
            moved
        });
        assert!(one == several, "{method:?}");
    }
}

#[test]
fn what_does_not_fit_is_named() {
    let case = case(10);
    let rest = case.points::<f64>();
    let binding = Binding::new(&rest, &case.weights).unwrap();
    let mut palette = binding.palette(Method::Motor);
    let mut motors = case.motors();
    let error = palette.set_motions(&motors[1..]);
    assert_eq!(
        error,
        Err(SkinError::JointCount {
            expected: 40,
            found: 39
        })
    );
    motors[3] = Motor::new_unchecked(f64::NAN, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    assert_eq!(
        palette.set_motions(&motors),
        Err(SkinError::BadMotion { joint: 3 })
    );
    motors[3] = Motor::new_unchecked(0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    assert_eq!(
        palette.set_motions(&motors),
        Err(SkinError::BadMotion { joint: 3 })
    );
    let mut matrices = vec![[[1.0, 0.0, 0.0, 0.0]; 3]; 40];
    matrices[5][2][1] = f64::INFINITY;
    for method in [Method::Linear, Method::Motor, Method::DualQuaternion] {
        let mut palette = binding.palette(method);
        assert_eq!(
            palette.set_matrices(&matrices),
            Err(SkinError::BadMotion { joint: 5 })
        );
    }
    let mut moved = rest.clone();
    let error = binding.pose(&palette, Posed::of_points(&mut moved[1..]));
    assert_eq!(
        error,
        Err(SkinError::VertexCount {
            expected: 10,
            found: 9
        })
    );
    let mut normals = [Vector::default(); 10];
    let posed = Posed {
        points: &mut moved,
        normals: &mut normals,
        tangents: &mut [],
    };
    assert_eq!(binding.pose(&palette, posed), Err(SkinError::NoDirections));
    assert_eq!(moved, rest);
}
