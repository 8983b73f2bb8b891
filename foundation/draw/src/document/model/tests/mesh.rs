//! The mathematics of the part.

use ga_runtime::vga3::Vector;
use serde_json::{Value, json};

use super::super::part::MESH;
use super::{data, model, page};
use crate::camera::Camera;
use crate::node::node;
use crate::page::GEOMETRY;
use crate::view::{Up, View};

/// The values of expressions of JavaScript, in which `data` are those of the model.
fn values(expressions: &[&str]) -> Option<Vec<Value>> {
    let script = format!(
        "{GEOMETRY}{MESH}
        const data = JSON.parse(require('node:fs').readFileSync(0, 'utf8'));
        const model = mesh.decode(data);
        const list = (numbers) => Array.from(numbers ?? []);
        process.stdout.write(JSON.stringify([{}]));",
        expressions.join(",")
    );
    let values = node(&script, &data(&page(&model())))?;
    Some(serde_json::from_value(values).unwrap())
}

fn numbers(value: &Value) -> Vec<f64> {
    serde_json::from_value(value.clone()).unwrap()
}

#[track_caller]
fn assert_near(found: &Value, expected: &[f64], off: f64) {
    let found = numbers(found);
    let same = found.len() == expected.len();
    let near = found
        .iter()
        .zip(expected)
        .all(|(a, b)| (a - b).abs() <= off);
    assert!(same && near, "{found:?} is not {expected:?}");
}

/// What the camera looks at, and the radius about it, from the bounds by hand.
fn sight() -> ([f64; 3], f64) {
    let centre = [0.0, 1.234_567 / 2.0, -0.15];
    let all = model().frames;
    let distances = all
        .iter()
        .flatten()
        .filter(|place| place[0] < 9.0)
        .map(|place| {
            let squares = (0..3).map(|k| (place[k] - centre[k]).powi(2));
            squares.sum::<f64>().sqrt()
        });
    (centre, distances.fold(0.0, f64::max))
}

#[test]
fn the_page_decodes_the_positions() {
    let asked = [
        "list(mesh.places(data, model, 1))",
        "list(mesh.ofVertices(mesh.places(data, model, 0), model)).length",
        "list(model.corners)",
        "list(model.coordinates).slice(0, 4)",
        "list(model.colours).slice(0, 3)",
        "mesh.floor(data)",
    ];
    let Some(found) = values(&asked) else {
        return;
    };
    let (centre, radius) = sight();
    // The points in the order in which triangles have them.
    let expected: Vec<f64> = [0, 2, 1, 3]
        .into_iter()
        .flat_map(|k| [0, 1, 2].map(|axis| (model().frames[1][k][axis] - centre[axis]) / radius))
        .collect();
    assert_near(&found[0], &expected, 2e-5);
    assert_eq!(found[1], json!(24));
    assert_eq!(found[2], json!([0, 1, 2, 0, 2, 3, 2, 1, 3, 1, 0, 3]));
    assert_near(&found[3], &[0.0, 1.0, 1.0, 1.0], 1e-6);
    assert_eq!(found[4], json!([0, 0, 255]));
    assert!((found[5].as_f64().unwrap() + centre[1] / radius).abs() < 1e-6);
}

#[test]
fn normals_are_those_of_the_areas() {
    // A cube's corner has the same share of three faces, however these are cut; the two triangles
    // of one face count once. Sheets on each other have no normal.
    let Some(found) = values(&[
        "list(mesh.normals([0,0,0, 1,0,0, 0,1,0, 0,0,1, 1,1,0], [0,4,1, 0,2,4, 0,1,3, 0,3,2]))
            .slice(0, 3)",
        "list(mesh.normals([0,0,0, 1,0,0, 0,1,0], [0,1,2, 0,2,1]))",
        "list(mesh.normals([0,0,0, 9,0,0, 0,9,0], [0,1,2]))",
    ]) else {
        return;
    };
    // The face across z has twice the area of the triangles across x and y.
    let length = 6.0_f64.sqrt();
    assert_near(
        &found[0],
        &[-1.0 / length, -1.0 / length, -2.0 / length],
        1e-6,
    );
    assert_near(&found[1], &[0.0; 9], 0.0);
    assert_near(
        &found[2],
        &[0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0],
        0.0,
    );
}

