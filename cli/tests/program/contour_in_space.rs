//! `nullcone contour LEFT RIGHT --rig`: closed curves in space whose places are known.

use std::fmt::Write as _;
use std::path::Path;

use ga_camera::format::rig;
use ga_camera::rig::StereoRig;
use ga_camera::{Camera, Intrinsics, RadialTangential};
use ga_image::file;
use ga_image::plane::Plane;
use ga_mesh::obj;
use ga_runtime::cga3::{Motor, Plane as Flat, Point, Rotor, Translator};
use serde_json::Value;
use tempfile::{TempDir, tempdir};

use crate::common::{assert_failure, assert_success, names, nullcone, number};

const SIZE: [usize; 2] = [480, 360];

/// Where the disk is: its centre and its frame, whose z axis is the normal.
fn placement() -> Motor<f64> {
    let rotor = Rotor::from_axis_angle([1.0, 0.4, 0.2], 0.6).unwrap();
    Translator::from_displacement([0.05, -0.02, 1.5]) * rotor
}

/// Two cameras that see the disk from different heights, the right one rolled and rotated.
fn rig(lens: Option<RadialTangential>) -> StereoRig {
    let camera = |focal: f64, column: f64, world_to_camera| {
        let intrinsics = Intrinsics::new([focal, focal], [column, 178.0]).unwrap();
        Camera {
            intrinsics: match lens {
                Some(lens) => intrinsics.with_lens(lens),
                None => intrinsics,
            },
            world_to_camera,
        }
    };
    let rotor = Rotor::from_axis_angle([0.15, 0.9, 0.4], 0.22).unwrap();
    let motor = Translator::from_displacement([-0.34, 0.1, 0.04]) * rotor;
    StereoRig {
        left: camera(430.0, 238.0, Motor::default()),
        right: camera(440.0, 244.0, motor),
    }
}

/// A bright shape in the plane of the disk. Pixels at its border are seen by rays through 8 × 8
/// places of each.
fn view(camera: &Camera, is_inside: impl Fn(f64, f64) -> bool) -> Plane<u8> {
    const PARTS: usize = 8;
    let [centre, normal] =
        [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]].map(|p| placement().transform(Point::from(p)));
    let plane = Flat::from_point_normal(centre, centre.vector_to(normal).coordinates());
    let back = placement().reverse();
    let is_bright = |u: f64, v: f64| {
        let ray = camera.ray([u, v]).unwrap();
        let place = ray.first_hit(plane).map(|hit| back.transform(hit.point));
        place.is_some_and(|place| is_inside(place.x(), place.y()))
    };
    Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
        let [u, v] = [column, row].map(|place| place as f64);
        let corners = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]];
        let bright = corners.map(|[x, y]| is_bright(u + x, v + y));
        let share = if bright.iter().all(|other| *other == bright[0]) {
            f64::from(u8::from(bright[0]))
        } else {
            let place = |part: usize| (part as f64 + 0.5) / PARTS as f64 - 0.5;
            let hits = (0..PARTS * PARTS)
                .filter(|part| is_bright(u + place(part % PARTS), v + place(part / PARTS)))
                .count();
            hits as f64 / (PARTS * PARTS) as f64
        };
        (25.0 + 200.0 * share).round() as u8
    })
}

fn scene(rig: &StereoRig, views: [Plane<u8>; 2]) -> TempDir {
    let folder = tempdir().unwrap();
    for (name, view) in ["left.png", "right.png"].into_iter().zip(&views) {
        file::write(folder.path().join(name), view).unwrap();
    }
    let text = rig::encode(rig, Some(SIZE)).unwrap();
    std::fs::write(folder.path().join("rig.yml"), text).unwrap();
    folder
}

fn lens() -> RadialTangential {
    RadialTangential::new(&[-0.14, 0.04, 6e-4, -5e-4, 0.0]).unwrap()
}

