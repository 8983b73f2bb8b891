//! The mathematics of the page against the modules that draw SVG.

use ga_runtime::cga3::Point;
use ga_runtime::vga3::Vector;
use proptest::prelude::*;
use proptest::strategy::ValueTree as _;
use proptest::test_runner::TestRunner;
use serde_json::{Value, json};

use super::super::{Data, GEOMETRY, SURFACE};
use crate::camera::{Camera, Pixel};
use crate::label::{LETTER, placed, text_width};
use crate::node::node;
use crate::picture::{Picture, as_written};
use crate::scene::Scene;
use crate::shape::Shape;
use crate::stroke::{Hiding, all_curves};
use crate::style::Style;
use crate::surface::Surface;
use crate::view::{Projection, Up};

const SCENES: usize = 120;

fn place() -> impl Strategy<Value = Vector<f64>> {
    proptest::array::uniform3(-2.0..2.0).prop_map(Vector::from)
}

fn unit() -> impl Strategy<Value = Vector<f64>> {
    place().prop_filter_map("no direction", Vector::normalized)
}

fn shape() -> impl Strategy<Value = Shape> {
    (place(), unit(), 0.2..1.5, any::<bool>(), 0..9, place()).prop_map(
        |(centre, side, radius, imaginary, kind, other)| {
            let vector = centre;
            let [centre, other] = [centre, other].map(Point::from);
            match kind {
                0 => Shape::Point { at: centre },
                1 => Shape::PointPair {
                    centre,
                    direction: side,
                    radius,
                    imaginary,
                },
                2 => Shape::Circle {
                    centre,
                    normal: side,
                    radius,
                    imaginary,
                },
                3 | 4 => Shape::Sphere {
                    centre,
                    radius,
                    imaginary,
                },
                5 => Shape::Line {
                    support: centre,
                    direction: side,
                },
                6 => Shape::Plane {
                    support: centre,
                    normal: side,
                },
                7 => Shape::Trajectory {
                    points: vec![centre, other],
                    frames: vec![(other, [side; 3])],
                },
                _ => Shape::Direction { vector },
            }
        },
    )
}

/// A scene, the size of the page, and places to be asked about. No surface is opaque, since the
/// picture cuts curves also where one opaque surface gives way to another.
fn case() -> impl Strategy<Value = (Scene, Pixel, Vec<Vector<f64>>)> {
    let opacity = prop_oneof![1 => Just(0.01), 4 => 0.1..0.85];
    let elements = proptest::collection::vec((shape(), opacity, "[a-zà-ü]{0,9}"), 2..7);
    let view = (-400.0..400.0, -90.0..90.0, 0.3..4.0, any::<[bool; 4]>());
    let size = [300.0..1600.0, 200.0..1200.0];
    let points = proptest::collection::vec(place(), 20);
    (elements, view, size, points).prop_map(|(elements, view, size, points)| {
        let mut scene = Scene::new("");
        let (azimuth, elevation, zoom, [parallel, y_up, axes, grid]) = view;
        (scene.view.azimuth, scene.view.elevation) = (azimuth, elevation);
        (scene.view.zoom, scene.axes, scene.grid) = (zoom, axes, grid);
        if parallel {
            scene.view.projection = Projection::Orthographic;
        }
        if y_up {
            scene.view.up = Up::Y;
        }
        for (shape, opacity, label) in elements {
            scene
                .add(shape, Style::labelled(label).with_opacity(opacity))
                .unwrap();
        }
        (scene, size, points)
    })
}

fn pixel(value: &Value) -> Pixel {
    serde_json::from_value(value.clone()).unwrap()
}

#[track_caller]
fn assert_near(found: &Value, expected: Pixel) {
    let pixel = pixel(found);
    let off = (pixel[0] - expected[0]).hypot(pixel[1] - expected[1]);
    assert!(
        off <= 1e-6 * (1.0 + expected[0].hypot(expected[1])),
        "{pixel:?} is not {expected:?}"
    );
}

