//! Cameras with given intrinsics, against the plain formula of projection.

use ga_camera::{Camera, Fisheye, Intrinsics, RadialTangential};
use ga_render::{Buffers, Object, RenderError, Scene, View};
use ga_runtime::cga3::{Motor, Point, Rotor, Translator};
use proptest::prelude::*;

use crate::scenes::{UNIT_SQUARE, cross, dot, square};

/// A calibration and a pose, as matrices.
#[derive(Clone, Copy, Debug)]
struct Plain {
    focal: [f64; 2],
    principal: [f64; 2],
    skew: f64,
    axis: [f64; 3],
    angle: f64,
    translation: [f64; 3],
}

impl Plain {
    fn motor(&self) -> Motor<f64> {
        let rotor = Rotor::from_axis_angle(self.axis, self.angle).unwrap();
        Translator::from_displacement(self.translation) * rotor
    }

    /// Rodrigues' formula.
    fn in_frame(&self, p: [f64; 3]) -> [f64; 3] {
        let length = self.axis.iter().map(|c| c * c).sum::<f64>().sqrt();
        let k = self.axis.map(|c| c / length);
        let (sine, cosine) = self.angle.sin_cos();
        let along = dot(k, p);
        let across = cross(k, p);
        std::array::from_fn(|i| {
            p[i] * cosine + across[i] * sine + k[i] * along * (1.0 - cosine) + self.translation[i]
        })
    }

    fn pixel(&self, p: [f64; 3]) -> [f64; 2] {
        let [x, y, z] = self.in_frame(p);
        [
            self.focal[0] * x / z + self.skew * y / z + self.principal[0],
            self.focal[1] * y / z + self.principal[1],
        ]
    }

    fn view(&self) -> View {
        let view = View::pinhole(&camera(self.focal, self.principal, self.motor()), 0.1);
        view.unwrap().with_skew(self.skew).unwrap()
    }
}

fn camera(focal: [f64; 2], principal: [f64; 2], world_to_camera: Motor<f64>) -> Camera {
    Camera {
        intrinsics: Intrinsics::new(focal, principal).unwrap(),
        world_to_camera,
    }
}

fn plain() -> impl Strategy<Value = Plain> {
    (
        [40f64..90.0, 40f64..90.0],
        [10f64..50.0, 5f64..40.0],
        -8f64..8.0,
        [-1f64..1.0, -1f64..1.0, 0.2f64..1.0],
        -0.7f64..0.7,
        [-0.5f64..0.5, -0.5f64..0.5, 2f64..4.0],
    )
        .prop_map(|(focal, principal, skew, axis, angle, translation)| Plain {
            focal,
            principal,
            skew,
            axis,
            angle,
            translation,
        })
}

proptest! {
    #[test]
    fn points_fall_where_the_formula_says(plain in plain(), point in prop::array::uniform3(-1f64..1.0)) {
        let camera = plain.view();
        let [u, v] = plain.pixel(point);
        let [column, row, depth] = camera.project(point, 64, 48).unwrap();
        // The middle of the first pixel is (0, 0) in one convention and (½, ½) in the other.
        prop_assert!((column - 0.5 - u).abs() < 1e-9 && (row - 0.5 - v).abs() < 1e-9);
        prop_assert!((depth - plain.in_frame(point)[2]).abs() < 1e-12);
    }

    /// The surface point seen in a pixel is projected back to the middle of that pixel.
    #[test]
    fn pictures_agree_with_the_formula(plain in plain()) {
        let (positions, scale) = (square(0.0), 3.0);
        let positions = positions.map(|p| p.map(|c| c * scale));
        let scene = Scene::new(&positions, &UNIT_SQUARE);
        let camera = plain.view();
        let buffers = Buffers::new(&scene, &camera, 64, 48).unwrap();
        let mut seen = 0;
        for row in 0..48 {
            for column in 0..64 {
                let Some(point) = buffers.get(column, row) else { continue };
                let [u, v] = plain.pixel(point.position);
                // Outlines lie on a grid of 1/4096 pixel, and no place lies beyond its triangle.
                let on_edge = point.barycentric.contains(&0.0);
                let tolerance = if on_edge { 1e-3 } else { 1e-8 };
                let close = |a: f64, b: usize| (a - b as f64).abs() < tolerance;
                prop_assert!(close(u, column) && close(v, row));
                let depth = plain.in_frame(point.position)[2];
                prop_assert!((point.depth - depth).abs() < 1e-9);
                prop_assert!(point.position[2].abs() < 1e-9);
                seen += 1;
            }
        }
        prop_assert!(seen > 1000, "{seen}");
    }

    #[test]
    fn the_pose_comes_back(plain in plain()) {
        let camera = plain.view();
        let [a, b] = [plain.motor(), camera.camera(64, 48).unwrap().world_to_camera].map(|m| m.to_matrix());
        for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
            prop_assert!((a - b).abs() < 1e-12);
        }
    }
}