const PAIR: [&str; 6] = [
    "contour",
    "left.png",
    "right.png",
    "--rig",
    "rig.yml",
    "--json",
];

fn found(folder: &Path, arguments: &[&str]) -> Value {
    let output = nullcone(folder, [&PAIR[..], arguments].concat());
    assert_success(&output);
    serde_json::from_slice(&output.stdout).unwrap()
}

fn triple(report: &Value, path: &str) -> Point<f64> {
    Point::from([0, 1, 2].map(|axis| number(report, &format!("{path}/{axis}"))))
}

/// The disk's radius and centre in metres, in the frame of the left camera.
fn check_disk(report: &Value, radius: f64) {
    let error = number(report, "/circle/radius_metres") - radius;
    assert!(error.abs() < 2e-3 * radius, "{error}");
    let centre = placement().transform(Point::default());
    let error = triple(report, "/circle/centre_metres").distance(centre);
    assert!(error < 2e-3, "{error}");
    assert!(number(report, "/circle/rms_metres") < 2e-3);
    let length = number(report, "/length_metres");
    assert!(
        (length / (std::f64::consts::TAU * radius) - 1.0).abs() < 5e-3,
        "{length}"
    );
    assert!(number(report, "/deviation_max_px") < 0.5);
    assert_eq!(report["left_snake"]["converged"], true);
}

#[test]
fn a_disk_seen_through_distorted_lenses_has_its_radius_and_place() {
    let rig = rig(Some(lens()));
    let disk = |x: f64, y: f64| x.hypot(y) < 0.3;
    let folder = scene(
        &rig,
        [rig.left, rig.right].map(|camera| view(&camera, disk)),
    );
    let report = found(
        folder.path(),
        &["--fit", "circle", "--axes", "camera", "--out", "curve.obj"],
    );
    check_disk(&report, 0.3);
    // The curve is closed, and its points are those of the report.
    let curve = obj::read(folder.path().join("curve.obj")).unwrap();
    let points = report["points"].as_array().unwrap();
    assert_eq!((curve.vertex_count(), points.len()), (400, 400));
    let chain = curve.polylines().get(0).unwrap();
    assert_eq!((chain.len(), chain[0], chain[400]), (401, 0, 0));
    for (index, position) in curve.coordinates().enumerate() {
        let reported = triple(&report, &format!("/points/{index}/position_metres"));
        assert!(reported.distance(Point::from(position)) < 1e-12);
    }
    // By default, y is up and z is towards the viewer.
    let flipped = found(folder.path(), &["--fit", "circle"]);
    let [x, y, z] = triple(&report, "/circle/centre_metres").coordinates();
    let other = triple(&flipped, "/circle/centre_metres");
    assert!(other.distance(Point::new(x, -y, -z)) < 1e-9);
}

#[test]
fn an_ellipse_lies_where_it_is() {
    let rig = rig(Some(lens()));
    let ellipse = |x: f64, y: f64| (x / 0.35).hypot(y / 0.2) < 1.0;
    let folder = scene(
        &rig,
        [rig.left, rig.right].map(|camera| view(&camera, ellipse)),
    );
    let report = found(folder.path(), &["--axes", "camera"]);
    let back = placement().reverse();
    let mut squares = 0.0;
    for index in 0..400 {
        let place = triple(&report, &format!("/points/{index}/position_metres"));
        let [x, y, z] = back.transform(place).coordinates();
        // To first order the distance from the ellipse in its plane.
        let level = (x / 0.35).powi(2) + (y / 0.2).powi(2) - 1.0;
        let slope = (2.0 * x / 0.35f64.powi(2)).hypot(2.0 * y / 0.2f64.powi(2));
        squares += (level / slope).powi(2) + z * z;
    }
    let rms = f64::sqrt(squares / 400.0);
    assert!(rms < 2e-3, "{rms}");
}

