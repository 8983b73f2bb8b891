//! Points of pairs without noise, from single rays, and in any order.

use ga_camera::rig::StereoRig;
use ga_camera::triangulation::{
    Method, PixelColumns, PointColumns, TriangulationError, TwoViews, triangulate_views,
};
use ga_camera::{Camera, Intrinsics, RadialTangential};
use ga_runtime::batch::InstructionSet;
use ga_runtime::cga3::{Motor, Point};
use proptest::prelude::*;

use super::{METHODS, Pairs, found, motor, places, rigs, seen, side_by_side};

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

/// Pixels behind distorted lenses are undistorted first, and no camera of columns takes them raw.
#[test]
fn distorted_lenses_are_seen_through() {
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
