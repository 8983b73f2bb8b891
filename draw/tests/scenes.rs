//! What comes out of scenes: structure, escaping, every kind, errors, and pictures of any scene
//! that there may be.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

use ga_draw::{
    Colour, Drawable, ElementError, NotDrawable, PALETTE, Scene, SceneError, Shape, Style,
};
use ga_runtime::cga3::{
    Circle, Direction, DualPlane, Infinity, Line, Motor, Multivector, Plane, Point, PointPair,
    Rotor, RoundVector, Sphere, Translator,
};
use proptest::prelude::*;

fn parsed(elements: &str) -> Result<Scene, SceneError> {
    Scene::from_json(format!("{{\"elements\": [{elements}]}}").as_bytes())
}

fn close(a: [f64; 3], b: [f64; 3]) -> bool {
    (0..3).all(|k| (a[k] - b[k]).abs() < 1e-12)
}

/// Well formed, with finite numbers only.
fn assert_well_formed(svg: &str) {
    let document = roxmltree::Document::parse(svg).unwrap();
    for node in document.descendants().filter(roxmltree::Node::is_element) {
        for attribute in node.attributes() {
            let value = attribute.value();
            assert!(!value.contains("NaN") && !value.contains("inf"), "{value}");
            if matches!(
                attribute.name(),
                "x" | "y" | "cx" | "cy" | "r" | "stroke-width"
            ) {
                assert!(value.parse::<f64>().unwrap().is_finite());
            }
        }
    }
}

#[test]
fn pairs_are_read_from_their_blades() {
    let (p, q) = (Point::new(1.0, 2.0, 3.0), Point::new(1.0, 2.0, 5.0));
    let shape = ((p ^ q) * -3.0).shape().unwrap();
    let Shape::PointPair {
        centre,
        direction,
        radius,
        imaginary,
    } = shape
    else {
        panic!("{shape:?}")
    };
    assert!(close(centre, [1.0, 2.0, 4.0]) && close(direction, [0.0, 0.0, -1.0]));
    assert!((radius - 1.0).abs() < 1e-12 && !imaginary);
    // A line passing a unit sphere at distance 2 meets it in points √−3 from its foot.
    let sphere = Sphere::from_centre_radius(Point::new(0.0, 0.0, 0.0), 1.0);
    let line = Line::from_point_direction(Point::new(0.0, 2.0, 0.0), [1.0, 0.0, 0.0]);
    let Shape::PointPair {
        centre,
        radius,
        imaginary: true,
        ..
    } = (sphere & line).shape().unwrap()
    else {
        panic!()
    };
    assert!(close(centre, [0.0, 2.0, 0.0]) && (radius * radius - 3.0).abs() < 1e-12);
    // One touching it meets it in a tangent vector.
    let line = Line::from_point_direction(Point::new(0.0, 1.0, 0.0), [1.0, 0.0, 0.0]);
    let Shape::TangentVector { at, .. } = (sphere & line).shape().unwrap() else {
        panic!()
    };
    assert!(close(at, [0.0, 1.0, 0.0]));
}

#[test]
fn each_type_is_what_it_is_called() {
    let [o, x, y] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point::from);
    let sphere = |x: f64, r| Sphere::from_centre_radius(Point::new(x, 0.0, 0.0), r);
    let plane = Plane::from_point_normal(x, [2.0, 0.0, 0.0]);
    let kinds: [(&dyn Drawable, &str); 15] = [
        (&o, "point"),
        (&(x ^ Infinity), "flat point"),
        (&(x ^ y), "point pair"),
        (&Circle::through(o, x, y), "circle"),
        (&(sphere(0.0, 1.0) & sphere(3.0, 1.0)), "imaginary circle"),
        (&(sphere(0.0, 1.0) & sphere(2.0, 1.0)), "tangent bivector"),
        (&sphere(0.0, 1.0), "sphere"),
        (&RoundVector::dual_sphere(x, 1.0), "sphere"),
        (&Line::through(o, x), "line"),
        (&plane, "plane"),
        (
            &DualPlane::from_normal_distance([0.0, 0.0, 1.0], 2.0),
            "plane",
        ),
        (&Direction::from_vector([0.0, 0.0, 2.0]), "direction"),
        (&Motor::<f64>::default(), "frame"),
        (&Rotor::<f64>::default(), "frame"),
        (&Translator::from_displacement([1.0, 0.0, 0.0]), "frame"),
    ];
    let mut scene = Scene::new("kinds");
    for (element, kind) in kinds {
        let shape = element.shape().unwrap();
        assert_eq!(shape.kind(), kind);
        scene.add(shape, Style::labelled(kind)).unwrap();
    }
    (scene.axes, scene.grid) = (true, true);
    assert_well_formed(&scene.to_svg());
    let Shape::Plane { support, normal } = plane.shape().unwrap() else {
        panic!()
    };
    assert!(close(support, [1.0, 0.0, 0.0]) && close(normal, [1.0, 0.0, 0.0]));
}

