//! Homographies against the maps that made the pairs.

use ga_runtime::cga3::Motor;
use ga_vision::homography::Homography;
use nullcone_shared_data::json::{matrix, numbers, rows};
use proptest::prelude::*;
use serde_json::Value;

/// The image of a place by a matrix with 1 in its last entry.
fn mapped(m: &[f64; 8], [x, y]: [f64; 2]) -> [f64; 2] {
    let scale = m[6] * x + m[7] * y + 1.0;
    [
        (m[0] * x + m[1] * y + m[2]) / scale,
        (m[3] * x + m[4] * y + m[5]) / scale,
    ]
}

const PLACES: [[f64; 2]; 6] = [
    [0.0, 0.0],
    [2.0, 0.1],
    [0.3, 1.5],
    [1.7, 1.9],
    [-0.8, 0.9],
    [0.9, -0.7],
];

proptest! {
    #[test]
    fn exact_pairs_give_the_map(
        linear in prop::array::uniform4(-50.0..50.0_f64),
        offset in prop::array::uniform2(-300.0..300.0_f64),
        far in prop::array::uniform2(-0.1..0.1_f64),
        count in 4usize..7,
        other in prop::array::uniform2(-0.8..2.0_f64),
    ) {
        let [a, b, c, d] = linear;
        let ([u, v], [p, q]) = (offset, far);
        prop_assume!((a * d - b * c).abs() > 200.0);
        let map = [a + p * u, b + q * u, u, c + p * v, d + q * v, v, p, q];
        let places = &PLACES[..count];
        let pixels: Vec<_> = places.iter().map(|place| mapped(&map, *place)).collect();
        let found = Homography::from_pairs(places, &pixels).unwrap();
        let (found, truth) = (found.apply(other).unwrap(), mapped(&map, other));
        prop_assert!((found[0] - truth[0]).hypot(found[1] - truth[1]) < 1e-7);
    }
}

/// With either sign of a translation.
#[test]
fn the_motions_of_a_plane_are_those_of_opencv() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/data/homography_motions.json"
    );
    let text = std::fs::read_to_string(path).unwrap();
    let records: Value = serde_json::from_str(&text).unwrap();
    let records = records.as_array().unwrap();
    assert_eq!(records.len(), 6);
    for record in records {
        let [directions, images] = ["directions", "images"].map(|key| rows::<2>(&record[key]));
        let seen = Homography::from_pairs(&directions, &images).unwrap();
        let found = seen.motions().unwrap();
        for expected in record["motions"].as_array().unwrap() {
            let (rotation, t) = (
                matrix(&expected["rotation"]),
                numbers::<3>(&expected["translation"]),
            );
            let is_equal = |motor: &Motor<f64>| {
                let apart = |found: &[f64], expected: &[f64], sign: f64| -> f64 {
                    let pairs = found.iter().zip(expected);
                    pairs.map(|(a, b)| (a - sign * b).abs()).fold(0.0, f64::max)
                };
                let turned = motor.rotor().to_matrix();
                let moved = motor.translator().displacement();
                apart(turned.as_flattened(), rotation.as_flattened(), 1.0) < 1e-9
                    && apart(&moved, &t, 1.0).min(apart(&moved, &t, -1.0)) < 1e-9
            };
            assert!(found.iter().any(is_equal), "{found:?} {expected}");
        }
    }
    // A rotation alone shows no plane.
    let turned = PLACES.map(|[x, y]| [-y, x]);
    let seen = Homography::from_pairs(&PLACES, &turned).unwrap();
    assert_eq!(seen.motions(), None);
}

#[test]
fn pairs_that_determine_nothing_are_refused() {
    let map = [40.0, 3.0, 20.0, -2.0, 45.0, 30.0, 0.01, -0.02];
    let pixels = PLACES.map(|place| mapped(&map, place));
    let find = |places: &[[f64; 2]], pixels: &[[f64; 2]]| Homography::from_pairs(places, pixels);
    assert!(find(&PLACES, &pixels).is_some());
    assert!(find(&PLACES[..3], &pixels[..3]).is_none());
    assert!(find(&PLACES, &pixels[..5]).is_none());
    let line: [[f64; 2]; 6] = std::array::from_fn(|k| [k as f64, 0.5 * k as f64 + 1.0]);
    assert!(find(&line, &line.map(|place| mapped(&map, place))).is_none());
    assert!(find(&PLACES, &line).is_none());
    assert!(find(&line, &pixels).is_none());
    assert!(find(&[[1.0; 2]; 6], &pixels).is_none());
    for value in [f64::NAN, f64::INFINITY] {
        let mut faulty = pixels;
        faulty[3][1] = value;
        assert!(find(&PLACES, &faulty).is_none());
        assert!(find(&faulty, &pixels).is_none());
    }
}
