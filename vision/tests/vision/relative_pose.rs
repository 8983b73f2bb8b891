//! Epipolar geometry against the oracle's rigs and against scenes that are known.

use ga_camera::{Camera, Intrinsics};
use ga_image::grey::Luma;
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use ga_runtime::vga3::Vector;
use ga_vision::ViewGeometryError;
use ga_vision::feature::{PixelPair, ViewOptions, match_views};
use ga_vision::relative_pose::{
    Bearing, BearingPair, EssentialMatrix, FundamentalMatrix, FundamentalOptions, Options, View,
    eight_point, estimate, estimate_from_bearings, estimate_fundamental, five_point, seven_point,
};
use proptest::prelude::*;
use serde_json::Value;

use super::{motor, vector};
use nullcone_shared_data::json::{matrix, numbers, rows};

/// A rig of the oracle, all of its points.
struct Rig {
    left: Intrinsics,
    right: Intrinsics,
    truth: Motor<f64>,
    pairs: Vec<PixelPair>,
    noise: f64,
    record: Value,
}

fn rigs() -> Vec<Rig> {
    let Some(path) = nullcone_shared_data::shared("oracle/vision/seed1/truth.json") else {
        return Vec::new();
    };
    let text = std::fs::read_to_string(path).expect("the oracle is readable");
    let oracle: Value = serde_json::from_str(&text).expect("JSON");
    let rigs = oracle["rigs"].as_array().expect("rigs").iter();
    let rigs = rigs.map(|record| {
        let intrinsics = |key: &str| Intrinsics::from_matrix(matrix(&record[key])).expect("K");
        let (rotation, translation) = (matrix(&record["R"]), numbers::<3>(&record["t"]));
        let row = |k: usize| {
            let [x, y, z] = rotation[k];
            [x, y, z, translation[k]]
        };
        let pixels = rows(&record["left"])
            .into_iter()
            .zip(rows(&record["right"]));
        Rig {
            left: intrinsics("K1"),
            right: intrinsics("K2"),
            truth: Motor::from_matrix([row(0), row(1), row(2)]).expect("a motion"),
            pairs: pixels
                .map(|(left, right)| PixelPair { left, right })
                .collect(),
            noise: record["sigma_px"].as_f64().expect("a number"),
            record: record.clone(),
        }
    });
    rigs.collect()
}

fn translation(motion: Motor<f64>) -> Vector<f64> {
    motion.translator().displacement().into()
}

/// The angle of the rotation between two motions, and that between their translations, in radians.
fn errors(found: Motor<f64>, truth: Motor<f64>) -> [f64; 2] {
    let between = found.rotor() * truth.rotor().reverse();
    let ([x, y, z], w) = between.to_quaternion();
    let angle = 2.0 * Vector::new(x, y, z).length().atan2(w.abs());
    let directions = translation(found).angle(translation(truth));
    [angle, directions.expect("translations")]
}

/// No pixel with noise of half a pixel is an outlier of three pixels.
fn generous() -> Options {
    Options {
        threshold: 3.0,
        ..Options::default()
    }
}

#[test]
fn exact_rigs_of_the_oracle_are_found_to_rounding() {
    for rig in rigs().iter().filter(|rig| rig.noise == 0.0) {
        let found = estimate(&rig.pairs, &rig.left, &rig.right, &Options::default()).unwrap();
        let [rotation, direction] = errors(found.left_to_right.motor, rig.truth);
        assert!(
            rotation < 1e-9 && direction < 1e-9,
            "{rotation:e} {direction:e}"
        );
        assert_eq!((found.inliers.len(), found.in_front), (40, 40));
        assert!(found.root_mean_square < 1e-9);
        let essential = EssentialMatrix::from_motor(found.left_to_right.motor).unwrap();
        assert_equal_up_to_scale(essential.rows(), matrix(&rig.record["E"]));
    }
}

