//! Cameras against OpenCV's formulas, written again over dual numbers.

use ga_camera::frame::{CameraFrame, In, World};
use ga_camera::{Camera, CameraError, Fisheye, Intrinsics, Lens, RadialTangential};
use ga_runtime::cga3::{Direction, MotorGenerator, Point};
use ga_runtime::scalar::{Dual, Real};
use proptest::prelude::*;
use serde_json::Value;

use super::{motor, vector};
use nullcone_shared_data::json::{matrix, rows};

/// OpenCV's projectPoints, from its documentation, for a point of the camera's frame and the
/// parameters f_x, f_y, c_x, c_y, k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 τx τy.
fn project_points<S: Real>([x, y, z]: [S; 3], parameters: [S; 18]) -> [S; 2] {
    let [
        fx,
        fy,
        cx,
        cy,
        k1,
        k2,
        p1,
        p2,
        k3,
        k4,
        k5,
        k6,
        s1,
        s2,
        s3,
        s4,
        tx,
        ty,
    ] = parameters;
    let (one, two) = (S::one(), S::from_integer(2));
    let (x, y) = (x / z, y / z);
    let r2 = x * x + y * y;
    let (r4, r6) = (r2 * r2, r2 * r2 * r2);
    let factor = (one + k1 * r2 + k2 * r4 + k3 * r6) / (one + k4 * r2 + k5 * r4 + k6 * r6);
    let x2 = x * factor + two * p1 * x * y + p2 * (r2 + two * x * x) + s1 * r2 + s2 * r4;
    let y2 = y * factor + p1 * (r2 + two * y * y) + two * p2 * x * y + s3 * r2 + s4 * r4;
    let ((sx, cos_x), (sy, cos_y)) = ((tx.sin(), tx.cos()), (ty.sin(), ty.cos()));
    // R = [cτy 0 −sτy; 0 1 0; sτy 0 cτy] [1 0 0; 0 cτx sτx; 0 −sτx cτx].
    let image = [
        cos_y * x2 + sy * sx * y2 - sy * cos_x,
        cos_x * y2 + sx,
        sy * x2 - cos_y * sx * y2 + cos_y * cos_x,
    ];
    let (r13, r23, r33) = (-(sy * cos_x), sx, cos_y * cos_x);
    let x3 = (r33 * image[0] - r13 * image[2]) / image[2];
    let y3 = (r33 * image[1] - r23 * image[2]) / image[2];
    [fx * x3 + cx, fy * y3 + cy]
}

/// OpenCV's fisheye::projectPoints, from its documentation.
fn fisheye_project_points<S: Real>([x, y, z]: [S; 3], parameters: [S; 8]) -> [S; 2] {
    let [fx, fy, cx, cy, k1, k2, k3, k4] = parameters;
    let (a, b) = (x / z, y / z);
    let r = (a * a + b * b).sqrt();
    let theta = r.atan2(S::one());
    let t2 = theta * theta;
    let (t4, t6, t8) = (t2 * t2, t2 * t2 * t2, t2 * t2 * t2 * t2);
    let distorted = theta * (S::one() + k1 * t2 + k2 * t4 + k3 * t6 + k4 * t8);
    [fx * (distorted / r * a) + cx, fy * (distorted / r * b) + cy]
}

/// A value and its derivatives by all variables, for each coordinate of a pixel.
fn check<const N: usize>(
    intrinsics: &Intrinsics,
    point: [f64; 3],
    expected: impl Fn([Dual<f64, N>; 3], Vec<Dual<f64, N>>) -> [Dual<f64, N>; 2],
) -> Result<(), TestCaseError> {
    let count = intrinsics.parameter_count();
    prop_assert_eq!(N, 3 + count);
    let mut variables = [0.0; N];
    variables[..3].copy_from_slice(&point);
    variables[3..].copy_from_slice(&intrinsics.parameters()[..count]);
    let variables = Dual::variables(variables);
    let [x, y, z] = [variables[0], variables[1], variables[2]];
    let truth = expected([x, y, z], variables[3..].to_vec());
    let Ok(found) = intrinsics.project_with_derivatives(Point::from(point)) else {
        // Outside the field, and then also without derivatives.
        prop_assert!(intrinsics.project(Point::from(point)).is_err());
        return Err(TestCaseError::reject("outside the field"));
    };
    prop_assert_eq!(found.pixel, intrinsics.project(Point::from(point)).unwrap());
    for (k, truth) in truth.iter().enumerate() {
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-11 * (1.0 + a.abs().max(b.abs())) * 500.0;
        prop_assert!((found.pixel[k] - truth.value).abs() < 1e-9 * (1.0 + truth.value.abs()));
        for j in 0..3 {
            prop_assert!(close(found.by_point[k][j], truth.derivatives[j]), "{k} {j}");
        }
        for j in 0..count {
            let (a, b) = (found.by_parameters[k][j], truth.derivatives[3 + j]);
            prop_assert!(close(a, b), "{k} {j}: {a} {b}");
        }
        prop_assert!(found.by_parameters[k][count..].iter().all(|x| *x == 0.0));
    }
    Ok(())
}