#[test]
fn what_has_no_place_is_refused() {
    let mut scene = Scene::new("");
    let nan = Point::new(f64::NAN, 0.0, 0.0);
    assert!(matches!(
        scene.add(nan, Style::default()),
        Err(NotDrawable::NotFinite(_))
    ));
    let far = Point::new(1e200, 0.0, 0.0);
    assert_eq!(
        scene.add(far, Style::default()).unwrap_err(),
        NotDrawable::TooLarge(1e200)
    );
    assert_eq!(
        PointPair::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0).shape(),
        Err(NotDrawable::Zero)
    );
    let at_infinity = RoundVector::new(0.0, 0.0, 0.0, 0.0, 1.0);
    assert_eq!(at_infinity.shape(), Err(NotDrawable::NoWeight));
    let infinite = Sphere::new(f64::INFINITY, 0.0, 0.0, 0.0, 0.0);
    assert_eq!(infinite.shape(), Err(NotDrawable::NotFinite(f64::INFINITY)));
    let mixed: Multivector<f64> = Multivector {
        scalar: 1.0,
        e1: 1.0,
        ..Multivector::default()
    };
    assert_eq!(mixed.shape(), Err(NotDrawable::NeitherBladeNorMotor));
    assert_eq!(scene.shapes().count(), 0);
}

#[test]
fn a_ball_is_a_circle_of_its_radius() {
    // Along parallel rays a unit sphere is a disc that fills the height of the picture but for its
    // margins.
    let mut scene = Scene::new("");
    scene.size = [400, 400];
    scene.view.projection = ga_draw::Projection::Orthographic;
    let sphere = Sphere::from_centre_radius(Point::new(5.0, 6.0, 7.0), 2.0);
    scene.add(sphere, Style::default()).unwrap();
    let svg = scene.to_svg();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let ball = document
        .descendants()
        .find(|node| node.attribute("id") == Some("ball0"))
        .unwrap();
    let data = ball.attribute("d").unwrap().replace(['M', 'L', 'Z'], " ");
    let numbers: Vec<f64> = data
        .split_whitespace()
        .map(|number| number.parse().unwrap())
        .collect();
    assert_eq!(numbers.len(), 2 * 97);
    let radii: Vec<f64> = numbers
        .chunks(2)
        .map(|p| (p[0] - 200.0).hypot(p[1] - 200.0))
        .collect();
    assert!(radii.iter().all(|radius| (radius - radii[0]).abs() < 0.2));
    assert!((radii[0] - 166.0).abs() < 1.0, "{}", radii[0]);
}

#[test]
fn texts_stay_texts() {
    let evil = "</script><svg onload=\"x()\"> & 'q' \u{1}";
    let mut scene = Scene::new(evil);
    scene.description = evil.to_owned();
    scene
        .add(Point::new(0.0, 0.0, 0.0), Style::labelled(evil))
        .unwrap();
    let svg = scene.to_svg();
    let document = roxmltree::Document::parse(&svg).unwrap();
    let read = evil.replace('\u{1}', "\u{fffd}");
    let texts = |name| {
        document
            .descendants()
            .filter(move |node| node.has_tag_name(("http://www.w3.org/2000/svg", name)))
    };
    assert_eq!(texts("title").next().unwrap().text(), Some(read.as_str()));
    assert_eq!(texts("desc").next().unwrap().text(), Some(read.as_str()));
    let html = scene.to_html();
    assert!(!html.contains("<svg onload") && !html.contains(evil));
    assert_eq!(html.matches("</script>").count(), 2);
}

