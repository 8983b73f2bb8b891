//! `nullcone contour`: borders and snakes of pictures whose shapes are known.

use std::path::Path;

use ga_image::file;
use ga_image::plane::Plane;
use nullcone_shared_data::shared;
use serde_json::Value;
use tempfile::tempdir;

use crate::common::{assert_failure, assert_success, json, names, nullcone, number, text};

/// A bright ring with radii 30 and 10 px about (50, 40), in 110 × 80 pixels.
fn write_ring(folder: &Path) {
    let ring = Plane::from_fn(110, 80, |column, row| {
        let radius = (column as f64 - 50.0).hypot(row as f64 - 40.0);
        if (10.0..=30.0).contains(&radius) {
            220u8
        } else {
            30
        }
    });
    file::write(folder.join("ring.png"), &ring).unwrap();
}

#[test]
fn a_ring_has_two_borders() {
    let folder = tempdir().unwrap();
    write_ring(folder.path());
    let report = json(folder.path(), &["contour", "ring.png", "--out", "c.svg"]);
    assert_eq!(report["threshold"], 30);
    let contours = report["contours"].as_array().unwrap();
    assert_eq!(contours.len(), 2);
    for (contour, radius) in contours.iter().zip([30.0, 10.0]) {
        let found = number(contour, "/circle/radius_px");
        assert!((found - radius).abs() < 0.6, "{found}");
        for (axis, centre) in [50.0, 40.0].into_iter().enumerate() {
            let found = number(contour, &format!("/circle/centre_px/{axis}"));
            assert!((found - centre).abs() < 0.1, "{contour}");
        }
    }
    assert_eq!(contours[0]["hole"], false);
    assert_eq!(contours[1]["hole"], true);
    assert_eq!(contours[1]["parent"], 0);
    let svg = std::fs::read_to_string(folder.path().join("c.svg")).unwrap();
    assert_eq!(svg.matches("<polygon").count(), 4);
    assert!(svg.contains("data:image/png;base64,iVBOR"));
    let arguments = ["contour", "ring.png", "--least-area", "1000"];
    let output = nullcone(folder.path(), arguments);
    assert_success(&output);
    assert_eq!(text(&output.stdout).lines().count(), 2);
}

#[test]
fn a_snake_needs_a_circle_with_a_radius() {
    let folder = tempdir().unwrap();
    write_ring(folder.path());
    for circle in ["50,40,-5", "50,40,0"] {
        let start = ["contour", "ring.png", "--snake", "--out", "c.svg"];
        let circle = format!("--circle={circle}");
        let output = nullcone(folder.path(), start.into_iter().chain([&*circle]));
        assert_failure(&output, &["--circle", "not above 0"]);
    }
}

#[test]
fn a_snake_settles_at_the_ring() {
    let folder = tempdir().unwrap();
    write_ring(folder.path());
    for more in [
        &["--circle", "50,40,38"][..],
        &[],
        &["--circle", "50,40,38", "--flow"],
    ] {
        let start = ["contour", "ring.png", "--snake", "--out", "c.svg"];
        let report = json(folder.path(), &[&start[..], more].concat());
        assert_eq!(report["snake"]["converged"], true, "{more:?}");
        let radius = number(&report, "/contours/0/circle/radius_px");
        assert!((radius - 30.0).abs() < 0.5, "{radius}");
        let energies = report["snake"]["energies"].as_array().unwrap();
        let energies: Vec<f64> = energies.iter().filter_map(Value::as_f64).collect();
        assert!(energies.is_sorted_by(|a, b| a >= b));
        assert_eq!(energies.len() as f64, number(&report, "/snake/steps") + 1.0);
        let svg = std::fs::read_to_string(folder.path().join("c.svg")).unwrap();
        assert_eq!(svg.matches("<polygon").count(), 2);
    }
}

#[test]
fn snakes_of_the_oracle_settle_at_its_shapes() {
    let Some(oracle) = shared("oracle/vision/seed1") else {
        return;
    };
    let folder = tempdir().unwrap();
    for name in ["snake_disk.png", "snake_ellipse.png", "snake_star.png"] {
        let path = oracle.join(name);
        let start = ["contour", path.to_str().unwrap(), "--snake"];
        for more in [&["--circle", "100,100,80", "--points", "200"][..], &[]] {
            let report = json(folder.path(), &[&start[..], more].concat());
            let white = file::read(&path)
                .unwrap()
                .to_grey::<u8>(ga_image::grey::Luma::Bt601);
            let white = white.values().iter().filter(|value| **value > 127).count() as f64;
            let area = number(&report, "/contours/0/area_px2");
            assert!(
                (area / white - 1.0).abs() < 0.02,
                "{name}: {area} of {white}"
            );
        }
    }
}