#[test]
fn the_matrix_projects_as_the_camera_does() {
    let views = [(0.0, 0.0, 1.0), (35.0, 22.0, 2.5), (-200.0, -80.0, 0.3)];
    let asked = views.map(|(azimuth, elevation, zoom)| {
        format!(
            "list(mesh.camera(data, {{ azimuth: {azimuth}, elevation: {elevation}, zoom: {zoom},
                shift: [0.25, -0.5] }}, [300, 420], 1).matrix)"
        )
    });
    let Some(found) = values(&asked.each_ref().map(String::as_str)) else {
        return;
    };
    let across = data(&page(&model()))["across"].as_f64().unwrap();
    for ((azimuth, elevation, zoom), found) in views.into_iter().zip(&found) {
        let mut camera = Camera::new(&View {
            azimuth,
            elevation,
            up: Up::Y,
            ..View::default()
        });
        camera.scale = 0.45 * zoom * (300.0 / across).min(420.0);
        // What is looked at is a quarter of the half to the right and half of it down.
        camera.middle = [150.0 + 0.25 * 150.0, 210.0 + 0.5 * 210.0];
        let matrix = numbers(found);
        for place in [[0.0, 0.0, 0.0], [0.4, -0.7, 0.2], [-0.9, 0.1, -0.4]] {
            let row = |r: usize| {
                let sum: f64 = (0..3).map(|k| matrix[4 * k + r] * place[k]).sum();
                sum + matrix[12 + r]
            };
            let [x, y, z, w] = [0, 1, 2, 3].map(row);
            let pixel = json!([150.0 + 150.0 * x / w, 210.0 - 210.0 * y / w]);
            assert_near(&pixel, &camera.project(Vector::from(place)), 1e-3);
            assert!((-1.0..1.0).contains(&(z / w)), "{z} {w}");
        }
    }
}

#[test]
fn what_is_under_the_pointer_stays_there() {
    let Some(found) = values(&[
        "mesh.shifted([0, 0], [0.5, -0.25], 2, 2)",
        "mesh.shifted([0, 0], [0.5, 1], 2, 2)",
        "mesh.shifted([-0.5, 0.25], [0.5, -0.25], 0.5, 1)",
        "mesh.shifted([0, 0], [1, 1], 0.5, 0.5)",
    ]) else {
        return;
    };
    assert_near(&found[0], &[-0.5, 0.25], 1e-12);
    assert_near(&found[1], &[-0.5, -1.0], 1e-12);
    assert_near(&found[2], &[0.0, 0.0], 1e-12);
    assert_near(&found[3], &[0.0, 0.0], 1e-12);
}

#[test]
fn times_floors_colours_and_sizes() {
    let Some(found) = values(&[
        "[0, 0.0999, 0.1, 0.3, 0.4].map((s) => mesh.frameAfter(data, 0, s))",
        "mesh.frameAfter({ rate: 29.97, frames: 2000 }, 5, 1001 / 29.97)",
        "list(mesh.grid({ centres: [[0.25, 9, 0]], radius: 2, square: 1 }, [0, 0, 0], 0.5))",
        "mesh.rgb('#0033ff')",
        "mesh.rgb('')",
        "[1, 512, 513, 5000].map((size) => mesh.textureSize(size, 4096))",
    ]) else {
        return;
    };
    assert_eq!(found[0], json!([0, 0, 1, 1, 0]));
    assert_eq!(found[1], json!(1006));
    // In metres there are lines at x = 0 and 1, and at z = −1, 0 and 1, about x = 0.25.
    let x = [-0.125, -0.5, -0.125, 0.5, 0.375, -0.5, 0.375, 0.5];
    let z = [
        -0.5, -0.5, 0.5, -0.5, -0.5, 0.0, 0.5, 0.0, -0.5, 0.5, 0.5, 0.5,
    ];
    assert_near(&found[2], &[&x[..], &z[..]].concat(), 1e-6);
    assert_eq!(found[3], json!([0, 0.2, 1]));
    assert_eq!(found[4], json!([0, 0, 0]));
    assert_eq!(found[5], json!([1, 512, 1024, 4096]));
}
