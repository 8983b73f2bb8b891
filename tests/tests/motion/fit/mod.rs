//! Motions fitted to points and directions, against known motions and another library.

mod refused;

use core::f64::consts::PI;

use ga_runtime::cga3::{Motor, Point, Rotor, Similarity, Translator};
use ga_runtime::testing::assert_close;
use nullcone_tests::oracle;
use nullcone_tests::plain::{Vector, cross, dot, length, minus, plus, rotated, unit, vector};
use proptest::prelude::*;
use serde_json::Value;

type Pairs = Vec<(Point<f64>, Point<f64>)>;

/// Four points that span space well, and up to twelve more.
fn points() -> impl Strategy<Value = Vec<Vector>> + Clone {
    prop::collection::vec(vector(3.0), 0..12).prop_map(|mut more| {
        more.extend([[0.0; 3], [4.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 2.0]]);
        more
    })
}

fn paired(from: &[Vector], to: &[Vector]) -> Pairs {
    let pairs = from.iter().zip(to);
    pairs
        .map(|(&x, &y)| (Point::from(x), Point::from(y)))
        .collect()
}

fn image(rows: [[f64; 4]; 3], x: Vector) -> Vector {
    rows.map(|[a, b, c, t]| dot([a, b, c], x) + t)
}

fn mean_square(rows: [[f64; 4]; 3], weighted: &[(f64, Vector, Vector)]) -> f64 {
    let total: f64 = weighted.iter().map(|(w, ..)| w).sum();
    let square = |x, y| {
        let left = minus(y, image(rows, x));
        dot(left, left)
    };
    weighted
        .iter()
        .map(|&(w, x, y)| w * square(x, y))
        .sum::<f64>()
        / total
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn exact_motions_are_found(
        from in points(), axis in unit(), angle in prop_oneof![-PI..PI, Just(PI), Just(0.0), -1e-9..1e-9], t in vector(10.0)
    ) {
        let to: Vec<_> = from.iter().map(|&x| plus(rotated(axis, angle, x), t)).collect();
        let fit = Motor::from_point_pairs(&paired(&from, &to)).unwrap();
        let rows = fit.motion.to_matrix();
        for column in 0..3 {
            let mut e = [0.0; 3];
            e[column] = 1.0;
            assert_close!(rows.map(|row| row[column]), rotated(axis, angle, e), 1e-13, 1.0);
        }
        assert_close!(rows.map(|row| row[3]), t, 1e-13, 10.0);
        prop_assert!(fit.residual(&paired(&from, &to)) < 1e-14 && fit.motion.scalar() >= 0.0);
        // With any weights.
        let weighted: Vec<_> = paired(&from, &to).into_iter().enumerate()
            .map(|(k, (x, y))| (1.0 / (1.0 + k as f64), x, y)).collect();
        let again = Motor::from_weighted_point_pairs(&weighted).unwrap();
        assert_close!(again.motion.to_matrix().map(|row| row.to_vec()).to_vec(), rows.map(|row| row.to_vec()).to_vec(), 1e-13);
        // And with a scaling.
        let larger: Vec<_> = to.iter().map(|y| y.map(|c| c * 0.3)).collect();
        let fit = Similarity::from_point_pairs(&paired(&from, &larger)).unwrap();
        for (&x, &y) in from.iter().zip(&larger) {
            let place = fit.motion.transform(Point::from(x)).centre().unwrap().coordinates();
            assert_close!(place, y, 1e-13, 10.0);
        }
        prop_assert!(fit.residual(&paired(&from, &larger)) < 1e-14);
    }

    #[test]
    fn no_other_motion_fits_better(
        from in points(), noise in prop::collection::vec((vector(2.0), 0.01..5.0), 16), axis in unit(), angle in -PI..PI,
        mirrored in any::<bool>(), others in prop::collection::vec((unit(), -PI..PI), 40)
    ) {
        let weighted: Vec<_> = from.iter().zip(&noise).map(|(&x, &(n, w))| {
            let [a, b, c] = x;
            let y = rotated(axis, angle, if mirrored { [a, b, -c] } else { x });
            (w, x, plus(y, n))
        }).collect();
        let pairs: Vec<_> = weighted.iter().map(|&(w, x, y)| (w, Point::from(x), Point::from(y))).collect();
        let fit = Motor::from_weighted_point_pairs(&pairs).unwrap();
        let rows = fit.motion.to_matrix();
        let least = mean_square(rows, &weighted);
        prop_assert!((least.sqrt() - fit.weighted_residual(&pairs)).abs() < 1e-13 * (1.0 + fit.weighted_residual(&pairs)));
        // The torque and the force of the distances left vanish, and the rows are a rotation.
        let (mut force, mut torque) = ([0.0; 3], [0.0; 3]);
        for &(w, x, y) in &weighted {
            let p = image(rows, x);
            let pull = minus(y, p).map(|c| c * w);
            force = plus(force, pull);
            torque = plus(torque, cross(p, pull));
        }
        prop_assert!(length(force) < 1e-12 && length(torque) < 1e-11, "{force:?} {torque:?}");
        let r = rows.map(|[a, b, c, _]| [a, b, c]);
        prop_assert!((dot(cross(r[0], r[1]), r[2]) - 1.0).abs() < 1e-14);
        // Rotated further about the centroid, by little or by much, it fits worse.
        let total: f64 = weighted.iter().map(|(w, ..)| w).sum();
        let centroid = weighted.iter().fold([0.0; 3], |sum, &(w, _, y)| plus(sum, y.map(|c| c * w / total)));
        for (axis, angle) in others {
            for angle in [angle, angle * 1e-3] {
                let moved = |x: Vector| plus(centroid, rotated(axis, angle, minus(image(rows, x), centroid)));
                let origin = moved([0.0; 3]);
                let e = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|e| minus(moved(e), origin));
                let rows = [0, 1, 2].map(|k| [e[0][k], e[1][k], e[2][k], origin[k]]);
                prop_assert!(mean_square(rows, &weighted) > least - 1e-13);
            }
        }
    }

    #[test]
    fn exact_rotations_of_directions_are_found(axis in unit(), angle in -PI..PI, a in unit(), b in unit(), sizes in prop::array::uniform4(1e-3..1e3)) {
        let apart = length(cross(a, b));
        prop_assume!(apart > 1e-3);
        let turned = |x: Vector, size: f64| rotated(axis, angle, x).map(|c| c * size);
        let [p, q, r, s] = sizes;
        let pairs = [(a.map(|c| c * p), turned(a, q)), (b.map(|c| c * r), turned(b, s))];
        let fit = Rotor::from_direction_pairs(&pairs).unwrap();
        let expected = Rotor::from_axis_angle(axis, angle).unwrap();
        let error = (fit.motion.reverse() * expected).to_axis_angle().1;
        prop_assert!(error.min(2.0 * PI - error) < 1e-14 / apart, "{error} at {apart}");
        prop_assert!(fit.residual(&pairs) < 1e-14);
    }

    #[test]
    fn errors_of_thin_sets_are_as_large_as_their_conditioning(axis in unit(), angle in -PI..PI, thickness in 2.0..6.0_f64, along in unit()) {
        // A rod, whose points are off its axis by a small fraction of its length.
        let side = {
            let e = if along[0].abs() < 0.7 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
            let n = cross(along, e);
            n.map(|c| c / length(n))
        };
        let thin = 10.0_f64.powf(-thickness);
        let from: Vec<_> = [(-1.0, 0.0), (0.0, thin), (1.0, 0.0), (0.5, -thin)]
            .map(|(s, t)| plus(along.map(|c| c * s), side.map(|c| c * t))).to_vec();
        let to: Vec<_> = from.iter().map(|&x| rotated(axis, angle, x)).collect();
        let fit = Motor::from_point_pairs(&paired(&from, &to)).unwrap();
        let expected = Rotor::from_axis_angle(axis, angle).unwrap();
        let error = (fit.motion.rotor().reverse() * expected).to_axis_angle().1;
        prop_assert!(error.min(2.0 * PI - error) < 2e-15 / thin, "{error} at {thin}");
    }
}

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let list = value.as_array().expect("a list");
    std::array::from_fn(|k| list[k].as_f64().expect("a number"))
}

