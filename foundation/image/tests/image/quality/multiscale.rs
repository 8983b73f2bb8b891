//! MS-SSIM, compared with a program in another language, and with closed forms.

use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::{Plane, PlaneError};
use ga_image::quality::{MULTISCALE_LEAST_SIDE, Ssim};
use nullcone_shared_data::shared;
use serde_json::Value;

use super::{close, json, number};
use crate::data;

/// The pictures of `ms_ssim.json`, whose sizes are odd at most scales.
fn pictures() -> [Plane<u8>; 2] {
    let a = Plane::from_fn(203, 177, |x, y| {
        ((7 * x * x / 16 + 31 * y + 3 * x * y / 8) % 256) as u8
    });
    let b = Plane::from_fn(203, 177, |x, y| {
        let value = usize::from(a.get(x, y).unwrap()) + (5 * x + 11 * y) % 23;
        value.saturating_sub(11).min(255) as u8
    });
    [a, b]
}

fn assert_scales(got: ga_image::quality::MultiScale, truth: &Value) {
    let scales = truth["scales"].as_array().unwrap();
    assert_eq!(scales.len(), 5);
    for (got, expected) in got.similarities().iter().zip(scales) {
        close(got.ssim, expected[0].as_f64().unwrap(), 1e-6);
        close(got.contrast_structure, expected[1].as_f64().unwrap(), 1e-6);
    }
    close(got.ms_ssim(), number(truth, "ms_ssim"), 1e-6);
}

#[test]
fn every_scale_is_that_of_the_program_in_scipy() {
    let truth = &json(&data("ms_ssim.json"))["formula"];
    let [a, b] = pictures();
    let ssim = Ssim::new(255.0);
    let got = ssim.multiscale(&a, &b).unwrap();
    assert_scales(got, truth);
    assert_eq!(ssim.multiscale(&b, &a).unwrap(), got);
    let finest = ssim.compare(&a, &b).unwrap();
    assert_eq!(ssim.multiscale_after(finest, &a, &b).unwrap(), got);

    let deep = [&a, &b].map(|plane| plane.map(|v| 4 * u16::from(v)));
    let got = Ssim::new(1020.0).multiscale(&deep[0], &deep[1]).unwrap();
    assert_scales(got, truth);
    let colours = [&a, &b].map(|plane| plane.map(|v| [v; 3]));
    let got = ssim.multiscale(&colours[0], &colours[1]).unwrap();
    assert_scales(got, truth);
}

#[test]
fn channels_are_averaged_at_each_scale() {
    let [a, b] = pictures();
    let first = Plane::interleaved([&a, &a]).unwrap();
    let second = Plane::interleaved([&b, &a]).unwrap();
    let ssim = Ssim::new(255.0);
    let [both, one] = [
        ssim.multiscale(&first, &second).unwrap(),
        ssim.multiscale(&a, &b).unwrap(),
    ];
    for (both, one) in both.similarities().iter().zip(one.similarities()) {
        close(both.ssim, 0.5 + 0.5 * one.ssim, 1e-9);
    }
}

#[test]
fn the_oracles_pictures_have_the_index_of_the_program_in_scipy() {
    let Some(folder) = shared("oracle/vision/seed1") else {
        return;
    };
    let truth = &json(&data("ms_ssim.json"))["oracle/vision/seed1"];
    let read = |name: &str| {
        file::read(folder.join(name))
            .unwrap()
            .to_grey::<u8>(Luma::Bt601)
    };
    let reference = read("gray.png");
    let rows = truth.as_object().unwrap();
    assert_eq!(rows.len(), 10);
    for (name, expected) in rows {
        let got = Ssim::new(255.0).multiscale(&reference, &read(name));
        close(got.unwrap().ms_ssim(), expected.as_f64().unwrap(), 1e-6);
    }
}

/// Between flat pictures only the luminance of the coarsest scale differs.
#[test]
fn flat_pictures_have_the_index_of_the_formula() {
    let [a, b] = [40u8, 90].map(|level| Plane::filled(180, 176, level));
    let c1 = 2.55f64.powi(2);
    let luminance = (2.0 * 40.0 * 90.0 + c1) / (40.0f64.powi(2) + 90.0f64.powi(2) + c1);
    let got = Ssim::new(255.0).multiscale(&a, &b).unwrap();
    close(got.ms_ssim(), luminance.powf(0.1333), 1e-6);
    close(got.similarities()[4].ssim, luminance, 1e-6);
}

/// The structure of a negative is opposite, and its fractional power does not exist.
#[test]
fn the_index_of_a_negative_is_zero() {
    let a = Plane::from_fn(
        192,
        192,
        |x, y| if (x / 40 + y / 40) % 2 == 0 { 0u8 } else { 255 },
    );
    let got = Ssim::new(255.0)
        .multiscale(&a, &a.map(|v| 255 - v))
        .unwrap();
    assert!(got.similarities()[4].ssim < 0.0);
    assert_eq!(got.ms_ssim(), 0.0);
}

#[test]
fn pictures_that_are_too_small_are_an_error() {
    assert_eq!(MULTISCALE_LEAST_SIDE, 176);
    let ssim = Ssim::new(255.0);
    let small = Plane::filled(175, 300, 0u8);
    let too_small = PlaneError::TooSmall {
        width: 175,
        height: 300,
        least: 176,
    };
    assert_eq!(ssim.multiscale(&small, &small), Err(too_small));
    let least = Plane::filled(176, 176, 0u8);
    assert_eq!(ssim.multiscale(&least, &least).unwrap().ms_ssim(), 1.0);
    let differs = PlaneError::Differs {
        first: [175, 300],
        second: [176, 176],
    };
    assert_eq!(ssim.multiscale(&small, &least), Err(differs));
}
