//! Delays between the eyes, in clips whose delay is known.

use ga_video::comfort::asynchrony::{Asynchrony, AsynchronyMeter};
use ga_video::{Frame, Samples};

use super::scene::{Random, grey, lattice, texture, walk};

const SIZE: [usize; 2] = [200, 112];

/// What differs between the eyes beside the delay.
#[derive(Clone, Copy, Default)]
struct Differences {
    parallax: f64,
    vertical: f64,
    gain: f64,
    offset: f64,
    noise: f64,
}

impl Differences {
    fn random(random: &mut Random) -> Self {
        Self {
            parallax: random.between(-9.0, 9.0),
            vertical: random.between(-1.0, 1.0),
            gain: random.between(-0.2, 0.2),
            offset: random.between(-15.0, 15.0),
            noise: random.between(0.0, 3.0),
        }
    }
}

/// The delays in a clip whose pictures are given by the frame and a place.
fn delays(
    frames: i32,
    delay: i32,
    differences: Differences,
    level: impl Fn(i32, f64, f64) -> f64,
) -> Vec<Asynchrony> {
    let mut random = Random(99);
    let mut noise = move || differences.noise * random.between(-1.7, 1.7);
    let mut meter = AsynchronyMeter::default();
    let mut found = Vec::new();
    for frame in 0..frames {
        let left = grey(SIZE, |x, y| level(frame, x, y) + noise());
        let right = grey(SIZE, |x, y| {
            let (x, y) = (x + differences.parallax, y + differences.vertical);
            let value = level(frame - delay, x, y) + noise();
            (1.0 + differences.gain) * value + differences.offset
        });
        found.extend(meter.push(&left, &right));
    }
    found.extend(meter.finish());
    assert_eq!(found.len(), frames as usize);
    found
}

/// The number of measured delays, all of which must be right.
fn right(found: &[Asynchrony], delay: i32) -> usize {
    let measured: Vec<f64> = found
        .iter()
        .filter_map(|a| Some(a.delay()?.frames))
        .collect();
    for frames in &measured {
        assert!((frames - f64::from(delay)).abs() < 0.3, "{frames} {delay}");
    }
    measured.len()
}

#[test]
fn delays_of_moving_pictures_are_found() {
    let (mut measured, mut all) = (0, 0);
    for delay in -3..=3 {
        let mut random = Random((40 + delay) as u64);
        let path = walk(&mut random, 60);
        let differences = Differences::random(&mut random);
        let cut = random.between(10.0, 30.0) as i32;
        let found = delays(40, delay, differences, |frame, x, y| {
            let [u, v] = path[(frame + 6) as usize];
            texture(if frame < cut { 5 } else { 6 }, x + u, y + v)
        });
        measured += right(&found, delay);
        all += found.len();
    }
    assert!(5 * measured > 4 * all, "{measured} of {all}");
}

#[test]
fn delays_between_frames_are_found() {
    let motion = |t: f64| [14.0 * (0.21 * t).sin(), 9.0 * (0.33 * t).cos()];
    let mut meter = AsynchronyMeter::default();
    let mut found = Vec::new();
    for frame in 0..50 {
        let view = |time: f64| {
            let [u, v] = motion(time);
            grey(SIZE, |x, y| texture(8, x + u, y + v))
        };
        let time = f64::from(frame);
        found.extend(meter.push(&view(time), &view(time - 0.5)));
    }
    found.extend(meter.finish());
    let measured: Vec<f64> = found
        .iter()
        .filter_map(|a| Some(a.delay()?.frames))
        .collect();
    assert!(measured.len() > 30, "{found:?}");
    for frames in measured {
        assert!((frames - 0.5).abs() < 0.2, "{frames}");
    }
}

