//! The mathematics of the part.

use serde_json::{Value, json};

use super::super::data::Data;
use super::super::part::{FIGURE, json};
use super::super::still::{self, SIZE};
use super::{data, motion, page};
use crate::camera::{Camera, Pixel};
use crate::node::node;
use crate::page::GEOMETRY;
use crate::view::{Up, View};

/// The values of expressions of JavaScript, in which `data` are those of the motion.
fn values(expressions: &[&str]) -> Option<Vec<Value>> {
    let script = format!(
        "{GEOMETRY}{FIGURE}
        const data = JSON.parse(require('node:fs').readFileSync(0, 'utf8'));
        process.stdout.write(JSON.stringify([{}]));",
        expressions.join(",")
    );
    let values = node(&script, &data(&page(&motion())))?;
    Some(serde_json::from_value(values).unwrap())
}

#[track_caller]
fn assert_near(found: &Value, expected: Pixel, off: f64) {
    let found: Pixel = serde_json::from_value(found.clone()).unwrap();
    let near = (0..2).all(|k| (found[k] - expected[k]).abs() <= off);
    assert!(near, "{found:?} is not {expected:?}");
}

#[test]
fn the_page_projects_as_the_picture_does() {
    let views = [(0.0, 0.0, 1.0), (35.0, 22.0, 2.5), (-200.0, -80.0, 0.3)];
    let size = [420.0, 300.0];
    let projected = views.map(|(azimuth, elevation, zoom)| {
        format!(
            "(() => {{ const view = {{ azimuth: {azimuth}, elevation: {elevation}, zoom: {zoom} }};
            const seen = figure.camera(data, view, {size:?});
            return [0, 1, 2].map((k) => seen.project(figure.pose(data, 3), k)); }})()"
        )
    });
    let Some(found) = values(&projected.each_ref().map(String::as_str)) else {
        return;
    };
    let motion = motion();
    let data = Data::of(&motion);
    for ((azimuth, elevation, zoom), found) in views.into_iter().zip(found) {
        let mut camera = Camera::new(&View {
            azimuth,
            elevation,
            up: Up::Y,
            ..View::default()
        });
        camera.scale = data.scale * zoom * 300.0;
        camera.middle = [210.0, 150.0];
        for (k, place) in [[2500, 0, 0], [2500, 10000, 0], [2500, 15000, -2500]]
            .iter()
            .enumerate()
        {
            assert_near(&found[k], camera.project(data.place(place)), 1e-6);
        }
    }
}

#[test]
fn the_whole_motion_fits_and_x_points_to_the_right() {
    let pixel = |frame: usize, point: usize| {
        format!(
            "figure.camera(data, {{ azimuth: 0, elevation: 0, zoom: 1 }}, [400, 300])
            .project(figure.pose(data, {frame}), {point})"
        )
    };
    let asked = [pixel(2, 0), pixel(4, 0), pixel(2, 2)];
    let Some(found) = values(&asked.each_ref().map(String::as_str)) else {
        return;
    };
    // By hand: the eye is on the z axis at four times the distance of the camera, 4 · √(0.25² +
    // 4.125²) m from the middle (0, 0.75, −0.125), and at its depth a metre has 0.92 · 150 pixels
    // for each radius of the motion, which is the distance of the last foot, √(0.5² + 0.75² +
    // 0.125²) m.
    let eye = 4.0 * 0.25_f64.hypot(4.125);
    let metre = 0.92 * 150.0 / (0.25_f64 + 0.5625 + 0.015625).sqrt();
    let near = metre * eye / (eye - 0.125);
    let far = metre * eye / (eye + 0.125);
    assert_near(&found[0], [200.0, 150.0 + 0.75 * near], 0.05);
    assert_near(&found[1], [200.0 + 0.5 * near, 150.0 + 0.75 * near], 0.05);
    assert_near(&found[2], [200.0, 150.0 - 0.75 * far], 0.05);
}

#[test]
fn times_and_frames_have_their_frames_and_pictures() {
    let Some(found) = values(&[
        "[0, 0.0999, 0.3, 0.3999, 9].map((s) => figure.frameAfter(data, 0, s))",
        "figure.frameAfter(data, 2, 0.1)",
        "figure.frameAfter({ rate: 29.97, frames: Array(2000) }, 0, 1001 / 29.97)",
        "[0, 3, 4].map((frame) => figure.pictureAt(data.films[0], frame))",
        "[0, 4].map((frame) => figure.pictureAt(data.films[1], frame))",
        "figure.pictureAt({ pictures: [] }, 0)",
        "[1, 4].map((frame) => figure.pose(data, frame))",
        "figure.nearest([[0, 0], [5, 0]], [4, 1], 3)",
        "figure.nearest([[0, 0], [5, 0]], [4, 9], 3)",
    ]) else {
        return;
    };
    assert_eq!(found[0], json!([0, 0, 3, 3, 4]));
    assert_eq!(found[1], json!(3));
    assert_eq!(found[2], json!(1001));
    assert_eq!(found[3], json!([0, 3, null]));
    assert_eq!(found[4], json!([0, 0]));
    assert_eq!(found[5], json!(null));
    let pose = [5000, 0, 0, 5000, 10000, 0, 5000, 15000, -2500];
    assert_eq!(found[6], json!([null, pose]));
    assert_eq!(found[7], json!(1));
    assert_eq!(found[8], json!(null));
}

#[test]
fn the_still_picture_is_what_the_script_shows_first() {
    let [width, height] = SIZE;
    let bones = format!(
        "figure.bones(data, figure.camera(data, {{ ...data, zoom: 1 }}, [{width}, {height}]), \
         figure.pose(data, 0))"
    );
    let Some(found) = values(&[&bones]) else {
        return;
    };
    let motion = motion();
    let data = Data::of(&motion);
    assert!(!json(&data).contains("null,\"points"));
    let svg = still::draw(&data, "");
    let svg = roxmltree::Document::parse(&svg).unwrap();
    let bones = svg
        .descendants()
        .filter(|node| node.attribute("stroke-width") == Some("4"));
    let bones: Vec<_> = bones.collect();
    assert_eq!(bones.len(), 2);
    for (k, bone) in bones.into_iter().enumerate() {
        let number = |name| bone.attribute(name).unwrap().parse::<f64>().unwrap();
        let ends = &found[0][k]["ends"];
        // The picture has two decimals.
        assert_near(&ends[0], [number("x1"), number("y1")], 0.0051);
        assert_near(&ends[1], [number("x2"), number("y2")], 0.0051);
        let side = found[0][k]["side"].as_u64().unwrap() as usize;
        assert_eq!(
            bone.attribute("stroke"),
            Some(data.colours[side].to_string().as_str())
        );
    }
}

/// The bones that are farther away come first, whichever of their ends does.
#[test]
fn the_ends_of_a_bone_do_not_change_what_hides_it() {
    let colours = |motion: &super::Motion| -> Vec<String> {
        let svg = still::draw(&Data::of(motion), "");
        let svg = roxmltree::Document::parse(&svg).unwrap();
        let lines = svg.descendants().filter(|node| node.has_tag_name("line"));
        let bones = lines.filter(|node| node.attribute("stroke-width") == Some("4"));
        bones
            .map(|bone| bone.attribute("stroke").unwrap().to_owned())
            .collect()
    };
    let expected = colours(&motion());
    assert!(expected[0] != expected[1]);
    for swapped in 0..2 {
        let mut motion = motion();
        motion.bones[swapped].ends.reverse();
        assert_eq!(colours(&motion), expected);
    }
}
