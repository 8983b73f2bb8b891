//! Visual information fidelity.

use ga_image::plane::{Plane, PlaneError};
use ga_video::quality::{VIF_LEAST_SIDE, Vif};

const SIZE: [usize; 2] = [150, 110];

/// Bits without an order.
fn noise(column: usize, row: usize) -> u32 {
    let [column, row] = [column, row].map(|index| index as u32);
    let sum = column
        .wrapping_mul(374_761_393)
        .wrapping_add(row.wrapping_mul(668_265_263));
    let mixed = (sum ^ (sum >> 13)).wrapping_mul(1_274_126_177);
    mixed ^ (mixed >> 16)
}

/// A slope with edges, a texture at the right and a smooth part.
fn level(column: usize, row: usize) -> i32 {
    if (21..60).contains(&column) && row > 60 {
        return 100;
    }
    let mut level = 40 + column / 2 + row * row / 160;
    if (column / 23 + row / 17).is_multiple_of(3) {
        level += 60;
    }
    if column > 90 {
        level += (noise(column, row) % 48) as usize;
    }
    level.min(255) as i32
}

fn picture(level: impl Fn(usize, usize) -> i32) -> Plane<u8> {
    Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
        level(column, row).clamp(0, 255) as u8
    })
}

/// The levels in coarse steps, their means over 3 × 3 pixels, noise, and less contrast.
fn distorted() -> [Plane<u8>; 4] {
    [
        picture(|column, row| level(column, row) / 24 * 24 + 12),
        picture(|column, row| {
            let near =
                |place: usize, last: usize| [place.saturating_sub(1), place, (place + 1).min(last)];
            let rows = near(row, SIZE[1] - 1);
            let columns = near(column, SIZE[0] - 1);
            let sum = |row: usize| columns.map(|column| level(column, row)).iter().sum::<i32>();
            rows.map(sum).iter().sum::<i32>() / 9
        }),
        picture(|column, row| level(column, row) + (noise(column + 1000, row) % 31) as i32 - 15),
        picture(|column, row| level(column, row) * 3 / 4 + 50),
    ]
}

/// The truth is what the filter of ffmpeg 5.1.9 printed for Y4M files with these frames:
/// `ffmpeg -i distorted.y4m -i reference.y4m -lavfi '[0:v][1:v]vif,metadata=print:file=-'
/// -f null -`
#[test]
fn the_scales_are_those_of_ffmpeg() {
    let expected = [
        [0.508829, 0.787325, 0.831753, 0.844848],
        [0.274753, 0.953129, 0.984928, 0.992900],
        [0.332858, 0.864134, 0.938439, 0.967184],
        [0.877457, 0.865909, 0.864970, 0.863970],
    ];
    // The sums over all scales, which ffmpeg does not print, by the formula in plain Python.
    let all_scales = [0.5717537836, 0.4239396415, 0.4524092952, 0.8748841334];
    let reference = picture(level);
    let truths = expected.into_iter().zip(all_scales);
    for (distorted, (expected, all_scales)) in distorted().iter().zip(truths) {
        let found = Vif::new(&reference, distorted, 255.0).unwrap();
        for (found, expected) in found.scales.iter().zip(expected) {
            assert!((found - expected).abs() < 2e-5, "{found} {expected}");
        }
        assert!((found.all_scales - all_scales).abs() < 1e-7, "{found:?}");
    }
}

#[test]
fn equal_pictures_have_one_and_a_blank_one_nothing() {
    let reference = picture(level);
    for same in [reference.clone(), reference.map(|_| 7)] {
        let found = Vif::new(&same, &same, 255.0).unwrap();
        assert_eq!((found.scales, found.all_scales), ([1.0; 4], 1.0));
    }
    let blank = Vif::new(&reference, &reference.map(|_| 100), 255.0).unwrap();
    assert_eq!((blank.scales, blank.all_scales), ([0.0; 4], 0.0));
}

/// More contrast is more than the reference gives.
#[test]
fn contrast_counts() {
    let reference = picture(level);
    let enhanced = picture(|column, row| (level(column, row) - 110) * 5 / 4 + 110);
    assert!(Vif::new(&reference, &enhanced, 255.0).unwrap().all_scales > 1.0);
}

#[test]
fn the_range_is_scaled_and_channels_count_together() {
    let (reference, [distorted, ..]) = (picture(level), distorted());
    let expected = Vif::new(&reference, &distorted, 255.0).unwrap();
    let [a, b] = [&reference, &distorted].map(|plane| plane.map(|level| f32::from(level) / 255.0));
    let floats = Vif::new(&a, &b, 1.0).unwrap();
    assert!((floats.all_scales - expected.all_scales).abs() < 2e-5);
    let [a, b] = [&reference, &distorted].map(|plane| plane.map(|level| [level; 3]));
    let channels = Vif::new(&a, &b, 255.0).unwrap();
    assert!((channels.all_scales - expected.all_scales).abs() < 1e-12);
}

#[test]
fn pictures_that_cannot_be_compared_are_refused() {
    let least = Plane::filled(VIF_LEAST_SIDE, VIF_LEAST_SIDE, 3u8);
    let other = least.map(|_| 4);
    assert_eq!(Vif::new(&least, &other, 255.0).unwrap().all_scales, 1.0);
    let small = Plane::filled(VIF_LEAST_SIDE - 1, 40, 3u8);
    let too_small = Vif::new(&small, &small, 255.0);
    assert!(matches!(too_small, Err(PlaneError::TooSmall { .. })));
    let differ = Vif::new(&least, &small, 255.0);
    assert!(matches!(differ, Err(PlaneError::Differs { .. })));
    let range = Vif::new(&least, &other, 0.0);
    assert!(matches!(range, Err(PlaneError::Range { .. })));
    let unknown = Plane::filled(20, 20, f32::NAN);
    assert!(
        Vif::new(&unknown, &unknown, 1.0)
            .unwrap()
            .all_scales
            .is_nan()
    );
}
