//! What is written of a model.

use serde_json::{Value, json};

use super::{bytes, data, model, page, short};
use crate::document::model::{ModelCoordinates, ModelView};

/// The numbers that lists of whole numbers along N axes stand for, and their steps.
fn decoded<const N: usize>(value: &Value) -> (Vec<[f64; N]>, [f64; N]) {
    let axes = |name: &str| -> Vec<f64> { serde_json::from_value(value[name].clone()).unwrap() };
    let [low, step] = [axes("low"), axes("step")];
    let place = |numbers: &[u16]| std::array::from_fn(|k| low[k] + f64::from(numbers[k]) * step[k]);
    let numbers = short(&value["numbers"]);
    let places = numbers.chunks_exact(N).map(place).collect();
    (places, step.try_into().unwrap())
}

/// The indices of a list that has 16 or 32 bits each.
fn indices(data: &Value, name: &str) -> Vec<usize> {
    let bytes = bytes(&data[name]);
    if data["wide"] == json!(true) {
        let fours = bytes.chunks_exact(4);
        fours
            .map(|four| u32::from_le_bytes(four.try_into().unwrap()) as usize)
            .collect()
    } else {
        short(&data[name]).into_iter().map(usize::from).collect()
    }
}

/// Compares each corner of each triangle in each frame with the model; gives the greatest error of
/// a position in parts of the length of the bounds.
fn compare(model: &ModelView) -> f64 {
    let data = data(&page(model));
    let frames = model.frames.len();
    let (points, step) = decoded::<3>(&data["points"]);
    let count = points.len() / frames;
    let triangles = indices(&data, "triangles");
    let sources = match &data["sources"] {
        Value::Null => (0..count).collect(),
        _ => indices(&data, "sources"),
    };
    assert_eq!(triangles.len(), 3 * model.triangles.len());
    let mut most = 0.0_f64;
    for (corner, vertex) in model.triangles.iter().flatten().enumerate() {
        for (k, frame) in model.frames.iter().enumerate() {
            let found = points[k * count + sources[triangles[corner]]];
            for axis in 0..3 {
                let error = (found[axis] - frame[*vertex as usize][axis]).abs();
                // The half of a step, and what rounding adds.
                assert!(error <= 0.5 * step[axis] + 1e-12, "{error} {}", step[axis]);
                most = most.max(error / (65535.0 * step[axis]).max(1e-300));
            }
        }
    }
    if let Some(texture) = &model.texture {
        let (coordinates, step) = decoded::<2>(&data["coordinates"]);
        for (corner, vertex) in model.triangles.iter().flatten().enumerate() {
            let [u, v] = texture.coordinates.of(corner / 3, corner % 3, *vertex);
            let found = coordinates[triangles[corner]];
            assert!((found[0] - u).abs() <= 0.5 * step[0] + 1e-12);
            assert!((found[1] - (1.0 - v)).abs() <= 0.5 * step[1] + 1e-12);
        }
    }
    if let Some(colours) = &model.colours {
        let found = bytes(&data["colours"]);
        for (corner, vertex) in model.triangles.iter().flatten().enumerate() {
            let of = &found[3 * triangles[corner]..][..3];
            assert_eq!(of, colours[*vertex as usize].0);
        }
    }
    most
}

/// A wave of n × n vertices, with texture coordinates at its vertices.
fn wave(n: u32, frames: usize) -> ModelView {
    let places = |frame: usize| {
        let place = |k: u32| {
            let [x, z] = [k % n, k / n].map(|k| f64::from(k) / f64::from(n));
            [
                7.3 * x,
                0.1 * (9.0 * (x + z) + frame as f64).sin(),
                3.1 * z - 40.0,
            ]
        };
        (0..n * n).map(place).collect()
    };
    let cells = (0..n - 1).flat_map(|row| (0..n - 1).map(move |column| row * n + column));
    ModelView {
        triangles: cells
            .flat_map(|k| [[k, k + n, k + 1], [k + 1, k + n, k + n + 1]])
            .collect(),
        frames: (0..frames).map(places).collect(),
        ..ModelView::default()
    }
}

