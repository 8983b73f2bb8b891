//! PLY: what is read must come back when it is written, in every encoding.
#![no_main]

use ga_mesh::ply::{self, Encoding};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Ok(mesh) = ply::decode(data) else {
        return;
    };
    for encoding in [Encoding::Ascii, Encoding::LittleEndian, Encoding::BigEndian] {
        let back =
            ply::decode(&ply::encode(&mesh, encoding)).expect("what is written is readable");
        assert_eq!(back.positions(), mesh.positions());
        assert_eq!(back.faces(), mesh.faces());
    }
});
