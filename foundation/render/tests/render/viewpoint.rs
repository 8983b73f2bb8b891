//! Viewpoints as text, and the views of a turntable.

use ga_render::model::Model;
use ga_render::{View, Viewpoint, ViewpointError};

/// A triangle whose bounds have their middle at (4, 1, −2).
fn model() -> Model {
    let mesh = ga_mesh::obj::decode(b"v 3 0 -3\nv 5 0 -1\nv 3 2 -1\nf 1 2 3\n").unwrap();
    Model::from_mesh(&mesh, None).unwrap()
}

#[test]
fn what_is_wrong_with_a_text_is_named() {
    let number = |text: &str| ViewpointError::Number {
        word: "eye".into(),
        text: text.into(),
    };
    for (text, error) in [
        ("eye", ViewpointError::Unknown("eye".into())),
        ("Front", ViewpointError::Unknown("Front".into())),
        ("eye 1,2,3 fov", ViewpointError::NoValue("fov".into())),
        ("eye 1,2,3 roll 4", ViewpointError::Word("roll".into())),
        ("eye 1,2,3 fov 40", ViewpointError::Missing("target")),
        ("eye 1,2,NaN fov 40", number("NaN")),
        ("eye 1,2,1e999 fov 40", number("1e999")),
        ("eye 1,,3 fov 40", number("")),
    ] {
        assert_eq!(text.parse::<Viewpoint>(), Err(error));
    }
    let error = "eye 1,2 fov 40".parse::<Viewpoint>().unwrap_err();
    assert_eq!(error.to_string(), "eye 1,2 has 2 numbers, not 3");
}

#[test]
fn named_sides_look_along_the_axes() {
    for (name, towards) in [
        ("front", [0.0, 0.0, -1.0]),
        (" side ", [-1.0, 0.0, 0.0]),
        ("top", [0.0, -1.0, 0.0]),
    ] {
        let viewpoint: Viewpoint = name.parse().unwrap();
        let [view] = &viewpoint.turntable(&model(), 1.0, 1).unwrap()[..] else {
            panic!("one view")
        };
        for (found, expected) in view.forward().into_iter().zip(towards) {
            assert!((found - expected).abs() < 1e-15, "{name}");
        }
    }
}

/// A quarter of a turn about the vertical axis through the middle takes (x, z), seen from there, to
/// (z, −x).
#[test]
fn a_turntable_goes_round_the_middle_of_the_model() {
    let viewpoint = "fov 40 target 0,0,0 eye 7,3,2";
    assert!(viewpoint.parse::<Viewpoint>().is_err(), "the eye is first");
    let viewpoint: Viewpoint = "eye 7,3,2 target 4,0,-2 fov 40".parse().unwrap();
    let views = viewpoint.turntable(&model(), 1.5, 4).unwrap();
    let eyes: Vec<[f64; 3]> = views.iter().map(View::eye).collect();
    let expected = [
        [7.0, 3.0, 2.0],
        [8.0, 3.0, -5.0],
        [1.0, 3.0, -6.0],
        [0.0, 3.0, 1.0],
    ];
    assert_eq!(eyes.len(), 4);
    for (found, expected) in eyes.iter().flatten().zip(expected.iter().flatten()) {
        assert!((found - expected).abs() < 1e-12, "{eyes:?}");
    }
    // What all of them look at is at half the width and height.
    for view in &views {
        let [column, row, _] = view.project([4.0, 0.0, -2.0], 60, 40).unwrap();
        assert!((column - 30.0).abs() < 1e-9 && (row - 20.0).abs() < 1e-9);
    }
}