/// Equality within 1e-9 of matrices that are scaled to a sum of squares of 1, up to sign.
fn assert_equal_up_to_scale(found: [[f64; 3]; 3], expected: [[f64; 3]; 3]) {
    let norm = |m: [[f64; 3]; 3]| m.as_flattened().iter().map(|x| x * x).sum::<f64>().sqrt();
    let pairs = || found.as_flattened().iter().zip(expected.as_flattened());
    let sign = pairs().map(|(a, b)| a * b).sum::<f64>().signum();
    let (a_norm, b_norm) = (norm(found), norm(expected) * sign);
    for (a, b) in pairs() {
        assert!(
            (a / a_norm - b / b_norm).abs() < 1e-9,
            "{found:?} {expected:?}"
        );
    }
}

/// The sum of squared Sampson distances, by matrices and without the code under test.
fn sampson_cost(rig: &Rig, motion: Motor<f64>) -> f64 {
    let (rotation, t) = (
        motion.rotor().to_matrix(),
        motion.translator().displacement(),
    );
    let cross = [[0.0, -t[2], t[1]], [t[2], 0.0, -t[0]], [-t[1], t[0], 0.0]];
    let product = |a: [[f64; 3]; 3], b: [[f64; 3]; 3]| -> [[f64; 3]; 3] {
        std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
    };
    let inverse = |camera: &Intrinsics| {
        let ([fx, fy], [cx, cy]) = (camera.focal(), camera.principal());
        [
            [1.0 / fx, 0.0, -cx / fx],
            [0.0, 1.0 / fy, -cy / fy],
            [0.0, 0.0, 1.0],
        ]
    };
    let transposed = |m: [[f64; 3]; 3]| -> [[f64; 3]; 3] {
        std::array::from_fn(|i| std::array::from_fn(|j| m[j][i]))
    };
    let essential = product(product(cross, rotation), inverse(&rig.left));
    let f = product(transposed(inverse(&rig.right)), essential);
    let square = |pair: &PixelPair| {
        let [l, r] = [pair.left, pair.right].map(|[u, v]| [u, v, 1.0]);
        let fl: [f64; 3] = std::array::from_fn(|i| (0..3).map(|j| f[i][j] * l[j]).sum());
        let fr: [f64; 3] = std::array::from_fn(|i| (0..3).map(|j| f[j][i] * r[j]).sum());
        let value: f64 = (0..3).map(|i| r[i] * fl[i]).sum();
        value * value / (fl[0] * fl[0] + fl[1] * fl[1] + fr[0] * fr[0] + fr[1] * fr[1])
    };
    rig.pairs.iter().map(square).sum()
}

/// The least cost that a search by trial finds from a start: steps along axes of falling length.
fn least_by_trial(rig: &Rig, start: Motor<f64>) -> f64 {
    let mut motion = start;
    let mut least = sampson_cost(rig, motion);
    let (mut step, mut trials) = (0.02, 0);
    while step > 1e-8 && trials < 4000 {
        trials += 1;
        let before = least;
        for axis in 0..6 {
            for size in [-step, step] {
                let mut unit = [0.0; 3];
                unit[axis % 3] = size;
                let change = if axis < 3 {
                    Motor::from(Rotor::from_rotation_vector(unit).expect("a rotation"))
                } else {
                    Motor::from(Translator::from_displacement(unit))
                };
                let moved = change * motion;
                let cost = sampson_cost(rig, moved);
                if cost < least {
                    (motion, least) = (moved, cost);
                }
            }
        }
        if least >= before * (1.0 - 1e-7) {
            step *= 0.5;
        }
    }
    least
}

