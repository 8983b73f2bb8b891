//! The order of the eyes, on pairs whose order is known.

use ga_video::comfort::stereoscopy::{Alignment, Stereoscopy, StereoscopyMeter};
use ga_video::{Planes, Samples};
use nullcone_shared_data::shared;

use super::scene::{grey, read, texture};

fn verdict(left: &Samples, right: &Samples) -> Stereoscopy {
    let mut meter = StereoscopyMeter::default();
    meter.add(left, right, &Alignment::default()).unwrap();
    meter.verdict()
}

/// The verdicts on a pair in both orders, the second one as if the views were not exchanged.
fn both(left: &Samples, right: &Samples) -> [Stereoscopy; 2] {
    let opposite = match verdict(right, left) {
        Stereoscopy::InOrder => Stereoscopy::Exchanged,
        Stereoscopy::Exchanged => Stereoscopy::InOrder,
        other => other,
    };
    [verdict(left, right), opposite]
}

fn real_pairs() -> Vec<[Samples; 2]> {
    let pairs = [
        [
            "middlebury/motorcycle_left.png",
            "middlebury/motorcycle_right.png",
        ],
        ["opencv/aloeL.jpg", "opencv/aloeR.jpg"],
        [
            "stereo/mb2001_venus/left.png",
            "stereo/mb2001_venus/right.png",
        ],
        [
            "stereo/mb2003_Teddy/left.png",
            "stereo/mb2003_Teddy/right.png",
        ],
        ["stereo/mb2005_Art/left.png", "stereo/mb2005_Art/right.png"],
        [
            "stereo/mb2005_Reindeer/left.png",
            "stereo/mb2005_Reindeer/right.png",
        ],
        [
            "stereo/mb2006_Baby1/left.png",
            "stereo/mb2006_Baby1/right.png",
        ],
        [
            "stereo/mb2006_Midd1/left.png",
            "stereo/mb2006_Midd1/right.png",
        ],
        [
            "stereo/mb2006_Wood1/left.png",
            "stereo/mb2006_Wood1/right.png",
        ],
        [
            "stereo/eth3d_terrace/im0.png",
            "stereo/eth3d_terrace/im1.png",
        ],
    ];
    let file = |name: &str| Some(read(&shared(&format!("data/vision/{name}"))?));
    let pair = |[left, right]: [&str; 2]| Some([file(left)?, file(right)?]);
    pairs.into_iter().filter_map(pair).collect()
}

#[test]
fn real_pairs_are_in_order() {
    let pairs = real_pairs();
    let mut decided = 0;
    for [left, right] in &pairs {
        for found in both(left, right) {
            assert!(matches!(found, Stereoscopy::InOrder | Stereoscopy::Unknown));
            decided += usize::from(found == Stereoscopy::InOrder);
        }
    }
    assert!(10 * decided >= 18 * pairs.len(), "{decided}");
}

/// Noise, another exposure, or a wrong height must not turn the eyes around.
#[test]
fn degraded_pairs_are_never_taken_for_exchanged_ones() {
    let pairs = real_pairs();
    let mut decided = 0;
    for (index, [left, right]) in pairs.iter().enumerate() {
        let changed = |samples: &Samples, change: &dyn Fn(usize, usize, u8) -> u8| {
            let planes = samples.eight_bits();
            let mut luma = planes.luma.clone();
            let width = luma.width();
            for (place, value) in luma.values_mut().iter_mut().enumerate() {
                *value = change(place % width, place / width, *value);
            }
            let differences = planes.differences.clone();
            Samples::Eight(Planes { luma, differences })
        };
        let right = match index % 3 {
            0 => changed(right, &|_, _, v| (f64::from(v) * 0.75 + 12.0) as u8),
            1 => {
                let source = right.eight_bits().luma.clone();
                let last = source.height() - 1;
                changed(right, &|u, v, _| source.row((v + 1).min(last))[u])
            }
            _ => changed(right, &|u, v, level| {
                let noise = (u * 7919 + v * 104_729 + u * v * 31) % 23;
                (i32::from(level) + noise as i32 - 11).clamp(0, 255) as u8
            }),
        };
        for found in both(left, &right) {
            assert!(matches!(found, Stereoscopy::InOrder | Stereoscopy::Unknown));
            decided += usize::from(found == Stereoscopy::InOrder);
        }
    }
    assert!(decided >= pairs.len(), "{decided}");
}

#[test]
fn pairs_of_the_oracle() {
    let read_pair = |index: usize| {
        let file = |eye| {
            let path = shared(&format!("oracle/vision/seed1/c{index}_{eye}.png"))?;
            Some(read(&path))
        };
        Some([file('L')?, file('R')?])
    };
    let Some([left, right]) = read_pair(24) else {
        return;
    };
    assert_eq!(both(&left, &right), [Stereoscopy::InOrder; 2]);
    let [left, right] = read_pair(25).unwrap();
    assert_eq!(both(&left, &right), [Stereoscopy::Exchanged; 2]);
    let [left, right] = read_pair(0).unwrap();
    assert_eq!(verdict(&left, &right), Stereoscopy::Identical);
    // Planes have no half-occlusions.
    for index in [1, 2, 3, 4, 5, 6, 8, 12, 16, 19, 21, 22] {
        let [left, right] = read_pair(index).unwrap();
        assert_eq!(verdict(&left, &right), Stereoscopy::Unknown, "{index}");
    }
}

#[test]
fn a_vertical_error_is_removed_first() {
    let Some([left, right]) = real_pairs().into_iter().next() else {
        return;
    };
    let planes = right.eight_bits();
    let lower = |samples: &ga_image::plane::Plane<u8>| {
        ga_image::plane::Plane::from_fn(samples.width(), samples.height(), |column, row| {
            samples.row(row.saturating_sub(6))[column]
        })
    };
    let [cb, cr] = planes.differences.each_ref().map(lower);
    let right = Samples::Eight(Planes {
        luma: lower(&planes.luma),
        differences: [cb, cr],
    });
    let alignment = Alignment {
        shift_px: 6.0,
        ..Alignment::default()
    };
    let mut meter = StereoscopyMeter::default();
    meter.add(&left, &right, &alignment).unwrap();
    assert_eq!(meter.verdict(), Stereoscopy::InOrder);
}

#[test]
fn unrelated_and_flat_views() {
    let size = [320, 180];
    let view = |seed| grey(size, |x, y| texture(seed, x, y));
    let flat = grey(size, |_, _| 90.0);
    assert_eq!(verdict(&view(1), &view(2)), Stereoscopy::Unrelated);
    assert_eq!(verdict(&view(1), &flat), Stereoscopy::Unrelated);
    assert_eq!(verdict(&view(1), &view(1)), Stereoscopy::Identical);
    assert_eq!(verdict(&flat, &flat), Stereoscopy::Unknown);
    let tiny = grey([20, 12], |x, y| texture(1, x, y));
    assert_eq!(verdict(&tiny, &tiny), Stereoscopy::Unknown);
    assert_eq!(StereoscopyMeter::default().verdict(), Stereoscopy::Unknown);
}