fn pinhole() -> Intrinsics {
    Intrinsics::new([536.0, 540.0], [342.4, 235.5]).expect("a camera")
}

/// Coefficients as large as those of strong wide-angle lenses.
fn coefficients() -> impl Strategy<Value = [f64; 14]> {
    let sizes = [
        0.4, 0.3, 0.01, 0.01, 0.2, 0.2, 0.1, 0.05, 0.01, 0.01, 0.01, 0.01, 0.2, 0.2,
    ];
    prop::array::uniform14(-1.0..1.0)
        .prop_map(move |x: [f64; 14]| std::array::from_fn(|k| x[k] * sizes[k]))
}

fn place() -> impl Strategy<Value = [f64; 3]> {
    (-0.8..0.8, -0.6..0.6, 0.5..4.0).prop_map(|(x, y, z)| [x * z, y * z, z])
}

proptest! {
    #[test]
    fn radial_tangential_derivatives(point in place(), coefficients in coefficients()) {
        let camera = pinhole().with_lens(RadialTangential::new(&coefficients).unwrap());
        check::<21>(&camera, point, |point, parameters| {
            project_points(point, parameters.try_into().unwrap())
        })?;
    }

    #[test]
    fn derivatives_of_few_coefficients(point in place(), coefficients in coefficients()) {
        // Without a tilt the derivatives by its angles are still those of the formula.
        for count in [4, 5, 8, 12] {
            let lens = RadialTangential::new(&coefficients[..count]).unwrap();
            check::<21>(&pinhole().with_lens(lens), point, |point, parameters| {
                project_points(point, parameters.try_into().unwrap())
            })?;
        }
    }

    #[test]
    fn pinhole_derivatives(point in place()) {
        check::<7>(&pinhole(), point, |point, parameters| {
            let mut all = [Dual::constant(0.0); 18];
            all[..4].copy_from_slice(&parameters);
            project_points(point, all)
        })?;
    }

    #[test]
    fn fisheye_derivatives(
        point in place(),
        wide in 1.0..5.0,
        k in prop::array::uniform4(-0.05..0.05),
    ) {
        let camera = pinhole().with_lens(Fisheye::new(&k).unwrap());
        let point = [point[0] * wide, point[1] * wide, point[2]];
        check::<11>(&camera, point, |point, parameters| {
            fisheye_project_points(point, parameters.try_into().unwrap())
        })?;
    }

    #[test]
    fn derivatives_by_the_pose_and_by_the_place_in_the_world(
        world in (vector(1.0), -3.0..3.0, vector(2.0)),
        point in place(),
        coefficients in coefficients(),
    ) {
        let pose = motor(world.0, world.1, world.2);
        let lens = RadialTangential::new(&coefficients).unwrap();
        let camera = Camera { intrinsics: pinhole().with_lens(lens), world_to_camera: pose };
        let in_world = pose.reverse().transform(Point::from(point));
        let Ok(seen) = camera.project_with_derivatives(in_world) else {
            return Err(TestCaseError::reject("outside the field"));
        };
        let size = 1e-5;
        for k in 0..6 {
            let side = |sign: f64| {
                let mut steps = [0.0; 6];
                steps[k] = sign * size;
                let [a, b, c, d, e, f] = steps;
                let (angular, linear) = (Direction::new(a, b, c), Direction::new(d, e, f));
                let twist = MotorGenerator::from_velocities(angular, linear);
                let moved = Camera { world_to_camera: twist.exp() * pose, ..camera };
                moved.project(in_world)
            };
            let (Ok(ahead), Ok(behind)) = (side(1.0), side(-1.0)) else {
                return Err(TestCaseError::reject("at the edge of the field"));
            };
            for row in 0..2 {
                let difference = (ahead[row] - behind[row]) / (2.0 * size);
                let found = seen.by_twist[row][k];
                prop_assert!((difference - found).abs() < 1e-4 * (1.0 + found.abs()));
            }
        }
        for k in 0..3 {
            let side = |sign: f64| {
                let mut place = in_world.coordinates();
                place[k] += sign * size;
                camera.project(place.into())
            };
            let (Ok(ahead), Ok(behind)) = (side(1.0), side(-1.0)) else {
                return Err(TestCaseError::reject("at the edge of the field"));
            };
            for row in 0..2 {
                let difference = (ahead[row] - behind[row]) / (2.0 * size);
                let found = seen.by_point[row][k];
                prop_assert!((difference - found).abs() < 1e-4 * (1.0 + found.abs()));
            }
        }
    }

    #[test]
    fn a_pixel_looks_at_what_is_seen_there(
        world in (vector(1.0), -3.0..3.0, vector(2.0)),
        point in place(),
        coefficients in coefficients(),
        k in prop::array::uniform4(-0.05..0.05),
    ) {
        let pose = motor(world.0, world.1, world.2);
        let in_world = pose.reverse().transform(Point::from(point));
        let lenses: [Lens; 3] = [
            Lens::Pinhole,
            RadialTangential::new(&coefficients).unwrap().into(),
            Fisheye::new(&k).unwrap().into(),
        ];
        let mut inverted = 0;
        for lens in lenses {
            let camera = Camera { intrinsics: pinhole().with_lens(lens), world_to_camera: pose };
            let Ok(pixel) = camera.project(in_world) else { continue };
            // Where the tangential terms fold the image, there is none or another ray.
            let Ok(ray) = camera.ray(pixel) else { continue };
            let again = camera.project(ray.at(2.0)).unwrap();
            prop_assert!((again[0] - pixel[0]).abs() < 1e-8 && (again[1] - pixel[1]).abs() < 1e-8);
            inverted += 1;
        }
        // proptest refuses to go on where too many cases are rejected, as if most lenses failed.
        prop_assume!(inverted == lenses.len());
    }

    #[test]
    fn moderate_distortion_is_always_inverted(
        point in place(),
        k1 in -0.3..0.3,
        k2 in -0.05..0.1,
        p in prop::array::uniform2(-2e-3..2e-3),
    ) {
        let lens = RadialTangential::new(&[k1, k2, p[0], p[1]]).unwrap();
        prop_assume!(lens.field_radius() > 1.3);
        let camera = pinhole().with_lens(lens);
        let truth = Point::from(point);
        let direction = camera.direction(camera.project(truth).unwrap()).unwrap();
        let angle = direction.angle(Direction::from_vector(point)).unwrap();
        prop_assert!(angle < 1e-12, "{angle:e}");
        let flat = camera.undistort(camera.project(truth).unwrap()).unwrap();
        let expected = pinhole().project(truth).unwrap();
        prop_assert!((flat[0] - expected[0]).abs() < 1e-9 && (flat[1] - expected[1]).abs() < 1e-9);
    }

    #[test]
    fn parameters_come_back(coefficients in coefficients()) {
        let camera = pinhole().with_lens(RadialTangential::new(&coefficients).unwrap());
        let parameters = camera.parameters();
        prop_assert_eq!(camera.with_parameters(&parameters).unwrap(), camera);
        prop_assert_eq!(pinhole().with_parameters(&parameters[..4]).unwrap(), pinhole());
    }

    #[test]
    fn poses_with_frames_are_motors(a in (vector(1.0), -3.0..3.0, vector(2.0)), point in place()) {
        let camera = Camera {
            intrinsics: pinhole(),
            world_to_camera: motor(a.0, a.1, a.2),
        };
        let point = In::<World, _>::new(Point::from(point));
        let seen: In<CameraFrame, Point<f64>> = camera.pose().transform(point);
        prop_assert_eq!(seen.value, camera.world_to_camera.transform(point.value));
        let back = camera.pose().reverse().transform(seen);
        prop_assert!(back.value.distance(point.value) < 1e-13);
    }
}