#[test]
fn noisy_rigs_of_the_oracle_have_the_least_sampson_cost() {
    let rigs = rigs();
    let noisy: Vec<_> = rigs.iter().filter(|rig| rig.noise > 0.0).collect();
    let (mut ours, mut opencv) = (Vec::new(), Vec::new());
    for rig in &noisy {
        let found = estimate(&rig.pairs, &rig.left, &rig.right, &generous()).unwrap();
        assert_eq!(found.inliers.len(), 40);
        let cost = sampson_cost(rig, found.left_to_right.motor);
        let mean_square = found.root_mean_square.powi(2);
        assert!((cost / 40.0 - mean_square).abs() < 1e-9 * mean_square);
        // Searches from the truth, from the result and from other places.
        let mut starts = vec![rig.truth, found.left_to_right.motor];
        for axis in [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]] {
            starts.push(motor(axis, 0.05, [0.0, 0.0, 0.1]) * rig.truth);
        }
        for start in starts {
            let other = least_by_trial(rig, start);
            assert!(cost <= (1.0 + 1e-6) * other, "{cost} {other}");
        }
        let [rotation, direction] = errors(found.left_to_right.motor, rig.truth);
        ours.push([rotation, direction]);
        let keys = ["rot_err_deg", "trans_err_deg"];
        let theirs = keys.map(|key| rig.record["cv2_pose"][key].as_f64().expect("a number"));
        opencv.push(theirs.map(f64::to_radians));
        // The errors are of the size that the covariance states.
        let deviations = [found.rotation_deviation(), found.direction_deviation()];
        assert!(
            rotation < 4.0 * deviations[0].unwrap(),
            "{rotation} {deviations:?}"
        );
        assert!(
            direction < 4.0 * deviations[1].unwrap(),
            "{direction} {deviations:?}"
        );
    }
    for part in [0, 1].into_iter().filter(|_| !noisy.is_empty()) {
        let median = |errors: &[[f64; 2]]| {
            let mut values: Vec<f64> = errors.iter().map(|pair| pair[part]).collect();
            values.sort_by(f64::total_cmp);
            let count = values.len();
            0.5 * (values[(count - 1) / 2] + values[count / 2])
        };
        let (ours, theirs) = (median(&ours), median(&opencv));
        assert!(ours < theirs, "{ours} {theirs}");
    }
}

/// Points in front of a camera at the origin.
fn scene(count: usize) -> Vec<Point<f64>> {
    let spread = |k: usize, by: f64| (k as f64 * by).fract() * 2.0 - 1.0;
    let point = |k| {
        let depth = 5.0 + 2.5 * spread(k, 0.754_877);
        let [x, y] = [0.35 * spread(k, 0.618_034), 0.25 * spread(k, 0.569_84)];
        Point::new(depth * x, depth * y, depth)
    };
    (1..=count).map(point).collect()
}

fn intrinsics() -> Intrinsics {
    Intrinsics::new([900.0, 880.0], [320.5, 239.5]).expect("a camera")
}

/// The pixels of points in two views; `None` where a point is not in front of both.
fn seen(points: &[Point<f64>], motion: Motor<f64>) -> Option<Vec<PixelPair>> {
    let camera = |world_to_camera| Camera {
        intrinsics: intrinsics(),
        world_to_camera,
    };
    let (left, right) = (camera(Motor::default()), camera(motion));
    let pair = |&point: &Point<f64>| {
        let [left, right] = [left.project(point).ok()?, right.project(point).ok()?];
        Some(PixelPair { left, right })
    };
    points.iter().map(pair).collect()
}

