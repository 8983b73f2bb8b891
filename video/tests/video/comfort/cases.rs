//! Films in which comfort was misjudged once.

use ga_image::plane::Plane;
use ga_video::comfort::align::{Correction, Corrector, Plan};
use ga_video::comfort::monitor::{Options, observe};
use ga_video::comfort::report::{self, About, Report};
use ga_video::comfort::{
    ComfortError, Dimension, FrameMeasures, FrameMeter, Level, Observer, Record, Summary, Viewing,
    comfortable_shift,
};
use ga_video::stereo::{Layout, StereoSource};
use ga_video::{Frame, Samples};
use nullcone_shared_data::shared;

use super::inputs::{COLOURS, Motion, PAIRS, Picture, level, measures, moved, pair, samples};

fn open(case: &str, layout: Layout) -> Option<StereoSource> {
    let source = ga_video::open(shared(&format!("cases/video/{case}"))?).unwrap();
    Some(StereoSource::halves(source, layout).unwrap())
}

/// What all frames of a film show, and the page on it.
fn analysed(source: &mut StereoSource, layout: Layout) -> (Vec<Record>, Summary, String) {
    let viewing = Viewing::default();
    let options = Options {
        viewing,
        layout: Some(layout),
        threads: 2,
    };
    let mut report = Report::new(About {
        title: "film".into(),
        align: Some("align".into()),
        shift: "--shift-parallax recommended".into(),
        properties: *source.properties(),
        viewing,
    });
    struct Both<'a>(&'a mut Report, Vec<Record>);
    impl Observer for Both<'_> {
        fn measured(&mut self, views: &[Frame; 2], measures: &FrameMeasures) {
            self.0.measured(views, measures);
        }

        fn complete(&mut self, record: Record) {
            self.1.push(record.clone());
            self.0.complete(record);
        }
    }
    let mut both = Both(&mut report, Vec::new());
    observe(source, options, &mut both).unwrap();
    let records = both.1;
    let mut summary = Summary::default();
    records.iter().for_each(|record| summary.add(record));
    let page = report.page(&summary, None).unwrap().into_html();
    (records, summary, page)
}

fn planned(case: &str, layout: Layout) -> Option<(Plan, Vec<[Samples; 2]>)> {
    let mut source = open(case, layout)?;
    let again = || Ok(open(case, layout).unwrap());
    let plan = Plan::of(again, Some(layout), 2, |_, _| {}).unwrap();
    let mut views = Vec::new();
    plan.apply(&mut source, |pair| {
        views.push(pair.map(|frame| frame.samples.clone()));
        Ok::<(), ComfortError>(())
    })
    .unwrap();
    Some((plan, views))
}

/// A film of which no frame shows the order of the eyes: that is said in words.
#[test]
fn an_order_that_is_not_known_is_said_in_words() {
    for (case, frames) in [("swapped36.mp4", 36), ("swapped.mp4", 8)] {
        let case = format!("align-swap-frame/{case}");
        let layout = Layout::SideBySide;
        let Some(mut source) = open(&case, layout) else {
            return;
        };
        let (_, summary, page) = analysed(&mut source, layout);
        assert_eq!(summary.undecided.frames(), frames, "{case}");
        let words = format!(
            "The order of the eyes could not be decided in frames 0 to {}",
            frames - 1
        );
        assert!(
            report::notes(&summary)[0].starts_with(&words),
            "{:?}",
            report::notes(&summary)
        );
        assert!(page.contains(&words));
        assert!(
            summary
                .json(&Viewing::default())
                .to_string()
                .contains(&words)
        );
        let (plan, _) = planned(&case, layout).unwrap();
        assert_eq!(
            (plan.exchanged_frames(), plan.undecided().frames()),
            (0, frames)
        );
    }
}

/// Truth: all disparities are crossed, from 12 to 160 pixels. A few confused points of repeated
/// textures seem to be far behind the screen.
#[test]
fn confused_points_do_not_pass_a_limit() {
    let layout = Layout::SideBySide;
    let Some(mut source) = open("false-divergence/laundry_rot1.mp4", layout) else {
        return;
    };
    let (records, _, _) = analysed(&mut source, layout);
    let row = records[0].row(Dimension::OverDivergence);
    assert_eq!(row.score.unwrap().number(), 0, "{row:?}");
    let parallax = records[0].measures.parallax.as_ref().unwrap();
    // A turn of one degree moves points by 6.3 pixels at most.
    assert!((-166.3..-100.0).contains(&parallax.near_px), "{parallax:?}");
    assert!((-90.0..-5.7).contains(&parallax.far_px), "{parallax:?}");
}

