use ga_anim::pose::Pose;
use ga_character::{CharacterError, TwoViews};
use ga_runtime::vga3::Vector;

use super::{assert_near, character, journey};

/// Joints at the heights 0 and 1 that go 4 m along an axis: the ball around the middle that holds
/// them has the radius √(2² + ½²).
const RADIUS: f64 = 2.061_552_812_808_830_3;

#[test]
fn the_cameras_see_the_motion_from_aside() {
    for (end, axis_of_view) in [([4.0, 0.0, 0.0], 2), ([0.0, 0.0, 4.0], 0)] {
        let clip = journey(0.5, &[[0.0; 3], end]);
        let seen = TwoViews::new(&character(), &clip, 7).unwrap();
        assert_near(seen.target_metres, [end[0] / 2.0, 0.5, end[2] / 2.0], 1e-12);
        // Half the picture is 540 px high at a focal length of 1600 px, and a tenth is left free.
        let half_height = (540.0f64 / 1600.0).atan();
        let distance = 1.1 * RADIUS / half_height.sin();
        let sides = [seen.left_camera_metres, seen.right_camera_metres]
            .map(|camera| Vector::from(camera) - Vector::from(seen.target_metres));
        for side in sides {
            assert!((side.length() - distance).abs() < 1e-9);
            assert!(side.e2.abs() < 1e-12);
            assert!(side.coordinates()[axis_of_view] > 0.9 * distance);
        }
        let [left, right] = sides.map(|side| side.coordinates());
        let products = left.iter().zip(right).map(|(a, b)| a * b);
        let cosine = products.sum::<f64>() / distance.powi(2);
        assert!((cosine - 30f64.to_radians().cos()).abs() < 1e-12);
        assert_eq!(seen.angle_degrees, 30.0);
        let baseline = 2.0 * distance * 15f64.to_radians().sin();
        assert!((seen.baseline_metres - baseline).abs() < 1e-9);
        // Right of the left camera, as they look: from +z that is +x, from +x it is −z.
        let to_right = sides[1] - sides[0];
        assert!(
            if axis_of_view == 2 {
                to_right.e1
            } else {
                -to_right.e3
            } > 0.0
        );
    }
}

#[test]
fn joints_are_found_exactly_without_noise_and_as_noise_predicts_with_it() {
    let places: Vec<[f64; 3]> = (0..200)
        .map(|step| [0.02 * f64::from(step), 0.0, 0.0])
        .collect();
    let seen = TwoViews::new(&character(), &journey(0.1, &places), 3).unwrap();
    assert_eq!(seen.joints_seen, 400);
    assert_eq!(seen.seed, 3);
    assert_eq!(seen.picture_pixels, [1920.0, 1080.0]);
    assert_eq!(seen.focal_length_pixels, 1600.0);
    let exact = &seen.noise_free;
    assert!(exact.joint_position_error_max_metres < 1e-9);
    assert!(exact.ray_gap_max_metres < 1e-9);
    for found in [exact, &seen.one_pixel_noise] {
        assert!(found.all_in_front_of_both_cameras);
        assert!(found.all_inside_both_pictures);
        let [mean, max] = [
            found.mean_per_joint_position_error_metres,
            found.joint_position_error_max_metres,
        ];
        assert!(mean <= max);
    }
    // A pixel is s = distance / f wide there. Across the mean of two is off by s/√2, up by s/√2,
    // and in depth by s / (√2 sin 15°), each the standard deviation of a normal distribution.
    let distance = 1.1 * (1.99f64.powi(2) + 0.25).sqrt() / (540.0f64 / 1600.0).atan().sin();
    let pixel = distance / 1600.0 / 2f64.sqrt();
    let deviations = [
        pixel / 15f64.to_radians().cos(),
        pixel,
        pixel / 15f64.to_radians().sin(),
    ];
    let root_mean_square = deviations.iter().map(|d| d * d).sum::<f64>().sqrt();
    let mean = seen.one_pixel_noise.mean_per_joint_position_error_metres;
    assert!(
        (0.7 * root_mean_square..0.95 * root_mean_square).contains(&mean),
        "{mean} {root_mean_square}"
    );
    // Noise that both cameras shared would leave no gap between the rays.
    assert!(seen.one_pixel_noise.ray_gap_max_metres > pixel);
}

#[test]
fn equal_seeds_are_equal_noise() {
    let clip = journey(0.5, &[[0.0; 3], [1.0, 0.0, 0.0]]);
    let of = |seed| TwoViews::new(&character(), &clip, seed).unwrap();
    assert_eq!(of(1), of(1));
    assert_ne!(of(1).one_pixel_noise, of(2).one_pixel_noise);
    assert_eq!(of(1).noise_free, of(2).noise_free);
}

#[test]
fn what_cannot_be_seen_is_an_error() {
    // A skeleton whose joints are all in one point.
    let mut character = character();
    let mut joints = character.skeleton.joints().to_vec();
    joints[1].head = joints[0].head;
    character.skeleton = ga_anim::skeleton::Skeleton::new(joints).unwrap();
    let clip = journey(0.5, &[[0.0; 3]]);
    assert!(matches!(
        TwoViews::new(&character, &clip, 1),
        Err(CharacterError::NoPlace)
    ));
    let other = ga_anim::clip::Clip::new(0.5, vec![Pose::rest(3)]).unwrap();
    assert!(matches!(
        TwoViews::new(&character, &other, 1),
        Err(CharacterError::Skeleton(_))
    ));
}
