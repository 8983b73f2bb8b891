//! Cuts, dissolves, fades and key frames of clips whose labels are known.

mod clips;
mod light;
mod parts;
mod reading;
mod selection;
mod splices;

use std::ops::Range;

use ga_image::plane::Plane;
use ga_image::ycbcr::{self, YCbCr};
use ga_video::keyframe::colour::Colour;
use ga_video::keyframe::evaluation::{Score, score};
use ga_video::keyframe::flash::{Flash, Kind};
use ga_video::keyframe::{Analyser, Analysis, Background, Options, Reason};
use ga_video::{Frame, Planes, Samples, VideoError};
use nullcone_shared_data::shared;
use serde_json::Value;

use clips::{Base, Clip, Effect, Joins, SIZE, base, clip};
use splices::Material;

/// Analyses frames of grey, whose luma is red.
fn analysed(frames: &[Plane<u8>], frames_per_second: f64, options: Options) -> Analysis {
    let colours = YCbCr {
        range: ycbcr::Range::Full,
        ..YCbCr::default()
    };
    let mut analyser = Analyser::new(options, colours);
    for (index, luma) in frames.iter().enumerate() {
        let samples = Samples::Eight(Planes {
            luma: luma.clone(),
            ..Planes::default()
        });
        let time_seconds = index as f64 / frames_per_second;
        let frame = Frame {
            index,
            time_seconds,
            samples,
        };
        analyser.push(&frame).unwrap();
    }
    analyser.finish()
}

fn of_clip(clip: &Clip) -> Analysis {
    analysed(&clip.frames, 25.0, Options::default())
}

fn overlap(a: &Range<usize>, b: &Range<usize>) -> bool {
    a.start < b.end && b.start < a.end
}

fn dissolves(found: &Analysis) -> Vec<Range<usize>> {
    let dissolves = found.transitions.dissolves.iter();
    dissolves.map(|dissolve| dissolve.frames.clone()).collect()
}

fn fades(found: &Analysis) -> Vec<Range<usize>> {
    let fades = found.transitions.fades.iter();
    fades.map(|fade| fade.frames.clone()).collect()
}

/// Found intervals that overlap a label, those that do not, and labels without any.
fn intervals(found: &[Range<usize>], labels: &[Range<usize>]) -> Score {
    let hit = |label: &&Range<usize>| found.iter().any(|frames| overlap(frames, label));
    let correct = labels.iter().filter(hit).count();
    let right = |frames: &&Range<usize>| labels.iter().any(|label| overlap(frames, label));
    Score {
        correct,
        extra: found.len() - found.iter().filter(right).count(),
        missed: labels.len() - correct,
    }
}

fn sum(scores: impl Iterator<Item = Score>) -> Score {
    scores.fold(Score::default(), |a, b| Score {
        correct: a.correct + b.correct,
        extra: a.extra + b.extra,
        missed: a.missed + b.missed,
    })
}

/// The seeds of the clips of each kind; the variable says how many, for a longer run.
fn seeds() -> impl Iterator<Item = u64> {
    let count = std::env::var("NULLCONE_CLIPS").ok();
    let count = count.and_then(|count| count.parse().ok()).unwrap_or(4);
    (0..count).map(|number: u64| 7919 * number + 13)
}

/// Cuts, dissolves and fades of clips with an effect, against their labels.
fn scores(bases: &[Base], effect: Effect) -> [Score; 3] {
    let all = bases.iter().map(|base| {
        let Clip { frames, labels } = base.with(effect);
        let found = analysed(&frames, 25.0, Options::default());
        [
            score(&found.transitions.cuts, &labels.cuts, 0),
            intervals(&dissolves(&found), &labels.dissolves),
            intervals(&fades(&found), &labels.fades),
        ]
    });
    let all: Vec<[Score; 3]> = all.collect();
    let scores = [0, 1, 2].map(|kind| sum(all.iter().map(|scores| scores[kind])));
    println!("{effect:?}: {scores:?}");
    scores
}

#[test]
fn cuts_are_found_in_clips_of_every_kind() {
    let bases: Vec<Base> = seeds().map(|seed| base(seed, Joins::Cuts)).collect();
    for effect in Effect::ALL {
        let [cuts, dissolves, fades] = scores(&bases, effect);
        let total = sum([cuts, dissolves, fades].into_iter());
        // A box that stands over all shots makes the frames more alike.
        let least = if effect == Effect::Banner { 0.8 } else { 0.93 };
        assert!(total.f1().unwrap() > least, "{effect:?}: {total:?}");
    }
}