/// All points of clean pairs are moved behind the screen, or in front of it, by a known amount.
#[test]
fn true_divergence_and_convergence_are_found() {
    for paths in PAIRS {
        let Some([left, right]) = pair(paths) else {
            return;
        };
        let usual = measures(&left, &right).parallax.unwrap();
        for (percent, dimension) in [
            (6.0, Dimension::OverDivergence),
            (-6.0, Dimension::OverConvergence),
        ] {
            // The median comes to this percentage.
            let pixels = 0.01 * percent * left.width() as f64 - usual.median_px;
            let motion = Motion {
                right: pixels,
                ..Motion::default()
            };
            let found = measures(&left, &moved(&right, motion));
            assert_eq!(level(&found, dimension), Level::Red, "{paths:?} {percent}");
            let moved = found.parallax.unwrap();
            assert!(
                (moved.median_px - usual.median_px - pixels).abs() < 3.0,
                "{paths:?}"
            );
        }
    }
}

/// A part of a picture that is truly far behind the screen is found, though it is small.
#[test]
fn a_small_far_surface_is_found() {
    let Some([left, right]) = pair(PAIRS[4]) else {
        return;
    };
    let [width, height] = [left.width() as f64, left.height() as f64];
    let far = (0.1 * width) as i64;
    let inside = |column: usize, row: usize| {
        (0.3..0.55).contains(&(column as f64 / width))
            && (0.3..0.6).contains(&(row as f64 / height))
    };
    // The same texture in both, 10 % of the width apart.
    let paste = |picture: &Picture, parallax: i64| {
        Plane::from_fn(left.width(), left.height(), |column, row| {
            let place = (column as i64 - parallax).max(0) as usize;
            match inside(place, row) {
                true => left.row(left.height() - 1 - row)[place],
                false => picture.row(row)[column],
            }
        })
    };
    let found = measures(&paste(&left, 0), &paste(&right, far));
    assert_eq!(
        level(&found, Dimension::OverDivergence),
        Level::Red,
        "{:?}",
        found.parallax
    );
}

/// The right eye is two frames late: the vertical differences and jumps of depth follow from that.
#[test]
fn a_delay_is_listed_before_what_follows_from_it() {
    let (case, layout) = ("delay-read-as-vertical/late2.mp4", Layout::SideBySide);
    let Some(mut source) = open(case, layout) else {
        return;
    };
    let (_, summary, page) = analysed(&mut source, layout);
    assert_eq!(summary.shots, 1);
    for dimension in [Dimension::Vertical, Dimension::ParallaxDeviation] {
        assert!(summary.row(dimension).levels[2] > 0, "{dimension:?}");
    }
    let (_, list) = page.split_once("What to mend, in this order").unwrap();
    let (list, _) = list.split_once("</ol>").unwrap();
    let items: Vec<&str> = list.split("<li>").skip(1).collect();
    assert!(items[0].contains("Delay of one eye"), "{items:?}");
    for name in ["Vertical misalignment", "Jumps of depth"] {
        let item = items.iter().find(|item| item.contains(name)).unwrap();
        assert!(
            item.contains("It may follow from the delay of one eye"),
            "{item}"
        );
    }
    assert!(!items[0].contains("It may follow"), "{items:?}");
    // There is one shot, so that no cut can be changed.
    assert!(
        !list.contains("cut") && !list.contains("one of the shots"),
        "{list}"
    );
    assert!(page.contains("Mend first: delay of one eye"));

    let (plan, views) = planned(case, layout).unwrap();
    assert_eq!(plan.delay().frames, 2);
    let colours = source.properties().colours;
    for [left, right] in &views {
        let found = FrameMeasures::of(left, right, colours).unwrap();
        assert_eq!(level(&found, Dimension::Vertical), Level::Green);
    }
}

/// The measures of the first frame.
fn first(case: &str, layout: Layout) -> Option<FrameMeasures> {
    let mut source = open(case, layout)?;
    let properties = *source.properties();
    let mut meter = FrameMeter::new(properties.size, properties.colours)
        .with_pixel_aspect(properties.pixel_aspect);
    let mut views = Default::default();
    assert!(source.read(&mut views).unwrap());
    let [left, right] = &views;
    Some(
        meter
            .measure(&left.samples, &right.samples)
            .unwrap()
            .clone(),
    )
}

/// A film squeezed to half of its height has the angles of the whole one.
#[test]
fn half_of_the_rows_have_the_angles_of_all() {
    let full = first("half-sbs/full_sbs.mp4", Layout::SideBySide);
    let half = first("half-sbs/half_tab.mp4", Layout::HalfTopBottom);
    let (Some(full), Some(half)) = (full, half) else {
        return;
    };
    let viewing = Viewing::default();
    for dimension in Dimension::ALL {
        let (Some(a), Some(b)) = (full.row(dimension, &viewing), half.row(dimension, &viewing))
        else {
            continue;
        };
        let [a, b] = [a, b].map(|row| row.score.unwrap().number());
        assert!(a.abs_diff(b) <= 2, "{dimension:?}: {a} {b}");
    }
    let arcminutes = |found: &FrameMeasures| {
        found
            .row(Dimension::Vertical, &viewing)
            .unwrap()
            .raw
            .unwrap()
    };
    assert!((arcminutes(&full) - arcminutes(&half)).abs() < 0.3);
    // Four pixels, which are two rows of the squeezed view.
    assert!(
        (half.geometry.unwrap().shift_px - 2.0).abs() < 0.1,
        "{half:?}"
    );
}

