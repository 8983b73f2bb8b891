//! Many pairs of pixels of two cameras, against the oracle's rigs, least squares and closed forms.

mod covariance;
mod errors;
mod optimal;
mod points;

use ga_camera::rig::StereoRig;
use ga_camera::triangulation::{Method, PixelColumns, PointColumns, TwoViews};
use ga_camera::{Camera, Intrinsics};
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use proptest::prelude::*;

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

fn side_by_side() -> StereoRig {
    let intrinsics = Intrinsics::new([900.0, 880.0], [320.5, 239.5]).unwrap();
    let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    StereoRig::from_matrices(intrinsics, intrinsics, identity, [-0.5, 0.0, 0.0]).unwrap()
}
