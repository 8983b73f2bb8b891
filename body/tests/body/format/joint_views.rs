//! The joints of one person in all views.

use ga_body::JointPixel;
use ga_body::format::{JointView, JointViews, JointsError};
use proptest::prelude::*;

#[test]
fn bad_views_name_view_frame_and_joint() {
    let decode = |views: &str| {
        let text = format!(r#"{{"version": 1, "joints": ["Hips", "Head"], "views": [{views}]}}"#);
        JointViews::decode(text.as_bytes())
    };
    assert!(decode(r#"{"name": "a", "frames": [[null, [1, 2, 0.5]]]}"#).is_ok());
    let cases: [(&str, &[&str]); 7] = [
        (
            r#"{"name": "a", "frames": [[null]]}"#,
            &["\"a\"", "frame 0", "1 joints", "2 are named"],
        ),
        (
            r#"{"name": "a", "frames": [[null, [1]]]}"#,
            &["\"a\"", "frame 0", "\"Head\" (1)", "1 numbers"],
        ),
        (
            r#"{"name": "a", "frames": [[null, [1, 2, 0]]]}"#,
            &["\"Head\" (1)", "0 px"],
        ),
        (r#"{"name": "a", "frames": []}"#, &["no frames"]),
        ("", &["no views"]),
        (
            r#"{"name": "a", "frames": [[null, null]]}, {"name": "b", "frames": []}"#,
            &["\"b\"", "0 frames"],
        ),
        (
            r#"{"name": "a", "frames": [[null, null]]}, {"name": "a", "frames": [[null, null]]}"#,
            &["two views", "\"a\""],
        ),
    ];
    for (views, parts) in cases {
        let text = decode(views).unwrap_err().to_string();
        for part in parts {
            assert!(text.contains(part), "{part:?} is not in {text:?}");
        }
    }
    let version = br#"{"version": 2, "joints": ["a"], "views": []}"#;
    assert!(matches!(
        JointViews::decode(version),
        Err(JointsError::Version { found: 2, .. })
    ));
    let unknown = br#"{"version": 1, "joints": ["a"], "views": [], "fps": 3}"#;
    assert!(matches!(
        JointViews::decode(unknown),
        Err(JointsError::Json(_))
    ));
    let rate = br#"{"version": 1, "joints": ["a"], "frames_per_second": 0, "views": []}"#;
    assert!(matches!(
        JointViews::decode(rate),
        Err(JointsError::FrameRate(_))
    ));
}

proptest! {
    #[test]
    fn what_is_written_is_read(
        frames in prop::collection::vec(
            prop::collection::vec(
                prop::option::of((-1e4..1e4f64, -1e4..1e4f64, 1e-3..1e3f64)),
                3,
            ),
            1..6,
        ),
        rate in prop::option::of(1.0..500.0f64),
    ) {
        let pixel = |(u, v, deviation)| JointPixel { position: [u, v], deviation };
        let frames: Vec<Vec<_>> = frames
            .into_iter()
            .map(|frame| frame.into_iter().map(|joint| joint.map(pixel)).collect())
            .collect();
        let names = ["Hips", "a \"b\"", "ä"].map(str::to_owned).to_vec();
        let view = |name: &str| JointView { name: name.to_owned(), frames: frames.clone() };
        let joints = JointViews::new(names, rate, vec![view("left"), view("right")]).unwrap();
        prop_assert_eq!(JointViews::decode(joints.encode().as_bytes()).unwrap(), joints);
    }
}
