//! The data and the elements of the page.

use serde_json::{Value, json};

use super::{EVIL, data, motion, page};
use crate::document::Page;

/// A list of numbers.
fn numbers(value: &Value) -> Vec<f64> {
    serde_json::from_value(value.clone()).unwrap()
}

#[test]
fn every_frame_is_there_in_tenths_of_millimetres() {
    let data = data(&page(&motion()));
    assert_eq!(data["frames"], json!([0, null, 1, 2, 3]));
    let points: Vec<f64> = [-5000.0, 0.0, 2500.0, 5000.0]
        .into_iter()
        .flat_map(|x| [x, 0.0, 0.0, x, 10000.0, 0.0, x, 15000.0, -2500.0])
        .collect();
    assert_eq!(numbers(&data["points"]), points);
    assert_eq!(data["bones"], json!([[0, 1, 1], [1, 2, 2]]));
    assert_eq!(data["middle"], json!([0, 7500, -1250]));
    // The camera is the farthest.
    let farthest = 10000.0 * 0.25_f64.hypot(4.125);
    assert!((data["radius"].as_f64().unwrap() - farthest).abs() <= 0.5);
    assert_eq!(data["films"][0]["pictures"][2]["start"], json!(2));
    assert_eq!(
        data["films"][1]["pictures"],
        json!([{"start": 0, "end": 5, "source": "data:image/png;base64,CQ=="}])
    );
}

#[test]
fn the_floor_is_below_the_whole_motion() {
    let data = data(&page(&motion()));
    let floor = numbers(&data["floor"]);
    let along = |k: usize| floor.iter().skip(k).step_by(3);
    let range = |k: usize| {
        let [low, high] = [f64::INFINITY, f64::NEG_INFINITY];
        along(k).fold([low, high], |[low, high], x| [low.min(*x), high.max(*x)])
    };
    assert_eq!(range(0), [-10000.0, 10000.0]);
    assert_eq!(range(1), [-1000.0, -1000.0]);
    assert_eq!(range(2), [-10000.0, 5000.0]);
    // Five lines along z and four along x.
    assert_eq!(floor.len(), 9 * 6);
}

#[test]
fn a_long_walk_has_a_floor_of_longer_steps() {
    let mut motion = motion();
    motion.frames[4].as_mut().unwrap()[0][0] = 9e4;
    let page = page(&motion);
    assert!(page.contains("squares of 2048 m"));
    assert!(data(&page)["floor"].as_array().unwrap().len() < 6 * 120);
}

#[test]
fn names_stay_names() {
    let page = page(&motion());
    let data = data(&page);
    assert_eq!(data["names"][1], json!(EVIL));
    assert_eq!(data["cameras"][0]["name"], json!(EVIL));
    assert_eq!(data["films"][0]["name"], json!(EVIL));
    assert!(!page.contains(EVIL) && !page.contains("<b onclick"));
    // The data and the scripts.
    assert_eq!(page.matches("</script>").count(), 2);
    let (_, still) = page.split_once("<div class=\"still\">").unwrap();
    let svg = still.split_once("<noscript>").unwrap().0;
    let svg = roxmltree::Document::parse(svg.trim()).unwrap();
    let text = svg
        .descendants()
        .find(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "text")));
    assert_eq!(text.unwrap().text(), Some(EVIL));
}

#[test]
fn the_page_needs_no_other_file() {
    let page = page(&motion());
    // The name space of the picture.
    assert_eq!(page.matches("http").count(), 1);
    assert!(!page.contains("src=") && !page.contains("<link") && !page.contains("@import"));
}

#[test]
fn two_motions_share_the_scripts() {
    let mut page = Page::new("Two motions");
    page.motion(&motion(), "one").unwrap();
    page.motion(&motion(), "two").unwrap();
    page.warning_first("above both");
    let html = page.into_html();
    assert_eq!(html.matches("const geometry").count(), 1);
    assert_eq!(html.matches(".motion .stage {").count(), 1);
    assert_eq!(html.matches("<figure class=\"motion\">").count(), 2);
    assert!(html.contains("</h1>\n<p class=\"warning\">above both</p>\n<figure"));
}

#[test]
fn the_same_motion_gives_the_same_page() {
    assert_eq!(page(&motion()), page(&motion()));
}

#[test]
fn the_eye_stands_beside_the_first_camera() {
    // The camera is on the side of +z, which is at azimuth 0; +x is at azimuth 90.
    let mut motion = motion();
    assert_eq!(data(&page(&motion))["azimuth"], json!(25.0));
    motion.cameras[0].centre = [4.0, 1.0, -0.125];
    assert_eq!(data(&page(&motion))["azimuth"], json!(115.0));
}

#[test]
fn the_legend_names_the_sides_by_their_colours() {
    let mut motion = motion();
    let page_of_two = page(&motion);
    assert_eq!(
        data(&page_of_two)["colours"],
        json!(["#0072b2", "#d55e00", "#7a7a7a"])
    );
    assert!(page_of_two.contains("<i style=\"background:#d55e00\"></i>the person’s right"));
    assert!(!page_of_two.contains("the person’s left"));
    motion.bones[0].side = super::Side::Left;
    let page = page(&motion);
    assert!(page.contains("<i style=\"background:#0072b2\"></i>the person’s left"));
    assert_eq!(data(&page)["bones"][0], json!([0, 1, 0]));
}
