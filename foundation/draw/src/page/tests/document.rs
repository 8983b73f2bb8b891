//! The page as a reader uses it.

use serde_json::{Value, json};

use super::super::{Data, GEOMETRY, SCRIPT, STAGE, SURFACE};
use crate::node::node;
use crate::scene::Scene;
use crate::style::Style;
use ga_runtime::cga3::{Point, Sphere};

fn scene() -> Scene {
    let mut scene = Scene::new("Two elements");
    let sphere = Sphere::from_centre_radius(Point::new(0.0, 0.0, 0.0), 1.0);
    scene.add(sphere, Style::labelled("ball")).unwrap();
    let point = Point::new(1.0, 1.0, 1.0);
    scene.add(point, Style::labelled("place")).unwrap();
    scene
}

/// The texts that are painted.
fn texts(painted: &Value) -> Vec<&str> {
    let calls = painted.as_array().unwrap().iter();
    let texts = calls.filter(|call| call[0] == "fillText");
    texts.map(|call| call[1].as_str().unwrap()).collect()
}

#[test]
fn the_page_follows_keys_pointer_legend_and_address() {
    let key = |key: &str| json!({"target": "stage", "name": "keydown", "event": {"key": key}});
    let pointer = |name: &str, x: i32| {
        let event = json!({"pointerId": 1, "clientX": x, "clientY": 0});
        json!({"target": "stage", "name": name, "event": event})
    };
    let events = json!([
        key("ArrowLeft"),
        key("ArrowRight"),
        key("+"),
        key("Home"),
        {"target": "legend 0", "name": "click", "event": {}},
        {"target": "legend 0", "name": "click", "event": {}},
        pointer("pointerdown", 100),
        pointer("pointermove", 125),
        {"target": "window", "name": "hashchange", "event": {"hash": "#turn=25,22"}},
        {"target": "window", "name": "hashchange", "event": {"hash": ""}},
        {"target": "stage", "name": "wheel", "event": {"deltaY": -100}},
        {"target": "stage", "name": "dblclick", "event": {}},
    ]);
    let input = json!({
        "script": format!("{GEOMETRY}{STAGE}{SURFACE}{SCRIPT}"),
        "scene": Data::of(&scene()).json(),
        "events": events,
    });
    let Some(answer) = node(include_str!("document.js"), &input) else {
        return;
    };
    let hidden = json!({"still": true, "stage": false, "legend": false});
    assert_eq!(answer["hidden"], hidden);
    let painted = answer["painted"].as_array().unwrap();
    let [
        first,
        left,
        right,
        zoomed,
        home,
        without_ball,
        with_ball,
        down,
        dragged,
        from_address,
        reset,
        wheel,
        double_click,
    ] = &painted[..]
    else {
        panic!("{} pictures", painted.len())
    };
    assert_eq!(texts(first), ["ball", "place"]);
    assert_ne!(left, first);
    assert_eq!(right, first);
    assert_ne!(zoomed, first);
    assert_eq!(home, first);
    assert_eq!(texts(without_ball), ["place"]);
    assert_eq!(with_ball, first);
    // Nothing is painted before the pointer moves.
    assert_eq!(down, &json!([]));
    // Moving by 25 pixels to the right rotates by −10 degrees, from azimuth 35 to 25.
    assert_ne!(dragged, first);
    assert_eq!(from_address, dragged);
    assert_eq!(reset, first);
    assert_ne!(wheel, first);
    assert_eq!(double_click, first);
}
