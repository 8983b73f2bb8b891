//! Many pairs of pixels of two cameras, against the oracle's rigs, least squares and closed forms.

use ga_runtime::batch::InstructionSet;
use ga_runtime::cga3::{Direction, Motor, Point, Rotor, Translator};
use ga_vision::camera::{Camera, Intrinsics};
use ga_vision::rig::StereoRig;
use ga_vision::triangulation::{
    ColumnsError, CovarianceColumns, Method, PixelColumns, PointColumns, TriangulationError,
    TwoViews, triangulate_views,
};
use nullcone_shared_data::shared;
use proptest::prelude::*;
use serde_json::Value;

use crate::{matrix, numbers, rows};

const METHODS: [Method; 3] = [Method::Midpoint, Method::DepthWeighted, Method::Optimal];

/// Pixels of both views in columns.
struct Pairs {
    left: [Vec<f64>; 2],
    right: [Vec<f64>; 2],
}

impl Pairs {
    fn new(left: &[[f64; 2]], right: &[[f64; 2]]) -> Self {
        let columns = |pixels: &[[f64; 2]]| [0, 1].map(|k| pixels.iter().map(|p| p[k]).collect());
        Self {
            left: columns(left),
            right: columns(right),
        }
    }

    fn columns(&self) -> [PixelColumns<'_>; 2] {
        [&self.left, &self.right].map(|[u, v]| PixelColumns { u, v })
    }
}

fn found(rig: &StereoRig, method: Method, pairs: &Pairs) -> PointColumns {
    let views = TwoViews::new(&rig.left, &rig.right).unwrap();
    let [left, right] = pairs.columns();
    let mut points = PointColumns::default();
    views.triangulate(method, left, right, &mut points).unwrap();
    points
}

/// The sum of the squared errors in both pictures.
fn cost(rig: &StereoRig, point: Point<f64>, left: [f64; 2], right: [f64; 2]) -> f64 {
    let error = |camera: &Camera, pixel: [f64; 2]| {
        let [u, v] = camera.project(point).unwrap();
        (u - pixel[0]).powi(2) + (v - pixel[1]).powi(2)
    };
    error(&rig.left, left) + error(&rig.right, right)
}

fn rig_of(record: &Value) -> StereoRig {
    let intrinsics = |key: &str| Intrinsics::from_matrix(matrix(&record[key])).unwrap();
    let (rotation, translation) = (matrix(&record["R"]), numbers(&record["t"]));
    StereoRig::from_matrices(intrinsics("K1"), intrinsics("K2"), rotation, translation).unwrap()
}

/// The points of the Hartley–Sturm method of OpenCV are the least in reprojection; ours may not be
/// worse, and the depth-weighted ones only by a part in a million together.
#[test]
fn rigs_of_the_oracle_reach_the_optimum() {
    let Some(path) = shared("oracle/vision/seed1/truth.json") else {
        return;
    };
    let text = std::fs::read_to_string(path).unwrap();
    let truth: Value = serde_json::from_str(&text).unwrap();
    for record in truth["rigs"].as_array().unwrap() {
        let rig = rig_of(record);
        let (left, right) = (rows::<2>(&record["left"]), rows::<2>(&record["right"]));
        let (optimal, exact) = (rows::<3>(&record["optimal"]), rows::<3>(&record["X"]));
        let pairs = Pairs::new(&left, &right);
        let noise = record["sigma_px"].as_f64().unwrap();
        for method in METHODS {
            let points = found(&rig, method, &pairs);
            points.check_in_front().unwrap();
            let (mut sum, mut least) = (0.0, 0.0);
            for index in 0..left.len() {
                let point = points.get(index).unwrap();
                let (a, b) = (left[index], right[index]);
                if noise == 0.0 {
                    let truth = Point::from(exact[index]);
                    let range = truth.distance(Point::default());
                    assert!(point.position.distance(truth) <= 1e-11 * range);
                    continue;
                }
                let ours = cost(&rig, point.position, a, b);
                let theirs = cost(&rig, optimal[index].into(), a, b);
                if method == Method::Optimal {
                    assert!(ours <= theirs * (1.0 + 1e-9) + 1e-18, "{ours} {theirs}");
                }
                sum += ours;
                least += theirs;
            }
            let bound = match method {
                Method::Midpoint => continue,
                Method::DepthWeighted => 1.0 + 1e-6,
                Method::Optimal => 1.0 + 1e-9,
            };
            assert!(
                noise == 0.0 || (sum / least).sqrt() <= bound,
                "{method:?}: {}",
                (sum / least).sqrt()
            );
        }
    }
}