fn vectors(value: &Value) -> Vec<Vector> {
    let list = value.as_array().expect("a list");
    list.iter().map(numbers).collect()
}

fn mean_distance(pairs: &Pairs, moved: impl Fn(Point<f64>) -> Point<f64>) -> f64 {
    let sum: f64 = pairs.iter().map(|&(x, y)| moved(x).distance(y)).sum();
    sum / pairs.len() as f64
}

#[test]
fn another_library_fits_alike() {
    let vectors_file = oracle::extract("anim/procrustes.json");
    let cases = vectors_file["cases"].as_array().unwrap();
    assert_eq!(cases.len(), 4);
    for case in cases {
        let pairs = paired(&vectors(&case["predicted"]), &vectors(&case["target"]));
        let similarity = Similarity::from_point_pairs(&pairs).unwrap();
        let known = &case["similarity"];
        let (rotation, scale) = (vectors(&known["R"]), known["scale"].as_f64().unwrap());
        let shift: Vector = numbers(&known["t"]);
        let moved = |x: Point<f64>| similarity.motion.transform(x).centre().unwrap();
        for (x, _) in &pairs {
            let expected: Vector =
                std::array::from_fn(|k| scale * dot(rotation[k], x.coordinates()) + shift[k]);
            assert_close!(moved(*x).coordinates(), expected, 1e-13);
        }
        let left = mean_distance(&pairs, moved);
        assert_close!(left, case["pa_mpjpe"].as_f64().unwrap(), 1e-13);
        if let Some(expected) = case["rms_similarity"].as_f64() {
            assert_close!(similarity.residual(&pairs), expected, 1e-13);
        }
        // The rotation is the same without scaling, also for mirror images where it is a proper
        // one.
        let rigid = Motor::from_point_pairs(&pairs).unwrap();
        let rows = rigid.motion.to_matrix();
        for (row, expected) in rows.iter().zip(&rotation) {
            assert_close!([row[0], row[1], row[2]], *expected, 1e-13, 1.0);
        }
        if let Some(expected) = case["rigid_mpjpe"].as_f64() {
            let shift: Vector = numbers(&case["rigid"]["t"]);
            assert_close!(rows.map(|row| row[3]), shift, 1e-13);
            let left = mean_distance(&pairs, |x| rigid.motion.transform(x));
            assert_close!(left, expected, 1e-13);
        }
    }
}

