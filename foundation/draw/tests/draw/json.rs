//! Scenes read from JSON, and the errors of those that cannot be read.

use ga_draw::{ElementProblem, Scene, SceneError, Shape};
use ga_runtime::cga3::Point;

use crate::{assert_well_formed, close, parsed};

#[test]
fn every_kind_in_json() {
    for (element, kind) in [
        (r#""point": [1, 2, 3]"#, "point"),
        (r#""flat_point": [1, 2, 3]"#, "flat point"),
        (r#""point_pair": [[0, 0, 0], [1, 0, 0]]"#, "point pair"),
        (
            r#""circle": {"through": [[1, 0, 0], [0, 1, 0], [-1, 0, 0]]}"#,
            "circle",
        ),
        (
            r#""circle": {"centre": [1, 0, 0], "normal": [0, 0, 1], "radius": 2}"#,
            "circle",
        ),
        (r#""sphere": {"centre": [0, 0, 0], "radius": 1}"#, "sphere"),
        (
            r#""sphere": {"through": [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, 0, 1]]}"#,
            "sphere",
        ),
        (r#""line": {"through": [[0, 0, 0], [1, 1, 1]]}"#, "line"),
        (
            r#""line": {"point": [0, 0, 0], "direction": [0, 1, 0]}"#,
            "line",
        ),
        (
            r#""plane": {"through": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}"#,
            "plane",
        ),
        (
            r#""plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}"#,
            "plane",
        ),
        (r#""plane": {"normal": [0, 1, 0], "distance": 2}"#, "plane"),
        (r#""direction": [0, 0, 1]"#, "direction"),
        (
            r#""motor": {"axis": [0, 0, 1], "degrees": 90, "translation": [1, 0, 0]}"#,
            "frame",
        ),
        (
            r#""trajectory": {"points": [[0, 0, 0], [1, 0, 0]]}"#,
            "trajectory",
        ),
        (
            r#""trajectory": {"motors": [{}, {"translation": [1, 0, 0]}], "frames": 2}"#,
            "trajectory",
        ),
        (
            r#""trajectory": {"screw": {"axis": [0, 0, 1], "degrees": 720, "shift": 1}, "point": [1, 0, 0]}"#,
            "trajectory",
        ),
        (r#""blade": {"e123o": 1, "e123i": 0.5}"#, "sphere"),
        (r#""blade": {"e12i": 1, "e1oi": -1}"#, "line"),
        (r#""blade": {"e1i": 2}"#, "direction"),
        (r#""blade": {"scalar": 1, "e3i": -0.5}"#, "frame"),
    ] {
        let scene = parsed(&format!("{{{element}, \"label\": \"x\"}}")).unwrap();
        assert_eq!(scene.shapes().next().unwrap().kind(), kind, "{element}");
        assert_well_formed(&scene.to_svg());
        assert_eq!(scene.to_html(), scene.clone().to_html());
    }
}

#[test]
fn a_screw_about_an_axis_beside_the_origin() {
    let scene = parsed(
        r#"{"trajectory": {"screw": {"axis": [0, 0, 2], "through": [1, 0, 0], "degrees": 180, "shift": 4}, "steps": 2}}"#,
    );
    let Shape::Trajectory { points, .. } = scene.unwrap().shapes().next().unwrap().clone() else {
        panic!()
    };
    // A rotation by 180° about x = 1 takes the origin to (2, 0) through (1, −1).
    assert!(
        close(points[1], [1.0, -1.0, 2.0]) && close(points[2], [2.0, 0.0, 4.0]),
        "{points:?}"
    );
}

#[test]
fn meets_joins_and_motions() {
    let scene = parsed(
        r#"{"name": "a", "sphere": {"centre": [0, 0, 0], "radius": 1}},
        {"name": "b", "sphere": {"centre": [1, 0, 0], "radius": 1}},
        {"name": "p", "point": [0, 0, 2], "hidden": true}, {"name": "q", "point": [0, 1, 2], "hidden": true},
        {"meet": ["a", "b"]}, {"join": ["p", "q"]},
        {"name": "l", "line": {"through": [[0, 0, 0], [0, 0, 1]]}},
        {"moved": {"element": "l", "by": {"axis": [1, 2, 3], "degrees": 50, "translation": [1, 0.3, 0]}}}"#,
    )
    .unwrap();
    let kinds: Vec<_> = scene.shapes().map(Shape::kind).collect();
    assert_eq!(
        kinds,
        ["sphere", "sphere", "circle", "point pair", "line", "line"]
    );
}

#[test]
fn curves_of_one_plane_meet() {
    let x = r#"{"name": "x", "line": {"through": [[0, 0, 0], [1, 0, 0]]}}"#;
    let y = r#"{"name": "y", "line": {"through": [[2, -1, 0], [2, 1, 0]]}}"#;
    let skew = r#"{"name": "s", "line": {"through": [[0, 0, 1], [0, 1, 1]]}}"#;
    let c = r#"{"name": "c", "circle": {"centre": [0, 0, 0], "normal": [0, 0, 1], "radius": 1}}"#;
    let d = r#"{"name": "d", "circle": {"centre": [1, 0, 0], "normal": [0, 0, 1], "radius": 1}}"#;
    let meet = |a: &str, b: &str, names: &str| {
        parsed(&format!("{a}, {b}, {{\"name\": \"m\", \"meet\": {names}}}"))
    };
    let last = |scene: Scene| scene.shapes().last().unwrap().clone();
    let crossing = last(meet(x, y, r#"["x", "y"]"#).unwrap());
    assert_eq!(
        crossing,
        Shape::FlatPoint {
            at: Point::new(2.0, 0.0, 0.0)
        }
    );
    for (a, b, names, middle) in [
        (x, c, r#"["x", "c"]"#, [0.0; 3]),
        (c, x, r#"["c", "x"]"#, [0.0; 3]),
        (c, d, r#"["c", "d"]"#, [0.5, 0.0, 0.0]),
    ] {
        match last(meet(a, b, names).unwrap()) {
            Shape::PointPair {
                centre,
                imaginary: false,
                ..
            } => assert!(close(centre, middle)),
            other => panic!("{other:?}"),
        }
    }
    let error = meet(x, skew, r#"["x", "s"]"#).unwrap_err().to_string();
    assert!(error.contains("do not meet"), "{error}");
}

#[test]
fn errors_name_the_place_and_the_value() {
    for (elements, message) in [
        (
            r#"{"name": "a"}"#,
            "element 0 (`a`): it must have exactly one kind of element, but has none",
        ),
        (
            r#"{"point": [0, 0, 0], "direction": [1, 0, 0]}"#,
            "element 0: it must have exactly one kind of element, but has `point` and `direction`",
        ),
        (
            r#"{"meet": ["a", "b"]}"#,
            "element 0: no element before it is named `a`",
        ),
        (
            r#"{"name": "a", "point": [0, 0, 0]}, {"name": "a", "point": [0, 0, 0]}"#,
            "element 1 (`a`): an element before it has the same name",
        ),
        (
            r#"{"sphere": {"centre": [0, 0, 0], "radius": -1}}"#,
            "element 0: `radius` is -1, but must be at least 0",
        ),
        (
            r#"{"line": {"through": [[1, 1, 1], [1, 1, 1]]}}"#,
            "element 0: all its coefficients are zero",
        ),
        (
            r#"{"point": [1e101, 0, 0]}"#,
            "element 0: one of its coordinates or lengths is 1e101, which is beyond the limit of 1e100",
        ),
        (
            r#"{"blade": {"e21": 1}}"#,
            "element 0: `e21` is not a basis blade of cga3: these are written as scalar, e1, e12, e1o, e12oi, eoi",
        ),
        (
            r#"{"blade": {"ei": 1}}"#,
            "element 0: its weight is zero: it is at infinity and has no place",
        ),
        (
            r#"{"point": [0, 0, 0], "colour": "red"}"#,
            "element 0: `red` is not a colour: it must be # and six hexadecimal digits, as in #0072b2",
        ),
        (
            r#"{"point": [0, 0, 0], "opacity": 2}"#,
            "element 0: `opacity` is 2, but must be from 0 to 1",
        ),
        (
            r#"{"motor": {"axis": [0, 0, 0], "degrees": 1}}"#,
            "element 0: `axis` is zero and has no direction",
        ),
        (
            r#"{"trajectory": {"points": []}}"#,
            "element 0: the trajectory has no points",
        ),
    ] {
        assert_eq!(parsed(elements).unwrap_err().to_string(), message);
    }
    assert!(matches!(
        parsed(r#"{"name": "m", "motor": {}}, {"meet": ["m", "m"]}"#),
        Err(SceneError::Element {
            index: 1,
            problem: ElementProblem::NotABlade(_),
            ..
        })
    ));
}

#[test]
fn errors_of_the_text_name_the_line_or_the_member() {
    for (text, part) in [
        (
            "{\"elements\": [\n{\"spher\": 1}]}",
            "unknown field `spher`",
        ),
        ("{\"elements\": [\n{\"point\": [1, 2]}]}", "line 2 column"),
        (
            "{\"elements\": [\n{\"point\": [1e999, 2, 3]}]}",
            "number out of range at line 2",
        ),
        ("{", "line 1 column 1"),
        ("{\"elements\": [], \"size\": [1, 1]}", "`size` is [1, 1]"),
        ("{\"elements\": [], \"view\": {\"zoom\": 0}}", "`zoom` is 0"),
    ] {
        let message = Scene::decode(text.as_bytes()).unwrap_err().to_string();
        assert!(message.contains(part), "{message}");
    }
}

#[test]
fn errors_of_the_text_name_the_unknown_member_and_no_type() {
    let element = |text: &str| format!("{{\"elements\": [{text}]}}");
    let cases = [
        (
            element(r#"{"circle": {"centre": [0,0,0], "normal": [0,0,1], "size": 1}}"#),
            "`size`",
        ),
        (element(r#"{"sphere": {"centre": [0,0,0], "r": 1}}"#), "`r`"),
        (element(r#"{"line": {"from": [0,0,0]}}"#), "`from`"),
        (element(r#"{"plane": {"at": [0,0,0]}}"#), "`at`"),
        (element(r#"{"trajectory": {"path": []}}"#), "`path`"),
        (element(r#"{"motor": {"angle": 3}}"#), "`angle`"),
        (element(r#"{"sphere": {"centre": [0,0,0]}}"#), "a sphere is"),
        (
            element(r#"{"line": {"through": [[0,0,0],[1,0,0]], "point": [0,0,0]}}"#),
            "a line is",
        ),
        (element(r#"{"plane": 3}"#), "a plane is"),
        (element(r#"{"circle": "round"}"#), "a circle is"),
        (element(r#"{"trajectory": 3}"#), "a trajectory is"),
        (element(r#"{"motor": 3}"#), "a motor"),
        (element(r#"{"moved": 3}"#), "`element` and `by`"),
        (element("3"), "an element"),
        ("3".to_owned(), "a scene"),
        (r#"{"view": 3, "elements": []}"#.to_owned(), "a view"),
        (
            r#"{"view": {"up": 3}, "elements": []}"#.to_owned(),
            "column 17",
        ),
        (
            r#"{"view": {"projection": {}}, "elements": []}"#.to_owned(),
            "column 26",
        ),
        (r#"{"view": {"up": "x"}, "elements": []}"#.to_owned(), "`x`"),
    ];
    for (text, part) in cases {
        let message = Scene::decode(text.as_bytes()).unwrap_err().to_string();
        assert!(message.contains(part), "{text}: {message}");
        for word in ["Text", "Members", "struct", "enum", "Projection", "Up"] {
            assert!(!message.contains(word), "{text}: {message}");
        }
    }
}
