//! Views of more than 8 bits: they show what those of 8 bits show, and more.

use ga_image::grey::Luma;
use ga_image::picture::Picture;
use ga_image::plane::Plane;
use ga_image::sample::Sample;
use ga_vision::disparity::evaluation::ErrorMap;
use ga_vision::disparity::{DisparityMap, file};
use ga_vision::feature::{ViewOptions, match_views};
use ga_vision::matcher::{Match, Matcher, MatcherOptions, Mode};
use nullcone_shared_data::shared;

const MODES: [Mode; 3] = [Mode::Fast, Mode::Balanced, Mode::Best];
const SIZE: [usize; 2] = [180, 100];

fn matched<T: Sample>([left, right]: &[Plane<T>; 2], range: i32, mode: Mode) -> Match {
    let options = MatcherOptions {
        range: [0, range],
        mode,
        threads: 2,
    };
    let mut matcher = Matcher::new(options, left.width(), left.height()).unwrap();
    matcher.run(left, right).unwrap()
}

/// A texture of 12 bits, the mean of a coarse and a fine one.
fn texture(column: usize, row: usize) -> u32 {
    let number = |column: usize, row: usize| {
        let mut state =
            (column as u32).wrapping_mul(0x9E37_79B9) ^ (row as u32).wrapping_mul(0x85EB_CA6B);
        state = (state ^ (state >> 15)).wrapping_mul(0x2C1B_3C6D);
        state = (state ^ (state >> 12)).wrapping_mul(0x297A_2D39);
        (state ^ (state >> 15)) >> 20
    };
    (number(column / 5 + 900, row / 5) + number(column, row)) / 2
}

/// A rectangle at disparity 17 before a background at disparity 6, as numbers of 12 bits.
fn rectangle() -> ([Plane<u32>; 2], DisparityMap) {
    rectangle_of(texture)
}

fn rectangle_of(texture: fn(usize, usize) -> u32) -> ([Plane<u32>; 2], DisparityMap) {
    let [width, height] = SIZE;
    let is_near =
        |column: usize, row: usize| (60..120).contains(&column) && (25..75).contains(&row);
    let view = |near: usize, far: usize| {
        Plane::from_fn(width, height, |column, row| {
            match is_near(column + near, row) {
                true => texture(column + near + 5000, row),
                false => texture(column + far, row),
            }
        })
    };
    let truth = Plane::from_fn(width, height, |column, row| match is_near(column, row) {
        true => 17.0,
        // What the rectangle hides, and what is outside the right view, does not count.
        false if column < 6 || is_near(column + 11, row) => f32::NAN,
        false => 6.0,
    });
    ([view(0, 0), view(17, 6)], DisparityMap::new(truth))
}

/// Views of 16 bits as a file holds them, spread.
fn spread(views: [Plane<u16>; 2]) -> [Plane<u16>; 2] {
    Picture::spread(views.map(Picture::from)).map(|view| view.to_grey(Luma::Bt601))
}

fn bad_2(found: &Match, truth: &DisparityMap) -> f64 {
    ErrorMap::new(&found.disparity, truth).unwrap().bad(2.0)
}

/// The part of the pixels where two maps differ by more than 2 px, in percent.
fn apart(a: &Match, b: &Match) -> f64 {
    ErrorMap::new(&a.disparity, &b.disparity).unwrap().bad(2.0)
}

#[test]
fn every_depth_has_the_disparities_of_8_bits() {
    let (views, truth) = rectangle();
    let bytes = views.each_ref().map(|view| view.map(|v| (v >> 4) as u8));
    for mode in MODES {
        let expected = matched(&bytes, 32, mode);
        assert!(bad_2(&expected, &truth) < 2.0);
        for bits in [10, 12, 14, 16] {
            let deep = views.each_ref().map(|view| {
                view.map(|v| match bits {
                    10 | 12 => (v >> (12 - bits)) as u16,
                    _ => (v << (bits - 12)) as u16,
                })
            });
            let found = matched(&spread(deep), 32, mode);
            let (wrong, differ) = (bad_2(&found, &truth), apart(&found, &expected));
            assert!(
                wrong < 2.0 && differ < 2.0,
                "{mode:?}, {bits} bits: {wrong} %, {differ} %"
            );
            assert!(found.summary().textured > 98.0, "{mode:?}, {bits} bits");
        }
    }
}