#[test]
fn mirror_images_give_the_best_proper_motion() {
    // Mirrored along the axis of least extent: the identity fits best, and the residual is that
    // extent.
    let from: Vec<_> = [[3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 1.0]]
        .into_iter()
        .flat_map(|x| [x, x.map(|c: f64| -c)])
        .collect();
    let to: Vec<_> = from.iter().map(|&[x, y, z]| [x, y, -z]).collect();
    let fit = Motor::from_point_pairs(&paired(&from, &to)).unwrap();
    assert_close!(fit.motion, Motor::from(Rotor::<f64>::default()), 1e-15);
    // Two of six points are off by 2.
    assert_close!(
        fit.residual(&paired(&from, &to)),
        (8.0_f64 / 6.0).sqrt(),
        1e-15
    );
    // Mirrored along the longest axis: a rotation by 180° about the shortest leaves the same
    // residual.
    let to: Vec<_> = from.iter().map(|&[x, y, z]| [-x, y, z]).collect();
    let fit = Motor::from_point_pairs(&paired(&from, &to)).unwrap();
    assert_close!(
        fit.motion,
        Motor::from(Rotor::from_axis_angle([0.0, 1.0, 0.0], PI).unwrap()),
        1e-15
    );
    assert_close!(
        fit.residual(&paired(&from, &to)),
        (8.0_f64 / 6.0).sqrt(),
        1e-15
    );
    // A flat set is its own mirror image.
    let flat = [
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [3.0, 3.0, 0.0],
    ];
    let to = flat.map(|[x, y, _]| [-x, y, 0.0]);
    let fit = Motor::from_point_pairs(&paired(&flat, &to)).unwrap();
    assert!(fit.residual(&paired(&flat, &to)) < 1e-15);
    assert_close!(
        fit.motion,
        Motor::from(Rotor::from_axis_angle([0.0, 1.0, 0.0], PI).unwrap()),
        1e-15
    );
}