fn motor(axis: [f64; 3], angle: f64, displacement: [f64; 3]) -> Motor<f64> {
    Translator::from_displacement(displacement)
        * Rotor::from_axis_angle(axis, angle).unwrap_or_default()
}

fn vector(size: f64) -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-size..size)
}

fn intrinsics() -> impl Strategy<Value = Intrinsics> {
    (400.0..2000.0, 0.8..1.25, 200.0..800.0, 200.0..600.0).prop_map(|(focal, ratio, u, v)| {
        Intrinsics::new([focal, focal * ratio], [u, v]).expect("a camera")
    })
}

prop_compose! {
    /// Two cameras in the world that look at much the same.
    fn rigs()(
        left in intrinsics(), right in intrinsics(),
        world in (vector(1.0), -3.0..3.0, vector(5.0)),
        between in (vector(1.0), -0.3..0.3, vector(1.0)),
    ) -> StereoRig {
        let pose = motor(world.0, world.1, world.2);
        StereoRig {
            left: Camera { intrinsics: left, world_to_camera: pose },
            right: Camera {
                intrinsics: right,
                world_to_camera: motor(between.0, between.1, between.2) * pose,
            },
        }
    }
}

/// What both cameras see of places in the left frame, with errors added.
fn seen(
    rig: &StereoRig,
    places: &[[f64; 3]],
    errors: &[[f64; 4]],
) -> Option<(Vec<Point<f64>>, Pairs)> {
    let to_world = rig.left.world_to_camera.reverse();
    let points: Vec<Point<f64>> = places
        .iter()
        .map(|place| to_world.transform(Point::from(*place)))
        .collect();
    let noisy = |camera: &Camera, first: usize| -> Option<Vec<[f64; 2]>> {
        let pixels = points.iter().zip(errors);
        pixels
            .map(|(point, error)| {
                let [u, v] = camera.project(*point).ok()?;
                Some([u + error[first], v + error[first + 1]])
            })
            .collect()
    };
    let (left, right) = (noisy(&rig.left, 0)?, noisy(&rig.right, 2)?);
    Some((points.clone(), Pairs::new(&left, &right)))
}

fn places() -> impl Strategy<Value = Vec<[f64; 3]>> {
    prop::collection::vec(
        (-1.0..1.0, -1.0..1.0, 2.0..9.0).prop_map(|(x, y, z)| [x, y, z]),
        1..11,
    )
}

