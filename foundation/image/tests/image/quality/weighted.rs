//! Measures with a weight for each pixel.

use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::{Plane, PlaneError};
use ga_image::quality::{Ssim, Weights, mse, psnr, weighted_mse, weighted_psnr};
use nullcone_shared_data::shared;
use proptest::prelude::*;

use super::{close, json, number, pictures};

fn weights(plane: Plane) -> Weights {
    Weights::new(plane).unwrap()
}

/// The oracle weights by the levels of its attention map, and SSIM over whole windows.
#[test]
fn the_oracles_pictures_have_its_weighted_figures() {
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
    let map = read(truth["attention_map"].as_str().unwrap());
    let attention = weights(map.map(f32::from));
    let rows = truth["quality"].as_array().unwrap();
    assert_eq!(rows.len(), 10);
    for row in rows {
        let picture = read(row["file"].as_str().unwrap());
        let psnr = weighted_psnr(&reference, &picture, &attention, 255.0).unwrap();
        close(psnr, number(row, "wpsnr"), 1e-9);
        let ssim = Ssim::new(255.0);
        let got = ssim.compare_weighted(&reference, &picture, &attention);
        let got = got.unwrap();
        close(got.weighted_ssim, number(row, "wssim"), 1e-6);
        assert_eq!(got.similarity, ssim.compare(&reference, &picture).unwrap());
    }
}

#[test]
fn errors_where_no_one_looks_do_not_count() {
    let a = Plane::from_fn(40, 30, |x, y| (5 * x + 3 * y) as u8);
    let b = Plane::from_fn(40, 30, |x, y| {
        a.get(x, y).unwrap() ^ if x < 20 { 0x55 } else { 0 }
    });
    let half = |left: f32, right: f32| {
        weights(Plane::from_fn(
            40,
            30,
            |x, _| if x < 20 { left } else { right },
        ))
    };
    let elsewhere = weighted_psnr(&a, &b, &half(0.0, 2.0), 255.0).unwrap();
    assert_eq!(elsewhere, f64::INFINITY);
    let there = weighted_mse(&a, &b, &half(7.0, 0.0)).unwrap();
    close(there, 2.0 * mse(&a, &b).unwrap(), 1e-9);
    let ssim = Ssim::new(255.0);
    let of = |weights| {
        ssim.compare_weighted(&a, &b, &weights)
            .unwrap()
            .weighted_ssim
    };
    assert!(of(half(0.0, 1.0)) > of(half(1.0, 1.0)));
    assert!(of(half(1.0, 1.0)) > of(half(1.0, 0.0)));
}

/// The mean of the map of SSIM, weighted by hand, and that of several channels.
#[test]
fn weighted_ssim_is_the_weighted_mean_of_its_map() {
    let [a, b] = pictures();
    let plane = Plane::from_fn(23, 15, |x, y| (x * y % 7) as f32);
    let ssim = Ssim::new(255.0);
    let map = ssim.map(&a, &b).unwrap();
    let (mut sum, mut total) = (0.0, 0.0);
    for row in 5..10 {
        for column in 5..18 {
            let weight = f64::from(plane.row(row)[column]);
            sum += weight * f64::from(map.row(row)[column]);
            total += weight;
        }
    }
    let weights = weights(plane);
    let got = ssim.compare_weighted(&a, &b, &weights).unwrap();
    close(got.weighted_ssim, sum / total, 1e-6);
    let colours = [&a, &b].map(|plane| plane.map(|v| [v; 2]));
    let of_colours = ssim.compare_weighted(&colours[0], &colours[1], &weights);
    close(of_colours.unwrap().weighted_ssim, got.weighted_ssim, 1e-9);
    close(
        weighted_mse(&colours[0], &colours[1], &weights).unwrap(),
        weighted_mse(&a, &b, &weights).unwrap(),
        1e-9,
    );
}

#[test]
fn weights_that_cannot_weigh_are_errors() {
    for bad in [-1.0, f32::NAN, f32::INFINITY] {
        // In a whole piece of the loop, and in the rest.
        for index in [13, 25] {
            let mut plane = Plane::filled(9, 3, 1.0);
            plane.values_mut()[index] = bad;
            let error = Weights::new(plane).unwrap_err();
            let PlaneError::Weight {
                column,
                row,
                weight,
            } = error
            else {
                panic!("{error}");
            };
            assert_eq!([column, row], [index % 9, index / 9]);
            assert_eq!(weight.to_bits(), bad.to_bits());
        }
    }
    assert_eq!(
        Weights::new(Plane::filled(9, 3, 0.0)),
        Err(PlaneError::ZeroWeights)
    );
    assert_eq!(Weights::new(Plane::default()), Err(PlaneError::ZeroWeights));

    let picture = Plane::filled(12, 12, 0u8);
    let other = weights(Plane::filled(12, 11, 1.0));
    let differs = PlaneError::Differs {
        first: [12, 12],
        second: [12, 11],
    };
    assert_eq!(
        weighted_mse(&picture, &picture, &other),
        Err(differs.clone())
    );
    let ssim = Ssim::new(255.0);
    assert_eq!(
        ssim.compare_weighted(&picture, &picture, &other),
        Err(differs)
    );
    let equal = weights(Plane::filled(12, 12, 1.0));
    assert!(weighted_psnr(&picture, &picture, &equal, 0.0).is_err());
    // Positive at the border alone, where no window has its middle.
    let border = weights(Plane::from_fn(
        12,
        12,
        |x, _| if x == 0 { 1.0 } else { 0.0 },
    ));
    assert_eq!(
        ssim.compare_weighted(&picture, &picture, &border),
        Err(PlaneError::ZeroWeights)
    );
}

proptest! {
    #[test]
    fn equal_weights_change_nothing_and_only_ratios_matter(
        (width, height, values) in (11usize..40, 11usize..30).prop_flat_map(|(w, h)| {
            (Just(w), Just(h), proptest::collection::vec(any::<(u8, u8, u8)>(), w * h))
        }),
        factor in 1e-3f32..1e3,
    ) {
        let plane = |of: fn(&(u8, u8, u8)) -> u8| {
            Plane::from_values(width, height, values.iter().map(of).collect()).unwrap()
        };
        let [a, b, map] = [plane(|v| v.0), plane(|v| v.1), plane(|v| v.2.max(1))];
        let ssim = Ssim::new(255.0);
        let equal = weights(Plane::filled(width, height, factor));
        let got = ssim.compare_weighted(&a, &b, &equal).unwrap();
        close(got.weighted_ssim, got.similarity.ssim, 1e-12);
        let expected = psnr(&a, &b, 255.0).unwrap();
        close(weighted_psnr(&a, &b, &equal, 255.0).unwrap(), expected, 1e-9);

        let [plain, scaled] = [1.0, factor].map(|f| weights(map.map(|v| f * f32::from(v))));
        let there = ssim.compare_weighted(&a, &b, &plain).unwrap().weighted_ssim;
        let back = ssim.compare_weighted(&b, &a, &plain).unwrap().weighted_ssim;
        let other = ssim.compare_weighted(&a, &b, &scaled).unwrap().weighted_ssim;
        close(there, back, 1e-6);
        close(there, other, 1e-6);
        close(
            weighted_mse(&a, &b, &plain).unwrap(),
            weighted_mse(&a, &b, &scaled).unwrap(),
            1e-2,
        );
        prop_assert_eq!(
            ssim.compare_weighted(&a, &a, &plain).unwrap().weighted_ssim,
            1.0
        );
    }
}