#[test]
fn size_and_position_cost_only_their_own_digits() {
    let from = [
        [0.0, 0.0, 0.0],
        [3.0, 0.0, 0.0],
        [0.0, 2.0, 0.0],
        [1.0, 1.0, 1.0],
    ];
    let (axis, angle) = ([0.0, 0.6, 0.8], 2.5);
    let expected = Rotor::from_axis_angle(axis, angle).unwrap();
    for size in [1e-300, 1e-100, 1e-12, 1e12, 1e100, 1e300] {
        let from = from.map(|x| x.map(|c| c * size));
        let to = from.map(|x| rotated(axis, angle, x));
        let fit = Motor::from_point_pairs(&paired(&from, &to)).unwrap();
        assert_close!(fit.motion.rotor(), expected, 1e-14);
        assert!(
            fit.residual(&paired(&from, &to)) < 1e-14 * size,
            "{size}: {}",
            fit.residual(&paired(&from, &to))
        );
        // A rotation by 90° about e3 with scaling s: the scalar is cos 45° cosh(½ ln s).
        let to = [[0.0; 3], [0.0, 6.0, 0.0], [-4.0, 0.0, 0.0]];
        let scaled = Similarity::from_point_pairs(&paired(&from[..3], &to)).unwrap();
        let root = (2.0 / size).sqrt();
        let expected = (0.5_f64).sqrt() * (root + 1.0 / root) / 2.0;
        assert_close!(scaled.motion.scalar(), expected, 1e-14);
    }
    // At a distance of a million, coordinates are known to 1e-10, and so is the rotation.
    let far = [1e6, -2e6, 5e5];
    let to = from.map(|x| plus(rotated(axis, angle, x), far));
    let fit = Motor::from_point_pairs(&paired(&from, &to)).unwrap();
    assert_close!(fit.motion.rotor(), expected, 1e-9);
    assert!(fit.residual(&paired(&from, &to)) < 1e-9);
}

#[test]
fn single_precision_fits_too() {
    let (axis, angle) = ([0.0, 0.6, 0.8], 2.5);
    let from = [
        [0.0, 0.0, 0.0],
        [3.0, 0.0, 0.0],
        [0.0, 2.0, 0.0],
        [1.0, 1.0, 1.0],
    ];
    let narrow = |x: Vector| Point::from(x.map(|c| c as f32));
    let pairs = from.map(|x| {
        (
            narrow(x),
            narrow(plus(rotated(axis, angle, x), [1.0, 2.0, 3.0])),
        )
    });
    let fit = Motor::from_point_pairs(&pairs).unwrap();
    let expected = Translator::from_displacement([1.0_f32, 2.0, 3.0])
        * Rotor::from_axis_angle([0.0, 0.6, 0.8], 2.5).unwrap();
    assert_close!(fit.motion, expected, 1e-6);
    assert!(fit.residual(&pairs) < 1e-6);
}