proptest! {
    #[test]
    fn exact_pixels_give_the_points(rig in rigs(), places in places()) {
        prop_assume!(rig.baseline() > 0.1);
        let none = vec![[0.0; 4]; places.len()];
        let Some((truth, pairs)) = seen(&rig, &places, &none) else { return Ok(()) };
        for method in METHODS {
            let views = TwoViews::new(&rig.left, &rig.right).unwrap();
            let [left, right] = pairs.columns();
            let mut points = PointColumns::default();
            if views.triangulate(method, left, right, &mut points).is_err() {
                return Ok(());
            }
            for (index, truth) in truth.iter().enumerate() {
                let point = points.get(index).unwrap();
                prop_assume!(point.angle > 0.01);
                prop_assert!(point.position.distance(*truth) < 1e-12 / point.angle, "{point:?}");
                prop_assert!(point.gap < 1e-12 / point.angle && point.is_in_front());
                for (camera, depth) in [rig.left, rig.right].iter().zip(point.depths) {
                    let [_, _, z] = camera.world_to_camera.transform(*truth).coordinates();
                    prop_assert!((depth - z).abs() < 1e-12 / point.angle);
                }
                // The parallax angle is the angle at the point between both centres.
                let [a, b] = [rig.left, rig.right].map(|camera| truth.vector_to(camera.centre()));
                prop_assert!((a.angle(b).unwrap() - point.angle).abs() < 1e-12);
            }
        }
    }

    /// The middle of the common perpendicular is the one of single rays, with the same gap and
    /// angle.
    #[test]
    fn midpoints_are_those_of_rays(
        rig in rigs(), places in places(), errors in prop::collection::vec(prop::array::uniform4(-3.0..3.0), 10),
    ) {
        prop_assume!(rig.baseline() > 0.1);
        let Some((_, pairs)) = seen(&rig, &places, &errors) else { return Ok(()) };
        let points = found(&rig, Method::Midpoint, &pairs);
        for index in 0..points.len() {
            let point = points.get(index).unwrap();
            prop_assume!(point.angle > 0.01 && point.angle < 3.1);
            let left = [pairs.left[0][index], pairs.left[1][index]];
            let right = [pairs.right[0][index], pairs.right[1][index]];
            let single = rig.triangulate(left, right).unwrap();
            let range = single.depths[0].abs() + single.depths[1].abs() + 10.0;
            let bound = 1e-12 * range / point.angle.sin();
            prop_assert!(single.position.distance(point.position) < bound);
            prop_assert!((single.gap - point.gap).abs() < bound);
            prop_assert!((single.angle - point.angle).abs() < 1e-12);
            prop_assert_eq!(single.is_in_front(), point.is_in_front());
        }
    }

    /// The optimal point has the least error in the pictures of all points: it is the point of
    /// least squares, found by another method, and no point beside it is better.
    #[test]
    fn optimal_points_are_those_of_least_squares(
        rig in rigs(), places in places(), errors in prop::collection::vec(prop::array::uniform4(-1.5..1.5), 10),
    ) {
        prop_assume!(rig.baseline() > 0.1);
        let Some((_, pairs)) = seen(&rig, &places, &errors) else { return Ok(()) };
        let optimal = found(&rig, Method::Optimal, &pairs);
        for index in 0..optimal.len() {
            let point = optimal.get(index).unwrap();
            prop_assume!(point.is_in_front() && point.angle > 0.02);
            let left = [pairs.left[0][index], pairs.left[1][index]];
            let right = [pairs.right[0][index], pairs.right[1][index]];
            let least = cost(&rig, point.position, left, right);
            let other = triangulate_views(&[rig.left, rig.right], &[left, right]);
            if let Ok(other) = other {
                let theirs = 2.0 * other.error_px.powi(2);
                prop_assert!((least - theirs).abs() <= 1e-8 * theirs + 1e-16, "{least} {theirs}");
            }
            for axis in 0..3 {
                for step in [-1e-3, 1e-3] {
                    let mut beside = point.position.coordinates();
                    beside[axis] += step * point.depths[0];
                    if rig.left.project(beside.into()).is_ok() && rig.right.project(beside.into()).is_ok() {
                        prop_assert!(cost(&rig, beside.into(), left, right) >= least);
                    }
                }
            }
        }
    }

    /// Away from the epipoles, one step leaves less than 0.1 % of the least error, with any rig.
    #[test]
    fn depth_weighted_points_are_nearly_those_of_least_squares(
        rig in rigs(), places in places(), errors in prop::collection::vec(prop::array::uniform4(-1.5..1.5), 10),
    ) {
        prop_assume!(rig.baseline() > 0.1);
        let pairs = seen(&rig, &places, &errors);
        prop_assume!(pairs.is_some());
        let (_, pairs) = pairs.unwrap();
        let [weighted, optimal] =
            [Method::DepthWeighted, Method::Optimal].map(|method| found(&rig, method, &pairs));
        for index in 0..optimal.len() {
            let [ours, best] = [&weighted, &optimal].map(|points| points.get(index).unwrap());
            prop_assume!(best.is_in_front() && best.angle > 0.1 && best.angle < 3.0);
            let left = [pairs.left[0][index], pairs.left[1][index]];
            let right = [pairs.right[0][index], pairs.right[1][index]];
            let [error, least] =
                [ours, best].map(|point| cost(&rig, point.position, left, right).sqrt());
            prop_assert!(error <= 1.001 * least + 1e-9, "{error} {least}");
            // Both depths belong to the point.
            for (camera, depth) in [rig.left, rig.right].iter().zip(best.depths) {
                let [_, _, z] = camera.world_to_camera.transform(best.position).coordinates();
                prop_assert!((depth - z).abs() < 1e-9);
            }
        }
    }

    /// The covariance is that of the inverse of the normal equations by differences.
    #[test]
    fn covariances_are_those_of_least_squares(rig in rigs(), places in places()) {
        prop_assume!(rig.baseline() > 0.1);
        let none = vec![[0.0; 4]; places.len()];
        let Some((_, pairs)) = seen(&rig, &places, &none) else { return Ok(()) };
        let views = TwoViews::new(&rig.left, &rig.right).unwrap();
        let points = found(&rig, Method::Optimal, &pairs);
        let mut covariances = CovarianceColumns::default();
        views.covariances(0.7, &points, &mut covariances).unwrap();
        for index in 0..points.len() {
            prop_assume!(points.angle[index] > 0.02);
            let left = [pairs.left[0][index], pairs.left[1][index]];
            let right = [pairs.right[0][index], pairs.right[1][index]];
            let Ok(other) = triangulate_views(&[rig.left, rig.right], &[left, right]) else { continue };
            let ours = covariances.get(index).unwrap();
            let size: f64 = (0..3).map(|k| ours[k][k]).sum();
            for (ours, theirs) in ours.iter().zip(&other.covariance) {
                for (ours, theirs) in ours.iter().zip(theirs) {
                    prop_assert!((ours - 0.49 * theirs).abs() < 1e-9 * size);
                }
            }
        }
    }

    /// The same bits with any instructions, and for any place in the columns.
    #[test]
    fn instructions_do_not_change_results(rig in rigs(), places in places()) {
        prop_assume!(rig.baseline() > 0.1);
        let errors = vec![[0.3, -0.2, 0.1, 0.4]; places.len()];
        let Some((_, pairs)) = seen(&rig, &places, &errors) else { return Ok(()) };
        let views = TwoViews::new(&rig.left, &rig.right).unwrap();
        let [left, right] = pairs.columns();
        for method in METHODS {
            let (mut best, mut plain) = (PointColumns::default(), PointColumns::default());
            views.triangulate(method, left, right, &mut best).unwrap();
            let baseline = views.clone().on(InstructionSet::Baseline);
            baseline.triangulate(method, left, right, &mut plain).unwrap();
            prop_assert_eq!(&best, &plain);
            for index in 0..best.len() {
                let [left, right] = [left, right].map(|columns| PixelColumns {
                    u: &columns.u[index..=index],
                    v: &columns.v[index..=index],
                });
                views.triangulate(method, left, right, &mut plain).unwrap();
                prop_assert_eq!(plain.get(0), best.get(index));
            }
        }
    }
}

