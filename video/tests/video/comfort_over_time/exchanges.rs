//! Views that are exchanged within a video, at times that are known.

use ga_image::plane::Plane;
use ga_video::comfort::Record;
use ga_video::comfort::stereoscopy::Stereoscopy;
use ga_video::{Frame, Planes, Samples};
use nullcone_shared_data::shared;

use super::monitor::of_frames;
use super::scene::{Random, grey, read, texture, walk};

/// What happens at a frame, to both views or to one of them.
#[derive(Clone, Copy, Debug, Default)]
struct Event {
    exchanges: bool,
    /// Codes that are added to each view from here on.
    brighter: [f64; 2],
    /// Whether each view is blurred from here on.
    blurred: [bool; 2],
}

/// Events at random frames; the first frame may be exchanged already.
fn events(random: &mut Random, count: usize, changes: bool) -> Vec<Event> {
    let mut wait = 0;
    let mut now = Event::default();
    let next = |index: usize| {
        now.exchanges = wait == 0 && (index > 0 || random.bits().is_multiple_of(2));
        if wait == 0 {
            wait = 1 + random.between(0.0, 14.0) as usize;
        }
        wait -= 1;
        if changes && random.bits().is_multiple_of(6) {
            let value = [0, 1].map(|_| random.between(-25.0, 25.0));
            now.brighter = match random.bits() % 3 {
                0 => [value[0]; 2],
                1 => [value[0], 0.0],
                _ => value,
            };
            now.blurred = [0, 1].map(|_| random.bits().is_multiple_of(4));
        }
        now
    };
    (0..count).map(next).collect()
}

/// The records of a video, and whether the views of each frame are exchanged.
fn analysed(
    events: &[Event],
    mut views: impl FnMut(usize) -> [Plane<u8>; 2],
) -> (Vec<Record>, Vec<bool>) {
    let mut exchanged = false;
    let (mut frames, mut truth) = (Vec::new(), Vec::new());
    for (index, event) in events.iter().enumerate() {
        exchanged ^= event.exchanges;
        truth.push(exchanged);
        let mut lumas = views(index);
        if exchanged {
            lumas.swap(0, 1);
        }
        let mut eye = 0;
        frames.push(lumas.map(|luma| {
            let luma = if event.blurred[eye] {
                blurred(&luma)
            } else {
                luma
            };
            let added = event.brighter[eye];
            eye += 1;
            let luma = luma.map(|code| (f64::from(code) + added).round() as u8);
            Frame {
                index,
                time_seconds: index as f64 / 24.0,
                samples: Samples::Eight(Planes {
                    luma,
                    ..Planes::default()
                }),
            }
        }));
    }
    (of_frames(&frames), truth)
}

fn blurred(luma: &Plane<u8>) -> Plane<u8> {
    let last = luma.width() - 1;
    Plane::from_fn(luma.width(), luma.height(), |column, row| {
        let row = luma.row(row);
        let near = column.saturating_sub(2)..=(column + 2).min(last);
        let count = near.clone().count() as u32;
        (near.map(|place| u32::from(row[place])).sum::<u32>() / count) as u8
    })
}

/// How many frames have the right order, none and the wrong one.
fn counts(records: &[Record], truth: &[bool]) -> [usize; 3] {
    let mut counts = [0; 3];
    for (record, exchanged) in records.iter().zip(truth) {
        counts[match (record.stereoscopy, exchanged) {
            (Stereoscopy::InOrder, false) | (Stereoscopy::Exchanged, true) => 0,
            (Stereoscopy::Unknown, _) => 1,
            _ => 2,
        }] += 1;
    }
    counts
}

fn add(sum: &mut [usize; 3], counts: [usize; 3]) {
    for (sum, count) in sum.iter_mut().zip(counts) {
        *sum += count;
    }
}

/// Near squares before a background that moves.
fn made(seed: u64, moved: [f64; 2]) -> [Plane<u8>; 2] {
    [0.0, 1.0].map(|eye| {
        let samples = grey([320, 180], |x, y| {
            let inside = (0..6).find(|square| {
                let [column, row] = [square % 3, square / 3].map(f64::from);
                let left = 25.0 + 105.0 * column - (8.0 + 2.0 * row + column) * eye + moved[0];
                let top = 12.0 + 88.0 * row;
                (left..left + 60.0).contains(&x) && (top..top + 66.0).contains(&y)
            });
            match inside {
                Some(square) => {
                    let near = 8.0 + 2.0 * f64::from(square / 3) + f64::from(square % 3);
                    let seed = seed + 10 + square as u64;
                    30.0 + 0.25 * texture(seed, x - moved[0] + near * eye, y) + 90.0
                }
                None => 30.0 + 0.4 * texture(seed, x - 4.0 * eye + moved[0], y + moved[1]),
            }
        });
        samples.eight_bits().luma.clone()
    })
}

/// To and fro, and up and down.
fn swing(frame: usize) -> [f64; 2] {
    let time = frame as f64;
    [6.0 * (0.3 * time).sin(), 4.0 * (0.21 * time).cos()]
}

