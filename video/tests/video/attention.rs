//! Attention: contours attract it, and what moves otherwise than the camera.

use ga_image::plane::{Plane, PlaneError};
use ga_video::attention::Attention;

/// A texture that is smooth over several pixels, without a period, from 60 to 180.
fn texture(x: f64, y: f64) -> f64 {
    let waves = [
        (0.11, 0.05, 0.0),
        (-0.07, 0.13, 1.0),
        (0.19, -0.09, 2.0),
        (0.031, 0.047, 3.0),
    ];
    let sum: f64 = waves
        .iter()
        .map(|(a, b, c)| (a * x + b * y + c + (0.023 * x * b).sin()).sin())
        .sum();
    120.0 + 15.0 * sum
}

/// A frame of the texture seen by a camera that has moved by `pan`, with a square of another
/// texture whose corner is at `square`, without contours that the ground has not.
fn frame(size: [usize; 2], pan: [f64; 2], square: [f64; 2], side: f64) -> Plane<u8> {
    Plane::from_fn(size[0], size[1], |column, row| {
        let [x, y] = [column as f64, row as f64];
        let [u, v] = [x - square[0], y - square[1]];
        let inside = (0.0..side).contains(&u) && (0.0..side).contains(&v);
        let value = if inside {
            texture(u + 500.0, v + 300.0)
        } else {
            texture(x + pan[0], y + pan[1])
        };
        value.round() as u8
    })
}

/// The mean weight in a rectangle.
fn mean(weights: &Plane, [left, top, width, height]: [usize; 4]) -> f64 {
    let part = weights.view().part(left, top, width, height).unwrap();
    let sum: f64 = part.rows().flatten().map(|weight| f64::from(*weight)).sum();
    sum / (width * height) as f64
}

/// The weights after two frames, and those of the second alone.
fn weights(first: &Plane<u8>, second: &Plane<u8>) -> [Plane; 2] {
    let size = [first.width(), first.height()];
    let mut attention = Attention::new(size).unwrap();
    attention.next(first).unwrap();
    let moving = attention.next(second).unwrap().plane().clone();
    attention.restart();
    let alone = attention.next(second).unwrap().plane().clone();
    [moving, alone]
}

#[test]
fn a_square_that_moves_gets_more_weight_than_the_still_ground() {
    // From pictures that are not reduced to such that are reduced by four.
    for (size, side) in [([400, 300], 80), ([960, 540], 120), ([1920, 1080], 200)] {
        let [width, height] = size;
        let place = [width / 2, height / 3];
        let step = (width / 100) as f64;
        let corner = place.map(|part| part as f64);
        let square = |along: f64| [corner[0] + along, corner[1] - 0.5 * along];
        let first = frame(size, [0.0; 2], square(0.0), side as f64);
        let second = frame(size, [0.0; 2], square(step), side as f64);
        let [moving, alone] = weights(&first, &second);
        let inside = [place[0] + side / 4, place[1] + side / 4, side / 2, side / 2];
        let elsewhere = [width / 16, height / 2, width / 4, height / 3];
        let [within, outside] = [inside, elsewhere].map(|part| mean(&moving, part));
        assert!(within > outside + 0.2, "{size:?}: {within} and {outside}");
        let of_contours = mean(&alone, inside) - mean(&alone, elsewhere);
        assert!(within - outside > of_contours + 0.2, "{size:?}");
        assert!(moving.values().iter().all(|w| (0.2..=1.0).contains(w)));
    }
}

/// Half the attention is then that of contours, and motion adds none.
fn assert_without_motion([moving, alone]: [Plane; 2], what: &str) {
    for (index, (moving, alone)) in moving.values().iter().zip(alone.values()).enumerate() {
        let expected = 0.2 + 0.5 * (alone - 0.2);
        let difference = moving - expected;
        assert!(difference.abs() < 0.02, "{what}: {difference} at {index}");
    }
}

#[test]
fn a_pan_of_the_camera_attracts_no_attention() {
    for pan in [
        [0.0, 0.0],
        [6.0, 2.0],
        [-16.0, 8.0],
        [1.0, -1.0],
        [3.0, 5.0],
        [40.0, 0.0],
    ] {
        let size = [1280, 720];
        let [first, second] =
            [0.0, 1.0].map(|time| frame(size, pan.map(|part| time * part), [-1e3; 2], 0.0));
        assert_without_motion(weights(&first, &second), &format!("{pan:?}"));
    }
}

#[test]
fn a_square_gets_weight_while_the_camera_pans() {
    let size = [960, 540];
    let first = frame(size, [0.0; 2], [400.0, 200.0], 120.0);
    let second = frame(size, [8.0, 0.0], [412.0, 200.0], 120.0);
    let [moving, _] = weights(&first, &second);
    let within = mean(&moving, [430, 230, 60, 60]);
    let outside = mean(&moving, [40, 300, 200, 200]);
    assert!(within > outside + 0.2, "{within} and {outside}");
}

/// After a cut no block has a match, and noise alone is not motion.
#[test]
fn cuts_and_noise_are_not_motion() {
    let size = [640, 360];
    let first = frame(size, [0.0; 2], [-1e3; 2], 0.0);
    let cut = frame(size, [5e3, 7e3], [-1e3; 2], 0.0);
    let mut state = 1u32;
    let mut noise = |level: u8| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        level.saturating_add((state >> 30) as u8)
    };
    let grey = Plane::filled(640, 360, 100u8);
    let noisy = [grey.map(&mut noise), grey.map(&mut noise)];
    assert_without_motion(weights(&noisy[0], &noisy[1]), "noise");
    let noisy = [first.map(&mut noise), first.map(&mut noise)];
    assert_without_motion(weights(&noisy[0], &noisy[1]), "texture with noise");
    let [after_cut, alone] = weights(&first, &cut);
    let excess = after_cut.values().iter().zip(alone.values());
    let excess: f32 = excess.map(|(a, b)| (a - 0.2 - 0.5 * (b - 0.2)).abs()).sum();
    let excess = excess / (640.0 * 360.0);
    assert!(excess < 0.1, "{excess}");
}

#[test]
fn a_contour_attracts_attention_in_a_picture_alone() {
    let picture = Plane::from_fn(300, 200, |column, _| if column < 80 { 30u8 } else { 160 });
    let mut attention = Attention::new([300, 200]).unwrap();
    let weights = attention.next(&picture).unwrap().plane();
    let [edge, flat] = [[72, 50, 16, 100], [200, 50, 50, 100]].map(|part| mean(weights, part));
    assert!(edge > flat + 0.5, "{edge} and {flat}");
    assert!((flat - 0.2).abs() < 1e-6, "{flat}");
}

#[test]
fn flat_and_tiny_frames_have_weights() {
    for size in [[1, 1], [7, 3], [9, 200], [481, 1], [500, 12]] {
        let flat = Plane::filled(size[0], size[1], 7u8);
        let mut attention = Attention::new(size).unwrap();
        for _ in 0..2 {
            let weights = attention.next(&flat).unwrap().plane();
            assert_eq!([weights.width(), weights.height()], size);
            assert!(weights.values().iter().all(|weight| *weight == 0.2));
        }
    }
    assert!(Attention::new([0, 4]).is_err());
    let mut attention = Attention::new([4, 4]).unwrap();
    let differs = PlaneError::Differs {
        first: [5, 4],
        second: [4, 4],
    };
    let other = Plane::filled(5, 4, 0u8);
    assert_eq!(attention.next(&other).unwrap_err(), differs);
}