/// Where one camera is twice as near as the other, its errors count four times as much.
#[test]
fn weights_by_depth_matter_where_the_depths_differ() {
    let intrinsics = Intrinsics::new([1000.0, 1000.0], [640.0, 360.0]).unwrap();
    let camera = |eye: [f64; 3]| {
        let (eye, target) = (Point::from(eye), Point::default());
        Camera::look_at(intrinsics, eye, target, [0.0, 1.0, 0.0]).unwrap()
    };
    let rig = StereoRig {
        left: camera([0.0, 0.0, 6.0]),
        right: camera([1.5, 0.0, 2.6]),
    };
    let places: Vec<[f64; 3]> = (0..200)
        .map(|step| {
            let step = f64::from(step);
            [
                0.5 * (step * 0.7).sin(),
                0.5 * (step * 1.3).cos(),
                6.0 + 0.3 * (step * 0.4).sin(),
            ]
        })
        .collect();
    let noise = |step: usize| {
        let step = step as f64;
        [1.0, 2.3, 3.1, 4.7].map(|rate: f64| (rate * step * step + rate).sin())
    };
    let errors: Vec<_> = (0..200).map(noise).collect();
    let (_, pairs) = seen(&rig, &places, &errors).unwrap();
    let [midpoint, weighted, optimal] = METHODS.map(|method| -> f64 {
        let points = found(&rig, method, &pairs);
        let costs = (0..200).map(|index| {
            let left = [pairs.left[0][index], pairs.left[1][index]];
            let right = [pairs.right[0][index], pairs.right[1][index]];
            cost(&rig, points.get(index).unwrap().position, left, right)
        });
        costs.sum()
    });
    assert!(
        optimal <= weighted && weighted <= (1.0 + 1e-4) * optimal,
        "{weighted} {optimal}"
    );
    assert!(midpoint >= 1.15 * optimal, "{midpoint} {optimal}");
}

