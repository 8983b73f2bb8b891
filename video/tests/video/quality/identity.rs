//! What is identical, and what is said where a number is infinite or does not exist.

use ga_image::grey::Luma;
use ga_image::picture::Picture;
use ga_image::plane::Plane;
use ga_image::ycbcr::Range;
use ga_video::quality::{
    FrameQuality, Same, VideoComparison, VideoQuality, compare_pictures, mean_ciede2000,
};

use super::{SIZE, compared, eight, pair};

/// The numbers of a film and of its pictures, as JSON.
fn reported(frames: &[FrameQuality]) -> serde_json::Value {
    let found = VideoQuality::new(frames, SIZE, &[], None).unwrap();
    serde_json::to_value(found).unwrap()
}

/// No key is null without one that says why, also in objects within.
fn assert_nulls_have_reasons(value: &serde_json::Value) {
    let serde_json::Value::Object(object) = value else {
        return;
    };
    for (key, value) in object {
        let reasons = [format!("{key}_reason"), "null_reason".to_owned()];
        let mut reasons = reasons.iter().filter_map(|reason| object.get(reason));
        assert!(
            !value.is_null() || reasons.any(serde_json::Value::is_string),
            "{key} of {object:?}"
        );
        assert_nulls_have_reasons(value);
    }
}

#[test]
fn psnr_of_the_mean_error_is_finite_beside_an_identical_frame() {
    let [reference, distorted] = pair(3);
    let found = compared(eight(&reference), eight(&distorted));
    let object = reported(&found);
    assert_eq!(object["psnr"], serde_json::Value::Null);
    assert_eq!(object["psnr_reason"], "1 of 3 frames is identical in luma");
    assert_eq!(
        (&object["identical"], &object["identical_frames"]),
        (&false.into(), &1.into())
    );
    assert_eq!(object["differs_in"], serde_json::json!(["luma", "colours"]));
    assert_nulls_have_reasons(&object);
    // Sums over all samples of all frames, plane by plane.
    let mut sums = [[0.0; 2]; 3];
    for (a, b) in reference.iter().zip(&distorted) {
        for ((a, b), sum) in a.as_array().iter().zip(b.as_array()).zip(&mut sums) {
            for (a, b) in a.values().iter().zip(b.values()) {
                sum[0] += (f64::from(*a) - f64::from(*b)).powi(2);
                sum[1] += 1.0;
            }
        }
    }
    let psnr = |error: f64, count: f64| 10.0 * (255.0 * 255.0 * count / error).log10();
    let [y, cb, cr] = sums.map(|[error, count]| psnr(error, count));
    let all = psnr(
        sums.iter().map(|s| s[0]).sum(),
        sums.iter().map(|s| s[1]).sum(),
    );
    for (key, expected) in [
        ("psnr_of_mean_mse", y),
        ("psnr_cb_of_mean_mse", cb),
        ("psnr_cr_of_mean_mse", cr),
        ("psnr_6_1_1_of_mean_mse", (6.0 * y + cb + cr) / 8.0),
        ("psnr_all_of_mean_mse", all),
    ] {
        let number = object[key].as_f64().unwrap();
        assert!(
            (number - expected).abs() < 1e-9,
            "{key}: {number}, not {expected}"
        );
    }
    let same = compared(eight(&reference), eight(&reference));
    let object = reported(&same);
    assert_eq!(object["psnr_of_mean_mse"], serde_json::Value::Null);
    assert_eq!(object["psnr_of_mean_mse_reason"], "nothing differs");
    assert_eq!(object["identical"], true);
    assert_nulls_have_reasons(&object);
}

/// The numbers of `ffmpeg -lavfi psnr` for the film of the shared cases, which are also in it.
#[test]
fn psnr_is_that_of_ffmpeg() {
    let Some(folder) = nullcone_shared_data::shared("cases/video/psnr-null") else {
        return;
    };
    let open = |name: &str| ga_video::open(folder.join(name)).unwrap();
    let comparison = VideoComparison::new(open("ref.y4m"), open("dist.y4m"), None).unwrap();
    let found: Vec<_> = comparison.map(Result::unwrap).collect();
    let object = reported(&found);
    for (key, expected) in [
        ("psnr_of_mean_mse", 23.850_402),
        ("psnr_all_of_mean_mse", 25.611_314),
    ] {
        let number = object[key].as_f64().unwrap();
        assert!(
            (number - expected).abs() < 1e-5,
            "{key}: {number}, not {expected}"
        );
    }
}