/// The same disk as a mesh, drawn by `nullcone render`.
#[test]
fn a_rendered_disk_has_its_radius_and_place() {
    const CORNERS: usize = 720;
    let rig = rig(None);
    let folder = tempdir().unwrap();
    let mut mesh = String::new();
    for corner in 0..CORNERS {
        let (sin, cos) = (std::f64::consts::TAU * corner as f64 / CORNERS as f64).sin_cos();
        let [x, y, z] = placement()
            .transform(Point::new(0.3 * cos, 0.3 * sin, 0.0))
            .coordinates();
        let _ = writeln!(mesh, "v {x} {y} {z}");
    }
    let corners: Vec<String> = (1..=CORNERS).map(|corner| corner.to_string()).collect();
    let _ = writeln!(mesh, "f {}", corners.join(" "));
    std::fs::write(folder.path().join("disk.obj"), mesh).unwrap();
    for (name, camera) in [("left", rig.left), ("right", rig.right)] {
        let [[fx, fy], [cx, cy]] = [camera.intrinsics.focal(), camera.intrinsics.principal()];
        let file = serde_json::json!({
            "width": SIZE[0], "height": SIZE[1], "fx": fx, "fy": fy, "cx": cx, "cy": cy,
            "rotation": camera.world_to_camera.rotor().to_matrix(),
            "translation": camera.world_to_camera.translator().displacement(),
        });
        std::fs::write(folder.path().join(format!("{name}.json")), file.to_string()).unwrap();
        let [camera, picture] = [format!("{name}.json"), format!("{name}.png")];
        let output = nullcone(
            folder.path(),
            [
                "render",
                "disk.obj",
                "--camera",
                &camera,
                "--out",
                &picture,
                "--shading",
                "unlit",
                "--samples",
                "8",
                "--background",
                "101010",
            ],
        );
        assert_success(&output);
    }
    let text = rig::encode(&rig, Some(SIZE)).unwrap();
    std::fs::write(folder.path().join("rig.yml"), text).unwrap();
    check_disk(
        &found(folder.path(), &["--fit", "circle", "--axes", "camera"]),
        0.3,
    );
}

#[test]
fn bad_input_leaves_nothing() {
    let rig = rig(Some(lens()));
    let disk = |x: f64, y: f64| x.hypot(y) < 0.3;
    let [left, right] = [rig.left, rig.right].map(|camera| view(&camera, disk));
    let nothing = Plane::filled(SIZE[0], SIZE[1], 25u8);
    let shifted = |by: [isize; 2]| {
        Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
            let [u, v] = [(column, by[0]), (row, by[1])].map(|(at, by)| at.wrapping_add_signed(by));
            right.get(u, v).unwrap_or(25)
        })
    };
    for (picture, parts) in [
        (&nothing, &["right.png", "no contour", "same level"][..]),
        (
            &shifted([-180, 0]),
            &["right.png", "leaves the picture of 480 × 360", "(479,"],
        ),
        (&shifted([0, 90]), &["left.png and right.png", "contour"]),
    ] {
        let folder = scene(&rig, [left.clone(), picture.clone()]);
        let before = names(folder.path());
        let output = nullcone(folder.path(), [&PAIR[..], &["--out", "c.obj"]].concat());
        assert_failure(&output, parts);
        assert_eq!(names(folder.path()), before);
    }
    let folder = scene(&rig, [left, right]);
    let fails = |arguments: &[&str], parts: &[&str]| {
        let output = nullcone(folder.path(), [&PAIR[..], arguments].concat());
        assert_failure(&output, parts);
    };
    fails(&["--out", "c.svg"], &["--out c.svg", ".obj"]);
    fails(&["--points", "7"], &["7 points", "8 are needed"]);
    fails(
        &["--right-circle", "240,180,400"],
        &["right.png", "point 0", "480 × 360"],
    );
    let none = ["contour", "left.png", "right.png", "--rig", "none.yml"];
    assert_failure(&nullcone(folder.path(), none), &["none.yml"]);
}
