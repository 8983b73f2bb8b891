//! Points of two views and of many, with known noise.

use ga_camera::triangulation::{
    CovarianceColumns, Method, PixelColumns, PointColumns, TwoViews, triangulate_views,
};
use ga_camera::{Camera, Intrinsics};
use ga_runtime::cga3::{Motor, Point};
use ga_runtime::vga3::Vector;

use super::super::motor;
use super::{Coverage, NOISE, Random, check, mahalanobis, runs};

fn coverage(name: &str, motors: &[Motor<f64>], point: impl Fn(&mut Random) -> [f64; 3]) {
    let intrinsics = Intrinsics::new([700.0; 2], [319.5, 239.5]).unwrap();
    let cameras: Vec<Camera> = motors
        .iter()
        .map(|&world_to_camera| Camera {
            intrinsics,
            world_to_camera,
        })
        .collect();
    let two = TwoViews::new(&cameras[0], &cameras[1]).unwrap();
    let mut of_two = Coverage::new(format!("points, {name}, two views"));
    let mut of_many = Coverage::new(format!("points, {name}, {} views", cameras.len()));
    for run in runs(100) {
        let mut random = Random::new(run);
        let truth = Point::from(point(&mut random));
        let seen = cameras.iter().map(|camera| camera.project(truth).unwrap());
        let pixels: Vec<_> = seen.map(|pixel| random.noisy(pixel)).collect();
        let columns = |pixel: &[f64; 2]| pixel.map(|u| [u]);
        let [left, right] = [columns(&pixels[0]), columns(&pixels[1])];
        let column = |[u, v]: &[[f64; 1]; 2]| (u.to_vec(), v.to_vec());
        let [left, right] = [column(&left), column(&right)];
        let (mut points, mut covariances) = (PointColumns::default(), CovarianceColumns::default());
        let views = [&left, &right].map(|(u, v)| PixelColumns { u, v });
        two.triangulate(Method::Optimal, views[0], views[1], &mut points)
            .unwrap();
        two.covariances(NOISE, &points, &mut covariances).unwrap();
        let error = |found: Point<f64>| (Vector::from(truth) - Vector::from(found)).coordinates();
        let found = points.get(0).unwrap().position;
        let covariance = covariances.get(0).unwrap();
        of_two.add(mahalanobis(&error(found), |i, j| covariance[i][j]), 3);

        let found = triangulate_views(&cameras, &pixels).unwrap();
        let scaled = |i: usize, j: usize| NOISE * NOISE * found.covariance[i][j];
        of_many.add(mahalanobis(&error(found.position), scaled), 3);
    }
    check(&[of_two, of_many]);
}

#[test]
fn points_of_views() {
    let general = |random: &mut Random| {
        let z = random.within(4.0, 8.0);
        [
            random.within(-0.4, 0.4) * z,
            random.within(-0.3, 0.3) * z,
            z,
        ]
    };
    let side = |x: f64| motor([0.3, 1.0, -0.2], 0.06 * x, [-0.8 * x, 0.1, 0.1 * x]);
    coverage(
        "general",
        &[Motor::default(), side(1.0), side(-1.0)],
        general,
    );
    let plane = |random: &mut Random| {
        let [x, y] = [random.within(-0.4, 0.4), random.within(-0.3, 0.3)];
        let z = 6.0 / (1.0 - 0.3 * x + 0.2 * y);
        [x * z, y * z, z]
    };
    coverage("planar", &[Motor::default(), side(1.0), side(-1.0)], plane);
    let near_plane = |random: &mut Random| {
        let off = 1.0 + 0.02 * random.normal();
        plane(random).map(|coordinate| off * coordinate)
    };
    let motors = [Motor::default(), side(1.0), side(-1.0)];
    coverage("near-planar", &motors, near_plane);
    let ahead = |z: f64| motor([0.0, 1.0, 0.0], 0.01, [0.02, 0.01, -z]);
    let beside = |random: &mut Random| {
        let z = random.within(4.0, 8.0);
        let side = if random.within(0.0, 1.0) < 0.5 {
            -1.0
        } else {
            1.0
        };
        [
            side * random.within(0.2, 0.4) * z,
            random.within(-0.3, 0.3) * z,
            z,
        ]
    };
    coverage(
        "forward",
        &[Motor::default(), ahead(1.0), ahead(0.5)],
        beside,
    );
    // 6 to 12 pixels of parallax at a baseline of a hundredth of the depth.
    let near = |x: f64| motor([0.0, 1.0, 0.0], 0.0, [-0.08 * x, 0.0, 0.0]);
    coverage("narrow", &[Motor::default(), near(1.0), near(0.5)], general);
}