#[test]
fn a_picture_without_skew_agrees_with_ga_camera() {
    let intrinsics = [[70.0, 65.0], [31.0, 22.5]];
    let pose = Translator::from_displacement([0.2, -0.1, 2.5])
        * Rotor::from_axis_angle([1.0, 2.0, 0.5], 0.4).unwrap();
    let other = camera(intrinsics[0], intrinsics[1], pose);
    let camera = View::pinhole(&other, 0.1).unwrap();
    let positions = square(0.3);
    let scene = Scene::new(&positions, &UNIT_SQUARE);
    let buffers = Buffers::new(&scene, &camera, 64, 48).unwrap();
    let mut seen = 0;
    for (index, point) in buffers.points().values().iter().enumerate() {
        let Some(point) = point else { continue };
        let [u, v] = other.project(Point::from(point.position)).unwrap();
        assert!((u - (index % 64) as f64).abs() < 1e-9 && (v - (index / 64) as f64).abs() < 1e-9);
        seen += 1;
    }
    assert!(seen > 800, "{seen}");
}

#[test]
fn nothing_is_seen_beyond_the_far_depth() {
    // A floor that recedes: at offset −1 down, row r sees it at depth f / (r − c).
    let positions = [
        [-50.0, 1.0, 0.5],
        [50.0, 1.0, 0.5],
        [50.0, 1.0, 90.0],
        [-50.0, 1.0, 90.0],
    ];
    let scene = Scene::new(&positions, &UNIT_SQUARE);
    let camera = camera([40.0, 40.0], [20.0, 0.0], Motor::default());
    let camera = View::pinhole(&camera, 0.1).unwrap().with_far(10.0).unwrap();
    let buffers = Buffers::new(&scene, &camera, 41, 41).unwrap();
    for row in 1..41 {
        let depth = 40.0 / row as f64;
        let seen = buffers.get(20, row);
        if row == 4 {
            continue; // Exactly at the far depth.
        }
        assert_eq!(seen.is_some(), depth < 10.0, "{row}");
        if let Some(seen) = seen {
            assert!((seen.depth - depth).abs() < 1e-9);
            assert!((seen.distance - depth.hypot(1.0)).abs() < 1e-9);
        }
    }
    assert_eq!(
        camera.with_far(0.05).unwrap_err(),
        RenderError::Camera("its far depth is not beyond its near depth")
    );
}

#[test]
fn objects_are_moved_by_their_transform() {
    let motor = Translator::from_displacement([0.3, -0.2, 1.0])
        * Rotor::from_axis_angle([0.3, 1.0, -0.4], 0.8).unwrap();
    let positions = square(0.0);
    let moved = positions.map(|p| motor.transform(Point::from(p)).coordinates());
    let camera = View::look_at([0.0, 1.0, 5.0], [0.0; 3], [0.0, 1.0, 0.0], 0.8, 0.1).unwrap();
    let object = Object {
        transform: motor,
        ..Object::new(&positions, &UNIT_SQUARE)
    };
    let one = Scene {
        objects: vec![object],
        ..Scene::default()
    };
    let other = Scene::new(&moved, &UNIT_SQUARE);
    let [one, other] = [&one, &other].map(|scene| Buffers::new(scene, &camera, 50, 50).unwrap());
    let mut seen = 0;
    for (a, b) in one.points().values().iter().zip(other.points().values()) {
        match (a, b) {
            (Some(a), Some(b)) => {
                let same =
                    |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9);
                assert!(same(a.position, b.position) && same(a.normal, b.normal));
                seen += 1;
            }
            (a, b) => assert!(a.is_none() && b.is_none()),
        }
    }
    assert!(seen > 100, "{seen}");
}

#[test]
fn bad_cameras_are_refused() {
    let scaled = Motor::new_unchecked(2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    let lost = Motor::from(Translator::from_displacement([f64::NAN, 0.0, 0.0]));
    let pose = Motor::default();
    let good = camera([50.0, 50.0], [20.0, 20.0], pose);
    for bad in [
        View::pinhole(&camera([1e-31, 50.0], [20.0, 20.0], pose), 0.1),
        View::pinhole(&camera([50.0, 50.0], [1e31, 0.0], pose), 0.1),
        View::pinhole(&camera([50.0, 50.0], [20.0, 20.0], scaled), 0.1),
        View::pinhole(&camera([50.0, 50.0], [20.0, 20.0], lost), 0.1),
        View::pinhole(&good, 0.0),
        View::pinhole(&good, 0.1).unwrap().with_skew(f64::NAN),
    ] {
        assert!(matches!(bad, Err(RenderError::Camera(_))), "{bad:?}");
    }
}

#[test]
fn a_lens_with_distortion_is_refused() {
    let good = camera([50.0, 50.0], [20.0, 20.0], Motor::default());
    for lens in [
        RadialTangential::new(&[-0.1, 0.0, 0.0, 0.0])
            .unwrap()
            .into(),
        ga_camera::Lens::from(Fisheye::new(&[0.0; 4]).unwrap()),
    ] {
        let bad = Camera {
            intrinsics: good.intrinsics.with_lens(lens),
            ..good
        };
        let error = View::pinhole(&bad, 0.1).unwrap_err();
        assert_eq!(error, RenderError::Lens);
    }
}