/// The pixels with errors of a standard deviation, evenly spread.
fn noisy(pairs: &[PixelPair], sigma: f64) -> Vec<PixelPair> {
    let error = |k: usize, by: f64| sigma * 1.732 * ((k as f64 * by).fract() * 2.0 - 1.0);
    let change = |(k, pair): (usize, &PixelPair)| PixelPair {
        left: [
            pair.left[0] + error(k, 0.324_717),
            pair.left[1] + error(k, 0.819_172),
        ],
        right: [
            pair.right[0] + error(k, 0.671_043),
            pair.right[1] + error(k, 0.549_7),
        ],
    };
    pairs.iter().enumerate().map(change).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn exact_views_determine_the_motion(
        axis in vector(1.0), angle in -0.25..0.25, displacement in vector(1.0),
    ) {
        prop_assume!(Vector::from(displacement).length() > 0.1);
        let truth = motor(axis, angle, displacement);
        let Some(pairs) = seen(&scene(30), truth) else { return Ok(()) };
        let found = estimate(&pairs, &intrinsics(), &intrinsics(), &Options::default()).unwrap();
        let [rotation, direction] = errors(found.left_to_right.motor, truth);
        // 1e-6 of a degree.
        prop_assert!(rotation.max(direction) < 1.7e-8, "{rotation:e} {direction:e}");
        prop_assert_eq!(found.in_front, 30);
    }

    #[test]
    fn wrong_pairs_are_left_out(
        axis in vector(1.0), angle in -0.2..0.2, displacement in vector(1.0), seed in 0..1000_u64,
    ) {
        prop_assume!(Vector::from(displacement).length() > 0.3);
        let truth = motor(axis, angle, displacement);
        let Some(pairs) = seen(&scene(120), truth) else { return Ok(()) };
        let mut pairs = noisy(&pairs, 0.1);
        // Every third pair belongs to another point.
        for k in (0..117).step_by(3) {
            pairs[k].right = pairs[(k + 31) % 120].right;
        }
        let options = Options { seed, ..Options::default() };
        let found = estimate(&pairs, &intrinsics(), &intrinsics(), &options).unwrap();
        let [rotation, direction] = errors(found.left_to_right.motor, truth);
        prop_assert!(rotation < 0.01 && direction < 0.1, "{rotation} {direction}");
        prop_assert!(found.inliers.len() >= 75, "{}", found.inliers.len());
        let again = estimate(&pairs, &intrinsics(), &intrinsics(), &options).unwrap();
        prop_assert_eq!(found, again);
    }

    #[test]
    fn a_rotation_alone_is_refused(axis in vector(1.0), angle in -0.2..0.2, sigma in 0.0..0.5) {
        let Some(pairs) = seen(&scene(60), motor(axis, angle, [0.0; 3])) else { return Ok(()) };
        let found = estimate(&noisy(&pairs, sigma), &intrinsics(), &intrinsics(), &generous());
        let is_refused = matches!(found, Err(ViewGeometryError::PureRotation { .. }));
        prop_assert!(is_refused, "{:?}", found);
    }

    #[test]
    fn minimal_samples_have_the_truth_among_their_solutions(
        axis in vector(1.0), angle in -0.25..0.25, displacement in vector(1.0),
        first in 0..90_usize,
    ) {
        prop_assume!(Vector::from(displacement).length() > 0.1);
        let truth = motor(axis, angle, displacement);
        let Some(pairs) = seen(&scene(100)[first..], truth) else { return Ok(()) };
        let bearing = |pixel| Bearing::of_pixel(&intrinsics(), pixel).unwrap().direction;
        let five = std::array::from_fn(|k| [bearing(pairs[k].left), bearing(pairs[k].right)]);
        let expected = EssentialMatrix::from_motor(truth).unwrap().rows();
        let distance = |essential: &EssentialMatrix| {
            let found = essential.rows();
            let pairs = found.as_flattened().iter().zip(expected.as_flattened());
            let sum = |sign: f64| pairs.clone().map(|(a, b)| (a - sign * b).powi(2)).sum::<f64>();
            sum(1.0).min(sum(-1.0)).sqrt()
        };
        let least = five_point(&five).iter().map(distance).fold(f64::INFINITY, f64::min);
        prop_assert!(least < 1e-4, "{least:e}");
        let seven = std::array::from_fn(|k| pairs[k]);
        let worst = |f: &FundamentalMatrix| {
            let distances = pairs.iter().map(|p| f.sampson_distance(p.left, p.right).abs());
            distances.fold(0.0, f64::max)
        };
        let least = seven_point(&seven).iter().map(worst).fold(f64::INFINITY, f64::min);
        prop_assert!(least < 1e-3, "{least:e}");
    }
}