#[test]
fn the_page_projects_hides_and_labels_as_the_picture_does() {
    // The same cases in each run: what is decided at a threshold may differ in the last bit.
    let mut runner = TestRunner::deterministic();
    let cases: Vec<_> = (0..SCENES)
        .map(|_| case().new_tree(&mut runner).unwrap().current())
        .collect();
    let asked = cases.iter().map(|(scene, size, points)| {
        let data = serde_json::to_value(Data::of(scene)).unwrap();
        let labels = Picture::of(scene).labels;
        let widths: Vec<f64> = labels
            .iter()
            .map(|label| text_width(&label.text, LETTER))
            .collect();
        let points: Vec<[f64; 3]> = points.iter().map(|point| point.coordinates()).collect();
        json!({"data": data, "size": size, "points": points, "widths": widths})
    });
    let input =
        json!({"source": format!("{GEOMETRY}{SURFACE}"), "cases": asked.collect::<Vec<_>>()});
    let Some(answers) = node(include_str!("compare.js"), &input) else {
        return;
    };
    let answers = answers.as_array().unwrap();
    assert_eq!(answers.len(), cases.len());
    let (mut hidden, mut visible, mut cut) = (0, 0, 0);
    for ((scene, size, points), answer) in cases.iter().zip(answers) {
        // The page has the numbers of the picture to five decimals.
        let picture = as_written(&Picture::of(scene));
        let mut camera = Camera::new(&scene.view);
        camera.scale = answer["scale"].as_f64().unwrap();
        camera.middle = pixel(&answer["middle"]);
        compare_points(&picture, &camera, points, answer);
        cut += compare_pieces(&picture, &camera, &answer["pieces"]);
        let counts = compare_strokes(&picture, &camera, &answer["curves"]);
        (hidden, visible) = (hidden + counts[0], visible + counts[1]);
        compare_labels(&picture, &camera, *size, &answer["labels"]);
    }
    // The scenes are worth comparing only where much is hidden and much is not.
    assert!(
        hidden > 200 && visible > 200,
        "{hidden} hidden, {visible} visible"
    );
    assert!(cut > 30, "{cut} pieces are cut");
}

/// Compares the pieces of surfaces, their order included, and counts those that are cut.
fn compare_pieces(picture: &Picture, camera: &Camera, answer: &Value) -> usize {
    let pieces = picture.pieces(camera);
    let found = answer.as_array().unwrap();
    assert_eq!(found.len(), pieces.len());
    let mut cut = 0;
    for (piece, found) in pieces.iter().zip(found) {
        let (ball, patch) = match piece.surface {
            Surface::Ball(index) => (json!(index), Value::Null),
            Surface::Patch(index) => (Value::Null, json!(index)),
        };
        assert_eq!((&found["ball"], &found["patch"]), (&ball, &patch));
        let sides: Vec<bool> = piece.sides.iter().map(|(_, _, side)| *side).collect();
        assert_eq!(found["sides"], json!(sides));
        let regions = found["regions"].as_array().unwrap();
        assert_eq!(regions.len(), piece.regions.len());
        for (region, found) in piece.regions.iter().zip(regions) {
            let outlines = found.as_array().unwrap();
            assert_eq!(outlines.len(), region.len());
            for (outline, found) in region.iter().zip(outlines) {
                let pixels = found.as_array().unwrap();
                assert_eq!(pixels.len(), outline.len());
                for (pixel, found) in outline.iter().zip(pixels) {
                    assert_near(found, *pixel);
                }
            }
        }
        cut += usize::from(regions.len() > 1);
    }
    cut
}

fn compare_points(picture: &Picture, camera: &Camera, points: &[Vector<f64>], answer: &Value) {
    let pieces = picture.pieces(camera);
    let hiding = Hiding::new(picture, camera, &pieces);
    for (k, &point) in points.iter().enumerate() {
        assert_near(&answer["projected"][k], camera.project(point));
        let depth = answer["depths"][k].as_f64().unwrap();
        assert!((depth - camera.depth(point)).abs() < 1e-12);
        assert_eq!(
            answer["hidden"][k],
            hiding.before(point).is_some(),
            "{point:?}"
        );
    }
}

/// Compares the strokes, and counts those that are hidden and those that are visible.
fn compare_strokes(picture: &Picture, camera: &Camera, answer: &Value) -> [usize; 2] {
    let pieces = picture.pieces(camera);
    let hiding = Hiding::new(picture, camera, &pieces);
    let curves = all_curves(picture, camera);
    assert_eq!(answer.as_array().unwrap().len(), curves.len());
    let mut counts = [0; 2];
    for (index, curve) in curves.iter().enumerate() {
        let strokes = hiding.strokes(index, curve);
        let found = answer[index].as_array().unwrap();
        assert_eq!(found.len(), strokes.len(), "curve {index}");
        for (stroke, found) in strokes.iter().zip(found) {
            assert_eq!(found["hidden"], stroke.before.is_some());
            counts[usize::from(stroke.before.is_none())] += 1;
            assert_near(&found["first"], stroke.points[0]);
            assert_near(&found["last"], stroke.points[stroke.points.len() - 1]);
            assert!((found["depth"].as_f64().unwrap() - stroke.depth).abs() < 1e-9);
            assert_eq!(found["head"].is_null(), stroke.head.is_none());
            for (k, corner) in stroke.head.iter().flatten().enumerate() {
                assert_near(&found["head"][k], *corner);
            }
        }
    }
    counts
}

fn compare_labels(picture: &Picture, camera: &Camera, size: Pixel, answer: &Value) {
    let labels = placed(picture, camera, size, &[]);
    let found = answer.as_array().unwrap();
    assert_eq!(found.len(), labels.len());
    for (label, found) in labels.iter().zip(found) {
        assert_eq!(found["index"], label.label);
        assert_near(&found["middle"], label.middle);
        assert_eq!(found["leader"].is_null(), label.leader().is_none());
        for (k, end) in label.leader().iter().flatten().enumerate() {
            assert_near(&found["leader"][k], *end);
        }
    }
}
