//! The part as a reader uses it.

use serde_json::{Value, json};

use super::super::part::{MESH, PAINTER, SCRIPT};
use super::{data, model, page};
use crate::node::node;
use crate::page::{GEOMETRY, STAGE};

/// What is shown at first and after each event.
fn shown(webgl: bool, events: &Value) -> Option<Vec<Value>> {
    let input = json!({
        "script": format!("{GEOMETRY}{STAGE}{MESH}{PAINTER}{SCRIPT}"),
        "data": data(&page(&model())).to_string(),
        "webgl": webgl,
        "events": events,
    });
    let shown = node(include_str!("player.js"), &input)?;
    Some(serde_json::from_value(shown).unwrap())
}

fn outputs(shown: &[Value]) -> Vec<&str> {
    let outputs = shown.iter().map(|shown| shown["output"].as_str().unwrap());
    outputs.collect()
}

const FRAMES: [&str; 2] = ["frame 0 / 1 · 0.00 s", "frame 1 / 1 · 0.10 s"];

#[test]
fn keys_and_the_slider_choose_frames() {
    let key = |key: &str| json!({"target": "part", "name": "keydown", "event": {"key": key}});
    let slider = |frame: usize| json!({"target": "[type=range]", "name": "input", "value": frame});
    let events = json!([key("."), key("."), key(","), slider(0), slider(1), key("x")]);
    let Some(shown) = shown(true, &events) else {
        return;
    };
    let expected = [0, 1, 0, 1, 0, 1, 1].map(|frame| FRAMES[frame]);
    assert_eq!(outputs(&shown), expected);
    // The shadow and the model, each by its twelve indices; nothing where nothing has changed.
    assert_eq!(shown[1]["drawn"], json!([12, 12]));
    assert_eq!(shown[6]["drawn"], json!([]));
    assert_eq!([&shown[0]["absent"], &shown[0]["stage"]], [&json!(true); 2]);
}

#[test]
fn it_plays_again_and_again() {
    let time = |time: f64| json!({"time": time});
    let button = json!({"target": "button", "name": "click"});
    let events = json!([button, time(100.0), time(250.0), button, time(900.0)]);
    let Some(shown) = shown(true, &events) else {
        return;
    };
    let expected = [0, 0, 1, 0, 0, 0].map(|frame| FRAMES[frame]);
    assert_eq!(outputs(&shown), expected);
    let words: Vec<_> = shown.iter().map(|shown| &shown["button"]).collect();
    assert_eq!(words, ["Play", "Pause", "Pause", "Pause", "Play", "Play"]);
}

#[test]
fn the_pointer_rotates_and_a_lost_canvas_comes_back() {
    let stage =
        |name: &str, event: Value| json!({"target": ".stage", "name": name, "event": event});
    let at = |x: f64| json!({"pointerId": 1, "clientX": x, "clientY": 5.0});
    let events = json!([
        stage("pointermove", at(10.0)),
        stage("pointerdown", at(10.0)),
        stage("pointermove", at(40.0)),
        stage("wheel", json!({"deltaY": -300, "clientX": 1, "clientY": 1})),
        stage("webglcontextlost", json!({})),
        stage("dblclick", json!({})),
        stage("webglcontextrestored", json!({})),
    ]);
    let Some(shown) = shown(true, &events) else {
        return;
    };
    let drawn: Vec<_> = shown[1..].iter().map(|shown| &shown["drawn"]).collect();
    // The shadow stays as it is while the view changes.
    let [none, model, both] = [json!([]), json!([12]), json!([12, 12])];
    assert_eq!(drawn[..6], [&none, &none, &model, &model, &none, &none]);
    assert_eq!(drawn[6].as_array().unwrap()[..2], *both.as_array().unwrap());
}

#[test]
fn without_webgl_a_sentence_stays() {
    let Some(shown) = shown(false, &json!([])) else {
        return;
    };
    assert_eq!(
        [&shown[0]["absent"], &shown[0]["stage"]],
        [&json!(false); 2]
    );
    let page = page(&model());
    assert!(page.contains("<p class=\"absent\">The model is shown by a script with WebGL"));
}