#[test]
fn opencv_sees_the_same_pixels() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/cameras.json");
    let text = std::fs::read_to_string(path).expect("the data is committed");
    let truth: Value = serde_json::from_str(&text).expect("JSON");
    let plain = Intrinsics::from_matrix(matrix(&truth["K"])).unwrap();
    let check = |record: &Value, lens: Lens| {
        let camera = plain.with_lens(lens);
        let (points, pixels) = (rows::<3>(&record["X"]), rows::<2>(&record["pixels"]));
        assert_eq!(points.len(), 20);
        for (point, pixel) in points.into_iter().zip(pixels) {
            let found = camera.project(point.into()).unwrap();
            assert!((found[0] - pixel[0]).abs() < 1e-10 * 1e3);
            assert!((found[1] - pixel[1]).abs() < 1e-10 * 1e3);
            let direction = camera.direction(pixel).unwrap();
            let angle = direction.angle(Direction::from_vector(point)).unwrap();
            assert!(angle < 1e-9, "{angle:e}");
        }
    };
    let coefficients = |record: &Value| -> Vec<f64> {
        let list = record["D"].as_array().expect("a list");
        list.iter().map(|x| x.as_f64().expect("a number")).collect()
    };
    for record in truth["distorted"].as_array().unwrap() {
        let lens = RadialTangential::new(&coefficients(record)).unwrap();
        check(record, lens.into());
    }
    let record = &truth["fisheye"];
    check(record, Fisheye::new(&coefficients(record)).unwrap().into());
}