/// 14 of 4095 numbers are less than a step of 8 bits.
#[test]
fn contrast_below_one_step_of_8_bits_is_enough() {
    let (views, truth) = rectangle();
    let faint = views
        .each_ref()
        .map(|view| view.map(|v| (2001 + v * 14 / 4096) as u16));
    let bytes = faint.each_ref().map(|view| view.map(|v| (v >> 4) as u8));
    let levels = |level: u8| bytes[0].values().contains(&level);
    assert!((0..=255).filter(|level| levels(*level)).count() <= 2);
    for mode in MODES {
        let found = matched(&spread(faint.clone()), 32, mode);
        let wrong = bad_2(&found, &truth);
        assert!(wrong < 2.0, "{mode:?}: {wrong} %");
        assert!(found.summary().textured > 98.0, "{mode:?}");
    }
}

/// A faint texture beside a bright lamp: the range of the whole picture is large. The texture is
/// coarser than noise.
#[test]
fn faint_texture_in_a_picture_of_much_contrast_is_matched() {
    let (views, truth) = rectangle_of(|column, row| texture(column / 3, row / 3));
    let lit = views.map(|view| {
        Plane::from_fn(SIZE[0], SIZE[1], |column, row| match row < 10 {
            true => (view.row(row)[column] % 4096) as u16,
            false => (2001 + view.row(row)[column] * 14 / 4096) as u16,
        })
    });
    let found = matched(&spread(lit), 32, Mode::Fast);
    let wrong = bad_2(&found, &truth);
    assert!(wrong < 3.0, "{wrong} %");
    assert!(
        found.summary().textured > 60.0,
        "{}",
        found.summary().textured
    );
}

/// The numbers of 8 bits, stored as 16, are the same picture to the last bit of the result.
#[test]
fn numbers_of_8_bits_in_16_change_nothing() {
    let (views, _) = rectangle();
    let bytes = views.map(|view| view.map(|v| (v >> 4) as u8));
    let stored = bytes.each_ref().map(|view| view.map(u16::from));
    let deep = spread(stored);
    for mode in MODES {
        let (a, b) = (matched(&bytes, 32, mode), matched(&deep, 32, mode));
        assert_eq!(a.disparity, b.disparity);
        assert_eq!(a.confidence, b.confidence);
    }
    let options = ViewOptions::default();
    let pairs = match_views(&bytes[0], &bytes[1], &options);
    assert!(pairs.len() > 50, "{}", pairs.len());
    assert_eq!(pairs, match_views(&deep[0], &deep[1], &options));
}

/// A real pair, with the depth and the contrast of other cameras.
#[test]
fn a_real_pair_is_matched_at_every_depth() {
    let Some(folder) = shared("data/vision/middlebury") else {
        return;
    };
    let read = |name: &str| ga_image::file::read(folder.join(name)).unwrap();
    let views = ["motorcycle_left.png", "motorcycle_right.png"].map(read);
    let truth = file::read(folder.join("motorcycle_disp.pfm"), None).unwrap();
    let bytes = views.each_ref().map(|view| view.to_grey::<u8>(Luma::Bt601));
    let expected = matched(&bytes, 64, Mode::Fast);
    let wanted = bad_2(&expected, &truth);
    // What the colours tell of grey between the levels of 8 bits counts.
    let deep = |offset: f32, range: f32| {
        let stored = views.each_ref().map(|view| {
            let grey: Plane<f32> = view.to_rgb::<f32>().map(|rgb| Luma::Bt601.of(rgb));
            grey.map(|v| (offset + range * v).round() as u16)
        });
        matched(&spread(stored), 64, Mode::Fast)
    };
    for white in [1023.0, 4095.0, 65535.0] {
        let found = deep(0.0, white);
        let (wrong, differ) = (bad_2(&found, &truth), apart(&found, &expected));
        assert!(
            wrong < wanted + 0.5 && differ < 3.0,
            "{white}: {wrong} %, {differ} %"
        );
    }
    // 60 steps of 4095 are less than 4 of 255.
    let faint = bad_2(&deep(1500.0, 60.0), &truth);
    assert!(faint < wanted + 3.0, "{faint} %, not {wanted} %");
}
