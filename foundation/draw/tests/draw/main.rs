//! What comes out of scenes.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod json;
mod output;
mod shapes;

use ga_draw::{Scene, SceneError};

/// The scene of these elements in JSON.
fn parsed(elements: &str) -> Result<Scene, SceneError> {
    Scene::decode(format!("{{\"elements\": [{elements}]}}").as_bytes())
}

fn close(a: impl Into<[f64; 3]>, b: [f64; 3]) -> bool {
    let a = a.into();
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
