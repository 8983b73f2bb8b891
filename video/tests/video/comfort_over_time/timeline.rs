//! Rows over time against sums over the frames of each interval.

use std::collections::BTreeMap;

use ga_image::plane::Plane;
use ga_image::y4m::{self, Film, Sampling};
use ga_image::ycbcr::YCbCr;
use ga_video::comfort::asynchrony::Asynchrony;
use ga_video::comfort::monitor::{Options, analyse, observe};
use ga_video::comfort::report::{About, Report};
use ga_video::comfort::stereoscopy::Stereoscopy;
use ga_video::comfort::{
    Dimension, FrameMeasures, Histogram, Missing, Observer, Record, Row, Score, Summary, Timeline,
    Viewing,
};
use ga_video::stereo::{Layout, StereoSource};
use ga_video::y4m::Y4mSource;
use ga_video::{Frame, Properties};
use proptest::prelude::*;

use super::scene::{Random, grey, texture};

/// Measures of frames with parallax of 3, −8 and 12 of 240 pixels, and of a flat one.
fn measures() -> Vec<FrameMeasures> {
    let size = [240, 136];
    let view = |moved: f64| grey(size, move |x, y| texture(5, x + moved, y));
    let flat = grey(size, |_, _| 90.0);
    let mut all: Vec<FrameMeasures> = [3.0, -8.0, 12.0]
        .into_iter()
        .map(|moved| FrameMeasures::of(&view(moved), &view(0.0), YCbCr::default()).unwrap())
        .collect();
    assert!(all.iter().all(|found| found.parallax.is_some()));
    all.push(FrameMeasures::of(&flat, &flat, YCbCr::default()).unwrap());
    all
}

/// Records with random rows. Raw numbers are eighths, whose sums are exact in any order.
fn records(count: usize, rate: [u32; 2], seed: u64, measures: &[FrameMeasures]) -> Vec<Record> {
    let mut random = Random(seed);
    (0..count)
        .map(|frame| Record {
            frame,
            time_seconds: frame as f64 * f64::from(rate[1]) / f64::from(rate[0]),
            begins_shot: frame == 0 || random.bits().is_multiple_of(20),
            run: 0,
            measures: measures[random.bits() as usize % measures.len()].clone(),
            asynchrony: Asynchrony::NoMotion,
            stereoscopy: Stereoscopy::Unknown,
            rows: Dimension::ALL.map(|dimension| match random.bits() % 6 {
                0 => Row::missing(dimension, Missing::Unknown),
                1 => Row::missing(dimension, Missing::NotMeasurable),
                _ => Row {
                    dimension,
                    score: Ok(Score::new((random.bits() % 16) as u8)),
                    raw: Some((random.bits() % 801) as f64 / 8.0 - 50.0),
                },
            }),
        })
        .collect()
}

/// The first number of fifths of a second, of those that are used, by which frames make no more
/// than the most intervals; 0 for single frames.
fn fifths(count: usize, rate: [u32; 2]) -> u64 {
    if count <= Timeline::MOST {
        return 0;
    }
    let groups = |fifths: u64| place(count as u64 - 1, rate, fifths) + 1;
    let mut lengths = vec![1, 5];
    lengths.extend((1..20).map(|k| 5 << k));
    let fits = |fifths: &u64| groups(*fifths) <= Timeline::MOST as u64;
    lengths.into_iter().find(fits).unwrap()
}

/// The interval of a frame, in whole numbers.
fn place(frame: u64, [numerator, denominator]: [u32; 2], fifths: u64) -> u64 {
    5 * frame * u64::from(denominator) / (u64::from(numerator) * fifths)
}

