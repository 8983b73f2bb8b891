//! What stands in the page of a motion, and what its scripts do with it.

mod document;
mod errors;
mod figure;
mod structure;

use serde_json::Value;

use super::{Bone, Encoding, Motion, MotionCamera, MotionFilm, MotionPicture, Side};
use crate::document::Page;

/// A name that would end the script, the attribute or the tag in which it stands.
const EVIL: &str = "</script><b onclick=\"x()\">&'";

/// Three points that move over five frames, the second of which has no pose, with a camera and two
/// films: one with a picture for each frame but the last, one with a picture for all.
fn motion() -> Motion {
    let pose = |x: f64| Some(vec![[x, 0.0, 0.0], [x, 1.00004, 0.0], [x, 1.5, -0.25]]);
    let picture = |frames, byte| MotionPicture {
        frames,
        encoding: Encoding::Png,
        bytes: vec![byte],
    };
    let film = |name: &str, pictures| MotionFilm {
        name: name.to_owned(),
        size: [32, 24],
        pictures,
    };
    Motion {
        frames_per_second: 10.0,
        names: vec!["foot".into(), EVIL.into(), "head".into()],
        bones: vec![
            Bone {
                ends: [0, 1],
                side: Side::Right,
            },
            Bone {
                ends: [1, 2],
                side: Side::Middle,
            },
        ],
        frames: vec![pose(-0.5), None, pose(0.0), pose(0.25), pose(0.5)],
        floor: Some(-0.1),
        cameras: vec![MotionCamera {
            name: EVIL.into(),
            centre: [0.0, 1.0, 4.0],
            corners: [
                [-0.2, 1.1, 3.7],
                [0.2, 1.1, 3.7],
                [0.2, 0.9, 3.7],
                [-0.2, 0.9, 3.7],
            ],
        }],
        films: vec![
            film(
                EVIL,
                (0..4_u8)
                    .map(|k| picture(k.into()..usize::from(k) + 1, k))
                    .collect(),
            ),
            film("slow", vec![picture(0..5, 9)]),
        ],
    }
}

/// A page with a motion.
fn page(motion: &Motion) -> String {
    let mut page = Page::new("A motion");
    page.motion(motion, EVIL).unwrap();
    page.into_html()
}

/// The data in a page, as its script reads them.
fn data(page: &str) -> Value {
    let (_, rest) = page
        .split_once("<script type=\"application/json\">")
        .unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}