#[test]
fn dissolves_are_reported_as_such_in_clips_of_every_kind() {
    let bases: Vec<Base> = seeds().map(|seed| base(seed, Joins::Dissolves)).collect();
    for effect in Effect::ALL {
        let total = sum(scores(&bases, effect).into_iter());
        // A flash near an end of a dissolve hides it, and a box makes the shots more alike.
        let least = match effect {
            Effect::Banner | Effect::Flashes => 0.6,
            _ => 0.8,
        };
        assert!(total.f1().unwrap() > least, "{effect:?}: {total:?}");
    }
}

#[test]
fn fades_are_reported_as_such_in_clips_of_every_kind() {
    let bases: Vec<Base> = seeds().map(|seed| base(seed, Joins::Fades)).collect();
    // Noise of pictures as small as these is not small in their signatures either.
    let effects = Effect::ALL.into_iter();
    for effect in effects.filter(|effect| *effect != Effect::Noise) {
        let total = sum(scores(&bases, effect).into_iter());
        assert!(total.f1().unwrap() > 0.85, "{effect:?}: {total:?}");
    }
}

/// Clips with cameras that move fast over their scenes: what they show at the ends of a second has
/// nothing in common, as at the ends of a dissolve.
#[test]
fn a_moving_camera_is_not_a_dissolve() {
    for seed in [314_264, 418_993, 837_909] {
        let found = of_clip(&clip(seed, Joins::Cuts, Effect::None));
        assert_eq!(dissolves(&found), vec![], "{seed}");
    }
}

/// A frame in which the picture fills a third.
#[test]
fn fades_are_found_between_wide_bars() {
    let scores = seeds().map(|seed| {
        let Clip { frames, labels } = clip(seed, Joins::Fades, Effect::None);
        let barred = frames.iter().map(|frame| {
            Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
                let inside = (25..135).contains(&column) && (22..68).contains(&row);
                frame.get(column, row).filter(|_| inside).unwrap_or(0)
            })
        });
        let found = analysed(&barred.collect::<Vec<_>>(), 25.0, Options::default());
        intervals(&fades(&found), &labels.fades)
    });
    let total = sum(scores);
    assert!(total.f1().unwrap() > 0.9, "{total:?}");
}

/// The contrast rises as steadily as in a fade.
#[test]
fn a_camera_that_comes_from_an_even_sky_is_not_a_fade() {
    for seed in seeds() {
        let scene = &clip(seed, Joins::Cuts, Effect::None).frames[0];
        for speed in [6, 8, 11] {
            let frames = (0..90usize).map(|time| {
                let left = SIZE[0].saturating_sub(speed * time.saturating_sub(20));
                Plane::from_fn(SIZE[0], SIZE[1], |column, row| {
                    let column = column.checked_sub(left);
                    column.map_or(120, |column| scene.get(column, row).unwrap())
                })
            });
            let found = analysed(&frames.collect::<Vec<_>>(), 25.0, Options::default());
            assert_eq!(fades(&found), vec![], "{seed} {speed}");
        }
    }
}

/// Photographs under a moving camera, and shots of a film. No setting was measured on them.
#[test]
fn transitions_between_real_pictures_are_found() {
    let Some(material) = Material::read() else {
        return;
    };
    let bases: Vec<Base> = seeds().map(|seed| material.splice(3 * seed)).collect();
    for effect in [
        Effect::None,
        Effect::Letterbox,
        Effect::Captions,
        Effect::Flicker,
        Effect::Dark,
        Effect::HalfRate,
    ] {
        let [cuts, dissolves, fades] = scores(&bases, effect);
        assert!(cuts.f1().unwrap() > 0.95, "{effect:?}: cuts {cuts:?}");
        for (name, found) in [("dissolves", dissolves), ("fades", fades)] {
            assert!(found.f1().unwrap() > 0.8, "{effect:?}: {name} {found:?}");
        }
    }
}

#[test]
fn shots_cover_the_clip_and_key_frames_are_clear() {
    for seed in seeds() {
        for joins in [Joins::Cuts, Joins::Dissolves, Joins::Fades] {
            let clip = clip(seed, joins, Effect::None);
            let found = of_clip(&clip);
            let mut next = 0;
            for shot in &found.shots {
                assert_eq!(shot.frames.start, next);
                assert!(shot.frames.end > shot.frames.start);
                next = shot.frames.end;
            }
            assert_eq!(next, clip.frames.len());
            assert!(!found.key_frames.is_empty());
            for key in &found.key_frames {
                assert!(found.transitions.is_clear(key.index), "{key:?}");
                let luma = clip.frames[key.index].values();
                let mean = luma.iter().map(|v| f64::from(*v)).sum::<f64>() / luma.len() as f64;
                assert!(mean > 12.0, "{key:?} is nearly black");
                assert!((0.0..=1.0).contains(&key.score));
            }
            let indices = found.key_frames.iter().map(|key| key.index);
            assert!(indices.is_sorted_by(|a, b| a < b));
        }
    }
}

