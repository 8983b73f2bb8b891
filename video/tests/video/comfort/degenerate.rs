//! Views in which nothing can be measured, and views of unusual kinds.

use ga_image::plane::Plane;
use ga_image::ycbcr::YCbCr;
use ga_video::comfort::{Dimension, FrameMeasures, FrameMeter, Missing, Viewing};
use ga_video::{Planes, Samples};

use super::inputs::{PAIRS, measures, pair, samples};

fn grey(size: [usize; 2], level: impl Fn(usize, usize) -> u8) -> Samples {
    Samples::Eight(Planes {
        luma: Plane::from_fn(size[0], size[1], level),
        ..Planes::default()
    })
}

fn is_not_measurable(found: &FrameMeasures) {
    assert!(
        found.matches.is_empty() && found.geometry.is_none(),
        "{found:?}"
    );
    for dimension in Dimension::ALL {
        if let Some(row) = found.row(dimension, &Viewing::default()) {
            assert_eq!((row.score, row.raw), (Err(Missing::NotMeasurable), None));
        }
    }
}

/// White noise, different for each seed.
fn noise(seed: u32) -> impl Fn(usize, usize) -> u8 {
    move |column, row| {
        let mut x = (column as u32)
            .wrapping_mul(0x9e37_79b1)
            .wrapping_add((row as u32).wrapping_mul(0x85eb_ca77))
            .wrapping_add(seed.wrapping_mul(0xc2b2_ae3d));
        for _ in 0..3 {
            x = (x ^ (x >> 15)).wrapping_mul(0x2c1b_3c6d);
        }
        (x >> 24) as u8
    }
}

#[test]
fn flat_views_and_ramps_are_not_measurable() {
    let colours = YCbCr::default();
    for size in [[480, 270], [1920, 1080]] {
        let flat = grey(size, |_, _| 16);
        let ramp = grey(size, |column, _| (column * 255 / size[0]) as u8);
        let stripes = grey(size, |column, _| if column % 40 < 20 { 50 } else { 180 });
        for view in [&flat, &ramp, &stripes] {
            is_not_measurable(&FrameMeasures::of(view, view, colours).unwrap());
        }
    }
}

#[test]
fn a_pattern_that_repeats_itself_is_not_measurable() {
    let squares = grey([640, 360], |column, row| {
        if (column / 16 + row / 16) % 2 == 0 {
            40
        } else {
            200
        }
    });
    let found = FrameMeasures::of(&squares, &squares, YCbCr::default()).unwrap();
    is_not_measurable(&found);
}

#[test]
fn views_of_different_scenes_are_not_measurable() {
    let size = [400, 350];
    let [a, b] = [1, 2].map(|seed| grey(size, noise(seed)));
    is_not_measurable(&FrameMeasures::of(&a, &b, YCbCr::default()).unwrap());
    let pairs: Option<Vec<_>> = PAIRS.into_iter().map(pair).collect();
    let Some(pairs) = pairs else { return };
    for (first, second) in [
        (0, 1),
        (2, 3),
        (4, 5),
        (6, 7),
        (8, 9),
        (3, 6),
        (9, 1),
        (5, 2),
    ] {
        let cut = |picture: &Plane<[f32; 3]>| {
            Plane::from_fn(size[0], size[1], |c, r| picture.get(c, r).unwrap())
        };
        is_not_measurable(&measures(&cut(&pairs[first][0]), &cut(&pairs[second][1])));
    }
}

#[test]
fn views_of_any_size_are_answered() {
    let colours = YCbCr::default();
    for size in [
        [0, 0],
        [1, 1],
        [3, 400],
        [400, 3],
        [9, 9],
        [11, 11],
        [17, 12],
    ] {
        let view = grey(size, noise(3));
        is_not_measurable(&FrameMeasures::of(&view, &view, colours).unwrap());
    }
    // Widths around those at which the reduction changes.
    for width in [319, 320, 321, 640, 641] {
        let view = grey([width, 181], |column, row| noise(4)(column / 5, row / 5));
        let found = FrameMeasures::of(&view, &view, colours).unwrap();
        assert!(found.geometry.unwrap().deviation_px < 0.01, "{width}");
        assert!(found.parallax.unwrap().median_px.abs() < 0.01, "{width}");
    }
}

#[test]
fn views_of_different_size_are_an_error() {
    let [a, b] = [[64, 48], [64, 49]].map(|size| grey(size, noise(5)));
    assert!(FrameMeasures::of(&a, &b, YCbCr::default()).is_err());
    let mut meter = FrameMeter::new([64, 48], YCbCr::default());
    assert!(meter.measure(&b, &b).is_err());
    assert!(meter.measure(&a, &a).is_ok());
}

#[test]
fn ten_bits_have_the_measures_of_eight() {
    let Some([left, right]) = pair(PAIRS[0]) else {
        return;
    };
    let eight = [samples(&left), samples(&right)];
    let ten = eight.each_ref().map(|samples| {
        let planes = samples.eight_bits();
        let four = |plane: &Plane<u8>| plane.map(|code| 4 * u16::from(code));
        Samples::Ten(Planes {
            luma: four(&planes.luma),
            differences: planes.differences.each_ref().map(four),
        })
    });
    let colours = YCbCr::default();
    let [eight, ten] = [eight, ten].map(|[l, r]| FrameMeasures::of(&l, &r, colours).unwrap());
    assert!(eight.matches.len() > 100);
    assert_eq!(eight, ten);
}

/// A meter that has measured other frames gives what a new one gives.
#[test]
fn frames_do_not_depend_on_each_other() {
    let Some([left, right]) = pair(PAIRS[2]) else {
        return;
    };
    let [left, right] = [samples(&left), samples(&right)];
    let colours = YCbCr::default();
    let mut meter = FrameMeter::new(left.size(), colours);
    let first = meter.measure(&left, &right).unwrap().clone();
    let flat = grey(left.size(), |_, _| 90);
    is_not_measurable(meter.measure(&left, &flat).unwrap());
    meter.measure(&right, &left).unwrap();
    assert_eq!(*meter.measure(&left, &right).unwrap(), first);
    assert_eq!(FrameMeasures::of(&left, &right, colours).unwrap(), first);
}