/// Baselines down to 0.002 of the distance, without noise.
#[test]
fn short_baselines_keep_eleven_digits() {
    let intrinsics = Intrinsics::new([1000.0, 1000.0], [640.0, 360.0]).unwrap();
    let mut worst: f64 = 0.0;
    for ratio in [0.002, 0.005, 0.02, 0.1, 0.5] {
        for step in 0..500 {
            let step = f64::from(step);
            let depth = 1.0 + 0.05 * step;
            let place = Point::new(
                depth * (step * 0.7).sin() * 0.5,
                depth * (step * 1.3).cos() * 0.3,
                depth,
            );
            let baseline = ratio * place.distance(Point::default());
            let pose = motor([0.2, 1.0, -0.1], 0.01, [-baseline, 0.0, 0.02 * baseline]);
            let camera = |world_to_camera| Camera {
                intrinsics,
                world_to_camera,
            };
            let rig = StereoRig {
                left: camera(Motor::default()),
                right: camera(pose),
            };
            let (left, right) = (
                rig.left.project(place).unwrap(),
                rig.right.project(place).unwrap(),
            );
            let pairs = Pairs::new(&[left], &[right]);
            for method in METHODS {
                let point = found(&rig, method, &pairs).get(0).unwrap();
                let error = point.position.distance(place) / place.distance(Point::default());
                worst = worst.max(error);
            }
        }
    }
    assert!(worst <= 1e-11, "{worst:e}");
}

fn side_by_side() -> StereoRig {
    let intrinsics = Intrinsics::new([900.0, 880.0], [320.5, 239.5]).unwrap();
    let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    StereoRig::from_matrices(intrinsics, intrinsics, identity, [-0.5, 0.0, 0.0]).unwrap()
}

