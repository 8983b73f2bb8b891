//! glTF: what is read must come back when it is written, and can be placed in the world and played.
#![no_main]

use ga_anim::gltf::{Placement, Player, character};
use ga_anim::recording::Recording;
use ga_anim::skin::Method;
use ga_mesh::gltf::{self, Document, Vertices};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Ok(mut document) = gltf::decode(data) else {
        return;
    };
    // A transform may take vertices beyond double precision.
    let _ = document.to_mesh(Vertices::Merged);
    play(&document);
    // An animation that moves nothing cannot be written.
    document
        .animations
        .retain(|animation| !animation.channels.is_empty());
    let file = gltf::encode(&document).expect("a document that was read is valid");
    let back = gltf::decode(&file).expect("what is written is readable");
    assert_eq!(back, document);
});

/// Evaluates the animations at a few times. Errors are in order, numbers that are not finite are
/// not.
fn play(document: &Document) {
    let _ = character(document);
    let Ok(player) = Player::new(document) else {
        return;
    };
    let Ok(placement) = Placement::new(&player) else {
        return;
    };
    for animation in [None, Some(0), Some(1)] {
        for time in [-1.0, 0.0, 0.3, 1e9] {
            let Ok(pose) = player.pose(animation, time) else {
                continue;
            };
            for method in [Method::Linear, Method::Motor, Method::DualQuaternion] {
                let Ok(placed) = placement.place(&pose, method) else {
                    continue;
                };
                let mesh = placement.mesh(&placed, |_| true).expect("places are finite");
                assert_eq!(mesh.vertex_count(), placement.vertex_count());
            }
        }
    }
    let _ = Recording::from_gltf(document, 0, 1.0, None);
}