#[test]
fn the_cuts_and_the_dissolve_of_the_oracle_are_exact() {
    let Some(folder) = shared("oracle/vision/seed1") else {
        return;
    };
    let truth = std::fs::read(folder.join("truth.json")).unwrap();
    let truth: Value = serde_json::from_slice(&truth).unwrap();
    let frames = |name: &str| -> Vec<usize> {
        let list = truth["cuts"][name].as_array().unwrap().iter();
        list.map(|frame| frame.as_u64().unwrap() as usize).collect()
    };
    let found = of_file(&folder.join("cuts.y4m"));
    assert_eq!(found.transitions.cuts, frames("hard"));
    let dissolve = frames("dissolve");
    assert_eq!(dissolves(&found), vec![dissolve[0]..dissolve[1]; 1]);
    assert!(found.transitions.fades.is_empty());
}

/// A film of the cases, where it can be read.
fn of_case(name: &str) -> Option<Analysis> {
    let path = shared("cases/video")?.join(name);
    match ga_video::open(&path) {
        Err(VideoError::NeedsFfmpeg { .. } | VideoError::Ffmpeg { .. }) => None,
        _ => Some(of_file(&path)),
    }
}

#[test]
fn a_dissolve_from_a_dark_picture_to_a_bright_one_is_found() {
    let Some(found) = of_case("dissolve-missed/nasa60_195.mp4") else {
        return;
    };
    let [frames] = &dissolves(&found)[..] else {
        panic!("{:?}", found.transitions);
    };
    assert!(
        frames.start.abs_diff(67) <= 2 && frames.end.abs_diff(92) <= 2,
        "{frames:?}"
    );
    assert!(found.transitions.cuts.is_empty() && found.transitions.fades.is_empty());
    let keys: Vec<usize> = found.key_frames.iter().map(|key| key.index).collect();
    assert!(keys.iter().all(|key| !frames.contains(key)), "{keys:?}");
    assert!(keys.iter().any(|key| *key >= frames.end), "{keys:?}");
}

#[test]
fn a_fade_has_its_colour() {
    let Some(found) = of_case("fade-dark-white/darkred.mp4") else {
        return;
    };
    assert_eq!(fades(&found).len(), 2);
    for fade in &found.transitions.fades {
        let Colour::Other([red, green, blue]) = fade.colour else {
            panic!("{fade:?}");
        };
        // Red of 70, as 4:2:0 of 8 bits keeps it.
        assert!(red.abs_diff(70) <= 3 && green <= 3 && blue <= 3, "{fade:?}");
    }
}

#[test]
fn stray_frames_of_an_edit_are_reported() {
    let Some(found) = of_case("flash-frame/sub.mp4") else {
        return;
    };
    assert_eq!(found.transitions.cuts, [30, 31, 61, 63]);
    let expected = [30..31, 61..63].map(|frames| Flash {
        frames,
        kind: Kind::StrayShot,
    });
    assert_eq!(found.transitions.flashes, expected);
}

#[test]
fn a_hand_that_leaves_a_table_is_no_cut() {
    if let Some(found) = of_case("false-cut-occluder/hand.mp4") {
        assert_eq!(found.shots.len(), 1, "{:?}", found.transitions);
    }
}

fn of_file(path: &std::path::Path) -> Analysis {
    let mut source = ga_video::open(path).unwrap();
    let mut analyser = Analyser::new(Options::default(), source.properties().colours);
    let mut frame = Frame::default();
    while source.read(&mut frame).unwrap() {
        analyser.push(&frame).unwrap();
    }
    analyser.finish()
}

#[test]
fn the_cut_of_a_real_clip_is_exact() {
    let path = "data/vision/clips/bbb_f265-305_320x180_cut285.y4m";
    let Some(path) = shared(path) else {
        return;
    };
    let found = of_file(&path);
    assert_eq!(found.transitions.cuts, [20]);
    assert!(found.transitions.dissolves.is_empty() && found.transitions.fades.is_empty());
    assert_eq!(found.shots[1].background, Background::Static);
    let first = found.key_frames.iter();
    let first = first.filter(|key| key.reason == Reason::Shot);
    assert_eq!(first.map(|key| key.index).collect::<Vec<_>>(), [0, 20]);
}

#[test]
fn a_budget_and_a_least_shot_are_kept() {
    let clip = clip(7, Joins::Cuts, Effect::None);
    let all = of_clip(&clip);
    let options = Options {
        budget: Some(1),
        minimum_shot: 10_000,
        ..Options::default()
    };
    let found = analysed(&clip.frames, 25.0, options);
    assert!(all.shots.len() > 1);
    assert_eq!(found.shots.len(), 1);
    assert!(found.transitions.cuts.is_empty());
    assert_eq!(found.key_frames.len(), 1);
}