#[test]
fn the_page_asks_for_nothing() {
    let html = parsed(r#"{"point": [1, 2, 3]}"#).unwrap().to_html();
    let links = html.matches("http").count();
    // The name space of the picture and the policy that forbids requests.
    assert_eq!(links, 2);
    assert!(html.contains("default-src 'none'") && html.contains("http-equiv"));
}

#[test]
fn colours_stand_out_against_both_grounds() {
    let channel = |value: u8| {
        let x = f64::from(value) / 255.0;
        if x <= 0.04045 {
            x / 12.92
        } else {
            ((x + 0.055) / 1.055).powf(2.4)
        }
    };
    let luminance =
        |Colour([r, g, b])| 0.2126 * channel(r) + 0.7152 * channel(g) + 0.0722 * channel(b) + 0.05;
    for colour in PALETTE {
        let own = luminance(colour);
        assert!(luminance(Colour([255; 3])) / own >= 3.0, "{colour}");
        assert!(
            own / luminance(Colour([0x14, 0x17, 0x1c])) >= 3.0,
            "{colour}"
        );
    }
}

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
    // Half a turn about x = 1 takes the origin to (2, 0), by (1, −1).
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
fn errors_name_the_place_and_the_value() {
    for (elements, message) in [
        (
            r#"{"name": "a"}"#,
            "element 0 (`a`): it must name one kind of element and names none",
        ),
        (
            r#"{"point": [0, 0, 0], "direction": [1, 0, 0]}"#,
            "element 0: it must name one kind of element and names `point` and `direction`",
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
            "element 0: one of its coordinates or lengths is 1e101, and nothing beyond 1e100 is drawn",
        ),
        (
            r#"{"blade": {"e21": 1}}"#,
            "element 0: `e21` is no blade of cga3: blades are written as in scalar, e1, e12, e1o, e12oi, eoi",
        ),
        (
            r#"{"blade": {"ei": 1}}"#,
            "element 0: its weight is zero: it is at infinity and has no place",
        ),
        (
            r#"{"point": [0, 0, 0], "colour": "red"}"#,
            "element 0: `red` is no colour: it must be # and six hexadecimal digits, as in #0072b2",
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
            "element 0: the trajectory has no place",
        ),
    ] {
        assert_eq!(parsed(elements).unwrap_err().to_string(), message);
    }
    assert!(matches!(
        parsed(r#"{"name": "m", "motor": {}}, {"meet": ["m", "m"]}"#),
        Err(SceneError::Element {
            index: 1,
            problem: ElementError::NotABlade(_),
            ..
        })
    ));
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
        let message = Scene::from_json(text.as_bytes()).unwrap_err().to_string();
        assert!(message.contains(part), "{message}");
    }
}

fn shape() -> impl Strategy<Value = Shape> {
    let number = prop_oneof![-10.0..10.0, -1e90..1e90, -1e-90..1e-90, Just(0.0)];
    let place = proptest::array::uniform3(number);
    let side =
        proptest::array::uniform3(-1.0..1.0).prop_filter_map("no direction", |v: [f64; 3]| {
            let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
            (length > 1e-3).then(|| v.map(|x| x / length))
        });
    let radius = prop_oneof![0.0..10.0, 0.0..1e90, Just(0.0)];
    (place.clone(), side, radius, any::<bool>(), 0..8, place).prop_map(
        |(centre, side, radius, imaginary, kind, other)| match kind {
            0 => Shape::Point { at: centre },
            1 => Shape::PointPair {
                centre,
                direction: side,
                radius,
                imaginary,
            },
            2 => Shape::Circle {
                centre,
                normal: side,
                radius,
                imaginary,
            },
            3 => Shape::Sphere {
                centre,
                radius,
                imaginary,
            },
            4 => Shape::Line {
                support: centre,
                direction: side,
            },
            5 => Shape::Plane {
                support: centre,
                normal: side,
            },
            6 => Shape::Trajectory {
                points: vec![centre, other],
                frames: vec![(other, [side; 3])],
            },
            _ => Shape::Direction { vector: centre },
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_scene_is_well_formed(
        shapes in proptest::collection::vec(shape(), 0..6),
        label in any::<String>(),
        (azimuth, elevation) in (-400.0..400.0, -90.0..90.0),
        parallel in any::<bool>(),
    ) {
        let mut scene = Scene::new(label.clone());
        scene.view.azimuth = azimuth;
        scene.view.elevation = elevation;
        if parallel {
            scene.view.projection = ga_draw::Projection::Orthographic;
        }
        (scene.axes, scene.grid) = (parallel, !parallel);
        for shape in shapes {
            scene.add(shape, Style::labelled(label.as_str())).unwrap();
        }
        let svg = scene.to_svg();
        assert_well_formed(&svg);
        prop_assert_eq!(svg, scene.to_svg());
        prop_assert!(!scene.to_html().contains("null,null"));
    }
}

#[test]
fn dual_forms_look_as_what_they_stand_for() {
    let at = Point::new(1.0, -2.0, 3.0);
    let normal = [0.0, 3.0, 4.0];
    for squared in [4.0, 0.0, -1.0] {
        let sphere = Sphere::from_centre_radius_squared(at, squared);
        let circle = Circle::from_centre_normal_radius_squared(at, normal, squared).unwrap();
        let pair = PointPair::from_centre_axis_radius_squared(at, normal, squared).unwrap();
        assert_eq!(sphere.dual().shape(), sphere.shape());
        assert_eq!(circle.dual().shape(), circle.shape());
        assert_eq!(pair.dual().shape(), pair.shape());
    }
    let flat = at ^ Infinity;
    assert_eq!(flat.dual().shape(), flat.shape());
    assert_eq!(
        flat.shape(),
        Ok(Shape::FlatPoint {
            at: [1.0, -2.0, 3.0]
        })
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
            at: [2.0, 0.0, 0.0]
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
