//! Rectification of cameras side by side, one above the other, on their side and on their head.

use std::f64::consts::FRAC_PI_2;

use ga_camera::rig::StereoRig;
use ga_camera::{Camera, Fisheye, Intrinsics, RadialTangential};
use ga_runtime::cga3::{Motor, Point, Rotor};
use ga_vision::ViewGeometryError;
use ga_vision::rectification::{Rectification, RectificationOptions};
use proptest::prelude::*;

use super::{motor, vector};

fn roll(quarter_turns: u8) -> Motor<f64> {
    Rotor::about_z(f64::from(quarter_turns) * FRAC_PI_2)
        .unwrap()
        .into()
}

/// What OpenCV 5.0.0's `stereoRectify` gives for two cameras, one above the other: in its pictures
/// the images of a point are in one column.
struct Above {
    rotation_vector: [f64; 3],
    translation: [f64; 3],
    /// How the pictures of OpenCV become those with rows: right angles, clockwise.
    quarter_turns: u8,
    /// `alpha`, the focal length and f·B of P2.
    focal: [(Option<f64>, f64, f64); 3],
    principal: [f64; 2],
    first: [[f64; 3]; 3],
    second: [[f64; 3]; 3],
}

const ABOVE: [Above; 2] = [
    Above {
        rotation_vector: [0.03, -0.05, 0.02],
        translation: [0.01, -0.2, 0.02],
        quarter_turns: 3,
        focal: [
            (None, 520.0, 104.647_981_346_990_16),
            (Some(0.0), 605.348_278_816_223_8, 121.823_991_134_601_51),
            (Some(1.0), 443.045_190_409_566_94, 89.161_124_657_411_66),
        ],
        principal: [323.005_138_397_216_8, 312.718_517_303_466_8],
        first: [
            [
                0.999_090_833_978_367_7,
                0.032_194_375_094_301_47,
                -0.027_946_872_324_053_806,
            ],
            [
                -0.035_495_615_558_969_01,
                0.991_262_792_609_458_2,
                -0.127_035_968_387_651_16,
            ],
            [
                0.023_612_851_087_901_676,
                0.127_912_463_037_758_16,
                0.991_504_329_321_417_9,
            ],
        ],
        second: [
            [
                0.998_363_070_433_099_1,
                0.052_245_382_729_952_675,
                0.023_272_292_082_977_115,
            ],
            [
                -0.049_690_399_499_995_326,
                0.993_807_989_999_906_6,
                -0.099_380_798_999_990_65,
            ],
            [
                -0.028_320_377_697_437_234,
                0.098_061_710_140_841_63,
                0.994_777_290_257_134_7,
            ],
        ],
    },
    Above {
        rotation_vector: [-0.02, 0.04, 0.05],
        translation: [-0.015, 0.15, 0.01],
        quarter_turns: 1,
        focal: [
            (None, 520.0, 78.561_313_634_638_25),
            (Some(0.0), 632.475_902_183_843_6, 95.554_110_995_799_48),
            (Some(1.0), 446.431_701_728_028_6, 67.446_655_645_963_33),
        ],
        principal: [319.687_194_824_218_75, 192.192_007_064_819_34],
        first: [
            [
                0.998_435_697_794_575_1,
                0.050_771_036_162_219_71,
                0.023_419_206_999_270_54,
            ],
            [
                -0.052_552_223_330_863_124,
                0.995_159_592_142_987_3,
                0.083_040_050_510_498_34,
            ],
            [
                -0.019_089_819_078_325_184,
                -0.084_140_882_172_803_58,
                0.996_270_992_629_384_6,
            ],
        ],
        second: [
            [
                0.994_757_083_572_641_3,
                0.100_674_016_557_654_2,
                -0.017_974_623_005_850_558,
            ],
            [
                -0.099_285_508_848_224_3,
                0.992_855_088_482_242_8,
                0.066_190_339_232_149_55,
            ],
            [
                0.024_509_843_222_722_906,
                -0.064_058_689_223_766_02,
                0.997_645_103_190_573_6,
            ],
        ],
    },
];

#[test]
fn cameras_one_above_the_other_are_rectified_as_by_opencv_on_their_side() {
    let first = Intrinsics::new([510.0, 500.0], [318.0, 244.0]).unwrap();
    let second = Intrinsics::new([530.0, 520.0], [325.0, 236.0]).unwrap();
    for case in ABOVE {
        let rotation = Rotor::from_rotation_vector(case.rotation_vector).unwrap();
        let rig = StereoRig::from_matrices(first, second, rotation.to_matrix(), case.translation);
        for (alpha, focal, shift) in case.focal {
            let options = RectificationOptions {
                alpha,
                ..RectificationOptions::default()
            };
            let found = Rectification::new(rig.as_ref().unwrap(), [640, 480], options).unwrap();
            assert_eq!(found.size, [480, 640]);
            assert_eq!(found.quarter_turns, [case.quarter_turns; 2]);
            for (motor, expected) in [
                (found.left.motor, case.first),
                (found.right.motor, case.second),
            ] {
                let own = (roll(case.quarter_turns).reverse() * motor)
                    .rotor()
                    .to_matrix();
                for (a, b) in own.iter().flatten().zip(expected.iter().flatten()) {
                    assert!((a - b).abs() < 1e-12, "{own:?} {expected:?}");
                }
            }
            let [u, v] = case.principal;
            let expected = if case.quarter_turns == 3 {
                [v, 639.0 - u]
            } else {
                [479.0 - v, u]
            };
            // OpenCV computes the corners in single precision.
            let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-6 * b, "{a} {b}");
            for camera in [found.rig.left(), found.rig.right()] {
                close(camera.focal()[0], focal);
                close(camera.focal()[1], focal);
                close(camera.principal()[0], expected[0]);
                close(camera.principal()[1], expected[1]);
            }
            close(focal * found.rig.baseline(), shift);
        }
    }
}

