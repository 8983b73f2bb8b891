//! MSE, PSNR and SSIM, compared with scikit-image.

mod information;
mod multiscale;
mod weighted;

use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::{Plane, PlaneError};
use ga_image::quality::{Ssim, mse, psnr};
use nullcone_shared_data::shared;
use serde_json::Value;

use crate::data;

fn json(path: &std::path::Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap()
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap()
}

/// The pictures of `ssim.json`.
fn pictures() -> [Plane<u8>; 2] {
    let a = Plane::from_fn(23, 15, |x, y| {
        ((7 * x * x + 31 * y + 3 * x * y) % 256) as u8
    });
    let b = Plane::from_fn(23, 15, |x, y| {
        let change = (5 * x + 11 * y) % 23;
        let value = usize::from(a.get(x, y).unwrap()) + change;
        value.saturating_sub(11).min(255) as u8
    });
    [a, b]
}

fn close(got: f64, expected: f64, tolerance: f64) {
    assert!(
        (got - expected).abs() <= tolerance,
        "{got}, not {expected}: off by {:e}",
        got - expected
    );
}

#[test]
fn the_oracles_pictures_have_its_figures() {
    let Some(folder) = shared("oracle/vision/seed1") else {
        return;
    };
    let truth = json(&folder.join("truth.json"));
    let read = |name: &str| {
        file::read(folder.join(name))
            .unwrap()
            .to_grey::<u8>(Luma::Bt601)
    };
    let reference = read(truth["base"]["gray"].as_str().unwrap());
    let rows = truth["quality"].as_array().unwrap();
    assert_eq!(rows.len(), 10);
    for row in rows {
        let picture = read(row["file"].as_str().unwrap());
        close(mse(&reference, &picture).unwrap(), number(row, "mse"), 1e-9);
        close(
            psnr(&reference, &picture, 255.0).unwrap(),
            number(row, "psnr"),
            1e-9,
        );
        let got = Ssim::new(255.0).compare(&reference, &picture).unwrap();
        close(got.ssim, number(row, "ssim"), 1e-6);
        let part = |plane: &Plane<u8>| plane.view().part(30, 20, 90, 70).unwrap().to_plane();
        let of_parts = Ssim::new(255.0).compare(
            reference.view().part(30, 20, 90, 70).unwrap(),
            picture.view().part(30, 20, 90, 70).unwrap(),
        );
        assert_eq!(
            of_parts,
            Ssim::new(255.0).compare(&part(&reference), &part(&picture))
        );
    }
}

#[test]
fn the_map_and_other_depths_are_those_of_scikit_image() {
    let truth = json(&data("ssim.json"));
    let [a, b] = pictures();
    close(mse(&a, &b).unwrap(), number(&truth, "mse"), 1e-9);
    close(psnr(&a, &b, 255.0).unwrap(), number(&truth, "psnr"), 1e-9);
    let ssim = Ssim::new(255.0);
    close(
        ssim.compare(&a, &b).unwrap().ssim,
        number(&truth, "ssim"),
        1e-6,
    );
    let map = ssim.map(&a, &b).unwrap();
    let rows = truth["map"].as_array().unwrap();
    assert_eq!((map.width(), map.height()), (23, rows.len()));
    for (got, expected) in map.rows().zip(rows) {
        for (got, expected) in got.iter().zip(expected.as_array().unwrap()) {
            close(f64::from(*got), expected.as_f64().unwrap(), 1e-5);
        }
    }

    let deep = [&a, &b].map(|plane| plane.map(|v| u16::from(v) * 257));
    let got = Ssim::new(65535.0).compare(&deep[0], &deep[1]).unwrap().ssim;
    close(got, number(&truth, "sixteen_bits_ssim"), 1e-6);
    let unit = [&a, &b].map(|plane| plane.map(|v| f32::from(v) / 255.0));
    let got = Ssim::new(1.0).compare(&unit[0], &unit[1]).unwrap().ssim;
    close(got, number(&truth, "unit_ssim"), 1e-6);

    let upside_down = |p: &Plane<u8>| Plane::from_fn(23, 15, |x, y| p.get(x, 14 - y).unwrap());
    let mirrored = Plane::from_fn(23, 15, |x, y| a.get(22 - x, y).unwrap());
    let colours = Plane::interleaved([&a, &upside_down(&a), &mirrored]).unwrap();
    let others = Plane::interleaved([&b, &upside_down(&a), &upside_down(&b)]).unwrap();
    let got = ssim.compare(&colours, &others).unwrap().ssim;
    close(got, number(&truth, "colour_ssim"), 1e-6);
    let map = ssim.map(&colours, &others).unwrap();
    let inside = map.view().part(5, 5, 13, 5).unwrap();
    let mean = inside.rows().flatten().map(|v| f64::from(*v)).sum::<f64>() / 65.0;
    close(mean, number(&truth, "colour_ssim"), 1e-6);
}

/// Squared differences by hand, at lengths that are not a multiple of what is added at once.
#[test]
fn squared_errors_of_every_type_are_sums_of_squares() {
    for (width, height) in [(1, 1), (7, 3), (40000, 2)] {
        let a = Plane::from_fn(width, height, |x, y| (x * 37 + y * 101) as u16);
        let b = a.map(|v| v.wrapping_mul(31).rotate_left(3));
        let mean = |a: &Plane<u16>, b: &Plane<u16>| {
            let pairs = a.values().iter().zip(b.values());
            let squares = pairs.map(|(a, b)| u128::from(a.abs_diff(*b)).pow(2));
            squares.sum::<u128>() as f64 / (width * height) as f64
        };
        let expected = mean(&a, &b);
        close(mse(&a, &b).unwrap(), expected, 1e-12 * expected);
        let [a, b] = [&a, &b].map(|plane| plane.map(|v| (v >> 8) as u8));
        let expected = mean(&a.map(u16::from), &b.map(u16::from));
        close(mse(&a, &b).unwrap(), expected, 1e-12 * expected);
        close(
            mse(&a.map(f32::from), &b.map(f32::from)).unwrap(),
            expected,
            1e-12 * expected,
        );
    }
}

#[test]
fn pictures_that_cannot_be_compared_are_errors() {
    let [small, wide] = [(10, 11), (11, 10)].map(|(w, h)| Plane::filled(w, h, 0u8));
    let differs = PlaneError::Differs {
        first: [10, 11],
        second: [11, 10],
    };
    assert_eq!(mse(&small, &wide), Err(differs.clone()));
    assert_eq!(psnr(&small, &wide, 255.0), Err(differs.clone()));
    let ssim = Ssim::new(255.0);
    assert_eq!(ssim.compare(&small, &wide), Err(differs.clone()));
    assert_eq!(ssim.map(&small, &wide), Err(differs));
    let too_small = PlaneError::TooSmall {
        width: 10,
        height: 11,
        least: 11,
    };
    assert_eq!(ssim.compare(&small, &small), Err(too_small));
    assert_eq!(ssim.map(&small, &small), Ok(Plane::filled(10, 11, 1.0)));
    for range in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        let ssim = Ssim::new(range);
        let expected = PlaneError::Range {
            range: range.to_string(),
        };
        let large = Plane::filled(20, 20, 0u8);
        assert_eq!(ssim.compare(&large, &large), Err(expected.clone()));
        assert_eq!(ssim.map(&large, &large), Err(expected));
    }
    let empty = Plane::<f32>::default();
    assert!(mse(&empty, &empty).is_err());
    assert!(ssim.map(&empty, &empty).is_err());
}