#[test]
fn exchanges_of_made_views_are_never_missed() {
    let mut sum = [0; 3];
    for seed in 0..6 {
        let mut random = Random(seed);
        let events = events(&mut random, 40, seed % 2 == 1);
        let (records, truth) = analysed(&events, |frame| made(100 * seed, swing(frame)));
        let found = counts(&records, &truth);
        assert_eq!(found[2], 0, "seed {seed}: {events:?}");
        add(&mut sum, found);
    }
    assert!(sum[0] > sum[1], "{sum:?}");
}

/// The case in which a verdict of the frames before would be wrong: another abrupt change, then
/// the exchange a few frames later.
#[test]
fn an_exchange_right_after_another_change_is_seen() {
    for after in 1..5 {
        let mut events = vec![Event::default(); 24];
        for event in &mut events[10..] {
            event.brighter = [20.0; 2];
        }
        events[10 + after].exchanges = true;
        let (records, truth) = analysed(&events, |frame| made(7, swing(frame)));
        let found = counts(&records, &truth);
        assert_eq!(found[2], 0, "{after}");
        assert!(found[0] >= 20, "{after}: {found:?}");
    }
}

#[test]
fn exchanges_of_real_views_are_never_missed() {
    let pairs = [
        "mb2003_Teddy",
        "mb2005_Art",
        "mb2005_Reindeer",
        "mb2006_Baby1",
        "eth3d_terrace",
    ];
    let mut sum = [0; 3];
    for (seed, name) in pairs.into_iter().enumerate() {
        let eyes = match name {
            "eth3d_terrace" => ["im0.png", "im1.png"],
            _ => ["left.png", "right.png"],
        };
        let file = |eye: &str| shared(&format!("data/vision/stereo/{name}/{eye}"));
        let [Some(left), Some(right)] = eyes.map(file) else {
            return;
        };
        let pair = [left, right].map(|path| read(&path).eight_bits().luma.clone());
        let mut random = Random(50 + seed as u64);
        for changes in [false, true] {
            let events = events(&mut random, 30, changes);
            let (records, truth) = analysed(&events, |frame| {
                let time = frame as f64;
                let place = [
                    8.0 * (1.0 + (0.3 * time).sin()),
                    5.0 * (1.0 + (0.5 * time).cos()),
                ];
                let [left, top] = place.map(|place| place as usize);
                pair.each_ref().map(|luma| {
                    let size = [luma.width(), luma.height()].map(|side| side - 20);
                    let part = luma.view().part(left, top, size[0], size[1]).unwrap();
                    part.map(|code| code)
                })
            });
            let found = counts(&records, &truth);
            assert_eq!(found[2], 0, "{name}: {events:?}");
            add(&mut sum, found);
        }
    }
    assert!(sum[0] > 2 * sum[1], "{sum:?}");
}

/// The right eye is two frames late; after the exchange it is the left one.
#[test]
fn a_delay_changes_its_sign_with_the_exchange() {
    let mut events = vec![Event::default(); 70];
    events[35].exchanges = true;
    let mut random = Random(8);
    let path = walk(&mut random, events.len() + 2);
    let (records, truth) = analysed(&events, |frame| {
        let [left, _] = made(3, path[frame + 2]);
        let [_, right] = made(3, path[frame]);
        [left, right]
    });
    let mut measured = 0;
    for (record, exchanged) in records.iter().zip(truth) {
        if let Some(delay) = record.asynchrony.delay() {
            let expected = if exchanged { -2.0 } else { 2.0 };
            assert!((delay.frames - expected).abs() < 0.3, "{record:?}");
            measured += 1;
        }
    }
    // Without a division at the exchange, fewer are certain.
    assert!(measured > 23, "{measured}");
}

/// The order of the eyes cannot change within a shot without being seen: frames that do not show
/// it, here those of a fade at the beginning, have that of the others.
#[test]
fn undecided_frames_have_the_order_of_their_shot() {
    for (name, exchanged) in [("mb2003_Teddy", true), ("mb2005_Reindeer", false)] {
        let file = |eye: &str| shared(&format!("data/vision/stereo/{name}/{eye}.png"));
        let [Some(left), Some(right)] = ["left", "right"].map(file) else {
            return;
        };
        let pair = [left, right].map(|path| read(&path).eight_bits().luma.clone());
        let mut events = vec![Event::default(); 40];
        events[0].exchanges = exchanged;
        let (records, truth) = analysed(&events, |frame| {
            let contrast = (0.02 * 1.25_f64.powi(frame as i32)).min(1.0);
            let part = (6.0 * (1.0 + (0.4 * frame as f64).sin())) as usize;
            pair.each_ref().map(|luma| {
                let size = [luma.width(), luma.height()].map(|side| side - 14);
                let part = luma.view().part(part, 3, size[0], size[1]).unwrap();
                part.map(|code| (128.0 + contrast * (f64::from(code) - 128.0)).round() as u8)
            })
        });
        assert_eq!(
            records.iter().filter(|record| record.begins_shot).count(),
            1
        );
        assert_eq!(counts(&records, &truth), [40, 0, 0], "{name}");
    }
}
