//! A clip of a still scene with defects in known intervals.

use ga_video::Frame;
use ga_video::comfort::{Dimension, FrameMeasures, FrameMeter, Viewing};
use ga_video::stereo::{Layout, StereoSource};
use nullcone_shared_data::shared;

/// The measures of all frames.
fn measures() -> Option<Vec<FrameMeasures>> {
    let path = shared("data/vision/clips/motorcycle_sbs_960x324_defects.y4m")?;
    let source = ga_video::open(path).unwrap();
    let mut views = StereoSource::halves(source, Layout::SideBySide).unwrap();
    let properties = *views.properties();
    let mut meter = FrameMeter::new(properties.size, properties.colours);
    let (mut frames, mut found) = (<[Frame; 2]>::default(), Vec::new());
    while views.read(&mut frames).unwrap() {
        let [left, right] = &frames;
        found.push(
            meter
                .measure(&left.samples, &right.samples)
                .unwrap()
                .clone(),
        );
    }
    Some(found)
}

#[test]
fn each_interval_rises_in_the_row_of_its_defect_alone() {
    let Some(found) = measures() else { return };
    let viewing = Viewing::default();
    let row = |frame: usize, dimension| found[frame].row(dimension, &viewing).unwrap();
    let score = |frame, dimension| i32::from(row(frame, dimension).score.unwrap().number());
    let same = [
        Dimension::Brightness,
        Dimension::Colour,
        Dimension::Vertical,
        Dimension::FocalGap,
    ];
    let injected = |frame| match frame {
        8..14 => Some(Dimension::Vertical),
        14..20 => Some(Dimension::Brightness),
        20..26 => Some(Dimension::Colour),
        32..38 => Some(Dimension::FocalGap),
        _ => None,
    };
    assert_eq!(found.len(), 48);
    for frame in 0..found.len() {
        for dimension in same {
            let change = score(frame, dimension) - score(0, dimension);
            let expected = if injected(frame) == Some(dimension) {
                5..=15
            } else {
                -2..=2
            };
            assert!(
                expected.contains(&change),
                "frame {frame}: {dimension:?} {change}"
            );
        }
        // Depth is as before where it is not injected, exchanged or blurred.
        if frame < 26 {
            for dimension in [
                Dimension::WeakDepth,
                Dimension::RichDepth,
                Dimension::OverConvergence,
                Dimension::OverDivergence,
            ] {
                let change = score(frame, dimension) - score(0, dimension);
                assert!(change.abs() <= 2, "frame {frame}: {dimension:?} {change}");
            }
        }
    }
}

#[test]
fn raw_numbers_show_what_was_injected() {
    let Some(found) = measures() else { return };
    let geometry = |frame: usize| found[frame].geometry.unwrap();
    let photometry = |frame: usize| found[frame].photometry.unwrap();
    let parallax = |frame: usize| found[frame].parallax.as_ref().unwrap();
    assert!((geometry(10).shift_px - geometry(0).shift_px - 3.0).abs() < 0.1);
    assert!((photometry(16).offset_codes - photometry(0).offset_codes - 25.0).abs() < 1.0);
    assert!(
        (photometry(22).channel_ratios[0] / photometry(0).channel_ratios[0] - 0.75).abs() < 0.02
    );
    assert!(found[34].sharpness_log2.unwrap() < -0.8);
    assert!((parallax(28).median_px + parallax(0).median_px).abs() < 1.0);
    // Each point has 40 pixels more of crossed parallax, and then 60 of uncrossed.
    for (frame, added) in [(40, -40.0), (45, 60.0)] {
        let moved = parallax(frame).median_px - parallax(0).median_px;
        assert!((moved - added).abs() < 2.0, "frame {frame}: {moved}");
    }
}