#[test]
fn a_fisheye_sees_beside_and_behind_itself() {
    let camera = pinhole().with_lens(Fisheye::new(&[0.0; 4]).unwrap());
    let [u, v] = camera.project(Point::new(1.0, 0.0, 0.0)).unwrap();
    assert!((u - (342.4 + 536.0 * std::f64::consts::FRAC_PI_2)).abs() < 1e-9 && v == 235.5);
    let behind = Point::new(-0.3, 0.4, -0.2);
    let seen = camera.project_with_derivatives(behind).unwrap();
    let direction = camera.direction(seen.pixel).unwrap();
    let angle = direction.angle(Direction::new(-0.3, 0.4, -0.2)).unwrap();
    assert!(angle < 1e-14, "{angle:e}");
    // On the axis: the derivatives are those of a pinhole.
    let ahead = camera.project_with_derivatives(Point::new(0.0, 0.0, 2.0));
    let plain = pinhole().project_with_derivatives(Point::new(0.0, 0.0, 2.0));
    assert_eq!(ahead.unwrap().by_point, plain.unwrap().by_point);
    let opposite = camera.project(Point::new(0.0, 0.0, -1.0));
    assert!(matches!(opposite, Err(CameraError::PointOutsideField(_))));
}

#[test]
fn folded_images_are_not_seen() {
    // r (1 − r²/3) rises up to r = 1, where it is 2/3.
    let lens = RadialTangential::new(&[-1.0 / 3.0, 0.0, 0.0, 0.0]).unwrap();
    assert!((lens.field_radius() - 1.0).abs() < 1e-15);
    let camera = pinhole().with_lens(lens);
    assert!(camera.project(Point::new(0.0, 0.999, 1.0)).is_ok());
    let beyond = Point::new(0.0, 1.001, 1.0);
    assert!(matches!(
        camera.project(beyond),
        Err(CameraError::PointOutsideField(point)) if point == beyond.coordinates()
    ));
    assert!(camera.project_with_derivatives(beyond).is_err());
    let pixel = [342.4, 235.5 + 540.0 * 0.667];
    assert_eq!(
        camera.direction(pixel),
        Err(CameraError::PixelOutsideField(pixel))
    );
    // A pole of the rational factor: 1 − r²/4 is zero at r = 2, and before it the radius rises.
    let pole = RadialTangential::new(&[0.0, 0.0, 0.0, 0.0, 0.0, -0.25, 0.0, 0.0]).unwrap();
    assert!((pole.field_radius() - 2.0).abs() < 1e-14);
    // θ (1 − θ²/3).
    let fisheye = Fisheye::new(&[-1.0 / 3.0, 0.0, 0.0, 0.0]).unwrap();
    assert!((fisheye.field_angle() - 1.0).abs() < 1e-15);
    let camera = pinhole().with_lens(fisheye);
    assert_eq!(
        camera.direction(pixel),
        Err(CameraError::PixelOutsideField(pixel))
    );
}

#[test]
fn faulty_lenses_are_named() {
    assert!(matches!(
        RadialTangential::new(&[0.0; 6]),
        Err(CameraError::CoefficientCount { found: 6, .. })
    ));
    assert!(matches!(
        RadialTangential::new(&[0.0, 0.0, f64::NAN, 0.0]),
        Err(CameraError::Coefficient { name: "p1", .. })
    ));
    let mut tilted = [0.0; 14];
    tilted[13] = 2.0;
    assert!(matches!(
        RadialTangential::new(&tilted),
        Err(CameraError::Coefficient {
            name: "tauY",
            value: 2.0,
            ..
        })
    ));
    assert!(matches!(
        Fisheye::new(&[0.0; 5]),
        Err(CameraError::CoefficientCount { found: 5, .. })
    ));
    assert!(matches!(
        Fisheye::new(&[0.0, 0.0, 0.0, f64::INFINITY]),
        Err(CameraError::Coefficient { name: "k4", .. })
    ));
    assert!(matches!(
        pinhole().with_parameters(&[1.0; 5]),
        Err(CameraError::ParameterCount {
            found: 5,
            expected: 4
        })
    ));
    assert!(pinhole().with_parameters(&[-1.0, 1.0, 0.0, 0.0]).is_err());
    assert!(pinhole().direction([f64::NAN, 0.0]).is_err());
}
