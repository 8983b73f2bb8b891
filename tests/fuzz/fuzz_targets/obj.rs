//! Wavefront OBJ with a material library: the input is both files, with a null byte between them.
//! What is read must come back when it is written.
#![no_main]

use ga_files::Reading;
use ga_mesh::obj;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let mut files = data.splitn(2, |&byte| byte == 0);
    let text = files.next().unwrap_or_default();
    let library = files.next().unwrap_or_default();
    let open = |_: &str| Ok(library.to_vec());
    let Ok((mesh, warnings)) = obj::decode_with_libraries(text, Reading::Tolerant, open) else {
        return;
    };
    // What is read strictly is the same mesh, and no deviation.
    if let Ok((strict, _)) = obj::decode_with_libraries(text, Reading::Strict, open) {
        assert_eq!(strict, mesh);
        assert!(!warnings.iter().any(|warning| matches!(warning, obj::Warning::Deviation(_))));
    }
    let back = obj::decode(obj::encode(&mesh).as_bytes()).expect("what is written is readable");
    assert_eq!(back.positions(), mesh.positions());
    assert_eq!(back.faces(), mesh.faces());
});