/// A disc about (6, 30) of radius 16, of which the left border of the picture cuts off a part, and
/// one that lies whole in the picture.
#[test]
fn what_the_border_of_the_picture_cuts_is_marked() {
    let folder = tempdir().unwrap();
    let discs = Plane::from_fn(80, 60, |column, row| {
        let is_inside = |u: f64, radius: f64| (column as f64 - u).hypot(row as f64 - 30.0) < radius;
        u8::from(is_inside(6.0, 16.0) || is_inside(50.0, 14.0)) * 255
    });
    file::write(folder.path().join("cut.png"), &discs).unwrap();
    let report = json(folder.path(), &["contour", "cut.png"]);
    assert_eq!(report["verdict"], "good");
    let contours = report["contours"].as_array().unwrap();
    for (contour, (u, radius, is_cut)) in contours
        .iter()
        .zip([(6.0, 16.0, true), (50.0, 14.0, false)])
    {
        assert!(
            (number(contour, "/circle/centre_px/0") - u).abs() < 0.3,
            "{contour}"
        );
        assert!((number(contour, "/circle/radius_px") + 0.5 - radius).abs() < 0.4);
        assert_eq!(number(contour, "/points_at_border") > 0.0, is_cut);
    }
    let output = nullcone(folder.path(), ["contour", "cut.png"]);
    let lines = text(&output.stdout);
    assert_eq!(
        lines.matches("cut by the border of the picture").count(),
        1,
        "{lines}"
    );
}

#[test]
fn snakes_that_hold_on_to_nothing_are_told() {
    let folder = tempdir().unwrap();
    file::write(folder.path().join("grey.png"), &Plane::filled(80, 60, 90u8)).unwrap();
    let disc = Plane::from_fn(80, 60, |column, row| {
        let is_inside = (column as f64 - 2.0).hypot(row as f64 - 30.0) < 16.0;
        if is_inside { 220u8 } else { 30 }
    });
    file::write(folder.path().join("cut.png"), &disc).unwrap();
    write_ring(folder.path());
    for (arguments, kind) in [
        (["grey.png", "--circle=40,30,15"], Some("collapsed")),
        (["grey.png", "--circle=40,30,29"], Some("collapsed")),
        (["ring.png", "--circle=50,40,4"], Some("collapsed")),
        (["ring.png", "--circle=50,40,38"], None),
        (["cut.png", "--circle=20,30,20"], Some("collapsed")),
    ] {
        let report = json(
            folder.path(),
            &[&["contour", "--snake"], &arguments[..]].concat(),
        );
        let warnings = report["warnings"].as_array().unwrap();
        let kinds: Vec<_> = warnings
            .iter()
            .map(|w| w["kind"].as_str().unwrap())
            .collect();
        assert_eq!(kinds, kind.into_iter().collect::<Vec<_>>(), "{arguments:?}");
        assert_eq!(
            report["verdict"],
            if kind.is_none() { "good" } else { "doubtful" }
        );
        assert!(
            warnings
                .iter()
                .all(|warning| warning["file"] == arguments[0])
        );
        let check = [&["contour", "--snake", "--check"], &arguments[..]].concat();
        let status = nullcone(folder.path(), check).status.code();
        assert_eq!(status, Some(if kind.is_none() { 0 } else { 3 }));
    }
    // It settles along the disc, and where the border cuts it, along that.
    let circle = ["cut.png", "--snake", "--circle=20,30,20", "--tension=0.01"];
    let report = json(folder.path(), &[&["contour"], &circle[..]].concat());
    assert_eq!(report["warnings"][0]["kind"], "at_border", "{report}");
    assert!(number(&report, "/contours/0/points_at_border") > 20.0);
}

#[test]
fn bad_input_leaves_nothing() {
    let folder = tempdir().unwrap();
    write_ring(folder.path());
    file::write(folder.path().join("flat.png"), &Plane::filled(9, 9, 7u8)).unwrap();
    let cut = Plane::from_fn(
        50,
        40,
        |column, row| if column < 30 && row > 9 { 200u8 } else { 5 },
    );
    file::write(folder.path().join("cut.png"), &cut).unwrap();
    let before = names(folder.path());
    let fails = |arguments: &[&str], parts: &[&str]| {
        let all = [&["contour"], arguments, &["--out", "c.svg"]].concat();
        assert_failure(&nullcone(folder.path(), all), parts);
        assert_eq!(names(folder.path()), before);
    };
    fails(&["flat.png"], &["flat.png", "no contour", "same level"]);
    fails(
        &["flat.png", "--snake"],
        &["flat.png", "no contour", "same level"],
    );
    fails(
        &["ring.png", "--least-area", "4000"],
        &["ring.png", "no border", "4000"],
    );
    fails(
        &["cut.png", "--snake"],
        &[
            "cut.png",
            "leaves the picture of 50 × 40",
            "(0, 10)",
            "--circle",
        ],
    );
    fails(
        &["ring.png", "--snake", "--circle", "50,40,70"],
        &["ring.png", "point 0 of the contour", "110 × 80"],
    );
    fails(
        &["ring.png", "--snake", "--circle", "50,40"],
        &["--circle", "U,V,RADIUS"],
    );
    fails(
        &["ring.png", "--snake", "--points", "5"],
        &["5 points", "at least 6"],
    );
    fails(&["ring.png", "--snake", "--sigma", "0"], &["σ = 0"]);
    fails(
        &["ring.png", "--snake", "--flow", "--smoothness", "0"],
        &["smoothness", "0"],
    );
    fails(&["missing.png"], &["missing.png"]);
    fails(&["ring.png", "ring.png"], &["--rig"]);
    fails(&["ring.png", "--rig", "rig.yml"], &["rig.yml", "two views"]);
    let wrong = nullcone(folder.path(), ["contour", "ring.png", "--out", "c.png"]);
    assert_failure(&wrong, &["--out c.png", ".svg"]);
}