proptest! {
    /// Two cameras side by side whose pictures are rolled, each by itself.
    #[test]
    fn a_point_is_in_one_row_however_the_cameras_stand(
        world in (vector(1.0), -3.0..3.0, vector(2.0)),
        between in (vector(1.0), -0.15..0.15, -0.3..-0.05, -0.03..0.03, -0.05..0.05),
        place in (-0.3..0.3, -0.3..0.3, 1.5..9.0),
        rolls in (0_u8..4, 0_u8..4, -0.3..0.3),
        lens in prop::array::uniform4(-0.02..0.02),
        choice in (any::<bool>(), prop::option::of(0.0..=1.0)),
        is_fisheye in any::<bool>(),
    ) {
        let plain = Intrinsics::new([520.0, 510.0], [330.0, 235.0]).unwrap();
        let intrinsics = if is_fisheye {
            plain.with_lens(Fisheye::new(&lens).unwrap())
        } else {
            plain.with_lens(RadialTangential::new(&lens.map(|k| k * 0.5)).unwrap())
        };
        let upright = motor(world.0, world.1, world.2);
        let left = roll(rolls.0) * upright;
        let slanted = Motor::from(Rotor::about_z(rolls.2).unwrap());
        let beside = motor(between.0, between.1, [between.2, between.3, between.4]);
        let right = roll(rolls.1) * slanted * beside * upright;
        let camera = |world_to_camera| Camera { intrinsics, world_to_camera };
        let rig = StereoRig { left: camera(left), right: camera(right) };
        let options = RectificationOptions {
            zero_disparity: choice.0,
            alpha: choice.1,
            size: None,
        };
        let found = Rectification::new(&rig, [640, 480], options);
        if (rolls.0, rolls.1) == (2, 2) {
            let is_exchanged = matches!(found, Err(ViewGeometryError::Exchanged([x, ..])) if x < 0.0);
            prop_assert!(is_exchanged);
            return Ok(());
        }
        let found = match found {
            Err(ViewGeometryError::Empty) => {
                return Err(TestCaseError::reject("the views do not overlap"));
            }
            found => found.unwrap(),
        };
        let undone = [rolls.0, rolls.1].map(|count| (4 - count) % 4);
        prop_assert_eq!(found.quarter_turns, undone);
        let on_its_side = rolls.0 % 2 == 1;
        prop_assert_eq!(found.size, if on_its_side { [480, 640] } else { [640, 480] });

        let in_upright = Point::new(place.0 * place.2, place.1 * place.2, place.2);
        let point = upright.reverse().transform(in_upright);
        let (Ok(a), Ok(b)) = (rig.left.project(point), rig.right.project(point)) else {
            return Err(TestCaseError::reject("a camera does not see the point"));
        };
        let (Ok(a), Ok(b)) = (found.left_pixel(a), found.right_pixel(b)) else {
            return Err(TestCaseError::reject("the distortion cannot be inverted"));
        };
        prop_assert!((a[1] - b[1]).abs() < 1e-7, "{a:?} {b:?}");
        let seen = found.rig.point(a, a[0] - b[0]).unwrap();
        let expected = (found.left.motor * rig.left.world_to_camera).transform(point);
        prop_assert!(seen.distance(expected) < 1e-8 * place.2 * place.2, "{seen:?} {expected:?}");
        // The rig that remains sees the same.
        let again = found.rig.stereo_rig();
        prop_assert!((again.left.project(expected).unwrap()[0] - a[0]).abs() < 1e-8);
        prop_assert!((again.right.project(expected).unwrap()[0] - b[0]).abs() < 1e-7);
        prop_assert!((again.baseline() - rig.baseline()).abs() < 1e-12);
    }

    #[test]
    fn with_alpha_zero_every_pixel_was_seen_and_with_one_every_pixel_is_kept(
        rolls in (0_u8..4, 0_u8..4),
        angle in -0.06..0.06,
        axis in vector(1.0),
        k1 in -0.25..0.1,
    ) {
        prop_assume!(rolls != (2, 2));
        let lens = RadialTangential::new(&[k1, 0.02, 0.0, 0.0]).unwrap();
        let camera = Intrinsics::new([300.0, 310.0], [160.0, 118.0]).unwrap().with_lens(lens);
        let side = |world_to_camera| Camera { intrinsics: camera, world_to_camera };
        let right = roll(rolls.1) * motor(axis, angle, [-0.2, 0.01, 0.0]);
        let rig = StereoRig { left: side(roll(rolls.0)), right: side(right) };
        let with = |alpha| RectificationOptions { alpha: Some(alpha), ..Default::default() };
        let tight = Rectification::new(&rig, [320, 240], with(0.0)).unwrap();
        for map in [tight.left_map(), tight.right_map()] {
            let outside = map.inside().values().iter().filter(|inside| !**inside).count();
            // The border is sampled, so a pixel between two samples may be missed.
            prop_assert!(outside < 40, "{outside}");
        }
        let wide = Rectification::new(&rig, [320, 240], with(1.0)).unwrap();
        let [width, height] = wide.size.map(|count| (count - 1) as f64);
        for step in 0..=8 {
            let part = f64::from(step) / 8.0;
            for pixel in [[0.0, part * 239.0], [319.0, part * 239.0], [part * 319.0, 0.0]] {
                for [u, v] in [wide.left_pixel(pixel).unwrap(), wide.right_pixel(pixel).unwrap()] {
                    prop_assert!((-1e-6..=width + 1e-6).contains(&u), "{u}");
                    prop_assert!((-1e-6..=height + 1e-6).contains(&v), "{v}");
                }
            }
        }
    }
}
