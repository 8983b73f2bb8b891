//! Points that several cameras see.

use ga_camera::triangulation::{TriangulationError, triangulate_views};
use ga_camera::{Camera, Intrinsics};
use ga_runtime::cga3::Point;
use proptest::prelude::*;

/// Cameras on a circle about the y axis that look at its middle from a height.
fn cameras(count: usize, radius: f64) -> Vec<Camera> {
    let intrinsics = Intrinsics::new([800.0, 760.0], [320.0, 240.0]).unwrap();
    let eye = |index: usize| {
        let angle = 2.1 * index as f64 / count as f64 + 0.3;
        [
            radius * angle.cos(),
            0.5 + 0.1 * index as f64,
            radius * angle.sin(),
        ]
    };
    (0..count)
        .map(|index| {
            Camera::look_at(
                intrinsics,
                eye(index).into(),
                Point::default(),
                [0.0, 1.0, 0.0],
            )
            .unwrap()
        })
        .collect()
}

fn cost(cameras: &[Camera], pixels: &[[f64; 2]], point: Point<f64>) -> f64 {
    let errors = cameras.iter().zip(pixels).map(|(camera, pixel)| {
        let [u, v] = camera.project(point).unwrap();
        (u - pixel[0]).powi(2) + (v - pixel[1]).powi(2)
    });
    errors.sum()
}

proptest! {
    #[test]
    fn exact_pixels_give_the_point(
        count in 2..9_usize,
        place in prop::array::uniform3(-1.0..1.0),
    ) {
        let cameras = cameras(count, 4.0);
        let point = Point::from(place);
        let pixels: Vec<_> = cameras.iter().map(|camera| camera.project(point).unwrap()).collect();
        let found = triangulate_views(&cameras, &pixels).unwrap();
        prop_assert!(found.position.distance(point) < 1e-13, "{found:?}");
        prop_assert!(found.gap < 1e-13 && found.error_px < 1e-10 && found.depth > 0.0);
        // The largest angle at the point between two centres.
        let mut largest: f64 = 0.0;
        for a in &cameras {
            for b in &cameras {
                let [a, b] = [a, b].map(|camera| point.vector_to(camera.centre()));
                largest = largest.max(a.angle(b).unwrap());
            }
        }
        prop_assert!((found.angle - largest).abs() < 1e-7);
    }

    /// The gradient of the error vanishes, and no point beside is better.
    #[test]
    fn noisy_pixels_give_the_least_error(
        count in 2..9_usize,
        place in prop::array::uniform3(-1.0..1.0),
        errors in prop::collection::vec(prop::array::uniform2(-3.0..3.0), 9),
    ) {
        let cameras = cameras(count, 4.0);
        let exact = cameras.iter().map(|camera| camera.project(place.into()).unwrap());
        let pixels: Vec<_> = exact.zip(&errors).map(|([u, v], [du, dv])| [u + du, v + dv]).collect();
        let found = triangulate_views(&cameras, &pixels).unwrap();
        let least = cost(&cameras, &pixels, found.position);
        prop_assert!((found.error_px.powi(2) * count as f64 - least).abs() < 1e-12 * least.max(1e-6));
        for axis in 0..3 {
            let beside = |step: f64| {
                let mut place = found.position.coordinates();
                place[axis] += step;
                cost(&cameras, &pixels, place.into())
            };
            for step in [1e-5, 1e-3, 0.1] {
                prop_assert!(beside(step) >= least && beside(-step) >= least);
            }
            // The second derivative is twice the inverse of what the covariance would be with the
            // other axes held, so that the slope is far below it.
            let slope = (beside(1e-5) - beside(-1e-5)) / 2e-5;
            let bend = (beside(1e-3) + beside(-1e-3) - 2.0 * least) / 1e-6;
            prop_assert!(slope.abs() < 1e-6 * bend, "{slope} {bend}");
        }
    }
}

/// The scatter of points found from noisy pixels is what the covariance says.
#[test]
fn the_covariance_is_that_of_the_scatter() {
    use ga_camera::observation::observe;
    let cameras = cameras(3, 4.0);
    let (truth, count, noise) = (Point::new(0.3, -0.2, 0.4), 4000, 0.5);
    let views: Vec<Vec<[f64; 2]>> = (0_u64..)
        .zip(&cameras)
        .map(|(seed, camera)| observe(camera, &vec![truth; count], noise, seed).unwrap())
        .collect();
    let mut sums = [0.0; 3];
    let mut expected = [0.0; 3];
    for index in 0..count {
        let pixels: Vec<_> = views.iter().map(|view| view[index]).collect();
        let found = triangulate_views(&cameras, &pixels).unwrap();
        let way = truth.vector_to(found.position).coordinates();
        for axis in 0..3 {
            sums[axis] += way[axis] * way[axis] / count as f64;
            expected[axis] = noise * noise * found.covariance[axis][axis];
        }
    }
    for axis in 0..3 {
        // Five standard errors of a variance.
        let bound = 5.0 * (2.0 / count as f64).sqrt();
        assert!(
            (sums[axis] / expected[axis] - 1.0).abs() < bound,
            "{sums:?} {expected:?}"
        );
    }
}

#[test]
fn bad_views_are_named() {
    let cameras = cameras(3, 4.0);
    let seen = |point: Point<f64>| -> Vec<[f64; 2]> {
        cameras
            .iter()
            .map(|camera| camera.project(point).unwrap())
            .collect()
    };
    let pixels = seen(Point::new(0.1, 0.2, 0.3));
    assert_eq!(
        triangulate_views(&cameras, &pixels[..2]),
        Err(TriangulationError::Counts {
            cameras: 3,
            pixels: 2
        })
    );
    for found in [0, 1] {
        assert_eq!(
            triangulate_views(&cameras[..found], &pixels[..found]),
            Err(TriangulationError::TooFewViews { found })
        );
    }
    let mut faulty = pixels.clone();
    faulty[1][0] = f64::INFINITY;
    let error = triangulate_views(&cameras, &faulty).unwrap_err();
    assert!(
        matches!(error, TriangulationError::Camera { view: 1, .. }),
        "{error}"
    );
    let same = [cameras[0]; 3];
    assert!(matches!(
        triangulate_views(&same, &[pixels[0]; 3]),
        Err(TriangulationError::Parallel { .. })
    ));
    // Pixels of two cameras that look past each other: their rays meet behind the first.
    let intrinsics = Intrinsics::new([800.0, 800.0], [320.0, 240.0]).unwrap();
    let at = |x: f64| {
        let target = Point::new(x, 0.0, 5.0);
        Camera::look_at(intrinsics, Point::new(x, 0.0, 0.0), target, [0.0, 1.0, 0.0]).unwrap()
    };
    let crossed = triangulate_views(&[at(1.0), at(0.0)], &[[310.0, 240.0], [330.0, 240.0]]);
    let open = triangulate_views(&[at(1.0), at(0.0)], &[[330.0, 240.0], [310.0, 240.0]]);
    let behind = |found: &Result<_, _>| matches!(found, Err(TriangulationError::Behind { .. }));
    assert!(behind(&crossed) != behind(&open), "{crossed:?} {open:?}");
}