#[test]
fn motion_that_shows_no_delay_gives_none() {
    let differences = Differences::default();
    // A still picture, with noise in each eye.
    let noisy = Differences {
        noise: 3.0,
        ..differences
    };
    let still = delays(40, 2, noisy, |_, x, y| texture(1, x, y));
    // The same every five frames.
    let repeated = delays(40, 2, differences, |frame, x, y| {
        let angle = f64::from(frame.rem_euclid(5)) * std::f64::consts::TAU / 5.0;
        texture(2, x + 8.0 * angle.cos(), y + 6.0 * angle.sin())
    });
    // A pan of constant speed: parallax looks like a delay.
    let pan = delays(
        40,
        1,
        Differences {
            parallax: 6.0,
            ..differences
        },
        |frame, x, y| texture(3, x + 2.0 * f64::from(frame), y),
    );
    for found in [still, repeated, pan] {
        assert!(
            found.iter().all(|found| found.delay().is_none()),
            "{found:?}"
        );
    }
}

/// Detail that the reduced pictures cannot show, such as small letters, must not make one delay of
/// many look best.
#[test]
fn constant_motion_of_fine_detail_gives_none() {
    for (velocity, delay, parallax, vertical) in [
        ([2.42, 0.0], -2, 19.8, -0.68),
        ([0.7, 0.0], -1, -4.5, 1.51),
        ([0.35, 0.0], 3, -22.3, -0.38),
        ([0.0, 0.35], 3, -22.3, -0.38),
        ([0.0, 0.9], 1, -0.4, 1.08),
    ] {
        let level = |frame: i32, x: f64, y: f64| {
            let [u, v] = velocity.map(|speed: f64| speed * f64::from(frame));
            128.0 + 90.0 * lattice(3, x + u, y + v)
        };
        let mut meter = AsynchronyMeter::default();
        let mut found = Vec::new();
        for frame in 0..36 {
            // Boxes of this many pixels differ in size.
            let size = [320, 180];
            let left = grey(size, |x, y| level(frame, x, y));
            let right = grey(size, |x, y| {
                level(frame - delay, x + parallax, y + vertical)
            });
            found.extend(meter.push(&left, &right));
        }
        found.extend(meter.finish());
        assert_eq!(right(&found, delay), 0, "{velocity:?} {found:?}");
    }
}

#[test]
fn unrelated_motion_gives_no_delay() {
    let mut random = Random(4);
    let (of_left, of_right) = (walk(&mut random, 40), walk(&mut random, 40));
    let mut meter = AsynchronyMeter::default();
    let mut found = Vec::new();
    for places in of_left.into_iter().zip(of_right) {
        let view = |seed, [u, v]: [f64; 2]| grey(SIZE, |x, y| texture(seed, x + u, y + v));
        let (left, right) = (view(10, places.0), view(11, places.1));
        found.extend(meter.push(&left, &right));
    }
    found.extend(meter.finish());
    assert!(
        found.iter().all(|found| found.delay().is_none()),
        "{found:?}"
    );
}

/// The right eye of a real clip is a part of it, later and moved.
#[test]
fn delays_of_a_real_clip_are_found() {
    let path = "data/vision/clips/bbb_f265-305_320x180_cut285.y4m";
    let Some(path) = nullcone_shared_data::shared(path) else {
        return;
    };
    let mut source = ga_video::open(path).unwrap();
    let (mut frame, mut lumas) = (Frame::default(), Vec::new());
    while source.read(&mut frame).unwrap() {
        lumas.push(frame.samples.eight_bits().luma.clone());
    }
    let (mut measured, mut all) = (0, 0);
    for delay in -3_isize..=3 {
        let mut meter = AsynchronyMeter::default();
        let mut found = Vec::new();
        for index in 3..lumas.len() - 3 {
            let part = |index: usize, left: usize, top: usize, change: fn(u8) -> u8| {
                let part = lumas[index].view().part(left, top, 280, 160).unwrap();
                Samples::Eight(ga_video::Planes {
                    luma: part.map(change),
                    ..Default::default()
                })
            };
            let right = part(index.wrapping_add_signed(-delay), 27, 9, |v| v / 8 * 7 + 9);
            found.extend(meter.push(&part(index, 20, 10, |v| v), &right));
        }
        found.extend(meter.finish());
        measured += right(&found, delay as i32);
        all += found.len();
    }
    assert!(2 * measured > all, "{measured} of {all}");
}