#[test]
fn the_fundamental_matrix_of_exact_rigs_is_that_of_the_oracle() {
    for rig in rigs().iter().filter(|rig| rig.noise == 0.0) {
        let found = estimate_fundamental(&rig.pairs, &FundamentalOptions::default()).unwrap();
        assert_eq!(found.inliers.len(), 40);
        assert!(found.root_mean_square < 1e-7, "{}", found.root_mean_square);
        let expected = matrix(&rig.record["F"]);
        assert_equal_up_to_scale(found.matrix.rows(), expected);
        assert_equal_up_to_scale(eight_point(&rig.pairs).unwrap().rows(), expected);
    }
}

#[test]
fn pairs_that_determine_nothing_are_refused() {
    let truth = motor([0.0, 1.0, 0.0], 0.1, [0.5, 0.0, 0.1]);
    let pairs = seen(&scene(60), truth).unwrap();
    let find = |pairs: &[PixelPair]| {
        estimate(pairs, &intrinsics(), &intrinsics(), &Options::default()).unwrap_err()
    };
    let too_few = |found, needed| ViewGeometryError::TooFew { found, needed };
    assert_eq!(find(&pairs[..5]), too_few(5, 6));
    assert_eq!(find(&[]), too_few(0, 6));
    assert_eq!(eight_point(&pairs[..7]), Err(too_few(7, 8)));
    // Two directions more than pixels.
    let of = |pixel| Bearing::of_pixel(&intrinsics(), pixel).unwrap();
    let bearings = pairs[..10].iter().map(|pair| BearingPair {
        left: of(pair.left),
        right: of(pair.right),
    });
    let bearings: Vec<_> = bearings.collect();
    assert_eq!(
        estimate_from_bearings(&pairs[..8], &bearings, &Options::default()),
        Err(ViewGeometryError::Counts {
            pixels: 8,
            directions: 10
        })
    );
    let mut broken = pairs.clone();
    broken[7].right[1] = f64::NAN;
    let (pair, view) = (7, View::Right);
    assert_eq!(find(&broken), ViewGeometryError::NotFinite { pair, view });
    let on_a_line: Vec<_> = (0..30)
        .map(|k| Point::new(-1.0 + 0.07 * f64::from(k), 0.2, 4.0 + 0.1 * f64::from(k)))
        .collect();
    let found = find(&seen(&on_a_line, truth).unwrap());
    let view = View::Left;
    assert!(
        matches!(found, ViewGeometryError::Collinear { view: v, .. } if v == view),
        "{found:?}"
    );
    // Pixels that have nothing to do with each other.
    let other = |k: usize| pairs[(k * 23 + 11) % 60].right;
    let mixed = pairs.iter().enumerate();
    let mixed: Vec<_> = mixed
        .map(|(k, p)| PixelPair {
            right: other(k),
            ..*p
        })
        .collect();
    let found = find(&mixed);
    assert!(
        matches!(found, ViewGeometryError::NoConsensus { .. }),
        "{found:?}"
    );
}

/// The camera stood still and the board moved: pairs of the wall behind it tell nothing of a
/// motion, whatever their noise makes of it.
#[test]
fn a_camera_that_stood_still_has_no_clear_motion() {
    let intrinsics = Intrinsics::new([533.0; 2], [342.0, 234.0]).unwrap();
    for [first, second] in [["01", "02"], ["02", "01"], ["02", "04"], ["04", "02"]] {
        let view = |number: &str| {
            let path =
                nullcone_shared_data::shared(&format!("data/vision/opencv/left{number}.jpg"));
            path.map(|path| {
                ga_image::file::read(&path)
                    .unwrap()
                    .to_grey::<u8>(Luma::Bt601)
            })
        };
        let (Some(a), Some(b)) = (view(first), view(second)) else {
            return;
        };
        let pairs = match_views(&a, &b, &ViewOptions::default());
        for seed in 1..4 {
            let options = Options {
                seed,
                ..Options::default()
            };
            let found = estimate(&pairs, &intrinsics, &intrinsics, &options);
            let is_refused = matches!(found, Err(ViewGeometryError::PureRotation { .. }));
            assert!(is_refused, "{first} {second} {seed}: {found:?}");
        }
    }
}