#[test]
fn identity_is_that_of_all_planes_and_properties() {
    let [reference, _] = pair(2);
    let mut coloured = reference.clone();
    for planes in &mut coloured {
        planes.differences[1] = planes.differences[1].map(|v| v ^ 1);
    }
    let found = compared(eight(&reference), eight(&coloured));
    assert!(found.iter().all(|frame| frame.same
        == Same {
            colours: false,
            ..Same::ALL
        }));
    let object = reported(&found);
    assert_eq!(
        object["psnr_of_mean_mse_reason"],
        "luma is identical, colours differ"
    );
    assert_eq!(object["psnr_cb_reason"], "Cb is identical");
    let decibels = 20.0 * 255f64.log10();
    assert!((object["psnr_cr"].as_f64().unwrap() - decibels).abs() < 1e-9);
    // A plane is a sixth of the samples.
    let all = decibels + 10.0 * 6f64.log10();
    assert!((object["psnr_all"].as_f64().unwrap() - all).abs() < 1e-9);
    assert_eq!(object["identical"], false);

    let mut full = eight(&reference);
    full.properties.colours.range = Range::Full;
    let error = VideoComparison::new(eight(&reference), full, None)
        .err()
        .unwrap();
    assert_eq!(
        error.to_string(),
        "the videos differ in range: limited and full"
    );

    let mut faster = eight(&reference);
    faster.properties.frames_per_second = Some([30, 1]);
    faster.step_seconds = 1.0 / 30.0;
    let comparison = VideoComparison::new(eight(&reference), faster, None).unwrap();
    let properties = comparison.property_differences();
    let message = "the videos differ in frames in a second: 25/1 and 30/1";
    assert_eq!(properties[0].to_string(), message);
    let frames: Vec<_> = comparison.map(Result::unwrap).collect();
    let found = VideoQuality::new(&frames, SIZE, &properties, None).unwrap();
    assert!(!found.identical && found.identical_frames == 2);
    assert_eq!(found.differs_in, ["frames in a second", "frame times"]);
}

#[test]
fn pictures_are_identical_where_colours_and_alpha_are() {
    let rgb = Plane::from_fn(40, 30, |x, y| [(5 * x) as u8, (7 * y) as u8, 90]);
    let same = |other: Picture| {
        compare_pictures(&rgb.clone().into(), &other, None)
            .unwrap()
            .same
    };
    assert!(same(rgb.clone().into()).is_all());
    // The same with 16 bits and opaque alpha.
    let deep = rgb.map(|[r, g, b]| [r, g, b, 255].map(|v| 257 * u16::from(v)));
    assert!(same(deep.clone().into()).is_all());
    let mut faint = deep;
    faint.values_mut()[7][3] -= 1;
    assert_eq!(same(faint.into()).differing(), ["alpha"]);
    let hole = rgb.map(|[r, g, b]| [r, g, b, 0]);
    assert_eq!(same(hole.into()).differing(), ["alpha"]);
    // Blue counts for so little that one more of it changes luma of few pixels alone.
    let luma = |rgb: [u8; 3]| Luma::Bt601.of(rgb);
    let blue = rgb.map(|[r, g, b]| match luma([r, g, b]) == luma([r, g, b + 1]) {
        true => [r, g, b + 1],
        false => [r, g, b],
    });
    let found = compare_pictures(&rgb.clone().into(), &blue.clone().into(), None).unwrap();
    assert_eq!(found.same.differing(), ["colours"]);
    assert_eq!(found.luma.psnr, f64::INFINITY);
    // Where blue differs by 1, Cb does by 0.5 and Cr by 0.114 / (2 · 0.701).
    let pixels = rgb.values().iter().zip(blue.values());
    let share = pixels.filter(|(a, b)| a != b).count() as f64 / rgb.values().len() as f64;
    let psnr = |error: f64| 20.0 * (255.0 / error).log10() - 10.0 * share.log10();
    let expected = [0.5, 0.114 / 1.402].map(psnr);
    for (found, expected) in found.psnr_differences.unwrap().iter().zip(expected) {
        assert!((found - expected).abs() < 1e-2, "{found}, not {expected}");
    }
    assert!((found.psnr_all - psnr(3f64.sqrt().recip())).abs() < 1e-9);
    assert_eq!(found.ciede2000, Some(mean_ciede2000(&rgb, &blue)));

    let Some(folder) = nullcone_shared_data::shared("cases/video/colour-only") else {
        return;
    };
    let [a, b] = ["a.png", "b.png"].map(|name| ga_image::file::read(folder.join(name)).unwrap());
    let found = compare_pictures(&a, &b, None).unwrap();
    assert_eq!(found.same.differing(), ["colours"]);
    assert!((found.psnr_all - 11.9).abs() < 0.1, "{}", found.psnr_all);
    assert!(found.ciede2000 > Some(20.0));
}

/// The pictures differ by their rotation in EXIF alone, which reading undoes.
#[test]
fn a_rotated_picture_is_compared_upright() {
    let Some(folder) = nullcone_shared_data::shared("cases/video/rotation") else {
        return;
    };
    let [a, b] =
        ["a.jpg", "b_exif3.jpg"].map(|name| ga_image::file::read(folder.join(name)).unwrap());
    let found = compare_pictures(&a, &b, None).unwrap();
    // Each was compressed for itself.
    assert!(
        found.luma.psnr > 35.0 && found.luma.ssim > Some(0.95),
        "{found:?}"
    );
}

#[test]
fn pictures_that_are_too_small_for_a_window_have_psnr() {
    for [width, height] in [[1, 1], [3, 2], [10, 40], [40, 10], [10, 10]] {
        let a = Plane::filled(width, height, 100u8);
        let b = Plane::filled(width, height, 101u8);
        let found = compare_pictures(&a.into(), &b.into(), None).unwrap();
        assert!((found.luma.psnr - 20.0 * 255f64.log10()).abs() < 1e-9);
        assert!((found.luma.attention_psnr - found.luma.psnr).abs() < 1e-9);
        assert_eq!(
            [
                found.luma.ssim,
                found.luma.attention_ssim,
                found.luma.ms_ssim
            ],
            [None; 3]
        );
    }
    let a = Plane::filled(11, 11, 100u8);
    let found = compare_pictures(&a.clone().into(), &a.into(), None).unwrap();
    assert_eq!(found.luma.ssim, Some(1.0));
}