fn check(count: usize, rate: [u32; 2], seed: u64, measures: &[FrameMeasures]) {
    let records = records(count, rate, seed, measures);
    let mut timeline = Timeline::default();
    records.iter().for_each(|record| timeline.add(record));
    let fifths = fifths(count, rate);
    assert_eq!(
        timeline.seconds(),
        (fifths > 0).then(|| fifths as f64 / 5.0)
    );
    let mut groups: BTreeMap<u64, Vec<&Record>> = BTreeMap::new();
    for record in &records {
        let frame = record.frame as u64;
        let place = if fifths == 0 {
            frame
        } else {
            place(frame, rate, fifths)
        };
        groups.entry(place).or_default().push(record);
    }
    assert!(groups.len() <= Timeline::MOST);
    assert_eq!(timeline.intervals().len(), groups.len());
    for (interval, (place, group)) in timeline.intervals().iter().zip(groups) {
        assert_eq!(interval.place, place);
        assert_eq!(interval.first_frame, group[0].frame);
        assert_eq!(interval.start_seconds, group[0].time_seconds);
        assert_eq!(interval.summary.frames, group.len());
        let shots = group.iter().filter(|record| record.begins_shot).count();
        assert_eq!(interval.summary.shots, shots);
        for dimension in Dimension::ALL {
            let row = interval.summary.row(dimension);
            let rows = || group.iter().map(|record| record.row(dimension));
            let missing = |why| rows().filter(|row| row.score == Err(why)).count();
            assert_eq!(row.unknown(), missing(Missing::Unknown));
            assert_eq!(row.not_measurable(), missing(Missing::NotMeasurable));
            let scored: Vec<(u8, f64, usize)> = group
                .iter()
                .filter_map(|record| {
                    let row = record.row(dimension);
                    Some((row.score.ok()?.number(), row.raw?, record.frame))
                })
                .collect();
            assert_eq!(row.scored, scored.len());
            assert_eq!(
                row.scored + row.unknown() + row.not_measurable(),
                group.len()
            );
            let of = |range: std::ops::RangeInclusive<u8>| {
                scored
                    .iter()
                    .filter(|(score, ..)| range.contains(score))
                    .count()
            };
            assert_eq!(row.levels, [of(0..=7), of(8..=13), of(14..=15)]);
            let worst = scored.iter().map(|(score, ..)| *score).max();
            let first = scored.iter().find(|(score, ..)| Some(*score) == worst);
            assert_eq!(row.worst, first.map(|(score, _, frame)| (*score, *frame)));
            let mean = |sum: f64| (!scored.is_empty()).then(|| sum / scored.len() as f64);
            let sum = |number: fn(&(u8, f64, usize)) -> f64| scored.iter().map(number).sum::<f64>();
            assert_eq!(row.mean_score(), mean(sum(|found| found.0.into())));
            assert_eq!(row.mean_raw(), mean(sum(|found| found.1)));
            let raws = || scored.iter().map(|(_, raw, _)| *raw);
            let range = [raws().reduce(f64::min), raws().reduce(f64::max)];
            assert_eq!(
                row.raw_range,
                range[0].zip(range[1]).map(|(low, high)| [low, high])
            );
        }
        let parallaxes: Vec<_> = group
            .iter()
            .filter_map(|record| record.measures.parallax.as_ref())
            .collect();
        let mut counts = [0; Histogram::INTERVALS];
        for parallax in &parallaxes {
            for (count, more) in counts.iter_mut().zip(parallax.histogram.counts()) {
                *count += more;
            }
        }
        assert_eq!(interval.histogram.counts(), &counts);
        let percent = |pixels: f64| 100.0 * pixels / 240.0;
        let near = parallaxes.iter().map(|found| percent(found.near_px));
        let far = parallaxes.iter().map(|found| percent(found.far_px));
        let depth = interval.depth;
        assert_eq!(
            depth.map(|depth| depth.frames),
            (!parallaxes.is_empty()).then_some(parallaxes.len())
        );
        let Some(depth) = depth else { continue };
        assert_eq!(Some(depth.nearest), near.clone().reduce(f64::min));
        assert_eq!(Some(depth.farthest), far.clone().reduce(f64::max));
        let count = parallaxes.len() as f64;
        let median = parallaxes.iter().map(|found| percent(found.median_px));
        let means = [near.sum::<f64>(), median.sum(), far.sum()].map(|sum| sum / count);
        for (found, expected) in depth.means().into_iter().zip(means) {
            assert!((found - expected).abs() < 1e-9, "{found} {expected}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]
    #[test]
    fn intervals_are_sums_over_their_frames(
        count in 1usize..6000,
        rate in prop::sample::select(vec![[24, 1], [25, 1], [30_000, 1001], [60, 1], [7, 3]]),
        seed: u64,
    ) {
        check(count, rate, seed, &measures());
    }
}

#[test]
fn intervals_change_where_there_are_too_many() {
    let measures = measures();
    for count in [1, 8, 480, 481, 2400, 2401, 12_000, 12_001] {
        check(count, [25, 1], 3, &measures[2..]);
    }
}

#[test]
fn a_long_film_has_a_few_hundred_intervals() {
    let pool = records(1000, [24, 1], 1, &[FrameMeasures::default()]);
    let mut timeline = Timeline::default();
    let frames = 3 * 3600 * 24;
    for frame in 0..frames {
        let mut record = pool[frame % pool.len()].clone();
        (record.frame, record.time_seconds) = (frame, frame as f64 / 24.0);
        timeline.add(&record);
    }
    assert_eq!(timeline.seconds(), Some(32.0));
    assert_eq!(timeline.intervals().len(), 338);
    let sum: usize = timeline
        .intervals()
        .iter()
        .map(|found| found.summary.frames)
        .sum();
    assert_eq!(sum, frames);
}

/// Times that are sums of the time of a frame are a little too short, and mean the same.
#[test]
fn rounded_times_belong_to_the_interval_that_they_mean() {
    let pool = records(600, [25, 1], 4, &[FrameMeasures::default()]);
    let (mut timeline, mut seconds) = (Timeline::default(), 0.0);
    for mut record in pool {
        record.time_seconds = seconds;
        seconds += 0.04;
        timeline.add(&record);
    }
    let mut frames = timeline.intervals().iter();
    assert!(frames.all(|found| found.summary.frames == 5));
}

/// Times that jump, or stand still, lose no frame.
#[test]
fn times_need_not_be_regular() {
    let pool = records(1000, [24, 1], 9, &[FrameMeasures::default()]);
    let mut timeline = Timeline::default();
    for (frame, mut record) in pool.into_iter().enumerate() {
        record.time_seconds = [0.0, 1e9, 1e9, f64::MAX][frame * 4 / 1000];
        timeline.add(&record);
    }
    let frames = timeline
        .intervals()
        .iter()
        .map(|found| found.summary.frames);
    assert_eq!(frames.collect::<Vec<_>>(), [250, 500, 250]);
}

/// Checks that frames are measured before their records come, both in order.
#[derive(Default)]
struct Watcher {
    measured: Vec<(usize, FrameMeasures)>,
    complete: Vec<Record>,
}

impl Observer for Watcher {
    fn measured(&mut self, views: &[Frame; 2], measures: &FrameMeasures) {
        assert_eq!(views[0].index, views[1].index);
        self.measured.push((views[0].index, measures.clone()));
    }

    fn complete(&mut self, record: Record) {
        let waiting = self.measured.len() - self.complete.len();
        assert!((1..=32).contains(&waiting), "{waiting} frames wait");
        self.complete.push(record);
    }
}

#[test]
fn an_observer_sees_each_frame_twice() {
    let pictures: Vec<_> = (0..50)
        .map(|frame| {
            let moved = f64::from(frame % 7);
            Plane::from_fn(160, 60, |column, row| {
                let x = (column % 80) as f64 + moved + if column < 80 { 4.0 } else { 0.0 };
                [texture(11, x, row as f64 - moved) as u8; 3]
            })
        })
        .collect();
    let bytes = y4m::encode(&pictures, Film::default()).unwrap();
    let open = || {
        let source = Y4mSource::new(std::io::Cursor::new(bytes.clone()), "clip.y4m").unwrap();
        StereoSource::halves(Box::new(source), Layout::SideBySide).unwrap()
    };
    let options = Options {
        viewing: Viewing::default(),
        layout: None,
        threads: 2,
    };
    let mut watcher = Watcher::default();
    observe(&mut open(), options, &mut watcher).unwrap();
    let mut records = Vec::new();
    analyse(&mut open(), options, |record| records.push(record)).unwrap();
    assert_eq!(watcher.complete, records);
    assert_eq!(watcher.measured.len(), 50);
    for (index, (record, (frame, measures))) in records.iter().zip(&watcher.measured).enumerate() {
        assert_eq!((index, index), (record.frame, *frame));
        assert_eq!(&record.measures, measures);
    }
}

/// Charts have 645 units for all intervals, from 185 on.
#[test]
fn charts_show_where_shots_begin() {
    let viewing = Viewing::default();
    let mut report = Report::new(About {
        title: "clip.y4m".into(),
        align: None,
        shift: String::new(),
        properties: Properties {
            size: [240, 136],
            sampling: Sampling::Quarter,
            bit_depth: 8,
            colours: YCbCr::default(),
            pixel_aspect: [1, 1],
            frames_per_second: Some([25, 1]),
            frame_count: Some(100),
        },
        viewing,
    });
    let mut summary = Summary::default();
    for mut record in records(100, [25, 1], 3, &measures()) {
        record.begins_shot = [0, 30, 70].contains(&record.frame);
        summary.add(&record);
        report.complete(record);
    }
    let page = report.page(&summary, None).unwrap().into_html();
    let dashed = page
        .lines()
        .filter(|line| line.contains("stroke-dasharray=\"4 3\""));
    let mut places: Vec<&str> = dashed.filter_map(|line| line.split('"').nth(1)).collect();
    places.sort_unstable();
    places.dedup();
    assert_eq!(places, ["378.5", "636.5"]);
}