#[test]
fn positions_are_there_within_half_a_step() {
    let most = compare(&wave(30, 5));
    assert!(most <= 1.0 / 131_070.0 + 1e-12, "{most}");
    // The bound is reached nearly.
    assert!(most > 0.9 / 131_070.0, "{most}");
    compare(&model());
}

#[test]
fn coordinates_at_vertices_are_there() {
    let mut model = model();
    let coordinates = (0..6).map(|k| [0.3 * f64::from(k), -1.7]).collect();
    model.texture.as_mut().unwrap().coordinates = ModelCoordinates::Vertices(coordinates);
    compare(&model);
    // All v are the same: the step is zero.
    let data = data(&page(&model));
    assert_eq!(data["coordinates"]["step"][1], json!(0.0));
}

#[test]
fn many_vertices_have_long_indices() {
    // 66,049 vertices.
    let large = wave(257, 1);
    assert_eq!(data(&page(&large))["wide"], json!(true));
    compare(&large);
    // 65,536 vertices, the last of which has the largest number of 16 bits.
    let small = wave(256, 1);
    assert_eq!(data(&page(&small))["wide"], json!(false));
    compare(&small);
}

#[test]
fn vertices_at_one_place_are_one_point() {
    let mut model = model();
    let data_of = |model: &ModelView| data(&page(model));
    let points = |data: &Value| short(&data["points"]["numbers"]).len() / 6;
    // Four corners. Of the twelve corners of triangles, two share all they have with the first at
    // vertex 3, one with that at vertex 0, and one with that at vertex 2.
    let data = data_of(&model);
    assert_eq!(points(&data), 4);
    assert_eq!(bytes(&data["colours"]).len() / 3, 8);
    assert_eq!(indices(&data, "sources")[..3], [0, 1, 2]);
    model.texture = None;
    model.colours = None;
    let data = data_of(&model);
    assert_eq!(points(&data), 4);
    assert_eq!(data["sources"], Value::Null);
    assert_eq!(
        short(&data["triangles"]),
        [0, 1, 2, 0, 2, 3, 2, 1, 3, 1, 0, 3]
    );
    // They are two as soon as they part in one frame.
    model.frames[1][5][2] += 0.01;
    assert_eq!(points(&data_of(&model)), 5);
}

#[test]
fn the_camera_follows_a_model_that_goes_away() {
    let mut model = model();
    let centres = |model: &ModelView| -> Vec<[f64; 3]> {
        serde_json::from_value(data(&page(model))["centres"].clone()).unwrap()
    };
    assert_eq!(centres(&model).len(), 1);
    let radius = |model: &ModelView| data(&page(model))["radius"].as_f64().unwrap();
    let still = model.frames[0].clone();
    let step = |k: u32| {
        let mut frame = still.clone();
        for place in &mut frame {
            place[0] += 0.5 * f64::from(k);
        }
        frame
    };
    model.frames = vec![still.clone()];
    let alone = radius(&model);
    model.frames = (0..40).map(step).collect();
    let found = centres(&model);
    assert_eq!(found.len(), 40);
    for (k, centre) in found.iter().enumerate() {
        let expected = found[0][0] + 0.5 * k as f64;
        assert!((centre[0] - expected).abs() < 1e-5, "{k}: {centre:?}");
        assert_eq!(centre[1..], found[0][1..]);
    }
    // Means of vertices and the middle of the box differ.
    assert!((radius(&model) / alone - 1.0).abs() < 0.2);
}

#[test]
fn squares_of_the_floor_have_round_sides() {
    for (size, square) in [
        (1.0, 0.5),
        (20.0, 10.0),
        (0.004, 0.002),
        (80_000.0, 20_000.0),
    ] {
        let mut model = model();
        for place in model.frames.iter_mut().flatten() {
            *place = place.map(|x| (x * size).clamp(-1e5, 1e5));
        }
        let data = data(&page(&model));
        assert_eq!(data["floor"], json!(0.0));
        let found = page(&model).contains(&format!("squares of {square} m"));
        assert!(found, "{size}: radius {}", data["radius"]);
    }
}