/// The film states pixels of half the width: saying that it is squeezed as well says the same.
#[test]
fn a_stated_shape_is_not_counted_twice() {
    for layout in [Layout::TopBottom, Layout::HalfTopBottom] {
        let Some(half) = open("half-sbs/half_tab.mp4", layout) else {
            return;
        };
        assert_eq!(half.properties().pixel_aspect, [1, 2]);
        assert_eq!(layout.likelier(half.properties()), None);
    }
}

/// A picture of half the columns, each the mean of two.
fn squeezed(picture: &Picture) -> Picture {
    Plane::from_fn(picture.width() / 2, picture.height(), |column, row| {
        let [a, b] = [0, 1].map(|k| picture.row(row)[2 * column + k]);
        [0, 1, 2].map(|k| 0.5 * (a[k] + b[k]))
    })
}

/// A rotated view is turned back by its true angle where its columns are squeezed to half.
#[test]
fn squeezed_views_are_turned_by_true_angles() {
    for paths in [PAIRS[0], PAIRS[3], PAIRS[7]] {
        let Some([left, right]) = pair(paths) else {
            return;
        };
        let turned = Motion {
            degrees: 1.5,
            ..Motion::default()
        };
        let views = [&left, &moved(&right, turned)].map(|view| samples(&squeezed(view)));
        let mut meter = FrameMeter::new(views[0].size(), COLOURS).with_pixel_aspect([2, 1]);
        let geometry = meter
            .measure(&views[0], &views[1])
            .unwrap()
            .geometry
            .unwrap();
        assert!(
            (geometry.rotation_degrees - 1.5).abs() < 0.1,
            "{paths:?} {geometry:?}"
        );
        let correction = Correction {
            alignment: (&geometry).into(),
            ..Default::default()
        };
        let corrected = Corrector::new(COLOURS)
            .with_pixel_aspect([2, 1])
            .corrected(&views[1], &correction);
        let truth = samples(&squeezed(&right));
        let error = |view: &Samples| {
            let (view, truth) = (view.eight_bits(), truth.eight_bits());
            let (mut sum, mut count) = (0.0, 0.0);
            for row in 20..truth.luma.height() - 20 {
                let pairs = view.luma.row(row).iter().zip(truth.luma.row(row));
                for (a, b) in pairs.skip(20).take(truth.luma.width() - 40) {
                    sum += f64::from(a.abs_diff(*b)).powi(2);
                    count += 1.0;
                }
            }
            sum / count
        };
        let [before, after] = [&views[1], &corrected].map(error);
        assert!(after < 0.1 * before, "{paths:?}: {before} {after}");
    }
}

/// The recommended shift makes the far points of a real pair comfortable.
#[test]
fn parallax_is_shifted_as_is_recommended() {
    let viewing = Viewing::default();
    let Some([left, right]) = pair(PAIRS[2]) else {
        return;
    };
    let usual = measures(&left, &right).parallax.unwrap();
    let motion = Motion {
        right: 0.04 * left.width() as f64 - usual.far_px,
        ..Motion::default()
    };
    let right = moved(&right, motion);
    let before = measures(&left, &right);
    assert_ne!(level(&before, Dimension::OverDivergence), Level::Green);
    let parallax = before.parallax.unwrap();
    let ends = [parallax.near_px, parallax.far_px].map(|px| parallax.percent(px));
    let percent = comfortable_shift(ends, &viewing);
    assert!(percent < -0.8, "{percent} {ends:?}");
    let correction = Correction {
        parallax_px: 0.01 * percent * left.width() as f64,
        ..Default::default()
    };
    let [left, right] = [left, right].map(|view| samples(&view));
    let shifted = Corrector::new(COLOURS).corrected(&right, &correction);
    let after = FrameMeasures::of(&left, &shifted, COLOURS).unwrap();
    for dimension in [Dimension::OverDivergence, Dimension::OverConvergence] {
        assert_eq!(
            level(&after, dimension),
            Level::Green,
            "{:?}",
            after.parallax
        );
    }
    let moved = after.parallax.unwrap().median_px - parallax.median_px;
    assert!(
        (moved - correction.parallax_px).abs() < 1.5,
        "{moved} {correction:?}"
    );
}
