//! Pictures with one known defect each, made by another program.

use ga_video::comfort::{Dimension, FrameMeasures, Level};
use nullcone_shared_data::shared;
use serde_json::Value;

use super::inputs::{level, measures, picture};

const FOLDER: &str = "oracle/vision/seed1";

/// The measures of a case, with the truth: what is injected, and by how much.
fn cases() -> Option<Vec<(String, Value, FrameMeasures)>> {
    let folder = shared(FOLDER)?;
    let text = std::fs::read_to_string(folder.join("truth.json")).unwrap();
    let truth: Value = serde_json::from_str(&text).unwrap();
    let cases = truth["comfort"].as_array().unwrap().iter().map(|case| {
        let view = |side: &str| picture(&folder.join(case[side].as_str().unwrap()));
        let found = measures(&view("left"), &view("right"));
        let defect = case["defect"].as_str().unwrap().to_owned();
        (defect, case["value"].clone(), found)
    });
    Some(cases.collect())
}

#[test]
fn raw_numbers_are_those_that_were_injected() {
    let Some(cases) = cases() else { return };
    assert_eq!(cases.len(), 26);
    for (index, (defect, value, found)) in cases.iter().enumerate() {
        let geometry = found.geometry.unwrap();
        let photometry = found.photometry.unwrap();
        let value = value.as_f64().unwrap_or(f64::NAN);
        let (measured, within) = match defect.split(['_', ' ']).next() {
            Some("horizontal") => {
                let parallax = found.parallax.as_ref().unwrap();
                (parallax.median_disparity_px(), 0.1)
            }
            Some("vertical") => (geometry.shift_px, 0.1),
            Some("rotation") => (geometry.rotation_degrees, 0.03),
            Some("scale") => (1.0 + 0.01 * geometry.zoom_percent, 0.001),
            Some("brightness") => (photometry.offset_codes, 0.5),
            Some("colour") => {
                // The other channels stay, so that brightness does.
                assert!(
                    photometry.offset_codes.abs() < 0.5,
                    "c{index}: {photometry:?}"
                );
                (photometry.channel_ratios[0], 0.01)
            }
            _ => continue,
        };
        assert!(
            (measured - value).abs() <= within,
            "c{index} {defect} {value}: {measured}"
        );
        // What was not injected is not measured.
        if !defect.starts_with("vertical") {
            assert!(geometry.shift_px.abs() < 0.1, "c{index}: {geometry:?}");
        }
        if !defect.starts_with("rotation") {
            assert!(
                geometry.rotation_degrees.abs() < 0.03,
                "c{index}: {geometry:?}"
            );
        }
        if !defect.starts_with("scale") {
            assert!(geometry.zoom_percent.abs() < 0.1, "c{index}: {geometry:?}");
        }
        if !defect.starts_with("brightness") {
            assert!(
                photometry.offset_codes.abs() < 0.5,
                "c{index}: {photometry:?}"
            );
        }
    }
}

#[test]
fn each_case_is_judged_in_the_row_of_its_defect() {
    let Some(cases) = cases() else { return };
    let check = |index: usize, dimension: Dimension, green: bool| {
        let found = level(&cases[index].2, dimension);
        assert_eq!(
            found == Level::Green,
            green,
            "c{index} {dimension:?}: {found:?}"
        );
    };
    for (index, green) in [(1, true), (3, false), (5, false)] {
        check(index, Dimension::OverConvergence, green);
    }
    for (index, green) in [(2, true), (4, false), (6, false)] {
        check(index, Dimension::OverDivergence, green);
    }
    let vertical = [(7, true), (8, false), (9, false), (10, false)];
    let rotated = [(11, true), (12, false), (13, false), (14, false)];
    for (index, green) in vertical.into_iter().chain(rotated) {
        check(index, Dimension::Vertical, green);
    }
    for (index, green) in [(16, false), (22, false), (23, false), (17, true)] {
        check(index, Dimension::FocalGap, green);
    }
    for (index, green) in [(17, true), (18, false), (19, false), (20, true), (21, true)] {
        check(index, Dimension::Brightness, green);
    }
    for (index, green) in [(20, false), (21, false), (18, true), (19, true)] {
        check(index, Dimension::Colour, green);
    }
}

/// Identical views differ in nothing and have no depth.
#[test]
fn identical_views_are_equal() {
    let Some(cases) = cases() else { return };
    let found = &cases[0].2;
    for dimension in [
        Dimension::Brightness,
        Dimension::Colour,
        Dimension::Vertical,
        Dimension::OverConvergence,
        Dimension::OverDivergence,
        Dimension::FocalGap,
    ] {
        assert_eq!(level(found, dimension), Level::Green);
    }
    assert_eq!(level(found, Dimension::WeakDepth), Level::Red);
}

/// Two layers at known parallax, and the same with the views exchanged.
#[test]
fn layers_are_found_at_both_depths() {
    let Some(cases) = cases() else { return };
    for (index, near, far) in [(24, -8.0, 4.0), (25, -4.0, 8.0)] {
        let parallax = cases[index].2.parallax.as_ref().unwrap();
        assert!((parallax.near_px - near).abs() < 0.2, "{parallax:?}");
        assert!((parallax.far_px - far).abs() < 0.2, "{parallax:?}");
    }
}
