//! glTF: what is read must come back when it is written, and can be placed in the world.
#![no_main]

use ga_mesh::gltf::{self, Vertices};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Ok(mut document) = gltf::parse(data) else {
        return;
    };
    // A transform may take vertices beyond double precision.
    let _ = document.to_mesh(Vertices::Merged);
    // An animation that moves nothing cannot be written.
    document
        .animations
        .retain(|animation| !animation.channels.is_empty());
    let file = gltf::to_glb(&document).expect("a document that was read is valid");
    let back = gltf::parse(&file).expect("what is written is readable");
    assert_eq!(back, document);
});
