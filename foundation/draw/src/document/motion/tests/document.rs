//! The part as a reader uses it.

use serde_json::{Value, json};

use super::super::part::{FIGURE, SCRIPT};
use super::{EVIL, data, motion, page};
use crate::node::node;
use crate::page::{GEOMETRY, STAGE};

/// What is shown at first and after each event.
fn shown(events: &Value) -> Option<Vec<Value>> {
    let input = json!({
        "script": format!("{GEOMETRY}{STAGE}{FIGURE}{SCRIPT}"),
        "data": data(&page(&motion())).to_string(),
        "events": events,
    });
    let shown = node(include_str!("document.js"), &input)?;
    Some(serde_json::from_value(shown).unwrap())
}

fn key(key: &str) -> Value {
    json!({"target": "part", "name": "keydown", "event": {"key": key}})
}

/// The bytes that the pictures of the films had, as base64; `null` where a film has none.
fn pictures(shown: &Value) -> &Value {
    &shown["pictures"]
}

#[test]
fn figure_and_films_show_the_same_frame() {
    let slider = |frame: usize| json!({"target": "[type=range]", "name": "input", "value": frame});
    let events = json!([
        key("."),
        key("."),
        slider(4),
        key("."),
        key(","),
        slider(0),
        key(",")
    ]);
    let Some(shown) = shown(&events) else {
        return;
    };
    let outputs: Vec<_> = shown
        .iter()
        .map(|shown| shown["output"].as_str().unwrap())
        .collect();
    assert_eq!(
        outputs,
        [
            "frame 0 / 4 · 0.00 s",
            "frame 1 / 4 · 0.10 s",
            "frame 2 / 4 · 0.20 s",
            "frame 4 / 4 · 0.40 s",
            "frame 4 / 4 · 0.40 s",
            "frame 3 / 4 · 0.30 s",
            "frame 0 / 4 · 0.00 s",
            "frame 0 / 4 · 0.00 s",
        ]
    );
    let found: Vec<_> = shown.iter().map(pictures).collect();
    // Bytes 0 to 3 and 9 in base64.
    let [zero, one, two, three] =
        ["AA==", "AQ==", "Ag==", "Aw=="].map(|first| json!([first, "CQ=="]));
    let none = json!([null, "CQ=="]);
    assert_eq!(
        found,
        [&zero, &one, &two, &none, &none, &three, &zero, &zero]
    );
    // Two bones and three points where there is a pose.
    let counts: Vec<_> = shown
        .iter()
        .map(|shown| shown["points"].as_u64().unwrap())
        .collect();
    assert_eq!(counts, [3, 0, 3, 3, 3, 3, 3, 3]);
    assert_eq!(shown[1]["texts"], json!(["no pose in this frame"]));
    assert_eq!(
        shown[3]["notes"],
        json!(["· no picture of this frame", "· picture of frames 0 to 4"])
    );
    assert_eq!(
        shown[0]["hidden"],
        json!({"still": true, "views": false, "controls": false})
    );
}

#[test]
fn the_figure_waits_for_the_films() {
    let slider = |frame: usize| json!({"target": "[type=range]", "name": "input", "value": frame});
    // The picture with byte 2 is decoded only when it is released.
    let events = json!([{"hold": "Ag=="}, slider(2), slider(3), {"release": true}]);
    let Some(shown) = shown(&events) else {
        return;
    };
    let first = shown[0]["heads"].clone();
    for (k, byte) in ["AA==", "AA==", "AA==", "AA==", "Aw=="]
        .into_iter()
        .enumerate()
    {
        assert_eq!(pictures(&shown[k])[0], byte);
        assert_eq!(shown[k]["heads"] == first, byte == "AA==");
    }
    assert_eq!(shown[4]["frame"], 3);
}

#[test]
fn it_plays_to_the_end_and_begins_again() {
    let time = |time: f64| json!({"time": time});
    let button = json!({"target": "button", "name": "click"});
    let events = json!([
        time(5000.0),
        key(" "),
        time(5210.0),
        time(5500.0),
        button,
        time(5830.0),
        button,
        time(9000.0),
    ]);
    let Some(shown) = shown(&events) else {
        return;
    };
    let frames: Vec<_> = shown
        .iter()
        .map(|shown| shown["frame"].as_u64().unwrap())
        .collect();
    // It is paused at first.
    assert_eq!(frames, [0, 0, 0, 2, 4, 0, 3, 3, 3]);
    let words: Vec<_> = shown
        .iter()
        .map(|shown| shown["button"].as_str().unwrap())
        .collect();
    let [play, pause] = ["Play", "Pause"];
    assert_eq!(
        words,
        [play, play, pause, pause, play, pause, pause, play, play]
    );
}

#[test]
fn the_pointer_rotates_and_names_points() {
    let stage = |name: &str, event: Value| json!({"target": "stage", "name": name, "event": event});
    let at = |x: f64, y: f64| json!({"pointerId": 1, "clientX": x, "clientY": y});
    let Some(first) = shown(&json!([])) else {
        return;
    };
    let [x, y] = [0, 1].map(|k| first[0]["heads"][2][k].as_f64().unwrap());
    let out = stage("wheel", json!({"deltaY": 300}));
    let events = json!([
        stage("pointermove", at(x + 3.0, y)),
        stage("pointerleave", at(0.0, 0.0)),
        stage("pointerdown", at(0.0, 0.0)),
        stage("pointermove", at(40.0, 0.0)),
        stage("dblclick", json!({})),
        out,
        out,
        out,
    ]);
    let shown = shown(&events).unwrap();
    let texts: Vec<_> = shown.iter().map(|shown| shown["texts"].clone()).collect();
    assert_eq!(texts[..3], [json!([]), json!(["head"]), json!([])]);
    let heads = |k: usize| &shown[k]["heads"];
    assert_ne!(heads(4), heads(0));
    assert_eq!(heads(5), heads(0));
    assert_ne!(heads(6), heads(0));
    // From farther away the camera is seen.
    assert_eq!([&texts[5], &texts[8]], [&json!([]), &json!([EVIL])]);
}

#[test]
fn a_figure_that_is_followed_stays_in_the_middle() {
    let slider = |frame: usize| json!({"target": "[type=range]", "name": "input", "value": frame});
    let follow = json!({"target": "[type=checkbox]", "name": "change"});
    let Some(shown) = shown(&json!([follow, slider(2), slider(1), slider(4), follow])) else {
        return;
    };
    let heads = |k: usize| &shown[k]["heads"];
    assert_ne!(heads(0), heads(1));
    // All poses are the same but for their place.
    assert_eq!(heads(1), heads(2));
    assert_eq!(heads(1), heads(4));
    assert_ne!(heads(4), heads(5));
    let lines = |k: usize| &shown[k]["lines"];
    assert_ne!(lines(1), lines(2));
    // Where there is no pose, the middle stays.
    let floor = |k: usize| lines(k).as_array().unwrap()[..18].to_vec();
    assert_eq!(floor(2), floor(3));
}
