//! What stands in the page of a model, and what its scripts do with it.

mod data;
mod errors;
mod mesh;
mod player;
mod structure;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use serde_json::Value;

use super::{ModelCoordinates, ModelTexture, ModelView};
use crate::colour::Colour;
use crate::document::Page;
use crate::document::motion::Encoding;

/// A caption that would end the script, the attribute or the tag in which it stands.
const EVIL: &str = "</script><b onclick=\"x()\">&'";

/// A tetrahedron with a texture that has seams at each edge, in two frames. Vertex 4 belongs to no
/// triangle, vertex 5 is always where vertex 1 is.
fn model() -> ModelView {
    let still = vec![
        [-0.5, 0.0, 0.3],
        [0.5, 0.0, 0.3],
        [0.0, 0.0, -0.6],
        [0.013, 0.9, 0.0],
        [70.0, 80.0, 90.0],
        [0.5, 0.0, 0.3],
    ];
    let mut moved = still.clone();
    moved[3] = [0.1, 1.234_567, 0.05];
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 0.75]];
    ModelView {
        triangles: vec![[0, 2, 1], [0, 5, 3], [1, 2, 3], [2, 0, 3]],
        frames: vec![still, moved],
        frames_per_second: 10.0,
        colours: Some((0..6).map(|k| Colour([k / 5, 0, 255])).collect()),
        texture: Some(ModelTexture {
            coordinates: ModelCoordinates::Corners(vec![corners; 4]),
            encoding: Encoding::Jpeg,
            bytes: b"\xff\xd8\xff\xe0".to_vec(),
        }),
        floor: Some(0.0),
        turn: [30.0, 95.0],
    }
}

/// A page with a model.
fn page(model: &ModelView) -> String {
    let mut page = Page::new("A model");
    page.model(model, EVIL).unwrap();
    page.into_html()
}

/// The data in a page, as its script reads them.
fn data(page: &str) -> Value {
    let (_, rest) = page
        .split_once("<script type=\"application/json\">")
        .unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

fn bytes(value: &Value) -> Vec<u8> {
    BASE64_STANDARD.decode(value.as_str().unwrap()).unwrap()
}

/// Numbers of 16 bits.
fn short(value: &Value) -> Vec<u16> {
    let pairs = bytes(value);
    let pairs = pairs.chunks_exact(2);
    pairs
        .map(|pair| u16::from_le_bytes([pair[0], pair[1]]))
        .collect()
}
