//! The elements of the page.

use serde_json::json;

use super::{EVIL, data, model, page};
use crate::document::{Bone, Motion, Page, Side};

#[test]
fn captions_stay_captions() {
    let page = page(&model());
    assert!(!page.contains(EVIL) && !page.contains("<b onclick"));
    // The data and the scripts.
    assert_eq!(page.matches("</script>").count(), 2);
    assert_eq!(page.matches("aria-label=\"&lt;/script&gt;").count(), 1);
}

#[test]
fn the_page_needs_no_other_file() {
    let page = page(&model());
    assert!(!page.contains("http"));
    assert!(!page.contains("src=") && !page.contains("<link") && !page.contains("@import"));
    assert_eq!(
        data(&page)["picture"],
        json!("data:image/jpeg;base64,/9j/4A==")
    );
}

#[test]
fn the_same_model_gives_the_same_page() {
    assert_eq!(page(&model()), page(&model()));
}

#[test]
fn a_model_at_rest_has_no_button() {
    let mut model = model();
    assert!(page(&model).contains("<button") && page(&model).contains("max=\"1\""));
    model.frames.truncate(1);
    model.floor = None;
    let page = page(&model);
    assert!(!page.contains("<button") && !page.contains("space to play"));
    assert!(!page.contains("squares of"));
}

#[test]
fn the_eye_is_at_most_above() {
    let data = data(&page(&model()));
    assert_eq!(data["azimuth"], json!(30.0));
    assert_eq!(data["elevation"], json!(90.0));
}

#[test]
fn models_and_motions_share_scripts() {
    let motion = Motion {
        frames_per_second: 25.0,
        names: vec!["a".into(), "b".into()],
        bones: vec![Bone {
            ends: [0, 1],
            side: Side::Left,
        }],
        frames: vec![Some(vec![[0.0; 3], [1.0; 3]])],
        ..Motion::default()
    };
    let mut page = Page::new("Three parts");
    page.model(&model(), "one").unwrap();
    page.motion(&motion, "two").unwrap();
    page.model(&model(), "three").unwrap();
    let html = page.into_html();
    for script in ["geometry", "stages", "mesh", "painters", "figure"] {
        let count = html.matches(&format!("\nconst {script} =")).count();
        assert_eq!(count, 1, "{script}");
    }
    assert_eq!(html.matches(".model .stage {").count(), 1);
    assert_eq!(html.matches("<figure class=\"model\">").count(), 2);
}
