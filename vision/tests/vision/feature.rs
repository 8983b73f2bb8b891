//! Features of views whose relation is known.

use ga_camera::Intrinsics;
use ga_image::file;
use ga_image::grey::Luma;
use ga_image::plane::Plane;
use ga_runtime::vga3::Vector;
use ga_vision::feature::{DetectOptions, ViewOptions, detect, match_views};
use ga_vision::relative_pose::{Options, estimate};
use proptest::prelude::*;

/// A smooth texture without a period, at any place.
fn texture(x: f64, y: f64) -> f64 {
    let mut sum = 128.0;
    for k in 1..24 {
        let k = f64::from(k);
        let (angle, wave) = (2.4 * k, 0.09 + 0.019 * k);
        sum += 14.0 * (wave * (x * angle.cos() + y * angle.sin()) + 1.7 * k * k).sin();
    }
    sum
}

/// A view in which the pixel x shows the texture at A⁻¹ (x − t), with gain and offset.
fn view(size: [usize; 2], linear: [[f64; 2]; 2], t: [f64; 2], gain: f64) -> Plane<u8> {
    let [[a, b], [c, d]] = linear;
    let determinant = a * d - b * c;
    Plane::from_fn(size[0], size[1], |u, v| {
        let (x, y) = (u as f64 - t[0], v as f64 - t[1]);
        let place = [(d * x - b * y) / determinant, (a * y - c * x) / determinant];
        (gain * texture(place[0], place[1]) + 8.0)
            .round()
            .clamp(0.0, 255.0) as u8
    })
}

const IDENTITY: [[f64; 2]; 2] = [[1.0, 0.0], [0.0, 1.0]];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn turned_and_scaled_views_are_matched_to_a_tenth_of_a_pixel(
        angle in -3.0..3.0_f64, zoom in 0.6..1.5_f64, gain in 0.6..1.1_f64,
    ) {
        let (sine, cosine): (f64, f64) = f64::sin_cos(angle);
        let linear = [[zoom * cosine, -zoom * sine], [zoom * sine, zoom * cosine]];
        // The middle stays in the middle.
        let t = [0, 1].map(|k| 160.0 - linear[k][0] * 160.0 - linear[k][1] * 160.0);
        let left = view([320, 320], IDENTITY, [0.0; 2], 1.0);
        let right = view([320, 320], linear, t, gain);
        let pairs = match_views(&left, &right, &ViewOptions::default());
        let mut errors: Vec<f64> = pairs.iter().map(|pair| {
            let [x, y] = pair.left;
            let image = [0, 1].map(|k| linear[k][0] * x + linear[k][1] * y + t[k]);
            (image[0] - pair.right[0]).hypot(image[1] - pair.right[1])
        }).collect();
        errors.sort_by(f64::total_cmp);
        prop_assert!(errors.len() >= 30, "{} pairs", errors.len());
        prop_assert!(errors[errors.len() / 2] < 0.1, "{}", errors[errors.len() / 2]);
        prop_assert!(errors[errors.len() * 9 / 10] < 1.0, "{errors:?}");
    }
}

#[test]
fn views_without_corners_or_room_have_no_features() {
    let options = DetectOptions::default();
    assert!(detect(&Plane::filled(200, 200, 90u8), &options).is_empty());
    assert!(detect(&Plane::<u8>::filled(0, 0, 0), &options).is_empty());
    assert!(detect(&view([40, 300], IDENTITY, [0.0; 2], 1.0), &options).is_empty());
    let edge = Plane::from_fn(200, 200, |u, _| if u < 100 { 20u8 } else { 220 });
    assert!(detect(&edge, &options).is_empty());
}

#[test]
fn the_number_of_features_is_bounded_and_the_result_is_repeatable() {
    let picture = view([400, 300], IDENTITY, [0.0; 2], 1.0);
    let options = DetectOptions {
        features: 100,
        ..DetectOptions::default()
    };
    let found = detect(&picture, &options);
    assert!(found.len() <= 103 && found.len() > 60, "{}", found.len());
    assert_eq!(found, detect(&picture, &options));
}

/// The rotation between two rectified views, the angle of the translation to the u axis, and the
/// standard deviation that is stated for it, in degrees, for a focal length and principal points.
fn errors_of_rectified(views: [&str; 2], focal: f64, centres: [[f64; 2]; 2]) -> Vec<[f64; 3]> {
    let read = |name: &str| {
        let path = nullcone_shared_data::shared(&format!("data/vision/{name}"))?;
        Some(
            file::read(path)
                .expect("a picture")
                .to_grey::<u8>(Luma::Bt601),
        )
    };
    let Some((left, right)) = read(views[0]).zip(read(views[1])) else {
        return Vec::new();
    };
    let pairs = match_views(&left, &right, &ViewOptions::default());
    let [first, second] =
        centres.map(|centre| Intrinsics::new([focal; 2], centre).expect("a camera"));
    let found = (1..=5).map(|seed| {
        let options = Options {
            seed,
            ..Options::default()
        };
        let found = estimate(&pairs, &first, &second, &options).expect("a motion");
        let (_, angle) = found.left_to_right.motor.rotor().to_axis_angle();
        let angle = angle.min(std::f64::consts::TAU - angle);
        let t = Vector::from(found.left_to_right.motor.translator().displacement());
        let direction = t.angle(-Vector::X).expect("a translation");
        let deviation = found.direction_deviation().expect("many pairs");
        [angle, direction, deviation].map(f64::to_degrees)
    });
    found.collect()
}

#[test]
fn rectified_pairs_are_translations_to_the_side() {
    let motorcycle = errors_of_rectified(
        [
            "middlebury/motorcycle_left.png",
            "middlebury/motorcycle_right.png",
        ],
        994.978,
        [[311.193, 254.877], [311.193 + 31.086, 254.877]],
    );
    let terrace = errors_of_rectified(
        [
            "stereo/eth3d_terrace/im0.png",
            "stereo/eth3d_terrace/im1.png",
        ],
        711.499,
        [[376.135, 227.447]; 2],
    );
    for [rotation, direction, _] in motorcycle {
        assert!(
            rotation <= 0.2 && direction <= 1.0,
            "{rotation} {direction}"
        );
    }
    // The baseline is short for this scene, so that the direction is known less well.
    for [rotation, direction, deviation] in terrace {
        let limit = 3.0 * deviation;
        assert!(
            rotation <= 0.2 && direction <= limit,
            "{rotation} {direction} {limit}"
        );
    }
}

#[test]
fn any_number_of_features_may_be_asked_for() {
    let view = view([160, 120], IDENTITY, [0.0; 2], 1.0);
    let found = |features| {
        let options = DetectOptions {
            features,
            ..DetectOptions::default()
        };
        detect(&view, &options)
    };
    let all = found(1_000_000);
    assert!(!all.is_empty());
    assert_eq!(found(usize::MAX), all);
}