#[test]
fn faulty_pairs_are_named_by_index() {
    let rig = side_by_side();
    let views = TwoViews::new(&rig.left, &rig.right).unwrap();
    let mut points = PointColumns::default();
    for method in METHODS {
        for faulty in [0, 3, 6] {
            let mut left = vec![[330.0, 240.0]; 7];
            let right = vec![[320.0, 240.0]; 7];
            let error = |left: &[[f64; 2]], points: &mut PointColumns| {
                let pairs = Pairs::new(left, &right);
                let [a, b] = pairs.columns();
                views.triangulate(method, a, b, points).unwrap_err()
            };
            left[faulty] = [f64::NAN, 240.0];
            let expected = ColumnsError::Point {
                point: faulty,
                error: TriangulationError::NotFinite,
            };
            assert_eq!(error(&left, &mut points), expected);
            left[faulty] = right[faulty];
            let found = error(&left, &mut points);
            assert!(
                matches!(found, ColumnsError::Point { point, error: TriangulationError::Parallel { .. } } if point == faulty),
                "{found}"
            );
            // Crossed pictures put the point behind both cameras, which is no error by itself.
            left[faulty] = [310.0, 240.0];
            let pairs = Pairs::new(&left, &right);
            let [a, b] = pairs.columns();
            views.triangulate(method, a, b, &mut points).unwrap();
            let behind = points.check_in_front().unwrap_err();
            assert!(
                matches!(behind, ColumnsError::Point { point, error: TriangulationError::Behind { view: 0, .. } } if point == faulty),
                "{behind}"
            );
        }
    }
    let short = PixelColumns {
        u: &[1.0, 2.0],
        v: &[1.0],
    };
    let right = PixelColumns {
        u: &[0.0, 0.0],
        v: &[1.0, 1.0],
    };
    let error = views
        .triangulate(Method::Optimal, short, right, &mut points)
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "the v column of the left view has 1 elements, but there are 2 columns of the left view"
    );
    let same = TwoViews::new(&rig.left, &rig.left).unwrap_err();
    assert_eq!(same, TriangulationError::NoBaseline);
    let none = PixelColumns { u: &[], v: &[] };
    views
        .triangulate(Method::Optimal, none, none, &mut points)
        .unwrap();
    assert!(points.is_empty());
    let mut covariances = CovarianceColumns::default();
    assert_eq!(
        views.covariances(-1.0, &points, &mut covariances),
        Err(ColumnsError::Noise(-1.0))
    );
    // A point on the line of both centres has no finite covariance.
    points.x = vec![3.0, 1.0];
    points.y = vec![1.0, 0.0];
    points.z = vec![4.0, 0.0];
    let error = views
        .covariances(1.0, &points, &mut covariances)
        .unwrap_err();
    assert_eq!(
        error,
        ColumnsError::Point {
            point: 1,
            error: TriangulationError::NotFinite
        }
    );
}

/// On the line of both centres the gradients span a plane, also where rounding leaves a volume.
#[test]
fn covariances_on_the_line_of_both_centres_are_errors() {
    let mut random = 1_u64;
    for _ in 0..200 {
        let [a, b, part] = [0, 1, 2].map(|_| {
            random = random.wrapping_mul(6_364_136_223_846_793_005) | 1;
            (random >> 40) as f64 / (1_u64 << 24) as f64
        });
        let mut rig = side_by_side();
        // The right camera is ahead of the left one, at `ahead`.
        let ahead = Direction::new(0.2 * a - 0.1, 0.2 * b - 0.1, 0.5);
        rig.right.world_to_camera = Translator::from_displacement((-ahead).coordinates()).into();
        let views = TwoViews::new(&rig.left, &rig.right).unwrap();
        let [x, y, z] = ahead.coordinates().map(|x| x * (3.0 + 7.0 * part));
        let points = PointColumns {
            x: vec![x],
            y: vec![y],
            z: vec![z],
            ..PointColumns::default()
        };
        let error = views
            .covariances(1.0, &points, &mut CovarianceColumns::default())
            .unwrap_err();
        assert!(
            matches!(error, ColumnsError::Point { point: 0, .. }),
            "{error}"
        );
    }
}

/// Pixels behind distorted lenses are undistorted first, and no camera of columns takes them raw.
#[test]
fn distorted_lenses_are_seen_through() {
    use ga_vision::camera::RadialTangential;
    let lens = RadialTangential::new(&[-0.2, 0.05, 1e-3, -5e-4]).unwrap();
    let mut rig = side_by_side();
    rig.right.intrinsics = rig.right.intrinsics.with_lens(lens);
    let point = Point::new(0.7, -0.4, 3.0);
    let (left, right) = (
        rig.left.project(point).unwrap(),
        rig.right.project(point).unwrap(),
    );
    let points = rig
        .triangulate_by(Method::Optimal, &[left], &[right])
        .unwrap();
    assert!(points.get(0).unwrap().position.distance(point) < 1e-12);
    assert_eq!(
        TwoViews::new(&rig.left, &rig.right).unwrap_err(),
        TriangulationError::Distorted { view: 1 }
    );
    let many = triangulate_views(&[rig.left, rig.right], &[left, right]).unwrap();
    assert!(many.position.distance(point) < 1e-12);
}
